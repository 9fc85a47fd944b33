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
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pn_subdivide {

struct Report_options
{
  bool quiet = false, strict = false;
  std::optional<std::string> file; // --report
};

// What a run says on standard error besides errors: progress at once, warnings and notes when the output
// is complete, so that a run that fails under --quiet says one line only. And what --report writes.
class Report
{
public:
  // What has been made of what.
  struct Result
  {
    std::string input, output;
    std::size_t vertices, faces;
    unsigned rounds;
  };
  using Value =
    std::pair<std::string,
              std::variant<bool, std::size_t, double, std::string, std::vector<double>>>;
  using Row = std::vector<Value>;

  // One that is silent says nothing and writes no file: another process does.
  explicit Report(Report_options options, bool silent = false);

  bool is_quiet() const { return options_.quiet; }
  double seconds() const;

  // The time since the start is put behind. Not with --quiet.
  void progress(const std::string& text) const;
  void warn(const std::string& text) { warnings_.push_back(text); }
  // the same, of `names` of the user's that are not in the result
  void warn_of_dropped(const std::string& text, const std::vector<std::string>& names);
  // Not with --quiet.
  void note(const std::string& text) { notes_.push_back(text); }

  // The same, and for --report: what data of the input was taken for.
  void remark(const std::string& text);

  // For --report only: how many of what --repair and merging of points have changed, what is known of limits, and
  // what --check has measured.
  void add_repair(const std::string& what, std::size_t number);
  void set_limit(Row numbers) { limit_ = std::move(numbers); }
  void set_check(Row values) { check_ = std::move(values); }
  // the same of recognized surfaces, one a row, and of tessellations
  void set_surfaces(std::vector<Row> rows) { surfaces_ = std::move(rows); }
  // control faces that are higher than with the linear scheme
  void set_high_faces(std::vector<std::size_t> faces) { high_faces_ = std::move(faces); }
  void set_tessellation(Row values) { tessellation_ = std::move(values); }

  // To be called once each in this order, when the output is complete.
  void print_warnings() const;
  void write_file(const Result& result) const;
  void print_notes() const;
  // Throws Strict_error.
  void require_no_warnings() const;

private:
  Report_options options_;
  bool silent_;
  std::chrono::steady_clock::time_point start_;
  std::vector<std::string> warnings_, notes_, remarks_, dropped_;
  Row repaired_, limit_, check_, tessellation_;
  std::vector<Row> surfaces_;
  std::vector<std::size_t> high_faces_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_REPORT_H
