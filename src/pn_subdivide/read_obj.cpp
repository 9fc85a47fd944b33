// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Error.h"
#include "Obj_normals.h"
#include "Text_reader.h"
#include "formats.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <utility>

namespace pn_subdivide {
namespace {

class Obj_reader
{
public:
  explicit Obj_reader(const std::string& content)
    : m_in(content, '#')
  {
  }

  Mesh_data read()
  {
    while (m_in.next_line()) {
      const std::string_view keyword = m_in.word();
      if (keyword == "v")
        read_point();
      else if (keyword == "vn")
        read_normal();
      else if (keyword == "f")
        read_face();
      // Everything else (textures, groups, materials, lines, ...) says nothing about the surface.
    }
    if (m_mesh.points.empty())
      throw Error("not an OBJ mesh: there is no vertex (no line 'v x y z')");
    check_indices();
    m_mesh.normals = m_normals.per_vertex(m_mesh.points.size());
    return std::move(m_mesh);
  }

private:
  // A face's vertex or normal, counted from 0. Numbers in the file count from 1, negative ones back
  // from the last that was read.
  std::int64_t index(std::string_view word, std::size_t so_far, const char* what) const
  {
    const std::int64_t n = m_in.to_integer(word, what);
    const std::int64_t i = n < 0 ? static_cast<std::int64_t>(so_far) + n : n - 1;
    if (i < 0 || static_cast<std::size_t>(i) >= Mesh_data::max_number_of_points)
      m_in.fail(std::string(what) + " " + std::to_string(n) + " is out of range");
    return i;
  }

  void read_point()
  {
    const double x = m_in.number("a coordinate");
    const double y = m_in.number("a coordinate");
    const double z = m_in.number("a coordinate");
    m_mesh.points.emplace_back(x, y, z); // a weight or a colour may follow
    if (m_mesh.points.size() > Mesh_data::max_number_of_points) m_in.fail("too many vertices");
  }

  void read_normal()
  {
    const double x = m_in.number("a normal's coordinate");
    const double y = m_in.number("a normal's coordinate");
    const double z = m_in.number("a normal's coordinate");
    m_normals.add_normal(Vector_3(x, y, z));
  }

  void read_face()
  {
    m_face.clear();
    for (std::string_view w = m_in.word(); !w.empty(); w = m_in.word()) read_corner(w);
    if (m_face.size() < 3) m_in.fail("a face with " + std::to_string(m_face.size()) + " vertices");
    m_mesh.add_face(m_face);
    m_line_of_face.push_back(m_in.line());
  }

  // v, v/t, v//n or v/t/n
  void read_corner(std::string_view w)
  {
    const std::size_t slash = std::min(w.find('/'), w.size());
    const std::int64_t v = index(w.substr(0, slash), m_mesh.points.size(), "a vertex index");
    m_face.push_back(static_cast<Mesh_data::Index>(v));
    if (slash == w.size()) return;

    w.remove_prefix(slash + 1);
    const std::size_t second_slash = w.find('/');
    if (second_slash == std::string_view::npos) return;
    const std::int64_t n =
        index(w.substr(second_slash + 1), m_normals.number_of_normals(), "a normal index");
    m_normals.add_corner(m_face.back(), static_cast<std::size_t>(n), m_in.line());
  }

  // Not earlier, because a face may come before its vertices.
  void check_indices() const
  {
    for (std::size_t f = 0; f < m_mesh.number_of_faces(); ++f)
      for (const Mesh_data::Index v : m_mesh.face(f))
        if (v >= m_mesh.points.size())
          throw Error("line " + std::to_string(m_line_of_face[f]) + ": the face's vertex index " +
                      std::to_string(v + std::uint64_t(1)) + " is out of range, there are " +
                      std::to_string(m_mesh.points.size()) + " vertices");
  }

  Text_reader m_in;
  Mesh_data m_mesh;
  Obj_normals m_normals;
  std::vector<Mesh_data::Index> m_face;
  std::vector<std::size_t> m_line_of_face;
};

} // namespace

Mesh_data read_obj(const std::string& content)
{
  if (content.find('\\') == std::string::npos) return Obj_reader(content).read();

  // A line that ends with a backslash goes on in the next one.
  std::string joined = boost::algorithm::replace_all_copy(content, "\\\r\n", " ");
  boost::algorithm::replace_all(joined, "\\\n", " ");
  return Obj_reader(joined).read();
}

} // namespace pn_subdivide
