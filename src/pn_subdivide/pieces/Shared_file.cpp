// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Ranks.h"

#include "io/Error.h"

#include <cerrno>
#include <fstream>
#include <system_error>

#if __has_include(<unistd.h>)
#  include <fcntl.h>
#  include <unistd.h>
#endif

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

#if __has_include(<unistd.h>)

class Posix_file : public Shared_file
{
public:
  explicit Posix_file(const fs::path& file)
    : descriptor_(::open(file.c_str(), O_WRONLY | O_CLOEXEC))
  {
    if (descriptor_ < 0) throw Error(file.string() + " cannot be opened: " + reason(errno));
  }
  ~Posix_file() override
  {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Posix_file(const Posix_file&) = delete;
  Posix_file& operator=(const Posix_file&) = delete;

  void write(std::uint64_t place, const void* data, std::size_t bytes) override
  {
    const char* const begin = static_cast<const char*>(data);
    for (std::size_t done = 0; done < bytes;) {
      const ssize_t n =
        ::pwrite(descriptor_, begin + done, bytes - done, static_cast<off_t>(place + done));
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) throw Error("writing failed: " + reason(errno));
      done += static_cast<std::size_t>(n);
    }
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

private:
  int descriptor_;
};

#else

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

std::unique_ptr<Shared_file> open_file(const fs::path& file)
{
  return std::make_unique<Posix_file>(file);
}

} // namespace pn_subdivide
