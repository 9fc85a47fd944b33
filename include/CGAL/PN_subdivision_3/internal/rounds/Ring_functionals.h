// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_RING_FUNCTIONALS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_RING_FUNCTIONALS_H

#include <CGAL/PN_subdivision_3/internal/average/vectors.h>
#include <CGAL/PN_subdivision_3/internal/numbers/number_functions.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// the double subdominant eigenvalue of Catmull-Clark (degree 4) and Loop subdivision
template <class FT>
FT subdominant_eigenvalue(Level_connectivity::Index degree, Level_connectivity::Index valence)
{
  const FT c = cosine_weight<FT>(1, valence);
  if (degree == 3) return FT(3) / 8 + c / 4;
  return (5 + c + square_root_of<FT>((c + 1) * (c + 9))) / 16;
}

// Left eigenvectors of the ring matrix of Catmull-Clark or Loop subdivision at an extraordinary
// vertex, in closed form: of 1 and lambda, and of the eigenvalues of the quadratic part of the
// surface. A ring is the vertex, its neighbors e_s in cyclic order and, among quads, the f_s between
// e_s and e_{s+1}.
template <class FT>
class Ring_functionals
{
public:
  using Index = Level_connectivity::Index;
  using Functional = std::vector<FT>;
  struct Entry
  {
    Index vertex; // the place in the ring
    FT weight;
  };

  Ring_functionals(Index degree, Index valence)
    : degree_(degree)
    , n_(valence)
    , lambda_(subdominant_eigenvalue<FT>(degree, valence))
  {
    make_limit();
    if (is_quads())
      make_quadratic_of_quads();
    else
      make_quadratic_of_triangles();
  }

  std::size_t size() const { return 1 + (degree_ - 2) * std::size_t(n_); }
  const std::vector<Entry>& limit() const { return limit_; }
  const Functional& tangent(std::size_t i) const { return tangents_[i]; }
  // three functionals, less at valences 3 and 4 of triangles; the largest modulus is 1
  const std::vector<Functional>& quadratic() const { return quadratic_; }

private:
  bool is_quads() const { return degree_ == 4; }

  void make_limit()
  {
    const FT n(static_cast<int>(n_));
    const FT a = 5 - 8 * lambda_ * lambda_; // 8 alpha
    const FT edge = is_quads() ? FT(4 / (n * (n + 5))) : FT(a / (n * (3 + a)));
    limit_.push_back({0, is_quads() ? FT(n / (n + 5)) : FT(3 / (3 + a))});
    for (Index s = 1; s <= n_; ++s) limit_.push_back({s, edge});
    for (Index s = n_ + 1; s < size(); ++s) limit_.push_back({s, FT(edge / 4)});
    const FT y = is_quads() ? face_part(1, lambda_) : FT(0);
    tangents_[0] = wave(1, y, 0);
    tangents_[1] = wave(1, y, 1);
  }

  // of frequency k and eigenvalue mu: the share of the f_s, where that of the e_s is 1
  FT face_part(Index k, const FT& mu) const { return half_turn(k)[0] / (8 * (mu - FT(1) / 4)); }

  // exp(-i k pi / n), by sin(x) = cos(x - pi / 2)
  Pair<FT> half_turn(std::int64_t k) const
  {
    return {cosine_weight<FT>(k, 2 * std::int64_t(n_)),
            -cosine_weight<FT>(2 * k - std::int64_t(n_), 4 * std::int64_t(n_))};
  }

  // the real (0) or imaginary part (1) of e^(-iks theta) on the e_s and y e^(-ik(s+1/2) theta) on the f_s
  Functional wave(Index k, const FT& y, std::size_t part) const
  {
    Functional f(size(), FT(0));
    for (Index s = 0; s < n_; ++s) {
      f[1 + s] = half_turn(std::int64_t(k) * 2 * s)[part];
      if (is_quads()) f[1 + n_ + s] = y * half_turn(std::int64_t(k) * (2 * s + 1))[part];
    }
    return f;
  }

  void add_wave(Index k, const FT& y, std::size_t parts = 2)
  {
    const FT largest = (std::max)(FT(1), absolute_value(y));
    for (std::size_t part = 0; part < parts; ++part) {
      quadratic_.push_back(wave(k, y, part));
      for (FT& x : quadratic_.back()) x /= largest;
    }
  }

  void make_quadratic_of_quads()
  {
    const FT n(static_cast<int>(n_)),
      mu = (3 * n - 7 + square_root_of<FT>(5 * n * n - 30 * n + 49)) / (8 * n);
    const FT edges = 8 * n * mu - 2 * n + 2, faces = n - 2;
    const FT largest = edges + faces;
    Functional mean(size(), edges / n / largest);
    mean[0] = -1;
    std::fill(mean.begin() + static_cast<std::ptrdiff_t>(n_) + 1, mean.end(), faces / n / largest);
    quadratic_.push_back(mean);
    // at valence 3 the second one of frequency 1
    const Index k = n_ == 3 ? 1 : 2;
    const FT c = half_turn(2 * k)[0], root = square_root_of<FT>((c + 1) * (c + 9));
    add_wave(k, face_part(k, FT((5 + c + (n_ == 3 ? FT(-root) : root)) / 16)));
  }

  void make_quadratic_of_triangles()
  {
    Functional mean(size(), FT(FT(1) / FT(static_cast<int>(n_))));
    mean[0] = -1;
    quadratic_.push_back(mean);
    if (n_ > 3) add_wave(2, FT(0), n_ == 4 ? 1 : 2);
  }

  Index degree_, n_;
  FT lambda_;
  std::vector<Entry> limit_;
  Functional tangents_[2];
  std::vector<Functional> quadratic_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_ROUNDS_RING_FUNCTIONALS_H
