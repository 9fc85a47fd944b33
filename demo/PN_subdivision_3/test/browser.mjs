// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// A browser with the page in it, and what the tests need of it: headless Chromium or, with PN_BROWSER=firefox, the Firefox that
// is installed.
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { chromium, firefox } from "playwright-core";

export const isFirefox = process.env.PN_BROWSER === "firefox";
const places = isFirefox ? [process.env.FIREFOX, "/usr/bin/firefox-esr", "/usr/bin/firefox"] : [process.env.CHROMIUM, "/usr/bin/chromium"];
const executablePath = places.find((place) => place && existsSync(place));
export const hasBrowser = executablePath !== undefined;
export const chromiumOnly = isFirefox && "does not apply: only Chromium can be told of fingers, screens and pages without scripts";

/** A screen in memory, where there is Xvfb: headless Firefox has no WebGL. */
async function startScreen() {
  if (process.env.DISPLAY || !existsSync("/usr/bin/Xvfb")) return { display: process.env.DISPLAY, close: () => {} };
  const screen = spawn("/usr/bin/Xvfb", ["-displayfd", "3", "-screen", "0", "1400x1000x24"], { stdio: ["ignore", "ignore", "ignore", "pipe"] });
  const number = await new Promise((resolve) => screen.stdio[3].once("data", resolve));
  return { display: `:${String(number).trim()}`, close: () => screen.kill() };
}

/** Playwright asks for colors in a way that not every Firefox knows; here they are settings. */
function answerForFirefox() {
  const { ws: WebSocket } = createRequire(import.meta.url)("playwright-core/lib/utilsBundle");
  const { send } = WebSocket.prototype;
  WebSocket.prototype.send = function (text, ...others) {
    const { id, method } = JSON.parse(text);
    if (method !== "emulation.setMediaFeaturesOverride") return send.call(this, text, ...others);
    setImmediate(() => this.emit("message", Buffer.from(JSON.stringify({ type: "success", id, result: {} })), false));
  };
}
if (isFirefox) answerForFirefox();

async function launchFirefox({ webgl, moves, colorScheme }) {
  const { display, close } = await startScreen();
  const firefoxUserPrefs = {
    "webgl.disabled": !webgl,
    "webgl.force-enabled": true, // where there is no graphics hardware
    "gfx.x11-egl.force-enabled": true,
    "ui.prefersReducedMotion": moves ? 0 : 1,
    "layout.css.prefers-color-scheme.content-override": colorScheme === "dark" ? 0 : 1,
  };
  const env = { ...process.env, ...(display ? { DISPLAY: display } : {}) };
  const browser = await firefox.launch({ channel: "moz-firefox", executablePath, headless: !display, firefoxUserPrefs, env });
  browser.on("disconnected", close);
  return browser;
}

const launchChromium = ({ webgl }) =>
  chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    ...(webgl ? [] : ["--disable-3d-apis"])] });

const browsers = new Map();

/** Calls use(browser) with one that is kept for the next call, and closed when none comes. */
export async function withBrowser(use, { webgl = true, moves = false, colorScheme = "light" } = {}) {
  const settings = isFirefox ? { webgl, moves, colorScheme } : { webgl };
  const key = JSON.stringify(settings);
  const kept = browsers.get(key) ?? { users: 0, launched: (isFirefox ? launchFirefox : launchChromium)(settings) };
  browsers.set(key, kept);
  clearTimeout(kept.timer);
  ++kept.users;
  try {
    return await use(await kept.launched);
  } finally {
    if (--kept.users === 0)
      kept.timer = setTimeout(() => {
        browsers.delete(key);
        kept.launched.then((browser) => browser.close(), () => {});
      }, 2000);
  }
}

/** Calls test(page, context) with the page, of a size and a color scheme; fails if it asks for anything of a network. Without
 * `moves` nothing moves by itself. */
export function withPage(file, { hash = "", webgl, moves = false, ...view }, test) {
  return withBrowser(async (browser) => {
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, reducedMotion: moves ? "no-preference" : "reduce", ...view });
    try {
      const page = await context.newPage();
      page.setDefaultTimeout(120_000); // on a busy machine
      const requests = [];
      const errors = [];
      page.on("request", (request) => requests.push(request.url()));
      page.on("pageerror", (error) => errors.push(error.message));
      page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
      const url = pathToFileURL(file).href;
      await page.goto(url + hash);
      await page.waitForFunction(() => document.documentElement.dataset.ready !== undefined);
      const result = await test(page, context);
      const foreign = requests.filter((r) => !r.startsWith(url) && !/^(data|blob):/.test(r));
      if (foreign.length > 0) throw new Error(`the page asked for ${foreign.join(", ")}`);
      if (errors.length > 0) throw new Error(`the page reported: ${errors.join("; ")}`);
      return result;
    } finally {
      await context.close();
    }
  }, { webgl, moves, colorScheme: view.colorScheme });
}
