// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/formats.h"

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

namespace pn_subdivide {
namespace {

class Vtp_writer;

// An array of numbers: put(writer) hands them to value().
struct Vtp_array
{
  std::string type, name;
  std::size_t components, bytes;
  std::function<void(Vtp_writer&)> put;
};

// VTK's XML poly data. Binary data stand behind the XML part ("appended", "raw"): each array is its
// number of bytes as UInt64 and then its values.
class Vtp_writer
{
public:
  Vtp_writer(Output_file& out, Encoding encoding)
    : out_(out)
    , encoding_(encoding)
  {}

  // comment: empty, or without two hyphens
  void begin(const std::string& comment = {})
  {
    out_.text("<?xml version=\"1.0\"?>\n");
    if (!comment.empty()) out_.text("<!-- " + comment + " -->\n");
    out_.text(
      R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData>
)");
  }

  void begin_piece(std::size_t points, std::size_t polygons)
  {
    out_.text(R"(<Piece NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPoints=")");
    write_count(out_, points);
    out_.text("\" NumberOfPolys=\"");
    write_count(out_, polygons);
    out_.text("\">\n");
  }

  void line(const std::string& xml) { out_.text(xml + "\n"); }

  // What it refers to must stay until end() has been called.
  void array(Vtp_array array)
  {
    out_.text("<DataArray type=\"" + array.type + "\" Name=\"" + xml_text(array.name) +
              "\" NumberOfComponents=\"" + std::to_string(array.components) + "\" format=\"");
    content("DataArray", array.bytes, std::move(array.put));
  }

  // Text is the numbers of its characters, as VTK has it.
  void words(const std::string& name, const std::vector<std::string>& values)
  {
    std::size_t bytes = 0;
    for (const std::string& word : values) bytes += word.size() + 1;
    out_.text("<Array type=\"String\" Name=\"" + xml_text(name) + "\" NumberOfTuples=\"" +
              std::to_string(values.size()) + "\" format=\"");
    content("Array", bytes, [&values](Vtp_writer& vtp) {
      for (const std::string& word : values)
        for (std::size_t i = 0; i <= word.size(); ++i)
          vtp.value<std::uint8_t>(static_cast<std::uint8_t>(word.c_str()[i]), i == word.size());
    });
  }

  template <class T>
  void value(T x, bool ends_line)
  {
    if (encoding_ == Encoding::binary) {
      out_.little_endian<T>(x);
    } else {
      text_value(x);
      out_.text(ends_line ? "\n" : " ");
    }
  }

  void value_of_type(Scalar_type type, double x, bool ends_line)
  {
    if (encoding_ == Encoding::binary)
      write_little_endian(out_, type, x);
    else
      value<double>(x, ends_line);
  }

  void end()
  {
    out_.text("</Piece>\n</PolyData>\n");
    if (encoding_ == Encoding::binary) {
      out_.text("<AppendedData encoding=\"raw\">\n_");
      for (const Appended& array : appended_) {
        out_.little_endian<std::uint64_t>(array.bytes);
        array.put(*this);
      }
      out_.text("\n</AppendedData>\n");
    }
    out_.text("</VTKFile>\n");
  }

private:
  struct Appended
  {
    std::uint64_t bytes;
    std::function<void(Vtp_writer&)> put;
  };

  void text_value(double x) { out_.number(x); }
  void text_value(std::uint8_t n) { out_.number(static_cast<std::uint64_t>(n)); }
  void text_value(std::int64_t n) { out_.number(static_cast<std::uint64_t>(n)); }

  // behind format="
  void content(const std::string& tag, std::size_t bytes, std::function<void(Vtp_writer&)> put)
  {
    if (encoding_ == Encoding::binary) {
      out_.text("appended\" offset=\"" + std::to_string(offset_) + "\"/>\n");
      offset_ += sizeof(std::uint64_t) + bytes;
      appended_.push_back({bytes, std::move(put)});
    } else {
      out_.text("ascii\">\n");
      put(*this);
      out_.text("\n</" + tag + ">\n");
    }
  }

