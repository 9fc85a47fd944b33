// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PIECES_COMMAND_H
#define PN_SUBDIVIDE_PIECES_COMMAND_H

#include "io/Limit_choice.h"
#include "io/Report.h"
#include "io/mesh_io.h"
#include "options.h"
#include "pieces/Output_names.h"
#include "pieces/Piece_output.h"
#include "surface/creases.h"

#include <memory>
#include <string>
#include <vector>

namespace pn_subdivide {

// Is the surface to be refined piece by piece? It is if an option says so, if the output is .pvtp, and if ranks
// share the work.
bool is_in_pieces(const Surface_options& options, const Mesh_file& output);

// Throws Usage_error if other options do not go with it.
void require_options_for_pieces(const Surface_options& options, const Mesh_file& output);

// Throws Error if the mesh has something that pieces do not carry.
void require_mesh_for_pieces(const Mesh_data& mesh, const Creases& creases,
                             const Output_normals& normals, const Mesh_file& output);

struct Pieces_job
{
  std::unique_ptr<Any_pieces> pieces;
  bool has_normals = false;      // to refine with
  Piece_normals normals;         // that are written
  bool has_lost_normals = false; // vertices with several of them have one in the output
  std::unique_ptr<const Piece_attributes> attributes;
  std::vector<std::string> lost_attributes; // that the format does not hold
  Limit_choice limit;
  bool is_resumable = false;
  std::string name; // of data and options, the same for the same result
  Output_names names;
};

// Takes the names in the file system first. Throws Output_error if they cannot be had.
Pieces_job make_pieces_job(Mesh_data&& mesh, const Creases& creases, const Surface_options& options,
                           const Scheme_choice& scheme, const Mesh_file& input,
                           const Mesh_file& output, const Output_normals& normals,
                           const Limit_choice& limit, Texture_rule texture_rule, Report& report);

// Refines the pieces that are this rank's, and writes them; the output is there when all ranks have done so.
// Returns what limits have reached.
Limit_summary write_pieces(const Pieces_job& job, const std::string& output, const Report& report);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PIECES_COMMAND_H
