// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_H
#define CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_H

#include <CGAL/PN_limit_surface_3/internal/limit/Limit_evaluation.h>
#include <CGAL/PN_limit_surface_3/internal/limit/limits_at_slots.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Adaptive_refinement.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Leaf_triangles.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Merged_leaves.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Proven_distance.h>
#include <CGAL/PN_limit_surface_3/internal/tessellation/Tessellation_output.h>
#include <CGAL/PN_limit_surface_3/tessellation/Tessellation_result.h>
#include <CGAL/PN_subdivision_3/attributes/Attribute_traits.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_values.h>
#include <CGAL/PN_subdivision_3/internal/meshes/Mesh_writer.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/meshes/slot_normals.h>
#include <CGAL/PN_subdivision_3/internal/rounds/Average_of_scheme.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal {

// The runs of a tessellation. Finer neighbors put vertices on the sides of a leaf, whose triangles may then miss the
// tolerance: it is split in another run.
template <class FT>
class Tessellation_runs
{
public:
  using Obstacle = Tessellation_result::Obstacle;

  explicit Tessellation_runs(unsigned most)
    : most_(most)
  {}

  // of the last run
  std::deque<Tessellation_node> take_nodes() { return std::move(nodes_); }
  unsigned number() const { return number_; }

  // Those of the leaves, once splits that did not have to be are taken back.
  template <class Refinement>
  Leaf_triangles<FT> triangles(Refinement& refinement, std::size_t dimension_of_corners)
  {
    const bool is_proven = refinement.selection().demand().is_proven;
    const double tolerance = refinement.selection().tolerance() / tessellation_safety;
    if (!is_proven)
      Merged_leaves<FT>(refinement.all(), refinement.selection().nodes(), tolerance)();
    Leaf_triangles<FT> triangles(refinement.all(), tolerance, dimension_of_corners, is_proven);
    triangles.reserve(2 * std::size_t(refinement.all().number_of_vertices()));
    const auto& corners = refinement.selection().corners_of_nodes();
    are_missed_ = false;
    for (std::size_t i = 0; i < refinement.selection().nodes().size(); ++i) {
      Tessellation_node& node = refinement.selection().nodes()[i];
      if (!node.is_leaf) continue;
      const double error = triangles.add(node.leaf, corners.empty() ? nullptr : corners[i].data());
      if (error > with_rounding * refinement.selection().tolerance()) miss(node);
    }
    return triangles;
  }

  // Whether there has to be another run, with nodes of which some have to be split now.
  template <class Refinement>
  bool go_on(Refinement& refinement, const Leaf_triangles<FT>& triangles)
  {
    ++number_;
    if (!are_missed_ || number_ >= most_) return false;
    if (number_ > 1 && triangles.triangles().size() > triangles_out_of_reach) return false;
    nodes_ = std::move(refinement.selection().nodes());
    return true;
  }

  // What has been reached, in the unit of the coordinates.
  template <class Refinement>
  void report(Refinement& refinement, const Leaf_triangles<FT>& triangles,
              Tessellation_result& report) const
  {
    const Tessellation_demand& demand = refinement.selection().demand();
    report.bound = std::ldexp(triangles.bound(), demand.exponent);
    report.worst_face = triangles.worst_face();
    report.worst_place = triangles.worst_place();
    for (double& x : report.worst_place) x = std::ldexp(x, demand.exponent);
    report.reached = triangles.bound() <= with_rounding * demand.tolerance;
    report.depth = refinement.depth();
    if (report.reached) return;
    report.obstacle = refinement.selection().obstacle();
    if (report.obstacle == Obstacle::none)
      report.obstacle = are_missed_ ? Obstacle::triangles : Obstacle::rounds;
  }

private:
  // a product and a quotient
  static constexpr double with_rounding = 1 + 0x1p-50;

  void miss(Tessellation_node& node)
  {
    if (node.has_to_be_split || (node.number_of_children == 0 && !node.may_be_split)) return;
    node.has_to_be_split = true;
    are_missed_ = true;
  }

  const unsigned most_;
  unsigned number_ = 0;
  bool are_missed_ = false; // leaves that can be split
  std::deque<Tessellation_node> nodes_;
};

// by triangles
template <class FT>
std::vector<bool> used_vertices(const Split_edges<FT>& all, const Leaf_triangles<FT>& triangles)
{
  std::vector<bool> used(all.number_of_vertices(), false);
  for (const Tessellation_triangle& t : triangles.triangles())
    for (const Level_connectivity::Index slot : t.slot_ids) used[all.slot(slot).vertex] = true;
  return used;
}

