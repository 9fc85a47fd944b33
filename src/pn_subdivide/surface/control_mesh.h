// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_CONTROL_MESH_H
#define PN_SUBDIVIDE_CONTROL_MESH_H

#include "io/mesh_io.h"
#include "options.h"
#include "surface/creases.h"

#include <optional>
#include <string>
#include <vector>

namespace pn_subdivide {

// The mesh of a file as the options want it: an oriented 2-manifold, its equal or near points merged, its faces
// split into triangles. Reports what was changed, what the command does not carry and where the surface is open
// although border edges lie on each other. Throws Error.
Mesh_data read_control_mesh(const Mesh_file& file, const Surface_options& options, Report& report);

// EPS, or P% of the diagonal of the mesh's box.
struct Box_length
{
  double value = 0; // a part of the diagonal, not percent
  bool is_of_diagonal = false;

  double of(const Mesh_data& mesh) const;
};

// Throws Usage_error if it is no number or negative; option: for messages.
Box_length parse_box_length(const std::string& text, const std::string& option);

// The scheme of the options or, where they name none, the one that suits the faces.
Scheme_choice chosen_scheme(const Mesh_data& mesh, const Scheme_choice& choice);

// Throws Error if the scheme wants triangles and a face is none.
void require_faces_for_scheme(const Mesh_data& mesh, const Scheme_choice& choice);

// As in "26 vertices, 24 faces".
std::string size_of(const Mesh_data& mesh);

// Steps on fewer faces are done before anybody could read about them.
constexpr std::size_t faces_worth_a_report = 100000;

// Where control normals come from, as --normals says it.
struct Normals_option
{
  enum class Source { automatic, file, estimate, reciprocal, angle, none, sphere, cylinder };

  Source source = Source::automatic;
  bool is_reciprocal = false; // what automatic and estimate estimate
  bool smooths = false;       // those of the file, against the points
  Triple center{0, 0, 0};     // of the sphere, or a point of the cylinder's axis
  Triple axis{0, 0, 1};       // of the cylinder
};

// auto | file | smooth | estimate or coherent | reciprocal | angle | none | sphere:X,Y,Z | cylinder:X,Y,Z,DX,DY,DZ. Throws Usage_error.
Normals_option parse_normals_option(const std::string& text);

// Sets, keeps or drops `mesh.normals`; all are unit vectors or zero afterwards. Throws Error if the
// file was to give normals and has none. The mesh must be an oriented 2-manifold. Drops normals of
// corners.
void set_control_normals(Mesh_data& mesh, const Normals_option& option);

// The same for a mesh with creases. Corners keep the normals that the file gives them, if it is asked
// for normals. Otherwise corners have the normal of their vertex where it has one wedge, and elsewhere
// an estimate; that estimates stand in the place of normals which the file gives to vertices is said.
// Estimates of all normals are those of the wedges, and set the roundness, too, which is that of the file before. Normals
// that are to be smoothed are, wedge by wedge; returns whether that has changed any.
bool set_control_normals(Mesh_data& mesh, const Normals_option& option, Creases& creases,
                         const std::string& name, Report& report);

// That which an estimate of the normals has, also where they are given.
void put_estimated_roundness(Mesh_data& mesh, const Creases& creases);

// To be called before these, when the creases are known: says in one line what normals in the file are taken for
// where they differ, and drops them, if --normals leaves it open, where they say nothing: zero everywhere,
// flat shading that makes no creases, or shading normals. `can_be_sharp`: whether --sharp file could make some.
void settle_file_normals(Mesh_data& mesh, const Normals_option& option, const Creases& creases,
                         bool can_be_sharp, const std::string& name, Report& report);

// Where the roundness of control vertices comes from, as --roundness says it.
struct Roundness_option
{
  enum class Source { automatic, file, estimate, constant };

  Source source = Source::automatic;
  double value = 1; // of all, if it is constant

  std::optional<double> constant() const
  {
    return source == Source::constant ? std::optional<double>(value) : std::nullopt;
  }
};

// auto | file | estimate | X. Throws Usage_error.
Roundness_option parse_roundness_option(const std::string& text);

// What a mesh had.
struct Roundness_of_file
{
  // The mesh has none afterwards.
  explicit Roundness_of_file(Mesh_data& mesh);
  void put_into(Mesh_data& mesh);

  std::vector<double> of_vertices, of_corners;
};

// Chooses between the roundness of the file and that of an estimate of normals, if there was one: `of_file` and
// `mesh.roundness`, which is empty afterwards where all is 1. Throws Error if the file was to have one and has none, or
// a number that is not from 0 to 1, naming the vertex.
void set_roundness(Mesh_data& mesh, const Roundness_option& option, Roundness_of_file&& of_file,
                   bool has_normals_of_file, const Creases& creases);

// Drops what is not to be written: 1 everywhere, or beside normals that are no control normals.
void suit_roundness(Mesh_data& mesh);

// Where it varies ", roundness 0 at 130 of 160 vertices" (or "below 1 at 130" if it is 0 at none), where it is 0 "at all
// 160", for the closing line.
std::string roundness_description(const std::vector<double>& roundness);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_CONTROL_MESH_H
