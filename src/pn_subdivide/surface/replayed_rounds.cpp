// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/replayed_rounds.h"

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

namespace pn_subdivide {
namespace {

namespace PN = CGAL::PN_subdivision_3;

// Without points, which take no part.
std::optional<Mesh_data> control_mesh(const Mesh_data& mesh)
{
  const Mesh_origin& origin = mesh.origin;
  if (origin.vertices > mesh.points.size() + origin.corners.size()) return std::nullopt;
  Mesh_data control;
  control.points.assign(origin.vertices, Triple{0, 0, 0});
  std::vector<Mesh_data::Index> face;
  std::size_t begin = 0;
  for (const std::size_t end : origin.face_end) {
    face.assign(origin.corners.begin() + std::ptrdiff_t(begin),
                origin.corners.begin() + std::ptrdiff_t(end));
    std::vector<Mesh_data::Index> sorted = face;
    std::sort(sorted.begin(), sorted.end());
    const bool is_face = face.size() >= 3 && sorted.back() < origin.vertices &&
                         std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    if (!is_face) return std::nullopt;
    control.add_face(face);
    begin = end;
  }
  return control;
}

template <class Scheme>
void refine(Surface& surface, const Scheme& scheme, unsigned rounds)
{
  PN::subdivide(surface, PN::linear(scheme), CGAL::parameters::number_of_iterations(rounds));
}

// One of the schemes by which the ways to split faces are named; false if there is none.
bool refine(Surface& surface, const std::string& scheme, unsigned rounds)
{
  if (scheme == "catmull-clark")
    refine(surface, PN::CatmullClark_scheme(), rounds);
  else if (scheme == "loop")
    refine(surface, PN::Loop_scheme(), rounds);
  else if (scheme == "sqrt3")
    refine(surface, PN::Sqrt3_scheme(), rounds);
  else if (scheme == "doo-sabin")
    refine(surface, PN::DooSabin_scheme(), rounds);
  else
    return false;
  return true;
}

// Damaged numbers must not make it larger than the mesh that it is to become.
bool replay(Surface& surface, const Mesh_origin::Rounds& rounds, std::size_t faces)
{
  constexpr unsigned most_rounds = 64;
  if (rounds.number > most_rounds) return false;
  if (rounds.scheme == "sqrt3") // whose rounds alternate
    return double(surface.number_of_faces()) * std::pow(3., rounds.number) <= 2. * double(faces) &&
           refine(surface, rounds.scheme, rounds.number);
  for (unsigned k = 0; k < rounds.number; ++k)
    if (surface.number_of_faces() > faces || !refine(surface, rounds.scheme, 1)) return false;
  return true;
}

bool has_faces_of(const Surface& surface, const Mesh_data& mesh)
{
  if (surface.number_of_vertices() != mesh.points.size() ||
      surface.number_of_faces() != mesh.number_of_faces())
    return false;
  std::size_t f = 0;
  for (const Surface::Face_index face : surface.faces()) {
    const Mesh_data::Face expected = mesh.face(f++);
    const Mesh_data::Index* next = expected.begin();
    for (const auto h : halfedges_around_face(surface.halfedge(face), surface)) {
      if (next == expected.end() || Mesh_data::Index(surface.target(h)) != *next) return false;
      ++next;
    }
    if (next != expected.end()) return false;
  }
  return true;
}

} // namespace

std::optional<Surface> replayed_rounds(const Mesh_data& mesh)
{
  if (!mesh.origin.any()) return std::nullopt;
  const std::optional<Mesh_data> control = control_mesh(mesh);
  if (!control || control->number_of_faces() == 0) return std::nullopt;
  try {
    Surface surface = make_surface(*control);
    for (const Mesh_origin::Rounds& rounds : mesh.origin.rounds)
      if (!replay(surface, rounds, mesh.number_of_faces())) return std::nullopt;
    if (has_faces_of(surface, mesh)) return surface;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) { // the control faces are none that can be refined
  }
  return std::nullopt;
}

} // namespace pn_subdivide
