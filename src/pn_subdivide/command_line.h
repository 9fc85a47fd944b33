// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_COMMAND_LINE_H
#define PN_SUBDIVIDE_COMMAND_LINE_H

#include "curve/curve_command.h"
#include "surface/surface_command.h"

#include <variant>

namespace pn_subdivide {

// std::monostate: help or the version was asked for and has been printed.
using Command = std::variant<std::monostate, Surface_options, Curve_options>;

// Throws Usage_error.
Command parse_command_line(int argc, char** argv);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_COMMAND_LINE_H
