// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Shared_file.h"

#include "io/Error.h"

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <string>
#include <system_error>

#if __has_include(<unistd.h>)
#  include <csignal>
#  include <cstdlib>
#  include <fcntl.h>
#  include <unistd.h>
#endif

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

std::string reason(int error)
{
  return std::generic_category().message(error);
}

#if __has_include(<unistd.h>)

class Posix_file : public Shared_file
{
public:
  explicit Posix_file(const fs::path& file, int flags = 0)
    : descriptor_(::open(file.c_str(), O_WRONLY | O_CLOEXEC | flags))
  {
    if (descriptor_ < 0) throw Error(file.string() + " cannot be opened: " + reason(errno));
  }
  // of an open file
  explicit Posix_file(int descriptor)
    : descriptor_(descriptor)
  {}
  ~Posix_file() override
  {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Posix_file(const Posix_file&) = delete;
  Posix_file& operator=(const Posix_file&) = delete;

  void write(std::uint64_t place, const void* data, std::size_t bytes) override
  {
    const char* const begin = static_cast<const char*>(data);
    write_all(bytes, [&](std::size_t done) {
      return ::pwrite(descriptor_, begin + done, bytes - done, static_cast<off_t>(place + done));
    });
  }
  void append(const std::string& text)
  {
    write_all(text.size(), [&](std::size_t done) {
      return ::write(descriptor_, text.data() + done, text.size() - done);
    });
  }

  void sync() override
  {
    if (::fsync(descriptor_) != 0) throw Error("writing failed: " + reason(errno));
  }

  void close() override
  {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) throw Error("writing failed: " + reason(errno));
  }

  void read(std::uint64_t place, void* data, std::size_t bytes)
  {
    char* const begin = static_cast<char*>(data);
    for (std::size_t done = 0; done < bytes;) {
      const ssize_t n =
        ::pread(descriptor_, begin + done, bytes - done, static_cast<off_t>(place + done));
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) throw Error("reading failed: " + reason(n < 0 ? errno : EIO));
      done += static_cast<std::size_t>(n);
    }
  }

private:
  template <class Write>
  static void write_all(std::size_t bytes, const Write& write)
  {
    for (std::size_t done = 0; done < bytes;) {
      const ssize_t n = write(done);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) throw Error("writing failed: " + reason(errno));
      done += static_cast<std::size_t>(n);
    }
  }

  int descriptor_;
};

// No signal ends the program between the two calls.
int open_without_name(std::string name)
{
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  const int descriptor = ::mkstemp(&name[0]);
  const int error = errno;
  if (descriptor >= 0) ::unlink(name.c_str());
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (descriptor < 0) throw Error(name + " cannot be made: " + reason(error));
  return descriptor;
}

class Temporary_rows : public Nameless_file
{
public:
  explicit Temporary_rows(const fs::path& beside)
    : file_(open_without_name(beside.string() + ".XXXXXX"))
  {}

  void write(std::uint64_t place, const void* data, std::size_t bytes) override
  {
    file_.write(place, data, bytes);
  }
  void read(std::uint64_t place, void* data, std::size_t bytes) override
  {
    file_.read(place, data, bytes);
  }

private:
  Posix_file file_;
};

#else

// The library's temporary file, wherever that is.
class Temporary_rows : public Nameless_file
{
public:
  explicit Temporary_rows(const fs::path&)
    : file_(std::tmpfile(), &std::fclose)
  {
    if (!file_) throw Error("a temporary file cannot be made: " + reason(errno));
  }

  void write(std::uint64_t place, const void* data, std::size_t bytes) override
  {
    seek(place);
    if (std::fwrite(data, 1, bytes, file_.get()) != bytes) throw Error("writing failed");
  }
  void read(std::uint64_t place, void* data, std::size_t bytes) override
  {
    seek(place);
    if (std::fread(data, 1, bytes, file_.get()) != bytes) throw Error("reading failed");
  }

private:
  void seek(std::uint64_t place)
  {
    const auto to = static_cast<std::fpos_t>(place);
    if (std::fsetpos(file_.get(), &to) != 0) throw Error("a temporary file is too large");
  }

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

class Posix_file : public Shared_file
{
public:
  explicit Posix_file(const fs::path& file)
    : stream_(file, std::ios::in | std::ios::out | std::ios::binary)
  {
    if (!stream_) throw Error(file.string() + " cannot be opened");
  }

  void write(std::uint64_t place, const void* data, std::size_t bytes) override
  {
    stream_.seekp(static_cast<std::streamoff>(place));
    stream_.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
    if (!stream_) throw Error("writing failed");
  }
  void sync() override
  {
    if (!stream_.flush()) throw Error("writing failed");
  }
  void close() override
  {
    stream_.close();
    if (!stream_) throw Error("writing failed");
  }

private:
  std::fstream stream_;
};

#endif

} // namespace

void create_file(const fs::path& file, std::uint64_t bytes)
{
  std::FILE* const f = std::fopen(file.string().c_str(), "wbx"); // x: never opens an existing file
  if (f == nullptr) throw Error(file.string() + " cannot be made: " + reason(errno));
  std::fclose(f);
  std::error_code error;
  fs::resize_file(file, bytes, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(file, ignored);
  throw Error(file.string() + " cannot be made: " + error.message());
}

void sync_file(const fs::path& file)
{
#if __has_include(<unistd.h>)
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw Error(file.string() + " cannot be opened: " + reason(errno));
  const int code = ::fsync(descriptor), error = errno;
  ::close(descriptor);
  if (code != 0 && error != EINVAL) // that of a file system which cannot
    throw Error("writing failed: " + reason(error));
#else
  (void)file;
#endif
}

void append_to_file(const fs::path& file, const std::string& text)
{
#if __has_include(<unistd.h>)
  Posix_file f(file, O_APPEND);
  f.append(text);
  f.sync();
  f.close();
#else
  std::ofstream out(file, std::ios::binary | std::ios::app);
  if (!(out << text).flush()) throw Error("writing failed");
#endif
}

std::unique_ptr<Shared_file> open_file(const fs::path& file)
{
  return std::make_unique<Posix_file>(file);
}

std::unique_ptr<Nameless_file> open_nameless_file(const fs::path& beside)
{
  return std::make_unique<Temporary_rows>(beside);
}

} // namespace pn_subdivide
