// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A scheme that is chosen at run time gives the bits of the scheme itself, in every function that takes a scheme.

#include "Extent.h"
#include "Mesh_cases.h"
#include "Messages.h"
#include "analysis/extraordinary_eigenvalues.h"
#include "analysis/subdivision_matrix.h"
#include "support/Options.h"

#include <CGAL/PN_fitting_3/interpolate_limit_points.h>
#include <CGAL/PN_limit_surface_3/Limit_surface.h>
#include <CGAL/PN_limit_surface_3/refine_in_pieces.h>
#include <CGAL/PN_limit_surface_3/subdivide_to_limit.h>
#include <CGAL/PN_subdivision_3.h>
#include <CGAL/PN_subdivision_3/Surface_refiner.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/estimated_row_entries.h>
#include <CGAL/PN_subdivision_3/schemes/scheme_by_name.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace PN = CGAL::PN_subdivision_3;
namespace params = CGAL::parameters;

namespace {

template <class FT>
using Mesh_of = CGAL::Surface_mesh<typename CGAL::Simple_cartesian<FT>::Point_3>;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = Mesh_of<double>;

template <class Scheme>
constexpr bool takes_triangles_v = std::is_same_v<typename Scheme::Host, PN::PTQ_host> ||
                                   std::is_same_v<typename Scheme::Host, PN::Sqrt3_host>;

// with border, and irregular vertices apart from each other after a round
template <class FT>
Mesh_of<FT> control_mesh(bool of_triangles)
{
  Mesh_of<FT> mesh;
  mesh_cases::build(of_triangles ? mesh_cases::triangles_with_border() : mesh_cases::cube(), mesh);
  if (of_triangles) PN::subdivide(mesh, PN::linear(PN::Loop_scheme()));
  return mesh;
}

template <class FT>
auto add_normals(Mesh_of<FT>& mesh)
{
  using Vector = typename CGAL::Simple_cartesian<FT>::Vector_3;
  auto normals =
    mesh.template add_property_map<CGAL::SM_Vertex_index, Vector>("v:n", Vector(0, 0, 0)).first;
  PN::estimate_control_normals(mesh, normals);
  return normals;
}

template <class FT>
std::vector<FT> numbers(const Mesh_of<FT>& mesh)
{
  std::vector<FT> result;
  for (const auto v : mesh.vertices())
    for (int i = 0; i < 3; ++i) result.push_back(mesh.point(v)[i]);
  return result;
}

// what a call makes of a mesh, or its message
struct Outcome
{
  std::vector<double> points;
  std::string message;
  bool operator==(const Outcome& other) const
  {
    return points == other.points && message == other.message;
  }
};

template <class Call>
Outcome outcome(Mesh mesh, const Call& call)
{
  try {
    call(mesh);
    return {numbers<double>(mesh), ""};
  } catch (const std::invalid_argument& e) {
    return {{}, e.what()};
  }
}

// call(mesh, scheme, normals) with the scheme itself and with the one that is chosen at run time
template <class Scheme, class Call>
Outcome expect_same(const Scheme& scheme, const Call& call)
{
  Mesh mesh = control_mesh<double>(takes_triangles_v<Scheme>);
  const auto with = [&](const auto& s) {
    return outcome(mesh, [&](Mesh& m) { call(m, s, add_normals<double>(m)); });
  };
  const Outcome expected = with(scheme);
  EXPECT_EQ(with(PN::Any_scheme<>(scheme)), expected) << scheme.name();
  EXPECT_TRUE(expected.message.empty()) << expected.message;
  return expected;
}

// a model with a mask of its own for the normals
template <class Scheme, class Normal_scheme>
struct Of_two
{
  using Host = typename Scheme::Host;
  static constexpr bool has_crease_rules = true;
  static constexpr bool has_normal_mask = true;
  static constexpr unsigned ghost_rings = 1;
  static constexpr PN::Limit_neighborhood limit_neighborhood =
    Normal_scheme::limit_neighborhood; // the farther one

  template <class FT>
  auto mask(const PN::Level_connectivity& level, unsigned round) const
  {
    return points.template mask<FT>(level, round);
  }
  template <class FT>
  auto normal_mask(const PN::Level_connectivity& level, unsigned round) const
  {
    return normals.template mask<FT>(level, round);
  }

  Scheme points;
  Normal_scheme normals;
};

} // namespace

