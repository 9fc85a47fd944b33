// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_SUBDIVISION_MATRIX_H
#define CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_SUBDIVISION_MATRIX_H

#include <CGAL/PN_subdivision_3/internal/needs_eigen.h>

#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_values.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/internal/schemes/on_host.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

// A sparse matrix that is filled row by row, without a list of its entries besides.
template <class FT>
class Matrix_rows
{
public:
  using Matrix = Eigen::SparseMatrix<FT, Eigen::RowMajor>;
  using Entry = typename Stencil_block<FT>::Entry;

  Matrix_rows(
    std::uint64_t rows, std::uint64_t columns,
    std::uint64_t most_entries = static_cast<std::uint64_t>((std::numeric_limits<int>::max)()))
    : most_entries_(most_entries)
  {
    check(rows, "rows");
    check(columns, "columns");
    matrix_.resize(static_cast<int>(rows), static_cast<int>(columns));
  }

  // appends a row; weights of the same vertex add up in their order
  void append(const Entry* begin, const Entry* end)
  {
    row_.assign(begin, end);
    std::stable_sort(row_.begin(), row_.end(),
                     [](const Entry& a, const Entry& b) { return a.vertex < b.vertex; });
    check(static_cast<std::uint64_t>(matrix_.data().size()) + row_.size(), "entries");
    matrix_.startVec(next_row_);
    FT* weight = nullptr;
    for (std::size_t i = 0; i < row_.size(); ++i)
      if (i != 0 && row_[i].vertex == row_[i - 1].vertex)
        *weight += row_[i].weight;
      else {
        weight = &matrix_.insertBack(next_row_, static_cast<int>(row_[i].vertex));
        *weight = row_[i].weight;
      }
    ++next_row_;
  }

  // the matrix, when all rows are there
  Matrix release()
  {
    matrix_.finalize();
    return std::move(matrix_);
  }

private:
  void check(std::uint64_t n, const char* what) const
  {
    if (n > most_entries_)
      throw std::length_error("PN_subdivision_3: a matrix of " + std::to_string(n) + " or more " +
                              what + " is more than Eigen's int can number: take a smaller mesh");
  }

  std::uint64_t most_entries_;
  Matrix matrix_;
  int next_row_ = 0;
  std::vector<Entry> row_;
};

} // namespace internal

/*!
returns the weights of one round of a scheme as a sparse matrix: row i holds the weights of the new
vertex i on the old vertices, which are the columns. Multiplied with the matrix of the old points it
gives the points of the linear scheme; the eigenvalues of its part that maps the neighborhood of a
vertex to the neighborhood of the same vertex after the round decide on the smoothness there.

The rows sum to 1: exactly in exact number types; in floating point exactly when the weights are
added in the order in which the mask emits them, and within 4 machine epsilons otherwise.

Not part of the header `CGAL/PN_subdivision_3.h`, since it needs \ref thirdpartyEigen "Eigen".

\tparam FT the number type of the weights; for a type that Eigen does not know,
  specialize `Eigen::NumTraits<FT>`
\tparam PolygonMesh a model of `FaceListGraph`
\tparam Scheme a model of `PNSubdivisionScheme_3`

\param mesh an oriented 2-manifold with border; it is not modified. The matrix is that of the mesh without
  creases.
\param scheme the scheme; of one with different normals, the mask of the points counts.
\param round the number of the round in a call, counted from 1, for schemes whose weights depend on
  it

\throws std::invalid_argument as `subdivide()` does, and if `round` is 0
\throws std::length_error if there are more rows or entries than `int` can number
<br><b>Cost:</b> linear in the number of entries
*/
template <class FT = double, class PolygonMesh, class Scheme>
Eigen::SparseMatrix<FT, Eigen::RowMajor>
subdivision_matrix(const PolygonMesh& mesh, const Scheme& scheme, unsigned round = 1)
{
  if (round == 0)
    throw std::invalid_argument("PN_subdivision_3: the rounds of a call are counted from 1");
  using Matrix = Eigen::SparseMatrix<FT, Eigen::RowMajor>;
  if constexpr (internal::Is_any<Scheme>::value)
    return internal::on_host<Matrix, internal::Number_call<FT>, internal::Hosts::all>(
      scheme, [&](const auto& s) { return subdivision_matrix<FT>(mesh, s, round); });
  else {
    Matrix matrix;
    internal::with_mesh_access(mesh, [&](const auto& access) {
      const Level_connectivity level = internal::checked_level(access);
      internal::check_scheme(scheme, level, access);
      internal::refuse_crease_borders(scheme, access, level, "a matrix has no rows");
      const typename Scheme::Host host(level, round);
      const auto mask = scheme.template mask<FT>(level, round);
      const std::uint64_t size = Scheme::Host::refined_size(level.size(), round).vertices;
      internal::Matrix_rows<FT> rows(size, level.number_of_vertices());
      internal::Stencil_block<FT> stencil;
      for (std::uint64_t r = 0; r < size; ++r) {
        stencil.clear();
        host.stencil(mask, static_cast<Level_connectivity::Index>(r), stencil.row());
        stencil.close_row();
        rows.append(stencil.begin(0), stencil.end(0));
      }
      matrix = rows.release();
    });
    return matrix;
  }
}

} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_SUBDIVISION_MATRIX_H
