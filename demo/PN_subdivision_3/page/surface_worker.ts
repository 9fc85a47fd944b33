// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The worker of the page, which makes the surfaces that take long.

import { instantiate, messageOf } from "./instantiate";
import type { ControlMesh, Modeler } from "./modeler_types";
import { readFile, type ReadJob } from "./read_file";
import { Surfaces } from "./surfaces";
import type { Answer, DrawJob, Drawn, ReadMesh, Request } from "./worker_messages";

const scope = globalThis as unknown as {
  onmessage: ((event: { data: WebAssembly.Module | Request }) => void) | null;
  postMessage(answer: Answer, transfer?: Transferable[]): void;
};

class SurfaceWorker {
  private readonly surfaces: Surfaces;
  private mesh: ControlMesh | undefined;
  private wedges = new Map<number, number[]>(); // by vertex

  constructor(private readonly modeler: Modeler) {
    this.surfaces = new Surfaces(modeler);
  }

  draw({ make, points, normals, shown }: DrawJob, onProgress: (share: number) => void): Drawn {
    const started = performance.now();
    const steps = (make ? 2 * make.kinds.length : 0) + 1;
    let done = 0;
    const onStep = (): void => onProgress(++done / steps);
    if (make) {
      const mesh = this.modeler.restoreMesh(make.state);
      onStep();
      this.surfaces.clear(); // there may not be room for both
      this.mesh?.delete();
      this.mesh = mesh;
      this.surfaces.make(mesh, make, onStep);
      this.wedges = new Map();
      mesh.handles().vertices.forEach((v, w) => this.wedges.set(v, [...(this.wedges.get(v) ?? []), w]));
    }
    const mesh = this.mesh!;
    for (const [v, x, y, z] of points) mesh.setPoint(v, x, y, z);
    for (const [v, x, y, z] of normals) for (const w of this.wedges.get(v) ?? []) mesh.setNormal(w, x, y, z);
    if (points.length + normals.length > 0)
      this.surfaces.follow(mesh, new Set([...points, ...normals].map(([v]) => v)));
    const milliseconds = make || points.length + normals.length > 0 ? performance.now() - started : undefined;
    const { drawings, colorEnd } = this.surfaces.draw(mesh, shown, onStep);
    for (const drawing of drawings) {
      drawing.positions = drawing.positions.slice();
      drawing.normals = drawing.normals.slice();
    }
    return { drawings, colorEnd, milliseconds };
  }

  read(job: ReadJob): ReadMesh {
    const { mesh, about } = readFile(this.modeler, job);
    const result = { state: mesh.state(), hasOnlyTriangles: mesh.hasOnlyTriangles(), about };
    mesh.delete();
    return result;
  }

  answer(request: Request): void {
    const { number } = request;
    const answer = (): Answer => {
      if ("draw" in request)
        return { number, drawn: this.draw(request.draw, (progress) => scope.postMessage({ number, progress })) };
      if ("read" in request) return { number, read: this.read(request.read) };
      return { number, content: this.surfaces.content(this.mesh!, request.content.isLinear) };
    };
    try {
      const result = answer();
      scope.postMessage(result, buffersOf(result));
    } catch (error) {
      scope.postMessage({ number, message: messageOf(error) });
    }
  }
}

/** Of all arrays in an object. */
function buffersOf(value: unknown): ArrayBuffer[] {
  if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
  return typeof value === "object" && value !== null ? Object.values(value).flatMap(buffersOf) : [];
}

let worker: Promise<SurfaceWorker>;
scope.onmessage = async ({ data }) => {
  if (data instanceof WebAssembly.Module) worker = instantiate(data).then((modeler) => new SurfaceWorker(modeler));
  else
    await worker.then((ready) => ready.answer(data), (error) => scope.postMessage({ number: data.number, message: messageOf(error) }));
};
