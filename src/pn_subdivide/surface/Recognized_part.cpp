// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Recognized_part.h"

#include "io/mesh_normals.h"

#include <CGAL/PN_recognition_3/internal/recognition.h>
#include <CGAL/PN_recognition_3/recognize_surfaces.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <optional>

namespace pn_subdivide {
namespace {

namespace Recognition = PN::internal::recognition;

using Kind = Recognized_surface::Kind;
using Recognition::Shape;
using Recognition::Vec3;

// Where vertices belong: on all surfaces of the faces around them.
class Places_on_surfaces
{
public:
  // segments: the numbers of the surfaces of the faces
  Places_on_surfaces(const Surface& surface, const std::vector<std::size_t>& segments,
                     const std::vector<Recognized_surface>& surfaces)
    : surface_(surface)
    , segments_(segments)
    , surfaces_(surfaces)
  {
    for (const Recognized_surface& s : surfaces) shapes_.push_back(Recognition::as_shape(s, 1, {}));
  }

  // Programs that cut facets, not what these stand for, leave vertices on their chords, which refinement would keep.
  std::vector<Moved_vertex> cut_vertices()
  {
    std::vector<Moved_vertex> result;
    for (const Vertex v : surface_.vertices())
      if (find_surfaces(v) && is_cut(v))
        if (const std::optional<Vec3> p = place_of(v, 0.4 * shortest_edge(v)))
          result.push_back({std::size_t(v), Point_3((*p)[0], (*p)[1], (*p)[2])});
    return result;
  }

  // Those of a refined mesh on surfaces that the scheme has left anywhere by more than a fiftieth of what facets do.
  std::vector<Moved_vertex> left_vertices()
  {
    std::vector<bool> is_left(surfaces_.size(), false);
    for (const Vertex v : surface_.vertices()) {
      find_surfaces(v);
      for (const std::size_t s : around_) is_left[s] = is_left[s] || is_off(s, at(v));
    }
    std::vector<Moved_vertex> result;
    for (const Vertex v : surface_.vertices()) {
      find_surfaces(v);
      double most = 0;
      for (const std::size_t s : around_) most = (std::max)(most, sagitta(s, at(v)));
      if (std::none_of(around_.begin(), around_.end(), [&](std::size_t s) { return is_left[s]; }))
        continue;
      if (const std::optional<Vec3> p = place_of(v, 2 * most))
        result.push_back({std::size_t(v), Point_3((*p)[0], (*p)[1], (*p)[2])});
    }
    return result;
  }

private:
  Vec3 at(Vertex v) const
  {
    const Point_3& p = surface_.point(v);
    return {p.x(), p.y(), p.z()};
  }

  // Those that are known; returns whether all are.
  bool find_surfaces(Vertex v)
  {
    around_.clear();
    if (surface_.is_isolated(v)) return false;
    for (const auto f : CGAL::faces_around_target(surface_.halfedge(v), surface_))
      if (f != Surface::null_face()) around_.push_back(segments_[f]);
    std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
    const auto known = std::remove_if(around_.begin(), around_.end(), [&](std::size_t s) {
      return surfaces_[s].kind == Kind::unknown;
    });
    const bool are_all = known == around_.end();
    around_.erase(known, around_.end());
    return are_all;
  }

  // how far the middle of a facet may be from its surface
  double sagitta(std::size_t segment, const Vec3& p) const
  {
    const Recognized_surface& s = surfaces_[segment];
    const auto height = [](double radius, double step) {
      return radius * (1 - std::cos(step / 2));
    };
    switch (s.kind) {
    case Kind::unknown:
    case Kind::plane:
      break;
    case Kind::cone:
      return height(shapes_[segment].local(p).rho, s.widest_step);
    case Kind::cylinder:
    case Kind::sphere:
    case Kind::torus:
      return height(s.radius + s.tube_radius, s.widest_step) +
             height(s.tube_radius, s.widest_meridian_step);
    }
    return 0;
  }

