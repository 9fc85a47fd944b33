// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Linear_check.h"

#include "io/Error.h"
#include "surface/Recognized_part.h"
#include "surface/refine_surface.h"

#include <CGAL/PN_certificates_3/compare_with_linear.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pn_subdivide {
namespace {

using Shape = PN::internal::Level_shape;
using Points = std::vector<std::array<double, 3>>;

std::string decimals(double x)
{
  return formatted(std::abs(x) < 1e6 ? "%.3f" : "%.3e", x);
}

Turning_edges turning_edges_of(Surface& surface, const std::vector<double>& sharpness)
{
  const auto turns = surface.add_property_map<Edge, bool>("e:turns", false).first;
  PN::detect_creases(surface, PN::internal::degrees_of_turning_edges, turns);
  Turning_edges result;
  for (const Edge e : surface.edges())
    result.number += turns[e] && (sharpness.empty() || !(sharpness[e] > 0));
  result.of = surface.number_of_edges();
  return result;
}

Points points_of(const Surface& surface)
{
  Points points;
  points.reserve(surface.number_of_vertices());
  for (const Vertex v : surface.vertices()) points.push_back(to_triple(surface.point(v)));
  return points;
}

using Frame = PN::internal::Unit_frame<double>;

Shape shape_of(const Surface& surface, const Frame& frame, std::vector<bool> is_sharp)
{
  PN::Level_connectivity level;
  PN::internal::with_mesh_access(
    surface, [&](const auto& access) { level = PN::internal::checked_level(access); });
  return Shape(std::move(level), frame(points_of(surface)), std::move(is_sharp), frame.rounding());
}

Mesh_measures measures_of(const Shape& shape)
{
  const double cosine_of_150_degrees = -std::sqrt(3.) / 2, cosine_of_91_degrees = -0.0175;
  const auto sharp_folds = shape.folds_beyond(cosine_of_150_degrees);
  Mesh_measures m;
  m.folded_edges = shape.edges_beyond(0);
  m.folded_length = shape.folds_beyond(cosine_of_91_degrees).length;
  m.sharply_folded_edges = sharp_folds.edges;
  m.sharply_folded_length = sharp_folds.length;
  return m;
}

void measure_distance(const Surface& surface, const Shape& shape,
                      const Reference_surface& reference, int exponent, Mesh_measures& m)
{
  constexpr std::size_t most = 100000;
  const std::size_t step = shape.points().size() / most + 1;
  for (std::size_t v = 0; v < shape.points().size(); v += step) {
    if (surface.is_isolated(Vertex(Surface::size_type(v)))) continue;
    const double distance = std::ldexp(reference.distance(shape.points()[v]), exponent);
    if (!(distance > m.distance)) continue;
    m.distance = distance;
    m.farthest_vertex = v;
  }
}

constexpr double kept = 0.05; // of logarithms

} // namespace

Turning_edges find_turning_edges(const Mesh_data& mesh, const Creases& creases)
{
  Surface surface = make_surface(mesh);
  return turning_edges_of(surface, creases.edges);
}

std::string turning_edges_text(std::size_t number, const std::string& edge)
{
  return plural(number, edge + " turns", edge + "s turn") +
         formatted(" by more than %.0f degrees", PN::internal::degrees_of_turning_edges);
}

bool Mesh_measures::is_swollen() const
{
  return volume && *volume > std::exp(kept);
}

bool Mesh_measures::is_lost() const
{
  return volume && *volume < std::exp(-kept);
}

// Creases that turn that much stay, and may become longer as they become round.
bool Mesh_measures::is_folded(const Mesh_measures& control) const
{
  constexpr std::size_t few = 4;
  constexpr double factor = 1.1, length = 1e-3;
  return (folded_edges > few && folded_length > factor * control.folded_length + length) ||
         sharply_folded_length > factor * control.sharply_folded_length + length;
}

