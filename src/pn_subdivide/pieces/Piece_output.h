// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_PIECE_OUTPUT_H
#define PN_SUBDIVIDE_PIECE_OUTPUT_H

#include "io/Limit_choice.h"
#include "io/formats.h"
#include "io/mesh_normals.h"
#include "options.h"
#include "pieces/Output_names.h"
#include "surface/attributes.h"
#include "surface/creases.h"
#include "surface/output_mesh.h"
#include "surface/surface_schemes.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/PN_limit_surface_3/refine_in_pieces.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pn_subdivide {

// The pieces of a surface refined by any scheme: Surface_pieces without its type.
class Any_pieces
{
public:
  using Piece = PN::Surface_piece<Kernel>;
  using Size = PN::Level_size;

  virtual ~Any_pieces() = default;
  virtual std::size_t number() const = 0;
  virtual bool is_empty(std::size_t i) const = 0;
  virtual const Size& size() const = 0;
  virtual std::uint64_t first_corner(std::uint64_t face) const = 0;
  virtual std::size_t largest_degree() const = 0;
  virtual Piece piece(std::size_t i, unsigned rings) const = 0;
  // The tolerance of limits is a part of the size of the box of all pieces, which has to be set.
  virtual CGAL::Bbox_3 box_of_piece(std::size_t i) const = 0;
  virtual void set_box(const CGAL::Bbox_3& box) = 0;
};

// The surface is not needed afterwards. Its normals are refined if it has some; with creases those of corners are
// removed. Vertices are on the limit surface, and have its normals, if that is asked for.
std::unique_ptr<Any_pieces> make_pieces(Surface& surface, const Scheme_choice& choice,
                                        unsigned levels, std::size_t number,
                                        const std::optional<Crease_maps>& creases,
                                        const Limit_choice& limit,
                                        const PN::Attribute_table& attributes);

// The bytes that so many pieces take in a process, about, with so many for each vertex besides.
double memory_of_pieces(const Surface& surface, const Scheme_choice& choice, unsigned levels,
                        std::size_t number, double of_vertex);

// "500M": bytes. Throws Usage_error.
double parse_memory(const std::string& text);

// How many pieces are made: as asked for, or so many that one of them fits into the memory. Throws Error if none
// does.
std::size_t piece_count(const Surface& surface, const Scheme_choice& scheme, unsigned levels,
                        const Pieces_options& options, unsigned ranks, bool with_limits,
                        double of_vertex);

// Which normals pieces have in the output.
struct Piece_normals
{
  bool are_written = false, with_control = false;
  bool with_roundness = false;
  bool are_of_faces = false; // of those around, and not control normals
  bool are_of_wedges =
    false; // at vertices with several the sums of their different normals at the limit
  Normal_kind kind = Normal_kind::control;
  double scale = 1;

  Piece_normals() = default;
  Piece_normals(const Output_normals& normals, bool has_normals, const Limit_choice& limit)
    : are_written((has_normals || limit.normals) && normals.any())
    , with_control(has_normals && normals.with_control())
    , are_of_faces(are_written && normals.are_of_faces())
    , are_of_wedges(are_written && !are_of_faces && limit.is_used())
    , kind(normals.kind)
    , scale(normals.scale)
  {}

  // roundness goes with control normals alone
  void add_roundness()
  {
    with_roundness = with_control || (are_written && kind == Normal_kind::control);
  }

  // the numbers of a vertex, its point among them
  unsigned numbers() const
  {
    return 3 + (are_written ? 3 : 0) + (with_control ? 3 : 0) + (with_roundness ? 1 : 0);
  }
  // of faces around a piece that its own normals depend on; with creases control normals are not written
  unsigned rings() const { return are_of_faces || are_of_wedges ? 1 : 0; }
};

// f(half-edge) for the corners of a face
template <class Level, class Function>
void for_each_corner(const Level& level, Any_pieces::Piece::Index face, const Function& f)
{
  const auto first = level.halfedge_of_face(face);
  auto h = first;
  do {
    f(h);
    h = level.next(h);
  } while (h != first);
}

