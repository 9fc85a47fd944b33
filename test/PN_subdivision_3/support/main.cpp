// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// main() of the GoogleTest programs, each of which is one entry of ctest: tells how to run a test that fails alone, and
// names tests that are skipped without a reason, for scripts/test_logs.py. Single tests of long_tests.txt are left to PN_TEST_FULL,
// unless a filter is given.

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <utility>

namespace {

class Advice : public testing::EmptyTestEventListener
{
public:
  explicit Advice(std::string program)
    : program_(std::move(program))
  {}

private:
  void OnTestEnd(const testing::TestInfo& test) override
  {
    const std::string name = std::string(test.test_suite_name()) + '.' + test.name();
    if (test.result()->Failed())
      std::printf("alone: '%s' --gtest_filter='%s'\n", program_.c_str(), name.c_str());
    else if (test.result()->Skipped() && !says_why(*test.result()))
      std::printf("left out: %s is skipped, and does not say why\n", name.c_str());
  }

  static bool says_why(const testing::TestResult& result)
  {
    for (int i = 0; i < result.total_part_count(); ++i) {
      const std::string text = std::string("\n") + result.GetTestPartResult(i).message();
      if (text.find("\nleft out: ") != text.npos || text.find("\ndoes not apply: ") != text.npos)
        return true;
    }
    return false;
  }

  std::string program_;
};

} // namespace

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
#ifdef PN_LONG_CASES
  if (testing::GTEST_FLAG(filter) == "*") testing::GTEST_FLAG(filter) = "-" PN_LONG_CASES;
#endif
  testing::UnitTest::GetInstance()->listeners().Append(new Advice(argv[0])); // which owns it
  return RUN_ALL_TESTS();
}
