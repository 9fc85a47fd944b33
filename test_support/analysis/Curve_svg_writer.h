// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_CURVE_SVG_WRITER_H
#define CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_CURVE_SVG_WRITER_H

#include "analysis/Curve_svg_panel.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <locale>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// The parts of a drawing of curves. Lengths that are said to be in units of the drawing are pixels at
// its natural size; what is finer is left out.

namespace CGAL {
namespace PN_subdivision_3 {
namespace curve_svg {
namespace internal {

constexpr double panel_width = 640, panel_height = 640, several = 0.7, margin = 28, gap = 40,
                 caption_height = 34;
constexpr double tooth_distance = 7; // in units of the drawing
// how far and with what turns paths are drawn in one line
constexpr double detail = 1.8, longest = 60, straight = 0.025;
// below which two points are one, and the size of the cells that show one dot or arrow
constexpr double invisible = 0.25, dot = 1;

// of numbers as SVG has them, whatever the global locale
inline std::ostringstream drawing_stream()
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << std::fixed << std::setprecision(1);
  return stream;
}

inline double length(const Vector& v)
{
  return std::hypot(v.x(), v.y());
}

inline CGAL::Bbox_2 box(const std::vector<Point>& points)
{
  CGAL::Bbox_2 b;
  for (const Point& p : points) b += p.bbox();
  return b;
}

inline double diagonal(const CGAL::Bbox_2& b)
{
  return b.xmin() > b.xmax() ? 0 : std::hypot(b.xmax() - b.xmin(), b.ymax() - b.ymin());
}

// What all panels share, so that they can be compared.
struct Scales
{
  double size = 0;   // of the largest curve
  double comb = 0;   // length of a tooth per curvature
  double normal = 0; // length of an arrow
};

// The comb's height is that of a curvature that 95 % of all points stay below, unless the largest
// would then leave the drawing.
inline Scales scales(const std::vector<Panel>& panels)
{
  Scales s;
  std::vector<double> curvatures;
  for (const Panel& panel : panels) {
    s.size = (std::max)(s.size, diagonal(box(panel.curve) + box(panel.control_points)));
    for (const double k : panel.curvature) curvatures.push_back(std::abs(k));
  }
  s.normal = 0.075 * s.size;
  if (curvatures.empty()) return s;
  std::sort(curvatures.begin(), curvatures.end());
  const double usual = curvatures[(curvatures.size() - 1) * 95 / 100];
  // of straight lines nothing is left but rounding
  if (curvatures.back() * s.size < 1e-6) return s;
  s.comb = (std::min)(0.15 * s.size / usual, 0.3 * s.size / curvatures.back());
  return s;
}

inline std::vector<Point> envelope(const Panel& panel, const Scales& s)
{
  return panel.comb && s.comb > 0 ? panel.comb(s.comb) : std::vector<Point>();
}

inline std::vector<Point> arrow_tips(const Panel& panel, const Scales& s)
{
  std::vector<Point> tips;
  for (std::size_t i = 0; i < panel.control_normals.size(); ++i)
    tips.push_back(panel.control_points[i] + s.normal * panel.control_normals[i]);
  return tips;
}

inline CGAL::Bbox_2 box(const Panel& panel, const Scales& s)
{
  return box(panel.curve) + box(panel.control_points) + box(envelope(panel, s)) +
         box(arrow_tips(panel, s));
}

inline std::string escaped(const std::string& text)
{
  std::string s;
  for (const char c : text) {
    if (c == '&')
      s += "&amp;";
    else if (c == '<')
      s += "&lt;";
    else if (c == '>')
      s += "&gt;";
    else
      s += static_cast<unsigned char>(c) < 32 ? ' ' : c;
  }
  return s;
}

// Maps a panel to its place in the drawing and writes its parts.
class Panel_writer
{
public:
  Panel_writer(std::ostream& out, const Panel& panel, const Scales& scales, double unit, Point left,
               double upper)
    : out_(out)
    , panel_(panel)
    , scales_(scales)
    , unit_(unit)
    , left_(left)
    , upper_(upper)
  {}

  void write() const
  {
    write_comb();
    out_ << "<path class=\"polygon\" d=\"" << path(panel_.control_points, panel_.closed, false)
         << "\"/>\n";
    out_ << "<path class=\"curve\" d=\"" << path(panel_.curve, panel_.closed, true) << "\"/>\n";
    write_normals();
    std::set<Cell> drawn;
    for (const Point& p : panel_.control_points)
      if (drawn.insert(cell(p)).second)
        out_ << "<circle cx=\"" << x(p) << "\" cy=\"" << y(p) << "\" r=\"3.4\"/>\n";
  }

private:
  double x(const Point& p) const { return left_.x() + unit_ * (p.x() - left_.y()); }
  double y(const Point& p) const { return unit_ * (upper_ - p.y()); }

  // Dots in one cell hide each other.
  using Cell = std::pair<long, long>;
  Cell cell(const Point& p) const { return {std::lround(x(p) / dot), std::lround(y(p) / dot)}; }

  std::string pair(const Point& p) const
  {
    std::ostringstream s = drawing_stream();
    s << x(p) << ' ' << y(p);
    return s.str();
  }

