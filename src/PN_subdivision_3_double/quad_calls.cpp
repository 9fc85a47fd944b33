// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#include "compiled_calls.h"

#include <CGAL/PN_subdivision_3/schemes/CatmullClark_scheme.h>
#include <CGAL/PN_subdivision_3/schemes/DooSabin_scheme.h>

namespace CGAL {
namespace PN_subdivision_3 {
namespace internal {

template void compiled_call(Cartesian::Mesh&, const CatmullClark_scheme&, unsigned, Rounds_done,
                            Cartesian::Points, Cartesian::Normals, No_constraint_map);
template void compiled_call(Cartesian::Mesh&, const CatmullClark_scheme&, unsigned, Rounds_done,
                            Cartesian::Points, Cartesian::Normals, Cartesian::Edges);
template void compiled_call(Cartesian::Mesh&, const CatmullClark_scheme&, unsigned, Rounds_done,
                            Cartesian::Points, No_normal_map, No_constraint_map);
template void compiled_call(Cartesian::Mesh&, const CatmullClark_scheme&, unsigned, Rounds_done,
                            Cartesian::Points, No_normal_map, Cartesian::Edges);
template void compiled_call(Inexact::Mesh&, const CatmullClark_scheme&, unsigned, Rounds_done,
                            Inexact::Points, Inexact::Normals, No_constraint_map);
template void compiled_call(Inexact::Mesh&, const CatmullClark_scheme&, unsigned, Rounds_done,
                            Inexact::Points, Inexact::Normals, Inexact::Edges);
template void compiled_call(Inexact::Mesh&, const CatmullClark_scheme&, unsigned, Rounds_done,
                            Inexact::Points, No_normal_map, No_constraint_map);
template void compiled_call(Inexact::Mesh&, const CatmullClark_scheme&, unsigned, Rounds_done,
                            Inexact::Points, No_normal_map, Inexact::Edges);
template void compiled_call(Cartesian::Mesh&, const DooSabin_scheme&, unsigned, Rounds_done,
                            Cartesian::Points, Cartesian::Normals, No_constraint_map);
template void compiled_call(Cartesian::Mesh&, const DooSabin_scheme&, unsigned, Rounds_done,
                            Cartesian::Points, No_normal_map, No_constraint_map);
template void compiled_call(Inexact::Mesh&, const DooSabin_scheme&, unsigned, Rounds_done,
                            Inexact::Points, Inexact::Normals, No_constraint_map);
template void compiled_call(Inexact::Mesh&, const DooSabin_scheme&, unsigned, Rounds_done,
                            Inexact::Points, No_normal_map, No_constraint_map);

} // namespace internal
} // namespace PN_subdivision_3
} // namespace CGAL
