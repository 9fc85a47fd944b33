// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_ROUNDNESS_H
#define PN_SUBDIVIDE_ROUNDNESS_H

#include "io/Mesh_data.h"
#include "surface/creases.h"

#include <optional>
#include <string>
#include <vector>

namespace pn_subdivide {

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

#endif // PN_SUBDIVIDE_ROUNDNESS_H
