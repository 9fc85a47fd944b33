// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_CURVE_SVG_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_CURVE_SVG_H

#include <CGAL/PN_subdivision_curve.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Draws plane curves with their control polygons, control normals and curvature combs as SVG. The
// colors follow the reader's light or dark mode. Used by the examples and by the command.
namespace curve_svg {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;

using Curve = std::vector<std::pair<Point, Vector>>;
using CGAL::PN_subdivision_3::Curve_end;

// One curve of a drawing.
struct Panel
{
  std::string caption;
  bool closed = false;
  std::vector<Point> curve;
  std::vector<Point> control_points;
  std::vector<Vector> control_normals; // of unit length or, seen from the side, shorter
  std::vector<double> curvature;       // at the points of the curve
  // The ends of the comb's teeth, if a curvature of 1 gives a tooth of length `scale`; empty for a
  // drawing without comb.
  std::function<std::vector<Point>(double scale)> comb;
};

inline Panel panel(const std::string& caption, const Curve& polygon, const Curve& curve,
                   Curve_end end)
{
  Panel p;
  p.caption = caption;
  p.closed = end == Curve_end::closed;
  for (const auto& [point, normal] : polygon) {
    p.control_points.push_back(point);
    p.control_normals.push_back(normal);
  }
  for (const auto& point_and_normal : curve) p.curve.push_back(point_and_normal.first);
  p.curvature = CGAL::PN_subdivision_3::discrete_curvature(p.curve, end);
  p.comb = [points = p.curve, end](double scale) {
    return CGAL::PN_subdivision_3::curvature_comb(points, end, scale);
  };
  return p;
}

namespace internal {

constexpr double panel_width = 640, panel_height = 640, several = 0.7, margin = 28, gap = 40,
                 caption_height = 34;
constexpr double tooth_distance = 7; // in units of the drawing
// how far and with what turns paths are drawn in one line
constexpr double detail = 1.8, longest = 60, straight = 0.025;

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
    for (const Point& p : panel_.control_points)
      out_ << "<circle cx=\"" << x(p) << "\" cy=\"" << y(p) << "\" r=\"3.4\"/>\n";
  }

private:
  double x(const Point& p) const { return left_.x() + unit_ * (p.x() - left_.y()); }
  double y(const Point& p) const { return unit_ * (upper_ - p.y()); }

  std::string pair(const Point& p) const
  {
    std::ostringstream s;
    s << std::fixed << std::setprecision(1) << x(p) << ' ' << y(p);
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

  std::string path(const std::vector<Point>& points, bool closed, bool thinned) const
  {
    std::string d;
    std::size_t last = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool is_end = i == 0 || i + 1 == points.size();
      if (!is_end && thinned && !is_needed(points, last, i)) continue;
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
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const Point& p = panel_.control_points[i];
      const double l = unit_ * length(tips[i] - p);
      if (!(l > 4)) continue;
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

// The text of an SVG file with the curves side by side, at one scale, and their combs too.
inline std::string drawing(const std::string& title, const std::vector<Panel>& panels)
{
  using namespace internal;
  const Scales s = scales(panels);
  double width = 0, height = 0;
  for (const Panel& panel : panels) {
    const CGAL::Bbox_2 b = box(panel, s);
    width = (std::max)(width, b.xmax() - b.xmin());
    height = (std::max)(height, b.ymax() - b.ymin());
  }
  double unit = 1;
  if (s.size > 0) unit = (std::min)(panel_width / width, panel_height / height);
  if (panels.size() > 1) unit = (std::min)(several * panel_width / width, panel_height / height);
  const double inner = unit * height;

  std::ostringstream body;
  body << std::fixed << std::setprecision(1);
  double left = margin;
  for (const Panel& panel : panels) {
    const CGAL::Bbox_2 b = box(panel, s);
    const double place = (std::max)(unit * (b.xmax() - b.xmin()), 7.5 * panel.caption.size());
    const double middle_x = (b.xmin() + b.xmax()) / 2, middle_y = (b.ymin() + b.ymax()) / 2;
    const double upper = middle_y + (margin + inner / 2) / unit;
    Panel_writer(body, panel, s, unit, Point(left + place / 2, middle_x), upper).write();
    body << "<text x=\"" << left + place / 2 << "\" y=\"" << margin + inner + caption_height
         << "\">" << escaped(panel.caption) << "</text>\n";
    left += place + gap;
  }

  std::ostringstream out;
  out << std::fixed << std::setprecision(1);
  const double whole_width = left - gap + margin;
  const double whole_height = 2 * margin + inner + caption_height - 6;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << whole_width << ' '
      << whole_height << "\" width=\"" << whole_width << "\" height=\"" << whole_height
      << "\">\n<title>" << escaped(title) << "</title>\n"
      << style() << "<rect class=\"paper\" width=\"100%\" height=\"100%\" rx=\"8\"/>\n"
      << body.str() << "</svg>\n";
  return out.str();
}

// Writes the drawing to a file; false if that fails.
inline bool write(const std::string& file, const std::string& title,
                  const std::vector<Panel>& panels)
{
  std::ofstream out(file);
  out << drawing(title, panels) << std::flush;
  return out.good();
}

} // namespace curve_svg

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_CURVE_SVG_H
