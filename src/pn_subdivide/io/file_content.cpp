// Copyright (c) 2026  PN_subdivision_3 developers
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

namespace pn_subdivide {

std::string file_content(const std::string& file)
{
  if (std::filesystem::is_directory(file)) throw Error("this is a directory, not a file to read");

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"),
                                                           std::fclose);
  if (!in) throw Error(std::string("cannot be opened: ") + std::strerror(errno));

  std::string content;
  std::string block(1 << 20, '\0');
  while (const std::size_t n = std::fread(&block[0], 1, block.size(), in.get()))
    content.append(block, 0, n);
  if (std::ferror(in.get())) throw Error(std::string("cannot be read: ") + std::strerror(errno));
  if (content.empty()) throw Error("the file is empty");
  return content;
}

} // namespace pn_subdivide
