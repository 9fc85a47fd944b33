// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "io/mesh_io.h"

#include "io/Error.h"
#include "io/Output_file.h"
#include "io/file_content.h"
#include "io/formats.h"

#include <boost/algorithm/string/case_conv.hpp>

#include <filesystem>

namespace pn_subdivide {
namespace {

template <class Function>
struct Format
{
  const char* extension;
  Function function;
};

using Reader = Mesh_data (*)(const std::string&);
using Writer = void (*)(Output_file&, const Mesh_data&, Encoding);

const Format<Reader> readers[] = {
  {".ply", read_ply}, {".off", read_off}, {".obj", read_obj}, {".stl", read_stl}};
const Format<Writer> writers[] = {
  {".ply", write_ply}, {".off", write_off}, {".obj", write_obj}, {".vtp", write_vtp}};

template <class Function, std::size_t n>
Function find_format(const Format<Function> (&formats)[n], const std::string& file,
                     const std::string& action)
{
  const std::string extension =
    boost::algorithm::to_lower_copy(std::filesystem::path(file).extension().string());
  std::string known;
  for (const auto& format : formats) {
    if (extension == format.extension) return format.function;
    known += std::string(" ") + format.extension;
  }
  throw Usage_error(file + ": the file name must end in one of" + known + " to be " + action);
}

} // namespace

void require_readable_format(const std::string& file)
{
  find_format(readers, file, "read");
}
void require_writable_format(const std::string& file)
{
  find_format(writers, file, "written");
}

bool holds_scalars(const std::string& file)
{
  const Writer writer = find_format(writers, file, "written");
  return writer == write_ply || writer == write_vtp;
}

void require_writable_place(const std::string& file)
{
  try {
    Output_file::check(file);
  } catch (const Error& e) {
    throw Error(file + ": " + e.what());
  }
}

Mesh_data read_mesh(const std::string& file)
{
  const Reader reader = find_format(readers, file, "read");
  try {
    return reader(file_content(file));
  } catch (const std::exception& e) {
    throw Error(file + ": " + e.what());
  }
}

void write_mesh(const std::string& file, const Mesh_data& mesh, Encoding encoding)
{
  const Writer writer = find_format(writers, file, "written");
  try {
    Output_file out(file);
    writer(out, mesh, encoding);
    out.commit();
  } catch (const std::exception& e) {
    throw Error(file + ": " + e.what());
  }
}

} // namespace pn_subdivide
