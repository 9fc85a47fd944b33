#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
# Refinement in pieces at full size, with what it has to keep: the file is that of the whole surface, the memory of
# a process with 50 million quads in 64 pieces is at most 300 MB, the time at most 1.25 of that of refining and
# writing the whole, and two ranks take at most 0.6 of the time of one. Takes some minutes, 8 GB of disk and, for
# the whole surface, 12 GB of memory.
#
#     scripts/check_pieces.sh [--command FILE] [--folder FOLDER] [--levels N] [--without-whole]
#
# Exit code 1 if something is not kept. Two ranks need MPI in the command, and two idle cores.
set -euo pipefail

source_folder=$(cd "$(dirname "$0")/.." && pwd)
command=$source_folder/build/release/src/pn_subdivide/pn_subdivide
folder=${TMPDIR:-/tmp}
levels=9
with_whole=true
while [ $# -gt 0 ]; do
  case $1 in
    --command) command=$2; shift ;;
    --folder) folder=$2; shift ;;
    --levels) levels=$2; shift ;;
    --without-whole) with_whole=false ;;
    *) echo "check_pieces.sh: unknown option $1" >&2; exit 2 ;;
  esac
  shift
done

work=$(mktemp -d "$folder/pn_pieces_XXXXXX")
trap 'rm -rf "$work"' EXIT
failures=0

# 192 quads, 50 million after nine rounds
python3 - > "$work/control.off" <<'PYTHON'
n, m = 12, 16
points = [(i, j, ((i * 7 + j * 5) % 9) / 5) for j in range(m + 1) for i in range(n + 1)]
faces = [(j * (n + 1) + i, j * (n + 1) + i + 1, (j + 1) * (n + 1) + i + 1, (j + 1) * (n + 1) + i)
         for j in range(m) for i in range(n)]
print("OFF\n%d %d 0" % (len(points), len(faces)))
for p in points: print("%g %g %g" % p)
for f in faces: print("4 %d %d %d %d" % f)
PYTHON

# run NAME COMMAND...: time in seconds and peak memory in MB of one process, into NAME_time and NAME_memory
run()
{
  local name=$1
  shift
  sync
  /usr/bin/time -f "%e %M" -o "$work/time" "$@"
  read -r seconds kilobytes < "$work/time"
  eval "${name}_time=$seconds ${name}_memory=$((kilobytes / 1024))"
  echo "$name: $seconds s, $((kilobytes / 1024)) MB"
}

# check TEXT CONDITION
check()
{
  if awk "BEGIN { exit !($2) }"; then echo "kept: $1"; else echo "NOT KEPT: $1"; failures=1; fi
}

job=("$command" surface "$work/control.off")
options=(--scheme catmull-clark --levels "$levels" --quiet)
run pieces "${job[@]}" "$work/pieces.ply" "${options[@]}" --pieces 64
check "at most 300 MB" "$pieces_memory <= 300"
if $with_whole; then
  run whole "${job[@]}" "$work/whole.ply" "${options[@]}"
  check "at most 1.25 of the time of the whole" "$pieces_time <= 1.25 * $whole_time"
  cmp "$work/whole.ply" "$work/pieces.ply" || failures=1
  rm "$work/whole.ply"
fi
if command -v mpirun > /dev/null; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  run ranks mpirun --oversubscribe -n 2 "${job[@]}" "$work/ranks.ply" "${options[@]}" --pieces 64
  check "two ranks in at most 0.6 of the time" "$ranks_time <= 0.6 * $pieces_time"
  cmp "$work/pieces.ply" "$work/ranks.ply" || failures=1
fi

# the same with colors, numbers of faces and texture coordinates with seams, two rounds before
python3 - "$work/control.off" > "$work/attributes.ply" <<'PYTHON'
import sys
lines = open(sys.argv[1]).read().split("\n")
vertices, faces = map(int, lines[1].split()[:2])
print("ply\nformat ascii 1.0\nelement vertex %d" % vertices)
for name in ("double x", "double y", "double z", "uchar red", "uchar green", "uchar blue"):
    print("property " + name)
print("element face %d\nproperty list uchar int vertex_indices\nproperty int part" % faces)
print("property list uchar float texcoord\nend_header")
for v in range(vertices): print(lines[2 + v], v * 37 % 256, 255 - v % 200, 7)
for f in range(faces):
    face = lines[2 + vertices + f]
    texture = [(int(v) % 13 + (20 if f % 24 < 12 else 0), int(v) // 13) for v in face.split()[1:]]
    print(face, f % 3, 2 * len(texture), " ".join("%d %d" % t for t in texture))
PYTHON
few=$((levels > 3 ? levels - 2 : levels))
job=("$command" surface "$work/attributes.ply")
options=(--scheme catmull-clark --levels "$few" --quiet)
run attributes "${job[@]}" "$work/pieces.ply" "${options[@]}" --pieces 64
run whole_attributes "${job[@]}" "$work/whole.ply" "${options[@]}"
cmp "$work/whole.ply" "$work/pieces.ply" || failures=1
if command -v mpirun > /dev/null; then
  run attributes_ranks mpirun --oversubscribe -n 2 "${job[@]}" "$work/ranks.ply" "${options[@]}" --pieces 64
  cmp "$work/pieces.ply" "$work/ranks.ply" || failures=1
fi
exit "$failures"
