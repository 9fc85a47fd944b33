// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Piece_output.h"

#include "io/Error.h"
#include "io/Ply_header.h"
#include "pieces/Ranks.h"

#include <boost/endian/conversion.hpp>

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

// One binary PLY file: every vertex and every face has its place, which follows from its number.

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

// Collects rows that follow on each other in the file.
class Row_writer
{
public:
  Row_writer(Shared_file& file, bool keeps_receipt)
    : file_(file)
    , keeps_receipt_(keeps_receipt)
  {
    buffer_.reserve(most + 1024);
  }

  // The places increase.
  void begin_row(std::uint64_t place)
  {
    if (place != place_ + buffer_.size() || buffer_.size() >= most) flush();
    if (buffer_.empty()) place_ = place;
  }
  template <class T>
  void little_endian(T x)
  {
    unsigned char bytes[sizeof(T)];
    boost::endian::endian_store<T, sizeof(T), boost::endian::order::little>(bytes, x);
    buffer_.append(reinterpret_cast<const char*>(bytes), sizeof(T));
  }
  void flush()
  {
    if (buffer_.empty()) return;
    file_.write(place_, buffer_.data(), buffer_.size());
    if (keeps_receipt_) {
      checksum_.process_bytes(buffer_.data(), buffer_.size());
      if (runs_.empty() || place_ != runs_.back().end) runs_.push_back({place_, place_});
      runs_.back().end = place_ + buffer_.size();
    }
    buffer_.clear();
  }

  // After flush(): the checksum of all rows, and where they are.
  std::string receipt() const
  {
    std::ostringstream text;
    text << text_of(checksum_) << std::hex;
    for (const Run& run : runs_) text << ' ' << run.begin << ' ' << run.end;
    return text.str();
  }

private:
  static constexpr std::size_t most = 1 << 20;

  // from a place in the file to another one
  struct Run
  {
    std::uint64_t begin, end;
  };

  Shared_file& file_;
  std::string buffer_;
  std::uint64_t place_ = 0;

  bool keeps_receipt_;
  Checksum checksum_;
  std::vector<Run> runs_;
};

// Are the rows of a receipt in a file?
bool has_rows(const std::filesystem::path& file, const std::string& receipt)
{
  std::ifstream rows;
  rows.rdbuf()->pubsetbuf(nullptr, 0); // runs are read as they are, often from far away
  rows.open(file, std::ios::binary);
  std::istringstream text(receipt);
  std::string expected;
  text >> expected >> std::hex;
  Checksum checksum;
  std::vector<char> buffer(1 << 16);
  for (std::uint64_t place = 0, end = 0; text >> place >> end;) {
    rows.seekg(static_cast<std::streamoff>(place));
    while (rows && place < end) {
      const std::size_t n = std::min<std::uint64_t>(end - place, buffer.size());
      rows.read(buffer.data(), static_cast<std::streamsize>(n));
      checksum.process_bytes(buffer.data(), n);
      place += n;
    }
  }
  return rows && text.eof() && text_of(checksum) == expected;
}

class Ply_pieces : public Piece_output
{
public:
  Ply_pieces(const Any_pieces& pieces, const Piece_normals& normals,
             const Piece_attributes& attributes, const Output_names& names, bool keeps_receipts)
    : pieces_(pieces)
    , normals_(normals)
    , attributes_(attributes)
    , has_short_lists_((attributes.has_texture() ? 2 : 1) * pieces.largest_degree() <= 255)
    , keeps_receipts_(keeps_receipts)
    , names_(names)
  {
    const Any_pieces::Size& size = pieces.size();
    if (size.vertices > std::numeric_limits<std::uint32_t>::max())
      throw Error("PLY files number vertices with 32 bits, and there would be " +
                  std::to_string(size.vertices) + ": write .pvtp, or ask for fewer levels");
    const Ply_shape shape{
      size.vertices, size.faces,       normals.are_written,    normals.with_control,
      normals.kind,  has_short_lists_, normals.with_roundness, attributes.has_texture()};
    const Attributes like = attributes.like();
    header_ = ply_header(shape, like);
    bytes_of_vertex_ = std::uint64_t(8) * normals_.numbers() + bytes_of(like.of_vertices);
    const std::uint64_t list = has_short_lists_ ? 1 : 4;
    bytes_of_face_ = list + bytes_of(like.of_faces);
    bytes_of_corner_ = 4;
    if (shape.has_texture) {
      bytes_of_face_ += list;
      bytes_of_corner_ += 2 * traits(like.texture_type).bytes;
    }
    faces_begin_ = header_.size() + size.vertices * bytes_of_vertex_;
  }

