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
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <new>
#include <optional>
#include <sstream>
#include <system_error>

namespace fs = std::filesystem;

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

void suit_attributes(Mesh_data& mesh, const Mesh_file& output)
{
  const auto names = not_held(output, mesh);
  const bool has_lost_texture =
    output.format == "pvtp" &&
    std::find(names.begin(), names.end(), "texture coordinates") != names.end();
  if (has_lost_texture) mesh.attributes.texture.clear(); // by no piece
}

std::string in_megabytes(double bytes)
{
  return std::to_string(static_cast<unsigned long long>(bytes / (1 << 20)) + 1) + " MB";
}

std::unique_ptr<Piece_output> make_output(const Pieces_job& job)
{
  return job.names.folder.empty()
           ? make_ply_output(*job.pieces, job.normals, *job.attributes, job.names, job.is_resumable)
           : make_pvtp_output(*job.pieces, job.normals, *job.attributes, job.names);
}

// The output under its name for the time being, and what is known of it. Unless the run can be continued it goes
// away with the object, or on a signal.
class Unfinished_output
{
public:
  explicit Unfinished_output(const Pieces_job& job)
    : job_(job)
    , finished_(job.names.done, job.name)
    , output_(make_output(job))
  {}
  ~Unfinished_output()
  {
    if (!is_ours_ || job_.is_resumable) return;
    // of several ranks that fail one finds something to remove
    const bool was_there = output_->remove();
    if (is_open_ && !was_there) ranks().leave_report_to_others();
  }
  Unfinished_output(const Unfinished_output&) = delete;
  Unfinished_output& operator=(const Unfinished_output&) = delete;

  // by one rank
  void create()
  {
    const bool is_new = !fs::exists(job_.names.part);
    require_space(is_new || !job_.is_resumable ? 0 : finished_.number());
    if (is_new) begin();
    output_->mend();
  }
  // by all
  void open()
  {
    if (!is_ours_) remove_on_signal();
    is_ours_ = is_open_ = true;
    output_->open();
  }

  // Is it on the disk as it was written?
  bool is_finished(std::size_t piece) const
  {
    if (!job_.is_resumable) return false;
    const std::string receipt = finished_.receipt(piece);
    return !receipt.empty() && output_->is_written(piece, receipt);
  }
  void write(std::size_t i)
  {
    const Any_pieces::Piece piece = job_.pieces->piece(i, job_.normals.rings());
    output_->write(i, piece);
    summary_.add({piece.limit_report(), job_.limit});
    if (job_.is_resumable) finished_.set_finished(i, output_->sync(i));
  }
  // what the limits of the pieces that were written have reached
  const Limit_summary& summary() const { return summary_; }
  void close() { output_->close(); }
  // by one rank, when all have closed it
  void finish()
  {
    output_->finish();
    is_ours_ = false;
    if (job_.is_resumable) finished_.remove();
  }
  // by the others
  void leave() { is_ours_ = false; }

private:
  // The file that tells what is finished comes first: alone it can be continued.
  void begin()
  {
    if (job_.is_resumable) finished_.create();
    remove_on_signal();
    try {
      output_->create();
    } catch (...) {
      removal_.reset();
      if (job_.is_resumable) finished_.remove();
      throw;
    }
    is_ours_ = true;
  }
  void require_space(std::size_t finished) const
  {
    std::error_code error;
    const fs::path parent = job_.names.target.parent_path();
    const fs::space_info space = fs::space(parent.empty() ? fs::path(".") : parent, error);
    if (error) return;
    const auto all = double(job_.pieces->number());
    const double needed = double(output_->size()) * (all - double(finished)) / all;
    if (double(space.available) < needed)
      throw Error("the disk has " + in_megabytes(double(space.available)) +
                  " left, and the output takes " + in_megabytes(needed));
  }
  void remove_on_signal()
  {
    if (job_.is_resumable) return;
    const std::size_t files = job_.names.folder.empty() ? 0 : job_.pieces->number();
    removal_.emplace(job_.names.part.string(), files);
  }

  const Pieces_job& job_;
  const Finished_pieces finished_;
  std::unique_ptr<Piece_output> output_;
  Limit_summary summary_;
  bool is_ours_ = false, is_open_ = false;
  std::optional<Temporary_on_signal> removal_;
};

void write_own_pieces(Unfinished_output& output, std::size_t pieces, const Report& report)
{
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds pause(2);
  Clock::time_point said = Clock::now();
  const unsigned rank = ranks().rank(), number = ranks().number();
  for (std::size_t i = rank; i < pieces; i += number) {
    if (!output.is_finished(i)) output.write(i);
    if (Clock::now() - said < pause) continue;
    report.progress("piece " + std::to_string(i + 1) + " of " + std::to_string(pieces));
    said = Clock::now();
  }
}

// of all pieces, of which each rank looks at its own
void set_box(Any_pieces& pieces)
{
  CGAL::Bbox_3 box;
  for (std::size_t i = ranks().rank(); i < pieces.number(); i += ranks().number())
    box += pieces.box_of_piece(i);
  std::vector<double> sides{-box.xmin(), -box.ymin(), -box.zmin(),
                            box.xmax(),  box.ymax(),  box.zmax()};
  ranks().take_largest(sides);
  pieces.set_box({-sides[0], -sides[1], -sides[2], sides[3], sides[4], sides[5]});
}

void add_up(Limit_summary& summary)
{
  std::vector<double> largest{summary.error, summary.tolerance, summary.box, summary.normal_error,
                              double(summary.depth)};
  ranks().take_largest(largest);
  summary.error = largest[0];
  summary.tolerance = largest[1];
  summary.box = largest[2];
  summary.normal_error = largest[3];
  summary.depth = static_cast<unsigned>(largest[4]);
  std::vector<double> sums{double(summary.number_of_misses), double(summary.number_of_stand_ins)};
  ranks().take_sums(sums);
  summary.number_of_misses = static_cast<std::size_t>(sums[0]);
  summary.number_of_stand_ins = static_cast<std::size_t>(sums[1]);
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

Limit_summary write_pieces(const Pieces_job& job, const std::string& output, const Report& report)
{
  Ranks& all = ranks();
  try {
    Unfinished_output unfinished(job);
    if (all.rank() == 0) unfinished.create();
    all.begin_work();
    if (job.limit.is_used()) set_box(*job.pieces);
    unfinished.open();
    write_own_pieces(unfinished, job.pieces->number(), report);
    unfinished.close();
    all.wait_for_all();
    Limit_summary summary = unfinished.summary();
    if (job.limit.is_used()) add_up(summary);
    if (all.rank() == 0)
      unfinished.finish();
    else
      unfinished.leave();
    return summary;
  } catch (const Failure_of_another_rank&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(output + ": not enough memory for a piece: ask for more --pieces");
  } catch (const std::exception& e) {
    throw Error(output + ": " + message_of(e));
  }
}

} // namespace pn_subdivide
