// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_WRITE_VTP_ARRAYS_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_WRITE_VTP_ARRAYS_H

#include <cstddef>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

// Writes a Surface_mesh without removed elements as a VTP file, with numbers at its vertices.
template <class Mesh>
bool write_vtp(const std::string& file, const Mesh& mesh,
               const std::vector<std::pair<std::string, std::vector<double>>>& arrays)
{
  std::ofstream out(file);
  out.precision(9);
  const auto begin_array = [&](const char* type, const std::string& name, int components) {
    out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
        << components << "\" format=\"ascii\">\n";
  };
  const auto end_array = [&] { out << "</DataArray>\n"; };
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
      << "<Piece NumberOfPoints=\"" << mesh.number_of_vertices() << "\" NumberOfPolys=\""
      << mesh.number_of_faces() << "\">\n<PointData>\n";
  for (const auto& [name, values] : arrays) {
    begin_array("Float64", name, 1);
    for (const double x : values) out << x << "\n";
    end_array();
  }
  out << "</PointData>\n<Points>\n";
  begin_array("Float64", "Points", 3);
  for (const auto v : mesh.vertices()) out << mesh.point(v) << "\n";
  end_array();
  out << "</Points>\n<Polys>\n";
  begin_array("Int64", "connectivity", 1);
  for (const auto f : mesh.faces()) {
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) out << v.idx() << " ";
    out << "\n";
  }
  end_array();
  begin_array("Int64", "offsets", 1);
  std::size_t offset = 0;
  for (const auto f : mesh.faces()) out << (offset += mesh.degree(f)) << "\n";
  end_array();
  out << "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  out.close();
  return !out.fail();
}

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_WRITE_VTP_ARRAYS_H
