// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_recognition_3/internal/Part.h>

#include <tuple>

namespace CGAL::PN_subdivision_3::internal::recognition {

class Make_patches
{
public:
  Make_patches(const Part& part, double greatest_smooth_angle)
    : part_(part)
    , greatest_angle_(greatest_smooth_angle)
  {}

  Patches operator()()
  {
    result_.patch_of_face.assign(part_.number_of_faces(), null);
    find_flat_edges();
    for (Index f = 0; f < part_.number_of_faces(); ++f)
      if (!part_.is_sliver(f) && result_.patch_of_face[f] == null) make_patches_from(f);
    for (Patches::Patch& patch : result_.patches) measure(patch);
    make_joints();
    return std::move(result_);
  }

private:
  void find_flat_edges()
  {
    std::vector<std::pair<Index, Index>> pairs;
    for (const Part::Edge& e : part_.edges) {
      if (!part_.is_nearly_flat(e, cosine_of_flat_, part_.tolerance)) continue;
      pairs.emplace_back(e.f, e.g);
      pairs.emplace_back(e.g, e.f);
    }
    flat_ = Lists(part_.number_of_faces(), pairs);
  }

  void make_patches_from(Index first)
  {
    std::vector<Index> component = grown(first, [](Index) { return true; });
    if (is_in_plane(component)) return add(component);
    for (const Index f : component) result_.patch_of_face[f] = null;
    sort_numbers(component,
                 [&](Index f, Index g) { return part_.altitude[f] > part_.altitude[g]; });
    for (const Index f : component)
      if (result_.patch_of_face[f] == null) add(grown_in_plane(f));
  }

  // marks what it takes as of the next patch
  template <class Takes>
  std::vector<Index> grown(Index first, const Takes& takes)
  {
    std::vector<Index> faces{first};
    result_.patch_of_face[first] = result_.size();
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (const Index g : flat_[faces[i]])
        if (result_.patch_of_face[g] == null && takes(g)) {
          result_.patch_of_face[g] = result_.size();
          faces.push_back(g);
        }
    return faces;
  }

  // through the means of corners, across the sum of area vectors
  class Running_plane
  {
  public:
    explicit Running_plane(const Part& part)
      : part_(part)
    {}
    void add(Index f)
    {
      area_ += part_.area[f];
      for (const Index v : part_.corners[f]) sum_ += part_.points[v];
      number_ += double(part_.corners[f].size());
    }
    bool has(Index f) const
    {
      const Vec3 n = unit(area_), mean = (1 / number_) * sum_;
      for (const Index v : part_.corners[f])
        if (std::abs(dot(n, part_.points[v] - mean)) > 2 * part_.tolerance) return false;
      return true;
    }

  private:
    const Part& part_;
    Vec3 area_, sum_;
    double number_ = 0;
  };

  std::vector<Index> grown_in_plane(Index first)
  {
    Running_plane plane(part_);
    plane.add(first);
    return grown(first, [&](Index g) {
      const bool result = plane.has(g);
      if (result) plane.add(g);
      return result;
    });
  }

  bool is_in_plane(const std::vector<Index>& faces) const
  {
    Running_plane plane(part_);
    for (const Index f : faces) plane.add(f);
    return std::all_of(faces.begin(), faces.end(), [&](Index f) { return plane.has(f); });
  }

  void add(const std::vector<Index>& faces)
  {
    Patches::Patch& patch = result_.patches.emplace_back();
    patch.faces = faces;
    patch.is_planar = is_in_plane(faces);
  }

  void measure(Patches::Patch& patch) const
  {
    Vec3 area;
    for (const Index f : patch.faces) {
      area += part_.area[f];
      for (const Index v : part_.corners[f]) patch.vertices.push_back(v);
    }
    std::sort(patch.vertices.begin(), patch.vertices.end());
    patch.vertices.erase(std::unique(patch.vertices.begin(), patch.vertices.end()),
                         patch.vertices.end());
    drop_chords(patch);
    patch.area = norm(area);
    patch.normal = unit(area);
    for (const Index v : patch.vertices) patch.mean += part_.points[v];
    patch.mean = (1 / double(patch.vertices.size())) * patch.mean;
    double extent = 0;
    for (const Index v : patch.vertices)
      extent = (std::max)(extent, norm(part_.points[v] - patch.mean));
    patch.width = extent > 0 ? patch.area / (2 * extent) : 0;
  }

