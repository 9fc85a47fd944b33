// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PLY_VALUES_H
#define PN_SUBDIVIDE_PLY_VALUES_H

#include "io/Attributes.h"
#include "io/Error.h"
#include "io/Ply_header.h"
#include "io/Text_reader.h"

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace pn_subdivide {

// Hands out the values behind a PLY header one after the other. Every PLY type fits into a double.
class Ply_values
{
public:
  Ply_values(const std::string& content, const Text_reader& behind_header, Ply_format format)
    : content_(content)
    , text_(behind_header)
    , pos_(behind_header.offset())
    , format_(format)
  {}

  double next(Scalar_type type)
  {
    switch (type) {
    case Scalar_type::int8:
      return value<std::int8_t>();
    case Scalar_type::uint8:
      return value<std::uint8_t>();
    case Scalar_type::int16:
      return value<std::int16_t>();
    case Scalar_type::uint16:
      return value<std::uint16_t>();
    case Scalar_type::int32:
      return value<std::int32_t>();
    case Scalar_type::uint32:
      return value<std::uint32_t>();
    case Scalar_type::float32:
      return value<float>();
    case Scalar_type::float64:
      break;
    }
    return value<double>();
  }

  // The same for a property that is carried: in a text, too, the number must be one of its type.
  double next(const Ply_property& property)
  {
    const double x = next(property.type);
    if (format_ != Ply_format::ascii || property.type == Scalar_type::float64) return x;
    const double rounded = nearest(property.type, x);
    const bool is_integer = traits(property.type).is_integer;
    if (is_integer ? rounded == x : std::isfinite(rounded) || !std::isfinite(x)) return rounded;
    std::ostringstream message;
    message.precision(17);
    message << x << " does not fit into '" << Text_reader::printable(property.name)
            << "', which is of type " << description(property.type);
    text_.fail(message.str());
  }

  bool is_text() const { return format_ == Ply_format::ascii; }
  // the last one, of a text
  std::string_view word() const { return word_; }

  std::size_t bytes_left() const
  {
    return content_.size() - (format_ == Ply_format::ascii ? text_.position() : pos_);
  }

  // Is nothing but blanks left?
  bool at_end()
  {
    if (format_ == Ply_format::ascii) return text_.at_end_of_line() && !text_.next_line();
    return content_.find_first_not_of(" \t\r\n", pos_) == std::string::npos;
  }

private:
  template <class T>
  double value()
  {
    if (format_ == Ply_format::ascii) return text_value();
    if (content_.size() - pos_ < sizeof(T)) throw Error("truncated");
    const auto* bytes = reinterpret_cast<const unsigned char*>(content_.data()) + pos_;
    pos_ += sizeof(T);
    using boost::endian::order;
    return format_ == Ply_format::little_endian
             ? boost::endian::endian_load<T, sizeof(T), order::little>(bytes)
             : boost::endian::endian_load<T, sizeof(T), order::big>(bytes);
  }

  double text_value()
  {
    word_ = text_.word_across_lines();
    if (word_.empty()) throw Error("truncated");
    return text_.to_number(word_, "a number");
  }

  const std::string& content_;
  Text_reader text_;
  std::size_t pos_;
  Ply_format format_;
  std::string_view word_;
};

// The scalar properties of an element that are carried, all but those that mean points, normals and
// faces.
class Ply_columns
{
public:
  Ply_columns() = default;

  Ply_columns(const Ply_element& element, const std::vector<std::string>& others)
  {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const Ply_property& p = element.properties[k];
      const bool is_other = std::find(others.begin(), others.end(), p.name) != others.end();
      carries_.push_back(!p.is_list && !is_other);
      if (!carries_.back()) continue;
      positions_.push_back(k);
      columns_.push_back({p.name, p.type, {}, {}, true});
    }
  }

  bool carries(std::size_t position) const
  {
    return position < carries_.size() && carries_[position];
  }

  void reserve(std::size_t elements)
  {
    for (Column& column : columns_) column.values.reserve(elements);
  }

  // All scalars of the next element.
  void add(const std::vector<double>& scalars)
  {
    for (std::size_t i = 0; i < columns_.size(); ++i)
      columns_[i].values.push_back(scalars[positions_[i]]);
  }

  Columns take() { return std::move(columns_); }

private:
  Columns columns_;
  std::vector<std::size_t> positions_; // of the columns among the properties
  std::vector<bool> carries_;
};

// What comments of a PLY file say about its attributes: "TextureFile wood.png", "mtllib house.mtl"
// and, for the numbers 0, 1, ... of a property 'material', "material 0 red".
void read_ply_comments(const std::vector<std::string>& comments, Attributes& attributes);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PLY_VALUES_H
