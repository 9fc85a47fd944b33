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

} // namespace

void write_pieces(const Pieces_job& job, const std::string& output,
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
    throw Error(output + ": not enough memory for a piece: ask for more --pieces");
  } catch (const std::exception& e) {
    throw Error(output + ": " + message_of(e));
  }
}

} // namespace pn_subdivide
