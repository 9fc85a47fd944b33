// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_ROW_WRITER_H
#define PN_SUBDIVIDE_ROW_WRITER_H

#include "pieces/Checksum.h"
#include "pieces/Shared_file.h"

#include <boost/endian/conversion.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pn_subdivide {

// Collects rows that follow on each other in the file.
class Row_writer
{
public:
  Row_writer(Shared_file& file, bool keeps_receipt)
    : file_(file)
    , keeps_receipt_(keeps_receipt)
  {
    buffer_.reserve(most + 1024);
  }

  // The places increase.
  void begin_row(std::uint64_t place)
  {
    if (place != place_ + buffer_.size() || buffer_.size() >= most) flush();
    if (buffer_.empty()) place_ = place;
  }
  template <class T>
  void little_endian(T x)
  {
    unsigned char bytes[sizeof(T)];
    boost::endian::endian_store<T, sizeof(T), boost::endian::order::little>(bytes, x);
    buffer_.append(reinterpret_cast<const char*>(bytes), sizeof(T));
  }
  void flush();

  // After flush(): the checksum of all rows, and where they are.
  std::string receipt() const;

private:
  static constexpr std::size_t most = 1 << 20;

  // from a place in the file to another one
  struct Run
  {
    std::uint64_t begin, end;
  };

  Shared_file& file_;
  std::string buffer_;
  std::uint64_t place_ = 0;

  bool keeps_receipt_;
  Checksum checksum_;
  std::vector<Run> runs_;
};

// Are the rows of a receipt in a file?
bool has_rows(const std::filesystem::path& file, const std::string& receipt);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_ROW_WRITER_H
