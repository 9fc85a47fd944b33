// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The page in Firefox: one screenshot and a few clicks; skipped where it is not installed.
//   node --test test_firefox.mjs      with PN_PAGE, the HTML file, in the environment
import assert from "node:assert/strict";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { inflateSync } from "node:zlib";
import { firefoxPath, hasFirefox, withFirefox } from "./firefox.mjs";

const file = path.resolve(process.env.PN_PAGE);

/** How many different bytes there are in a picture. */
function differentBytes(png) {
  const parts = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at))
    if (png.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
  return new Set(inflateSync(Buffer.concat(parts))).size;
}

test("Firefox shows the page, and a click shows another picture", { skip: !hasFirefox && `${firefoxPath ?? "Firefox"} is not installed` }, async () => {
  await withFirefox(pathToFileURL(file).href, async (page) => {
    while (!(await page.evaluate("document.documentElement.dataset.ready ?? null"))) await new Promise((resolve) => setTimeout(resolve, 200));
    const place = (id) => page.evaluate(`(() => { const b = document.getElementById("${id}").getBoundingClientRect();
      return [b.left + b.width / 2, b.top + b.height / 2]; })()`);
    assert.ok(differentBytes(await page.screenshot()) > 100);
    if (await page.evaluate("window.page.editor.viewer.canDraw")) {
      await page.click(...(await place("picture-waves")));
      assert.equal(await page.evaluate("window.page.editor.name"), "waves");
      // by the worker
      await page.click(...(await place("picture-head")));
      assert.equal(await page.evaluate("window.page.editor.name"), "head");
      assert.equal(await page.evaluate("window.page.editor.content().then(({ faces }) => faces.degrees.length)"), 18_944);
    }
    await page.click(...(await place("tab-curve")));
    assert.equal(await page.evaluate("document.getElementById('curve').hidden"), false);
    // drawn when the browser comes to it
    const holds = () => page.evaluate("document.querySelectorAll('#drawing .hold').length");
    for (const end = Date.now() + 20_000; (await holds()) <= 3 && Date.now() < end; ) await new Promise((resolve) => setTimeout(resolve, 100));
    assert.ok((await holds()) > 3);
  });
});
