// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Report.h"

#include "io/Error.h"
#include "io/Output_file.h"
#include "io/mesh_io.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace pn_subdivide {

Report::Report(Report_options options, bool silent)
  : options_(std::move(options))
  , silent_(silent)
  , start_(std::chrono::steady_clock::now())
{
  if (silent_) options_.quiet = true;
}

double Report::seconds() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Report::progress(const std::string& text) const
{
  if (!options_.quiet) std::fprintf(stderr, "%s, %.2f s\n", text.c_str(), seconds());
}

void Report::warn_of_dropped(const std::string& text, const std::vector<std::string>& names)
{
  warn(text);
  dropped_.insert(dropped_.end(), names.begin(), names.end());
}

void Report::remark(const std::string& text)
{
  note(text);
  remarks_.push_back(text);
}

void Report::add_repair(const std::string& what, std::size_t number)
{
  if (number > 0) repaired_.emplace_back(what, number);
}

void Report::print_warnings() const
{
  if (silent_) return;
  for (const std::string& w : warnings_) std::fprintf(stderr, "warning: %s\n", w.c_str());
}

void Report::print_notes() const
{
  if (options_.quiet) return;
  for (const std::string& n : notes_) std::fprintf(stderr, "%s\n", n.c_str());
}

void Report::write_file(const Result& result) const
{
  if (silent_ || !options_.file) return;
  using Json = nlohmann::ordered_json; // the keys stay in this order
  const auto row = [](const Row& values) {
    Json of_row = Json::object();
    for (const auto& [key, value] : values)
      std::visit([&of_row, &name = key](const auto& x) { of_row[name] = x; }, value);
    return of_row;
  };
  Json json;
  json["input"] = result.input;
  json["output"] = result.output;
  json["vertices"] = result.vertices;
  json["faces"] = result.faces;
  json["rounds"] = result.rounds;
  json["warnings"] = warnings_;
  json["notes"] = remarks_;
  json["dropped"] = dropped_;
  json["repaired"] = row(repaired_);
  json["limit"] = row(limit_);
  json["check"] = row(check_);
  json["surfaces"] = Json::array();
  for (const Row& values : surfaces_) json["surfaces"].push_back(row(values));
  json["high_faces"] = high_faces_;
  json["tessellation"] = row(tessellation_);
  try {
    Output_file file(*options_.file);
    // what is no UTF-8 in a file's name is replaced
    file.text(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    file.commit();
  } catch (const Error& e) {
    throw Error(*options_.file + ": " + e.what() + "; " + result.output + " is written");
  }
}

void Report::require_no_warnings() const
{
  if (!options_.strict || warnings_.empty()) return;
  throw Strict_error("--strict: " + plural(warnings_.size(), "warning", "warnings") +
                     "; the result is written");
}

} // namespace pn_subdivide
