// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A folder with one VTP file a piece, and the PVTP file that names them.

#include "io/Error.h"
#include "io/Output_file.h"
#include "io/formats.h"
#include "pieces/Output_names.h"
#include "pieces/Piece_output.h"
#include "pieces/Ranks.h"

#include <fstream>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

// Selects what a piece owns, with a vertex that the piece has twice once.
class Owned_part
{
public:
  Owned_part(const Any_pieces::Piece& piece, const Piece_normals& normals,
             const Piece_attributes& attributes)
    : piece_(piece)
    , row_(piece.number_of_vertices(), none)
  {
    list_corners();
    list_vertices();
    mesh_.normal_kind = normals.kind;
    mesh_.attributes = attributes.of(piece);
    select(mesh_.attributes.of_vertices, vertices_);
    select(mesh_.attributes.of_faces, faces_);
    select(mesh_.attributes.texture, corners_);
    const Normals_of_piece values(piece, normals);
    for (const Index v : vertices_) {
      mesh_.points.push_back(to_triple(piece.points()[v]));
      ids_.points.push_back(piece.vertex_number(v));
      if (normals.are_written) mesh_.normals.push_back(values[v]);
      if (normals.with_control) mesh_.control_normals.push_back(values.control(v));
      if (normals.with_roundness) mesh_.roundness.push_back(piece.roundness()[v]);
    }
    add_faces();
  }

  void write(Output_file& out) const { write_vtp(out, mesh_, Encoding::binary, &ids_); }

private:
  template <class Function>
  void for_each_corner_of_piece(const Function& f) const
  {
    const auto& level = piece_.connectivity();
    for (Index face = 0; face < piece_.number_of_faces(); ++face)
      for_each_corner(level, face, [&](Index h) {
        f(face, level.target(h), level.next(h) == level.halfedge_of_face(face));
      });
  }

  void list_corners()
  {
    Index corner = 0;
    for_each_corner_of_piece([&](Index face, Index v, bool is_last) {
      const Index c = corner++;
      if (!piece_.owns_face(face)) return;
      row_[v] = used;
      corners_.push_back(c);
      if (is_last) faces_.push_back(face);
    });
  }
  void list_vertices()
  {
    for (Index v = 0; v < row_.size(); ++v) {
      const bool is_used = row_[v] == used || piece_.connectivity().is_isolated(v);
      if (!is_used) continue;
      const bool is_new =
        vertices_.empty() || piece_.vertex_number(v) != piece_.vertex_number(vertices_.back());
      if (is_new) vertices_.push_back(v);
      row_[v] = static_cast<Index>(vertices_.size() - 1);
    }
  }
  void add_faces()
  {
    mesh_.reserve_faces(faces_.size(), corners_.size());
    std::vector<Index> face;
    for_each_corner_of_piece([&](Index f, Index v, bool is_last) {
      face.push_back(row_[v]);
      if (!is_last) return;
      if (piece_.owns_face(f)) {
        mesh_.add_face(face);
        ids_.cells.push_back(piece_.face_number(f));
      }
      face.clear();
    });
  }

  static constexpr Index none = std::numeric_limits<Index>::max(), used = none - 1;

  const Any_pieces::Piece& piece_;
  std::vector<Index> row_, vertices_; // the row of each vertex, the vertex of each row
  std::vector<Index> faces_, corners_;
  Mesh_data mesh_;
  Vtp_ids ids_;
};

// The checksum of a file, and its size.
std::string receipt_of(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  std::vector<char> buffer(1 << 20);
  Checksum checksum;
  std::uint64_t size = 0;
  while (in) {
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    const auto n = static_cast<std::size_t>(in.gcount());
    checksum.process_bytes(buffer.data(), n);
    size += n;
  }
  return text_of(checksum) + ":" + std::to_string(size);
}

class Pvtp_pieces : public Piece_output
{
public:
  Pvtp_pieces(const Any_pieces& pieces, const Piece_normals& normals,
              const Piece_attributes& attributes, const Output_names& names)
    : pieces_(pieces)
    , normals_(normals)
    , attributes_(attributes)
    , names_(names)
  {}

