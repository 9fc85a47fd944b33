# Copyright (c) 2026  PN_subdivision_3 developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Pictures of meshes with VTK: reading files, choosing a camera, drawing a sheet of tiles."""
