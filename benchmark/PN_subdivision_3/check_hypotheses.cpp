// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// How much differences along edges shrink in one, two and three rounds of a linear scheme, whatever the data: the
// hypothesis (L) of the manual's page "Approximation Order", for one extraordinary vertex of each valence, and
// for Doo-Sabin a face of so many corners. Prints the table of that page.
//
// The difference of two rows that end in a new edge is a sum of differences along old edges; the least sum of
// absolute weights is the cost of transporting the positive part of the difference to its negative part along
// the edges. Computed in double precision.
//
//   check_hypotheses

#include "../../examples/PN_certificates_3/Order_samples.h"
#include "analysis/subdivision_matrix.h"

#include <CGAL/PN_subdivision_3/schemes/Any_scheme.h>
#include <CGAL/PN_subdivision_3/subdivide.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;
using namespace order_samples;
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

std::vector<int> distances_from(const Mesh& mesh, Mesh::Vertex_index source)
{
  std::vector<int> distance(mesh.number_of_vertices(), -1);
  std::queue<Mesh::Vertex_index> queue;
  distance[source] = 0;
  for (queue.push(source); !queue.empty(); queue.pop())
    for (const auto v : mesh.vertices_around_target(mesh.halfedge(queue.front())))
      if (distance[v] < 0) {
        distance[v] = distance[queue.front()] + 1;
        queue.push(v);
      }
  return distance;
}

// Amounts at some vertices are carried to others: the least sum of amounts times distances, by shortest
// augmenting paths with potentials.
class Transport
{
public:
  Transport(std::vector<double> from, std::vector<double> to, std::vector<std::vector<double>> cost)
    : m_from(std::move(from))
    , m_to(std::move(to))
    , m_cost(std::move(cost))
    , m_flow(m_from.size(), std::vector<double>(m_to.size(), 0.))
    , m_potential(m_from.size() + m_to.size(), 0.)
  {}

  double operator()()
  {
    while (augment()) {
    }
    double sum = 0;
    for (std::size_t i = 0; i < m_from.size(); ++i)
      for (std::size_t j = 0; j < m_to.size(); ++j) sum += m_flow[i][j] * m_cost[i][j];
    return sum;
  }

private:
  static constexpr double nothing = 1e-13;

  bool augment()
  {
    const std::size_t n = m_from.size(), all = n + m_to.size();
    constexpr double far = std::numeric_limits<double>::infinity();
    std::vector<double> distance(all, far);
    std::vector<std::size_t> before(all, all);
    std::vector<bool> is_done(all, false);
    for (std::size_t i = 0; i < n; ++i)
      if (m_from[i] > nothing) distance[i] = 0;
    for (;;) {
      std::size_t v = all;
      for (std::size_t w = 0; w < all; ++w)
        if (!is_done[w] && distance[w] < far && (v == all || distance[w] < distance[v])) v = w;
      if (v == all) break;
      is_done[v] = true;
      const auto reach = [&](std::size_t w, double cost) {
        const double d = distance[v] + (std::max)(0., cost + m_potential[v] - m_potential[w]);
        if (d < distance[w]) {
          distance[w] = d;
          before[w] = v;
        }
      };
      if (v < n)
        for (std::size_t j = 0; j < m_to.size(); ++j) reach(n + j, m_cost[v][j]);
      else
        for (std::size_t i = 0; i < n; ++i)
          if (m_flow[i][v - n] > nothing) reach(i, -m_cost[i][v - n]);
    }
    std::size_t end = all;
    for (std::size_t j = n; j < all; ++j)
      if (m_to[j - n] > nothing && (end == all || distance[j] < distance[end])) end = j;
    if (end == all || distance[end] == far) return false;
    for (std::size_t v = 0; v < all; ++v) m_potential[v] += (std::min)(distance[v], distance[end]);
    push(before, end);
    return true;
  }

  void push(const std::vector<std::size_t>& before, std::size_t end)
  {
    const std::size_t n = m_from.size(), none = before.size();
    double amount = m_to[end - n];
    std::size_t v = end;
    for (; before[v] != none; v = before[v])
      if (v < n) amount = (std::min)(amount, m_flow[v][before[v] - n]);
    amount = (std::min)(amount, m_from[v]);
    m_from[v] -= amount;
    m_to[end - n] -= amount;
    for (v = end; before[v] != none; v = before[v])
      if (v < n)
        m_flow[v][before[v] - n] -= amount;
      else
        m_flow[before[v]][v - n] += amount;
  }

  std::vector<double> m_from, m_to;
  std::vector<std::vector<double>> m_cost, m_flow;
  std::vector<double> m_potential;
};

// A net, its distances, and the rows of several rounds
class Net
{
public:
  Net(Mesh mesh, bool borders_count)
    : m_mesh(std::move(mesh))
    , m_fine(m_mesh)
    , m_rows(Matrix(m_mesh.number_of_vertices(), m_mesh.number_of_vertices()))
    , m_borders_count(borders_count)
  {
    m_rows.setIdentity();
    for (const auto v : m_mesh.vertices()) m_distance.push_back(distances_from(m_mesh, v));
    m_to_border.assign(m_mesh.number_of_vertices(), std::numeric_limits<int>::max());
    for (const auto b : m_mesh.vertices())
      if (m_mesh.is_border(b))
        for (const auto v : m_mesh.vertices())
          m_to_border[v] = (std::min)(m_to_border[v], m_distance[b][v]);
  }

