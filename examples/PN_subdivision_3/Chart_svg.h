// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_CHART_SVG_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_CHART_SVG_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Line charts as SVG, side by side, with one legend. The vertical axis is logarithmic; smaller values
// than a given one, 0 among them, are drawn at its lower end. The colors follow the reader's light or dark mode.
namespace chart_svg {

struct Series
{
  std::string name; // the same name has the same color in all panels
  std::vector<std::pair<double, double>> points;
};

struct Panel
{
  std::string caption, x_label;
  bool logarithmic_x = false;
  std::vector<Series> series;
};

namespace internal {

constexpr double width = 430, height = 400, left = 76, top = 84, below = 64, gap = 44, legend = 236;
// distinguishable with color vision deficiencies (Okabe and Ito), and by their marks
constexpr std::array<const char*, 9> colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00",
                                            "#56b4e9", "#8a6fd1", "#7f7f7f", "#b8a800"};

struct Axis
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool logarithmic = true;
  double smallest = 0;    // smaller values are drawn at the lower end
  bool too_small = false; // there are such

  void add(double x)
  {
    if (is_too_small(x)) {
      too_small = true;
      return;
    }
    const double e = logarithmic ? std::log10(x) : x;
    low = (std::min)(low, e);
    high = (std::max)(high, e);
  }
  bool is_too_small(double x) const { return logarithmic && !(x > smallest); }
  void round_out()
  {
    if (!(low <= high)) low = high = 0;
    low = std::floor(low) - (too_small ? 1 : 0);
    high = (std::max)(std::ceil(high), low + 1);
  }
  double operator()(double x) const // in [0, 1]
  {
    const double e = !logarithmic ? x : is_too_small(x) ? low : std::log10(x);
    return (e - low) / (high - low);
  }
  double step() const { return (std::max)(1., std::ceil((high - low) / 10)); }
  std::string tick(double e) const
  {
    std::ostringstream out;
    if (!logarithmic)
      out << e;
    else if (too_small && e == low)
      out << (smallest > 0 ? "less or 0" : "0");
    else
      out << "10<tspan dy='-5' font-size='10'>" << e << "</tspan>";
    return out.str();
  }
};

class Drawing
{
public:
  Drawing(const std::vector<Panel>& panels, double smallest)
    : panels_(panels)
  {
    y_.smallest = smallest;
    for (const Panel& p : panels)
      for (const Series& s : p.series) {
        color_.emplace(s.name, color_.size());
        if (color_.size() > names_.size()) names_.push_back(s.name);
        for (const auto& point : s.points) y_.add(point.second);
      }
    y_.round_out();
  }

  std::string operator()(const std::string& title, const std::string& y_label)
  {
    const double w = left + double(panels_.size()) * (width + gap) + legend,
                 h = top + height + below;
    out_
      << std::fixed << std::setprecision(1) << "<svg xmlns='http://www.w3.org/2000/svg' width='"
      << w << "' height='" << h << "' viewBox='0 0 " << w << ' ' << h
      << "' font-family='sans-serif' font-size='13'>\n<style>text{fill:#222}.axis{stroke:#999;fill:"
         "none}.grid{stroke:#ddd}.back{fill:#fff}@media(prefers-color-scheme:dark){text{fill:#ddd}"
         ".grid{stroke:#444}.back{fill:#1b1b1b}}</style>\n<rect class='back' width='100%' "
         "height='100%'/>\n";
    text(left, 30, title, "font-size='17'");
    text(left, 52, y_label, "font-size='12'");
    for (std::size_t i = 0; i < panels_.size(); ++i)
      draw(panels_[i], left + double(i) * (width + gap), i == 0);
    draw_legend(left + double(panels_.size()) * (width + gap) + 4);
    out_ << "</svg>\n";
    return out_.str();
  }

private:
  void text(double x, double y, const std::string& s, const std::string& attributes = "")
  {
    out_ << "<text x='" << x << "' y='" << y << "' " << attributes << '>' << s << "</text>\n";
  }

  void line(double x, double y, double u, double v, const char* kind)
  {
    out_ << "<line class='" << kind << "' x1='" << x << "' y1='" << y << "' x2='" << u << "' y2='"
         << v << "'/>\n";
  }

  void mark(double x, double y, std::size_t color)
  {
    const double r = 3.5;
    if (color % 3 == 0)
      out_ << "<circle cx='" << x << "' cy='" << y << "' r='" << r << "'";
    else if (color % 3 == 1)
      out_ << "<rect x='" << x - r << "' y='" << y - r << "' width='" << 2 * r << "' height='"
           << 2 * r << "'";
    else
      out_ << "<path d='M" << x << ' ' << y - r - 1 << "l" << r + 1 << ' ' << 2 * r << 'h'
           << -2 * r - 2 << "z'";
    out_ << " fill='" << colors[color % colors.size()] << "'/>\n";
  }

  void draw(const Panel& panel, double x0, bool first)
  {
    Axis x;
    x.logarithmic = panel.logarithmic_x;
    for (const Series& s : panel.series)
      for (const auto& point : s.points) x.add(point.first);
    x.round_out();
    const auto at_x = [&](double value) { return x0 + width * value; };
    const auto at_y = [&](double value) { return top + height * (1 - value); };
    for (double e = x.low; e <= x.high; e += x.step()) {
      const double u = at_x((e - x.low) / (x.high - x.low));
      line(u, top, u, top + height, "grid");
      text(u, top + height + 20, x.tick(e), "text-anchor='middle'");
    }
    for (double e = y_.low; e <= y_.high; e += y_.step()) {
      const double v = at_y((e - y_.low) / (y_.high - y_.low));
      line(x0, v, x0 + width, v, "grid");
      if (first) text(x0 - 8, v + 4, y_.tick(e), "text-anchor='end'");
    }
    out_ << "<rect class='axis' x='" << x0 << "' y='" << top << "' width='" << width << "' height='"
         << height << "'/>\n";
    text(x0 + width / 2, top - 10, panel.caption, "text-anchor='middle'");
    text(x0 + width / 2, top + height + 44, panel.x_label, "text-anchor='middle'");
    for (const Series& s : panel.series) {
      const std::size_t color = color_.at(s.name);
      out_ << "<polyline fill='none' stroke-width='2' stroke='" << colors[color % colors.size()]
           << "' points='";
      for (const auto& [u, v] : s.points) out_ << at_x(x(u)) << ',' << at_y(y_(v)) << ' ';
      out_ << "'/>\n";
      for (const auto& [u, v] : s.points) mark(at_x(x(u)), at_y(y_(v)), color);
    }
  }

  void draw_legend(double x)
  {
    double y = top + 12;
    for (const std::string& name : names_) {
      const std::size_t color = color_.at(name);
      out_ << "<line stroke-width='2' stroke='" << colors[color % colors.size()] << "' x1='" << x
           << "' y1='" << y << "' x2='" << x + 26 << "' y2='" << y << "'/>\n";
      mark(x + 13, y, color);
      text(x + 34, y + 4, name, "font-size='12'");
      y += 23;
    }
  }

  const std::vector<Panel>& panels_;
  std::map<std::string, std::size_t> color_;
  std::vector<std::string> names_; // in the order of their colors
  Axis y_;
  std::ostringstream out_;
};

} // namespace internal

/// whether the file could be written
inline bool write(const std::string& file, const std::string& title, const std::string& y_label,
                  const std::vector<Panel>& panels, double smallest = 0)
{
  std::ofstream out(file);
  out << internal::Drawing(panels, smallest)(title, y_label);
  return bool(out.flush());
}

} // namespace chart_svg

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_CHART_SVG_H
