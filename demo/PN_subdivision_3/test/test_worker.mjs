// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// What is large is made by the page's worker, and is what the command makes:
//   node --test test_worker.mjs      with PN_PAGE, the HTML file, and PN_SUBDIVIDE, the command, in the environment
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { withPage } from "./browser.mjs";
import { download as downloadTo, dropAll, frontWedge, largestDifference, loseContext, message, points, readPly, tipOf } from "./page_actions.mjs";

const file = path.resolve(process.env.PN_PAGE);
const command = path.resolve(process.env.PN_SUBDIVIDE);
let folder;
before(async () => (folder = await mkdtemp(path.join(tmpdir(), "pn-page-test-"))));
after(() => rm(folder, { recursive: true }));

const download = (page, button) => downloadTo(page, button, folder);
const facesOf = (page) => page.evaluate(async () => (await window.page.editor.content()).faces.degrees.length);
/** Those that were made on the page, where nothing else happens meanwhile. */
const facesMadeHere = (page) => page.evaluate(() => window.page.editor.shownSurface?.faces().degrees.length ?? 0);

async function requireSameAsCommand(page, options) {
  const control = await download(page, "#save-control");
  const ours = readPly(await readFile(await download(page, "#save-surface")));
  const native = path.join(folder, "native.ply");
  execFileSync(command, ["surface", control, native, "--quiet", ...options]);
  const theirs = readPly(await readFile(native));
  assert.equal(ours.faces, theirs.faces);
  const size = theirs.points.reduce((largest, x) => Math.max(largest, Math.abs(x)), 0); // too many for arguments of a call
  const difference = largestDifference(ours.points, theirs.points) / size;
  assert.ok(difference < 1e-12, `vertices differ by ${difference}`);
  return ours;
}

const grid = (n) => {
  const lines = [`OFF\n${(n + 1) ** 2} ${n * n} 0`];
  for (let i = 0; i <= n; ++i) for (let j = 0; j <= n; ++j) lines.push(`${i / n} ${j / n} ${Math.sin((11 * i) / n) * 0.1}`);
  for (let i = 0; i < n; ++i)
    for (let j = 0; j < n; ++j) lines.push(`4 ${i * (n + 1) + j} ${(i + 1) * (n + 1) + j} ${(i + 1) * (n + 1) + j + 1} ${i * (n + 1) + j + 1}`);
  return lines.join("\n");
};

/** Too large to be sent as an array of numbers. */
const dropText = (page, name, text) => page.evaluate(([name, text]) => {
  const transfer = new DataTransfer();
  transfer.items.add(new File([text], name));
  window.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true }));
}, [name, text]);

const catmullClark = ["--scheme", "catmull-clark", "--levels", "4"];

test("a large surface is that of the command: made, dragged, undone, with creases, at the limit", async () => {
  await withPage(file, { hash: "#head" }, async (page) => {
    await page.check("input[name=layout][value=pn]");
    await page.fill("#rounds", "4");
    assert.equal(await facesOf(page), 75_776);
    assert.ok((await facesMadeHere(page)) < 15_000);
    await requireSameAsCommand(page, catmullClark);
    const start = await points(page);
    await page.check("#show-normals");
    const tip = await tipOf(page, await frontWedge(page));
    await page.mouse.move(tip.x, tip.y);
    await page.mouse.down();
    await page.mouse.move(tip.x + 15, tip.y - 25, { steps: 6 });
    await page.mouse.up();
    const dragged = await requireSameAsCommand(page, catmullClark);
    assert.ok(largestDifference(dragged.points, start) > 1e-4);
    await page.focus("#canvas");
    await page.keyboard.press("l"); // the point
    await requireSameAsCommand(page, catmullClark);
    for (let i = 0; i < 2; ++i) await page.click("#undo");
    assert.equal(largestDifference(await points(page), start), 0);
    // the curvatures are those of this surface, not of one with fewer rounds
    await page.check("input[name=shading][value=gaussian]");
    const values = await page.evaluate(async () => {
      await window.page.editor.settled();
      const pane = window.page.editor.viewer.pane(false);
      return ["position", "value"].map((name) => pane.mesh.geometry.getAttribute(name).count);
    });
    assert.deepEqual(values, [start.length / 3, start.length / 3]);
    await page.check("#limit");
    const limit = readPly(await readFile(await download(page, "#save-surface")));
    assert.ok(largestDifference(limit.points, start) > 1e-6);
    await page.uncheck("#limit");
    await page.fill("#angle", "50");
    await page.click("#detect");
    await page.click("#normals-estimate");
    await requireSameAsCommand(page, [...catmullClark, "--sharp", "angle:50", "--normals", "estimate"]);
  });
});

