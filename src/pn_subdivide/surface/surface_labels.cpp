// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/surface_labels.h"

#include "io/Error.h"
#include "surface/surface_command.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pn_subdivide {
namespace {

constexpr const char* column_name = "surface";

void drop_segments(Columns& columns)
{
  const auto is_ours = [](const Column& column) { return column.name == column_name; };
  columns.erase(std::remove_if(columns.begin(), columns.end(), is_ours), columns.end());
}

} // namespace

void require_labels_place(const Surface_options& options, const std::vector<std::string>& others)
{
  const std::optional<std::string>& name = options.creases.surface_labels;
  if (!name) return;
  if (name->empty() || *name == "-")
    throw Usage_error("--surface-labels '" + *name + "': it takes the name of a file");
  for (const std::string& other : others)
    if (!other.empty() && other != "-" && same_file(*name, other))
      throw Usage_error("--surface-labels " + *name + ": the labels need a file of their own");
  require_writable_place(*name);
}

Labels_file::Labels_file(const Surface_options& options, const Recognized_part* part)
{
  if (!options.creases.surface_labels || part == nullptr) return;
  name_ = *options.creases.surface_labels;
  try {
    file_.emplace(name_);
    for (const std::size_t segment : part->segments) {
      file_->number(static_cast<std::uint64_t>(segment));
      file_->text("\n");
    }
  } catch (const std::exception& e) {
    throw Error(name_ + ": " + message_of(e));
  }
}

void Labels_file::commit()
{
  if (!file_) return;
  try {
    file_->commit();
  } catch (const Error& e) {
    throw Error(name_ + ": " + e.what());
  }
}

void add_segments(Mesh_data& mesh, const Recognized_part& part, const std::string& name,
                  Report& report)
{
  Columns& columns = mesh.attributes.of_faces;
  if (find_column(columns, column_name) != nullptr)
    report.warn_of_dropped(name + ": the property 'surface' of faces gives way to the numbers of "
                                  "the recognized surfaces",
                           {"'surface' of faces"});
  drop_segments(columns);
  Column column;
  column.name = column_name;
  column.type = Scalar_type::int32;
  column.values.assign(part.segments.begin(), part.segments.end());
  columns.push_back(std::move(column));
}

const std::vector<double>* segments_of(const Attributes& attributes)
{
  const Column* const column = find_column(attributes.of_faces, column_name);
  return column == nullptr ? nullptr : &column->values;
}

void suit_segments(Mesh_data& mesh, const Mesh_file& output)
{
  if (output.format != "ply" && output.format != "vtp") drop_segments(mesh.attributes.of_faces);
}

} // namespace pn_subdivide
