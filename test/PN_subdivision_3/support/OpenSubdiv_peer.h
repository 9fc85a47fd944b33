// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Control meshes as OpenSubdiv takes them.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_OPENSUBDIV_PEER_H
#define CGAL_PN_SUBDIVISION_3_TEST_OPENSUBDIV_PEER_H

#include "Random_creases.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <set>

namespace opensubdiv_peer {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;
using namespace random_creases;

struct Peer_point
{
  Triple x{0, 0, 0};

  void Clear(void* = nullptr) { x = {0, 0, 0}; }
  template <class Weight>
  void AddWithWeight(const Peer_point& p, Weight w)
  {
    for (std::size_t k = 0; k < 3; ++k) x[k] += double(w) * p.x[k];
  }
};

// the values of the corners of all faces, by their numbers, and the rule that they are refined by
struct Peer_channel
{
  std::vector<int> of_corners;
  int number_of_values = 0;
  Sdc::Options::FVarLinearInterpolation rule = Sdc::Options::FVAR_LINEAR_CORNERS_PLUS1;
};

inline std::unique_ptr<Far::TopologyRefiner>
make_peer(const Control& control, Sdc::SchemeType scheme, const Peer_channel* channel = nullptr)
{
  std::vector<int> degrees, corners, crease_vertices, corner_vertices;
  std::vector<float> crease_weights, corner_weights;
  const auto weight = [](double s) {
    return s == infinity ? Sdc::Crease::SHARPNESS_INFINITE : float(s);
  };
  for (const Face& f : control.faces) {
    degrees.push_back(int(f.size()));
    corners.insert(corners.end(), f.begin(), f.end());
  }
  for (const auto& [e, s] : control.sharp_edges) {
    crease_vertices.push_back(e.first);
    crease_vertices.push_back(e.second);
    crease_weights.push_back(weight(s));
  }
  for (const auto& [v, s] : control.sharp_vertices) {
    corner_vertices.push_back(v);
    corner_weights.push_back(weight(s));
  }
  Far::TopologyDescriptor d;
  d.numVertices = int(control.points.size());
  d.numFaces = int(control.faces.size());
  d.numVertsPerFace = degrees.data();
  d.vertIndicesPerFace = corners.data();
  d.numCreases = int(crease_weights.size());
  d.creaseVertexIndexPairs = crease_vertices.data();
  d.creaseWeights = crease_weights.data();
  d.numCorners = int(corner_weights.size());
  d.cornerVertexIndices = corner_vertices.data();
  d.cornerWeights = corner_weights.data();
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(control.border == Border::corners
                                        ? Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                        : Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  options.SetCreasingMethod(Sdc::Options::CREASE_UNIFORM);
  Far::TopologyDescriptor::FVarChannel peer_channel;
  if (channel != nullptr) {
    options.SetFVarLinearInterpolation(channel->rule);
    peer_channel.numValues = channel->number_of_values;
    peer_channel.valueIndices = channel->of_corners.data();
    d.numFVarChannels = 1;
    d.fvarChannels = &peer_channel;
  }
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  return std::unique_ptr<Far::TopologyRefiner>(
    Factory::Create(d, Factory::Options(scheme, options)));
}

// the peer's face with these vertices, which are among those of edges of it
inline int face_of(const Far::TopologyLevel& level, const std::vector<int>& vertices)
{
  std::set<int> common;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const int e = level.FindEdge(vertices[i], vertices[(i + 1) % vertices.size()]);
    const auto faces = level.GetEdgeFaces(e);
    std::set<int> these;
    for (int k = 0; k < faces.size(); ++k)
      if (i == 0 || common.count(faces[k]) != 0) these.insert(faces[k]);
    common = these;
  }
  return common.size() == 1 ? *common.begin() : -1;
}

} // namespace opensubdiv_peer

#endif // CGAL_PN_SUBDIVISION_3_TEST_OPENSUBDIV_PEER_H
