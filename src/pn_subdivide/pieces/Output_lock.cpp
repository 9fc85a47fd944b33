// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Output_lock.h"

#include "io/Error.h"

#include <cerrno>
#include <chrono>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#if __has_include(<unistd.h>)
#  include <csignal>
#  include <fcntl.h>
#  include <sys/stat.h>
#  include <unistd.h>
#endif

namespace fs = std::filesystem;

namespace pn_subdivide {

#if __has_include(<unistd.h>)

namespace {

const std::string content = "pn_subdivide lock\n";

// of the whole file; false if another process has it
bool lock(int descriptor, bool waits)
{
  struct flock whole = {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  while (::fcntl(descriptor, waits ? F_SETLKW : F_SETLK, &whole) != 0) {
    if (errno == EACCES || errno == EAGAIN) return false;
    if (errno != EINTR) return true; // a file system without locks has to do without
  }
  return true;
}

bool is_file_of_that_name(int descriptor, const fs::path& file)
{
  struct stat opened, named;
  return ::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

// until the file is known to the handler of signals, which removes it
class Signals_wait
{
public:
  Signals_wait()
  {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~Signals_wait() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  Signals_wait(const Signals_wait&) = delete;
  Signals_wait& operator=(const Signals_wait&) = delete;

private:
  sigset_t before_;
};

[[noreturn]] void fail(const fs::path& file)
{
  throw Error(file.string() + " cannot be made: " + std::generic_category().message(errno));
}

} // namespace

Output_lock::Output_lock(fs::path file)
  : file_(std::move(file))
{
  try {
    const Signals_wait scope;
    while (make() == Attempt::again && take_over() == Attempt::again) close();
    removal_.emplace(file_.string());
  } catch (...) {
    close();
    throw;
  }
}

Output_lock::~Output_lock()
{
  std::error_code ignored;
  fs::remove(file_, ignored); // before others can have the lock
  close();
}

Output_lock::Attempt Output_lock::make()
{
  constexpr int readable_by_all = 0666;
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, readable_by_all);
  if (descriptor_ < 0) {
    if (errno != EEXIST) fail(file_);
    return Attempt::again;
  }
  // Who looks into the file just now does not keep the lock, since nothing is in it yet.
  lock(descriptor_, true);
  if (::write(descriptor_, content.data(), content.size()) != ssize_t(content.size())) {
    const int error = errno;
    ::unlink(file_.c_str());
    errno = error;
    fail(file_);
  }
  return Attempt::held;
}

Output_lock::Attempt Output_lock::take_over()
{
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor_ < 0 && errno == ENOENT) return Attempt::again;
  std::string text(content.size() + 1, '\0');
  const bool is_free = descriptor_ >= 0 && lock(descriptor_, false);
  if (descriptor_ >= 0 && !is_free) throw Error("another run is writing it");
  const ssize_t n = descriptor_ < 0 ? -1 : ::pread(descriptor_, text.data(), text.size(), 0);
  text.resize(n < 0 ? 0 : static_cast<std::size_t>(n));
  if (n == 0 && looks_left_ > 0) { // its maker is about to lock it and to write into it
    --looks_left_;
    close();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return Attempt::again;
  }
  if (text != content)
    throw Error(file_.string() + " is there, by which runs lock each other out, and is not of this "
                                 "program: rename or delete it");
  return is_file_of_that_name(descriptor_, file_) ? Attempt::held : Attempt::again;
}

void Output_lock::close()
{
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

#else // without locks

Output_lock::Output_lock(fs::path file)
  : file_(std::move(file))
{}
Output_lock::~Output_lock() = default;

#endif

} // namespace pn_subdivide
