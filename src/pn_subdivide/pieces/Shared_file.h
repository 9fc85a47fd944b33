// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SHARED_FILE_H
#define PN_SUBDIVIDE_SHARED_FILE_H

#include <boost/crc.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace pn_subdivide {

// that of ECMA-182
using Checksum = boost::crc_optimal<64, 0x42f0e1eba9ea3693u, ~0ull, ~0ull, true, true>;

inline std::string text_of(const Checksum& checksum)
{
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(checksum.checksum()));
  return text;
}

// A file into which several processes write at places of their own. Throws Error where something fails.
class Shared_file
{
public:
  virtual ~Shared_file() = default;

  virtual void write(std::uint64_t place, const void* data, std::size_t bytes) = 0;
  // until everything is on the disk
  virtual void sync() = 0;
  // Errors that the system kept back come out here. Otherwise the destructor closes, without a word.
  virtual void close() = 0;
};

// Throws Error if there is such a file already.
void create_file(const std::filesystem::path& file, std::uint64_t bytes);

// Until what any process of this machine wrote into a file, or the names in a folder, are on the disk.
void sync_file(const std::filesystem::path& file);

// An existing file.
std::unique_ptr<Shared_file> open_file(const std::filesystem::path& file);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SHARED_FILE_H
