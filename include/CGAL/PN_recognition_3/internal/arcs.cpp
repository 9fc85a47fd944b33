// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/recognition_interface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal::recognition {

// Cuts a polygon into the lines and arcs that it has been made of. As of surfaces, points are on them up to the rounding of
// the file: a run of three points is extended as long as they are on its line or circle up to the tolerance, and
// believed in if more points are on it than would be on any, and the next ones are clearly not.
class Arc_finder
{
public:
  using Point = std::array<double, 2>;

  Arc_finder(std::vector<Point> points, bool closed, double tolerance, unsigned min_facets)
    : points_(std::move(points))
    , closed_(closed)
    , tolerance_(tolerance)
    , min_facets_(min_facets)
    , n_(Index(points_.size()))
    , edges_(closed ? n_ : n_ - 1)
    , is_flat_(points_.size(), false)
    , owner_(points_.size(), -1)
  {}

  std::vector<Arc_run> operator()()
  {
    if (n_ < 2) return {};
    if (n_ < 3) return {Arc_run{Kind::unknown, 0, edges_}};
    find(Kind::line);
    find(Kind::circle);
    choose();
    drop_accidents();
    return pieces();
  }

private:
  using Index = std::ptrdiff_t;
  using Kind = Arc_run::Kind;

  static constexpr double pi = 3.14159265358979323846;
  static double greatest_step() { return radians(61); }

  const Point& at(Index i) const { return points_[std::size_t((i % n_ + n_) % n_)]; }
  std::size_t edge_number(Index i) const { return std::size_t((i % n_ + n_) % n_); }
  Point edge(Index i) const { return {at(i + 1)[0] - at(i)[0], at(i + 1)[1] - at(i)[1]}; }
  double length(Index i) const { return std::hypot(edge(i)[0], edge(i)[1]); }
  bool is_edge(Index i) const { return closed_ || (i >= 0 && i < edges_); }
  // the angle by which the polygon turns to the left at a vertex between two edges
  double turn(Index i) const
  {
    const Point a = edge(i - 1), b = edge(i);
    return std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
  }

  // --- fits ---

  static double distance(const Arc_run& run, const Point& p)
  {
    const double x = p[0] - run.center[0], y = p[1] - run.center[1];
    return run.kind == Kind::line ? std::abs(run.direction[0] * y - run.direction[1] * x)
                                  : std::abs(std::hypot(x, y) - run.radius);
  }
  bool fit_line(Arc_run& run) const
  {
    // across its longest chord
    const Point &a = at(run.first), &b = at(run.last);
    const double h = std::hypot(b[0] - a[0], b[1] - a[1]);
    if (!(h > 0)) return false;
    const Point u{(b[0] - a[0]) / h, (b[1] - a[1]) / h};
    Least_squares system(2);
    for (Index i = run.first; i <= run.last; ++i) {
      const double x = at(i)[0] - a[0], y = at(i)[1] - a[1];
      system.add({1, u[0] * x + u[1] * y}, u[0] * y - u[1] * x);
    }
    const auto x = system.solve();
    const double c = 1 / std::hypot(1., x[1]), s = x[1] * c;
    run.direction = {c * u[0] - s * u[1], c * u[1] + s * u[0]};
    run.center = {a[0] - x[0] * u[1], a[1] + x[0] * u[0]};
    return true;
  }

  // the circle of which the points have the least sum of squared powers
  bool fit_circle(Arc_run& run) const
  {
    const Point& o = at(run.first);
    Least_squares powers(3);
    for_each_point(run, [&](const Point& p) {
      const double x = p[0] - o[0], y = p[1] - o[1];
      powers.add({2 * x, 2 * y, 1}, x * x + y * y);
    });
    const auto x = powers.solve();
    run.radius = std::sqrt(x[2] + x[0] * x[0] + x[1] * x[1]);
    run.center = {o[0] + x[0], o[1] + x[1]};
    return run.radius > 0 && run.radius < 50;
  }
  template <class Function>
  void for_each_point(const Arc_run& run, const Function& f) const
  {
    const Index end = run.edges() == n_ ? run.last - 1 : run.last;
    for (Index i = run.first; i <= end; ++i) f(at(i));
  }

