// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Limit masks and estimates against what is known of them: the masks of the literature, how well the
// point-normal average of a limit mask does, how errors fall, curvature.

#include "Curved_surfaces.h"
#include "Extent.h"
#include "Limit_cases.h"
#include "Schemes.h"
#include "reference/Limit.h"
#include "support/Options.h"

#include "../../examples/PN_limit_surface_3/Extraordinary_data.h"
#include "analysis/Extraordinary_net.h"
#include "analysis/extraordinary_curvature.h"

namespace {

using namespace limit_cases;
using reference::Real;
using reference::Row;
using reference::Vector;
using test_meshes::Cells;
using test_meshes::Control_mesh;

// --- masks ---

// The weights of the limit mask of vertex v: the limit points of the linear scheme on unit vectors,
// three at a time.
template <class Scheme>
std::vector<double> mask_at(const Control_mesh& control, const Scheme& scheme, int v)
{
  std::vector<double> weights(control.points.size());
  for (std::size_t first = 0; first < weights.size(); first += 3) {
    Control_mesh units = control;
    units.points.assign(weights.size(), {0, 0, 0});
    for (std::size_t k = 0; k < 3 && first + k < weights.size(); ++k)
      units.points[first + k][k] = 1;
    units.normals.assign(weights.size(), {0, 0, 0});
    Surface_mesh mesh = to_surface_mesh(units);
    const Limits all = limits(mesh, PN::linear(scheme), test_options::Limit_options());
    const Kernel::Point_3& p = all.at[std::size_t(v)].point;
    for (std::size_t k = 0; k < 3 && first + k < weights.size(); ++k)
      weights[first + k] = p[int(k)];
  }
  return weights;
}

// of the vertex, its neighbors, the other vertices of its faces
struct Mask
{
  double vertex, neighbor, diagonal;
};

// of vertex 0 of a star, all its neighbors alike
void expect_mask(const std::vector<double>& weights, const Control_mesh& control, const Mask& mask,
                 const std::string& what)
{
  const reference::Face_list list = test_meshes::face_list(control);
  const std::vector<int> ring = list.ring(0);
  std::vector<double> expected(weights.size(), 0.);
  expected[0] = mask.vertex;
  for (int w : ring) {
    expected[std::size_t(w)] = mask.neighbor;
    const int diagonal = list.after(0, w);
    if (std::find(ring.begin(), ring.end(), diagonal) == ring.end())
      expected[std::size_t(diagonal)] = mask.diagonal;
  }
  for (std::size_t i = 0; i < weights.size(); ++i)
    EXPECT_NEAR(weights[i], expected[i], 1e-15) << what << ", vertex " << i;
}

// Halstead, Kass and DeRose 1993 for Catmull-Clark; Loop 1987; Kobbelt 2000 for sqrt(3): the fixed
// point of (1 - alpha, alpha) on the vertex and the mean of its neighbors, which all schemes with
// such rows share, solved for here.
TEST(Limit_masks, AreThoseOfTheLiterature)
{
  for (const int n : {3, 4, 5, 6, 7, 9, 12}) {
    const std::string what = "valence " + std::to_string(n);
    const Control_mesh quads = test_meshes::star(n, 2, Cells::quads);
    const Mask halstead{n / (n + 5.), 4. / (n * (n + 5.)), 1. / (n * (n + 5.))};
    expect_mask(mask_at(quads, PN::CatmullClark_scheme(), 0), quads, halstead, what);
    expect_mask(mask_at(quads, PN::CatmullClark_scheme::Tuned(), 0), quads, halstead, what);

    const Control_mesh triangles = test_meshes::star(n, 2, Cells::triangles);
    const double c = std::cos(2 * std::acos(-1.) / n);
    // the mean m of the neighbors goes to 3/8 v + 5/8 m, v to (1 - alpha) v + alpha m
    const double alpha = 5. / 8 - (3 + 2 * c) * (3 + 2 * c) / 64;
    const double loop = alpha / (3. / 8 + alpha);
    expect_mask(mask_at(triangles, PN::Loop_scheme(), 0), triangles, {1 - loop, loop / n, 0}, what);
    expect_mask(mask_at(triangles, PN::Loop_scheme::Tuned(), 0), triangles, {1 - loop, loop / n, 0},
                what);
    // the mean goes to 1/3 v + 2/3 m
    const double beta = (4 - 2 * c) / 9;
    const double sqrt3 = beta / (1. / 3 + beta);
    expect_mask(mask_at(triangles, PN::Sqrt3_scheme(), 0), triangles, {1 - sqrt3, sqrt3 / n, 0},
                what);
    expect_mask(mask_at(triangles, PN::Butterfly_scheme(), 0), triangles, {1, 0, 0}, what);
    expect_mask(mask_at(quads, PN::Kobbelt_scheme(), 0), quads, {1, 0, 0}, what);
  }
}

// a cubic B-spline curve, at corners too; sqrt(3) has the ternary one
TEST(Limit_masks, OfTheBorderAreThoseOfTheCubicBSpline)
{
  const auto expect_border = [](const Control_mesh& control, const auto& scheme) {
    const reference::Face_list list = test_meshes::face_list(control);
    for (int v = 0; v < list.number_of_vertices(); ++v) {
      if (!list.is_border(v)) continue;
      const std::vector<double> weights = mask_at(control, scheme, v);
      const std::vector<int> ring = list.ring(v);
      for (int w = 0; w < list.number_of_vertices(); ++w) {
        const double expected = w == v                                  ? 4. / 6
                                : w == ring.front() || w == ring.back() ? 1. / 6
                                                                        : 0;
        EXPECT_NEAR(weights[std::size_t(w)], expected, 1e-15) << "vertex " << v << " of " << w;
      }
    }
  };
  expect_border(test_meshes::grid(3, 2, false, false, Cells::quads), PN::CatmullClark_scheme());
  const Control_mesh triangles = test_meshes::grid(3, 2, false, false, Cells::triangles);
  expect_border(triangles, PN::Loop_scheme());
  expect_border(triangles, PN::Sqrt3_scheme());
}

// after an odd round no face has two border edges, and an even round refuses them
TEST(Limit_masks, OfCornersBeforeAnEvenRoundAreRefused)
{
  test_options::Limit_options after_one;
  after_one.rounds_done = 1;
  for (Control_mesh control :
       {test_meshes::single_polygon(3), test_meshes::grid(3, 2, false, false, Cells::triangles)}) {
    test_meshes::set_uneven_normals(control, 2);
    Surface_mesh mesh = to_surface_mesh(control);
    EXPECT_NO_THROW(limits(mesh, PN::Sqrt3_scheme(), test_options::Limit_options()))
      << control.name;
    EXPECT_THROW(limits(mesh, PN::Sqrt3_scheme(), after_one), std::invalid_argument)
      << control.name;
  }
}

// --- the point-normal average of the limit mask ---

using extraordinary_data::Values;

Control_mesh control_mesh(const PN::Extraordinary_net& net, const Values& values)
{
  Control_mesh control{"net", {}, {}};
  for (const auto& v : values) {
    control.points.push_back(v.point);
    control.normals.push_back(v.normal);
  }
  for (const auto& [s, corners] : net.faces()) {
    control.faces.emplace_back();
    for (const auto& [i, j] : corners) control.faces.back().push_back(int(net.vertex(s, i, j)));
  }
  return control;
}

// L and the linear average of the mask of Halstead et al. or Loop at vertex 0
struct Averages
{
  Vector pn, linear;
};
Averages averages(Surface_mesh& mesh, int degree)
{
  const Result data = result_of(mesh);
  const reference::Face_list list = face_list(mesh);
  const std::vector<int> ring = list.ring(0);
  const Real n = Real(ring.size());
  Row mask = list.zero();
  if (degree == 4) {
    mask[0] = n / (n + 5);
    for (int w : ring) {
      mask[w] += 4 / (n * (n + 5));
      mask[list.after(0, w)] += 1 / (n * (n + 5));
    }
  } else {
    const Real a = 3 + 2 * reference::cosine(1 / n), alpha = Real(5) / 8 - a * a / 64;
    const Real b = alpha / (Real(3) / 8 + alpha);
    mask[0] = 1 - b;
    for (int w : ring) mask[w] += b / n;
  }
  Vector linear = Vector::Zero();
  for (Eigen::Index i = 0; i < mask.size(); ++i)
    linear += mask[i] * data.values.points[std::size_t(i)];
  return {reference::new_value(mask, data.values, false).point, linear};
}

struct Gain
{
  double logarithm = 0;
  int count = 0;
  double mean() const { return std::exp(logarithm / count); }
};

// Over valences and data: what the average gains over the linear one at levels 0 and 2 (B8), and that
// the distance of two levels' averages tells the error (B9).
template <class Scheme>
void measure_averages(const Scheme& scheme, int degree, std::initializer_list<int> valences,
                      Gain (&gain)[3])
{
  for (const int n : valences)
    for (const auto& set : extraordinary_data::curved()) {
      if (set.name != "cubic" && set.name != "ellipsoid" && set.name != "bicubic" &&
          set.name != "rough")
        continue;
      const PN::Extraordinary_net net(PN::Extraordinary_net::Index(degree),
                                      PN::Extraordinary_net::Index(n), 4);
      Surface_mesh mesh = to_surface_mesh(control_mesh(net, set.values(net)));
      const Limits exact = limits(mesh, scheme, close(1e-15));
      const Vector limit = to_vector(exact.at[0].point);
      Vector last = Vector::Zero();
      double last_error = 0;
      for (int level = 0; level <= 2; ++level) {
        const Averages l = averages(mesh, degree);
        const double error = double((l.pn - limit).norm());
        if (level != 0 && last_error > 1e-12) {
          EXPECT_LE(last_error, 1.5 * double((l.pn - last).norm()))
            << set.name << ", valence " << n << ", level " << level;
        }
        if (set.name != "rough" && error > 1e-14) {
          gain[level].logarithm += std::log(double((l.linear - limit).norm()) / error);
          ++gain[level].count;
        }
        last = l.pn;
        last_error = error;
        PN::subdivide(mesh, scheme, CGAL::parameters::vertex_normal_map(normal_map(mesh)));
      }
    }
}

TEST(Limit_averages, GainOverTheLinearMaskAndTellTheirErrors)
{
  Gain gain[3];
  measure_averages(PN::CatmullClark_scheme(), 4, {3, 4, 5, 6, 8}, gain);
  measure_averages(PN::CatmullClark_scheme::Tuned(), 4, {3, 5, 6, 8}, gain);
  measure_averages(PN::Loop_scheme(), 3, {4, 5, 6, 7, 8}, gain);
  measure_averages(PN::Loop_scheme::Tuned(), 3, {3, 4, 5, 7, 8}, gain);
  RecordProperty("level_0", std::to_string(gain[0].mean()));
  RecordProperty("level_2", std::to_string(gain[2].mean()));
  EXPECT_GE(gain[0].mean(), 300);
  EXPECT_GE(gain[2].mean(), 3000);
}

// What is reported is no less than the error, and not much more, whatever the tolerance.
template <class Scheme>
void expect_honest_estimates(const Scheme& scheme, const Control_mesh& control)
{
  Surface_mesh mesh = to_surface_mesh(control);
  const Limits exact = limits(mesh, scheme, close(1e-15));
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const Limits rough = limits(mesh, scheme, close(tolerance));
    EXPECT_TRUE(rough.report.is_within_tolerance());
    double largest = 0;
    for (std::size_t v = 0; v < exact.at.size(); ++v) {
      const double error = std::sqrt(CGAL::squared_distance(rough.at[v].point, exact.at[v].point));
      EXPECT_LE(error, rough.at[v].error + 1e-14) << control.name << ", vertex " << v;
      EXPECT_LE(rough.at[v].error, rough.report.error);
      EXPECT_LE(rough.at[v].error, rough.report.tolerance);
      largest = (std::max)(largest, error);
    }
    EXPECT_GT(largest, 1e-4 * rough.report.error);
  }
}

