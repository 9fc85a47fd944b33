// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What holds for every scheme: exact invariance, rows that sum to 1 and rows that copy, any number of threads; and what
// suite/random_meshes.h has, for the schemes that the suite leaves out.

#include "Scheme_rows.h"
#include "Schemes.h"
#include "analysis/subdivision_matrix.h"
#include "suite/random_meshes.h"
#include "support/Exact_rational.h"

#include <CGAL/PN_subdivision_3/schemes/estimated_row_entries.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#  include <tbb/task_arena.h>
#endif

namespace {

namespace PN = CGAL::PN_subdivision_3;
using test_meshes::Control_mesh;
using test_meshes::Triple;

template <class Description>
class Scheme_property : public testing::Test
{};
TYPED_TEST_SUITE(Scheme_property, Schemes, Scheme_names);

constexpr unsigned rounds = 2;

PN::internal::Surface_mesh_access<const Surface_mesh> access_to(const Surface_mesh& mesh)
{
  return PN::internal::Surface_mesh_access<const Surface_mesh>(mesh);
}

template <class Description>
Result refined(const Control_mesh& control)
{
  Surface_mesh mesh = to_surface_mesh(control);
  refine<Description>(mesh, rounds);
  return result_of(mesh);
}

template <class Description>
std::vector<Control_mesh> meshes_with_wild_normals()
{
  std::vector<Control_mesh> result = meshes_for<Description>();
  for (Control_mesh& mesh : result) test_meshes::set_wild_normals(mesh, 5);
  return result;
}

// --- invariance ---

// Half a turn about the z axis and a power of two as scale: no operation rounds differently.
TYPED_TEST(Scheme_property, CommutesBitForBitWithExactSimilarities)
{
  for (Control_mesh control : meshes_with_wild_normals<TypeParam>()) {
    Result expected = refined<TypeParam>(control);
    for (auto& p : expected.values.points) p = reference::Vector(-16 * p[0], -16 * p[1], 16 * p[2]);
    for (auto& n : expected.values.normals) n = reference::Vector(-n[0], -n[1], n[2]);
    for (Triple& p : control.points) p = {-16 * p[0], -16 * p[1], 16 * p[2]};
    for (Triple& n : control.normals) n = {-n[0], -n[1], n[2]};
    EXPECT_TRUE(is_within(difference_by_index(refined<TypeParam>(control), expected), 0))
      << control.name;
  }
}

TYPED_TEST(Scheme_property, IgnoresLabelsOfVerticesOrderAndStartOfFaces)
{
  std::mt19937 generator(11);
  for (const Control_mesh& control : meshes_for<TypeParam>()) {
    std::vector<int> label(control.points.size());
    for (std::size_t i = 0; i < label.size(); ++i) label[i] = int(i);
    std::shuffle(label.begin(), label.end(), generator);
    Control_mesh other = control;
    for (std::size_t i = 0; i < label.size(); ++i) {
      other.points[std::size_t(label[i])] = control.points[i];
      other.normals[std::size_t(label[i])] = control.normals[i];
    }
    for (reference::Face& f : other.faces) {
      for (int& v : f) v = label[std::size_t(v)];
      std::rotate(f.begin(), f.begin() + std::ptrdiff_t(generator() % f.size()), f.end());
    }
    // a face may only follow a neighbor of it, for add_face()
    std::reverse(other.faces.begin(), other.faces.end());
    const Result expected = refined<TypeParam>(control), result = refined<TypeParam>(other);
    EXPECT_TRUE(is_within(difference(result, expected), 1e-13)) << control.name;
    if (!TypeParam::is_primal) continue;
    for (std::size_t i = 0; i < label.size(); ++i) // old vertices keep their index
      ASSERT_LE(
        double((result.values.points[std::size_t(label[i])] - expected.values.points[i]).norm()),
        1e-12)
        << control.name << ", vertex " << i;
  }
}

// --- rows ---

// of valences and degrees beyond the tables of weights, too
template <class Description>
std::vector<Control_mesh> meshes_of_any_valence()
{
  std::vector<Control_mesh> result = meshes_for<Description>();
  using namespace test_meshes;
  for (Control_mesh mesh : {bipyramid(64), in_quads(bipyramid(40)), house(64)}) {
    set_uneven_normals(mesh, 1);
    if (takes<Description>(mesh)) result.push_back(mesh);
  }
  return result;
}

template <class FT, class Description>
void expect_rows_that_sum_to_one()
{
  for (const Control_mesh& control : meshes_of_any_valence<Description>()) {
    Surface_mesh mesh = to_surface_mesh(control);
    for (unsigned k = 1; k <= 2; ++k) {
      ::expect_rows_that_sum_to_one<FT>(mesh, Description::scheme(), k, control.name);
      if (k == 1) refine_linearly<Description>(mesh, 1);
    }
  }
}

TYPED_TEST(Scheme_property, RowsSumToOneInOrderOfEmission)
{
  expect_rows_that_sum_to_one<double, TypeParam>();
  expect_rows_that_sum_to_one<float, TypeParam>();
  expect_rows_that_sum_to_one<long double, TypeParam>();
}

TYPED_TEST(Scheme_property, RowsSumToOneExactly)
{
  expect_rows_that_sum_to_one<CGAL::Exact_rational, TypeParam>();
}

// Vertices and faces with many edges, whose rows are long and have weights that are not tabulated.
template <class Description>
std::vector<Control_mesh> meshes_of_high_valence(int n)
{
  using test_meshes::Cells;
  std::vector<Control_mesh> result;
  for (Control_mesh mesh : {test_meshes::star(n, 2, Cells::triangles),
                            test_meshes::star(n, 2, Cells::quads), test_meshes::house(n)}) {
    test_meshes::set_uneven_normals(mesh, unsigned(n));
    if (takes<Description>(mesh)) result.push_back(mesh);
  }
  return result;
}

TYPED_TEST(Scheme_property, EqualsTheReferenceAtHighValences)
{
  for (int n : {31, 32, 90})
    for (const Control_mesh& control : meshes_of_high_valence<TypeParam>(n)) {
      Surface_mesh mesh = to_surface_mesh(control);
      const Result expected = reference_result<TypeParam>(mesh, 1, Rule::pn);
      refine<TypeParam>(mesh, 1);
      EXPECT_TRUE(is_within(difference_by_index(result_of(mesh), expected), 1e-13)) << control.name;
    }
}

// At high valences the long rows are what counts: none is forgotten, and none counted for much more than
// it takes. (Kobbelt's are merged from several times as many entries; modified rules may not be in force yet.)
TYPED_TEST(Scheme_property, EstimatesTheEntriesOfItsRows)
{
  for (const Control_mesh& control : meshes_of_high_valence<TypeParam>(200)) {
    Surface_mesh mesh = to_surface_mesh(control);
    const auto scheme = TypeParam::scheme();
    // adaptors pass it on
    const double estimate =
      PN::estimated_row_entries(PN::internal::with_border(PN::linear(scheme), PN::Border::surface),
                                PN::internal::checked_level(access_to(mesh)), 2);
    double entries = 0;
    for (unsigned k : {1u, 2u}) {
      for_each_row<double>(mesh, scheme, k, [&](auto, const auto* begin, const auto* end) {
        entries += double(end - begin);
      });
      PN::subdivide(mesh, PN::linear(scheme));
    }
    EXPECT_GT(estimate, 0.8 * entries) << control.name;
    EXPECT_LT(estimate, 6 * entries) << control.name;
  }
}

TYPED_TEST(Scheme_property, NewElementsHaveParentsOfTheirOwn)
{
  using Kind = PN::Element_parent::Kind;
  using Host = typename decltype(TypeParam::scheme())::Host;
  for (const Control_mesh& control : meshes_for<TypeParam>())
    for (unsigned round : {1u, 2u}) {
      const Surface_mesh mesh = to_surface_mesh(control);
      const PN::Level_connectivity level = PN::internal::checked_level(access_to(mesh));
      if (round == 2 && (level.has_border() || TypeParam::composes_single_rounds)) continue;
      const Host host(level, round);
      using Index = std::uint32_t;
      const auto expect_own = [&](const char* kind, std::uint64_t size, const auto& parent_of) {
        std::set<std::array<Index, 3>> parents;
        for (Index i = 0; i < size; ++i) {
          const PN::Element_parent parent = parent_of(i);
          EXPECT_TRUE(parents.insert({Index(parent.kind), parent.index, parent.ordinal}).second)
            << control.name << ", " << kind << " " << i;
        }
      };
      const PN::Level_size size = Host::refined_size(level.size(), round);
      expect_own("vertex", size.vertices, [&](Index v) {
        const PN::Element_parent parent = host.parent_of_vertex(v);
        if (parent.kind == Kind::vertex) {
          EXPECT_EQ(parent.index, v);
        }
        return parent;
      });
      expect_own("edge", size.edges, [&](Index e) { return host.parent_of_edge(e); });
      expect_own("face", size.faces, [&](Index f) { return host.parent_of_face(f); });
    }
}

// More entries than Eigen can number are refused by the row that has them; the limit is lowered here.
TEST(Matrix_rows, AddUpAndAreNotMoreThanCanBeNumbered)
{
  using Rows = PN::internal::Matrix_rows<double>;
  const Rows::Entry entries[] = {{2, 0.25}, {0, 0.5}, {2, 0.125}, {1, 0.125}};
  Rows rows(2, 3, 7);
  rows.append(entries, entries + 4);
  rows.append(entries, entries + 4);
  const Eigen::MatrixXd expected = Eigen::RowVector3d(0.5, 0.125, 0.375).replicate(2, 1);
  EXPECT_EQ(Eigen::MatrixXd(rows.release()), expected);

  Rows too_many(2, 3, 5);
  too_many.append(entries, entries + 4);
  EXPECT_THROW(too_many.append(entries, entries + 4), std::length_error);
  EXPECT_THROW(Rows(std::uint64_t(1) << 31, 3), std::length_error);
}

TYPED_TEST(Scheme_property, RowsOfOneEntryCopyBitForBit)
{
  for (const Control_mesh& control : meshes_with_wild_normals<TypeParam>()) {
    Surface_mesh old = to_surface_mesh(control), mesh = old;
    refine<TypeParam>(mesh, 1);
    const Normal_map old_normals = normal_map(old), normals = normal_map(mesh);
    std::set<std::size_t> copies;
    for_each_row<double>(
      old, TypeParam::scheme(), 1, [&](std::size_t i, const auto* begin, const auto* end) {
        if (end - begin != 1) return;
        copies.insert(i);
        const Surface_mesh::Vertex_index v(static_cast<Surface_mesh::size_type>(i)),
          source(begin->vertex);
        EXPECT_EQ(mesh.point(v), old.point(source)) << control.name << ", vertex " << i;
        EXPECT_EQ(normals[v], old_normals[source]) << control.name << ", vertex " << i;
      });
    if (!TypeParam::is_primal) continue;
    for (auto v : old.vertices())
      if (TypeParam::is_interpolatory || old.is_isolated(v)) {
        EXPECT_EQ(copies.count(v.idx()), 1u) << control.name << ", " << v;
      }
  }
}

TEST(Subdivision_matrix, RoundsThatCannotBeAreRefused)
{
  Control_mesh control = test_meshes::single_polygon(3);
  test_meshes::set_uneven_normals(control, 1);
  const Surface_mesh triangle = to_surface_mesh(control);
  EXPECT_THROW(PN::subdivision_matrix(triangle, PN::Loop_scheme(), 0), std::invalid_argument);
  // an even round cuts the border edge of a face, of which there may be only one
  EXPECT_THROW(PN::subdivision_matrix(triangle, PN::Sqrt3_scheme(), 2), std::invalid_argument);
  EXPECT_EQ(PN::subdivision_matrix(triangle, PN::Sqrt3_scheme(), 1).rows(), 4);
}

// --- threads ---

#ifdef CGAL_LINKED_WITH_TBB
template <class Function>
void with_threads(int n, const Function& f)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, std::size_t(n));
  tbb::task_arena(n).execute(f);
}

