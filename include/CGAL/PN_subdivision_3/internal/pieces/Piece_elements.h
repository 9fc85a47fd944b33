// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_PIECE_ELEMENTS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_PIECE_ELEMENTS_H

#include <boost/container/vector.hpp>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Elements of one kind in a piece: their numbers in the whole level, and whether the piece owns them. Every
// element of the whole level has one owner.
class Numbered_elements
{
public:
  using Number = std::uint64_t;

  // of an element that the whole level does not have
  static constexpr Number no_number = static_cast<Number>(-1);

  Numbered_elements() = default;
  explicit Numbered_elements(std::size_t size)
    : number_(size, boost::container::default_init)
    , is_owned_(size, boost::container::default_init)
  {}

  std::size_t size() const { return number_.size(); }
  Number number(std::size_t i) const { return number_[i]; }
  bool is_owned(std::size_t i) const { return is_owned_[i] != 0; }

  // different elements by different threads
  void set(std::size_t i, Number number, bool is_owned)
  {
    number_[i] = number;
    is_owned_[i] = is_owned ? 1 : 0;
  }
  void push_back(Number number, bool is_owned)
  {
    number_.push_back(number);
    is_owned_.push_back(is_owned ? 1 : 0);
  }

private:
  boost::container::vector<Number> number_;
  boost::container::vector<char> is_owned_;
};

// Those of a level of a piece, beside its connectivity. In all three kinds the numbers increase.
struct Piece_elements
{
  Numbered_elements vertices, edges, faces;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_PIECE_ELEMENTS_H