  // well off a round surface
  bool is_off(std::size_t segment, const Vec3& p) const
  {
    return surfaces_[segment].kind != Kind::plane &&
           std::abs(shapes_[segment].distance(p)) > 0.02 * sagitta(segment, p);
  }
  // by no more than a chord is
  bool is_cut(Vertex v) const
  {
    const Vec3 p = at(v);
    const auto is_far = [&](std::size_t s) {
      return surfaces_[s].kind != Kind::plane &&
             !(std::abs(shapes_[s].distance(p)) <= 1.1 * sagitta(s, p));
    };
    return std::none_of(around_.begin(), around_.end(), is_far) &&
           std::any_of(around_.begin(), around_.end(), [&](std::size_t s) { return is_off(s, p); });
  }

  // by projections in turn, which go to a near point of all of them if they meet at an angle
  std::optional<Vec3> place_of(Vertex v, double farthest) const
  {
    const Vec3 start = at(v);
    const double edge = shortest_edge(v);
    Vec3 p = start;
    double off = 0;
    for (int k = 0; k < 200; ++k) {
      for (const std::size_t s : around_) p = p - shapes_[s].distance(p) * shapes_[s].normal(p);
      off = 0;
      for (const std::size_t s : around_) off = (std::max)(off, std::abs(shapes_[s].distance(p)));
      if (off <= 1e-9 * edge) break;
    }
    if (!(off <= 1e-6 * edge && Recognition::norm(p - start) <= farthest)) return std::nullopt;
    return p;
  }
  double shortest_edge(Vertex v) const
  {
    double shortest = -1;
    for (const auto h : CGAL::halfedges_around_target(surface_.halfedge(v), surface_)) {
      const double length = Recognition::norm(at(surface_.source(h)) - at(v));
      if (shortest < 0 || length < shortest) shortest = length;
    }
    return shortest;
  }

