// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Piece_output.h"

#include "io/Error.h"

#include <CGAL/PN_subdivision_3/parameters/parameters.h>
#include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>

#include <cctype>
#include <cmath>
#include <cstdlib>

namespace pn_subdivide {
namespace {

template <class S>
class Pieces_of_scheme : public Any_pieces
{
public:
  template <class NamedParameters>
  Pieces_of_scheme(const Surface& surface, const S& scheme, std::size_t number,
                   const NamedParameters& np)
    : pieces_(surface, scheme, PN::parameters::join(PN::parameters::number_of_pieces(number), np))
  {}

  std::size_t number() const override { return pieces_.number_of_pieces(); }
  bool is_empty(std::size_t i) const override { return pieces_.is_empty(i); }
  const Size& size() const override { return pieces_.size(); }
  std::uint64_t first_corner(std::uint64_t face) const override
  {
    return pieces_.first_corner(face);
  }
  std::size_t largest_degree() const override { return pieces_.largest_degree(); }
  Piece piece(std::size_t i, unsigned rings) const override { return pieces_.piece(i, rings); }
  CGAL::Bbox_3 box_of_piece(std::size_t i) const override { return pieces_.box_of_piece(i); }
  void set_box(const CGAL::Bbox_3& box) override { pieces_.set_box(box); }

private:
  PN::Surface_pieces<S, Kernel, CGAL::Parallel_if_available_tag> pieces_;
};

template <class S, class NamedParameters>
std::unique_ptr<Any_pieces> pieces_of_scheme(const Surface& surface, const S& scheme,
                                             std::size_t number, const NamedParameters& np)
{
  return std::make_unique<Pieces_of_scheme<S>>(surface, scheme, number, np);
}

template <class NamedParameters>
auto with_limit(const Limit_choice& limit, const PN::Attribute_table& attributes,
                const NamedParameters& np)
{
  return PN::parameters::join(PN::parameters::attributes(attributes)
                                .to_limit(limit.is_used())
                                .points(limit.points)
                                .surface_normals(limit.normals)
                                .tolerance(limit.tolerance_or_default()),
                              np);
}

std::unique_ptr<Any_pieces> pieces_with_creases(Surface& surface, const Scheme_choice& choice,
                                                unsigned levels, std::size_t number,
                                                const Crease_maps& creases,
                                                const Limit_choice& limit,
                                                const PN::Attribute_table& attributes)
{
  const auto np = with_limit(limit, attributes,
                             PN::parameters::border(creases.border)
                               .number_of_iterations(levels)
                               .edge_is_constrained_map(creases.edges)
                               .vertex_is_constrained_map(creases.vertices));
  if (!normals_of(surface)) {
    const Scheme scheme = scheme_of(choice);
    return pieces_of_scheme(surface, PN::linear(scheme), number, np);
  }
  const std::vector<Corner_value> of_corners = take_corner_normals(surface);
  return pieces_of_scheme(surface, scheme_with_normals(choice), number,
                          PN::parameters::join(PN::parameters::crease_tangent_map(creases.tangents),
                                               np.vertex_normal_map(Control_corner_normals(
                                                 of_corners, creases.without_fractions))));
}

constexpr double mega = 1 << 20;
constexpr double default_memory = 1024 * mega;
constexpr double of_the_program = 48 * mega; // with its buffers, and the control mesh
constexpr double of_limits = 2; // limits are kept beside the last level, which has more rings
constexpr std::size_t most_pieces = 1 << 20;

std::string in_megabytes(double bytes)
{
  return std::to_string(static_cast<unsigned long long>(std::ceil(bytes / mega))) + "M";
}

} // namespace

std::unique_ptr<Any_pieces> make_pieces(Surface& surface, const Scheme_choice& choice,
                                        unsigned levels, std::size_t number,
                                        const std::optional<Crease_maps>& creases,
                                        const Limit_choice& limit,
                                        const PN::Attribute_table& attributes)
{
  if (creases)
    return pieces_with_creases(surface, choice, levels, number, *creases, limit, attributes);
  const auto rounds = with_limit(limit, attributes, CGAL::parameters::number_of_iterations(levels));
  const std::optional<Normal_map> normals = normals_of(surface);
  if (!normals) return pieces_of_scheme(surface, PN::linear(scheme_of(choice)), number, rounds);
  const auto given = PN::parameters::join(CGAL::parameters::vertex_normal_map(*normals), rounds);
  const Roundness_map roundness = roundness_or_added(surface);
  return pieces_of_scheme(
    surface, scheme_with_normals(choice), number,
    PN::parameters::join(PN::parameters::vertex_roundness_map(roundness), given));
}

double memory_of_pieces(const Surface& surface, const Scheme_choice& choice, unsigned levels,
                        std::size_t number, double of_vertex)
{
  Any_pieces::Size size;
  size.vertices = surface.number_of_vertices();
  size.edges = surface.number_of_edges();
  size.faces = surface.number_of_faces();
  for (const Halfedge h : surface.halfedges())
    if (!surface.is_border(h)) ++size.corners;
  // beside those of points, normals and connectivity
  constexpr double bytes_of_vertex = 200;
  return (1 + of_vertex / bytes_of_vertex) *
         PN::Surface_pieces<Scheme, Kernel>::memory(scheme_of(choice), size, levels, number);
}

double parse_memory(const std::string& text)
{
  char* end = nullptr;
  const bool is_number = !text.empty() && std::isdigit(static_cast<unsigned char>(text[0]));
  double bytes = is_number ? std::strtod(text.c_str(), &end) : 0;
  const std::string unit = is_number ? end : "";
  if (unit == "K")
    bytes *= 1024;
  else if (unit == "M")
    bytes *= mega;
  else if (unit == "G")
    bytes *= 1024 * mega;
  else if (unit == "T")
    bytes *= mega * mega;
  else
    bytes = 0;
  if (!(bytes > 0) || !std::isfinite(bytes))
    throw Usage_error("--memory '" + text + "': it takes a size such as 500M or 2G");
  return bytes;
}

std::size_t piece_count(const Surface& surface, const Scheme_choice& scheme, unsigned levels,
                        const Pieces_options& options, unsigned ranks, bool with_limits,
                        double of_vertex)
{
  if (options.pieces) return *options.pieces;
  const double memory = options.memory ? parse_memory(*options.memory) : default_memory;
  double least_bytes = 0;
  // a few pieces for each rank, so that none waits long for the last one
  for (std::size_t n = ranks == 1 ? 1 : 4 * std::size_t(ranks); n <= most_pieces; n += n / 4 + 1) {
    const double here = of_the_program + (with_limits ? of_limits : 1) *
                                           memory_of_pieces(surface, scheme, levels, n, of_vertex);
    if (here <= memory) return n;
    if (least_bytes == 0 || here < least_bytes) least_bytes = here;
  }
  throw Error("--memory: " + in_megabytes(memory) + " are not enough, it takes at least " +
              in_megabytes(least_bytes));
}

} // namespace pn_subdivide
