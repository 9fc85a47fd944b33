// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_CONTROL_MESH_IO_H
#define CGAL_PN_SUBDIVISION_3_CONTROL_MESH_IO_H

#include <CGAL/PN_subdivision_3/estimate_control_normals.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Control_file.h>
#include <CGAL/PN_subdivision_3/internal/meshes/build_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/crease_maps.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3 {
namespace internal {

// a sharpness as a map of constraints has it
template <class Value>
Value constraint_as(double sharpness)
{
  if constexpr (std::is_same_v<Value, bool>)
    return sharpness > 0;
  else if constexpr (std::is_integral_v<Value>)
    return sharpness < double((std::numeric_limits<Value>::max)()) ? Value(sharpness)
                                                                   : sharp_for_ever<Value>();
  else
    return sharpness == infinite_sharpness ? sharp_for_ever<Value>() : Value(sharpness);
}

using Ends = std::pair<std::size_t, std::size_t>;
inline Ends ends_of_edge(const Level_connectivity& level, Level_connectivity::Index e)
{
  return std::minmax(std::size_t(level.target(2 * e)), std::size_t(level.target(2 * e + 1)));
}

// the sharpness of the edges of a level
inline std::vector<double> sharpness_of_edges(const Control_file& file,
                                              const Level_connectivity& level)
{
  std::map<Ends, double> sharp;
  for (const auto& edge : file.edges)
    sharp[std::minmax(edge.ends[0], edge.ends[1])] = checked_sharpness(edge.sharpness, [&] {
      return file.name + ": the edge from vertex " + std::to_string(edge.ends[0]) + " to vertex " +
             std::to_string(edge.ends[1]);
    });
  std::vector<double> all(level.number_of_edges(), 0);
  for (Level_connectivity::Index e = 0; e < all.size() && !sharp.empty(); ++e)
    if (const auto found = sharp.find(ends_of_edge(level, e)); found != sharp.end()) {
      all[e] = found->second;
      sharp.erase(found);
    }
  if (!sharp.empty())
    refuse_file(file.name, "no face has the sharp edge from vertex " +
                             std::to_string(sharp.begin()->first.first) + " to vertex " +
                             std::to_string(sharp.begin()->first.second));
  return all;
}

// puts what a file has into a mesh with its connectivity, of which `level` is a copy
template <class Access>
struct Control_data_writer
{
  using Index = Level_connectivity::Index;

  Access& access;
  const Control_file& file;
  const Level_connectivity& level;

  template <class Edge_map, class Vertex_map>
  void put_creases(const std::vector<double>& sharpness, [[maybe_unused]] Edge_map edges,
                   [[maybe_unused]] Vertex_map vertices) const
  {
    if constexpr (is_constraint_map_v<Edge_map>)
      for (Index e = 0; e < sharpness.size(); ++e)
        put(edges, access.edge_at(e),
            constraint_as<typename boost::property_traits<Edge_map>::value_type>(sharpness[e]));
    if constexpr (is_constraint_map_v<Vertex_map>)
      for (Index v = 0; v < file.points.size(); ++v)
        put(vertices, access.vertex(v),
            constraint_as<typename boost::property_traits<Vertex_map>::value_type>(
              file.sharpness.empty() ? 0 : file.sharpness[v]));
  }

