// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "pieces/Output_names.h"

#include "io/Error.h"
#include "io/formats.h"

#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace pn_subdivide {
namespace {

bool is_piece_file(const fs::directory_entry& entry)
{
  const std::string begin = "piece_", end = ".vtp", name = entry.path().filename().string();
  std::error_code error;
  return name.size() > begin.size() + end.size() && name.rfind(begin, 0) == 0 &&
         name.find_first_not_of("0123456789", begin.size()) == name.size() - end.size() &&
         name.compare(name.size() - end.size(), end.size(), end) == 0 &&
         fs::is_regular_file(entry.symlink_status(error));
}

} // namespace

std::string piece_name(std::size_t i)
{
  return "piece_" + std::to_string(i) + ".vtp";
}

bool is_piece_folder(const fs::path& folder)
{
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(folder, error))) return false;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (!is_piece_file(entry)) return false;
  return true;
}

bool remove_piece_folder(const fs::path& folder)
{
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator i(folder, error); !error && i != fs::directory_iterator();
       i.increment(error))
    if (is_piece_file(*i)) files.push_back(i->path());
  bool any = false;
  for (const fs::path& file : files) any = fs::remove(file, error) || any;
  return fs::remove(folder, error) || any;
}

Output_names::Output_names(const Mesh_file& output)
  : target(Output_file::regular_target(output.name))
  , part(target.string() + ".part")
  , done(part.string() + ".done")
{
  if (output.format == "ply") return;
  folder = target.parent_path() / (target.stem().string() + "_pieces");
  old = folder.string() + ".old";
}

void Output_names::require_free(bool resumes, const std::string& job) const
{
  if (fs::exists(fs::symlink_status(part)))
    require_continuation(resumes, job);
  else if (resumes && fs::exists(fs::symlink_status(done)) &&
           !Finished_pieces(done, job).are_of_job())
    throw Error(done.string() + " is there, and is not of a run that can be continued: rename or "
                                "delete it");
  if (!folder.empty()) require_own_folder();
}

void Output_names::require_continuation(bool resumes, const std::string& job) const
{
  const std::string name = part.string();
  if (!resumes)
    throw Error(name + " is there: another run writes it, one was interrupted, or it is something "
                       "else; delete or rename it, or continue with --resume if that run had it");
  if (!fs::exists(done))
    throw Error(name + " is there without " + done.filename().string() +
                ", and cannot be continued: delete or rename it");
  if (!Finished_pieces(done, job).are_of_job())
    throw Error(done.string() +
                " belongs to a run with other data or options, which cannot be continued: delete "
                "it and " +
                done.stem().string() + " to begin anew");
  const bool is_of_a_run =
    folder.empty() ? fs::is_regular_file(fs::symlink_status(part)) : is_piece_folder(part);
  if (!is_of_a_run) throw Error(name + " is not what a run writes: rename it");
}

// What lies in the folder is replaced: it must be what this program has put there.
void Output_names::require_own_folder() const
{
  if (!is_xml_text(folder.filename().string()))
    throw Error("a PVTP file cannot name a folder after it, since its name has control characters "
                "or is no UTF-8: take another name");
  if (!fs::exists(fs::symlink_status(folder))) return;
  if (!is_piece_folder(folder))
    throw Error("the pieces go into the folder " + folder.string() +
                ", and something else is there: remove it, or take another name");
  if (fs::exists(fs::symlink_status(old)))
    throw Error(folder.string() + " is to be replaced, and is called " + old.filename().string() +
                " until then, which is there already: rename or delete it");
}

} // namespace pn_subdivide