TEST(Limit_estimates, AreNoLessThanTheErrors)
{
  for (const Control_mesh& control : test_meshes::all()) {
    if (test_meshes::has_isolated_vertex(control)) continue;
    if (!test_meshes::is_closed(control)) continue;
    expect_honest_estimates(PN::CatmullClark_scheme(), control);
    expect_honest_estimates(PN::CatmullClark_scheme::Tuned(), control);
    expect_honest_estimates(PN::CatmullClark_scheme::Transfer(), control);
    if (!test_meshes::all_faces_have_degree(control, 3)) continue;
    expect_honest_estimates(PN::Loop_scheme(), control);
    expect_honest_estimates(PN::Loop_scheme::Tuned(), control);
    expect_honest_estimates(PN::Loop_scheme::Transfer(), control);
    expect_honest_estimates(PN::Sqrt3_scheme(), control);
  }
}

TEST(Limit_estimates, SayWhereTheToleranceIsMissed)
{
  Surface_mesh mesh = to_surface_mesh(test_meshes::all()[0]);
  test_options::Limit_options options;
  options.tolerance = 0;
  options.max_depth = 3;
  const Limits all = limits(mesh, PN::Loop_scheme(), options);
  EXPECT_FALSE(all.report.is_within_tolerance());
  EXPECT_EQ(all.report.depth, 3u);
  EXPECT_GT(all.report.error, 0);
}

