// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Row_writer.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

namespace pn_subdivide {

void Row_writer::flush()
{
  if (buffer_.empty()) return;
  file_.write(place_, buffer_.data(), buffer_.size());
  if (keeps_receipt_) {
    checksum_.process_bytes(buffer_.data(), buffer_.size());
    if (runs_.empty() || place_ != runs_.back().end) runs_.push_back({place_, place_});
    runs_.back().end = place_ + buffer_.size();
  }
  buffer_.clear();
}

std::string Row_writer::receipt() const
{
  std::ostringstream text;
  text << text_of(checksum_) << std::hex;
  for (const Run& run : runs_) text << ' ' << run.begin << ' ' << run.end;
  return text.str();
}

bool has_rows(const std::filesystem::path& file, const std::string& receipt)
{
  std::ifstream rows;
  rows.rdbuf()->pubsetbuf(nullptr, 0); // runs are read as they are, often from far away
  rows.open(file, std::ios::binary);
  std::istringstream text(receipt);
  std::string expected;
  text >> expected >> std::hex;
  Checksum checksum;
  std::vector<char> buffer(1 << 16);
  for (std::uint64_t place = 0, end = 0; text >> place >> end;) {
    rows.seekg(static_cast<std::streamoff>(place));
    while (rows && place < end) {
      const std::size_t n = std::min<std::uint64_t>(end - place, buffer.size());
      rows.read(buffer.data(), static_cast<std::streamsize>(n));
      checksum.process_bytes(buffer.data(), n);
      place += n;
    }
  }
  return rows && text.eof() && text_of(checksum) == expected;
}

} // namespace pn_subdivide
