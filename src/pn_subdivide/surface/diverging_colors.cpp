// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/diverging_colors.h"

#include <algorithm>
#include <cmath>

namespace pn_subdivide {
namespace {

using Numbers = std::array<double, 3>;

constexpr Color blue{59, 76, 192}, white{242, 242, 242}, red{180, 4, 38};

// IEC 61966-2-1: sRGB to linear light, and the reverse
double to_linear(double x)
{
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}
double from_linear(double x)
{
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

// CIE 1976 L*a*b* with the white point D65
constexpr Numbers white_point{0.95047, 1, 1.08883};
constexpr double knee = 6. / 29;

double lab_curve(double t)
{
  return t > knee * knee * knee ? std::cbrt(t) : t / (3 * knee * knee) + 4. / 29;
}
double inverse_lab_curve(double t)
{
  return t > knee ? t * t * t : 3 * knee * knee * (t - 4. / 29);
}

Numbers to_lab(const Color& color)
{
  Numbers c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = to_linear(color[k] / 255.);
  const double x = 0.4124564 * c[0] + 0.3575761 * c[1] + 0.1804375 * c[2];
  const double y = 0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2];
  const double z = 0.0193339 * c[0] + 0.1191920 * c[1] + 0.9503041 * c[2];
  const double fx = lab_curve(x / white_point[0]), fy = lab_curve(y / white_point[1]),
               fz = lab_curve(z / white_point[2]);
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

Color from_lab(const Numbers& lab)
{
  const double fy = (lab[0] + 16) / 116;
  const double x = white_point[0] * inverse_lab_curve(fy + lab[1] / 500);
  const double y = white_point[1] * inverse_lab_curve(fy);
  const double z = white_point[2] * inverse_lab_curve(fy - lab[2] / 200);
  const Numbers c{3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
                  -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
                  0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
  Color color;
  for (std::size_t k = 0; k < 3; ++k)
    color[k] = static_cast<std::uint8_t>(std::lround(255 * from_linear(std::clamp(c[k], 0., 1.))));
  return color;
}

} // namespace

Color diverging_color(double value)
{
  static const Numbers ends[] = {to_lab(blue), to_lab(white), to_lab(red)};
  const double t = std::clamp(value, -1., 1.);
  const Numbers &end = t < 0 ? ends[0] : ends[2], &middle = ends[1];
  Numbers lab;
  for (std::size_t k = 0; k < 3; ++k) lab[k] = middle[k] + std::abs(t) * (end[k] - middle[k]);
  return from_lab(lab);
}

} // namespace pn_subdivide
