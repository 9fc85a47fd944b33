// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_SLIVER_SEGMENTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_SLIVER_SEGMENTS_H

#include <CGAL/PN_subdivision_3/internal/recognition/Part.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Region.h>
#include <CGAL/PN_subdivision_3/internal/recognition/Shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {
namespace recognition {

// What every face of the part belongs to.
struct Segments
{
  struct Segment
  {
    Shape shape;
    int side = 1;
    double widest_step = 0, widest_meridian_step = 0, residual = 0;
    std::vector<Index> faces;
  };
  std::vector<Segment> segments;
  std::vector<Index> segment_of_face;
};

// Gives slivers, which have no normal, to the segments beside them.
class Give_slivers_away
{
public:
  Give_slivers_away(const Context& context, const Lists& edges_of_face, std::vector<Index>& label,
                    std::vector<Segments::Segment>& labels)
    : c_(context)
    , edges_of_face_(edges_of_face)
    , label_(label)
    , labels_(labels)
  {}

  // from the edge of what has labels, to the longest common border among the best
  void operator()()
  {
    std::vector<Index> slivers;
    for (Index f = 0; f < label_.size(); ++f)
      if (label_[f] == null) slivers.push_back(f);
    for (int quality = 0; quality < 4 && !slivers.empty();) {
      std::vector<std::pair<Index, Index>> given;
      std::vector<Index> rest;
      for (const Index f : slivers) {
        const Index label = label_for_sliver(f, quality);
        if (label == null)
          rest.push_back(f);
        else
          given.emplace_back(f, label);
      }
      for (const auto& g : given) label_[g.first] = g.second;
      quality = given.empty() ? quality + 1 : 0;
      slivers = rest;
    }
    if (slivers.empty()) return;
    labels_.emplace_back(); // components of nothing but slivers
    const Index label = Index(labels_.size()) - 1;
    for (const Index f : slivers) label_[f] = label;
  }

private:
  Index label_for_sliver(Index f, int quality) const
  {
    std::vector<std::pair<Index, double>> borders;
    for (const Index e : edges_of_face_[f]) {
      const Part::Edge& edge = c_.part.edges[e];
      const Index label = label_[c_.part.across(f, e)];
      if (label == null || !is_good_for(f, labels_[label].shape, quality)) continue;
      auto it = borders.begin();
      while (it != borders.end() && it->first != label) ++it;
      if (it == borders.end())
        borders.emplace_back(label, c_.part.length(edge));
      else
        it->second += c_.part.length(edge);
    }
    Index best = null;
    double longest = -1;
    for (const auto& b : borders)
      if (b.second > longest) {
        best = b.first;
        longest = b.second;
      }
    return best;
  }
  bool is_good_for(Index f, const Shape& s, int quality) const
  {
    if (quality == 3) return true;
    if (quality == 2 || s.kind == Kind::unknown) return quality == 2 && s.kind == Kind::unknown;
    for (const Index v : c_.part.corners[f])
      if (!(std::abs(s.distance(c_.point(v))) <= (quality == 0 ? 2 : 8) * c_.tolerance()))
        return false;
    return true;
  }

  const Context& c_;
  const Lists& edges_of_face_;
  std::vector<Index>& label_;
  std::vector<Segments::Segment>& labels_;
};

} // namespace recognition
} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_RECOGNITION_SLIVER_SEGMENTS_H
