// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SCHEMES_TUNED_CATMULLCLARK_SCHEME_H
#define CGAL_PN_SUBDIVISION_3_SCHEMES_TUNED_CATMULLCLARK_SCHEME_H

#include <CGAL/PN_subdivision_3/hosts/PQQ_host.h>
#include <CGAL/PN_subdivision_3/internal/numbers/Weight_number.h>
#include <CGAL/PN_subdivision_3/internal/schemes/Ring_tuning.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/rows/Stencil.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_weights.h>
#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::PN_subdivision_3 {

namespace internal {

// The eigenvalues of A_k, frequency k > 0; they coincide where 2k = n.
template <class Number>
struct CatmullClark_eigenvalues
{
  CatmullClark_eigenvalues(std::size_t k, std::size_t n)
    : cosine(cosine_weight<Number>(std::int64_t(k), std::int64_t(n)))
    , half_cosine(cosine_weight<Number>(std::int64_t(k), std::int64_t(2 * n)))
  {
    const Number two_half_cosines = Number(2) * half_cosine;
    // (c + 1)(c + 9), where c + 1 would cancel near -1
    const Number root = square_root(Number(two_half_cosines * half_cosine * (cosine + Number(9))));
    greater = (Number(5) + cosine + root) / Number(16);
    lesser = (Number(5) + cosine - root) / Number(16);
    difference = root / Number(8);
  }

  Number cosine, half_cosine, greater, lesser, difference;
};

// What the matrices A_k' of frequencies k > 0 add to the weights, from d = 0 on.
template <class Number>
struct Tuned_CatmullClark_frequencies
{
  Tuned_CatmullClark_frequencies(std::size_t n, const Number& new_lambda, const Ring_tuning& tuning)
    : edge_edge(n, Number(0))
    , edge_face(n, Number(0))
    , face_edge(n, Number(0))
    , face_face(n, Number(0))
  {
    std::vector<Number> cosine; // of multiples of pi / n
    for (std::size_t j = 0; j < 2 * n; ++j)
      cosine.push_back(cosine_weight<Number>(std::int64_t(j), std::int64_t(2 * n)));
    const Number size(static_cast<int>(n));
    for (std::size_t k = 1; k < n; ++k) {
      const CatmullClark_eigenvalues<Number> old(k, n);
      const bool is_dominant = k == 1 || k == n - 1;
      const bool is_quadratic = k == 2 || k == n - 2;
      const Number greater =
        is_dominant ? new_lambda : tuning.other(old.greater, is_quadratic, new_lambda);
      const Number lesser = tuning.other(old.lesser, n == 3, new_lambda);
      // A_k' = slope A_k + shift
      const Number slope = 2 * k == n ? Number(0) : Number((greater - lesser) / old.difference);
      const Number shift = lesser - slope * old.lesser;
      const Number ee = (slope * (Number(3) + old.cosine) / Number(8) + shift) / size;
      const Number ff = (slope / Number(4) + shift) / size;
      const Number ef = slope * old.half_cosine / Number(8) / size;
      const Number fe = Number(4) * ef;
      for (std::size_t d = 0; d < n; ++d) {
        edge_edge[d] += ee * cosine[k * 2 * d % (2 * n)];
        face_face[d] += ff * cosine[k * 2 * d % (2 * n)];
        edge_face[d] += ef * cosine[k * (2 * d + 1) % (2 * n)];
        face_edge[d] += fe * cosine[k * (2 * d + 2 * n - 1) % (2 * n)];
      }
    }
  }

