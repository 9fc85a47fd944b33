// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATE_IN_PIECES_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATE_IN_PIECES_H

#include <CGAL/PN_limit_surface_3/Surface_piece.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Tessellation_pieces.h>
#include <CGAL/PN_limit_surface_3/tessellate.h>
#include <CGAL/PN_subdivision_3/internal/attributes/Kept_attributes.h>
#include <CGAL/PN_subdivision_3/internal/calls/concept_checks.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A piece in the form that those of Surface_pieces have.
struct Piece_of_tessellation
{
  template <class GeomTraits>
  static Surface_piece<GeomTraits> make(Tessellated_piece<typename GeomTraits::FT>&& piece,
                                        bool has_attributes)
  {
    Surface_piece<GeomTraits> result;
    result.connectivity_ = std::move(piece.level);
    result.vertices_ = std::move(piece.vertices);
    result.faces_ = std::move(piece.faces);
    result.points_.reserve(piece.points.size());
    for (const auto& p : piece.points) result.points_.emplace_back(p[0], p[1], p[2]);
    result.normals_.reserve(piece.normals.size());
    for (const flatness::Vector& n : piece.normals) result.normals_.emplace_back(n[0], n[1], n[2]);
    if (has_attributes) result.attributes_ = Kept_attributes(std::move(piece.attributes));
    return result;
  }
};

template <class Scheme, class FT, class Level_creases, bool may_be_proven>
std::unique_ptr<Kept_tessellation<FT>>
kept_tessellation(const Scheme& scheme,
                  Tessellation_data<Scheme, FT, Level_creases, may_be_proven>&& data,
                  std::optional<Attribute_table> table, const For_chunks& for_chunks)
{
  return std::make_unique<Tessellation_pieces<Scheme, FT, Level_creases, may_be_proven>>(
    scheme, std::move(data), std::move(table), for_chunks);
}

// The tessellation of tessellate() in pieces; the mesh is not needed afterwards. Throws as tessellate() does.
template <class Concurrency_tag, class FaceGraph, class Scheme, class NamedParameters>
std::unique_ptr<Kept_tessellation<typename Surface_parameters<FaceGraph, NamedParameters>::FT>>
tessellate_in_pieces(const FaceGraph& control, const Scheme& scheme, double chord_error,
                     const NamedParameters& np)
{
  using Parameters = Surface_parameters<FaceGraph, NamedParameters>;
  using Result = std::unique_ptr<Kept_tessellation<typename Parameters::FT>>;
  if constexpr (adapts_scheme_v<Scheme, NamedParameters>)
    return with_scheme_of_call(scheme, np, [&](const auto& s, const auto& others) {
      return tessellate_in_pieces<Concurrency_tag>(control, s, chord_error, others);
    });
  else if constexpr (Is_any<Scheme>::value)
    return on_host<Result, Surface_call<FaceGraph, NamedParameters>>(scheme, [&](const auto& s) {
      return tessellate_in_pieces<Concurrency_tag>(control, s, chord_error, np);
    });
  else if constexpr (!std::is_same_v<typename Scheme::Host, PQQ_host> &&
                     !std::is_same_v<typename Scheme::Host, PTQ_host>)
    throw std::invalid_argument(no_halves(scheme));
  else {
    Result result;
    if constexpr (check_pieces_arguments<FaceGraph, Scheme, NamedParameters>())
      with_mesh_access(control, [&](const auto& access) {
        const Tessellation<Concurrency_tag, FaceGraph, NamedParameters> tessellation(
          chord_error, np, attribute_table(np), true);
        with_roundness_of_call<Parameters>(access, scheme, np, [&](const auto& s) {
          tessellation.read(access, s, Parameters::const_point_map(control, np), [&](auto&& data) {
            result = kept_tessellation(rules_of(s), std::move(data), tessellation.table().shape(),
                                       tessellation.for_chunks());
          });
        });
      });
    return result;
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATE_IN_PIECES_H