  const Surface& surface_;
  const std::vector<std::size_t>& segments_;
  const std::vector<Recognized_surface>& surfaces_;
  std::vector<Shape> shapes_;
  std::vector<std::size_t> around_; // a vertex: the surfaces
};

using Patch_map = Surface::Property_map<Face, std::size_t>;
using Crease_map = Surface::Property_map<Edge, bool>;
using Normals_of_surfaces = Surface::Property_map<Halfedge, Vector_3>;

// of the farthest corner of a face over an edge of it
double height_over(const Surface& surface, Halfedge h)
{
  const Point_3& p = surface.point(surface.source(h));
  const Vector_3 along = surface.point(surface.target(h)) - p;
  double most = 0;
  for (const Vertex v : surface.vertices_around_face(h))
    most = (std::max)(most, CGAL::cross_product(surface.point(v) - p, along).squared_length());
  return std::sqrt(most / along.squared_length());
}

// Schemes move the edge between a narrow facet and a wide one by a part of the height of the latter, and fold the former over, as beside
// cuts near rulings. A crease stays; nobody sees it, since both sides have the normals of the surface.
bool is_between_narrow_and_wide(const Surface& surface, Halfedge h)
{
  constexpr double narrow = 1. / 4;
  const auto [less, more] =
    std::minmax({height_over(surface, h), height_over(surface, surface.opposite(h))});
  return less < narrow * more;
}

std::vector<bool> vertices_at_ends(const Recognized_part& part, const Surface& surface)
{
  std::vector<bool> is_at_end(surface.number_of_vertices(), false);
  for (const Edge e : surface.edges())
    if (part.creases[e] || surface.is_border(e))
      is_at_end[surface.vertex(e, 0)] = is_at_end[surface.vertex(e, 1)] = true;
  return is_at_end;
}

void tag_narrow_facets(Recognized_part& part, const Surface& surface,
                       const std::vector<bool>& is_at_end)
{
  for (const Edge e : surface.edges()) {
    const Halfedge h = surface.halfedge(e);
    if (!surface.is_border(e) && is_at_end[surface.source(h)] && is_at_end[surface.target(h)] &&
        is_round(part.surfaces[part.segments[surface.face(h)]].kind) &&
        is_between_narrow_and_wide(surface, h))
      part.creases[e] = true;
  }
}

double distance_from_plane(const Surface& surface, Face f, Face of)
{
  const auto [p, area, size] = place_of(surface, of);
  double most = 0;
  for (const Vertex v : surface.vertices_around_face(surface.halfedge(f)))
    most = (std::max)(most, std::abs((surface.point(v) - p) * area));
  return most / std::sqrt(area.squared_length());
}

// of the flat polygon that a face is in, if its neighbors are beyond doubt in other planes; `first`: a face of each that was found
std::vector<Halfedge> rim_of_cap(const Surface& surface, Face f, std::vector<Face>& first,
                                 const std::vector<bool>& is_at_end, double tolerance)
{
  std::vector<Face> cap(1, f);
  std::vector<Halfedge> rim;
  bool is_cap = true;
  first[f] = f;
  for (std::size_t i = 0; is_cap && i < cap.size(); ++i)
    for (const Halfedge h : CGAL::halfedges_around_face(surface.halfedge(cap[i]), surface)) {
      is_cap = is_cap && !is_at_end[surface.target(h)];
      const Face g = surface.face(surface.opposite(h));
      if (!is_cap || first[g] == f) continue;
      const double off = distance_from_plane(surface, g, f);
      if (first[g] == Surface::null_face() && off <= tolerance) {
        first[g] = f;
        cap.push_back(g);
      } else {
        is_cap = off > 16 * tolerance;
        rim.push_back(h);
      }
    }
  if (is_cap && cap.size() > 2) return rim;
  for (const Face g : cap) first[g] = Surface::null_face();
  return {};
}

// Polygons inside spheres, as programs write them at poles, are divided into such facets: their rims stay, too.
void tag_caps(Recognized_part& part, const Surface& surface, const std::vector<bool>& is_at_end,
              double tolerance)
{
  std::vector<Face> first(surface.number_of_faces(), Surface::null_face());
  for (const Face f : surface.faces()) {
    if (first[f] != Surface::null_face() || part.surfaces[part.segments[f]].kind != Kind::sphere)
      continue;
    const std::vector<Halfedge> rim = rim_of_cap(surface, f, first, is_at_end, tolerance);
    if (std::any_of(rim.begin(), rim.end(),
                    [&](Halfedge h) { return is_between_narrow_and_wide(surface, h); }))
      for (const Halfedge h : rim) part.creases[surface.edge(h)] = true;
  }
}

// The least cosine of the angle between the normals of two known surfaces along an edge; -1 if they are not known.
double cosine_between(const Recognized_part& part, const Surface& surface, Patch_map segments,
                      Normals_of_surfaces normals, Edge e)
{
  const Halfedge h = surface.halfedge(e), g = surface.opposite(h);
  if (surface.is_border(e)) return -1;
  if (!part.is_known(segments[surface.face(h)]) || !part.is_known(segments[surface.face(g)]))
    return -1;
  return (std::min)(normals[h] * normals[surface.prev(g)], normals[g] * normals[surface.prev(h)]);
}

// Those with more vertices than determine them: a plane that is a triangle, or a warped quadrilateral, is a facet of anything.
std::vector<bool> sure_segments(const Recognized_part& part, const Surface& surface, double flat)
{
  std::vector<bool> sure;
  for (const Recognized_surface& s : part.surfaces)
    sure.push_back(s.kind != Kind::unknown &&
                   (s.kind != Kind::plane || (s.number_of_faces > 1 && s.residual <= flat)));
  for (const Face f : surface.faces()) {
    const Recognized_surface& s = part.surfaces[part.segments[f]];
    if (s.kind == Kind::plane && s.residual <= flat && surface.degree(f) > 3)
      sure[part.segments[f]] = true;
  }
  return sure;
}

void fill(Recognized_part& part, const Surface& surface, Patch_map segments, Crease_map creases,
          Normals_of_surfaces normals, double diagonal)
{
  const std::vector<bool> sure = sure_segments(part, surface, 1e-5 * diagonal);
  const auto is_among_sure_ones = [&](Face f) {
    const auto faces = CGAL::faces_around_face(surface.halfedge(f), surface);
    return std::all_of(faces.begin(), faces.end(),
                       [&](Face g) { return g == Surface::null_face() || sure[part.segments[g]]; });
  };
  for (const Face f : surface.faces()) {
    const double area = std::sqrt(place_of(surface, f).twice_area.squared_length()) / 2;
    part.area += area;
    if (!part.is_known(segments[f]))
      part.unknown_area += area;
    else if (sure[segments[f]] || is_among_sure_ones(f))
      part.sure_area += area;
  }
  const double cosine_of_2_degrees = std::cos(2 * CGAL_PI / 180),
               cosine_of_40_degrees = std::cos(40 * CGAL_PI / 180);
  for (const Edge e : surface.edges()) {
    part.creases.push_back(creases[e]);
    if (!creases[e]) continue;
    const double cosine = cosine_between(part, surface, segments, normals, e);
    const auto is_beside_round = [&](Halfedge h) {
      return is_round(part.surfaces[segments[surface.face(h)]].kind);
    };
    if (cosine >= cosine_of_2_degrees)
      ++part.tangent_creases;
    else if (cosine > cosine_of_40_degrees && is_beside_round(surface.halfedge(e)) &&
             is_beside_round(surface.opposite(surface.halfedge(e))))
      ++part.slight_creases;
  }
  for (const Halfedge h : surface.halfedges()) part.normals.push_back(normals[h]);
}

std::size_t number_of_known_faces(const std::vector<Recognized_surface>& surfaces)
{
  std::size_t result = 0;
  for (const Recognized_surface& s : surfaces)
    if (s.kind != Kind::unknown) result += s.number_of_faces;
  return result;
}

// A file of six digits that another program has scaled or moved has coordinates of all digits, and is taken for exact.
void try_tolerance_of_six_digits(Recognized_part& part, Surface& surface,
                                 const Recognition_plan& plan, const Bounding_box& box,
                                 double rounding)
{
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) largest = (std::max)({largest, -box.low[k], box.high[k]});
  if (rounding > std::ldexp(largest, -40)) return;
  const double tolerance = 2e-6 * diagonal_of(box);
  const auto segments = surface.add_property_map<Face, std::size_t>("f:other_segment", 0).first;
  const std::vector<Recognized_surface> found = PN::recognize_surfaces(
    surface, segments, PN::parameters::surface_tolerance(tolerance).min_facets(plan.min_facets));
  const std::size_t known = number_of_known_faces(found);
  if (10 * found.size() > 9 * part.surfaces.size() &&
      9 * known <= 10 * number_of_known_faces(part.surfaces))
    return;
  part.other_tolerance = tolerance;
  part.other_segments = found.size();
}

} // namespace

