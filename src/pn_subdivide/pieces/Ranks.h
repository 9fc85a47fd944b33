// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_RANKS_H
#define PN_SUBDIVIDE_RANKS_H

#include <boost/crc.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace pn_subdivide {

// that of ECMA-182
using Checksum = boost::crc_optimal<64, 0x42f0e1eba9ea3693u, ~0ull, ~0ull, true, true>;

inline std::string text_of(const Checksum& checksum)
{
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(checksum.checksum()));
  return text;
}

// A file into which several processes write at places of their own. Throws Error where something fails.
class Shared_file
{
public:
  virtual ~Shared_file() = default;

  virtual void write(std::uint64_t place, const void* data, std::size_t bytes) = 0;
  // until everything is on the disk
  virtual void sync() = 0;
  // Errors that the system kept back come out here. Otherwise the destructor closes, without a word.
  virtual void close() = 0;
};

// Throws Error if there is such a file already.
void create_file(const std::filesystem::path& file, std::uint64_t bytes);

// Until what any process of this machine wrote into a file, or the names in a folder, are on the disk.
void sync_file(const std::filesystem::path& file);

// An existing file.
std::unique_ptr<Shared_file> open_file(const std::filesystem::path& file);

// Another rank fails, and says why.
struct Failure_of_another_rank : std::runtime_error
{
  Failure_of_another_rank()
    : std::runtime_error("another rank failed")
  {}
};

// The processes that share the work: the ranks of mpirun, or this process alone.
class Ranks
{
public:
  virtual ~Ranks() = default;

  unsigned rank() const { return rank_; }
  unsigned number() const { return number_; }

  // To be called by all. What fails before it fails in all ranks, or is known to all here: throws
  // Failure_of_another_rank.
  virtual void begin_work() {}
  // to be called by all
  virtual void wait_for_all() {}
  // Each number becomes the largest one of all ranks, or their sum. To be called by all.
  virtual void take_largest(std::vector<double>& /*numbers*/) {}
  virtual void take_sums(std::vector<double>& /*numbers*/) {}
  // to be called by all
  virtual std::unique_ptr<Shared_file> open(const std::filesystem::path& file)
  {
    return open_file(file);
  }

  // Another rank has said, or will say, why the work ends.
  void leave_report_to_others() { is_reporter_ = number_ == 1; }
  // To be called once by a rank that fails: is it the one to say so?
  virtual bool reports_failure() { return is_reporter_; }
  // To be called last. With a code other than 0 all ranks end.
  virtual void end(int /*code*/) {}

protected:
  unsigned rank_ = 0, number_ = 1;
  bool is_reporter_ = true;
};

// Those of this run. Throws Usage_error under mpirun if the program was built without MPI.
Ranks& ranks();

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_RANKS_H
