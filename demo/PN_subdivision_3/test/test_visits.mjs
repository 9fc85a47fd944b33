// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Visits: links that are damaged, leaving, what is seen before the page is there or without WebGL or JavaScript, the first
// seconds, telephones and low windows:
//   node --test test_visits.mjs      with PN_PAGE, the HTML file, in the environment
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { chromiumOnly, withBrowser, withPage } from "./browser.mjs";
import { drop, frontWedge, message, points, saved, tipOf } from "./page_actions.mjs";

const file = path.resolve(process.env.PN_PAGE);
const telephone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const lowWindows = [{ width: 844, height: 390 }, { width: 640, height: 400 }];

/** A grid of n times n squares. */
function grid(n) {
  const lines = [`OFF\n${(n + 1) ** 2} ${n * n} 0`];
  for (let i = 0; i <= n; ++i) for (let j = 0; j <= n; ++j) lines.push(`${i} ${j} ${Math.sin(i) * Math.sin(j)}`);
  const at = (i, j) => i * (n + 1) + j;
  for (let i = 0; i < n; ++i) for (let j = 0; j < n; ++j) lines.push(`4 ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`);
  return `${lines.join("\n")}\n`;
}

// --- links ---

test("a link that is damaged or cut off opens the page, with a line that says so", async () => {
  for (const hash of ["#%E0%A4%A", "#%E0%A4%A=abc", "#rin", "#picture-none", "#constructor", "#ring=bnVsbA"])
    await withPage(file, { hash }, async (page) => {
      assert.match(await message(page), /^The link cannot be read: (it is damaged|there is no (example|picture) “)[^\n]*\.$/, hash);
      assert.ok((await points(page)).length > 0);
      assert.equal(await page.evaluate(() => window.page.editor.name), "cube");
    });
  await withPage(file, { hash: "#ring" }, async (page) => {
    await page.evaluate(() => window.page.editor.setNormal(3, 0.1, 0.2, 1));
    await page.waitForTimeout(700);
    const { hash } = new URL(page.url());
    assert.ok(hash.length > 100);
    await page.selectOption("#example", "torus");
    const start = await points(page);
    for (let length = 8; length < hash.length; length += Math.ceil(hash.length / 25)) {
      const cut = hash.slice(0, length);
      await page.evaluate((h) => {
        document.getElementById("message").hidden = true;
        location.hash = h;
      }, cut);
      assert.match(await message(page), /^The link cannot be read: it is damaged, or its end is missing\.$/, cut);
      assert.deepEqual(await points(page), start);
    }
  });
});

// --- leaving ---

test("who leaves with edits that no link holds is asked, and finds them again", async () => {
  await withPage(file, { hash: "#cube" }, async (page, context) => {
    const address = pathToFileURL(file).href;
    /** Whether the page asks. */
    const leave = async (other) => {
      let asks = false;
      other.once("dialog", (dialog) => {
        asks = dialog.type() === "beforeunload";
        void dialog.accept();
      });
      await other.close({ runBeforeUnload: true });
      if (!other.isClosed()) await other.waitForEvent("close");
      return asks;
    };
    const open = async () => {
      const other = await context.newPage();
      other.setDefaultTimeout(120_000);
      await other.goto(address);
      await other.waitForFunction(() => document.documentElement.dataset.ready !== undefined);
      return other;
    };
    const openGrid = async () => {
      const other = await open();
      await drop(other, "grid.off", grid(80));
      await other.waitForFunction(() => window.page.editor.name === "grid.off");
      await other.evaluate(() => window.page.editor.set({ rounds: 0, layout: "pn" }));
      await other.mouse.click(300, 300); // who has touched nothing is not asked by any browser
      return other;
    };
    const edit = async (other) => {
      await other.evaluate(() => window.page.editor.setPoint(17, 1, 2, 3.5));
      await other.waitForTimeout(1500); // it is written
    };
    assert.equal(await leave(await openGrid()), false, "nothing was edited");
    let other = await open();
    assert.ok(await other.isHidden("#unsaved"));
    await other.mouse.click(300, 300);
    await other.evaluate(() => window.page.editor.setPoint(0, 1, 2, 3.5));
    assert.equal(await leave(other), false, "a link holds it");
    other = await openGrid();
    await edit(other);
    assert.equal(await leave(other), true);
    // it is there again
    other = await open();
    await other.waitForSelector("#unsaved:not([hidden])");
    assert.equal(await other.textContent("#unsaved span"), "Edits of grid.off were not saved.");
    await other.click("#unsaved-open");
    assert.deepEqual(await other.evaluate(() => Array.from(window.page.editor.handles.points.slice(51, 54))), [1, 2, 3.5]);
    assert.equal(await leave(other), true);
    // until it is saved
    other = await open();
    await other.click("#unsaved-open");
    await saved(other, "#save-control");
    await other.waitForTimeout(1500);
    assert.equal(await leave(other), false);
    other = await open();
    await other.waitForTimeout(300);
    assert.ok(await other.isHidden("#unsaved"));
    await other.close();
  });
});

