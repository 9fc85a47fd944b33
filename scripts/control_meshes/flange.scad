// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// A flange, for scripts/pictures.py: a plate with round ends, a boss, a bore, two countersunk holes. $fn is given by -D.
difference() {
  union() {
    linear_extrude(6) hull() for (x = [-32, 32]) translate([x, 0]) circle(11);
    cylinder(h = 24, r = 15);
  }
  translate([0, 0, -1]) cylinder(h = 26, r = 9);
  for (x = [-32, 32]) translate([x, 0]) {
    translate([0, 0, -1]) cylinder(h = 8, r = 3.5);
    translate([0, 0, 3]) cylinder(h = 3, r1 = 3.5, r2 = 6.5);
  }
}
