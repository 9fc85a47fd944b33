// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Files of any content through the command's way: reader, checks and repairs, refinement, writer. What must hold:
// the output is a mesh that is read again, or there is none and what was thrown has a message; nothing else is
// left in the folder. Sanitizers watch the rest.
//
// The first bytes of the input are options (see options_of()), the others are the file.

#include "io/Error.h"
#include "io/mesh_io.h"
#include "options.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

using namespace pn_subdivide;

namespace {

namespace fs = std::filesystem;

constexpr std::size_t option_bytes = 4;

const fs::path& folder()
{
  static const fs::path path = [] {
    std::string name = (fs::temp_directory_path() / "pn_fuzz_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) std::abort();
    std::atexit([] {
      std::error_code ignored;
      fs::remove_all(folder(), ignored);
    });
    return fs::path(name);
  }();
  return path;
}

Surface_options options_of(const std::uint8_t* bytes)
{
  const char* const inputs[] = {"ply", "off", "obj", "stl"};
  const char* const outputs[] = {"ply", "off", "obj", "stl", "vtp"};
  const char* const schemes[] = {"",          "catmull-clark", "loop",  "doo-sabin",
                                 "butterfly", "kobbelt",       "sqrt3", "modified-loop"};
  Surface_options options;
  options.input = (folder() / "in.").string() + inputs[bytes[0] % 4];
  options.output = (folder() / "out.").string() + outputs[bytes[0] / 4 % 5];
  options.scheme.scheme = schemes[bytes[1] % 8];
  options.levels = bytes[1] / 8 % 3;
  options.linear = bytes[1] & 32;
  options.merge_points = bytes[1] & 64;
  options.repair = bytes[1] & 128;
  options.triangulate = bytes[2] & 1;
  options.ascii = bytes[2] & 2;
  if (bytes[2] & 4) options.normals = bytes[2] & 8 ? "angle" : "estimate";
  if (bytes[2] & 16) options.creases.sharp = "angle:" + std::to_string(bytes[3] % 180);
  if (bytes[2] & 32) options.curvature = "gaussian";
  options.report.quiet = true;
  return options;
}

void fail(const std::string& what)
{
  std::fprintf(stderr, "fuzz_command: %s\n", what.c_str());
  std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size < option_bytes) return 0;
  const Surface_options options = options_of(data);
  std::ofstream(options.input, std::ios::binary)
    .write(reinterpret_cast<const char*>(data + option_bytes),
           std::streamsize(size - option_bytes));
  bool is_written = true;
  try {
    run_surface_command(options);
  } catch (const std::exception& e) {
    is_written = false;
    if (std::string(e.what()).empty()) fail("an exception without a message");
  }
  if (is_written != fs::exists(options.output))
    fail(is_written ? "there is no output" : "there is output after an exception");
  if (is_written && fs::path(options.output).extension() != ".vtp") {
    read_mesh(options.output); // throws, and ends the program, if it is damaged
  }
  fs::remove(options.input);
  fs::remove(options.output);
  if (!fs::is_empty(folder())) fail("a file is left");
  return 0;
}