Linear_check::Linear_check(const Surface& control, const Creases& creases, const Choices& choices)
  : choices_(choices)
  , control_(control)
{
  if (const std::optional<Roundness_map> roundness = roundness_of(control_)) {
    const auto all = control_.vertices();
    const auto number = [&](const auto& is_counted) {
      return std::size_t(std::count_if(all.begin(), all.end(),
                                       [&](Vertex v) { return is_counted((*roundness)[v]); }));
    };
    if (number([&](double w) { return w == (*roundness)[*all.begin()]; }) < all.size()) {
      of_roundness_0_ = number([](double w) { return w == 0; });
      of_roundness_below_1_ = number([](double w) { return w < 1; });
    }
  }
  remove_normals(control_);
  for (const double s : creases.edges) is_sharp_.push_back(s > 0);
  turning_ = turning_edges_of(control_, creases.edges);
}

void Linear_check::set_net(const Surface& net, const std::optional<Crease_maps>& creases)
{
  net_ = net;
  net_creases_ = creases_of(net_, creases);
  remove_normals(net_);
}

// The net becomes it.
void Linear_check::make_linear(const Scheme_choice& scheme, const Rounds& rounds)
{
  PN::Attribute_table no_attributes;
  if (rounds.chord) {
    tessellate_surface(net_, scheme, net_creases_, *rounds.chord, false, no_attributes);
    net_creases_.reset();
    return;
  }
  refine_surface(net_, scheme, {rounds.levels, net_creases_, nullptr, &no_attributes, {}});
  Limit_choice limit = rounds.limit;
  limit.normals = false;
  if (limit.points) set_limits(net_, scheme, limit, net_creases_, rounds.levels);
}

void Linear_check::compare(const Surface& result, const Scheme_choice& scheme, const Rounds& rounds)
{
  make_linear(scheme, rounds);
  const Points points = points_of(control_);
  const Frame frame(points);
  const std::vector<bool> of_result = sharp_edges_of(result), of_linear = sharp_edges_of(net_);
  const bool are_known = net_creases_ && !of_result.empty() && !of_linear.empty();
  const auto shape = [&](const Surface& surface, const std::vector<bool>& is_sharp) {
    return shape_of(surface, frame, are_known ? is_sharp : std::vector<bool>());
  };
  const Shape control = shape(control_, is_sharp_);
  const Reference_surface reference(
    control_, control.points(),
    {std::ldexp(1., frame.exponent()), points.empty() ? Triple{} : points.front()}, choices_.part);
  reference_ = reference.has_round_surfaces() ? "the recognized surfaces" : "the control mesh";
  of_control_ = measures_of(control);
  const double volume =
    control.is_closed() && control.volume() != 0 ? control.volume() + reference.gained_volume() : 0;
  const auto measure = [&](const Surface& mesh, const Shape& of_mesh) {
    Mesh_measures m = measures_of(of_mesh);
    if (volume != 0 && of_mesh.is_closed()) m.volume = of_mesh.volume() / volume;
    measure_distance(mesh, of_mesh, reference, frame.exponent(), m);
    return m;
  };
  of_result_ = measure(result, shape(result, of_result));
  of_linear_ = measure(net_, shape(net_, of_linear));
  net_ = Surface(); // the maps of a mesh go with it
  net_creases_.reset();
}

bool Linear_check::is_bad(const Mesh_measures& m) const
{
  return m.is_swollen() || m.is_lost() || m.is_folded(of_control_);
}

std::string Linear_check::verdict(const Mesh_measures& m) const
{
  const std::string folded = m.is_folded(of_control_) ? "FOLDED" : "";
  const std::string volume = m.is_swollen() ? "SWOLLEN" : m.is_lost() ? "LOST" : "";
  if (volume.empty() && folded.empty()) return m.volume ? "kept" : "not folded";
  return volume + (volume.empty() || folded.empty() ? "" : ", ") + folded;
}