  std::vector<Number> edge_edge, edge_face, face_edge, face_face;
};

template <class Number>
using Matrix_3x3 = std::array<std::array<Number, 3>, 3>;

// A_0', given the square root that occurs in the eigenvalues p and q of A_0: the matrix A_0, plus
// (p' - p) (A_0 - 1)(A_0 - q) / ((p - 1)(p - q)), plus the same with p and q exchanged.
template <class Number>
Matrix_3x3<Number> tuned_CatmullClark_mean(std::size_t valence, const Number& root,
                                           const Number& new_lambda, const Ring_tuning& tuning)
{
  const Number n(static_cast<int>(valence)), one(1), four_n = Number(4) * n;
  const Matrix_3x3<Number> a = {{{one - Number(7) / four_n, Number(6) / four_n, one / four_n},
                                 {Number(3) / Number(8), one / Number(2), one / Number(8)},
                                 {one / Number(4), one / Number(2), one / Number(4)}}};
  const Number p = (Number(3) * n - Number(7) + root) / (Number(8) * n);
  const Number q = (Number(3) * n - Number(7) - root) / (Number(8) * n);
  const Number of_p = (tuning.other(p, true, new_lambda) - p) / ((p - one) * (p - q));
  const Number of_q = (tuning.other(q, false, new_lambda) - q) / ((q - one) * (q - p));
  // A_0 + (A_0 - 1) (slope A_0 - shift)
  const Number slope = of_p + of_q, shift = of_p * q + of_q * p;
  Matrix_3x3<Number> result = a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t m = 0; m < 3; ++m) {
        const Number left = i == m ? Number(a[i][m] - one) : a[i][m];
        const Number right = m == j ? Number(slope * a[m][j] - shift) : Number(slope * a[m][j]);
        result[i][j] += left * right;
      }
  return result;
}

} // namespace internal

/*!
\ingroup PkgPNSubdivision3Schemes

The weights of Catmull-Clark subdivision, modified at extraordinary vertices after Prautzsch (1998). The matrix that
maps the 1-ring of such a vertex (the vertices of its faces) to the next one keeps its eigenvectors and gets other
eigenvalues.

An interior vertex of valence n other than 4 is *extraordinary*; it is *separated* if its faces are
quadrilaterals and none has another vertex that is extraordinary. This is decided anew in every
round: in a mesh with other polygons or neighboring extraordinary vertices the vertices are
separated after one round, or two. A separated vertex v, unless its valence is 2, the edges at v and
the faces at v have the rules below; all else is as in `CatmullClark_mask`.

Let e<sub>d</sub> be the neighbors around v, f<sub>d</sub> the vertex opposite v in the face between
e<sub>d</sub> and e<sub>d+1</sub>, c<sub>k</sub> = cos(2&pi;k/n). On the components of frequency k = 1, ..., n-1 of
(e, f) the scheme acts by A<sub>k</sub> = [3/8 + c<sub>k</sub>/8, c<sub>k/2</sub>/8; c<sub>k/2</sub>/2, 1/4]. Its
eigenvalues are (5 + c<sub>k</sub> &plusmn; ((c<sub>k</sub>+1)(c<sub>k</sub>+9))<sup>1/2</sup>)/16, of which &lambda;
is the greater one for k = 1. On (v, mean of e, mean of f) it acts by A<sub>0</sub> = [1 - 7/(4n), 3/(2n), 1/(4n);
3/8, 1/2, 1/8; 1/4, 1/2, 1/4] with the eigenvalues 1 and (3n - 7 &plusmn; (5n<sup>2</sup> - 30n +
49)<sup>1/2</sup>)/(8n). Then
<ul>
<li> &lambda;, of frequencies 1 and n-1, becomes &lambda;', which is 1/2 if n = 3, and &lambda;
otherwise; 1 remains,
<li> the absolute values of all others are bounded by C&lambda;'<sup>2</sup>; C is the cap.
With C = 1 curvature is only bounded.
</ul>
The matrices A<sub>k</sub>' with the new eigenvalues give the weights
<ul>
<li> vertex v: A<sub>0</sub>'[0][0] for v, A<sub>0</sub>'[0][1]/n and A<sub>0</sub>'[0][2]/n for the
e<sub>d</sub> and f<sub>d</sub>.
<li> edge from v to e<sub>0</sub>: A<sub>0</sub>'[1][0] for v,
(A<sub>0</sub>'[1][1] + &sum; A<sub>k</sub>'[0][0] c<sub>kd</sub>)/n for e<sub>d</sub>,
(A<sub>0</sub>'[1][2] + &sum; A<sub>k</sub>'[0][1] c<sub>k(d+1/2)</sub>)/n for f<sub>d</sub>.
<li> face of f<sub>0</sub>: A<sub>0</sub>'[2][0] for v,
(A<sub>0</sub>'[2][1] + &sum; A<sub>k</sub>'[1][0] c<sub>k(d-1/2)</sub>)/n for e<sub>d</sub>,
(A<sub>0</sub>'[2][2] + &sum; A<sub>k</sub>'[1][1] c<sub>kd</sub>)/n for f<sub>d</sub>.
</ul>

\tparam FT a field. The weights of frequency 0, thus of the vertex, are rational for n = 3. Others are computed to the
  precision of `Gmpfr` and of number types with their own `cos()`, `acos()` and `sqrt()`, and enclosed in intervals.
  For other types they are computed with about 104 bits, and rounded to `double` for exact number types. All rows sum
  to 1.
<br><b>Cost:</b> of construction: linear in the size of the level, and n<sup>2</sup> for every valence n of a
  separated vertex
\cgalModels{PNSubdivisionMask_3}
*/
template <class FT>
class Tuned_CatmullClark_mask
{
public:
  /// numbers an element.
  using Index = Level_connectivity::Index;

