// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_OUTPUT_FILE_H
#define PN_SUBDIVIDE_OUTPUT_FILE_H

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace pn_subdivide {

// While it lives, a signal that ends the program (an interrupt at the keyboard, a closed terminal,
// kill) removes the file first. Signals that the caller ignores, as nohup does, stay ignored.
class Temporary_on_signal
{
public:
  // With pieces it is a folder with files piece_0.vtp, piece_1.vtp, ..., of which some may be there.
  explicit Temporary_on_signal(const std::string& file, std::size_t pieces = 0);
  ~Temporary_on_signal();
  Temporary_on_signal(const Temporary_on_signal&) = delete;
  Temporary_on_signal& operator=(const Temporary_on_signal&) = delete;

private:
  std::size_t slot_;
};

// Writes a file that appears as a whole, or not at all: everything goes into a temporary file in
// the same folder, which `commit()` gives its name. Links are followed, also to files that are not
// there yet. Devices, pipes and standard output ("-") cannot be replaced: for them everything is
// collected in a file without name, and `commit()` passes it on.
class Output_file
{
public:
  // Throws Error if it can be seen without touching anything that the file cannot be written.
  static void check(const std::string& file);

  // What a link leads to. Throws Error as check() does, and if the file is a device or a pipe.
  static std::filesystem::path regular_target(const std::string& file);

  // Throws Error if the file cannot be written.
  explicit Output_file(const std::string& file);
  // A new file in a folder that is temporary as a whole: no second temporary file, whose name nobody
  // would know if the process is killed.
  struct In_temporary_folder
  {};
  Output_file(const std::string& file, In_temporary_folder);
  ~Output_file();
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  void text(std::string_view s);
  void number(double x); // 17 significant digits
  void number(std::uint64_t n);

  template <class T>
  void little_endian(T x)
  {
    unsigned char bytes[sizeof(T)];
    boost::endian::endian_store<T, sizeof(T), boost::endian::order::little>(bytes, x);
    text(std::string_view(reinterpret_cast<const char*>(bytes), sizeof(T)));
  }

  // Throws Error if anything did not reach the file; the old file is then still there.
  void commit();

private:
  Output_file();
  void open_temporary();
  void flush();
  void close();
  void pass_on();

  std::filesystem::path target_, temporary_; // `temporary_` is empty where nothing is replaced
  std::unique_ptr<Temporary_on_signal> removal_;
  std::FILE* file_ = nullptr;
  std::string buffer_;
};

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_OUTPUT_FILE_H