// One run on a control mesh that has been read. The last one calls build(all, mesh).
template <class FT, class Scheme, class Value, class Level_creases>
bool run_tessellation(
  const Scheme& scheme, const Tessellation_demand& demand, const For_chunks& for_chunks,
  const Tessellation_table& table, Valued_level<Value>& control, Level_creases& creases,
  Face_bounds<Value, Level_creases>* bounds, Tessellation_runs<FT>& runs,
  Tessellation_result& report,
  Function_ref<void(const Split_edges<FT>&, const Tessellation_mesh<FT>&)> build)
{
  using Index = Level_connectivity::Index;
  const Index control_vertices = control.level.number_of_vertices();
  const Tessellation_data attributes = table.read(control.level);
  Adaptive_refinement<Scheme, FT, Level_creases> refinement(scheme, demand, for_chunks, bounds);
  refinement(std::move(control), std::move(creases), attributes, runs.take_nodes());
  const Leaf_triangles<FT> triangles = runs.triangles(refinement, table.dimension_of_corners());
  if (runs.go_on(refinement, triangles)) return true;
  std::vector<bool> used = used_vertices(refinement.all(), triangles);
  std::fill_n(used.begin(), control_vertices, true);
  refinement.remove_unused(used);
  const Tessellation_mesh<FT> mesh(refinement.all(), triangles);
  Attribute_table carried;
  if (table.any())
    carried = table.of_result(refinement, triangles, attributes, first_indices(control_vertices));
  build(refinement.all(), mesh);
  table.set(std::move(carried));
  runs.report(refinement, triangles, report);
  report.number_of_vertices = mesh.level().number_of_vertices();
  report.number_of_triangles = mesh.level().number_of_faces();
  return false;
}

// for the library CGAL::PN_subdivision_3_limits, see limit/compiled_limits.h
#define CGAL_PN_SUBDIVISION_3_TESSELLATION_OF(EXTERN, SCHEME, CREASES)                             \
  EXTERN template bool run_tessellation(                                                           \
    const compiled_once::SCHEME&, const Tessellation_demand&, const For_chunks&,                   \
    const Tessellation_table&, Valued_level<compiled_once::Value<compiled_once::SCHEME>>&,         \
    CREASES&, Face_bounds<compiled_once::Value<compiled_once::SCHEME>, CREASES>*,                  \
    Tessellation_runs<double>&, Tessellation_result&,                                              \
    Function_ref<void(const Split_edges<double>&, const Tessellation_mesh<double>&)>);
#define CGAL_PN_SUBDIVISION_3_TESSELLATION(EXTERN, SCHEME)                                         \
  CGAL_PN_SUBDIVISION_3_TESSELLATION_OF(EXTERN, SCHEME, No_creases)                                \
  CGAL_PN_SUBDIVISION_3_TESSELLATION_OF(EXTERN, SCHEME, Creases<double>)
#ifdef CGAL_PN_SUBDIVISION_3_LIMITS
CGAL_PN_SUBDIVISION_3_TESSELLATION(extern, Any_of_quads)
CGAL_PN_SUBDIVISION_3_TESSELLATION(extern, Any_of_triangles)
CGAL_PN_SUBDIVISION_3_TESSELLATION(extern, Linear_of_quads)
CGAL_PN_SUBDIVISION_3_TESSELLATION(extern, Linear_of_triangles)
#endif

// A call of tessellate(): reads the control mesh, refines it adaptively, and builds the mesh of the triangles.
template <class Concurrency_tag, class FaceGraph, class NamedParameters>
class Tessellation
{
  using Parameters = Surface_parameters<FaceGraph, NamedParameters>;
  using FT = typename Parameters::FT;
  using Index = Level_connectivity::Index;

public:
  Tessellation(double chord_error, const NamedParameters& np, Attribute_table* table)
    : chord_error_(chord_error)
    , np_(np)
    , table_(table)
    , for_chunks_(For_chunks::with(Concurrency_tag()))
  {}

  template <class OutputMesh, class Access, class Scheme, class Out_access, class Out_parameters>
  Tessellation_result operator()(const FaceGraph& control, const Access& access,
                                 const Scheme& scheme, OutputMesh& out, Out_access& out_access,
                                 const Out_parameters& np_out) const
  {
    require_empty(out_access);
    Tessellation_result report;
    Tessellation_runs<FT> runs(most_runs);
    const auto build_out = [&](const Split_edges<FT>& all, const Tessellation_mesh<FT>& mesh) {
      using Out = Surface_parameters<OutputMesh, Out_parameters>;
      build(all, mesh, out_access, Out::point_map(out, np_out), Out::normal_map(np_out));
    };
    const auto run = [&](const auto& s) {
      bool goes_on = false;
      read(access, s, Parameters::const_point_map(control, np_),
           [&](const Tessellation_demand& demand, auto& level, auto& creases, auto* bounds) {
             goes_on = run_tessellation<FT>(rules_of(s), demand, for_chunks_, table_, level,
                                            creases, bounds, runs, report, build_out);
           });
      return goes_on;
    };
    with_roundness_of_call<Parameters>(access, scheme, np_, [&](const auto& s) {
      while (run(s)) {
      }
    });
    return report;
  }

private:
  static constexpr bool may_be_proven =
    is_given_v<proven_bound_t, NamedParameters> && std::is_same_v<FT, double>;

