// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Recognized_part.h"

#include "surface/output_mesh.h"

#include <CGAL/PN_recognition_3/internal/recognition.h>

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace pn_subdivide {

namespace {

namespace PN_recognition = PN::internal::recognition;

using Kind = Recognized_surface::Kind;

// What reports say of a kind. The compiler tells of a kind that is not here.
struct Kind_words
{
  const char* many = "";
  bool has_direction = false, has_radius = false;
};

Kind_words words_of(Kind kind)
{
  switch (kind) {
  case Kind::plane:
    return {"planes", true, false};
  case Kind::cylinder:
    return {"cylinders", true, true};
  case Kind::cone:
    return {"cones", true, false};
  case Kind::sphere:
    return {"spheres", false, true};
  case Kind::torus:
    return {"tori", true, true};
  case Kind::unknown:
    break;
  }
  return {"unknown segments"};
}

constexpr auto name_of = [](Kind k) { return Recognized_surface::kind_names[std::size_t(k)]; };

PN_recognition::Vec3 as_vec3(const Vector_3& v)
{
  return {v.x(), v.y(), v.z()};
}

PN_recognition::Vec3 as_vec3(const Point_3& p)
{
  return as_vec3(p - CGAL::ORIGIN);
}

Deviation largest(const Deviation& a, const Deviation& b)
{
  return {(std::max)(a.of_vertices, b.of_vertices), (std::max)(a.of_faces, b.of_faces)};
}

Deviation of_face(const Surface& surface, Face f, const PN_recognition::Shape& shape)
{
  const auto distance = [&](const Point_3& p) { return std::abs(shape.distance(as_vec3(p))); };
  Deviation result{0, distance(place_of(surface, f).middle)};
  const Halfedge first = surface.halfedge(f);
  Halfedge h = first;
  do {
    const Point_3 &p = surface.point(surface.source(h)), &q = surface.point(surface.target(h));
    result = largest(result, {distance(q), distance(CGAL::midpoint(p, q))});
    h = surface.next(h);
  } while (h != first);
  return result;
}

// One a segment; zero for unknown ones. Segments are those of the faces.
std::vector<Deviation> deviations(const Surface& surface, const std::vector<double>& segments,
                                  const std::vector<Recognized_surface>& surfaces)
{
  std::vector<Deviation> result(surfaces.size());
  std::vector<PN_recognition::Shape> shapes;
  for (const Recognized_surface& s : surfaces) shapes.push_back(PN_recognition::as_shape(s, 1, {}));
  for (const Face f : surface.faces()) {
    const auto segment = static_cast<std::size_t>(segments[f]);
    if (surfaces[segment].kind != Kind::unknown)
      result[segment] = largest(result[segment], of_face(surface, f, shapes[segment]));
  }
  return result;
}

std::string columns(const std::array<std::string, 6>& words)
{
  const auto word = [&](std::size_t i) { return words[i].c_str(); };
  return formatted(" %-11s %9s %7s %9s %9s %9s", word(0), word(1), word(2), word(3), word(4),
                   word(5));
}

std::string radius_of(const Recognized_surface& s)
{
  if (s.kind == Kind::torus) return three_digits(s.radius) + "/" + three_digits(s.tube_radius);
  return words_of(s.kind).has_radius ? three_digits(s.radius)
                                     : three_digits(s.half_angle * 180 / CGAL_PI) + " deg";
}

// Prisms that are not round: how many of their sides, and with which --min-facets they were.
std::string left_prisms(const std::vector<Recognized_surface>& surfaces)
{
  std::map<long, std::size_t> sides;
  for (const Recognized_surface& s : surfaces)
    if (s.kind == Kind::plane && s.widest_step > 0)
      ++sides[std::lround(2 * CGAL_PI / s.widest_step)];
  std::string text;
  for (const auto& [n, planes] : sides)
    text += (text.empty() ? "" : ", ") + std::to_string(planes) + " of " + std::to_string(n);
  return text.empty() ? "" : "planes left as sides of prisms: " + text + " a turn";
}

} // namespace

Surface_table::Surface_table(const Recognized_part& part, const Surface& control)
  : part_(part)
  , before_(deviations(control, {part.segments.begin(), part.segments.end()}, part.surfaces))
  , after_(before_)
  , along_(part.surfaces.size(), 0.)
{
  for (const Face f : control.faces()) {
    const Face_place place = place_of(control, f);
    along_[part.segments[f]] += along(place, part.segments[f]);
  }
  for (const Face f : control.faces())
    was_folded_.push_back(is_folded(place_of(control, f), part.segments[f]));
}

// Of twice the area of a face what is along the normal of its surface.
double Surface_table::along(const Face_place& place, std::size_t segment) const
{
  if (part_.surfaces[segment].kind == Kind::unknown) return 0;
  return dot(
    as_vec3(place.twice_area),
    PN_recognition::as_shape(part_.surfaces[segment], 1, {}).normal(as_vec3(place.middle)));
}

// against most of its surface, by more than rounding: that of the control mesh, whose cut vertices have moved
bool Surface_table::is_folded(const Face_place& place, std::size_t segment) const
{
  const double side = along_[segment] < 0 ? -1 : 1;
  const double rounding = 1e-9 * place.size + 8 * before_[segment].of_vertices;
  return side * along(place, segment) < -rounding * place.size;
}

void Surface_table::number_faces(Attributes& attributes) const
{
  std::vector<double>& numbers = *segments_of(attributes);
  std::iota(numbers.begin(), numbers.end(), 0.);
}

void Surface_table::measure(const Surface& refined, Attributes& attributes)
{
  std::vector<double>& numbers = *segments_of(attributes);
  std::set<std::size_t> folded;
  for (const Face f : refined.faces()) {
    const auto parent = std::size_t(numbers[f]);
    const std::size_t segment = part_.segments[parent];
    if (!was_folded_[parent] && is_folded(place_of(refined, f), segment)) folded.insert(parent);
    numbers[f] = double(segment);
  }
  folded_faces_.assign(folded.begin(), folded.end());
  after_ = deviations(refined, numbers, part_.surfaces);
}

std::string Surface_table::text() const
{
  std::string text = "surfaces:";
  const char* before = " ";
  constexpr std::size_t kinds = Recognized_surface::kind_names.size();
  for (std::size_t k = 1; k <= kinds; ++k) {
    const auto kind = Kind(k % kinds); // what is unknown is last
    std::size_t segments = 0, faces = 0;
    for (const Recognized_surface& s : part_.surfaces)
      if (s.kind == kind) {
        ++segments;
        faces += s.number_of_faces;
      }
    if (segments == 0) continue;
    const std::string one = std::string(name_of(kind)) + (kind == Kind::unknown ? " segment" : "");
    text +=
      before + plural(segments, one, words_of(kind).many) + " of " + plural(faces, "face", "faces");
    before = ", ";
  }
  const auto creases = std::size_t(std::count(part_.creases.begin(), part_.creases.end(), true));
  text += "; " + plural(creases, "crease edge", "crease edges");
  if (part_.tangent_creases > 0)
    text += ", " + std::to_string(part_.tangent_creases) + " where surfaces are tangent";
  const std::string prisms = left_prisms(part_.surfaces);
  if (!prisms.empty()) text += "; " + prisms;

  constexpr std::size_t most = 30;
  std::size_t rounds = 0;
  for (std::size_t i = 0; i < part_.surfaces.size(); ++i) {
    const Recognized_surface& s = part_.surfaces[i];
    if (!is_round(s.kind) || rounds++ >= most) continue;
    if (rounds == 1)
      text += "\n" + columns({"surface", "radius", "faces", "residual", "before", "after"});
    text += "\n" + columns({name_of(s.kind), radius_of(s), std::to_string(s.number_of_faces),
                            three_digits(s.residual), three_digits(before_[i].of_faces),
                            three_digits(after_[i].of_faces)});
  }
  if (rounds > most)
    text += "\n  and " + std::to_string(rounds - most) + " more, which --report has";
  return text;
}

std::vector<Report::Row> Surface_table::rows() const
{
  std::vector<Report::Row> rows;
  for (std::size_t i = 0; i < part_.surfaces.size(); ++i) {
    const Recognized_surface& s = part_.surfaces[i];
    const Kind_words words = words_of(s.kind);
    Report::Row row{{"kind", std::string(name_of(s.kind))}, {"faces", s.number_of_faces}};
    const auto add = [&row](const std::string& name, const auto& x) { row.emplace_back(name, x); };
    const auto triple = [](const Triple& t) { return std::vector<double>(t.begin(), t.end()); };
    if (s.kind != Kind::unknown) add("point", triple(s.point));
    if (words.has_direction) add("direction", triple(s.direction));
    if (words.has_radius) add("radius", s.radius);
    if (s.kind == Kind::torus) add("tube_radius", s.tube_radius);
    if (s.kind == Kind::cone) add("half_angle", s.half_angle);
    if (s.widest_step > 0) add("widest_step", s.widest_step);
    if (s.kind == Kind::torus) add("widest_meridian_step", s.widest_meridian_step);
    if (s.kind != Kind::unknown) {
      add("residual", s.residual);
      add("deviation_before", before_[i].of_faces);
      add("deviation_after", after_[i].of_faces);
      add("deviation_of_vertices", after_[i].of_vertices);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

void Surface_table::warn(const std::string& input, Report& report) const
{
  if (!part_.segments.empty() && !part_.knows_any())
    report.warn(input + ": no surface is recognized, its faces are those of no CAD part");
  else if (part_.unknown_area > part_.area / 2)
    report.warn(input + ": " + std::to_string(std::lround(100 * part_.unknown_area / part_.area)) +
                " % of the area is on no recognized surface: this is no tessellation of a CAD part "
                "(decimated, remeshed or free-form)");
  if (part_.other_segments > 0)
    report.warn(input + ": with --surface-tolerance " + three_digits(part_.other_tolerance) +
                " there are " + std::to_string(part_.other_segments) +
                " segments in the place of " + std::to_string(part_.surfaces.size()) +
                ": its coordinates have all digits, as those of a file of fewer that has been "
                "moved or scaled");
  if (crossed_planes_ > 0)
    report.warn(
      input + ": " + plural(crossed_planes_, "plane", "planes") +
      (crossed_planes_ == 1 ? " intersects itself: its" : " intersect themselves: their") +
      " rims cross or touch each other, as they do not in the control mesh");
  report.set_high_faces(folded_faces_);
  if (folded_faces_.empty()) return;
  constexpr std::size_t most = 10;
  std::string faces;
  for (std::size_t i = 0; i < folded_faces_.size() && i < most; ++i)
    faces += (i == 0 ? " " : ", ") + std::to_string(folded_faces_[i]);
  if (folded_faces_.size() > most) faces += ", ...";
  report.warn(input + ": the result is folded over on " +
              plural(folded_faces_.size(), "face", "faces") + " of recognized surfaces:" + faces);
}

void Surface_table::report_chord(double chord, const std::string& output, Report& report) const
{
  constexpr double much = 1.25; // what is put onto the surfaces gains or loses a little
  if (!part_.knows_any()) return;
  const auto beyond_residual = [&](std::size_t i) {
    return after_[i].of_faces - part_.surfaces[i].residual;
  };
  std::size_t worst = 0;
  for (std::size_t i = 1; i < after_.size(); ++i)
    if (beyond_residual(i) > beyond_residual(worst)) worst = i;
  const std::string distance = three_digits(after_[worst].of_faces);
  std::size_t unknown = 0;
  for (const Recognized_surface& s : part_.surfaces)
    if (s.kind == Kind::unknown) unknown += s.number_of_faces;
  report.note("chord: largest distance from the recognized surfaces " + distance +
              (unknown == 0 ? "" : "; " + plural(unknown, "face", "faces") + " of none"));
  if (beyond_residual(worst) > much * chord)
    report.warn(output + ": up to " + distance + " from a recognized " +
                name_of(part_.surfaces[worst].kind) + ", more than --chord " + three_digits(chord));
}

} // namespace pn_subdivide
