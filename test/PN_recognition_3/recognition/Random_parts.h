// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
#ifndef PN_TEST_RANDOM_PARTS_H
#define PN_TEST_RANDOM_PARTS_H

// Random parts with known truth. What the specification calls ambiguous is not among them: full rounds have eight facets or more
// at their widest step (fewer sides are prisms, whose sides meet at more than 31 degrees), quarters two or more with tangent ends, spheres and
// bends three or more a quarter, chords of D-shaped holes 2.3 steps or more, and all rounds of a part are of about one step.

#include "Named_parts.h"

namespace synthetic_parts {

class Random_part
{
public:
  // Seeds give families in turn.
  explicit Random_part(std::uint32_t seed)
    : random_(seed * 7919u + 17u)
  {
    struct Family
    {
      const char* name;
      void (Random_part::*make)();
      bool may_have_eight_facets; // where three of a quarter are not two thirds of its step
    };
    static constexpr Family families[] = {{"prism", &Random_part::make_prism, true},
                                          {"plate", &Random_part::make_plate, false},
                                          {"shaft", &Random_part::make_shaft, false},
                                          {"bolt", &Random_part::make_bolt, false},
                                          {"nut", &Random_part::make_nut, true},
                                          {"elbow", &Random_part::make_elbow, true},
                                          {"rounded box", &Random_part::make_rounded_box, false},
                                          {"flats", &Random_part::make_flats, false},
                                          {"few sides", &Random_part::make_few_sides, false},
                                          {"cut box", &Random_part::make_cut_box, false}};
    const Family& family = families[seed % std::size(families)];
    static const int turns[] = {8, 9, 10, 12, 12, 16, 16, 20, 24, 24, 30, 32, 36, 48, 64, 72};
    n_ = turns[random_.integer(0, 15)];
    if (n_ == 8 && !family.may_have_eight_facets) n_ = 9;
    unevenness_ = n_ >= 16 && random_.chance(0.3) ? 0.15 : 0;
    are_triangles_ = random_.chance(0.8);
    (this->*family.make)();
    part_.name = std::string(family.name) + ", seed " + std::to_string(seed);
    put_into_a_file();
    check_closed(part_);
    check_truth(part_);
  }

  const Part& part() const { return part_; }
  bool is_small_prism() const { return is_small_prism_; } // prisms and pyramids of 3 to 7 sides

private:
  using Fractions = std::vector<double>;

  void put_into_a_file()
  {
    const File file = static_cast<File>(random_.integer(0, 2));
    const double shift = file == File::six_digits ? 0.5 : random_.chance(0.2) ? 15 : 2;
    if (!random_.chance(0.15)) place(part_, random_pose(random_, shift, 6));
    write_as(part_, file);
    renumber(part_, random_);
  }

  // --- steps ---
  Fractions full() { return steps(n_, unevenness_, random_); }
  Fractions part_of_turn(double degrees, int least = 2)
  {
    const int n = static_cast<int>(std::lround(n_ * degrees / 360));
    return steps((std::max)(n, least), unevenness_, random_);
  }
  Fractions line() // sometimes several faces in a row
  {
    return random_.chance(0.75) ? Fractions{0, 1} : steps(random_.integer(2, 3), 0.3, random_);
  }

  // --- prisms, pyramids, frusta ---
  Chain side_of_prism(int n)
  {
    if (n >= 8) return circle(0, 0, 1, steps(n), false, random_(0, 1));
    if (random_.chance(0.5)) return regular_polygon(n, 0, 0, 1, false, random_(0, 1));
    for (;;) {
      std::vector<std::array<double, 2>> p;
      const double stretch = random_(1, 1.4);
      for (double t : steps(n, 0.25, random_))
        p.push_back({stretch * std::cos(2 * pi * t), std::sin(2 * pi * t)});
      p.pop_back();
      Chain c = polygon(p);
      double least = pi;
      for (std::size_t i = 0; i < c.pieces.size(); ++i) {
        const auto &a = c.pieces[i].normal, &b = c.pieces[(i + 1) % c.pieces.size()].normal;
        least = (std::min)(least, std::acos(a[0] * b[0] + a[1] * b[1]));
      }
      if (least > 31.5 * pi / 180) return c;
    }
  }

