// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_PIECES_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_PIECES_H

#include <CGAL/PN_limit_surface_3/internal/limit/Settled_neighborhood.h>
#include <CGAL/PN_limit_surface_3/internal/limit_surface/In_double.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Piece_numbers.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Tessellation.h>
#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/creases/Smooth_rows.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Divided_level.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Level_part.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_candidates.h>
#include <CGAL/PN_subdivision_3/internal/refinement/Piece_extraction.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The triangles of the faces that a piece owns, with their vertices.
template <class FT>
struct Tessellated_piece
{
  Level_connectivity level;
  Numbered_elements vertices, faces;
  std::vector<Coordinates<FT, 3>> points;
  std::vector<flatness::Vector> normals;
  Attribute_table attributes; // if there are any
  double bound = 0;           // as Tessellation_result has these
  std::size_t worst_face = 0;
  std::array<double, 3> worst_place{};
  bool reached = true;
  Tessellation_result::Obstacle obstacle = Tessellation_result::Obstacle::none;
  unsigned depth = 0;
};

// A tessellation whose pieces are made one after the other, without its scheme. The decision whether a face is split goes
// by what is near it, so that the triangles are those of the whole, but for their order.
template <class FT>
class Kept_tessellation
{
public:
  using Piece = Tessellated_piece<FT>;
  // The normal of a vertex with several wedges, from theirs, in the order of the triangles of the whole.
  using Normal_of_wedges = std::function<flatness::Vector(const std::vector<flatness::Vector>&)>;

  virtual ~Kept_tessellation() = default;
  // about how many triangles there will be on each control face
  virtual std::vector<double> expected_triangles() const = 0;
  // into so many pieces, of about equal weights; returns the weight of each piece
  virtual std::vector<double> divide(std::size_t number, const std::vector<double>& weights) = 0;
  virtual bool is_empty(std::size_t i) const = 0;
  // The next one: each is made once, in their order.
  virtual Piece piece(std::size_t i, const Normal_of_wedges& normal_of_wedges) = 0;
  // so far, with all vertices of the control mesh
  virtual std::uint64_t number_of_vertices() const = 0;
  virtual std::uint64_t number_of_triangles() const = 0;
};

template <class Scheme, class FT, class Level_creases, bool may_be_proven>
class Tessellation_pieces final : public Kept_tessellation<FT>
{
public:
  using Data = Tessellation_data<Scheme, FT, Level_creases, may_be_proven>;
  using Index = Level_connectivity::Index;
  using typename Kept_tessellation<FT>::Piece;
  using typename Kept_tessellation<FT>::Normal_of_wedges;

  // The table's arrays need no values.
  Tessellation_pieces(const Scheme& scheme, Data&& data, std::optional<Attribute_table> table,
                      const For_chunks& for_chunks)
    : scheme_(kept_scheme(scheme, roundness_))
    , data_(std::move(data))
    , shape_(std::move(table))
    , table_(shape_ ? &*shape_ : nullptr)
    , for_chunks_(for_chunks)
    , numbers_(level().number_of_vertices())
    , candidates_(level())
    , slots_(level(), data_.creases)
  {
    data_.demand.is_of_piece = true;
  }

  std::vector<double> expected_triangles() const override
  {
    constexpr std::size_t least_at_once = 1 << 14, parts_of_many = 8;
    constexpr double more_if_proven = 2;
    Tessellation_demand demand = data_.demand;
    demand.most_rounds = 0;
    demand.is_proven = demand.is_of_piece = false;
    std::vector<double> expected(level().number_of_faces(), 0);
    const std::size_t number =
      (std::min)((expected.size() + least_at_once - 1) / least_at_once, parts_of_many);
    const Divided_level parts(level(), (std::max)(number, std::size_t(1)), place());
    for (std::size_t i = 0; i < number; ++i) {
      Part part = this->part(parts, i, 0);
      Refinement refinement(scheme_, demand, for_chunks_);
      refinement(std::move(part.control), std::move(part.creases), {}, &part.is_wanted);
      for (const Tessellation_node& node : refinement.nodes()) {
        if (!node.is_leaf) continue;
        const double excess = node.leaf.error / demand.tolerance; // a fourth in each round
        expected[part.of.faces[node.leaf.origin]] += (node.leaf.degree - 2) *
                                                     (excess > 1 ? (std::min)(excess, 1e15) : 1.) *
                                                     (data_.demand.is_proven ? more_if_proven : 1);
      }
    }
    return expected;
  }

  std::vector<double> divide(std::size_t number, const std::vector<double>& weights) override
  {
    division_.emplace(level(), number, place(), &weights);
    std::vector<double> sums(number, 0);
    for (std::size_t i = 0; i < number; ++i)
      for (const Index* f = division_->begin(i); f != division_->end(i); ++f)
        sums[i] += weights[*f];
    return sums;
  }
  bool is_empty(std::size_t i) const override
  {
    return division_->begin(i) == division_->end(i) &&
           (i != 0 || division_->isolated_vertices().empty());
  }

