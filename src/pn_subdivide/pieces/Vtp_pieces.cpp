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
#include "io/Vtp_writer.h"
#include "io/write_text.h"
#include "pieces/Checksum.h"
#include "pieces/Piece_folder.h"
#include "pieces/Piece_output.h"
#include "pieces/Shared_file.h"

#include <fstream>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

using Index = Any_pieces::Piece::Index;

// The arrays of what a piece owns, in which a vertex that the piece has twice is there once.
class Vtp_arrays
{
public:
  Vtp_arrays(const Any_pieces::Piece& piece, const Piece_normals& normals)
    : piece_(piece)
    , normals_(normals)
    , row_(piece.number_of_vertices(), none)
  {
    for_each_corner([&](Index v, bool is_last) {
      row_[v] = used;
      ++corners_;
      if (is_last) ++faces_;
    });
    for (Index v = 0; v < row_.size(); ++v) {
      const bool is_used = row_[v] == used || piece.connectivity().is_isolated(v);
      if (!is_used) continue;
      const bool is_new =
        vertices_.empty() || piece.vertex_number(v) != piece.vertex_number(vertices_.back());
      if (is_new) vertices_.push_back(v);
      row_[v] = static_cast<Index>(vertices_.size() - 1);
    }
  }

  void write(Output_file& out) const
  {
    Vtp_writer vtp(out, Encoding::binary);
    vtp.begin(normals_.are_written ? comment_of(normals_.kind) : "");
    vtp.begin_piece(vertices_.size(), faces_);
    const Normals_of_piece normals(piece_, normals_);
    vtp.line(normals_.are_written ? R"(<PointData Normals="Normals" GlobalIds="GlobalPointIds">)"
                                  : R"(<PointData GlobalIds="GlobalPointIds">)");
    if (normals_.are_written)
      vtp.triples("Normals", vertices_.size(),
                  [&](std::size_t i) { return normals[vertices_[i]]; });
    if (normals_.with_control)
      vtp.triples("control_normals", vertices_.size(),
                  [&](std::size_t i) { return normals.control(vertices_[i]); });
    Column roundness;
    if (normals_.with_roundness) {
      for (const Index v : vertices_) roundness.values.push_back(piece_.roundness()[v]);
      vtp.columns("roundness", {&roundness});
    }
    vtp.integers("GlobalPointIds", vertices_.size(), [&] {
      for (const Index v : vertices_) put(vtp, piece_.vertex_number(v));
    });
    vtp.line("</PointData>\n<CellData GlobalIds=\"GlobalCellIds\">");
    vtp.integers("GlobalCellIds", faces_, [&] {
      for (Index f = 0; f < piece_.number_of_faces(); ++f)
        if (piece_.owns_face(f)) put(vtp, piece_.face_number(f));
    });
    vtp.line("</CellData>\n<Points>");
    vtp.triples("Points", vertices_.size(),
                [&](std::size_t i) { return to_triple(piece_.points()[vertices_[i]]); });
    vtp.line("</Points>\n<Polys>");
    vtp.integers("connectivity", corners_,
                 [&] { for_each_corner([&](Index v, bool) { put(vtp, row_[v]); }); });
    vtp.integers("offsets", faces_, [&] {
      std::uint64_t end = 0;
      for_each_corner([&](Index, bool is_last) {
        ++end;
        if (is_last) put(vtp, end);
      });
    });
    vtp.line("</Polys>");
    vtp.end();
  }

private:
  static void put(Vtp_writer& vtp, std::uint64_t n)
  {
    vtp.value<std::int64_t>(static_cast<std::int64_t>(n), true);
  }

  template <class Function>
  void for_each_corner(const Function& f) const
  {
    const auto& level = piece_.connectivity();
    for (Index face = 0; face < piece_.number_of_faces(); ++face) {
      if (!piece_.owns_face(face)) continue;
      const Index first = level.halfedge_of_face(face);
      Index h = first;
      do {
        const Index n = level.next(h);
        f(level.target(h), n == first);
        h = n;
      } while (h != first);
    }
  }

  static constexpr Index none = std::numeric_limits<Index>::max(), used = none - 1;

  const Any_pieces::Piece& piece_;
  const Piece_normals& normals_;
  std::vector<Index> row_, vertices_; // the row of each vertex, the vertex of each row
  std::size_t corners_ = 0, faces_ = 0;
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
  Pvtp_pieces(const Any_pieces& pieces, const Piece_normals& normals, const Output_names& names)
    : pieces_(pieces)
    , normals_(normals)
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
    Vtp_arrays(piece, normals_).write(out);
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
    const auto normals = [](const std::string& name) {
      return "<PDataArray type=\"Float64\" Name=\"" + name + "\" NumberOfComponents=\"3\"/>\n";
    };
    out.text("<?xml version=\"1.0\"?>\n");
    if (normals_.are_written) out.text(std::string("<!-- ") + comment_of(normals_.kind) + " -->\n");
    out.text("<VTKFile type=\"PPolyData\" version=\"1.0\" "
             "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
             "<PPolyData GhostLevel=\"0\">\n<PPointData ");
    out.text(normals_.are_written ? "Normals=\"Normals\" GlobalIds=\"GlobalPointIds\">\n"
                                  : "GlobalIds=\"GlobalPointIds\">\n");
    if (normals_.are_written) out.text(normals("Normals"));
    if (normals_.with_control) out.text(normals("control_normals"));
    if (normals_.with_roundness) out.text("<PDataArray type=\"Float64\" Name=\"roundness\"/>\n");
    out.text("<PDataArray type=\"Int64\" Name=\"GlobalPointIds\"/>\n</PPointData>\n"
             "<PCellData GlobalIds=\"GlobalCellIds\">\n"
             "<PDataArray type=\"Int64\" Name=\"GlobalCellIds\"/>\n</PCellData>\n<PPoints>\n"
             "<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
             "</PPoints>\n");
    const std::string folder = xml_text(names_.folder.filename().string());
    for (std::size_t i = 0; i < pieces_.number(); ++i)
      if (!pieces_.is_empty(i))
        out.text("<Piece Source=\"" + folder + "/" + piece_name(i) + "\"/>\n");
    out.text("</PPolyData>\n</VTKFile>\n");
  }

  const Any_pieces& pieces_;
  const Piece_normals normals_;
  const Output_names names_;
};

} // namespace

std::unique_ptr<Piece_output>
make_pvtp_output(const Any_pieces& pieces, const Piece_normals& normals, const Output_names& names)
{
  return std::make_unique<Pvtp_pieces>(pieces, normals, names);
}

} // namespace pn_subdivide
