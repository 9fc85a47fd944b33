// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "io/Ply_header.h"
#include "io/formats.h"
#include "io/mesh_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

using Names = std::vector<std::string>;
const Names names_at_vertices = {"x",  "y",          "z",          "nx",         "ny",
                                 "nz", "control_nx", "control_ny", "control_nz", "roundness"};
const Names names_of_indices = {"vertex_indices", "vertex_index"};
const Names names_of_lists = {"vertex_indices", "vertex_index", texture_list, normals_list,
                              roundness_list};

// Faces as strips of triangles, one after the other in one list or several, with -1 between them.
constexpr const char* strips_element = "tristrips";

// They are read if there are no other faces.
bool has_strips(const Ply_header& header)
{
  bool result = false;
  for (const Ply_element& element : header.elements) {
    if (element.name == "face" && element.size > 0) return false;
    result = result || element.name == strips_element;
  }
  return result;
}

// Lists, but for those of indices and of texture coordinates, and elements other than vertices and
// faces.
void note_what_is_dropped(const Ply_header& header, const Ply_tags& tags, Mesh_data& mesh)
{
  for (const Ply_element& element : header.elements) {
    if (element.size == 0 || tags.is_edge(element)) continue;
    if (element.name == strips_element && has_strips(header)) continue;
    const bool is_face = element.name == "face";
    if (!is_face && element.name != "vertex") {
      // their names differ: drop() need not look for them
      mesh.dropped.push_back("the element '" + Text_reader::printable(element.name) + "'");
      continue;
    }
    for (const Ply_property& p : element.properties)
      if (p.is_list &&
          !(is_face && std::count(names_of_lists.begin(), names_of_lists.end(), p.name)))
        mesh.drop("the property '" + Text_reader::printable(p.name) + "'");
  }
}

class Ply_reader
{
public:
  Ply_reader(const std::string& content, const Ply_header& header, const Text_reader& behind_header,
             bool with_attributes)
    : header_(header)
    , tags_(header)
    , values_(content, behind_header, header.format)
    , with_attributes_(with_attributes)
  {
    if (with_attributes) note_what_is_dropped(header, tags_, mesh_);
  }

  Mesh_data read()
  {
    const bool by_strips = has_strips(header_);
    bool has_vertices = false, has_faces = false;
    for (const Ply_element& element : header_.elements) {
      if (element.name == "vertex") {
        has_vertices = true;
        read_vertices(element);
      } else if (element.name == "face") {
        has_faces = true;
        read_faces(element);
      } else if (by_strips && element.name == strips_element) {
        has_faces = true;
        read_strips(element);
      } else if (tags_.is_edge(element)) {
        read_edges(element);
      } else {
        skip(element);
      }
    }
    if (!has_vertices) throw Error("the PLY file has no element 'vertex'");
    if (!has_faces)
      throw Error("the PLY file has no element 'face' and no 'tristrips', so it is not a mesh");
    if (!values_.at_end()) throw Error("more data than the PLY header announces");
    check_indices();
    put_corner_values();
    if (with_attributes_) read_ply_comments(header_.comments, mesh_.attributes);
    return std::move(mesh_);
  }

private:
  struct Lists
  {
    // their positions
    std::size_t indices = Ply_element::none, texture = Ply_element::none,
                normals = Ply_element::none, roundness = Ply_element::none;
  };

  // A list of each face with as many numbers for each corner, or empty.
  struct Corner_list
  {
    const char* name;
    std::size_t dimension;
    const char* numbers;                 // what they are, for messages
    bool is_there = false;               // in the file
    std::vector<double> of_face = {};    // that is read
    std::vector<double> of_all = {};     // face by face, of those whose list is not empty
    std::vector<std::size_t> faces = {}; // these
  };

