// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_FUNCTION_REF_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_FUNCTION_REF_H

#include <type_traits>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Any function object by reference, for the time of a call. What takes it is instantiated once for
// all of them. Used where a call does the work of many elements, so that the jump costs nothing.
template <class Signature>
class Function_ref;

template <class... Arguments>
class Function_ref<void(Arguments...)>
{
public:
  template <class Function,
            class = std::enable_if_t<!std::is_same_v<std::decay_t<Function>, Function_ref>>>
  Function_ref(const Function& f)
    : function_(&f)
    , call_([](const void* function, Arguments... arguments) {
      (*static_cast<const Function*>(function))(arguments...);
    })
  {}

  void operator()(Arguments... arguments) const { call_(function_, arguments...); }

private:
  const void* function_;
  void (*call_)(const void*, Arguments...);
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_FUNCTION_REF_H
