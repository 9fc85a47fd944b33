// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Control_mesh.h"

#include "io/Error.h"
#include "io/formats.h"
#include "io/mesh_normals.h"
#include "io/soup_repair.h"

#include <CGAL/PN_subdivision_3/detect_creases.h>
#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/parameters/parameters.h>

#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Dense>

#include <algorithm>
#include <limits>
#include <utility>

namespace pn_demo {
namespace {

using pn_subdivide::Error;
using Halfedge = Surface::Halfedge_index;
using Edge = Surface::Edge_index;

constexpr double sharp_for_ever = std::numeric_limits<double>::infinity();

Mesh_data read_format(const std::string& content, const std::string& format)
{
  if (content.empty()) throw Error("the file is empty");
  if (format == "ply") return pn_subdivide::read_ply(content, false);
  if (format == "off") return pn_subdivide::read_off(content, false);
  if (format == "obj") return pn_subdivide::read_obj(content, false);
  if (format == "stl") return pn_subdivide::read_stl(content, false);
  throw Error("the format must be ply, off, obj or stl");
}

void require_manifold(const Mesh_data& mesh)
{
  pn_subdivide::require_finite_elements(mesh);
  std::vector<std::size_t> last_face(mesh.points.size(), mesh.number_of_faces());
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Mesh_data::Index v : mesh.face(f)) {
      if (last_face[v] == f)
        throw Error("this is no oriented manifold: face " + std::to_string(f) + " visits vertex " +
                    std::to_string(v) + " twice");
      last_face[v] = f;
    }
  const pn_subdivide::Soup_defects defects = pn_subdivide::find_defects(mesh);
  if (!defects.none()) throw Error("this is no oriented manifold: " + defects.description(mesh));
}

// As the command does without --normals. Returns where the normals come from then.
std::string drop_normals_that_say_nothing(Mesh_data& mesh)
{
  const std::string estimated = "estimated from the points";
  if (!mesh.has_normals()) return estimated;
  const pn_subdivide::Flat_shading flat = pn_subdivide::find_flat_shading(mesh);
  const bool is_flat = flat.is_there() && !flat.makes_creases();
  const bool is_shading =
    !mesh.are_said_to_be_control && !flat.is_there() && pn_subdivide::find_shading(mesh).is_there();
  const bool are_zero = pn_subdivide::are_all_zero(mesh);
  if (!are_zero && !is_flat && !is_shading) return "of the file";
  mesh.normals.clear();
  mesh.corner_normals.clear();
  mesh.roundness.clear();
  mesh.corner_roundness.clear();
  return are_zero ? estimated : estimated + ": those of the file are for shading";
}

// Cuts off ears, those with the shortest diagonals first.
void add_triangles(std::vector<std::uint32_t> face, const std::vector<double>& points,
                   Mesh_state& result)
{
  const auto squared_length = [&](std::uint32_t a, std::uint32_t b) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = points[3 * a + k] - points[3 * b + k];
      sum += d * d;
    }
    return sum;
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    result.degrees.push_back(3);
    result.corners.insert(result.corners.end(), {a, b, c});
  };
  while (face.size() > 3) {
    const std::size_t n = face.size();
    std::size_t best = 0;
    for (std::size_t i = 1; i < n; ++i)
      if (squared_length(face[i], face[(i + 2) % n]) <
          squared_length(face[best], face[(best + 2) % n]))
        best = i;
    add(face[best], face[(best + 1) % n], face[(best + 2) % n]);
    face.erase(face.begin() + std::ptrdiff_t((best + 1) % n));
  }
  add(face[0], face[1], face[2]);
}

double roundness_of_corner(const Mesh_state& state, std::size_t c)
{
  if (state.roundness.empty()) return 1;
  return state.roundness[3 * state.roundness.size() == state.points.size() ? state.corners[c] : c];
}

} // namespace

Control_mesh Control_mesh::read(const std::string& content, const std::string& format, bool repairs)
{
  Mesh_data mesh = read_format(content, format);
  pn_subdivide::require_finite_elements(mesh);
  // the triangles of STL share no vertices
  if (format == "stl")
    pn_subdivide::merge_near_points(mesh, pn_subdivide::rounding_of_floats(mesh.points));
  Control_mesh result;
  if (repairs) {
    const pn_subdivide::Soup_repair repair = pn_subdivide::repair_soup(mesh);
    if (repair.changed_anything()) result.repair_ = repair.description();
  }
  require_manifold(mesh);
  result.normals_from_ = drop_normals_that_say_nothing(mesh);
  result.fill(mesh);
  result.mark_creases(mesh);
  result.wedges_ =
    std::make_unique<Wedges>(result.surface_, [&](Edge e) { return result.is_sharp(e); });
  if (!mesh.has_normals()) result.estimate_normals();
  return result;
}

