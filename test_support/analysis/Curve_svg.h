// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_CURVE_SVG_H
#define CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_CURVE_SVG_H

#include "analysis/Curve_svg_panel.h"
#include "analysis/Curve_svg_writer.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace PN_subdivision_3 {
namespace curve_svg {

/*!
returns the text of an SVG file with the curves side by side. All are drawn at one scale, and so are their
combs. The colors follow the reader's light or dark mode. Details finer than a pixel are left out, so that
a curve of many points makes a small drawing.
*/
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

  std::ostringstream body = drawing_stream();
  double left = margin;
  for (const Panel& panel : panels) {
    const CGAL::Bbox_2 b = box(panel, s);
    const double place =
      (std::max)(unit * (b.xmax() - b.xmin()), 7.5 * static_cast<double>(panel.caption.size()));
    const double middle_x = (b.xmin() + b.xmax()) / 2, middle_y = (b.ymin() + b.ymax()) / 2;
    const double upper = middle_y + (margin + inner / 2) / unit;
    Panel_writer(body, panel, s, unit, Point(left + place / 2, middle_x), upper).write();
    body << "<text x=\"" << left + place / 2 << "\" y=\"" << margin + inner + caption_height
         << "\">" << escaped(panel.caption) << "</text>\n";
    left += place + gap;
  }

  std::ostringstream out = drawing_stream();
  const double whole_width = left - gap + margin;
  const double whole_height = 2 * margin + inner + caption_height - 6;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << whole_width << ' '
      << whole_height << "\" width=\"" << whole_width << "\" height=\"" << whole_height
      << "\">\n<title>" << escaped(title) << "</title>\n"
      << style() << "<rect class=\"paper\" width=\"100%\" height=\"100%\" rx=\"8\"/>\n"
      << body.str() << "</svg>\n";
  return out.str();
}

/*!
writes the `drawing()` to a file; returns `false` if that fails.
*/
inline bool write(const std::string& file, const std::string& title,
                  const std::vector<Panel>& panels)
{
  std::ofstream out(file);
  out << drawing(title, panels) << std::flush;
  return out.good();
}

} // namespace curve_svg
} // namespace PN_subdivision_3
} // namespace CGAL

#endif // CGAL_PN_SUBDIVISION_3_TEST_SUPPORT_CURVE_SVG_H
