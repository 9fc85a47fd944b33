// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_ERROR_H
#define PN_SUBDIVIDE_ERROR_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace pn_subdivide {

// What the process returns; documented in --help, so these numbers stay.
enum Exit_code {
  exit_ok = 0,
  exit_failure = 1,
  exit_usage = 2,
  exit_tolerance = 3,
  exit_warnings = 4
};

// Something is wrong with a file or with what is in it.
struct Error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// With what is to be written, and says so.
struct Output_error : Error
{
  using Error::Error;
};

// Something is wrong with the command line itself.
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// The result deviates more than --tolerance allows; it has been written.
struct Tolerance_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// There are warnings, and --strict is given; the result has been written.
struct Strict_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// What people read of an exception: without the name of the library, and nothing of allocators.
std::string message_of(const std::exception& e);

// Runs f(), and names the file in what it throws.
template <class Function>
auto naming(const std::string& file, const Function& f)
{
  try {
    return f();
  } catch (const std::exception& e) {
    throw Error(file + ": " + message_of(e));
  }
}

// what errno means
std::string reason(int error);

// What std::printf() prints.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

inline std::string three_digits(double x)
{
  return formatted("%.3g", x);
}

// "1 face", "2 faces"
inline std::string plural(std::size_t n, const std::string& one, const std::string& many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

// "groups, materials and colors"
std::string enumeration(const std::vector<std::string>& names, const std::string& last = "and");

// "; did you mean --levels?", or nothing: of the word that was probably meant at most a third of the letters are added, missing
// or others, or it goes on where `word` ends.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_ERROR_H
