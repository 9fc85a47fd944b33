// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Linear_check.h"

#include "io/Error.h"
#include "surface/limit_surface.h"
#include "surface/refine_surface.h"

#include <CGAL/PN_subdivision_3/detect_creases.h>

#include <cmath>
#include <utility>

namespace pn_subdivide {
namespace {

namespace PN = CGAL::PN_subdivision_3;

std::string decimals(double x, int digits)
{
  char text[40];
  std::snprintf(text, sizeof text, std::abs(x) < 1e6 ? "%.*f" : "%.*e", digits, x);
  return text;
}

// The sharpness of edges, of which there may be a map.
struct Sharpness_of_edges
{
  using key_type = Surface::Edge_index;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  friend double get(const Sharpness_of_edges& of_edges, key_type e)
  {
    return *of_edges.maps ? (**of_edges.maps).edges[e] : 0;
  }
  const std::optional<Crease_maps>* maps;
};

auto sharp(const std::optional<Crease_maps>& creases)
{
  return CGAL::parameters::edge_is_constrained_map(Sharpness_of_edges{&creases});
}

} // namespace

std::size_t number_of_turning_edges(const Mesh_data& mesh, const Creases& creases)
{
  using Edge = Surface::Edge_index;
  Surface surface = make_surface(mesh);
  const auto turns = surface.add_property_map<Edge, bool>("e:turns", false).first;
  PN::detect_creases(surface, PN::internal::degrees_of_turning_edges, turns);
  std::size_t number = 0;
  for (const Edge e : surface.edges()) number += turns[e] && !creases.is_sharp(e);
  return number;
}

std::string turning_edges_text(std::size_t number, const std::string& edge)
{
  return std::to_string(number) + " " + edge + (number == 1 ? " turns" : "s turn") +
         " by more than " + decimals(PN::internal::degrees_of_turning_edges, 0) + " degrees";
}

Linear_check::Linear_check(const Surface& control, const Creases& creases, const Choices& choices)
  : choices_(choices)
  , control_(control)
{
  remove_normals(control_);
  control_creases_ = add_creases(control_, creases);
}

void Linear_check::set_net(const Surface& net, const std::optional<Crease_maps>& creases)
{
  net_ = net;
  net_creases_ = creases_of(net_, creases);
  remove_normals(net_);
}

void Linear_check::compare(const Surface& result, const std::optional<Crease_maps>& creases,
                           const Scheme_choice& scheme, const Rounds& rounds)
{
  PN::Attribute_table no_attributes;
  Refinement refinement;
  refinement.levels = rounds.levels;
  refinement.threads = rounds.threads;
  refinement.creases = net_creases_;
  refinement.attributes = &no_attributes;
  refine_surface(net_, scheme, refinement);
  Limit_choice limit = rounds.limit;
  limit.normals = false;
  if (limit.points && net_creases_)
    set_limits(net_, scheme, limit, *net_creases_, rounds.levels, rounds.threads);
  else if (limit.points)
    set_limits(net_, scheme, limit, rounds.levels, rounds.threads);
  comparison_ = PN::compare_with_linear(control_, result, net_, sharp(control_creases_),
                                        sharp(creases), sharp(net_creases_));
  comparison_.vertices_of_roundness_0 = choices_.of_roundness_0;
  comparison_.vertices_of_roundness_below_1 = choices_.of_roundness_below_1;
  net_ = Surface(); // the maps of a mesh go with it
  net_creases_.reset();
}

std::string Linear_check::verdict() const
{
  const std::string swollen = comparison_.is_swollen() ? "SWOLLEN" : "",
                    folded = comparison_.is_folded() ? "FOLDED" : "";
  return swollen + (swollen.empty() || folded.empty() ? "" : ", ") + folded;
}

std::string Linear_check::advice() const
{
  constexpr double keeps_round_volumes = 0.5;
  const bool is_rounder = choices_.roundness && *choices_.roundness > keeps_round_volumes;
  if (comparison_.turning_edges > 0 && choices_.may_tag)
    return turning_edges_text(comparison_.turning_edges, "control edge") +
           ": tag them (--sharp angle:40)" + (is_rounder ? ", or --roundness auto" : "");
  if (is_rounder || choices_.has_given_normals) return "Try --roundness auto --normals estimate";
  return choices_.roundness ? "Try --linear" : "Try --roundness 0.5"; // one that is not above that
}

std::vector<std::string> Linear_check::lines() const
{
  const Comparison& c = comparison_;
  const auto linear = [](std::size_t number) { return " (linear " + std::to_string(number) + ")"; };
  std::vector<std::string> lines;
  if (!std::isnan(c.volume_ratio))
    lines.push_back("volume " + decimals(c.volume_ratio, 3) + " of the control mesh (linear " +
                    decimals(c.linear_volume_ratio, 3) + ")");
  lines.push_back(std::to_string(c.folded_edges) +
                  (c.folded_edges == 1 ? " edge folds" : " edges fold") +
                  " by more than 90 degrees" + linear(c.linear_folded_edges) + ", " +
                  std::to_string(c.sharply_folded_edges) + " by more than 150" +
                  linear(c.linear_sharply_folded_edges));
  lines.push_back("farthest from the linear result " + decimals(c.largest_distance, 2) +
                  " of the local edge length, at vertex " + std::to_string(c.farthest_vertex));
  if (c.vertices_of_roundness_below_1 > 0)
    lines.push_back("roundness 0 at " + std::to_string(c.vertices_of_roundness_0) + " of " +
                    std::to_string(c.control_vertices) + " vertices, below 1 at " +
                    std::to_string(c.vertices_of_roundness_below_1));
  const std::string words = verdict();
  lines.push_back(words.empty() ? "as good as linear" : words + ". " + advice());
  return lines;
}

void Linear_check::print(std::FILE* stream) const
{
  for (const std::string& line : lines()) std::fprintf(stream, "check: %s\n", line.c_str());
  if (std::fflush(stream) != 0 || std::ferror(stream))
    throw Error("--check: what was measured cannot be printed");
}

std::vector<Report::Value> Linear_check::values() const
{
  const Comparison& c = comparison_;
  std::vector<Report::Value> values;
  if (!std::isnan(c.volume_ratio)) {
    values.emplace_back("volume", c.volume_ratio);
    values.emplace_back("linear_volume", c.linear_volume_ratio);
  }
  values.emplace_back("edges_folded_by_90_degrees", c.folded_edges);
  values.emplace_back("linear_edges_folded_by_90_degrees", c.linear_folded_edges);
  values.emplace_back("edges_folded_by_150_degrees", c.sharply_folded_edges);
  values.emplace_back("linear_edges_folded_by_150_degrees", c.linear_sharply_folded_edges);
  values.emplace_back("largest_distance_in_edge_lengths", c.largest_distance);
  values.emplace_back("farthest_vertex", c.farthest_vertex);
  if (c.vertices_of_roundness_below_1 > 0) {
    values.emplace_back("vertices_of_roundness_0", c.vertices_of_roundness_0);
    values.emplace_back("vertices_of_roundness_below_1", c.vertices_of_roundness_below_1);
  }
  values.emplace_back("edges_that_turn_by_40_degrees", c.turning_edges);
  values.emplace_back("swollen", c.is_swollen());
  values.emplace_back("folded", c.is_folded());
  if (!verdict().empty()) values.emplace_back("advice", advice());
  return values;
}

} // namespace pn_subdivide
