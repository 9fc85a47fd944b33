// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the libraries PN_subdivision_3_double and PN_subdivision_3_limits have the code of gives the same bits as the headers, throws the same, and all other
// calls are compiled from these.

#include "Mesh_cases.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/PN_limit_surface_3/limit_points.h>
#include <CGAL/PN_limit_surface_3/tessellate.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/parameters/Default_visitor.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <string>
#include <type_traits>
#include <utility>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

std::vector<mesh_cases::Triple> limits_of_headers(bool is_cube); // compiled_calls_alone.cpp

namespace {

// asks for what the library does not have, and so is compiled from the headers
struct Of_headers : PN::Default_visitor
{
  template <class Vertex, class Element>
  void vertex_created(Vertex, const Element&)
  {
    ++vertices;
  }
  std::size_t vertices = 0;
};

// whether a call is left to the library, as subdivide() finds it
template <class Scheme, class Mesh, class NamedParameters,
          class Concurrency_tag = CGAL::Sequential_tag>
constexpr bool is_compiled()
{
  using Parameters = PN::internal::Surface_parameters<Mesh, NamedParameters>;
  using Visitor = decltype(Parameters::visitor(std::declval<const NamedParameters&>()));
  using Unwrapped =
    std::remove_reference_t<decltype(PN::internal::unwrapped(std::declval<Visitor&>()))>;
  using Attributes = decltype(Parameters::attributes(std::declval<const NamedParameters&>()));
  return PN::internal::is_compiled_call<
    Concurrency_tag, Mesh, Scheme, Parameters,
    PN::internal::Call_attributes<Mesh, Unwrapped, Attributes>>();
}

template <class Mesh>
std::vector<double> numbers(const Mesh& mesh)
{
  std::vector<double> result;
  for (const auto v : mesh.vertices())
    for (int i = 0; i < 3; ++i) result.push_back(mesh.point(v)[i]);
  for (const auto h : mesh.halfedges()) {
    result.push_back(double(mesh.target(h)));
    result.push_back(double(mesh.next(h)));
  }
  return result;
}

template <class Scheme>
constexpr bool takes_triangles_v = std::is_same_v<typename Scheme::Host, PN::PTQ_host> ||
                                   std::is_same_v<typename Scheme::Host, PN::Sqrt3_host>;

template <class Kernel_, class Scheme_>
struct Case
{
  using Kernel = Kernel_;
  using Scheme = Scheme_;
};
using Cartesian = CGAL::Simple_cartesian<double>;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Case>
class Compiled_calls : public testing::Test
{
protected:
  using Kernel = typename Case::Kernel;
  using Scheme = typename Case::Scheme;
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  using Vector = typename Kernel::Vector_3;

  // what call(mesh, normals, sharp edges, attribute) makes of a mesh with a removed vertex, or the message
  template <class Call>
  static std::vector<double> result(const Call& call, std::string& message)
  {
    Mesh mesh;
    mesh.add_vertex({9, 9, 9});
    mesh_cases::build(
      takes_triangles_v<Scheme> ? mesh_cases::triangles_with_border() : mesh_cases::cube(), mesh);
    mesh.remove_vertex(typename Mesh::Vertex_index(0));
    auto normals =
      mesh.template add_property_map<CGAL::SM_Vertex_index, Vector>("v:n", Vector(0, 0, 0)).first;
    PN::estimate_control_normals(mesh, normals);
    auto edges = mesh.template add_property_map<CGAL::SM_Edge_index, bool>("e:sharp", false).first;
    edges[*mesh.edges().begin()] = true;
    auto values = mesh.template add_property_map<CGAL::SM_Vertex_index, double>("v:value").first;
    for (const auto v : mesh.vertices()) values[v] = double(v);
    try {
      call(mesh, normals, edges, values);
    } catch (const std::exception& e) {
      message = e.what();
    }
    std::vector<double> all = numbers(mesh);
    for (const auto v : mesh.vertices())
      for (int i = 0; i < 3; ++i) all.push_back(normals[v][i]);
    for (const auto v : mesh.vertices()) all.push_back(values[v]);
    for (const auto e : mesh.edges()) all.push_back(edges[e]);
    return all;
  }

