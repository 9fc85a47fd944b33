// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PLY_VALUES_H
#define PN_SUBDIVIDE_PLY_VALUES_H

#include "Error.h"
#include "Ply_header.h"
#include "Text_reader.h"

#include <boost/endian/conversion.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace pn_subdivide {

// Hands out the values behind a PLY header one after the other. Every PLY type fits into a double.
class Ply_values
{
public:
  Ply_values(const std::string& content, const Text_reader& behind_header, Ply_format format)
    : m_content(content)
    , m_text(behind_header)
    , m_pos(behind_header.offset())
    , m_format(format)
  {
  }

  double next(Ply_type type)
  {
    switch (type) {
    case Ply_type::int8:
      return value<std::int8_t>();
    case Ply_type::uint8:
      return value<std::uint8_t>();
    case Ply_type::int16:
      return value<std::int16_t>();
    case Ply_type::uint16:
      return value<std::uint16_t>();
    case Ply_type::int32:
      return value<std::int32_t>();
    case Ply_type::uint32:
      return value<std::uint32_t>();
    case Ply_type::float32:
      return value<float>();
    case Ply_type::float64:
      break;
    }
    return value<double>();
  }

  std::size_t bytes_left() const
  {
    return m_content.size() - (m_format == Ply_format::ascii ? m_text.position() : m_pos);
  }

  // Is nothing but blanks left?
  bool at_end()
  {
    if (m_format == Ply_format::ascii) return m_text.at_end_of_line() && !m_text.next_line();
    return m_content.find_first_not_of(" \t\r\n", m_pos) == std::string::npos;
  }

private:
  template <class T>
  double value()
  {
    if (m_format == Ply_format::ascii) return text_value();
    if (m_content.size() - m_pos < sizeof(T)) throw Error("truncated");
    const auto* bytes = reinterpret_cast<const unsigned char*>(m_content.data()) + m_pos;
    m_pos += sizeof(T);
    using boost::endian::order;
    return m_format == Ply_format::little_endian
               ? boost::endian::endian_load<T, sizeof(T), order::little>(bytes)
               : boost::endian::endian_load<T, sizeof(T), order::big>(bytes);
  }

  double text_value()
  {
    const std::string_view word = m_text.word_across_lines();
    if (word.empty()) throw Error("truncated");
    return m_text.to_number(word, "a number");
  }

  const std::string& m_content;
  Text_reader m_text;
  std::size_t m_pos;
  Ply_format m_format;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PLY_VALUES_H
