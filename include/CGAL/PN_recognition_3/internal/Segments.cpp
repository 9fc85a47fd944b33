// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/Part.h>

namespace CGAL::PN_subdivision_3::internal::recognition {

// From regions of patches to segments of faces: facets of two rounds in one plane, planes, what is unknown, slivers.
class Make_segments
{
public:
  Make_segments(const Context& context, const std::vector<Region>& regions,
                const std::vector<Index>& owners, const std::vector<double>& prism_step)
    : c_(context)
    , regions_(regions)
    , owners_(owners)
    , prism_step_(prism_step)
    , label_(context.part.number_of_faces(), null)
  {
    std::vector<std::pair<Index, Index>> pairs;
    for (Index e = 0; e < c_.part.edges.size(); ++e) {
      const Part::Edge& edge = c_.part.edges[e];
      if (edge.g == null) continue;
      pairs.emplace_back(edge.f, e);
      pairs.emplace_back(edge.g, e);
    }
    edges_of_face_ = Lists(c_.part.number_of_faces(), pairs);
  }

  Segments operator()()
  {
    for (const Region& r : regions_) {
      Region measured = r;
      if (!r.patches.empty()) measure(c_, measured);
      const double step =
        facts_of(r.shape.kind).turns_about_axis ? measured.turn.widest : measured.widest_angle;
      labels_.push_back({r.shape, r.side, step, measured.meridian.widest, 0, {}});
    }
    for (Index p = 0; p < c_.patches.size(); ++p)
      if (owners_[p] != null) set_label(p, owners_[p]);
    relabel();
    split();
    find_planes();
    join_unknown();
    give_slivers_away();
    join_equal();
    return collect();
  }

private:
  void set_label(Index p, Index label)
  {
    for (const Index f : c_.patches[p].faces) label_[f] = label;
  }
  bool is_free(Index p) const { return label_[c_.patches[p].faces[0]] == null; }
  Index new_label(const Shape& s)
  {
    labels_.push_back({s, 1, 0, 0, 0, {}});
    return Index(labels_.size()) - 1;
  }

  // Narrow faces at the pole of a corner are, up to rounding, in the plane of a facet of the fillet beside them.
  void relabel()
  {
    for (Index p = 0; p < c_.patches.size(); ++p) {
      const Index own = owners_[p];
      if (own == null || distance(own, c_.patches[p].vertices) <= c_.tolerance() / 2) continue;
      std::vector<Index> others = owners_beside(p);
      others.erase(std::remove(others.begin(), others.end(), own), others.end());
      for (const Index f : c_.patches[p].faces) {
        const double d = distance(own, c_.part.corners[f]);
        const Index other = d > c_.tolerance() / 2 ? region_of_face(f, others) : null;
        if (other != null && distance(other, c_.part.corners[f]) < d / 2) label_[f] = other;
      }
    }
  }
  double distance(Index region, Lists::Range vertices) const
  {
    double result = 0;
    for (const Index v : vertices)
      result = (std::max)(result, std::abs(regions_[region].shape.distance(c_.point(v))));
    return result;
  }
  std::vector<Index> owners_beside(Index p) const
  {
    std::vector<Index> owners;
    for (const Index number : c_.patches[p].joints) {
      const Index owner = owners_[c_.patches.joints[number].other(p)];
      if (owner != null) owners.push_back(owner);
    }
    std::sort(owners.begin(), owners.end());
    owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
    return owners;
  }

  // The middle facets of a pipe and of its bend are coplanar.
  void split()
  {
    for (Index p = 0; p < c_.patches.size(); ++p) {
      if (!is_free(p) || c_.patches[p].faces.size() < 2) continue;
      const std::vector<Index> owners = owners_beside(p);
      std::vector<Index> chosen;
      for (const Index f : c_.patches[p].faces) {
        chosen.push_back(region_of_face(f, owners));
        if (chosen.back() == null) break;
      }
      if (chosen.back() == null) continue;
      for (std::size_t i = 0; i < chosen.size(); ++i) label_[c_.patches[p].faces[i]] = chosen[i];
    }
  }
  Index region_of_face(Index f, const std::vector<Index>& owners) const
  {
    Index best = null;
    double least = 0;
    for (const Index region : owners) {
      const Region& r = regions_[region];
      if (!may_be_facet(c_, r, c_.part.corners[f], c_.part.normal[f], c_.part.altitude[f],
                        2 * c_.tolerance()))
        continue;
      const double d = midpoint_distance(c_, r.shape, std::vector<Index>{f});
      if (d > r.greatest_midpoint_distance || (best != null && d >= least)) continue;
      best = region;
      least = d;
    }
    return best;
  }

