// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Ply_values.h"

#include "io/Text_reader.h"

namespace pn_subdivide {
namespace {

// "material 1 red", if the next number is 1.
void read_word(const std::string& comment, Columns& columns)
{
  const std::size_t first = comment.find(' ');
  const std::size_t second = first == std::string::npos ? first : comment.find(' ', first + 1);
  if (second == std::string::npos) return;
  const std::string name = comment.substr(0, first);
  const std::string number = comment.substr(first + 1, second - first - 1);
  for (Column& column : columns)
    if (column.name == name && traits(column.type).is_integer &&
        number == std::to_string(column.words.size()))
      column.words.push_back(comment.substr(second + 1));
}

} // namespace

void read_ply_comments(const std::vector<std::string>& comments, Attributes& attributes)
{
  const auto read_file = [](const std::string& comment, const std::string& keyword,
                            std::vector<std::string>& files) {
    if (comment.compare(0, keyword.size() + 1, keyword + " ") == 0)
      files.push_back(comment.substr(keyword.size() + 1));
  };
  for (const std::string& comment : comments) {
    read_file(comment, "TextureFile", attributes.texture_files);
    read_file(comment, "mtllib", attributes.material_files);
    read_word(comment, attributes.of_faces);
  }
}

} // namespace pn_subdivide
