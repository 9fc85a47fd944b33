// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Ply_header.h"

#include <unordered_set>

namespace pn_subdivide {
namespace {

Scalar_type read_type(Text_reader& in)
{
  const std::string word(in.word());
  for (int i = 0; i <= static_cast<int>(Scalar_type::float64); ++i) {
    const auto type = static_cast<Scalar_type>(i);
    if (word == traits(type).ply || word == traits(type).other_ply) return type;
  }
  in.fail("not a PLY type: '" + Text_reader::printable(word) + "'");
}

Ply_format read_format(Text_reader& in)
{
  const std::string_view word = in.word();
  if (word == "ascii") return Ply_format::ascii;
  if (word == "binary_little_endian") return Ply_format::little_endian;
  if (word == "binary_big_endian") return Ply_format::big_endian;
  in.fail("not a PLY format: '" + Text_reader::printable(word) + "'");
}

Ply_element read_element(Text_reader& in, std::unordered_set<std::string>& names)
{
  Ply_element element;
  element.name = in.word();
  if (!names.insert(element.name).second)
    in.fail("a second element '" + Text_reader::printable(element.name) + "'");
  element.size = in.count("the number of elements");
  return element;
}

Ply_property read_property(Text_reader& in)
{
  Ply_property property;
  Text_reader first_word = in;
  property.is_list = first_word.word() == "list";
  if (property.is_list) {
    in.word();
    property.size_type = read_type(in);
    if (property.size_type == Scalar_type::float32 || property.size_type == Scalar_type::float64)
      in.fail("the length of a list must be an integer");
  }
  property.type = read_type(in);
  property.name = in.word();
  if (property.name.empty()) in.fail("a property without a name");
  return property;
}

} // namespace

std::size_t Ply_element::find(const std::string& property) const
{
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property) return i;
  return none;
}

Ply_header read_ply_header(Text_reader& in)
{
  Ply_header header;
  if (!in.next_line() || in.word() != "ply")
    in.fail("not a PLY file: it does not begin with 'ply'");

  bool has_format = false;
  std::unordered_set<std::string> names; // of the elements
  while (in.next_line()) {
    const std::string_view keyword = in.word();
    if (keyword == "format") {
      header.format = read_format(in);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(in, names));
    } else if (keyword == "property") {
      if (header.elements.empty()) in.fail("a property before the first element");
      header.elements.back().properties.push_back(read_property(in));
    } else if (keyword == "end_header") {
      if (!has_format) in.fail("the header says nothing about the format");
      return header;
    } else if (keyword == "comment") {
      header.comments.emplace_back(in.name());
    } else if (keyword != "obj_info") {
      in.fail("'" + Text_reader::printable(keyword) + "' does not belong into a PLY header");
    }
  }
  in.fail("truncated: the header has no 'end_header'");
}

} // namespace pn_subdivide