test("while it is made the page goes on, and what is no longer wanted is not made", async () => {
  await withPage(file, { hash: "#head" }, async (page) => {
    const { beats, picture } = await page.evaluate(async () => {
      const { editor } = window.page;
      let beats = 0;
      const heart = setInterval(() => ++beats, 5);
      editor.set({ rounds: 5, layout: "pn" });
      await editor.settled();
      clearInterval(heart);
      return { beats, picture: editor.viewer.pane(false).mesh.geometry.getAttribute("position").count };
    });
    assert.ok(beats >= 3, `${beats} beats`);
    assert.equal(picture, 303_329); // a disk: 303,104 faces with 448 border edges
    for (const rounds of ["2", "5", "4", "5", "3"]) await page.fill("#rounds", rounds);
    assert.equal(await facesOf(page), 18_944);
    assert.equal(await page.inputValue("#rounds"), "3");
  });
});

test("it can be stopped, and what fails leaves what was there", async () => {
  await withPage(file, { hash: "#head" }, async (page) => {
    await page.fill("#rounds", "3");
    const start = await points(page);
    await page.fill("#rounds", "5");
    // as soon as it is shown: it is not there for long
    await page.evaluate(async () => {
      const stop = document.getElementById("stop");
      const isOnTop = () => {
        const { left, top, width, height } = stop.getBoundingClientRect();
        return document.elementFromPoint(left + width / 2, top + height / 2) === stop;
      };
      while (!isOnTop()) await new Promise((resolve) => setTimeout(resolve, 5));
      stop.click();
    });
    assert.equal(await message(page), "Stopped.");
    assert.equal(largestDifference(await points(page), start), 0);
    assert.equal(await page.inputValue("#rounds"), "3");
    await page.waitForSelector("#progress", { state: "hidden" });
    await page.evaluate(() => {
      const { editor } = window.page;
      const state = editor.mesh.state();
      state.points[0] = NaN; // found by the worker only
      editor.remote.make({ state, scheme: "catmull-clark", rounds: 3, kinds: [false], origin: [0, 0, 0] }, editor.shown(true));
    });
    await page.waitForFunction(() => /finite|nan/i.test(document.querySelector("#message span").textContent));
    assert.equal(largestDifference(await points(page), start), 0);
  });
});

test("a large file is read beside the page, and gives the same mesh", async () => {
  await withPage(file, { hash: "#ring" }, async (page) => {
    const text = grid(80);
    assert.ok(text.length > 250_000);
    await dropText(page, "grid.off", text);
    await page.waitForFunction(() => window.page.editor.name === "grid.off");
    await page.fill("#rounds", "1");
    await page.check("input[name=layout][value=pn]");
    await requireSameAsCommand(page, ["--scheme", "catmull-clark", "--levels", "1"]);
    await dropText(page, "damaged.off", `${text.slice(0, -20)} x\n`);
    await page.waitForFunction(() => /^damaged\.off: /.test(document.querySelector("#message span").textContent));
    assert.equal(await page.evaluate(() => window.page.editor.name), "grid.off");
  });
});

