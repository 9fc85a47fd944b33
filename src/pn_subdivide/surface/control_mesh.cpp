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
#include "io/mesh_normals.h"
#include "io/soup_repair.h"
#include "surface/Surface.h"
#include "surface/attributes.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace pn_subdivide {
namespace {

constexpr std::uintmax_t bytes_worth_a_report = 1 << 23;

bool visits_vertices_twice(const Mesh_data& mesh)
{
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    std::vector<Index> face(mesh.face(f).begin(), mesh.face(f).end());
    std::sort(face.begin(), face.end());
    if (std::adjacent_find(face.begin(), face.end()) != face.end()) return true;
  }
  return false;
}

// Most border edges lie on others.
bool is_unwelded(std::size_t equal_edges, const Soup_defects& defects)
{
  return 2 * equal_edges > defects.border.size();
}

class Control_mesh_reader
{
public:
  Control_mesh_reader(const Mesh_file& file, const Surface_options& options, Report& report)
    : file_(file)
    , options_(options)
    , report_(report)
    , name_(file.title("standard input"))
    , may_mend_(!options.no_mend && !options.report.strict)
    , may_choose_normals_(!options.linear && options.normals.value_or("auto") == "auto")
    , takes_normals_(may_choose_normals_ || (!options.linear && (options.normals == "file" ||
                                                                 options.normals == "smooth")))
  {}

  Mesh_data operator()()
  {
    read();
    require_finite_elements(mesh_);
    merge_points();
    if (may_mend_) mend();
    note_shading();
    if (options_.repair) repair();
    require_manifold();
    if (options_.triangulate) split_into_triangles();
    return std::move(mesh_);
  }

private:
  void read()
  {
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(file_.name, error);
    if (!error && bytes >= bytes_worth_a_report)
      report_.progress("reading " + file_.name + " (" + std::to_string(bytes >> 20) + " MB)");
    mesh_ = read_mesh(file_, !options_.drop_attributes);
    if (mesh_.number_of_faces() >= faces_worth_a_report)
      report_.progress("read " + name_ + ": " + size_of(mesh_));
    if (!mesh_.dropped.empty())
      report_.warn_of_dropped(
        name_ + ": not carried over to the result: " + enumeration(mesh_.dropped), mesh_.dropped);
    const Places& broken = mesh_.broken_normals;
    if (broken.number > 0 && takes_normals_)
      report_.warn(name_ + ": " + plural(broken.number, "normal is", "normals are") +
                   " not finite (first: " + broken.first + "), which means none there");
  }

  // Within the distance of the options, and in STL files, which have no other way to say which triangles are neighbors, within
  // that of rounding.
  void merge_points()
  {
    if (options_.merge_distance)
      distance_ = parse_box_length(*options_.merge_distance, "--merge-distance").of(mesh_);
    else if (file_.format == "stl")
      distance_ = rounding_of_floats(mesh_.points);
    if (!options_.merge_points && !options_.merge_distance) {
      defects_ = find_defects(mesh_);
      if (!(distance_ > 0) || (defects_.none() && defects_.border.empty())) return;
    }
    const Point_merge merge = merge_near_points(mesh_, distance_);
    report_merged_attributes(merge);
    if (merge.merged_vertices > 0)
      report_.note(name_ + ": " + plural(merge.merged_vertices, "vertex", "vertices") +
                   " merged with an equal one");
    if (merge.joined_vertices > 0)
      report_.note(name_ + ": " + plural(merge.joined_vertices, "vertex", "vertices") +
                   formatted(" joined with one within %.3g", distance_));
    defects_ = find_defects(mesh_);
  }

  void report_merged_attributes(const Point_merge& merge)
  {
    report_.add_repair("merged_vertices", merge.merged_vertices);
    report_.add_repair("joined_vertices", merge.joined_vertices);
    std::vector<std::string> names;
    for (const std::string& attribute : merge.differing_attributes)
      names.push_back("'" + Text_reader::printable(attribute) + "'");
    if (!names.empty())
      report_.warn(name_ + ": merged vertices had different values of " + enumeration(names) +
                   "; those of the first are kept");
  }

  // Nobody means a file that falls apart, or two fans of faces that only touch, to be refused or refined as they are.
  void mend()
  {
    std::string done;
    const auto add = [&done](std::size_t number, const char* what) {
      if (number > 0)
        done += (done.empty() ? "" : ", ") + plural(number, "vertex", "vertices") + what;
    };
    add(weld(), " merged with an equal one");
    if (!options_.repair && defects_.pinched.number > 0 && !visits_vertices_twice(mesh_)) {
      const std::size_t copies = split_fans(mesh_);
      report_.add_repair("added_vertices", copies);
      add(copies, " added where fans of faces meet");
      defects_ = find_defects(mesh_);
    }
    if (!done.empty())
      report_.note(name_ + ": " + done + "; --no-mend reads the file as it stands");
  }

