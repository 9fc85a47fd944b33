// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "options.h"
#include "pieces/Ranks.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <csignal>
#include <cstdio>
#include <string>

using namespace pn_subdivide;

namespace {

int run(int argc, char** argv)
{
  ranks(); // before anything that they could fail in together
  const Command command = parse_command_line(argc, argv);
  if (const auto* surface = std::get_if<Surface_options>(&command))
    run_surface_command(*surface);
  else if (const auto* curve = std::get_if<Curve_options>(&command))
    run_curve_command(*curve);
  return exit_ok;
}

int report(std::string message, Exit_code code)
{
  boost::algorithm::trim(message);
  boost::algorithm::replace_all(message, "\n", " ");
  if (ranks().reports_failure()) std::fprintf(stderr, "pn_subdivide: %s\n", message.c_str());
  return code;
}

int run_and_report(int argc, char** argv)
{
  try {
    return run(argc, argv);
  } catch (const Usage_error& e) {
    return report(e.what(), exit_usage);
  } catch (const Tolerance_error& e) {
    return report(e.what(), exit_tolerance);
  } catch (const Strict_error& e) {
    return report(e.what(), exit_warnings);
  } catch (const std::exception& e) {
    return report(message_of(e), exit_failure);
  }
}

} // namespace

int main(int argc, char** argv)
{
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN); // a file size limit is then an error in writing like a full disk
#endif
  const int code = run_and_report(argc, argv);
  ranks().end(code);
  return code;
}