  // Reads element i; scalars go to `scalars_`, the lists to `indices_`, `texture_` and the lists of corners.
  void read_item(const Ply_element& element, std::size_t i, const Lists& lists)
  {
    try {
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const Ply_property& property = element.properties[k];
        if (property.is_list)
          read_list(property, k == lists.indices     ? &indices_
                              : k == lists.texture   ? &texture_
                              : k == lists.normals   ? &normals_.of_face
                              : k == lists.roundness ? &roundness_.of_face
                                                     : nullptr);
        else
          scalars_[k] = columns_.carries(k) ? values_.next(property) : values_.next(property.type);
        if (k < words_.size()) words_[k] = values_.word();
      }
    } catch (const Error& e) {
      throw Error(std::string(e.what()) + " (in " + name_of(element, i) + ")");
    }
  }

  void read_list(const Ply_property& property, std::vector<double>* list)
  {
    const double size = values_.next(property.size_type);
    if (!(size >= 0) || size != std::floor(size))
      throw Error("a list with a negative or broken length");
    if (size > static_cast<double>(values_.bytes_left())) throw Error("truncated");
    if (list != nullptr) list->clear();
    for (double i = 0; i < size; ++i) {
      const double x = list == &texture_ ? values_.next(property) : values_.next(property.type);
      if (list != nullptr) list->push_back(x);
    }
  }

  // For the scalars of an element, which are carried but for those of the given names.
  void begin(const Ply_element& element, const std::vector<std::string>& others)
  {
    scalars_.assign(element.properties.size(), 0);
    columns_ = with_attributes_ ? Ply_columns(element, others) : Ply_columns();
    const std::size_t properties = (std::max)(element.properties.size(), std::size_t(1));
    columns_.reserve(std::min(element.size, values_.bytes_left() / properties));
  }

  void skip(const Ply_element& element)
  {
    if (element.properties.empty()) return;
    scalars_.assign(element.properties.size(), 0);
    columns_ = Ply_columns();
    for (std::size_t i = 0; i < element.size; ++i) read_item(element, i, Lists());
  }

  void read_vertices(const Ply_element& element)
  {
    const auto p = find_three(element, {"x", "y", "z"});
    const auto control = find_three(element, {"control_nx", "control_ny", "control_nz"});
    const bool has_control = control[0] != Ply_element::none;
    const auto n = has_control ? control : find_three(element, {"nx", "ny", "nz"});
    if (!has_control) mesh_.normal_kind = normal_kind_of(header_.comments);
    mesh_.are_said_to_be_control = has_control || are_said_to_be_control(header_.comments);
    if (p[0] == Ply_element::none) throw Error("the vertices have no properties x y z");
    const bool has_normals = n[0] != Ply_element::none;
    if (element.size > Mesh_data::max_number_of_points) throw Error("too many vertices");

    const std::size_t plausible = std::min(element.size, values_.bytes_left() / 3);
    mesh_.points.reserve(plausible);
    if (has_normals) mesh_.normals.reserve(plausible);
    Names others = names_at_vertices;
    const std::size_t roundness = element.find("roundness");
    if (roundness != Ply_element::none && element.properties[roundness].is_list)
      throw Error("the vertex property roundness is a list");
    const std::size_t sharpness = tags_.any() ? element.find("sharpness") : Ply_element::none;
    if (sharpness != Ply_element::none) others.emplace_back("sharpness");
    begin(element, others);
    if (has_normals && values_.is_text()) words_.resize(element.properties.size());
    for (std::size_t i = 0; i < element.size; ++i) {
      read_item(element, i, Lists());
      mesh_.points.push_back({scalars_[p[0]], scalars_[p[1]], scalars_[p[2]]});
      if (has_normals) add_normal(element, n, i);
      if (roundness != Ply_element::none) mesh_.roundness.push_back(scalars_[roundness]);
      columns_.add(scalars_);
      if (sharpness != Ply_element::none) add_sharpness(element, i, scalars_[sharpness]);
    }
    words_.clear();
    mesh_.attributes.of_vertices = columns_.take();
    for (const Column* column : find_texture(mesh_.attributes.of_vertices))
      for (std::size_t i = 0; i < element.size; ++i)
        require_finite_texture(column->values[i], element, i);
  }

  void add_normal(const Ply_element& element, const std::array<std::size_t, 3>& n, std::size_t i)
  {
    mesh_.normals.push_back(mesh_.finite_normal({scalars_[n[0]], scalars_[n[1]], scalars_[n[2]]},
                                                [i] { return "vertex " + std::to_string(i); }));
    Written_digits& digits = mesh_.digits_of_normals;
    if (values_.is_text())
      digits.see({words_[n[0]], words_[n[1]], words_[n[2]]}, mesh_.normals.back());
    else if (traits(element.properties[n[0]].type).is_integer)
      digits.see_whole_number();
  }

  void add_sharpness(const Ply_element& element, std::size_t i, double x)
  {
    try {
      require_sharpness(x);
    } catch (const Error& e) {
      throw Error(name_of(element, i) + " has " + e.what());
    }
    if (!(x > 0)) return;
    mesh_.tags.vertices.resize(element.size, 0.);
    mesh_.tags.vertices[i] = x;
  }

  void read_edges(const Ply_element& element)
  {
    begin(element, {});
    columns_ = Ply_columns();
    std::size_t vertices = 0;
    for (const Ply_element& other : header_.elements)
      if (other.name == "vertex") vertices = other.size;
    for (std::size_t i = 0; i < element.size; ++i) {
      read_item(element, i, Lists());
      try {
        tags_.add_edge(scalars_, vertices, mesh_.tags);
      } catch (const Error& e) {
        throw Error(name_of(element, i) + ": " + e.what());
      }
    }
  }

  static void require_finite_texture(double x, const Ply_element& element, std::size_t i)
  {
    if (!std::isfinite(x))
      throw Error(name_of(element, i) + " has a texture coordinate that is not finite" +
                  reading_without_it);
  }

  static std::size_t list_of_indices(const Ply_element& element)
  {
    std::size_t list = element.find("vertex_indices");
    if (list == Ply_element::none) list = element.find("vertex_index");
    if (list == Ply_element::none || !element.properties[list].is_list)
      throw Error("the element '" + element.name + "' has no list 'vertex_indices'");
    return list;
  }

  static void require_index(double v, const Ply_element& element, std::size_t i)
  {
    if (!(v >= 0 && v < 4294967295.0) || v != std::floor(v))
      throw Error(name_of(element, i) + " has a negative or broken vertex index");
  }

  // Every second triangle of a strip goes the other way round. Strips are joined by triangles that visit a vertex twice.
  void read_strips(const Ply_element& element)
  {
    Lists lists;
    lists.indices = list_of_indices(element);
    scalars_.assign(element.properties.size(), 0);
    columns_ = Ply_columns();
    for (std::size_t i = 0; i < element.size; ++i) {
      read_item(element, i, lists);
      std::size_t length = 0; // of the strip so far
      for (auto v = indices_.begin(); v != indices_.end(); ++v) {
        if (*v == -1) {
          length = 0;
          continue;
        }
        require_index(*v, element, i);
        if (++length < 3 || v[0] == v[-1] || v[0] == v[-2] || v[-1] == v[-2]) continue;
        const bool is_turned = length % 2 == 0;
        mesh_.add_face(std::array<double, 3>{v[is_turned ? -1 : -2], v[is_turned ? -2 : -1], v[0]});
      }
    }
  }

  void read_faces(const Ply_element& element)
  {
    Lists lists;
    lists.indices = list_of_indices(element);
    const std::size_t texture = element.find(texture_list);
    if (with_attributes_ && texture != Ply_element::none && element.properties[texture].is_list) {
      lists.texture = texture;
      mesh_.attributes.texture_type = element.properties[texture].type;
      mesh_.attributes.has_texture_type_of_file = true;
    }
    lists.normals = find(normals_, element);
    lists.roundness = find(roundness_, element);

    const std::size_t plausible = std::min(element.size, values_.bytes_left() / 4);
    mesh_.reserve_faces(plausible, 4 * plausible);
    begin(element, names_of_indices);
    for (std::size_t i = 0; i < element.size; ++i) {
      read_item(element, i, lists);
      if (indices_.size() < 3) {
        mesh_.short_faces.add(name_of(element, i) + " has " +
                              plural(indices_.size(), "vertex", "vertices"));
        continue;
      }
      for (const double v : indices_) require_index(v, element, i);
      mesh_.add_face(indices_);
      columns_.add(scalars_);
      if (lists.texture != Ply_element::none) add_texture(element, i);
      add(normals_, element, i);
      add(roundness_, element, i);
    }
    mesh_.attributes.of_faces = columns_.take();
    drop_empty_texture();
  }

  // Faces without texture have an empty list.
  void add_texture(const Ply_element& element, std::size_t i)
  {
    const std::size_t corners = indices_.size();
    if (texture_.empty()) {
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      mesh_.attributes.texture.resize(mesh_.number_of_corners(), {nan, nan, nan});
      return;
    }
    if (texture_.size() != 2 * corners)
      throw Error(name_of(element, i) + " has " + std::to_string(texture_.size()) +
                  " texture coordinates for " + std::to_string(corners) + " vertices");
    for (const double x : texture_) require_finite_texture(x, element, i);
    for (std::size_t c = 0; c < corners; ++c)
      mesh_.attributes.texture.push_back({texture_[2 * c], texture_[2 * c + 1], 0});
  }

  static std::size_t find(Corner_list& list, const Ply_element& element)
  {
    const std::size_t place = element.find(list.name);
    list.is_there = place != Ply_element::none && element.properties[place].is_list;
    return list.is_there ? place : Ply_element::none;
  }

  void add(Corner_list& list, const Ply_element& element, std::size_t i)
  {
    const std::vector<double>& numbers = list.of_face;
    if (numbers.empty()) return;
    if (numbers.size() != list.dimension * indices_.size())
      throw Error(name_of(element, i) + " has " + std::to_string(numbers.size()) + " " +
                  list.numbers + " for " + std::to_string(indices_.size()) + " vertices");
    if (&list == &normals_)
      for (std::size_t k = 0; k < numbers.size(); k += 3)
        for (const double x : mesh_.finite_normal({numbers[k], numbers[k + 1], numbers[k + 2]},
                                                  [&] { return name_of(element, i); }))
          list.of_all.push_back(x);
    else
      list.of_all.insert(list.of_all.end(), numbers.begin(), numbers.end());
    list.faces.push_back(mesh_.number_of_faces() - 1);
  }

  // Not earlier, because the vertices may come behind the faces. Faces without a list have the values of their
  // vertices.
  void put_corner_values()
  {
    if (normals_.is_there && mesh_.has_normals()) {
      for_each_corner(normals_, [&](const double* n, Index v) {
        mesh_.corner_normals.push_back(n ? Triple{n[0], n[1], n[2]} : mesh_.normals[v]);
      });
      mesh_.vertices_with_several_normals = vertices_with_several_normals(mesh_);
    }
    if (roundness_.is_there && !mesh_.roundness.empty())
      for_each_corner(roundness_, [&](const double* w, Index v) {
        mesh_.corner_roundness.push_back(w ? *w : mesh_.roundness[v]);
      });
  }

  // calls put(its numbers or null, its vertex)
  template <class Put>
  void for_each_corner(const Corner_list& list, const Put& put) const
  {
    const double* numbers = list.of_all.data();
    auto next = list.faces.begin();
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f) {
      const bool has_list = next != list.faces.end() && *next == f;
      if (has_list) ++next;
      for (const Index v : mesh_.face(f)) {
        put(has_list ? numbers : nullptr, v);
        if (has_list) numbers += list.dimension;
      }
    }
  }

  // There is none if all faces are without.
  void drop_empty_texture()
  {
    auto& texture = mesh_.attributes.texture;
    if (std::all_of(texture.begin(), texture.end(), is_none)) texture.clear();
  }

  // Not earlier, because the faces may come before the vertices.
  void check_indices() const
  {
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f)
      for (const Index v : mesh_.face(f))
        if (v >= mesh_.points.size())
          throw Error("face " + std::to_string(f) + ": " +
                      out_of_range("the vertex index", v, mesh_.points.size(), "vertices"));
  }

  const Ply_header& header_;
  const Ply_tags tags_;
  Ply_values values_;
  bool with_attributes_;
  Mesh_data mesh_;
  Ply_columns columns_;
  std::vector<double> scalars_, indices_, texture_;
  std::vector<std::string_view> words_; // of the scalars, while digits are counted
  Corner_list normals_{normals_list, 3, "numbers of normals"};
  Corner_list roundness_{roundness_list, 1, "numbers of roundness"};
};

} // namespace

Mesh_data read_ply(const std::string& content, bool with_attributes)
{
  Text_reader in(content, '\0');
  const Ply_header header = read_ply_header(in);
  return Ply_reader(content, header, in, with_attributes).read();
}

} // namespace pn_subdivide