  void make_prism()
  {
    const int n = random_.integer(3, 12);
    is_small_prism_ = n < 8;
    const Chain outline = side_of_prism(n);
    Part_builder b("", random_, are_triangles_);
    double inner = 1e9;
    for (const auto& piece : outline.pieces)
      inner = (std::min)(inner, piece.is_arc ? piece.signed_radius
                                             : piece.point[0] * piece.normal[0] +
                                                 piece.point[1] * piece.normal[1]);
    const int form = random_.integer(0, 2); // prism, frustum, pyramid
    const bool is_regular =
      n >= 8 || std::abs(length({outline.points[0][0], outline.points[0][1], 0}) - 1) < 1e-9;
    const double d = form == 0                                                ? 0
                     : form == 1 || !all_alike(outline, inner) || !is_regular ? random_(0.2, 0.6)
                                                                              : 1;
    const auto side = b.sweep(outline, Chain(0, 0).line_to(-d * inner, random_(0.7, 2.5), line()));
    b.cap({side.start});
    if (d < 1) b.cap({side.end});
    part_ = b.take();
  }
  static bool all_alike(const Chain& outline, double inner)
  {
    for (const auto& p : outline.pieces)
      if (!p.is_arc &&
          std::abs(p.point[0] * p.normal[0] + p.point[1] * p.normal[1] - inner) > 1e-12)
        return false;
    return true;
  }

  // --- plates: corners sharp, cut or round, an edge cut or round, holes ---
  static Chain cut_rectangle(double x, double y, double c)
  {
    return polygon({{c, 0},
                    {x - c, 0},
                    {x, 1.3 * c},
                    {x, y - c},
                    {x - 1.3 * c, y},
                    {0.8 * c, y},
                    {0, y - c},
                    {0, c}});
  }
  Chain side_of_plate(double x, double y, double r, int least)
  {
    const int form = random_.integer(0, 3);
    if (form == 0) return polygon({{0, 0}, {x, 0}, {x, y}, {0, y}});
    if (form == 1) return cut_rectangle(x, y, r);
    return rounded_rectangle(0, 0, x, y, r, part_of_turn(90, least));
  }
  Chain profile_of_plate(double h, double r)
  {
    const int form = random_.integer(0, 3);
    Chain c(0, 0);
    if (form < 2) return c.line_to(0, h, line());
    c.line_to(0, h - r);
    return form == 2 ? c.line_to(-r * random_(0.6, 1), h)
                     : c.arc(-r, h - r, 90, part_of_turn(90, 3));
  }
  Chain slot(double x, double y, double l, double r)
  {
    return Chain(x + l, y - r)
      .line_to(x - l, y - r)
      .arc(x - l, y, -180, part_of_turn(180, 3))
      .line_to(x + l, y + r)
      .arc(x + l, y, -180, part_of_turn(180, 3))
      .close();
  }
  Chain d_shape(double x, double y, double r, bool is_hole)
  {
    const double step = 360. / n_ * (1 + 2 * unevenness_);
    const double chord = (std::max)(2.3 * step, random_(70, 130)), t = random_(0, 6);
    return Chain(x + r * std::cos(t), y + r * std::sin(t))
      .arc(x, y, is_hole ? chord - 360 : 360 - chord, part_of_turn(360 - chord, 4))
      .line_to(x + r * std::cos(t), y + r * std::sin(t))
      .close();
  }
  void add_hole(Part_builder& b, double x, double y, double h, std::vector<Rim>& bottom,
                std::vector<Rim>& top)
  {
    const int form = random_.integer(0, 6);
    const double r = random_(0.12, 0.25);
    const Chain straight = Chain(0, 0).line_to(0, h, line());
    Part_builder::Side s;
    if (form == 1)
      s = b.sweep(slot(x, y, random_(0.1, 0.15), r), straight);
    else if (form == 2)
      s = b.sweep(d_shape(x, y, r, true), straight);
    else if (form == 3)
      s = b.sweep(regular_polygon(random_.integer(3, 6), x, y, r, true, random_(0, 1)), straight);
    else if (form == 4) // countersunk
      s = b.sweep(circle(x, y, r, full(), true),
                  Chain(0, 0).line_to(0, 0.6 * h).line_to(-0.4 * r, h));
    else if (form == 5) // stepped
      s = b.sweep(circle(x, y, r, full(), true),
                  Chain(0, 0).line_to(0, 0.5 * h).line_to(-0.4 * r, 0.5 * h).line_to(-0.4 * r, h));
    else if (form == 6) // drilled, with the drill's point
      s = b.sweep(circle(x, y, r, full(), true),
                  Chain(r, 0.2 * h).line_to(0, 0.2 * h + 0.3 * h).line_to(0, h));
    else
      s = b.sweep(circle(x, y, r, full(), true, random_(0, 1)), straight);
    if (form != 6) bottom.push_back(s.start);
    top.push_back(s.end);
  }
  void make_plate()
  {
    const int nx = random_.integer(1, 3), ny = random_.integer(1, 2);
    const double h = random_(0.4, 0.8), r = random_(0.15, 0.3);
    Part_builder b("", random_, are_triangles_);
    const Chain profile = profile_of_plate(h, 0.5 * r);
    // corners of tori and cones have three facets or more
    const int least = profile.pieces.size() > 1 ? 3 : 2;
    const auto side = b.sweep(side_of_plate(nx + 0.4, ny + 0.4, r, least), profile);
    std::vector<Rim> bottom{side.start}, top{side.end};
    for (int i = 0; i < nx; ++i)
      for (int j = 0; j < ny; ++j)
        if (random_.chance(0.75)) add_hole(b, i + 0.7, j + 0.7, h, bottom, top);
    b.cap(bottom);
    b.cap(top);
    part_ = b.take();
  }