  // over the estimate; where a vertex has several normals it has its own of the file only if that is all that is asked for
  template <class Key, class Kernel>
  void put_normals(const std::vector<double>& sharpness,
                   const Estimated_control_normals<Key, Kernel>& map) const
  {
    if constexpr (std::is_same_v<Key, typename Access::vertex_descriptor>) {
      for (Index v = 0; v < file.points.size(); ++v) put_normal(v, access.vertex(v), map);
    } else {
      std::vector<bool> has_wedges(file.points.size(), false);
      for (Index e = 0; e < sharpness.size(); ++e)
        if (sharpness[e] > 0 && !level.is_border_edge(e))
          has_wedges[level.target(2 * e)] = has_wedges[level.target(2 * e + 1)] = true;
      for (Index h = 0; h < level.number_of_halfedges(); ++h)
        if (!level.is_border(h) && !has_wedges[level.target(h)])
          put_normal(level.target(h), access.halfedge_at(h), map);
    }
  }

private:
  template <class Key, class Kernel>
  void put_normal(Index v, const Key& key, const Estimated_control_normals<Key, Kernel>& map) const
  {
    using FT = typename Kernel::FT;
    if (!file.normals.empty()) {
      const auto& n = file.normals[v];
      put(map, key, typename Kernel::Vector_3(FT(n.x()), FT(n.y()), FT(n.z())));
    }
    if (!file.roundness.empty()) put(map.roundness_map(), key, FT(file.roundness[v]));
  }
};

// the normal and the roundness of the vertices as they are written: of several normals the mean, and the least roundness
template <class Access, class Normal_map>
std::vector<std::array<double, 4>>
written_normals(const Access& access, const Level_connectivity& level, const Normal_map& map)
{
  using Index = Level_connectivity::Index;
  std::vector<std::array<double, 4>> all(level.number_of_vertices(), {0, 0, 0, 1});
  const auto add = [&all](Index v, const auto& n, double w) {
    for (int i = 0; i < 3; ++i) all[v][i] += CGAL::to_double(n[i]);
    all[v][3] = (std::min)(all[v][3], w);
  };
  if constexpr (std::is_same_v<Key_of_map<Normal_map>, typename Access::vertex_descriptor>) {
    for (Index v = 0; v < all.size(); ++v) add(v, get(map, access.vertex(v)), 1);
  } else if constexpr (!std::is_same_v<Normal_map, No_normal_map>) {
    for (Index h = 0; h < level.number_of_halfedges(); ++h) {
      if (level.is_border(h)) continue;
      const auto whole = get_whole(map, access.halfedge_at(h));
      if constexpr (goes_with_roundness_v<Normal_map>)
        add(level.target(h), whole.normal, CGAL::to_double(whole.roundness));
      else
        add(level.target(h), whole, 1);
    }
    for (auto& n : all)
      if (const double length = std::hypot(n[0], n[1], n[2]); length > 0)
        for (int i = 0; i < 3; ++i) n[i] /= length;
  }
  return all;
}

template <class PolygonMesh, class NamedParameters>
void write_ply(std::ostream& out, const PolygonMesh& mesh, const NamedParameters& np)
{
  using Parameters = Surface_parameters<PolygonMesh, NamedParameters>;
  using Normal_map = typename Parameters::Normal_map;
  using Edge_map = typename Parameters::Edge_constraint_map;
  using Vertex_map = typename Parameters::Vertex_constraint_map;
  using Roundness_map = typename Parameters::Roundness_map;
  using Index = Level_connectivity::Index;
  with_mesh_access(mesh, [&](const auto& access) {
    Ply_of_level ply;
    ply.level = checked_level(access);
    const auto points = Parameters::const_point_map(mesh, np);
    const auto normals = written_normals(access, ply.level, Parameters::normal_map(np));
    for (const int i : {0, 1, 2})
      ply.columns.emplace_back(std::string(1, "xyz"[i]), [&, i](Index v) {
        return CGAL::to_double(get(points, access.vertex(v))[i]);
      });
    if (!std::is_same_v<Normal_map, No_normal_map>)
      for (const int i : {0, 1, 2})
        ply.columns.emplace_back(std::string("n") + "xyz"[i],
                                 [&, i](Index v) { return normals[v][i]; });
    if constexpr (is_given_roundness_v<Roundness_map>)
      ply.columns.emplace_back("roundness", [&](Index v) {
        return CGAL::to_double(get(Parameters::roundness_map(np), access.vertex(v)));
      });
    else if (goes_with_roundness_v<Normal_map>)
      ply.columns.emplace_back("roundness", [&](Index v) { return normals[v][3]; });
    if constexpr (is_constraint_map_v<Vertex_map>)
      ply.columns.emplace_back("sharpness", [&](Index v) {
        return sharpness_in(Parameters::vertex_constraint_map(np), access.vertex(v));
      });
    ply.has_edges = is_constraint_map_v<Edge_map> || is_constraint_map_v<Vertex_map>;
    if constexpr (is_constraint_map_v<Edge_map>)
      for (Index e = 0; e < ply.level.number_of_edges(); ++e)
        if (const double s = sharpness_in(Parameters::edge_constraint_map(np), access.edge_at(e));
            s > 0)
          ply.sharp_edges.emplace_back(e, s);
    ply.write(out);
  });
}

// what CGAL's writers take, in numbers that are read as they were
template <class PolygonMesh, class NamedParameters>
bool write_by_cgal(const std::string& name, const PolygonMesh& mesh, const NamedParameters& np)
{
  using Parameters = Surface_parameters<PolygonMesh, NamedParameters>;
  const std::string ending = IO::internal::get_file_extension(name);
  if (ending == "stl")
    for (const auto f : faces(mesh))
      if (CGAL::halfedges_around_face(halfedge(f, mesh), mesh).size() != 3)
        refuse_file(
          name,
          "STL has triangles only: call CGAL::Polygon_mesh_processing::triangulate_faces() first");
  const auto of_points =
    CGAL::parameters::vertex_point_map(Parameters::const_point_map(mesh, np)).stream_precision(17);
  if constexpr (std::is_same_v<Key_of_map<typename Parameters::Normal_map>,
                               typename boost::graph_traits<PolygonMesh>::vertex_descriptor>)
    if (ending == "off")
      return IO::write_OFF(name, mesh, of_points.vertex_normal_map(Parameters::normal_map(np)));
  return IO::write_polygon_mesh(name, mesh, of_points);
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Functions

reads a control mesh from a file, with its normals, its roundness and what is sharp; what the file has not is estimated.
\code{.cpp}
auto sharp = mesh.add_property_map<Mesh::Edge_index, double>("e:sharp", 0).first;
auto np = CGAL::parameters::edge_is_constrained_map(sharp);
auto normals = PN::read_control_mesh("part.ply", mesh, np);
PN::CatmullClark_subdivision(mesh, np.vertex_normal_map(normals).number_of_iterations(3));
PN::write_refined_mesh("fine.ply", mesh, np.vertex_normal_map(normals));
\endcode
\ref PN_subdivision_3_files has what is read of each format. Vertices and faces keep the order of the file.

\tparam PolygonMesh a model of `MutableFaceGraph` that can be default-constructed
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param file_name the name of a file, whose ending says what it is
\param mesh an empty mesh
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `geom_traits`,
  `edge_is_constrained_map` and `vertex_is_constrained_map`, which are written (a map of `bool` has `true` for all that is sharp), and
  `border` and `control_normal_estimate` as of `estimate_control_normals()`

\returns the control normals with their roundness, as `estimate_control_normals()` returns them: of vertices or, if one of the parameters
  that tell what is sharp is given, of half-edges. The file's count where it has some, but where a vertex has several they are estimated.

\throws std::runtime_error if the file cannot be read, or its faces are no oriented 2-manifold with border
\throws std::invalid_argument if the mesh is not empty, a vertex joins several fans of faces, a point is not finite, or a sharpness
  is negative or not a number.
<br><b>Strong guarantee:</b> The mesh is empty then.
*/
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters>
auto read_control_mesh(const std::string& file_name, PolygonMesh& mesh,
                       const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::control_normal_estimate_t,
                           internal::border_t>();
  internal::Estimate_of_call<PolygonMesh, NamedParameters> normals;
  if constexpr (internal::check_build_arguments<PolygonMesh, NamedParameters>()) {
    using Parameters = internal::Surface_parameters<PolygonMesh, NamedParameters>;
    using Point = typename boost::property_traits<typename Parameters::Point_map>::value_type;
    using FT = typename Parameters::FT;
    const internal::Control_file file = internal::read_control_file(file_name);
    const Level_connectivity level = internal::level_of_file<PolygonMesh>(file);
    const std::vector<double> sharpness = internal::sharpness_of_edges(file, level);
    std::vector<Point> points;
    for (const auto& p : file.points) points.emplace_back(FT(p.x()), FT(p.y()), FT(p.z()));
    internal::with_mesh_access(mesh, [&](auto& access) {
      internal::build_mesh(access, level, Parameters::point_map(mesh, np), points,
                           internal::No_normal_map(), std::vector<char>(), [] {});
      try {
        using Access = std::decay_t<decltype(access)>;
        const internal::Control_data_writer<Access> writer{access, file, level};
        writer.put_creases(sharpness, Parameters::edge_constraint_map(np),
                           Parameters::vertex_constraint_map(np));
        normals = estimate_control_normals(mesh, np);
        writer.put_normals(sharpness, normals);
      } catch (...) {
        access.shrink();
        throw;
      }
    });
  }
  return normals;
}

/*!
\ingroup PkgPNSubdivision3Functions

writes a mesh to a file, with the data that the parameters name. PLY files have normals, roundness and sharpness, OFF
files normals of vertices. The other formats that \cgal writes have none of these. `read_control_mesh()` and the
command read them again.

\tparam PolygonMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param file_name the name of the file, whose ending says what it will be
\param mesh an oriented 2-manifold with border
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters", with the meaning that they have for `subdivide()`:
  `vertex_point_map`, `geom_traits`, `vertex_normal_map`, `vertex_roundness_map`, `edge_is_constrained_map` and
  `vertex_is_constrained_map`. A vertex gets the mean of the normals of its corners.

\throws std::runtime_error if the file cannot be written, or has a format that cannot take the faces
\throws std::invalid_argument if a PLY file is asked for, and the mesh is not an oriented 2-manifold with border
*/
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters>
void write_refined_mesh(const std::string& file_name, const PolygonMesh& mesh,
                        const NamedParameters& np = parameters::default_values())
{
  internal::check_are_read<NamedParameters, internal::vertex_roundness_map_t>();
  bool is_written = false;
  if (IO::internal::get_file_extension(file_name) == "ply") {
    std::ofstream out(file_name, std::ios::binary);
    if (out) internal::write_ply(out, mesh, np);
    out.close();
    is_written = !out.fail();
  } else
    is_written = internal::write_by_cgal(file_name, mesh, np);
  if (!is_written)
    internal::refuse_file(
      file_name, "the file cannot be written; its name must end in .ply, .off, .obj or .stl");
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_CONTROL_MESH_IO_H