TYPED_TEST(Scheme_property, AnyNumberOfThreadsGivesTheSameBits)
{
  using test_meshes::Cells;
  const Cells cells = TypeParam::degree == 3   ? Cells::triangles
                      : TypeParam::degree == 4 ? Cells::quads
                                               : Cells::mixed;
  for (bool closed : {false, true}) {
    Control_mesh control = test_meshes::grid(25, 20, true, closed, cells);
    test_meshes::set_wild_normals(control, 3);
    Surface_mesh expected = to_surface_mesh(control), expected_linear = expected;
    refine<TypeParam>(expected, 3);
    refine_linearly<TypeParam>(expected_linear, 3);
    EXPECT_GT(expected.number_of_vertices(), 8192u); // several chunks
    for (int threads = 1; threads <= 3; ++threads)
      with_threads(threads, [&] {
        Surface_mesh mesh = to_surface_mesh(control), linear = mesh;
        refine<TypeParam, CGAL::Parallel_tag>(mesh, 3);
        refine_linearly<TypeParam, CGAL::Parallel_tag>(linear, 3);
        EXPECT_TRUE(is_identical(mesh, expected)) << threads << " threads";
        EXPECT_TRUE(is_identical(linear, expected_linear)) << threads << " threads";
      });
  }
}
#endif

} // namespace

namespace random_meshes {
using Transfer_schemes = testing::Types<Ct_CatmullClark_description, Ct_Loop_description>;
INSTANTIATE_TYPED_TEST_SUITE_P(Transfer, Random_meshes, Transfer_schemes, Scheme_names);
} // namespace random_meshes