Face_place place_of(const Surface& surface, Face f)
{
  const Halfedge first = surface.halfedge(f);
  const Point_3& origin = surface.point(surface.target(first));
  Vector_3 sum(0, 0, 0), area(0, 0, 0), before(0, 0, 0);
  double squared_size = 0, n = 1;
  for (Halfedge h = surface.next(first); h != first; h = surface.next(h), ++n) {
    const Vector_3 d = surface.point(surface.target(h)) - origin;
    sum += d;
    area += CGAL::cross_product(before, d);
    squared_size = (std::max)(squared_size, d.squared_length());
    before = d;
  }
  return {origin + sum / n, area, std::sqrt(squared_size)};
}

bool is_round(Recognized_surface::Kind kind)
{
  return kind != Kind::plane && kind != Kind::unknown;
}

bool Recognized_part::knows_any() const
{
  return std::any_of(segments.begin(), segments.end(),
                     [&](std::size_t segment) { return is_known(segment); });
}

bool Recognized_part::is_sure() const
{
  bool has_plane = false, has_round = false;
  for (const Recognized_surface& s : surfaces) {
    has_plane = has_plane || s.kind == Kind::plane;
    has_round = has_round || (is_round(s.kind) && s.kind != Kind::cone);
  }
  const auto all_creases = std::size_t(std::count(creases.begin(), creases.end(), true));
  return sure_area >= 0.9 * area && has_plane && has_round && 2 * slight_creases <= all_creases;
}

