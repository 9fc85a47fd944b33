// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/pieces_command.h"

#include "io/Error.h"
#include "io/Output_file.h"
#include "pieces/Ranks.h"
#include "surface/refine_surface.h"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <new>
#include <optional>
#include <system_error>

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

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
    const double all = double(job_.pieces->number());
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
