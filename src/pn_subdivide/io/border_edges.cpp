// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "io/mesh_normals.h"
#include "io/soup_repair.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>

namespace pn_subdivide {
namespace {

enum class Contact { none, along, near, equal };

struct Segment
{
  Triple ends[2];        // in order
  Border_edge originals; // the vertices that these are, or are copies of, in order
  Contact contact = Contact::none;
};

std::vector<Segment> segments_of(const Mesh_data& mesh, const std::vector<Border_edge>& edges)
{
  std::vector<Segment> segments;
  segments.reserve(edges.size());
  for (const Border_edge& e : edges) {
    Segment s{{mesh.points[e[0]], mesh.points[e[1]]}, {mesh.original(e[0]), mesh.original(e[1])}};
    if (s.ends[1] < s.ends[0]) std::swap(s.ends[0], s.ends[1]);
    if (s.originals[1] < s.originals[0]) std::swap(s.originals[0], s.originals[1]);
    segments.push_back(s);
  }
  return segments;
}

bool have_equal_ends(const Segment& a, const Segment& b)
{
  return a.ends[0] == b.ends[0] && a.ends[1] == b.ends[1];
}

void mark_equal(std::vector<Segment>& segments)
{
  std::sort(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) {
    return a.ends[0] != b.ends[0] ? a.ends[0] < b.ends[0] : a.ends[1] < b.ends[1];
  });
  for (auto begin = segments.begin(); begin != segments.end();) {
    const auto end = std::find_if_not(begin, segments.end(),
                                      [&](const Segment& s) { return have_equal_ends(s, *begin); });
    const bool are_copies =
      std::all_of(begin, end, [&](const Segment& s) { return s.originals == begin->originals; });
    if (!are_copies) std::for_each(begin, end, [](Segment& s) { s.contact = Contact::equal; });
    begin = end;
  }
}

double distance_between(const Triple& p, const Triple& q)
{
  const Triple d = difference(p, q);
  return std::hypot(d[0], d[1], d[2]);
}

bool is_on(const Triple& p, const Segment& s, double distance)
{
  const Triple d = difference(s.ends[1], s.ends[0]), v = difference(p, s.ends[0]);
  const double squared = scalar_product(d, d);
  const double t = squared > 0 ? (std::min)(1., (std::max)(0., scalar_product(v, d) / squared)) : 0;
  return distance_between(v, {t * d[0], t * d[1], t * d[2]}) <= distance;
}

Contact contact_between(const Segment& a, const Segment& b, double distance)
{
  const auto are_near = [&](int i, int j) {
    return distance_between(a.ends[0], b.ends[i]) <= distance &&
           distance_between(a.ends[1], b.ends[j]) <= distance;
  };
  if (a.originals == b.originals) return Contact::none;
  const auto is_long = [&](const Segment& s) {
    return distance_between(s.ends[0], s.ends[1]) > 4 * distance;
  };
  if (!is_long(a) || !is_long(b)) return Contact::none;
  if (are_near(0, 1) || are_near(1, 0)) return Contact::near;
  // more than a common end
  std::vector<Triple> common;
  for (int i = 0; i < 2; ++i) {
    if (is_on(a.ends[i], b, distance)) common.push_back(a.ends[i]);
    if (is_on(b.ends[i], a, distance)) common.push_back(b.ends[i]);
  }
  for (const Triple& p : common)
    if (distance_between(p, common.front()) > 4 * distance) return Contact::along;
  return Contact::none;
}

void mark_near(std::vector<Segment*>& segments, double distance)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Segment*>;
  std::vector<Box> boxes;
  boxes.reserve(segments.size());
  for (Segment* s : segments) {
    Triple low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = (std::min)(s->ends[0][k], s->ends[1][k]) - distance;
      high[k] = (std::max)(s->ends[0][k], s->ends[1][k]) + distance;
    }
    boxes.emplace_back(low.data(), high.data(), s);
  }
  const auto mark = [distance](const Box& a, const Box& b) {
    Segment &s = *a.info(), &t = *b.info();
    const Contact contact = contact_between(s, t, distance);
    s.contact = (std::max)(s.contact, contact);
    t.contact = (std::max)(t.contact, contact);
  };
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), mark);
}

std::size_t number_of(Contact contact, const std::vector<Segment>& segments)
{
  return std::size_t(std::count_if(segments.begin(), segments.end(),
                                   [&](const Segment& s) { return s.contact == contact; }));
}

} // namespace

std::size_t number_of_equal(const Mesh_data& mesh, const std::vector<Border_edge>& edges)
{
  std::vector<Segment> segments = segments_of(mesh, edges);
  mark_equal(segments);
  return number_of(Contact::equal, segments);
}

Border_contacts find_border_contacts(const Mesh_data& mesh, const std::vector<Border_edge>& edges,
                                     double distance)
{
  std::vector<Segment> segments = segments_of(mesh, edges);
  mark_equal(segments);
  std::vector<Segment*> others;
  for (Segment& s : segments)
    if (s.contact == Contact::none) others.push_back(&s);
  mark_near(others, distance);
  Border_contacts result;
  result.border_edges = edges.size();
  result.equal = number_of(Contact::equal, segments);
  result.near = number_of(Contact::near, segments);
  result.along = number_of(Contact::along, segments);
  return result;
}

std::string Border_contacts::description(double distance_of_diagonal,
                                         const std::string& joins_equal) const
{
  std::string text;
  const auto add = [&](std::size_t number, const std::string& what) {
    if (number == 0) return;
    text += (text.empty() ? "" : "; ") + std::to_string(number) + " of " +
            plural(border_edges, "border edge ", "border edges ") + (number == 1 ? "lies" : "lie") +
            what;
  };
  add(equal, " on others: " + joins_equal + " joins them");
  add(near, formatted(" on others up to rounding: --merge-distance %.3g%% joins them",
                      100 * distance_of_diagonal));
  add(along, " along others with other ends (T-junctions), where the surface stays open");
  return text;
}

} // namespace pn_subdivide
