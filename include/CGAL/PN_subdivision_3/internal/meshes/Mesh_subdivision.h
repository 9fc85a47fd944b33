// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_SUBDIVISION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_SUBDIVISION_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/hosts/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Carried_through.h>
#include <CGAL/PN_subdivision_3/internal/average/checked_coordinates.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_writer.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Caller_precision.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Function_ref.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/refinement/for_chunks.h>
#include <CGAL/PN_subdivision_3/schemes/normal_estimate.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_adaptors.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// the size after some rounds
template <class Host>
Level_size checked_refined_size(Level_size size, unsigned rounds, std::uint64_t limit)
{
  for (unsigned k = 1; k <= rounds; ++k) {
    size = Host::refined_size(size, k);
    if (size.halfedges() < limit && size.vertices < limit && size.faces < limit) continue;
    throw std::length_error(
      "PN_subdivision_3: round " + std::to_string(k) + " would need " +
      std::to_string(size.vertices) + " vertices, " + std::to_string(size.halfedges()) +
      " half-edges and " + std::to_string(size.faces) + " faces, more than the " +
      std::to_string(limit - 1) + " that the index type of the mesh can number: ask for at most " +
      std::to_string(k - 1) + " rounds");
  }
  return size;
}

// of calls that tell nobody of their rounds
inline constexpr auto no_round_done = [](unsigned, std::size_t) {};

// Subdivision of a mesh: read, refine flat levels, write the last one. The mesh and its maps are
// untouched until everything that a user's data can make fail has been checked; what fails
// afterwards (an allocation, a map of the user's) is taken back.
template <class Concurrency_tag, class Scheme, class FT>
class Mesh_subdivision
{
  static constexpr bool is_pn = !Is_linear<Scheme>::value;

  using Index = Level_connectivity::Index;
  using Average = std::conditional_t<is_pn, PN_average<FT, 3>, Linear_average<FT, 3>>;
  using Value = typename Average::Value;
  using Refiner = Level_refiner<Scheme, Average>;
  using One_round = typename Refiner::One_round;
  using Transfers = typename Refiner::Transfers;
  using Rows_sink = typename Refiner::Rows_sink;

public:
  using Round_done = Function_ref<void(unsigned, std::size_t)>;

  // round_done has to live as long
  template <class Function>
  Mesh_subdivision(const Scheme& scheme, unsigned rounds, const Function& round_done)
    : scheme_(scheme)
    , rounds_(rounds)
    , round_done_(round_done)
    , for_chunks_(For_chunks::with(Concurrency_tag()))
  {}
  template <class Function>
  Mesh_subdivision(const Scheme&, unsigned, const Function&&) = delete;

  // a linear scheme has no use for normals
  template <class Access, class Point_map, class Normal_map, class Carry>
  void operator()(Access& access, Point_map points, Normal_map normals, const Carry& carry) const
  {
    if constexpr (is_pn)
      subdivide(access, points, normals, carry);
    else
      subdivide(access, points, No_normal_map(), carry);
  }

  // \name Steps of a call
  // shared with Creased_subdivision

  // without faces all rounds are alike
  unsigned number_of_rounds(const Level_connectivity& level) const
  {
    return level.size().faces == 0 ? 1 : rounds_;
  }

  // Whether a mesh gets edges and faces in one thread while others put the values of the last round: the
  // maps of a Surface_mesh stand where they are when other elements than theirs come.
  template <class Writer>
  static constexpr bool has_late_growth_v = is_parallel_v<Concurrency_tag>&& Writer::has_own_maps;

  // With several threads the mesh grows while the levels before the last one are made.
  template <class Writer, class Access, class Any_refiner, class Refine>
  void grow_and_refine(Access& access, const Level_size& size, const Any_refiner& refiner,
                       unsigned rounds, const Refine& refine) const
  {
    const auto grow = [&] {
      if constexpr (is_parallel_v<Concurrency_tag> && !has_late_growth_v<Writer>)
        access.grow(size);
      else
        access.grow_vertices(size);
    };
    run_with_precision(grow, [&] {
      for (unsigned k = 1; k < rounds; ++k) {
        refine();
        round_done_(k, static_cast<std::size_t>(refiner.level().size().faces));
      }
    });
  }

  // The last values, put by put(), and what the mesh has not yet of edges and faces; with one thread
  // these come when the old values are gone.
  template <class Writer, class Access, class Any_refiner, class Put>
  static void put_and_grow(Access& access, const Level_size& size, Any_refiner& refiner,
                           const Put& put)
  {
    if constexpr (has_late_growth_v<Writer>)
      run_with_precision([&] { access.grow(size); }, put);
    else
      put();
    refiner.release_values();
    access.grow(size);
  }

  // of the last round, and of those that change nothing
  void report_last_round(unsigned rounds, const Level_size& size) const
  {
    round_done_(rounds, static_cast<std::size_t>(size.faces));
    for (unsigned k = rounds; k < rounds_;) round_done_(++k, 0);
  }

