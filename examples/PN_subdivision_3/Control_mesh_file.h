// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_CONTROL_MESH_FILE_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_CONTROL_MESH_FILE_H

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Control meshes from files of any origin (PLY, OFF, OBJ, STL): whatever they hold becomes an oriented
// 2-manifold, with equal points merged.
namespace control_mesh_file {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Normal_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Vector_3>;

struct Control_mesh
{
  Mesh mesh; // with normals in "v:normal" if the file has some that are not zero
  bool has_normals = false;
  std::string comments; // of a PLY file
  std::string repairs;  // what had to be done, for people
};

struct Soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
};

inline void require_sound_elements(const Soup& soup)
{
  const auto is_finite = [](const Kernel::Point_3& p) {
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  };
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (!is_finite(soup.points[v]))
      throw std::runtime_error("vertex " + std::to_string(v) + " has no finite coordinates");
  for (std::size_t f = 0; f < soup.faces.size(); ++f)
    for (const std::size_t v : soup.faces[f])
      if (v >= soup.points.size())
        throw std::runtime_error("face " + std::to_string(f) + " has a vertex that is not there");
}

inline Soup read_soup(const std::filesystem::path& file)
{
  if (!std::filesystem::exists(file)) throw std::runtime_error("there is no such file");
  if (!std::filesystem::is_regular_file(file)) throw std::runtime_error("is not a file");
  if (!std::ifstream(file)) throw std::runtime_error("may not be read");
  Soup soup;
  if (!CGAL::IO::read_polygon_soup(file.string(), soup.points, soup.faces,
                                   CGAL::parameters::verbose(false)))
    throw std::runtime_error("cannot be read; it must be a complete PLY, OFF, OBJ or STL file, "
                             "named .ply, .off, .obj or .stl");
  require_sound_elements(soup);
  if (soup.faces.empty()) throw std::runtime_error("has no faces");
  return soup;
}

// Six times the volume, of a closed surface.
inline double orientation(const Mesh& mesh)
{
  double sum = 0;
  for (const Mesh::Face_index f : mesh.faces()) {
    const auto first = mesh.halfedge(f);
    const Kernel::Vector_3 a = mesh.point(mesh.target(first)) - CGAL::ORIGIN;
    for (auto h = mesh.next(first); mesh.next(h) != first; h = mesh.next(h)) {
      const Kernel::Vector_3 b = mesh.point(mesh.target(h)) - CGAL::ORIGIN;
      const Kernel::Vector_3 c = mesh.point(mesh.target(mesh.next(h))) - CGAL::ORIGIN;
      sum += a * CGAL::cross_product(b, c);
    }
  }
  return sum;
}

inline Mesh make_mesh(Soup soup)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
  if (!CGAL::is_closed(mesh) || !(orientation(mesh) < 0)) return mesh;
  for (auto& face : soup.faces) std::reverse(face.begin(), face.end()); // its outside was within
  mesh.clear();
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.faces, mesh);
  return mesh;
}

// What an undamaged PLY file holds besides.
inline void read_normals_and_comments(const std::filesystem::path& file, Control_mesh& control)
{
  std::ifstream in(file, std::ios::binary);
  Mesh mesh;
  if (!CGAL::IO::read_PLY(in, mesh, control.comments, false)) return;
  const Normal_map normals =
    mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal", CGAL::NULL_VECTOR)
      .first;
  control.has_normals = std::any_of(mesh.vertices().begin(), mesh.vertices().end(),
                                    [&](auto v) { return normals[v] != CGAL::NULL_VECTOR; });
  if (control.has_normals) control.mesh = std::move(mesh);
}

// Throws std::runtime_error if the file holds no mesh.
inline Control_mesh read(const std::filesystem::path& file)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Soup soup = read_soup(file);
  const std::size_t points = soup.points.size(), faces = soup.faces.size();
  PMP::repair_polygon_soup(soup.points, soup.faces);
  if (soup.faces.empty()) throw std::runtime_error("has no faces with three different vertices");
  const bool is_same = soup.points.size() == points && soup.faces.size() == faces;
  const bool is_mesh = PMP::is_polygon_soup_a_polygon_mesh(soup.faces);
  Control_mesh control;
  if (!is_same) control.repairs = "equal, unused or degenerate elements removed";
  if (!is_mesh) {
    PMP::orient_polygon_soup(soup.points, soup.faces);
    control.repairs += std::string(is_same ? "" : ", ") + "faces oriented, non-manifold places cut";
  }
  control.mesh = make_mesh(std::move(soup));
  if (is_same && is_mesh && file.extension() == ".ply") read_normals_and_comments(file, control);
  return control;
}

} // namespace control_mesh_file

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_CONTROL_MESH_FILE_H
