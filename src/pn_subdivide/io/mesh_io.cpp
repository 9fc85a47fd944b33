// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/mesh_io.h"

#include "io/Error.h"
#include "io/Output_file.h"
#include "io/Text_reader.h"
#include "io/formats.h"

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>

namespace pn_subdivide {
namespace {

using Reader = Mesh_data (*)(const std::string&, bool);
using Writer = void (*)(Output_file&, const Mesh_data&, Encoding);
using Not_held = std::vector<std::string> (*)(const Mesh_data&, Encoding);

struct Format
{
  const char* name;
  Reader read; // nullptr: not read
  Writer write;
  Not_held not_held;
  Held_values held;
};

const Format formats[] = {
  {"ply", read_ply, write_ply, not_held_by_ply, {true, true, true, false, true}},
  {"off", read_off, write_off, not_held_by_off, {false, true, false, false, true}},
  {"obj", read_obj, write_obj, not_held_by_obj, {false, true, false, true, true}},
  {"stl", read_stl, write_stl, not_held_by_stl, {false, false, false, false, false}},
  {"vtp", nullptr, write_vtp, not_held_by_vtp, {true, true, true, false, true}},
  // written piece by piece only
  {"pvtp", nullptr, nullptr, not_held_by_vtp, {true, true, true, false, true}}};

// All are written, some are read.
std::string names_of(bool are_read, const char* before_each = "")
{
  std::string names;
  for (const Format& format : formats)
    if (!are_read || format.read != nullptr)
      names += (names.empty() ? "" : " ") + (before_each + std::string(format.name));
  return names;
}

Mesh_file mesh_file(const std::string& name, const std::optional<std::string>& format, bool is_read)
{
  const std::string action = is_read ? "read" : "written";
  namespace algorithm = boost::algorithm;
  const bool is_stream = name == "-";
  if (is_stream && !format)
    throw Usage_error("'-' needs --format and one of " + names_of(is_read) + " to be " + action);
  const std::string extension = std::filesystem::path(name).extension().string();
  const std::string word =
    algorithm::to_lower_copy(is_stream ? *format : extension.substr(extension.empty() ? 0 : 1));
  for (const Format& f : formats)
    if (word == f.name && (!is_read || f.read != nullptr)) return {name, word};
  if (is_stream)
    throw Usage_error("--format '" + *format + "': it must be one of " + names_of(is_read) +
                      " to be " + action);
  throw Usage_error(name + ": the file name must end in one of " + names_of(is_read, ".") +
                    " to be " + action);
}

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

const Format& format_of(const Mesh_file& file)
{
  return *std::find_if(std::begin(formats), std::end(formats),
                       [&file](const Format& format) { return file.format == format.name; });
}

} // namespace

std::string readable_formats()
{
  return names_of(true);
}
std::string writable_formats()
{
  return names_of(false);
}

Mesh_file input_mesh_file(const std::string& name, const std::optional<std::string>& format)
{
  return mesh_file(name, format, true);
}
Mesh_file output_mesh_file(const std::string& name, const std::optional<std::string>& format)
{
  return mesh_file(name, format, false);
}

const Held_values& held_by(const Mesh_file& file)
{
  return format_of(file).held;
}

void require_writable_place(const std::string& file)
{
  naming(file, [&] { Output_file::check(file); });
}

bool same_file(const std::string& a, const std::string& b)
{
  std::error_code error;
  const auto place = [&error](const std::string& file) {
    return std::filesystem::weakly_canonical(file, error);
  };
  return place(a) == place(b);
}

void require_own_file(const std::string& option, const std::string& file,
                      const std::vector<std::string>& others)
{
  if (file.empty() || file == "-")
    throw Usage_error(option + " '" + file + "': it takes the name of a file");
  require_writable_place(file);
  for (const std::string& other : others)
    if (!other.empty() && other != "-" && same_file(file, other))
      throw Usage_error(option + " " + file + ": it needs a file of its own");
}

std::vector<std::string> not_held(const Mesh_file& file, const Mesh_data& mesh, Encoding encoding)
{
  return format_of(file).not_held(mesh, encoding);
}

std::string lost_precision(const Mesh_file& file, const Mesh_data& mesh, Encoding encoding)
{
  return file.format == "stl" && encoding == Encoding::binary ? loss_in_stl(mesh) : "";
}

Mesh_data read_mesh(const Mesh_file& file, bool with_attributes)
{
  return naming(file.title("standard input"),
                [&] { return format_of(file).read(file_content(file.name), with_attributes); });
}

Mesh_data read_mesh(const std::string& name)
{
  return read_mesh(input_mesh_file(name, std::nullopt));
}

void write_mesh(const Mesh_file& file, const Mesh_data& mesh, Encoding encoding)
{
  naming(file.title("standard output"), [&] {
    Output_file out(file.name);
    format_of(file).write(out, mesh, encoding);
    out.commit();
  });
}

void write_mesh(const std::string& name, const Mesh_data& mesh, Encoding encoding)
{
  write_mesh(output_mesh_file(name, std::nullopt), mesh, encoding);
}

Selection read_selection(const std::string& file)
{
  return naming(file, [&] { return parse_selection(file_content(file)); });
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
