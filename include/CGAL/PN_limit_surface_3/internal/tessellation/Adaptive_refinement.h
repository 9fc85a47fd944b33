// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_ADAPTIVE_REFINEMENT_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_ADAPTIVE_REFINEMENT_H

#include <CGAL/PN_limit_surface_3/internal/limit/Creased_limits.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_limit_surface_3/internal/limit/Sub_level.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Adaptive_level.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Face_selection.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Split_edges.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Tessellation_attributes.h>
#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/concepts/scheme_traits.h>
#include <CGAL/PN_subdivision_3/internal/creases/Creases.h>
#include <CGAL/PN_subdivision_3/internal/hosts/Edge_split.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_refiner.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Round.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// Refines, level by level, the faces that are not flat enough, with the rings of faces that they need. Every vertex gets
// its limit when it is new, so that the vertices of the result are the whole cost. Faces of the control mesh and children
// of its polygons get a round before it is known whether they have to be split, so that something has been seen of every
// face.
template <class Scheme, class FT, class Level_creases, bool carries_attributes>
class Adaptive_refinement
{
public:
  using Index = Level_connectivity::Index;
  // attributes share what there is of all limits, as libraries do
  static constexpr Limit_kinds kinds = carries_attributes ? Limit_kinds::all : Limit_kinds::normals;
  using Average = Average_of_scheme<Scheme, FT>;
  using Value = typename Average::Value;
  using Level = Adaptive_level<Value, Level_creases>;
  using Result = Limit_result<Average>;
  using Attributes =
    Carried<carries_attributes, Tessellation_attributes<Scheme, FT, Level_creases>>;
  using Selection = Face_selection<typename Scheme::Host, FT, Value, Level_creases>;

  Adaptive_refinement(const Scheme& scheme, const Tessellation_demand& demand,
                      const For_chunks& for_chunks,
                      Face_bounds<Value, Level_creases>* bounds = nullptr)
    : scheme_(scheme)
    , for_chunks_(for_chunks)
    , selection_(demand, for_chunks, bounds, all_)
    , limits_(scheme, selection_.demand().limits, for_chunks)
    , attributes_(scheme, selection_.demand().limits, for_chunks)
  {
    all_.set_exponent(demand.exponent);
  }

  // before: the nodes of an earlier refinement of the same mesh; some of these nodes have to be split now
  void operator()(Valued_level<Value>&& control, Level_creases&& creases,
                  std::deque<Tessellation_node>&& before,
                  [[maybe_unused]] const Carried<carries_attributes, Tessellation_data>& attributes)
  {
    selection_.begin(std::move(before));
    Level level{std::move(control), std::move(creases), {}, {}, {}};
    if constexpr (carries_attributes) attributes_.read(attributes, level);
    begin(level);
    for (bool is_done = false; !is_done;) is_done = !refine(level);
    selection_.end();
  }

  Selection& selection() { return selection_; }
  Split_edges<FT>& all() { return all_; }
  const Split_edges<FT>& all() const { return all_; }
  // vertices that are not used go
  void remove_unused(const std::vector<bool>& used)
  {
    if constexpr (carries_attributes) attributes_.keep_vertices(used);
    all_.keep_vertices(used);
  }
  const Attributes& attributes() const { return attributes_; }
  unsigned depth() const { return rounds_; }

private:
  using Host = typename Scheme::Host;
  using Refiner = Level_refiner<Scheme, Average, Level_creases>;
  static constexpr bool is_creased = are_creases_v<Level_creases>;
  using Results = std::vector<Result>;
  using Flatness = typename Selection::Flatness;
  using Slots = Slots_of_corners<Level_creases>;
  static constexpr Index null = Level_connectivity::null;

  // \name Limits
  // limits at all slots, or at those of some vertices
  Results limits(Level& level, const std::vector<Index>* some)
  {
    // a copy, since its tangents become those of the limit, with which no round goes on
    Level_creases creases = level.creases;
    return limits_(level.level, creases, rounds_ + 1, some);
  }

  // sets the limits at the slots that are new
  void set_limits(const Level& level, const Results& results, Index first_new)
  {
    for (std::size_t s = 0; s < results.size(); ++s)
      if (level.slot_ids[s] != null && level.slot_ids[s] >= first_new)
        set_slot(level.slot_ids[s], results[s]);
  }

