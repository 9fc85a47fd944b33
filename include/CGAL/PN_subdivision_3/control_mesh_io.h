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
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_writer.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Undoable_map.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>
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

template <class Map, class Element>
void put_constraints([[maybe_unused]] Map map,
                     [[maybe_unused]] const std::vector<double>& sharpness,
                     [[maybe_unused]] const Element& element)
{
  if constexpr (is_there_v<Map>)
    for (Level_connectivity::Index i = 0; i < sharpness.size(); ++i)
      put(map, element(i),
          constraint_as<typename boost::property_traits<Map>::value_type>(sharpness[i]));
}

// over the estimate; where a vertex has several normals it has its own of the file only if that is all that is asked for
template <class Access, class Key, class Kernel>
void put_normals(const Access& access, const Control_file& file, const Level_connectivity& level,
                 [[maybe_unused]] const std::vector<double>& sharpness,
                 const Estimated_control_normals<Key, Kernel>& map)
{
  using FT = typename Kernel::FT;
  using Index = Level_connectivity::Index;
  const auto put_normal = [&](Index v, const Key& key) {
    if (!file.normals.empty()) {
      const auto& n = file.normals[v];
      put(map, key, typename Kernel::Vector_3(FT(n.x()), FT(n.y()), FT(n.z())));
    }
    if (!file.roundness.empty()) put(map.roundness_map(), key, FT(file.roundness[v]));
  };
  if constexpr (std::is_same_v<Key, typename Access::vertex_descriptor>) {
    for (Index v = 0; v < file.points.size(); ++v) put_normal(v, access.vertex(v));
  } else {
    std::vector<bool> has_wedges(file.points.size(), false);
    for (Index e = 0; e < sharpness.size(); ++e)
      if (sharpness[e] > 0 && !level.is_border_edge(e))
        has_wedges[level.target(2 * e)] = has_wedges[level.target(2 * e + 1)] = true;
    for (Index h = 0; h < level.number_of_halfedges(); ++h)
      if (!level.is_border(h) && !has_wedges[level.target(h)])
        put_normal(level.target(h), access.halfedge_at(h));
  }
}

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
  } else if constexpr (is_there_v<Normal_map>) {
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

// writes in the order of bytes of this processor; the properties of vertices are numbers, one column each
inline void
write_ply_elements(std::ostream& out, const Level_connectivity& level,
                   const std::string& properties, const std::vector<std::vector<double>>& columns,
                   const std::vector<std::pair<Level_connectivity::Index, double>>* edges)
{
  using Index = Level_connectivity::Index;
  out.imbue(std::locale::classic());
  const std::uint16_t one = 1;
  const bool is_little = reinterpret_cast<const char&>(one) == 1;
  out << "ply\nformat binary_" << (is_little ? "little" : "big")
      << "_endian 1.0\ncomment control normals\n"
      << "element vertex " << level.number_of_vertices() << '\n'
      << properties << "element face " << level.number_of_faces()
      << "\nproperty list uint uint vertex_indices\n";
  if (edges != nullptr)
    out << "element edge " << edges->size()
        << "\nproperty uint vertex1\nproperty uint vertex2\nproperty double sharpness\n";
  out << "end_header\n";
  const auto write = [&out](const auto& x) {
    out.write(reinterpret_cast<const char*>(&x), sizeof x);
  };
  for (Index v = 0; v < level.number_of_vertices(); ++v)
    for (const auto& column : columns) write(column[v]);
  for (Index f = 0; f < level.number_of_faces(); ++f) {
    Index h = level.halfedge_of_face(f);
    const Index degree = level.degree(h);
    write(degree);
    for (Index i = 0; i < degree; ++i, h = level.next(h)) write(level.target(h));
  }
  if (edges == nullptr) return;
  for (const auto& [e, sharpness] : *edges) {
    write(level.target(2 * e + 1));
    write(level.target(2 * e));
    write(sharpness);
  }
}

template <class PolygonMesh, class NamedParameters>
void write_ply(std::ostream& out, const PolygonMesh& mesh, const NamedParameters& np)
{
  using Parameters = Surface_parameters<PolygonMesh, NamedParameters>;
  using Normal_map = typename Parameters::Normal_map;
  using Index = Level_connectivity::Index;
  constexpr bool has_edges = is_there_v<typename Parameters::Edge_constraint_map>,
                 has_corners = is_there_v<typename Parameters::Vertex_constraint_map>,
                 has_roundness = is_there_v<typename Parameters::Roundness_map>;
  with_mesh_access(mesh, [&](const auto& access) {
    const Level_connectivity level = checked_level(access);
    const auto points = Parameters::const_point_map(mesh, np);
    const auto normals = written_normals(access, level, Parameters::normal_map(np));
    std::vector<std::vector<double>> columns;
    std::ostringstream properties;
    const auto add = [&](const char* name, const auto& value) {
      properties << "property double " << name << '\n';
      columns.emplace_back();
      for (Index v = 0; v < level.number_of_vertices(); ++v) columns.back().push_back(value(v));
    };
    for (const int i : {0, 1, 2})
      add(std::array{"x", "y", "z"}[i],
          [&](Index v) { return CGAL::to_double(get(points, access.vertex(v))[i]); });
    for (const int i : {0, 1, 2})
      if (is_there_v<Normal_map>)
        add(std::array{"nx", "ny", "nz"}[i], [&](Index v) { return normals[v][i]; });
    if constexpr (has_roundness)
      add("roundness", [&](Index v) {
        return CGAL::to_double(get(Parameters::roundness_map(np), access.vertex(v)));
      });
    else if (goes_with_roundness_v<Normal_map>)
      add("roundness", [&](Index v) { return normals[v][3]; });
    if constexpr (has_corners)
      add("sharpness", [&](Index v) {
        return sharpness_in(Parameters::vertex_constraint_map(np), access.vertex(v));
      });
    std::vector<std::pair<Index, double>> edges;
    if constexpr (has_edges)
      for (Index e = 0; e < level.number_of_edges(); ++e)
        if (const double s = sharpness_in(Parameters::edge_constraint_map(np), access.edge_at(e));
            s > 0)
          edges.emplace_back(e, s);
    write_ply_elements(out, level, properties.str(), columns,
                       has_edges || has_corners ? &edges : nullptr);
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
    std::vector<double> corners = file.sharpness;
    corners.resize(file.points.size(), 0);
    std::vector<Point> points;
    for (const auto& p : file.points) points.emplace_back(FT(p.x()), FT(p.y()), FT(p.z()));
    internal::with_mesh_access(mesh, [&](auto& access) {
      internal::build_mesh(access, level, Parameters::point_map(mesh, np), points,
                           internal::Not_given(), std::vector<char>(), [] {});
      internal::Growth growth(access);
      internal::put_constraints(Parameters::edge_constraint_map(np), sharpness,
                                [&](auto e) { return access.edge_at(e); });
      internal::put_constraints(Parameters::vertex_constraint_map(np), corners,
                                [&](auto v) { return access.vertex(v); });
      normals = estimate_control_normals(mesh, np);
      internal::put_normals(access, file, level, sharpness, normals);
      growth.commit();
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