  // at least: a vertex between pieces is in several files
  std::uint64_t size() const override
  {
    const Any_pieces::Size& size = pieces_.size();
    return size.vertices * (8 + 8 * normals_.numbers()) + size.faces * 16 +
           pieces_.first_corner(size.faces) * 8;
  }

  void create() override
  {
    std::error_code error;
    if (!fs::create_directory(names_.part, error) && !error)
      error = std::make_error_code(std::errc::file_exists);
    if (error) throw Error(names_.part.string() + " cannot be made: " + error.message());
  }
  bool is_written(std::size_t i, const std::string& receipt) const override
  {
    return pieces_.is_empty(i) || receipt == receipt_of(names_.part / piece_name(i));
  }
  void write(std::size_t i, const Any_pieces::Piece& piece) override
  {
    if (pieces_.is_empty(i)) return;
    Output_file out((names_.part / piece_name(i)).string(), Output_file::In_temporary_folder());
    Owned_part(piece, normals_, attributes_).write(out);
    out.commit();
  }
  std::string sync(std::size_t i) override
  {
    if (pieces_.is_empty(i)) return "empty";
    sync_file(names_.part / piece_name(i));
    sync_file(names_.part); // its name
    return receipt_of(names_.part / piece_name(i));
  }
  void finish() override
  {
    Output_file index(names_.target.string());
    write_index(index);
    const bool has_old = fs::exists(names_.folder);
    if (has_old && !is_piece_folder(names_.folder))
      throw Error("the pieces go into the folder " + names_.folder.string() +
                  ", and something else is there since");
    const fs::path old = free_name(names_.old);
    std::error_code ignored;
    if (has_old) rename(names_.folder, old);
    try {
      rename(names_.part, names_.folder);
      index.commit();
    } catch (...) { // what was there comes back
      fs::rename(names_.folder, names_.part, ignored);
      if (has_old) fs::rename(old, names_.folder, ignored);
      throw;
    }
    if (has_old) remove_piece_folder(old);
  }
  bool remove() override { return remove_piece_folder(names_.part); }

private:
  // It was free when the run began.
  static fs::path free_name(const fs::path& name)
  {
    fs::path result = name;
    for (int i = 1; fs::exists(fs::symlink_status(result)); ++i)
      result = name.string() + std::to_string(i);
    return result;
  }

  static void rename(const fs::path& from, const fs::path& to)
  {
    std::error_code error;
    fs::rename(from, to, error);
    if (error)
      throw Error(from.string() + " cannot be renamed to " + to.string() + ": " + error.message());
  }

  void write_index(Output_file& out) const
  {
    Mesh_data like; // a vertex
    like.attributes = attributes_.like();
    if (normals_.are_written) like.normals.resize(1);
    if (normals_.with_control) like.control_normals.resize(1);
    if (normals_.with_roundness) like.roundness.resize(1);
    const bool has_texture =
      attributes_.has_texture() || !find_texture(like.attributes.of_vertices).empty();
    out.text("<?xml version=\"1.0\"?>\n");
    if (normals_.are_written) out.text(std::string("<!-- ") + comment_of(normals_.kind) + " -->\n");
    out.text("<VTKFile type=\"PPolyData\" version=\"1.0\" "
             "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
             "<PPolyData GhostLevel=\"0\">\n");
    out.text(pvtp_arrays(like, has_texture));
    const std::string folder = xml_text(names_.folder.filename().string());
    for (std::size_t i = 0; i < pieces_.number(); ++i)
      if (!pieces_.is_empty(i))
        out.text("<Piece Source=\"" + folder + "/" + piece_name(i) + "\"/>\n");
    out.text("</PPolyData>\n</VTKFile>\n");
  }

  const Any_pieces& pieces_;
  const Piece_normals normals_;
  const Piece_attributes& attributes_;
  const Output_names names_;
};

} // namespace

std::unique_ptr<Piece_output> make_pvtp_output(const Any_pieces& pieces,
                                               const Piece_normals& normals,
                                               const Piece_attributes& attributes,
                                               const Output_names& names)
{
  return std::make_unique<Pvtp_pieces>(pieces, normals, attributes, names);
}

} // namespace pn_subdivide