  /// makes the mask of a level, which has to live as long, with a bound of the eigenvalues.
  Tuned_CatmullClark_mask(const Level_connectivity& level, const Scheme_parameter& cap)
    : Tuned_CatmullClark_mask(level, 1, internal::Ring_tuning(cap, 1, Tuned_valences::all))
  {}
  /// in a round, counted from 1.
  Tuned_CatmullClark_mask(const Level_connectivity& level, unsigned round,
                          const internal::Ring_tuning& tuning)
    : level_(level)
    , plain_(level)
  {
    if (tuning.holds_in(round))
      separated_ = {level, 4, 4, [&](Index n) { return weights(n, tuning); },
                    [&](Index n) { return n > 3 || tuning.valences == Tuned_valences::all; }};
  }

  /// the row of the new vertex of an old vertex.
  template <class Stencil>
  void vertex(Index v, Stencil& s) const
  {
    if (const Weights* const w = separated_.at(v))
      ring(level_.halfedge_of_vertex(v), w->vertex, s);
    else
      plain_.vertex(v, s);
  }

  /// the row of the new vertex of an edge.
  template <class Stencil>
  void edge(Index e, Stencil& s) const
  {
    const auto [h, w] = separated_.at_edge(level_, e);
    if (w != nullptr)
      ring(h, w->edge, s);
    else
      plain_.edge(e, s);
  }

  /// the row of the new vertex of a face.
  template <class Stencil>
  void face(Index f, Stencil& s) const
  {
    for (const Index h : internal::halfedges_around_face(level_, level_.halfedge_of_face(f)))
      if (const Weights* const w = separated_.at(level_.target(h))) return ring(h, w->face, s);
    plain_.face(f, s);
  }

  /// the parts of `CatmullClark_mask`. \pre the row is the one of that mask
  FT face_part_of_vertex(Index h, Index n) const { return plain_.face_part_of_vertex(h, n); }
  /// the part of a face in the row of an edge.
  FT face_part_of_edge(Index h) const { return plain_.face_part_of_edge(h); }

  /// the vertices with rules of their own, in ascending order.
  std::vector<Index> separated_vertices() const { return separated_.vertices(); }

private:
  // The weights of e_d and f_d; v has the rest.
  struct Ring_weights
  {
    std::vector<FT> edges, faces;
  };
  struct Weights
  {
    Ring_weights vertex, edge, face;
  };

  // h leads from e_0 to v, f_0 is in its face
  template <class Stencil>
  void ring(Index h, const Ring_weights& w, Stencil& s) const
  {
    Index g = h;
    for (std::size_t d = 0; d < w.edges.size(); ++d) {
      s.add(level_.source(g), w.edges[d]);
      s.add(level_.target(level_.next(level_.next(g))), w.faces[d]);
      g = level_.next_around_target(g);
    }
    s.add_rest(level_.target(h));
  }

