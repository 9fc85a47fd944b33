// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_DECIDED_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_DECIDED_H

#include <CGAL/Uncertain.h>

#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// calls f(); where the precision of the number type does not suffice, what() says for what
template <class FT, class Function, class What>
void decided(const Function& f, [[maybe_unused]] const What& what)
{
  if constexpr (std::is_floating_point_v<FT>)
    f();
  else
    try {
      f();
    } catch (const Uncertain_conversion_exception&) {
      throw std::domain_error(
        "PN_subdivision_3: the precision of the number type does not decide " +
        std::string(what()) + ": use a higher precision");
    }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CREASES_DECIDED_H
