// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/selection.h"
#include "io/Error.h"
#include "io/Output_file.h"
#include "io/Text_reader.h"

#include <new>
#include <string_view>

namespace pn_subdivide {
namespace {

std::vector<std::int64_t> read_numbers(Text_reader& in, const char* what)
{
  std::vector<std::int64_t> numbers;
  for (std::string_view w = in.word(); !w.empty(); w = in.word()) {
    numbers.push_back(in.to_integer(w, what));
    if (numbers.back() < 0) in.fail(std::string(what) + " is negative: " + std::string(w));
  }
  return numbers;
}

Selection parse_selection(const std::string& content)
{
  Text_reader in(content, '\0');
  Selection selection;
  while (in.next_line()) {
    if (in.line() > 3)
      in.fail("a selection has three lines only: vertices, faces, and edges as pairs of vertices");
    std::vector<std::int64_t> numbers =
      read_numbers(in, in.line() == 2 ? "a face number" : "a vertex number");
    if (in.line() == 1)
      selection.vertices = std::move(numbers);
    else if (in.line() == 2)
      selection.faces = std::move(numbers);
    else if (numbers.size() % 2 != 0)
      in.fail("edges are pairs of vertex numbers, and there are " + std::to_string(numbers.size()) +
              " numbers");
    else
      for (std::size_t i = 0; i < numbers.size(); i += 2)
        selection.edges.push_back({numbers[i], numbers[i + 1]});
  }
  return selection;
}

} // namespace

Selection read_selection(const std::string& file)
{
  try {
    return parse_selection(file_content(file));
  } catch (const std::bad_alloc&) {
    throw; // has no file to blame
  } catch (const std::exception& e) {
    throw Error(file + ": " + e.what());
  }
}

void write_selection(Output_file& out, const Crease_tags& tags)
{
  std::string line;
  for (std::size_t v = 0; v < tags.vertices.size(); ++v)
    if (tags.vertices[v] > 0) line += (line.empty() ? "" : " ") + std::to_string(v);
  out.text(line + "\n\n");
  line.clear();
  for (const Crease_tags::Edge& edge : tags.edges)
    line +=
      (line.empty() ? "" : " ") + std::to_string(edge.ends[0]) + " " + std::to_string(edge.ends[1]);
  out.text(line + "\n");
}

} // namespace pn_subdivide