  // Polyhedral Booleans leave vertices in the middle of sides: at the facets of what is beyond a sharp one, or where the diagonal of a
  // facet has been. Of a round surface they are on chords.
  void drop_chords(Patches::Patch& patch) const
  {
    std::vector<std::pair<Index, Index>> sides, outline;
    for (const Index f : patch.faces) {
      const Lists::Range c = part_.corners[f];
      for (std::size_t i = 0; i < c.size(); ++i) sides.emplace_back(c[i], c[(i + 1) % c.size()]);
    }
    std::sort(sides.begin(), sides.end());
    for (const auto& s : sides)
      if (!std::binary_search(sides.begin(), sides.end(), std::make_pair(s.second, s.first)))
        outline.push_back(s);
    std::vector<Index> dropped;
    for (const auto& s : outline) {
      const auto next =
        std::equal_range(outline.begin(), outline.end(), std::make_pair(s.second, Index(0)),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
      if (next.second - next.first == 1 && is_straight(s.first, s.second, next.first->second) &&
          is_on_chord(patch, s.second))
        dropped.push_back(s.second);
    }
    std::sort(dropped.begin(), dropped.end());
    const auto is_dropped = [&](Index v) {
      return std::binary_search(dropped.begin(), dropped.end(), v);
    };
    patch.vertices.erase(std::remove_if(patch.vertices.begin(), patch.vertices.end(), is_dropped),
                         patch.vertices.end());
  }
  bool is_straight(Index a, Index b, Index c) const
  {
    const Vec3 p = part_.points[a], q = part_.points[b], r = part_.points[c];
    const double length = norm(r - p);
    return norm(cross(q - p, r - p)) <= 2 * part_.tolerance * length && dot(q - p, r - q) > 0;
  }
  // whether all else around a vertex is beyond what may be round, or one patch, of which the vertex is in the middle of a side, too
  bool is_on_chord(const Patches::Patch& patch, Index v) const
  {
    const Vec3& normal = part_.normal[patch.faces[0]];
    Index other = null;
    bool is_sharp = true, is_alone = true;
    for (const Index f : part_.faces_around[v]) {
      const Index p = result_.patch_of_face[f];
      if (p == null || p == result_.patch_of_face[patch.faces[0]]) continue;
      is_sharp = is_sharp && angle_between(part_.normal[f], normal) > greatest_angle_;
      is_alone = is_alone && (other == null || other == p);
      other = p;
    }
    return (is_sharp || is_alone) && !part_.on_border[v];
  }

  void make_joints()
  {
    std::vector<std::tuple<Index, Index, Index>> pairs;
    for (Index e = 0; e < part_.edges.size(); ++e) {
      if (part_.edges[e].g == null) continue;
      const Index p = result_.patch_of_face[part_.edges[e].f],
                  q = result_.patch_of_face[part_.edges[e].g];
      if (p == null || q == null || p == q) continue;
      pairs.emplace_back((std::min)(p, q), (std::max)(p, q), e);
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [p, q, e] : pairs) {
      if (result_.joints.empty() || result_.joints.back().p != p || result_.joints.back().q != q) {
        const auto number = Index(result_.joints.size());
        result_.patches[p].joints.push_back(number);
        result_.patches[q].joints.push_back(number);
        result_.joints.push_back({p, q, {}});
      }
      result_.joints.back().edges.push_back(e);
    }
    for (Joint& j : result_.joints) measure(j);
  }

  void measure(Joint& j) const
  {
    j.angle = angle_between(result_[j.p].normal, result_[j.q].normal);
    j.is_smooth = j.angle <= greatest_angle_;
    Vec3 mean;
    for (const Index e : j.edges) {
      j.length += part_.length(part_.edges[e]);
      mean += 0.5 * (part_.points[part_.edges[e].v] + part_.points[part_.edges[e].w]);
    }
    j.v = furthest_from((1 / double(j.edges.size())) * mean, j);
    j.w = furthest_from(part_.points[j.v], j);
  }
  Index furthest_from(const Vec3& p, const Joint& j) const
  {
    Index result = part_.edges[j.edges[0]].v;
    for (const Index e : j.edges)
      for (const Index v : {part_.edges[e].v, part_.edges[e].w})
        if (norm(part_.points[v] - p) > norm(part_.points[result] - p)) result = v;
    return result;
  }

  const Part& part_;
  double greatest_angle_;
  double cosine_of_flat_ = std::cos(radians(25));
  Lists flat_;
  Patches result_;
};

inline Patches make_patches(const Part& part, double greatest_smooth_angle)
{
  return Make_patches(part, greatest_smooth_angle)();
}

} // namespace CGAL::PN_subdivision_3::internal::recognition
