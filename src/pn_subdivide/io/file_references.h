// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

#ifndef PN_SUBDIVIDE_FILE_REFERENCES_H
#define PN_SUBDIVIDE_FILE_REFERENCES_H

#include "io/Attributes.h"
#include "io/mesh_io.h"

namespace pn_subdivide {

// The names of material and texture files are relative to the folder of the mesh file. Makes them
// those that hold for the output, where it is in another folder. Standard input and output are in the
// current folder.
void move_file_references(Attributes& attributes, const Mesh_file& input, const Mesh_file& output);

} // namespace pn_subdivide

#endif // PN_SUBDIVIDE_FILE_REFERENCES_H
