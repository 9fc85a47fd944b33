// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Headless Chromium with the page in it, and what the tests need of it.
import { existsSync } from "node:fs";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

export const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
export const hasBrowser = existsSync(executablePath);

/** Calls test(page, context) with the page, of a size and a color scheme; fails if it asks for anything of a network. */
export async function withPage(file, options, test) {
  const profile = await mkdtemp(path.join(tmpdir(), "pn-page-"));
  const { hash = "", args = [], ...view } = options;
  const context = await chromium.launchPersistentContext(profile, {
    executablePath,
    headless: true,
    acceptDownloads: true,
    viewport: { width: 1280, height: 800 },
    reducedMotion: "reduce", // nothing moves by itself
    ...view,
    args: ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", ...args],
  });
  try {
    const page = context.pages()[0] ?? (await context.newPage());
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
    await rm(profile, { recursive: true, force: true });
  }
}
