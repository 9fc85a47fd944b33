// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_STORED_REFINEMENT_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_STORED_REFINEMENT_H

#include <CGAL/PN_subdivision_3/average/PN_average.h>
#include <CGAL/PN_subdivision_3/internal/average/input_checks.h>
#include <CGAL/PN_subdivision_3/internal/hosts/for_chunks.h>
#include <CGAL/PN_subdivision_3/internal/meshes/named_parameters.h>
#include <CGAL/PN_subdivision_3/internal/meshes/read_mesh.h>
#include <CGAL/PN_subdivision_3/internal/normals/Fan.h>
#include <CGAL/PN_subdivision_3/internal/normals/estimate_normals.h>
#include <CGAL/PN_subdivision_3/internal/package_parameters.h>
#include <CGAL/PN_subdivision_3/internal/rows/Stencil_block.h>
#include <CGAL/PN_subdivision_3/internal/schemes/scheme_of_call.h>
#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

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

// The values of the control vertices, and which vertices were set since the values were last taken.
template <class Average>
class Control_values
{
public:
  using Index = Level_connectivity::Index;
  using FT = typename Average::FT;
  using Value = typename Average::Value;
  using Vector = Coordinates<FT, 3>;

  static constexpr bool has_normals = has_normal_v<Value>;

  // Normals that are given for all slots, with their roundness; some normals tell of the tangents beside them. Or none.
  struct Given_slots
  {
    std::vector<Value> values;
    std::vector<bool> tell_of_tangents;

    std::size_t memory() const { return values.capacity() * sizeof(Value); }
  };

  // Where there are creases, it is up to them to estimate normals.
  template <class Access, class Point_map, class Normal_map>
  Control_values(const Access& access, const Level_connectivity& level, Point_map points,
                 Normal_map normals, Control_normal_estimate estimate, bool has_creases)
    : values_(has_creases
                ? read_given_values<Average>(access, points, normals, level.number_of_vertices())
                : read_values<Average>(access, level, points, normals, estimate))
    , is_changed_(values_.size(), true)
    , estimate_(estimate)
    , is_estimated_(has_normals && !is_there_v<Normal_map>)
    , is_near_overflow_(std::any_of(values_.begin(), values_.end(), [](const Value& v) {
      return internal::is_near_overflow(point_of(v));
    }))
  {
    if (is_estimated_) is_given_.assign(values_.size(), false);
  }

  std::size_t size() const { return values_.size(); }
  std::size_t memory() const
  {
    return values_.capacity() * sizeof(Value) + slots_.memory() +
           slots_without_fractions_.memory() + (is_changed_.capacity() + is_given_.capacity()) / 8;
  }
  const Value& operator[](std::size_t v) const { return values_[checked(v)]; }
  // whether one of the points is, or was, so far out that refined ones have to be looked at
  bool is_near_overflow() const { return is_near_overflow_; }

  void set_point(std::size_t v, const Vector& p)
  {
    check_finite<FT, 3>(p, "point", [&] { return name(v); });
    point_of(values_[checked(v)]) = p;
    is_near_overflow_ = is_near_overflow_ || internal::is_near_overflow(p);
    is_changed_[v] = true;
  }
  void set_normal(std::size_t v, Vector n)
  {
    check_finite<FT, 3>(n, "normal", [&] { return name(v); });
    if (has_several_normals(static_cast<Index>(checked(v))))
      throw std::invalid_argument("PN_subdivision_3: " + name(v) +
                                  " has a normal on each side of its creases, all of which are " +
                                  (slots_.values.empty() ? "estimated" : "given by its corners") +
                                  ": set the normals of its neighbors");
    normalize_control_normal<FT, 3>(n, [&] { return name(v); });
    values_[checked(v)].normal = n;
    if (is_estimated_) is_given_[v] = true;
    is_changed_[v] = true;
  }