// --- surface normals ---

// The error of a surface normal without further rounds falls by lambda^2 from level to level.
template <class Scheme>
void expect_normal_rate(const Scheme& scheme, int degree, int valence, double lambda)
{
  const PN::Extraordinary_net net(PN::Extraordinary_net::Index(degree),
                                  PN::Extraordinary_net::Index(valence), 4);
  Values values =
    extraordinary_data::turned(extraordinary_data::sampled(net, extraordinary_data::cubic));
  Surface_mesh mesh = to_surface_mesh(control_mesh(net, values));
  const Limits exact = limits(mesh, scheme, close(1e-9, 1e-10));
  ASSERT_TRUE(exact.at[0].has_surface_normal);
  test_options::Limit_options once = close(1, HUGE_VAL);
  once.max_depth = 1;
  double error[5];
  for (double& e : error) {
    const Limits now = limits(mesh, scheme, once);
    e = std::sqrt((now.at[0].surface_normal - exact.at[0].surface_normal).squared_length());
    PN::subdivide(mesh, scheme, CGAL::parameters::vertex_normal_map(normal_map(mesh)));
  }
  EXPECT_NEAR(std::pow(error[4] / error[1], 1. / 3), lambda * lambda, 0.15 * lambda * lambda)
    << "valence " << valence << ": " << error[0] << " " << error[4];
  // and the control normal is another
  EXPECT_GT((exact.at[0].control_normal - exact.at[0].surface_normal).squared_length(), 1e-10);
}

