// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_BENCHMARK_PEERS_FOR_EACH_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_BENCHMARK_PEERS_FOR_EACH_SCHEME_H

#include <CGAL/PN_subdivision_3/schemes/Butterfly_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Kobbelt_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/Sqrt3_scheme.h>

// calls f(name, scheme) for the schemes that are compared
template <class Function>
void for_each_scheme(const Function& f)
{
  namespace PN = CGAL::PN_subdivision_3;
  f("catmull-clark", PN::CatmullClark_scheme());
  f("loop", PN::Loop_scheme());
  f("doo-sabin", PN::DooSabin_scheme());
  f("sqrt3", PN::Sqrt3_scheme());
  f("butterfly", PN::Butterfly_scheme());
  f("kobbelt", PN::Kobbelt_scheme());
}

#endif // CGAL_PN_SUBDIVISION_3_BENCHMARK_PEERS_FOR_EACH_SCHEME_H
