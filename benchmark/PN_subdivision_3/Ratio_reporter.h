// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_BENCHMARK_RATIO_REPORTER_H
#define CGAL_PN_SUBDIVISION_3_BENCHMARK_RATIO_REPORTER_H

#include <benchmark/benchmark.h>

#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

// Prints as usual, and keeps the medians: the ratios of a group `name/size/job` are to its first job.
class Ratio_reporter : public benchmark::ConsoleReporter
{
public:
  void ReportRuns(const std::vector<Run>& runs) override
  {
    benchmark::ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      if (run.aggregate_name == "median")
        medians_.emplace_back(run.run_name.function_name, run.GetAdjustedRealTime());
  }

  void print_ratios() const
  {
    std::cout << "\nRatios of medians to the first job of each group\n";
    std::string group;
    double first = 0;
    for (const auto& [name, time] : medians_) {
      const std::string of = name.substr(0, name.rfind('/'));
      if (of != group) {
        group = of;
        first = time;
      }
      std::cout << std::left << std::setw(48) << name << std::right << std::fixed
                << std::setprecision(3) << std::setw(10) << time << " ms" << std::setw(9)
                << time / first << '\n';
    }
  }

private:
  std::vector<std::pair<std::string, double>> medians_;
};

#endif // CGAL_PN_SUBDIVISION_3_BENCHMARK_RATIO_REPORTER_H
