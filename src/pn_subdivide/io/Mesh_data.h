// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_MESH_DATA_H
#define PN_SUBDIVIDE_MESH_DATA_H

#include "io/Attributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pn_subdivide {

// The meaning of the normals of a mesh: data for a further round, normals of its faces, or normals of the surface that
// the rounds lead to.
enum class Normal_kind { control, of_mesh, of_surface };

// by which files say so: "control normals"
const char* comment_of(Normal_kind kind);
// Where no comment says anything they are control normals.
Normal_kind normal_kind_of(const std::vector<std::string>& comments);
// Does a comment say that they are?
bool are_said_to_be_control(const std::vector<std::string>& comments);

// With how many digits a text has vectors. Trailing zeros may be left out and vectors may have any length, so the
// largest coordinates count, and among these the one with the most digits.
class Written_digits
{
public:
  void see(const std::array<std::string_view, 3>& words, const std::array<double, 3>& vector);
  // for whole numbers that are no text
  void see_whole_number() { see("1"); }

  // What the last digit of a vector counts; 0 where nothing has been seen, as in binary files.
  double unit(const std::array<double, 3>& vector) const;

private:
  void see(std::string_view word);

  int decimals_ = none, significant_ = none;
  static constexpr int none = -1000;
};

// What is sharp in a mesh, by the numbers of its vertices in the file.
struct Crease_tags
{
  struct Edge
  {
    std::array<std::uint32_t, 2> ends;
    double sharpness; // greater than 0; infinite for ever
    // unit tangents at the ends, along the edge and into it; zero where there is none
    std::array<std::array<double, 3>, 2> tangents;
  };

  std::vector<Edge> edges;
  std::vector<double> vertices; // sharpness, or empty

  bool any() const { return !edges.empty() || !vertices.empty(); }
};

using Index = std::uint32_t;          // of a vertex
using Triple = std::array<double, 3>; // a point or a vector; a kernel's would cost compile time
using Color = std::array<std::uint8_t, 3>; // red, green, blue

// Normals of the faces: how many different normals there are, on how many faces. If they are few, or the faces large, the
// edges are meant to be seen; many such normals are there for want of better normals.
struct Flat_shading
{
  std::size_t normals = 0, faces = 0; // 0: no flat shading

  bool is_there() const { return normals > 0; }
  bool makes_creases() const { return normals <= 6 || faces >= 20 * normals; }
};

// Normals for shading, which a modeling program has averaged from normals of faces: how they are weighted, and how many
// normals of the file agree.
struct Shading
{
  const char* weights = nullptr; // "weighted by angle"
  std::size_t normals = 0, of = 0;

  bool is_there() const { return weights != nullptr; }
};

// How many of something a file has, and where the first one is, for people: "line 7".
struct Places
{
  std::size_t number = 0;
  std::string first;

  void add(const std::string& place)
  {
    if (number++ == 0) first = place;
  }
};

struct Corner_normal
{
  std::size_t corner;
  std::uint32_t vertex;
  Triple normal;
  double roundness = 1;
};

// A polygon soup as the files hold it: nothing is said about manifoldness or orientation.
// `normals` is empty or has one vector per point, zero where a point has no control normal.
// `corner_normals` is empty but where corners of one vertex have different normals; then it has one
// vector per corner, face by face, and `normals` has the normalized sum of the different ones. Refined meshes have
// `several_normals` in its place, of the corners of those vertices only.
class Mesh_data
{
public:
  using Index = pn_subdivide::Index;
  // The vertices of a face, in its place among all corners. No range of Boost's: its headers took a quarter of the time
  // that the files about files take to compile.
  class Face
  {
  public:
    Face(const Index* begin, const Index* end)
      : begin_(begin)
      , end_(end)
    {}

    const Index* begin() const { return begin_; }
    const Index* end() const { return end_; }
    std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
    Index front() const { return *begin_; }
    Index operator[](std::ptrdiff_t i) const { return begin_[i]; }

  private:
    const Index *begin_, *end_;
  };
  static constexpr std::size_t max_number_of_points = std::numeric_limits<Index>::max();

  std::vector<Triple> points;
  std::vector<Triple> normals, corner_normals;
  std::vector<Corner_normal> several_normals;     // in the order of the corners
  Normal_kind normal_kind = Normal_kind::control; // of these
  // That of each point, besides its control normals; empty: 1 everywhere, or not known. Where corners of one vertex have
  // different ones it is the least, and all are in the other list.
  std::vector<double> roundness, corner_roundness;
  // to be written beside these, if they are not themselves control normals
  std::vector<Triple> control_normals, corner_control_normals;
  Attributes attributes;
  Crease_tags tags;