  // calls sink(demand, level, creases, bounds)
  template <class Access, class Scheme, class Point_map, class Sink>
  void read(const Access& access, const Scheme& scheme, Point_map points, const Sink& sink) const
  {
    const auto take = [&](auto& control, auto& creases, const auto&) {
      const Tessellation_demand demand = this->demand(box_size(control));
      using Level_creases = std::decay_t<decltype(creases)>;
      Face_bounds<typename Average_of_scheme<Scheme, FT>::Value, Level_creases>* none = nullptr;
      if constexpr (may_be_proven)
        if (demand.is_proven) {
          Proven_bounds<Rules_of<Scheme>, Level_creases> bounds(rules_of(scheme), demand.exponent);
          bounds.require_all(control, creases, chord_error_);
          return sink(demand, control, creases, none = &bounds);
        }
      sink(demand, control, creases, none);
    };
    with_slot_level<FT>(
      access, scheme, points, normal_map<Scheme>(), Parameters::edge_constraint_map(np_),
      Parameters::vertex_constraint_map(np_), rounds_of_all(access.size().faces), take);
  }

  static constexpr unsigned most_runs = 64;

  // how many rounds may be made of all faces, until nothing is sharp but forever
  static unsigned rounds_of_all(std::size_t faces)
  {
    constexpr std::size_t most_faces = std::size_t(1) << 22;
    unsigned rounds = 0;
    for (std::size_t n = 4 * faces; 0 < n && n <= most_faces; n *= 4) ++rounds;
    return rounds;
  }

  // a linear scheme has no use for normals
  template <class Scheme>
  auto normal_map() const
  {
    if constexpr (is_pn_v<Scheme>)
      return Parameters::normal_map(np_);
    else
      return No_normal_map();
  }

  Tessellation_demand demand(double box) const
  {
    Tessellation_demand demand;
    // 2^-exponent is a number, too
    demand.exponent = box > 0 && std::isfinite(box) ? (std::max)(std::ilogb(box), -1000) : 0;
    demand.tolerance = std::ldexp(chord_error_, -demand.exponent);
    constexpr bool is_given = is_given_v<internal_np::number_of_iterations_t, NamedParameters>;
    demand.most_rounds = is_given ? Parameters::number_of_iterations(np_) : 12;
    demand.most_triangles = std::uint64_t(1) << 31;
    Limit_options options;
    options.surface_normals = true;
    options.normal_tolerance = 1e-4;
    demand.limits = limit_demand<FT>(options, box);
    demand.limits.tolerance =
      (std::min)(demand.limits.tolerance, (std::max)(chord_error_ / 1024, std::ldexp(box, -50)));
    demand.is_proven = parameter_or<proven_bound_t>(np_, false);
    if (demand.is_proven && !std::is_same_v<FT, double>)
      throw std::invalid_argument(
        "PN_subdivision_3: distances are proven of coordinates in double only: "
        "leave proven_bound out");
    return demand;
  }

  template <class Access>
  static void require_empty(const Access& access)
  {
    const Level_size size = access.size();
    if (size.vertices != 0 || size.edges != 0 || size.faces != 0)
      throw std::invalid_argument("PN_subdivision_3: the mesh of the tessellation has vertices "
                                  "already: it must be empty");
  }

  template <class Access, class Point_map, class Normal_map>
  static void build(const Split_edges<FT>& all, const Tessellation_mesh<FT>& mesh, Access& access,
                    Point_map point_map, Normal_map normal_map)
  {
    using Writers = Normal_writers<Access, Normal_map>;
    using Point = typename boost::property_traits<Point_map>::value_type;
    std::vector<Point> points;
    points.reserve(all.number_of_vertices());
    for (Index v = 0; v < all.number_of_vertices(); ++v) {
      const auto& p = all.point(v);
      points.emplace_back(p[0], p[1], p[2]);
    }
    build_mesh(access, mesh.level(), point_map, points, Writers::vertex_map(normal_map),
               vertex_normals<typename Writers::Vertex_map>(mesh), [&] {
                 if constexpr (Writers::Corner_writer::takes_corners)
                   mesh.for_each_corner([&](Index h, const flatness::Vector& n) {
                     using Normal = typename boost::property_traits<Normal_map>::value_type;
                     put(normal_map, access.halfedge_at(h), Normal(n[0], n[1], n[2]));
                   });
               });
  }

  template <class Normal_map>
  static auto vertex_normals([[maybe_unused]] const Tessellation_mesh<FT>& mesh)
  {
    if constexpr (std::is_same_v<Normal_map, No_normal_map>)
      return std::vector<char>();
    else {
      std::vector<typename boost::property_traits<Normal_map>::value_type> normals;
      normals.reserve(mesh.level().number_of_vertices());
      for (const flatness::Vector& n : mesh.normals()) normals.emplace_back(n[0], n[1], n[2]);
      return normals;
    }
  }

  double chord_error_;
  const NamedParameters& np_;
  const Tessellation_table table_;
  For_chunks for_chunks_;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_LIMIT_SURFACE_3_INTERNAL_TESSELLATION_TESSELLATION_H
