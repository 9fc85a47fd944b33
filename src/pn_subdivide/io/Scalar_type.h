// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SCALAR_TYPE_H
#define PN_SUBDIVIDE_SCALAR_TYPE_H

#include <cstddef>
#include <cstdint>
#include <string>

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

// x must be a number of the type.
template <class Output>
void write_little_endian(Output& out, Scalar_type type, double x)
{
  switch (type) {
  case Scalar_type::int8:
    return out.little_endian(static_cast<std::int8_t>(x));
  case Scalar_type::uint8:
    return out.little_endian(static_cast<std::uint8_t>(x));
  case Scalar_type::int16:
    return out.little_endian(static_cast<std::int16_t>(x));
  case Scalar_type::uint16:
    return out.little_endian(static_cast<std::uint16_t>(x));
  case Scalar_type::int32:
    return out.little_endian(static_cast<std::int32_t>(x));
  case Scalar_type::uint32:
    return out.little_endian(static_cast<std::uint32_t>(x));
  case Scalar_type::float32:
    return out.little_endian(static_cast<float>(x));
  case Scalar_type::float64:
    break;
  }
  out.little_endian(x);
}

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SCALAR_TYPE_H
