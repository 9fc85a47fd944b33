// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The floor: no job that makes a new mesh can take less than writing its bytes to memory that the
// system has just handed out. Beside it the same to memory that has been written before.

#include "Job.h"
#include "for_each_scheme.h"

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>

#include <sys/mman.h>

#include <cstddef>
#include <cstring>
#include <deque>
#include <new>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace PN = CGAL::PN_subdivision_3;

PN::Level_size size_of(const Control& control)
{
  std::set<std::pair<int, int>> edges;
  PN::Level_size size;
  size.vertices = control.points.size();
  size.faces = control.faces.size();
  for (const std::vector<int>& f : control.faces) {
    size.corners += f.size();
    for (std::size_t i = 0; i < f.size(); ++i) {
      const int a = f[i], b = f[(i + 1) % f.size()];
      edges.emplace(a < b ? a : b, a < b ? b : a);
    }
  }
  size.edges = edges.size();
  return size;
}

// the arrays of a Surface_mesh with normals, but for the bits of removed elements
std::vector<std::size_t> bytes_of_arrays(const PN::Level_size& size)
{
  return {24 * size.vertices, 24 * size.vertices, 4 * size.vertices, 16 * size.halfedges(),
          4 * size.faces};
}

// pages that nobody has touched
class Fresh_memory
{
public:
  explicit Fresh_memory(std::size_t bytes)
    : bytes_(bytes)
    , begin_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))
  {
    if (begin_ == MAP_FAILED) throw std::bad_alloc();
  }
  ~Fresh_memory() { munmap(begin_, bytes_); }
  Fresh_memory(const Fresh_memory&) = delete;
  Fresh_memory& operator=(const Fresh_memory&) = delete;

  void write() const { std::memset(begin_, 1, bytes_); }

private:
  std::size_t bytes_;
  void* begin_;
};

template <class Scheme>
Result write(const Control& control, unsigned rounds, bool is_fresh)
{
  PN::Level_size size = size_of(control);
  for (unsigned k = 1; k <= rounds; ++k) size = Scheme::Host::refined_size(size, k);
  std::deque<Fresh_memory> arrays;
  for (const std::size_t bytes : bytes_of_arrays(size)) arrays.emplace_back(bytes);
  const auto write_all = [&] {
    for (const Fresh_memory& array : arrays) array.write();
  };
  if (!is_fresh) write_all();
  Result result = timed(write_all);
  result.faces = size.faces;
  return result;
}

} // namespace

void add_floor(Jobs& jobs)
{
  for_each_scheme([&](const std::string& name, const auto& scheme) {
    using Scheme = std::decay_t<decltype(scheme)>;
    for (const bool is_fresh : {true, false})
      jobs[std::string("floor/") + (is_fresh ? "fresh" : "again") + "/" + name] =
        [is_fresh](const Control& control, unsigned rounds, unsigned) {
          return write<Scheme>(control, rounds, is_fresh);
        };
  });
}
