// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CONTROL_VERTICES_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CONTROL_VERTICES_H

#include <CGAL/PN_subdivision_3/internal/own_parameters.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <unordered_map>

namespace CGAL::PN_subdivision_3::internal {

// Where the vertices of a mesh come in their order, by their indices; it outlives the mesh.
template <class Mesh>
class Control_vertices
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Index = Level_connectivity::Index;

public:
  Control_vertices() = default;

  template <class NamedParameters>
  Control_vertices(const Mesh& mesh, const NamedParameters& np)
  {
    const auto map = [&] {
      if constexpr (is_given_v<CGAL::internal_np::vertex_index_t, NamedParameters>)
        return CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_index);
      else
        return get_initialized_vertex_index_map(mesh);
    }();
    index_ = [map](Vertex v) { return static_cast<long long>(get(map, v)); };
    for (const Vertex v : vertices(mesh)) {
      const long long index = index_(v);
      if (index < 0)
        throw std::invalid_argument(
          "PN_subdivision_3: an index in the vertex_index_map is negative");
      if (index != static_cast<long long>(size_)) is_order_ = false;
      ++size_;
    }
    if (is_order_) return;
    Index position = 0;
    for (const Vertex v : vertices(mesh))
      if (!positions_.emplace(index_(v), position++).second)
        throw std::invalid_argument("PN_subdivision_3: two vertices have the same index in the "
                                    "vertex_index_map");
  }

  std::size_t position(Vertex v) const
  {
    const long long index = index_ ? index_(v) : -1;
    if (is_order_ && index >= 0 && index < static_cast<long long>(size_))
      return static_cast<std::size_t>(index);
    const auto found = positions_.find(index);
    if (found == positions_.end())
      throw std::out_of_range("PN_subdivision_3: the control mesh has no such vertex");
    return found->second;
  }

  std::size_t memory() const { return positions_.size() * (sizeof(long long) + 3 * sizeof(void*)); }

private:
  std::function<long long(Vertex)> index_;
  std::unordered_map<long long, Index> positions_; // unless the indices are the order
  std::size_t size_ = 0;
  bool is_order_ = true;
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_MESHES_CONTROL_VERTICES_H
