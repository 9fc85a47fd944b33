// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// Undo and redo: what there was before each change.

export class History<State> {
  private past: State[] = [];
  private future: State[] = [];
  onChange: (() => void) | undefined;

  constructor(private readonly depth = 100) {}

  get canUndo(): boolean {
    return this.past.length > 0;
  }
  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** To be called before a change. */
  remember(state: State): void {
    this.past.push(state);
    if (this.past.length > this.depth) this.past.shift();
    this.future = [];
    this.onChange?.();
  }

  /** The change that was announced last did not take place. */
  forget(): void {
    this.past.pop();
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