  // --- shafts ---
  void begin_shaft(Chain& c, double r) // from below to (r, 0.3)
  {
    const int form = random_.integer(0, 4);
    if (form == 0)
      c = Chain(r, 0);
    else if (form == 1)
      c = Chain(r - 0.08, 0).line_to(r, random_(0.05, 0.12));
    else if (form == 2)
      c = Chain(r - 0.1, 0).arc(r - 0.1, 0.1, 90, part_of_turn(90, 3));
    else if (form == 3)
      c = Chain(0, 0.3 - r).arc(0, 0.3, 90, part_of_turn(90, 3));
    else
      c = Chain(0, -random_(0.3, 0.8)).line_to(r, 0.25);
  }
  void go_up(Chain& c, double z) // not where it is already
  {
    if (c.points.back()[1] < z - 1e-9) c.line_to(c.points.back()[0], z, line());
  }
  void step_down(Chain& c, double r, double z)
  {
    const double old = c.points.back()[0], f = 0.35 * (old - r);
    const int convex = random_.integer(0, 2);
    go_up(c, convex == 0 ? z : z - f);
    if (convex == 1) c.line_to(old - f, z);
    if (convex == 2) c.arc(old - f, z - f, 90, part_of_turn(90, 3));
    if (random_.chance(0.5))
      c.line_to(r, z);
    else
      c.line_to(r + f, z).arc(r + f, z + f, -90, part_of_turn(90, 3));
  }
  void step_up(Chain& c, double r, double z)
  {
    const double old = c.points.back()[0], f = 0.35 * (r - old);
    if (random_.chance(0.5))
      go_up(c, z);
    else {
      go_up(c, z - f);
      c.arc(old + f, z - f, -90, part_of_turn(90, 3));
    }
    const int convex = random_.integer(0, 2);
    if (convex == 0)
      c.line_to(r, z);
    else
      c.line_to(r - f, z);
    if (convex == 1) c.line_to(r, z + f);
    if (convex == 2) c.arc(r - f, z + f, 90, part_of_turn(90, 3));
  }
  void end_shaft(Chain& c, double z)
  {
    const double r = c.points.back()[0];
    go_up(c, z);
    const int form = random_.integer(0, 4);
    if (form == 1)
      c.line_to(r - 0.08, z + random_(0.05, 0.12));
    else if (form == 2)
      c.arc(r - 0.1, z, 90, part_of_turn(90, 3));
    else if (form == 3)
      c.arc(0, z, 90, part_of_turn(90, 3));
    else if (form == 4)
      c.line_to(0, z + random_(0.3, 0.8));
  }
  void make_shaft()
  {
    double r = random_(0.3, 1), z = 0.3;
    Chain c;
    begin_shaft(c, r);
    const bool has_bottom = c.points[0][0] > 0;
    for (int k = random_.integer(0, 3); k > 0; --k) {
      z += random_(0.5, 1.2);
      const bool is_down = r > 0.55 && (r > 1.2 || random_.chance(0.5));
      r = is_down ? r * random_(0.55, 0.8) : r * random_(1.25, 1.6);
      if (is_down)
        step_down(c, r, z);
      else
        step_up(c, r, z);
    }
    end_shaft(c, z + random_(0.5, 1.2));
    const bool has_top = c.points.back()[0] > 1e-9;
    Part_builder b("", random_, are_triangles_);
    const auto side = b.sweep(circle(0, 0, 0, full()), c);
    std::vector<Rim> bottom{side.start}, top{side.end};
    if (has_bottom && has_top && random_.chance(0.4)) {
      const auto bore = b.sweep(circle(0, 0, 0.12, full(), true),
                                Chain(0, c.points[0][1]).line_to(0, c.points.back()[1], line()));
      bottom.push_back(bore.start);
      top.push_back(bore.end);
    }
    if (has_bottom) b.cap(bottom);
    if (has_top) b.cap(top);
    part_ = b.take();
  }

