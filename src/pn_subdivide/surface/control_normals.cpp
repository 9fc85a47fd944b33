// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/control_mesh.h"

#include "io/Error.h"
#include "io/Text_reader.h"
#include "io/mesh_normals.h"
#include "surface/Surface.h"

#include <CGAL/PN_fitting_3/smooth_control_normals.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>

#include <algorithm>
#include <cmath>

namespace pn_subdivide {
namespace {

using Source = Normals_option::Source;

constexpr PN::Control_normal_estimate default_estimate = PN::Control_normal_estimate::coherent;

PN::Control_normal_estimate default_of(const Normals_option& option)
{
  return option.is_reciprocal ? PN::Control_normal_estimate::reciprocal : default_estimate;
}

// In long double, so that normals of exact control data are correct to the last bit or nearly so.
using Long_vector = CGAL::Simple_cartesian<long double>::Vector_3;

Long_vector between(const Triple& p, const Triple& q)
{
  return Long_vector(static_cast<long double>(q[0]) - p[0], static_cast<long double>(q[1]) - p[1],
                     static_cast<long double>(q[2]) - p[2]);
}

Triple unit(const Long_vector& v)
{
  const long double length = std::sqrt(v.squared_length());
  if (!(length > 0)) return {0, 0, 0};
  return {static_cast<double>(v.x() / length), static_cast<double>(v.y() / length),
          static_cast<double>(v.z() / length)};
}

void point_away(Mesh_data& mesh, const Normals_option& option)
{
  const Long_vector d(option.axis[0], option.axis[1], option.axis[2]);
  mesh.normals.clear();
  mesh.normals.reserve(mesh.points.size());
  for (const Triple& p : mesh.points) {
    Long_vector v = between(option.center, p);
    if (option.source == Source::cylinder) v = v - d * ((v * d) / d.squared_length());
    mesh.normals.push_back(unit(v));
  }
}

// With the roundness that the estimate has.
void estimate(Mesh_data& mesh, PN::Control_normal_estimate how)
{
  mesh.normals.clear();
  Surface surface = make_surface(mesh);
  auto normals = surface.add_property_map<Vertex, Vector_3>("v:normal").first;
  const Roundness_map roundness = add_roundness(surface);
  PN::estimate_control_normals(
    surface, normals, PN::parameters::control_normal_estimate(how).vertex_roundness_map(roundness));
  mesh.roundness.clear();
  mesh.corner_roundness.clear();
  for (const Vertex v : surface.vertices()) {
    mesh.normals.push_back(to_triple(normals[v]));
    mesh.roundness.push_back(roundness[v]);
  }
}

// As the library does it on entry, so that no round and several rounds start from the same normals.
Vector_3 unit_normal(const Vector_3& n)
{
  using Traits = PN::Unit_normal_traits<double>;
  if (std::abs(n.squared_length() - 1) <= Traits::unit_tolerance()) return n;
  const double largest = (std::max)({std::abs(n.x()), std::abs(n.y()), std::abs(n.z())});
  if (largest == 0) return n;
  const Vector_3 scaled = n / largest;
  return scaled * Traits::inverse_length(scaled.squared_length());
}

// Vertices in one of whose wedges the corners have different normals.
std::size_t mixed_vertices(const Surface& surface, const Wedges& wedges,
                           const Corner_normal_map& normals)
{
  std::vector<Triple> first(wedges.vertex.size());
  std::vector<bool> is_known(first.size(), false), is_mixed(surface.number_of_vertices(), false);
  for (const Halfedge h : surface.halfedges()) {
    if (surface.is_border(h)) continue;
    const std::size_t wedge = wedges.of_corner[h];
    const Triple n = to_triple(normals[h]);
    if (normalized(n) == Triple{0, 0, 0}) continue; // none
    if (!is_known[wedge]) first[wedge] = n;
    is_known[wedge] = true;
    if (directions_differ(first[wedge], n)) is_mixed[surface.target(h)] = true;
  }
  return std::size_t(std::count(is_mixed.begin(), is_mixed.end(), true));
}

void normalize_corners(Mesh_data& mesh, const Creases& creases, const std::string& name,
                       Report& report)
{
  for (Triple& n : mesh.corner_normals) n = to_triple(unit_normal(to_vector(n)));
  const Surface surface = make_surface(mesh);
  const Wedges wedges(surface, [&](auto e) { return creases.is_sharp(e); });
  const std::size_t mixed = mixed_vertices(surface, wedges, *corner_normals_of(surface));
  if (mixed > 0)
    report.warn(name + ": " + plural(mixed, "vertex has", "vertices have") +
                " several normals that no crease separates; their normalized sum is taken");
}

// Vertices with several wedges have an estimate in each; the others keep their normal, if it is not to be
// estimated.
void estimate_between_creases(Mesh_data& mesh, std::optional<PN::Control_normal_estimate> of_all,
                              const Creases& creases)
{
  Surface surface = make_surface(mesh);
  const Crease_maps maps = add_creases(surface, creases);
  add_roundness(surface);
  const Corner_normal_map normals = add_corner_normals(surface);
  const auto estimated = PN::estimate_control_normals(
    surface, PN::parameters::control_normal_estimate(of_all.value_or(default_estimate))
               .edge_is_constrained_map(maps.edges)
               .vertex_is_constrained_map(maps.vertices));
  const Wedges wedges(surface, [&](auto e) { return creases.is_sharp(e); });
  for (const Halfedge h : surface.halfedges())
    if (!surface.is_border(h) && (of_all || wedges.number[surface.target(h)] > 1))
      normals.values[h] = {estimated[h], get(estimated.roundness_map(), h)};
  Mesh_data with_normals = to_mesh_data(surface);
  mesh.take_normals(with_normals);
  if (of_all || mesh.roundness.empty()) mesh.take_roundness(with_normals);
}

// With the roundness that the estimate has.
void set_estimated_normals(Mesh_data& mesh, const Creases& creases)
{
  estimate(mesh, default_estimate);
  if (creases.any()) estimate_between_creases(mesh, default_estimate, creases);
}

void set_without_fractions(Creases& creases, Mesh_data mesh,
                           std::optional<PN::Control_normal_estimate> of_all)
{
  Creases others = creases;
  bool has_fractions = false, has_others = false;
  for (std::vector<double>* const of_elements : {&others.edges, &others.vertices})
    for (double& s : *of_elements) {
      has_fractions = has_fractions || (s > 0 && s < 1);
      if (s < 1) s = 0;
      has_others = has_others || s > 0;
    }
  if (!has_fractions) return;
  if (has_others) estimate_between_creases(mesh, of_all, others);
  Surface surface = make_surface(mesh);
  creases.without_fractions = std::make_shared<Normals_without_fractions>(
    Normals_without_fractions{take_corner_normals(surface), !mesh.roundness.empty()});
}

// Vertices whose normal in the file gives way to several.
void report_estimated_wedges(const Mesh_data& mesh, const Creases& creases, const std::string& name,
                             Report& report)
{
  const Surface surface = make_surface(mesh);
  const Wedges wedges(surface, [&](auto e) { return creases.is_sharp(e); });
  const auto several =
    std::count_if(wedges.number.begin(), wedges.number.end(), [](std::size_t n) { return n > 1; });
  if (several > 0)
    report.warn(name + ": " +
                plural(std::size_t(several), "vertex on creases has", "vertices on creases have") +
                " one normal in the file and need several, which are estimated");
}

// How all normals are to be estimated, if they are.
std::optional<PN::Control_normal_estimate> estimate_of_all(const Mesh_data& mesh,
                                                           const Normals_option& option)
{
  if (option.source == Source::angle) return PN::Control_normal_estimate::angle;
  if (option.source == Source::reciprocal) return PN::Control_normal_estimate::reciprocal;
  if (option.source == Source::estimate ||
      (option.source == Source::automatic && !mesh.has_normals()))
    return default_of(option);
  return std::nullopt;
}

// Those of wedges if there are creases; returns whether any has changed.
bool smooth(Mesh_data& mesh, const Creases& creases, const std::string& name, Report& report)
{
  Surface surface = make_surface(mesh);
  const PN::Normal_smoothing_report done =
    creases.any() ? PN::smooth_control_normals(surface, *corner_normals_of(surface),
                                               CGAL::parameters::edge_is_constrained_map(
                                                 add_creases(surface, creases).edges))
                  : PN::smooth_control_normals(surface, *normals_of(surface));
  const std::string text = name + formatted(": the normals in the file have a noise of about %.2g "
                                            "degrees and miss arcs by %.2g: ",
                                            done.noise, done.arc_defect);
  if (done.changed_normals == 0 && done.roundness == 1) {
    const bool is_rough = done.mean_turn > done.linear_mean_turn;
    report.warn(
      text +
      formatted("left as they are, since this does not stand out from what the shape itself does "
                "to arcs; the faces turn by %.3g degrees on average, those of the linear result by "
                "%.3g%s",
                done.mean_turn, done.linear_mean_turn,
                is_rough ? ": if that is rough take --roundness 0.5, or --linear" : ""));
    return false;
  }
  std::string change = "left as they are";
  if (done.changed_normals > 0) {
    change =
      formatted("%zu smoothed, by up to %.2g degrees", done.changed_normals, done.largest_turn);
    Mesh_data smoothed = to_mesh_data(surface);
    mesh.take_normals(smoothed);
  }
  if (done.roundness < 1) {
    mesh.roundness.assign(mesh.points.size(), done.roundness);
    mesh.corner_roundness.clear();
    change += formatted("; the points have noise, too: roundness %g", done.roundness);
  }
  report.remark(text + change);
  return done.changed_normals > 0;
}

// A file of this command gets a warning, because there is one with which its rounds go on.
void drop_shading(Mesh_data& mesh, const std::string& name, Report& report)
{
  const Shading& shading = mesh.shading;
  const std::string text =
    name + ": the normals in the file are shading normals, unit sums of those of the faces " +
    shading.weights + " (" + std::to_string(shading.normals) + " of " + std::to_string(shading.of) +
    "), which say nothing that the faces do not: normals are estimated as if there were none "
    "(--normals file takes them)";
  if (mesh.normal_kind == Normal_kind::control)
    report.remark(text);
  else
    report.warn(text + "; --output-normals both writes a file from which a further round takes "
                       "the control normals");
  mesh.drop_normals();
}

// They are estimated.
void set_aside(Mesh_data& mesh, const Stray_normals& stray, const Creases& creases,
               const std::string& name, Report& report)
{
  report.remark(name +
                formatted(": the normals in the file are %.0f degrees off those of the faces on "
                          "%zu of %zu components in the median and are set aside there: they are "
                          "estimated (--normals file takes them)",
                          stray.degrees, stray.components, stray.of));
  if (stray.components == stray.of) return mesh.drop_normals();
  Mesh_data estimated = mesh;
  estimated.drop_normals();
  set_estimated_normals(estimated, creases);
  mesh.roundness.assign(mesh.points.size(), 1.);
  mesh.corner_roundness.assign(estimated.corner_roundness.size(), 1.);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (stray.is_stray[v]) {
      mesh.normals[v] = estimated.normals[v];
      mesh.roundness[v] = estimated.roundness[v];
    }
  for (std::size_t c = 0; c < mesh.number_of_corners(); ++c) {
    const Index v = mesh.vertices_of_corners()[c];
    if (!stray.is_stray[v]) continue;
    if (!mesh.corner_normals.empty())
      mesh.corner_normals[c] =
        estimated.corner_normals.empty() ? estimated.normals[v] : estimated.corner_normals[c];
    if (!mesh.corner_roundness.empty()) mesh.corner_roundness[c] = estimated.corner_roundness[c];
  }
}

} // namespace

Normals_option parse_normals_option(const std::string& text)
{
  Normals_option option;
  const auto [name, arguments] = split_at_colon(text);

  if (name == "sphere") {
    const std::vector<double> x = parse_numbers(arguments, 3, "--normals sphere:X,Y,Z");
    option.source = Source::sphere;
    option.center = {x[0], x[1], x[2]};
  } else if (name == "cylinder") {
    const std::vector<double> x = parse_numbers(arguments, 6, "--normals cylinder:X,Y,Z,DX,DY,DZ");
    require_direction(&x[3], "--normals cylinder");
    option.source = Source::cylinder;
    option.center = {x[0], x[1], x[2]};
    const double largest = (std::max)({std::abs(x[3]), std::abs(x[4]), std::abs(x[5])});
    option.axis = {x[3] / largest, x[4] / largest, x[5] / largest};
  } else
    option.source = parse_word<Source>("--normals", text,
                                       {{"auto", Source::automatic},
                                        {"file", Source::file},
                                        {"smooth", Source::file},
                                        {"estimate", Source::estimate},
                                        {"coherent", Source::estimate},
                                        {"reciprocal", Source::reciprocal},
                                        {"angle", Source::angle},
                                        {"none", Source::none},
                                        {"sphere:X,Y,Z", Source::sphere},
                                        {"cylinder:X,Y,Z,DX,DY,DZ", Source::cylinder}});
  option.smooths = text == "smooth";
  return option;
}

void set_control_normals(Mesh_data& mesh, const Normals_option& option)
{
  const bool is_shape = option.source == Source::sphere || option.source == Source::cylinder;
  if (option.source == Source::file && !mesh.has_normals())
    throw Error(std::string("--normals ") + (option.smooths ? "smooth" : "file") +
                ", but the file has no vertex normals; --normals estimate makes some");
  if (const std::optional<PN::Control_normal_estimate> how = estimate_of_all(mesh, option))
    estimate(mesh, *how);
  if (option.source == Source::none) mesh.normals.clear();
  if (is_shape) point_away(mesh, option);
  mesh.corner_normals.clear();
  for (Triple& n : mesh.normals) n = to_triple(unit_normal(to_vector(n)));
}

bool set_control_normals(Mesh_data& mesh, const Normals_option& option, Creases& creases,
                         const std::string& name, Report& report)
{
  if (!creases.any()) {
    set_control_normals(mesh, option);
    return option.smooths && smooth(mesh, creases, name, report);
  }
  std::vector<Triple> corner_normals;
  corner_normals.swap(mesh.corner_normals);
  const bool from_file =
    option.source == Source::file || (option.source == Source::automatic && mesh.has_normals());
  const std::optional<PN::Control_normal_estimate> of_all = estimate_of_all(mesh, option);
  set_control_normals(mesh, option);
  if (!mesh.has_normals() || (from_file && are_all_zero(mesh))) return false;
  if (from_file && !corner_normals.empty()) {
    mesh.corner_normals.swap(corner_normals);
    normalize_corners(mesh, creases, name, report);
  } else {
    set_without_fractions(creases, mesh, of_all);
    estimate_between_creases(mesh, of_all, creases);
    if (from_file) report_estimated_wedges(mesh, creases, name, report);
  }
  return option.smooths && smooth(mesh, creases, name, report);
}

void put_estimated_roundness(Mesh_data& mesh, const Creases& creases)
{
  Mesh_data points = mesh;
  points.corner_normals.clear();
  points.attributes = Attributes();
  set_estimated_normals(points, creases);
  mesh.take_roundness(points);
}

constexpr const char* no_creases = " (--sharp none takes none)";

void settle_file_normals(Mesh_data& mesh, const Normals_option& option, const Creases& creases,
                         bool can_be_sharp, const std::string& name, Report& report)
{
  if (!mesh.has_normals()) return;
  const bool may_drop = option.source == Source::automatic;
  if (are_all_zero(mesh)) {
    if (!may_drop) return;
    mesh.drop_normals();
    return report.remark(name + ": the normals of the file are all zero, which is none: they are "
                                "estimated; --normals file leaves them zero");
  }
  const std::string edges = plural(creases.number_of_edges, "edge", "edges");
  const Flat_shading& flat = mesh.flat_shading;
  if (!flat.is_there()) {
    if (creases.are_by_normals)
      report.remark(name + ": the normals in the file differ at " + edges + ", taken for creases" +
                    no_creases);
    if (!may_drop || mesh.are_said_to_be_control) return;
    if (mesh.shading.is_there()) return drop_shading(mesh, name, report);
    if (!mesh.roundness.empty()) return;
    const Stray_normals stray = find_stray_normals(mesh);
    if (stray.components > 0) set_aside(mesh, stray, creases, name, report);
    return;
  }
  std::string text = name + ": the normals in the file are those of its faces, for flat shading (" +
                     std::to_string(flat.normals) + " different on " + std::to_string(flat.faces) +
                     (flat.faces == 1 ? " face): " : " faces): ");
  if (creases.are_by_normals)
    return report.remark(text + edges + " where they differ, taken for creases" + no_creases);
  const bool has_edges = mesh.has_corner_normals() && can_be_sharp;
  if (has_edges) text += "not taken for creases (--sharp file takes them)";
  if (may_drop) {
    text += (has_edges ? ", " : "") +
            std::string("normals are estimated as if there were none (--normals file takes them)");
    mesh.drop_normals();
  }
  if (has_edges || may_drop) report.remark(text);
}

} // namespace pn_subdivide
