// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/mesh_normals.h"

#include <array>
#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace pn_subdivide {

void set_vertex_normals(Mesh_data& mesh, Zero_normals zero)
{
  const Different_values different(mesh, mesh.corner_normals);
  mesh.normals.resize(mesh.points.size(), Triple{0, 0, 0});
  std::vector<int> number(mesh.points.size(), 0); // of different normals; 2: more than one
  bool all_same = true;
  for (std::size_t i = 0; i < different.values.size(); ++i) {
    if (zero == Zero_normals::are_left_out && is_zero(different.values[i])) continue;
    const Index v = different.vertex[i];
    Triple& n = mesh.normals[v];
    if (number[v] == 0)
      n = different.values[i];
    else
      for (std::size_t k = 0; k < 3; ++k) n[k] += different.values[i][k];
    number[v] = (std::min)(number[v] + 1, 2);
    all_same = all_same && number[v] == 1;
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (number[v] == 2) mesh.normals[v] = normalized(mesh.normals[v]);
  if (all_same) mesh.corner_normals.clear();
}

void set_several_normals(Mesh_data& mesh, std::vector<Corner_normal>&& normals)
{
  std::unordered_map<Index, std::vector<Triple>> different;
  for (const Corner_normal& n : normals) {
    std::vector<Triple>& of_vertex = different[n.vertex];
    const auto is_same = [&](const Triple& other) { return are_equal(other, n.normal); };
    if (std::none_of(of_vertex.begin(), of_vertex.end(), is_same)) of_vertex.push_back(n.normal);
  }
  bool all_same = true;
  for (const auto& [v, values] : different) {
    Triple sum = values[0];
    for (std::size_t i = 1; i < values.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += values[i][k];
    mesh.normals[v] = values.size() == 1 ? sum : normalized(sum);
    all_same = all_same && values.size() == 1;
  }
  for (const Corner_normal& n : normals)
    all_same = all_same && (mesh.roundness.empty() || n.roundness == mesh.roundness[n.vertex]);
  if (!all_same) mesh.several_normals = std::move(normals);
}

void set_vertex_roundness(Mesh_data& mesh)
{
  if (mesh.corner_roundness.empty()) return;
  std::vector<double> least(mesh.points.size(), 2);
  const std::vector<Index>& vertices = mesh.vertices_of_corners();
  for (std::size_t c = 0; c < vertices.size(); ++c)
    least[vertices[c]] = (std::min)(least[vertices[c]], mesh.corner_roundness[c]);
  bool all_same = true, all_round = mesh.roundness.empty();
  for (std::size_t c = 0; c < vertices.size(); ++c) {
    all_same = all_same && mesh.corner_roundness[c] == least[vertices[c]];
    all_round = all_round && mesh.corner_roundness[c] == 1;
  }
  mesh.roundness.resize(all_round ? 0 : mesh.points.size(), 1);
  for (std::size_t v = 0; v < mesh.roundness.size(); ++v)
    if (least[v] < 2) mesh.roundness[v] = least[v];
  if (all_same) mesh.corner_roundness.clear();
}

std::size_t vertices_with_several_normals(const Mesh_data& mesh)
{
  std::vector<Triple> first(mesh.points.size(), Triple{0, 0, 0});
  std::vector<bool> has_several(mesh.points.size(), false);
  for (std::size_t c = 0; c < mesh.corner_normals.size(); ++c) {
    const Index v = mesh.vertices_of_corners()[c];
    const Triple& n = mesh.corner_normals[c];
    if (normalized(n) == Triple{0, 0, 0}) continue;
    if (first[v] == Triple{0, 0, 0}) first[v] = n;
    if (directions_differ(first[v], n)) has_several[v] = true;
  }
  return static_cast<std::size_t>(std::count(has_several.begin(), has_several.end(), true));
}

Different_values::Different_values(const Mesh_data& mesh, const std::vector<Triple>& of_corners)
{
  const std::vector<Index>& vertex_of = mesh.vertices_of_corners();
  std::vector<std::size_t> order(of_corners.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (vertex_of[a] != vertex_of[b]) return vertex_of[a] < vertex_of[b];
    return are_equal(of_corners[a], of_corners[b]) ? a < b : is_less(of_corners[a], of_corners[b]);
  });
  std::vector<std::size_t> first(of_corners.size()); // corner with the same vertex and value
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t c = order[i];
    const bool is_new = i == 0 || vertex_of[order[i - 1]] != vertex_of[c] ||
                        !are_equal(of_corners[order[i - 1]], of_corners[c]);
    first[c] = is_new ? c : first[order[i - 1]];
  }
  of_corner.resize(of_corners.size());
  for (std::size_t c = 0; c < of_corners.size(); ++c) {
    of_corner[c] = first[c] == c ? values.size() : of_corner[first[c]];
    if (first[c] != c) continue;
    values.push_back(of_corners[c]);
    vertex.push_back(vertex_of[c]);
  }
}

