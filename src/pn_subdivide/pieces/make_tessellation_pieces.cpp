// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/corner_normals.h"
#include "pieces/Any_pieces.h"
#include "pieces/Piece_count.h"
#include "surface/Tessellation_parameters.h"
#include "surface/tessellate_surface.h"

#include <CGAL/PN_limit_surface_3/internal/tessellation/tessellate_in_pieces.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace pn_subdivide {
namespace {

namespace PN = CGAL::PN_subdivision_3;
using Kept = PN::internal::Kept_tessellation<double>;
using Vector = PN::internal::flatness::Vector;

class Tessellated_pieces : public Any_pieces
{
public:
  Tessellated_pieces(std::unique_ptr<Kept> kept, std::size_t control_vertices, bool is_proven)
    : kept_(std::move(kept))
  {
    size_.vertices = control_vertices;
    tessellation_.is_proven = is_proven;
  }

  void divide(std::size_t number, const std::vector<double>& weights)
  {
    number_ = number;
    kept_->divide(number, weights);
  }

  std::size_t number() const override { return number_; }
  bool is_empty(std::size_t i) const override { return kept_->is_empty(i); }
  const Size& size() const override { return size_; }
  std::uint64_t first_corner(std::uint64_t face) const override { return 3 * face; }
  std::size_t largest_degree() const override { return 3; }
  CGAL::Bbox_3 box_of_piece(std::size_t) const override { return {}; }
  void set_box(const CGAL::Bbox_3&) override {}
  const Tessellation* tessellation() const override { return &tessellation_; }

  Piece piece(std::size_t i, unsigned /*rings*/) override
  {
    auto piece = kept_->piece(i, [this](const std::vector<Vector>& n) { return sum(n); });
    if (piece.bound > tessellation_.bound) {
      tessellation_.bound = piece.bound;
      tessellation_.worst_face = piece.worst_face;
      tessellation_.worst_place = piece.worst_place;
    }
    if (!piece.reached) tessellation_.obstacle = piece.obstacle;
    tessellation_.reached = tessellation_.reached && piece.reached;
    tessellation_.depth = (std::max)(tessellation_.depth, piece.depth);
    tessellation_.triangles = kept_->number_of_triangles();
    size_.vertices = kept_->number_of_vertices();
    size_.faces = kept_->number_of_triangles();
    return PN::internal::Piece_of_tessellation::make<Kernel>(std::move(piece), true);
  }

private:
  // of the different ones, as set_vertex_normals() has it
  Vector sum(const std::vector<Vector>& normals)
  {
    std::vector<Vector> different;
    for (const Vector& n : normals)
      if (std::find(different.begin(), different.end(), n) == different.end())
        different.push_back(n);
    if (different.size() == 1) return different[0];
    tessellation_.has_several_normals = true;
    Vector sum = different[0];
    for (std::size_t i = 1; i < different.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += different[i][k];
    return normalized(sum);
  }

  std::unique_ptr<Kept> kept_;
  std::size_t number_ = 1;
  Size size_;
  Tessellation tessellation_;
};

// What so many pieces take, the largest of which has a part of the weights. That of the rings around it is as if it were
// a square of faces.
double bytes_of_pieces(const std::vector<double>& weights_of_pieces, std::size_t control_faces,
                       double of_vertex)
{
  constexpr double of_control_face = 500, of_face_near_piece = 1500, of_triangle = 700;
  constexpr double rings_with_triangles = 2, rings = 9;
  const double faces = double(control_faces) / double(weights_of_pieces.size());
  const auto with_rings = [&](double number) {
    const double side = std::sqrt((std::max)(faces, 1.)) + 2 * number;
    return (std::min)(side * side, double(control_faces));
  };
  const double largest = *std::max_element(weights_of_pieces.begin(), weights_of_pieces.end());
  return double(control_faces) * of_control_face + with_rings(rings) * of_face_near_piece +
         largest * with_rings(rings_with_triangles) / (std::max)(faces, 1.) *
           (of_triangle + of_vertex / 2);
}

} // namespace

std::unique_ptr<Any_pieces> make_tessellation_pieces(Surface& surface, const Scheme_choice& choice,
                                                     const Tessellation_in_pieces& wanted,
                                                     const Pieces_options& options,
                                                     const std::optional<Crease_maps>& creases,
                                                     const PN::Attribute_table& attributes,
                                                     double of_vertex)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, wanted.threads);
#endif
  PN::Attribute_table table = attributes;
  std::unique_ptr<Kept> kept =
    with_tessellation_parameters(surface, choice, creases, [&](const auto& scheme, const auto& np) {
      return PN::internal::tessellate_in_pieces<CGAL::Parallel_if_available_tag>(
        surface, scheme, wanted.chord,
        PN::parameters::join(PN::parameters::attributes(table).proven_bound(wanted.is_proven), np));
    });
  const std::size_t vertices = surface.number_of_vertices(), faces = surface.number_of_faces();
  surface = Surface();
  const std::vector<double> weights =
    options.pieces == std::size_t(1) ? std::vector<double>(faces, 1) : kept->expected_triangles();
  const auto bytes = [&](std::size_t n) {
    return bytes_of_pieces(kept->divide(n, weights), faces, of_vertex);
  };
  const std::size_t number =
    options.pieces ? *options.pieces
                   : fitting_piece_count(options, bytes, 1, (std::max)(faces, std::size_t(1)));
  auto pieces = std::make_unique<Tessellated_pieces>(std::move(kept), vertices, wanted.is_proven);
  pieces->divide(number, weights);
  return pieces;
}

} // namespace pn_subdivide
