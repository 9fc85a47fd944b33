// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Finished_pieces.h"

#include "io/Output_file.h"
#include "pieces/Shared_file.h"

#include <fstream>
#include <iterator>
#include <utility>

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

std::string content(const fs::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

Finished_pieces::Finished_pieces(fs::path folder, std::string job)
  : folder_(std::move(folder))
  , job_("pn_subdivide " + std::move(job))
{}

bool Finished_pieces::are_of(const fs::path& folder, const std::string& job)
{
  return content(folder / "job") == "pn_subdivide " + job + "\n";
}

void Finished_pieces::create() const
{
  remove(); // that of the same job whose other file is gone
  fs::create_directory(folder_);
  write("job", job_ + "\n");
}

void Finished_pieces::remove() const
{
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::size_t Finished_pieces::number() const
{
  const auto files = std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  return files > 0 ? static_cast<std::size_t>(files) - 1 : 0; // without that of the job
}

std::string Finished_pieces::receipt(std::size_t i) const
{
  const std::string text = content(folder_ / std::to_string(i)), line = first_line(i);
  return text.compare(0, line.size(), line) == 0 ? text.substr(line.size()) : "";
}

void Finished_pieces::set_finished(std::size_t i, const std::string& receipt) const
{
  write(std::to_string(i), first_line(i) + receipt);
}

void Finished_pieces::write(const std::string& name, const std::string& text) const
{
  Output_file out((folder_ / name).string());
  out.text(text);
  out.commit();
  sync_file(folder_ / name);
  sync_file(folder_); // its name
}

std::string Finished_pieces::first_line(std::size_t i) const
{
  return job_ + " " + std::to_string(i) + "\n";
}

} // namespace pn_subdivide
