// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_CALLER_PRECISION_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_CALLER_PRECISION_H

#include <CGAL/PN_subdivision_3/average/Unit_normal_traits.h>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// The precision that new numbers of a multiprecision type get is a setting of the thread: what
// computes for a caller takes over the caller's, and gives the thread its own back.
template <class FT, bool = Has_default_precision<FT>::value>
class Caller_precision
{
public:
  struct In_this_thread
  {
    explicit In_this_thread(const Caller_precision&) {}
    ~In_this_thread() {} // NOLINT(modernize-use-equals-default): used, as far as compilers warn
  };
};

template <class FT>
class Caller_precision<FT, true>
{
public:
  class In_this_thread
  {
  public:
    explicit In_this_thread(const Caller_precision& caller)
      : own_(FT::set_default_precision(caller.precision_))
    {}
    ~In_this_thread() { FT::set_default_precision(own_); }
    In_this_thread(const In_this_thread&) = delete;
    In_this_thread& operator=(const In_this_thread&) = delete;

  private:
    decltype(FT::get_default_precision()) own_;
  };

private:
  decltype(FT::get_default_precision()) precision_ = FT::get_default_precision();
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINEMENT_CALLER_PRECISION_H
