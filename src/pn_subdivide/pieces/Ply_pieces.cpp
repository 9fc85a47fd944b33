// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// One binary PLY file: every vertex and every face has its place, which follows from its number.

#include "io/Error.h"
#include "io/Ply_shape.h"
#include "pieces/Piece_output.h"
#include "pieces/Ranks.h"

#include <boost/endian/conversion.hpp>

#include <limits>
#include <string>

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

// Collects rows that follow on each other in the file.
class Row_writer
{
public:
  explicit Row_writer(Shared_file& file)
    : file_(file)
  {
    buffer_.reserve(most + 1024);
  }

  void begin_row(std::uint64_t place)
  {
    if (place != place_ + buffer_.size() || buffer_.size() >= most) flush();
    if (buffer_.empty()) place_ = place;
  }
  template <class T>
  void put(T x)
  {
    unsigned char bytes[sizeof(T)];
    boost::endian::endian_store<T, sizeof(T), boost::endian::order::little>(bytes, x);
    buffer_.append(reinterpret_cast<const char*>(bytes), sizeof(T));
  }
  void flush()
  {
    if (!buffer_.empty()) file_.write(place_, buffer_.data(), buffer_.size());
    buffer_.clear();
  }

private:
  static constexpr std::size_t most = 1 << 20;

  Shared_file& file_;
  std::string buffer_;
  std::uint64_t place_ = 0;
};

class Ply_pieces : public Piece_output
{
public:
  Ply_pieces(const Any_pieces& pieces, bool has_normals, const fs::path& part,
             const fs::path& target)
    : pieces_(pieces)
    , has_normals_(has_normals)
    , has_short_lists_(pieces.largest_degree() <= 255)
    , part_(part)
    , target_(target)
  {
    const Any_pieces::Size& size = pieces.size();
    if (size.vertices > std::numeric_limits<std::uint32_t>::max())
      throw Error("PLY files number vertices with 32 bits, and there would be " +
                  std::to_string(size.vertices) + ": write .pvtp, or ask for fewer levels");
    Ply_shape shape;
    shape.vertices = size.vertices;
    shape.faces = size.faces;
    shape.has_normals = has_normals;
    shape.has_short_lists = has_short_lists_;
    header_ = ply_header(shape);
    faces_begin_ = header_.size() + size.vertices * bytes_of_vertex();
  }

  std::uint64_t size() const override { return place_of_face(pieces_.size().faces); }

  void create() override
  {
    if (fs::exists(part_)) return;
    create_file(part_, size());
    const std::unique_ptr<Shared_file> file = open_file(part_);
    file->write(0, header_.data(), header_.size());
    file->close();
  }
  void open() override { file_ = ranks().open(part_); }
  void write(std::size_t /*i*/, const Any_pieces::Piece& piece) override
  {
    Row_writer rows(*file_);
    write_vertices(piece, rows);
    write_faces(piece, rows);
    rows.flush();
  }
  void sync(std::size_t) override { file_->sync(); }
  void close() override { file_->close(); }
  void finish() override
  {
    std::error_code error;
    fs::rename(part_, target_, error);
    if (error) throw Error("cannot be replaced: " + error.message());
  }

private:
  using Index = Any_pieces::Piece::Index;

  std::uint64_t bytes_of_vertex() const { return has_normals_ ? 48 : 24; }
  std::uint64_t place_of_face(std::uint64_t f) const
  {
    return faces_begin_ + (has_short_lists_ ? 1 : 4) * f + 4 * pieces_.first_corner(f);
  }

  void write_vertices(const Any_pieces::Piece& piece, Row_writer& rows) const
  {
    for (Index v = 0; v < piece.number_of_vertices(); ++v) {
      if (!piece.owns_vertex(v)) continue;
      rows.begin_row(header_.size() + piece.vertex_number(v) * bytes_of_vertex());
      for (const double x : to_triple(piece.points()[v])) rows.put(x);
      if (!has_normals_) continue;
      for (const double x : to_triple(piece.normals()[v])) rows.put(x);
    }
  }

  void write_faces(const Any_pieces::Piece& piece, Row_writer& rows) const
  {
    const auto& level = piece.connectivity();
    for (Index f = 0; f < piece.number_of_faces(); ++f) {
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
  bool has_normals_, has_short_lists_;
  fs::path part_, target_;
  std::string header_;
  std::uint64_t faces_begin_;
  std::unique_ptr<Shared_file> file_;
};

} // namespace

std::unique_ptr<Piece_output> make_ply_output(const Any_pieces& pieces, bool has_normals,
                                              const fs::path& part, const fs::path& target)
{
  return std::make_unique<Ply_pieces>(pieces, has_normals, part, target);
}

} // namespace pn_subdivide