  // Is point i needed if `last` was the one before? Not while the path goes on nearly straight.
  bool is_needed(const std::vector<Point>& points, std::size_t last, std::size_t i) const
  {
    const Vector in = unit_ * (points[i] - points[last]), out = points[i + 1] - points[i];
    if (length(in) < detail) return false;
    const double turn = std::abs(in.x() * out.y() - in.y() * out.x());
    return length(in) > longest || in * out < 0 || turn > straight * length(in) * length(out);
  }

  // Nobody sees that these are two points.
  bool is_near(const Point& p, const Point& q) const { return unit_ * length(q - p) < invisible; }

  // With `thinned` as few of the points as a smooth line needs, otherwise all that can be told apart.
  std::string path(const std::vector<Point>& points, bool closed, bool thinned) const
  {
    std::string d;
    std::size_t last = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool is_end = i == 0 || i + 1 == points.size();
      if (!is_end && (thinned ? !is_needed(points, last, i) : is_near(points[last], points[i])))
        continue;
      d += (i == 0 ? 'M' : ' ') + pair(points[i]); // after M a line to each
      last = i;
    }
    return d + (closed && !points.empty() ? "Z" : "");
  }

  void write_comb() const
  {
    const std::vector<Point> tips = envelope(panel_, scales_);
    if (tips.empty()) return;
    const std::vector<Point> back(tips.rbegin(), tips.rend());
    std::string other_side = path(back, panel_.closed, true);
    if (!panel_.closed) other_side = " " + other_side.substr(1) + "Z";
    out_ << "<path class=\"area\" d=\"" << path(panel_.curve, panel_.closed, true) << other_side
         << "\"/>\n<path class=\"teeth\" d=\"";
    write_teeth(panel_.curve, tips);
    out_ << "\"/>\n<path class=\"envelope\" d=\"" << path(tips, panel_.closed, true) << "\"/>\n";
  }

  // Teeth at even distances, between two points of the curve where need be.
  void write_teeth(const std::vector<Point>& feet, const std::vector<Point>& tips) const
  {
    double next = 0; // tooth, from foot i - 1
    for (std::size_t i = 1; i < feet.size(); ++i) {
      const double step = unit_ * length(feet[i] - feet[i - 1]);
      for (; next < step; next += tooth_distance) {
        const double t = next / step;
        out_ << 'M' << pair(feet[i - 1] + t * (feet[i] - feet[i - 1])) << ' '
             << pair(tips[i - 1] + t * (tips[i] - tips[i - 1]));
      }
      next -= step;
    }
    if (!panel_.closed) out_ << 'M' << pair(feet.back()) << ' ' << pair(tips.back());
  }

  void write_normals() const
  {
    const std::vector<Point> tips = arrow_tips(panel_, scales_);
    std::set<std::pair<Cell, Cell>> drawn;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const Point& p = panel_.control_points[i];
      const double l = unit_ * length(tips[i] - p);
      if (!(l > 4) || !drawn.emplace(cell(p), cell(tips[i])).second) continue;
      const Vector n = (tips[i] - p) / l;
      const Point neck = tips[i] - (std::min)(7., l / 2) * n;
      const Vector side = 2.6 * Vector(-n.y(), n.x());
      out_ << "<path class=\"normal\" d=\"M" << pair(p) << 'L' << pair(neck) << "\"/>"
           << "<path class=\"head\" d=\"M" << pair(tips[i]) << 'L' << pair(neck + side) << 'L'
           << pair(neck - side) << "Z\"/>\n";
    }
  }

  std::ostream& out_;
  const Panel& panel_;
  Scales scales_;
  double unit_;
  Point left_; // where the panel begins in the drawing, and there in the plane of the curve
  double upper_;
};

inline const char* style()
{
  return "<style>\n"
         ".paper{fill:#fdfdfb}.polygon{stroke:#8d96a3}.curve{stroke:#14417b}"
         ".area{fill:#e4682a}.teeth{stroke:#e4682a}.envelope{stroke:#c9501a}"
         ".normal{stroke:#16845b}.head{fill:#16845b}circle{fill:#fdfdfb;stroke:#5c6673}"
         "text{fill:#39424e}\n"
         "@media(prefers-color-scheme:dark){.paper{fill:#14171c}.polygon{stroke:#727c8a}"
         ".curve{stroke:#a9cdff}.area{fill:#ff9257}.teeth{stroke:#ff9257}.envelope{stroke:#ffa673}"
         ".normal{stroke:#4fd09a}.head{fill:#4fd09a}circle{fill:#14171c;stroke:#a7b0bd}"
         "text{fill:#c3cbd6}}\n"
         "path{fill:none;stroke-linejoin:round;stroke-linecap:round}"
         ".polygon{stroke-width:1;stroke-dasharray:1 4}.curve{stroke-width:2.2}"
         ".area{fill-rule:evenodd;fill-opacity:.09}.teeth{stroke-width:.6;stroke-opacity:.55}"
         ".envelope{stroke-width:1}.normal{stroke-width:1.4}circle{stroke-width:1.4}"
         "text{font:15px system-ui,'Segoe UI',Helvetica,Arial,sans-serif;text-anchor:middle}\n"
         "</style>\n";
}

} // namespace internal
} // namespace curve_svg
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_CURVE_SVG_WRITER_H
