// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/vertex_curvature.h"

#include "io/Error.h"
#include "io/Text_reader.h"
#include "surface/refine_surface.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#if __has_include(<Eigen/Core>)
#  include <CGAL/PN_limit_surface_3/estimate_curvature.h>

#  include <boost/property_map/property_map.hpp>
#endif

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

const char* name_of(Curvature_kind kind)
{
  return kind == Curvature_kind::gaussian ? "gaussian_curvature" : "mean_curvature";
}

// The value at the end of the colors: a few vertices with large values, at extraordinary vertices
// say, must not make the others pale. What is flat but for rounding remains so.
double end_of_colors(const Mesh_data& mesh, const std::vector<double>& values, Curvature_kind kind)
{
  constexpr double share_within = 0.9, flat = 1e-9;
  std::vector<double> sizes;
  for (const double x : values) sizes.push_back(std::abs(x));
  if (sizes.empty()) return 1;
  const auto rank = static_cast<std::ptrdiff_t>(share_within * double(sizes.size() - 1));
  std::nth_element(sizes.begin(), sizes.begin() + rank, sizes.end());
  const double diameter = diagonal_of(Bounding_box(mesh.points));
  const double least = kind == Curvature_kind::mean ? flat / diameter : flat / diameter / diameter;
  const double end = sizes[static_cast<std::size_t>(rank)];
  if (end > least) return end;
  return least > 0 && std::isfinite(least) ? least : 1;
}

#if __has_include(<Eigen/Core>)
// Writes the curvature that is asked for, and nothing else.
struct Scalar_map
{
  using key_type = Vertex;
  using value_type = PN::Vertex_curvature<Kernel>;
  using reference = void;
  using category = boost::writable_property_map_tag;

  friend void put(const Scalar_map& map, key_type v, const value_type& c)
  {
    map.result->values[v] = map.kind == Curvature_kind::gaussian ? c.gaussian : c.mean;
    if (!c.is_estimated) ++map.result->without_estimate;
  }

  Curvature_values* result;
  Curvature_kind kind;
};
#endif

Curvature_values measure(const Surface& surface, Curvature_kind kind)
{
  Curvature_values result;
#if __has_include(<Eigen/Core>)
  result.values.resize(surface.number_of_vertices());
  using Tag = CGAL::Parallel_if_available_tag;
  const Scalar_map map{&result, kind};
  if (const std::optional<Normal_map> normals = normals_of(surface))
    PN::estimate_curvature<Tag>(surface, map, CGAL::parameters::vertex_normal_map(*normals));
  else
    PN::estimate_curvature<Tag>(surface, map);
#else
  (void)surface;
  (void)kind;
#endif
  return result;
}

// Each wedge has a vertex of its own, with its normal.
Surface cut_between(const Surface& surface, const Wedges& wedges)
{
  const std::optional<Normal_map> normals = normals_of(surface);
  const std::optional<Corner_normal_map> of_corners = corner_normals_of(surface);
  Mesh_data mesh;
  for (const Vertex v : wedges.vertex) mesh.points.push_back(to_triple(surface.point(v)));
  if (normals) mesh.normals.resize(mesh.points.size());
  std::vector<std::size_t> face;
  for (const Face f : surface.faces()) {
    face.clear();
    for (const auto h : halfedges_around_face(surface.halfedge(f), surface)) {
      face.push_back(wedges.of_corner[h]);
      if (normals)
        mesh.normals[face.back()] =
          to_triple(of_corners ? (*of_corners)[h] : (*normals)[surface.target(h)]);
    }
    mesh.add_face(face);
  }
  return make_surface(mesh);
}

Curvature_values means_of_wedges(const Curvature_values& of_wedges, const Wedges& wedges)
{
  Curvature_values result;
  result.values.assign(wedges.number.size(), 0.);
  result.without_estimate = of_wedges.without_estimate;
  for (std::size_t w = 0; w < wedges.vertex.size(); ++w) {
    const std::size_t v = wedges.vertex[w];
    result.values[v] += of_wedges.values[w] / double(wedges.number[v]);
  }
  result.without_estimate +=
    std::size_t(std::count(wedges.number.begin(), wedges.number.end(), std::size_t(0)));
  return result;
}