double catmull_clark_lambda(int n)
{
  const double c = std::cos(2 * std::acos(-1.) / n);
  return (5 + c + std::sqrt((c + 1) * (c + 9))) / 16;
}

TEST(Surface_normals, HaveErrorsThatFallByTheSquareOfLambda)
{
  for (const int n : {4, 5, 6, 8}) {
    expect_normal_rate(PN::CatmullClark_scheme(), 4, n, catmull_clark_lambda(n));
    if (n != 4) expect_normal_rate(PN::CatmullClark_scheme::Tuned(), 4, n, catmull_clark_lambda(n));
  }
  for (const int n : {5, 6, 7, 8})
    expect_normal_rate(PN::Loop_scheme(), 3, n, 3. / 8 + std::cos(2 * std::acos(-1.) / n) / 4);
}

// A border vertex between some faces, with a few rings around it, on an uneven surface with normals that
// are not quite its own.
Control_mesh at_border(int degree, int faces)
{
  using Index = PN::Extraordinary_net::Index;
  const PN::Extraordinary_net net(Index(degree), Index((std::max)(3, 2 * faces)), 5);
  Control_mesh control{std::to_string(faces) + " faces", {}, {}};
  std::map<Index, int> number;
  const auto corner = [&](Index s, Index i, Index j) {
    const auto [at, is_new] = number.emplace(net.vertex(s, i, j), int(number.size()));
    if (is_new) {
      const double angle = std::acos(-1.) / (std::max)(faces, 2), a = angle * s,
                   b = angle * (s + 1);
      const double shift = .02 * std::sin(3. * at->second);
      const double x = .3 * (i * std::cos(a) + j * std::cos(b)) + shift;
      const double y = .3 * (i * std::sin(a) + j * std::sin(b)) - shift;
      control.points.push_back({x, y, .3 * x * x - .2 * x * y + .25 * y * y + .2 * x + 3 * shift});
      control.normals.push_back(
        test_meshes::unit({-(.6 * x - .2 * y + .2) + 2 * shift, .2 * x - .5 * y - shift, 1}));
    }
    return at->second;
  };
  corner(0, 0, 0);
  for (const auto& [s, corners] : net.faces()) {
    if (int(s) >= faces) continue;
    control.faces.emplace_back();
    for (const auto& [i, j] : corners) control.faces.back().push_back(corner(s, i, j));
  }
  return control;
}

