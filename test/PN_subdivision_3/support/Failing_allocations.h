// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Allocations of a program that can be told to fail. To be included in one source file of a program: it replaces
// the global operators new and delete.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_FAILING_ALLOCATIONS_H
#define CGAL_PN_SUBDIVISION_3_TEST_FAILING_ALLOCATIONS_H

#include <boost/config.hpp>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

namespace failing_allocations {

inline std::atomic<long> allocations_left{std::numeric_limits<long>::max()};

// lets the k-th allocation of its lifetime fail, and all that follow
struct Allocation_limit
{
  explicit Allocation_limit(long k) { allocations_left = k - 1; }
  ~Allocation_limit() { allocations_left = std::numeric_limits<long>::max(); }
  Allocation_limit(const Allocation_limit&) = delete;
  Allocation_limit& operator=(const Allocation_limit&) = delete;
};

inline void* allocate(std::size_t size)
{
  if (allocations_left.fetch_sub(1) <= 0) throw std::bad_alloc();
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}

inline void* allocate(std::size_t size, std::align_val_t alignment)
{
  if (allocations_left.fetch_sub(1) <= 0) throw std::bad_alloc();
  const auto a = static_cast<std::size_t>(alignment);
  if (void* p = std::aligned_alloc(a, (size + a - 1) / a * a)) return p;
  throw std::bad_alloc();
}

} // namespace failing_allocations

BOOST_NOINLINE void* operator new(std::size_t size)
{
  return failing_allocations::allocate(size);
}
BOOST_NOINLINE void* operator new[](std::size_t size)
{
  return failing_allocations::allocate(size);
}
// as the standard library's: std::stable_sort() asks for them, and sanitizers have their own
BOOST_NOINLINE void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  try {
    return failing_allocations::allocate(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
BOOST_NOINLINE void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept
{
  return operator new(size, tag);
}
BOOST_NOINLINE void* operator new(std::size_t size, std::align_val_t alignment)
{
  return failing_allocations::allocate(size, alignment);
}
BOOST_NOINLINE void* operator new[](std::size_t size, std::align_val_t alignment)
{
  return failing_allocations::allocate(size, alignment);
}
BOOST_NOINLINE void operator delete(void* p) noexcept
{
  std::free(p);
}
BOOST_NOINLINE void operator delete[](void* p) noexcept
{
  std::free(p);
}
BOOST_NOINLINE void operator delete(void* p, std::size_t) noexcept
{
  std::free(p);
}
BOOST_NOINLINE void operator delete[](void* p, std::size_t) noexcept
{
  std::free(p);
}
BOOST_NOINLINE void operator delete(void* p, std::align_val_t) noexcept
{
  std::free(p);
}
BOOST_NOINLINE void operator delete[](void* p, std::align_val_t) noexcept
{
  std::free(p);
}
BOOST_NOINLINE void operator delete(void* p, std::size_t, std::align_val_t) noexcept
{
  std::free(p);
}
BOOST_NOINLINE void operator delete[](void* p, std::size_t, std::align_val_t) noexcept
{
  std::free(p);
}

#endif // CGAL_PN_SUBDIVISION_3_TEST_FAILING_ALLOCATIONS_H
