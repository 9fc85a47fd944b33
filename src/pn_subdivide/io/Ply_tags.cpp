// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Ply_tags.h"

#include "io/Error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

namespace pn_subdivide {
namespace {

double checked_tangent(double x)
{
  if (!std::isfinite(x)) throw Error("a tangent that is not finite");
  return x;
}

} // namespace

Ply_tags::Ply_tags(const Ply_header& header)
{
  for (const Ply_element& element : header.elements) {
    if (element.name != "edge") continue;
    std::size_t found = 0;
    for (; found < places_.size(); ++found) {
      places_[found] = element.find(edge_properties[found]);
      const std::size_t place = places_[found];
      if (place == Ply_element::none || element.properties[place].is_list) break;
    }
    if (found < 3) continue;
    edges_ = &element;
    has_tangents_ = found == places_.size();
  }
}

void Ply_tags::add_edge(const std::vector<double>& scalars, std::size_t number_of_vertices,
                        Crease_tags& tags) const
{
  Crease_tags::Edge edge{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double v = scalars[places_[i]];
    if (!(v >= 0 && v < double(number_of_vertices)) || v != std::floor(v)) {
      std::ostringstream message;
      message << "its vertex " << v << " is out of range, there are " << number_of_vertices
              << " vertices";
      throw Error(message.str());
    }
    edge.ends[i] = static_cast<std::uint32_t>(v);
  }
  edge.sharpness = scalars[places_[2]];
  require_sharpness(edge.sharpness);
  for (std::size_t k = 0; k < 6 && has_tangents_; ++k)
    edge.tangents[k / 3][k % 3] = checked_tangent(scalars[places_[3 + k]]);
  if (edge.sharpness > 0) tags.edges.push_back(edge);
}

void require_sharpness(double sharpness)
{
  if (!(sharpness >= 0)) throw Error("a sharpness that is negative or no number");
}

} // namespace pn_subdivide