  // --- growing ---

  // whether the run may go on with this edge, or, for the first ones, consist of it
  bool may_have(const Arc_run& run, Index e, double side) const
  {
    if (run.kind == Kind::line) {
      const Point d = edge(e);
      return side * (d[0] * run.direction[0] + d[1] * run.direction[1]) > 0;
    }
    if (is_flat_[edge_number(e)]) return false;
    const Point d = edge(e);
    const double x = at(e)[0] + d[0] / 2 - run.center[0], y = at(e)[1] + d[1] / 2 - run.center[1];
    return side * (x * d[1] - y * d[0]) > 0 && length(e) <= longest_chord(run);
  }
  static double longest_chord(const Arc_run& run)
  {
    return 2 * run.radius * std::sin(greatest_step() / 2);
  }

  Arc_run grown(const Arc_run& seed, double t) const
  {
    Arc_run run = seed;
    double side = 1;
    if (!may_have(run, run.first, side)) side = -1;
    const Index middle = (seed.first + seed.last) / 2;
    run.first = run.last = middle;
    const auto has = [&](Index e, Index end) {
      return is_edge(e) && may_have(run, e, side) && distance(run, at(end)) <= t;
    };
    if (!(distance(run, at(middle)) <= t)) return run;
    while (run.edges() < n_ && has(run.last, run.last + 1)) ++run.last;
    while (run.edges() < n_ && has(run.first - 1, run.first - 1)) --run.first;
    return run;
  }

  bool settle(Arc_run& run) const
  {
    double t = (std::max)(
      2 * tolerance_,
      (std::min)(50 * tolerance_, 0.02 * (std::min)(length(run.first), length(run.first + 1))));
    for (int k = 0; k < 8; ++k) {
      if (!(run.kind == Kind::line ? fit_line(run) : fit_circle(run))) return false;
      const Arc_run next = grown(run, t);
      if (next.edges() < 2) return false;
      const bool repeats = t == tolerance_ && next.first == run.first && next.last == run.last;
      run = next;
      if (repeats) break;
      t = (std::max)(t / 10, tolerance_);
    }
    run.residual = 0;
    for_each_point(
      run, [&](const Point& p) { run.residual = (std::max)(run.residual, distance(run, p)); });
    return run.residual <= tolerance_;
  }

  double step(const Arc_run& run, Index e) const
  {
    return 2 * std::asin((std::min)(1., length(e) / (2 * run.radius)));
  }

  // --- evidence ---

  bool is_over_determined(const Arc_run& run) const
  {
    if (run.edges() < n_ && !(ends_clearly(run, run.last, run.last + 1) &&
                              ends_clearly(run, run.first - 1, run.first - 1)))
      return false;
    if (run.kind == Kind::line) return true;
    const Index points = run.edges() + (run.edges() < n_);
    double least = run.widest;
    for (Index e = run.first; e < run.last; ++e) least = (std::min)(least, step(run, e));
    const double sagitta = run.radius * (1 - std::cos(run.widest / 2));
    if (sagitta < 2 * tolerance_) return false;
    const int ends =
      is_tangent(run, run.first - 1, run.first) + is_tangent(run, run.last, run.last);
    if (points <= 5 && ends == 0 && run.widest > 1.75 * least) return false;
    return points + ends >= 5; // a trapezoid of equal legs is on a circle anyway
  }

