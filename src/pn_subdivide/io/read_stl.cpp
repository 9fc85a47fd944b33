// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "io/Text_reader.h"
#include "io/formats.h"

#include <boost/algorithm/string/predicate.hpp>
#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>

namespace pn_subdivide {
namespace {

constexpr std::size_t header_size = 84, facet_size = 50;

const unsigned char* bytes(const std::string& content)
{
  return reinterpret_cast<const unsigned char*>(content.data());
}

std::size_t announced_facets(const std::string& content)
{
  if (content.size() < header_size) return 0;
  return boost::endian::load_little_u32(bytes(content) + header_size - 4);
}

bool is_binary(const std::string& content)
{
  return content.size() >= header_size && (content.size() - header_size) % facet_size == 0 &&
         (content.size() - header_size) / facet_size == announced_facets(content);
}

// The first word, perhaps behind a byte order mark.
std::string first_word(const std::string& content)
{
  const std::string_view blanks = "\xEF\xBB\xBF \t\r\n";
  const std::size_t begin = std::min(content.find_first_not_of(blanks), content.size());
  const std::size_t end = content.find_first_of(blanks, begin);
  return content.substr(begin, std::min(end - begin, std::size_t(20)));
}

[[noreturn]] void fail_as_no_stl(const std::string& content)
{
  if (boost::algorithm::iequals(first_word(content), "solid"))
    throw Error("an STL file with the keyword '" + first_word(content) +
                "': its keywords must be in lower case ('solid', 'facet', ...)");
  if (content.size() < header_size)
    throw Error("not an STL file: neither text that begins with 'solid' nor long enough for a "
                "binary one");
  throw Error("not an STL file or truncated: it is no text that begins with 'solid', and a binary "
              "file with the " +
              std::to_string(announced_facets(content)) + " triangles it announces has " +
              std::to_string(header_size + std::uint64_t(facet_size) * announced_facets(content)) +
              " bytes, not " + std::to_string(content.size()));
}

// Merges equal points; near ones are left to first_near(). CGAL's reader does so too, but skips in silence a facet whose keyword is
// damaged, and takes a coordinate that is not a number for equal to any other.
class Stl_reader
{
public:
  explicit Stl_reader(bool with_attributes)
    : with_attributes_(with_attributes)
  {}

  Mesh_data read_text(const std::string& content)
  {
    Text_reader in(content, '\0');
    while (in.next_line()) read_solid(in);
    if (with_attributes_ && !groups_.words.empty())
      mesh_.attributes.of_faces.push_back(std::move(groups_));
    return std::move(mesh_);
  }

  // Attribute bytes that are the same everywhere are no colors: programs write what they like.
  Mesh_data read_binary(const std::string& content)
  {
    const std::size_t facets = announced_facets(content);
    mesh_.reserve_faces(facets, 3 * facets);
    for (std::size_t f = 0; f < facets; ++f) {
      const unsigned char* const facet = bytes(content) + header_size + facet_size * f;
      for (std::size_t i = 0; i < 3; ++i) triangle_[i] = index(corner(facet + 12 * (i + 1)));
      mesh_.add_face(triangle_);
      const bool differs = !std::equal(facet + facet_size - 2, facet + facet_size,
                                       bytes(content) + header_size + facet_size - 2);
      if (with_attributes_ && differs) mesh_.drop("colors (attribute bytes of triangles)");
    }
    return std::move(mesh_);
  }

private:
  static Triple corner(const unsigned char* p)
  {
    using boost::endian::endian_load;
    using boost::endian::order;
    Triple c;
    for (std::size_t k = 0; k < 3; ++k)
      c[k] = endian_load<float, sizeof(float), order::little>(p + sizeof(float) * k);
    return c;
  }

  Index index(const Triple& c)
  {
    for (const double x : c)
      if (!std::isfinite(x))
        throw Error("triangle " + std::to_string(mesh_.number_of_faces()) +
                    " has a coordinate that is not finite");
    const auto next = static_cast<Index>(mesh_.points.size());
    const auto [place, is_new] = indices_.emplace(c, next);
    if (is_new) mesh_.points.push_back(c);
    return place->second;
  }

  static void expect(Text_reader& in, const std::string& keyword)
  {
    const std::string_view word = in.word_across_lines();
    if (word != keyword) fail(in, word, "'" + keyword + "'");
  }

  [[noreturn]] static void fail(const Text_reader& in, std::string_view word,
                                const std::string& expected)
  {
    in.fail("damaged or truncated STL file: " +
            (word.empty() ? "it ends" : "'" + Text_reader::printable(word) + "' stands") +
            " where " + expected + " is expected");
  }

  // 'solid' and 'endsolid' may be followed by a name, 'facet' by a normal, which is not used.
  void read_solid(Text_reader& in)
  {
    expect(in, "solid");
    const double group = group_of(std::string(in.name()));
    for (;;) {
      const std::string_view word = in.word_across_lines();
      if (word == "endsolid") break;
      if (word != "facet") fail(in, word, "'facet' or 'endsolid'");
      in.rest_of_line();
      read_facet(in);
    }
    in.rest_of_line();
    if (!groups_.words.empty()) groups_.values.resize(mesh_.number_of_faces(), group);
  }

  // Solids before the first one with a name are in none.
  double group_of(const std::string& name)
  {
    if (name.empty()) return -1;
    groups_.values.resize(mesh_.number_of_faces(), -1.);
    const auto [place, is_new] = numbers_.emplace(name, double(groups_.words.size()));
    if (is_new) groups_.words.push_back(name);
    return place->second;
  }

  void read_facet(Text_reader& in)
  {
    expect(in, "outer");
    expect(in, "loop");
    for (Index& i : triangle_) {
      expect(in, "vertex");
      Triple c;
      for (double& x : c) x = in.to_number(in.word_across_lines(), "a coordinate");
      i = index(c);
    }
    expect(in, "endloop");
    expect(in, "endfacet");
    mesh_.add_face(triangle_);
  }

  bool with_attributes_;
  Mesh_data mesh_;
  Column groups_{"group", Scalar_type::int32, {}, {}};
  std::map<std::string, double> numbers_; // of their names
  std::map<Triple, Index> indices_;
  std::array<Index, 3> triangle_;
};

} // namespace

Mesh_data read_stl(const std::string& content, bool with_attributes)
{
  Stl_reader reader(with_attributes);
  if (is_binary(content)) return reader.read_binary(content);
  if (first_word(content) == "solid") return reader.read_text(content);
  fail_as_no_stl(content);
}

} // namespace pn_subdivide
