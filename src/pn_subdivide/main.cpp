// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The command line. What it means is in surface_command.h and curve_command.h.

#include "curve/curve_command.h"
#include "io/Error.h"
#include "surface/surface_command.h"

#include <CLI/CLI.hpp>

#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <new>
#include <sstream>
#include <string>

using namespace pn_subdivide;

namespace {

const char* const footer =
  "Reads .ply .off .obj .stl, writes .ply .off .obj .vtp; messages count vertices and faces from "
  "0.\nExit code: 0 success, 1 failure, 2 wrong command line; a failure prints one line on "
  "standard\nerror and leaves OUTPUT as it was. 3 the deviation exceeds --tolerance; OUTPUT is "
  "written.";

const char* const curve_footer =
  "Files are text with a vertex a line: x y nx ny, or x y z nx ny nz, or without normals x y or\n"
  "x y z; blank lines and # comments are skipped. 0 0 (0 0 0) means: no control normal here. In "
  "the\nplane missing normals are estimated. Messages count lines from 1.\nExit code: 0 success, 1 "
  "failure, 2 wrong command line; a failure prints one line on standard\nerror and leaves OUTPUT "
  "as it was. 3 the deviation exceeds --tolerance; OUTPUT is written.";

// Alone CLI11 takes an empty word, as of a shell variable that is not set, for 0, and words that
// begin with 0 for octal or hexadecimal numbers.
CLI::Validator whole_number()
{
  const auto check = [](std::string& word) {
    if (word.empty() || word.find_first_not_of("0123456789") != std::string::npos)
      return "'" + word + "' is not a whole number";
    word.erase(0, (std::min)(word.find_first_not_of('0'), word.size() - 1));
    return std::string();
  };
  return CLI::Validator(check, "");
}

// A number or a fraction such as 1/16.
double parse_fraction(const char* option, const std::string& text)
{
  std::istringstream in(text);
  double numerator = 0, denominator = 1;
  char slash = 0;
  in >> numerator;
  bool good = !in.fail();
  if (good && in >> slash) good = slash == '/' && (in >> denominator) && denominator != 0;
  if (!good || !(in >> std::ws).eof())
    throw Usage_error(option + (" '" + text) + "': it takes a number or a fraction such as 1/16");
  return numerator / denominator;
}

void add_verify_options(CLI::App& command, Verify_options& options, const std::string& shapes)
{
  CLI::Option* const verify =
    command.add_option("--verify", options.shape,
                       "Print the largest deviation D of the result from " + shapes +
                         ", and the bound (5 R + 3 |C|) 2^-52 that it keeps if the control data is "
                         "on the shape up to rounding");
  command
    .add_option("--tolerance", options.tolerance,
                "With --verify: exit with 3, OUTPUT written, if D is more than this times R")
    ->check([](const std::string& word) { return word.empty() ? "a number is expected" : ""; })
    ->needs(verify);
}

void add_surface_command(CLI::App& app, Surface_options& options)
{
  CLI::App* surface = app.add_subcommand("surface", "Subdivide a mesh");
  surface->footer(footer);
  surface->add_option("INPUT", options.input, "Control mesh")->required();
  surface->add_option("OUTPUT", options.output, "Refined mesh")->required();
  surface
    ->add_option(
      "--scheme", options.scheme.scheme,
      "catmull-clark, loop, doo-sabin, sqrt3, butterfly, kobbelt, modified-catmull-clark or "
      "modified-loop")
    ->required();
  surface->add_option("--normal-scheme", options.scheme.normal_scheme,
                      "Another scheme for the normals, with the same split of the faces");
  surface->add_option_function<std::string>(
    "--tension",
    [&options](const std::string& text) {
      options.scheme.tension = parse_fraction("--tension", text);
    },
    "Kobbelt's tension, a number or a fraction; default 1/16");
  surface->add_option_function<std::string>(
    "--cap",
    [&options](const std::string& text) { options.scheme.cap = parse_fraction("--cap", text); },
    "Of a modified scheme: bound of its eigenvalues, C in C lambda^2, a number or a fraction; "
    "0 < C <= 1, default 1/2");
  surface
    ->add_option("--levels", options.levels, "Rounds of subdivision; 0 copies the control data")
    ->transform(whole_number())
    ->capture_default_str();
  surface->add_flag("--linear", options.linear, "The linear scheme, without normals");
  surface->add_option("--normals", options.normals,
                      "Control normals: auto (the file's if it has any, else estimated), file, "
                      "estimate, none, sphere:X,Y,Z or cylinder:X,Y,Z,DX,DY,DZ");
  surface->add_option("--curvature", options.curvature,
                      "Add gaussian or mean curvature to the vertices, and colors for it, "
                      "symmetric about 0 (.ply, .vtp)");
  surface->add_option("--threads", options.threads, "Number of threads; 0 for all cores")
    ->transform(whole_number())
    ->capture_default_str();
  add_verify_options(*surface, options.verify, "sphere:X,Y,Z,R or cylinder:X,Y,Z,DX,DY,DZ,R");
  surface->add_flag("--repair", options.repair,
                    "Orient the faces and duplicate non-manifold edges and vertices");
  surface->add_flag("--ascii", options.ascii, "PLY and VTP as text");
  surface->add_flag("--quiet", options.quiet, "No progress on standard error");
}

CLI::App* add_curve_command(CLI::App& app, Curve_options& options)
{
  CLI::App* curve = app.add_subcommand("curve", "Subdivide a polygon in the plane or in space");
  curve->footer(curve_footer);
  curve->add_option("INPUT", options.input, "Control polygon")->required();
  curve->add_option("OUTPUT", options.output, "Refined curve")->required();
  curve
    ->add_option("--scheme", options.scheme,
                 "bspline:DEGREE (2 to 9), chaikin (bspline:2), 4-point, 6-point, 8-point, "
                 "10-point, ..., 20-point")
    ->required();
  curve->add_option("--normal-scheme", options.normal_scheme,
                    "Another scheme for the normals; both primal (odd degrees, N-point) or both "
                    "dual (even degrees)");
  curve->add_option("--levels", options.levels, "Rounds of subdivision; 0 copies the control data")
    ->transform(whole_number())
    ->capture_default_str();
  curve->add_flag("--linear", options.linear, "The linear scheme, without normals");
  curve->add_flag("--closed", options.closed,
                  "The polygon is closed; its first vertex is not repeated");
  curve->add_option("--end", options.end,
                    "Ends of an open polygon: reflect (default for primal schemes: up to the end "
                    "points) or none (default for dual ones: as far as whole stencils reach)");
  curve->add_option("--comb", options.comb,
                    "Draw curve, control polygon, control normals and curvature comb into this "
                    "SVG file");
  add_verify_options(*curve, options.verify,
                     "circle:X,Y,R or, in space, circle:X,Y,Z,NX,NY,NZ,R, sphere:X,Y,Z,R or "
                     "cylinder:X,Y,Z,DX,DY,DZ,R");
  curve->add_flag("--quiet", options.quiet, "No progress on standard error");
  return curve;
}

int run(int argc, char** argv)
{
  CLI::App app(
    "Point-normal subdivision of meshes and curves: spheres, cylinders and circles stay what they "
    "are",
    "pn_subdivide");
  app.set_version_flag("--version", PN_SUBDIVIDE_VERSION);
  app.require_subcommand(1);
  app.footer(footer);

  Surface_options options;
  add_surface_command(app, options);
  Curve_options curve_options;
  const CLI::App* curve = add_curve_command(app, curve_options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(e);
    throw Usage_error(std::string(e.what()) + " (see pn_subdivide --help)");
  }
  if (curve->parsed())
    run_curve_command(curve_options);
  else
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
  } catch (const Tolerance_error& e) {
    return report(e.what(), exit_tolerance);
  } catch (const std::bad_alloc&) {
    return report("not enough memory", exit_failure);
  } catch (const std::exception& e) {
    return report(e.what(), exit_failure);
  }
}
