// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_MASK_ON_VIEW_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_MASK_ON_VIEW_H

#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The user's mask template on the view: Mask<View>, or Mask<View, point map> if that is needed.
template <class View, template <class...> class Mask, class = void>
struct Mask_on_view
{
  using type = Mask<View, typename View::Point_map>;
};

template <class View, template <class...> class Mask>
struct Mask_on_view<View, Mask, std::void_t<Mask<View>>>
{
  using type = Mask<View>;
};

// CGAL's masks take a pointer to the mesh, the manual's a reference; not all take a point map.
template <class Mask, class View, class PointMap, class... Args>
Mask make_mask_on_view(View& view, const PointMap& points, const Args&... args)
{
  if constexpr (std::is_constructible_v<Mask, View*, PointMap, const Args&...>)
    return Mask(&view, points, args...);
  else if constexpr (std::is_constructible_v<Mask, View&, PointMap, const Args&...>)
    return Mask(view, points, args...);
  else if constexpr (std::is_constructible_v<Mask, View*, const Args&...>)
    return Mask(&view, args...);
  else {
    static_assert(std::is_constructible_v<Mask, View&, const Args&...>,
                  "The mask must be constructible from a pointer or a reference to the mesh, then "
                  "the vertex point map (if it takes one), then the arguments given here.");
    return Mask(view, args...);
  }
}

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_CGAL_MASKS_MASK_ON_VIEW_H