TEST(Any_scheme, RoundsOfAllSchemes)
{
  std::vector<Outcome> all;
  PN::for_each_shipped_scheme([&](const auto& scheme) {
    all.push_back(expect_same(scheme, [](Mesh& mesh, const auto& s, const auto& normals) {
      PN::subdivide(mesh, s, params::number_of_iterations(3).vertex_normal_map(normals));
      for (const auto v : mesh.vertices()) // the normals count, too
        mesh.point(v) = mesh.point(v) + normals[v];
    }));
  });
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(all[i] == all[j]) << i << ' ' << j;
}

TEST(Any_scheme, LinearTwins)
{
  PN::for_each_shipped_scheme([&](const auto& scheme) {
    expect_same(scheme, [](Mesh& mesh, const auto& s, const auto&) {
      PN::subdivide(mesh, PN::linear(s), params::number_of_iterations(3));
    });
  });
}

TEST(Any_scheme, Creases)
{
  const auto subdivide = [](Mesh& mesh, const auto& s, const auto& normals) {
    auto edges = mesh.add_property_map<Mesh::Edge_index, double>("e:sharpness", 0).first;
    for (const auto e : mesh.edges()) edges[e] = std::size_t(e) % 3 == 0 ? 1.5 : 0;
    PN::subdivide(
      mesh, PN::internal::with_border(s, PN::Border::curve),
      params::number_of_iterations(3).vertex_normal_map(normals).edge_is_constrained_map(edges));
  };
  expect_same(PN::CatmullClark_scheme(), subdivide);
  expect_same(PN::Loop_scheme(), subdivide);
  expect_same(PN::CatmullClark_scheme::Transfer(), subdivide);
}

// call(mesh, scheme, normals, sharp edges) with two schemes themselves and with two that are chosen at run time, without creases
// and with some, one of which ends
template <class Scheme, class Normal_scheme, class Call>
void expect_same_of_two(const Scheme& points, const Normal_scheme& normals, const Call& call)
{
  for (const std::size_t creased : {0, 1, 3}) {
    const auto with = [&](const auto& scheme) {
      return outcome(control_mesh<double>(takes_triangles_v<Scheme>), [&](Mesh& mesh) {
        auto edges = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
        for (std::size_t e = 0; e < creased; ++e) edges[Mesh::Edge_index(unsigned(e))] = true;
        auto of_vertices = add_normals<double>(mesh);
        call(mesh, scheme, of_vertices, edges);
        for (const auto v : mesh.vertices()) mesh.point(v) = mesh.point(v) + of_vertices[v];
      });
    };
    const Outcome expected = with(PN::with_normal_scheme(points, normals));
    EXPECT_TRUE(expected.message.empty()) << expected.message;
    EXPECT_EQ(with(PN::with_normal_scheme(PN::Any_scheme<>(points), PN::Any_scheme<>(normals))),
              expected);
    EXPECT_EQ(with(PN::Any_scheme<>(Of_two<Scheme, Normal_scheme>{points, normals})), expected);
    if (creased == 0) {
      EXPECT_FALSE(with(points) == expected);
    }
  }
}

TEST(Any_scheme, TwoSchemes)
{
  const auto subdivide = [](Mesh& mesh, const auto& s, const auto& normals, const auto& edges) {
    PN::subdivide(
      mesh, s,
      params::number_of_iterations(3).vertex_normal_map(normals).edge_is_constrained_map(edges));
  };
  expect_same_of_two(PN::Loop_scheme(), PN::Loop_scheme::Tuned(), subdivide);
}

// an adaptor is no scheme on a host by itself
TEST(Any_scheme, TwoSchemesOfWhichOneIsAdapted)
{
  const auto with = [](const auto& scheme) {
    return outcome(control_mesh<double>(false), [&](Mesh& mesh) {
      PN::subdivide(mesh, scheme, params::vertex_normal_map(add_normals<double>(mesh)));
    });
  };
  const PN::CatmullClark_scheme points;
  const PN::CatmullClark_scheme::Tuned normals;
  const PN::Any_scheme<> any_points(points), any_normals(normals);
  EXPECT_EQ(with(PN::with_normal_scheme(any_points, PN::linear(any_normals))),
            with(PN::with_normal_scheme(points, PN::linear(normals))));
}