  void find_planes()
  {
    join_coplanar();
    std::vector<Index> planes;
    for (Index p = 0; p < c_.patches.size(); ++p)
      if (is_free(p) && c_.patches[p].is_planar && (prism_step_[p] > 0 || stands_out(p)))
        planes.push_back(p);
    for (const Index p : planes) make_plane({p});
  }

  // patches that are free and connected by joints of at most some angle
  std::vector<std::vector<Index>> free_components(double greatest_angle) const
  {
    std::vector<std::vector<Index>> result;
    std::vector<bool> is_taken(c_.patches.size(), false);
    for (Index first = 0; first < c_.patches.size(); ++first) {
      if (is_taken[first] || !is_free(first)) continue;
      is_taken[first] = true;
      std::vector<Index> component{first};
      for (std::size_t i = 0; i < component.size(); ++i)
        for (const Index number : c_.patches[component[i]].joints) {
          const Joint& j = c_.patches.joints[number];
          const Index q = j.other(component[i]);
          if (is_taken[q] || !is_free(q) || j.angle > greatest_angle) continue;
          is_taken[q] = true;
          component.push_back(q);
        }
      result.push_back(component);
    }
    return result;
  }

  // Narrow planes of rounded points come in several patches.
  void join_coplanar()
  {
    for (const std::vector<Index>& component : free_components(radians(3))) {
      if (component.size() < 2) continue;
      const Shape plane = plane_of(component);
      if (greatest_distance(plane, c_.points_of(c_.vertices_of(component))) <= 2 * c_.tolerance())
        make_plane(component);
    }
  }
  bool stands_out(Index p) const
  {
    double largest = 0;
    for (const Index number : c_.patches[p].joints) {
      const Joint& j = c_.patches.joints[number];
      const Index q = j.other(p);
      if (j.angle <= radians(30) && is_free(q)) largest = (std::max)(largest, c_.patches[q].area);
    }
    const double area = c_.patches[p].area;
    return largest == 0 || area >= 4 * largest ||
           (c_.patches[p].faces.size() >= 6 && area > largest);
  }
  Shape plane_of(const std::vector<Index>& patches) const
  {
    const std::vector<Vec3> points = c_.points_of(c_.vertices_of(patches));
    Shape s;
    s.kind = Kind::plane;
    for (const Vec3& p : points) s.center += (1 / double(points.size())) * p;
    for (const Index p : patches) s.axis += c_.patches[p].area * c_.patches[p].normal;
    s.axis = unit(s.axis);
    Covariance covariance;
    for (const Vec3& p : points) covariance.add(p - s.center);
    Shape fitted = s;
    fitted.axis = covariance.least_direction();
    if (dot(fitted.axis, s.axis) < 0) fitted.axis = -fitted.axis;
    return greatest_distance(fitted, points) < greatest_distance(s, points) ? fitted : s;
  }
  void make_plane(const std::vector<Index>& patches)
  {
    const Index label = new_label(plane_of(patches));
    for (const Index p : patches) set_label(p, label);
    labels_[label].widest_step = prism_step_[patches[0]];
  }

  // joins segments over joints of at most 30 degrees
  void join_unknown()
  {
    for (const std::vector<Index>& component : free_components(radians(30))) {
      const bool are_planar = std::all_of(component.begin(), component.end(),
                                          [&](Index p) { return c_.patches[p].is_planar; });
      if (are_planar && is_pyramid(component))
        for (const Index p : component) make_plane({p});
      else {
        const Index label = new_label(Shape());
        for (const Index p : component) set_label(p, label);
      }
    }
  }

  // One or two facets, few about a vertex, or a ring of few: a flat pyramid or frustum, which need not be regular.
  bool is_pyramid(const std::vector<Index>& component) const
  {
    if (component.size() >= c_.min_facets) return false;
    const std::vector<Index>& first = c_.patches[component[0]].vertices;
    const bool have_apex = std::any_of(first.begin(), first.end(),
                                       [&](Index v) { return c_.have_vertex(component, v); });
    return have_apex || std::all_of(component.begin(), component.end(),
                                    [&](Index p) { return neighbors_within(component, p) == 2; });
  }
  std::size_t neighbors_within(const std::vector<Index>& component, Index p) const
  {
    std::size_t result = 0;
    for (const Index number : c_.patches[p].joints) {
      const Joint& j = c_.patches.joints[number];
      result += j.angle <= radians(30) &&
                std::find(component.begin(), component.end(), j.other(p)) != component.end();
    }
    return result;
  }

