// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The modified schemes: where they differ from the unmodified ones, rows against eigenvalues and eigenvectors of the
// 1-ring, which the reference is made of, and known from hand, all valences and caps.

#include "Messages.h"
#include "Modified_rings.h"
#include "Named_shapes.h"
#include "analysis/subdivision_matrix.h"

#include <CGAL/Gmpq.h>

namespace {

template <class Kind>
class Modified_scheme : public testing::Test
{};
TYPED_TEST_SUITE(Modified_scheme, Kinds_of_faces, );

template <class Kind, class Scheme>
Matrix ring_matrix(int n, const Scheme& scheme)
{
  const auto rows = ring_of<double, Kind>(n, scheme);
  Matrix m(Eigen::Index(rows.size()), Eigen::Index(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows.size(); ++j) m(Eigen::Index(i), Eigen::Index(j)) = rows[i][j];
  return m;
}

double largest(const Matrix& m)
{
  return double(m.cwiseAbs().maxCoeff());
}

// --- where the rules differ ---

// The new vertices whose rows are not those of the unmodified scheme. (With the cap 1/2, Loop's row
// of a vertex of valence 3 is.)
template <class Kind>
std::set<std::size_t> modified_rows(const Surface_mesh& mesh)
{
  const Eigen::MatrixXd plain = PN::subdivision_matrix(mesh, Kind::unmodified()),
                        modified = PN::subdivision_matrix(mesh, typename Kind::Modified(0.2));
  std::set<std::size_t> rows;
  for (Eigen::Index i = 0; i < plain.rows(); ++i)
    if (plain.row(i) != modified.row(i)) rows.insert(std::size_t(i));
  return rows;
}

template <class Kind>
void expect_modified_about(Control_mesh control, unsigned rounds_before,
                           const std::set<int>& vertices)
{
  control.normals.assign(control.points.size(), {0, 0, 0});
  Surface_mesh mesh = to_surface_mesh(control);
  PN::subdivide(mesh, PN::linear(Kind::unmodified()),
                CGAL::parameters::number_of_iterations(rounds_before));
  const reference::Face_list list = face_list(mesh);
  std::set<std::size_t> expected;
  for (int v : vertices) {
    expected.insert(std::size_t(v));
    for (int u : list.ring(v)) {
      expected.insert(reference::edge_point(list, v, u));
      if (Kind::groups == 2) expected.insert(reference::face_point(list, list.face(v, u)));
    }
  }
  EXPECT_EQ(modified_rows<Kind>(mesh), expected)
    << control.name << " after " << rounds_before << " rounds";
}

TYPED_TEST(Modified_scheme, ModifiesVertexEdgesAndFacesOfASeparatedVertex)
{
  for (int n : {3, 4, 5, 6, 7, 12})
    for (int rings : {1, 2}) // one ring: all neighbors are on the border
      for (unsigned rounds : {0u, 1u, 2u}) {
        const bool regular = n == TypeParam::regular_valence;
        expect_modified_about<TypeParam>(star(n, rings, TypeParam::cells), rounds,
                                         regular ? std::set<int>{} : std::set<int>{0});
      }
}

TYPED_TEST(Modified_scheme, IsTheUnmodifiedOneOnRegularMeshesAndBorders)
{
  for (const bool closed : {false, true})
    expect_modified_about<TypeParam>(test_meshes::grid(5, 4, closed, closed, TypeParam::cells), 0,
                                     {});
  expect_modified_about<TypeParam>(test_meshes::single_polygon(TypeParam::groups == 2 ? 4 : 3), 0,
                                   {});
}

// Closed meshes full of extraordinary vertices: first none is separated, then all are.
TYPED_TEST(Modified_scheme, ModifiesAllVerticesOnceTheyAreSeparated)
{
  for (int n : {3, 5, 7, 9}) {
    Control_mesh control = test_meshes::bipyramid(n);
    if (TypeParam::groups == 2) control = test_meshes::in_quads(control);
    expect_modified_about<TypeParam>(control, 0, {});
    std::set<int> extraordinary;
    const reference::Face_list list = test_meshes::face_list(control);
    for (int v = 0; v < list.number_of_vertices(); ++v)
      if (list.is_interior_of_valence_other_than(TypeParam::regular_valence, v))
        extraordinary.insert(v);
    ASSERT_GT(extraordinary.size(), 4u);
    expect_modified_about<TypeParam>(control, 1, extraordinary);
  }
}

// Neighbors along an edge, and opposite corners of a quad.
TEST(Separated_vertex, HasNoExtraordinaryNeighbor)
{
  const Control_mesh cube = named_shapes::cube();
  expect_modified_about<Quads>(cube, 0, {});
  expect_modified_about<Quads>(cube, 1, {0, 1, 2, 3, 4, 5, 6, 7});
}

// A polygon at the vertex: its first quads have an extraordinary corner in their midst.
TEST(Separated_vertex, HasQuadsOnly)
{
  for (int n : {4, 5, 7}) {
    Control_mesh control = star(n, 1, Cells::quads);
    const int added = int(control.points.size());
    control.points.push_back({3, 3, 0});
    reference::Face& face = control.faces[0]; // 0, e, f, e
    face.insert(face.begin() + 3, added);
    const reference::Face_list list = test_meshes::face_list(control);
    const std::set<int> vertex = n == 4 ? std::set<int>{} : std::set<int>{0};
    expect_modified_about<Quads>(control, 0, {});
    const int pentagon = int(reference::face_point(list, 0));
    if (n == 4) { // only the midst of the pentagon is extraordinary
      expect_modified_about<Quads>(control, 1, {pentagon});
      continue;
    }
    expect_modified_about<Quads>(control, 1, {});
    expect_modified_about<Quads>(control, 2, {0, pentagon});
  }
}

// A vertex of valence 2 within a quad at the vertex 0, whose valence becomes 5.
TEST(Separated_vertex, HasNoNeighborOfValenceTwo)
{
  Control_mesh control = star(4, 1, Cells::quads);
  const int added = int(control.points.size());
  control.points.push_back({0.4, 0.6, 0});
  const reference::Face face = control.faces[0];
  control.faces[0] = {face[0], face[1], face[2], added};
  control.faces.push_back({face[0], added, face[2], face[3]});
  ASSERT_EQ(test_meshes::face_list(control).ring(0).size(), 5u);
  expect_modified_about<Quads>(control, 0, {});
  // then the one of valence 5 is separated, that of valence 2 is never modified
  expect_modified_about<Quads>(control, 1, {0});
  expect_modified_about<Quads>(control, 2, {0});
  expect_modified_about<Quads>(star(2, 2, Cells::quads), 0, {});
}

// --- the policy: rounds and valences ---

TYPED_TEST(Modified_scheme, IsTheUnmodifiedOneBeforeItsFirstRound)
{
  using Modified = typename TypeParam::Modified;
  const Surface_mesh mesh = to_surface_mesh(star(7, 2, TypeParam::cells));
  const Eigen::MatrixXd plain = PN::subdivision_matrix(mesh, TypeParam::unmodified()),
                        modified = PN::subdivision_matrix(mesh, Modified());
  ASSERT_NE(plain, modified);
  for (const unsigned first : {1u, 2u, 5u})
    for (const unsigned round : {1u, 2u, 3u, 4u, 5u, 6u})
      EXPECT_EQ(PN::subdivision_matrix(mesh, Modified(.5, first), round).toDense(),
                round < first ? plain : modified)
        << first << ", " << round;
  EXPECT_EQ(Modified(.5, 3).first_round(), 3u);
  EXPECT_THROW(Modified(.5, 0), std::invalid_argument);
}

// Plain first rounds and the modified ones after them, call by call and in one call.
TYPED_TEST(Modified_scheme, CountsTheRoundsOfOneCall)
{
  using Modified = typename TypeParam::Modified;
  Control_mesh control = star(5, 2, TypeParam::cells);
  test_meshes::set_uneven_normals(control, 3);
  const auto rounds = [](Surface_mesh& mesh, const auto& scheme, unsigned n) {
    PN::subdivide(mesh, scheme,
                  CGAL::parameters::number_of_iterations(n).vertex_normal_map(normal_map(mesh)));
  };
  Surface_mesh one_call = to_surface_mesh(control), two_calls = to_surface_mesh(control),
               restarted = to_surface_mesh(control);
  rounds(one_call, Modified(.5, 3), 4);
  rounds(two_calls, TypeParam::unmodified(), 2);
  rounds(two_calls, Modified(), 2);
  EXPECT_TRUE(is_within(difference_by_index(result_of(one_call), result_of(two_calls)), 0));
  for (int i = 0; i < 4; ++i) rounds(restarted, Modified(.5, 3), 1);
  EXPECT_FALSE(is_within(difference_by_index(result_of(one_call), result_of(restarted)), 1e-6));
}

TYPED_TEST(Modified_scheme, LeavesValencesOfBoundedCurvatureAloneIfAsked)
{
  using Modified = typename TypeParam::Modified;
  const auto left_alone =
    TypeParam::groups == 2 ? std::set<int>{3} : std::set<int>{4, 5}; // as in the paper
  for (const int n : {3, 4, 5, 6, 7, 9}) {
    if (n == TypeParam::regular_valence) continue;
    const Matrix m = ring_matrix<TypeParam>(n, Modified(.3, 1, PN::Tuned_valences::diverging));
    const Matrix expected = left_alone.count(n) != 0
                              ? ring_matrix<TypeParam>(n, TypeParam::unmodified())
                              : ring_matrix<TypeParam>(n, Modified(.3));
    EXPECT_EQ(m, expected) << n;
    EXPECT_NE(ring_matrix<TypeParam>(n, TypeParam::unmodified()),
              ring_matrix<TypeParam>(n, Modified(.3)));
  }
  const Modified paper = Modified::of_the_paper();
  EXPECT_EQ(paper.first_round(), 2u);
  EXPECT_EQ(paper.valences(), PN::Tuned_valences::diverging);
}

// A vertex that is left alone keeps its neighbors from being separated all the same.
TEST(Modified_CatmullClark, SeparatesVerticesAlsoFromThoseLeftAlone)
{
  Control_mesh control = test_meshes::in_quads(test_meshes::bipyramid(7));
  test_meshes::set_uneven_normals(control, 1);
  const Surface_mesh mesh = to_surface_mesh(control);
  EXPECT_EQ(
    PN::subdivision_matrix(mesh, PN::CatmullClark_scheme()).toDense(),
    PN::subdivision_matrix(mesh, PN::CatmullClark_scheme::Tuned::of_the_paper(), 2).toDense());
}

// --- transfer of curvature on meshes with creases ---

// Far from a crease all is as without it; a vertex on one has no ring of its own.
TEST(Transfer_of_curvature, IsTheSameBesideCreases)
{
  for (const bool quads : {true, false}) {
    Control_mesh control = star(5, 4, quads ? Cells::quads : Cells::triangles);
    test_meshes::set_uneven_normals(control, 9);
    const auto refined = [&](bool creased, unsigned rounds, bool at_the_vertex) {
      Surface_mesh mesh = to_surface_mesh(control);
      auto sharp = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:sharp", false).first;
      const auto middle = Surface_mesh::Vertex_index(0);
      if (creased)
        for (const auto e : mesh.edges()) {
          const bool is_at = mesh.vertex(e, 0) == middle || mesh.vertex(e, 1) == middle;
          const bool is_outer =
            mesh.is_border(mesh.vertex(e, 0)) != mesh.is_border(mesh.vertex(e, 1));
          sharp[e] = at_the_vertex ? is_at : is_outer;
        }
      const auto np = CGAL::parameters::number_of_iterations(rounds)
                        .vertex_normal_map(normal_map(mesh))
                        .edge_is_constrained_map(sharp);
      if (quads)
        PN::subdivide(mesh, PN::CatmullClark_scheme::Transfer(), np);
      else
        PN::subdivide(mesh, PN::Loop_scheme::Transfer(), np);
      return result_of(mesh).values;
    };
    const auto plain = refined(false, 2, false), beside = refined(true, 2, false),
               through = refined(true, 2, true);
    const auto star_mesh = test_meshes::face_list(control);
    // new values next to the middle: the vertex and its first edges
    EXPECT_EQ(plain.points[0], beside.points[0]);
    EXPECT_EQ(plain.normals[0], beside.normals[0]);
    for (const int u : star_mesh.ring(0)) {
      EXPECT_EQ(plain.points[std::size_t(u)], beside.points[std::size_t(u)]) << u;
      EXPECT_EQ(plain.normals[std::size_t(u)], beside.normals[std::size_t(u)]) << u;
    }
    EXPECT_NE(plain.points[0], through.points[0]);
    // at the vertex the rules are those of a corner, and nothing is transferred
    EXPECT_EQ(through.points[0],
              reference::Vector(control.points[0][0], control.points[0][1], control.points[0][2]));
  }
}

// the weights of a scheme that transfers curvature, and no transfer
template <class Scheme>
struct Without_transfer : Scheme
{
  static constexpr bool transfers_curvature = false;
};

// The new vertices of a ring are computed some at a time. About a vertex of revolution the normals of all are turned by the same
// angle.
template <class Scheme>
void expect_transfer_to_all(int n, Cells cells)
{
  Control_mesh control = star(n, 4, cells);
  control.normals.clear();
  for (auto& p : control.points) {
    p[2] = -0.05 * (p[0] * p[0] + p[1] * p[1]);
    const double length = std::hypot(0.2 * p[0], 0.2 * p[1], 1);
    control.normals.push_back({0.2 * p[0] / length, 0.2 * p[1] / length, 1 / length});
  }
  const auto heights_of_normals = [&](const auto& scheme) {
    Surface_mesh mesh = to_surface_mesh(control);
    const auto normals = normal_map(mesh);
    PN::subdivide(mesh, scheme, CGAL::parameters::vertex_normal_map(normals));
    std::vector<double> heights;
    for (const auto v :
         CGAL::vertices_around_target(mesh.halfedge(Surface_mesh::Vertex_index(0)), mesh))
      heights.push_back(normals[v].z());
    return heights;
  };
  const auto with = heights_of_normals(Scheme()),
             without = heights_of_normals(Without_transfer<Scheme>());
  const double turn = with[0] - without[0];
  EXPECT_GT(std::abs(turn), 1e-6);
  for (std::size_t i = 0; i < with.size(); ++i)
    EXPECT_NEAR(with[i] - without[i], turn, 1e-6 * std::abs(turn)) << i;
}

TEST(Transfer_of_curvature, TurnsAllNormalsOfALargeRing)
{
  expect_transfer_to_all<PN::CatmullClark_scheme::Transfer>(150, Cells::quads);
  expect_transfer_to_all<PN::Loop_scheme::Transfer>(150, Cells::triangles);
}

// --- weights ---

TYPED_TEST(Modified_scheme, EqualsTheReferenceForAllCapsAndValences)
{
  double difference = 0;
  for (int n : {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 20, 31, 32, 33, 64}) {
    if (n == TypeParam::regular_valence) continue;
    for (double cap : {0.5, 1., 0.9, 0.25, 1e-3}) {
      if (n > 20 && cap != 0.5) continue;
      const Matrix m = ring_matrix<TypeParam>(n, typename TypeParam::Modified(cap));
      const double d = largest(m - TypeParam::ring(n, Real(cap)));
      EXPECT_LE(d, 1e-15) << "valence " << n << ", cap " << cap;
      difference = (std::max)(difference, d);
    }
  }
  std::cout << "largest difference " << difference << '\n';
}

// No eigenvalue of Loop's matrix exceeds the bound for valence 5 and cap 1.
TEST(Modified_Loop, IsTheUnmodifiedOneIfTheCapBindsNothing)
{
  EXPECT_LE(largest(ring_matrix<Triangles>(5, PN::Loop_scheme::Tuned(1)) -
                    ring_matrix<Triangles>(5, PN::Loop_scheme())),
            2e-16);
  EXPECT_GT(largest(ring_matrix<Triangles>(5, PN::Loop_scheme::Tuned(0.99)) -
                    ring_matrix<Triangles>(5, PN::Loop_scheme())),
            1e-4);
}

// Fractions by hand: kappa = 1 for n = 3, 56/55 for n = 4.
TEST(Modified_Loop, HasExactRationalRowsForValences3And4)
{
  using Q = CGAL::Gmpq;
  using Rows = std::vector<std::vector<Q>>;
  const Rows three = ring_of<Q, Triangles>(3, PN::Loop_scheme::Tuned());
  EXPECT_EQ(three[0], (std::vector<Q>{Q(7, 16), Q(3, 16), Q(3, 16), Q(3, 16)}));
  EXPECT_EQ(three[1], (std::vector<Q>{Q(3, 8), Q(13, 24), Q(1, 24), Q(1, 24)}));
  const Rows four = ring_of<Q, Triangles>(4, PN::Loop_scheme::Tuned());
  const Q neighbor = Q(31, 64) * Q(56, 55) / Q(4);
  EXPECT_EQ(four[0],
            (std::vector<Q>{Q(1) - Q(4) * neighbor, neighbor, neighbor, neighbor, neighbor}));
  const Q rest = Q(1) - Q(3, 8) * Q(56, 55), eighth(1, 8);
  EXPECT_EQ(four[1], (std::vector<Q>{Q(3, 8) * Q(56, 55), (rest + Q(1) + eighth) / Q(4),
                                     (rest - eighth) / Q(4), (rest - Q(1) + eighth) / Q(4),
                                     (rest - eighth) / Q(4)}));
}

// The vertex of valence 3: (6 + C)/16 for itself, 1/6 for each neighbor, whatever the cap C.
TEST(Modified_CatmullClark, HasAnExactRationalMeanForValence3)
{
  using Q = CGAL::Gmpq;
  for (double cap : {0.5, 0.1}) {
    const auto rows = ring_of<Q, Quads>(3, PN::CatmullClark_scheme::Tuned(cap));
    const Q sixth(1, 6), own = (Q(6) + Q(cap)) / Q(16), outer = (Q(1, 2) - own) / Q(3);
    EXPECT_EQ(rows[0], (std::vector<Q>{own, sixth, sixth, sixth, outer, outer, outer})) << cap;
  }
  const auto rows = ring_of<Q, Quads>(3, PN::CatmullClark_scheme::Tuned());
  for (std::size_t i : {1u, 2u, 3u})
    EXPECT_LE(std::abs(CGAL::to_double(rows[i][0] - Q(3, 8))), 1e-16);
  for (std::size_t i : {4u, 5u, 6u})
    EXPECT_LE(std::abs(CGAL::to_double(rows[i][0] - Q(9, 32))), 1e-16);
}

// --- sums ---

template <class FT, class Kind>
void expect_rows_that_sum_to_one(const std::vector<int>& valences)
{
  for (int n : valences) {
    Surface_mesh mesh = to_surface_mesh(star(n, 1, Kind::cells));
    for (double cap : {0.5, 0.3})
      ::expect_rows_that_sum_to_one<FT>(mesh, typename Kind::Modified(cap), 1,
                                        "valence " + std::to_string(n));
  }
}

TYPED_TEST(Modified_scheme, RowsSumToOneForAllValences)
{
  std::vector<int> valences;
  for (int n = 3; n <= 70; ++n) valences.push_back(n);
  valences.insert(valences.end(), {127, 256, 1000});
  expect_rows_that_sum_to_one<double, TypeParam>(valences);
  expect_rows_that_sum_to_one<float, TypeParam>(valences);
  expect_rows_that_sum_to_one<long double, TypeParam>(valences);
  expect_rows_that_sum_to_one<CGAL::Gmpq, TypeParam>({3, 4, 5, 7, 8, 13, 64});
}

// --- interface ---

TEST(Modified_schemes, RefuseACapOutsideOfZeroToOne)
{
  for (double cap : {0., -0.5, 1.0001, std::numeric_limits<double>::quiet_NaN(),
                     std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(PN::CatmullClark_scheme::Tuned{cap}, std::invalid_argument) << cap;
    EXPECT_THROW(PN::Loop_scheme::Tuned{cap}, std::invalid_argument) << cap;
  }
  messages::expect_refused([&] { PN::Loop_scheme::Tuned scheme(2); }, {"cap"});
  EXPECT_NO_THROW(PN::Loop_scheme::Tuned(1));
  EXPECT_NO_THROW(PN::CatmullClark_scheme::Tuned(1e-300));
}

} // namespace
