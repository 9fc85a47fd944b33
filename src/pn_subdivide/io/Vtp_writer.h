// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_VTP_WRITER_H
#define PN_SUBDIVIDE_VTP_WRITER_H

#include "io/Attributes.h"
#include "io/formats.h"
#include "io/mesh_io.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace pn_subdivide {

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

inline Vtp_array triples_array(const char* name, const std::vector<Triple>& values)
{
  return {"Float64", name, 3, 24 * values.size(), [&values](Vtp_writer& vtp) {
            for (const Triple& t : values)
              for (std::size_t i = 0; i < 3; ++i) vtp.value<double>(t[i], i == 2);
          }};
}

// The columns have one type.
inline Vtp_array columns_array(const std::string& name, const Column_group& group)
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

inline Vtp_array texture_array(const std::vector<Texture_point>& values, Scalar_type type)
{
  return {traits(type).vtk, "TCoords", 2, 2 * traits(type).bytes * values.size(),
          [&values, type](Vtp_writer& vtp) {
            for (const Texture_point& t : values)
              for (std::size_t i = 0; i < 2; ++i) vtp.value_of_type(type, t[i], i == 1);
          }};
}

inline Vtp_array ids_array(const char* name, const std::vector<std::uint64_t>& ids)
{
  return {"Int64", name, 1, 8 * ids.size(), [&ids](Vtp_writer& vtp) {
            for (const std::uint64_t n : ids) vtp.value(static_cast<std::int64_t>(n), true);
          }};
}

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_VTP_WRITER_H
