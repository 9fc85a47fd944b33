// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Surfaces around one extraordinary vertex by Catmull-Clark and modified Catmull-Clark subdivision,
// linear and point-normal: the Gaussian curvatures on rings ever closer to the vertex, and the limit.
//
//   local_curvature FOLDER_OF_CONTROL_MESHES

#include "Local_examples.h"

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Tuned_CatmullClark_scheme.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace PN = CGAL::PN_subdivision_3;

namespace {

template <class Scheme>
void print_row(const char* name, const local_examples::Mesh& mesh, const Scheme& scheme,
               bool has_limit)
{
  const auto c = local_examples::curvature(mesh, scheme);
  std::printf("  %-16s", name);
  for (int m : {0, 3, 6, 12})
    std::printf(" %9.4f to %9.4f", c.rings[m].gaussian_min, c.rings[m].gaussian_max);
  if (has_limit) std::printf("  %9.5f", c.limit.gaussian);
  std::printf("\n");
}

void print_table(const std::string& file, const local_examples::Local_example& example)
{
  const local_examples::Mesh mesh = local_examples::read(file);
  std::printf("%s", example.file.c_str());
  if (example.gaussian_curvature)
    std::printf(", K of the sampled surface %.5f", *example.gaussian_curvature);
  std::printf("\n  %-16s", "K on ring");
  for (int m : {0, 3, 6, 12}) std::printf(" %22d", m);
  std::printf("  predicted\n");
  const PN::CatmullClark_scheme plain;
  const PN::CatmullClark_scheme::Tuned modified;
  print_row("linear", mesh, PN::linear(plain), false);
  print_row("modified linear", mesh, PN::linear(modified), true);
  print_row("PN", mesh, plain, false);
  print_row("PN-modified", mesh, modified, true);
}

} // namespace

int main(int argc, char** argv)
{
  try {
    for (const auto& example : local_examples::all())
      print_table(argc > 1 ? argv[1] + ("/" + example.file)
                           : CGAL::data_file_path("meshes/" + example.file),
                  example);
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
