#!/usr/bin/env bash
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
#
# Makes the figures of X. Yang, Point-Normal Subdivision Curves and Surfaces: refines the control meshes
# of data/meshes/paper and others, draws doc/PN_subdivision_3/fig/paper/figure_N*.png, has the examples
# draw the curves, and puts the numbers into doc/PN_subdivision_3/Paper_figures.md.
#
#   scripts/make_paper_figures.sh [OPTIONS] [N...]        all 17 figures without N
#     --build FOLDER    where command and examples are built (default: build/release)
#     --output FOLDER   where the pictures go (default: doc/PN_subdivision_3/fig)
#     --check           draw nothing, unless there is an --output; tell whether the page's numbers are
#                       those of the present code
set -euo pipefail
cd "$(dirname "$0")/.."

build=build/release
output=
check=
figures=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --build) build=$2; shift ;;
    --output) output=$2; shift ;;
    --check) check=yes ;;
    [1-9] | 1[0-7]) figures+=("$1") ;;
    *) sed -n '/^# Makes/,/^set/s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
  esac
  shift
done
[[ ${#figures[@]} -gt 0 ]] || mapfile -t figures < <(seq 17)

page=doc/PN_subdivision_3/Paper_figures.md
folder=${output:-${check:+none}}
folder=${folder:-doc/PN_subdivision_3/fig}
command=$build/src/pn_subdivide/pn_subdivide
examples=$build/examples/PN_subdivision_3
paper=data/meshes/paper
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
touch "$work/numbers"
[[ $folder == none ]] || mkdir -p "$folder/paper"

need() {
  [[ -x $1 ]] && return
  echo "$1 is missing: scripts/build.sh $(basename "$1") builds it" >&2
  return 1
}

surface() { # control mesh, result, options of the command
  "$command" surface "$1" "$work/$2" --ascii --quiet "${@:3}" 2> "$work/warnings" ||
    { cat "$work/warnings" >&2; return 1; }
}

number() { # name, value
  echo "$1 $2" >> "$work/numbers"
}

deviation() { # name, shape, control mesh, result, options: the distance from the shape over its radius
  local line
  line=$("$command" surface "$3" "$work/$4" --verify "$2" --ascii --quiet "${@:5}" 2> /dev/null)
  number "$1" "$(sed 's/.*2^-52: \([^)]*\)).*/\1/' <<< "$line" | awk '{ print $1 * 2 ^ -52 }')"
}

measure() { # figure, folder
  python3 -B scripts/paper_figure.py measure "$1" "$2" >> "$work/numbers"
}

example() { # name, drawing: what it prints; the drawing goes to the folder
  need "$examples/$1"
  "$examples/$1" "$work/drawing.svg"
  [[ $folder == none ]] || cp "$work/drawing.svg" "$folder/$2"
}

sheet() { # picture, columns, further arguments of render.py
  [[ $folder == none ]] && return
  scripts/render.py --output "$folder/paper/$1.png" --columns "$2" --tile 450 "${@:3}"
}

curvature() { # control mesh, rounds, result, options of the command
  surface "$1" "$3.ply" --levels "$2" --curvature gaussian "${@:4}"
  [[ $folder == none ]] || surface "$1" "$3.vtp" --levels "$2" --curvature gaussian "${@:4}"
}

curvatures=(--shading averaged --same-view --scalars gaussian_curvature)

figure_1() {
  example average_arcs average_arcs.svg > "$work/printed"
  read -r _ h0 h1 h2 _ mean < <(tr -d , < "$work/printed")
  number 1_h0 "$h0"; number 1_h1 "$h1"; number 1_h2 "$h2"; number 1_mean "$mean"
}

figure_2() {
  example curve_circle curve_circle.svg > "$work/printed"
  local deviation spacing scheme=6_point
  while read -r deviation spacing; do
    number "2_off_$scheme" "$deviation"
    number "2_spacing_$scheme" "$spacing"
    scheme=b_spline
  done < <(tr -d , < "$work/printed" | awk '{ print $7, $NF }')
}

figure_3() {
  local cylinder=cylinder:0,0,0,0,0,1,1
  deviation 3_linear $cylinder $paper/cylinder.ply linear.ply --scheme catmull-clark --levels 5 --linear
  deviation 3_PN $cylinder $paper/cylinder.ply PN.ply --scheme catmull-clark --levels 5
  sheet figure_3 2 --same-view --shading averaged --view=30,20 --control $paper/cylinder.ply \
        --control-normals --caption "(a) Catmull-Clark" --caption "(b) PN-Catmull-Clark" \
        "$work"/{linear,PN}.ply
}

figure_4() {
  local sphere=sphere:0,0,0,1
  deviation 4_linear $sphere $paper/tetrahedron.ply linear.ply --scheme butterfly --levels 5 --linear
  deviation 4_PN $sphere $paper/tetrahedron.ply PN.ply --scheme butterfly --levels 5
  sheet figure_4 2 --same-view --shading averaged --view=20,20 --control $paper/tetrahedron.ply \
        --control-normals --caption "(a) Butterfly" --caption "(b) PN-Butterfly" "$work"/{linear,PN}.ply
}

figure_5() {
  example curve_bottle curve_bottle.svg > "$work/printed"
  local row=0 a b c
  while read -r a b c; do
    row=$((row + 1))
    number "5_${row}_6" "$a"; number "5_${row}_8" "$b"; number "5_${row}_10" "$c"
  done < <(awk '{ print $(NF - 2), $(NF - 1), $NF }' "$work/printed")
}

figure_6() {
  local mesh=data/meshes/bezier_6.ply m k
  for m in 0 1 2 3; do
    surface $mesh "control_$m.ply" --scheme catmull-clark --levels "$m" --output-normals control
    surface "$work/control_$m.ply" "PN_$m.ply" --scheme catmull-clark --levels 2
    for k in $(seq 0 $((3 - m))); do
      surface "$work/control_$m.ply" "linear_${m}_$k.ply" --scheme catmull-clark --linear \
              --levels $((k + 2))
    done
    cp "$work/linear_${m}_0.ply" "$work/linear_$m.ply"
  done
  python3 -B scripts/paper_figure.py rings "$work"
  measure 6 "$work"
  sheet figure_6 2 --zoom 0.87 --shading smooth --view=20,25 --control "$work/rings_control.ply" \
        --control none --control-normals --caption "(a) PN, control data" \
        --caption "(b) linear from these points" "$work"/rings_{PN,linear}.ply
}

figure_7() {
  surface $paper/cross.off quads.ply --scheme catmull-clark --levels 0 --normals angle
  surface $paper/cross.off triangles.ply --scheme loop --triangulate --levels 0 --normals angle
  sheet figure_7 2 --same-view --shading flat --edges --normals --view=30,25 \
        --caption "(a) quads" --caption "(b) triangles" "$work"/{quads,triangles}.ply
}

figure_8() {
  local scheme name meshes=() captions=() options
  while read -r scheme name; do
    options=(--scheme $scheme --normals angle)
    [[ $scheme == loop ]] && options+=(--triangulate)
    curvature $paper/cross.off 5 "cross_PN_$scheme" "${options[@]}"
    options=(--scheme $scheme --linear)
    [[ $scheme == loop ]] && options+=(--triangulate)
    curvature $paper/cross.off 5 "cross_linear_$scheme" "${options[@]}"
    meshes+=("$work/cross_PN_$scheme.vtp" "$work/cross_linear_$scheme.vtp")
    captions+=(--caption "PN-$name" --caption "$name")
  done << 'END'
catmull-clark Catmull-Clark
doo-sabin Doo-Sabin
kobbelt Kobbelt
loop Loop
END
  measure 8 "$work"
  sheet figure_8 4 "${curvatures[@]}" --range 4 --view=30,25 "${captions[@]}" "${meshes[@]}"
}

figure_9() {
  local row mesh bound view colors panel options
  while read -r row mesh bound view colors; do
    while read -r panel options; do
      # shellcheck disable=SC2086  # several words
      curvature "data/meshes/$mesh.ply" 5 "$row$panel" --scheme $options
    done << 'END'
a catmull-clark --linear
b modified-catmull-clark --linear --first-round 2 --tuned-valences diverging
c catmull-clark
d modified-catmull-clark --first-round 2 --tuned-valences diverging
e modified-catmull-clark
END
    # shellcheck disable=SC2086  # none, or an option
    sheet "figure_9_$row" 5 "${curvatures[@]}" --range "$bound" --view="$view" $colors \
          --caption "(a) linear" --caption "(b) modified linear" --caption "(c) PN" \
          --caption "(d) PN-modified, round 2" --caption "PN-modified, round 1" \
          "$work/$row"{a,b,c,d,e}.vtp
  done << 'END'
1 saddle_5 5 35,60
2 bezier_6 1 35,60
3 cylinder_cap_8 0.05 35,50 --cubic
END
  measure 9 "$work"
}

figure_10() {
  local shape
  for shape in waves bumps; do
    surface $paper/$shape.ply "grid_$shape.ply" --scheme doo-sabin --levels 4
    surface $paper/$shape.ply "grid_linear_$shape.ply" --scheme doo-sabin --levels 4 --linear
  done
  measure 10 "$work"
  sheet figure_10 2 --tile 360 --same-view --zoom 1.15 --shading averaged --view=25,45 --control $paper/waves.ply \
        --control $paper/bumps.ply --control none --control none --control-normals \
        --caption "(a) two normals in turn" --caption "(b) four normals, row by row" --caption "(a) PN-Doo-Sabin" \
        --caption "(b) PN-Doo-Sabin" $paper/{waves,bumps}.ply "$work"/grid_{waves,bumps}.ply
}

figure_11() {
  surface $paper/ring.ply ring_linear.ply --scheme catmull-clark --levels 4 --linear
  surface $paper/ring.ply ring_PN.ply --scheme catmull-clark --levels 4 --normals file
  surface $paper/ring_edited.ply ring_edited.ply --scheme catmull-clark --levels 4
  surface $paper/ring.ply ring_bare.ply --scheme catmull-clark --levels 0 --linear
  measure 11 "$work"
  sheet figure_11 3 --same-view --shading averaged --view=20,50 --control "$work/ring_bare.ply" \
        --control $paper/ring.ply --control $paper/ring_edited.ply --control-normals \
        --caption "(a) Catmull-Clark" --caption "(b) horizontal normals" \
        --caption "(c) edited normals" "$work"/ring_{linear,PN,edited}.ply
}

figure_12() {
  surface $paper/wheel.ply wheel_linear.ply --scheme catmull-clark --levels 4 --linear
  surface $paper/wheel.ply wheel_PN.ply --scheme catmull-clark --levels 4
  surface $paper/wheel_tori.ply wheel_tori.ply --scheme catmull-clark --levels 4
  surface $paper/wheel.ply wheel_bare.ply --scheme catmull-clark --levels 0 --linear
  measure 12 "$work"
  sheet figure_12 3 --tile 360 --same-view --shading averaged --view=20,55 --control "$work/wheel_bare.ply" \
        --control $paper/wheel.ply --control $paper/wheel_tori.ply --control none --control none --control none \
        --control-normals --caption "(a) without normals" --caption "(b) horizontal normals" \
        --caption "(c) normals of tori" --caption "(a) Catmull-Clark" --caption "(b) PN-Catmull-Clark" \
        --caption "(c) PN-Catmull-Clark" "$work/wheel_bare.ply" $paper/{wheel,wheel_tori}.ply \
        "$work"/wheel_{linear,PN,tori}.ply
}

figure_13() {
  local kind options
  for kind in linear PN; do
    options=()
    [[ $kind == linear ]] && options=(--linear)
    surface $paper/bell.ply bell_$kind.ply --scheme catmull-clark --levels 4 "${options[@]}"
    surface $paper/cuboid_with_hole.ply hole_$kind.ply --scheme doo-sabin --levels 5 "${options[@]}"
  done
  surface $paper/cyclide.ply cyclide.ply --scheme kobbelt --levels 5
  measure 13 "$work"
  sheet figure_13 3 --shading averaged --view=25,40 --control $paper/bell.ply \
        --control $paper/cuboid_with_hole.ply --control $paper/cyclide.ply --control-normals \
        --caption "(a) PN-Catmull-Clark" --caption "(b) PN-Doo-Sabin" --caption "(c) PN-Kobbelt" \
        "$work"/{bell_PN,hole_PN,cyclide}.ply
}

modified() { # figure, control mesh, scheme, range, view, name, options
  curvature "$2" 4 linear --scheme "$3" --linear "${@:7}"
  curvature "$2" 4 modified --scheme "modified-$3" --linear --first-round 2 \
            --tuned-valences diverging "${@:7}"
  curvature "$2" 4 PN_modified --scheme "modified-$3" --normals angle --first-round 2 \
            --tuned-valences diverging "${@:7}"
  curvature "$2" 4 PN_modified_1 --scheme "modified-$3" --normals angle "${@:7}"
  curvature "$2" 4 PN --scheme "$3" --normals angle "${@:7}"
  surface "$2" control.ply --scheme "$3" --levels 0 --normals angle "${@:7}"
  measure "$1" "$work"
  sheet "figure_$1" 4 "${curvatures[@]}" --range "$4" --view="$5" --cubic "${detail[@]}" --control none \
        --control none --control none --control "$work/control.ply" --control-normals --caption "(a) $6" \
        --caption "(b) modified" --caption "(c) PN-modified" --caption "(d) PN-modified" \
        "$work"/{linear,modified,PN_modified}.vtp "$work/PN_modified.ply"
}

figure_14() {
  local detail=(--zoom 2 "--shift=-0.44,-0.2") # the bowl
  modified 14 data/meshes/spoon.obj catmull-clark 30 -40,60 Catmull-Clark
}

figure_15() {
  local detail=()
  modified 15 data/meshes/head.obj loop 60 -35,10 Loop --triangulate
}

figure_16() {
  example curve_normal_edit curve_normal_edit.svg > "$work/printed"
  local degrees kept angle crossings
  while read -r degrees kept angle crossings; do
    number "16_kept_$degrees" "$kept"; number "16_angle_$degrees" "$angle"
    number "16_crossings_$degrees" "$crossings"
  done < <(awk '{ print $1, $3, $(NF - 3), $(NF - 1) }' "$work/printed")
}

figure_17() {
  surface $paper/torus_4.ply torus_4.ply --scheme kobbelt --levels 5
  surface $paper/torus_8.ply torus_8.ply --scheme kobbelt --levels 5
  measure 17 "$work"
  [[ $folder == none ]] && return
  surface $paper/torus_4.ply torus_4.vtp --scheme kobbelt --levels 5 --curvature gaussian
  sheet figure_17 3 "${curvatures[@]}" --range 1 --view=25,50 --control $paper/torus_4.ply \
        --control none --control $paper/torus_8.ply --control-normals --caption "(a) 4 x 4" \
        --caption "(b) 4 x 4, curvature" --caption "(c) 8 x 8" \
        "$work"/torus_4.ply "$work"/torus_4.vtp "$work"/torus_8.ply
}

need "$command"
for figure in "${figures[@]}"; do
  echo "figure $figure"
  "figure_$figure"
done
if [[ -n $check ]]; then
  scripts/paper_figure.py check $page "$work/numbers"
elif [[ -z $output ]]; then
  scripts/paper_figure.py page $page "$work/numbers"
else
  cat "$work/numbers"
fi