  // What the file says and this does not hold, for people: "materials".
  std::vector<std::string> dropped;
  Places short_faces;    // of less than three vertices: they are not among the faces
  Places broken_normals; // that are not finite: here they are zero
  // Vertices that the file gives normals in clearly different directions; they have the normalized
  // sum.
  std::size_t vertices_with_several_normals = 0;
  Flat_shading flat_shading;
  Shading shading;
  Written_digits digits_of_normals;    // in the file
  bool are_said_to_be_control = false; // the normals, by the file itself

  // For each vertex of the file the number of the vertex that it was merged into (empty: its own), and for each of the last
  // vertices the number of the vertex that it is a copy of.
  std::vector<Index> merged_into, copied_from;

  // the vertex that v is a copy of, or v
  Index original(Index v) const
  {
    const std::size_t copies_begin = points.size() - copied_from.size();
    while (v >= copies_begin) v = copied_from[v - copies_begin];
    return v;
  }
  // for messages; merged vertices have the number of the first
  Index number_in_file(Index v) const
  {
    v = original(v);
    if (merged_into.empty()) return v;
    return Index(std::find(merged_into.begin(), merged_into.end(), v) - merged_into.begin());
  }

  bool has_normals() const { return !normals.empty(); }
  bool has_corner_normals() const { return !corner_normals.empty() || !several_normals.empty(); }
  bool has_control_normals() const { return !control_normals.empty(); }
  void take_normals(Mesh_data& other)
  {
    normals = std::move(other.normals);
    corner_normals = std::move(other.corner_normals);
  }
  void take_roundness(Mesh_data& other)
  {
    roundness = std::move(other.roundness);
    corner_roundness = std::move(other.corner_roundness);
  }
  void drop_normals()
  {
    normals.clear();
    corner_normals.clear();
    vertices_with_several_normals = 0;
  }
  void drop(const std::string& what)
  {
    if (std::find(dropped.begin(), dropped.end(), what) == dropped.end()) dropped.push_back(what);
  }
  // The normal of a file, or none if it is not finite; place() says where it is.
  template <class Place>
  Triple finite_normal(const Triple& n, const Place& place)
  {
    if (std::isfinite(n[0]) && std::isfinite(n[1]) && std::isfinite(n[2])) return n;
    broken_normals.add(place());
    return {0, 0, 0};
  }
  std::size_t number_of_faces() const { return face_end_.size(); }
  std::size_t number_of_corners() const { return corners_.size(); }

  Face face(std::size_t f) const
  {
    return Face(corners_.data() + first_corner(f), corners_.data() + face_end_[f]);
  }
  // Corners are numbered through all faces.
  std::size_t first_corner(std::size_t f) const { return f == 0 ? 0 : face_end_[f - 1]; }

  template <class Index_range>
  void add_face(const Index_range& vertices)
  {
    for (const auto& v : vertices) corners_.push_back(static_cast<Index>(v));
    face_end_.push_back(corners_.size());
  }

  void reserve_faces(std::size_t faces, std::size_t corners)
  {
    face_end_.reserve(faces);
    corners_.reserve(corners);
  }

  // Vertex v of the faces becomes numbers[v].
  void renumber_vertices(const std::vector<Index>& numbers)
  {
    for (Index& v : corners_) v = numbers[v];
  }

  // Those of all corners, one face after the other.
  const std::vector<Index>& vertices_of_corners() const { return corners_; }
  void set_vertices(std::vector<Index> corners) { corners_ = std::move(corners); }

  // Calls f(values) for each array of values of vertices, whether these are there or not.
  template <class Function>
  void for_each_array_of_vertices(const Function& f)
  {
    f(points);
    f(normals);
    f(control_normals);
    f(roundness);
    f(tags.vertices);
    for (Column& column : attributes.of_vertices) f(column.values);
  }

  void take_faces(Mesh_data& other)
  {
    corners_ = std::move(other.corners_);
    face_end_ = std::move(other.face_end_);
  }
  // It begins with the same vertex.
  void reverse_face(std::size_t f)
  {
    std::reverse(corners_.begin() + std::ptrdiff_t(first_corner(f) + 1),
                 corners_.begin() + std::ptrdiff_t(face_end_[f]));
  }

  void clear_faces()
  {
    corners_.clear();
    face_end_.clear();
  }

private:
  std::vector<Index> corners_;        // the faces' vertices, one face after the other
  std::vector<std::size_t> face_end_; // where each face ends in `corners_`
};

// The smallest box along the axes that holds the points; there must be one.
struct Bounding_box
{
  explicit Bounding_box(const std::vector<Triple>& points);

  Triple low, high;
};

double diagonal_of(const Bounding_box& box);

// A power of 2 that makes points about as large as 1, so that no product overflows or vanishes.
double scale_to_unit_size(const std::vector<Triple>& points);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_MESH_DATA_H