Control_mesh::Control_mesh(const Mesh_state& state)
{
  Mesh_data mesh;
  for (std::size_t i = 0; i + 2 < state.points.size(); i += 3)
    mesh.points.push_back({state.points[i], state.points[i + 1], state.points[i + 2]});
  auto corner = state.corners.begin();
  for (const std::uint32_t degree : state.degrees) {
    if (degree < 3 || degree > std::size_t(state.corners.end() - corner))
      throw Error("the faces do not fit their vertices");
    mesh.add_face(std::vector<std::uint32_t>(corner, corner + degree));
    corner += degree;
  }
  for (const std::uint32_t v : state.corners)
    if (v >= mesh.points.size()) throw Error("vertex " + std::to_string(v) + " is out of range");
  require_manifold(mesh);
  fill(mesh);
  const bool has_normals = state.corner_normals.size() == 3 * state.corners.size();
  const std::vector<Halfedge> corners = pn_subdivide::corners_of(surface_);
  if (!state.uv.empty()) uv_.assign(2 * surface_.number_of_halfedges(), 0);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const double* const n = state.corner_normals.data() + 3 * c;
    if (has_normals) normals_[corners[c]] = Vector_3(n[0], n[1], n[2]);
    for (std::size_t k = 0; k < 2 && !uv_.empty(); ++k)
      uv_[2 * corners[c] + k] = state.uv.at(2 * c + k);
  }
  for (std::size_t i = 0; i + 1 < state.sharp_edges.size(); i += 2) {
    const std::uint32_t a = state.sharp_edges[i], b = state.sharp_edges[i + 1];
    const Halfedge h = (std::max)(a, b) < mesh.points.size()
                         ? surface_.halfedge(Surface::Vertex_index(a), Surface::Vertex_index(b))
                         : Surface::null_halfedge();
    if (h == Surface::null_halfedge())
      throw Error("the mesh has no edge from vertex " + std::to_string(a) + " to vertex " +
                  std::to_string(b));
    sharpness_[surface_.edge(h)] = sharp_for_ever;
  }
  wedges_ = std::make_unique<Wedges>(surface_, [this](Edge e) { return is_sharp(e); });
  if (!has_normals) estimate_normals();
  if (state.roundness.size() != mesh.points.size() && state.roundness.size() != corners.size())
    return;
  for (std::size_t c = 0; c < corners.size(); ++c)
    normals_.values[corners[c]].roundness = roundness_of_corner(state, c);
}

void Control_mesh::fill(const Mesh_data& mesh)
{
  surface_ = pn_subdivide::make_surface(mesh);
  sharpness_ = surface_.add_property_map<Edge, double>("e:sharpness", 0).first;
  if (!pn_subdivide::normals_of(surface_)) pn_subdivide::add_normals(surface_);
  const auto of_corners = pn_subdivide::corner_normals_of(surface_);
  normals_ = of_corners ? *of_corners : pn_subdivide::add_corner_normals(surface_);
}

void Control_mesh::mark_creases(const Mesh_data& mesh)
{
  if (mesh.tags.edges.empty() && mesh.has_corner_normals()) mark_edges_where_normals_differ();
  for (const auto& tag : mesh.tags.edges) {
    const Halfedge h =
      surface_.halfedge(Surface::Vertex_index(tag.ends[0]), Surface::Vertex_index(tag.ends[1]));
    if (h != Surface::null_halfedge()) sharpness_[surface_.edge(h)] = sharp_for_ever;
  }
}

// As the command does without --sharp.
void Control_mesh::mark_edges_where_normals_differ()
{
  const auto differ = [&](Halfedge h, Halfedge g) {
    return normals_[h] != CGAL::NULL_VECTOR && normals_[g] != CGAL::NULL_VECTOR &&
           pn_subdivide::directions_differ(pn_subdivide::to_triple(normals_[h]),
                                           pn_subdivide::to_triple(normals_[g]));
  };
  for (const Edge e : surface_.edges()) {
    if (surface_.is_border(e)) continue;
    const Halfedge h = surface_.halfedge(e), g = surface_.opposite(h);
    if (differ(h, surface_.prev(g)) || differ(g, surface_.prev(h))) sharpness_[e] = sharp_for_ever;
  }
}

