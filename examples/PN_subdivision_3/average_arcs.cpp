// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How the point-normal average makes a point: from each old point an arc goes to the line through the
// linear average q along the averaged normal n, at right angles to the old normal and to n. Where the arcs
// end are heights over q; the new point is at their weighted mean.
//
//   average_arcs [OUTPUT.svg]

#include <CGAL/PN_subdivision_3/average/PN_average.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace PN = CGAL::PN_subdivision_3;

namespace {

using Average = PN::PN_average<double, 2>;
using Vector = Average::Vector;

struct Entry
{
  int vertex;
  double weight;
};

double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1];
}

// a + s b
Vector moved(const Vector& a, double s, const Vector& b)
{
  return {a[0] + s * b[0], a[1] + s * b[1]};
}

Vector direction(double degrees)
{
  const double t = degrees * std::acos(-1) / 180;
  return {std::cos(t), std::sin(t)};
}

// What the drawing shows, by the formulas of the paper.
struct Construction
{
  std::vector<Average::Value> old;
  std::vector<Entry> row;
  Vector q{0, 0}, normal{0, 0}, point{0, 0};
  std::vector<double> heights;
};

Construction construct(const std::vector<Average::Value>& old, const std::vector<Entry>& row)
{
  Construction c{old, row, {0, 0}, {0, 0}, {0, 0}, {}};
  for (const auto& [j, weight] : row) {
    c.q = moved(c.q, weight, old[j].point);
    c.normal = moved(c.normal, weight, old[j].normal);
  }
  c.normal = moved({0, 0}, 1 / std::sqrt(dot(c.normal, c.normal)), c.normal);
  double height = 0;
  for (const auto& [j, weight] : row) {
    const Vector sum = moved(old[j].normal, 1, c.normal);
    c.heights.push_back(dot(sum, moved(old[j].point, -1, c.q)) / dot(sum, c.normal));
    height += weight * c.heights.back();
  }
  c.point = moved(c.q, height, c.normal);
  return c;
}

class Drawing
{
public:
  explicit Drawing(std::ostream& out)
    : out_(out)
  {
    out_ << std::fixed << std::setprecision(1);
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 310\" width=\"640\" "
            "height=\"310\">\n<title>The heights of the point-normal average</title>\n<style>\n"
            ".paper{fill:#fff} .line{stroke:#888;stroke-dasharray:5 4} path{fill:none}\n"
            ".arc{stroke:#2166c8;stroke-width:2} .normal{stroke:#2b8a3e;stroke-width:2}\n"
            "circle{fill:#b3202c} .mean{fill:#111} .end{fill:#2166c8}\n"
            "text{font:16px sans-serif;fill:#222}\n"
            "@media (prefers-color-scheme:dark){.paper{fill:#1b1e23} text{fill:#ddd} "
            ".mean{fill:#fff}\n.arc{stroke:#7fb2ff} .end{fill:#7fb2ff} .normal{stroke:#69db7c} "
            "circle{fill:#ff8787}}\n</style>\n"
            "<rect class=\"paper\" width=\"100%\" height=\"100%\" rx=\"8\"/>\n";
  }
  ~Drawing() { out_ << "</svg>\n"; }

  void line(const std::string& kind, const Vector& a, const Vector& b)
  {
    out_ << "<path class=\"" << kind << "\" d=\"M" << x(a) << ' ' << y(a) << 'L' << x(b) << ' '
         << y(b) << "\"/>\n";
  }

  // the arc of a circle with these normals at its ends
  void arc(const Vector& a, const Vector& normal_at_a, const Vector& b, const Vector& normal_at_b)
  {
    const Vector chord = moved(b, -1, a), turn = moved(normal_at_b, -1, normal_at_a);
    const double radius = dot(chord, chord) / dot(chord, turn);
    const double across = normal_at_a[0] * normal_at_b[1] - normal_at_a[1] * normal_at_b[0];
    out_ << "<path class=\"arc\" d=\"M" << x(a) << ' ' << y(a) << 'A' << scale * std::abs(radius)
         << ' ' << scale * std::abs(radius) << " 0 0 " << (across > 0 ? 0 : 1) << ' ' << x(b) << ' '
         << y(b) << "\"/>\n";
  }

  void dot_with_text(const std::string& kind, const Vector& p, const std::string& text,
                     double right, double down)
  {
    out_ << "<circle class=\"" << kind << "\" cx=\"" << x(p) << "\" cy=\"" << y(p)
         << "\" r=\"4\"/>\n<text x=\"" << x(p) + right << "\" y=\"" << y(p) + down << "\">" << text
         << "</text>\n";
  }

private:
  static constexpr double scale = 110;
  static double x(const Vector& p) { return 320 + scale * p[0]; }
  static double y(const Vector& p) { return 200 - scale * p[1]; }

  std::ostream& out_;
};

void draw(std::ostream& out, const Construction& c)
{
  const std::array<const char*, 3> index = {"\u2080", "\u2081", "\u2082"};
  Drawing d(out);
  d.line("line", moved(c.q, -0.5, c.normal), moved(c.q, 1.6, c.normal));
  for (std::size_t j = 0; j < c.row.size(); ++j) {
    const auto& [point, normal, roundness] = c.old[j];
    const Vector end = moved(c.q, c.heights[j], c.normal);
    d.arc(point, normal, end, c.normal);
    d.line("normal", point, moved(point, 0.45, normal));
    d.dot_with_text("old", point, std::string("p") + index[j], -8, 24);
    const double right = j == 0 ? 12 : -84, down = j == 0 ? -6 : j == 1 ? 6 : 14;
    d.dot_with_text("end", end, std::string("q + h") + index[j] + " n", right, down);
  }
  d.line("normal", c.point, moved(c.point, 0.45, c.normal));
  d.dot_with_text("mean", c.q, "q", -24, 6);
  d.dot_with_text("mean", c.point, "new point", -92, 6);
}

} // namespace

int main(int argc, char** argv)
{
  const std::string output = argc > 1 ? argv[1] : "average_arcs.svg";
  const std::vector<Average::Value> old = {
    {{-2, -0.3}, direction(140)}, {{0.8, -0.1}, direction(85)}, {{2.3, -0.6}, direction(25)}};
  const std::vector<Entry> row = {{0, 0.25}, {1, 0.5}, {2, 0.25}};
  const Construction c = construct(old, row);
  std::cout << "heights " << c.heights[0] << ' ' << c.heights[1] << ' ' << c.heights[2] << ", mean "
            << dot(c.normal, moved(c.point, -1, c.q)) << std::endl;

  // the package's average of the same points and normals
  const Average::Value made = Average()(row.data(), row.data() + row.size(), old.data());
  const Vector off = moved(made.point, -1, c.point);
  std::cout << "off the package's point by " << std::sqrt(dot(off, off)) << std::endl;

  std::ofstream file(output);
  draw(file, c);
  const bool same = dot(off, off) <= std::pow(8 * std::numeric_limits<double>::epsilon(), 2);
  return same && file.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