  std::uint64_t size() const override { return place_of_face(pieces_.size().faces); }

  void create() override { create_file(names_.part, size()); }
  // Another size, or another header, is that of a damaged file.
  void mend() override
  {
    std::error_code error;
    fs::resize_file(names_.part, size(), error);
    if (error) throw Error(names_.part.string() + " cannot be continued: " + error.message());
    const std::unique_ptr<Shared_file> file = open_file(names_.part);
    file->write(0, header_.data(), header_.size());
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
    const Attributes attributes = attributes_.of(piece);
    write_vertices(piece, attributes.of_vertices, rows);
    write_faces(piece, attributes, rows);
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
  static std::uint64_t bytes_of(const Columns& columns)
  {
    std::uint64_t bytes = 0;
    for (const Column& column : columns) bytes += traits(column.type).bytes;
    return bytes;
  }
  std::uint64_t place_of_face(std::uint64_t f) const
  {
    return faces_begin_ + bytes_of_face_ * f + bytes_of_corner_ * pieces_.first_corner(f);
  }

  static void put(Row_writer& rows, const Columns& columns, Index i)
  {
    for (const Column& column : columns) write_little_endian(rows, column.type, column.values[i]);
  }
  void put_size(Row_writer& rows, Index size) const
  {
    write_little_endian(rows, has_short_lists_ ? Scalar_type::uint8 : Scalar_type::uint32, size);
  }

  void write_vertices(const Any_pieces::Piece& piece, const Columns& columns,
                      Row_writer& rows) const
  {
    const Normals_of_piece normals(piece, normals_);
    const auto put = [&rows](const Triple& t) {
      for (const double x : t) rows.little_endian(x);
    };
    for (Index v = 0; v < piece.number_of_vertices(); ++v) {
      if (!piece.owns_vertex(v)) continue;
      rows.begin_row(header_.size() + piece.vertex_number(v) * bytes_of_vertex_);
      put(to_triple(piece.points()[v]));
      if (normals_.are_written) put(normals[v]);
      if (normals_.with_control) put(normals.control(v));
      if (normals_.with_roundness) rows.little_endian(piece.roundness()[v]);
      this->put(rows, columns, v);
    }
  }

  void write_faces(const Any_pieces::Piece& piece, const Attributes& attributes,
                   Row_writer& rows) const
  {
    const auto& level = piece.connectivity();
    auto texture = attributes.texture.begin();
    for (Index f = 0; f < piece.number_of_faces(); ++f) {
      const auto own_texture = texture;
      if (attributes_.has_texture()) texture += level.degree(level.halfedge_of_face(f));
      if (!piece.owns_face(f)) continue;
      rows.begin_row(place_of_face(piece.face_number(f)));
      const Index degree = level.degree(level.halfedge_of_face(f));
      put_size(rows, degree);
      for_each_corner(level, f, [&](Index h) {
        rows.little_endian(static_cast<std::uint32_t>(piece.vertex_number(level.target(h))));
      });
      put(rows, attributes.of_faces, f);
      if (!attributes_.has_texture()) continue;
      put_size(rows, 2 * degree);
      for (auto t = own_texture; t != texture; ++t)
        for (const std::size_t k : {0, 1})
          write_little_endian(rows, attributes.texture_type, (*t)[k]);
    }
  }

  const Any_pieces& pieces_;
  const Piece_normals normals_;
  const Piece_attributes& attributes_;
  bool has_short_lists_, keeps_receipts_;
  const Output_names names_;
  std::string header_;
  std::uint64_t faces_begin_, bytes_of_vertex_, bytes_of_face_, bytes_of_corner_;
  std::unique_ptr<Shared_file> file_;
  std::string receipt_; // of the piece that was written last
};

} // namespace

std::unique_ptr<Piece_output> make_ply_output(const Any_pieces& pieces,
                                              const Piece_normals& normals,
                                              const Piece_attributes& attributes,
                                              const Output_names& names, bool keeps_receipts)
{
  return std::make_unique<Ply_pieces>(pieces, normals, attributes, names, keeps_receipts);
}

} // namespace pn_subdivide
