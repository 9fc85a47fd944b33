// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

// The elements of the page by their ids.

export function element<E extends Element = HTMLElement>(id: string): E {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no element ${id}`);
  return found as unknown as E;
}
export const button = (id: string): HTMLButtonElement => element<HTMLButtonElement>(id);
export const input = (id: string): HTMLInputElement => element<HTMLInputElement>(id);
export const select = (id: string): HTMLSelectElement => element<HTMLSelectElement>(id);

export function fill(list: HTMLSelectElement, options: Iterable<[value: string, title: string]>): void {
  list.replaceChildren(...Array.from(options, ([value, title]) => new Option(title, value)));
}

/** The sentence about what is chosen is under it, since fingers see no titles. */
export function choose(name: string, value: string): void {
  for (const radio of document.querySelectorAll<HTMLInputElement>(`input[name="${name}"]`)) {
    radio.checked = radio.value === value;
    if (radio.checked) element(`${name}-hint`).textContent = radio.labels![0].title;
  }
}

export function onChoice(name: string, act: (value: string) => void): void {
  for (const radio of document.querySelectorAll<HTMLInputElement>(`input[name="${name}"]`))
    radio.addEventListener("change", () => radio.checked && act(radio.value));
}

/** One line for the user, perhaps with what can be done; an error stays until it is closed or another message comes. */
export function say(text: string, kind: "error" | "note", action?: { title: string; act(): void }): void {
  const box = element("message");
  box.className = kind;
  box.querySelector("span")!.textContent = text;
  if (action) box.querySelector("span")!.append(" ", buttonOf(action.title, action.act));
  announce("");
  box.hidden = false;
}
export function buttonOf(title: string, act: () => void): HTMLButtonElement {
  const result = document.createElement("button");
  result.type = "button";
  result.className = "inline";
  result.textContent = title;
  result.addEventListener("click", act);
  return result;
}
/** Whose hyphens end no line. */
export function wordOf(text: string): HTMLElement {
  const result = document.createElement("span");
  result.className = "word";
  result.textContent = text;
  return result;
}
/** Takes any message away, or only this one. */
export function silence(text?: string): void {
  const box = element("message");
  if (text === undefined || box.querySelector("span")!.textContent === text) box.hidden = true;
}

let progressTimer = 0;
/** What has taken a while already is shown to go on. */
export function showProgress(share: number | undefined): void {
  const box = element("progress");
  if (share !== undefined) box.querySelector("progress")!.value = share;
  if (share !== undefined && progressTimer === 0) progressTimer = window.setTimeout(() => (box.hidden = false), 200);
  if (share !== undefined) return;
  clearTimeout(progressTimer);
  progressTimer = 0;
  box.hidden = true;
}

/** For screen readers. */
export function announce(text: string): void {
  element("announcement").textContent = text;
}
