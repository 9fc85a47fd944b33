// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_SCHEME_BY_NAME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_SCHEME_BY_NAME_H

#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/shipped_schemes.h>

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL::PN_subdivision_3 {

/// \ingroup PkgPNSubdivision3Schemes
/// numbers that a scheme takes, by their names.
using Scheme_parameters = std::map<std::string, Scheme_parameter>;

namespace internal {

template <class Scheme>
constexpr bool takes_first_round_v =
  std::is_constructible_v<Scheme, Scheme_parameter, unsigned, Tuned_valences>;

constexpr const char* first_round_name = "first-round";

// refuses what the scheme of a name does not take: the parameter `known`, if it has one, and perhaps the first round
inline void check_parameters(const Scheme_parameters& parameters, const std::string& scheme,
                             const std::string& known, bool takes_first_round)
{
  for (const auto& [name, value] : parameters) {
    if (takes_first_round && name == first_round_name) {
      const double round = value.to_double();
      if (!(round >= 1 && round <= 1e6 && round == unsigned(round)))
        throw std::invalid_argument(
          "PN_subdivision_3: first-round must be a whole number, at least 1");
    } else if (known.empty() || name != known)
      throw std::invalid_argument(
        "PN_subdivision_3: the scheme " + scheme + " has no parameter '" + name + "': it takes " +
        (known.empty() ? "none" : known) +
        (takes_first_round ? std::string(" and ") + first_round_name : ""));
  }
}

template <class Scheme>
Scheme with_parameters(const Scheme_parameters& parameters)
{
  if constexpr (has_parameter_v<Scheme>) {
    check_parameters(parameters, Scheme::name(), Scheme::parameter_name(),
                     takes_first_round_v<Scheme>);
    const auto given = parameters.find(Scheme::parameter_name());
    const Scheme_parameter value =
      given == parameters.end() ? Scheme_parameter(Scheme::default_parameter()) : given->second;
    if constexpr (takes_first_round_v<Scheme>) {
      const auto round = parameters.find(first_round_name);
      return Scheme(value, round == parameters.end() ? 1u : unsigned(round->second.to_double()),
                    Tuned_valences::all);
    } else
      return Scheme(value);
  } else {
    check_parameters(parameters, Scheme::name(), "", false);
    return Scheme();
  }
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Schemes
returns one of the `Shipped_schemes` by its name.

\code{.cpp}
const auto scheme = any_scheme<double>("kobbelt", {{"tension", 1. / 16}});
\endcode

\tparam FT the number type of the points
\param name the name, as in the command `pn_subdivide`
\param parameters the scheme's parameter by its `parameter_name()`, and `first-round` of a modified scheme; what is
  not given has its default

\throws std::invalid_argument if there is no such scheme, or it has no such parameter: the message lists those that
  there are; or if a parameter is out of its range
*/
template <class FT = double>
Any_scheme<FT> any_scheme(const std::string& name,
                          const Scheme_parameters& parameters = Scheme_parameters())
{
  std::optional<Any_scheme<FT>> found;
  std::string names;
  for_each_shipped_scheme([&](const auto& scheme) {
    using Scheme = std::decay_t<decltype(scheme)>;
    names += (names.empty() ? "" : ", ") + std::string(Scheme::name());
    if (name == Scheme::name()) found.emplace(internal::with_parameters<Scheme>(parameters));
  });
  if (!found)
    throw std::invalid_argument("PN_subdivision_3: there is no scheme '" + name +
                                "'; there are: " + names);
  return *found;
}

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_SCHEME_BY_NAME_H
