// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Unfinished_output.h"

#include "io/Error.h"
#include "pieces/Ranks.h"

#include <filesystem>
#include <string>
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

} // namespace

Unfinished_output::Unfinished_output(const Pieces_job& job)
  : job_(job)
  , finished_(job.names.done, job.name)
  , output_(make_output(job))
{}

Unfinished_output::~Unfinished_output()
{
  if (!is_ours_ || job_.is_resumable) return;
  // of several ranks that fail one finds something to remove
  const bool was_there = output_->remove();
  if (is_open_ && !was_there) ranks().leave_report_to_others();
}

void Unfinished_output::create()
{
  const bool is_new = !fs::exists(job_.names.part);
  require_space(is_new || !job_.is_resumable ? 0 : finished_.number());
  if (is_new) begin();
  output_->mend();
}

// The file that tells what is finished comes first: alone it can be continued.
void Unfinished_output::begin()
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

void Unfinished_output::open()
{
  if (!is_ours_) remove_on_signal();
  is_ours_ = is_open_ = true;
  output_->open();
}

bool Unfinished_output::is_finished(std::size_t piece) const
{
  if (!job_.is_resumable) return false;
  const std::string receipt = finished_.receipt(piece);
  return !receipt.empty() && output_->is_written(piece, receipt);
}

void Unfinished_output::write(std::size_t i)
{
  const Any_pieces::Piece piece = job_.pieces->piece(i, job_.normals.rings());
  output_->write(i, piece);
  const auto& limits = piece.limit_report();
  const double tolerance = job_.limit.tolerance.value_or(default_limit_tolerance);
  summary_.add({limits, limits.tolerance / tolerance});
  if (job_.is_resumable) finished_.set_finished(i, output_->sync(i));
}

void Unfinished_output::finish()
{
  output_->finish();
  is_ours_ = false;
  if (job_.is_resumable) finished_.remove();
}

void Unfinished_output::require_space(std::size_t finished) const
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

void Unfinished_output::remove_on_signal()
{
  if (job_.is_resumable) return;
  const std::size_t files = job_.names.folder.empty() ? 0 : job_.pieces->number();
  removal_.emplace(job_.names.part.string(), files);
}

} // namespace pn_subdivide
