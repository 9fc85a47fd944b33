// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_PART_FILE_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_PART_FILE_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

// The files of data/meshes/parts: OBJ with faces `f v//n ...` in groups `g NAME`, and for each group
// a line `# group NAME is plane:X,Y,Z,NX,NY,NZ` (a point and a normal), `sphere:X,Y,Z,R` or
// `cylinder:X,Y,Z,DX,DY,DZ,R`.
namespace part_file {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct Surface
{
  std::string name, kind;
  std::vector<double> numbers;
};

struct Part
{
  Mesh mesh;
  // of the face of a half-edge at its target
  Mesh::Property_map<Mesh::Halfedge_index, Kernel::Vector_3> normals;
  std::vector<int> groups; // of the faces: which of the surfaces each belongs to
  std::vector<Surface> surfaces;
};

// All edges between two surfaces are sharp, also where these are tangent.
inline bool is_between_surfaces(const Part& part, Mesh::Edge_index e)
{
  const auto h = part.mesh.halfedge(e), opposite = part.mesh.opposite(h);
  return part.groups[part.mesh.face(h)] != part.groups[part.mesh.face(opposite)];
}

inline bool read_surface(std::istream& in, Part& part)
{
  std::string word, is, shape;
  in >> word;
  if (word != "group") return true; // any other comment
  Surface surface;
  in >> surface.name >> is >> shape;
  const std::size_t colon = (std::min)(shape.find(':'), shape.size());
  surface.kind = shape.substr(0, colon);
  std::replace(shape.begin(), shape.end(), ',', ' ');
  std::istringstream numbers(shape.substr((std::min)(colon + 1, shape.size())));
  for (double x; numbers >> x;) surface.numbers.push_back(x);
  const std::map<std::string, std::size_t> sizes{{"plane", 6}, {"sphere", 4}, {"cylinder", 7}};
  const auto size = sizes.find(surface.kind);
  part.surfaces.push_back(surface);
  return size != sizes.end() && surface.numbers.size() == size->second;
}

inline bool read_face(std::istream& in, const std::vector<Kernel::Vector_3>& normals, Part& part)
{
  std::vector<Mesh::Vertex_index> vertices;
  std::map<Mesh::Vertex_index, Kernel::Vector_3> normal_at;
  unsigned v = 0, n = 0;
  for (char slash; in >> v >> slash >> slash >> n;) {
    if (v < 1 || v > num_vertices(part.mesh) || n < 1 || n > normals.size()) return false;
    vertices.emplace_back(v - 1);
    normal_at[vertices.back()] = normals[n - 1];
  }
  if (!in.eof() || vertices.size() < 3) return false;
  const Mesh::Face_index f = part.mesh.add_face(vertices);
  if (f == Mesh::null_face()) return false;
  for (const auto h : halfedges_around_face(part.mesh.halfedge(f), part.mesh))
    part.normals[h] = normal_at[part.mesh.target(h)];
  return true;
}

inline bool read(const std::string& filename, Part& part)
{
  part.normals =
    part.mesh.add_property_map<Mesh::Halfedge_index, Kernel::Vector_3>("h:normal").first;
  std::ifstream in(filename);
  std::vector<Kernel::Vector_3> normals;
  int group = -1;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string keyword, name;
    double x = 0, y = 0, z = 0;
    words >> keyword;
    if (keyword == "#" && !read_surface(words, part)) return false;
    if (keyword == "v" && words >> x >> y >> z) part.mesh.add_vertex(Kernel::Point_3(x, y, z));
    if (keyword == "vn" && words >> x >> y >> z) normals.emplace_back(x, y, z);
    if (keyword == "g" && words >> name) {
      group = -1;
      for (std::size_t i = 0; i < part.surfaces.size(); ++i)
        if (part.surfaces[i].name == name) group = int(i);
    }
    if (keyword == "f") {
      if (group < 0 || !read_face(words, normals, part)) return false;
      part.groups.push_back(group);
    }
  }
  return !part.groups.empty();
}

} // namespace part_file

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_PART_FILE_H
