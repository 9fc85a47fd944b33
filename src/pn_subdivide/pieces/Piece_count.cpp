// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Piece_count.h"

#include "io/Error.h"
#include "pieces/Any_pieces.h"

#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace pn_subdivide {
namespace {

constexpr double mega = 1 << 20;
constexpr double default_memory = 1024 * mega;
constexpr double of_the_program = 48 * mega; // with its buffers, and the control mesh
constexpr double of_limits = 2; // limits are kept beside the last level, which has more rings
constexpr std::size_t most_pieces = 1 << 20;

std::string in_megabytes(double bytes)
{
  return std::to_string(static_cast<unsigned long long>(std::ceil(bytes / mega))) + "M";
}

} // namespace

double parse_memory(const std::string& text)
{
  char* end = nullptr;
  const bool is_number = !text.empty() && std::isdigit(static_cast<unsigned char>(text[0]));
  double bytes = is_number ? std::strtod(text.c_str(), &end) : 0;
  const std::string unit = is_number ? end : "";
  if (unit == "K")
    bytes *= 1024;
  else if (unit == "M")
    bytes *= mega;
  else if (unit == "G")
    bytes *= 1024 * mega;
  else if (unit == "T")
    bytes *= mega * mega;
  else
    bytes = 0;
  if (!(bytes > 0) || !std::isfinite(bytes))
    throw Usage_error("--memory '" + text + "': it takes a size such as 500M or 2G");
  return bytes;
}

std::size_t piece_count(const Surface& surface, const Scheme_choice& scheme, unsigned levels,
                        const Pieces_options& options, unsigned ranks, bool with_limits,
                        double of_vertex)
{
  if (options.pieces) return *options.pieces;
  const double memory = options.memory ? parse_memory(*options.memory) : default_memory;
  double least_bytes = 0;
  // a few pieces for each rank, so that none waits long for the last one
  for (std::size_t n = ranks == 1 ? 1 : 4 * std::size_t(ranks); n <= most_pieces; n += n / 4 + 1) {
    const double here = of_the_program + (with_limits ? of_limits : 1) *
                                           memory_of_pieces(surface, scheme, levels, n, of_vertex);
    if (here <= memory) return n;
    if (least_bytes == 0 || here < least_bytes) least_bytes = here;
  }
  throw Error("--memory: " + in_megabytes(memory) + " are not enough, it takes at least " +
              in_megabytes(least_bytes));
}

} // namespace pn_subdivide
