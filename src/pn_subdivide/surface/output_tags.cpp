// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/output_mesh.h"

#include "options.h"
#include "surface/Recognized_part.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pn_subdivide {
namespace {

bool ends_with(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

constexpr const char* column_name = "surface";
constexpr const char* hidden_name = "surface, not to be written";

void add_column(Columns& columns, const char* name, const Recognized_part& part)
{
  columns.push_back({name, Scalar_type::int32, {part.segments.begin(), part.segments.end()}});
}

} // namespace

void require_tags_place(const Surface_options& options, const std::vector<std::string>& others)
{
  if (!options.write_tags) return;
  const std::string& name = *options.write_tags;
  if (!ends_with(name, ".selection.txt"))
    throw Usage_error("--write-tags " + name + ": the name of the file must end in .selection.txt");
  require_own_file("--write-tags", name, others);
}

bool are_tags_written(const Surface_options& options, const Output_normals& normals)
{
  return options.write_tags || normals.goes_on();
}

void suit_tags(Mesh_data& mesh, const Mesh_file& output, const Surface_options& options,
               const Output_normals& normals, Report& report)
{
  if (!normals.goes_on()) mesh.tags = Crease_tags();
  if (!mesh.tags.any()) return;
  const std::string name = output.title("standard output");
  const bool has_place = output.format == "ply" || output.format == "obj";
  if (!has_place && options.write_tags) return;
  if (!has_place)
    return report.warn_of_dropped(name + ": not written, " + output.format +
                                    " files cannot hold it: what is sharp; --write-tags writes "
                                    "it to a file of its own",
                                  {"what is sharp"});
  Columns& columns = mesh.attributes.of_vertices;
  if (output.format != "ply" || find_column(columns, "sharpness") == nullptr) return;
  remove_columns(columns, {"sharpness"});
  report.warn_of_dropped(name +
                           ": the property 'sharpness' of vertices gives way to that of corners",
                         {"'sharpness' of vertices"});
}

Side_file tags_file(const Surface_options& options, const Crease_tags& tags, Report& report)
{
  if (!options.write_tags) return {};
  const std::string& name = *options.write_tags;
  Side_file file(name, [&](Output_file& out) { write_selection(out, tags); });
  const auto is_finite = [](double s) { return s > 0 && std::isfinite(s); };
  const auto edges = std::size_t(
    std::count_if(tags.edges.begin(), tags.edges.end(),
                  [&](const Crease_tags::Edge& edge) { return is_finite(edge.sharpness); }));
  const auto vertices =
    std::size_t(std::count_if(tags.vertices.begin(), tags.vertices.end(), is_finite));
  if (edges + vertices > 0)
    report.warn(name + ": a selection does not say that " + plural(edges, "edge", "edges") +
                (vertices > 0 ? " and " + plural(vertices, "corner", "corners") : std::string()) +
                (edges + vertices == 1 ? " is" : " are") + " sharp for some rounds only");
  return file;
}

Side_file labels_file(const Surface_options& options, const Recognized_part* part)
{
  if (!options.creases.surface_labels || part == nullptr) return {};
  return Side_file(*options.creases.surface_labels, [part](Output_file& out) {
    for (const std::size_t segment : part->segments) {
      out.number(static_cast<std::uint64_t>(segment));
      out.text("\n");
    }
  });
}

void add_segments(Mesh_data& mesh, const Recognized_part& part, const std::string& name,
                  Report& report)
{
  Columns& columns = mesh.attributes.of_faces;
  if (find_column(columns, column_name) != nullptr)
    report.warn_of_dropped(name + ": the property 'surface' of faces gives way to the numbers of "
                                  "the recognized surfaces",
                           {"'surface' of faces"});
  remove_columns(columns, {column_name});
  add_column(columns, column_name, part);
}

void add_hidden_segments(Mesh_data& mesh, const Recognized_part& part)
{
  add_column(mesh.attributes.of_faces, hidden_name, part);
}

std::vector<double>* segments_of(Attributes& attributes)
{
  std::vector<double>* segments = nullptr;
  for (Column& column : attributes.of_faces)
    if (column.name == hidden_name || (column.name == column_name && segments == nullptr))
      segments = &column.values;
  return segments;
}

void suit_segments(Mesh_data& mesh, const Mesh_file& output)
{
  Columns& columns = mesh.attributes.of_faces;
  if (remove_columns(columns, {hidden_name})) return; // one of the user's stays
  if (output.format != "ply" && output.format != "vtp") remove_columns(columns, {column_name});
}

} // namespace pn_subdivide