  // is_smooth: whether the surface has a tangent plane wherever it has a normal
  void set_slot(Index slot, const Result& result, bool is_smooth = true)
  {
    auto& s = all_.slot(slot);
    const auto& point = point_of(result.value);
    check_in_range<FT, 3>(
      point, [&] { return "the limit point of vertex number " + std::to_string(s.vertex); });
    all_.set_point(s.vertex, point);
    s.has_surface_normal = result.has_surface_normal && is_smooth;
    if constexpr (is_pn_v<Scheme>) s.normal = to_double_3(result.value.normal);
    if (result.has_surface_normal) s.normal = result.surface_normal;
    s.is_trusted = is_smooth;
  }

  // \name Levels
  void begin(Level& level)
  {
    const Level_connectivity& connectivity = level.level.level;
    const Results results = limits(level, nullptr);
    for (Index v = 0; v < connectivity.number_of_vertices(); ++v)
      level.slot_ids.push_back(all_.add_slot(all_.add_vertex()));
    for (const Index v : vertices_of_extra_slots(level.creases, connectivity.number_of_vertices()))
      level.slot_ids.push_back(all_.add_slot(v));
    const std::vector<unsigned> faces = faces_of_slots(level);
    for (Index s = 0; s < level.slot_ids.size(); ++s) set_slot(s, results[s], faces[s] != 1);
    for (Index e = 0; e < connectivity.number_of_edges(); ++e)
      level.edges.push_back(all_.add_edge());
    level.faces.resize(connectivity.number_of_faces());
    for (Index f = 0; f < level.faces.size(); ++f) {
      level.faces[f].origin = f;
      level.faces[f].is_wanted = true;
    }
    if constexpr (carries_attributes) {
      const std::vector<Results> of_planes = attributes_.limits(level, rounds_, nullptr);
      for (Index v = 0; v < connectivity.number_of_vertices(); ++v)
        attributes_.set(v, of_planes, v);
    }
  }

  // A single face between two edges of a smooth curve has no angle that a tangent plane could tell. Where the edges do not
  // remain sharp, there are others.
  static std::vector<unsigned> faces_of_slots(const Level& level)
  {
    const Level_connectivity& connectivity = level.level.level;
    const Slots slot_of(connectivity, level.creases);
    std::vector<unsigned> faces(level.slot_ids.size(), 0);
    for (Index h = 0; h < connectivity.number_of_halfedges(); ++h)
      if (!connectivity.is_border(h)) ++faces[slot_of(h)];
    if constexpr (is_creased)
      for (const auto& star : level.creases.stars)
        for (Index i = 0; i < star.number_of_ends; ++i)
          if (!std::isinf(level.creases.edge(level.creases.end(star, i)).sharpness))
            for (Index w = 0; w < star.number_of_wedges; ++w) faces[star.slot(w)] = 0;
    return faces;
  }

  // makes one round; false if there is nothing to refine
  bool refine(Level& level)
  {
    const bool is_control = rounds_ == 0;
    const bool has_unseen = Selection::mark_unseen(level);
    if (!selection_.select(level, false, rounds_) && !has_unseen) return false;
    if (!is_control && rounds_ + 1 >= facts_of(scheme_).first_round &&
        !is_anything_ending(level.creases))
      cut(level);
    Level next = refined(level);
    ++rounds_;
    Results results;
    if (has_unseen) {
      const std::vector<Index> vertices = new_vertices(level);
      results = limits(next, is_control ? nullptr : &vertices);
      measure(level, [&](Index, Index v) { return all_.place(point_of(results[v].value)); });
      selection_.select(level, true, rounds_ - 1);
      if (std::none_of(level.faces.begin(), level.faces.end(),
                       [](const Adaptive_face& f) { return f.is_split; })) {
        --rounds_;
        return false;
      }
    }
    const std::vector<Index> vertices = new_vertices(level);
    std::vector<Results> of_planes;
    if constexpr (carries_attributes)
      of_planes = attributes_.limits(next, rounds_, is_control ? nullptr : &vertices);
    all_.reserve(vertices.size(), next.level.level.number_of_edges());
    const Index first_new = all_.number_of_slots();
    connect(level, next, of_planes);
    if (has_unseen)
      set_limits(next, results, first_new);
    else {
      set_limits(next, limits(next, &vertices), first_new);
      measure(level, [&](Index h, Index v) {
        const Index slot =
          h == null ? next.slot_ids[v] : all_.edge(level.edges[h / 2]).middle[h % 2];
        return all_.place_of(all_.slot(slot).vertex);
      });
    }
    hand_down(level, next);
    level = std::move(next);
    return true;
  }

