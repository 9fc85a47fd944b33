// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Report.h"

#include <cstdio>

namespace pn_subdivide {

std::string enumeration(const std::vector<std::string>& names)
{
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return list;
}

double Report::seconds() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Report::progress(const std::string& text) const
{
  if (!quiet_) std::fprintf(stderr, "%s, %.2f s\n", text.c_str(), seconds());
}

void Report::print_warnings() const
{
  if (silent_) return;
  for (const std::string& w : warnings_) std::fprintf(stderr, "warning: %s\n", w.c_str());
}

void Report::print_notes() const
{
  if (quiet_) return;
  for (const std::string& n : notes_) std::fprintf(stderr, "%s\n", n.c_str());
}

} // namespace pn_subdivide
