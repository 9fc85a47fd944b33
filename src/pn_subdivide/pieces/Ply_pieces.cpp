// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// One binary PLY file: every vertex and every face has its place, which follows from its number.

#include "io/Error.h"
#include "io/Ply_origin.h"
#include "pieces/Piece_output.h"
#include "pieces/Ranks.h"
#include "pieces/Row_writer.h"

#include <limits>
#include <string>

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

class Ply_pieces : public Piece_output
{
public:
  Ply_pieces(const Any_pieces& pieces, const Piece_normals& normals, const Mesh_origin& origin,
             const Output_names& names, bool keeps_receipts)
    : pieces_(pieces)
    , normals_(normals)
    , has_short_lists_(pieces.largest_degree() <= 255)
    , keeps_receipts_(keeps_receipts)
    , names_(names)
  {
    const Any_pieces::Size& size = pieces.size();
    if (size.vertices > std::numeric_limits<std::uint32_t>::max())
      throw Error("PLY files number vertices with 32 bits, and there would be " +
                  std::to_string(size.vertices) + ": write .pvtp, or ask for fewer levels");
    Ply_shape shape;
    shape.vertices = size.vertices;
    shape.faces = size.faces;
    shape.has_normals = normals.are_written;
    shape.has_control_normals = normals.with_control;
    shape.has_roundness = normals.with_roundness;
    shape.normal_kind = normals.kind;
    shape.has_short_lists = has_short_lists_;
    header_ = ply_header(shape, origin);
    behind_faces_ = origin.any() ? origin_bytes(origin) : "";
    faces_begin_ = header_.size() + size.vertices * bytes_of_vertex();
  }

  std::uint64_t size() const override { return faces_end() + behind_faces_.size(); }

  void create() override { create_file(names_.part, size()); }
  // Another size, or another header, is that of a damaged file.
  void mend() override
  {
    std::error_code error;
    fs::resize_file(names_.part, size(), error);
    if (error) throw Error(names_.part.string() + " cannot be continued: " + error.message());
    const std::unique_ptr<Shared_file> file = open_file(names_.part);
    file->write(0, header_.data(), header_.size());
    file->write(faces_end(), behind_faces_.data(), behind_faces_.size());
    file->close();
  }
  bool is_written(std::size_t /*i*/, const std::string& receipt) const override
  {
    return has_rows(names_.part, receipt);
  }
  void open() override { file_ = ranks().open(names_.part); }
  void write(std::size_t /*i*/, const Any_pieces::Piece& piece) override
  {
    Row_writer rows(*file_, keeps_receipts_);
    write_vertices(piece, rows);
    write_faces(piece, rows);
    rows.flush();
    if (keeps_receipts_) receipt_ = rows.receipt();
  }
  std::string sync(std::size_t /*i*/) override
  {
    file_->sync();
    return receipt_;
  }
  void close() override { file_->close(); }
  void finish() override
  {
    std::error_code error;
    fs::rename(names_.part, names_.target, error);
    if (error) throw Error("cannot be replaced: " + error.message());
  }
  bool remove() override
  {
    std::error_code ignored;
    return fs::remove(names_.part, ignored);
  }

private:
  using Index = Any_pieces::Piece::Index;

  std::uint64_t bytes_of_vertex() const { return 8 * normals_.numbers(); }
  std::uint64_t faces_end() const { return place_of_face(pieces_.size().faces); }
  std::uint64_t place_of_face(std::uint64_t f) const
  {
    return faces_begin_ + (has_short_lists_ ? 1 : 4) * f + 4 * pieces_.first_corner(f);
  }

  void write_vertices(const Any_pieces::Piece& piece, Row_writer& rows) const
  {
    const Normals_of_piece normals(piece, normals_);
    const auto put = [&rows](const Triple& t) {
      for (const double x : t) rows.put(x);
    };
    for (Index v = 0; v < piece.number_of_vertices(); ++v) {
      if (!piece.owns_vertex(v)) continue;
      rows.begin_row(header_.size() + piece.vertex_number(v) * bytes_of_vertex());
      put(to_triple(piece.points()[v]));
      if (normals_.are_written) put(normals[v]);
      if (normals_.with_control) put(normals.control(v));
      if (normals_.with_roundness) rows.put(piece.roundness()[v]);
    }
  }

  void write_faces(const Any_pieces::Piece& piece, Row_writer& rows) const
  {
    const auto& level = piece.connectivity();
    for (Index f = 0; f < piece.number_of_faces(); ++f) {
      if (!piece.owns_face(f)) continue;
      rows.begin_row(place_of_face(piece.face_number(f)));
      const Index first = level.halfedge_of_face(f);
      const Index degree = level.degree(first);
      if (has_short_lists_)
        rows.put(static_cast<std::uint8_t>(degree));
      else
        rows.put(static_cast<std::uint32_t>(degree));
      Index h = first;
      do {
        rows.put(static_cast<std::uint32_t>(piece.vertex_number(level.target(h))));
        h = level.next(h);
      } while (h != first);
    }
  }

  const Any_pieces& pieces_;
  const Piece_normals normals_;
  bool has_short_lists_, keeps_receipts_;
  const Output_names names_;
  std::string header_, behind_faces_;
  std::uint64_t faces_begin_;
  std::unique_ptr<Shared_file> file_;
  std::string receipt_; // of the piece that was written last
};

} // namespace

std::unique_ptr<Piece_output> make_ply_output(const Any_pieces& pieces,
                                              const Piece_normals& normals,
                                              const Mesh_origin& origin, const Output_names& names,
                                              bool keeps_receipts)
{
  return std::make_unique<Ply_pieces>(pieces, normals, origin, names, keeps_receipts);
}

} // namespace pn_subdivide
