// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "io/Mesh_data.h"
#include "io/Obj_attributes.h"
#include "io/Text_reader.h"
#include "io/formats.h"
#include "io/mesh_normals.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace pn_subdivide {

namespace {

// The normals of the corners of faces, as the file has them.
class Obj_normals
{
public:
  std::size_t number_of_normals() const { return normals_.size(); }
  void add_normal(const Triple& n) { normals_.push_back(n); }

  // `corner` counts through all faces.
  void add_corner(std::size_t corner, std::size_t normal, std::size_t line)
  {
    corners_.push_back({corner, normal, line});
  }

  // To be called when all is read. Corners that are given none have zero.
  void put(Mesh_data& mesh) const
  {
    if (corners_.empty()) return put_in_order(mesh);
    mesh.corner_normals.resize(mesh.number_of_corners(), Triple{0, 0, 0});
    for (const Corner& c : corners_) {
      if (c.normal >= normals_.size())
        throw Error(
          "line " + std::to_string(c.line) + ": " +
          out_of_range("the face's normal index", c.normal + 1, normals_.size(), "normals"));
      mesh.corner_normals[c.corner] = normals_[c.normal];
    }
    mesh.vertices_with_several_normals = vertices_with_several_normals(mesh);
    set_vertex_normals(mesh, Zero_normals::are_left_out);
  }

private:
  struct Corner
  {
    std::size_t corner, normal, line;
  };

  // Some programs (CGAL's writer among them) list one normal per vertex and leave it at that.
  void put_in_order(Mesh_data& mesh) const
  {
    if (!normals_.empty() && normals_.size() != mesh.points.size())
      throw Error(std::to_string(normals_.size()) + " normals (vn) for " +
                  std::to_string(mesh.points.size()) +
                  " vertices, and no face says which belongs where (f v//n)");
    mesh.normals = normals_;
  }

  std::vector<Triple> normals_;
  std::vector<Corner> corners_;
};

class Obj_reader
{
public:
  Obj_reader(const std::string& content, bool with_attributes)
    : in_(content, '#', true)
    , with_attributes_(with_attributes)
  {}

  Mesh_data read()
  {
    while (in_.next_line()) {
      const std::string_view keyword = in_.word();
      if (keyword == "v")
        read_point();
      else if (keyword == "vn")
        read_normal();
      else if (keyword == "f")
        read_face();
      else if (keyword == "t")
        read_tag();
      else if (!with_attributes_)
        Obj_attributes::skip(keyword, in_);
      else if (!attributes_.read(keyword, in_, mesh_))
        note_what_is_dropped(keyword);
    }
    if (mesh_.points.empty())
      throw Error("not an OBJ mesh: there is no vertex (no line 'v x y z')");
    check_indices();
    normals_.put(mesh_);
    attributes_.put(mesh_);
    mesh_.tags = tags_.take(mesh_.points.size());
    return std::move(mesh_);
  }

private:
  std::string place() const { return "line " + std::to_string(in_.line()); }

  void note_what_is_dropped(std::string_view keyword)
  {
    constexpr std::size_t many = 8; // in a damaged file every line may begin with another word
    if (keyword == "l" || keyword == "p")
      mesh_.drop("lines and points");
    else
      mesh_.drop(mesh_.dropped.size() < many ? "'" + Text_reader::printable(keyword) + "'"
                                             : "other lines");
  }

  void read_tag()
  {
    const std::string other = tags_.read(in_);
    if (!other.empty() && with_attributes_) note_what_is_dropped("t " + other);
  }

  // A face's vertex, texture point or normal, counted from 0. Numbers in the file count from 1, negative ones back
  // from the last that was read.
  std::int64_t index(std::string_view word, std::size_t so_far, const char* what) const
  {
    const std::int64_t n = in_.to_integer(word, what);
    const std::int64_t i = n < 0 ? static_cast<std::int64_t>(so_far) + n : n - 1;
    if (i < 0 || static_cast<std::uint64_t>(i) >= Mesh_data::max_number_of_points)
      in_.fail(std::string(what) + " " + std::to_string(n) + " is out of range");
    return i;
  }

  void read_point()
  {
    mesh_.points.push_back(in_.triple("a coordinate"));
    if (with_attributes_) attributes_.read_color(in_, mesh_);
    if (mesh_.points.size() > Mesh_data::max_number_of_points) in_.fail("too many vertices");
  }

  void read_normal()
  {
    const Triple n = in_.triple("a normal's coordinate");
    normals_.add_normal(mesh_.finite_normal(n, [this] { return place(); }));
    mesh_.digits_of_normals.see(in_.last_words(), n);
  }

  void read_face()
  {
    face_.clear();
    words_.clear();
    for (std::string_view w = in_.word(); !w.empty(); w = in_.word()) words_.push_back(w);
    if (words_.size() < 3)
      return mesh_.short_faces.add(place() + " has a face with " +
                                   plural(words_.size(), "vertex", "vertices"));
    for (const std::string_view w : words_) read_corner(w);
    mesh_.add_face(face_);
    attributes_.end_face();
    line_of_face_.push_back(in_.line());
  }

  // v, v/t, v//n or v/t/n; what is missing behind a slash is absent
  void read_corner(std::string_view w)
  {
    const std::size_t slash = std::min(w.find('/'), w.size());
    const std::int64_t v = index(w.substr(0, slash), mesh_.points.size(), "a vertex index");
    face_.push_back(static_cast<Index>(v));
    if (slash == w.size()) return;

    w.remove_prefix(slash + 1);
    const std::size_t corner = mesh_.number_of_corners() + face_.size() - 1;
    const std::size_t second_slash = std::min(w.find('/'), w.size());
    if (with_attributes_ && second_slash > 0) {
      const std::int64_t t =
        index(w.substr(0, second_slash), attributes_.number_of_texture_points(), "a texture index");
      attributes_.add_corner(corner, static_cast<std::size_t>(t), in_.line());
    }
    if (second_slash + 1 >= w.size()) return;
    const std::int64_t n =
      index(w.substr(second_slash + 1), normals_.number_of_normals(), "a normal index");
    normals_.add_corner(corner, static_cast<std::size_t>(n), in_.line());
  }

  // Not earlier, because a face may come before its vertices.
  void check_indices() const
  {
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f)
      for (const Index v : mesh_.face(f))
        if (v >= mesh_.points.size())
          throw Error("line " + std::to_string(line_of_face_[f]) + ": " +
                      out_of_range("the face's vertex index", v + std::uint64_t(1),
                                   mesh_.points.size(), "vertices"));
  }

  Text_reader in_;
  bool with_attributes_;
  Mesh_data mesh_;
  Obj_normals normals_;
  Obj_attributes attributes_;
  Obj_tags tags_;
  std::vector<Index> face_;
  std::vector<std::string_view> words_;
  std::vector<std::size_t> line_of_face_;
};

} // namespace

Mesh_data read_obj(const std::string& content, bool with_attributes)
{
  return Obj_reader(content, with_attributes).read();
}

} // namespace pn_subdivide
