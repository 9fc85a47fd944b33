// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_TEMPORARY_ON_SIGNAL_H
#define PN_SUBDIVIDE_TEMPORARY_ON_SIGNAL_H

#include <cstddef>
#include <string>

namespace pn_subdivide {

// While it lives, a signal that ends the program (an interrupt at the keyboard, a closed terminal,
// kill) removes the file first. Signals that the caller ignores, as nohup does, stay ignored.
class Temporary_on_signal
{
public:
  explicit Temporary_on_signal(const std::string& file)
    : Temporary_on_signal(file, 0)
  {}
  // A folder with files piece_0.vtp, piece_1.vtp, ..., of which some may be there.
  Temporary_on_signal(const std::string& folder, std::size_t pieces);
  ~Temporary_on_signal();
  Temporary_on_signal(const Temporary_on_signal&) = delete;
  Temporary_on_signal& operator=(const Temporary_on_signal&) = delete;

private:
  std::size_t slot_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_TEMPORARY_ON_SIGNAL_H
