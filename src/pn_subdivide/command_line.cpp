// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The command line. What it means is in surface/surface_command.cpp and curve/curve_command.cpp.

#include "options.h"

#include "io/Error.h"
#include "io/mesh_io.h"

#include <CGAL/PN_subdivision_3/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>
#include <vector>

namespace pn_subdivide {
namespace {

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
double parse_fraction(const std::string& option, const std::string& text)
{
  std::istringstream in(text);
  double numerator = 0, denominator = 1;
  char slash = 0;
  in >> numerator;
  bool good = !in.fail();
  if (good && in >> slash) good = slash == '/' && (in >> denominator) && denominator != 0;
  if (!good || !(in >> std::ws).eof())
    throw Usage_error(option + " '" + text + "': it takes a number or a fraction such as 1/16");
  return numerator / denominator;
}

// --- options that both commands have ---

// Those that follow are in this group of the help.
void begin_group(CLI::App& command, const char* title)
{
  command.option_defaults()->group(title);
}

void add_quiet_and_help(CLI::App& command, bool& quiet)
{
  command.add_flag("--quiet", quiet, "No progress and no closing line; warnings are still printed");
  command.set_help_flag("-h,--help", "Print this help message and exit"); // the last of its group
}

void add_linear_and_limit(CLI::App& command, bool& linear, Limit_choice& limit,
                          const std::string& points)
{
  command.add_flag("--linear", linear, "The linear scheme, without normals");
  command.add_flag("--limit", limit.points,
                   "Put the " + points + " of the last level on the limit " + limit.shape);
}

void add_limit_options(CLI::App& command, Limit_choice& limit, std::optional<std::string>& mode,
                       const std::string& what)
{
  command.add_option("--limit-tolerance", limit.tolerance,
                     "The largest estimated error of these points, as a part of the bounding box; "
                     "default 1e-9");
  command.add_option("--interpolate", mode,
                     what +
                       " passes through the points: slide (the fairest; exact on spheres, "
                       "cylinders and circles) or points (each point is the limit of its own)");
}

void add_checks(CLI::App& command, Report_options& report, Verify_options& verification,
                const std::string& shapes)
{
  command.add_flag("--strict", report.strict,
                   "Any warning makes the exit code 4; OUTPUT is still written. Meshes are read "
                   "as with --no-mend");
  command.add_option(
    "--report", report.file,
    "Write what was read, done, repaired, dropped and warned of into this JSON file");
  CLI::Option* const verify =
    command.add_option("--verify", verification.shape,
                       "Print the largest deviation D of the result from " + shapes +
                         ", and the bound (5 R + 3 |C|) 2^-52 that it keeps if the control data is "
                         "on the shape up to rounding");
  command
    .add_option("--tolerance", verification.tolerance,
                "With --verify: exit with 3, OUTPUT written, if D is more than this times R")
    ->check([](const std::string& word) { return word.empty() ? "a number is expected" : ""; })
    ->needs(verify);
}

// --- surface ---

void add_rounds(CLI::App& surface, Surface_options& options)
{
  const auto check = [](std::string& word) {
    if (word == "auto")
      return std::string("auto is no longer known: take --chord EPS, which makes triangles within "
                         "a tolerance, or --levels N for N rounds");
    return whole_number()(word);
  };
  surface
    .add_option_function<std::string>(
      "--levels",
      [&options](const std::string& word) {
        options.has_levels = true;
        if (!CLI::detail::lexical_cast(word, options.levels))
          throw CLI::ConversionError(word, "--levels");
      },
      "Rounds of subdivision; 0 copies the control data")
    ->transform(CLI::Validator(check, ""))
    ->default_str("1");
  surface.add_option("--chord", options.chord,
                     "How far the limit surface may be from the triangles of the result, which are "
                     "large where it is flat: a length, or P% of the box's diagonal");
  surface
    .add_option("--scheme", options.scheme.scheme,
                scheme_names() + "; default: loop if all faces are triangles, otherwise "
                                 "catmull-clark")
    ->check([](const std::string& word) { return word.empty() ? "a scheme is expected" : ""; });
}

void add_common_options(CLI::App& surface, Surface_options& options)
{
  begin_group(surface, "Common options");
  add_rounds(surface, options);
  surface.add_flag(
    "--part", options.part,
    "A CAD part written as facets, such as an STL file of openscad: the same as "
    "--sharp surfaces --planes rims --chord 0.02%; a --chord of your own or --levels "
    "N take the place of that one");
  surface.add_option(
    "--sharp", options.creases.sharp,
    "Edges that are creases: auto (default; those of file, but of normals for flat "
    "shading only if there are at most 6 different ones or one for 20 faces; those of surfaces if "
    "the file has neither tags nor normals and is a part beyond doubt), "
    "none, surfaces (those between the planes, cylinders, cones, spheres and tori of a CAD part, "
    "which are recognized; ./surfaces is a file), file (those that the file tags as sharp, or "
    "where its normals of two faces differ by "
    "more than 0.1 degrees), angle:DEG (where the faces meet at an angle greater by 0.1 degrees "
    "and more) or a selection file of CGAL (.selection.txt)");
  surface.add_option(
    "--normals", options.normals,
    "Control normals: auto (the file's if it has any that are not zero or those of the "
    "faces or shading, else estimated), file, smooth (the file's, smoothed using the points), "
    "estimate or coherent, reciprocal, angle (estimated by the faces' angles), none, sphere:X,Y,Z "
    "or cylinder:X,Y,Z,DX,DY,DZ");
  surface.add_option(
    "--roundness", options.roundness,
    "How far points leave those of the linear scheme: auto (default; the file's "
    "property roundness besides its control normals, 1 with other given normals, "
    "else as estimate), file, estimate (computed from the points), or a number for all "
    "vertices from 0 (linear points) to 1");
  add_linear_and_limit(surface, options.linear, options.limit, "vertices");
  surface.add_option("--threads", options.threads, "Number of threads; 0 for all cores")
    ->transform(whole_number())
    ->capture_default_str();
  add_quiet_and_help(surface, options.report.quiet);
}

void add_crease_options(CLI::App& surface, Surface_options& options)
{
  begin_group(surface, "Sharp edges, borders and ends");
  surface.add_option("--sharpness", options.creases.sharpness,
                     "Of these edges: the number of rounds for which they are sharp; default: that "
                     "of the file's tags, else inf");
  surface.add_option(
    "--border", options.creases.border,
    "Border: surface (default; part of the surface), curve (a crease, circles stay "
    "circles), corners (the same, and vertices with one face are corners) or fixed "
    "(stays where it is)");
  surface.add_option("--write-tags", options.write_tags,
                     "Write what is sharp in the result as a selection file of CGAL, "
                     "FILE.selection.txt; with --output-normals control or both .ply and .obj hold "
                     "it themselves");
  begin_group(surface, "Surfaces of CAD parts");
  surface.add_option("--min-facets", options.creases.min_facets,
                     "With --sharp surfaces: the least number of sides of prisms that are round "
                     "even if nothing else indicates it; default 8");
  surface.add_option("--surface-tolerance", options.creases.surface_tolerance,
                     "With --sharp surfaces: how far vertices may be from their surface; default: "
                     "4 units of the file's rounding and 1e-7 of the box's diagonal");
  surface.add_option("--sharp-angle", options.creases.sharp_angle,
                     "With --sharp surfaces: where no surface is recognized, edges are creases "
                     "whose faces meet at an angle greater than this; default 30 degrees");
  surface.add_option("--planes", options.planes,
                     "rims: with --sharp surfaces planes are of as few triangles as their refined "
                     "rims allow, unless control data are asked for; with this they must be");
  surface.add_option("--surface-labels", options.creases.surface_labels,
                     "With --sharp surfaces: write the number of its surface for each control "
                     "face into this file, one per line");
}

void add_input_options(CLI::App& surface, Surface_options& options)
{
  begin_group(surface, "What is read");
  surface.add_flag("--triangulate", options.triangulate,
                   "Split faces with more than three vertices before anything else");
  surface.add_flag(
    "--repair", options.repair,
    "Orient the faces, what is closed outwards and cavities the other way; split or remove faces "
    "that visit a vertex twice, remove duplicate faces, duplicate non-manifold edges and vertices; "
    "say what was changed");
  surface.add_flag("--merge-points", options.merge_points,
                   "Merge vertices with equal points; different normals become those of corners");
  surface.add_option("--merge-distance", options.merge_distance,
                     "Merge vertices at borders within this distance, but never two of one face: "
                     "a length, or P% of the box's diagonal. Default: 0, of STL files 4 units in "
                     "the last place of the largest coordinate as a float. Includes "
                     "--merge-points");
  surface.add_flag(
    "--no-mend", options.no_mend,
    "Read the file as it stands. Else points are merged where most border edges lie on others, and "
    "vertices doubled where fans of faces meet; a note says so, and with --strict it is not done");
  surface.add_flag("--drop-attributes", options.drop_attributes,
                   "Points, faces and normals only: texture coordinates, colors, materials, groups "
                   "and other properties are not read");
}

void add_output_options(CLI::App& surface, Surface_options& options)
{
  begin_group(surface, "What is written");
  surface.add_option(
    "--output-normals", options.output_normals,
    "Normals in OUTPUT: auto (default; those of the mesh that is written, those "
    "of the surface with --limit, none in .off), surface (those of the limit surface), control "
    "(the control normals for a further round), both (auto's and the control "
    "normals; .ply, .vtp, .pvtp) or none");
  surface.add_flag("--surface-normals", options.limit.normals,
                   "The same as --output-normals surface");
  surface.add_option("--curvature", options.curvature,
                     "Add gaussian or mean curvature to the vertices, and colors for it, "
                     "symmetric about 0 (.ply, .vtp)");
  surface.add_option("--texture-rule", options.texture_rule,
                     "What stays of texture coordinates where charts end, as in OpenSubdiv: none, "
                     "corners-only (corners of one face), corners-plus1 (default; and where three "
                     "charts meet), corners-plus2 (and concave corners and ends of seams), "
                     "boundaries (all of seams and borders) or all (linear inside faces)");
  surface.add_option("--nearest", options.nearest,
                     "Numbers of vertices that are labels, as whole numbers but colors are: names, "
                     "separated by commas. A vertex gets that of the nearest control vertex");
  surface.add_option("--directions", options.directions,
                     "Numbers of vertices that are unit vectors, and are made unit again: three "
                     "names for each, or one before x, y, z; separated by commas");
  surface.add_flag("--split-seams", options.split_seams,
                   "Write texture coordinates to the vertices of a .ply file, which are doubled at "
                   "seams, as VTK and game engines read them (.vtp files always have them so)");
  surface.add_flag("--ascii", options.ascii, "PLY, STL and VTP as text");
  surface.add_option("--format", options.format,
                     "Format of standard input and output: " + writable_formats() +
                       " (vtp is written only)");
}

// What a parameter of schemes is, where its name does not tell.
std::string meaning(const std::string& parameter)
{
  if (parameter == "tension") return "The tension of ";
  if (parameter == "cap") return "C in the bound C lambda^2 of the eigenvalues, 0 < C <= 1, of ";
  return "The parameter of ";
}

void add_scheme_options(CLI::App& surface, Scheme_choice& choice)
{
  begin_group(surface, "Schemes");
  surface.add_option("--normal-scheme", choice.normal_scheme,
                     "Another scheme for the normals, with the same split of the faces");
  for (const Scheme_parameter& p : scheme_parameters()) {
    std::string schemes;
    for (const std::string& scheme : p.schemes) schemes += (schemes.empty() ? "" : ", ") + scheme;
    surface.add_option_function<std::string>(
      "--" + p.name,
      [&choice, name = p.name](const std::string& text) {
        choice.parameters[name] = parse_fraction("--" + name, text);
      },
      meaning(p.name) + schemes +
        formatted("; a number or a fraction, default %g", p.default_value));
  }
  surface
    .add_option("--first-round", choice.first_round,
                "The first round with the weights of " + modified_scheme_names() +
                  ", those of the unmodified schemes before; default 1")
    ->transform(whole_number());
  surface.add_option("--tuned-valences", choice.tuned_valences,
                     "Where " + modified_scheme_names() +
                       " have weights of their own: all (default) or diverging (not at valence 3 "
                       "of quads and 4 and 5 of triangles)");
}

void add_pieces_options(CLI::App& surface, Pieces_options& options)
{
  begin_group(surface, "Piece by piece");
  surface.add_option("--memory", options.memory,
                     "Refine and write piece by piece, so that a process takes no more than this, "
                     "500M or 2G (.ply, .pvtp; no --chord); under mpirun ranks share the pieces");
  surface
    .add_option("--pieces", options.pieces, "The same with so many pieces, instead of --memory")
    ->transform(whole_number());
  surface.add_flag("--resume", options.resume,
                   "Of refinement in pieces: if it is interrupted, keep what is written in "
                   "OUTPUT.part, and continue that with the next --resume");
}

void add_surface_command(CLI::App& app, Surface_options& options)
{
  CLI::App& surface = *app.add_subcommand("surface", "Subdivide a mesh");
  surface.footer(surface_footer());
  surface.add_option("INPUT", options.input, "Control mesh; - for standard input")->required();
  surface.add_option("OUTPUT", options.output, "Refined mesh; - for standard output")->required();
  add_common_options(surface, options);
  add_crease_options(surface, options);
  add_input_options(surface, options);
  add_output_options(surface, options);
  begin_group(surface, "Limits and interpolation");
  surface.add_option(
    "--chord-bound", options.chord_bound,
    "How that is known: estimated (default) or proven, without creases and borders");
  add_limit_options(surface, options.limit, options.interpolate, "The limit surface");
  add_scheme_options(surface, options.scheme);
  add_pieces_options(surface, options.pieces);
  begin_group(surface, "Checks and reports");
  surface.add_flag(
    "--check", options.check,
    "Compare with the control mesh and its recognized surfaces, beside the result of "
    "the linear scheme: print volumes, folds and the largest distance, whether the "
    "shape is kept, SWOLLEN, LOST or FOLDED, and what helps");
  add_checks(surface, options.report, options.verify,
             "sphere:X,Y,Z,R or cylinder:X,Y,Z,DX,DY,DZ,R");
}

// --- curve ---

void add_curve_command(CLI::App& app, Curve_options& options)
{
  CLI::App& curve = *app.add_subcommand("curve", "Subdivide a polygon in the plane or in space");
  curve.footer(curve_footer());
  curve.add_option("INPUT", options.input, "Control polygon; - for standard input")->required();
  curve.add_option("OUTPUT", options.output, "Refined curve; - for standard output")->required();
  begin_group(curve, "Common options");
  curve.add_option("--levels", options.levels, "Rounds of subdivision; 0 copies the control data")
    ->transform(whole_number())
    ->capture_default_str();
  curve.add_option("--scheme", options.scheme, curve_scheme_names())->capture_default_str();
  curve.add_flag("--closed", options.closed,
                 "The polygon is closed; its first vertex is not repeated");
  curve.add_option(
    "--sharp", options.sharp,
    "arcs (lines and circular arcs of a plane drawing are recognized and kept; ./arcs "
    "is a file), or a file with the numbers of the vertices, from 0 on, that are "
    "corners (primal schemes)");
  curve.add_option("--normals", options.normals,
                   "Control normals of a curve in space: spherical:X,Y,Z, away from this point "
                   "(default: the file's, else estimated)");
  curve.add_option("--roundness", options.roundness,
                   "How far points leave those of the linear scheme, from 0 (linear points) to 1 "
                   "(default)");
  add_linear_and_limit(curve, options.linear, options.limit,
                       "points (of dual schemes the middles of the edges)");
  add_quiet_and_help(curve, options.report.quiet);
  begin_group(curve, "Sharp edges, borders and ends");
  curve.add_option("--end", options.end,
                   "Ends of an open polygon: reflect (default for primal schemes: up to the end "
                   "points) or none (default for dual ones: as far as whole stencils reach)");
  begin_group(curve, "What is written");
  curve.add_flag("--curve-normals", options.limit.normals,
                 "Write the normals of the limit curve instead of the control normals");
  curve.add_option("--comb", options.comb,
                   "Draw curve, control polygon, control normals and curvature comb into this "
                   "SVG file");
  begin_group(curve, "Limits and interpolation");
  add_limit_options(curve, options.limit, options.interpolate, "The limit curve (bspline:3)");
  begin_group(curve, "Schemes");
  curve.add_option("--normal-scheme", options.normal_scheme,
                   "Another scheme for the normals; both primal (odd degrees, N-point) or both "
                   "dual (even degrees)");
  begin_group(curve, "Checks and reports");
  add_checks(curve, options.report, options.verify,
             "circle:X,Y,R or, in space, circle:X,Y,Z,NX,NY,NZ,R, sphere:X,Y,Z,R or "
             "cylinder:X,Y,Z,DX,DY,DZ,R");
}

// `pn_subdivide INPUT OUTPUT ...` means a surface. A file of the name of a command is ./surface.
std::vector<std::string> with_command(int argc, char** argv)
{
  std::vector<std::string> words(argv + 1, argv + argc);
  const auto is_known = [](const std::string& word) {
    return word == "surface" || word == "curve" || word == "--help" || word == "-h" ||
           word == "--version";
  };
  if (!words.empty() && !is_known(words.front())) words.insert(words.begin(), "surface");
  return words;
}

std::vector<std::string> option_names(const CLI::App& command)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// Files whose names begin with a hyphen are taken for options, and "-h.obj" even for --help.
void require_no_file_like_options(const std::vector<std::string>& words)
{
  const std::string formats = " " + writable_formats() + " ";
  for (const std::string& word : words) {
    const std::size_t dot = word.rfind('.');
    if (word.size() < 2 || word[0] != '-' || dot == std::string::npos ||
        word.find('=') != std::string::npos)
      continue;
    if (formats.find(" " + word.substr(dot + 1) + " ") != std::string::npos ||
        std::filesystem::exists(word))
      throw Usage_error("'" + word + "' looks like an option: the file is ./" + word);
  }
}

// What CLI11 says of words that it does not know, and what was probably meant.
std::string unexpected(const CLI::App& app)
{
  const std::vector<std::string> words = app.remaining(true);
  const auto option = std::find_if(words.begin(), words.end(), [](const std::string& word) {
    return word.rfind("--", 0) == 0 && word.size() > 2;
  });
  if (option == words.end())
    return "'" + (words.empty() ? "" : words.front()) + "' is one argument too many";
  const std::string name = option->substr(0, option->find('='));
  const std::vector<CLI::App*> commands = app.get_subcommands();
  return "there is no option " + name +
         (commands.empty() ? "" : did_you_mean(name, option_names(*commands.front())));
}

} // namespace

Command parse_command_line(int argc, char** argv)
{
  CLI::App app(
    "Point-normal subdivision of meshes and curves: spheres, cylinders and circles stay what "
    "they are.\n\n  pn_subdivide INPUT OUTPUT [OPTIONS]   is   pn_subdivide surface INPUT "
    "OUTPUT [OPTIONS]\n",
    "pn_subdivide");
  app.formatter(command_help());
  app.set_version_flag("--version", "pn_subdivide " CGAL_PN_SUBDIVISION_3_VERSION);
  app.require_subcommand(1);
  app.footer(top_level_footer());

  Surface_options surface;
  add_surface_command(app, surface);
  Curve_options curve;
  add_curve_command(app, curve);
  std::vector<std::string> words = with_command(argc, argv);
  require_no_file_like_options(words);
  std::reverse(words.begin(), words.end()); // as CLI11 takes them
  const std::string help = " (see pn_subdivide --help)";
  try {
    if (words.empty()) throw Usage_error("INPUT and OUTPUT are missing" + help);
    app.parse(std::move(words));
  } catch (const CLI::ExtrasError&) {
    throw Usage_error(unexpected(app) + help);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() != static_cast<int>(CLI::ExitCodes::Success))
      throw Usage_error(e.what() + help);
    app.exit(e);
    return {};
  }
  const bool is_curve = app.got_subcommand("curve");
  require_no_exclusions(*app.get_subcommand(is_curve ? "curve" : "surface"));
  if (is_curve) return curve;
  return surface;
}

} // namespace pn_subdivide
