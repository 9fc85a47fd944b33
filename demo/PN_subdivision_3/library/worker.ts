// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The same beside the page: in a worker of the browser.

import type { Mesh, Options, Refined } from "./index.js";
import type { Request } from "./worker_script.js";

type Answer = { number: number; refined: Refined; message?: undefined } | { number: number; message: string };

export interface SubdivisionWorker {
  /** As subdivide() of load(); what it throws is what the promise is rejected with. */
  subdivide(mesh: Mesh, options?: Options): Promise<Refined>;
  /** Calls that are not done are never. */
  terminate(): void;
}

export function startWorker(): SubdivisionWorker {
  const worker = new Worker(new URL("./worker_script.js", import.meta.url), { type: "module" });
  const waiting = new Map<number, { resolve(refined: Refined): void; reject(error: Error): void }>();
  let last = 0;
  worker.onmessage = ({ data }: MessageEvent<Answer>) => {
    const call = waiting.get(data.number)!;
    waiting.delete(data.number);
    if (data.message === undefined) call.resolve(data.refined);
    else call.reject(new Error(data.message));
  };
  worker.onerror = ({ message }) => {
    for (const { reject } of waiting.values()) reject(new Error(message || "the worker cannot be started"));
    waiting.clear();
  };
  return {
    subdivide: (mesh, options) =>
      new Promise((resolve, reject) => {
        waiting.set(++last, { resolve, reject });
        worker.postMessage({ number: last, mesh, options } satisfies Request);
      }),
    terminate: () => worker.terminate(),
  };
}