  // estimates again what depends on what was set
  void update_estimate(const Level_connectivity& level)
  {
    if constexpr (has_normals) {
      if (!is_estimated_ || changes().empty()) return;
      std::vector<Value> estimated = values_;
      estimate_normals_of<FT>(level, estimate_, estimated, &is_given_);
      for (Index v = 0; v < values_.size(); ++v) {
        if (is_given_[v]) continue;
        if (has_given_roundness_) estimated[v].roundness = values_[v].roundness;
        if (values_[v].roundness == estimated[v].roundness &&
            values_[v].normal == estimated[v].normal)
          continue;
        values_[v] = estimated[v];
        is_changed_[v] = true;
      }
    }
  }

  // the roundness in place of the estimated roundness
  void set_roundness(const Given_roundness<FT>& given)
  {
    if constexpr (has_normals) {
      given.put(values_.size(), values_);
      has_given_roundness_ = given.is_any();
      is_roundness_of_estimate_ = given.is_of_estimate;
    }
  }
  // the roundness of an estimate counts where its normal does
  bool has_given_roundness(Index v) const
  {
    return has_given_roundness_ && (!is_roundness_of_estimate_ || is_given(v));
  }

  // \name Creases
  // Vertices between creases have several normals, one for each wedge, which are estimated, or given for all slots.
  bool is_given(Index v) const
  {
    return (!is_estimated_ || is_given_[v]) && !has_several_normals(v);
  }
  // the vertices are in the order of the numbers
  void set_vertices_with_several_normals(std::vector<Index> vertices)
  {
    several_normals_ = std::move(vertices);
    if constexpr (has_normals)
      for (const Index v : several_normals_) given_to_several_.push_back(values_[v].normal);
  }
  // the given normal of a vertex, even if its corners have several, for levels where it has one; null if there is none
  const Vector* given_normal(Index v) const
  {
    if (is_estimated_ && !is_given_[v]) return nullptr;
    const auto it = std::lower_bound(several_normals_.begin(), several_normals_.end(), v);
    if (it == several_normals_.end() || *it != v) return &values_[v].normal;
    return &given_to_several_[std::size_t(it - several_normals_.begin())];
  }
  void set_slots(Given_slots given)
  {
    is_estimated_ = false;
    is_given_.clear();
    for (Index v = 0; v < values_.size(); ++v) {
      values_[v].normal = given.values[v].normal;
      values_[v].roundness = given.values[v].roundness;
    }
    slots_ = std::move(given);
  }
  const Given_slots& given_slots() const { return slots_; }
  // of the mesh without edges whose sharpness is less than 1
  Given_slots& slots_without_fractions() { return slots_without_fractions_; }
  bool has_several_normals(Index v) const
  {
    return std::binary_search(several_normals_.begin(), several_normals_.end(), v);
  }
  void put_estimate(Index v, const Vector& n) { values_[v].normal = n; }

  // the changed vertices in the order of the numbers
  std::vector<Index> changes() const
  {
    std::vector<Index> result;
    for (Index v = 0; v < values_.size(); ++v)
      if (is_changed_[v]) result.push_back(v);
    return result;
  }
  void forget_changes() { is_changed_.assign(values_.size(), false); }
  void change_all() { is_changed_.assign(values_.size(), true); }

private:
  static std::string name(std::size_t v) { return "control vertex " + std::to_string(v); }

  std::size_t checked(std::size_t v) const
  {
    if (v >= values_.size())
      throw std::out_of_range("PN_subdivision_3: there is no control vertex " + std::to_string(v) +
                              ": the control mesh has " + std::to_string(values_.size()));
    return v;
  }

  std::vector<Value> values_;
  std::vector<bool> is_changed_;
  std::vector<bool> is_given_; // where normals are estimated
  std::vector<Index> several_normals_;
  std::vector<Vector> given_to_several_;
  Given_slots slots_, slots_without_fractions_;
  Control_normal_estimate estimate_;
  bool is_estimated_;
  bool is_near_overflow_;
  bool has_given_roundness_ = false, is_roundness_of_estimate_ = false;
};

// What a refiner keeps of a control mesh, a scheme and a number of rounds, so that other control values
// are refined without anything of the connectivity.
template <class Average>
class Stored_refinement
{
public:
  using Index = Level_connectivity::Index;
  using Value = typename Average::Value;
  // take refined values, from several threads if for_chunks calls from them
  using Sink = Function_ref<void(Index, const Value*, Index)>;
  using List_sink = Function_ref<void(const Index*, const Value*, Index)>;
  // takes (corner of the refined level, its value; none if it is that of the vertex)
  using Corner_sink = Function_ref<void(Index, const Value*)>;