  // Merges equal points of a file that is nothing but loose faces without, unless that breaks more than it mends; returns how
  // many vertices it takes.
  std::size_t weld()
  {
    if (defects_.border.empty() || !is_unwelded(number_of_equal(mesh_, defects_.border), defects_))
      return 0;
    Mesh_data welded = mesh_;
    const Point_merge merge = merge_equal_points(welded);
    Soup_defects rest = find_defects(welded);
    if (!options_.repair && (visits_vertices_twice(welded) || !rest.has_edges_in_order())) return 0;
    report_merged_attributes(merge);
    mesh_ = std::move(welded);
    defects_ = std::move(rest);
    return merge.merged_vertices;
  }

  // Shading is looked for in the faces as they are in the file, and as they have been turned.
  void note_shading()
  {
    if (!mesh_.flat_shading.is_there()) mesh_.flat_shading = find_flat_shading(mesh_);
    const bool is_open = may_choose_normals_ && !mesh_.are_said_to_be_control;
    if (is_open && !mesh_.flat_shading.is_there() && !mesh_.shading.is_there())
      mesh_.shading = find_shading(mesh_);
  }

  void repair()
  {
    Soup_repair repair = repair_soup(mesh_);
    if (takes_normals_) {
      const Opposing_normals turned = turn_opposing_normals(mesh_);
      repair.turned_normals = turned.number;
      repair.first_turned_normal = turned.first_vertex;
    }
    if (repair.changed_anything()) {
      report_.warn(name_ + ": " + repair.description());
      defects_ = find_defects(mesh_);
      note_shading();
    }
    report_.add_repair("removed_degenerate_faces", repair.removed_degenerate_faces);
    report_.add_repair("split_faces", repair.split_faces);
    report_.add_repair("removed_duplicate_faces", repair.removed_duplicate_faces);
    report_.add_repair("reversed_faces", repair.reversed_faces);
    report_.add_repair("added_vertices", repair.added_vertices);
    report_.add_repair("turned_components", repair.turned_components);
    report_.add_repair("turned_normals", repair.turned_normals);
  }

  void require_manifold()
  {
    require_sound_elements(mesh_);
    if (defects_.none()) return report_contacts();
    throw Error(options_.repair
                  ? "--repair did not mend everything: " + defects_.description(mesh_)
                  : defects_.description(mesh_) + "; --repair orients the faces and duplicates "
                                                  "such edges and vertices");
  }

  // Where the surface is open although border edges lie on each other.
  void report_contacts()
  {
    if (defects_.border.empty()) return;
    constexpr double crack = 1e-6; // of the diagonal; nobody has meant it
    const double diagonal = diagonal_of(Bounding_box(mesh_.points));
    const double distance =
      (std::max)({crack * diagonal, distance_, rounding_of_floats(mesh_.points)});
    const Border_contacts contacts = find_border_contacts(mesh_, defects_.border, distance);
    // what has not been mended although it might have been is left with more to repair
    const bool is_worse_joined = may_mend_ && is_unwelded(contacts.equal, defects_);
    if (contacts.any())
      report_.warn(
        name_ + ": " +
        contacts.description(distance / diagonal, is_worse_joined ? "--repair" : "--merge-points"));
  }

  void split_into_triangles()
  {
    Surface surface = make_surface(mesh_);
    const Old_elements old(surface);
    const Triangulation triangulation = triangulate(surface);
    if (triangulation.split_faces == 0) return;
    old.follow(surface, triangulation, mesh_.attributes);
    Mesh_data split_mesh = to_mesh_data(surface);
    mesh_.take_normals(split_mesh);
    mesh_.take_roundness(split_mesh);
    mesh_.take_faces(split_mesh);
    report_.note(name_ + ": " + plural(triangulation.split_faces, "face", "faces") +
                 " split into triangles");
  }

  const Mesh_file& file_;
  const Surface_options& options_;
  Report& report_;
  const std::string name_;
  const bool may_mend_, may_choose_normals_, takes_normals_;
  Mesh_data mesh_;
  Soup_defects defects_; // that are left
  double distance_ = 0;  // within which points are joined
};

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
  return Control_mesh_reader(file, options, report)();
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