  Piece piece(std::size_t i, const Normal_of_wedges& normal_of_wedges) override
  {
    Tessellation_runs<FT> runs(most_runs);
    std::optional<Piece> piece;
    while (!piece) piece = run(i, normal_of_wedges, runs);
    return std::move(*piece);
  }

  std::uint64_t number_of_vertices() const override { return numbers_.number_of_vertices(); }
  std::uint64_t number_of_triangles() const override { return triangles_; }

private:
  using Refinement = typename Data::Refinement;
  using Value = typename Refinement::Value;
  static constexpr bool is_creased = are_creases_v<Level_creases>;
  static constexpr Index null = Level_connectivity::null;

  // What is split again has its neighbors split again in another run only.
  static constexpr unsigned most_runs = 2;
  // What is refined along with a piece, and how its own faces and their sides are divided is right: whether splits are taken
  // back at a face depends on faces that touch it, and the order of the triangles at a vertex with several wedges on
  // all faces there.
  static constexpr unsigned wanted_rings = (is_creased ? 2 : 1) + most_runs - 1;
  // One about the vertices that are wanted, whose limits tell on which side their normals are, and one that the
  // rim is not that of a part about a single vertex; rules of creases read all wedges of a vertex.
  static constexpr unsigned more_rings = is_creased ? 4 : 2;

  // none if there has to be another one
  std::optional<Piece> run(std::size_t i, const Normal_of_wedges& normal_of_wedges,
                           Tessellation_runs<FT>& runs)
  {
    Part part = this->part(*division_, i, wanted_rings);
    Refinement refinement(scheme_, data_.demand, for_chunks_);
    refinement(std::move(part.control), std::move(part.creases), part.attributes, &part.is_wanted,
               runs.take_nodes());
    const Leaf_triangles<FT> triangles =
      runs.triangles(refinement, table_.dimension_of_corners(), [&](const Tessellation_leaf& leaf) {
        return part.is_owned[leaf.origin] != 0;
      });
    if (runs.go_on(refinement, triangles)) return std::nullopt;
    std::vector<bool> used = used_vertices(refinement.all(), triangles);
    for (const Index v : part.isolated) used[v] = true;
    const std::vector<flatness::Vector> normals = this->normals(refinement, used, normal_of_wedges);
    Piece piece;
    number_vertices(part, refinement.all(), used, piece);
    for (Index v = 0; v < used.size(); ++v)
      if (used[v]) piece.normals.push_back(normals[v]);
    refinement.remove_unused(used);
    const Split_edges<FT>& all = refinement.all();
    for (Index v = 0; v < all.number_of_vertices(); ++v) piece.points.push_back(all.point(v));
    if (table_.any()) {
      std::vector<Index> vertices; // of the control mesh
      for (Index v = 0; v < part.of.vertices.size(); ++v)
        if (used[v]) vertices.push_back(part.of.vertices[v]);
      piece.attributes = table_.of_result(refinement, triangles, data_.attributes, &part.of.faces,
                                          std::move(vertices));
      for (auto& f : piece.attributes.face_parents) f = part.of.faces[f];
    }
    piece.level = Tessellation_mesh<FT>(all, triangles).level();
    piece.faces = Numbered_elements(triangles.triangles().size());
    for (std::size_t t = 0; t < piece.faces.size(); ++t) piece.faces.set(t, triangles_++, true);
    runs.report(refinement, triangles, piece);
    if (!part.of.faces.empty()) piece.worst_face = part.of.faces[piece.worst_face];
    return piece;
  }

  // some faces with the rings around them
  struct Part
  {
    Valued_level<Value> control;
    Level_creases creases;
    typename Data::Attributes attributes;
    Level_part of; // without its level
    Face_marks is_owned, is_wanted;
    std::vector<Index> isolated, seams; // edges between faces that are owned and others
  };

  const Level_connectivity& level() const { return data_.control.level; }

  auto place() const
  {
    return [this](Index v) { return to_double_3(point_of(data_.control.values[v])); };
  }

  Part part(const Divided_level& division, std::size_t i, unsigned wanted) const
  {
    const bool has_isolated = i == 0;
    candidates_.list(division.begin(i), division.end(i), wanted + cut_rings(scheme_) + more_rings,
                     has_isolated ? division.isolated_vertices() : std::vector<Index>());
    Piece_extraction<Listed_candidates> extraction(level(), candidates_, has_isolated);
    Part part{{}, Level_creases(0), {}, Level_part(extraction, true), {}, {}, {}, {}};
    const Level_connectivity& cut = part.of.level;
    part.creases = Level_creases(cut.number_of_vertices());
    std::vector<Index> slot_ids = part.of.vertices;
    if constexpr (is_creased)
      if (!data_.creases.empty()) {
        part.creases = part.of.creases(data_.creases);
        slot_ids = part.of.slot_origins(part.creases, slots_);
      }
    part.control.values = values_of_part(data_.control.values, slot_ids);
    read_attributes(part);
    for (const Index f : part.of.faces) part.is_owned.push_back(division.owns_face(i, f) ? 1 : 0);
    part.is_wanted = part.is_owned;
    for (unsigned r = 0; r < wanted; ++r) add_ring(cut, part.is_wanted);
    for (Index v = 0; v < cut.number_of_vertices(); ++v)
      if (cut.is_isolated(v)) part.isolated.push_back(v);
    for (Index e = 0; e < cut.number_of_edges(); ++e)
      if (!cut.is_border_edge(e) &&
          part.is_owned[cut.face(2 * e)] != part.is_owned[cut.face(2 * e + 1)])
        part.seams.push_back(e);
    part.control.level = std::move(part.of.level);
    return part;
  }