  Stored_refinement(const Stored_refinement&) = delete;
  Stored_refinement& operator=(const Stored_refinement&) = delete;
  virtual ~Stored_refinement() = default;

  virtual Level_size refined_size() const = 0;
  virtual Level_connectivity refined_level() const = 0;

  // takes over what was set; returns what has changed by it, for evaluate_from()
  virtual std::vector<Index> take(Control_values<Average>& control) = 0;
  virtual void evaluate(Sink sink) = 0;
  // what this reaches; returns it, in the order of the numbers. The first such call finds out once what
  // reads what. Values were evaluated before.
  virtual std::vector<Index> evaluate_from(std::vector<Index> changed, List_sink sink) = 0;

  // calls the sink with the values of the last evaluation
  virtual void for_each_corner(const Level_connectivity& refined, Corner_sink sink) const = 0;

  // in bytes, without what the masks of a scheme may keep
  virtual std::size_t memory() const = 0;

protected:
  explicit Stored_refinement(const For_chunks& for_chunks)
    : for_chunks_(for_chunks)
  {}

  For_chunks for_chunks_;
};

// Finds the new vertices of a round whose rows read any of some old ones. Finds out in the first call what reads what:
// the rows of the round, transposed.
class Row_readers
{
public:
  using Index = Level_connectivity::Index;

  // finds the new vertices, in the order of the numbers
  template <class Round>
  std::vector<Index> operator()(const Round& round, std::size_t number_of_old_vertices,
                                const std::vector<Index>& old)
  {
    if (begin_.empty()) {
      is_marked_.assign(round.refined_size().vertices, 0);
      transpose(round, number_of_old_vertices);
    }
    std::vector<Index> readers;
    for (Index v : old)
      for (std::size_t i = begin_[v]; i < begin_[v + 1]; ++i) { // some come more than once
        const Index r = readers_[i];
        if (is_marked_[r] != 0) continue;
        is_marked_[r] = 1;
        readers.push_back(r);
      }
    // unless there are few, looking at all marks costs less than sorting
    if (readers.size() < is_marked_.size() / 256)
      std::sort(readers.begin(), readers.end());
    else
      collect_marks(readers);
    for (Index r : readers) is_marked_[r] = 0;
    return readers;
  }

  std::size_t memory() const
  {
    return begin_.capacity() * sizeof(std::size_t) + readers_.capacity() * sizeof(Index) +
           is_marked_.size();
  }

private:
  template <class Round>
  void transpose(const Round& round, std::size_t number_of_old_vertices)
  {
    std::vector<std::size_t> begin(number_of_old_vertices + 1, 0);
    const auto n = static_cast<Index>(is_marked_.size());
    Stencil_block<typename Round::FT> buffer;
    for (Index r = 0; r < n; ++r) round.for_each_entry(r, buffer, [&](Index v) { ++begin[v + 1]; });
    for (std::size_t v = 0; v < number_of_old_vertices; ++v) begin[v + 1] += begin[v];
    // while the lists are filled, the end of each is where it begins
    readers_.resize(begin.back());
    for (Index r = n; r-- > 0;)
      round.for_each_entry(r, buffer, [&](Index v) { readers_[--begin[v + 1]] = r; });
    begin.erase(begin.begin());
    begin.push_back(readers_.size());
    begin_ = std::move(begin);
  }

  void collect_marks(std::vector<Index>& marked) const
  {
    auto end = marked.begin();
    const char* const marks = is_marked_.data();
    const char* const last = marks + is_marked_.size();
    for (const char* m = marks; (m = std::find(m, last, 1)) != last; ++m)
      *end++ = static_cast<Index>(m - marks);
  }

  std::vector<std::size_t> begin_; // of the readers of each old vertex
  std::vector<Index> readers_;
  std::vector<char> is_marked_; // of each new vertex; false between two calls
};

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_REFINER_STORED_REFINEMENT_H
