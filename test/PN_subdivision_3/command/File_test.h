// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_TEST_FILE_TEST_H
#define PN_TEST_FILE_TEST_H

// What tests of the readers and writers share.

#include "Command_test.h"

#include "io/Error.h"
#include "io/formats.h"
#include "io/mesh_io.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace pn_subdivide {

// So that -0, NaN and the last bit count.
inline std::vector<std::uint64_t> bits(const std::vector<double>& numbers)
{
  std::vector<std::uint64_t> result(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (std::isnan(numbers[i]))
      result[i] = ~std::uint64_t(0);
    else
      std::memcpy(&result[i], &numbers[i], sizeof(double));
  return result;
}
inline std::vector<std::uint64_t> bits(const std::vector<Triple>& triples)
{
  std::vector<double> numbers;
  for (const Triple& t : triples) numbers.insert(numbers.end(), t.begin(), t.end());
  return bits(numbers);
}

template <class T>
std::string raw(T x, bool big_endian)
{
  std::string s(sizeof(T), '\0');
  std::memcpy(&s[0], &x, sizeof(T));
  const std::uint16_t one = 1;
  const bool host_is_big_endian = *reinterpret_cast<const unsigned char*>(&one) == 0;
  return big_endian == host_is_big_endian ? s : std::string(s.rbegin(), s.rend());
}

// the numbers of an array of a VTP file with raw data
template <class T>
std::vector<T> raw_array(const std::string& vtp, const std::string& name)
{
  const std::size_t tag = vtp.find("Name=\"" + name + "\"");
  if (tag == std::string::npos) return {};
  const std::size_t offset = std::stoul(vtp.substr(vtp.find("offset=\"", tag) + 8));
  const std::size_t begin = vtp.find("\n_", vtp.find("<AppendedData")) + 2 + offset;
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, vtp.data() + begin, sizeof bytes);
  std::vector<T> values(bytes / sizeof(T));
  std::memcpy(values.data(), vtp.data() + begin + sizeof bytes, bytes);
  return values;
}

class File_test : public testing::Test
{
protected:
  Mesh_data read(const std::string& name, const std::string& content,
                 bool with_attributes = true) const
  {
    return read_mesh(input_mesh_file(folder.write(name, content), std::nullopt), with_attributes);
  }
  Mesh_data written_and_read(const std::string& name, const Mesh_data& mesh,
                             Encoding encoding = Encoding::binary) const
  {
    write_mesh(folder.file(name), mesh, encoding);
    return read_mesh(folder.file(name));
  }

  static std::string error_of(const std::string& file)
  {
    try {
      read_mesh(file);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  }
  // one line that begins with the file's name and holds `part`
  void expect_error(const std::string& name, const std::string& content,
                    const std::string& part) const
  {
    const std::string file = folder.write(name, content), message = error_of(file);
    EXPECT_EQ(message.rfind(file + ": ", 0), 0u) << message;
    expect_part(message, part);
    expect_no_part(message, "\n");
  }

  Temporary_folder folder;
};

} // namespace pn_subdivide

#endif // PN_TEST_FILE_TEST_H
