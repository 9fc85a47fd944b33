// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CONTROL_FILE_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CONTROL_FILE_H

#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/helpers.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/PN_subdivision_3/internal/meshes/crease_maps.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/with_mesh_access.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <functional>
#include <istream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

[[noreturn]] inline void refuse_file(const std::string& name, const std::string& what)
{
  throw std::runtime_error("PN_subdivision_3: " + name + ": " + what);
}

// What a file has of a control mesh. Normals, roundness and sharpness are those of all vertices, or of none.
struct Control_file
{
  using Kernel = Simple_cartesian<double>;

  std::string name;
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<Kernel::Vector_3> normals;
  std::vector<double> roundness, sharpness;
  std::map<std::pair<std::size_t, std::size_t>, double>
    edges; // sharp ones, by their ends, the lesser one first
};

// What a PLY file has, by the first four letters of an element and by property; of a list its length, then its values.
using Ply_columns = std::map<std::string, std::map<std::string, std::vector<double>>>;

// appends what a property of one of the types has read
template <class... Type>
std::function<void()> ply_appender(const IO::internal::PLY_read_number* property,
                                   std::vector<double>& column)
{
  std::function<void()> append = [] {};
  const auto of_number = [&](const auto* typed) {
    if (typed != nullptr) append = [&column, typed] { column.push_back(double(typed->buffer())); };
  };
  const auto of_list = [&](const auto* typed) {
    if (typed != nullptr)
      append = [&column, typed] {
        column.push_back(double(typed->buffer().size()));
        column.insert(column.end(), typed->buffer().begin(), typed->buffer().end());
      };
  };
  (of_number(dynamic_cast<const IO::internal::PLY_read_typed_number<Type>*>(property)), ...);
  (of_list(dynamic_cast<const IO::internal::PLY_read_typed_list<Type>*>(property)), ...);
  return append;
}

inline void read_ply_element(std::istream& in, IO::internal::PLY_element& element,
                             const std::string& file_name, Ply_columns& columns)
{
  auto& of_element = columns[element.name().substr(0, 4)]; // "vertex" or "vertices"
  std::vector<std::function<void()>> append;
  for (std::size_t k = 0; k < element.number_of_properties(); ++k)
    append.push_back(ply_appender<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t,
                                  std::int32_t, std::uint32_t, float, double>(
      element.property(k), of_element[element.property(k)->name()]));
  for (std::size_t i = 0; i < element.number_of_items(); ++i) {
    for (std::size_t k = 0; k < append.size(); ++k) element.property(k)->get(in);
    if (in.fail())
      refuse_file(file_name, element.name() + " " + std::to_string(i) +
                               " cannot be read: it is missing, or no number (CGAL's reader takes "
                               "inf and nan in binary files only)");
    for (const auto& f : append) f();
  }
}

// By CGAL's reader of elements, since that of meshes is one of Surface_mesh alone, and takes indices beyond the vertices.
inline void read_ply(std::istream& in, Control_file& file)
{
  IO::internal::PLY_reader reader(false);
  if (!reader.init(in)) refuse_file(file.name, "the header of this PLY file cannot be read");
  Ply_columns columns;
  for (std::size_t i = 0; i < reader.number_of_elements(); ++i)
    read_ply_element(in, reader.element(i), file.name, columns);
  auto &vertex = columns["vert"], &face = columns["face"], &edge = columns["edge"];

  const auto &x = vertex["x"], &y = vertex["y"], &z = vertex["z"];
  if (x.size() != y.size() || x.size() != z.size())
    refuse_file(file.name, "its vertices lack one of the properties x, y and z");
  for (std::size_t v = 0; v < x.size(); ++v) file.points.emplace_back(x[v], y[v], z[v]);
  const auto of_vertices = [&](const std::string& name) {
    const auto& column = vertex[name];
    return column.size() == x.size() ? column : std::vector<double>(); // not of a list
  };
  const bool has_control_normals = vertex.count("control_nz") != 0;
  const std::string prefix = has_control_normals ? "control_n" : "n";
  const auto nx = of_vertices(prefix + "x"), ny = of_vertices(prefix + "y"),
             nz = of_vertices(prefix + "z");
  // of the mesh or the surface, as the command says it
  const bool are_for_viewers =
    !has_control_normals && reader.comments().find("normals of the ") != std::string::npos;
  if (!nx.empty() && !ny.empty() && !are_for_viewers)
    for (std::size_t v = 0; v < nz.size(); ++v) file.normals.emplace_back(nx[v], ny[v], nz[v]);
  file.roundness = of_vertices("roundness");

  const auto index = [](double i) { return i >= 0 ? std::size_t(i) : std::size_t(-1); };
  const auto& corner = face[face.count("vertex_index") != 0 ? "vertex_index" : "vertex_indices"];
  for (std::size_t i = 0; i < corner.size();) {
    const std::size_t degree = index(corner[i++]);
    if (degree > corner.size() - i) refuse_file(file.name, "the vertices of its faces are no list");
    for (auto& v : file.faces.emplace_back(degree)) v = index(corner[i++]);
  }
  if (edge.count("sharpness") == 0) return; // what vertices have of this name is something else
  file.sharpness = of_vertices("sharpness");
  const auto &ends = edge["vertex1"], &other_ends = edge["vertex2"], &sharpness = edge["sharpness"];
  if (ends.size() != sharpness.size() || other_ends.size() != sharpness.size())
    refuse_file(file.name, "its sharp edges lack vertex1 or vertex2");
  for (std::size_t e = 0; e < ends.size(); ++e) {
    const std::pair<std::size_t, std::size_t> both =
      std::minmax(index(ends[e]), index(other_ends[e]));
    if (sharpness[e] != 0)
      file.edges[both] = checked_sharpness(sharpness[e], [&] {
        return file.name + ": the edge from vertex " + std::to_string(both.first) + " to vertex " +
               std::to_string(both.second);
      });
  }
}