  Output_file& out_;
  Encoding encoding_;
  std::uint64_t offset_ = 0;
  std::vector<Appended> appended_;
};

Vtp_array triples_array(const char* name, const std::vector<Triple>& values)
{
  return {"Float64", name, 3, 24 * values.size(), [&values](Vtp_writer& vtp) {
            for (const Triple& t : values)
              for (std::size_t i = 0; i < 3; ++i) vtp.value<double>(t[i], i == 2);
          }};
}

// The columns have one type.
Vtp_array columns_array(const std::string& name, const Column_group& group)
{
  const Scalar_type type = group[0]->type;
  const std::size_t size = group[0]->values.size();
  return {traits(type).vtk, name, group.size(), traits(type).bytes * group.size() * size,
          [group, type, size](Vtp_writer& vtp) {
            for (std::size_t i = 0; i < size; ++i)
              for (const Column* column : group)
                vtp.value_of_type(type, column->values[i], column == group.back());
          }};
}

Vtp_array texture_array(const std::vector<Texture_point>& values, Scalar_type type)
{
  return {traits(type).vtk, "TCoords", 2, 2 * traits(type).bytes * values.size(),
          [&values, type](Vtp_writer& vtp) {
            for (const Texture_point& t : values)
              for (std::size_t i = 0; i < 2; ++i) vtp.value_of_type(type, t[i], i == 1);
          }};
}

Vtp_array ids_array(const char* name, const std::vector<std::uint64_t>& ids)
{
  return {"Int64", name, 1, 8 * ids.size(), [&ids](Vtp_writer& vtp) {
            for (const std::uint64_t n : ids) vtp.value(static_cast<std::int64_t>(n), true);
          }};
}

// of a character of UTF-8 that begins with this byte; 0 if none does
std::size_t number_of_bytes(unsigned char first)
{
  if (first < 0x80) return 1;
  if (first < 0xc2) return 0; // a later byte, or a longer form than needed
  if (first < 0xe0) return 2;
  if (first < 0xf0) return 3;
  return first < 0xf5 ? 4 : 0;
}

// those of XML 1.0, each in its shortest form
bool is_xml_character(std::uint32_t code, std::size_t bytes)
{
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < 0x20) return code == '\t' || code == '\n' || code == '\r';
  const bool is_half_of_a_pair = code >= 0xd800 && code < 0xe000;
  return code >= least[bytes] && code < 0x110000 && !is_half_of_a_pair && code != 0xfffe &&
         code != 0xffff;
}

// The bytes of the character at the beginning; 0 if there is none of XML's.
std::size_t first_character(std::string_view text)
{
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t bytes = number_of_bytes(first);
  if (bytes == 0 || bytes > text.size()) return 0;
  std::uint32_t code = bytes == 1 ? first : first & (0xffu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xc0u) != 0x80) return 0;
    code = (code << 6) | (next & 0x3fu);
  }
  return is_xml_character(code, bytes) ? bytes : 0;
}

std::string escaped(std::string_view character)
{
  switch (character[0]) {
  case '&':
    return "&amp;";
  case '<':
    return "&lt;";
  case '>':
    return "&gt;";
  case '"':
    return "&quot;";
  case '\t':
    return "&#9;";
  case '\n':
    return "&#10;";
  case '\r':
    return "&#13;";
  default:
    return std::string(character);
  }
}

constexpr const char* ids_of_points = " GlobalIds=\"GlobalPointIds\"";
constexpr const char* ids_of_cells = " GlobalIds=\"GlobalCellIds\"";

struct Vtp_content
{
  Held_attributes held;
  Column_group vertex_color, face_color;
  std::vector<Texture_point> texture; // per vertex
  Column_group own_texture, scalars;  // of vertices
  Scalar_type corner_texture_type;
  Column roundness;

