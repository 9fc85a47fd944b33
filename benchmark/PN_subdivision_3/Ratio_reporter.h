// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef CGAL_PN_SUBDIVISION_3_BENCHMARK_RATIO_REPORTER_H
#define CGAL_PN_SUBDIVISION_3_BENCHMARK_RATIO_REPORTER_H

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <map>
#include <regex>
#include <string>
#include <vector>

// the group of a job `name/size/job`
inline std::string group_of(const std::string& name)
{
  return name.substr(0, name.rfind('/'));
}

// Prints as usual, and keeps the medians: the ratios of a group `name/size/job` are to its first
// job.
class Ratio_reporter : public benchmark::ConsoleReporter
{
public:
  bool ReportContext(const Context& context) override
  {
    if (!medians_.empty()) return true; // of the groups after the first
    return benchmark::ConsoleReporter::ReportContext(context);
  }

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
      if (group_of(name) != group) {
        group = group_of(name);
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

// Runs the jobs of one group that the user's filter lets pass.
inline void run_group(const std::string& group, const std::vector<std::string>& names,
                      const std::string& filter, Ratio_reporter& reporter)
{
  const std::regex passes(filter.empty() ? "." : filter);
  std::string jobs;
  for (const std::string& name : names)
    if (group_of(name) == group && std::regex_search(name + "/", passes))
      jobs += (jobs.empty() ? "" : "|") + name;
  if (!jobs.empty()) benchmark::RunSpecifiedBenchmarks(&reporter, "^(" + jobs + ")(/|$)");
}

// The main() of a benchmark: group after group, the jobs of a group interleaved, so that a change of
// the machine's speed meets all that are compared alike, and so that a small job is not timed with
// the caches as a job ten times as large has left them. `add_jobs()` registers the jobs and returns
// their names in this order; arguments of the command line overrule the number of repetitions and
// the rest (a file of --benchmark_out holds the group that was run last).
template <class Add_jobs>
int run_and_print_ratios(int argc, char** argv, int repetitions, const Add_jobs& add_jobs)
{
  std::vector<std::string> defaults = {
    argv[0], "--benchmark_repetitions=" + std::to_string(repetitions),
    "--benchmark_enable_random_interleaving=true", "--benchmark_report_aggregates_only=true"};
  std::vector<char*> arguments;
  for (std::string& s : defaults) arguments.push_back(s.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return EXIT_FAILURE;
  const std::vector<std::string> names = add_jobs();
  const std::string filter = benchmark::GetBenchmarkFilter();
  Ratio_reporter reporter;
  std::string last_group;
  for (const std::string& name : names) {
    if (group_of(name) == last_group) continue;
    last_group = group_of(name);
    run_group(last_group, names, filter, reporter);
  }
  reporter.print_ratios(names);
  return EXIT_SUCCESS;
}

#endif // CGAL_PN_SUBDIVISION_3_BENCHMARK_RATIO_REPORTER_H
