// Copyright (c) 2026  PN_subdivision_3 developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_SURFACE_SCHEMES_H
#define PN_SUBDIVIDE_SURFACE_SCHEMES_H

#include "io/Mesh_data.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace pn_subdivide {

struct Refinement
{
  unsigned levels = 1;
  unsigned threads = 1;
  std::function<void(unsigned, std::size_t)> round_done; // (round, faces), after each round
};

struct Scheme_choice
{
  std::string scheme;
  std::optional<std::string> normal_scheme; // the scheme's own mask if there is none
  std::optional<double> tension;            // Kobbelt's
  std::optional<double> cap;                // that of the modified schemes
};

// Throws Usage_error if there is no such scheme, or if these do not go together.
void require_surface_schemes(const Scheme_choice& choice);

// Throws Usage_error if this program was built without TBB and there is more than one thread.
void require_threads(unsigned threads);

// Refines with the scheme, point-normal if `mesh` has normals, linear if not. Old vertices come
// first in the result, in their order, but for Doo-Sabin. Passes on the library's exceptions.
Mesh_data refine_surface(const Mesh_data& mesh, const Scheme_choice& choice,
                         const Refinement& refinement);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_SURFACE_SCHEMES_H
