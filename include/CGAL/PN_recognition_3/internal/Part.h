// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef CGAL_PN_RECOGNITION_3_INTERNAL_PART_H
#define CGAL_PN_RECOGNITION_3_INTERNAL_PART_H

#include <CGAL/PN_recognition_3/internal/recognition_interface.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>

// with what all sources of recognition need
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::PN_subdivision_3::internal::recognition {

constexpr Index null = Level_connectivity::null;

// Those that are alike stay in their order. One function sorts all kinds of numbers, as a sort takes long to compile.
void sort_numbers(std::vector<Index>& numbers, Function_ref<bool(Index, Index)> is_before);

// lists of numbers, one behind the other
class Lists
{
public:
  Lists() = default;
  // makes lists of pairs (list, number)
  Lists(Index lists, const std::vector<std::pair<Index, Index>>& pairs);

  struct Range
  {
    Range(const Index* from, const Index* to)
      : first(from)
      , last(to)
    {}
    Range(const std::vector<Index>& numbers)
      : Range(numbers.data(), numbers.data() + numbers.size())
    {}
    const Index* begin() const { return first; }
    const Index* end() const { return last; }
    std::size_t size() const { return std::size_t(last - first); }
    Index operator[](std::size_t i) const { return first[i]; }

    const Index *first, *last;
  };
  Range operator[](Index i) const
  {
    return {items_.data() + begin_[i], items_.data() + begin_[i + 1]};
  }
  Index size() const { return Index(begin_.size()) - 1; }

private:
  std::vector<Index> begin_{0};
  std::vector<Index> items_;
};

// A mesh, scaled to its box, with vertices in the order of their coordinates and faces in the order of their vertices, so
// that results do not depend on how the mesh was numbered.
struct Part
{
  struct Edge
  {
    Index v, w, f, g; // g is null on the border
  };

  std::vector<Vec3> points;
  Lists corners;      // of faces: vertices
  Lists faces_around; // of vertices
  std::vector<Edge> edges;
  std::vector<Vec3> normal; // of faces; zero: a sliver
  std::vector<Vec3> area;   // vectors
  std::vector<double> altitude;
  std::vector<bool> on_border;                     // vertices
  std::vector<Index> rank_of_vertex, rank_of_face; // of the mesh: the number here
  double size = 0, tolerance = 0;
  double scale = 1; // of the mesh: scale x + shift
  Vec3 shift;

  Index number_of_faces() const { return corners.size(); }
  bool is_sliver(Index f) const { return altitude[f] < 4 * tolerance; }
  // how far a face leaves the plane of another one
  double height(Index f, Index g) const;
  // of the two faces of an inner edge the lower one, if they are no slivers and turn by little
  bool is_nearly_flat(const Edge& e, double cosine, double greatest_height) const;
  // the face on the other side of an inner edge
  Index across(Index f, Index e) const { return edges[e].f == f ? edges[e].g : edges[e].f; }
  double length(const Edge& e) const { return norm(points[e.v] - points[e.w]); }
};

// a tolerance of 0 is chosen
Part make_part(const Level_connectivity& level, const Points& points, double tolerance);

// All edges that two patches share. It is smooth if the patches may be facets of one surface.
struct Joint
{
  Index p, q; // p < q
  std::vector<Index> edges;
  double angle = 0;
  double length = 0;
  Index v = 0, w = 0; // the two vertices that are furthest from each other
  bool is_smooth = false;

  Index other(Index patch) const { return patch == p ? q : p; }
};

// The facets of a part: faces of one plane are one facet, however they are triangulated. Slivers belong to none.
struct Patches
{
  struct Patch
  {
    std::vector<Index> faces, vertices, joints; // joints: numbers
    double area = 0, width = 0;
    Vec3 normal, mean; // mean of the vertices
    bool is_planar = true;
  };

  std::vector<Patch> patches;
  std::vector<Joint> joints;
  std::vector<Index> patch_of_face; // null of slivers

  Index size() const { return Index(patches.size()); }
  const Patch& operator[](Index p) const { return patches[p]; }
};

Patches make_patches(const Part& part, double greatest_smooth_angle);

// --- regions ---

// How the facets of a region lie about an angle: that about its axis, or about the tube of a torus.
struct Turn
{
  std::vector<double> positions; // distinct angles of vertices, from where the region begins on
  std::vector<double> spans;     // of the facets; on a sphere their widths
  bool is_full = false;
  double widest = 0, least = 0; // of the spans
  double start = 0, end = 0;

  // the first or last position: 0, 1; -1: neither
  int end_at(double angle) const;
};

// Facets of one shape, and what there is to tell about them.
struct Region
{
  Shape shape;
  std::vector<Index> patches; // sorted
  std::vector<Index> vertices;
  int side = 1; // of the faces' normals beside the shape's
  double residual = 0;
  double greatest_rho = 0;
  Turn turn, meridian;                   // meridian: of a torus
  double widest_angle = 0;               // of a sphere: between corners of a face
  double greatest_midpoint_distance = 0; // that a facet may have; by close_borders()
  std::size_t inner_vertices = 0;
  bool tangent_ends[2] = {false, false}; // of the turn
  bool has_tangent_end = false;          // any

  int number_of_tangent_ends() const { return int(tangent_ends[0]) + int(tangent_ends[1]); }
  // the widest step, n = 2 pi / step
  double step() const
  {
    return facts_of(shape.kind).turns_about_axis ? (std::max)(turn.widest, meridian.widest)
                                                 : widest_angle;
  }
};

// What many functions need to know about the part.
struct Context
{
  const Part& part;
  const Patches& patches;
  double greatest_smooth_angle;
  unsigned min_facets;
  // vertices, none but in vertices_of(), and patches, none but in measure()
  mutable std::vector<bool> is_listed, is_inside;

  double tolerance() const { return part.tolerance; }
  const Vec3& point(Index v) const { return part.points[v]; }
  Vec3 direction(const Joint& j) const { return part.points[j.w] - part.points[j.v]; }
  // whether all of some patches have a vertex
  bool have_vertex(const std::vector<Index>& some_patches, Index v) const;
  std::vector<Vec3> points_of(const std::vector<Index>& vertices) const;
  std::vector<Index> vertices_of(const std::vector<Index>& some_patches) const;
};

// whether a patch outside is tangent to a shape along a joint
bool is_tangent_along(const Context& c, const Joint& j, Index outside, const Shape& s, int side,
                      double greatest_angle = radians(0.5));
// fills in what follows from the shape and the patches
void measure(const Context& c, Region& r);

// --- fits ---

double greatest_distance(const Shape& s, const std::vector<Vec3>& points);
// Fits a shape that is near by the distances from it, in some steps; whether this has been any good. With a `hopeless` distance
// it gives up if the first step leaves more than this distance and more than a quarter.
bool fit_shape(Shape& s, const std::vector<Vec3>& points, std::size_t steps, double hopeless = 0);
// the sphere of the least sum of squares of |p - c|^2 - r^2
bool sphere_through(const std::vector<Vec3>& points, Shape& s);
// the circle of the least sum of such squares in a plane across an axis
bool circle_through(const std::vector<Vec3>& points, const Vec3& axis, Vec3& center,
                    double& radius);

// --- finding ---

// Collects the facets that are on a shape.
class Grower
{
public:
  explicit Grower(const Context& context)
    : c_(context)
    , cosine_(std::cos(context.greatest_smooth_angle / 2 + radians(1.1)))
    , stamp_(context.patches.size(), 0)
  {}

  // all vertices of a facet within t of the shape, the normal of the facet near the normals of the shape there
  bool is_on(const Shape& s, Index p, double t, int side) const;
  // tells on which side a facet is
  int side_of(const Shape& s, Index p) const;
  // Grows and fits by turns until nothing changes; whether there is a region. A generous tolerance may take too many
  // facets, so that the fit leaves the seeds: then it is tried with less tolerance.
  bool settle(Region& r, const std::vector<Index>& seeds, double t);

  // a facet that flats must not take
  void ban(Index p) { banned_.push_back(p); }
  void lift_bans() { banned_.clear(); }

private:
  std::vector<Index> grow(const Shape& s, const std::vector<Index>& seeds, double t, int side);
  bool settle_from(Region& r, const std::vector<Index>& seeds, double t, std::size_t& first_size);

  const Context& c_;
  double cosine_;
  std::vector<unsigned> stamp_;
  std::vector<Index> banned_;
  unsigned now_ = 0;
};

// whether a measured region has more vertices on its shape than any facets would have, so that it is no accident
bool is_evident(const Context& c, const Region& r);
// is_evident() of a region that it measures and takes flats out of
bool has_evidence(const Context& c, Grower& grower, Region& r);

// Tries guesses and keeps the regions that have evidence.
class Found_regions
{
public:
  using Seeds = std::vector<Index>;

  explicit Found_regions(const Context& context);

  std::vector<Region> take_regions() { return std::move(regions_); }
  bool has_region(Index p) const { return has_region_[p]; }
  // whether the facet is in a sphere or torus that is beyond doubt
  bool is_settled(Index p) const { return is_settled_[p]; }
  // whether the facets are together in a region of this kind already
  bool is_known(Kind kind, const Seeds& seeds) const;

  enum class Guess {
    exact,
    may_be_fitted,
    whole // may be fitted, and the facets may be all facets of the surface
  };
  void try_shape(Shape s, const Seeds& seeds, Guess guess = Guess::exact);

private:
  double least_width(const Seeds& seeds) const;
  bool are_on(const Shape& s, const Seeds& seeds, double t) const;
  bool goes_on(const Shape& s, const Seeds& seeds, double t) const;
  bool fit_to(const Seeds& seeds, Shape& s) const;
  void remember(Region&& r, bool holds);

  const Context& c_;
  Grower grower_;
  std::vector<Region> regions_;
  std::vector<std::vector<std::pair<Kind, Index>>> known_; // of a patch: what has been tried
  std::vector<bool> has_region_, is_settled_;
  Index number_ = 0;
};

// Cones by their apexes: the edges at it make one angle with the axis.
void guess_by_apexes(const Context& c, Found_regions& found);
// Cylinders by rulings: two facets meet in one.
void guess_by_rulings(const Context& c, Found_regions& found);
// Shapes of revolution by three facets in a row, with this one in the middle.
void guess_by_rows(const Context& c, Found_regions& found, Index middle);

// all regions of a part; they have no facets in common
std::vector<Region> find_regions(const Context& c);

// --- from regions to segments ---

// whether a patch is a facet of a region that a polyhedral Boolean has cut, which leaves vertices on chords
bool is_cut_facet(const Context& c, const Patches::Patch& patch, const Region& r);
// leaves the round regions; returns for patches of prisms the steps of the prisms, 0 for other patches
std::vector<double> take_prisms_out(const Context& c, std::vector<Region>& regions);
// lets regions take what growing has left undone at their borders; returns the region of each patch, null: none
std::vector<Index> close_borders(const Context& c, std::vector<Region>& regions,
                                 const std::vector<double>& prism_step);
// the largest distance of the midpoints of edges of some faces from a shape
double midpoint_distance(const Context& c, const Shape& s, Lists::Range faces);
// whether vertices and normal of some face or patch are as a facet's of the region would be
bool may_be_facet(const Context& c, const Region& r, Lists::Range vertices, const Vec3& normal,
                  double width, double t);

// What every face of the part belongs to.
struct Segments
{
  struct Segment
  {
    Shape shape;
    int side = 1;
    double widest_step = 0, widest_meridian_step = 0, residual = 0;
    std::vector<Index> faces;
  };
  std::vector<Segment> segments;
  std::vector<Index> segment_of_face;
};

Segments make_segments(const Context& c, const std::vector<Region>& regions,
                       const std::vector<Index>& owners, const std::vector<double>& prism_step);

} // namespace CGAL::PN_subdivision_3::internal::recognition

#endif // CGAL_PN_RECOGNITION_3_INTERNAL_PART_H