TEST(Any_scheme, LimitsOfTwoSchemes)
{
  const auto to_limit = [](Mesh& mesh, const auto& s, const auto& normals, const auto& edges) {
    PN::subdivide_to_limit(
      mesh, s,
      params::number_of_iterations(1).vertex_normal_map(normals).edge_is_constrained_map(edges));
  };
  expect_same_of_two(PN::CatmullClark_scheme(), PN::CatmullClark_scheme::Tuned(), to_limit);
}

// the proof takes the same weights for points and normals
TEST(Any_scheme, ProvenBoundsOfTwoSchemes)
{
  Mesh mesh = control_mesh<double>(false);
  const PN::Any_scheme<> scheme{PN::CatmullClark_scheme()};
  const auto given = params::vertex_normal_map(add_normals<double>(mesh));
  const PN::Limit_surface<Mesh> proven(mesh, scheme, given);
  EXPECT_GT(proven.proven_distance_to_linear(Mesh::Face_index(0), 4), 0);
  const PN::Limit_surface<Mesh> of_two(
    mesh, PN::with_normal_scheme(scheme, PN::Any_scheme<>(PN::CatmullClark_scheme::Tuned())),
    given);
  EXPECT_THROW(of_two.proven_distance_to_linear(Mesh::Face_index(0), 4), std::invalid_argument);
}

TEST(Any_scheme, Limits)
{
  const auto to_limit = [](Mesh& mesh, const auto& s, const auto& normals) {
    test_options::Limit_options options;
    options.surface_normals = true;
    PN::subdivide_to_limit(
      mesh, s, PN::parameters::join(options.pack(), params::vertex_normal_map(normals)));
    for (const auto v : mesh.vertices()) mesh.point(v) = mesh.point(v) + normals[v];
  };
  expect_same(PN::CatmullClark_scheme(), to_limit);
  expect_same(PN::Loop_scheme::Tuned(1., 2, PN::Tuned_valences::all), to_limit);
  expect_same(PN::CatmullClark_scheme::Transfer(), to_limit);
  expect_same(PN::Kobbelt_scheme(), to_limit);
  expect_same(PN::Sqrt3_scheme(), to_limit);
}

TEST(Any_scheme, LimitsOfFaces)
{
  expect_same(PN::DooSabin_scheme(), [](Mesh& mesh, const auto& s, const auto& normals) {
    auto limits = mesh.add_property_map<Mesh::Face_index, PN::Limit_point<Kernel>>("f:limit").first;
    PN::limit_points(mesh, s, limits, params::vertex_normal_map(normals));
    std::size_t v = 0;
    for (const auto f : mesh.faces())
      mesh.point(Mesh::Vertex_index(unsigned(v++))) = limits[f].point;
  });
}

TEST(Any_scheme, Refiner)
{
  const auto refine = [](Mesh& mesh, const auto& s, const auto& normals) {
    PN::Surface_refiner refiner(mesh, s,
                                params::number_of_iterations(2).vertex_normal_map(normals));
    refiner.set_point(Mesh::Vertex_index(0), Kernel::Point_3(1, 2, 3));
    refiner.update();
    for (const auto& p : refiner.points()) mesh.add_vertex(p);
  };
  expect_same(PN::Kobbelt_scheme(), refine);
  expect_same(PN::Sqrt3_scheme(), refine);
}

TEST(Any_scheme, Pieces)
{
  const auto refine = [](Mesh& mesh, const auto& s, const auto& normals) {
    const PN::Surface_pieces<std::decay_t<decltype(s)>, Kernel> pieces(
      mesh, s,
      PN::parameters::number_of_pieces(3).number_of_iterations(3).vertex_normal_map(normals));
    for (std::size_t i = 0; i < 3; ++i) {
      const auto piece = pieces.piece(i, 1);
      for (const auto& p : piece.points()) mesh.add_vertex(p);
    }
    EXPECT_THROW(pieces.piece(0, PN::internal::facts_of(PN::Loop_scheme()).ghost_rings + 7),
                 std::invalid_argument);
    EXPECT_GT(pieces.memory(s, {4, 6, 4, 12}, 3, 3), 0);
  };
  expect_same(PN::CatmullClark_scheme(), refine);
  expect_same(PN::Loop_scheme::Transfer(), refine);
}

