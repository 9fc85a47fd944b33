// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Output_normals.h"

#include "io/Error.h"
#include "io/Mesh_data.h"
#include "surface/surface_command.h"

#include <algorithm>
#include <cmath>

namespace pn_subdivide {
namespace {

using Choice = Output_normals::Choice;

Choice parse(const std::string& text)
{
  if (text == "auto") return Choice::automatic;
  if (text == "surface") return Choice::surface;
  if (text == "control") return Choice::control;
  if (text == "both") return Choice::both;
  if (text == "none") return Choice::none;
  throw Usage_error("--output-normals '" + text +
                    "': expected auto, surface, control, both or none" +
                    did_you_mean(text, {"auto", "surface", "control", "both", "none"}));
}

void require_control_normals(const Surface_options& options, const std::string& option)
{
  if (options.linear)
    throw Usage_error(option + " and --linear exclude each other: in linear schemes normals take "
                               "no part");
  if (options.normals == "none")
    throw Usage_error(option + " and --normals none exclude each other: there are no control "
                               "normals then");
}

Choice choice_of(const Surface_options& options, const Mesh_file& output)
{
  const bool is_flag = options.limit.normals; // the option's own choice is not in there yet
  if (!options.output_normals) return is_flag ? Choice::surface : Choice::automatic;
  const Choice choice = parse(*options.output_normals);
  const std::string option = "--output-normals " + *options.output_normals;
  if (is_flag && choice != Choice::surface)
    throw Usage_error("--surface-normals and " + option + " exclude each other");
  if (choice == Choice::control || choice == Choice::both) require_control_normals(options, option);
  if (choice == Choice::both && !holds_control_normals(output))
    throw Usage_error(option + ": " + output.title("standard output") + " (" + output.format +
                      ") cannot hold both, only .ply, .vtp and .pvtp can");
  return choice;
}

} // namespace

Output_normals Output_normals::make(const Surface_options& options, const Mesh_file& output)
{
  Output_normals normals;
  normals.choice = choice_of(options, output);
  // many programs refuse NOFF
  const bool are_wanted = options.output_normals || (options.levels == 0 && options.normals);
  const bool is_bare = !holds_normals(output) || (output.format == "off" && !are_wanted);
  if (normals.choice == Choice::automatic && is_bare) normals.choice = Choice::none;
  const bool is_default = normals.choice == Choice::automatic || normals.choice == Choice::both;
  const bool has_control_normals = !options.linear && options.normals != "none";
  if (normals.choice == Choice::surface || (is_default && options.chord) ||
      (is_default && options.limit.points && has_control_normals))
    normals.kind = Normal_kind::of_surface;
  else if (is_default && options.levels > 0)
    normals.kind = Normal_kind::of_mesh;
  normals.copies = normals.choice == Choice::automatic && options.levels == 0 &&
                   !options.limit.points && !options.interpolate;
  return normals;
}

void Output_normals::suit(const Mesh_data& mesh)
{
  if (copies) kind = mesh.normal_kind;
  if (mesh.points.empty()) return;
  const Bounding_box box(mesh.points);
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) size = (std::max)(size, box.high[i] - box.low[i]);
  if (size > 0 && std::isfinite(size)) scale = std::ldexp(1., -std::ilogb(size));
}

} // namespace pn_subdivide
