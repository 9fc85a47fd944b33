// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Finished_pieces.h"

#include "io/Error.h"
#include "pieces/Checksum.h"
#include "pieces/Shared_file.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

std::string first_line_of(const std::string& job)
{
  return "pn_subdivide " + job;
}

} // namespace

Finished_pieces::Finished_pieces(fs::path file, const std::string& job, std::size_t pieces)
  : file_(std::move(file))
  , first_line_(first_line_of(job))
  , is_finished_(pieces, false)
{}

bool Finished_pieces::are_of(const fs::path& file, const std::string& job)
{
  const std::string expected = first_line_of(job) + "\n";
  std::string line(expected.size(), '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(&line[0], static_cast<std::streamsize>(line.size()));
  return in && line == expected;
}

void Finished_pieces::create()
{
  remove(); // that of the same job whose other file is gone
  create_file(file_, 0);
  append_to_file(file_, first_line_ + "\n");
}

void Finished_pieces::remove() const
{
  std::error_code ignored;
  fs::remove(file_, ignored);
}

void Finished_pieces::end_last_line() const
{
  std::ifstream in(file_, std::ios::binary);
  if (in.seekg(-1, std::ios::end) && in.get() != '\n') append_to_file(file_, "\n");
}

std::size_t Finished_pieces::number_of_lines() const
{
  std::vector<bool> has_line(is_finished_.size(), false);
  for_each_line([&](std::size_t i, const std::string&) { has_line[i] = true; });
  return static_cast<std::size_t>(std::count(has_line.begin(), has_line.end(), true));
}

void Finished_pieces::read(const std::function<bool(std::size_t, const std::string&)>& is_written)
{
  for_each_line([&](std::size_t i, const std::string& receipt) {
    if (!is_finished_[i]) is_finished_[i] = is_written(i, receipt);
  });
}

void Finished_pieces::set_finished(std::size_t i, const std::string& receipt)
{
  const std::string line = std::to_string(i) + " " + receipt;
  append_to_file(file_, line + " " + checksum(line) + "\n");
  is_finished_[i] = true;
}

// f(piece, receipt) for what is whole
template <class Function>
void Finished_pieces::for_each_line(const Function& f) const
{
  std::ifstream in(file_, std::ios::binary);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    const std::size_t space = line.find(' '), last = line.rfind(' ');
    if (space == last || line.substr(last + 1) != checksum(line.substr(0, last))) continue;
    std::size_t i = is_finished_.size();
    const char* const end = line.data() + space;
    if (std::from_chars(line.data(), end, i).ptr == end && i < is_finished_.size())
      f(i, line.substr(space + 1, last - space - 1));
  }
}

std::string Finished_pieces::checksum(const std::string& line) const
{
  Checksum sum;
  for (const std::string* s : {&first_line_, &line}) sum.process_bytes(s->data(), s->size());
  return text_of(sum);
}

} // namespace pn_subdivide
