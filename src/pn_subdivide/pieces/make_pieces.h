// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_MAKE_PIECES_H
#define PN_SUBDIVIDE_MAKE_PIECES_H

#include "pieces/Any_pieces.h"
#include "surface/Scheme.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace pn_subdivide {

// One file each, so that they are compiled side by side.
std::unique_ptr<Any_pieces> make_pieces_linearly(const Surface& surface, const Scheme& scheme,
                                                 unsigned levels, std::size_t number);
std::unique_ptr<Any_pieces> make_pieces_with_normals(const Surface& surface, Normal_map normals,
                                                     const Scheme& scheme, unsigned levels,
                                                     std::size_t number);
std::unique_ptr<Any_pieces> make_pieces_with_normal_scheme(const Surface& surface,
                                                           Normal_map normals, const Scheme& scheme,
                                                           const Scheme& normal_scheme,
                                                           unsigned levels, std::size_t number);

template <class S>
class Pieces_of_scheme : public Any_pieces
{
public:
  template <class NamedParameters>
  Pieces_of_scheme(const Surface& surface, const S& scheme, std::size_t number,
                   const NamedParameters& np)
    : pieces_(surface, scheme, number, np)
  {}

  std::size_t number() const override { return pieces_.number_of_pieces(); }
  bool is_empty(std::size_t i) const override { return pieces_.is_empty(i); }
  const Size& size() const override { return pieces_.size(); }
  std::uint64_t first_corner(std::uint64_t face) const override
  {
    return pieces_.first_corner(face);
  }
  std::size_t largest_degree() const override { return pieces_.largest_degree(); }
  Piece piece(std::size_t i, unsigned rings) const override { return pieces_.piece(i, rings); }

private:
  CGAL::PN_subdivision_3::Surface_pieces<S, Kernel, CGAL::Parallel_if_available_tag> pieces_;
};

template <class S, class NamedParameters>
std::unique_ptr<Any_pieces> pieces_of_scheme(const Surface& surface, const S& scheme,
                                             std::size_t number, const NamedParameters& np)
{
  return std::make_unique<Pieces_of_scheme<S>>(surface, scheme, number, np);
}

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_MAKE_PIECES_H
