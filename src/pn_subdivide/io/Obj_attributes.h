// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OBJ_ATTRIBUTES_H
#define PN_SUBDIVIDE_OBJ_ATTRIBUTES_H

#include "io/Mesh_data.h"
#include "io/Text_reader.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pn_subdivide {

// The columns of faces that OBJ has statements for, and the plural of what these are for people.
struct Obj_statement
{
  const char *keyword, *column, *plural;
  bool has_words;
};
extern const Obj_statement obj_statements[4];

// What an OBJ file says besides points, normals and faces: texture coordinates (vt), colors behind the
// points, objects (o), groups (g), materials (usemtl) and smoothing groups (s), which hold for the
// faces that follow them, and the names of material files (mtllib).
class Obj_attributes
{
public:
  std::size_t number_of_texture_points() const { return points_.size(); }

  // Reads the rest of the line; false if the keyword is none of these.
  bool read(std::string_view keyword, Text_reader& in, Mesh_data& mesh);
  // Without reading it: a backslash at the end of a name does not join the next line to it.
  static void skip(std::string_view keyword, Text_reader& in);

  // The rest of a vertex's line: a weight, which says nothing here, or a color, perhaps with alpha.
  void read_color(Text_reader& in, Mesh_data& mesh);

  // `corner` counts through all faces, `point` through the lines vt; there is one call for each face
  // when its corners are known.
  void add_corner(std::size_t corner, std::size_t point, std::size_t line)
  {
    corners_.push_back({corner, point, line});
  }
  void end_face();

  // To be called when all is read.
  void put(Mesh_data& mesh);

private:
  struct Corner
  {
    std::size_t corner, point, line;
  };

  // A column and its value for the faces to come.
  struct State
  {
    bool is_used = false;
    double value = -1;
    Column column;
    std::map<std::string, double, std::less<>> numbers; // of the words
  };

  void read_texture_point(Text_reader& in);
  void read_statement(const Obj_statement& statement, State& state, Text_reader& in,
                      Mesh_data& mesh);
  void put_texture(Mesh_data& mesh) const;
  void put_colors(Mesh_data& mesh);

  std::vector<Texture_point> points_;
  std::vector<Corner> corners_;
  std::vector<std::array<double, 4>> colors_;
  bool has_alpha_ = false;
  std::size_t vertices_ = 0, faces_ = 0;
  State states_[4]; // of `obj_statements`
};

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

#endif // PN_SUBDIVIDE_OBJ_ATTRIBUTES_H
