// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEME_ADAPTORS_H
#define CGAL_PN_SUBDIVISION_3_SCHEME_ADAPTORS_H

#include <CGAL/PN_subdivision_3/Level_connectivity.h>

#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Schemes
The linear twin of a scheme, made by `linear()`: the same points as without normals.
*/
template <class Scheme>
struct Linear_scheme
{
  using Host = typename Scheme::Host;

  template <class FT>
  auto mask(const Level_connectivity& level, unsigned round) const
  {
    return scheme.template mask<FT>(level, round);
  }

  Scheme scheme;
};

/// \ingroup PkgPNSubdivision3Schemes
/// returns the linear twin of `scheme`: normals are neither read nor written.
template <class Scheme>
Linear_scheme<Scheme> linear(const Scheme& scheme)
{
  return {scheme};
}

namespace internal {

template <class Scheme>
struct Is_linear : std::false_type
{
};
template <class Scheme>
struct Is_linear<Linear_scheme<Scheme>> : std::true_type
{
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SCHEME_ADAPTORS_H