// The wedges of vertices that have several: at a vertex in the order of their least half-edges, as Several_wedges has
// them in the whole surface.
class Wedges_of_piece
{
public:
  using Piece = Any_pieces::Piece;

  // The piece must stay.
  explicit Wedges_of_piece(const Piece& piece)
    : corners_(piece.corners_of_several_wedges())
    , has_several_(corners_.empty() ? 0 : piece.number_of_vertices(), false)
  {
    std::unordered_map<std::uint64_t, std::size_t> number;
    for (const Piece::Corner& c : corners_) {
      const Index v = piece.connectivity().target(c.halfedge);
      has_several_[v] = true;
      const auto [it, is_new] =
        number.try_emplace((std::uint64_t(v) << 32) + c.wedge, vertex_.size());
      if (is_new) vertex_.push_back(v);
      of_corner_.push_back(it->second);
    }
  }

  std::size_t number() const { return vertex_.size(); }
  bool at(Index v) const { return !has_several_.empty() && has_several_[v]; }
  // \pre at(the target)
  std::size_t of(Index h) const
  {
    const auto it =
      std::lower_bound(corners_.begin(), corners_.end(), h,
                       [](const Piece::Corner& c, Index other) { return c.halfedge < other; });
    return of_corner_[std::size_t(it - corners_.begin())];
  }

  // Those of the vertices, which are zero, become the sums of those of the wedges, which are behind them and go.
  void add_to_vertices(std::vector<Triple>& normals) const
  {
    const std::size_t vertices = normals.size() - vertex_.size();
    for (std::size_t w = 0; w < vertex_.size(); ++w)
      for (std::size_t k = 0; k < 3; ++k) normals[vertex_[w]][k] += normals[vertices + w][k];
    normals.resize(vertices);
    for (std::size_t v = 0; v < has_several_.size(); ++v)
      if (has_several_[v]) normals[v] = normalized(normals[v]);
  }

private:
  const std::vector<Piece::Corner>& corners_;
  std::vector<bool> has_several_;
  std::vector<Index> vertex_;          // of each wedge
  std::vector<std::size_t> of_corner_; // by their places in corners_
};

// The normals of a piece with its rings.
class Normals_of_piece
{
public:
  using Piece = Any_pieces::Piece;

  // The piece must stay.
  Normals_of_piece(const Piece& piece, const Piece_normals& normals)
    : piece_(piece)
  {
    if (normals.are_of_wedges) add_normals_of_wedges();
    if (!normals.are_of_faces) return;
    const auto& level = piece.connectivity();
    const std::size_t vertices = piece.number_of_vertices();
    const Wedges_of_piece wedges(piece);
    Area_normals sums(vertices + wedges.number(), normals.scale);
    std::vector<Piece::Index> corners;
    std::vector<std::size_t> places;
    for (Piece::Index f = 0; f < piece.number_of_faces(); ++f) {
      corners.clear();
      places.clear();
      for_each_corner(level, f, [&](Piece::Index h) {
        corners.push_back(level.target(h));
        places.push_back(wedges.at(corners.back()) ? vertices + wedges.of(h) : corners.back());
      });
      sums.add_face(
        corners.size(), [&](std::size_t i) { return to_triple(piece.points()[corners[i]]); },
        [&](std::size_t i) { return places[i]; });
    }
    of_faces_ = sums.take();
    wedges.add_to_vertices(of_faces_);
  }

  Triple operator[](Piece::Index v) const
  {
    const auto sum = sums_.find(v);
    if (sum != sums_.end())
      return sum->second.number > 1 ? normalized(sum->second.of) : sum->second.of;
    return of_faces_.empty() ? control(v) : of_faces_[v];
  }
  Triple control(Piece::Index v) const { return to_triple(piece_.normals()[v]); }

private:
  struct Sum
  {
    Triple of;
    int number;
    std::vector<Triple> summands;
  };

