// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/Part.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>

#include <cstdio>
#include <cstdlib>
#include <tuple>

namespace CGAL::PN_subdivision_3::internal::recognition {

// --- data ---

inline void sort_numbers(std::vector<Index>& numbers, Function_ref<bool(Index, Index)> is_before)
{
  std::stable_sort(numbers.begin(), numbers.end(), is_before);
}

inline Lists::Lists(Index lists, const std::vector<std::pair<Index, Index>>& pairs)
  : begin_(lists + 1, 0)
  , items_(pairs.size())
{
  for (const auto& p : pairs) ++begin_[p.first + 1];
  for (Index i = 0; i < lists; ++i) begin_[i + 1] += begin_[i];
  std::vector<Index> at(begin_.begin(), begin_.end() - 1);
  for (const auto& p : pairs) items_[at[p.first]++] = p.second;
}

inline double Part::height(Index f, Index g) const
{
  double result = 0;
  for (const Index v : corners[f])
    result = (std::max)(result, std::abs(dot(normal[g], points[v] - points[corners[g][0]])));
  return result;
}

inline bool Part::is_nearly_flat(const Edge& e, double cosine, double greatest_height) const
{
  return e.g != null && !is_sliver(e.f) && !is_sliver(e.g) &&
         dot(normal[e.f], normal[e.g]) > cosine &&
         (height(e.f, e.g) <= greatest_height || height(e.g, e.f) <= greatest_height);
}

// --- the rounding of a file ---

inline bool is_float(double x)
{
  return x == double(float(x));
}

inline bool has_decimal_form(double x, const char* format, int digits)
{
  char text[400];
  if (std::snprintf(text, sizeof text, format, digits, x) >= int(sizeof text)) return false;
  return std::strtod(text, nullptr) == x;
}

CGAL_PN_RECOGNITION_3_INLINE double file_rounding(const std::vector<double>& x)
{
  double largest = 0;
  bool are_floats = true;
  for (const double c : x) {
    largest = (std::max)(largest, std::abs(c));
    are_floats = are_floats && is_float(c);
  }
  if (are_floats) return std::ldexp(largest, -24);
  const auto all_but_one_percent_have = [&](const char* format, int digits) {
    std::size_t others = 0;
    for (const double c : x)
      if (!has_decimal_form(c, format, digits) && 100 * ++others > x.size()) return false;
    return true;
  };
  for (int digits = 5; digits <= 9; ++digits)
    if (all_but_one_percent_have("%.*e", digits - 1))
      return 0.5 * std::pow(10., std::floor(std::log10(largest)) - digits + 1);
  for (int digits = 3; digits <= 7; ++digits)
    if (all_but_one_percent_have("%.*f", digits)) return 0.5 * std::pow(10., -digits);
  return std::ldexp(largest, -50);
}

// --- how a part is made ---

class Make_part
{
public:
  Part operator()(const Level_connectivity& level, const Points& points, double tolerance)
  {
    sort_vertices(level, points);
    scale_points(points);
    choose_tolerance(points, tolerance);
    sort_faces(level);
    make_edges(level);
    measure_faces();
    if (has_all_digits_ && widen_tolerance()) measure_faces();
    part_.rank_of_vertex = std::move(rank_);
    part_.rank_of_face = std::move(face_rank_);
    return std::move(part_);
  }

private:
  void sort_vertices(const Level_connectivity& level, const Points& points)
  {
    for (Index v = 0; v < level.number_of_vertices(); ++v)
      if (!level.is_isolated(v)) order_.push_back(v);
    sort_numbers(order_, [&](Index v, Index w) { return points[v] < points[w]; });
    rank_.assign(level.number_of_vertices(), null);
    for (Index i = 0; i < order_.size(); ++i) rank_[order_[i]] = i;
  }

  // scales by powers of two, in two steps so that nothing overflows
  void scale_points(const Points& points)
  {
    for (const Index v : order_)
      for (const double x : points[v]) largest_ = (std::max)(largest_, std::abs(x));
    int exponent = largest_ > 0 ? std::ilogb(largest_) : 0;
    Vec3 low{4, 4, 4}, high{-4, -4, -4};
    for (const Index v : order_) {
      const auto& x = points[v];
      const Vec3 p{std::ldexp(x[0], -exponent), std::ldexp(x[1], -exponent),
                   std::ldexp(x[2], -exponent)};
      part_.points.push_back(p);
      low = {(std::min)(low[0], p[0]), (std::min)(low[1], p[1]), (std::min)(low[2], p[2])};
      high = {(std::max)(high[0], p[0]), (std::max)(high[1], p[1]), (std::max)(high[2], p[2])};
    }
    if (order_.empty()) return;
    const double diagonal = norm(high - low);
    const int further = diagonal > 0 ? std::ilogb(diagonal) : 0;
    const Vec3 middle = low + 0.5 * (high - low);
    for (Vec3& p : part_.points) p = std::ldexp(1., -further) * (p - middle);
    part_.size = std::ldexp(diagonal, -further);
    part_.scale = std::ldexp(1., exponent + further);
    part_.shift = std::ldexp(1., exponent) * middle;
  }

