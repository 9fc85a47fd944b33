// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OUTPUT_LOCK_H
#define PN_SUBDIVIDE_OUTPUT_LOCK_H

#include "io/Temporary_on_signal.h"

#include <filesystem>
#include <optional>

namespace pn_subdivide {

// While it lives no other process of this program writes the same output. The system takes the lock back
// from a process that is killed; the file that is left then stands in nobody's way.
class Output_lock
{
public:
  // Throws Error if another process has the lock, or if the file is not of this program.
  explicit Output_lock(std::filesystem::path file);
  ~Output_lock();
  Output_lock(const Output_lock&) = delete;
  Output_lock& operator=(const Output_lock&) = delete;

private:
  enum class Attempt { held, again };

  Attempt make();
  Attempt take_over();
  void close();

  std::filesystem::path file_;
  std::optional<Temporary_on_signal> removal_;
  int descriptor_ = -1;
  int looks_left_ = 100; // at a file that is empty
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OUTPUT_LOCK_H
