// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What of this the page sees, by Embind; page/modeler.ts has the same in types.

#include "Control_mesh.h"
#include "Plane_curve.h"
#include "Refined_surface.h"

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <new>
#include <string>
#include <vector>

namespace pn_demo {
namespace {

using emscripten::val;

// An exception of C++ becomes an Error with its message.
[[noreturn]] void throw_to_page(const std::string& message)
{
  const std::string prefix = "PN_subdivision_3: ";
  val::global("Error")
    .new_(message.compare(0, prefix.size(), prefix) == 0 ? message.substr(prefix.size()) : message)
    .throw_();
  std::terminate();
}

template <class Function>
auto guarded(const Function& function)
{
  std::string message;
  try {
    return function();
  } catch (const std::bad_alloc&) {
    message = "there is not enough memory for this: ask for fewer rounds";
  } catch (const std::exception& e) {
    message = e.what();
  }
  throw_to_page(message);
}

// Copies, since memory that grows invalidates views.
template <class T>
val copy_of(const std::vector<T>& values)
{
  return val(emscripten::typed_memory_view(values.size(), values.data())).call<val>("slice");
}
// A view, for what is copied to the graphics hardware at once.
template <class T>
val view_of(const std::vector<T>& values)
{
  return val(emscripten::typed_memory_view(values.size(), values.data()));
}

template <class T>
std::vector<T> vector_of(const val& array)
{
  return array.isUndefined() ? std::vector<T>()
                             : emscripten::convertJSArrayToNumberVector<T>(array);
}

template <class Triple_range>
val triples(const Triple_range& range)
{
  std::vector<double> flat;
  for (const auto& t : range)
    for (int k = 0; k < 3; ++k) flat.push_back(t[k]);
  return copy_of(flat);
}

val to_page(const Faces& faces)
{
  val result = val::object();
  std::vector<Index> degrees;
  Index begin = 0;
  for (const Index end : faces.end) {
    degrees.push_back(end - begin);
    begin = end;
  }
  result.set("degrees", copy_of(degrees));
  result.set("corners", copy_of(faces.corners));
  return result;
}

// --- control meshes ---

Control_mesh read_mesh(const std::string& content, const std::string& format, bool repairs)
{
  return guarded([&] { return Control_mesh::read(content, format, repairs); });
}

Control_mesh restore_mesh(const val& state)
{
  return guarded([&] {
    Mesh_state s;
    s.points = vector_of<double>(state["points"]);
    s.degrees = vector_of<std::uint32_t>(state["degrees"]);
    s.corners = vector_of<std::uint32_t>(state["corners"]);
    s.corner_normals = vector_of<double>(state["cornerNormals"]);
    s.sharp_edges = vector_of<std::uint32_t>(state["sharpEdges"]);
    s.roundness = vector_of<double>(state["roundness"]);
    s.uv = vector_of<double>(state["uv"]);
    return Control_mesh(s);
  });
}

val state_of(const Control_mesh& mesh)
{
  const Mesh_state s = mesh.state();
  val result = val::object();
  result.set("points", copy_of(s.points));
  result.set("degrees", copy_of(s.degrees));
  result.set("corners", copy_of(s.corners));
  result.set("cornerNormals", copy_of(s.corner_normals));
  result.set("sharpEdges", copy_of(s.sharp_edges));
  if (!s.roundness.empty()) result.set("roundness", copy_of(s.roundness));
  if (!s.uv.empty()) result.set("uv", copy_of(s.uv));
  return result;
}

// What the page draws of a control mesh and lets the user take hold of.
val handles_of(const Control_mesh& mesh)
{
  const Surface& surface = mesh.surface();
  std::vector<std::uint32_t> vertices;
  std::vector<Vector_3> normals(mesh.wedges().vertex.size(), CGAL::NULL_VECTOR);
  for (const auto v : mesh.wedges().vertex) vertices.push_back(std::uint32_t(v));
  for (const auto h : surface.halfedges())
    if (!surface.is_border(h)) normals[mesh.wedges().of_corner[h]] = mesh.normal_at(h);
  std::vector<std::uint32_t> edges;
  std::vector<std::uint8_t> sharp, border;
  for (const auto e : surface.edges()) {
    edges.push_back(std::uint32_t(surface.vertex(e, 0)));
    edges.push_back(std::uint32_t(surface.vertex(e, 1)));
    sharp.push_back(mesh.is_sharp(e));
    border.push_back(surface.is_border(e));
  }
  val result = val::object();
  result.set("points",
             triples(std::vector<Point_3>(surface.points().begin(), surface.points().end())));
  result.set("vertices", copy_of(vertices));
  result.set("normals", triples(normals));
  result.set("edges", copy_of(edges));
  result.set("sharp", copy_of(sharp));
  result.set("border", copy_of(border));
  return result;
}

Control_mesh triangulated(const Control_mesh& mesh)
{
  return guarded([&] { return mesh.triangulated(); });
}
void set_point(Control_mesh& mesh, unsigned v, double x, double y, double z)
{
  guarded([&] { mesh.set_point(v, Point_3(x, y, z)); });
}
void set_normal(Control_mesh& mesh, unsigned wedge, double x, double y, double z)
{
  guarded([&] { mesh.set_normal(wedge, Vector_3(x, y, z)); });
}
void set_sharp(Control_mesh& mesh, unsigned edge, bool is_sharp)
{
  guarded([&] { mesh.set_sharp(edge, is_sharp); });
}
unsigned detect_creases(Control_mesh& mesh, double degrees)
{
  return guarded([&] { return unsigned(mesh.detect_creases(degrees)); });
}
void set_roundness(Control_mesh& mesh, double w)
{
  guarded([&] { mesh.set_roundness(w); });
}
void estimate_roundness(Control_mesh& mesh)
{
  guarded([&] { mesh.estimate_roundness(); });
}
unsigned number_of_sharp_edges(const Control_mesh& mesh)
{
  return unsigned(mesh.number_of_sharp_edges());
}
unsigned number_of_faces(const Control_mesh& mesh)
{
  return unsigned(mesh.surface().number_of_faces());
}

// --- refined surfaces ---

val scheme_list()
{
  val result = val::array();
  for (const Scheme_traits& s : scheme_traits()) {
    val item = val::object();
    item.set("name", s.name);
    item.set("takesTriangles", s.takes_triangles);
    item.set("takesQuads", s.takes_quads);
    item.set("hasCreaseRules", s.has_crease_rules);
    item.set("hasLimitPoints", s.has_limit_points);
    result.call<void>("push", item);
  }
  return result;
}

Refined_surface* refine(const Control_mesh& mesh, const std::string& scheme, unsigned rounds,
                        bool is_linear, double x, double y, double z)
{
  return guarded(
    [&] { return new Refined_surface(mesh, scheme, rounds, is_linear, Point_3(x, y, z)); });
}

void follow(Refined_surface& surface, const Control_mesh& mesh, unsigned vertex)
{
  guarded([&] { surface.follow(mesh, vertex); });
}
void update(Refined_surface& surface, const Control_mesh& mesh)
{
  guarded([&] { surface.update(mesh); });
}
void show_limit(Refined_surface& surface, const Control_mesh& mesh)
{
  guarded([&] { surface.show_limit(mesh); });
}
val curvature(Refined_surface& surface, bool is_gaussian)
{
  return guarded([&] { return copy_of(surface.curvature(is_gaussian)); });
}
val positions_view(const Refined_surface& surface)
{
  return view_of(surface.display().positions());
}
val normals_view(const Refined_surface& surface)
{
  return view_of(surface.display().normals());
}
val triangles(const Refined_surface& surface)
{
  return copy_of(surface.display().triangles());
}
val points_of(const Refined_surface& surface)
{
  return triples(surface.points());
}
val control_normals_of(const Refined_surface& surface)
{
  return triples(surface.normals());
}
val roundness_of(const Refined_surface& surface, const Control_mesh& mesh)
{
  return guarded([&] { return copy_of(surface.roundness(mesh)); });
}
val uv_of(const Refined_surface& surface)
{
  return copy_of(surface.uv());
}
val sides_of(const Refined_surface& surface)
{
  val result = val::object();
  result.set("sharpEdges", copy_of(surface.sides().sharp_edges));
  result.set("tangents", triples(surface.sides().tangents));
  result.set("normals", triples(surface.sides().normals));
  result.set("roundness", copy_of(surface.sides().roundness));
  return result;
}
val faces_of(const Refined_surface& surface)
{
  return to_page(surface.faces());
}

// Three corners of each triangle, as the command has them in files of triangles.
val split_faces(const val& points, const val& faces)
{
  return guarded([&] {
    Mesh_data mesh;
    const auto coordinates = vector_of<double>(points);
    for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
      mesh.points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
    const auto corners = vector_of<std::uint32_t>(faces["corners"]);
    auto corner = corners.begin();
    for (const std::uint32_t degree : vector_of<std::uint32_t>(faces["degrees"])) {
      mesh.add_face(std::vector<std::uint32_t>(corner, corner + degree));
      corner += degree;
    }
    Surface surface = pn_subdivide::make_surface(mesh);
    pn_subdivide::triangulate(surface);
    std::vector<std::uint32_t> result;
    for (const auto h : pn_subdivide::corners_of(surface))
      result.push_back(std::uint32_t(surface.target(h)));
    return copy_of(result);
  });
}

// --- curves ---

val refine_curve(const val& points, const val& normals, const std::string& mask, bool is_linear,
                 bool is_closed, unsigned rounds, double roundness)
{
  return guarded([&] {
    const Plane_curve curve =
      refine_plane_curve(vector_of<double>(points), vector_of<double>(normals), mask, is_linear,
                         is_closed, rounds, roundness);
    val result = val::object();
    result.set("points", copy_of(curve.points));
    result.set("normals", copy_of(curve.normals));
    result.set("curvature", copy_of(curve.curvature));
    result.set("comb", copy_of(curve.comb));
    return result;
  });
}

val estimate_curve_normals(const val& points, bool is_closed)
{
  return guarded(
    [&] { return copy_of(estimate_plane_normals(vector_of<double>(points), is_closed)); });
}

} // namespace

EMSCRIPTEN_BINDINGS(pn_subdivision_3)
{
  using namespace emscripten;
  class_<Control_mesh>("ControlMesh")
    .function("state", state_of)
    .function("handles", handles_of)
    .function("triangulated", triangulated)
    .function("hasOnlyTriangles", &Control_mesh::has_only_triangles)
    .function("numberOfFaces", number_of_faces)
    .function("numberOfSharpEdges", number_of_sharp_edges)
    .function("normalsFrom", &Control_mesh::normals_from)
    .function("repair", &Control_mesh::repair)
    .function("setPoint", set_point)
    .function("setNormal", set_normal)
    .function("setSharp", set_sharp)
    .function("detectCreases", detect_creases)
    .function("dropNormals", &Control_mesh::drop_normals)
    .function("estimateNormals", &Control_mesh::estimate_normals)
    .function("setRoundness", set_roundness)
    .function("estimateRoundness", estimate_roundness)
    .function("takeNormalsOfSphere", &Control_mesh::take_normals_of_sphere);
  class_<Refined_surface>("RefinedSurface")
    .function("follow", follow)
    .function("update", update)
    .function("showLimit", show_limit)
    .function("hideLimit", &Refined_surface::hide_limit)
    .function("curvature", curvature)
    .function("positionsView", positions_view)
    .function("normalsView", normals_view)
    .function("triangles", triangles)
    .function("points", points_of)
    .function("controlNormals", control_normals_of)
    .function("roundness", roundness_of)
    .function("uv", uv_of)
    .function("sides", sides_of)
    .function("faces", faces_of);
  function("readMesh", read_mesh);
  function("restoreMesh", restore_mesh);
  function("refine", refine, allow_raw_pointers());
  function("schemes", scheme_list);
  function("splitFaces", split_faces);
  function("refineCurve", refine_curve);
  function("estimateCurveNormals", estimate_curve_normals);
}

} // namespace pn_demo