Mesh_state Control_mesh::state() const
{
  Mesh_state s;
  for (const auto v : surface_.vertices())
    for (int k = 0; k < 3; ++k) s.points.push_back(surface_.point(v)[k]);
  for (const auto f : surface_.faces()) {
    s.degrees.push_back(surface_.degree(f));
    for (const Halfedge h : halfedges_around_face(surface_.halfedge(f), surface_)) {
      s.corners.push_back(std::uint32_t(surface_.target(h)));
      for (int k = 0; k < 3; ++k) s.corner_normals.push_back(normals_[h][k]);
      if (!uv_.empty()) s.uv.insert(s.uv.end(), {uv_[2 * h], uv_[2 * h + 1]});
    }
  }
  for (const Edge e : surface_.edges())
    if (is_sharp(e))
      for (unsigned i = 0; i < 2; ++i)
        s.sharp_edges.push_back(std::uint32_t(surface_.vertex(e, i)));
  if (!has_roundness()) return s;
  s.roundness.assign(surface_.number_of_vertices(), 1);
  std::vector<double> of_corners;
  bool differ = false;
  for (const auto v : surface_.vertices()) s.roundness[v] = value_at(v).roundness;
  for (const Halfedge h : pn_subdivide::corners_of(surface_)) {
    of_corners.push_back(value_at(h).roundness);
    differ = differ || of_corners.back() != s.roundness[surface_.target(h)];
  }
  if (differ) s.roundness = std::move(of_corners);
  return s;
}

bool Control_mesh::has_only_triangles() const
{
  const auto faces = surface_.faces();
  return std::all_of(faces.begin(), faces.end(), [&](auto f) { return surface_.degree(f) == 3; });
}

Control_mesh Control_mesh::triangulated() const
{
  const Mesh_state old = state();
  Mesh_state split;
  split.points = old.points;
  split.sharp_edges = old.sharp_edges;
  std::size_t first = 0;
  for (const std::uint32_t degree : old.degrees) {
    const std::size_t first_new = split.corners.size();
    add_triangles({old.corners.begin() + std::ptrdiff_t(first),
                   old.corners.begin() + std::ptrdiff_t(first + degree)},
                  old.points, split);
    for (std::size_t c = first_new; c < split.corners.size(); ++c) {
      const auto begin = old.corners.begin() + std::ptrdiff_t(first);
      const auto place = std::find(begin, begin + degree, split.corners[c]) - old.corners.begin();
      for (std::ptrdiff_t k = 0; k < 3; ++k)
        split.corner_normals.push_back(old.corner_normals[std::size_t(3 * place + k)]);
      if (!old.roundness.empty())
        split.roundness.push_back(roundness_of_corner(old, std::size_t(place)));
      for (std::ptrdiff_t k = 0; k < 2 && !old.uv.empty(); ++k)
        split.uv.push_back(old.uv[std::size_t(2 * place + k)]);
    }
    first += degree;
  }
  return Control_mesh(split);
}

std::size_t Control_mesh::number_of_sharp_edges() const
{
  const auto edges = surface_.edges();
  return std::size_t(
    std::count_if(edges.begin(), edges.end(), [this](Edge e) { return is_sharp(e); }));
}

void Control_mesh::set_point(std::size_t v, const Point_3& p)
{
  surface_.point(Surface::Vertex_index(Surface::size_type(v))) = p;
}

void Control_mesh::set_normal(std::size_t wedge, const Vector_3& n)
{
  const Surface::Vertex_index v = wedges_->vertex.at(wedge);
  for (const Halfedge h : halfedges_around_target(v, surface_))
    if (!surface_.is_border(h) && wedges_->of_corner[h] == wedge) normals_[h] = n;
}

void Control_mesh::set_sharp(std::size_t edge, bool is_sharp)
{
  sharpness_[Edge(Surface::size_type(edge))] = is_sharp ? sharp_for_ever : 0;
  replace_wedges();
}

std::size_t Control_mesh::detect_creases(double degrees)
{
  const std::size_t n = CGAL::PN_subdivision_3::detect_creases(surface_, degrees, sharpness_);
  replace_wedges();
  return n;
}

