// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_TEST_REFINED_FILES_H
#define PN_TEST_REFINED_FILES_H

#include "Command_test.h"

#include "io/mesh_io.h"

#include <gtest/gtest.h>

#include <string>

namespace pn_subdivide {

// Files of the test's folder, refined by the command.
class Refined_files : public Command_test
{
protected:
  Outcome surface(const std::string& input, const std::string& output,
                  const std::string& options) const
  {
    return run("surface '" + folder.file(input) + "' '" + folder.file(output) + "' --quiet " +
               options);
  }

  std::string written(const std::string& input, const std::string& output,
                      const std::string& options) const
  {
    const Outcome outcome = surface(input, output, options);
    EXPECT_EQ(outcome.code, 0) << options << outcome.err;
    return Temporary_folder::content(folder.file(output));
  }

  Mesh_data refined(const std::string& input, const std::string& output,
                    const std::string& options) const
  {
    written(input, output, options);
    return read_mesh(folder.file(output));
  }
};

} // namespace pn_subdivide

#endif // PN_TEST_REFINED_FILES_H
