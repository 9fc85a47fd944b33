// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Output_file.h"

#include "io/Error.h"

#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <iterator>
#include <random>
#include <system_error>

#if __has_include(<unistd.h>)
#  include <unistd.h>
#endif

namespace fs = std::filesystem;

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
  std::memcpy(file + length, "/piece_", 8);
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

constexpr std::size_t buffer_size = 1 << 20;

// An old file that may not be changed is not replaced either.
void require_changeable(const fs::path& file)
{
  std::FILE* f = std::fopen(file.string().c_str(), "r+b");
  if (f == nullptr) throw Error("cannot be written: " + reason(errno));
  std::fclose(f);
}

// What a link, or a chain of links, leads to, whether it is there or not.
fs::path real_target(fs::path file)
{
  constexpr int longest_chain = 40; // as in Linux
  std::error_code error;
  for (int i = 0; i < longest_chain; ++i) {
    if (!fs::is_symlink(file, error)) return file;
    const fs::path next = fs::read_symlink(file, error);
    if (error) throw Error("this link cannot be read: " + error.message());
    file = next.is_absolute() ? next : file.parent_path() / next;
  }
  throw Error("this link leads to itself");
}

fs::file_status checked_status(const fs::path& target)
{
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) throw Error("this is a directory, not a file to be written");
  if (fs::is_regular_file(status)) require_changeable(target);
  const fs::path folder = target.parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error))
    throw Error("cannot be written: there is no folder " + folder.string());
  return status;
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

void Output_file::check(const std::string& file)
{
  if (file != "-") checked_status(real_target(file));
}

fs::path Output_file::regular_target(const std::string& file)
{
  fs::path target = real_target(file);
  const fs::file_status status = checked_status(target);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw Error("this is no file into which pieces can be written at their places");
  return target;
}

Output_file::Output_file()
{
  buffer_.reserve(buffer_size + 64);
}

// Made complete first, so that whatever is thrown from here on finds the destructor.
Output_file::Output_file(const std::string& file)
  : Output_file()
{
  fs::file_status status;
  if (file != "-") {
    target_ = real_target(file);
    status = checked_status(target_);
  }
  const bool is_replaceable = !fs::exists(status) || fs::is_regular_file(status);
  if (file == "-" || !is_replaceable) {
    file_ = std::tmpfile();
    if (file_ == nullptr) throw Error("no temporary file can be made: " + reason(errno));
    return;
  }
  open_temporary();
  std::error_code ignored;
  if (fs::is_regular_file(status)) fs::permissions(temporary_, status.permissions(), ignored);
}

Output_file::Output_file(const std::string& file, In_temporary_folder)
  : Output_file()
{
  target_ = file;
  file_ = std::fopen(file.c_str(), "wb");
  if (file_ == nullptr) throw Error("cannot be written: " + reason(errno));
  temporary_ = target_;
}

Output_file::~Output_file()
{
  if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void Output_file::open_temporary()
{
  std::random_device random;
  for (int attempt = 0; attempt < 100; ++attempt) {
    const std::string name = ".pn_subdivide-" + std::to_string(random()) + ".tmp";
    fs::path temporary = target_.parent_path() / name;
    const std::string path = temporary.string();
    removal_ = std::make_unique<Temporary_on_signal>(path);
    file_ = std::fopen(path.c_str(), "wbx"); // x: never opens an existing file
    if (file_ != nullptr) {
      temporary_.swap(temporary); // which cannot fail
      return;
    }
    const int error = errno;
    removal_.reset();
    if (error != EEXIST)
      throw Error("cannot be written, no file can be made in its folder: " + reason(error));
  }
  throw Error("cannot be written: no name for a new file is free in its folder");
}

void Output_file::text(std::string_view s)
{
  buffer_.append(s);
  if (buffer_.size() >= buffer_size) flush();
}

void Output_file::number(double x)
{
  char digits[40];
  const auto end =
    std::to_chars(digits, digits + sizeof(digits), x, std::chars_format::general, 17).ptr;
  text(std::string_view(digits, static_cast<std::size_t>(end - digits)));
}

void Output_file::number(std::uint64_t n)
{
  char digits[24];
  const auto end = std::to_chars(digits, digits + sizeof(digits), n).ptr;
  text(std::string_view(digits, static_cast<std::size_t>(end - digits)));
}

void Output_file::flush()
{
  if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size())
    throw Error("writing failed: " + reason(errno));
  buffer_.clear();
}

void Output_file::close()
{
  std::FILE* file = file_;
  file_ = nullptr;
  const bool flushed = std::fflush(file) == 0;
  const int error = errno;
  const bool closed = std::fclose(file) == 0;
  if (!flushed || !closed) throw Error("writing failed: " + reason(flushed ? errno : error));
}

void Output_file::pass_on()
{
  std::FILE* const collected = file_;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> closed_later(collected, std::fclose);
  file_ = nullptr;
  if (std::fflush(collected) != 0) throw Error("writing failed: " + reason(errno));
  std::rewind(collected);
  const bool is_standard_output = target_.empty();
  file_ = is_standard_output ? stdout : std::fopen(target_.string().c_str(), "wb");
  if (file_ == nullptr) throw Error("cannot be written: " + reason(errno));

  buffer_.resize(buffer_size);
  while (const std::size_t n = std::fread(&buffer_[0], 1, buffer_size, collected))
    if (std::fwrite(buffer_.data(), 1, n, file_) != n)
      throw Error("writing failed: " + reason(errno));
  if (std::ferror(collected)) throw Error("writing failed: the collected file cannot be read back");
  if (!is_standard_output) return close();
  file_ = nullptr;
  if (std::fflush(stdout) != 0) throw Error("writing failed: " + reason(errno));
}

void Output_file::commit()
{
  flush();
  if (temporary_.empty()) return pass_on();
  close();

  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) throw Error("cannot be replaced: " + error.message());
  temporary_.clear();
  removal_.reset();
}

} // namespace pn_subdivide
