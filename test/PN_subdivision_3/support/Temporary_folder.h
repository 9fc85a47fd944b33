// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVISION_3_TEST_TEMPORARY_FOLDER_H
#define PN_SUBDIVISION_3_TEST_TEMPORARY_FOLDER_H

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

// A folder of its own for each test, removed with everything in it.
class Temporary_folder
{
public:
  Temporary_folder()
    : path_(std::filesystem::temp_directory_path() /
            ("pn_subdivide_test_" + std::to_string(std::random_device()()) + "_" +
             std::to_string(std::random_device()())))
  {
    std::filesystem::create_directories(path_);
  }
  ~Temporary_folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }

  std::string write(const std::string& name, const std::string& content) const
  {
    std::ofstream(file(name), std::ios::binary) << content;
    return file(name);
  }

  static std::string content(const std::string& file)
  {
    std::ifstream in(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  }

  std::size_t number_of_files() const
  {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

private:
  std::filesystem::path path_;
};

#endif // PN_SUBDIVISION_3_TEST_TEMPORARY_FOLDER_H
