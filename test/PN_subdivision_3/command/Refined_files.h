// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_TEST_REFINED_FILES_H
#define PN_TEST_REFINED_FILES_H

#include "Command_test.h"
#include "Part_files.h"

#include "io/mesh_io.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace pn_subdivide {

// Compares all that meshes have but attributes, to rounding, whatever numbers their vertices, edges and faces have.
class Mesh_comparison
{
public:
  Mesh_comparison(const Mesh_data& expected, const Mesh_data& mesh)
    : expected_(expected)
    , mesh_(mesh)
  {}

  void operator()()
  {
    const Mesh_data &expected = expected_, &mesh = mesh_;
    ASSERT_EQ(mesh.points.size(), expected.points.size());
    ASSERT_EQ(mesh.number_of_faces(), expected.number_of_faces());
    ASSERT_EQ(mesh.tags.edges.size(), expected.tags.edges.size());
    std::vector<std::size_t> all;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      std::size_t best = 0;
      for (std::size_t w = 1; w < expected.points.size(); ++w)
        if (distance(expected.points[w], mesh.points[v]) <
            distance(expected.points[best], mesh.points[v]))
          best = w;
      number_.push_back(Index(best));
      all.push_back(v);
    }
    EXPECT_EQ(std::set<Index>(number_.begin(), number_.end()).size(), number_.size());
    const std::vector<std::size_t> numbers(number_.begin(), number_.end());
    compare("point", expected.points, numbers, mesh.points, all);
    compare("normal", expected.normals, numbers, mesh.normals, all);
    compare("control normal", expected.control_normals, numbers, mesh.control_normals, all);
    if (expected.corner_roundness.empty()) // else a vertex has that of one of its corners
      compare("roundness", expected.roundness, numbers, mesh.roundness, all);
    compare("sharpness", expected.tags.vertices, numbers, mesh.tags.vertices, all);
    compare_faces();
    compare_edges();
  }

private:
  using Index = Mesh_data::Index;

  static double distance(double x, double y) { return x == y ? 0 : std::abs(x - y); }
  static double distance(const Triple& p, const Triple& q) { return pn_subdivide::distance(p, q); }
  template <class Values>
  static void compare(const char* what, const Values& expected, const std::vector<std::size_t>& i,
                      const Values& values, const std::vector<std::size_t>& j)
  {
    ASSERT_EQ(values.size(), expected.size()) << what;
    for (std::size_t k = 0; k < i.size() && !values.empty(); ++k)
      EXPECT_LE(distance(values[j[k]], expected[i[k]]), 1e-10) << what << " " << j[k];
  }

  // the corners of a face, from that of the least vertex on; the numbers become those of the vertices
  static std::vector<std::size_t> rotated(std::vector<Index>& face, std::size_t first)
  {
    std::vector<std::size_t> corners(face.size());
    const auto least = std::min_element(face.begin(), face.end()) - face.begin();
    for (std::size_t i = 0; i < face.size(); ++i)
      corners[i] = first + (i + std::size_t(least)) % face.size();
    std::rotate(face.begin(), face.begin() + least, face.end());
    return corners;
  }
  void compare_faces() const
  {
    std::map<std::vector<Index>, std::vector<std::size_t>> corners;
    for (std::size_t f = 0; f < expected_.number_of_faces(); ++f) {
      std::vector<Index> face(expected_.face(f).begin(), expected_.face(f).end());
      const auto of_face = rotated(face, expected_.first_corner(f));
      corners[face] = of_face;
    }
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f) {
      std::vector<Index> face;
      for (const Index v : mesh_.face(f)) face.push_back(number_[v]);
      const auto of_face = rotated(face, mesh_.first_corner(f));
      const auto it = corners.find(face);
      ASSERT_TRUE(it != corners.end()) << f;
      const std::vector<std::size_t>& expected = it->second;
      compare("normal of corner", expected_.corner_normals, expected, mesh_.corner_normals,
              of_face);
      compare("control normal of corner", expected_.corner_control_normals, expected,
              mesh_.corner_control_normals, of_face);
      compare("roundness of corner", expected_.corner_roundness, expected, mesh_.corner_roundness,
              of_face);
    }
  }
  void compare_edges() const
  {
    std::map<std::array<Index, 2>, Crease_tags::Edge> edges;
    for (const Crease_tags::Edge& e : expected_.tags.edges) edges[e.ends] = e;
    for (const Crease_tags::Edge& e : mesh_.tags.edges) {
      auto it = edges.find({number_[e.ends[0]], number_[e.ends[1]]});
      const bool is_turned = it == edges.end();
      if (is_turned) it = edges.find({number_[e.ends[1]], number_[e.ends[0]]});
      ASSERT_TRUE(it != edges.end());
      EXPECT_LE(distance(e.sharpness, it->second.sharpness), 1e-10);
      for (const std::size_t i : {0, 1})
        EXPECT_LE(distance(e.tangents[i], it->second.tangents[is_turned ? 1 - i : i]), 1e-10);
    }
  }

  const Mesh_data& expected_;
  const Mesh_data& mesh_;
  std::vector<Index> number_; // of each vertex of the mesh in the other one
};

