// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Certificates: one round from rational points and normals on a sphere or cylinder ends exactly on
// it, in every scheme. As the result is again of this kind, so do all further rounds.

#include "One_root_number.h"
#include "Rational_shapes.h"
#include "Scheme_runs.h"
#include "Schemes.h"

namespace {

namespace PN = CGAL::PN_subdivision_3;
using rational_shapes::Shape;
using test_meshes::Control_mesh;

using Number = One_root_number;

using Exact_control = rational_shapes::Samples<One_root_kernel>;

std::size_t number_of_vertices_off(const Exact_control& exact)
{
  std::size_t off = 0;
  for (auto v : exact.mesh.vertices()) {
    const auto& p = exact.mesh.point(v);
    const auto& n = exact.normals[v];
    off += !rational_shapes::is_exactly_on<Number>(exact.shape, {p.x(), p.y(), p.z()},
                                                   {n.x(), n.y(), n.z()});
  }
  return off;
}

// The rows of a scheme and no more, the first round being number 1 + `rounds_before`.
template <class Host_, unsigned rounds_before>
struct Host_of_rows : Host_
{
  Host_of_rows(const PN::Level_connectivity& level, unsigned round)
    : Host_(level, round + rounds_before)
  {}
  static PN::Level_size refined_size(const PN::Level_size& size, unsigned round)
  {
    return Host_::refined_size(size, round + rounds_before);
  }
};

template <class Scheme, unsigned rounds_before = 0>
struct Scheme_of_rows
{
  using Host = Host_of_rows<typename Scheme::Host, rounds_before>;

  template <class FT>
  auto mask(const PN::Level_connectivity& level, unsigned round) const
  {
    return scheme.template mask<FT>(level, round + rounds_before);
  }
  template <class Element_names>
  void check(const PN::Level_connectivity& level, const Element_names& names) const
  {
    PN::internal::check_scheme(scheme, level, names);
  }

  Scheme scheme;
};

// The mesh after one linear round: its points are not used but as directions.
template <class Description>
Control_mesh refined_once(const Control_mesh& control)
{
  Surface_mesh mesh = to_surface_mesh(control);
  refine_linearly<Description>(mesh, 1);
  const Result result = result_of(mesh);
  Control_mesh refined{control.name + ", refined", {}, result.faces};
  for (const auto& p : result.values.points)
    refined.points.push_back({double(p[0]), double(p[1]), double(p[2])});
  return refined;
}

// Control meshes of all classes, and once refined ones: there the extraordinary vertices are
// separated, and the border of sqrt(3) is as its second round wants it.
template <class Description>
std::vector<Control_mesh> refined_meshes_for()
{
  std::vector<Control_mesh> result;
  for (const Control_mesh& control : meshes_for<Description>())
    if (control.faces.size() <= 40) result.push_back(refined_once<Description>(control));
  return result;
}

std::vector<Shape> shapes()
{
  return {rational_shapes::sphere_at_origin(), rational_shapes::sphere(),
          rational_shapes::cylinder()};
}

// the same by the package's own predicates
bool is_certified(const Exact_control& exact)
{
  return exact.is_on_shape([](const auto& deviation) {
    return CGAL::certainly(deviation.points_are_on_shape) &&
           CGAL::certainly(deviation.normals_are_exact) &&
           deviation.squared_deviation == Number(0) &&
           deviation.squared_normal_deviation == Number(0);
  });
}

// The transfer of curvature is computed in double, so that it has no certificate; the rows of its
// schemes have.
template <class Description>
auto scheme_of_rows()
{
  using Scheme = std::decay_t<decltype(Description::scheme())>;
  if constexpr (PN::internal::Has_curvature_transfer<Scheme>::value)
    return Scheme_of_rows<Scheme>{Description::scheme()};
  else
    return Description::scheme();
}

template <class Description>
class Certificate : public testing::Test
{
public:
  // every vertex after one round
  template <class Scheme>
  void certify(const Shape& shape, const Control_mesh& control, const Scheme& scheme)
  {
    Exact_control exact(shape, control);
    ASSERT_EQ(number_of_vertices_off(exact), 0u) << "control data of " << control.name;
    PN::subdivide(exact.mesh, scheme, CGAL::parameters::vertex_normal_map(exact.normals));
    EXPECT_EQ(number_of_vertices_off(exact), 0u) << control.name;
    EXPECT_TRUE(is_certified(exact)) << control.name;
    vertices_ += exact.mesh.number_of_vertices();
  }

  ~Certificate() override
  {
    if (vertices_ != 0) std::cout << vertices_ << " vertices certified\n";
  }

private:
  std::size_t vertices_ = 0;
};
TYPED_TEST_SUITE(Certificate, Schemes_elsewhere, Scheme_names);

TYPED_TEST(Certificate, OneRoundKeepsSpheresAndCylindersExactly)
{
  for (const Shape& shape : shapes())
    for (const Control_mesh& control : meshes_for<TypeParam>())
      this->certify(shape, control, scheme_of_rows<TypeParam>());
}

TYPED_TEST(Certificate, OneRoundOfARefinedMeshKeepsThemExactly)
{
  for (const Control_mesh& control : refined_meshes_for<TypeParam>()) {
    this->certify(rational_shapes::sphere(), control, scheme_of_rows<TypeParam>());
    if constexpr (!TypeParam::composes_single_rounds) { // the second round is another one
      const Scheme_of_rows<std::decay_t<decltype(TypeParam::scheme())>, 1> second{
        TypeParam::scheme()};
      for (const Shape& shape : shapes()) this->certify(shape, control, second);
    }
  }
}

// --- the hypothesis ---

// Any stencil whose weights sum to 1, over any normals of a shape: exact if N does not vanish and
// what the fade leaves of the weights is at least 1/64.
struct Random_stencil
{
  struct Entry
  {
    std::uint32_t vertex;
    Number weight;
  };
  using Average = PN::PN_average<Number, 3>;

