// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Row_writer.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string_view>
#include <vector>

namespace pn_subdivide {
namespace {

void append_hexadecimal(std::string& s, std::uint64_t n)
{
  char digits[20];
  s.append(digits, std::to_chars(digits, digits + sizeof digits, n, 16).ptr);
}

// of a piece's rows in a file
class Row_reader
{
public:
  explicit Row_reader(const std::filesystem::path& file)
    : buffer_(1 << 16)
  {
    in_.rdbuf()->pubsetbuf(nullptr, 0); // runs are read as they are, often from far away
    in_.open(file, std::ios::binary);
  }

  bool read(std::uint64_t place, std::uint64_t bytes)
  {
    in_.seekg(static_cast<std::streamoff>(place));
    while (in_ && bytes > 0) {
      const std::size_t n = std::min<std::uint64_t>(bytes, buffer_.size());
      in_.read(buffer_.data(), static_cast<std::streamsize>(n));
      checksum_.process_bytes(buffer_.data(), n);
      bytes -= n;
    }
    return static_cast<bool>(in_);
  }
  std::string checksum() const { return text_of(checksum_); }

private:
  std::vector<char> buffer_;
  std::ifstream in_;
  Checksum checksum_;
};

// Takes a number and the character behind it from the front.
bool take(std::string_view& text, char behind, std::uint64_t& n)
{
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n, 16);
  if (error != std::errc() || end == text.data() + text.size() || *end != behind) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
  return true;
}

} // namespace

void Row_writer::flush()
{
  if (buffer_.empty()) return;
  file_.write(place_, buffer_.data(), buffer_.size());
  if (keeps_receipt_) add_to_receipt();
  buffer_.clear();
}

void Row_writer::add_to_receipt()
{
  checksum_.process_bytes(buffer_.data(), buffer_.size());
  if (place_ != run_end_) {
    end_run();
    run_begin_ = place_;
  }
  run_end_ = place_ + buffer_.size();
}

void Row_writer::end_run()
{
  if (run_end_ == run_begin_) return;
  append_hexadecimal(runs_, run_begin_ - last_end_);
  runs_ += '+';
  append_hexadecimal(runs_, run_end_ - run_begin_);
  runs_ += ',';
  last_end_ = run_end_;
}

std::string Row_writer::receipt()
{
  end_run();
  return text_of(checksum_) + ":" + runs_;
}

bool has_rows(const std::filesystem::path& file, const std::string& receipt)
{
  Row_reader rows(file);
  const std::size_t end = receipt.find(':');
  if (end == std::string::npos) return false;
  std::uint64_t place = 0, distance = 0, bytes = 0;
  for (std::string_view runs = std::string_view(receipt).substr(end + 1); !runs.empty();) {
    if (!take(runs, '+', distance) || !take(runs, ',', bytes)) return false;
    if (!rows.read(place + distance, bytes)) return false;
    place += distance + bytes;
  }
  return rows.checksum() == receipt.substr(0, end);
}

} // namespace pn_subdivide