test("a million faces are shown as they are", async () => {
  await withPage(file, { hash: "#ring" }, async (page) => {
    await page.check("input[name=layout][value=pn]");
    await dropText(page, "million.off", grid(1000));
    await page.waitForFunction(() => window.page.editor.name === "million.off");
    assert.equal(await page.getAttribute("#rounds", "max"), "0");
    assert.ok(await page.isHidden("#message"));
    assert.match(await page.textContent("#about"), /1.000.000 faces/);
    assert.equal(await facesOf(page), 1_000_000);
    assert.equal(await page.evaluate(() => window.page.editor.viewer.pane(false).mesh.geometry.getAttribute("position").count), 1001 ** 2);
    await page.click("#normals-zero");
    assert.match(await message(page), /more than 60000 faces are shown here, but not edited/);
    await page.selectOption("#example", "ring");
    assert.ok(Number(await page.getAttribute("#rounds", "max")) > 3);
    await page.click("#undo");
    assert.match(await page.textContent("#about"), /1.000.000 faces/);
  });
});

test("the share that is shown as done rises, and is gone at the end", async () => {
  await withPage(file, { hash: "#head" }, async (page) => {
    await page.fill("#rounds", "3");
    const shares = await page.evaluate(async () => {
      const { editor } = window.page;
      await editor.settled();
      const { listener } = editor.remote;
      const { onProgress } = listener;
      const shares = [];
      listener.onProgress = (share) => {
        shares.push(share ?? null);
        onProgress(share);
      };
      editor.set({ rounds: 5, layout: "both" });
      await editor.settled();
      return shares;
    });
    assert.equal(shares.pop(), null);
    assert.equal(shares.at(-1), 1);
    // the mesh, two surfaces and what is drawn of each
    assert.equal(shares.length, 5, `${shares}`);
    assert.ok(shares.every((share, i) => share > (shares[i - 1] ?? 0)), `${shares}`);
    assert.ok(await page.isHidden("#progress"));
  });
});

test("where a worker cannot be started the page says why, and shows fewer rounds", async () => {
  for (const isRefusedAtOnce of [true, false])
    await withPage(file, { hash: "#ring" }, async (page) => {
      await page.check("input[name=layout][value=pn]");
      await page.evaluate(async (isRefusedAtOnce) => {
        const { editor } = window.page;
        await editor.settled();
        editor.remote.worker = undefined; // one that has been started already would do the work
        const Original = Worker;
        window.Worker = class extends Original {
          constructor() {
            if (isRefusedAtOnce) throw new Error("no workers here");
            super(URL.createObjectURL(new Blob(["throw new Error('no workers here')"], { type: "text/javascript" })));
          }
        };
      }, isRefusedAtOnce);
      await page.selectOption("#example", "head");
      await page.fill("#rounds", "5");
      await page.waitForFunction(() => /no workers here/.test(document.querySelector("#message span").textContent));
      await page.waitForFunction(() => Number(document.getElementById("rounds").value) < 5);
      const faces = await facesOf(page);
      assert.ok(faces > 0 && faces < 15_000, `${faces} faces`);
      assert.equal(await facesMadeHere(page), faces);
      await dropText(page, "grid.off", grid(80));
      await page.waitForFunction(() => /^grid.off: .*no workers here/.test(document.querySelector("#message span").textContent));
    });
});

/** Waits for the files and for what is done while the first of them is read: by the browser or, a moment later, by a worker. */
const openMeanwhile = (page, texts, meanwhile, isInWorker = false) => page.evaluate(`(async () => {
  const opened = ${JSON.stringify(texts)}.map(([name, text]) => window.page.panel.open([new File([text], name)]));
  while (${isInWorker} && !window.page.editor.remote.endReading) await new Promise((resolve) => setTimeout(resolve));
  await (${meanwhile})();
  await Promise.all(opened);
})()`);
const nameOf = (page) => page.evaluate(() => window.page.editor.name);

