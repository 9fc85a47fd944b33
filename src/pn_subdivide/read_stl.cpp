// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "Error.h"
#include "formats.h"

#include <CGAL/IO/STL.h>

#include <boost/endian/conversion.hpp>

#include <array>
#include <sstream>

namespace pn_subdivide {
namespace {

constexpr std::size_t header_size = 84, facet_size = 50;

std::size_t announced_facets(const std::string& content)
{
  if (content.size() < header_size) return 0;
  return boost::endian::load_little_u32(reinterpret_cast<const unsigned char*>(content.data()) +
                                        header_size - 4);
}

bool is_binary(const std::string& content)
{
  return content.size() >= header_size &&
         content.size() == header_size + facet_size * announced_facets(content);
}

bool is_text(const std::string& content)
{
  const std::size_t begin = content.find_first_not_of(" \t\r\n");
  return begin != std::string::npos && content.compare(begin, 5, "solid") == 0;
}

// CGAL's reader takes a file that is too short for an empty mesh and one that is too long for its
// beginning; the size tells.
void require_stl(const std::string& content)
{
  if (is_binary(content) || is_text(content)) return;
  if (content.size() < header_size)
    throw Error("not an STL file: neither text that begins with 'solid' nor long enough for a "
                "binary one");
  throw Error("not an STL file or truncated: it is no text that begins with 'solid', and a binary "
              "file with the " +
              std::to_string(announced_facets(content)) + " triangles it announces has " +
              std::to_string(header_size + facet_size * announced_facets(content)) +
              " bytes, not " + std::to_string(content.size()));
}

} // namespace

Mesh_data read_stl(const std::string& content)
{
  require_stl(content);

  Mesh_data mesh;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::istringstream in(content);
  if (!CGAL::IO::read_STL(in, mesh.points, triangles))
    throw Error("damaged or truncated STL file: text must hold 'solid', triangles as 'facet' ... "
                "'endfacet' with three times 'vertex x y z', and 'endsolid'");
  for (const auto& triangle : triangles) mesh.add_face(triangle);
  return mesh;
}

} // namespace pn_subdivide
