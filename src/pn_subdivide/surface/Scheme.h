// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SCHEME_H
#define PN_SUBDIVIDE_SCHEME_H

#include "surface/surface_schemes.h"

#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>

#include <string>

namespace pn_subdivide {

namespace PN = CGAL::PN_subdivision_3;

using Scheme = PN::Any_scheme<double>;

Scheme make_scheme(const std::string& option, const std::string& name, const Scheme_choice& choice);

inline Scheme scheme_of(const Scheme_choice& choice)
{
  return make_scheme("--scheme", choice.scheme, choice);
}

// The same, with the scheme of the normals if that is another one.
Scheme scheme_with_normals(const Scheme_choice& choice);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SCHEME_H