test("what was chosen last is shown", async () => {
  await withPage(file, { hash: "#head" }, async (page) => {
    const [slow, small] = [grid(80), grid(2)];
    await openMeanwhile(page, [["slow.off", slow]], () => window.page.panel.showExample("ring"), true);
    assert.equal(await nameOf(page), "ring");
    for (const meanwhile of [
      () => window.page.panel.showExample("ring"),
      () => window.page.editor.undo(),
      () => window.page.panel.open([new File(["OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"], "one.off")]),
    ]) {
      await page.selectOption("#example", "bolt");
      await page.selectOption("#example", "cube");
      await openMeanwhile(page, [["slow.off", slow]], meanwhile);
      assert.match(await nameOf(page), /^(ring|bolt|one\.off)$/);
      assert.ok(await page.isHidden("#message"), await page.textContent("#message span"));
    }
    // a link that is still unpacked, and one that is damaged
    await page.selectOption("#example", "torus");
    const { hash } = new URL(await page.evaluate(() => window.page.address()), "file:///");
    await page.selectOption("#example", "cube");
    for (const link of [hash, hash.slice(0, -9)]) {
      await page.evaluate((h) => new Promise((resolve) => {
        window.addEventListener("hashchange", () => {
          window.page.panel.showExample("ring");
          setTimeout(resolve, 300);
        }, { once: true });
        location.hash = h;
      }), link);
      assert.equal(await nameOf(page), "ring");
      assert.ok(await page.isHidden("#message"), await page.textContent("#message span"));
    }
    await openMeanwhile(page, [["first.off", slow], ["second.off", `${slow}\n`], ["third.off", small]], () => {});
    assert.equal(await nameOf(page), "third.off");
    await openMeanwhile(page, [["first.off", small], ["bad.off", `${slow} x\n3 x`], ["last.off", slow]], () => {});
    assert.equal(await nameOf(page), "last.off");
    assert.ok(await page.isHidden("#message"), await page.textContent("#message span"));
  });
});

test("a file that is read beside a surface waits for nothing, and is not ended with it", async () => {
  await withPage(file, { hash: "#head" }, async (page) => {
    for (const end of [(editor) => editor.cancel(), (editor) => editor.set({ rounds: 1 })]) {
      await page.selectOption("#example", "head");
      await page.evaluate(() => window.page.editor.set({ rounds: 5, layout: "both" }));
      await openMeanwhile(page, [["grid.off", grid(80)]], `() => (${end})(window.page.editor)`);
      assert.equal(await nameOf(page), "grid.off");
    }
  });
});

test("of two meshes that are dropped together the first is shown, and the other one named", async () => {
  await withPage(file, { hash: "#ring" }, async (page) => {
    await dropAll(page, [["part.mtl", "newmtl red\n"], ["a.off", grid(2)], ["b.off", grid(3)]]);
    assert.equal(await message(page), "Not opened: part.mtl, b.off. The page shows one mesh at a time, and one file with its creases.");
    assert.equal(await nameOf(page), "a.off");
  });
});

test("a lost context comes back with what the worker has made", async () => {
  await withPage(file, { hash: "#head" }, async (page) => {
    await page.check("input[name=layout][value=pn]");
    await page.fill("#rounds", "4");
    const picture = () => page.evaluate(async () => {
      await window.page.editor.settled();
      return [...new Uint8Array(await (await window.page.editor.viewer.png()).arrayBuffer())];
    });
    const before = await picture();
    await loseContext(page, async () => {
      const { editor } = window.page; // while there is none
      editor.set({ rounds: 3 });
      await editor.settled();
    });
    assert.notDeepEqual(await picture(), before);
    await page.fill("#rounds", "4");
    assert.deepEqual(await picture(), before);
  });
});

test("what a million faces cannot have is refused in one line", async () => {
  await withPage(file, { hash: "#ring" }, async (page) => {
    await page.check("input[name=layout][value=pn]");
    await dropText(page, "million.off", grid(1000));
    await page.waitForFunction(() => window.page.editor.name === "million.off");
    await facesOf(page);
    for (const act of [
      (editor) => editor.set({ scheme: "loop" }), // which takes triangles
      (editor) => editor.openSelection("\n\n0 1\n", "edges.txt"),
      (editor) => editor.slideRoundness(0.5, true),
    ]) {
      await page.evaluate(() => (document.getElementById("message").hidden = true));
      await page.evaluate(`(${act})(window.page.editor)`);
      assert.match(await message(page), /more than 60000 faces are shown here, but not edited/);
      assert.equal(await facesOf(page), 1_000_000);
      assert.equal(await page.evaluate(() => window.page.editor.settings.scheme), "catmull-clark");
    }
  });
});