Triple face_normal(const Mesh_data& mesh, std::size_t f)
{
  const Mesh_data::Face face = mesh.face(f);
  const Triple& origin = mesh.points[face.front()];
  double largest = 0; // so that no product overflows or vanishes
  for (const Index v : face)
    for (const double x : difference(mesh.points[v], origin))
      largest = std::fmax(largest, std::abs(x));
  if (!(largest > 0)) return {0, 0, 0};

  const auto side = [&](const Index& v) {
    Triple d = difference(mesh.points[v], origin);
    for (double& x : d) x /= largest;
    return d;
  };
  Triple before = side(face[1]), area = {0, 0, 0};
  for (std::ptrdiff_t i = 2; i < std::ptrdiff_t(face.size()); ++i) {
    const Triple now = side(face[i]), part = cross_product(before, now);
    if (i == 2)
      area = part; // with its signs of zero
    else
      for (std::size_t k = 0; k < 3; ++k) area[k] += part[k];
    before = now;
  }
  return normalized(area);
}

namespace {

// `function(normal)` for each corner that has a normal; without the sorting that slots cost.
template <class Function>
void for_each_normal(const Mesh_data& mesh, std::size_t f, const Function& function)
{
  std::size_t corner = mesh.first_corner(f);
  for (const Index v : mesh.face(f)) {
    const Triple& n = mesh.corner_normals.empty() ? mesh.normals[v] : mesh.corner_normals[corner];
    if (!is_zero(n)) function(n);
    ++corner;
  }
}

// Directions, where those that do not differ count once.
class Directions
{
public:
  void add(const Triple& normal)
  {
    if (normal == last_) return;
    last_ = normal;
    const Triple n = normalized(normal);
    if (is_known(n)) return;
    cells_[key({cell(n[0]), cell(n[1]), cell(n[2])})].push_back(n);
    ++number_;
  }
  std::size_t number() const { return number_; }

private:
  static constexpr double size = 1. / 128,
                          reach = 0.002; // directions that do not differ are closer

  static int cell(double x) { return int(std::floor(x / size)); }
  static std::uint32_t key(const std::array<int, 3>& cell)
  {
    std::uint32_t k = 0;
    for (const int c : cell) k = k << 9u | std::uint32_t(c + 256);
    return k;
  }

  bool is_known(const Triple& n) const
  {
    for (int i = cell(n[0] - reach); i <= cell(n[0] + reach); ++i)
      for (int j = cell(n[1] - reach); j <= cell(n[1] + reach); ++j)
        for (int k = cell(n[2] - reach); k <= cell(n[2] + reach); ++k) {
          const auto found = cells_.find(key({i, j, k}));
          if (found != cells_.end() &&
              std::any_of(found->second.begin(), found->second.end(),
                          [&n](const Triple& m) { return !directions_differ(m, n); }))
            return true;
        }
    return false;
  }

  std::unordered_map<std::uint32_t, std::vector<Triple>> cells_;
  Triple last_ = {0, 0, 0};
  std::size_t number_ = 0;
};

double corner_angle(const Mesh_data& mesh, std::size_t f, std::size_t i)
{
  const Mesh_data::Face face = mesh.face(f);
  const auto n = static_cast<std::size_t>(face.size());
  const auto towards = [&](std::size_t j) {
    return normalized(difference(mesh.points[face.begin()[j % n]], mesh.points[face.begin()[i]]));
  };
  const Triple a = towards(i + 1), b = towards(i + n - 1), c = cross_product(a, b);
  return std::atan2(std::hypot(c[0], c[1], c[2]), scalar_product(a, b));
}

// Nearly all files have none, and this is soon known.
bool has_opposing_corner(const Mesh_data& mesh)
{
  bool result = false;
  for (std::size_t f = 0; f < mesh.number_of_faces() && !result; ++f) {
    const Triple m = face_normal(mesh, f);
    for_each_normal(mesh, f, [&](const Triple& n) { result = result || scalar_product(m, n) < 0; });
  }
  return result;
}

constexpr double right_angle = -1e-6; // cosines below are no right angles but for rounding

// For each normal whether it opposes all faces that have it.
std::vector<bool> oppose_all(const Mesh_data& mesh, const Normal_slots& slots)
{
  std::vector<bool> result(slots.size(), false), is_seen(slots.size(), false);
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Triple m = face_normal(mesh, f);
    if (is_zero(m)) continue;
    slots.for_each(f, [&](std::size_t, std::size_t slot, const Triple& n) {
      const bool opposes = scalar_product(normalized(n), m) < right_angle;
      result[slot] = opposes && (result[slot] || !is_seen[slot]);
      is_seen[slot] = true;
    });
  }
  return result;
}

