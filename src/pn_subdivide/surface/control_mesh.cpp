// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/control_mesh.h"

#include "io/Error.h"
#include "io/Mesh_data.h"
#include "io/Text_reader.h"
#include "io/border_edges.h"
#include "io/merge_points.h"
#include "io/mesh_normals.h"
#include "io/shading_normals.h"
#include "io/soup_check.h"
#include "io/soup_repair.h"
#include "surface/Surface.h"
#include "surface/attributes.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace pn_subdivide {
namespace {

constexpr std::uintmax_t bytes_worth_a_report = 1 << 23;

void announce_reading(const Mesh_file& file, const Report& report)
{
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file.name, error);
  if (!error && bytes >= bytes_worth_a_report)
    report.progress("reading " + file.name + " (" + std::to_string(bytes >> 20) + " MB)");
}

void report_what_is_dropped(const Mesh_data& mesh, const std::string& name, Report& report)
{
  if (!mesh.dropped.empty())
    report.warn_of_dropped(name + ": not carried over to the result: " + enumeration(mesh.dropped),
                           mesh.dropped);
}

bool may_mend(const Surface_options& options)
{
  return !options.no_mend && !options.report.strict;
}

// Most border edges lie on others.
bool is_unwelded(std::size_t equal_edges, const Soup_defects& defects)
{
  return 2 * equal_edges > defects.border.size();
}

// Where the surface is open although border edges lie on each other.
void report_contacts(const Mesh_data& mesh, const Soup_defects& defects, double joined_within,
                     const std::string& name, const Surface_options& options, Report& report)
{
  if (defects.border.empty()) return;
  constexpr double crack = 1e-6; // of the diagonal; nobody has meant it
  const double diagonal = diagonal_of(Bounding_box(mesh.points));
  const double distance =
    (std::max)({crack * diagonal, joined_within, rounding_of_floats(mesh.points)});
  const Border_contacts contacts = find_border_contacts(mesh, defects.border, distance);
  // what has not been mended although it might have been is left with more to repair
  const bool is_worse_joined = may_mend(options) && is_unwelded(contacts.equal, defects);
  if (contacts.any())
    report.warn(
      name + ": " +
      contacts.description(distance / diagonal, is_worse_joined ? "--repair" : "--merge-points"));
}

bool may_choose_normals(const Surface_options& options)
{
  return !options.linear && options.normals.value_or("auto") == "auto";
}

bool are_normals_taken(const Surface_options& options)
{
  return may_choose_normals(options) ||
         (!options.linear && (options.normals == "file" || options.normals == "smooth"));
}

void report_broken_normals(const Mesh_data& mesh, const std::string& name,
                           const Surface_options& options, Report& report)
{
  const Places& broken = mesh.broken_normals;
  if (broken.number > 0 && are_normals_taken(options))
    report.warn(name + ": " + plural(broken.number, "normal is", "normals are") +
                " not finite (first: " + broken.first + "), which means none there");
}

// Shading is looked for in the faces as they are in the file, and as they have been turned.
void note_shading(Mesh_data& mesh, const Surface_options& options)
{
  if (!mesh.flat_shading.is_there()) mesh.flat_shading = find_flat_shading(mesh);
  const bool is_open = may_choose_normals(options) && !mesh.are_said_to_be_control;
  if (is_open && !mesh.flat_shading.is_there() && !mesh.shading.is_there())
    mesh.shading = find_shading(mesh);
}

void make_manifold(Mesh_data& mesh, const std::string& name, const Surface_options& options,
                   double joined_within, Soup_defects defects, Report& report)
{
  if (options.repair) {
    Soup_repair repair = repair_soup(mesh);
    if (are_normals_taken(options)) {
      const Opposing_normals turned = turn_opposing_normals(mesh);
      repair.turned_normals = turned.number;
      repair.first_turned_normal = turned.first_vertex;
    }
    if (repair.changed_anything()) {
      report.warn(name + ": " + repair.description());
      defects = find_defects(mesh);
      note_shading(mesh, options);
    }
    report.add_repair("removed_degenerate_faces", repair.removed_degenerate_faces);
    report.add_repair("split_faces", repair.split_faces);
    report.add_repair("removed_duplicate_faces", repair.removed_duplicate_faces);
    report.add_repair("reversed_faces", repair.reversed_faces);
    report.add_repair("added_vertices", repair.added_vertices);
    report.add_repair("turned_components", repair.turned_components);
    report.add_repair("turned_normals", repair.turned_normals);
  }
  require_sound_elements(mesh);
  if (defects.none()) return report_contacts(mesh, defects, joined_within, name, options, report);
  throw Error(options.repair
                ? "--repair did not mend everything: " + defects.description(mesh)
                : defects.description(mesh) + "; --repair orients the faces and duplicates "
                                              "such edges and vertices");
}

