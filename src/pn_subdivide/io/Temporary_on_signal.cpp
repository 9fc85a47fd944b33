// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Temporary_on_signal.h"

#include "io/Error.h"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iterator>

#if __has_include(<unistd.h>)
#  include <unistd.h>
#endif

namespace pn_subdivide {
namespace {

// The handler may touch lock-free atomics and call functions that are safe in signals, so the names
// lie in fixed memory.
struct Slot
{
  char file[4096];
  std::atomic<bool> is_used{false};
};
Slot slots[4];

extern "C" void remove_temporaries(int signal)
{
  for (Slot& slot : slots)
    if (slot.is_used.load()) {
#if __has_include(<unistd.h>)
      ::unlink(slot.file);
#else
      std::remove(slot.file);
#endif
    }
  std::signal(signal, SIG_DFL);
  std::raise(signal); // ends the program in the way that the caller expects
}

void install_handlers()
{
  const int signals[] = {SIGINT, SIGTERM,
#ifdef SIGHUP
                         SIGHUP, SIGPIPE, SIGQUIT,
#endif
#ifdef SIGXCPU
                         SIGXCPU
#endif
  };
  for (const int signal : signals)
    if (std::signal(signal, remove_temporaries) == SIG_IGN) std::signal(signal, SIG_IGN);
}

} // namespace

Temporary_on_signal::Temporary_on_signal(const std::string& file)
{
  static const bool installed = (install_handlers(), true);
  (void)installed;
  if (file.size() >= sizeof(Slot::file)) throw Error("cannot be written: the path is too long");
  for (slot_ = 0; slot_ < std::size(slots); ++slot_)
    if (!slots[slot_].is_used) {
      std::memcpy(slots[slot_].file, file.c_str(), file.size() + 1);
      slots[slot_].is_used = true;
      return;
    }
  throw Error("too many files are being written at once");
}

Temporary_on_signal::~Temporary_on_signal()
{
  slots[slot_].is_used = false;
}

} // namespace pn_subdivide
