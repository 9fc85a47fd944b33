// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_UNFINISHED_OUTPUT_H
#define PN_SUBDIVIDE_UNFINISHED_OUTPUT_H

#include "io/Temporary_on_signal.h"
#include "pieces/Finished_pieces.h"
#include "pieces/Piece_output.h"
#include "pieces/pieces_command.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace pn_subdivide {

// The output under its name for the time being, and what is known of it. Unless the run can be continued it goes
// away with the object, or on a signal.
class Unfinished_output
{
public:
  explicit Unfinished_output(const Pieces_job& job);
  ~Unfinished_output();
  Unfinished_output(const Unfinished_output&) = delete;
  Unfinished_output& operator=(const Unfinished_output&) = delete;

  // by one rank
  void create();
  // by all
  void open();

  // Is it on the disk as it was written?
  bool is_finished(std::size_t piece) const;
  void write(std::size_t i);
  // what the limits of the pieces that were written have reached
  const Limit_summary& summary() const { return summary_; }
  void close() { output_->close(); }
  // by one rank, when all have closed it
  void finish();
  // by the others
  void leave() { is_ours_ = false; }

private:
  void begin();
  void require_space(std::size_t finished) const;
  void remove_on_signal();

  const Pieces_job& job_;
  const Finished_pieces finished_;
  std::unique_ptr<Piece_output> output_;
  Limit_summary summary_;
  bool is_ours_ = false, is_open_ = false;
  std::optional<Temporary_on_signal> removal_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_UNFINISHED_OUTPUT_H