std::string Linear_check::advice() const
{
  constexpr double keeps_round_volumes = 0.5;
  const bool is_rounder = choices_.roundness && *choices_.roundness > keeps_round_volumes;
  const auto tagged = std::size_t(std::count(is_sharp_.begin(), is_sharp_.end(), true));
  if (choices_.may_be_part &&
      edge_advice(choices_.part, turning_.number + tagged, turning_.of) == Edge_advice::part)
    return "It looks like a part: try --part";
  if (choices_.may_tag && edge_advice(nullptr, turning_.number, turning_.of) == Edge_advice::angle)
    return turning_edges_text(turning_.number, "control edge") + ": tag them (--sharp angle:40)" +
           (is_rounder ? ", or --roundness auto" : "");
  const bool is_only_lost = of_result_.is_lost() && !of_result_.is_folded(of_control_);
  if (is_only_lost && choices_.may_interpolate)
    return "Try --interpolate slide, whose surface passes through the points";
  if (is_rounder || choices_.has_given_normals) return "Try --roundness auto --normals estimate";
  if (is_only_lost)
    return choices_.roundness ? "Try --roundness auto" : "Take a finer control mesh";
  return choices_.roundness ? "Try --linear" : "Try --roundness 0.5"; // one that is not above that
}

std::vector<std::string> Linear_check::lines() const
{
  const Mesh_measures &m = of_result_, &l = of_linear_;
  const auto beside = [](const auto& text) { return " (linear " + text + ")"; };
  std::vector<std::string> lines;
  if (m.volume && l.volume)
    lines.push_back("volume " + decimals(*m.volume) + " of " + reference_ +
                    beside(decimals(*l.volume)));
  lines.push_back(plural(m.folded_edges, "edge folds", "edges fold") + " by more than 90 degrees" +
                  beside(std::to_string(l.folded_edges)) + ", " +
                  std::to_string(m.sharply_folded_edges) + " by more than 150" +
                  beside(std::to_string(l.sharply_folded_edges)));
  lines.push_back("farthest from " + reference_ + " " + three_digits(m.distance) +
                  beside(three_digits(l.distance)) + ", at vertex " +
                  std::to_string(m.farthest_vertex));
  if (of_roundness_below_1_ > 0)
    lines.push_back("roundness 0 at " + std::to_string(of_roundness_0_) + " of " +
                    std::to_string(control_.number_of_vertices()) + " vertices, below 1 at " +
                    std::to_string(of_roundness_below_1_));
  lines.push_back(verdict(m) + beside(verdict(l)) + (is_bad(m) ? ". " + advice() : ""));
  return lines;
}

void Linear_check::print(std::FILE* stream) const
{
  for (const std::string& line : lines()) std::fprintf(stream, "check: %s\n", line.c_str());
  if (std::fflush(stream) != 0 || std::ferror(stream))
    throw Error("--check: what was measured cannot be printed");
}

Report::Row Linear_check::values() const
{
  Report::Row values;
  const auto add = [&](const std::string& before, const Mesh_measures& m) {
    if (m.volume) values.emplace_back(before + "volume", *m.volume);
    values.emplace_back(before + "edges_folded_by_90_degrees", m.folded_edges);
    values.emplace_back(before + "edges_folded_by_150_degrees", m.sharply_folded_edges);
    values.emplace_back(before + "largest_distance", m.distance);
    values.emplace_back(before + "farthest_vertex", m.farthest_vertex);
    values.emplace_back(before + "swollen", m.is_swollen());
    values.emplace_back(before + "lost", m.is_lost());
    values.emplace_back(before + "folded", m.is_folded(of_control_));
  };
  add("", of_result_);
  add("linear_", of_linear_);
  values.emplace_back("compared_with", reference_);
  if (of_roundness_below_1_ > 0) {
    values.emplace_back("vertices_of_roundness_0", of_roundness_0_);
    values.emplace_back("vertices_of_roundness_below_1", of_roundness_below_1_);
  }
  values.emplace_back("edges_that_turn_by_40_degrees", turning_.number);
  if (is_bad(of_result_)) values.emplace_back("advice", advice());
  return values;
}

} // namespace pn_subdivide