  void cut(Level& level) const
  {
    Face_marks marks;
    marks.reserve(level.faces.size());
    for (const Adaptive_face& face : level.faces) marks.push_back(face.is_split ? 1 : 0);
    // what a round needs to come out right in the rings that the next one needs, and the limits of the new vertices
    unsigned rings =
      facts_of(scheme_).limit_neighborhood.regular_rings == 0 ? facts_of(scheme_).ghost_rings : 0;
    if (rings == 0) rings = cut_rings(scheme_);
    cut_adaptive_level(level, std::move(marks), rings + (reads_wedges(level.creases) ? 1 : 0));
  }

  // whether a vertex may need all wedges of its neighbors, which then must not lack faces
  bool reads_wedges([[maybe_unused]] const Level_creases& creases) const
  {
    if constexpr (is_creased) {
      if constexpr (is_pn_v<Scheme>)
        if (!average_of<Average>(scheme_).roundness) return !creases.stars.empty();
      return std::any_of(creases.stars.begin(), creases.stars.end(), [&](const Crease_star& star) {
        return creases.rule(star) == Vertex_rule::dart;
      });
    } else
      return false;
  }

  Level refined(Level& level) const
  {
    const Value* const values = level.level.values.data();
    typename Refiner::Level_round round(scheme_, level.level.level, level.creases, values,
                                        rounds_ + 1);
    Level next{{}, Level_creases(), {}, {}, {}};
    next.level.values.resize(round.refined_creases().number_of_slots);
    evaluate_round(round, values, for_chunks_, next.level.values);
    next.level.level = child_level(round, round.refined_creases(), for_chunks_);
    next.creases = std::move(round.refined_creases());
    if constexpr (carries_attributes) attributes_.refine(level, rounds_, next);
    return next;
  }

  // the new vertices on the faces that are split
  std::vector<Index> new_vertices(const Level& level) const
  {
    const Level_connectivity& old = level.level.level;
    const Host host(old, rounds_);
    std::vector<char> is_on_face(old.number_of_edges(), 0);
    std::vector<Index> vertices, of_faces;
    for (Index f = 0; f < old.number_of_faces(); ++f) {
      if (!level.faces[f].is_split) continue;
      for_each_halfedge_of_face(old, f,
                                [&](Index h) { is_on_face[Level_connectivity::edge(h)] = 1; });
      if constexpr (has_face_vertices) of_faces.push_back(host.vertex_of_face(f));
    }
    for (Index e = 0; e < is_on_face.size(); ++e)
      if (is_on_face[e] != 0) vertices.push_back(host.vertex_of_edge(e));
    vertices.insert(vertices.end(), of_faces.begin(), of_faces.end());
    return vertices;
  }

  // \name What the new limit points tell of the faces
  // place(half-edge, vertex of the next level) is the place of the limit, without a half-edge of a face
  template <class Place>
  void measure(Level& level, const Place& place) const
  {
    const Level_connectivity& old = level.level.level;
    const Host host(old, rounds_);
    const Flatness flatness(level, all_);
    for_chunks_(old.number_of_faces(), [&](Index begin, Index end) {
      for (Index f = begin; f < end; ++f) {
        Adaptive_face& face = level.faces[f];
        if (!face.is_split || !Selection::is_leaf(level, f)) continue;
        typename Flatness::Middles middles;
        flatness.for_each_edge(f, [&](std::size_t i, Index h) {
          middles.of_edges[i] = place(h, host.vertex_of_edge(Level_connectivity::edge(h)));
        });
        if constexpr (has_face_vertices) {
          middles.has_face = true;
          middles.of_face = place(null, host.vertex_of_face(f));
        }
        const auto measure = flatness.measure(f, middles);
        face.measured = measure.distance;
        face.discrepancy = measure.discrepancy;
        if (face.seen == Adaptive_face::Seen::none) face.seen = Adaptive_face::Seen::of_itself;
      }
    });
  }

