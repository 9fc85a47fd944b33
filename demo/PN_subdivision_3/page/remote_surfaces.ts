// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The surfaces that the worker makes, as the page sees them.

import workerAddress from "surface-worker-code";
import type { Content, Shown } from "./surfaces";
import { messageOf } from "./instantiate";
import type { ReadJob } from "./read_file";
import type { Answer, DrawJob, Drawn, Edit, Make, ReadMesh, Request } from "./worker_messages";

/** A worker that has been busy for so many milliseconds with what nobody wants any more is ended. */
const patience = 300;

interface Waiting {
  resolve(answer: never): void;
  reject(error: Error): void;
}

export interface Listener {
  onDrawn(drawn: Drawn, isLast: boolean): void;
  onFailure(message: string): void;
  /** From 0 to 1; undefined: nothing is being done. */
  onProgress(share: number | undefined): void;
}

/** One job is done at a time; of those that wait, what is no longer wanted is not done. */
export class RemoteSurfaces {
  private worker: Worker | undefined;
  private number = 0;
  private running: { number: number; job: DrawJob; since: number } | undefined;
  private next: DrawJob | undefined;
  private readonly waiting = new Map<number, Waiting>();
  private settling: (() => void)[] = [];
  private endReading: (() => void) | undefined;

  constructor(
    private readonly module: WebAssembly.Module,
    private readonly listener: Listener,
  ) {}

  make(make: Make, shown: Shown): void {
    this.next = { make, points: [], normals: [], shown };
    if (this.running?.job.make && performance.now() - this.running.since > patience) this.end("something else is wanted");
    this.pump();
  }

  edit(points: Edit[], normals: Edit[], shown: Shown): void {
    const { next } = this;
    this.next = { make: next?.make, points: [...(next?.points ?? []), ...points], normals: [...(next?.normals ?? []), ...normals], shown };
    this.pump();
  }

  show(shown: Shown): void {
    this.edit([], [], shown);
  }

  /** Nothing is wanted any more. */
  cancel(): void {
    this.next = undefined;
    if (this.running) this.end("cancelled");
    this.pump();
  }

  content(isLinear: boolean): Promise<Content> {
    return this.ask<{ content: Content }>({ content: { isLinear } }).then(({ content }) => content);
  }

  /** By a worker of its own, which waits for no surface and is stopped by the next file only. */
  read(read: ReadJob): Promise<ReadMesh> {
    this.endReading?.();
    return new Promise((resolve, reject) => {
      const take = (answer: Answer): void => {
        worker.terminate();
        if ("read" in answer) resolve(answer.read);
        else reject(new Error("message" in answer ? answer.message : undefined));
      };
      const worker = startWorker(this.module, take, (message) => take({ number: 0, message }));
      this.endReading = () => take({ number: 0, message: "another file is read" });
      worker.postMessage({ number: 0, read } satisfies Request, [read.content.buffer as ArrayBuffer]);
    });
  }

  /** Until nothing is left to do. */
  settled(): Promise<void> {
    return this.running || this.next ? new Promise((resolve) => this.settling.push(resolve)) : Promise.resolve();
  }

  private ask<T>(request: Record<string, unknown>): Promise<T> {
    const number = ++this.number;
    return new Promise<T>((resolve, reject) => {
      this.started().postMessage({ number, ...request } as Request);
      this.waiting.set(number, { resolve: resolve as (answer: never) => void, reject });
    });
  }

  private started(): Worker {
    return (this.worker ??= startWorker(this.module, (answer) => this.take(answer), (message) => this.fail(message)));
  }

  private end(reason: string): void {
    this.worker?.terminate();
    this.worker = undefined;
    this.running = undefined;
    for (const { reject } of this.waiting.values()) reject(new Error(reason));
    this.waiting.clear();
  }

  private fail(message: string): void {
    this.end(message);
    this.next = undefined;
    this.listener.onFailure(message);
    this.pump();
  }

  private pump(): void {
    if (this.running) return;
    const job = this.next;
    if (!job) {
      this.listener.onProgress(undefined);
      for (const resolve of this.settling.splice(0)) resolve();
      return;
    }
    this.next = undefined;
    this.running = { number: ++this.number, job, since: performance.now() };
    try {
      this.started().postMessage({ number: this.number, draw: job } satisfies Request);
    } catch (error) {
      this.fail(messageOf(error)); // a page that may have no workers
    }
  }

  private take(answer: Answer): void {
    const isOfRunning = answer.number === this.running?.number;
    if ("progress" in answer) {
      if (isOfRunning && this.running!.job.make) this.listener.onProgress(answer.progress);
    } else if (isOfRunning) {
      const { job } = this.running!;
      if ("message" in answer) return this.fail(answer.message);
      this.running = undefined;
      // what is made anew at once is not worth a picture
      if ("drawn" in answer && !this.next?.make) this.listener.onDrawn(answer.drawn, job.shown.isLast);
      this.pump();
    } else {
      const waiting = this.waiting.get(answer.number);
      this.waiting.delete(answer.number);
      if ("message" in answer) waiting?.reject(new Error(answer.message));
      else waiting?.resolve(answer as never);
    }
  }
}

function startWorker(module: WebAssembly.Module, take: (answer: Answer) => void, fail: (message: string) => void): Worker {
  const address = workerAddress();
  const worker = new Worker(address);
  worker.onmessage = ({ data }: MessageEvent<Answer>) => take(data);
  worker.onerror = (event) => {
    event.preventDefault(); // it is told here
    fail(event.message || "the worker cannot be started");
  };
  worker.postMessage(module);
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
  return worker;
}
