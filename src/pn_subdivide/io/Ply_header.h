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
#include "io/Mesh_data.h"
#include "io/Text_reader.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
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

constexpr const char* edge_properties[] = {"vertex1", "vertex2", "sharpness", "t1x", "t1y",
                                           "t1z",     "t2x",     "t2y",       "t2z"};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PLY_HEADER_H
