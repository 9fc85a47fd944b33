// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Attributes.h"
#include "io/Error.h"
#include "io/Text_reader.h"
#include "io/formats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pn_subdivide {
namespace {

// The colors of vertices or faces in an OFF file: three or four numbers, whole ones from 0 to 255 or
// others from 0 to 1. If files have both, all become numbers from 0 to 1. Where there is no color it
// is the gray that the format's own viewer takes. A single number is one of a color map, which the
// file does not hold.
class Off_colors
{
public:
  // Reads so many words, the color of the next element.
  void read(Text_reader& in, std::size_t words)
  {
    ++size_;
    if (words == 0 && entries_.empty()) return;
    entries_.resize(size_ - 1, gray);
    Color_entry entry = gray;
    entry.words = words;
    if (words == 1) {
      in.integer("a number of the color map");
      has_numbers_of_color_map_ = true;
    } else if (words == 2 || words > 4) {
      in.fail("a color of " + std::to_string(words) + " numbers; it has three or four");
    }
    for (std::size_t i = 0; words > 1 && i < words; ++i) {
      const std::string_view word = in.word();
      entry.channels[i] = in.to_number(word, "a color");
      if (word.find_first_not_of("0123456789+-") != std::string_view::npos) entry.is_whole = false;
    }
    const double highest = entry.is_whole ? 255 : 1;
    for (std::size_t i = 0; words > 1 && i < words; ++i)
      if (!(entry.channels[i] >= 0 && entry.channels[i] <= highest))
        in.fail(
          std::string(
            "a color out of range: its numbers must be whole ones from 0 to 255, or from 0 to 1") +
          reading_without_it);
    has_alpha_ = has_alpha_ || words == 4;
    entries_.push_back(entry);
  }

  bool has_numbers_of_color_map() const { return has_numbers_of_color_map_; }

  // Empty if there is no color, or a number of a color map.
  Columns columns() const
  {
    if (has_numbers_of_color_map_ || entries_.empty()) return {};
    const bool all_whole = std::all_of(entries_.begin(), entries_.end(),
                                       [](const Color_entry& entry) { return entry.is_whole; });
    const char* const names[] = {"red", "green", "blue", "alpha"};
    Columns columns;
    for (std::size_t i = 0; i < (has_alpha_ ? 4 : 3); ++i) {
      Column column;
      column.name = names[i];
      column.type = all_whole ? Scalar_type::uint8 : Scalar_type::float64;
      for (const Color_entry& entry : entries_) {
        const double x = entry.channels[i];
        const bool is_opaque = i == 3 && entry.words < 4;
        column.values.push_back(all_whole ? x : !entry.is_fraction() ? x / 255 : is_opaque ? 1 : x);
      }
      columns.push_back(std::move(column));
    }
    return columns;
  }

private:
  struct Color_entry
  {
    std::array<double, 4> channels;
    std::size_t words; // of the channels in the file
    bool is_whole;

    // Among fractions 1 0 0 is as much a color as 255 0 0.
    bool is_fraction() const
    {
      const auto end = channels.begin() + std::ptrdiff_t(words);
      return !is_whole || (words > 0 && *std::max_element(channels.begin(), end) <= 1);
    }
  };

  static constexpr Color_entry gray{{170, 170, 170, 255}, 0, true};

  std::size_t size_ = 0;
  std::vector<Color_entry> entries_; // empty, as long as there is no color
  bool has_alpha_ = false, has_numbers_of_color_map_ = false;
};

struct Off_header
{
  bool texture = false, colors = false, normals = false;
  std::size_t points = 0, faces = 0;

  bool is_plain() const { return !texture && !colors && !normals; }
};

// [ST][C][N]OFF in any order of the prefixes, since programs differ. What follows OFF in the same
// word, as in "OFF8 6 0", begins the counts.
std::string_view read_keyword(Text_reader& in, Off_header& header)
{
  std::string_view word = in.word();
  const bool begins_with_a_number = word.find_first_not_of("0123456789") == std::string_view::npos;
  const auto take = [&word](std::string_view prefix) {
    const bool found = word.substr(0, prefix.size()) == prefix;
    if (found) word.remove_prefix(prefix.size());
    return found;
  };
  while (!take("OFF")) {
    if (take("ST"))
      header.texture = true;
    else if (take("C"))
      header.colors = true;
    else if (take("N"))
      header.normals = true;
    else if (take("4") || take("n"))
      in.fail("OFF files with points that are not x y z are not supported");
    else if (begins_with_a_number)
      in.fail(
        "this looks like an OFF file without its first word: put a line OFF in front (or NOFF "
        "if normals follow the points)");
    else
      in.fail("not an OFF file: it does not begin with OFF, NOFF, COFF or the like");
  }
  return word;
}

Off_header read_header(Text_reader& in)
{
  Off_header header;
  if (!in.next_line()) throw Error("not an OFF file: it holds no text");
  std::string_view word = read_keyword(in, header);
  if (word.empty()) word = in.word_across_lines();
  if (word == "BINARY")
    in.fail("binary OFF files are not supported; PLY is a good exchange format");

  header.points = in.to_count(word, "the number of vertices");
  header.faces = in.to_count(in.word_across_lines(), "the number of faces");
  if (header.points > Mesh_data::max_number_of_points) in.fail("too many vertices");
  return header; // the number of edges, where it is given, says nothing new
}

void next_line_of(Text_reader& in, const char* what, std::size_t i, std::size_t number)
{
  if (!in.next_line())
    throw Error("truncated: the file ends after " + std::to_string(i) + " of " +
                std::to_string(number) + " " + what);
}

// What an OFF file says besides points, normals and faces.
struct Off_attributes
{
  Off_colors of_vertices, of_faces;
  std::vector<double> texture;