// Where the normals of all faces at the vertex tend to one, that is the surface's; elsewhere none is
// claimed. What is reported is no less than the error.
template <class Description>
void expect_border_normals(int degree, const std::vector<int>& faces_with_normals)
{
  for (int faces = 1; faces <= (tests_are_full ? 8 : 4); ++faces) {
    const Control_mesh control = at_border(degree, faces);
    Surface_mesh mesh = to_surface_mesh(control);
    const std::string what = std::string(Description::scheme().name()) + ", " + control.name;
    const bool has_normal = std::find(faces_with_normals.begin(), faces_with_normals.end(),
                                      faces) != faces_with_normals.end();
    const Limits fine = limits(mesh, Description::scheme(), close(1e-9, 1e-9));
    EXPECT_EQ(fine.at[0].has_surface_normal, has_normal) << what;
    for (const bool linear : {false, true}) {
      const reference::Limit expected = brute_force<Description>(control, 0, linear);
      const bool tends_to_plane =
        expected.normal_spread < .3L * expected.earlier_spread + 1e-12L && expected.turn < 6;
      // between the two halves of a smooth border a corner is a cusp: it has a plane of second order only
      if (faces != 1 || has_normal) {
        EXPECT_EQ(tends_to_plane, has_normal)
          << what << ": " << expected.normal_spread << " after " << expected.earlier_spread
          << ", turn " << expected.turn;
      }
      if (!has_normal) continue;
      const Vector normal = to_vector(
        linear ? limits(mesh, PN::linear(Description::scheme()), close(1e-9)).at[0].surface_normal
               : fine.at[0].surface_normal);
      EXPECT_LE(double((normal - expected.surface_normal).norm()),
                1e-7 + 2 * double(expected.normal_change))
        << what << ", " << expected.normal_change;
    }
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      const Limit rough = limits(mesh, Description::scheme(), close(1, tolerance)).at[0];
      if (!rough.has_surface_normal) continue;
      EXPECT_LE(rough.normal_error, tolerance);
      EXPECT_LE(std::sqrt((rough.surface_normal - fine.at[0].surface_normal).squared_length()),
                rough.normal_error + 2e-9)
        << what;
    }
  }
}

TEST(Surface_normals, OfBordersAreThoseThatFacesTendTo)
{
  expect_border_normals<CatmullClark_description>(4, {2, 3});
  expect_border_normals<Loop_description>(3, {2, 3, 4, 5});
  expect_border_normals<Sqrt3_description>(3, {2, 3, 4, 5});
  if (!tests_are_full) return; // as the others
  expect_border_normals<Butterfly_description>(3, {2, 3});
  expect_border_normals<Kobbelt_description>(4, {1, 2});
}

// A border vertex of sqrt(3) in the middle of a call, where one more triangle is at it.
TEST(Surface_normals, OfBordersOfSqrt3ContinueTheCall)
{
  for (int faces = 1; faces <= 5; ++faces) {
    Surface_mesh mesh = to_surface_mesh(at_border(3, faces));
    const Limits base = limits(mesh, PN::Sqrt3_scheme(), close(1e-9, 1e-8));
    for (unsigned rounds = 1; rounds <= 2; ++rounds) {
      mesh = to_surface_mesh(at_border(3, faces));
      PN::subdivide(
        mesh, PN::Sqrt3_scheme(),
        CGAL::parameters::number_of_iterations(rounds).vertex_normal_map(normal_map(mesh)));
      test_options::Limit_options options = close(1e-9, 1e-8);
      options.rounds_done = rounds;
      const Limit l = limits(mesh, PN::Sqrt3_scheme(), options).at[0];
      EXPECT_EQ(l.has_surface_normal, faces > 1);
      EXPECT_EQ(base.at[0].has_surface_normal, faces > 1);
      if (faces == 1) continue;
      EXPECT_LE(std::sqrt((l.surface_normal - base.at[0].surface_normal).squared_length()), 3e-8)
        << faces << " faces, " << rounds << " rounds";
    }
  }
}

