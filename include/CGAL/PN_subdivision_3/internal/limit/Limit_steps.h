// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_STEPS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_STEPS_H

#include <CGAL/PN_subdivision_3/average/Unit_normal_traits.h>
#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/limit/Limit_tower.h>
#include <CGAL/PN_subdivision_3/internal/limit/limit_error.h>
#include <CGAL/PN_subdivision_3/internal/limit/refuse_intervals.h>

#include <cmath>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// Decides when the averages of a limit mask over values that are refined by themselves have come close
// enough to the limit, as a Limit_tower does.
template <class FT>
class Limit_steps
{
public:
  // ratio: that of the differences in a row; is_exact: whether the first average is the limit
  Limit_steps(const Limit_demand& demand, bool is_exact, double ratio)
    : demand_(demand)
    , is_exact_(is_exact)
    , ratio_(ratio)
  {
    if (!is_exact) refuse_intervals<FT>();
  }

  // takes the averages one after the other
  bool is_last(const Coordinates<FT, 3>& limit)
  {
    if (is_exact_) return true;
    if (is_first_)
      is_first_ = false;
    else {
      ++depth_;
      const double step =
        std::hypot(close_double(FT(limit[0] - last_[0])), close_double(FT(limit[1] - last_[1])),
                   close_double(FT(limit[2] - last_[2])));
      error_ = limit_error(limit_error_factor(ratio_), ratio_, step, last_step_);
      if (error_ <= demand_.tolerance || depth_ >= demand_.max_depth) return true;
    }
    last_ = limit;
    return false;
  }

  // estimated
  double error() const { return error_; }
  // rounds done
  unsigned depth() const { return depth_; }

private:
  const Limit_demand& demand_;
  const bool is_exact_;
  const double ratio_;
  bool is_first_ = true;
  Coordinates<FT, 3> last_{};
  double last_step_ = 0, error_ = 0;
  unsigned depth_ = 0;
};

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_LIMIT_LIMIT_STEPS_H
