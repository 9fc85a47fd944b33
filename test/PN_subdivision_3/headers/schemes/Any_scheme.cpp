// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>

using namespace CGAL::PN_subdivision_3;

namespace header_in_use {

struct Scheme
{
  using Host = PTQ_host;
  struct Mask
  {
    template <class Stencil>
    void vertex(Level_connectivity::Index v, Stencil& s) const
    {
      s.add_rest(v);
    }
    template <class Stencil>
    void edge(Level_connectivity::Index e, Stencil& s) const
    {
      s.add_rest(e);
    }
  };
  template <class FT>
  Mask mask(const Level_connectivity&, unsigned) const
  {
    return {};
  }
};

bool use_any_scheme()
{
  const Any_scheme<float> scheme{Scheme()};
  return scheme.name().empty() && scheme.needs_triangles();
}

bool use_scheme_by_name()
{
  return any_scheme("kobbelt", {{"tension", {1, 16}}}).interpolates();
}

} // namespace header_in_use
