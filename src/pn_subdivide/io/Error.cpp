// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <limits>
#include <new>
#include <numeric>
#include <system_error>

namespace pn_subdivide {

std::string message_of(const std::exception& e)
{
  const std::string library = "PN_subdivision_3: ";
  const std::string what = e.what();
  const bool is_of_library = what.find(library) != std::string::npos;
  // what std::vector says of sizes that it cannot have is for programmers
  if (dynamic_cast<const std::bad_alloc*>(&e) ||
      (dynamic_cast<const std::length_error*>(&e) && !is_of_library))
    return "not enough memory";
  return boost::algorithm::replace_all_copy(what, library, "");
}

std::string reason(int error)
{
  return std::generic_category().message(error);
}

std::string formatted(const char* format, ...)
{
  char text[400];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

std::string enumeration(const std::vector<std::string>& names, const std::string& last)
{
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list += (i == 0 ? "" : i + 1 == names.size() ? " " + last + " " : ", ") + names[i];
  return list;
}

namespace {

// Levenshtein's distance: letters added, missing or others.
std::size_t distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t other = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = (std::min)({row[j] + 1, row[j + 1] + 1, other});
    }
  }
  return row.back();
}

constexpr std::size_t longest_word = 100; // nothing that is known comes near

} // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known)
{
  if (word.size() > longest_word) return {};
  std::string nearest;
  std::size_t least = (std::numeric_limits<std::size_t>::max)();
  for (const std::string& candidate : known) {
    const bool goes_on = word.size() > 3 && candidate.rfind(word, 0) == 0;
    const std::size_t d = distance(word, candidate);
    if ((3 * d > candidate.size() && !goes_on) || d >= least) continue;
    least = d;
    nearest = candidate;
  }
  return nearest.empty() ? "" : "; did you mean " + nearest + "?";
}

} // namespace pn_subdivide