  // \name From a level to the next one
  void connect(const Level& level, Level& next, const std::vector<Results>& of_planes)
  {
    const Level_connectivity& old = level.level.level;
    const Host host(old, rounds_);
    next.slot_ids.assign(next.level.values.size(), null);
    {
      const Slots old_slots(old, level.creases), new_slots(next.level.level, next.creases);
      for (Index f = 0; f < old.number_of_faces(); ++f)
        if (level.faces[f].is_split)
          split_face(level, f, host, old_slots, new_slots, of_planes, next);
    }
    next.edges.assign(next.level.level.number_of_edges(), null);
    for (Index e = 0; e < next.edges.size(); ++e) {
      const Element_parent parent = host.parent_of_edge(e);
      if (parent.kind != Element_parent::Kind::edge) continue;
      const Index old_edge = level.edges[parent.index];
      if (old_edge != null && all_.edge(old_edge).is_split())
        next.edges[e] = all_.edge(old_edge).halves + parent.ordinal;
    }
  }

  // hands what is known of the faces down to their children
  void hand_down(const Level& level, Level& next)
  {
    const Host host(level.level.level, rounds_);
    for (const Adaptive_face& face : level.faces)
      if (face.is_split) selection_.nodes()[face.node].leaf.error = face.discrepancy;
    next.faces.resize(next.level.level.number_of_faces());
    for (Index f = 0; f < next.faces.size(); ++f) {
      const Adaptive_face& parent = level.faces[host.parent_of_face(f).index];
      if (!parent.is_split) continue;
      next.faces[f] = parent;
      next.faces[f].is_split = false;
      next.faces[f].seen = parent.seen == Adaptive_face::Seen::none
                             ? Adaptive_face::Seen::none
                             : Adaptive_face::Seen::of_parent;
      for_each_halfedge_of_face(next.level.level, f, [&](Index h) {
        Index& e = next.edges[Level_connectivity::edge(h)];
        if (e == null) e = all_.add_edge();
      });
    }
    if constexpr (carries_attributes)
      if (!level.corners.empty()) attributes_.split_corners(level, host, next);
  }

  void split_face(const Level& level, Index f, [[maybe_unused]] const Host& host,
                  const Slots& old_slots, const Slots& new_slots,
                  [[maybe_unused]] const std::vector<Results>& of_planes, Level& next)
  {
    const Level_connectivity& old = level.level.level;
    const Edge_split split(old);
    const auto add_slot = [&](Index new_slot, Index vertex) {
      Index& slot = next.slot_ids[new_slot];
      if (slot != null) return slot;
      slot = all_.add_slot(vertex);
      if constexpr (carries_attributes) attributes_.set(vertex, of_planes, new_slot);
      return slot;
    };
    for_each_halfedge_of_face(old, f, [&](Index h) {
      next.slot_ids[new_slots(split.second_half(h))] = level.slot_ids[old_slots(h)];
      const Index e = Level_connectivity::edge(h), edge = level.edges[e];
      if (!all_.edge(edge).is_split()) {
        const Index vertex = all_.add_vertex();
        std::array<Index, 2> middle{null, null};
        for (const Index side : {0u, 1u})
          if (!old.is_border(2 * e + side))
            middle[side] = add_slot(new_slots(split.first_half(2 * e + side)), vertex);
        all_.split(edge, middle);
      }
    });
    if constexpr (has_face_vertices) add_slot(host.vertex_of_face(f), all_.add_vertex());
  }

  static constexpr bool has_face_vertices = std::is_same_v<Host, PQQ_host>;

  const Scheme& scheme_;
  For_chunks for_chunks_;
  Split_edges<FT> all_;
  Selection selection_;
  Limits_of_level<Scheme, FT, Level_creases, kinds> limits_;
  Attributes attributes_;
  unsigned rounds_ = 0;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_ADAPTIVE_REFINEMENT_H
