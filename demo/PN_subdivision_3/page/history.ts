// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Undo and redo: what there was before each change.

const greatestSize = 2e7;

export class History<State> {
  private past: State[] = [];
  private future: State[] = [];
  onChange: (() => void) | undefined;

  /** `sizeOf` is in numbers; so many states are kept as together have not too many. */
  constructor(private readonly sizeOf: (state: State) => number) {}

  get canUndo(): boolean {
    return this.past.length > 0;
  }
  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** To be called before a change. */
  remember(state: State): void {
    this.past.push(state);
    let room = greatestSize;
    const first = this.past.findLastIndex((s) => (room -= this.sizeOf(s)) < 0);
    this.past.splice(0, Math.min(first + 1, this.past.length - 1));
    this.future = [];
    this.onChange?.();
  }

  undo(now: State): State | undefined {
    const state = this.past.pop();
    if (state !== undefined) this.future.push(now);
    this.onChange?.();
    return state;
  }

  redo(now: State): State | undefined {
    const state = this.future.pop();
    if (state !== undefined) this.past.push(now);
    this.onChange?.();
    return state;
  }
}
