// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_FOR_CHUNKS_H
#define CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_FOR_CHUNKS_H

#include <CGAL/PN_subdivision_3/levels/Level_connectivity.h>
#include <CGAL/PN_subdivision_3/numbers/Unit_normal_traits.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/blocked_range.h>
#  include <tbb/parallel_for.h>
#  include <tbb/parallel_invoke.h>
#  include <tbb/task_group.h>
#endif

#include <type_traits>

namespace CGAL::PN_subdivision_3::internal {

// Any function object by reference, for the time of a call. What takes it is instantiated once for
// all function objects. Used where a call does the work of many elements, so that the jump costs nothing.
template <class Signature>
class Function_ref;

template <class Result, class... Arguments>
class Function_ref<Result(Arguments...)>
{
public:
  template <class Function,
            class = std::enable_if_t<!std::is_same_v<std::decay_t<Function>, Function_ref>>>
  Function_ref(const Function& f)
    : function_(&f)
    , call_([](const void* function, Arguments... arguments) -> Result {
      return static_cast<Result>((*static_cast<const Function*>(function))(arguments...));
    })
  {}

  Result operator()(Arguments... arguments) const { return call_(function_, arguments...); }

private:
  const void* function_;
  Result (*call_)(const void*, Arguments...);
};

template <class Concurrency_tag>
constexpr bool is_parallel_v = std::is_convertible_v<Concurrency_tag, Parallel_tag>;

#ifdef CGAL_LINKED_WITH_TBB
// isolated: a cancelled task group around it would leave elements undefined
constexpr auto task_kind = tbb::task_group_context::isolated;
// the workers round as the caller does: intervals rely on it
constexpr auto task_traits =
  tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings;
#endif

// The precision that new numbers of a multiprecision type get is a setting of the thread: what
// computes for a caller takes over the caller's, and gives the thread its own back.
template <class FT, bool = Has_default_precision<FT>::value>
class Caller_precision
{
public:
  struct In_this_thread
  {
    explicit In_this_thread(const Caller_precision&) {}
    ~In_this_thread() {} // NOLINT(modernize-use-equals-default): used, as far as compilers warn
  };
};

template <class FT>
class Caller_precision<FT, true>
{
public:
  class In_this_thread
  {
  public:
    explicit In_this_thread(const Caller_precision& caller)
      : own_(FT::set_default_precision(caller.precision_))
    {}
    ~In_this_thread() { FT::set_default_precision(own_); }
    In_this_thread(const In_this_thread&) = delete;
    In_this_thread& operator=(const In_this_thread&) = delete;

  private:
    decltype(FT::get_default_precision()) own_;
  };

private:
  decltype(FT::get_default_precision()) precision_ = FT::get_default_precision();
};

// Calls f(begin, end) for pieces that cover [0, n), in this thread or in several. Every element has
// one owner, so that the result does not depend on the pieces nor on the number of threads. The class is the same with TBB and
// without, so that libraries serve both.
class For_chunks
{
public:
  using Index = Level_connectivity::Index;
  using Function = Function_ref<void(Index, Index)>;

  For_chunks() = default;

  template <class Concurrency_tag>
  static For_chunks with(Concurrency_tag);

  void operator()(Index n, Function f) const { run_(n, f); }
  // where new numbers get the caller's precision
  template <class FT>
  void in_precision(Index n, Function f) const
  {
    const Caller_precision<FT> precision;
    run_(n, [&](Index begin, Index end) {
      const typename Caller_precision<FT>::In_this_thread scope(precision);
      f(begin, end);
    });
  }
  bool has_threads() const { return run_ != &run; }

private:
  static void run(Index n, Function f)
  {
    if (n != 0) f(0, n);
  }

  void (*run_)(Index, Function) = &run;
};

#ifdef CGAL_LINKED_WITH_TBB
template <int = 0> // compiled where it is used only
void run_in_parallel(For_chunks::Index n, For_chunks::Function f)
{
  using Index = For_chunks::Index;
  constexpr Index grain = 2048; // a multiple of the block of the averages
  const Index chunks = n / grain + (n % grain != 0);
  tbb::task_group_context context(task_kind, task_traits);
  const auto do_chunks = [&](const auto& range) {
    f(range.begin() * grain, range.end() == chunks ? n : range.end() * grain);
  };
  tbb::parallel_for(tbb::blocked_range<Index>(0, chunks), do_chunks, context);
}
#endif

template <class Concurrency_tag>
For_chunks For_chunks::with(Concurrency_tag)
{
  static_assert(std::is_convertible_v<Concurrency_tag, Sequential_tag> ||
                  is_parallel_v<Concurrency_tag>,
                "PN_subdivision_3: the concurrency tag is Sequential_tag, Parallel_tag or "
                "Parallel_if_available_tag");
  For_chunks for_chunks;
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel_v<Concurrency_tag>) for_chunks.run_ = &run_in_parallel<>;
#else
  static_assert(
    !is_parallel_v<Concurrency_tag>,
    "PN_subdivision_3: Parallel_tag needs TBB: link CGAL::PN_subdivision_3_TBB, or take "
    "Parallel_if_available_tag");
#endif
  return for_chunks;
}

// Calls f() and g(), which do not touch the same data, in any order or at the same time; f() in the
// calling thread: memory that a mesh gets from another thread's arena costs page faults in every call.
template <class Concurrency_tag>
void run_together(Function_ref<void()> f, Function_ref<void()> g)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel_v<Concurrency_tag>) {
    tbb::task_group_context context(task_kind, task_traits);
    tbb::parallel_invoke(g, f, context); // the last one is not spawned
    return;
  }
#endif
  g();
  f();
}

} // namespace CGAL::PN_subdivision_3::internal

#endif // CGAL_PN_SUBDIVISION_3_INTERNAL_HOSTS_FOR_CHUNKS_H