  // --- bolts, nuts ---
  void make_bolt()
  {
    Part_builder b("", random_, are_triangles_);
    const double h = random_(0.4, 0.8), r = random_(0.3, 0.45), l = random_(1, 3);
    const auto head = b.sweep(regular_polygon(random_.integer(4, 7), 0, 0, 1, false, random_(0, 1)),
                              Chain(0, 0).line_to(0, h, line()));
    std::vector<Rim> bottom{head.start};
    if (random_.chance(0.4)) {
      const auto socket =
        b.sweep(regular_polygon(6, 0, 0, random_(0.2, 0.5), true), Chain(0, 0).line_to(0, 0.6 * h));
      bottom.push_back(socket.start);
      b.cap({socket.end});
    }
    Chain c(r, h);
    if (random_.chance(0.4)) c = Chain(r + 0.1, h).arc(r + 0.1, h + 0.1, -90, part_of_turn(90, 3));
    end_shaft(c, h + l);
    const bool has_top = c.points.back()[0] > 1e-9;
    const auto shank = b.sweep(circle(0, 0, 0, full()), c);
    b.cap(bottom);
    b.cap({head.end, shank.start});
    if (has_top) b.cap({shank.end});
    part_ = b.take();
  }
  void make_nut()
  {
    Part_builder b("", random_, are_triangles_);
    const double h = random_(0.5, 1), r = random_(0.3, 0.5), c = random_(0.05, 0.12);
    const auto side = b.sweep(regular_polygon(random_.integer(4, 7), 0, 0, 1, false, random_(0, 1)),
                              Chain(0, 0).line_to(0, h, line()));
    const bool is_cut[] = {random_.chance(0.6), random_.chance(0.6)};
    Chain p = is_cut[0] ? Chain(-c, 0).line_to(0, c) : Chain(0, 0);
    if (is_cut[1])
      p.line_to(0, h - c, line()).line_to(-c, h);
    else
      p.line_to(0, h, line());
    const auto hole = b.sweep(circle(0, 0, r, full(), true, random_(0, 1)), p);
    b.cap({side.start, hole.start});
    b.cap({side.end, hole.end});
    part_ = b.take();
  }

  // --- the rest ---
  void make_elbow()
  {
    const double angle = random_(30, 120);
    part_ = elbow(full(), part_of_turn(angle, 4), angle,
                  random_.chance(0.5) ? random_(0.25, 0.4) : 0, random_, random_(0, 1));
  }
  void make_rounded_box()
  {
    const Vec size{random_(1, 3), random_(1, 2), random_(0.8, 1.5)};
    part_ =
      rounded_box(size, random_(0.1, 0.35), part_of_turn(90, 3), part_of_turn(90, 3), random_);
  }
  void make_flats()
  {
    Part_builder b("", random_, are_triangles_);
    const double r = random_(0.5, 1), l = random_(0.5, 2);
    if (random_.chance(0.5)) { // D all along
      const auto side = b.sweep(d_shape(0, 0, r, false), Chain(0, 0).line_to(0, l, line()));
      b.cap({side.start});
      b.cap({side.end});
    } else {
      Chain c;
      begin_shaft(c, r);
      go_up(c, 0.3 + l);
      const auto side = b.sweep(circle(0, 0, 0, full()), c);
      const auto end =
        b.sweep(d_shape(0, 0, r * random_(0.5, 0.8), false), Chain(0, 0.3 + l).line_to(0, 1 + l));
      if (c.points[0][0] > 0) b.cap({side.start});
      b.cap({side.end, end.start});
      b.cap({end.end});
    }
    part_ = b.take();
  }

