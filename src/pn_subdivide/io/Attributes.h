// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_ATTRIBUTES_H
#define PN_SUBDIVIDE_ATTRIBUTES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pn_subdivide {

// The types of numbers in files. Every number of them fits into a double.
enum class Scalar_type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Scalar_traits
{
  const char *ply, *other_ply; // the names of the type
  const char* vtk;
  std::size_t bytes;
  bool is_integer;
  double lowest, highest; // of integers
};

const Scalar_traits& traits(Scalar_type type);

// As in "uchar (whole numbers from 0 to 255)".
std::string description(Scalar_type type);

// The number of the type that is nearest; numbers out of range become the lowest or highest.
double nearest(Scalar_type type, double x);

// f(a number of the type)
template <class Function>
auto with_type(Scalar_type type, const Function& f)
{
  switch (type) {
  case Scalar_type::int8:
    return f(std::int8_t());
  case Scalar_type::uint8:
    return f(std::uint8_t());
  case Scalar_type::int16:
    return f(std::int16_t());
  case Scalar_type::uint16:
    return f(std::uint16_t());
  case Scalar_type::int32:
    return f(std::int32_t());
  case Scalar_type::uint32:
    return f(std::uint32_t());
  case Scalar_type::float32:
    return f(float());
  case Scalar_type::float64:
    break;
  }
  return f(double());
}

// x must be a number of the type.
template <class Output>
void write_little_endian(Output& out, Scalar_type type, double x)
{
  with_type(type, [&](auto number) { out.little_endian(static_cast<decltype(number)>(x)); });
}

// Behind what is wrong with an attribute.
inline const char* const reading_without_it = "; --drop-attributes reads the file without it";

// The last number is 0 in the plane. Where there is none, all three are NaN.
using Texture_point = std::array<double, 3>;

bool is_none(const Texture_point& t);
// An order in which all that are none are equal and behind the others.
bool is_less(const Texture_point& a, const Texture_point& b);
bool are_equal(const Texture_point& a, const Texture_point& b);

// A number for each vertex, or for each face, as a file has it.
struct Column
{
  std::string name;
  Scalar_type type = Scalar_type::float64;
  std::vector<double> values = {}; // of the type
  // Where the values stand for words, as materials and groups do: those of 0, 1, and so on. Others
  // stand for nothing.
  std::vector<std::string> words = {};
  bool has_type_of_file = false; // otherwise it is that of the numbers in memory
  bool is_label = false;         // of vertices: no number between two others is one
};

using Columns = std::vector<Column>;
using Column_group = std::vector<const Column*>;

// What a file says of vertices, faces and corners besides points and normals.
struct Attributes
{
  Columns of_vertices, of_faces;
  std::vector<std::array<std::string, 3>> directions; // names of columns of vertices

  // Texture coordinates of the corners, face by face, or empty.
  std::vector<Texture_point> texture;
  Scalar_type texture_type = Scalar_type::float64;
  bool has_texture_type_of_file = false;

  std::vector<std::string> texture_files, material_files; // as the file names them

  bool empty() const { return of_vertices.empty() && of_faces.empty() && texture.empty(); }
};

// Is there a texture point that is not in the plane?
bool has_depth(const std::vector<Texture_point>& texture);

// Is it one of these?
inline bool contains(const Column_group& group, const Column& column)
{
  return std::find(group.begin(), group.end(), &column) != group.end();
}

// nullptr if there is none
const Column* find_column(const Columns& columns, const std::string& name);

// Removes those of these names; returns whether there was any.
bool remove_columns(Columns& columns, const std::vector<std::string>& names);

// What a value that is not negative stands for, or its digits.
std::string word_of(const Column& column, double value);

// The columns of a color: red, green, blue and perhaps alpha, of one type. Empty if there is none.
Column_group find_color(const Columns& columns);

// Is it one of bytes, or of fractions from 0 to 1, as text files have it?
bool is_plain_color(const Column_group& color);

// The columns of texture coordinates of vertices: s and t, u and v, or texture_u and texture_v. Empty
// if there are none.
Column_group find_texture(const Columns& columns);

// Element i gets what element rows[i] had.
template <class T, class Index>
void select(std::vector<T>& values, const std::vector<Index>& rows)
{
  if (values.empty()) return;
  std::vector<T> selected;
  selected.reserve(rows.size());
  for (const Index i : rows) selected.push_back(values[static_cast<std::size_t>(i)]);
  values = std::move(selected);
}

template <class Index>
void select(Columns& columns, const std::vector<Index>& rows)
{
  for (Column& column : columns) select(column.values, rows);
}

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_ATTRIBUTES_H
