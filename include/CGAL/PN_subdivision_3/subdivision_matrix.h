// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_SUBDIVISION_MATRIX_H
#define CGAL_PN_SUBDIVISION_3_SUBDIVISION_MATRIX_H

#include <CGAL/PN_subdivision_3/schemes/Stencil.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <Eigen/SparseCore>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {

/*!
\ingroup PkgPNSubdivision3Functions

returns the weights of one round of a scheme as a sparse matrix: row i holds the weights of the new
vertex i on the old vertices, which are the columns. Multiplied with the matrix of the old points it
gives the points of the linear scheme; the eigenvalues of its part that maps the neighborhood of a
vertex to that of its successor decide on the smoothness there.

The rows sum to 1: exactly in exact number types; in floating point exactly when the weights are
added in the order in which the mask emits them, and within 4 machine epsilons otherwise.

Not part of the header `CGAL/PN_subdivision_3.h`, since it needs \ref thirdpartyEigen "Eigen".

\tparam FT the number type of the weights; if it is none of Eigen's own, `Eigen::NumTraits<FT>` has
  to be specialized
\tparam PolygonMesh a model of `FaceListGraph`
\tparam Scheme a model of `PNSubdivisionScheme_3`

\param mesh an oriented 2-manifold with border; it is not modified
\param scheme the scheme; of one with different normals, the mask of the points counts
\param round the number of the round in a call, counted from 1, for schemes whose weights depend on
  it

\throws std::invalid_argument as `subdivide()` does, and if `round` is 0
\throws std::length_error if there are more rows than `int` can number
\cost linear in the size of the refined mesh
*/
template <class FT = double, class PolygonMesh, class Scheme>
Eigen::SparseMatrix<FT, Eigen::RowMajor>
subdivision_matrix(const PolygonMesh& mesh, const Scheme& scheme, unsigned round = 1)
{
  using Index = Level_connectivity::Index;
  using Triplet = Eigen::Triplet<FT, int>;
  if (round == 0)
    throw std::invalid_argument("PN_subdivision_3: the rounds of a call are counted from 1");
  Eigen::SparseMatrix<FT, Eigen::RowMajor> matrix;
  internal::with_mesh_access(mesh, [&](const auto& access) {
    const Level_connectivity level = internal::checked_level(access);
    internal::check_scheme(scheme, level, access);
    const typename Scheme::Host host(level, round);
    const auto mask = scheme.template mask<FT>(level, round);
    const std::uint64_t size = Scheme::Host::refined_size(level.size(), round).vertices;
    if (size > static_cast<std::uint64_t>((std::numeric_limits<int>::max)()))
      throw std::length_error("PN_subdivision_3: a matrix of " + std::to_string(size) +
                              " rows is more than Eigen's int can number");
    const auto rows = static_cast<Index>(size);
    std::vector<Triplet> triplets;
    Stencil<FT> stencil;
    for (Index r = 0; r < rows; ++r) {
      stencil.clear();
      host.stencil(mask, r, stencil);
      stencil.close_row();
      for (auto e = stencil.begin(0); e != stencil.end(0); ++e)
        triplets.emplace_back(static_cast<int>(r), static_cast<int>(e->vertex), e->weight);
    }
    matrix.resize(static_cast<int>(rows), static_cast<int>(level.number_of_vertices()));
    matrix.setFromTriplets(triplets.begin(), triplets.end());
  });
  return matrix;
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_SUBDIVISION_MATRIX_H
