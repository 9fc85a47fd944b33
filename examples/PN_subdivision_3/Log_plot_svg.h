// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_EXAMPLES_LOG_PLOT_SVG_H
#define CGAL_PN_SUBDIVISION_3_EXAMPLES_LOG_PLOT_SVG_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

// Plots of positive numbers against 0, 1, 2, ... in logarithmic scale, side by side, as SVG. What is
// out of the plot's bounds, 0 among it, is drawn on them. The colors follow the reader's light or dark mode.
namespace log_plot_svg {

struct Line
{
  std::string label; // lines with the same label have the same color and one entry in the legend
  std::vector<double> values;
  bool dashed = false;
};

struct Panel
{
  std::string caption;
  std::vector<Line> lines;
};

struct Plot
{
  std::string title, x_label, y_label, legend_title;
  int least_exponent, largest_exponent; // of the powers of ten that bound the plot
  std::vector<Panel> panels;
  std::size_t tick_step = 5;
  bool numbered_labels = true; // the legend is in the order of numbers, else of appearance
  double legend_width = 90;
  std::vector<std::string> tick_labels = {}; // instead of 0, 1, 2, ...
  std::size_t color_step = 1;                // farther apart where lines are few
};

namespace internal {

constexpr double width = 400, height = 420, left = 64, top = 44, gap = 30, bottom = 58;

// readable on light and on dark paper
constexpr std::array<const char*, 10> colors = {"#8f63e8", "#4f7df0", "#1e96c8", "#0f9d8a",
                                                "#3f9b3f", "#8a9a1f", "#c78a10", "#e06c1f",
                                                "#d9483b", "#c94c96"};

inline std::vector<std::string> labels(const Plot& plot)
{
  std::vector<std::string> all;
  for (const Panel& panel : plot.panels)
    for (const Line& line : panel.lines)
      if (std::find(all.begin(), all.end(), line.label) == all.end()) all.push_back(line.label);
  if (plot.numbered_labels)
    std::sort(all.begin(), all.end(), [](const std::string& a, const std::string& b) {
      return a.size() == b.size() ? a < b : a.size() < b.size();
    });
  return all;
}

inline std::size_t last_x(const Plot& plot)
{
  std::size_t n = 1;
  for (const Panel& panel : plot.panels)
    for (const Line& line : panel.lines) n = (std::max)(n, line.values.size() - 1);
  return n;
}

inline double y(const Plot& plot, double value)
{
  const double exponent = (std::min)((std::max)(std::log10(value), double(plot.least_exponent)),
                                     double(plot.largest_exponent));
  return top + height * (plot.largest_exponent - exponent) /
                 (plot.largest_exponent - plot.least_exponent);
}

inline void write_axes(std::ostream& out, const Plot& plot, std::size_t n, double x0, bool first)
{
  for (int e = plot.least_exponent; e <= plot.largest_exponent; ++e) {
    const double at = y(plot, std::pow(10., e));
    out << "<path class=\"grid\" d=\"M" << x0 << ' ' << at << 'h' << width << "\"/>\n";
    if (first)
      out << "<text class=\"end\" x=\"" << x0 - 8 << "\" y=\"" << at + 5 << "\">10<tspan dy=\"-6\" "
          << "font-size=\"10\">" << e << "</tspan></text>\n";
  }
  for (std::size_t i = 0; i <= n; i += plot.tick_step) {
    const double at = x0 + width * double(i) / double(n);
    out << "<path class=\"grid\" d=\"M" << at << ' ' << top << 'v' << height << "\"/><text x=\""
        << at << "\" y=\"" << top + height + 19 << "\">"
        << (plot.tick_labels.empty() ? std::to_string(i) : plot.tick_labels.at(i)) << "</text>\n";
  }
  out << "<text x=\"" << x0 + width / 2 << "\" y=\"" << top + height + 42 << "\">" << plot.x_label
      << "</text>\n";
}

inline const char* style()
{
  return "<style>.paper{fill:#fdfdfb}.grid{stroke:#d9dce1}text{fill:#39424e}\n"
         "@media(prefers-color-scheme:dark){.paper{fill:#14171c}.grid{stroke:#343a44}"
         "text{fill:#c3cbd6}}\n"
         "path{fill:none;stroke-width:2;stroke-linejoin:round}.grid{stroke-width:1}"
         ".dashed{stroke-dasharray:6 4;stroke-width:1.6}"
         "text{font:14px system-ui,'Segoe UI',Helvetica,Arial,sans-serif;text-anchor:middle}"
         ".end{text-anchor:end}.start{text-anchor:start}.caption{font-size:16px}</style>\n";
}

} // namespace internal

// The text of an SVG file.
inline std::string drawing(const Plot& plot)
{
  using namespace internal;
  const std::vector<std::string> names = labels(plot);
  const std::size_t n = last_x(plot);
  const auto color = [&](const std::string& label) {
    const auto i = std::find(names.begin(), names.end(), label) - names.begin();
    return colors[static_cast<std::size_t>(i) * plot.color_step % colors.size()];
  };
  const double right = left + double(plot.panels.size()) * (width + gap);
  std::ostringstream out;
  out << std::fixed << std::setprecision(1);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << right + plot.legend_width
      << ' ' << top + height + bottom << "\" width=\"" << right + plot.legend_width
      << "\">\n<title>" << plot.title << "</title>\n"
      << style() << "<rect class=\"paper\" width=\"100%\" height=\"100%\" rx=\"8\"/>\n";
  double x0 = left;
  for (const Panel& panel : plot.panels) {
    write_axes(out, plot, n, x0, x0 == left);
    out << "<text class=\"caption\" x=\"" << x0 + width / 2 << "\" y=\"" << top - 16 << "\">"
        << panel.caption << "</text>\n";
    for (const Line& line : panel.lines) {
      out << "<path" << (line.dashed ? " class=\"dashed\"" : "") << " stroke=\""
          << color(line.label) << "\" d=\"M";
      for (std::size_t i = 0; i < line.values.size(); ++i)
        out << (i == 0 ? "" : " ") << x0 + width * double(i) / double(n) << ' '
            << y(plot, line.values[i]);
      out << "\"/>\n";
    }
    x0 += width + gap;
  }
  out << "<text transform=\"translate(16 " << top + height / 2 << ")rotate(-90)\">" << plot.y_label
      << "</text>\n<text class=\"start\" x=\"" << right - 10 << "\" y=\"" << top + 12 << "\">"
      << plot.legend_title << "</text>\n";
  double at = top + 36;
  for (const std::string& name : names) {
    out << "<path stroke=\"" << color(name) << "\" d=\"M" << right - 10 << ' ' << at - 5
        << "h26\"/><text class=\"start\" x=\"" << right + 24 << "\" y=\"" << at << "\">" << name
        << "</text>\n";
    at += 22;
  }
  out << "</svg>\n";
  return out.str();
}

// Writes the plot to a file; false if that fails.
inline bool write(const std::string& file, const Plot& plot)
{
  std::ofstream out(file);
  out << drawing(plot) << std::flush;
  return out.good();
}

} // namespace log_plot_svg

#endif // CGAL_PN_SUBDIVISION_3_EXAMPLES_LOG_PLOT_SVG_H
