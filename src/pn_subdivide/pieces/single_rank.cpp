// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// In a program without MPI: this process alone.

#include "io/Error.h"
#include "pieces/Ranks.h"

#include <cstdlib>
#include <string>

namespace pn_subdivide {
namespace {

void require_one_process()
{
  for (const char* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* const size = std::getenv(name))
      if (std::atoi(size) > 1)
        throw Usage_error("this program was built without MPI and cannot share the work of " +
                          std::string(size) + " ranks: run it without mpirun");
}

} // namespace

Ranks& ranks()
{
  static Ranks alone;
  static const bool checked = (require_one_process(), true);
  (void)checked;
  return alone;
}

} // namespace pn_subdivide
