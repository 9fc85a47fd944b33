// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Edits of a mesh that is too large for a link: kept by the browser, where it keeps anything, until there is a file of
// them.

import type { MeshState } from "./modeler";

export interface Unsaved {
  name: string;
  mesh: MeshState;
  settings: unknown;
}

const store = "edits";
const key = "last";

function opened(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open("pn_subdivision_3", 1);
    request.onupgradeneeded = () => request.result.createObjectStore(store);
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

/** Nothing where the browser keeps nothing. */
async function ask<T>(mode: IDBTransactionMode, act: (edits: IDBObjectStore) => IDBRequest<T>): Promise<T | undefined> {
  try {
    const database = await opened();
    const transaction = database.transaction(store, mode);
    const request = act(transaction.objectStore(store));
    return await new Promise<T>((resolve, reject) => {
      transaction.oncomplete = () => resolve(request.result);
      transaction.onabort = () => reject(transaction.error);
    }).finally(() => database.close());
  } catch {
    return undefined;
  }
}

export const keep = (edits: Unsaved): Promise<unknown> => ask("readwrite", (all) => all.put(edits, key));
export const kept = (): Promise<Unsaved | undefined> => ask("readonly", (all) => all.get(key));
export const forget = (): Promise<unknown> => ask("readwrite", (all) => all.delete(key));

export function isSameMesh(a: MeshState, b: MeshState | undefined): boolean {
  const names = ["points", "corners", "degrees", "cornerNormals", "sharpEdges", "roundness"] as const;
  return a === b || (b !== undefined && names.every((name) => {
    const [x, y] = [a[name], b[name]];
    return x?.length === y?.length && (!x || x.every((value, i) => value === y![i]));
  }));
}
