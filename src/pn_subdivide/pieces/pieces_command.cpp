// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/pieces_command.h"

#include "io/Error.h"
#include "io/formats.h"
#include "pieces/Ranks.h"

#include <CGAL/PN_subdivision_3/version.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <optional>
#include <sstream>

namespace pn_subdivide {
namespace {

bool is_creased(const Creases& creases)
{
  return creases.any() || creases.border != Border::surface;
}

// An edge that is still sharp has vertices with a normal on either side.
bool has_inner_creases(const Surface& surface, const Creases& creases, unsigned levels)
{
  for (const Edge e : surface.edges())
    if (creases.is_sharp(e) && !surface.is_border(e) && creases.edges[e] > levels) return true;
  return false;
}

// Of the same data and options the same word.
std::string name_of(const Mesh_data& mesh, const Creases& creases, const Surface_options& options,
                    const Scheme_choice& scheme, const Output_normals& normals,
                    const Limit_choice& limit, std::size_t pieces)
{
  Checksum crc;
  std::ostringstream text;
  text.precision(17);
  const auto add = [&crc](const auto& values) {
    crc.process_bytes(values.data(), values.size() * sizeof(values[0]));
  };
  add(mesh.points);
  add(mesh.normals);
  add(mesh.corner_normals);
  add(mesh.roundness);
  add(mesh.corner_roundness);
  add(creases.edges);
  add(creases.vertices);
  for (const Vector_3& t : creases.tangents) add(to_triple(t));
  add(mesh.attributes.texture);
  for (const Columns* columns : {&mesh.attributes.of_vertices, &mesh.attributes.of_faces})
    for (const Column& column : *columns) {
      add(column.name);
      add(column.values);
      for (const std::string& word : column.words) add(word);
      text << int(column.type) << column.words.size() << column.is_label << ' ';
    }
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const std::uint64_t degree = mesh.face(f).size();
    crc.process_bytes(&degree, sizeof degree);
    crc.process_bytes(mesh.face(f).begin(), degree * sizeof(Index));
  }
  text << CGAL_PN_SUBDIVISION_3_VERSION << ' ' << scheme.scheme << ' '
       << scheme.normal_scheme.value_or("-");
  for (const auto& [parameter, value] : scheme.parameters) text << ' ' << parameter << ' ' << value;
  text << ' ' << scheme.first_round.value_or(1) << ' ' << scheme.tuned_valences.value_or("-");
  text << ' ' << int(creases.border) << ' ' << int(normals.choice) << ' ' << int(normals.kind);
  text << ' ' << limit.points << limit.normals << ' ' << limit.tolerance.value_or(0);
  for (const auto& names : mesh.attributes.directions)
    for (const std::string& name : names) text << ' ' << name;
  for (const auto* files : {&mesh.attributes.texture_files, &mesh.attributes.material_files})
    for (const std::string& file : *files) text << ' ' << file;
  text << ' ' << options.texture_rule.value_or("-") << int(mesh.attributes.texture_type);
  text << ' ' << options.levels << ' ' << mesh.points.size() << ' ' << mesh.number_of_faces();
  add(text.str());
  return text_of(crc) + " " + std::to_string(pieces);
}

// About what a vertex of a piece takes: its values in two rounds, in the table and in the file.
double bytes_of_vertex(const Attributes& attributes)
{
  return 32. * double(attributes.of_vertices.size()) + 24. * double(attributes.of_faces.size()) +
         (attributes.texture.empty() ? 0 : 250);
}

void take_names(Pieces_job& job, const Mesh_file& output)
{
  try {
    job.names = Output_names(output);
    if (ranks().rank() != 0) return; // one for all
    job.names.require_free(job.is_resumable, job.name);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    throw Output_error(output.name + ": " + e.what());
  }
}

} // namespace

bool is_in_pieces(const Surface_options& options, const Mesh_file& output)
{
  return options.pieces.any() || output.format == "pvtp" || ranks().number() > 1;
}

void require_options_for_pieces(const Surface_options& options, const Mesh_file& output)
{
  if (options.output == "-" || (output.format != "ply" && output.format != "pvtp"))
    throw Usage_error("refinement in pieces (--memory, --pieces, .pvtp, mpirun) writes files "
                      "whose names end in .ply or .pvtp");
  if (options.pieces.pieces == std::size_t(0)) throw Usage_error("--pieces must be at least 1");
  if (options.pieces.memory) parse_memory(*options.pieces.memory);
  if (options.limit.points && options.output_normals == "both")
    throw Usage_error("--limit together with --output-normals both is not known for refinement in "
                      "pieces (--memory, --pieces, .pvtp, mpirun): leave one of these out");
}

void require_mesh_for_pieces(const Mesh_data& mesh, const Creases& creases,
                             const Output_normals& normals, const Mesh_file& output)
{
  if (is_creased(creases) && normals.goes_on())
    throw Error("refinement in pieces does not write what is sharp, which goes with control "
                "normals: take --output-normals auto, or --sharp none and --border surface, or "
                "refine it as a whole");
  const std::vector<Texture_point>& texture = mesh.attributes.texture;
  if (output.format == "ply" && std::any_of(texture.begin(), texture.end(), is_none))
    throw Error("refinement in pieces does not write texture coordinates that some corners lack: "
                "take --drop-attributes, .pvtp, or refine the mesh as a whole");
}

static void suit_attributes(Mesh_data& mesh, const Mesh_file& output)
{
  const auto names = not_held(output, mesh);
  const bool has_lost_texture =
    output.format == "pvtp" &&
    std::find(names.begin(), names.end(), "texture coordinates") != names.end();
  if (has_lost_texture) mesh.attributes.texture.clear(); // by no piece
}

Pieces_job make_pieces_job(Mesh_data&& mesh, const Creases& creases, const Surface_options& options,
                           const Scheme_choice& scheme, const Mesh_file& input,
                           const Mesh_file& output, const Output_normals& normals,
                           const Limit_choice& limit, Texture_rule texture_rule, Report& report)
{
  Pieces_job job;
  job.lost_attributes = not_held(output, mesh);
  suit_attributes(mesh, output);
  Surface surface = make_surface(mesh);
  std::optional<Crease_maps> maps;
  if (is_creased(creases) && (options.levels > 0 || limit.is_used()))
    maps = add_creases(surface, creases, limit.is_used());
  const std::size_t number =
    piece_count(surface, scheme, options.levels, options.pieces, ranks().number(), limit.is_used(),
                bytes_of_vertex(mesh.attributes));
  job.name = name_of(mesh, creases, options, scheme, normals, limit, number);
  job.limit = limit;
  job.has_normals = mesh.has_normals();
  job.normals = Piece_normals(normals, job.has_normals, limit);
  if (!mesh.roundness.empty()) job.normals.add_roundness();
  const bool has_several = options.levels == 0 && !limit.is_used()
                             ? mesh.has_corner_normals()
                             : maps && has_inner_creases(surface, creases, options.levels);
  job.has_lost_normals = job.normals.are_written && has_several;
  job.is_resumable = options.pieces.resume;
  move_file_references(mesh.attributes, input, output);
  Carried_attributes carried(surface, std::move(mesh.attributes), texture_rule);
  mesh = Mesh_data();
  if (options.levels > 0)
    carried.suit(surface, scheme.scheme, input.title("standard input"), report);
  job.attributes = std::make_unique<const Piece_attributes>(std::move(carried), output);
  take_names(job, output);
  job.pieces =
    make_pieces(surface, scheme, options.levels, number, maps, limit, job.attributes->table());
  return job;
}

} // namespace pn_subdivide
