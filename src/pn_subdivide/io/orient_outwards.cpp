// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/soup_repair.h"

#include "io/Error.h"
#include "io/mesh_normals.h"

#include <boost/math/constants/constants.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pn_subdivide {
namespace {

struct Component
{
  std::vector<std::size_t> faces;
  bool is_closed = true;
  Triple low, high;  // its box
  double volume = 0; // negative if it is inside out; in units of its largest extent
};

// CGAL's orient_to_bound_a_volume() takes triangles only and refuses what crosses itself; here a sum over
// the triangles of which polygons consist tells on which side a point is, whatever they cross.
class Components
{
public:
  explicit Components(const Mesh_data& mesh)
    : mesh_(mesh)
  {
    collect();
    for (Component& c : components_)
      if (c.is_closed) measure(c);
  }

  // oriented the other way than orient_outwards() has it
  std::vector<const Component*> to_be_turned() const
  {
    std::vector<const Component*> result;
    for (const Component& c : components_)
      if (bounds_volume(c) && (c.volume < 0) != is_cavity(c)) result.push_back(&c);
    return result;
  }

  Inside_out inside_out() const
  {
    Inside_out result;
    for (const Component& c : components_)
      if (bounds_volume(c) && c.volume < 0 && !is_cavity(c) && ++result.number == 1)
        result.first_face = c.faces.front();
    return result;
  }

private:
  void collect()
  {
    boost::disjoint_sets_with_storage<> sets(mesh_.points.size());
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) sets.make_set(v);
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f)
      for (const Index v : mesh_.face(f)) sets.union_set(mesh_.face(f).front(), v);
    const auto none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> number(mesh_.points.size(), none); // of a root
    const auto component_of = [&](Index v) -> Component& {
      std::size_t& n = number[sets.find_set(v)];
      if (n == none) {
        n = components_.size();
        components_.emplace_back();
      }
      return components_[n];
    };
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f)
      component_of(mesh_.face(f).front()).faces.push_back(f);
    for (const Border_edge& e : find_defects(mesh_).border) component_of(e[0]).is_closed = false;
  }

  bool is_cavity(const Component& c) const
  {
    const auto others =
      std::count_if(components_.begin(), components_.end(), [&](const Component& other) {
        return &other != &c && bounds_volume(other) && has_box_in(c, other) && lies_in(c, other);
      });
    return others % 2 != 0;
  }

  void measure(Component& c) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    c.low = {infinity, infinity, infinity};
    c.high = {-infinity, -infinity, -infinity};
    for (const std::size_t f : c.faces)
      for (const Index v : mesh_.face(f))
        for (std::size_t k = 0; k < 3; ++k) {
          c.low[k] = (std::min)(c.low[k], mesh_.points[v][k]);
          c.high[k] = (std::max)(c.high[k], mesh_.points[v][k]);
        }
    const double size = size_of(c);
    if (!(size > 0)) return;
    for_each_triangle(c, c.low, size, [&](const Triple& p, const Triple& q, const Triple& r) {
      c.volume += scalar_product(p, cross_product(q, r)) / 6;
    });
  }

  static double size_of(const Component& c)
  {
    const Triple extent = difference(c.high, c.low);
    return (std::max)({extent[0], extent[1], extent[2]});
  }

  // more than rounding
  static bool bounds_volume(const Component& c)
  {
    return c.is_closed && std::abs(c.volume) > 1e-12;
  }

  // The triangles of a fan in each polygon, seen from a point, divided by the size.
  template <class Function>
  void for_each_triangle(const Component& c, const Triple& from, double size,
                         const Function& function) const
  {
    const auto seen = [&](Index v) {
      Triple d = difference(mesh_.points[v], from);
      for (double& x : d) x /= size;
      return d;
    };
    for (const std::size_t f : c.faces) {
      const Mesh_data::Face face = mesh_.face(f);
      const Triple first = seen(face.front());
      Triple before = seen(face[1]);
      for (std::ptrdiff_t i = 2; i < std::ptrdiff_t(face.size()); ++i) {
        const Triple now = seen(face[i]);
        function(first, before, now);
        before = now;
      }
    }
  }

  static bool has_box_in(const Component& inner, const Component& outer)
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (inner.low[k] < outer.low[k] || inner.high[k] > outer.high[k]) return false;
    return true;
  }

  // How often the component goes round a point: the sum of the solid angles of its triangles (van Oosterom and
  // Strackee, 1983), over the full one.
  double winding_number(const Component& c, const Triple& point) const
  {
    constexpr double nothing = 1e-10; // of what is computed from differences, to their product
    double sum = 0;
    for_each_triangle(
      c, point, size_of(c), [&sum](const Triple& p, const Triple& q, const Triple& r) {
        const double a = length(p), b = length(q), d = length(r);
        const double volume = scalar_product(p, cross_product(q, r));
        const double share = a * b * d + scalar_product(p, q) * d + scalar_product(q, r) * a +
                             scalar_product(r, p) * b;
        // on a triangle, rounding would decide on which side: half a turn is left out
        const bool is_on = std::abs(volume) <= nothing * a * b * d && share <= nothing * a * b * d;
        if (!is_on) sum += 2 * std::atan2(volume, share);
      });
    return sum / (4 * boost::math::constants::pi<double>());
  }

  static double length(const Triple& v) { return std::hypot(v[0], v[1], v[2]); }

  // Is every one of some points inside? Those on the other surface tell nothing.
  bool lies_in(const Component& inner, const Component& outer) const
  {
    constexpr std::size_t wanted = 7;
    const std::size_t step = (std::max)(std::size_t(1), inner.faces.size() / wanted);
    bool is_known = false;
    for (std::size_t i = 0; i < inner.faces.size(); i += step) {
      const double w = std::abs(winding_number(outer, middle_of(inner.faces[i])));
      const double to_whole = std::abs(w - std::round(w));
      if (to_whole > 0.25) continue;
      if (w < 0.5) return false;
      is_known = true;
    }
    return is_known;
  }

  Triple middle_of(std::size_t f) const
  {
    const Mesh_data::Face face = mesh_.face(f);
    const auto n = double(face.size());
    Triple middle = {0, 0, 0};
    for (const Index v : face)
      for (std::size_t k = 0; k < 3; ++k) middle[k] += mesh_.points[v][k] / n;
    return middle;
  }

  const Mesh_data& mesh_;
  std::vector<Component> components_;
};

} // namespace

std::size_t orient_outwards(Mesh_data& mesh, std::vector<bool>& is_turned)
{
  const Components components(mesh);
  const std::vector<const Component*> wrong = components.to_be_turned();
  if (wrong.empty()) return 0;
  for (const Component* c : wrong)
    for (const std::size_t f : c->faces) {
      mesh.reverse_face(f);
      is_turned[f] = !is_turned[f];
    }
  return wrong.size();
}

Inside_out find_inside_out(const Mesh_data& mesh)
{
  return Components(mesh).inside_out();
}

std::string Inside_out::description() const
{
  return plural(number, "body is", "bodies are") + " inside out (first: at face " +
         std::to_string(first_face) + "); --repair turns " + (number == 1 ? "it" : "them") +
         " right side out";
}

} // namespace pn_subdivide
