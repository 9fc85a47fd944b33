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
  std::size_t pieces; // files in it if it is a folder, otherwise 0
  std::atomic<bool> is_used{false};
};
Slot slots[4];

// All of it may be called in the handler of a signal.
void remove_file(const char* file)
{
#if __has_include(<unistd.h>)
  ::unlink(file);
#else
  std::remove(file);
#endif
}

void remove_folder(const Slot& slot)
{
  static char file[sizeof slot.file + 40];
  const std::size_t length = std::strlen(slot.file);
  std::memcpy(file, slot.file, length); // NOLINT(bugprone-not-null-terminated-result): more follows
  std::memcpy(file + length, "/piece_", 7);
  for (std::size_t i = 0; i < slot.pieces; ++i) {
    char* end = file + length + 7;
    std::size_t divisor = 1;
    while (i / divisor >= 10) divisor *= 10;
    for (; divisor > 0; divisor /= 10) *end++ = static_cast<char>('0' + i / divisor % 10);
    std::memcpy(end, ".vtp", 5);
    remove_file(file);
  }
#if __has_include(<unistd.h>)
  ::rmdir(slot.file);
#endif
}

extern "C" void remove_temporaries(int signal)
{
  for (const Slot& slot : slots)
    if (slot.is_used.load() && slot.pieces == 0) remove_file(slot.file);
  for (const Slot& slot : slots)
    if (slot.is_used.load() && slot.pieces != 0) remove_folder(slot);
  std::signal(signal, SIG_DFL);
  std::raise(signal); // ends the program in the way that the caller expects
}

const int signals[] = {SIGINT, SIGTERM,
#ifdef SIGHUP
                       SIGHUP, SIGPIPE, SIGQUIT,
#endif
#ifdef SIGXCPU
                       SIGXCPU
#endif
};
bool was_ignored[std::size(signals)];

// A library may have a handler of its own before main() begins (UCX, which Open MPI loads, has one for SIGHUP): what
// the caller wants ignored is looked up before libraries are initialized, where that is possible.
void note_ignored_signals()
{
  for (std::size_t i = 0; i < std::size(signals); ++i) {
    const auto handler = std::signal(signals[i], SIG_IGN);
    if (handler == SIG_IGN)
      was_ignored[i] = true;
    else if (handler != SIG_ERR)
      std::signal(signals[i], handler);
  }
}
#if defined(__linux__) && defined(__ELF__)
[[gnu::section(".preinit_array"),
  gnu::used]] void (*const before_libraries)() = note_ignored_signals;
#endif

void install_handlers()
{
  note_ignored_signals();
  for (std::size_t i = 0; i < std::size(signals); ++i)
    std::signal(signals[i], was_ignored[i] ? SIG_IGN : remove_temporaries);
}

} // namespace

Temporary_on_signal::Temporary_on_signal(const std::string& file, std::size_t pieces)
{
  static const bool installed = (install_handlers(), true);
  (void)installed;
  if (file.size() >= sizeof(Slot::file)) throw Error("cannot be written: the path is too long");
  for (slot_ = 0; slot_ < std::size(slots); ++slot_)
    if (!slots[slot_].is_used) {
      std::memcpy(slots[slot_].file, file.c_str(), file.size() + 1);
      slots[slot_].pieces = pieces;
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
