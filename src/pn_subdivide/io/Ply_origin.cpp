// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Ply_origin.h"

#include <boost/endian/conversion.hpp>

#include <cstdint>
#include <sstream>

namespace pn_subdivide {
namespace {

void append(std::string& bytes, std::uint32_t n)
{
  unsigned char four[4];
  boost::endian::endian_store<std::uint32_t, 4, boost::endian::order::little>(four, n);
  bytes.append(reinterpret_cast<const char*>(four), 4);
}

} // namespace

std::string origin_comments(const Mesh_origin& origin)
{
  std::string text;
  for (const Mesh_origin::Rounds& rounds : origin.rounds)
    text += "comment " + std::to_string(rounds.number) +
            (rounds.number == 1 ? " round of " : " rounds of ") + rounds.scheme + " from " +
            origin_element + " of " + std::to_string(origin.vertices) + " vertices\n";
  return text;
}

std::string origin_header(const Mesh_origin& origin)
{
  if (!origin.any()) return {};
  return std::string("element ") + origin_element + " " + std::to_string(origin.face_end.size()) +
         "\nproperty list uint uint vertex_indices\n";
}

std::string origin_bytes(const Mesh_origin& origin)
{
  std::string bytes;
  std::size_t begin = 0;
  for (const std::size_t end : origin.face_end) {
    append(bytes, static_cast<std::uint32_t>(end - begin));
    for (; begin < end; ++begin) append(bytes, origin.corners[begin]);
  }
  return bytes;
}

void read_origin_comments(const std::vector<std::string>& comments, Mesh_origin& origin)
{
  for (const std::string& comment : comments) {
    std::istringstream words(comment);
    Mesh_origin::Rounds rounds;
    std::string round, of, from, element, of_vertices;
    std::size_t vertices = 0;
    if (!(words >> rounds.number >> round >> of >> rounds.scheme >> from >> element) ||
        !(words >> of_vertices >> vertices) || from != "from" || element != origin_element)
      continue;
    origin.rounds.push_back(rounds);
    origin.vertices = vertices;
  }
}

} // namespace pn_subdivide