  void choose_tolerance(const Points& points, double tolerance)
  {
    constexpr std::size_t most = 1000;
    std::vector<double> some;
    const std::size_t stride = order_.size() / most + 1;
    for (std::size_t i = 0; i < order_.size(); i += stride)
      for (const double x : points[order_[i]]) some.push_back(x);
    some.push_back(largest_);
    const double rounding = file_rounding(some);
    has_all_digits_ = !(tolerance > 0) && rounding < std::ldexp(largest_, -40);
    part_.tolerance =
      tolerance > 0 ? tolerance / part_.scale : 4 * rounding / part_.scale + 1e-7 * part_.size;
  }

  // each face from its least vertex on
  void sort_faces(const Level_connectivity& level)
  {
    std::vector<std::vector<Index>> corners(level.number_of_faces());
    std::vector<Index> order(level.number_of_faces());
    for (Index f = 0; f < corners.size(); ++f) {
      order[f] = f;
      for_each_halfedge_of_face(level, f,
                                [&](Index h) { corners[f].push_back(rank_[level.target(h)]); });
      std::rotate(corners[f].begin(), std::min_element(corners[f].begin(), corners[f].end()),
                  corners[f].end());
    }
    sort_numbers(order, [&](Index f, Index g) { return corners[f] < corners[g]; });
    std::vector<std::pair<Index, Index>> of_faces, of_vertices;
    face_rank_.resize(order.size());
    for (Index i = 0; i < order.size(); ++i) {
      face_rank_[order[i]] = i;
      for (const Index v : corners[order[i]]) {
        of_faces.emplace_back(i, v);
        of_vertices.emplace_back(v, i);
      }
    }
    part_.corners = Lists(Index(order.size()), of_faces);
    part_.faces_around = Lists(Index(part_.points.size()), of_vertices);
  }

  void make_edges(const Level_connectivity& level)
  {
    part_.on_border.assign(part_.points.size(), false);
    for (Index e = 0; e < level.number_of_edges(); ++e) {
      Index h = 2 * e;
      if (level.is_border(h)) ++h;
      const Index o = Level_connectivity::opposite(h);
      Part::Edge edge{rank_[level.source(h)], rank_[level.target(h)], face_rank_[level.face(h)],
                      level.is_border(o) ? null : face_rank_[level.face(o)]};
      if (edge.g == null) part_.on_border[edge.v] = part_.on_border[edge.w] = true;
      if (edge.g < edge.f) {
        std::swap(edge.f, edge.g);
        std::swap(edge.v, edge.w);
      }
      part_.edges.push_back(edge);
    }
    std::sort(part_.edges.begin(), part_.edges.end(), [](const Part::Edge& a, const Part::Edge& b) {
      return std::tie(a.f, a.g, a.v, a.w) < std::tie(b.f, b.g, b.v, b.w);
    });
  }

  // Other programs move and scale files of few digits, and write all digits then; their planes keep the rounding. It is that of
  // the heights of faces over their neighbors if these are many, little, as different as by accident, and clearly less than
  // all bends.
  bool widen_tolerance()
  {
    const double least = (std::max)(1e-12 * part_.size, std::ldexp(largest_ / part_.scale, -46));
    std::vector<double> heights;
    for (const Part::Edge& e : part_.edges) {
      if (!part_.is_nearly_flat(e, std::cos(radians(25)), 1e-3 * part_.size)) continue;
      const double h = (std::min)(part_.height(e.f, e.g), part_.height(e.g, e.f));
      if (h > least) heights.push_back(h);
    }
    std::sort(heights.begin(), heights.end());
    std::size_t n = 8;
    while (n < heights.size() && heights[n] < 20 * heights[n - 1]) ++n;
    if (n > heights.size() || heights[n - 1] > 3e-5 * part_.size) return false;
    const double most = heights[3 * n / 4];
    const double rounding_only = 4 * most + 1e-7 * part_.size;
    if (heights[n / 10] > most / 3 || heights[n / 4] < most / 50 ||
        rounding_only < 2 * part_.tolerance)
      return false;
    part_.tolerance = rounding_only;
    return true;
  }

  void measure_faces()
  {
    part_.area.clear();
    part_.altitude.clear();
    part_.normal.clear();
    for (Index f = 0; f < part_.number_of_faces(); ++f) {
      const Lists::Range c = part_.corners[f];
      const Vec3 origin = part_.points[c[0]];
      Vec3 area;
      double longest = 0;
      for (std::size_t i = 0; i < c.size(); ++i) {
        const Vec3 p = part_.points[c[i]] - origin;
        area += 0.5 * cross(p, part_.points[c[(i + 1) % c.size()]] - origin);
        for (std::size_t j = 0; j < i && (j + 8 > i || c.size() < 16); ++j)
          longest = (std::max)(longest, norm(part_.points[c[i]] - part_.points[c[j]]));
        longest = (std::max)(longest, norm(p));
      }
      const double size = norm(area);
      part_.area.push_back(area);
      part_.altitude.push_back(longest > 0 ? (c.size() == 3 ? 2 : 1) * size / longest : 0);
      part_.normal.push_back(part_.is_sliver(f) ? Vec3() : unit(area));
    }
  }

  Part part_;
  std::vector<Index> order_, rank_, face_rank_;
  double largest_ = 0;
  bool has_all_digits_ = false; // of double
};

inline Part make_part(const Level_connectivity& level, const Points& points, double tolerance)
{
  return Make_part()(level, points, tolerance);
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
