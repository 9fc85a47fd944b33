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

  void line(const char* xml)
  {
    out_.text(xml);
    out_.text("\n");
  }

  void triples(const char* name, const std::vector<Triple>& values)
  {
    triples(name, values.size(), [&values](std::size_t i) { return values[i]; });
  }
  // triple(i), which must stay until end() has been called
  void triples(const char* name, std::size_t number, std::function<Triple(std::size_t)> triple)
  {
    array_tag("Float64", name, 3, 24 * number, [this, number, triple = std::move(triple)] {
      for (std::size_t n = 0; n < number; ++n) {
        const Triple t = triple(n);
        for (std::size_t i = 0; i < 3; ++i) value<double>(t[i], i == 2);
      }
    });
  }

  // The columns have one type.
  void columns(const std::string& name, const Column_group& group)
  {
    const Scalar_type type = group[0]->type;
    const std::size_t size = group[0]->values.size();
    array_tag(traits(type).vtk, name, group.size(), traits(type).bytes * group.size() * size,
              [this, group, type, size] {
                for (std::size_t i = 0; i < size; ++i)
                  for (const Column* column : group)
                    column_value(type, column->values[i], column == group.back());
              });
  }

  void texture(const std::vector<Texture_point>& values, Scalar_type type)
  {
    const std::size_t bytes = 2 * traits(type).bytes * values.size();
    array_tag(traits(type).vtk, "TCoords", 2, bytes, [this, &values, type] {
      for (const Texture_point& t : values)
        for (std::size_t i = 0; i < 2; ++i) column_value(type, t[i], i == 1);
    });
  }

  // Text is the numbers of its characters, as VTK has it.
  void words(const std::string& name, const std::vector<std::string>& values)
  {
    std::size_t bytes = 0;
    for (const std::string& word : values) bytes += word.size() + 1;
    out_.text("<Array type=\"String\" Name=\"" + xml_text(name) + "\" NumberOfTuples=\"" +
              std::to_string(values.size()) + "\" format=\"");
    array_content("Array", bytes, [this, &values] {
      for (const std::string& word : values)
        for (std::size_t i = 0; i <= word.size(); ++i)
          value<std::uint8_t>(static_cast<std::uint8_t>(word.c_str()[i]), i == word.size());
    });
  }

  // One number per face, or several: `put(f)` writes them.
  void integers(const char* name, std::size_t number, std::function<void()> put)
  {
    array_tag("Int64", name, 1, 8 * number, std::move(put));
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

  void end()
  {
    out_.text("</Piece>\n</PolyData>\n");
    if (encoding_ == Encoding::binary) {
      out_.text("<AppendedData encoding=\"raw\">\n_");
      for (const Appended& array : appended_) {
        out_.little_endian<std::uint64_t>(array.bytes);
        array.put();
      }
      out_.text("\n</AppendedData>\n");
    }
    out_.text("</VTKFile>\n");
  }

private:
  struct Appended
  {
    std::uint64_t bytes;
    std::function<void()> put;
  };

  void text_value(double x) { out_.number(x); }
  void text_value(std::uint8_t n) { out_.number(static_cast<std::uint64_t>(n)); }
  void text_value(std::int64_t n) { out_.number(static_cast<std::uint64_t>(n)); }

  void column_value(Scalar_type type, double x, bool ends_line)
  {
    if (encoding_ == Encoding::binary)
      write_little_endian(out_, type, x);
    else
      value<double>(x, ends_line);
  }

  void array_tag(const char* type, const std::string& name, std::size_t components,
                 std::size_t bytes, std::function<void()> put)
  {
    out_.text(std::string("<DataArray type=\"") + type + "\" Name=\"" + xml_text(name) +
              "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"");
    array_content("DataArray", bytes, std::move(put));
  }

  // behind format="
  void array_content(const std::string& tag, std::size_t bytes, std::function<void()> put)
  {
    if (encoding_ == Encoding::binary) {
      out_.text("appended\" offset=\"" + std::to_string(offset_) + "\"/>\n");
      offset_ += sizeof(std::uint64_t) + bytes;
      appended_.push_back({bytes, std::move(put)});
    } else {
      out_.text("ascii\">\n");
      put();
      out_.text("\n</" + tag + ">\n");
    }
  }

  Output_file& out_;
  Encoding encoding_;
  std::uint64_t offset_ = 0;
  std::vector<Appended> appended_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_VTP_WRITER_H