  void refine(const PN::Any_scheme<>& scheme)
  {
    m_rows = Matrix(PN::subdivision_matrix(m_fine, scheme) * m_rows);
    PN::subdivide(m_fine, PN::linear(scheme), CGAL::parameters::number_of_iterations(1));
  }

  // the largest factor of all new edges within the first sector, away from the border
  double contraction() const
  {
    double largest = 0;
    for (const auto e : m_fine.edges()) {
      const auto a = m_fine.vertex(e, 0), b = m_fine.vertex(e, 1);
      if ((is_of_sector(a) || is_of_sector(b)) && is_inside(a) && is_inside(b))
        largest = (std::max)(largest, cost(a, b));
    }
    return largest;
  }

  // whatever is symmetric is looked at once
  double angle = 7;

private:
  bool is_of_sector(Mesh::Vertex_index v) const
  {
    const Point& p = m_fine.point(v);
    double turn = std::atan2(p.y(), p.x()) - .3;
    if (turn < -.1) turn += 2 * std::acos(-1.);
    return turn < angle;
  }

  // no vertex of the row has the rule of a border, nor is next to one that has
  bool is_inside(Mesh::Vertex_index v) const
  {
    if (m_borders_count) return true;
    for (Matrix::InnerIterator i(m_rows, v); i; ++i)
      if (m_to_border[std::size_t(i.col())] < 2) return false;
    return true;
  }

  double cost(Mesh::Vertex_index a, Mesh::Vertex_index b) const
  {
    const Eigen::SparseVector<double> difference =
      Eigen::SparseVector<double>(m_rows.row(a).transpose()) -
      Eigen::SparseVector<double>(m_rows.row(b).transpose());
    std::vector<std::size_t> from, to;
    std::vector<double> amounts, wanted;
    for (Eigen::SparseVector<double>::InnerIterator i(difference); i; ++i)
      if (i.value() > 1e-14) {
        from.push_back(std::size_t(i.index()));
        amounts.push_back(i.value());
      } else if (i.value() < -1e-14) {
        to.push_back(std::size_t(i.index()));
        wanted.push_back(-i.value());
      }
    std::vector<std::vector<double>> costs;
    for (std::size_t v : from) {
      costs.emplace_back();
      for (std::size_t w : to) costs.back().push_back(m_distance[v][w]);
    }
    return Transport(amounts, wanted, costs)();
  }

  Mesh m_mesh, m_fine;
  Matrix m_rows;
  std::vector<std::vector<int>> m_distance;
  std::vector<int> m_to_border;
  bool m_borders_count;
};

Mesh flat(const Layout& layout)
{
  Mesh mesh;
  for (const Place& p : layout.places) mesh.add_vertex(Point(p[0], p[1], 0));
  for (const auto& face : layout.faces) {
    std::vector<Mesh::Vertex_index> corners;
    for (std::size_t v : face) corners.emplace_back(Mesh::size_type(v));
    mesh.add_face(corners);
  }
  return mesh;
}

void print_scheme(const std::string& name, bool triangles, unsigned rounds)
{
  const PN::Any_scheme<> scheme = PN::any_scheme(name);
  std::vector<std::vector<double>> found(rounds);
  for (unsigned n : {3u, 4u, 5u, 6u, 7u, 8u, 12u}) {
    Mesh mesh = flat(sectors(triangles, n));
    if (!scheme.keeps_vertices()) // a face of n corners
      PN::subdivide(mesh, PN::linear(scheme), CGAL::parameters::number_of_iterations(1));
    Net net(mesh, false);
    net.angle = 2 * std::acos(-1.) / n + .1;
    for (unsigned r = 0; r < rounds; ++r) {
      net.refine(scheme);
      found[r].push_back(net.contraction());
    }
  }
  for (unsigned r = 0; r < rounds; ++r) {
    std::printf("<tr><td>%s</td><td>%u</td>", r == 0 ? name.c_str() : "", r + 1);
    for (double gamma : found[r]) std::printf("<td>%.2f</td>", gamma);
    std::puts("</tr>");
    std::fflush(stdout);
  }
}

void print_borders(const std::string& name, bool triangles)
{
  Net net(flat(grid(triangles)), true);
  std::printf("<tr><td>%s</td>", name.c_str());
  for (int r = 0; r < 2; ++r) {
    net.refine(PN::any_scheme(name));
    std::printf("<td>%.2f</td>", net.contraction());
  }
  std::puts("</tr>");
}

} // namespace

int main()
{
  std::puts("#table contraction");
  for (const char* name :
       {"catmull-clark", "modified-catmull-clark", "ct-catmull-clark", "kobbelt"})
    print_scheme(name, false, 2);
  print_scheme("doo-sabin", false, 3);
  for (const char* name : {"loop", "modified-loop", "ct-loop", "butterfly", "sqrt3"})
    print_scheme(name, true, 2);
  std::puts("#table contraction_borders");
  print_borders("catmull-clark", false);
  print_borders("loop", true);
}
