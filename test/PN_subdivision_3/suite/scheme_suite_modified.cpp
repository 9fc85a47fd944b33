// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Schemes.h"
#include "named_shapes.h"
#include "random_meshes.h"

using Modified_schemes =
  testing::Types<Modified_CatmullClark_description, Modified_Loop_description>;

namespace named_shapes {
INSTANTIATE_TYPED_TEST_SUITE_P(Modified, Named_shapes, Modified_schemes, Scheme_names);
}
namespace random_meshes {
INSTANTIATE_TYPED_TEST_SUITE_P(Modified, Random_meshes, Modified_schemes, Scheme_names);
}
