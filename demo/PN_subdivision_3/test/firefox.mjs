// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Firefox, told what to do by WebDriver BiDi, which it speaks itself.
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";

const { ws: WebSocket } = createRequire(import.meta.url)("playwright-core/lib/utilsBundle");

export const firefoxPath = process.env.FIREFOX ?? ["/usr/bin/firefox-esr", "/usr/bin/firefox"].find(existsSync);
export const hasFirefox = firefoxPath !== undefined && existsSync(firefoxPath);

class Connection {
  constructor(socket) {
    this.socket = socket;
    this.waiting = new Map();
    socket.on("message", (text) => {
      const { id, result, error, message } = JSON.parse(text);
      const call = this.waiting.get(id);
      this.waiting.delete(id);
      if (error) call?.reject(new Error(`${error}: ${message}`));
      else call?.resolve(result);
    });
  }

  send(method, params) {
    const id = this.waiting.size + Date.now();
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.socket.send(JSON.stringify({ id, method, params }));
    });
  }
}

/** A screen in memory, where there is Xvfb: headless Firefox has no WebGL. */
async function startScreen() {
  if (process.env.DISPLAY || !existsSync("/usr/bin/Xvfb")) return undefined;
  const screen = spawn("/usr/bin/Xvfb", ["-displayfd", "3", "-screen", "0", "1400x1000x24"], { stdio: ["ignore", "ignore", "ignore", "pipe"] });
  const number = await new Promise((resolve) => screen.stdio[3].once("data", resolve));
  return { process: screen, display: `:${String(number).trim()}` };
}

async function end(process) {
  if (!process || process.exitCode !== null) return;
  const ended = new Promise((resolve) => process.on("exit", resolve));
  process.kill();
  await ended;
}

async function connect(firefox) {
  const address = await new Promise((resolve, reject) => {
    let said = "";
    firefox.stderr.on("data", (text) => {
      said += text;
      const found = /listening on (ws:\S+)/.exec(said);
      if (found) resolve(found[1]);
    });
    firefox.on("exit", () => reject(new Error(`Firefox has ended: ${said}`)));
  });
  const socket = new WebSocket(`${address}/session`);
  await new Promise((resolve, reject) => socket.on("open", resolve).on("error", reject));
  return new Connection(socket);
}

/** Calls test(page) with a page of 1280 times 800 pixels: evaluate(expression), which may be a promise, click(x, y),
 * resize(width, height), go(address), screenshot(). */
export async function withFirefox(address, test) {
  const profile = await mkdtemp(path.join(tmpdir(), "pn-firefox-"));
  // where there is no graphics hardware
  const settings = ["webgl.force-enabled", "gfx.x11-egl.force-enabled"].map((name) => `user_pref("${name}", true);\n`);
  await writeFile(path.join(profile, "user.js"), settings.join(""));
  const screen = await startScreen();
  const display = screen?.display ?? process.env.DISPLAY;
  const firefox = spawn(firefoxPath,
    [...(display ? [] : ["--headless"]), "--no-remote", "--profile", profile, "--remote-debugging-port", "0", "about:blank"],
    { stdio: ["ignore", "ignore", "pipe"], env: { ...process.env, ...(display ? { DISPLAY: display } : {}) } });
  try {
    const connection = await connect(firefox);
    await connection.send("session.new", { capabilities: {} });
    const { contexts } = await connection.send("browsingContext.getTree", {});
    const { context } = contexts[0];
    await connection.send("browsingContext.setViewport", { context, viewport: { width: 1280, height: 800 } });
    await connection.send("browsingContext.navigate", { context, url: address, wait: "complete" });
    return await test({
      async evaluate(expression) {
        const { type, result, exceptionDetails } = await connection.send("script.evaluate",
          { expression: `(async () => JSON.stringify(await (${expression})))()`, target: { context }, awaitPromise: true });
        if (type === "exception") throw new Error(exceptionDetails.text);
        return result.value === undefined ? undefined : JSON.parse(result.value);
      },
      resize: (width, height) => connection.send("browsingContext.setViewport", { context, viewport: { width, height } }),
      go: (to) => connection.send("browsingContext.navigate", { context, url: to, wait: "complete" }),
      click: (x, y) => connection.send("input.performActions", { context, actions: [{ type: "pointer", id: "mouse", actions: [
        { type: "pointerMove", x: Math.round(x), y: Math.round(y) }, { type: "pointerDown", button: 0 }, { type: "pointerUp", button: 0 }] }] }),
      screenshot: async () => Buffer.from((await connection.send("browsingContext.captureScreenshot", { context })).data, "base64"),
    });
  } finally {
    await end(firefox);
    await end(screen?.process);
    await rm(profile, { recursive: true, force: true });
  }
}