void split_into_triangles(Mesh_data& mesh, const std::string& name, Report& report)
{
  Surface surface = make_surface(mesh);
  const Old_elements old(surface);
  const Triangulation triangulation = triangulate(surface);
  if (triangulation.split_faces == 0) return;
  Mesh_data split_mesh = to_mesh_data(surface);
  split_mesh.attributes = std::move(mesh.attributes);
  old.follow(surface, triangulation, split_mesh.attributes);
  split_mesh.merged_into = std::move(mesh.merged_into);
  split_mesh.copied_from = std::move(mesh.copied_from);
  split_mesh.vertices_with_several_normals = mesh.vertices_with_several_normals;
  split_mesh.flat_shading = mesh.flat_shading;
  split_mesh.shading = mesh.shading;
  split_mesh.normal_kind = mesh.normal_kind;
  split_mesh.tags = std::move(mesh.tags);
  mesh = std::move(split_mesh);
  report.note(name + ": " + plural(triangulation.split_faces, "face", "faces") +
              " split into triangles");
}

void report_merged_attributes(const Point_merge& merge, const std::string& name, Report& report)
{
  report.add_repair("merged_vertices", merge.merged_vertices);
  report.add_repair("joined_vertices", merge.joined_vertices);
  std::vector<std::string> names;
  for (const std::string& attribute : merge.differing_attributes)
    names.push_back("'" + Text_reader::printable(attribute) + "'");
  if (!names.empty())
    report.warn(name + ": merged vertices had different values of " + enumeration(names) +
                "; those of the first are kept");
}

void report_merge(const Point_merge& merge, double distance, const std::string& name,
                  Report& report)
{
  report_merged_attributes(merge, name, report);
  if (merge.merged_vertices > 0)
    report.note(name + ": " + plural(merge.merged_vertices, "vertex", "vertices") +
                " merged with an equal one");
  if (merge.joined_vertices > 0) {
    char text[60];
    std::snprintf(text, sizeof text, " joined with one within %.3g", distance);
    report.note(name + ": " + plural(merge.joined_vertices, "vertex", "vertices") + text);
  }
}

bool visits_vertices_twice(const Mesh_data& mesh)
{
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    std::vector<Mesh_data::Index> face(mesh.face(f).begin(), mesh.face(f).end());
    std::sort(face.begin(), face.end());
    if (std::adjacent_find(face.begin(), face.end()) != face.end()) return true;
  }
  return false;
}

// Merges equal points of a file that is nothing but loose faces without, unless that breaks more than it mends; returns how
// many vertices it takes.
std::size_t weld(Mesh_data& mesh, Soup_defects& defects, const std::string& name,
                 const Surface_options& options, Report& report)
{
  if (defects.border.empty() || !is_unwelded(number_of_equal(mesh, defects.border), defects))
    return 0;
  Mesh_data welded = mesh;
  const Point_merge merge = merge_equal_points(welded);
  Soup_defects rest = find_defects(welded);
  if (!options.repair && (visits_vertices_twice(welded) || !rest.has_edges_in_order())) return 0;
  report_merged_attributes(merge, name, report);
  mesh = std::move(welded);
  defects = std::move(rest);
  return merge.merged_vertices;
}