  // as set_vertex_normals() has them, in the order of the faces
  void add_normals_of_wedges()
  {
    if (piece_.corners_of_several_wedges().empty()) return;
    std::vector<const Piece::Corner*> corners;
    for (const Piece::Corner& c : piece_.corners_of_several_wedges()) corners.push_back(&c);
    const auto& level = piece_.connectivity();
    std::sort(corners.begin(), corners.end(), [&](const auto* a, const auto* b) {
      return level.face(a->halfedge) < level.face(b->halfedge);
    });
    for (const Piece::Corner* c : corners) {
      const Triple n = to_triple(c->normal);
      Sum& sum = sums_.try_emplace(level.target(c->halfedge), Sum{{0, 0, 0}, 0, {}}).first->second;
      const auto is_same = [&](const Triple& other) { return are_equal(other, n); };
      if (std::any_of(sum.summands.begin(), sum.summands.end(), is_same)) continue;
      for (std::size_t k = 0; k < 3; ++k) sum.of[k] = sum.number == 0 ? n[k] : sum.of[k] + n[k];
      ++sum.number;
      sum.summands.push_back(n);
    }
  }

  const Piece& piece_;
  std::vector<Triple> of_faces_;
  std::unordered_map<Piece::Index, Sum> sums_; // of vertices with several wedges
};

// The attributes of pieces in the output.
class Piece_attributes
{
public:
  using Piece = Any_pieces::Piece;

  Piece_attributes(Carried_attributes carried, Mesh_file output)
    : carried_(std::move(carried))
    , output_(std::move(output))
  {}

  const Carried_attributes::Table& table() const { return carried_.table(); }
  bool has_texture() const { return !table().corners.empty(); }

  // with the columns and the types of those of pieces, but without values
  Attributes like() const
  {
    Carried_attributes::Table table = this->table();
    for (auto* arrays : {&table.vertices, &table.corners})
      for (auto& array : *arrays) array.values.clear();
    return of(table, {});
  }
  // of all its vertices, faces and, face by face, corners
  Attributes of(const Piece& piece) const
  {
    if (piece.attributes() == nullptr) return like();
    const auto& level = piece.connectivity();
    std::vector<std::size_t> corners;
    for (Piece::Index f = 0; has_texture() && f < piece.number_of_faces(); ++f)
      for_each_corner(level, f, [&](Piece::Index h) { corners.push_back(h); });
    return of(*piece.attributes(), corners);
  }

private:
  Attributes of(const Carried_attributes::Table& table,
                const std::vector<std::size_t>& corners) const
  {
    Attributes attributes = carried_.of_piece(table, corners);
    take_types_of_format(output_, attributes);
    return attributes;
  }

  Carried_attributes carried_;
  Mesh_file output_;
};

// What pieces are written into, under a name of its own until all of them are there. The functions are called
// in the order in which they stand; create(), mend() and finish() by one rank, the others by all.
class Piece_output
{
public:
  virtual ~Piece_output() = default;

  // the bytes that it will take
  virtual std::uint64_t size() const = 0;
  // unless it is to be continued; throws Error if the name is taken
  virtual void create() = 0;
  // all but the pieces
  virtual void mend() {}
  // Is a piece there as it was when it was written? The receipt is that of write().
  virtual bool is_written(std::size_t i, const std::string& receipt) const = 0;
  virtual void open() {}
  virtual void write(std::size_t i, const Any_pieces::Piece& piece) = 0;
  // Until a piece that was just written is on the disk. Returns a receipt, without line ends.
  virtual std::string sync(std::size_t i) = 0;
  virtual void close() {}
  // gives it the name that was asked for
  virtual void finish() = 0;
  // instead of it: was there something to remove?
  virtual bool remove() = 0;
};

// Throws Error if the format cannot hold the surface.
std::unique_ptr<Piece_output> make_ply_output(const Any_pieces& pieces,
                                              const Piece_normals& normals,
                                              const Piece_attributes& attributes,
                                              const Output_names& names, bool keeps_receipts);
std::unique_ptr<Piece_output> make_pvtp_output(const Any_pieces& pieces,
                                               const Piece_normals& normals,
                                               const Piece_attributes& attributes,
                                               const Output_names& names);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_PIECE_OUTPUT_H
