// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "io/Ply_header.h"
#include "io/Ply_values.h"
#include "io/formats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace pn_subdivide {
namespace {

std::string name_of(const Ply_element& element, std::size_t i)
{
  return Text_reader::printable(element.name) + " " + std::to_string(i) + " of " +
         std::to_string(element.size);
}

// The positions of three properties; `none` three times if the element has none of them.
std::array<std::size_t, 3> find_three(const Ply_element& element,
                                      const std::array<const char*, 3>& names)
{
  std::array<std::size_t, 3> positions;
  int found = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    positions[k] = element.find(names[k]);
    if (positions[k] == Ply_element::none) continue;
    ++found;
    if (element.properties[positions[k]].is_list)
      throw Error("the vertex property " + std::string(names[k]) + " is a list");
  }
  if (found != 0 && found != 3)
    throw Error("the vertices have only " + std::to_string(found) + " of the properties " +
                names[0] + " " + names[1] + " " + names[2]);
  return positions;
}

// A property that a mesh has no place for, as people call it.
std::string name_of_dropped(const std::string& property)
{
  static const char* const colors[] = {"red",         "green",         "blue",        "alpha",
                                       "diffuse_red", "diffuse_green", "diffuse_blue"};
  static const char* const texture[] = {"s", "t", "u", "v", "texture_u", "texture_v", "texcoord"};
  const auto is_one_of = [&](const auto& names) {
    return std::find(std::begin(names), std::end(names), property) != std::end(names);
  };
  if (is_one_of(colors)) return "colors";
  if (is_one_of(texture)) return "texture coordinates";
  return "the property '" + Text_reader::printable(property) + "'";
}

void note_what_is_dropped(const Ply_header& header, Mesh_data& mesh)
{
  static const std::array<const char*, 6> of_vertices = {"x", "y", "z", "nx", "ny", "nz"};
  static const std::array<const char*, 2> of_faces = {"vertex_indices", "vertex_index"};
  const auto drop_others = [&mesh](const Ply_element& element, const auto& known) {
    for (const Ply_property& p : element.properties)
      if (std::find(known.begin(), known.end(), p.name) == known.end())
        mesh.drop(name_of_dropped(p.name));
  };
  for (const Ply_element& element : header.elements) {
    if (element.size == 0) continue;
    if (element.name == "vertex")
      drop_others(element, of_vertices);
    else if (element.name == "face")
      drop_others(element, of_faces);
    else
      mesh.drop("the element '" + Text_reader::printable(element.name) + "'");
  }
}

class Ply_reader
{
public:
  Ply_reader(const std::string& content, const Ply_header& header, const Text_reader& behind_header)
    : header_(header)
    , values_(content, behind_header, header.format)
  {
    note_what_is_dropped(header, mesh_);
  }

  Mesh_data read()
  {
    bool has_vertices = false, has_faces = false;
    for (const Ply_element& element : header_.elements) {
      if (element.name == "vertex") {
        has_vertices = true;
        read_vertices(element);
      } else if (element.name == "face") {
        has_faces = true;
        read_faces(element);
      } else {
        skip(element);
      }
    }
    if (!has_vertices) throw Error("the PLY file has no element 'vertex'");
    if (!has_faces) throw Error("the PLY file has no element 'face', so it is not a mesh");
    if (!values_.at_end()) throw Error("more data than the PLY header announces");
    check_indices();
    return std::move(mesh_);
  }

private:
  // Reads element i; scalars go to `scalars_`, and the list `wanted_list` to `list_`.
  void read_item(const Ply_element& element, std::size_t i, std::size_t wanted_list)
  {
    try {
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const Ply_property& property = element.properties[k];
        if (property.is_list)
          read_list(property, k == wanted_list);
        else
          scalars_[k] = values_.next(property.type);
      }
    } catch (const Error& e) {
      throw Error(std::string(e.what()) + " (in " + name_of(element, i) + ")");
    }
  }

  void read_list(const Ply_property& property, bool wanted)
  {
    const double size = values_.next(property.size_type);
    if (!(size >= 0) || size != std::floor(size))
      throw Error("a list with a negative or broken length");
    if (size > static_cast<double>(values_.bytes_left())) throw Error("truncated");
    if (wanted) list_.clear();
    for (double i = 0; i < size; ++i) {
      const double x = values_.next(property.type);
      if (wanted) list_.push_back(x);
    }
  }

  void skip(const Ply_element& element)
  {
    if (element.properties.empty()) return;
    scalars_.assign(element.properties.size(), 0);
    for (std::size_t i = 0; i < element.size; ++i) read_item(element, i, Ply_element::none);
  }

  void read_vertices(const Ply_element& element)
  {
    const auto p = find_three(element, {"x", "y", "z"});
    const auto n = find_three(element, {"nx", "ny", "nz"});
    if (p[0] == Ply_element::none) throw Error("the vertices have no properties x y z");
    const bool has_normals = n[0] != Ply_element::none;
    if (element.size > Mesh_data::max_number_of_points) throw Error("too many vertices");

    const std::size_t plausible = std::min(element.size, values_.bytes_left() / 3);
    mesh_.points.reserve(plausible);
    if (has_normals) mesh_.normals.reserve(plausible);
    scalars_.assign(element.properties.size(), 0);
    for (std::size_t i = 0; i < element.size; ++i) {
      read_item(element, i, Ply_element::none);
      mesh_.points.push_back({scalars_[p[0]], scalars_[p[1]], scalars_[p[2]]});
      if (has_normals) mesh_.normals.push_back({scalars_[n[0]], scalars_[n[1]], scalars_[n[2]]});
    }
  }

  void read_faces(const Ply_element& element)
  {
    std::size_t indices = element.find("vertex_indices");
    if (indices == Ply_element::none) indices = element.find("vertex_index");
    if (indices == Ply_element::none || !element.properties[indices].is_list)
      throw Error("the faces have no list 'vertex_indices'");

    const std::size_t plausible = std::min(element.size, values_.bytes_left() / 4);
    mesh_.reserve_faces(plausible, 4 * plausible);
    scalars_.assign(element.properties.size(), 0);
    for (std::size_t i = 0; i < element.size; ++i) {
      read_item(element, i, indices);
      if (list_.size() < 3)
        throw Error(name_of(element, i) + " has " + std::to_string(list_.size()) + " vertices");
      for (const double v : list_)
        if (!(v >= 0 && v < 4294967295.0) || v != std::floor(v))
          throw Error(name_of(element, i) + " has a negative or broken vertex index");
      mesh_.add_face(list_);
    }
  }

  // Not earlier, because the faces may come before the vertices.
  void check_indices() const
  {
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f)
      for (const Mesh_data::Index v : mesh_.face(f))
        if (v >= mesh_.points.size())
          throw Error("face " + std::to_string(f) + ": the vertex index " + std::to_string(v) +
                      " is out of range, there are " + std::to_string(mesh_.points.size()) +
                      " vertices");
  }

  const Ply_header& header_;
  Ply_values values_;
  Mesh_data mesh_;
  std::vector<double> scalars_, list_;
};

} // namespace

Mesh_data read_ply(const std::string& content)
{
  Text_reader in(content, '\0');
  const Ply_header header = read_ply_header(in);
  return Ply_reader(content, header, in).read();
}

} // namespace pn_subdivide