void turn(Triple& n)
{
  for (double& x : n) x = -x;
}

void turn_corners(Mesh_data& mesh, const Normal_slots& slots, const std::vector<bool>& is_turned)
{
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    slots.for_each(f, [&](std::size_t i, std::size_t slot, const Triple&) {
      if (is_turned[slot]) turn(mesh.corner_normals[mesh.first_corner(f) + i]);
    });
  set_vertex_normals(mesh);
  mesh.vertices_with_several_normals =
    mesh.has_corner_normals() ? vertices_with_several_normals(mesh) : 0;
}

} // namespace

bool are_all_zero(const Mesh_data& mesh)
{
  return std::all_of(mesh.normals.begin(), mesh.normals.end(), is_zero) &&
         std::all_of(mesh.corner_normals.begin(), mesh.corner_normals.end(), is_zero);
}

Flat_shading find_flat_shading(const Mesh_data& mesh)
{
  if (!mesh.has_normals()) return {};
  Directions directions;
  bool is_flat = true;
  for (std::size_t f = 0; f < mesh.number_of_faces() && is_flat; ++f) {
    const Triple m = face_normal(mesh, f);
    if (is_zero(m)) continue;
    for_each_normal(mesh, f, [&](const Triple& n) {
      is_flat = is_flat && !directions_differ(m, n);
      if (is_flat) directions.add(n);
    });
  }
  if (!is_flat || directions.number() == 0) return {};
  return {directions.number(), mesh.number_of_faces()};
}

Opposing_normals find_opposing_normals(const Mesh_data& mesh)
{
  Opposing_normals result;
  if (!mesh.has_normals() || !has_opposing_corner(mesh)) return result;
  const Normal_slots slots(mesh);
  std::vector<double> along(slots.size(), 0); // the normal times the sum of those of its faces
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Triple m = face_normal(mesh, f);
    if (is_zero(m)) continue;
    slots.for_each(f, [&](std::size_t i, std::size_t slot, const Triple& n) {
      along[slot] += corner_angle(mesh, f, i) * scalar_product(normalized(n), m);
    });
  }
  for (std::size_t slot = 0; slot < slots.size(); ++slot) {
    result.of += along[slot] != 0;
    if (along[slot] < right_angle) result.add(mesh.original(slots.vertex(slot)));
  }
  if (result.number > 0) {
    result.first_vertex = mesh.number_in_file(result.first_vertex);
    const std::vector<bool> all = oppose_all(mesh, slots);
    result.of_all_faces = std::size_t(std::count(all.begin(), all.end(), true));
  }
  return result;
}

Opposing_normals turn_opposing_normals(Mesh_data& mesh)
{
  Opposing_normals turned;
  if (!mesh.has_normals() || !has_opposing_corner(mesh)) return turned;
  const Normal_slots slots(mesh);
  const std::vector<bool> is_turned = oppose_all(mesh, slots);
  for (std::size_t slot = 0; slot < slots.size(); ++slot)
    if (is_turned[slot]) turned.add(mesh.original(slots.vertex(slot)));
  turned.of_all_faces = turned.number;
  if (turned.number == 0) return turned;
  turned.first_vertex = mesh.number_in_file(turned.first_vertex); // searches, so once
  if (!mesh.corner_normals.empty()) {
    turn_corners(mesh, slots, is_turned);
    return turned;
  }
  for (std::size_t v = 0; v < mesh.normals.size(); ++v)
    if (is_turned[v]) turn(mesh.normals[v]);
  return turned;
}

} // namespace pn_subdivide