  // parameters(others, normals, sharp edges) of a call that the library has: of the scheme or, with an attribute, of any scheme
  template <bool has_attribute, class Make>
  static void expect_same(const Make& parameters, const char* expected_message = "")
  {
    using Called = std::conditional_t<has_attribute, PN::Any_scheme<>, Scheme>;
    using Compiled =
      std::conditional_t<has_attribute, PN::internal::Scheme_on_host<typename Scheme::Host, double>,
                         Scheme>;
    const auto others = [](auto values) {
      if constexpr (has_attribute)
        return PN::parameters::attributes(PN::parameters::vertex_attribute(values))
          .number_of_iterations(3);
      else
        return params::number_of_iterations(3);
    };
    std::string of_library, of_headers;
    const auto compiled = result(
      [&](Mesh& mesh, auto normals, auto edges, auto values) {
        const auto np = parameters(others(values), normals, edges);
        static_assert(is_compiled<Compiled, Mesh, std::decay_t<decltype(np)>>());
        PN::subdivide(mesh, Called(Scheme()), np);
      },
      of_library);
    Of_headers visitor;
    const auto expected = result(
      [&](Mesh& mesh, auto normals, auto edges, auto values) {
        const auto np = parameters(others(values), normals, edges).visitor(std::ref(visitor));
        static_assert(!is_compiled<Scheme, Mesh, std::decay_t<decltype(np)>>());
        PN::subdivide(mesh, Scheme(), np);
      },
      of_headers);
    EXPECT_EQ(compiled, expected);
    EXPECT_EQ(of_library, of_headers);
    EXPECT_NE(of_library.find(expected_message), std::string::npos) << of_library;
    EXPECT_EQ(visitor.vertices > 0, of_headers.empty());
  }
};

using Cases =
  testing::Types<Case<Cartesian, PN::CatmullClark_scheme>, Case<Cartesian, PN::Loop_scheme>,
                 Case<Cartesian, PN::DooSabin_scheme>, Case<Cartesian, PN::Sqrt3_scheme>,
                 Case<Inexact, PN::CatmullClark_scheme>, Case<Inexact, PN::Loop_scheme>,
                 Case<Inexact, PN::DooSabin_scheme>, Case<Inexact, PN::Sqrt3_scheme>>;
TYPED_TEST_SUITE(Compiled_calls, Cases, );

TYPED_TEST(Compiled_calls, GiveTheSameBits)
{
  constexpr bool has_rules = PN::internal::Has_crease_rules<typename TypeParam::Scheme>::value;
  const char* const refusal = has_rules ? "" : "has no rules for creases";
  this->template expect_same<false>([](const auto& others, auto, auto) { return others; });
  this->template expect_same<true>(
    [](const auto& others, auto normals, auto) { return others.vertex_normal_map(normals); });
  this->template expect_same<false>(
    [](const auto& others, auto, auto edges) { return others.edge_is_constrained_map(edges); },
    refusal);
  this->template expect_same<true>(
    [](const auto& others, auto normals, auto edges) {
      return others.edge_is_constrained_map(edges).vertex_normal_map(normals);
    },
    refusal);
}

TYPED_TEST(Compiled_calls, ThrowTheSame)
{
  this->template expect_same<true>(
    [](const auto& others, auto normals, auto) {
      normals[CGAL::SM_Vertex_index(3)] = typename TestFixture::Vector(HUGE_VAL, 0, 0);
      return others.vertex_normal_map(normals);
    },
    "is not finite");
}

TYPED_TEST(Compiled_calls, CallTheVisitorForRounds)
{
  std::vector<std::pair<unsigned, std::size_t>> rounds;
  struct Visitor : PN::Default_visitor
  {
    void round_done(unsigned round, std::size_t faces) const { done->emplace_back(round, faces); }
    std::vector<std::pair<unsigned, std::size_t>>* done;
  } visitor;
  visitor.done = &rounds;
  const auto np = params::number_of_iterations(2).visitor(visitor);
  static_assert(is_compiled<typename TypeParam::Scheme, typename TestFixture::Mesh,
                            std::decay_t<decltype(np)>>());
  std::string message;
  std::size_t faces = 0;
  this->result(
    [&](auto& mesh, auto, auto, auto) {
      PN::subdivide(mesh, typename TypeParam::Scheme(), np);
      faces = mesh.number_of_faces();
    },
    message);
  ASSERT_EQ(rounds.size(), 2u) << message;
  EXPECT_EQ(rounds[0].first, 1u);
  EXPECT_EQ(rounds[1], std::make_pair(2u, faces));
}

// what the library does not have
TEST(Compiled_call, IsOfUsualTypesOnly)
{
  using Mesh = CGAL::Surface_mesh<Cartesian::Point_3>;
  using PN::CatmullClark_scheme;
  Mesh mesh;
  const auto np = params::number_of_iterations(2);
  using Plain = std::decay_t<decltype(np)>;
  EXPECT_TRUE((is_compiled<CatmullClark_scheme, Mesh, Plain>()));
  EXPECT_FALSE((is_compiled<CatmullClark_scheme, Mesh, Plain, CGAL::Parallel_tag>()));
  EXPECT_FALSE((is_compiled<PN::Kobbelt_scheme, Mesh, Plain>()));
  EXPECT_FALSE((is_compiled<PN::Linear_scheme<CatmullClark_scheme>, Mesh, Plain>()));
  EXPECT_FALSE((is_compiled<CatmullClark_scheme, CGAL::Polyhedron_3<Cartesian>, Plain>()));
  EXPECT_FALSE((is_compiled<CatmullClark_scheme,
                            CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>, Plain>()));
  const auto with = [](const auto& parameters) {
    return is_compiled<CatmullClark_scheme, Mesh, std::decay_t<decltype(parameters)>>();
  };
  EXPECT_FALSE(with(PN::parameters::roundness(1)));
  EXPECT_FALSE(with(params::geom_traits(CGAL::Simple_cartesian<float>())));
  auto sharpness = mesh.add_property_map<CGAL::SM_Edge_index, double>("e:s", 0).first;
  EXPECT_FALSE(with(params::edge_is_constrained_map(sharpness)));
  auto corners = mesh.add_property_map<CGAL::SM_Vertex_index, bool>("v:c", false).first;
  EXPECT_FALSE(with(params::vertex_is_constrained_map(corners)));
  auto of_corners =
    mesh.add_property_map<CGAL::SM_Halfedge_index, Cartesian::Vector_3>("h:n", {0, 0, 0}).first;
  EXPECT_FALSE(with(params::vertex_normal_map(of_corners)));
}

// another type, which the library does not have
template <class Scheme>
struct Of_headers_alone : Scheme
{};

template <class Scheme>
std::vector<mesh_cases::Triple> limits_of(const mesh_cases::Soup& soup, const Scheme& scheme,
                                          bool has_creases)
{
  CGAL::Surface_mesh<Cartesian::Point_3> mesh;
  mesh_cases::build(soup, mesh);
  auto limits = mesh.add_property_map<CGAL::SM_Vertex_index, Cartesian::Point_3>("v:limit").first;
  auto sharp = mesh.add_property_map<CGAL::SM_Edge_index, bool>("e:sharp", false).first;
  for (const auto h : halfedges_around_face(halfedge(*faces(mesh).begin(), mesh), mesh))
    sharp[edge(h, mesh)] = has_creases;
  PN::limit_points(mesh, scheme,
                   PN::parameters::limit_point_map(limits).edge_is_constrained_map(sharp));
  return mesh_cases::values(mesh, limits);
}

TEST(Compiled_limits, SourcesThatAreLinkedAndOthersAreOneProgram)
{
  EXPECT_EQ(limits_of(mesh_cases::cube(), PN::CatmullClark_scheme(), false),
            limits_of_headers(true));
  EXPECT_EQ(limits_of(mesh_cases::tetrahedron(), PN::Loop_scheme(), false),
            limits_of_headers(false));
}

// the control values of a level with sharp edges about its first face, of which make() makes normals and tangents
template <class Make>
std::vector<double> control_values(const mesh_cases::Soup& soup, const Make& make)
{
  using Index = PN::Level_connectivity::Index;
  CGAL::Surface_mesh<Cartesian::Point_3> mesh;
  mesh_cases::build(soup, mesh);
  std::vector<double> numbers;
  PN::internal::with_mesh_access(mesh, [&](const auto& access) {
    const auto level = PN::internal::checked_level(access);
    const Index n = level.number_of_vertices();
    auto creases = PN::internal::Make_creases<double>(level, PN::Border::surface)(
      [&](Index e) { return level.face(2 * e) == 0 ? PN::internal::infinite_sharpness : 0; },
      [](Index v) { return v == 1 ? 1.5 : 0; });
    std::vector<PN::Point_normal<double, 3>> values(creases.number_of_slots);
    const auto extra = PN::internal::vertices_of_extra_slots(creases, n);
    for (Index s = 0; s < values.size(); ++s)
      values[s].point = soup.points[s < n ? s : extra[s - n]];
    make(level, creases, values);
    for (const auto& value : values) {
      numbers.insert(numbers.end(), value.normal.begin(), value.normal.end());
      numbers.push_back(value.roundness);
    }
    for (const auto& e : creases.edges)
      for (const auto& t : e.tangent_from) numbers.insert(numbers.end(), t.begin(), t.end());
  });
  return numbers;
}

TEST(Compiled_levels, ControlValuesAreThoseOfTheHeaders)
{
  using namespace PN::internal;
  for (const mesh_cases::Soup& soup : {mesh_cases::cube(), mesh_cases::mixed_with_border()})
    for (const auto estimate :
         {PN::Control_normal_estimate::coherent, PN::Control_normal_estimate::reciprocal,
          PN::Control_normal_estimate::angle}) {
      EXPECT_EQ(control_values(soup,
                               [&](const auto& level, auto& creases, auto& values) {
                                 estimate_wedges(level, creases, values,
                                                 std::vector<bool>(values.size(), false), estimate);
                               }),
                control_values(soup, [&](const auto& level, auto& creases, auto& values) {
                  Wedge_estimation<double>(level, creases, values,
                                           std::vector<bool>(values.size(), false), estimate)();
                }));
      EXPECT_EQ(control_values(soup,
                               [&](const auto& level, auto&, auto& values) {
                                 values.resize(level.number_of_vertices());
                                 estimate_normals_of(level, estimate, values);
                               }),
                control_values(soup, [&](const auto& level, auto&, auto& values) {
                  values.resize(level.number_of_vertices());
                  estimate_normals(level, estimate, values);
                }));
    }
}

// what is refined where sharpness ends in a round, less than a round is left, or nothing is sharp
template <class Scheme>
std::vector<double> refined_numbers(const mesh_cases::Soup& soup, const Scheme& scheme,
                                    double sharpness)
{
  CGAL::Surface_mesh<Cartesian::Point_3> mesh;
  mesh_cases::build(soup, mesh);
  auto sharp = mesh.add_property_map<CGAL::SM_Edge_index, double>("e:sharp", 0).first;
  for (const auto h : halfedges_around_face(halfedge(*faces(mesh).begin(), mesh), mesh))
    sharp[edge(h, mesh)] = sharpness;
  PN::subdivide(mesh, scheme, params::number_of_iterations(2).edge_is_constrained_map(sharp));
  return numbers(mesh);
}

// the libraries have linear twins of an Any_scheme only
template <class Scheme, class Make>
void expect_same_linear(const Scheme& scheme, const mesh_cases::Soup& soup, const Make& make)
{
  EXPECT_EQ(make(soup, PN::linear(PN::Any_scheme<>(scheme))), make(soup, PN::linear(scheme)));
}
template <class Scheme, class Make>
void expect_same_as_headers(const Scheme& scheme, const mesh_cases::Soup& soup, const Make& make)
{
  const auto expected = make(soup, Of_headers_alone<Scheme>());
  EXPECT_EQ(make(soup, scheme), expected);
  EXPECT_EQ(make(soup, PN::Any_scheme<>(scheme)), expected);
  expect_same_linear(scheme, soup, make);
}

TEST(Compiled_levels, RoundsAreThoseOfTheHeaders)
{
  for (const double sharpness : {0., 1.5, HUGE_VAL}) {
    const auto refined = [&](const mesh_cases::Soup& soup, const auto& scheme) {
      return refined_numbers(soup, scheme, sharpness);
    };
    expect_same_as_headers(PN::CatmullClark_scheme(), mesh_cases::mixed_with_border(), refined);
    expect_same_as_headers(PN::Loop_scheme(), mesh_cases::triangles_with_border(), refined);
  }
}

template <class Scheme>
std::vector<double> tessellated(const mesh_cases::Soup& soup, const Scheme& scheme)
{
  CGAL::Surface_mesh<Cartesian::Point_3> mesh, result;
  mesh_cases::build(soup, mesh);
  auto sharp = mesh.add_property_map<CGAL::SM_Edge_index, bool>("e:sharp", false).first;
  for (const auto h : halfedges_around_face(halfedge(*faces(mesh).begin(), mesh), mesh))
    sharp[edge(h, mesh)] = true;
  PN::tessellate(mesh, scheme, 0.01, result);
  std::vector<double> all = numbers(result);
  result.clear();
  all.push_back(
    PN::tessellate(mesh, scheme, 0.01, result, params::edge_is_constrained_map(sharp)).bound);
  const std::vector<double> creased = numbers(result);
  all.insert(all.end(), creased.begin(), creased.end());
  return all;
}

TEST(Compiled_tessellation, IsThatOfTheHeaders)
{
  const mesh_cases::Soup quads = mesh_cases::mixed_with_border();
  const auto of_quads = tessellated(quads, Of_headers_alone<PN::CatmullClark_scheme>());
  EXPECT_EQ(of_quads, tessellated(quads, PN::CatmullClark_scheme()));
  EXPECT_EQ(of_quads, tessellated(quads, PN::Any_scheme<>(PN::CatmullClark_scheme())));
  const mesh_cases::Soup triangles = mesh_cases::triangles_with_border();
  const auto of_triangles = tessellated(triangles, PN::Loop_scheme());
  EXPECT_GT(of_triangles.size(), 100u);
  EXPECT_EQ(of_triangles, tessellated(triangles, PN::Any_scheme<>(PN::Loop_scheme())));
  const auto make = [](const auto& soup, const auto& scheme) { return tessellated(soup, scheme); };
  expect_same_linear(PN::CatmullClark_scheme(), quads, make);
  expect_same_linear(PN::Loop_scheme(), triangles, make);
}

TEST(Compiled_limits, AreThoseOfTheHeaders)
{
  for (const bool has_creases : {false, true}) {
    const auto limits = [&](const mesh_cases::Soup& soup, const auto& scheme) {
      return limits_of(soup, scheme, has_creases);
    };
    for (const mesh_cases::Soup& soup : {mesh_cases::cube(), mesh_cases::mixed_with_border()})
      expect_same_as_headers(PN::CatmullClark_scheme(), soup, limits);
    for (const mesh_cases::Soup& soup :
         {mesh_cases::tetrahedron(), mesh_cases::triangles_with_border()}) {
      expect_same_as_headers(PN::Loop_scheme(), soup, limits);
      EXPECT_EQ(limits_of(soup, PN::Sqrt3_scheme(), false),
                limits_of(soup, PN::Any_scheme<>(PN::Sqrt3_scheme()), false));
    }
  }
}

} // namespace
