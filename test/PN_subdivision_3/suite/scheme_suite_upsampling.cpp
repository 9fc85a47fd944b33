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

using Upsampling_schemes = testing::Types<Midpoint_description, Bilinear_description>;

namespace named_shapes {
INSTANTIATE_TYPED_TEST_SUITE_P(Upsampling, Named_shapes, Upsampling_schemes, Scheme_names);
}
namespace random_meshes {
INSTANTIATE_TYPED_TEST_SUITE_P(Upsampling, Random_meshes, Upsampling_schemes, Scheme_names);
}