void Control_mesh::replace_wedges()
{
  const std::unique_ptr<Wedges> old = std::move(wedges_);
  wedges_ = std::make_unique<Wedges>(surface_, [this](Edge e) { return is_sharp(e); });
  // a wedge is the same if its corners are those of one old wedge
  const auto corners_of = [](const Wedges& wedges) {
    std::vector<std::size_t> n(wedges.vertex.size(), 0);
    for (const std::size_t w : wedges.of_corner)
      if (w != Wedges::none) ++n[w];
    return n;
  };
  const std::vector<std::size_t> old_size = corners_of(*old), size = corners_of(*wedges_);
  std::vector<bool> is_new(size.size(), false);
  for (const Halfedge h : surface_.halfedges()) {
    if (surface_.is_border(h)) continue;
    const std::size_t w = wedges_->of_corner[h];
    if (old_size[old->of_corner[h]] != size[w]) is_new[w] = true;
  }
  const std::vector<Corner_value> estimated = estimate();
  for_each_corner([&](Halfedge h) {
    if (is_new[wedges_->of_corner[h]]) normals_[h] = estimated[h].normal;
  });
}

std::vector<Corner_value> Control_mesh::estimate() const
{
  namespace PN = CGAL::PN_subdivision_3;
  const auto estimated =
    PN::estimate_control_normals(surface_, PN::parameters::edge_is_constrained_map(sharpness_));
  std::vector<Corner_value> result(surface_.number_of_halfedges());
  for_each_corner([&](Halfedge h) {
    result[h] = {estimated[h], get(estimated.roundness_map(), h)};
  });
  return result;
}

template <class Function>
void Control_mesh::for_each_corner(const Function& f) const
{
  for (const Halfedge h : surface_.halfedges())
    if (!surface_.is_border(h)) f(h);
}

Corner_value Control_mesh::value_at(Surface::Vertex_index v) const
{
  if (surface_.is_isolated(v)) return {CGAL::NULL_VECTOR, 1};
  const Halfedge h = surface_.halfedge(v);
  return value_at(surface_.is_border(h) ? surface_.prev(surface_.opposite(h)) : h);
}

void Control_mesh::drop_normals()
{
  for (const Halfedge h : surface_.halfedges()) normals_[h] = CGAL::NULL_VECTOR;
}

void Control_mesh::estimate_normals()
{
  const std::vector<Corner_value> estimated = estimate();
  for_each_corner([&](Halfedge h) { normals_.put_whole(h, estimated[h]); });
}

bool Control_mesh::has_roundness() const
{
  bool has = false;
  for_each_corner([&](Halfedge h) { has = has || value_at(h).roundness != 1; });
  return has;
}

void Control_mesh::set_roundness(double w)
{
  if (!(w >= 0 && w <= 1)) throw Error("the roundness must be from 0 to 1");
  for (const Halfedge h : surface_.halfedges()) normals_.values[h].roundness = w;
}

void Control_mesh::estimate_roundness()
{
  const std::vector<Corner_value> estimated = estimate();
  for_each_corner([&](Halfedge h) { normals_.values[h].roundness = estimated[h].roundness; });
}

// |p - c|^2 = r^2 is linear in c and r^2 - |c|^2.
void Control_mesh::take_normals_of_sphere()
{
  const auto n = Eigen::Index(surface_.number_of_vertices());
  Eigen::MatrixXd a(n, 4);
  Eigen::VectorXd b(n);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  const auto to_eigen = [&](auto v) {
    const Point_3& p = surface_.point(v);
    return Eigen::Vector3d(p.x(), p.y(), p.z());
  };
  for (const auto v : surface_.vertices()) mean += to_eigen(v) / double(n);
  Eigen::Index i = 0;
  for (const auto v : surface_.vertices()) {
    const Eigen::Vector3d d = to_eigen(v) - mean;
    a.row(i) << 2 * d.transpose(), 1;
    b(i++) = d.squaredNorm();
  }
  const Eigen::Vector3d c = mean + a.completeOrthogonalDecomposition().solve(b).head<3>().eval();
  for (const Halfedge h : surface_.halfedges()) {
    const Point_3& p = surface_.point(surface_.target(h));
    normals_[h] = p - Point_3(c[0], c[1], c[2]);
  }
  set_roundness(1);
}

} // namespace pn_demo