inline void expect_same_but_for_numbers(const Mesh_data& expected, const Mesh_data& mesh)
{
  Mesh_comparison(expected, mesh)();
}

// Has every edge two faces that run along it the other way round?
inline bool is_watertight(const Mesh_data& mesh)
{
  std::set<std::pair<std::size_t, std::size_t>> sides;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto face = mesh.face(f);
    for (auto v = face.begin(); v != face.end(); ++v)
      if (!sides.insert({*v, v + 1 == face.end() ? *face.begin() : *(v + 1)}).second) return false;
  }
  return std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
    return sides.count({side.second, side.first}) == 1;
  });
}

// the ends of the sides of a face
inline std::vector<std::array<Triple, 2>> sides(const Mesh_data& mesh, std::size_t f)
{
  std::vector<std::array<Triple, 2>> result;
  const auto face = mesh.face(f);
  for (auto v = face.begin(); v != face.end(); ++v)
    result.push_back(
      {mesh.points[*v], mesh.points[v + 1 == face.end() ? *face.begin() : *(v + 1)]});
  return result;
}

// by Newell's formula, about the first corner
inline Triple area_vector(const Mesh_data& mesh, std::size_t f)
{
  const Triple& o = mesh.points[mesh.face(f).front()];
  Triple area{};
  for (const auto& [p, q] : sides(mesh, f))
    area = sum(area, cross(difference(p, o), difference(q, o)), 0.5);
  return area;
}

// of the faces from `begin` to `end`
inline double volume(const Mesh_data& mesh, std::size_t begin, std::size_t end)
{
  double sum = 0;
  const Triple& o = mesh.points[mesh.face(begin).front()];
  for (std::size_t f = begin; f < end; ++f)
    sum += dot(difference(mesh.points[mesh.face(f).front()], o), area_vector(mesh, f)) / 3;
  return sum;
}
inline double volume(const Mesh_data& mesh)
{
  return volume(mesh, 0, mesh.number_of_faces());
}

// Files of the test's folder, refined by the command.
class Refined_files : public Command_test
{
protected:
  Outcome surface(const std::string& input, const std::string& output,
                  const std::string& options) const
  {
    return run("surface " + words(input, output) + "--quiet " + options);
  }

  std::string written(const std::string& input, const std::string& output,
                      const std::string& options) const
  {
    const Outcome outcome = surface(input, output, options);
    EXPECT_EQ(outcome.code, 0) << options << outcome.err;
    return Temporary_folder::content(folder.file(output));
  }

  Mesh_data refined(const std::string& input, const std::string& output,
                    const std::string& options) const
  {
    written(input, output, options);
    return read_mesh(folder.file(output));
  }

  nlohmann::json report() const { return nlohmann::json::parse(content("r.json")); }
  std::string reported() const { return " --report '" + folder.file("r.json") + "' "; }
};

} // namespace pn_subdivide

#endif // PN_TEST_REFINED_FILES_H
