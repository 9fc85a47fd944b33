// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OUTPUT_NAMES_H
#define PN_SUBDIVIDE_OUTPUT_NAMES_H

#include "io/mesh_io.h"

#include <filesystem>
#include <string>

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

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OUTPUT_NAMES_H
