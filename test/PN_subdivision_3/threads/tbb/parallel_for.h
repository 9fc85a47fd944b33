// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the package and its tests use of TBB, by threads that are started and joined. For the thread sanitizer (preset
// tsan): it sees nothing of how a TBB that is compiled without it hands over work, and takes all of that for races.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_THREADS_TBB_PARALLEL_FOR_H
#define CGAL_PN_SUBDIVISION_3_TEST_THREADS_TBB_PARALLEL_FOR_H

#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {

struct task_group_context
{
  enum kind_type { isolated, bound };
  enum traits_type { default_traits = 0, fp_settings = 1 };
  task_group_context(kind_type, int) {}
};

namespace test {

// Keeps the first exception.
class Guarded
{
public:
  template <class Function>
  void operator()(const Function& f)
  {
    try {
      f();
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!exception_) exception_ = std::current_exception();
    }
  }
  void rethrow() const
  {
    if (exception_) std::rethrow_exception(exception_);
  }

private:
  std::mutex mutex_;
  std::exception_ptr exception_;
};

} // namespace test

template <class Index>
class blocked_range
{
public:
  blocked_range(Index begin, Index end)
    : begin_(begin)
    , end_(end)
  {}
  Index begin() const { return begin_; }
  Index end() const { return end_; }

private:
  Index begin_, end_;
};

// A thread for each of at most four parts; the calling thread waits.
template <class Index, class Body>
void parallel_for(const blocked_range<Index>& range, const Body& body, task_group_context&)
{
  const Index size = range.end() - range.begin(), parts = size < 4 ? size : 4;
  test::Guarded guarded;
  std::vector<std::thread> threads;
  for (Index i = 0; i < parts; ++i)
    threads.emplace_back([&, i] {
      guarded([&] {
        body(blocked_range<Index>(range.begin() + size * i / parts,
                                  range.begin() + size * (i + 1) / parts));
      });
    });
  for (std::thread& thread : threads) thread.join();
  guarded.rethrow();
}

template <class F, class G>
void parallel_invoke(const F& f, const G& g, task_group_context&)
{
  test::Guarded guarded;
  std::thread thread([&] { guarded(f); });
  guarded(g);
  thread.join();
  guarded.rethrow();
}

struct global_control
{
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t) {}
  ~global_control() {} // as a variable that is not used otherwise
};

struct task_arena
{
  explicit task_arena(int) {}
  template <class F>
  void execute(const F& f)
  {
    f();
  }
};

} // namespace tbb

#endif // CGAL_PN_SUBDIVISION_3_TEST_THREADS_TBB_PARALLEL_FOR_H
