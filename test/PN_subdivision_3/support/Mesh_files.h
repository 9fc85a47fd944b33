// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The control meshes of data/, and those of others where they are found.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_MESH_FILES_H
#define CGAL_PN_SUBDIVISION_3_TEST_MESH_FILES_H

#include "Scheme_runs.h"

#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <filesystem>
#include <fstream>

namespace mesh_files {

inline std::vector<std::string> in_folder(const std::string& folder)
{
  std::vector<std::string> files;
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".ply" || extension == ".off" || extension == ".obj")
        files.push_back(entry.path().string());
    }
  std::sort(files.begin(), files.end());
  return files;
}

inline std::vector<std::string> all()
{
  std::vector<std::string> files = in_folder(PN_DATA_DIR);
  for (const char* folder : {PN_TEST_REAL_MESH_DIR, PN_TEST_EXTRA_MESH_DIR})
    for (const std::string& file : in_folder(folder)) files.push_back(file);
  return files;
}

// With the normals of the file in normal_map().
inline Surface_mesh read(const std::string& file)
{
  Surface_mesh mesh;
  normal_map(mesh);
  bool good = false;
  if (std::filesystem::path(file).extension() == ".ply") {
    std::ifstream in(file, std::ios::binary);
    good = CGAL::IO::read_PLY(in, mesh);
  } else
    good = CGAL::IO::read_polygon_mesh(file, mesh);
  if (!good) throw std::runtime_error("cannot read " + file);
  return mesh;
}

inline bool has_normals(Surface_mesh& mesh)
{
  const Normal_map normals = normal_map(mesh);
  return std::any_of(mesh.vertices().begin(), mesh.vertices().end(),
                     [&](auto v) { return normals[v] != CGAL::NULL_VECTOR; });
}

inline bool all_faces_have_degree(const Surface_mesh& mesh, std::size_t m)
{
  return std::all_of(mesh.faces().begin(), mesh.faces().end(),
                     [&](auto f) { return mesh.degree(f) == m; });
}

template <class Description>
bool takes(const Surface_mesh& mesh)
{
  return Description::degree == 0 || all_faces_have_degree(mesh, Description::degree);
}

} // namespace mesh_files

#endif // CGAL_PN_SUBDIVISION_3_TEST_MESH_FILES_H
