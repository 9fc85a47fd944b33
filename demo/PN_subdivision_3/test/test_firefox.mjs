// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The page in Firefox: what is seen and clicked, saved and said; skipped where it is not installed.
//   node --test test_firefox.mjs      with PN_PAGE, the HTML file, and PN_SUBDIVIDE, the command, in the environment
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { inflateSync } from "node:zlib";
import { firefoxPath, hasFirefox, withFirefox } from "./firefox.mjs";

const file = path.resolve(process.env.PN_PAGE);
const address = pathToFileURL(file).href;
const skip = !hasFirefox && `${firefoxPath ?? "Firefox"} is not installed`;

async function ready(page) {
  while (!(await page.evaluate("document.documentElement.dataset.ready ?? null"))) await new Promise((resolve) => setTimeout(resolve, 200));
}

/** How many different bytes there are in a picture. */
function differentBytes(png) {
  const parts = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at))
    if (png.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
  return new Set(inflateSync(Buffer.concat(parts))).size;
}

test("Firefox shows the page, and a click shows another picture", { skip }, async () => {
  await withFirefox(address, async (page) => {
    await ready(page);
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

test("Firefox says what is wrong, keeps what is chosen, and saves what the command makes", { skip }, async () => {
  const folder = await mkdtemp(path.join(tmpdir(), "pn-firefox-test-"));
  await withFirefox(`${address}#%E0%A4%A`, async (page) => {
    const message = () => page.evaluate("document.querySelector('#message:not([hidden]) span')?.textContent ?? ''");
    /** A file that a button saves: its name and bytes. */
    const save = (button) => page.evaluate(`new Promise((resolve, reject) => {
      const { createObjectURL } = URL;
      const { click } = HTMLAnchorElement.prototype;
      let blob;
      URL.createObjectURL = (content) => createObjectURL.call(URL, (blob = content));
      HTMLAnchorElement.prototype.click = function () {
        URL.createObjectURL = createObjectURL;
        HTMLAnchorElement.prototype.click = click;
        blob.arrayBuffer().then((bytes) => resolve([this.download, Array.from(new Uint8Array(bytes))]), reject);
      };
      document.getElementById("${button}").click();
    })`).then(([name, bytes]) => ({ name, bytes: Buffer.from(bytes) }));
    await ready(page);
    assert.match(await message(), /^The link cannot be read: it is damaged/);
    await page.evaluate("void Promise.reject(new Error('on purpose'))");
    for (const end = Date.now() + 20_000; !/on purpose/.test(await message()) && Date.now() < end; ) await new Promise((resolve) => setTimeout(resolve, 100));
    assert.match(await message(), /^This did not work: on purpose\.$/);
    // every scheme takes every roundness
    const failed = await page.evaluate(`(async () => {
      const { editor } = window.page;
      const failed = [];
      for (const scheme of editor.schemes.keys())
        for (const roundness of [0, 0.5]) {
          editor.set({ scheme, rounds: 1 });
          editor.change((mesh) => mesh.setRoundness(roundness));
          const { points } = await editor.content();
          if (editor.settings.scheme !== scheme || !points.every(Number.isFinite)) failed.push(scheme);
        }
      return failed;
    })()`);
    assert.deepEqual(failed, []);
    // files, by the command that is shown
    await page.evaluate("page.panel.showExample('bolt', { rounds: 1, layout: 'pn', flat: true })");
    for (const format of ["obj", "ply", "stl"]) {
      await page.evaluate(`void (document.getElementById("surface-format").value = "${format}")`);
      const [control, surface] = [await save("save-control"), await save("save-surface")];
      await writeFile(path.join(folder, control.name), control.bytes);
      const words = await page.evaluate("(document.getElementById('recipe').click(), document.getElementById('recipe-command').textContent.split(' '))");
      await page.evaluate("document.getElementById('recipe-dialog').close()");
      execFileSync(path.resolve(process.env.PN_SUBDIVIDE), [...words.slice(1), "--quiet"], { cwd: folder });
      assert.ok(surface.bytes.equals(await readFile(path.join(folder, surface.name))), format);
    }
    // small windows
    for (const [width, height] of [[844, 390], [640, 400], [390, 844]]) {
      await page.resize(width, height);
      await page.evaluate("void document.getElementById('picture-waves').click()");
      await page.evaluate("new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve(0))))");
      const [caption, canvas] = await page.evaluate("['caption', 'canvas'].map((id) => document.getElementById(id).getBoundingClientRect().toJSON())");
      assert.ok(caption.height > 0 && caption.bottom <= canvas.top, `${width}: ${JSON.stringify([caption, canvas])}`);
      assert.ok(await page.evaluate("document.documentElement.scrollWidth <= window.innerWidth"));
    }
  }).finally(() => rm(folder, { recursive: true }));
});
