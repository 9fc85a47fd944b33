// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Error.h"
#include "io/Obj_attributes.h"
#include "io/Obj_normals.h"
#include "io/Obj_tags.h"
#include "io/Text_reader.h"
#include "io/formats.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cstdint>

namespace pn_subdivide {
namespace {

class Obj_reader
{
public:
  Obj_reader(const std::string& content, bool with_attributes)
    : in_(content, '#')
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
      else if (with_attributes_ && !attributes_.read(keyword, in_, mesh_))
        note_what_is_dropped(keyword);
    }
    if (mesh_.points.empty())
      throw Error("not an OBJ mesh: there is no vertex (no line 'v x y z')");
    check_indices();
    normals_.check();
    mesh_.corner_normals = normals_.per_corner(mesh_.points.size(), mesh_.number_of_corners());
    mesh_.normals = normals_.per_vertex(mesh_.points.size());
    mesh_.vertices_with_several_normals = normals_.vertices_with_several_normals();
    attributes_.put(mesh_);
    mesh_.tags = tags_.take(mesh_.points.size());
    return std::move(mesh_);
  }

private:
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
    const double x = in_.number("a coordinate");
    const double y = in_.number("a coordinate");
    const double z = in_.number("a coordinate");
    mesh_.points.push_back({x, y, z});
    if (with_attributes_) attributes_.read_color(in_);
    if (mesh_.points.size() > Mesh_data::max_number_of_points) in_.fail("too many vertices");
  }

  void read_normal()
  {
    const double x = in_.number("a normal's coordinate");
    const double y = in_.number("a normal's coordinate");
    const double z = in_.number("a normal's coordinate");
    normals_.add_normal({x, y, z});
    mesh_.digits_of_normals.see(in_.last_words(), {x, y, z});
  }

  void read_face()
  {
    face_.clear();
    for (std::string_view w = in_.word(); !w.empty(); w = in_.word()) read_corner(w);
    if (face_.size() < 3) in_.fail("a face with " + std::to_string(face_.size()) + " vertices");
    mesh_.add_face(face_);
    attributes_.end_face();
    line_of_face_.push_back(in_.line());
  }

  // v, v/t, v//n or v/t/n; what is missing behind a slash is absent
  void read_corner(std::string_view w)
  {
    const std::size_t slash = std::min(w.find('/'), w.size());
    const std::int64_t v = index(w.substr(0, slash), mesh_.points.size(), "a vertex index");
    face_.push_back(static_cast<Mesh_data::Index>(v));
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
    normals_.add_corner(corner, face_.back(), static_cast<std::size_t>(n), in_.line());
  }

  // Not earlier, because a face may come before its vertices.
  void check_indices() const
  {
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f)
      for (const Mesh_data::Index v : mesh_.face(f))
        if (v >= mesh_.points.size())
          throw Error("line " + std::to_string(line_of_face_[f]) + ": the face's vertex index " +
                      std::to_string(v + std::uint64_t(1)) + " is out of range, there are " +
                      std::to_string(mesh_.points.size()) + " vertices");
  }

  Text_reader in_;
  bool with_attributes_;
  Mesh_data mesh_;
  Obj_normals normals_;
  Obj_attributes attributes_;
  Obj_tags tags_;
  std::vector<Mesh_data::Index> face_;
  std::vector<std::size_t> line_of_face_;
};

} // namespace

Mesh_data read_obj(const std::string& content, bool with_attributes)
{
  if (content.find('\\') == std::string::npos) return Obj_reader(content, with_attributes).read();

  // A line that ends with a backslash goes on in the next one.
  std::string joined = boost::algorithm::replace_all_copy(content, "\\\r\n", " ");
  boost::algorithm::replace_all(joined, "\\\n", " ");
  return Obj_reader(joined, with_attributes).read();
}

} // namespace pn_subdivide
