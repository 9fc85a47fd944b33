// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OBJ_TAGS_H
#define PN_SUBDIVIDE_OBJ_TAGS_H

#include "io/Crease_tags.h"
#include "io/Text_reader.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pn_subdivide {

class Output_file;

// The lines "t crease 2/1/0 A B S" and "t corner 1/1/0 V S" of OBJ files, as OpenSubdiv has them: the numbers of
// integers, floats and strings, and then these; vertices are counted from 0, and a sharpness of 10 is one for ever.
class Obj_tags
{
public:
  // The rest of a line that begins with "t". Returns the name of a tag that is none of these, or nothing. Throws
  // Error.
  std::string read(Text_reader& in);

  // To be called when all is read. Throws Error, which names the line, if a vertex is out of range.
  Crease_tags take(std::size_t number_of_vertices);

private:
  struct Place
  {
    std::int64_t vertex;
    std::size_t line;
  };

  Crease_tags tags_;
  std::vector<std::pair<std::int64_t, double>> corners_;
  std::vector<Place> places_; // of all vertices
};

void write_obj_tags(Output_file& out, const Crease_tags& tags);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OBJ_TAGS_H
