// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Subdivides control meshes, those of the package or all of a folder, triangle meshes by PN-Loop and all others by
// PN-Catmull-Clark, and writes the results as PLY with normals. A comment line `sphere X Y Z R` or
// `cylinder X Y Z DX DY DZ R` in a PLY file names the surface that the control data lies on; the
// largest distance of the result from it is printed in units of 2^-52 times the radius.
//
//   subdivide_control_meshes [FOLDER [OUTPUT_FOLDER [ROUNDS]]]

#include <CGAL/Exact_rational.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/reproduction.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Normal_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Vector_3>;
namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

// In exact numbers: the square of a double is not a double.
using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Shape = std::variant<Exact::Sphere_3, PN::Cylinder_3<Exact>>;

struct Round_surface
{
  Shape shape;
  double radius;
};

std::optional<Round_surface> surface_in_comments(const std::string& comments)
{
  std::istringstream lines(comments);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind != "sphere" && kind != "cylinder") continue;
    const std::vector<double> x{std::istream_iterator<double>(words), {}};
    if (x.size() != (kind == "sphere" ? 4 : 7)) throw std::runtime_error("has a broken comment");
    const Exact::Point_3 center(x[0], x[1], x[2]);
    const Exact::FT squared_radius = CGAL::square(Exact::FT(x.back()));
    if (kind == "sphere") return Round_surface{Exact::Sphere_3(center, squared_radius), x.back()};
    const Exact::Line_3 axis(center, Exact::Vector_3(x[3], x[4], x[5]));
    return Round_surface{PN::Cylinder_3<Exact>(axis, squared_radius), x.back()};
  }
  return std::nullopt;
}

bool read(const std::filesystem::path& file, Mesh& mesh, std::string& comments)
{
  if (file.extension() != ".ply") return CGAL::IO::read_polygon_mesh(file.string(), mesh);
  std::ifstream in(file, std::ios::binary);
  return CGAL::IO::read_PLY(in, mesh, comments);
}

// the normals of the file, or estimated ones
Normal_map control_normals(Mesh& mesh)
{
  const auto [normals, is_new] =
    mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal", CGAL::NULL_VECTOR);
  if (is_new) PN::estimate_control_normals(mesh, normals);
  return normals;
}

void subdivide(const std::filesystem::path& file, const std::filesystem::path& folder,
               unsigned rounds)
{
  Mesh mesh;
  std::string comments;
  if (!read(file, mesh, comments)) throw std::runtime_error("cannot be read");
  const std::size_t control_faces = mesh.number_of_faces();
  const bool triangles = CGAL::is_triangle_mesh(mesh);
  const Normal_map normals = control_normals(mesh);

  CGAL::Real_timer timer;
  timer.start();
  const auto np = params::number_of_iterations(rounds).vertex_normal_map(normals);
  if (triangles)
    PN::Loop_subdivision(mesh, np);
  else
    PN::CatmullClark_subdivision(mesh, np);
  timer.stop();

  std::cout << std::left << std::setw(26) << file.filename().string() << std::setw(18)
            << (triangles ? "PN-Loop" : "PN-Catmull-Clark") << std::right << std::setw(7)
            << control_faces << std::setw(10) << mesh.number_of_faces() << std::setw(10)
            << mesh.number_of_vertices() << std::fixed << std::setprecision(2) << std::setw(9)
            << timer.time() * 1e3 << " ms";
  if (const auto surface = surface_in_comments(comments)) {
    const double distance =
      std::visit([&](const auto& shape) { return PN::mesh_deviation(mesh, shape).distance.sup(); },
                 surface->shape);
    std::cout << std::setprecision(2) << std::setw(9) << distance / surface->radius * 0x1p52;
  }
  std::cout << '\n';

  const std::filesystem::path output = folder / file.filename().replace_extension(".ply");
  std::ofstream out(output, std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  if (!CGAL::IO::write_PLY(out, mesh))
    throw std::runtime_error(output.string() + " is not writable");
}

std::vector<std::filesystem::path> control_meshes_of_the_package()
{
  std::vector<std::filesystem::path> files;
  for (const char* name :
       {"cylinder_quads.ply", "cylinder_triangles.ply", "sphere_mixed.ply", "sphere_quads.ply",
        "sphere_triangles.ply", "torus_quads.ply", "creature.obj", "head.obj", "spoon.obj"})
    files.push_back(CGAL::data_file_path("meshes/" + std::string(name)));
  return files;
}

std::vector<std::filesystem::path> control_meshes_of(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    for (const char* extension : {".ply", ".off", ".obj"})
      if (entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

int main(int argc, char** argv)
{
  const std::vector<std::filesystem::path> files =
    argc > 1 ? control_meshes_of(argv[1]) : control_meshes_of_the_package();
  const std::filesystem::path output = argc > 2 ? argv[2] : "subdivided";
  const unsigned rounds = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 4;
  std::filesystem::create_directories(output);

  std::cout << "control mesh              scheme            control     faces  vertices        time"
               "  deviation/R in 2^-52\n";
  int result = EXIT_SUCCESS;
  for (const std::filesystem::path& file : files) try {
      subdivide(file, output, rounds);
    } catch (const std::exception& e) {
      std::cerr << file.string() << ": " << e.what() << '\n';
      result = EXIT_FAILURE;
    }
  return files.empty() ? EXIT_FAILURE : result;
}
