// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// In a program with MPI: the ranks of mpirun, or this process alone without it.

#include "io/Error.h"
#include "pieces/Ranks.h"

#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace pn_subdivide {
namespace {

// Files report their errors, everything else of MPI ends the run by itself.
void check_file(int code)
{
  if (code == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(code, text, &length);
  throw Error("writing failed: " + std::string(text, static_cast<std::size_t>(length)));
}

class Mpi_file : public Shared_file
{
public:
  explicit Mpi_file(const std::filesystem::path& file)
    : path_(file)
  {
    check_file(MPI_File_open(MPI_COMM_WORLD, file.c_str(), MPI_MODE_WRONLY, MPI_INFO_NULL, &file_));
  }

  void write(std::uint64_t place, const void* data, std::size_t bytes) override
  {
    const char* begin = static_cast<const char*>(data);
    constexpr std::size_t most = 1 << 30;
    while (bytes > 0) {
      MPI_Status status;
      int written = 0;
      check_file(MPI_File_write_at(file_, static_cast<MPI_Offset>(place), begin,
                                   static_cast<int>((std::min)(bytes, most)), MPI_BYTE, &status));
      MPI_Get_count(&status, MPI_BYTE, &written);
      if (written <= 0) throw Error("writing failed: the disk may be full");
      begin += written;
      bytes -= static_cast<std::size_t>(written);
      place += static_cast<std::uint64_t>(written);
    }
  }

  // MPI_File_sync() would wait for all ranks
  void sync() override { sync_file(path_); }
  // waits for all ranks, which is why the destructor does not
  void close() override { check_file(MPI_File_close(&file_)); }

private:
  std::filesystem::path path_;
  MPI_File file_;
};

class Mpi_ranks : public Ranks
{
public:
  Mpi_ranks()
  {
    int given = 0, rank = 0, number = 1;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &number);
    rank_ = static_cast<unsigned>(rank);
    number_ = static_cast<unsigned>(number);
  }

  void begin_work() override
  {
    has_begun_ = true;
    if (first_failing(number_) == number_) return;
    ends_together_ = true;
    leave_report_to_others();
    throw Failure_of_another_rank();
  }
  void wait_for_all() override { MPI_Barrier(MPI_COMM_WORLD); }
  void take_largest(std::vector<double>& numbers) override { reduce(numbers, MPI_MAX); }
  void take_sums(std::vector<double>& numbers) override { reduce(numbers, MPI_SUM); }
  std::unique_ptr<Shared_file> open(const std::filesystem::path& file) override
  {
    return std::make_unique<Mpi_file>(file);
  }

  bool reports_failure() override
  {
    if (has_begun_) return is_reporter_;
    has_begun_ = true;
    ends_together_ = true;
    return first_failing(rank_) == rank_;
  }

  void end(int code) override
  {
    if (code != 0 && !ends_together_) MPI_Abort(MPI_COMM_WORLD, code);
    MPI_Finalize();
  }

private:
  static void reduce(std::vector<double>& numbers, MPI_Op op)
  {
    MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, op,
                  MPI_COMM_WORLD);
  }
  static unsigned first_failing(unsigned rank)
  {
    unsigned first = rank;
    MPI_Allreduce(&rank, &first, 1, MPI_UNSIGNED, MPI_MIN, MPI_COMM_WORLD);
    return first;
  }

  bool has_begun_ = false, ends_together_ = false;
};

bool is_under_mpirun()
{
  for (const char* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMI_RANK", "PMIX_RANK"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

} // namespace

Ranks& ranks()
{
  // MPI takes its time to start, and nobody should wait for it who works alone.
  static const std::unique_ptr<Ranks> all =
    is_under_mpirun() ? std::unique_ptr<Ranks>(new Mpi_ranks) : std::make_unique<Ranks>();
  return *all;
}

} // namespace pn_subdivide