// Nobody means a file that falls apart, or two fans of faces that only touch, to be refused or refined as they are.
void mend(Mesh_data& mesh, Soup_defects& defects, const std::string& name,
          const Surface_options& options, Report& report)
{
  std::string done;
  const auto add = [&done](std::size_t number, const char* what) {
    if (number > 0)
      done += (done.empty() ? "" : ", ") + plural(number, "vertex", "vertices") + what;
  };
  add(weld(mesh, defects, name, options, report), " merged with an equal one");
  if (!options.repair && defects.pinched.number > 0) {
    const std::size_t copies = split_fans(mesh);
    report.add_repair("added_vertices", copies);
    add(copies, " added where fans of faces meet");
    defects = find_defects(mesh);
  }
  if (!done.empty()) report.note(name + ": " + done + "; --no-mend reads the file as it stands");
}

// Within which distance points are joined: that of the options, and in STL files, which have no other way to say which
// triangles are neighbors, that of rounding.
double distance_to_join(const Mesh_data& mesh, const Mesh_file& file,
                        const Surface_options& options)
{
  if (options.merge_distance)
    return parse_box_length(*options.merge_distance, "--merge-distance").of(mesh);
  return file.format == "stl" ? rounding_of_floats(mesh.points) : 0;
}

// What is left to mend afterwards.
Soup_defects merge_points(Mesh_data& mesh, const Mesh_file& file, const Surface_options& options,
                          double distance, Report& report)
{
  const bool is_wanted = options.merge_points || options.merge_distance;
  if (!is_wanted) {
    Soup_defects defects = find_defects(mesh);
    if (!(distance > 0) || (defects.none() && defects.border.empty())) return defects;
  }
  report_merge(merge_near_points(mesh, distance), distance, file.title("standard input"), report);
  return find_defects(mesh);
}

bool is_triangle(const Mesh_data::Face& face)
{
  return face.size() == 3;
}

} // namespace

double Box_length::of(const Mesh_data& mesh) const
{
  return is_of_diagonal ? value * diagonal_of(Bounding_box(mesh.points)) : value;
}

Box_length parse_box_length(const std::string& text, const std::string& option)
{
  Box_length distance;
  distance.is_of_diagonal = !text.empty() && text.back() == '%';
  const std::string number = distance.is_of_diagonal ? text.substr(0, text.size() - 1) : text;
  distance.value = parse_numbers(number, 1, option)[0];
  if (distance.value < 0) throw Usage_error(option + " " + text + ": it must not be negative");
  if (distance.is_of_diagonal) distance.value /= 100;
  return distance;
}

std::string size_of(const Mesh_data& mesh)
{
  return plural(mesh.points.size(), "vertex", "vertices") + ", " +
         plural(mesh.number_of_faces(), "face", "faces");
}

Mesh_data read_control_mesh(const Mesh_file& file, const Surface_options& options, Report& report)
{
  const std::string name = file.title("standard input");
  announce_reading(file, report);
  Mesh_data mesh = read_mesh(file, !options.drop_attributes);
  if (mesh.number_of_faces() >= faces_worth_a_report)
    report.progress("read " + name + ": " + size_of(mesh));
  report_what_is_dropped(mesh, name, report);
  report_broken_normals(mesh, name, options, report);

  require_finite_elements(mesh);
  const double distance = distance_to_join(mesh, file, options);
  Soup_defects defects = merge_points(mesh, file, options, distance, report);
  if (may_mend(options)) mend(mesh, defects, name, options, report);
  note_shading(mesh, options);
  make_manifold(mesh, name, options, distance, std::move(defects), report);
  if (options.triangulate) split_into_triangles(mesh, name, report);
  return mesh;
}

Scheme_choice chosen_scheme(const Mesh_data& mesh, const Scheme_choice& choice)
{
  if (!choice.scheme.empty()) return choice;
  bool triangles = true;
  for (std::size_t f = 0; f < mesh.number_of_faces() && triangles; ++f)
    triangles = is_triangle(mesh.face(f));
  Scheme_choice chosen = choice;
  chosen.scheme = triangles ? "loop" : "catmull-clark";
  require_surface_schemes(chosen);
  return chosen;
}

void require_faces_for_scheme(const Mesh_data& mesh, const Scheme_choice& choice)
{
  if (!needs_triangles(choice.scheme)) return;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    if (!is_triangle(mesh.face(f)))
      throw Error("face " + std::to_string(f) + " has " + std::to_string(mesh.face(f).size()) +
                  " vertices, and " + choice.scheme +
                  " refines triangles only; --triangulate splits such faces");
}

} // namespace pn_subdivide
