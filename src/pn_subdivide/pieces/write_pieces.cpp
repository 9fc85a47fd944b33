// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/pieces_command.h"

#include "io/Error.h"
#include "pieces/Ranks.h"
#include "pieces/Unfinished_output.h"

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <chrono>
#include <new>
#include <string>
#include <vector>

namespace pn_subdivide {
namespace {

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
  std::vector<double> sums{double(summary.misses), double(summary.stand_ins)};
  ranks().take_sums(sums);
  summary.misses = static_cast<std::size_t>(sums[0]);
  summary.stand_ins = static_cast<std::size_t>(sums[1]);
}

} // namespace

Limit_summary write_pieces(const Pieces_job& job, const std::string& output,
                           [[maybe_unused]] unsigned threads, const Report& report)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#endif
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