// needs as many rings as the scheme of the two that reaches farther
TEST(Any_scheme, PiecesOfTwoSchemes)
{
  const auto with = [](const auto& points, const auto& normals) {
    return outcome(control_mesh<double>(false), [&](Mesh& mesh) {
      const PN::Surface_pieces pieces(
        mesh, PN::with_normal_scheme(points, normals),
        PN::parameters::number_of_pieces(3).number_of_iterations(3).vertex_normal_map(
          add_normals<double>(mesh)));
      for (std::size_t i = 0; i < 3; ++i) {
        const auto piece = pieces.piece(i, 4);
        for (const auto& p : piece.points()) mesh.add_vertex(p);
      }
    });
  };
  const PN::CatmullClark_scheme near;
  const PN::Kobbelt_scheme far;
  EXPECT_EQ(with(PN::Any_scheme<>(near), PN::Any_scheme<>(far)), with(near, far));
}

TEST(Any_scheme, Interpolation)
{
  long_test([](auto) {
    const auto interpolate = [](Mesh& mesh, const auto& s, const auto& normals) {
      PN::interpolate_limit_points(
        mesh, s,
        PN::parameters::interpolation_normals(PN::Limit_interpolation::Normals::natural)
          .vertex_normal_map(normals));
    };
    expect_same(PN::Loop_scheme(), interpolate);
  });
}

TEST(Any_scheme, Numbers)
{
  const PN::CatmullClark_scheme::Tuned scheme(PN::Scheme_parameter(1, 3), 2u,
                                              PN::Tuned_valences::all);
  const PN::Any_scheme<> any(scheme);
  for (const unsigned valence : {3u, 5u, 8u}) {
    const auto a = PN::extraordinary_eigenvalues(scheme, valence);
    const auto b = PN::extraordinary_eigenvalues(any, valence);
    EXPECT_EQ(a.subdominant, b.subdominant);
    EXPECT_EQ(a.largest_other, b.largest_other);
  }
  Mesh mesh = control_mesh<double>(false);
  for (const unsigned round : {1u, 2u})
    EXPECT_EQ(
      (PN::subdivision_matrix(mesh, scheme, round) - PN::subdivision_matrix(mesh, any, round))
        .squaredNorm(),
      0);
  const PN::Level_connectivity level =
    PN::internal::checked_level(PN::internal::Surface_mesh_access<Mesh>(mesh));
  for (const unsigned rounds : {1u, 2u, 3u})
    EXPECT_EQ(PN::estimated_row_entries(any, level, rounds),
              PN::estimated_row_entries(scheme, level, rounds));
}

TEST(Any_scheme, InFloat)
{
  long_test([](auto) {
    const auto with = [](const auto& scheme) {
      Mesh_of<float> mesh = control_mesh<float>(true);
      auto normals = add_normals<float>(mesh);
      PN::subdivide_to_limit(mesh, scheme, params::vertex_normal_map(normals));
      return numbers<float>(mesh);
    };
    EXPECT_EQ(with(PN::Any_scheme<float>(PN::Loop_scheme())), with(PN::Loop_scheme()));
  });
}

TEST(Any_scheme, ByName)
{
  std::vector<PN::Any_scheme<>> all;
  PN::for_each_shipped_scheme([&](const auto& scheme) {
    all.push_back(PN::any_scheme(scheme.name()));
    EXPECT_EQ(all.back().name(), scheme.name());
    using Scheme = std::decay_t<decltype(scheme)>;
    EXPECT_EQ(all.back().has_crease_rules(), PN::internal::Has_crease_rules<Scheme>::value);
    EXPECT_EQ(all.back().transfers_curvature(),
              PN::internal::Has_curvature_transfer<Scheme>::value);
    EXPECT_EQ(all.back().keeps_vertices(), Scheme::Host::keeps_vertices);
    EXPECT_EQ(all.back().splits_edges(), PN::splits_edges_v<Scheme>);
    EXPECT_EQ(all.back().needs_triangles(), takes_triangles_v<Scheme>);
    EXPECT_EQ(all.back().has_host_of(PN::Any_scheme<>(PN::Kobbelt_scheme())),
              (std::is_same_v<typename Scheme::Host, PN::PQQ_host>));
    const bool interpolates =
      std::string("butterfly kobbelt midpoint bilinear").find(scheme.name()) != std::string::npos;
    EXPECT_EQ(all.back().interpolates(), interpolates);
  });
  const auto refined = [](const auto& scheme) {
    Mesh mesh = control_mesh<double>(false);
    PN::subdivide(mesh, PN::linear(scheme), params::number_of_iterations(2));
    return numbers<double>(mesh);
  };
  EXPECT_EQ(refined(PN::any_scheme("kobbelt", {{"tension", 1. / 20}})),
            refined(PN::Kobbelt_scheme(1. / 20)));
  EXPECT_EQ(refined(PN::any_scheme("modified-catmull-clark", {{"cap", 0.3}, {"first-round", 2.}})),
            refined(PN::CatmullClark_scheme::Tuned(0.3, 2u, PN::Tuned_valences::all)));
}

