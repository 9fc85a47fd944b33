// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The linear schemes with creases are those of OpenSubdiv.

#include "Random_creases.h"

#include <gtest/gtest.h>

#ifdef PN_TEST_WITH_OPENSUBDIV

#  include "OpenSubdiv_peer.h"

#  include <CGAL/PN_subdivision_3/scheme_parts/scheme_adaptors.h>
#  include <CGAL/PN_subdivision_3/schemes/Loop_scheme.h>

namespace {

using namespace opensubdiv_peer;

// the greatest difference of coordinates in all levels
template <class Scheme>
double greatest_difference(const Control& control, const Scheme& scheme,
                           Sdc::SchemeType peer_scheme, int rounds)
{
  const auto peer = make_peer(control, peer_scheme);
  peer->RefineUniform(Far::TopologyRefiner::UniformOptions(rounds));
  const Far::PrimvarRefinerReal<double> refiner(*peer);
  std::vector<Peer_point> points;
  for (const Triple& p : control.points) points.push_back({p});
  std::vector<int> in_peer; // of our vertices
  for (int v = 0; v < int(points.size()); ++v) in_peer.push_back(v);

  Crease_run<double, Linear_scheme<Scheme>> run(control, linear(scheme));
  double greatest = 0;
  for (int k = 1; k <= rounds; ++k) {
    const Far::TopologyLevel& old = peer->GetLevel(k - 1);
    const Level_connectivity& level = run.level();
    std::vector<int> child;
    for (const int v : in_peer) child.push_back(old.GetVertexChildVertex(v));
    for (Index e = 0; e < level.number_of_edges(); ++e)
      child.push_back(old.GetEdgeChildVertex(
        old.FindEdge(in_peer[level.source(2 * e)], in_peer[level.target(2 * e)])));
    if (peer_scheme == Sdc::SCHEME_CATMARK)
      for (Index f = 0; f < level.number_of_faces(); ++f) {
        std::vector<int> vertices;
        const Index first = level.halfedge_of_face(f);
        Index h = first;
        do {
          vertices.push_back(in_peer[level.target(h)]);
          h = level.next(h);
        } while (h != first);
        child.push_back(old.GetFaceChildVertex(face_of(old, vertices)));
      }
    std::vector<Peer_point> refined(std::size_t(peer->GetLevel(k).GetNumVertices()));
    refiner.Interpolate(k, points, refined);
    points = refined;
    in_peer = child;
    run.refine();
    for (Index v = 0; v < run.level().number_of_vertices(); ++v)
      for (std::size_t c = 0; c < 3; ++c) {
        const double d = std::abs(run.point(v)[c] - points[std::size_t(in_peer[v])].x[c]);
        if (!(d <= greatest)) greatest = d;
      }
  }
  return greatest;
}

void expect_equal(Control (*shape)(), Border border, const std::vector<double>& sharpness,
                  double bar)
{
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    Control c = shape();
    c.border = border;
    perturb(c, random);
    tag(c, random, 0.2, sharpness);
    EXPECT_LE(greatest_difference(c, CatmullClark_scheme(), Sdc::SCHEME_CATMARK, 4), bar) << seed;
    EXPECT_LE(greatest_difference(triangulated(c), Loop_scheme(), Sdc::SCHEME_LOOP, 4), bar)
      << seed;
  }
}

TEST(OpenSubdiv, Sharp)
{
  expect_equal(box, Border::surface, {infinity}, 1e-13);
  expect_equal(patch, Border::surface, {infinity}, 1e-13);
  expect_equal(patch, Border::curve, {infinity}, 1e-13);
  expect_equal(patch, Border::corners, {infinity}, 1e-13);
}

// the peer's fractions are single precision
TEST(OpenSubdiv, Semi_sharp)
{
  const std::vector<double> sharpness{0.25, 0.5, 0.8, 1, 1.5, 2, 2.3, infinity};
  expect_equal(box, Border::surface, sharpness, 1e-6);
  expect_equal(patch, Border::surface, sharpness, 1e-6);
  expect_equal(patch, Border::corners, sharpness, 1e-6);
}

} // namespace

#else

TEST(OpenSubdiv, Sharp)
{
  GTEST_SKIP() << "left out: OpenSubdiv not found (Debian package libosd-dev)";
}

#endif
