// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_REPORT_H
#define PN_SUBDIVIDE_REPORT_H

#include <chrono>
#include <string>
#include <vector>

namespace pn_subdivide {

// "groups, materials and colors"
std::string enumeration(const std::vector<std::string>& names);

// What a run says on standard error besides errors: progress at once, warnings and notes when the output
// is complete, so that a run that fails under --quiet says one line only.
class Report
{
public:
  // One that is silent prints no warnings either: other processes do.
  explicit Report(bool quiet, bool silent = false)
    : quiet_(quiet || silent)
    , silent_(silent)
    , start_(std::chrono::steady_clock::now())
  {}

  bool is_quiet() const { return quiet_; }
  double seconds() const;

  // The time since the start is put behind. Not with --quiet.
  void progress(const std::string& text) const;
  void warn(const std::string& text) { warnings_.push_back(text); }
  // Not with --quiet.
  void note(const std::string& text) { notes_.push_back(text); }

  // To be called once each, when the output is complete.
  void print_warnings() const;
  void print_notes() const;

private:
  bool quiet_, silent_;
  std::chrono::steady_clock::time_point start_;
  std::vector<std::string> warnings_, notes_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_REPORT_H
