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
#include "io/Temporary_on_signal.h"
#include "pieces/Finished_pieces.h"
#include "pieces/Piece_output.h"
#include "pieces/Ranks.h"
#include "surface/control_mesh.h"

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <chrono>
#include <filesystem>
#include <new>
#include <optional>
#include <string>

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

std::string in_megabytes(double bytes)
{
  return std::to_string(static_cast<unsigned long long>(bytes / (1 << 20)) + 1) + " MB";
}

// The output under its name for the time being, and what is known of it. Unless the run can be continued it goes
// away with the object, or on a signal.
class Unfinished_output
{
public:
  Unfinished_output(const Pieces_job& job, const Mesh_file& output)
    : job_(job)
    , target_(Output_file::regular_target(output.name))
    , part_(target_.string() + ".part")
    , finished_(part_.string() + ".done", job.name, job.pieces->number())
    , output_((output.format == "ply" ? make_ply_output : make_pvtp_output)(
        *job.pieces, job.has_normals, part_, target_))
    , is_folder_(output.format != "ply")
  {}
  ~Unfinished_output()
  {
    if (!is_ours_ || job_.is_resumable) return;
    std::error_code ignored;
    // of several ranks that fail one finds something to remove
    const auto removed = fs::remove_all(part_, ignored);
    if (!is_open_) return;
    if (removed == 0 || removed == static_cast<std::uintmax_t>(-1))
      ranks().leave_report_to_others();
  }
  Unfinished_output(const Unfinished_output&) = delete;
  Unfinished_output& operator=(const Unfinished_output&) = delete;

  // by one rank
  void create()
  {
    const bool is_new = !fs::exists(part_);
    if (!is_new) require_continuation();
    require_space();
    if (!is_new) return;
    own();
    output_->create();
    if (job_.is_resumable) finished_.create();
  }
  // by all
  void open()
  {
    if (!is_ours_) own();
    is_open_ = true;
    if (job_.is_resumable) finished_.read();
    output_->open();
  }

  bool is_finished(std::size_t piece) const
  {
    return job_.is_resumable && finished_.is_finished(piece);
  }
  void write(std::size_t i)
  {
    output_->write(i, job_.pieces->piece(i));
    if (!job_.is_resumable) return;
    output_->sync(i);
    finished_.set_finished(i);
  }
  void close() { output_->close(); }
  // by one rank, when all have closed it
  void finish()
  {
    output_->finish();
    is_ours_ = false;
    std::error_code ignored;
    if (job_.is_resumable) fs::remove(part_.string() + ".done", ignored);
  }
  // by the others
  void leave() { is_ours_ = false; }

private:
  void require_continuation()
  {
    const std::string name = part_.string();
    if (!job_.is_resumable)
      throw Error(name + " is there: another run is writing it, or one was interrupted; delete "
                         "it, or continue with --resume if that run had it");
    if (!finished_.exists())
      throw Error(name + " is there without " + part_.filename().string() +
                  ".done, and cannot be continued: delete it");
    finished_.read();
  }

  void require_space() const
  {
    std::error_code error;
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    const fs::space_info space = fs::space(folder, error);
    if (error) return;
    const double all = double(job_.pieces->number());
    const double needed = double(output_->size()) * (all - double(finished_.number())) / all;
    if (double(space.available) < needed)
      throw Error("the disk has " + in_megabytes(double(space.available)) +
                  " left, and the output takes " + in_megabytes(needed));
  }

  void own()
  {
    if (!job_.is_resumable) {
      if (is_folder_)
        removal_.emplace(part_.string(), job_.pieces->number());
      else
        removal_.emplace(part_.string());
    }
    is_ours_ = true;
  }

  const Pieces_job& job_;
  fs::path target_, part_;
  Finished_pieces finished_;
  std::unique_ptr<Piece_output> output_;
  bool is_folder_;
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

} // namespace

void write_pieces(const Pieces_job& job, const Mesh_file& output, [[maybe_unused]] unsigned threads,
                  const Report& report)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#endif
  Ranks& all = ranks();
  try {
    Unfinished_output unfinished(job, output);
    if (all.rank() == 0) unfinished.create();
    all.begin_work();
    unfinished.open();
    write_own_pieces(unfinished, job.pieces->number(), report);
    unfinished.close();
    all.wait_for_all();
    if (all.rank() == 0)
      unfinished.finish();
    else
      unfinished.leave();
  } catch (const Failure_of_another_rank&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(output.name + ": not enough memory for a piece: ask for more --pieces");
  } catch (const std::exception& e) {
    throw Error(output.name + ": " + message_of(e));
  }
}

} // namespace pn_subdivide
