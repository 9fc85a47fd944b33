// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/Ply_header.h"

#include <unordered_set>

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

Scalar_type read_type(Text_reader& in)
{
  const std::string word(in.word());
  for (int i = 0; i <= static_cast<int>(Scalar_type::float64); ++i) {
    const auto type = static_cast<Scalar_type>(i);
    if (word == traits(type).ply || word == traits(type).other_ply) return type;
  }
  in.fail("not a PLY type: '" + Text_reader::printable(word) + "'");
}

Ply_format read_format(Text_reader& in)
{
  const std::string_view word = in.word();
  if (word == "ascii") return Ply_format::ascii;
  if (word == "binary_little_endian") return Ply_format::little_endian;
  if (word == "binary_big_endian") return Ply_format::big_endian;
  in.fail("not a PLY format: '" + Text_reader::printable(word) + "'");
}

Ply_element read_element(Text_reader& in, std::unordered_set<std::string>& names)
{
  Ply_element element;
  element.name = in.word();
  if (!names.insert(element.name).second)
    in.fail("a second element '" + Text_reader::printable(element.name) + "'");
  element.size = in.count("the number of elements");
  return element;
}

Ply_property read_property(Text_reader& in)
{
  Ply_property property;
  Text_reader first_word = in;
  property.is_list = first_word.word() == "list";
  if (property.is_list) {
    in.word();
    property.size_type = read_type(in);
    if (property.size_type == Scalar_type::float32 || property.size_type == Scalar_type::float64)
      in.fail("the length of a list must be an integer");
  }
  property.type = read_type(in);
  property.name = in.word();
  if (property.name.empty()) in.fail("a property without a name");
  return property;
}

double checked_tangent(double x)
{
  if (!std::isfinite(x)) throw Error("a tangent that is not finite");
  return x;
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

std::size_t Ply_element::find(const std::string& property) const
{
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property) return i;
  return none;
}

Ply_header read_ply_header(Text_reader& in)
{
  Ply_header header;
  if (!in.next_line() || in.word() != "ply")
    in.fail("not a PLY file: it does not begin with 'ply'");

  bool has_format = false;
  std::unordered_set<std::string> names; // of the elements
  while (in.next_line()) {
    const std::string_view keyword = in.word();
    if (keyword == "format") {
      header.format = read_format(in);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(in, names));
    } else if (keyword == "property") {
      if (header.elements.empty()) in.fail("a property before the first element");
      header.elements.back().properties.push_back(read_property(in));
    } else if (keyword == "end_header") {
      if (!has_format) in.fail("the header says nothing about the format");
      return header;
    } else if (keyword == "comment") {
      header.comments.emplace_back(in.name());
    } else if (keyword != "obj_info") {
      in.fail("'" + Text_reader::printable(keyword) + "' does not belong into a PLY header");
    }
  }
  in.fail("truncated: the header has no 'end_header'");
}

Ply_tags::Ply_tags(const Ply_header& header)
{
  for (const Ply_element& element : header.elements) {
    if (element.name != "edge") continue;
    std::size_t found = 0;
    for (; found < places_.size(); ++found) {
      places_[found] = element.find(edge_properties[found]);
      const std::size_t place = places_[found];
      if (place == Ply_element::none || element.properties[place].is_list) break;
    }
    if (found < 3) continue;
    edges_ = &element;
    has_tangents_ = found == places_.size();
  }
}

void Ply_tags::add_edge(const std::vector<double>& scalars, std::size_t number_of_vertices,
                        Crease_tags& tags) const
{
  Crease_tags::Edge edge{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double v = scalars[places_[i]];
    if (!(v >= 0 && v < double(number_of_vertices)) || v != std::floor(v)) {
      throw Error(formatted("its vertex %g is out of range, there are ", v) +
                  std::to_string(number_of_vertices) + " vertices");
    }
    edge.ends[i] = static_cast<std::uint32_t>(v);
  }
  edge.sharpness = scalars[places_[2]];
  require_sharpness(edge.sharpness);
  for (std::size_t k = 0; k < 6 && has_tangents_; ++k)
    edge.tangents[k / 3][k % 3] = checked_tangent(scalars[places_[3 + k]]);
  if (edge.sharpness > 0) tags.edges.push_back(edge);
}

void require_sharpness(double sharpness)
{
  if (!(sharpness >= 0)) throw Error("a sharpness that is negative or no number");
}

} // namespace pn_subdivide
