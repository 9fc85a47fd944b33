// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/formats.h"
#include "io/write_text.h"

#include <functional>
#include <string>
#include <vector>

namespace pn_subdivide {
namespace {

// VTK's XML poly data. Binary data stand behind the XML part ("appended", "raw"): each array is its
// number of bytes as UInt64 and then its values.
class Vtp_writer
{
public:
  Vtp_writer(Output_file& out, Encoding encoding)
    : out_(out)
    , encoding_(encoding)
  {}

  void begin(std::size_t points, std::size_t polygons)
  {
    out_.text(R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData>
<Piece NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPoints=")");
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
    array_tag("Float64", name, 3, 24 * values.size(), [this, &values] {
      for (const Triple& t : values)
        for (std::size_t i = 0; i < 3; ++i) value<double>(t[i], i == 2);
    });
  }

  void scalars(const std::string& name, const std::vector<double>& values)
  {
    array_tag("Float64", name, 1, 8 * values.size(), [this, &values] {
      for (const double x : values) value<double>(x, true);
    });
  }

  void colors(const std::vector<Color>& values)
  {
    array_tag("UInt8", "colors", 3, 3 * values.size(), [this, &values] {
      for (const Color& c : values)
        for (std::size_t i = 0; i < 3; ++i) value<std::uint8_t>(c[i], i == 2);
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

  void array_tag(const char* type, const std::string& name, std::size_t components,
                 std::size_t bytes, std::function<void()> put)
  {
    out_.text(std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
              "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"");
    if (encoding_ == Encoding::binary) {
      out_.text("appended\" offset=\"" + std::to_string(offset_) + "\"/>\n");
      offset_ += sizeof(std::uint64_t) + bytes;
      appended_.push_back({bytes, std::move(put)});
    } else {
      out_.text("ascii\">\n");
      put();
      out_.text("\n</DataArray>\n");
    }
  }

  Output_file& out_;
  Encoding encoding_;
  std::uint64_t offset_ = 0;
  std::vector<Appended> appended_;
};

void write_point_data(Vtp_writer& vtp, const Mesh_data& mesh)
{
  if (!mesh.has_normals() && mesh.scalars.empty() && mesh.colors.empty()) return;
  std::string tag = "<PointData";
  if (mesh.has_normals()) tag += " Normals=\"Normals\"";
  if (!mesh.scalars.empty()) tag += " Scalars=\"" + mesh.scalar_name + "\"";
  vtp.line((tag + ">").c_str());
  if (mesh.has_normals()) vtp.triples("Normals", mesh.normals);
  if (!mesh.scalars.empty()) vtp.scalars(mesh.scalar_name, mesh.scalars);
  if (!mesh.colors.empty()) vtp.colors(mesh.colors);
  vtp.line("</PointData>");
}

} // namespace

void write_vtp(Output_file& out, const Mesh_data& mesh, Encoding encoding)
{
  const std::size_t faces = mesh.number_of_faces();
  Vtp_writer vtp(out, encoding);
  vtp.begin(mesh.points.size(), faces);
  write_point_data(vtp, mesh);
  vtp.line("<Points>");
  vtp.triples("Points", mesh.points);
  vtp.line("</Points>\n<Polys>");
  vtp.integers("connectivity", mesh.number_of_corners(), [&] {
    for (std::size_t f = 0; f < faces; ++f)
      for (const Mesh_data::Index& v : mesh.face(f))
        vtp.value<std::int64_t>(v, &v + 1 == mesh.face(f).end());
  });
  vtp.integers("offsets", faces, [&] {
    std::int64_t end = 0;
    for (std::size_t f = 0; f < faces; ++f) {
      end += static_cast<std::int64_t>(mesh.face(f).size());
      vtp.value<std::int64_t>(end, true);
    }
  });
  vtp.line("</Polys>");
  vtp.end();
}

} // namespace pn_subdivide