// Whether there was any.
bool remove_color_and(const std::string& name, Columns& columns)
{
  std::vector<std::string> names = {name};
  for (const Column* channel : find_color(columns)) names.push_back(channel->name);
  return remove_columns(columns, names);
}

Columns color_columns(const std::vector<double>& values, double end)
{
  Columns columns;
  for (const char* const name : {"red", "green", "blue"})
    columns.push_back({name, Scalar_type::uint8, {}, {}});
  for (Column& channel : columns) channel.values.reserve(values.size());
  for (const double x : values) {
    const Color color = diverging_color(x / end);
    for (std::size_t i = 0; i < 3; ++i) columns[i].values.push_back(color[i]);
  }
  return columns;
}

// Where squares of curvatures are numbers.
void require_size_for_curvature(const Surface& surface)
{
  constexpr int largest_exponent = 450;
  CGAL::Bbox_3 box;
  for (const Point_3& p : surface.points()) box += p.bbox();
  const double size = (std::max)({box.x_span(), box.y_span(), box.z_span()});
  if (!(size > 0) || std::abs(std::ilogb(size)) <= largest_exponent) return;
  throw Error(formatted(
    "--curvature: the mesh has a size of %.3g, and curvatures are measured between 1e-135 "
    "and 1e135 only: scale its coordinates",
    size));
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

Curvature_kind parse_curvature_option(const std::string& text, const Mesh_file& output)
{
#if !__has_include(<Eigen/Core>)
  throw Usage_error("--curvature: this program was built without Eigen");
#endif
  const auto kind = parse_word<Curvature_kind>(
    "--curvature", text, {{"gaussian", Curvature_kind::gaussian}, {"mean", Curvature_kind::mean}});
  if (!held_by(output).scalars)
    throw Usage_error("--curvature: " + output.title("standard output") + " (" + output.format +
                      ") cannot hold it, only .ply and .vtp can");
  return kind;
}

std::string Curvature_range::description(Curvature_kind kind) const
{
  const std::string text =
    formatted("%s curvature from %.4g to %.4g, colors from %.4g to %.4g",
              kind == Curvature_kind::gaussian ? "Gaussian" : "mean", least, greatest, -end, end);
  if (without_estimate == 0) return text;
  return text + "; " + std::to_string(without_estimate) +
         " vertices allow no estimate (too few neighbors, no area or out of range) and get 0";
}

Curvature_values measure_curvature(const Surface& surface,
                                   const std::optional<Crease_maps>& creases, Curvature_kind kind)
{
  require_size_for_curvature(surface);
  if (!creases) return measure(surface, kind);
  const Wedges wedges(surface, [&](Edge e) { return creases->edges[e] > 0; });
  return means_of_wedges(measure(cut_between(surface, wedges), kind), wedges);
}

Curvature_values measure_limit_curvature(Surface mesh, const Wedge_list& wedges,
                                         const Scheme_choice& scheme,
                                         const std::optional<Crease_maps>& creases, unsigned levels,
                                         Curvature_kind kind)
{
  require_size_for_curvature(mesh);
  if (!wedges.empty()) put_corner_normals(mesh, wedges);
  const std::optional<Crease_maps> of_copy = creases_of(mesh, creases);
  if (!move_to_surface(mesh, scheme, of_copy, levels)) remove_normals(mesh);
  return measure_curvature(mesh, of_copy, kind);
}

Curvature_range set_curvature(Mesh_data& mesh, Curvature_kind kind, Curvature_values curvature)
{
  Columns& columns = mesh.attributes.of_vertices;
  Curvature_range range;
  range.replaces_attributes = remove_color_and(name_of(kind), columns);
  range.without_estimate = curvature.without_estimate;
  const std::vector<double>& values = curvature.values;
  range.end = end_of_colors(mesh, values, kind);
  Columns added = color_columns(values, range.end);
  const auto ends = std::minmax_element(values.begin(), values.end());
  if (!values.empty()) {
    range.least = *ends.first;
    range.greatest = *ends.second;
  }
  added.insert(added.begin(),
               {name_of(kind), Scalar_type::float64, std::move(curvature.values), {}});
  columns.insert(columns.begin(), std::make_move_iterator(added.begin()),
                 std::make_move_iterator(added.end()));
  return range;
}

} // namespace pn_subdivide
