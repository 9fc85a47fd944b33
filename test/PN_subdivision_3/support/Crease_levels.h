// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control meshes with creases, and rounds of the package on levels of them.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_CREASE_LEVELS_H
#define CGAL_PN_SUBDIVISION_3_TEST_CREASE_LEVELS_H

#include <CGAL/PN_subdivision_3/internal/creases/Wedge_estimation.h>
#include <CGAL/PN_subdivision_3/internal/creases/make_creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/check_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace crease_levels {

using namespace CGAL::PN_subdivision_3;

using Index = Level_connectivity::Index;
using Triple = std::array<double, 3>;
using Face = std::vector<int>;
using Edge = std::pair<int, int>;

inline Edge undirected(int a, int b)
{
  return {(std::min)(a, b), (std::max)(a, b)};
}

struct Control
{
  std::vector<Triple> points;
  std::vector<Face> faces;
  std::map<std::pair<int, int>, Triple> normals; // of (face, vertex); none: estimated
  std::map<Edge, double> sharp_edges;            // undirected
  std::map<int, double> sharp_vertices;
  Border border = Border::surface;
  bool has_zero_tangents = false; // none are made
};

// the control mesh with all polygons split from their first corner
inline Control triangulated(const Control& control)
{
  Control result = control;
  result.faces.clear();
  result.normals.clear();
  for (std::size_t f = 0; f < control.faces.size(); ++f) {
    const Face& face = control.faces[f];
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Face t{face[0], face[i], face[i + 1]};
      for (const int v : t)
        if (!control.normals.empty())
          result.normals[{int(result.faces.size()), v}] = control.normals.at({int(f), v});
      result.faces.push_back(t);
    }
  }
  return result;
}

struct Names : internal::Element_names
{
  std::string vertex_name(Index v) const override { return "vertex " + std::to_string(v); }
  std::string halfedge_name(Index h) const override { return "half-edge " + std::to_string(h); }
  std::string face_name(Index f) const override { return "face " + std::to_string(f); }
};

// edges in the order in which the faces have them first
inline Level_connectivity level_of(const Control& control)
{
  std::map<Edge, Index> halfedge;
  Index edges = 0;
  for (const Face& face : control.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int a = face[i], b = face[(i + 1) % face.size()];
      if (halfedge.count({a, b}) != 0) continue;
      halfedge[{a, b}] = 2 * edges;
      halfedge[{b, a}] = 2 * edges + 1;
      ++edges;
    }
  Level_size size;
  size.vertices = control.points.size();
  size.edges = edges;
  size.faces = control.faces.size();
  Level_connectivity level(size);
  for (Index v = 0; v < size.vertices; ++v) level.set_isolated(v);
  for (const auto& [ends, h] : halfedge) {
    level.set_target(h, Index(ends.second));
    level.set_border(h);
  }
  for (Index f = 0; f < control.faces.size(); ++f) {
    const Face& face = control.faces[f];
    const std::size_t m = face.size();
    for (std::size_t i = 0; i < m; ++i) {
      const Index h = halfedge.at({face[i], face[(i + 1) % m]});
      level.set_next(h, halfedge.at({face[(i + 1) % m], face[(i + 2) % m]}));
      level.set_face(h, f);
      level.set_halfedge_of_vertex(level.target(h), h);
      level.set_halfedge_of_face(f, h);
    }
  }
  std::map<Index, Index> along_border;
  for (Index h = 0; h < 2 * edges; ++h)
    if (level.face(h) == Level_connectivity::null) along_border[level.source(h)] = h;
  for (const auto& entry : along_border)
    level.set_next(entry.second, along_border.at(level.target(entry.second)));
  const Names names{};
  internal::Connectivity_check(level, names)();
  return level;
}

// Rounds of a scheme, in which the roundness varies if it has normals.
template <class FT, class Scheme_, class Concurrency_tag = CGAL::Sequential_tag>
class Crease_run
{
public:
  static constexpr bool is_pn = !internal::Is_linear<Scheme_>::value;
  using Scheme = std::conditional_t<is_pn, internal::With_roundness<Scheme_, FT>, Scheme_>;
  using Average = internal::Average_of_scheme<Scheme, FT>;
  using Refiner = internal::Level_refiner<Scheme, Average, internal::Creases<FT>>;
  using Vector = Coordinates<FT, 3>;

  Crease_run(const Control& control, const Scheme_& scheme)
    : scheme_(std::make_shared<const Scheme>(with_roundness(scheme)))
    , refiner_(make(control, *scheme_))
  {}
  Crease_run(const Crease_run&) = delete;
  Crease_run& operator=(const Crease_run&) = delete;

