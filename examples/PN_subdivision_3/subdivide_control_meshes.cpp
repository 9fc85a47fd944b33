// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Subdivides control meshes of any origin by the linear and by the point-normal scheme, triangle meshes
// by Loop and all others by Catmull-Clark, and writes control mesh and results as PLY, which
// scripts/render.py draws side by side.
//
//   subdivide_control_meshes [-o FOLDER] [--sharp DEGREES] [FILE...]
//
// Edges at which faces meet at more than DEGREES are kept sharp. Without it they are, at 40 degrees, where
// a file without normals looks like a part made of surfaces with edges between them; those of
// data/meshes/parts tell themselves where. A comment line `sphere X Y Z R` or
// `cylinder X Y Z DX DY DZ R` in a PLY file names the surface that the control data lies on; the
// largest distances of the results from it are printed in units of 2^-52 times the radius.

#include "Control_mesh_file.h"
#include "Part_file.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/PN_certificates_3/reproduction.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Real_timer.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

using control_mesh_file::Control_mesh;
using control_mesh_file::Kernel;
using control_mesh_file::Mesh;
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

// The maps by name, because those of a copy are others. They are not written to files: normals of the
// file are control normals, and viewers shade better by the faces.
auto sharp_edges(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
}
auto vertex_normals(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Vertex_index, Kernel::Vector_3>("v:normal", CGAL::NULL_VECTOR)
    .first;
}
void remove_maps(Mesh& mesh)
{
  auto sharp = sharp_edges(mesh);
  auto of_vertices = vertex_normals(mesh);
  mesh.remove_property_map(sharp);
  mesh.remove_property_map(of_vertices);
}

using Corner_normals = PN::Estimated_control_normals<Mesh::Halfedge_index, Kernel>;

// Parts have some sharp edges and hardly any that are nearly so. Of the control mesh of a smooth shape, and
// of a scan, that is not true.
std::size_t find_sharp_edges(Mesh& mesh, bool has_normals, std::optional<double> degrees)
{
  constexpr double sharp_angle = 40, smooth_angle = 20;
  const auto edges = sharp_edges(mesh);
  if (degrees) return PN::detect_creases(mesh, *degrees, edges);
  if (has_normals) return 0;
  const std::size_t not_smooth = PN::detect_creases(mesh, smooth_angle, edges);
  const std::size_t sharp = PN::detect_creases(mesh, sharp_angle, edges);
  if (2 * sharp <= mesh.number_of_edges() && 4 * (not_smooth - sharp) <= sharp) return sharp;
  for (const Mesh::Edge_index e : mesh.edges()) edges[e] = false;
  return 0;
}

struct Input
{
  Mesh mesh; // with the maps above
  Corner_normals normals;
  std::size_t sharp_edges = 0;
  std::optional<Round_surface> surface;
  std::string repairs;
};

Input input_of_part(const part_file::Part& part)
{
  Input input;
  input.mesh = part.mesh;
  const auto edges = sharp_edges(input.mesh);
  for (const Mesh::Edge_index e : input.mesh.edges()) {
    edges[e] = part_file::is_between_surfaces(part, e);
    input.sharp_edges += edges[e];
  }
  for (const Mesh::Halfedge_index h : input.mesh.halfedges())
    put(input.normals, h, part.normals[h]);
  return input;
}

Input read(const std::filesystem::path& file, std::optional<double> degrees)
{
  if (part_file::Part part; !degrees && part_file::read(file.string(), part))
    return input_of_part(part);
  Control_mesh control = control_mesh_file::read(file);
  Input input;
  input.mesh = std::move(control.mesh);
  input.repairs = control.repairs;
  input.surface = surface_in_comments(control.comments);
  input.sharp_edges = find_sharp_edges(input.mesh, control.has_normals, degrees);
  if (!control.has_normals || input.sharp_edges > 0)
    input.normals = PN::estimate_control_normals(
      input.mesh, params::edge_is_constrained_map(sharp_edges(input.mesh)));
  else {
    const auto normals = vertex_normals(input.mesh);
    for (const Mesh::Halfedge_index h : input.mesh.halfedges())
      put(input.normals, h, normals[input.mesh.target(h)]);
  }
  return input;
}

// As many as show a smooth surface without making a heavy file; the first splits n-gons n-fold.
unsigned number_of_rounds(const Mesh& mesh)
{
  constexpr std::size_t enough_corners = 100000;
  unsigned rounds = 1;
  for (std::size_t n = mesh.number_of_halfedges(); rounds < 5 && 4 * n <= enough_corners; n *= 4)
    ++rounds;
  return rounds;
}

