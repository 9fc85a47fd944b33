// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/parse_numbers.h"

#include "io/Error.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pn_subdivide {

std::pair<std::string, std::string> split_at_colon(const std::string& text)
{
  const std::size_t colon = text.find(':');
  return {text.substr(0, colon), colon == std::string::npos ? "" : text.substr(colon + 1)};
}

namespace {

double parse_number(const std::string& word, const std::string& option)
{
  char* end = nullptr;
  const double x = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(x))
    throw Usage_error(option + ": '" + word + "' is not a number");
  return x;
}

} // namespace

std::vector<double> parse_numbers(const std::string& text, const std::string& option)
{
  std::vector<std::string> words;
  boost::algorithm::split(words, text, boost::algorithm::is_any_of(","));
  std::vector<double> numbers;
  numbers.reserve(words.size());
  for (const std::string& word : words) numbers.push_back(parse_number(word, option));
  return numbers;
}

std::vector<double> parse_numbers(const std::string& text, std::size_t number,
                                  const std::string& option)
{
  std::vector<double> numbers = parse_numbers(text, option);
  if (numbers.size() != number)
    throw Usage_error(option + ": " + std::to_string(number) +
                      " numbers with commas between are expected");
  return numbers;
}

void require_direction(const double* direction, const std::string& option)
{
  if (std::all_of(direction, direction + 3, [](double x) { return x == 0; }))
    throw Usage_error(option + ": the axis has no direction");
}

double parse_roundness(const std::string& text, const std::string& expected)
{
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0' && x >= 0 && x <= 1) return x;
  throw Usage_error("--roundness '" + text + "': expected " + expected + "a number from 0 to 1");
}

} // namespace pn_subdivide
