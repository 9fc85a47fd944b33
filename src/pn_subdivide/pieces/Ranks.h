// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_RANKS_H
#define PN_SUBDIVIDE_RANKS_H

#include "pieces/Shared_file.h"

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

namespace pn_subdivide {

// Another rank fails, and says why.
struct Failure_of_another_rank : std::runtime_error
{
  Failure_of_another_rank()
    : std::runtime_error("another rank failed")
  {}
};

// The processes that share the work: the ranks of mpirun, or this process alone.
class Ranks
{
public:
  virtual ~Ranks() = default;

  unsigned rank() const { return rank_; }
  unsigned number() const { return number_; }

  // To be called by all. What fails before it fails in all ranks, or is known to all here: throws
  // Failure_of_another_rank.
  virtual void begin_work() {}
  // to be called by all
  virtual void wait_for_all() {}
  // Each number becomes the largest one of all ranks, or their sum. To be called by all.
  virtual void take_largest(std::vector<double>& /*numbers*/) {}
  virtual void take_sums(std::vector<double>& /*numbers*/) {}
  // to be called by all
  virtual std::unique_ptr<Shared_file> open(const std::filesystem::path& file)
  {
    return open_file(file);
  }

  // Another rank has said, or will say, why the work ends.
  void leave_report_to_others() { is_reporter_ = false; }
  // To be called once by a rank that fails: is it the one to say so?
  virtual bool reports_failure() { return is_reporter_; }
  // To be called last. With a code other than 0 all ranks end.
  virtual void end(int /*code*/) {}

protected:
  unsigned rank_ = 0, number_ = 1;
  bool is_reporter_ = true;
};

// Those of this run. Throws Usage_error under mpirun if the program was built without MPI.
Ranks& ranks();

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_RANKS_H