  static Weights weights(Index n, const internal::Ring_tuning& tuning)
  {
    using Number =
      internal::Weight_number<FT, internal::Has_trigonometry<FT>, internal::Has_square_root<FT>>;
    const Number new_lambda = n == 3 ? Number(Number(1) / Number(2))
                                     : internal::CatmullClark_eigenvalues<Number>(1, n).greater;
    const internal::Tuned_CatmullClark_frequencies<Number> other(n, new_lambda, tuning);
    const auto mean = frequency_zero(n, new_lambda, tuning);
    const auto sum = [](const FT& mean_weight, const Number& other_weight) {
      return FT(mean_weight + internal::rounded_weight<FT>(other_weight));
    };

    Weights w;
    w.vertex.edges.assign(n, mean[0][1]);
    w.vertex.faces.assign(n, mean[0][2]);
    for (Index d = 0; d < n; ++d) {
      w.edge.edges.push_back(sum(mean[1][1], other.edge_edge[d]));
      w.edge.faces.push_back(sum(mean[1][2], other.edge_face[d]));
      w.face.edges.push_back(sum(mean[2][1], other.face_edge[d]));
      w.face.faces.push_back(sum(mean[2][2], other.face_face[d]));
    }
    return w;
  }

  // A_0' / n, which is rational for n = 3
  template <class Number>
  static internal::Matrix_3x3<FT> frequency_zero(Index n, const Number& new_lambda,
                                                 const internal::Ring_tuning& tuning)
  {
    internal::Matrix_3x3<FT> result;
    if (n == 3)
      result = internal::tuned_CatmullClark_mean<FT>(n, FT(2), FT(FT(1) / FT(2)), tuning);
    else {
      const Number size = Number(int(n));
      const Number square = (Number(5) * size - Number(30)) * size + Number(49);
      const auto rounded = internal::tuned_CatmullClark_mean<Number>(
        n, internal::square_root(square), new_lambda, tuning);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          result[i][j] = internal::rounded_weight<FT>(rounded[i][j]);
    }
    for (auto& row : result)
      for (FT& weight : row) weight /= FT(int(n));
    return result;
  }

  const Level_connectivity& level_;
  CatmullClark_mask<FT> plain_;
  internal::Separated_vertices<Weights> separated_;
};

/*!
\ingroup PkgPNSubdivision3Schemes
Tuned Catmull-Clark subdivision: `Tuned_CatmullClark_mask` on `PQQ_host`. Accepts any polygons.
On a mesh without separated extraordinary vertices a round gives the same as one of `CatmullClark_scheme`.

`Tuned(cap, first_round, valences)` takes the cap, above 0 and at most 1, by default 0.5. In a call, whose rounds are counted
from 1, the rules hold from `first_round` on, by default 1, and those of `CatmullClark_scheme` before; they hold at `valences`, see
`Tuned_valences`, by default at all. Numbers out of their range are refused by `std::invalid_argument`. `of_the_paper(cap)` is the
policy of Yang's paper: a plain first round, and plain rules at valence 3.
\cgalModels{PNSubdivisionScheme_3}
*/
class CatmullClark_scheme::Tuned : public internal::Tuned_scheme<CatmullClark_scheme>
{
public:
  /// the name of the scheme, as in the command `pn_subdivide`.
  static constexpr const char* name() { return "modified-catmull-clark"; }

  using internal::Tuned_scheme<CatmullClark_scheme>::Tuned_scheme;

  /// the mask of a round; see `PNSubdivisionScheme_3`.
  template <class FT>
  Tuned_CatmullClark_mask<FT> mask(const Level_connectivity& level, unsigned round) const
  {
    return Tuned_CatmullClark_mask<FT>(level, round, tuning_);
  }

  /// see `estimated_row_entries()`: the edges and faces of a separated vertex of valence n have 2n entries each, other faces those of `CatmullClark_scheme`.
  /// A face of the first round is a vertex of the next.
  static double dense_row_entries(const Level_connectivity& level, unsigned round)
  {
    if (round == 1)
      return 4 * internal::squared_separated_valences(level, 4, 4) +
             2 * internal::squared_irregular_degrees(level);
    // nearly all are separated
    return 4 * (internal::squared_irregular_valences(level, 4) +
                internal::squared_irregular_degrees(level));
  }
};

} // namespace CGAL::PN_subdivision_3

#endif // CGAL_PN_SUBDIVISION_3_SCHEMES_TUNED_CATMULLCLARK_SCHEME_H