  // Free-form curves leave a circle or a line little by little: a cubic through five points is off at the sixth by seven times as
  // much as at any of the five.
  bool ends_clearly(const Arc_run& run, Index e, Index beyond) const
  {
    if (!is_edge(e) || (run.kind == Kind::circle && is_flat_[edge_number(e)])) return true;
    if (run.kind == Kind::circle && length(e) > longest_chord(run)) return true;
    const double mean = mean_length(run), ratio = length(e) / mean;
    return ratio > 4 ||
           distance(run, at(beyond)) > 60 * (std::max)(1., ratio * ratio) * run.residual;
  }
  double mean_length(const Arc_run& run) const
  {
    double sum = 0;
    for (Index e = run.first; e < run.last; ++e) sum += length(e);
    return sum / double(run.edges());
  }

  // whether an edge outside goes on along the tangent at an end
  bool is_tangent(const Arc_run& run, Index e, Index end) const
  {
    if (!is_edge(e) || run.edges() >= n_) return false;
    const Point d = edge(e);
    const double x = at(end)[0] - run.center[0], y = at(end)[1] - run.center[1];
    const double angle = 8 * tolerance_ / (std::min)(length(e), mean_length(run));
    return std::abs(d[0] * x + d[1] * y) <=
           (std::min)({radians(0.5), run.widest / 8, angle}) * length(e) * run.radius;
  }

  bool is_round(const Arc_run& run) const
  {
    return run.widest * min_facets_ <= 2 * pi * (1 + 1e-9) ||
           (is_tangent(run, run.first - 1, run.first) && is_tangent(run, run.last, run.last));
  }

  std::vector<Arc_run> lines(Index first, Index last) const
  {
    std::vector<Arc_run> result;
    for (Index i = first; i < last; ++i) {
      Arc_run run{Kind::line, i, i + 1};
      fit_line(run);
      result.push_back(run);
    }
    return result;
  }

  // --- finding ---

  void find(Kind kind)
  {
    std::vector<bool> is_known(points_.size(), false);
    for (Index i = closed_ ? 0 : 1; i < edges_; ++i) {
      if (is_known[edge_number(i - 1)] && is_known[edge_number(i)]) continue;
      Arc_run run{kind, i - 1, i + 1};
      if (std::abs(turn(i)) > greatest_step() || !settle(run)) continue;
      new_flats_.clear();
      if (!take_flats_out(run) || !is_over_determined(run)) {
        for (const Index e : new_flats_) is_flat_[edge_number(e)] = false;
        i += run.edges() / 8; // its neighbors lead to the same
        continue;
      }
      for (Index e = run.first; e < run.last; ++e) is_known[edge_number(e)] = true;
      found_.push_back(run);
    }
  }

  // Few chords that are much longer than all others are lines: tessellators halve steps, they do not double them.
  bool take_flats_out(Arc_run& run)
  {
    if (run.kind == Kind::line) return true;
    double widest = 0, next = 0;
    for (Index e = run.first; e < run.last; ++e) widest = (std::max)(widest, step(run, e));
    std::vector<Index> flats;
    for (Index e = run.first; e < run.last; ++e)
      if (step(run, e) >= 0.9 * widest)
        flats.push_back(e);
      else
        next = (std::max)(next, step(run, e));
    const auto number = Index(flats.size());
    run.widest = widest;
    if (number == run.edges() || !(number <= 2 || 10 * number <= run.edges()) ||
        !(widest > 1.75 * next))
      return true;
    for (const Index e : flats) is_flat_[edge_number(e)] = true;
    new_flats_.insert(new_flats_.end(), flats.begin(), flats.end());
    return take_rest(run, flats);
  }
  bool take_rest(Arc_run& run, std::vector<Index> flats)
  {
    const bool is_full = run.edges() == n_;
    flats.push_back(is_full ? flats.front() + n_ : run.last);
    Index from = is_full ? flats.front() + 1 : run.first;
    Arc_run best = run;
    best.first = best.last = from;
    for (const Index e : flats) {
      if (e - from > best.edges()) {
        best.first = from;
        best.last = e;
      }
      from = e + 1;
    }
    run = best;
    return run.edges() >= 2 && settle(run) && take_flats_out(run);
  }

  // --- choice ---

