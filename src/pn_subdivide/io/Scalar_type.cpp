// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Scalar_type.h"

#include <cmath>
#include <cstdio>

namespace pn_subdivide {

const Scalar_traits& traits(Scalar_type type)
{
  // in the order of the enumerators
  static const Scalar_traits table[] = {
    {"char", "int8", "Int8", 1, true, -128, 127},
    {"uchar", "uint8", "UInt8", 1, true, 0, 255},
    {"short", "int16", "Int16", 2, true, -32768, 32767},
    {"ushort", "uint16", "UInt16", 2, true, 0, 65535},
    {"int", "int32", "Int32", 4, true, -2147483648., 2147483647},
    {"uint", "uint32", "UInt32", 4, true, 0, 4294967295.},
    {"float", "float32", "Float32", 4, false, 0, 0},
    {"double", "float64", "Float64", 8, false, 0, 0}};
  return table[static_cast<std::size_t>(type)];
}

std::string description(Scalar_type type)
{
  const Scalar_traits& t = traits(type);
  if (!t.is_integer) return t.ply;
  char range[80];
  std::snprintf(range, sizeof range, " (whole numbers from %.0f to %.0f)", t.lowest, t.highest);
  return t.ply + std::string(range);
}

double nearest(Scalar_type type, double x)
{
  if (type == Scalar_type::float64) return x;
  if (type == Scalar_type::float32) return static_cast<double>(static_cast<float>(x));
  const Scalar_traits& t = traits(type);
  if (!(x > t.lowest)) return t.lowest;
  return x < t.highest ? std::floor(x + 0.5) : t.highest;
}

} // namespace pn_subdivide
