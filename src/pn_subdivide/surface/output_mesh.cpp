// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/output_mesh.h"

#include "io/Text_reader.h"
#include "options.h"
#include "surface/Recognized_part.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace pn_subdivide {
namespace {

using Choice = Output_normals::Choice;

Choice parse(const std::string& text)
{
  return parse_word<Choice>("--output-normals", text,
                            {{"auto", Choice::automatic},
                             {"surface", Choice::surface},
                             {"control", Choice::control},
                             {"both", Choice::both},
                             {"none", Choice::none}});
}

Choice choice_of(const Surface_options& options, const Mesh_file& output)
{
  const bool is_flag = options.limit.normals; // the option's own choice is not in there yet
  if (!options.output_normals) return is_flag ? Choice::surface : Choice::automatic;
  const Choice choice = parse(*options.output_normals);
  const std::string option = "--output-normals " + *options.output_normals;
  if (choice == Choice::both && !held_by(output).control_normals)
    throw Usage_error(option + ": " + output.title("standard output") + " (" + output.format +
                      ") cannot hold both, only .ply, .vtp and .pvtp can");
  return choice;
}

// The wedges of vertices that have several, which are few where a mesh is large: runs of faces round the vertex between
// sharp edges and border edges.
class Several_wedges
{
public:
  // `is_sharp(edge)`
  template <class Is_sharp>
  Several_wedges(const Surface& surface, const Is_sharp& is_sharp)
    : has_several_(surface.number_of_vertices(), false)
  {
    for (const Edge e : surface.edges())
      if (is_sharp(e))
        for (const Halfedge h : {surface.halfedge(e), surface.opposite(surface.halfedge(e))})
          has_several_[surface.target(h)] = true;
    for (const Vertex v : surface.vertices())
      if (has_several_[v]) has_several_[v] = add(surface, is_sharp, v);
  }

  std::size_t size() const { return vertex_.size(); }
  Vertex vertex(std::size_t wedge) const { return vertex_[wedge]; }
  bool at(Vertex v) const { return has_several_[v]; }
  // That of the half-edge's face at its target, which has several.
  std::size_t of(Halfedge h) const { return of_corner_.at(static_cast<std::uint32_t>(h)); }

private:
  // Returns whether there are several.
  template <class Is_sharp>
  bool add(const Surface& surface, const Is_sharp& is_sharp, Vertex v)
  {
    using Run = std::vector<Halfedge>;
    std::vector<Run> runs;
    const auto is_begin = [&](Halfedge h) {
      return !surface.is_border(h) &&
             (is_sharp(surface.edge(h)) || surface.is_border(surface.opposite(h)));
    };
    Halfedge first = surface.halfedge(v);
    const Halfedge start = first;
    while (!is_begin(first)) {
      first = surface.opposite(surface.next(first));
      if (first == start) return false;
    }
    Halfedge h = first;
    do {
      if (is_begin(h)) runs.emplace_back();
      if (!surface.is_border(h)) runs.back().push_back(h);
      h = surface.opposite(surface.next(h));
    } while (h != first);
    if (runs.size() < 2) return false;
    // whatever half-edge the vertex has
    std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
      return *std::min_element(a.begin(), a.end()) < *std::min_element(b.begin(), b.end());
    });
    for (const Run& run : runs) {
      for (const Halfedge corner : run)
        of_corner_.emplace(static_cast<std::uint32_t>(corner), vertex_.size());
      vertex_.push_back(v);
    }
    return true;
  }

  std::vector<bool> has_several_;
  std::vector<Vertex> vertex_; // of each wedge
  std::unordered_map<std::uint32_t, std::size_t> of_corner_;
};

// The places of normals: those of the vertices, and behind them those of the wedges of vertices that have several.
class Places_of_corners
{
public:
  Places_of_corners(const Surface& surface, const Mesh_data& mesh, const Several_wedges& wedges)
    : surface_(surface)
    , mesh_(mesh)
    , wedges_(wedges)
  {}

  // of the corners of a face; valid until the next call
  const std::vector<std::size_t>& of(std::size_t f)
  {
    const Mesh_data::Face face = mesh_.face(f);
    places_.assign(face.begin(), face.end());
    if (std::none_of(face.begin(), face.end(), [&](auto v) { return wedges_.at(Vertex(v)); }))
      return places_;
    auto place = places_.begin();
    for (const Halfedge h : halfedges_around_face(surface_.halfedge(Face(f)), surface_)) {
      if (wedges_.at(Vertex(static_cast<Index>(*place))))
        *place = mesh_.points.size() + wedges_.of(h);
      ++place;
    }
    return places_;
  }

private:
  const Surface& surface_;
  const Mesh_data& mesh_;
  const Several_wedges& wedges_;
  std::vector<std::size_t> places_;
};

