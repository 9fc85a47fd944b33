# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The control meshes of data/: how they are built, checked and written.

The files must come out the same, byte for byte, on every machine and with every Python from 3.11
on. So the modules use only +, -, *, / and sqrt on floats (IEEE gives one answer), `decimal` for
everything else (no libm), `random.Random.random` (a documented sequence), and never the built-in
`sum` on floats (its rounding changed in Python 3.12).
"""
