// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/types_of_format.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pn_subdivide {
namespace {

bool is_float(double x)
{
  return !(std::abs(x) > std::numeric_limits<float>::max());
}

bool has_no_type(const Column* column)
{
  return !column->has_type_of_file && column->type == Scalar_type::float64;
}

// Fractions of 1 become bytes.
void make_bytes(const Column_group& color, Columns& columns)
{
  if (!std::all_of(color.begin(), color.end(), has_no_type)) return;
  for (Column& column : columns) {
    if (std::find(color.begin(), color.end(), &column) == color.end()) continue;
    column.type = Scalar_type::uint8;
    for (double& x : column.values) x = nearest(Scalar_type::uint8, 255 * x);
  }
}

void make_floats(const Column_group& texture, Columns& columns)
{
  const auto holds_floats = [](const Column* column) {
    return has_no_type(column) &&
           std::all_of(column->values.begin(), column->values.end(), is_float);
  };
  if (!std::all_of(texture.begin(), texture.end(), holds_floats)) return;
  for (Column& column : columns) {
    if (std::find(texture.begin(), texture.end(), &column) == texture.end()) continue;
    column.type = Scalar_type::float32;
    for (double& x : column.values) x = nearest(Scalar_type::float32, x);
  }
}

void make_floats_of_corners(Attributes& attributes)
{
  if (attributes.has_texture_type_of_file) return;
  for (const Texture_point& t : attributes.texture)
    if (!std::all_of(t.begin(), t.end(), is_float)) return;
  attributes.texture_type = Scalar_type::float32;
  for (Texture_point& t : attributes.texture)
    for (double& x : t) x = nearest(Scalar_type::float32, x);
}

} // namespace

void take_types_of_format(const Mesh_file& output, Attributes& attributes)
{
  if (!holds_scalars(output)) return;
  make_bytes(find_color(attributes.of_vertices), attributes.of_vertices);
  make_bytes(find_color(attributes.of_faces), attributes.of_faces);
  make_floats(find_texture(attributes.of_vertices), attributes.of_vertices);
  make_floats_of_corners(attributes);
}

} // namespace pn_subdivide
