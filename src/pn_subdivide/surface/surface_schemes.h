// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SURFACE_SCHEMES_H
#define PN_SUBDIVIDE_SURFACE_SCHEMES_H

#include <map>
#include <optional>
#include <string>
#include <vector>

// The schemes are those of the library's list CGAL::PN_subdivision_3::Shipped_schemes; everything that
// the command knows about them by name comes from there. Besides there is CatmullClark_scheme::Grid, which refines and
// does nothing else.

namespace CGAL::PN_subdivision_3 {
template <class FT>
class Any_scheme; // options need not wait for its header
} // namespace CGAL::PN_subdivision_3

namespace pn_subdivide {

struct Scheme_choice
{
  std::string scheme;                       // empty: the mesh's faces decide
  std::optional<std::string> normal_scheme; // the scheme's own mask if there is none
  std::map<std::string, double> parameters; // as given: {"cap", 0.5}
  // which rounds and valences the modified schemes change, as given
  std::optional<unsigned> first_round;
  std::optional<std::string> tuned_valences;
};

// A parameter that schemes take, which is an option of the same name.
struct Scheme_parameter
{
  std::string name;
  std::vector<std::string> schemes; // that take it
  double default_value;
};

// Names with commas between, "or" before the last.
std::string scheme_names();
std::vector<Scheme_parameter> scheme_parameters();
// As scheme_names(), of those that have a first round.
std::string modified_scheme_names();

using Scheme = CGAL::PN_subdivision_3::Any_scheme<double>;

// Throws Usage_error, which begins with the option, if there is no such scheme.
Scheme make_scheme(const std::string& option, const std::string& name, const Scheme_choice& choice);
Scheme scheme_of(const Scheme_choice& choice);
// The same, with the scheme of the normals if that is another one.
Scheme scheme_with_normals(const Scheme_choice& choice);

// Throws Usage_error if there is no such scheme, or if these do not go together.
void require_surface_schemes(const Scheme_choice& choice);

// Is it CatmullClark_scheme::Grid?
bool is_grid_scheme(const std::string& scheme);

// Does the scheme refine triangles only?
bool needs_triangles(const std::string& scheme);

// Are the edges of a mesh still there, in parts, after a round? Otherwise seams cannot be kept.
bool keeps_edges(const std::string& scheme);

// Of the two schemes the one that has no rules for creases; empty if both have, or have no name.
std::string scheme_without_creases(const Scheme_choice& choice);
// As scheme_names(), but "and" before the last.
std::string creasing_scheme_names();

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SURFACE_SCHEMES_H