// Vertices with several wedges have the normalized sum of those.
void set_normals_of_wedges(Mesh_data& mesh, const Surface& surface, const Several_wedges& wedges,
                           double scale)
{
  const std::size_t vertices = mesh.points.size();
  Places_of_corners places(surface, mesh, wedges);
  Area_normals sums(vertices + wedges.size(), scale);
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Index* const corner = mesh.face(f).begin();
    const std::vector<std::size_t>& place = places.of(f);
    sums.add_face(
      place.size(), [&](std::size_t i) { return mesh.points[corner[i]]; },
      [&](std::size_t i) { return place[i]; });
  }
  mesh.normals = sums.take();
  for (std::size_t f = 0; f < mesh.number_of_faces() && wedges.size() > 0; ++f) {
    const std::vector<std::size_t>& place = places.of(f);
    for (std::size_t i = 0; i < place.size(); ++i)
      if (place[i] >= vertices)
        mesh.several_normals.push_back(
          {mesh.first_corner(f) + i, mesh.face(f).begin()[i], mesh.normals[place[i]]});
  }
  for (std::size_t w = 0; w < wedges.size(); ++w)
    for (std::size_t k = 0; k < 3; ++k)
      mesh.normals[wedges.vertex(w)][k] += mesh.normals[vertices + w][k];
  mesh.normals.resize(vertices);
  for (const Vertex v : surface.vertices())
    if (wedges.at(v)) mesh.normals[v] = normalized(mesh.normals[v]);
}

// Control normals and creases go before others take their room.
Mesh_data with_normals_of_faces(Surface& surface, std::optional<Crease_maps>& creases, double scale)
{
  remove_normals(surface);
  const Several_wedges wedges(surface, [&](Edge e) { return creases && creases->edges[e] > 0; });
  if (creases) remove_creases(surface, *creases);
  Mesh_data mesh = to_mesh_data(surface);
  set_normals_of_wedges(mesh, surface, wedges, scale);
  return mesh;
}

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

Output_normals Output_normals::make(const Surface_options& options, const Mesh_file& output)
{
  Output_normals normals;
  normals.choice = choice_of(options, output);
  // many programs refuse NOFF
  const bool are_wanted = options.output_normals || (options.levels == 0 && options.normals);
  const bool is_bare = !held_by(output).normals || (output.format == "off" && !are_wanted);
  if (normals.choice == Choice::automatic && is_bare) normals.choice = Choice::none;
  const bool is_default = normals.choice == Choice::automatic || normals.choice == Choice::both;
  const bool has_control_normals = !options.linear && options.normals != "none";
  if (normals.choice == Choice::surface || (is_default && options.chord) ||
      (is_default && options.limit.points && has_control_normals))
    normals.kind = Normal_kind::of_surface;
  else if (is_default && options.levels > 0)
    normals.kind = Normal_kind::of_mesh;
  normals.copies = normals.choice == Choice::automatic && options.levels == 0 &&
                   !options.limit.points && !options.interpolate;
  return normals;
}

void Output_normals::suit(const Mesh_data& mesh)
{
  if (copies) kind = mesh.normal_kind;
  scale = scale_to_unit_size(mesh.points);
}

Kept_normals kept_normals(const Surface& surface, const Wedge_list& wedges)
{
  Mesh_data mesh = to_mesh_data(surface, wedges);
  if (mesh.several_normals.empty())
    return {std::move(mesh.normals), std::move(mesh.corner_normals),
            std::move(mesh.corner_roundness)};
  std::vector<Triple> of_corners;
  of_corners.reserve(mesh.number_of_corners());
  for (const Index v : mesh.vertices_of_corners()) {
    of_corners.push_back(mesh.normals[v]);
    if (!mesh.roundness.empty()) mesh.corner_roundness.push_back(mesh.roundness[v]);
  }
  for (const Corner_normal& n : mesh.several_normals) {
    of_corners[n.corner] = n.normal;
    if (!mesh.roundness.empty()) mesh.corner_roundness[n.corner] = n.roundness;
  }
  set_vertex_roundness(mesh);
  return {std::move(mesh.normals), std::move(of_corners), std::move(mesh.corner_roundness)};
}

Mesh_data output_mesh(Surface& surface, std::optional<Crease_maps>& creases,
                      const Wedge_list& of_wedges, const Output_normals& normals,
                      Kept_normals control)
{
  if (!normals.any()) remove_normals(surface);
  const bool has_normals = normals_of(surface).has_value();
  const bool of_faces = normals.are_of_faces() && has_normals;
  if (of_faces && normals.with_control()) control = kept_normals(surface, of_wedges);
  if (!of_faces && creases) remove_creases(surface, *creases);
  Mesh_data mesh = of_faces ? with_normals_of_faces(surface, creases, normals.scale)
                            : to_mesh_data(surface, has_normals ? of_wedges : Wedge_list());
  mesh.normal_kind = normals.kind;
  mesh.control_normals = std::move(control.of_vertices);
  mesh.corner_control_normals = std::move(control.of_corners);
  if (!control.roundness_of_corners.empty())
    mesh.corner_roundness = std::move(control.roundness_of_corners);
  if (normals.kind == Normal_kind::control) put_control_normals(mesh, normals);
  return mesh;
}

void put_control_normals(Mesh_data& mesh, const Output_normals& normals)
{
  if (!normals.any()) {
    mesh.normals.clear();
    mesh.corner_normals.clear();
    mesh.several_normals.clear();
  }
  if (!normals.with_control()) return;
  mesh.control_normals = mesh.normals;
  mesh.corner_control_normals = mesh.corner_normals;
}

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
