// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OUTPUT_NAMES_H
#define PN_SUBDIVIDE_OUTPUT_NAMES_H

#include "io/Output_file.h"
#include "io/mesh_io.h"
#include "pieces/Ranks.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

namespace pn_subdivide {

// The names in the file system that a run in pieces takes. What others have there stays: the run is refused.
struct Output_names
{
  Output_names() = default;
  explicit Output_names(const Mesh_file& output);

  // Throws Error if one of them is taken by anything but the run that is to be continued, if there is one.
  void require_free(bool resumes, const std::string& job) const;

  std::filesystem::path target;
  std::filesystem::path part;   // what is written, until it is complete: a file or a folder
  std::filesystem::path done;   // a folder: which pieces are written, of runs that can be continued
  std::filesystem::path folder; // of the pieces that a PVTP file names; otherwise empty
  std::filesystem::path old;    // the folder that is replaced, until the new one is there

private:
  void require_continuation(bool resumes, const std::string& job) const;
  void require_own_folder() const;
};

// The file of a piece in a folder of pieces.
std::string piece_name(std::size_t i);

// Is it a folder, with nothing but files of such names in it?
bool is_piece_folder(const std::filesystem::path& folder);

// Removes the files of pieces and, unless there are others, the folder. Was there something to remove?
bool remove_piece_folder(const std::filesystem::path& folder);

// The folder that tells which pieces are on the disk: a file that names the job, and one for each piece, with a receipt by
// which what was written is known again. They are renamed into place, so that ranks need not know of each other.
class Finished_pieces
{
public:
  Finished_pieces(std::filesystem::path folder, const std::string& job)
    : folder_(std::move(folder))
    , job_("pn_subdivide " + job)
  {}

  bool are_of_job() const { return content("job") == job_ + "\n"; }
  void create() const
  {
    remove(); // that of the same job whose other file is gone
    std::filesystem::create_directory(folder_);
    write("job", job_ + "\n");
  }
  void remove() const
  {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::size_t number() const
  {
    using Entries = std::filesystem::directory_iterator;
    const auto files = std::distance(Entries(folder_), Entries());
    return files > 0 ? static_cast<std::size_t>(files) - 1 : 0; // without that of the job
  }
  // empty if there is none
  std::string receipt(std::size_t i) const
  {
    const std::string text = content(std::to_string(i)), line = first_line(i);
    return text.compare(0, line.size(), line) == 0 ? text.substr(line.size()) : "";
  }
  // once the piece is on the disk
  void set_finished(std::size_t i, const std::string& receipt) const
  {
    write(std::to_string(i), first_line(i) + receipt);
  }

private:
  std::string content(const std::string& name) const
  {
    std::ifstream in(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& name, const std::string& text) const
  {
    Output_file out((folder_ / name).string());
    out.text(text);
    out.commit();
    sync_file(folder_ / name);
    sync_file(folder_); // its name
  }
  std::string first_line(std::size_t i) const { return job_ + " " + std::to_string(i) + "\n"; }

  std::filesystem::path folder_;
  std::string job_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OUTPUT_NAMES_H
