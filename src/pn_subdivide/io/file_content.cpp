// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/file_content.h"

#include "io/Error.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#if __has_include(<unistd.h>)
#  include <sys/stat.h>
#  include <unistd.h>
#endif

namespace pn_subdivide {

namespace {

void close_unless_stdin(std::FILE* file)
{
  if (file != stdin) std::fclose(file);
}

// Devices such as /dev/zero have no end; the input at a terminal has.
bool is_endless([[maybe_unused]] std::FILE* file)
{
#if __has_include(<unistd.h>)
  struct stat status;
  const int descriptor = ::fileno(file);
  return ::fstat(descriptor, &status) == 0 && S_ISCHR(status.st_mode) && ::isatty(descriptor) == 0;
#else
  return false;
#endif
}

} // namespace

std::string file_content(const std::string& file)
{
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw Error("this is a directory, not a file to read");

  const std::unique_ptr<std::FILE, void (*)(std::FILE*)> in(
    file == "-" ? stdin : std::fopen(file.c_str(), "rb"), close_unless_stdin);
  if (!in) throw Error(std::string("cannot be opened: ") + std::strerror(errno));

  std::string content;
  std::string block(1 << 20, '\0');
  while (const std::size_t n = std::fread(&block[0], 1, block.size(), in.get())) {
    if (is_endless(in.get())) throw Error("this is a device without end, not a file to read");
    content.append(block, 0, n);
  }
  if (std::ferror(in.get())) throw Error(std::string("cannot be read: ") + std::strerror(errno));
  if (content.empty()) throw Error(file == "-" ? "nothing came in" : "the file is empty");
  return content;
}

} // namespace pn_subdivide