  explicit Vtp_content(const Mesh_data& mesh)
    : held(mesh)
    , vertex_color(find_color(mesh.attributes.of_vertices))
    , face_color(find_color(mesh.attributes.of_faces))
    , texture(texture_of_vertices(mesh))
    , corner_texture_type(mesh.attributes.texture_type)
  {
    const Attributes& attributes = mesh.attributes;
    roundness.values = mesh.roundness;
    held.take(all_of(attributes.of_vertices));
    held.take(all_of(attributes.of_faces));
    held.take_texture_files();
    held.take_material_files();
    if (has_depth(texture)) texture.clear();
    if (!texture.empty()) held.take_texture();
    if (attributes.texture.empty()) own_texture = find_texture(attributes.of_vertices);
    for (const Column& column : attributes.of_vertices)
      if (!contains(vertex_color, column) && !contains(own_texture, column))
        scalars.push_back(&column);
  }

  Scalar_type texture_type() const
  {
    return own_texture.empty() ? corner_texture_type : own_texture[0]->type;
  }
};

void write_field_data(Vtp_writer& vtp, const Attributes& attributes)
{
  const auto has_words = [](const Column& column) { return !column.words.empty(); };
  const Columns& columns = attributes.of_faces;
  if (attributes.texture_files.empty() && attributes.material_files.empty() &&
      std::none_of(columns.begin(), columns.end(), has_words))
    return;
  vtp.line("<FieldData>");
  for (const Column& column : columns)
    if (has_words(column)) vtp.words(column.name, column.words);
  if (!attributes.texture_files.empty()) vtp.words("texture files", attributes.texture_files);
  if (!attributes.material_files.empty()) vtp.words("material files", attributes.material_files);
  vtp.line("</FieldData>");
}

std::string attributes_of_points(const Vtp_content& content, bool has_normals, bool has_texture,
                                 bool has_ids)
{
  std::string tag;
  if (has_normals) tag += " Normals=\"Normals\"";
  if (!content.scalars.empty()) tag += " Scalars=\"" + xml_text(content.scalars[0]->name) + "\"";
  if (has_texture) tag += " TCoords=\"TCoords\"";
  return tag + (has_ids ? ids_of_points : "");
}

// of points and of cells, with the numbers that a piece has for them, if it is one
std::vector<Vtp_array> point_arrays(const Mesh_data& mesh, const Vtp_content& content,
                                    bool has_texture, const Vtp_ids* ids)
{
  std::vector<Vtp_array> arrays;
  if (mesh.has_normals()) arrays.push_back(triples_array("Normals", mesh.normals));
  if (mesh.has_control_normals())
    arrays.push_back(triples_array("control_normals", mesh.control_normals));
  if (!mesh.roundness.empty()) arrays.push_back(columns_array("roundness", {&content.roundness}));
  for (const Column* column : content.scalars)
    arrays.push_back(columns_array(column->name, {column}));
  if (!content.vertex_color.empty())
    arrays.push_back(columns_array("colors", content.vertex_color));
  if (has_texture) arrays.push_back(texture_array(content.texture, content.texture_type()));
  if (ids != nullptr) arrays.push_back(ids_array("GlobalPointIds", ids->points));
  return arrays;
}

std::vector<Vtp_array> cell_arrays(const Mesh_data& mesh, const Vtp_content& content,
                                   const Vtp_ids* ids)
{
  std::vector<Vtp_array> arrays;
  for (const Column& column : mesh.attributes.of_faces)
    if (!contains(content.face_color, column))
      arrays.push_back(columns_array(column.name, {&column}));
  if (!content.face_color.empty()) arrays.push_back(columns_array("colors", content.face_color));
  if (ids != nullptr) arrays.push_back(ids_array("GlobalCellIds", ids->cells));
  return arrays;
}