  void put(Mesh_data& mesh)
  {
    if (of_vertices.has_numbers_of_color_map() || of_faces.has_numbers_of_color_map())
      mesh.drop("colors that are numbers of a color map");
    mesh.attributes.of_vertices = of_vertices.columns();
    mesh.attributes.of_faces = of_faces.columns();
    for (std::size_t i = 0; i < 2 && !texture.empty(); ++i) {
      Column column;
      column.name = i == 0 ? "s" : "t";
      for (std::size_t k = i; k < texture.size(); k += 2) column.values.push_back(texture[k]);
      mesh.attributes.of_vertices.push_back(std::move(column));
    }
  }
};

// Colors have 0 to 4 numbers, whatever the header says. Four are a color in plain OFF files, too; three could mean
// normals or colors there, and this is not guessed.
void read_rest_of_vertex(Text_reader& in, const Off_header& header, Off_attributes& attributes)
{
  const std::size_t left = in.words_left();
  const bool has_color = header.colors || (header.is_plain() && left == 4);
  const std::size_t texture = header.texture ? 2 : 0;
  const std::size_t most = texture + (has_color ? 4 : 0);
  if (left < texture || left > most)
    in.fail("the vertex has " + std::to_string(left) + " numbers behind its coordinates" +
            (header.normals ? " and normal" : "") + " where the header announces " +
            (texture == most ? std::to_string(most)
                             : std::to_string(texture) + " to " + std::to_string(most)) +
            (header.is_plain() ? " (COFF has colors, NOFF normals)" : "") + reading_without_it);
  if (has_color || header.is_plain()) attributes.of_vertices.read(in, left - texture);
  while (!in.at_end_of_line()) {
    const double x = in.number("a number");
    if (!std::isfinite(x))
      in.fail(std::string("a texture coordinate that is not finite") + reading_without_it);
    attributes.texture.push_back(x);
  }
}

// False if it has less than three vertices.
bool read_face(Text_reader& in, std::size_t number_of_points, std::vector<Index>& face,
               Off_attributes* attributes)
{
  const std::int64_t n = in.integer("the face's number of vertices");
  if (n < 0) in.fail("a face with " + std::to_string(n) + " vertices");
  if (n < 3) return false;
  face.clear();
  for (std::int64_t i = 0; i < n; ++i) {
    const std::int64_t v = in.integer("a vertex index");
    if (v < 0 || static_cast<std::uint64_t>(v) >= number_of_points)
      in.fail("the face's vertex index " + std::to_string(v) + " is out of range, there are " +
              std::to_string(number_of_points) + " vertices");
    face.push_back(static_cast<Index>(v));
  }
  if (attributes == nullptr) return true;
  const std::size_t left = in.words_left();
  if (left > 4)
    in.fail("too many numbers for a face with " + std::to_string(n) + " vertices and a color" +
            reading_without_it);
  attributes->of_faces.read(in, left);
  return true;
}

} // namespace

Mesh_data read_off(const std::string& content, bool with_attributes)
{
  Text_reader in(content, '#');
  const Off_header header = read_header(in);

  Mesh_data mesh;
  const auto place = [&in] { return "line " + std::to_string(in.line()); };
  Off_attributes read_attributes;
  const std::size_t plausible = content.size() / 6; // a damaged header may announce anything
  mesh.points.reserve(std::min(header.points, plausible));
  for (std::size_t i = 0; i < header.points; ++i) {
    next_line_of(in, "vertices", i, header.points);
    mesh.points.push_back(in.triple("a coordinate"));
    if (header.normals) {
      mesh.normals.push_back(mesh.finite_normal(in.triple("a normal's coordinate"), place));
      mesh.digits_of_normals.see(in.last_words(), mesh.normals.back());
    }
    if (with_attributes) read_rest_of_vertex(in, header, read_attributes);
  }
  std::vector<Index> face;
  mesh.reserve_faces(std::min(header.faces, plausible), 4 * std::min(header.faces, plausible));
  for (std::size_t i = 0; i < header.faces; ++i) {
    next_line_of(in, "faces", i, header.faces);
    if (read_face(in, header.points, face, with_attributes ? &read_attributes : nullptr))
      mesh.add_face(face);
    else
      mesh.short_faces.add(place() + " has a face with less than three vertices");
  }
  if (in.next_line()) in.fail("more lines than the header announces");
  read_attributes.put(mesh);
  return mesh;
}

} // namespace pn_subdivide
