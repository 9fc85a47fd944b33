// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The small pictures of the panel, and the first surfaces, which are seen while the page is loaded:
// node draw_gallery.mjs PAGE.html [FOLDER]
import { writeFile } from "node:fs/promises";
import path from "node:path";
import { withPage } from "./browser.mjs";

const [, , file, folder = path.resolve(import.meta.dirname, "../page/pictures")] = process.argv;
const options = { viewport: { width: 960, height: 520 }, colorScheme: "light" };

/** Of a picture in the page, 192 by 128 pixels of its middle. */
const shrink = (page, png) =>
  page.evaluate(async (bytes) => {
    const picture = await createImageBitmap(new Blob([Uint8Array.from(bytes)]));
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [192, 128];
    const scale = Math.max(192 / picture.width, 128 / picture.height);
    const context = canvas.getContext("2d");
    context.imageSmoothingQuality = "high";
    context.drawImage(picture, 96 - (scale * picture.width) / 2, 64 - (scale * picture.height) / 2,
      scale * picture.width, scale * picture.height);
    return canvas.toDataURL("image/webp", 0.82).split(",")[1];
  }, [...png]);

const names = ["cube", "bolt", "waves", "ring", "head", "bottle"];
for (const name of names)
  await withPage(file, { ...options, hash: `#picture-${name}` }, async (page) => {
    await page.waitForTimeout(500);
    await page.addStyleTag({ content: "#curve-status { visibility: hidden; }" });
    const png = name === "bottle"
      ? await page.locator("#drawing").screenshot()
      : Buffer.from(await page.evaluate(async () => [...new Uint8Array(await (await window.page.editor.viewer.png()).arrayBuffer())]));
    const bytes = Buffer.from(await shrink(page, png), "base64");
    await writeFile(path.join(folder, `${name}.webp`), bytes);
    console.log(`${name}: ${bytes.length} bytes`);
  });

await withPage(file, { ...options, viewport: { width: 720, height: 360 }, hash: "?embed=1#picture-cube" }, async (page) => {
  await page.waitForTimeout(500);
  const pictures = await page.evaluate(() => {
    const { viewer } = window.page.editor;
    viewer.draw(2);
    return [0, 1].map((side) => {
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [360, 360];
      canvas.getContext("2d").drawImage(viewer.canvas, side * 720, 0, 720, 720, 0, 0, 360, 360);
      return canvas.toDataURL("image/webp", 0.7).split(",")[1];
    });
  });
  for (const [i, name] of ["linear", "pn"].entries()) {
    const bytes = Buffer.from(pictures[i], "base64");
    await writeFile(path.join(folder, `first_${name}.webp`), bytes);
    console.log(`first_${name}: ${bytes.length} bytes`);
  }
});
