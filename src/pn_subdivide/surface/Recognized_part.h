// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_RECOGNIZED_PART_H
#define PN_SUBDIVIDE_RECOGNIZED_PART_H

#include "io/Report.h"
#include "options.h"
#include "surface/Surface.h"
#include "surface/creases.h"

#include <CGAL/PN_recognition_3/surfaces/Recognized_surface.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace pn_subdivide {

struct Moved_vertex
{
  std::size_t vertex;
  Point_3 point;
};

using Recognized_surface = PN::Recognized_surface;

// Where a face is, and how it lies.
struct Face_place
{
  Point_3 middle;
  Vector_3 twice_area;
  double size = 0; // how far its vertices are apart
};
Face_place place_of(const Surface& surface, Face f);

// neither a plane nor unknown
bool is_round(Recognized_surface::Kind kind);

// What --sharp surfaces finds in a control mesh, by the numbers of make_surface().
struct Recognized_part
{
  std::vector<Recognized_surface> surfaces; // one a segment
  std::vector<std::size_t> segments;        // of the faces
  std::vector<bool> creases;                // is the edge one?
  std::size_t tangent_creases = 0;          // between surfaces that touch
  std::size_t slight_creases = 0;           // of round surfaces that meet at up to 40 degrees
  std::vector<std::size_t> corners;         // vertices: apexes of cones
  std::vector<Vector_3> normals;            // of corners; zero: none
  std::vector<double> roundness;            // of vertices: 0 where nothing is known, else 1
  std::vector<Moved_vertex> moved; // that were cut; all else is with these in their new places
  double unknown_area = 0, area = 0;
  double sure_area =
    0; // of surfaces with more vertices than determine them, and of triangles among such faces only
  // of a file of all digits: a tolerance with which clearly more is recognized, and how many segments then; 0: there is none
  double other_tolerance = 0;
  std::size_t other_segments = 0;

  bool is_known(std::size_t segment) const
  {
    return surfaces[segment].kind != Recognized_surface::Kind::unknown;
  }
  bool knows_any() const;
  // Is it one beyond doubt? Surfaces cover it, planes and round ones, and not only rows of cones, as which a vase is recognized.
  bool is_sure() const;
};

// The mesh must be an oriented 2-manifold. Its normals take no part. Passes on the library's exceptions.
Recognized_part recognize_part(const Mesh_data& mesh, const Recognition_plan& plan);

// Moves the vertices that were cut.
void move_cut_vertices(Mesh_data& mesh, const Recognized_part& part);

// Moves the vertices of a refined part that the scheme has left off their surfaces, as of cones. `parents`: the control faces of
// the faces.
void put_on_surfaces(Surface& refined, const std::vector<double>& parents,
                     const Recognized_part& part);

// Gives the mesh the normals of the part or, with `where_file_has_none`, only those that the file does not give.
void put_surface_normals(Mesh_data& mesh, const Recognized_part& part, bool where_file_has_none);

// What --part stands for: --sharp surfaces --planes rims, and --chord 0.02% unless a chord or rounds are given. Throws Usage_error,
// which names --part, if it does not go with the other options.
Surface_options with_part(const Surface_options& options);

// A first look: flat patches behind sharp edges at a tenth of some vertices. It takes at most a twentieth of the time of a round.
bool looks_like_part(const Mesh_data& mesh);

// May --sharp auto take the mesh of a file without tags and normals for a part, as far as the options and the scheme go?
bool may_be_part(const Surface_options& options, const Scheme_choice& scheme);

// "taken for a part of 6 planes and 2 round surfaces on 100 % of its area ..."
std::string taken_for_part(const Recognized_part& part);

// What helps to keep edges: --part where surfaces cover half of the area, --sharp angle:40 where few of the edges turn, or nothing.
enum class Edge_advice { none, part, angle };
Edge_advice edge_advice(const Recognized_part* part, std::size_t turning, std::size_t edges);

// How far a mesh is from the surfaces that its faces belong to: its vertices, and the middles of its edges and faces.
struct Deviation
{
  double of_vertices = 0, of_faces = 0;
};

// What was found in a part, and what has become of it.
class Surface_table
{
public:
  Surface_table(const Recognized_part& part, const Surface& control);

  // The numbers of the faces take the place of the segments until the refined mesh is measured.
  void number_faces(Attributes& attributes) const;
  void measure(const Surface& refined, Attributes& attributes);
  void set_crossed_planes(std::size_t number) { crossed_planes_ = number; }
  // Forgets the folds of what has got other faces: is_replaced(segment).
  template <class Is_replaced>
  void forget_folds(const Is_replaced& is_replaced)
  {
    folded_faces_.erase(
      std::remove_if(folded_faces_.begin(), folded_faces_.end(),
                     [&](std::size_t f) { return is_replaced(part_.segments[f]); }),
      folded_faces_.end());
  }

  // Several lines: numbers of each kind, and a table of what is round.
  std::string text() const;
  std::vector<Report::Row> rows() const;
  void warn(const std::string& input, Report& report) const;
  // How far triangles within a tolerance of the limit surface are from the surfaces themselves, which need not be the same.
  void report_chord(double chord, const std::string& output, Report& report) const;

private:
  double along(const Face_place& place, std::size_t segment) const;
  bool is_folded(const Face_place& place, std::size_t segment) const;

  const Recognized_part& part_;
  std::vector<Deviation> before_, after_;
  std::vector<double> along_;             // of the segments: their faces' sum
  std::vector<bool> was_folded_;          // of the control faces
  std::vector<std::size_t> folded_faces_; // that were not
  std::size_t crossed_planes_ = 0;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_RECOGNIZED_PART_H
