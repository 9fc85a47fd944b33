// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/file_references.h"

#include <filesystem>
#include <sstream>
#include <string>
#include <system_error>

namespace pn_subdivide {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const Mesh_file& file)
{
  std::error_code error;
  const fs::path path = file.name == "-" ? fs::path("x") : fs::path(file.name);
  const fs::path folder = fs::weakly_canonical(fs::absolute(path, error).parent_path(), error);
  return error ? path.parent_path() : folder;
}

std::string moved(const std::string& name, const fs::path& from, const fs::path& to)
{
  if (fs::path(name).is_absolute()) return name;
  return (from / name).lexically_normal().lexically_proximate(to).generic_string();
}

// A line may name several files, and the name of one may have blanks.
std::string all_moved(const std::string& names, const fs::path& from, const fs::path& to)
{
  std::error_code error;
  if (names.find(' ') == std::string::npos || fs::exists(from / names, error))
    return moved(names, from, to);
  std::istringstream in(names);
  std::string result, name;
  while (in >> name) result += (result.empty() ? "" : " ") + moved(name, from, to);
  return result;
}

} // namespace

void move_file_references(Attributes& attributes, const Mesh_file& input, const Mesh_file& output)
{
  if (attributes.material_files.empty() && attributes.texture_files.empty()) return;
  const fs::path from = folder_of(input), to = folder_of(output);
  if (from == to) return;
  for (std::string& names : attributes.material_files) names = all_moved(names, from, to);
  for (std::string& name : attributes.texture_files) name = moved(name, from, to);
}

} // namespace pn_subdivide
