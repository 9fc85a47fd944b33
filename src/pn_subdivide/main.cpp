// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The command line. What it means is in surface_command.h.

#include "Error.h"
#include "surface_command.h"

#include <CLI/CLI.hpp>

#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <csignal>
#include <cstdio>
#include <new>
#include <sstream>
#include <string>

using namespace pn_subdivide;

namespace {

const char* const footer =
  "Reads .ply .off .obj .stl, writes .ply .off .obj .vtp; messages count vertices and faces from "
  "0.\nExit code: 0 success, 1 failure, 2 wrong command line (3 is reserved for --tolerance). A "
  "failure\nprints one line on standard error and leaves OUTPUT as it was.";

// Options that are spoken for. They are refused by name, so that nobody takes them for typos.
const char* const later_options[] = {"--cap", "--curvature", "--verify", "--tolerance"};

// A number or a fraction such as 1/16.
double parse_tension(const std::string& text)
{
  std::istringstream in(text);
  double numerator = 0, denominator = 1;
  char slash = 0;
  in >> numerator;
  bool good = !in.fail();
  if (good && in >> slash) good = slash == '/' && (in >> denominator) && denominator != 0;
  if (!good || !(in >> std::ws).eof())
    throw Usage_error("--tension '" + text + "': it takes a number or a fraction such as 1/16");
  return numerator / denominator;
}

CLI::App* add_surface_command(CLI::App& app, Surface_options& options)
{
  CLI::App* surface = app.add_subcommand("surface", "Subdivide a mesh");
  surface->footer(footer);
  surface->add_option("INPUT", options.input, "Control mesh")->required();
  surface->add_option("OUTPUT", options.output, "Refined mesh")->required();
  surface
    ->add_option("--scheme", options.scheme.scheme,
                 "catmull-clark, loop, doo-sabin, sqrt3, butterfly or kobbelt")
    ->required();
  surface->add_option("--normal-scheme", options.scheme.normal_scheme,
                      "Another scheme for the normals, with the same split of the faces");
  surface->add_option_function<std::string>(
    "--tension",
    [&options](const std::string& text) { options.scheme.tension = parse_tension(text); },
    "Kobbelt's tension, a number or a fraction; default 1/16");
  surface
    ->add_option("--levels", options.levels, "Rounds of subdivision; 0 copies the control data")
    ->capture_default_str();
  surface->add_flag("--linear", options.linear, "The linear scheme, without normals");
  surface->add_option("--normals", options.normals,
                      "Control normals: auto (the file's if it has any, else estimated), file, "
                      "estimate, none, sphere:X,Y,Z or cylinder:X,Y,Z,DX,DY,DZ");
  surface->add_option("--threads", options.threads, "Number of threads; 0 for all cores")
    ->capture_default_str();
  surface->add_flag("--repair", options.repair,
                    "Orient the faces and duplicate non-manifold edges and vertices");
  surface->add_flag("--ascii", options.ascii, "PLY and VTP as text");
  surface->add_flag("--quiet", options.quiet, "No progress on standard error");
  for (const char* later : later_options) surface->add_option(later)->group("");
  return surface;
}

void refuse_later_options(const CLI::App& surface)
{
  for (const char* later : later_options)
    if (surface.count(later) > 0) throw Usage_error(std::string(later) + " is not available yet");
}

int run(int argc, char** argv)
{
  CLI::App app(
    "Point-normal subdivision of meshes: spheres, cylinders and circles stay what they are",
    "pn_subdivide");
  app.set_version_flag("--version", PN_SUBDIVIDE_VERSION);
  app.require_subcommand(1);
  app.footer(footer);

  Surface_options options;
  const CLI::App* surface = add_surface_command(app, options);
  const CLI::App* curve = app.add_subcommand("curve", "")->group("")->allow_extras();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(e);
    throw Usage_error(std::string(e.what()) + " (see pn_subdivide --help)");
  }
  if (curve->parsed()) throw Usage_error("the subcommand 'curve' is not available yet");
  refuse_later_options(*surface);
  run_surface_command(options);
  return exit_ok;
}

int report(std::string message, Exit_code code)
{
  boost::algorithm::trim(message);
  boost::algorithm::replace_all(message, "\n", " ");
  std::fprintf(stderr, "pn_subdivide: %s\n", message.c_str());
  return code;
}

} // namespace

int main(int argc, char** argv)
{
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN); // a file size limit is then an error in writing like a full disk
#endif
  try {
    return run(argc, argv);
  } catch (const Usage_error& e) {
    return report(e.what(), exit_usage);
  } catch (const std::bad_alloc&) {
    return report("not enough memory", exit_failure);
  } catch (const std::exception& e) {
    return report(e.what(), exit_failure);
  }
}
