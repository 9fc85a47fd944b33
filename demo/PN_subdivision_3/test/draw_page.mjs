// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The picture of the manual, or of another state: node draw_page.mjs PAGE.html PICTURE.png [#HASH [WIDTH HEIGHT [light|dark]]]
import { withPage } from "./browser.mjs";

const [, , file, picture, hash = "#ring_edited", width = 1280, height = 800, colorScheme = "light"] = process.argv;
await withPage(file, { hash, viewport: { width: Number(width), height: Number(height) }, colorScheme }, async (page) => {
  await page.waitForTimeout(500); // the address is written
  await page.screenshot({ path: picture });
});