  void read_attributes(Part& part) const
  {
    const auto& whole = data_.attributes;
    auto& of_part = part.attributes;
    of_part.of_vertices = whole.of_vertices;
    of_part.of_corners = whole.of_corners;
    of_part.largest = whole.largest;
    const auto take = [](const std::vector<double>& from, std::size_t n, std::size_t i,
                         std::vector<double>& to) {
      const auto begin = from.begin() + std::ptrdiff_t(i * n);
      to.insert(to.end(), begin, begin + std::ptrdiff_t(n));
    };
    for (const Index v : part.of.vertices)
      take(whole.vertices, whole.of_vertices, v, of_part.vertices);
    if (whole.of_corners > 0)
      for (Index h = 0; h < part.of.level.number_of_halfedges(); ++h)
        take(whole.corners, whole.of_corners, part.of.halfedge(h), of_part.corners);
  }

  // Of vertices with several wedges all leaves count, of other pieces too, in the order that they have in the whole.
  static std::vector<flatness::Vector> normals(const Refinement& refinement,
                                               [[maybe_unused]] const std::vector<bool>& used,
                                               [[maybe_unused]] const Normal_of_wedges& of_wedges)
  {
    const Split_edges<FT>& all = refinement.all();
    std::vector<flatness::Vector> normals(all.number_of_vertices(), flatness::Vector{});
    if constexpr (!is_creased) {
      for (Index s = 0; s < all.number_of_slots(); ++s)
        normals[all.slot(s).vertex] = all.slot(s).normal;
    } else {
      std::vector<unsigned char> wedges(all.number_of_vertices(), 0); // 2: several
      for (Index s = 0; s < all.number_of_slots(); ++s) {
        unsigned char& n = wedges[all.slot(s).vertex];
        n = (std::min<unsigned char>)(n + 1, 2);
      }
      std::vector<bool> is_seen(all.number_of_slots(), false);
      std::unordered_map<Index, std::vector<flatness::Vector>> several;
      for (const Tessellation_node& node : refinement.nodes())
        for (Index i = 0; node.is_leaf && i < node.leaf.degree; ++i)
          all.for_each_part(node.leaf.slot_ids[i], node.leaf.halfedges[i],
                            [&](Index slot, Index, double) {
                              const Index v = all.slot(slot).vertex;
                              if (!used[v] || is_seen[slot]) return;
                              is_seen[slot] = true;
                              if (wedges[v] == 1)
                                normals[v] = all.slot(slot).normal;
                              else
                                several[v].push_back(all.slot(slot).normal);
                            });
      for (const auto& [v, of_vertex] : several) normals[v] = of_wedges(of_vertex);
    }
    return normals;
  }

  void number_vertices(const Part& part, const Split_edges<FT>& all, const std::vector<bool>& used,
                       Piece& piece)
  {
    constexpr auto none = Numbered_elements::no_number;
    Numbered_elements of_all(used.size());
    for (Index v = 0; v < used.size(); ++v) of_all.set(v, none, false);
    for (Index v = 0; v < part.of.vertices.size(); ++v)
      if (used[v]) of_all.set(v, part.of.vertices[v], numbers_.give(part.of.vertices[v]));
    std::vector<Index> along;
    for (const Index e : part.seams) {
      along.clear();
      all.for_each_part(null, 2 * e, [&](Index slot, Index, double) {
        if (slot != null) along.push_back(all.slot(slot).vertex);
      });
      numbers_.for_edge(part.of.edges[e], along.size(),
                        [&](std::size_t i, std::uint64_t number, bool is_new) {
                          of_all.set(along[i], number, is_new);
                        });
    }
    for (Index v = 0; v < used.size(); ++v) {
      if (!used[v]) continue;
      if (of_all.number(v) == none) of_all.set(v, numbers_.next(), true);
      piece.vertices.push_back(of_all.number(v), of_all.is_owned(v));
    }
  }

  Given_roundness<FT> roundness_;
  const Scheme scheme_;
  Data data_;
  std::optional<Attribute_table> shape_;
  const Tessellation_table table_;
  For_chunks for_chunks_;
  Piece_numbers numbers_;
  mutable Listed_candidates candidates_;
  const Slots_of_corners<Level_creases> slots_;
  std::optional<Divided_level> division_;
  std::uint64_t triangles_ = 0;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_PIECES_H
