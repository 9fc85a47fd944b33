// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers

export const space = "http://www.w3.org/2000/svg";

export function make(name: string, attributes: Record<string, string | number>, data?: Record<string, string | number>): SVGElement {
  const result = document.createElementNS(space, name);
  for (const [key, value] of Object.entries(attributes)) result.setAttribute(key, String(value));
  for (const [key, value] of Object.entries(data ?? {})) result.dataset[key] = String(value);
  return result;
}
