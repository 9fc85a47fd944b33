// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_ANY_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_ANY_SCHEME_H

#include <CGAL/PN_subdivision_3/internal/rows/Level_origins.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Scheme_on_host.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>

#include <string>
#include <type_traits>
#include <variant>

namespace CGAL::PN_subdivision_3 {
/*!
\ingroup PkgPNSubdivision3Schemes

A scheme that is chosen at run time: any model of `PNSubdivisionScheme_3` on a host of this package. It is taken by
all functions and classes that take a scheme, which give the same bits as with the scheme itself; so are its
adaptors, `linear(any)` and `with_normal_scheme(any, other)`. Functions are compiled once for all schemes.

A row of weights costs one virtual call more, which is not measurable next to the average.

\code{.cpp}
std::vector<Any_scheme<>> schemes{Any_scheme<>(Loop_scheme()), Any_scheme<>(Butterfly_scheme())};
for (const auto& scheme : schemes) subdivide(copy_of(mesh), scheme, np);
\endcode

\tparam FT the number type of the points

\sa `any_scheme()`, which makes one by its name
*/
template <class FT = double>
class Any_scheme
{
  template <class Host>
  using On = internal::Scheme_on_host<Host, FT>;
  using On_a_host = std::variant<On<PQQ_host>, On<PTQ_host>, On<DQQ_host>, On<Sqrt3_host>>;

public:
  /// \cond
  using Host = internal::Host_at_run_time;
  /// \endcond
  /// the number type of the points.
  using Number_type = FT;

  /*!
  makes it of a scheme, which is copied.
  \tparam Scheme a model of `PNSubdivisionScheme_3` whose host is one of this package, and no adaptor: adapt the
    `Any_scheme`
  */
  template <class Scheme, class = std::enable_if_t<!std::is_same_v<typename Scheme::Host, Host>>>
  explicit Any_scheme(const Scheme& scheme)
    : on_a_host_(On<typename Scheme::Host>(scheme))
  {
    static_assert(internal::check_no_grid_rows<Scheme>());
    static_assert(
      !internal::Is_adaptor<Scheme>::value,
      "PN_subdivision_3: make an Any_scheme of the scheme that is adapted, and adapt it");
  }

  /// the name of the scheme, empty if it has none.
  const std::string& name() const
  {
    return visit([](const auto& s) -> const auto& { return s.name(); });
  }
  /// whether its rules for borders serve along creases.
  bool has_crease_rules() const { return facts().has_crease_rules; }
  /// whether a round transfers curvature to the normals. Such a scheme goes with no normal scheme.
  bool transfers_curvature() const { return facts().transfers_curvature; }
  /// whether vertices stay, so that `limit_points()` are those of the vertices.
  bool keeps_vertices() const
  {
    return visit([](const auto& s) { return std::decay_t<decltype(s)>::Host::keeps_vertices; });
  }
  /// whether its surfaces pass through the control points anyway.
  bool interpolates() const { return facts().limit_neighborhood.keeps_points; }
  /// whether every old edge is split, so that seams and sharp edges are still there, in parts, after a round.
  bool splits_edges() const
  {
    return visit([](const auto& s) {
      return internal::Splits_edges<typename std::decay_t<decltype(s)>::Host>::value;
    });
  }
  /// whether it takes triangles only.
  bool needs_triangles() const
  {
    return visit([](const auto& s) {
      using S_host = typename std::decay_t<decltype(s)>::Host;
      return std::is_same_v<S_host, PTQ_host> || std::is_same_v<S_host, Sqrt3_host>;
    });
  }
  /// whether another scheme splits the faces in the same way.
  bool has_host_of(const Any_scheme& other) const
  {
    return on_a_host_.index() == other.on_a_host_.index();
  }

  /// \cond
  template <class Function>
  decltype(auto) visit(const Function& f) const
  {
    return std::visit(f, on_a_host_);
  }
  /// \endcond

private:
  const internal::Scheme_facts& facts() const
  {
    return visit([](const auto& s) -> const auto& { return s.facts(); });
  }

  On_a_host on_a_host_;
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_ANY_SCHEME_H