// Normals drown in the rounding of small rings; what is returned is one from before.
TEST(Surface_normals, AreTheBestOnesIfTheToleranceIsOutOfReach)
{
  for (const int faces : {2, 3}) {
    Surface_mesh mesh = to_surface_mesh(at_border(4, faces));
    const Limit fine = limits(mesh, PN::CatmullClark_scheme(), close(1e-9, 1e-9)).at[0];
    test_options::Limit_options never = close(0, 0);
    never.max_depth = 60;
    const Limits best = limits(mesh, PN::CatmullClark_scheme(), never);
    EXPECT_FALSE(best.report.is_within_tolerance());
    EXPECT_LE(best.at[0].normal_error, 1e-10);
    EXPECT_LE(std::sqrt((best.at[0].surface_normal - fine.surface_normal).squared_length()), 2e-9);
  }
}

// --- curvature ---

TEST(Limit_curvature, IsThatOfSpheresAndCylinders)
{
  for (const bool sphere : {true, false}) {
    const auto sampled =
      curved_surfaces::lay(curved_surfaces::square(6, curved_surfaces::Faces::quads, 0.2),
                           sphere ? curved_surfaces::sphere : curved_surfaces::cylinder);
    Control_mesh control{"samples", sampled.soup.points, {}};
    for (const auto& f : sampled.soup.faces) control.faces.emplace_back(f.begin(), f.end());
    for (const auto& e : sampled.exact) control.normals.push_back(e.normal);
    Surface_mesh mesh = to_surface_mesh(control);
    test_options::Limit_options options;
    options.curvatures = true;
    const Limits all = limits(mesh, PN::CatmullClark_scheme(), options);
    int count = 0;
    for (const Limit& l : all.at) {
      if (!l.has_curvature) continue;
      ++count;
      EXPECT_NEAR(l.gaussian, sphere ? 0.25 : 0, 3e-3);
      EXPECT_NEAR(l.mean, sphere ? 0.5 : 0.25, 3e-3);
    }
    EXPECT_EQ(count, 25);
  }
}

// at an extraordinary vertex: what its zoom measures eighteen rings deep
TEST(Limit_curvature, OfModifiedSchemesIsWhatRingsTendTo)
{
  const auto expect_curvature = [](const auto& scheme, int n) {
    const PN::Extraordinary_vertex_zoom<std::decay_t<decltype(scheme)>> zoom(
      scheme, PN::Extraordinary_net::Index(n));
    const Values values = extraordinary_data::turned(
      extraordinary_data::sampled(zoom.net(), extraordinary_data::saddle));
    const auto measured = zoom.measure(values, 18);
    Surface_mesh mesh = to_surface_mesh(control_mesh(zoom.net(), values));
    test_options::Limit_options options = close(1e-12, 1e-6);
    options.curvatures = true;
    const Limits all = limits(mesh, scheme, options);
    ASSERT_TRUE(all.at[0].has_curvature) << n;
    const auto& ring = measured.rings.back();
    EXPECT_NEAR(all.at[0].gaussian, (ring.gaussian_min + ring.gaussian_max) / 2,
                .01 * ring.scale());
    EXPECT_NEAR(all.at[0].mean, (ring.mean_min + ring.mean_max) / 2, .01 * std::sqrt(ring.scale()));
  };
  for (const int n : {3, 5, 8}) expect_curvature(PN::CatmullClark_scheme::Tuned(), n);
  for (const int n : {4, 7, 9}) expect_curvature(PN::Loop_scheme::Tuned(), n);
}

TEST(Limit_curvature, IsNotClaimedWhereItDoesNotSettle)
{
  const PN::Extraordinary_net net(4, 5, 4);
  Surface_mesh mesh =
    to_surface_mesh(control_mesh(net, extraordinary_data::sampled(net, extraordinary_data::cubic)));
  test_options::Limit_options options;
  options.curvatures = true;
  EXPECT_FALSE(limits(mesh, PN::CatmullClark_scheme(), options).at[0].has_curvature);
  EXPECT_FALSE(limits(mesh, PN::Kobbelt_scheme(), options).at[1].has_curvature);
}

} // namespace
