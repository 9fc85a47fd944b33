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

using Sqrt3_schemes = testing::Types<Sqrt3_description>;

namespace named_shapes {
INSTANTIATE_TYPED_TEST_SUITE_P(Sqrt3, Named_shapes, Sqrt3_schemes, Scheme_names);
}
namespace random_meshes {
INSTANTIATE_TYPED_TEST_SUITE_P(Sqrt3, Random_meshes, Sqrt3_schemes, Scheme_names);
}
