# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Read by the scripts that draw the manual's figures, with their arguments [PN_SUBDIVIDE [FOLDER]]:
# sets command, folder (of the figures) and work (a temporary folder).
cd "$(dirname "$0")/.."

command=${1:-build/release/src/pn_subdivide/pn_subdivide}
folder=${2:-doc/PN_subdivision_3/fig}
if [[ ! -x $command ]]; then
  echo "$command is missing: scripts/build.sh pn_subdivide builds it" >&2
  exit 1
fi
mkdir -p "$folder"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