  // Slivers have no normal. Labels them from the edge of what has labels on, by the longest common border among the best.
  void give_slivers_away()
  {
    std::vector<Index> slivers;
    for (Index f = 0; f < label_.size(); ++f)
      if (label_[f] == null) slivers.push_back(f);
    for (int quality = 0; quality < 3 && !slivers.empty();) {
      std::vector<std::pair<Index, Index>> given;
      std::vector<Index> rest;
      for (const Index f : slivers) {
        const Index label = label_for_sliver(f, quality);
        if (label == null)
          rest.push_back(f);
        else
          given.emplace_back(f, label);
      }
      for (const auto& g : given) label_[g.first] = g.second;
      quality = given.empty() ? quality + 1 : 0;
      slivers = rest;
    }
    if (slivers.empty()) return;
    const Index label = new_label(Shape()); // components of nothing but slivers
    for (const Index f : slivers) label_[f] = label;
  }
  Index label_for_sliver(Index f, int quality) const
  {
    std::vector<std::pair<Index, double>> borders;
    for (const Index e : edges_of_face_[f]) {
      const Part::Edge& edge = c_.part.edges[e];
      const Index label = label_[c_.part.across(f, e)];
      if (label == null || !is_good_for(f, labels_[label].shape, quality)) continue;
      auto it = borders.begin();
      while (it != borders.end() && it->first != label) ++it;
      if (it == borders.end()) it = borders.emplace(it, label, 0.);
      it->second += c_.part.length(edge);
    }
    const auto best =
      std::max_element(borders.begin(), borders.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return best == borders.end() ? null : best->first;
  }
  bool is_good_for(Index f, const Shape& s, int quality) const
  {
    if (quality == 2) return true;
    if (quality == 1 || s.kind == Kind::unknown) return quality == 1 && s.kind == Kind::unknown;
    for (const Index v : c_.part.corners[f])
      if (!(std::abs(s.distance(c_.point(v))) <= 8 * c_.tolerance())) return false;
    return true;
  }

  // neighbors on one surface
  void join_equal()
  {
    for (Index f = 0; f < label_.size(); ++f) labels_[label_[f]].faces.push_back(f);
    for (const Part::Edge& e : c_.part.edges) {
      if (e.g == null) continue;
      Index a = label_[e.f], b = label_[e.g];
      if (a == b) continue;
      if (labels_[a].faces.size() < labels_[b].faces.size()) std::swap(a, b);
      if (!are_equal(labels_[a], labels_[b])) continue;
      for (const Index f : labels_[b].faces) label_[f] = a;
      labels_[a].faces.insert(labels_[a].faces.end(), labels_[b].faces.begin(),
                              labels_[b].faces.end());
      labels_[b].faces.clear();
    }
  }
  bool are_equal(const Segments::Segment& a, const Segments::Segment& b) const
  {
    if (a.shape.kind != b.shape.kind || a.shape.kind == Kind::unknown) return false;
    const double margin = 2 * c_.tolerance(); // vertices of cut facets are off both
    for (const Index f : b.faces)
      for (const Index v : c_.part.corners[f]) {
        const Vec3& x = c_.point(v);
        const double d = a.shape.distance(x);
        if (!(std::abs(d) <= margin || std::abs(d - b.shape.distance(x)) <= margin)) return false;
        if (dot(a.side * a.shape.normal(x), b.side * b.shape.normal(x)) < std::cos(radians(8)))
          return false;
      }
    return true;
  }

  // collects the segments in the order of their first faces
  Segments collect()
  {
    Segments result;
    result.segment_of_face.assign(label_.size(), null);
    std::vector<Index> number(labels_.size(), null);
    for (Index f = 0; f < label_.size(); ++f) {
      Segments::Segment& s = labels_[label_[f]];
      if (number[label_[f]] == null) {
        number[label_[f]] = Index(result.segments.size());
        s.residual = residual(s);
        result.segments.push_back(s);
      }
      result.segment_of_face[f] = number[label_[f]];
    }
    return result;
  }
  double residual(const Segments::Segment& s) const
  {
    double largest = 0;
    if (s.shape.kind == Kind::unknown) return 0;
    for (const Index f : s.faces)
      for (const Index v : c_.part.corners[f])
        largest = (std::max)(largest, std::abs(s.shape.distance(c_.point(v))));
    return largest;
  }

  const Context& c_;
  const std::vector<Region>& regions_;
  const std::vector<Index>& owners_;
  const std::vector<double>& prism_step_;
  Lists edges_of_face_;
  std::vector<Index> label_;
  std::vector<Segments::Segment> labels_;
};

inline Segments make_segments(const Context& c, const std::vector<Region>& regions,
                              const std::vector<Index>& owners,
                              const std::vector<double>& prism_step)
{
  return Make_segments(c, regions, owners, prism_step)();
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
