// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_SUBDIVISION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_SUBDIVISION_H

#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/limit/read_limit_level.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_subdivision.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_writer.h>
#include <CGAL/PN_subdivision_3/internal/meshes/No_normal_map.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>
#include <CGAL/PN_subdivision_3/limit_points.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The rounds of a call, and then the limits of the vertices that they make. The mesh is touched when all
// limits are known.
template <class Concurrency_tag, class Scheme, class FT>
class Limit_subdivision
{
public:
  Limit_subdivision(const Scheme& scheme, unsigned rounds, const Limit_options& options)
    : scheme_(scheme)
    , options_(options)
    , plain_(scheme, rounds, no_round_done)
    , for_chunks_(For_chunks::with(Concurrency_tag()))
  {}

  template <class Access, class Point_map, class Normal_map>
  Limit_report operator()(Access& access, Point_map points, Normal_map normals) const
  {
    auto control = read_limit_level<Scheme, FT>(access, scheme_, points, normals);
    const unsigned rounds = plain_.number_of_rounds(control.level);
    checked_refined_size<Host>(control.level.size(), rounds, Access::index_limit());
    Refiner refiner(scheme_, std::move(control.level),
                    {control.values.begin(), control.values.end()}, for_chunks_);
    for (unsigned k = 1; k < rounds; ++k) refiner.refine();
    const One_round last = refiner.next_round();
    const Level refined = refined_level(refiner, last);
    refiner.release_values();
    const Limit_demand demand = limit_demand<FT>(options_, box_size(refined));
    Limit_evaluation<Scheme, FT> evaluation(scheme_, demand, for_chunks_);
    const auto limits = evaluation(refined, rounds + 1);
    check_limits<FT>(limits, [](std::size_t v) { return "vertex number " + std::to_string(v); });
    // with a linear scheme normals are written as surface normals only
    if (is_pn_v<Scheme> || options_.surface_normals)
      put(refiner, last, access, points, normals, limits);
    else
      put(refiner, last, access, points, No_normal_map(), limits);
    return limit_report(limits, demand);
  }

private:
  using Index = Level_connectivity::Index;
  using Host = typename Scheme::Host;
  using Average = Average_of_scheme<Scheme, FT>;
  using Refiner = Level_refiner<Scheme, Average>;
  using One_round = typename Refiner::One_round;
  using Level = Valued_level<typename Average::Value>;
  using Plain = Mesh_subdivision<Concurrency_tag, Scheme, FT>;

  Level refined_level(const Refiner& refiner, const One_round& last) const
  {
    Level refined;
    refined.level = Level_connectivity(last.refined_size());
    refined.level.set_uniform_degree(Host::refined_degree);
    refiner.connect(last, refined.level);
    const auto values = refiner.refined_values(last, last.refined_size().vertices);
    refined.values.assign(values.begin(), values.end());
    return refined;
  }

  template <class Access, class Point_map, class Normal_map, class Limits>
  void put(const Refiner& refiner, const One_round& last, Access& access, Point_map points,
           Normal_map normals, const Limits& limits) const
  {
    using Value = Point_normal<FT, 3>;
    Mesh_writer<Value, Access, Point_map, Normal_map> writer(access, points, normals, false);
    access.grow(last.refined_size());
    const auto put_range = [&](Index begin, Index end) {
      for (Index v = begin; v < end; ++v) {
        const Value value{point_of(limits[v].value),
                          limit_normal<Scheme>(limits[v], options_.surface_normals)};
        writer.put_values(v, &value, 1);
      }
    };
    const auto n = static_cast<Index>(limits.size());
    const Index old_vertices = (std::min)(n, writer.number_of_old_vertices());
    put_range(old_vertices, n);
    writer.begin_old_vertices();
    put_range(0, old_vertices);
    plain_.put_connectivity(refiner, last, access, [&] { writer.keep(); });
  }

  const Scheme& scheme_;
  const Limit_options& options_;
  const Plain plain_;
  For_chunks for_chunks_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_SUBDIVISION_H
