// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PLY_HEADER_H
#define PN_SUBDIVIDE_PLY_HEADER_H

#include "io/Attributes.h"
#include "io/Error.h"
#include "io/Mesh_data.h"
#include "io/Text_reader.h"

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pn_subdivide {

enum class Ply_format { ascii, little_endian, big_endian };

struct Ply_property
{
  std::string name;
  Scalar_type type;
  bool is_list = false;
  Scalar_type size_type = Scalar_type::uint8; // of lists
};

struct Ply_element
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::string name;
  std::size_t size = 0;
  std::vector<Ply_property> properties;

  std::size_t find(const std::string& property) const; // its position, or `none`
};

struct Ply_header
{
  Ply_format format = Ply_format::ascii;
  std::vector<Ply_element> elements;
  std::vector<std::string> comments;
};

// Leaves `in` on the last line of the header. Throws Error.
Ply_header read_ply_header(Text_reader& in);

// What a header to be written depends on besides attributes.
struct Ply_shape
{
  std::uint64_t vertices = 0, faces = 0;
  bool has_normals = false, has_control_normals = false;
  Normal_kind normal_kind = Normal_kind::control;
  bool has_short_lists = true; // of at most 255 values
  bool has_roundness = false, has_texture = false;

  bool fits_int() const { return vertices <= 0x7fffffffu; }
  std::string list() const
  {
    return has_short_lists ? "property list uchar " : "property list uint ";
  }
};

// Of a binary file, with the columns of attributes, whose values do not matter.
std::string ply_header(const Ply_shape& shape, const Attributes& attributes);

// The element 'edge' of a PLY file, if it has the sharpness of edges; then the property 'sharpness' of vertices
// is theirs, too.
class Ply_tags
{
public:
  explicit Ply_tags(const Ply_header& header);

  bool any() const { return edges_ != nullptr; }
  bool is_edge(const Ply_element& element) const { return &element == edges_; }

  // Adds an edge, whose scalars are those of the element. Throws Error.
  void add_edge(const std::vector<double>& scalars, std::size_t number_of_vertices,
                Crease_tags& tags) const;

private:
  const Ply_element* edges_ = nullptr;
  std::array<std::size_t, 9> places_{}; // of the properties
  bool has_tangents_ = false;
};

// Throws Error unless it is a number that is not negative.
void require_sharpness(double sharpness);

// The texture coordinates of a face's corners, as MeshLab writes them.
constexpr const char* texture_list = "texcoord";
// Their control normals, where vertices have several; of other faces it is empty.
constexpr const char* normals_list = "corner_control_normals";
constexpr const char* roundness_list = "corner_roundness";
constexpr const char* edge_properties[] = {"vertex1", "vertex2", "sharpness", "t1x", "t1y",
                                           "t1z",     "t2x",     "t2y",       "t2z"};

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
    return with_type(type, [this](auto number) { return value<decltype(number)>(); });
  }

  // The same for a property that is carried: in a text, too, the number must be one of its type.
  double next(const Ply_property& property)
  {
    const double x = next(property.type);
    if (format_ != Ply_format::ascii || property.type == Scalar_type::float64) return x;
    const double rounded = nearest(property.type, x);
    const bool is_integer = traits(property.type).is_integer;
    if (is_integer ? rounded == x : std::isfinite(rounded) || !std::isfinite(x)) return rounded;
    text_.fail(formatted("%.17g does not fit into '", x) + Text_reader::printable(property.name) +
               "', which is of type " + description(property.type));
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

#endif // PN_SUBDIVIDE_PLY_HEADER_H
