// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What is said of what is refused.

#ifndef CGAL_PN_SUBDIVISION_3_TEST_MESSAGES_H
#define CGAL_PN_SUBDIVISION_3_TEST_MESSAGES_H

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace messages {

// nothing where nothing is thrown
template <class Exception = std::invalid_argument, class Call>
std::string message_of(const Call& call)
{
  try {
    call();
  } catch (const Exception& e) {
    return e.what();
  }
  return "";
}

inline void expect_words(const std::string& message, const std::vector<std::string>& words)
{
  for (const std::string& word : words)
    EXPECT_NE(message.find(word), std::string::npos) << "no \"" << word << "\" in: " << message;
}

template <class Exception = std::invalid_argument, class Call>
void expect_refused(const Call& call, const std::vector<std::string>& words)
{
  expect_words(message_of<Exception>(call), words);
}

} // namespace messages

#endif // CGAL_PN_SUBDIVISION_3_TEST_MESSAGES_H