void write_data(Vtp_writer& vtp, const std::string& tag, const std::string& attributes,
                std::vector<Vtp_array> arrays)
{
  if (arrays.empty()) return;
  vtp.line("<" + tag + attributes + ">");
  for (Vtp_array& array : arrays) vtp.array(std::move(array));
  vtp.line("</" + tag + ">");
}

// As the file that names the pieces has them.
std::string tags_of(const std::vector<Vtp_array>& arrays)
{
  std::string text;
  for (const Vtp_array& a : arrays)
    text +=
      "<PDataArray type=\"" + a.type + "\" Name=\"" + xml_text(a.name) + "\"" +
      (a.components == 1 ? "" : " NumberOfComponents=\"" + std::to_string(a.components) + "\"") +
      "/>\n";
  return text;
}

} // namespace

std::string xml_text(const std::string& text)
{
  std::string s;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t bytes = first_character(rest);
    s += bytes == 0 ? "?" : escaped(rest.substr(0, bytes));
    rest.remove_prefix(bytes == 0 ? 1 : bytes);
  }
  return s;
}

bool is_xml_text(const std::string& text)
{
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t bytes = first_character(rest);
    if (bytes == 0) return false;
    rest.remove_prefix(bytes);
  }
  return true;
}

std::vector<std::string> not_held_by_vtp(const Mesh_data& mesh, Encoding)
{
  return Vtp_content(mesh).held.rest();
}

std::string pvtp_arrays(const Mesh_data& like, bool has_texture)
{
  const Vtp_content content(like);
  const Vtp_ids ids{};
  return "<PPointData" + attributes_of_points(content, like.has_normals(), has_texture, true) +
         ">\n" + tags_of(point_arrays(like, content, has_texture, &ids)) +
         "</PPointData>\n<PCellData" + ids_of_cells + ">\n" +
         tags_of(cell_arrays(like, content, &ids)) + "</PCellData>\n<PPoints>\n" +
         tags_of({triples_array("Points", like.points)}) + "</PPoints>\n";
}

void write_vtp(Output_file& out, const Mesh_data& mesh, Encoding encoding)
{
  write_vtp(out, mesh, encoding, nullptr);
}

void write_vtp(Output_file& out, const Mesh_data& mesh, Encoding encoding, const Vtp_ids* ids)
{
  const std::size_t faces = mesh.number_of_faces();
  const Vtp_content content(mesh);
  Vtp_writer vtp(out, encoding);
  vtp.begin(mesh.has_normals() ? comment_of(mesh.normal_kind) : "");
  write_field_data(vtp, mesh.attributes);
  vtp.begin_piece(mesh.points.size(), faces);
  const bool has_texture = !content.texture.empty(), has_ids = ids != nullptr;
  write_data(vtp, "PointData",
             attributes_of_points(content, mesh.has_normals(), has_texture, has_ids),
             point_arrays(mesh, content, has_texture, ids));
  write_data(vtp, "CellData", has_ids ? ids_of_cells : "", cell_arrays(mesh, content, ids));
  write_data(vtp, "Points", "", {triples_array("Points", mesh.points)});
  const auto connectivity = [&mesh, faces](Vtp_writer& to) {
    for (std::size_t f = 0; f < faces; ++f)
      for (const Index& v : mesh.face(f)) to.value<std::int64_t>(v, &v + 1 == mesh.face(f).end());
  };
  const auto offsets = [&mesh, faces](Vtp_writer& to) {
    for (std::size_t f = 0; f < faces; ++f)
      to.value(static_cast<std::int64_t>(mesh.first_corner(f) + mesh.face(f).size()), true);
  };
  write_data(vtp, "Polys", "",
             {{"Int64", "connectivity", 1, 8 * mesh.number_of_corners(), connectivity},
              {"Int64", "offsets", 1, 8 * faces, offsets}});
  vtp.end();
}

} // namespace pn_subdivide
