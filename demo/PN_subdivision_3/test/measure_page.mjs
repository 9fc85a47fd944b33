// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// How fast the page is here: node measure_page.mjs PAGE.html
import { withPage } from "./browser.mjs";

const [, , file] = process.argv;
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

const ready = [];
for (let i = 0; i < 3; ++i)
  ready.push(await withPage(file, {}, (page) => page.evaluate(() => Number(document.documentElement.dataset.ready))));
console.log(`first picture after ${median(ready)} ms (${ready.join(", ")})`);

for (const [rounds, layout] of [[4, "pn"], [4, "both"], [5, "pn"]])
  await withPage(file, { hash: "#head" }, async (page) => {
    const { work, frames, faces } = await page.evaluate(
      async ([rounds, layout]) => {
        const { editor } = window.page;
        editor.set({ rounds, layout });
        const nextFrame = () => new Promise(requestAnimationFrame);
        const work = [];
        const frames = [];
        editor.beginDrag();
        await nextFrame();
        let last = performance.now();
        for (let i = 0; i < 30; ++i) {
          editor.dragNormal(100, Math.sin(i / 9), Math.cos(i / 9), 0.3);
          // what the next frame will do, without the picture, done here to be timed
          const started = performance.now();
          editor.follow(false);
          work.push(performance.now() - started);
          await nextFrame();
          frames.push(performance.now() - last);
          last = performance.now();
        }
        editor.endDrag();
        return { work, frames, faces: editor.shownSurface.faces().degrees.length };
      },
      [rounds, layout],
    );
    const frame = median(frames.slice(10));
    console.log(
      `${faces} faces, ${layout === "both" ? "two views" : "one view"}: a normal that turns takes ` +
        `${median(work.slice(10)).toFixed(1)} ms, a frame with its picture ${frame.toFixed(1)} ms (${(1000 / frame).toFixed(0)} a second)`,
    );
  });
