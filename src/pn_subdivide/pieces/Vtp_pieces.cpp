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
#include "pieces/Piece_output.h"
#include "pieces/Shared_file.h"

#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

using Index = Any_pieces::Piece::Index;

// The arrays of a piece, in which a vertex that the piece has twice is there once.
class Vtp_arrays
{
public:
  explicit Vtp_arrays(const Any_pieces::Piece& piece)
    : piece_(piece)
    , row_(piece.number_of_vertices())
  {
    for (Index v = 0; v < row_.size(); ++v) {
      const bool is_new = v == 0 || piece.vertex_number(v) != piece.vertex_number(v - 1);
      if (is_new) vertices_.push_back(v);
      row_[v] = static_cast<Index>(vertices_.size() - 1);
    }
    for (Index f = 0; f < piece.number_of_faces(); ++f)
      corners_ += piece.connectivity().degree(piece.connectivity().halfedge_of_face(f));
  }

  void write(Output_file& out) const
  {
    Vtp_writer vtp(out, Encoding::binary);
    vtp.begin();
    vtp.begin_piece(vertices_.size(), piece_.number_of_faces());
    const bool has_normals = !piece_.normals().empty();
    vtp.line(has_normals ? R"(<PointData Normals="Normals" GlobalIds="GlobalPointIds">)"
                         : R"(<PointData GlobalIds="GlobalPointIds">)");
    if (has_normals)
      vtp.triples("Normals", vertices_.size(),
                  [&](std::size_t i) { return to_triple(piece_.normals()[vertices_[i]]); });
    vtp.integers("GlobalPointIds", vertices_.size(), [&] {
      for (const Index v : vertices_) put(vtp, piece_.vertex_number(v));
    });
    vtp.line("</PointData>\n<CellData GlobalIds=\"GlobalCellIds\">");
    vtp.integers("GlobalCellIds", piece_.number_of_faces(), [&] {
      for (Index f = 0; f < piece_.number_of_faces(); ++f) put(vtp, piece_.face_number(f));
    });
    vtp.line("</CellData>\n<Points>");
    vtp.triples("Points", vertices_.size(),
                [&](std::size_t i) { return to_triple(piece_.points()[vertices_[i]]); });
    vtp.line("</Points>\n<Polys>");
    vtp.integers("connectivity", corners_,
                 [&] { for_each_corner([&](Index v, bool) { put(vtp, row_[v]); }); });
    vtp.integers("offsets", piece_.number_of_faces(), [&] {
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
      const Index first = level.halfedge_of_face(face);
      Index h = first;
      do {
        const Index n = level.next(h);
        f(level.target(h), n == first);
        h = n;
      } while (h != first);
    }
  }

  const Any_pieces::Piece& piece_;
  std::vector<Index> row_, vertices_; // the row of each vertex, the vertex of each row
  std::size_t corners_ = 0;
};

std::string piece_name(std::size_t i)
{
  return "piece_" + std::to_string(i) + ".vtp";
}

bool is_piece_name(const std::string& name)
{
  const std::string begin = "piece_", end = ".vtp";
  return name.size() > begin.size() + end.size() && name.rfind(begin, 0) == 0 &&
         name.find_first_not_of("0123456789", begin.size()) == name.size() - end.size() &&
         name.compare(name.size() - end.size(), end.size(), end) == 0;
}

class Pvtp_pieces : public Piece_output
{
public:
  Pvtp_pieces(const Any_pieces& pieces, bool has_normals, const fs::path& part,
              const fs::path& target)
    : pieces_(pieces)
    , has_normals_(has_normals)
    , part_(part)
    , target_(target)
    , folder_(target.parent_path() / (target.stem().string() + "_pieces"))
  {
    require_own_folder();
  }

  // at least: a vertex between pieces is in several files
  std::uint64_t size() const override
  {
    const Any_pieces::Size& size = pieces_.size();
    return size.vertices * (has_normals_ ? 56 : 32) + size.faces * 16 +
           pieces_.first_corner(size.faces) * 8;
  }

  void create() override
  {
    if (fs::exists(part_)) return;
    std::error_code error;
    fs::create_directory(part_, error);
    if (error) throw Error(part_.string() + " cannot be made: " + error.message());
  }
  void open() override {}
  void write(std::size_t i, const Any_pieces::Piece& piece) override
  {
    if (pieces_.is_empty(i)) return;
    Output_file out((part_ / piece_name(i)).string(), Output_file::In_temporary_folder());
    Vtp_arrays(piece).write(out);
    out.commit();
  }
  void sync(std::size_t i) override
  {
    if (pieces_.is_empty(i)) return;
    sync_file(part_ / piece_name(i));
    sync_file(part_); // its name
  }
  void close() override {}
  void finish() override
  {
    Output_file index(target_.string());
    write_index(index);
    require_own_folder();
    const fs::path old = folder_.string() + ".old";
    std::error_code ignored;
    const bool has_old = fs::exists(folder_);
    if (has_old) rename(folder_, old);
    try {
      rename(part_, folder_);
      index.commit();
    } catch (...) { // what was there comes back
      fs::rename(folder_, part_, ignored);
      if (has_old) fs::rename(old, folder_, ignored);
      throw;
    }
    if (has_old) fs::remove_all(old, ignored);
  }

private:
  static void rename(const fs::path& from, const fs::path& to)
  {
    std::error_code error;
    fs::rename(from, to, error);
    if (error)
      throw Error(from.string() + " cannot be renamed to " + to.string() + ": " + error.message());
  }

  // What lies in the folder is replaced: it must be what this program has put there.
  void require_own_folder() const
  {
    if (!fs::exists(folder_)) return;
    if (fs::is_directory(folder_)) {
      bool is_own = true;
      for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
        is_own = is_own && is_piece_name(entry.path().filename().string());
      if (is_own) return;
    }
    throw Error("the pieces go into the folder " + folder_.string() +
                ", and something else is there: remove it, or take another name");
  }

  void write_index(Output_file& out) const
  {
    const std::string normals =
      "<PDataArray type=\"Float64\" Name=\"Normals\" NumberOfComponents=\"3\"/>\n";
    out.text("<?xml version=\"1.0\"?>\n<VTKFile type=\"PPolyData\" version=\"1.0\" "
             "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
             "<PPolyData GhostLevel=\"0\">\n<PPointData ");
    out.text((has_normals_ ? "Normals=\"Normals\" GlobalIds=\"GlobalPointIds\">\n" + normals
                           : "GlobalIds=\"GlobalPointIds\">\n"));
    out.text("<PDataArray type=\"Int64\" Name=\"GlobalPointIds\"/>\n</PPointData>\n"
             "<PCellData GlobalIds=\"GlobalCellIds\">\n"
             "<PDataArray type=\"Int64\" Name=\"GlobalCellIds\"/>\n</PCellData>\n<PPoints>\n"
             "<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
             "</PPoints>\n");
    const std::string folder = Vtp_writer::escaped(folder_.filename().string());
    for (std::size_t i = 0; i < pieces_.number(); ++i)
      if (!pieces_.is_empty(i))
        out.text("<Piece Source=\"" + folder + "/" + piece_name(i) + "\"/>\n");
    out.text("</PPolyData>\n</VTKFile>\n");
  }

  const Any_pieces& pieces_;
  bool has_normals_;
  fs::path part_, target_, folder_;
};

} // namespace

std::unique_ptr<Piece_output> make_pvtp_output(const Any_pieces& pieces, bool has_normals,
                                               const fs::path& part, const fs::path& target)
{
  return std::make_unique<Pvtp_pieces>(pieces, has_normals, part, target);
}

} // namespace pn_subdivide