TEST(Any_scheme, RefusedNames)
{
  struct Case
  {
    const char* name;
    PN::Scheme_parameters parameters;
    std::vector<std::string> words;
  };
  for (const Case& c : {Case{"lop", {}, {"'lop'", "catmull-clark, kobbelt, loop", "ct-loop"}},
                        {"kobbelt", {{"cap", 1.}}, {"'cap'", "tension"}},
                        {"loop", {{"tension", 1.}}, {"'tension'", "none"}},
                        {"modified-loop", {{"w", 1.}}, {"'w'", "cap and first-round"}},
                        {"modified-loop", {{"first-round", 0.}}, {"first-round"}},
                        {"modified-loop", {{"first-round", 1.5}}, {"first-round"}},
                        {"modified-loop", {{"first-round", -1.}}, {"first-round"}},
                        {"kobbelt", {{"tension", 1e9}}, {"tension"}}})
    messages::expect_refused([&] { PN::any_scheme(c.name, c.parameters); }, c.words);
}

// What the compiler refuses of a scheme is refused at run time, and the mesh is as it was.
TEST(Any_scheme, RefusedCalls)
{
  const auto refused = [](const auto& call, const std::vector<std::string>& words) {
    Mesh mesh = control_mesh<double>(false);
    const std::vector<double> before = numbers<double>(mesh);
    messages::expect_refused([&] { call(mesh); }, words);
    EXPECT_EQ(numbers<double>(mesh), before);
  };
  const PN::Any_scheme<> quads{PN::CatmullClark_scheme()}, triangles{PN::Loop_scheme()},
    dual{PN::DooSabin_scheme()}, transferring{PN::CatmullClark_scheme::Transfer()},
    without_creases{PN::Kobbelt_scheme()};
  refused([&](Mesh& m) { PN::subdivide(m, triangles); }, {"triangles"});
  refused([&](Mesh& m) { PN::subdivide(m, PN::with_normal_scheme(quads, triangles)); },
          {"loop", "split the faces"});
  refused([&](Mesh& m) { PN::subdivide(m, PN::with_normal_scheme(quads, transferring)); },
          {"transfers curvature"});
  refused(
    [&](Mesh& m) {
      auto edges = m.add_property_map<Mesh::Edge_index, bool>("e:s", true).first;
      PN::subdivide(m, PN::with_normal_scheme(without_creases, quads),
                    params::edge_is_constrained_map(edges));
    },
    {"kobbelt", "no rules for creases"});
  refused([&](Mesh& m) { PN::subdivide_to_limit(m, dual); }, {"doo-sabin", "faces"});
  refused(
    [&](Mesh& m) { PN::subdivide_to_limit(m, dual, CGAL::parameters::number_of_iterations(0)); },
    {"doo-sabin", "faces"});
  refused([&](Mesh& m) { PN::Surface_refiner(m, transferring); }, {"transfers curvature"});
  refused([&](Mesh& m) { PN::interpolate_limit_points(m, PN::linear(dual)); }, {"doo-sabin"});
  refused(
    [&](Mesh& m) {
      PN::interpolate_limit_points(m, transferring,
                                   params::vertex_normal_map(add_normals<double>(m)));
    },
    {"ct-catmull"});
  const auto corners = [](Mesh& m) {
    return m.add_property_map<Mesh::Halfedge_index, Kernel::Vector_3>("h:n", {0, 0, 1}).first;
  };
  for (const auto& scheme : {dual, without_creases}) {
    refused([&](Mesh& m) { PN::subdivide(m, scheme, params::vertex_normal_map(corners(m))); },
            {scheme.name(), "per vertex"});
    refused(
      [&](Mesh& m) {
        auto edges = m.add_property_map<Mesh::Edge_index, bool>("e:s", true).first;
        PN::subdivide(m, scheme, params::edge_is_constrained_map(edges));
      },
      {scheme.name(), "no rules for creases"});
  }
  refused([&](Mesh& m) { PN::subdivide(m, PN::internal::with_crease_tangents(dual, corners(m))); },
          {"doo-sabin", "tangents"});
}
