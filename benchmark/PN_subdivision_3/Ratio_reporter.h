// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_BENCHMARK_RATIO_REPORTER_H
#define CGAL_PN_SUBDIVISION_3_BENCHMARK_RATIO_REPORTER_H

#include <benchmark/benchmark.h>

#include <iomanip>
#include <iostream>
#include <map>
#include <string>
#include <vector>

// Prints as usual, and keeps the medians: the ratios of a group `name/size/job` are to its first
// job.
class Ratio_reporter : public benchmark::ConsoleReporter
{
public:
  void ReportRuns(const std::vector<Run>& runs) override
  {
    benchmark::ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      if (run.aggregate_name == "median")
        medians_[run.run_name.function_name] = run.GetAdjustedRealTime();
  }

  // names in the order of registration; jobs that a filter has left out are skipped
  void print_ratios(const std::vector<std::string>& names) const
  {
    std::cout << "\nMedians, and their ratios to the first job of each group\n";
    std::string group;
    double first = 0;
    for (const std::string& name : names) {
      const auto median = medians_.find(name);
      if (median == medians_.end()) continue;
      if (name.substr(0, name.rfind('/')) != group) {
        group = name.substr(0, name.rfind('/'));
        first = median->second;
      }
      std::cout << std::left << std::setw(48) << name << std::right << std::fixed
                << std::setprecision(3) << std::setw(10) << median->second << " ms" << std::setw(9)
                << median->second / first << '\n';
    }
  }

private:
  std::map<std::string, double> medians_;
};

#endif // CGAL_PN_SUBDIVISION_3_BENCHMARK_RATIO_REPORTER_H