  void refine(int rounds = 1)
  {
    for (int k = 0; k < rounds; ++k) refiner_.refine();
  }

  const Level_connectivity& level() const { return refiner_.level(); }
  const internal::Creases<FT>& creases() const { return refiner_.creases(); }
  Index number_of_slots() const { return creases().number_of_slots; }
  Vector point(Index slot) const
  {
    const typename Average::Value value = refiner_.values()[slot];
    if constexpr (is_pn)
      return value.point;
    else
      return value;
  }
  Vector normal(Index slot) const
  {
    if constexpr (is_pn) {
      const typename Average::Value value = refiner_.values()[slot];
      return value.normal;
    } else
      return {FT(0), FT(0), FT(0)};
  }

  // 1 where it does not vary
  FT roundness(Index slot) const
  {
    if constexpr (is_pn) {
      const typename Average::Value value = refiner_.values()[slot];
      return value.roundness;
    } else
      return FT(1);
  }

  // calls f(face, vertex, slot) for every corner
  template <class Function>
  void for_each_corner(const Function& f) const
  {
    const internal::Cut_copy<FT> cut(level(), creases());
    for_each_corner(level(), cut.connectivity(), f);
  }

private:
  template <class Function>
  static void for_each_corner(const Level_connectivity& level, const Level_connectivity& cut,
                              const Function& f)
  {
    for (Index face = 0; face < level.number_of_faces(); ++face) {
      const Index first = level.halfedge_of_face(face);
      Index h = first, g = cut.halfedge_of_face(face);
      do {
        f(face, level.target(h), cut.target(g));
        h = level.next(h);
        g = cut.next(g);
      } while (h != first);
    }
  }

  static Scheme with_roundness(const Scheme_& scheme)
  {
    if constexpr (is_pn)
      return {{scheme}, nullptr};
    else
      return scheme;
  }

  static Refiner make(const Control& control, const Scheme& scheme)
  {
    Level_connectivity level = level_of(control);
    const auto value = [](const auto& map, const auto& key) {
      const auto it = map.find(key);
      return it == map.end() ? 0. : it->second;
    };
    auto creases = internal::Make_creases<FT>(level, control.border)(
      [&](Index e) {
        return value(control.sharp_edges,
                     undirected(int(level.source(2 * e)), int(level.target(2 * e))));
      },
      [&](Index v) { return value(control.sharp_vertices, int(v)); });
    if (is_pn && control.normals.empty())
      internal::keep_without_fractions<FT>(level, creases, [&](internal::Creases<FT>& others) {
        return values_of_slots(control, level, others);
      });
    const auto values = values_of_slots(control, level, creases);
    typename Refiner::Values stored;
    for (const auto& v : values)
      if constexpr (is_pn)
        stored.push_back(v);
      else
        stored.push_back(v.point);
    return Refiner(scheme, std::move(level), std::move(creases), std::move(stored),
                   internal::For_chunks::with(Concurrency_tag()));
  }

  static auto values_of_slots(const Control& control, const Level_connectivity& level,
                              internal::Creases<FT>& creases)
  {
    const Index n = level.number_of_vertices();
    std::vector<Point_normal<FT, 3>> values(creases.number_of_slots);
    const std::vector<Index> extra = internal::vertices_of_extra_slots(creases, n);
    for (Index slot = 0; slot < values.size(); ++slot) {
      const Triple& p = control.points[slot < n ? slot : extra[slot - n]];
      values[slot] = {{FT(p[0]), FT(p[1]), FT(p[2])}, {FT(0), FT(0), FT(0)}};
    }
    if (is_pn) {
      std::vector<bool> is_given(values.size(), !control.normals.empty());
      if (!control.normals.empty()) {
        const internal::Cut_copy<FT> cut(level, creases);
        for_each_corner(level, cut.connectivity(), [&](Index f, Index v, Index slot) {
          const Triple& m = control.normals.at({int(f), int(v)});
          values[slot].normal = {FT(m[0]), FT(m[1]), FT(m[2])};
        });
      }
      internal::estimate_wedges<FT>(level, creases, values, is_given,
                                    Control_normal_estimate::coherent);
      if (control.has_zero_tangents)
        for (auto& e : creases.edges) e.tangent_from.fill({FT(0), FT(0), FT(0)});
    }
    return values;
  }

  std::shared_ptr<const Scheme> scheme_;
  Refiner refiner_;
};

} // namespace crease_levels

#endif // CGAL_PN_SUBDIVISION_3_TEST_CREASE_LEVELS_H
