// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_NUMBER_SET_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_NUMBER_SET_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// each six bits of it are others (de Bruijn)
constexpr std::uint64_t sequence_of_places = 0x03f79d71b4cb0a89;
constexpr std::array<unsigned char, 64> make_places()
{
  std::array<unsigned char, 64> places{};
  for (unsigned char i = 0; i < 64; ++i) places[(sequence_of_places << i) >> 58] = i;
  return places;
}

// the place of the lowest bit \pre bits != 0
inline unsigned lowest_bit(std::uint64_t bits)
{
  static constexpr std::array<unsigned char, 64> places = make_places();
  return places[((bits & (~bits + 1)) * sequence_of_places) >> 58];
}

// Numbers below a bound, from which they come in increasing order: a bit for each, a bit for each word of these
// that is not zero, and so on. Some hundred numbers of a piece are sorted by it in a fraction of the time of
// std::sort(), whatever the bound is.
class Number_set
{
public:
  using Number = std::uint32_t;

  explicit Number_set(std::size_t bound)
  {
    do {
      bound = (bound + 63) / 64;
      words_.emplace_back(bound == 0 ? 1 : bound, 0);
    } while (bound > 1);
  }

  void add(Number i)
  {
    for (auto& words : words_) {
      std::uint64_t& word = words[i >> 6];
      const bool is_listed = word != 0;
      word |= std::uint64_t(1) << (i & 63);
      if (is_listed) return;
      i >>= 6;
    }
  }

  // moves all of them to the list, which becomes their order
  void move_to(std::vector<Number>& numbers)
  {
    numbers.clear();
    move(words_.size() - 1, 0, numbers);
  }

private:
  void move(std::size_t level, std::size_t place, std::vector<Number>& numbers)
  {
    std::uint64_t& word = words_[level][place];
    for (std::uint64_t bits = word; bits != 0; bits &= bits - 1) {
      const std::size_t i = 64 * place + lowest_bit(bits);
      if (level == 0)
        numbers.push_back(static_cast<Number>(i));
      else
        move(level - 1, i, numbers);
    }
    word = 0;
  }

  std::vector<std::vector<std::uint64_t>> words_;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_PIECES_NUMBER_SET_H
