// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/near_points.h"

#include "io/Error.h"
#include "io/corner_normals.h"
#include "io/soup_check.h"

#include <CGAL/box_intersection_d.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pn_subdivide {
namespace {

using Index = Mesh_data::Index;

struct Pair
{
  double distance;
  Index a, b; // a < b
};

std::vector<Pair> pairs_within(const Mesh_data& mesh, const std::vector<Index>& vertices,
                               double distance)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Index>;
  std::vector<Box> boxes;
  boxes.reserve(vertices.size());
  for (const Index v : vertices) {
    Triple low = mesh.points[v], high = low;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] -= distance;
      high[k] += distance;
    }
    boxes.emplace_back(low.data(), high.data(), v);
  }
  const std::size_t too_many = 64 * vertices.size() + 1000;
  std::vector<Pair> pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& s, const Box& t) {
    const Triple d = difference(mesh.points[s.info()], mesh.points[t.info()]);
    const double length = std::hypot(d[0], d[1], d[2]);
    if (!(length <= distance)) return;
    pairs.push_back({length, (std::min)(s.info(), t.info()), (std::max)(s.info(), t.info())});
    if (pairs.size() > too_many)
      throw Error("--merge-distance is too large for this mesh: it would join most of its points");
  });
  std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
    return p.distance != q.distance ? p.distance < q.distance : p.a != q.a ? p.a < q.a : p.b < q.b;
  });
  return pairs;
}

// Sets of vertices, which know the faces at them.
class Clusters
{
public:
  Clusters(const Mesh_data& mesh, const std::vector<Index>& vertices)
    : mesh_(mesh)
    , sets_(mesh.points.size())
    , faces_(vertices.size())
    , place_(mesh.points.size(), none)
  {
    for (std::size_t v = 0; v < mesh.points.size(); ++v) sets_.make_set(v);
    for (std::size_t i = 0; i < vertices.size(); ++i) place_[vertices[i]] = i;
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      for (const Index v : mesh.face(f))
        if (place_[v] != none) faces_[place_[v]].push_back(f);
  }

  void join(Index a, Index b)
  {
    const std::size_t s = sets_.find_set(a), t = sets_.find_set(b);
    if (s == t) return;
    std::vector<std::size_t>*few = &faces_[place_[s]], *many = &faces_[place_[t]];
    if (few->size() > many->size()) std::swap(few, many);
    const auto has_both = [&](std::size_t f) {
      bool has_s = false, has_t = false;
      for (const Index v : mesh_.face(f)) {
        const std::size_t root = sets_.find_set(v);
        has_s = has_s || root == s;
        has_t = has_t || root == t;
      }
      return has_s && has_t;
    };
    if (std::any_of(few->begin(), few->end(), has_both)) return;
    many->insert(many->end(), few->begin(), few->end());
    std::vector<std::size_t> faces = std::move(*many);
    few->clear();
    many->clear();
    sets_.link(s, t);
    faces_[place_[sets_.find_set(s)]] = std::move(faces);
  }

  std::vector<Index> first()
  {
    std::vector<Index> result(mesh_.points.size()), of_root(result.size());
    std::vector<bool> is_known(result.size(), false);
    for (std::size_t v = 0; v < result.size(); ++v) {
      const std::size_t root = sets_.find_set(v);
      if (!is_known[root]) of_root[root] = Index(v);
      is_known[root] = true;
      result[v] = of_root[root];
    }
    return result;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const Mesh_data& mesh_;
  boost::disjoint_sets_with_storage<> sets_;
  std::vector<std::vector<std::size_t>> faces_; // of the candidates, at the roots of the sets
  std::vector<std::size_t> place_;              // of a vertex among the candidates
};

} // namespace

std::vector<Index> first_near(const Mesh_data& mesh, double distance)
{
  const std::vector<Index> vertices = vertices_at_open_edges(mesh);
  const std::vector<Pair> pairs = pairs_within(mesh, vertices, distance);
  if (pairs.empty()) {
    std::vector<Index> first(mesh.points.size());
    std::iota(first.begin(), first.end(), Index(0));
    return first;
  }
  Clusters clusters(mesh, vertices);
  for (const Pair& pair : pairs) clusters.join(pair.a, pair.b);
  return clusters.first();
}

double rounding_of_floats(const std::vector<Triple>& points)
{
  double largest = 0;
  for (const Triple& p : points)
    for (const double x : p) largest = (std::max)(largest, std::abs(x));
  if (!(largest > 0)) return 0;
  const int lowest = std::numeric_limits<float>::min_exponent - 1;
  return std::ldexp(4., (std::max)(std::ilogb(largest), lowest) -
                          (std::numeric_limits<float>::digits - 1));
}

} // namespace pn_subdivide