// reads what CGAL's readers take, by the ending of the name
inline Control_file read_control_file(const std::string& name)
{
  Control_file file;
  file.name = name;
  const std::string ending = IO::internal::get_file_extension(name);
  std::ifstream in(name, std::ios::binary);
  if (!in) refuse_file(name, "the file is not there, or may not be read");
  bool is_read = true;
  if (ending == "ply")
    read_ply(in, file);
  else if (ending == "off")
    is_read = IO::read_OFF(
      in, file.points, file.faces,
      CGAL::parameters::vertex_normal_output_iterator(std::back_inserter(file.normals)));
  else
    is_read =
      IO::read_polygon_soup(name, file.points, file.faces, CGAL::parameters::verbose(false));
  if (!is_read)
    refuse_file(name, "CGAL's reader does not take it: it must be a complete file whose name ends "
                      "in .ply, .off, .obj or .stl "
                      "(the command pn_subdivide tells the line)");
  return file;
}

// The connectivity of a file, checked: its faces begin with the corners at their first vertices.
template <class PolygonMesh>
Level_connectivity level_of_file(const Control_file& file)
{
  using Traits = boost::graph_traits<PolygonMesh>;
  PolygonMesh mesh;
  std::vector<typename Traits::vertex_descriptor> vertices, corners;
  for (std::size_t v = 0; v < file.points.size(); ++v) vertices.push_back(add_vertex(mesh));
  for (std::size_t f = 0; f < file.faces.size(); ++f) {
    std::vector<std::size_t> face = file.faces[f];
    const auto refuse = [&](const std::string& what) {
      refuse_file(file.name, "face " + std::to_string(f) + " " + what);
    };
    corners.clear();
    for (const std::size_t v : face)
      if (v < vertices.size())
        corners.push_back(vertices[v]);
      else
        refuse("has a vertex that is not there: there are " + std::to_string(vertices.size()));
    std::sort(face.begin(), face.end());
    if (face.size() < 3 || std::adjacent_find(face.begin(), face.end()) != face.end())
      refuse("has not three or more different vertices: remove it, for instance by pn_subdivide "
             "--repair");
    if (Euler::add_face(corners, mesh) == Traits::null_face())
      refuse("does not fit to those before it, which leave no room at one of its edges or "
             "vertices: the faces are oriented "
             "differently, or more than two meet. "
             "CGAL::Polygon_mesh_processing::orient_polygon_soup() and pn_subdivide --repair "
             "mend it");
  }
  return with_mesh_access(std::as_const(mesh),
                          [](const auto& access) { return checked_level(access); });
}

inline std::vector<double> sharpness_of_edges(const Control_file& file,
                                              const Level_connectivity& level)
{
  auto edges = file.edges; // that have not been found
  std::vector<double> all(level.number_of_edges(), 0);
  for (Level_connectivity::Index e = 0; e < all.size() && !edges.empty(); ++e) {
    const auto found = edges.find(
      std::minmax(std::size_t(level.target(2 * e)), std::size_t(level.target(2 * e + 1))));
    if (found == edges.end()) continue;
    all[e] = found->second;
    edges.erase(found);
  }
  if (!edges.empty())
    refuse_file(file.name, "no face has the sharp edge from vertex " +
                             std::to_string(edges.begin()->first.first) + " to vertex " +
                             std::to_string(edges.begin()->first.second));
  return all;
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CONTROL_FILE_H