  Random_stencil(const Shape& shape, std::mt19937& random)
  {
    std::uniform_real_distribution<> any(-1, 1);
    const std::size_t n = 2 + random() % 5;
    Number rest = 1;
    for (std::size_t i = 0; i < n; ++i) {
      test_meshes::Triple d{any(random), any(random), any(random)};
      // now and then nearly opposite to the one before
      if (i % 2 == 1 && random() % 3 == 0)
        for (std::size_t k = 0; k < 3; ++k) d[k] = 0.07 * d[k] - direction[k];
      direction = d;
      const rational_shapes::Sample s = shape.sample(d);
      old.push_back({rational_shapes::in<Number>(s.point), rational_shapes::in<Number>(s.normal)});
      const Number weight =
        i + 1 == n ? rest : Number(rational_shapes::Rational(int(random() % 33) - 8, 24));
      row.push_back({std::uint32_t(i), weight});
      rest -= weight;
    }
  }

  Average::Value average() const
  {
    return Average()(row.data(), row.data() + row.size(), old.data());
  }

  // sum a_j chi_j, by the definition, in double: -1 if N vanishes
  double weight_left(bool& fades) const
  {
    test_meshes::Triple sum{0, 0, 0};
    const auto coordinate = [&](std::size_t i, std::size_t k) {
      return CGAL::to_double(old[i].normal[k]);
    };
    for (std::size_t i = 0; i < row.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] += CGAL::to_double(row[i].weight) * coordinate(i, k);
    if (std::hypot(sum[0], sum[1], sum[2]) < 1e-12) return -1;
    const test_meshes::Triple n = test_meshes::unit(sum);
    double left = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      double d = 1;
      for (std::size_t k = 0; k < 3; ++k) d += n[k] * coordinate(i, k);
      const double t = (std::min)(1., (std::max)(0., (d - 24 / 256.) / (51 / 256.)));
      const double a = CGAL::to_double(row[i].weight);
      fades = fades || (t < 1 && t > 0 && a != 0);
      left += a * t * t * (3 - 2 * t);
    }
    return left;
  }

  std::vector<Average::Value> old;
  std::vector<Entry> row;
  test_meshes::Triple direction{};
};

TEST(Certificate_of_the_average, HoldsForAnyWeightsThatSumToOne)
{
  std::mt19937 random(7);
  std::size_t certified = 0, faded = 0, excluded = 0;
  for (int i = 0; i < 3000; ++i)
    for (const Shape& shape : shapes()) {
      const Random_stencil stencil(shape, random);
      bool fades = false;
      const double left = stencil.weight_left(fades);
      const auto value = stencil.average();
      const bool on = rational_shapes::is_exactly_on<Number>(shape, value.point, value.normal);
      if (left < 1 / 64. + 1e-9) {
        ++excluded;
        continue;
      }
      EXPECT_TRUE(on) << "stencil " << i << ", weight left " << left;
      ++certified;
      faded += fades;
    }
  std::cout << certified << " stencils certified, " << faded << " of them fade, " << excluded
            << " outside of the hypothesis\n";
  EXPECT_GT(faded, 100u);
  EXPECT_LT(excluded, 100u);
}

// Outside of the hypothesis nothing is claimed: opposite normals with equal weights give the chord.
TEST(Certificate_of_the_average, NeedsASumOfNormalsThatDoesNotVanish)
{
  using Average = Random_stencil::Average;
  const Average::Value old[] = {{{1, 0, 0}, {1, 0, 0}}, {{-1, 0, 0}, {-1, 0, 0}}};
  const Random_stencil::Entry row[] = {{0, Number(0.5)}, {1, Number(0.5)}};
  const auto value = Average()(row, row + 2, old);
  EXPECT_TRUE(value.point == (PN::Coordinates<Number, 3>{0, 0, 0}));
  EXPECT_TRUE(value.normal == (PN::Coordinates<Number, 3>{0, 0, 0}));
}

// Here N = (0, 0, 4), the first entry is opposite to it, and the others' weights sum to 0.
TEST(Certificate_of_the_average, NeedsWeightsThatTheFadeLeaves)
{
  using Average = Random_stencil::Average;
  std::vector<Average::Value> old;
  for (const PN::Coordinates<Number, 3>& n :
       {PN::Coordinates<Number, 3>{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}})
    old.push_back({n, n});
  const Random_stencil::Entry row[] = {
    {0, Number(1)}, {1, Number(5)}, {2, Number(-2.5)}, {3, Number(-2.5)}};
  const auto value = Average()(row, row + 4, old.data());
  EXPECT_TRUE(value.normal == (PN::Coordinates<Number, 3>{0, 0, 1}));
  EXPECT_TRUE(value.point == (PN::Coordinates<Number, 3>{0, 0, 4})); // the linear point
}

} // namespace