  void choose()
  {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Arc_run& a, const Arc_run& b) { return a.edges() > b.edges(); });
    for (Arc_run& run : found_) {
      give_way(run);
      if (run.edges() < 2) continue;
      for (Index e = run.first; e < run.last; ++e) owner_[edge_number(e)] = Index(chosen_.size());
      chosen_.push_back(run);
    }
  }
  // Three points are on a line by accident now and then, five on a circle.
  void drop_accidents()
  {
    const auto goes_on = [&](Index i, Index e) {
      return is_edge(e) && owner_[edge_number(e)] < 0 && std::abs(turn(i)) <= greatest_step();
    };
    for (const Arc_run& run : chosen_) {
      const bool is_short = run.kind == Kind::line
                              ? run.edges() == 2
                              : run.edges() <= 5 && !is_tangent(run, run.first - 1, run.first) &&
                                  !is_tangent(run, run.last, run.last);
      if (!is_short || !goes_on(run.first, run.first - 1) || !goes_on(run.last, run.last)) continue;
      for (Index e = run.first; e < run.last; ++e) owner_[edge_number(e)] = -1;
    }
  }
  // At their ends two runs may share edges, whose points are on both: they meet where the sum of the distances is least.
  void give_way(Arc_run& run)
  {
    while (run.edges() > 0 && owner_[edge_number(run.first)] >= 0) ++run.first;
    while (run.edges() > 0 && owner_[edge_number(run.last - 1)] >= 0) --run.last;
    for (Index e = run.first; e < run.last; ++e)
      if (owner_[edge_number(e)] >= 0) run.last = e;
  }

  // --- the rest ---

  bool is_corner(Index i) const
  {
    if (!closed_ && (i == 0 || i == n_ - 1)) return true;
    return owner_[edge_number(i - 1)] != owner_[edge_number(i)] ||
           (owner_[edge_number(i)] < 0 && std::abs(turn(i)) > greatest_step());
  }

  std::vector<Arc_run> pieces()
  {
    std::vector<Index> corners;
    for (Index i = 0; i < n_; ++i)
      if (is_corner(i)) corners.push_back(i);
    if (corners.empty()) corners.push_back(0);
    if (closed_) corners.push_back(corners.front() + n_);
    std::vector<Arc_run> result;
    const bool has_owner =
      std::any_of(owner_.begin(), owner_.end(), [](Index owner) { return owner >= 0; });
    bool is_known = has_owner;
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      result.push_back(piece(corners[k], corners[k + 1]));
      is_known = is_known || result.back().edges() > 1;
    }
    if (!is_known) return lines(0, edges_); // corners everywhere
    if (!has_owner) return {Arc_run{Kind::unknown, 0, edges_}};
    std::vector<Arc_run> all;
    for (const Arc_run& run : result)
      if ((run.kind == Kind::circle && !is_round(run)) ||
          (run.kind == Kind::unknown && run.edges() <= 2)) {
        const std::vector<Arc_run> more = lines(run.first, run.last);
        all.insert(all.end(), more.begin(), more.end());
      } else
        all.push_back(run);
    return all;
  }
  Arc_run piece(Index first, Index last) const
  {
    const Index owner = owner_[edge_number(first)];
    Arc_run run = owner < 0 ? Arc_run() : chosen_[std::size_t(owner)];
    run.first = first;
    run.last = last;
    return run;
  }

  std::vector<Point> points_;
  bool closed_;
  double tolerance_;
  unsigned min_facets_;
  Index n_, edges_;
  std::vector<bool> is_flat_; // edges that are on no circle
  std::vector<Index> owner_, new_flats_;
  std::vector<Arc_run> found_, chosen_;
};

CGAL_PN_RECOGNITION_3_INLINE std::vector<Arc_run>
find_arcs(std::vector<std::array<double, 2>> points, bool closed, double tolerance,
          unsigned min_facets)
{
  Arc_finder find(std::move(points), closed, tolerance, min_facets);
  return find();
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
