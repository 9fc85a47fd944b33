// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Finished_pieces.h"

#include "io/Error.h"

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>

namespace pn_subdivide {

Finished_pieces::Finished_pieces(std::filesystem::path file, const std::string& job,
                                 std::size_t pieces)
  : file_(std::move(file))
  , first_line_("pn_subdivide " + job)
  , marks_(pieces, '0')
{}

void Finished_pieces::create()
{
  marks_.assign(marks_.size(), '0');
  std::error_code ignored;
  std::filesystem::remove(file_, ignored); // of a run whose other file is gone
  const std::string content = first_line_ + "\n" + marks_ + "\n";
  create_file(file_, content.size());
  const std::unique_ptr<Shared_file> file = open_file(file_);
  file->write(0, content.data(), content.size());
  file->sync();
  file->close();
}

void Finished_pieces::read()
{
  std::ifstream in(file_);
  std::string line, marks;
  std::getline(in, line);
  std::getline(in, marks);
  if (!in || line != first_line_ || marks.size() != marks_.size() ||
      marks.find_first_not_of("01") != std::string::npos)
    throw Error(file_.string() +
                " belongs to a run with other data or options, which cannot be continued: delete "
                "it and " +
                file_.stem().string() + " to begin anew");
  marks_ = marks;
  open_file_ = open_file(file_);
}

std::size_t Finished_pieces::number() const
{
  return static_cast<std::size_t>(std::count(marks_.begin(), marks_.end(), '1'));
}

void Finished_pieces::set_finished(std::size_t i)
{
  marks_[i] = '1';
  open_file_->write(first_line_.size() + 1 + i, "1", 1);
  open_file_->sync();
}

} // namespace pn_subdivide
