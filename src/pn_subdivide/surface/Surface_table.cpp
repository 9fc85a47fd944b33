// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "surface/Surface_table.h"

#include "surface/Surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace pn_subdivide {
namespace {

using Kind = Recognized_surface::Kind;

constexpr std::array<Kind, 6> kinds{Kind::plane,  Kind::cylinder, Kind::cone,
                                    Kind::sphere, Kind::torus,    Kind::unknown};

const char* name_of(Kind kind)
{
  switch (kind) {
  case Kind::plane:
    return "plane";
  case Kind::cylinder:
    return "cylinder";
  case Kind::cone:
    return "cone";
  case Kind::sphere:
    return "sphere";
  case Kind::torus:
    return "torus";
  case Kind::unknown:
    break;
  }
  return "unknown";
}

std::string number_of(std::size_t n, const std::string& one, const std::string& many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string number_of(std::size_t n, Kind kind)
{
  if (kind == Kind::unknown) return number_of(n, "unknown segment", "unknown segments");
  const std::string name = name_of(kind);
  return number_of(n, name, kind == Kind::torus ? "tori" : name + "s");
}

std::string digits(double x)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

double distance(const Recognized_surface& s, const Point_3& p)
{
  const Vector_3 d = p - to_point(s.point), axis = to_vector(s.direction);
  const double along = d * axis;
  const Vector_3 off = d - along * axis;
  const double rho = std::sqrt(off.squared_length());
  switch (s.kind) {
  case Kind::plane:
    return std::abs(along);
  case Kind::cylinder:
    return std::abs(rho - s.radius);
  case Kind::cone:
    return std::abs(rho * std::cos(s.half_angle) - std::abs(along) * std::sin(s.half_angle));
  case Kind::sphere:
    return std::abs(std::sqrt(d.squared_length()) - s.radius);
  case Kind::torus:
    return std::abs(std::hypot(rho - s.radius, along) - s.tube_radius);
  case Kind::unknown:
    break;
  }
  return 0;
}

Deviation largest(const Deviation& a, const Deviation& b)
{
  return {(std::max)(a.of_vertices, b.of_vertices), (std::max)(a.of_faces, b.of_faces)};
}

Deviation of_face(const Surface& surface, Surface::Face_index f, const Recognized_surface& s)
{
  Deviation result;
  Vector_3 sum(0, 0, 0);
  std::size_t n = 0;
  const Surface::Halfedge_index first = surface.halfedge(f);
  Surface::Halfedge_index h = first;
  do {
    const Point_3 &p = surface.point(surface.source(h)), &q = surface.point(surface.target(h));
    const double of_middle = distance(s, CGAL::midpoint(p, q));
    result = largest(result, {distance(s, q), of_middle});
    sum += q - CGAL::ORIGIN;
    ++n;
    h = surface.next(h);
  } while (h != first);
  result.of_faces =
    (std::max)(result.of_faces, distance(s, CGAL::ORIGIN + sum / static_cast<double>(n)));
  return result;
}

std::vector<double> as_numbers(const std::vector<std::size_t>& segments)
{
  return std::vector<double>(segments.begin(), segments.end());
}

std::string columns(const std::array<std::string, 6>& words)
{
  constexpr std::array<int, 6> width{12, 10, 8, 10, 10, 10};
  std::string line = " ";
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto gap = (std::max)(1, width[i] - int(words[i].size()));
    if (i == 0)
      line += words[i] + std::string(std::size_t(gap), ' ');
    else
      line += std::string(std::size_t(gap), ' ') + words[i];
  }
  return line;
}

std::string radius_of(const Recognized_surface& s)
{
  if (s.kind == Kind::torus) return digits(s.radius) + "/" + digits(s.tube_radius);
  if (s.kind == Kind::cone) return digits(s.half_angle * 180 / CGAL_PI) + " deg";
  return digits(s.radius);
}

bool is_round(const Recognized_surface& s)
{
  return s.kind != Kind::plane && s.kind != Kind::unknown;
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

std::vector<Deviation> deviations(const Surface& surface, const std::vector<double>& segments,
                                  const std::vector<Recognized_surface>& surfaces)
{
  std::vector<Deviation> result(surfaces.size());
  for (const Surface::Face_index f : surface.faces()) {
    const auto segment = static_cast<std::size_t>(segments[f]);
    if (surfaces[segment].kind != Kind::unknown)
      result[segment] = largest(result[segment], of_face(surface, f, surfaces[segment]));
  }
  return result;
}

Surface_table::Surface_table(const Recognized_part& part, const Mesh_data& control)
  : part_(part)
  , before_(deviations(make_surface(control), as_numbers(part.segments), part.surfaces))
  , after_(before_)
{}

void Surface_table::measure(const Surface& refined, const std::vector<double>& segments)
{
  after_ = deviations(refined, segments, part_.surfaces);
}

double Surface_table::largest_deviation() const
{
  Deviation all;
  for (const Deviation& d : after_) all = largest(all, d);
  return (std::max)(all.of_vertices, all.of_faces);
}

std::string Surface_table::text() const
{
  std::string text = "surfaces:";
  const char* before = " ";
  for (const Kind kind : kinds) {
    std::size_t segments = 0, faces = 0;
    for (const Recognized_surface& s : part_.surfaces)
      if (s.kind == kind) {
        ++segments;
        faces += s.number_of_faces;
      }
    if (segments == 0) continue;
    text += before + number_of(segments, kind) + " of " + number_of(faces, "face", "faces");
    before = ", ";
  }
  const auto creases = std::size_t(std::count(part_.creases.begin(), part_.creases.end(), true));
  text += "; " + number_of(creases, "crease edge", "crease edges");
  if (part_.tangent_creases > 0)
    text += ", " + std::to_string(part_.tangent_creases) + " where surfaces are tangent";
  if (part_.given_up > 0)
    text += "; " + number_of(part_.given_up, "segment", "segments") + " given up";
  if (part_.set_back > 0)
    text += "; " + number_of(part_.set_back, "wedge", "wedges") + " set back to linear";

  const std::string prisms = left_prisms(part_.surfaces);
  if (!prisms.empty()) text += "; " + prisms;

  constexpr std::size_t most = 30;
  std::size_t rounds = 0;
  for (std::size_t i = 0; i < part_.surfaces.size(); ++i) {
    const Recognized_surface& s = part_.surfaces[i];
    if (!is_round(s) || rounds++ >= most) continue;
    if (rounds == 1)
      text += "\n" + columns({"surface", "radius", "faces", "residual", "before", "after"});
    text +=
      "\n" + columns({name_of(s.kind), radius_of(s), std::to_string(s.number_of_faces),
                      digits(s.residual), digits(before_[i].of_faces), digits(after_[i].of_faces)});
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
    Report::Row row{{"kind", std::string(name_of(s.kind))}, {"faces", s.number_of_faces}};
    const auto add = [&row](const std::string& name, const auto& x) { row.emplace_back(name, x); };
    const auto triple = [](const Triple& t) { return std::vector<double>(t.begin(), t.end()); };
    if (s.kind != Kind::unknown) add("point", triple(s.point));
    if (s.kind != Kind::unknown && s.kind != Kind::sphere) add("direction", triple(s.direction));
    if (is_round(s) && s.kind != Kind::cone) add("radius", s.radius);
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
    report.warn(input + ": with --surface-tolerance " + digits(part_.other_tolerance) +
                " there are " + std::to_string(part_.other_segments) +
                " segments in the place of " + std::to_string(part_.surfaces.size()) +
                ": its coordinates have all digits, as those of a file of fewer that has been "
                "moved or scaled");
  if (part_.excess_of_volume > 0.001)
    report.warn(input + ": its volume changes by " + digits(100 * part_.excess_of_volume) +
                " % more than with --linear");
  report.set_high_faces(part_.high_faces);
  if (part_.high_faces.empty()) return;
  constexpr std::size_t most = 10;
  std::string faces;
  for (std::size_t i = 0; i < part_.high_faces.size() && i < most; ++i)
    faces += (i == 0 ? " " : ", ") + std::to_string(part_.high_faces[i]);
  if (part_.high_faces.size() > most) faces += ", ...";
  report.warn(input + ": " + number_of(part_.high_faces.size(), "face", "faces") +
              " may be rounder than with --linear:" + faces);
}

} // namespace pn_subdivide
