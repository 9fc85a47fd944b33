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

PN_INSTANTIATE_SUITES(Sqrt3, Sqrt3_description)
