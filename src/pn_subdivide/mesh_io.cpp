// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "mesh_io.h"

#include "Error.h"
#include "Output_file.h"
#include "formats.h"

#include <boost/algorithm/string/case_conv.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

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

std::string content_of(const std::string& file)
{
  if (std::filesystem::is_directory(file)) throw Error("this is a directory, not a mesh file");

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"),
                                                           std::fclose);
  if (!in) throw Error(std::string("cannot be opened: ") + std::strerror(errno));

  std::string content;
  std::string block(1 << 20, '\0');
  while (const std::size_t n = std::fread(&block[0], 1, block.size(), in.get()))
    content.append(block, 0, n);
  if (std::ferror(in.get())) throw Error(std::string("cannot be read: ") + std::strerror(errno));
  if (content.empty()) throw Error("the file is empty");
  return content;
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
    return reader(content_of(file));
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