  // What is turned with less than eight sides is of planes.
  void make_few_sides()
  {
    is_small_prism_ = true;
    const int n = random_.integer(3, 7);
    const double inner = std::cos(pi / n);
    Chain c(-random_(0, 0.3), 0);
    double z = 0;
    for (int k = random_.integer(1, 4); k > 0; --k) {
      const double d = c.points.back()[0];
      z += random_(0.3, 1);
      c.line_to(d, z, line());
      if (k == 1) break;
      // a step, or a chamfer: it meets the sides, and its sides each other, at more than 31 degrees
      const double next = d < -0.3 * inner ? d + random_(0.1, 0.2) : d - random_(0.1, 0.2);
      if (random_.chance(0.5))
        c.line_to(next, z);
      else {
        z += random_(1, 1.6) * std::abs(next - d);
        c.line_to(next, z);
      }
    }
    Part_builder b("", random_, are_triangles_);
    const auto side = b.sweep(regular_polygon(n, 0, 0, 1, false, random_(0, 1)), c);
    std::vector<Rim> bottom{side.start}, top{side.end};
    if (random_.chance(0.4)) {
      const auto bore = b.sweep(regular_polygon(random_.integer(3, 7), 0, 0, 0.1, true),
                                Chain(0, 0).line_to(0, c.points.back()[1], line()));
      bottom.push_back(bore.start);
      top.push_back(bore.end);
    }
    b.cap(bottom);
    b.cap(top);
    part_ = b.take();
  }

  // fillets and chamfers along z, both ends at any angle
  void make_cut_box()
  {
    Convex_builder b;
    const double x = random_(1, 3), y = random_(1, 3), r = random_(0.1, 0.4);
    b.add_plane({random_(-0.3, 0.3), random_(-0.3, 0.3), -1}, {0, 0, -1});
    b.add_plane({random_(-0.3, 0.3), random_(-0.3, 0.3), 1}, {0, 0, 2});
    const std::array<double, 4> sx{1, 0, 0, 1}, sy{1, 1, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) {
      const double t = static_cast<double>(i) * pi / 2;
      const Vec corner{sx[i] * x, sy[i] * y, 0};
      b.add_plane({std::cos(t), std::sin(t), 0}, corner);
      const double u = 2 * sx[i] - 1, v = 2 * sy[i] - 1;
      const int form = random_.integer(0, 2);
      if (form == 1) b.add_plane({u, v, 0}, {corner[0] - u * r, corner[1], 0});
      if (form == 2)
        b.add_fillet(corner[0] - u * r, corner[1] - v * r, r, static_cast<double>(i) * 90, 90,
                     static_cast<int>(part_of_turn(90).size()) - 1);
    }
    part_ = b.take("");
    if (are_triangles_) part_ = cut_into_triangles(part_);
  }
  Part cut_into_triangles(const Part& part)
  {
    Part result = part;
    result.faces.clear();
    result.surface_of_face.clear();
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      std::vector<std::size_t> face = part.faces[f];
      std::rotate(face.begin(),
                  face.begin() + random_.integer(0, static_cast<int>(face.size()) - 1), face.end());
      for (std::size_t i = 2; i < face.size(); ++i) {
        result.faces.push_back({face[0], face[i - 1], face[i]});
        result.surface_of_face.push_back(part.surface_of_face[f]);
      }
    }
    return result;
  }

  Random random_;
  int n_ = 0;
  double unevenness_ = 0;
  bool are_triangles_ = true, is_small_prism_ = false;
  Part part_;
};

} // namespace synthetic_parts

#endif // PN_TEST_RANDOM_PARTS_H
