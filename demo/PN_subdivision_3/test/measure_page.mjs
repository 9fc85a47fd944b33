// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How fast the page is here: node measure_page.mjs PAGE.html
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { brotliCompressSync, gzipSync } from "node:zlib";
import { withBrowser, withPage } from "./browser.mjs";

const [, , file] = process.argv;
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

const html = await readFile(file);
console.log(`${html.length} bytes, compressed ${gzipSync(html, { level: 9 }).length}`);

const ready = [];
for (let i = 0; i < 5; ++i)
  ready.push(await withPage(file, {}, (page) => page.evaluate(() => Number(document.documentElement.dataset.ready))));
console.log(`first picture after ${median(ready)} ms (${ready.join(", ")})`);

// as it comes by brotli at 1.6 Mbit/s
const sent = brotliCompressSync(html);
const headers = { "content-type": "text/html; charset=utf-8", "content-encoding": "br" };
const server = createServer((_, answer) => answer.writeHead(200, headers).end(sent)).listen(0);
const painted = [];
for (let i = 0; i < 5; ++i)
  painted.push(await withBrowser(async (browser) => {
    const page = await browser.newPage();
    const session = await page.context().newCDPSession(page);
    await session.send("Network.emulateNetworkConditions", { offline: false, latency: 0, downloadThroughput: 200_000, uploadThroughput: 200_000 });
    await page.goto(`http://localhost:${server.address().port}/`, { waitUntil: "commit" });
    const seen = await page.waitForFunction(() =>
      performance.getEntriesByName("first-contentful-paint").length && [...document.querySelectorAll("#loading img")].every((i) => i.complete) && performance.now());
    const paint = await seen.jsonValue();
    await page.close();
    return Math.round(paint);
  }));
server.close();
console.log(`at 1.6 Mbit/s the first surfaces are seen after ${median(painted)} ms (${painted.join(", ")})`);

for (const [rounds, layout, isRound] of [[4, "pn", true], [4, "pn", false], [4, "both", false], [5, "pn", false]])
  await withPage(file, { hash: "#head" }, async (page) => {
    const { work, frames, faces } = await page.evaluate(
      async ([rounds, layout, isRound]) => {
        const { editor } = window.page;
        editor.set({ rounds, layout });
        if (isRound) editor.change((mesh) => mesh.setRoundness(1));
        await editor.settled();
        const nextFrame = () => new Promise(requestAnimationFrame);
        const work = [];
        const frames = [];
        const draw = editor.draw;
        editor.draw = function (drawings, isLast, milliseconds) {
          if (milliseconds !== undefined) work.push(milliseconds);
          draw.call(this, drawings, isLast, milliseconds);
        };
        editor.beginDrag();
        await nextFrame();
        let last = performance.now();
        for (let i = 0; i < 40; ++i) {
          editor.dragNormal(100, Math.sin(i / 9), Math.cos(i / 9), 0.3);
          await nextFrame();
          await editor.settled();
          frames.push(performance.now() - last);
          last = performance.now();
        }
        editor.endDrag();
        return { work, frames, faces: (await editor.content()).faces.degrees.length };
      },
      [rounds, layout, isRound],
    );
    console.log(
      `${faces} faces, ${layout === "both" ? "two views" : "one view"}, ${isRound ? "roundness 1" : "estimated normals and roundness"}: ` +
        `a normal that turns takes ${median(work.slice(10)).toFixed(1)} ms (at best ${Math.min(...work).toFixed(1)}), ` +
        `a frame with its picture ${median(frames.slice(10)).toFixed(1)} ms`,
    );
  });

// how long the page stands still, pictures apart
await withPage(file, {}, async (page) => {
  const gaps = await page.evaluate(async () => {
    const { editor } = window.page;
    let work = 0;
    let started = 0;
    for (const [object, name] of [[editor, "replace"], [editor, "draw"], [editor, "show"], [editor, "follow"]]) {
      const original = object[name];
      object[name] = function (...given) {
        const isOutermost = started === 0;
        if (isOutermost) started = performance.now();
        try {
          return original.apply(this, given);
        } finally {
          if (isOutermost) {
            work = Math.max(work, performance.now() - started);
            started = 0;
          }
        }
      };
    }
    const gaps = {};
    const measure = async (name, act) => {
      work = 0;
      act();
      await editor.settled();
      await new Promise(requestAnimationFrame);
      gaps[name] = work;
    };
    const wedge = 100;
    await measure("load", () => document.getElementById("picture-head").click());
    await measure("rounds 4, two views", () => editor.set({ rounds: 4, layout: "both" }));
    await measure("curvature", () => editor.set({ shading: "gaussian" }));
    await measure("limit", () => editor.set({ limit: true }));
    await measure("turn", () => editor.setNormal(wedge, 0, 0, 1));
    await measure("undo", () => editor.undo());
    await measure("estimate", () => editor.change((mesh) => mesh.estimateNormals()));
    await measure("rounds 5", () => editor.set({ rounds: 5, layout: "pn" }));
    return gaps;
  });
  for (const [name, ms] of Object.entries(gaps)) console.log(`${name}: the page stands still for ${ms.toFixed(1)} ms`);
});