  template <class Writer>
  static void put_values(const Refiner& refiner, const One_round& last, Writer& writer,
                         const Rows_sink* rows = nullptr)
  {
    const auto new_vertices = static_cast<Index>(last.refined_size().vertices);
    const Index old_vertices = (std::min)(new_vertices, writer.number_of_old_vertices());
    const Transfers transfers = refiner.transfers(last);
    put_range(refiner, last, transfers, old_vertices, new_vertices, writer, rows);
    writer.begin_old_vertices();
    put_range(refiner, last, transfers, 0, old_vertices, writer, rows);
  }

  template <class Writer>
  static void put_range(const Refiner& refiner, const One_round& last, const Transfers& transfers,
                        Index begin, Index end, const Writer& writer, const Rows_sink* rows)
  {
    if constexpr (Writer::has_own_maps || !is_parallel_v<Concurrency_tag>)
      refiner.evaluate(
        last, transfers, begin, end,
        [&](Index first, const Value* values, Index n) { writer.put_values(first, values, n); },
        rows);
    else {
      boost::container::vector<Value> refined(end - begin, boost::container::default_init);
      refiner.evaluate(
        last, transfers, begin, end,
        [&](Index first, const Value* values, Index n) {
          std::copy(values, values + n, refined.begin() + (first - begin));
        },
        rows);
      writer.put_values(begin, refined.data(), end - begin);
    }
  }

  // keep() is called where nothing may fail any more. Threads may; then one alone repeats what they
  // have begun.
  template <class Access>
  void put_connectivity(const Refiner& refiner, const One_round& last, Access& access,
                        Function_ref<void()> keep) const
  {
    std::optional<Level_connectivity> child;
    if constexpr (!Access::is_child_of_hosts) {
      child.emplace(last.refined_size());
      refiner.connect(last, *child);
    }
    keep();
    const auto write = [&](const For_chunks& for_chunks) {
      if constexpr (Access::is_child_of_hosts)
        last.host().connect(access, for_chunks);
      else
        access.write(*child, for_chunks);
    };
    try {
      write(Access::has_concurrent_connectivity ? for_chunks_ : For_chunks());
    } catch (...) {
      write(For_chunks());
    }
  }

private:
  // f() and g(), which computes in the caller's precision
  template <class Function, class Computation>
  static void run_with_precision(const Function& f, const Computation& g)
  {
    const Caller_precision<FT> precision;
    run_together<Concurrency_tag>([&] { f(); },
                                  [&] {
                                    const typename Caller_precision<FT>::In_this_thread scope(
                                      precision);
                                    g();
                                  });
  }

  template <class Access, class Point_map, class Normal_map, class Carry>
  void subdivide(Access& access, Point_map points, Normal_map normals, const Carry& carry) const
  {
    Level_connectivity level = checked_level(access);
    check_scheme<Scheme, Element_names>(scheme_, level, access);
    const unsigned rounds = number_of_rounds(level);
    const Level_size size =
      checked_refined_size<typename Scheme::Host>(level.size(), rounds, Access::index_limit());
    auto values = read_values<Average>(access, level, points, normals, normal_estimate(scheme_));
    using Writer = Mesh_writer<Value, Access, Point_map, Normal_map>;
    Writer writer(access, points, normals, is_any_near_overflow(values));
    Carried_through<FT, typename Scheme::Host, Carry> carried(
      carry, access, level, std::vector<Index>(), Control_sharpness(), for_chunks_);
    Refiner refiner(scheme_, std::move(level), {values.begin(), values.end()}, for_chunks_);
    std::vector<Value>().swap(values);

    grow_and_refine<Writer>(access, size, refiner, rounds, [&] {
      const One_round round = refiner.next_round();
      carried.begin_round(scheme_, round, refiner.level(), false);
      refiner.refine(round, carried.rows(), carried.child());
      carried.end_round();
    });
    const One_round last = refiner.next_round();
    carried.begin_round(scheme_, last, refiner.level(), true);
    put_and_grow<Writer>(access, size, refiner,
                         [&] { put_values(refiner, last, writer, carried.rows()); });
    carried.put(refiner, last);
    report_last_round(rounds, size);
    put_connectivity(refiner, last, access, [&] {
      writer.keep();
      carried.keep();
    });
    carried.visit(access, refiner, last);
    if constexpr (!Scheme::Host::keeps_vertices) access.trim(size, writer.has_own_maps);
  }

  static bool is_any_near_overflow(const std::vector<Value>& values)
  {
    return std::any_of(values.begin(), values.end(),
                       [](const Value& v) { return is_near_overflow(point_of(v)); });
  }

  const Scheme& scheme_;
  unsigned rounds_;
  Round_done round_done_;
  For_chunks for_chunks_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_MESH_SUBDIVISION_H