// --- before the page is there, and without what it needs ---

test("the first surfaces are seen before the page is loaded, and no label is over another", async () => {
  const html = await readFile(file);
  // a fifth of a second at 1.6 Mbit/s, even uncompressed; the rest comes late
  const server = createServer((request, response) => {
    response.setHeader("Content-Type", "text/html");
    response.write(html.subarray(0, 40_000));
    response.on("close", () => response.destroy());
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  await withBrowser(async (browser) => {
    for (const viewport of [{ width: 1280, height: 800 }, { width: 390, height: 844 }, ...lowWindows]) {
      const page = await browser.newPage({ viewport });
      await page.goto(`http://127.0.0.1:${server.address().port}/`, { waitUntil: "commit" });
      await page.waitForFunction(() => {
        const all = [...document.querySelectorAll("#loading img")];
        const isPainted = performance.getEntriesByName("first-contentful-paint").length === 1;
        return isPainted && all.length === 2 && all.every((image) => image.complete && image.naturalWidth > 100);
      });
      const boxes = await page.evaluate(() => Object.fromEntries(
        [["linear", "#label-linear"], ["pn", "#label-pn"], ["first", "#loading img"], ["second", "#loading img + img"]].map(([name, selector]) => {
          const { left, top, right, bottom } = document.querySelector(selector).getBoundingClientRect();
          return [name, { left, top, right, bottom }];
        })));
      const overlap = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
      assert.ok(!overlap(boxes.linear, boxes.pn), JSON.stringify(boxes));
      assert.ok(!overlap(boxes.first, boxes.second));
      for (const name of ["first", "second"]) assert.ok(boxes[name].right - boxes[name].left > 90 && boxes[name].bottom - boxes[name].top > 90, JSON.stringify(boxes));
      assert.equal(await page.textContent("#loading p"), "Loading …");
      await page.close();
    }
    const page = await browser.newPage();
    await page.goto(`http://127.0.0.1:${server.address().port}/#head`, { waitUntil: "commit" });
    await page.waitForFunction(() => document.querySelector("#loading p")?.textContent === "Loading …");
    assert.equal(await page.locator("#loading img").count(), 0, "it would be another surface");
    await page.close();
  }).finally(() => {
    server.closeAllConnections();
    server.close();
  });
});

test("without JavaScript the page says what it needs, and does not load for ever", { skip: chromiumOnly }, async () => {
  await withBrowser(async (browser) => {
    const context = await browser.newContext({ javaScriptEnabled: false });
    const page = await context.newPage();
    await page.goto(pathToFileURL(file).href);
    const text = await page.locator("#surface .picture").innerText();
    assert.match(text, /needs JavaScript/);
    assert.doesNotMatch(text, /Loading/);
    await context.close();
  });
});

test("without WebGL the surfaces' tab says so, and so does the button for a picture", async () => {
  await withPage(file, { webgl: false }, async (page) => {
    await page.click("#tab-surface");
    assert.match(await page.textContent("#no-webgl"), /WebGL/);
    const isOnTop = await page.evaluate(() => {
      const { left, top, width, height } = document.getElementById("canvas").getBoundingClientRect();
      return [0.1, 0.5, 0.9].every((s) => document.elementFromPoint(left + s * width, top + s * height).id === "no-webgl");
    });
    assert.ok(isOnTop);
    assert.ok(await page.isHidden("#caption"));
    await page.click("#message button");
    await page.click("#save-png");
    assert.match(await message(page), /^There is no picture: .*WebGL/);
  });
});

// --- the first seconds ---

test("a normal turns by itself once, and nothing has changed then", async () => {
  const isTurning = () => window.page.turnMe.end !== undefined;
  await withPage(file, { moves: true }, async (page) => {
    const different = await page.evaluate(async () => {
      const seen = new Set();
      while (window.page.turnMe.end !== undefined) {
        seen.add(window.page.editor.shownSurface.points().join());
        await new Promise((resolve) => setTimeout(resolve, 50));
      }
      return seen.size;
    });
    assert.ok(different > 3, `${different} surfaces are seen`);
    assert.ok(await page.isDisabled("#undo"));
    assert.ok(await page.isVisible("#turn-me span"));
    await page.waitForTimeout(700);
    assert.equal(await page.evaluate(() => window.page.editsOfNow()), undefined);
    const after = await points(page);
    await page.click("#picture-cube");
    assert.deepEqual(await points(page), after);
  });
  // it ends when somebody does something
  await withPage(file, { moves: true }, async (page) => {
    assert.ok(await page.evaluate(isTurning));
    await page.evaluate(() => {
      const normals = (state) => state.cornerNormals.join();
      const start = normals(window.page.exampleState("cube"));
      window.turned = () => normals(window.page.editor.mesh.state()) !== start;
    });
    await page.waitForFunction(() => window.turned() || window.page.turnMe.end === undefined);
    await page.keyboard.press("Tab");
    assert.ok(!(await page.evaluate(isTurning)));
    assert.equal(await page.evaluate(() => window.turned()), false);
  });
  await withPage(file, {}, async (page) => assert.ok(!(await page.evaluate(isTurning)), "who wants no motion sees none"));
});

test("the tour is on telephones, too, and shows the normals that it speaks of", async () => {
  for (const options of [telephone, ...lowWindows.map((viewport) => ({ viewport }))])
    await withPage(file, options, async (page) => {
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
      await page.click("#tour");
      await page.click("#tour-next");
      assert.match(await page.textContent("#tour-title"), /^2 of 5/);
      assert.ok(await page.evaluate(() => window.page.editor.settings.showNormals && window.page.editor.viewer.control.normals.visible));
      const [box, canvas] = await page.evaluate(() => ["tour-box", "canvas"].map((id) => {
        const { left, top, right, bottom } = document.getElementById(id).getBoundingClientRect();
        return { left, top, right, bottom };
      }));
      assert.ok(box.top >= canvas.bottom || box.left >= canvas.right - 1, `${JSON.stringify(box)} ${JSON.stringify(canvas)}`);
    });
});

test("words of the page have a sentence each", async () => {
  await withPage(file, {}, async (page) => {
    const text = () => page.locator("#surface .panel").innerText();
    for (const sentence of ["Each round", "Roundness tells", "no color where it is even"]) assert.ok((await text()).includes(sentence), sentence);
    for (const [name, value] of [["layout", "pn"], ["shading", "zebra"]]) {
      await page.check(`input[name=${name}][value=${value}]`);
      assert.ok((await page.textContent(`#${name}-hint`)).length > 20);
    }
    assert.match(await text(), /PN, point-normal: /);
  });
});

test("nothing is written over the surface on telephones, and over the picture of a low window", async () => {
  await withPage(file, { ...telephone, hash: "#picture-bolt" }, async (page) => {
    const [caption, canvas] = await page.evaluate(() => ["caption", "canvas"].map((id) => document.getElementById(id).getBoundingClientRect().toJSON()));
    assert.ok(caption.height > 0 && caption.bottom <= canvas.top, JSON.stringify([caption, canvas]));
    assert.ok(canvas.height > 0.4 * telephone.viewport.height);
  });
  for (const viewport of lowWindows)
    for (const name of ["cube", "waves"])
      await withPage(file, { viewport, hash: `#picture-${name}` }, async (page) => {
        const boxesOf = (...ids) => page.evaluate((all) => ["canvas", ...all].map((id) => [id, document.getElementById(id).getBoundingClientRect().toJSON()]), ids);
        const areBeside = ([[, canvas], ...others]) => {
          for (const [id, { height, top, bottom }] of others)
            assert.ok(height > 0 && (bottom <= canvas.top || top >= canvas.bottom), `${id} of ${name} at ${viewport.width}: ${JSON.stringify(others)}`);
          assert.ok(canvas.height > 0.45 * viewport.height, JSON.stringify(canvas));
        };
        areBeside(await boxesOf("caption", "status", ...(name === "cube" ? ["scale"] : [])));
        await page.check("input[name=shading][value=gaussian]"); // which ends the caption
        areBeside(await boxesOf("scale", "status"));
        const [needed, there] = await page.$eval("#surface .panel", (panel) => [panel.scrollWidth, panel.clientWidth]);
        assert.ok(needed <= there, `the panel needs ${needed} pixels of ${there}`);
      });
});

test("normals of a file that is opened are in the picture, and under no label", async () => {
  const cube = "OFF\n8 12 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n" + [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2],
    [1, 3, 7, 5]].map(([a, b, c, d]) => `3 ${a} ${b} ${c}\n3 ${a} ${c} ${d}\n`).join("");
  for (const options of [{}, telephone, ...lowWindows.map((viewport) => ({ viewport }))])
    await withPage(file, options, async (page) => {
      await drop(page, "cube.off", cube);
      await page.waitForFunction(() => window.page.editor.name === "cube.off");
      for (const wedge of await page.evaluate(() => [...window.page.editor.handles.vertices.keys()])) {
        const { x, y } = await tipOf(page, wedge);
        const [pane, label] = await page.evaluate(() => ["canvas", "label-pn"].map((id) => document.getElementById(id).getBoundingClientRect().toJSON()));
        const place = JSON.stringify({ x, y, pane, label });
        assert.ok(x > (pane.left + pane.right) / 2 + 3 && x < pane.right - 3 && y > pane.top + 3 && y < pane.bottom - 3, place);
        assert.ok(y > label.bottom + 2 || x > label.right, place);
      }
    });
});

test("what is opened begins with its title, and no word of the command is broken", async () => {
  for (const options of [{ viewport: lowWindows[0] }, telephone])
    await withPage(file, options, async (page) => {
      for (const [button, title] of [["recipe", "recipe-title"], ["help", "help-title"]]) {
        await page.click(`#${button}`);
        const [top, bottom] = await page.$eval(`#${title}`, (e) => [e.getBoundingClientRect().top - e.parentElement.getBoundingClientRect().top, e.getBoundingClientRect().bottom]);
        assert.ok(top > 0 && bottom < options.viewport.height, `${title} at ${top}`);
        if (button === "recipe") {
          const heights = await page.$$eval("#recipe-command .word", (words) => words.map((word) => word.getBoundingClientRect().height));
          assert.ok(heights.length > 8 && Math.max(...heights) < 1.5 * Math.min(...heights), `${heights}`);
        }
        await page.keyboard.press("Escape");
      }
    });
});
