// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What the tests do with the page, and what they see on it.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { isFirefox } from "./browser.mjs";

/** Of the tests that run. */
export const folder = mkdtempSync(path.join(tmpdir(), "pn-page-test-"));
process.on("exit", () => rmSync(folder, { recursive: true }));

/** The faces of a cube. */
export const quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/** Binary PLY as the page and the command write it: vertices of doubles, of which the first three are the point, then faces. */
export function readPly(bytes) {
  const end = bytes.indexOf("end_header\n") + "end_header\n".length;
  const header = bytes.subarray(0, end).toString("latin1");
  const vertices = Number(/element vertex (\d+)/.exec(header)[1]);
  const hasNormals = /double nx/.test(header);
  const names = header.split("element face")[0].match(/(?<=^property double )\w+$/gm);
  const normals = [];
  const roundness = [];
  const points = [];
  for (let v = 0; v < vertices; ++v) {
    const at = (k) => bytes.readDoubleLE(end + 8 * (names.length * v + k));
    for (let k = 0; k < 3; ++k) points.push(at(k));
    if (hasNormals) for (let k = 3; k < 6; ++k) normals.push(at(k));
    if (names.includes("roundness")) roundness.push(at(names.indexOf("roundness")));
  }
  return { vertices, points, faces: Number(/element face (\d+)/.exec(header)[1]), hasNormals, normals, roundness };
}

/** The file that a button saves: its name and bytes. Of those of Firefox Playwright is not told. */
export async function saved(page, button) {
  if (!isFirefox) {
    await page.waitForTimeout(110); // Chromium drops the eleventh of a second
    const [item] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
    return { name: item.suggestedFilename(), bytes: await readFile(await item.path()) };
  }
  const [name, address] = await page.evaluate((selector) => new Promise((resolve) => {
    const { createObjectURL } = URL;
    const { click } = HTMLAnchorElement.prototype;
    const reader = new FileReader();
    URL.createObjectURL = (content) => {
      reader.readAsDataURL(content);
      return createObjectURL.call(URL, content);
    };
    HTMLAnchorElement.prototype.click = function () {
      URL.createObjectURL = createObjectURL;
      HTMLAnchorElement.prototype.click = click;
      reader.onload = () => resolve([this.download, reader.result]);
    };
    document.querySelector(selector).click();
  }), button);
  return { name, bytes: Buffer.from(address.split(",")[1] ?? "", "base64") };
}

export async function download(page, button, folder) {
  const { name, bytes } = await saved(page, button);
  await writeFile(path.join(folder, name), bytes);
  return path.join(folder, name);
}

export function largestDifference(a, b) {
  assert.equal(a.length, b.length);
  return a.reduce((most, x, i) => Math.max(most, Math.abs(x - b[i])), 0);
}

/** Of the surface on the screen, once it is made. */
export const points = (page) => page.evaluate(async () => Array.from((await window.page.editor.content()).points));

/** Where the tip of a normal is on the screen. */
export function tipOf(page, wedge) {
  return page.evaluate((w) => {
    const { editor } = window.page;
    const { viewer } = editor;
    const { vertices, normals, points } = editor.handles;
    viewer.draw(); // the view may have changed
    const v = vertices[w];
    const n = normals.slice(3 * w, 3 * w + 3);
    const length = Math.hypot(...n);
    const p = viewer.camera.position.clone();
    p.fromArray([0, 1, 2].map((k) => points[3 * v + k] + (editor.normalLength * n[k]) / length));
    const pixels = viewer.toPixels(p);
    const box = viewer.canvas.getBoundingClientRect();
    const half = editor.settings.layout === "both" ? 0.75 : 0.5;
    return { x: box.left + half * box.width + pixels.x, y: box.top + box.height / 2 + pixels.y };
  }, wedge);
}

/** The middle of the first element of a drawing, which is drawn anew with each frame: found and measured at once. */
export async function middleOf(page, selector) {
  await page.waitForSelector(selector, { state: "attached" });
  return page.evaluate((s) => {
    const { left, top, width, height } = document.querySelector(s).getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  }, selector);
}

/** The normal that is nearest to the eye. */
export const frontWedge = (page) =>
  page.evaluate(() => {
    const { handles, viewer } = window.page.editor;
    const p = viewer.camera.position.clone();
    let best = 0;
    let least = Infinity;
    handles.vertices.forEach((v, w) => {
      p.fromArray(handles.points, 3 * v);
      const { depth } = viewer.toPixels(p);
      if (depth < least) [best, least] = [w, depth];
    });
    return best;
  });

export const drop = (page, name, content) => dropAll(page, [[name, content]]);

export async function dropAll(page, files) {
  await page.evaluate((all) => {
    const transfer = new DataTransfer();
    for (const [name, bytes] of all) transfer.items.add(new File([Uint8Array.from(bytes)], name));
    window.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true }));
  }, files.map(([name, content]) => [name, [...Buffer.from(content)]]));
}

/** The page is without graphics hardware while `meanwhile` runs on it, and then draws by itself what there is. */
export async function loseContext(page, meanwhile = async () => {}) {
  await page.evaluate(`(async () => {
    const { viewer } = window.page.editor;
    const { onDraw } = viewer;
    const canvas = document.getElementById("canvas");
    const context = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
    const heard = (name) => new Promise((resolve) => canvas.addEventListener(name, resolve, { once: true }));
    const lost = heard("webglcontextlost");
    context.loseContext();
    await lost;
    await new Promise((resolve) => setTimeout(resolve, 100)); // the event has been heard by all
    await (${meanwhile})();
    await new Promise((resolve) => setTimeout(resolve, 300)); // what is left to be drawn is drawn into nothing
    const drawn = new Promise((resolve, reject) => {
      viewer.onDraw = resolve;
      setTimeout(() => reject(new Error("nothing is drawn when the context is back")), 10_000);
    });
    const back = heard("webglcontextrestored");
    context.restoreContext();
    await back;
    await drawn;
    viewer.onDraw = onDraw;
  })()`);
}

export const message = async (page) => {
  await page.waitForSelector("#message:not([hidden])");
  return page.textContent("#message span");
};
