// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OUTPUT_TAGS_H
#define PN_SUBDIVIDE_OUTPUT_TAGS_H

#include "io/Error.h"
#include "io/Output_file.h"
#include "io/Report.h"
#include "io/mesh_io.h"
#include "options.h"
#include "surface/Recognized_part.h"
#include "surface/output_mesh.h"

#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace pn_subdivide {

// What is sharp in the result, as it is written beside control normals and by --write-tags.

// Throws Usage_error or Error if the file of --write-tags cannot be one, or is one of `others`.
void require_tags_place(const Surface_options& options, const std::vector<std::string>& others);

// Are the tags of the result written anywhere?
bool are_tags_written(const Surface_options& options, const Output_normals& normals);

// Leaves those tags in the mesh that its own file gets, and warns of what is not written.
void suit_tags(Mesh_data& mesh, const Mesh_file& output, const Surface_options& options,
               const Output_normals& normals, Report& report);

// A file beside OUTPUT, which appears by commit(), or none.
class Side_file
{
public:
  Side_file() = default;
  // write(Output_file&)
  template <class Function>
  Side_file(const std::string& name, const Function& write)
    : name_(name)
  {
    naming([&] {
      file_ = std::make_unique<Output_file>(name);
      write(*file_);
    });
  }
  void commit()
  {
    if (file_ != nullptr) naming([&] { file_->commit(); });
  }

private:
  template <class Function>
  void naming(const Function& f)
  {
    try {
      f();
    } catch (const std::exception& e) {
      throw Error(name_ + ": " + message_of(e));
    }
  }

  std::string name_;
  std::unique_ptr<Output_file> file_;
};

// The selection of --write-tags.
Side_file tags_file(const Surface_options& options, const Crease_tags& tags, Report& report);
// The file of --surface-labels: the segment of each control face, one a line.
Side_file labels_file(const Surface_options& options, const Recognized_part* part);

// The numbers of segments as a property of the faces of the result.

// Adds the property, which the children of the faces get, too. One of the user's with this name gives way.
void add_segments(Mesh_data& mesh, const Recognized_part& part, const std::string& name,
                  Report& report);
// The same of a part that was not asked for, under a name that no file has, and not to be written.
void add_hidden_segments(Mesh_data& mesh, const Recognized_part& part);
// That property; nullptr if there is none.
std::vector<double>* segments_of(Attributes& attributes);
// It stays where files have properties of faces, without a word elsewhere.
void suit_segments(Mesh_data& mesh, const Mesh_file& output);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OUTPUT_TAGS_H
