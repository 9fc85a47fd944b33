// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/write_text.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pn_subdivide {
namespace {

// of a character of UTF-8 that begins with this byte; 0 if none does
std::size_t number_of_bytes(unsigned char first)
{
  if (first < 0x80) return 1;
  if (first < 0xc2) return 0; // a later byte, or a longer form than needed
  if (first < 0xe0) return 2;
  if (first < 0xf0) return 3;
  return first < 0xf5 ? 4 : 0;
}

// those of XML 1.0, each in its shortest form
bool is_xml_character(std::uint32_t code, std::size_t bytes)
{
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < 0x20) return code == '\t' || code == '\n' || code == '\r';
  const bool is_half_of_a_pair = code >= 0xd800 && code < 0xe000;
  return code >= least[bytes] && code < 0x110000 && !is_half_of_a_pair && code != 0xfffe &&
         code != 0xffff;
}

// The bytes of the character at the beginning; 0 if there is none of XML's.
std::size_t first_character(std::string_view text)
{
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t bytes = number_of_bytes(first);
  if (bytes == 0 || bytes > text.size()) return 0;
  std::uint32_t code = bytes == 1 ? first : first & (0xffu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xc0u) != 0x80) return 0;
    code = (code << 6) | (next & 0x3fu);
  }
  return is_xml_character(code, bytes) ? bytes : 0;
}

std::string escaped(std::string_view character)
{
  switch (character[0]) {
  case '&':
    return "&amp;";
  case '<':
    return "&lt;";
  case '>':
    return "&gt;";
  case '"':
    return "&quot;";
  case '\t':
    return "&#9;";
  case '\n':
    return "&#10;";
  case '\r':
    return "&#13;";
  default:
    return std::string(character);
  }
}

} // namespace

std::string xml_text(const std::string& text)
{
  std::string s;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t bytes = first_character(rest);
    s += bytes == 0 ? "?" : escaped(rest.substr(0, bytes));
    rest.remove_prefix(bytes == 0 ? 1 : bytes);
  }
  return s;
}

bool is_xml_text(const std::string& text)
{
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t bytes = first_character(rest);
    if (bytes == 0) return false;
    rest.remove_prefix(bytes);
  }
  return true;
}

} // namespace pn_subdivide
