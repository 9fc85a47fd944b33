#!/bin/sh
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# PN_check_only.sh COMPILER ... -o OBJECT ...: lets a compiler only check, templates instantiated but no code
# generated, and, if it finds nothing, leaves an empty object file by which the build tool sees that this is
# done. Precompiled headers are made as ever.
set -e
for argument; do
  if [ "$argument" = c++-header ]; then exec "$@"; fi
done
"$@" -fsyntax-only
while [ "$1" != -o ]; do shift; done
: > "$2"