Recognized_part recognize_part(const Mesh_data& mesh, const Recognition_plan& plan)
{
  Recognized_part part;
  Surface surface = make_surface(mesh);
  remove_normals_and_roundness(surface);
  const Patch_map segments = surface.add_property_map<Face, std::size_t>("f:segment", 0).first;
  const Crease_map creases = surface.add_property_map<Edge, bool>("e:is_crease", false).first;
  const Normals_of_surfaces normals =
    surface.add_property_map<Halfedge, Vector_3>("h:of_surface", CGAL::NULL_VECTOR).first;
  const auto corners = surface.add_property_map<Vertex, bool>("v:is_corner", false).first;
  const Roundness_map roundness = add_roundness(surface);
  const Bounding_box box(mesh.points);
  const double rounding = rounding_of(mesh.points), diagonal = diagonal_of(box);
  const auto np =
    PN::parameters::shared(PN::parameters::surface_tolerance(plan.tolerance.value_or(0))
                             .sharp_angle(plan.sharp_angle)
                             .min_facets(plan.min_facets));
  part.surfaces = PN::recognize_surfaces(surface, segments, np);
  if (!plan.tolerance && plan.tries_tolerances)
    try_tolerance_of_six_digits(part, surface, plan, box, rounding);
  for (const Face f : surface.faces()) part.segments.push_back(segments[f]);
  part.moved = Places_on_surfaces(surface, part.segments, part.surfaces).cut_vertices();
  for (const Moved_vertex& m : part.moved) surface.point(Vertex(unsigned(m.vertex))) = m.point;
  PN::surface_creases(surface, segments, part.surfaces, creases,
                      PN::parameters::join(PN::parameters::vertex_roundness_map(roundness)
                                             .vertex_is_constrained_map(corners)
                                             .vertex_normal_map(normals),
                                           np));
  for (const Vertex v : surface.vertices()) {
    if (corners[v]) part.corners.push_back(v);
    part.roundness.push_back(roundness[v]);
  }
  fill(part, surface, segments, creases, normals, diagonal);
  const std::vector<bool> is_at_end = vertices_at_ends(part, surface);
  tag_narrow_facets(part, surface, is_at_end);
  tag_caps(part, surface, is_at_end, 8 * rounding + 1e-7 * diagonal);
  return part;
}

void move_cut_vertices(Mesh_data& mesh, const Recognized_part& part)
{
  for (const Moved_vertex& m : part.moved) mesh.points[m.vertex] = to_triple(m.point);
}

void put_on_surfaces(Surface& refined, const std::vector<double>& parents,
                     const Recognized_part& part)
{
  std::vector<std::size_t> segments;
  for (const double parent : parents) segments.push_back(part.segments[std::size_t(parent)]);
  for (const Moved_vertex& m : Places_on_surfaces(refined, segments, part.surfaces).left_vertices())
    refined.point(Vertex(unsigned(m.vertex))) = m.point;
}

void put_surface_normals(Mesh_data& mesh, const Recognized_part& part, bool where_file_has_none)
{
  Surface surface = make_surface(mesh);
  std::vector<Vector_3> of_file(surface.number_of_halfedges(), CGAL::NULL_VECTOR);
  if (where_file_has_none) {
    const Wedges wedges(surface, [&](Edge e) { return bool(part.creases[e]); });
    const std::optional<Corner_normal_map> of_corners = corner_normals_of(surface);
    const Normal_map of_vertices = *normals_of(surface);
    for (const Halfedge h : surface.halfedges())
      if (of_corners)
        of_file[h] = (*of_corners)[h];
      else if (wedges.number[surface.target(h)] == 1)
        of_file[h] = of_vertices[surface.target(h)];
  }
  remove_normals(surface);
  add_normals(surface); // zero, of vertices without faces
  const Corner_normal_map normals = add_corner_normals(surface);
  for (const Halfedge h : surface.halfedges())
    normals[h] = of_file[h] == CGAL::NULL_VECTOR ? part.normals[h] : of_file[h];
  Mesh_data with_normals = to_mesh_data(surface);
  mesh.take_normals(with_normals);
  if (mesh.corner_normals.empty()) // or they would be estimated at creases inside surfaces
    for (const Index v : mesh.vertices_of_corners()) mesh.corner_normals.push_back(mesh.normals[v]);
}

} // namespace pn_subdivide
