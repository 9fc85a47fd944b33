// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OUTPUT_MESH_H
#define PN_SUBDIVIDE_OUTPUT_MESH_H

#include "io/Error.h"
#include "io/Mesh_data.h"
#include "io/Output_file.h"
#include "io/Report.h"
#include "io/mesh_io.h"
#include "io/mesh_normals.h"
#include "surface/Surface.h"
#include "surface/creases.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pn_subdivide {

// The unit sums of the area vectors of the faces at vertices, or at wedges of vertices. They depend on the order
// in which faces are added, in their last bits.
class Area_normals
{
public:
  // scale: a power of 2, so that no product overflows or vanishes
  Area_normals(std::size_t number, double scale)
    : sums_(number, Triple{0, 0, 0})
    , scale_(scale)
  {}

  // The points of n corners, and the vertices or wedges at them: point(i), place(i).
  template <class Point, class Place>
  void add_face(std::size_t n, const Point& point, const Place& place)
  {
    const Triple area = twice_the_area(n, point);
    for (std::size_t i = 0; i < n; ++i) {
      Triple& sum = sums_[place(i)];
      for (std::size_t k = 0; k < 3; ++k) sum[k] += area[k];
    }
  }

  // zero where there is no area
  std::vector<Triple> take()
  {
    for (Triple& n : sums_) n = normalized(n);
    return std::move(sums_);
  }

private:
  template <class Point>
  Triple twice_the_area(std::size_t n, const Point& point) const
  {
    const auto from_to = [&](std::size_t i, std::size_t j) {
      Triple d = difference(point(j), point(i));
      for (double& x : d) x *= scale_;
      return d;
    };
    if (n == 4) return cross_product(from_to(0, 2), from_to(1, 3));
    Triple before = from_to(0, 2), area = cross_product(from_to(0, 1), before);
    for (std::size_t i = 3; i < n; ++i) {
      const Triple now = from_to(0, i), part = cross_product(before, now);
      for (std::size_t k = 0; k < 3; ++k) area[k] += part[k];
      before = now;
    }
    return area;
  }

  std::vector<Triple> sums_;
  double scale_;
};

struct Surface_options;
struct Recognized_part;

// Which normals are written, as --output-normals and the old --surface-normals say it.
struct Output_normals
{
  enum class Choice { automatic, surface, control, both, none };

  Choice choice = Choice::automatic;
  Normal_kind kind = Normal_kind::control; // of those that are written as the mesh's normals
  bool copies = false;                     // those of the control mesh are written as they are
  double scale = 1;                        // a power of 2, about one over the size of the mesh

  bool any() const { return choice != Choice::none; }
  bool with_control() const { return choice == Choice::both; }
  bool goes_on() const { return choice == Choice::control || choice == Choice::both; }

  // Throws Usage_error if the options contradict each other.
  static Output_normals make(const Surface_options& options, const Mesh_file& output);

  // Are those of the faces to be computed?
  bool are_of_faces() const { return kind == Normal_kind::of_mesh && !copies; }

  // to the control mesh with its normals
  void suit(const Mesh_data& mesh);
};

// Control normals that are written beside others, because these have taken their place in the surface.
struct Kept_normals
{
  std::vector<Triple> of_vertices, of_corners;
  std::vector<double> roundness_of_corners;
};

// The control normals of the surface; those of corners only where vertices have several.
Kept_normals kept_normals(const Surface& surface, const Wedge_list& wedges = {});

// What is written of the surface, which has control normals or those of its limit, or none; `control` are those
// that the limit has replaced. The surface is without creases and perhaps normals afterwards.
Mesh_data output_mesh(Surface& surface, std::optional<Crease_maps>& creases,
                      const Wedge_list& of_wedges, const Output_normals& normals,
                      Kept_normals control);

// The same of a mesh that is neither refined nor moved.
void put_control_normals(Mesh_data& mesh, const Output_normals& normals);

// Throws Usage_error or Error if the file of --write-tags cannot be one, or is one of `others`.
void require_tags_place(const Surface_options& options, const std::vector<std::string>& others);

// Are the tags of the result written anywhere?
bool are_tags_written(const Surface_options& options, const Output_normals& normals);

// Leaves those tags in the mesh that its own file gets, and warns of what is not written.
void suit_tags(Mesh_data& mesh, const Mesh_file& output, const Surface_options& options,
               const Output_normals& normals, Report& report);

// A file beside OUTPUT, which appears by commit(), or none.
class Side_file
{
public:
  Side_file() = default;
  // write(Output_file&)
  template <class Function>
  Side_file(const std::string& name, const Function& write)
    : name_(name)
  {
    naming(name, [&] {
      file_ = std::make_unique<Output_file>(name);
      write(*file_);
    });
  }
  void commit()
  {
    if (file_ != nullptr) naming(name_, [&] { file_->commit(); });
  }

private:
  std::string name_;
  std::unique_ptr<Output_file> file_;
};

// The selection of --write-tags.
Side_file tags_file(const Surface_options& options, const Crease_tags& tags, Report& report);
// The file of --surface-labels: the segment of each control face, one a line.
Side_file labels_file(const Surface_options& options, const Recognized_part* part);

// The numbers of segments as a property of the faces of the result.

// Adds the property, which the children of the faces get, too. One of the user's with this name gives way.
void add_segments(Mesh_data& mesh, const Recognized_part& part, const std::string& name,
                  Report& report);
// The same of a part that was not asked for, under a name that no file has, and not to be written.
void add_hidden_segments(Mesh_data& mesh, const Recognized_part& part);
// That property; nullptr if there is none.
std::vector<double>* segments_of(Attributes& attributes);
// It stays where files have properties of faces, without a word elsewhere.
void suit_segments(Mesh_data& mesh, const Mesh_file& output);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OUTPUT_MESH_H