template <class Scheme>
double subdivide(Mesh& mesh, const Scheme& scheme, const Corner_normals* normals, unsigned rounds)
{
  CGAL::Real_timer timer;
  timer.start();
  const auto np = params::number_of_iterations(rounds).edge_is_constrained_map(sharp_edges(mesh));
  if (normals != nullptr)
    PN::subdivide(mesh, scheme, np.vertex_normal_map(*normals));
  else
    PN::subdivide(mesh, PN::linear(scheme), np);
  return timer.time() * 1e3;
}

void write(const std::filesystem::path& file, Mesh mesh)
{
  remove_maps(mesh);
  std::ofstream out(file, std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  if (!CGAL::IO::write_PLY(out, mesh) || !out.flush())
    throw std::runtime_error("the result " + file.string() + " cannot be written");
}

void print_distance(const Mesh& mesh, const std::optional<Round_surface>& surface)
{
  if (!surface) return;
  const double distance =
    std::visit([&](const auto& shape) { return PN::mesh_deviation(mesh, shape).distance.sup(); },
               surface->shape);
  std::cout << std::defaultfloat << std::setprecision(3) << std::setw(11)
            << distance / surface->radius * 0x1p52;
}

void subdivide(const std::filesystem::path& file, const std::filesystem::path& folder,
               std::optional<double> degrees)
{
  Input input = read(file, degrees);
  const bool triangles = CGAL::is_triangle_mesh(input.mesh);
  const unsigned rounds = number_of_rounds(input.mesh);
  const std::string name = file.stem().string();
  std::cout << std::left << std::setw(19) << name << ' ' << std::setw(14)
            << (triangles ? "Loop" : "Catmull-Clark") << std::right << std::setw(7)
            << input.mesh.number_of_faces() << std::setw(7) << input.sharp_edges << std::flush;
  write(folder / (name + "_control.ply"), input.mesh);

  Mesh linear = input.mesh, point_normal = input.mesh;
  for (const bool with_normals : {false, true}) {
    Mesh& mesh = with_normals ? point_normal : linear;
    const Corner_normals* const normals = with_normals ? &input.normals : nullptr;
    const double time = triangles ? subdivide(mesh, PN::Loop_scheme(), normals, rounds)
                                  : subdivide(mesh, PN::CatmullClark_scheme(), normals, rounds);
    if (!with_normals) std::cout << std::setw(9) << mesh.number_of_faces();
    std::cout << std::fixed << std::setprecision(1) << std::setw(9) << time << " ms" << std::flush;
  }
  print_distance(linear, input.surface);
  print_distance(point_normal, input.surface);
  std::cout << '\n';
  if (!input.repairs.empty()) std::cout << "  repaired: " << input.repairs << '\n';
  write(folder / (name + "_linear.ply"), std::move(linear));
  write(folder / (name + "_point_normal.ply"), std::move(point_normal));
}

struct Arguments
{
  std::filesystem::path output = "subdivided";
  std::optional<double> degrees;
  std::vector<std::filesystem::path> files;
};

Arguments parse(int argc, char** argv)
{
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "-o" && i + 1 < argc)
      arguments.output = argv[++i];
    else if (word == "--sharp" && i + 1 < argc)
      arguments.degrees = std::atof(argv[++i]);
    else
      arguments.files.emplace_back(word);
  }
  if (arguments.files.empty())
    for (const char* name :
         {"parts/bearing_housing.obj", "head.obj", "cube_on_sphere.ply", "creature.obj"})
      arguments.files.push_back(CGAL::data_file_path("meshes/" + std::string(name)));
  return arguments;
}

int main(int argc, char** argv)
{
  const Arguments arguments = parse(argc, argv);
  std::filesystem::create_directories(arguments.output);
  std::cout
    << "control mesh        scheme          faces  sharp   result  linear, and  point-normal"
       "  distance/R in 2^-52\n";
  int result = EXIT_SUCCESS;
  for (const std::filesystem::path& file : arguments.files) {
    std::string error;
    try {
      subdivide(file, arguments.output, arguments.degrees);
    } catch (const std::bad_alloc&) {
      error = "there is not enough memory for it";
    } catch (const std::exception& e) {
      error = e.what();
    }
    if (error.empty()) continue;
    std::cerr << file.string() << ": " << error << std::endl;
    result = EXIT_FAILURE;
  }
  return result;
}
