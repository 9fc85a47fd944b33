# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The tables of the page on speed."""

from pathlib import Path

from .measurements import Median, Medians, Run

TITLES = {
    "catmull-clark": "Catmull-Clark",
    "loop": "Loop",
    "doo-sabin": "Doo-Sabin",
    "sqrt3": "&radic;3",
    "butterfly": "Butterfly",
    "kobbelt": "Kobbelt",
}
NAMES = {
    "pn/surface-mesh": "**this package, PN, `Surface_mesh`**",
    "pn-linear/surface-mesh": "this package, linear, `Surface_mesh`",
    "pn/polyhedron": "this package, PN, `Polyhedron_3`",
    "pn-linear/polyhedron": "this package, linear, `Polyhedron_3`",
    "cgal/surface-mesh": "CGAL, `Surface_mesh`",
    "cgal/polyhedron": "CGAL, `Polyhedron_3`",
    "opensubdiv/last-level": "OpenSubdiv, last level reduced",
    "opensubdiv/full-topology": "OpenSubdiv, full topology",
    "openmesh/mesh": "OpenMesh",
    "vtk/filter": "VTK",
    "floor/fresh": "*floor: the bytes of the result with normals, to fresh memory*",
    "floor/again": "*the same, to memory in use*",
    "pn/refiner": "`Surface_refiner`, PN",
    "pn-linear/refiner": "`Surface_refiner`, linear",
    "opensubdiv/stencils": "OpenSubdiv, table of stencils, `float`",
}
DETAILED = ("catmull-clark", "loop")  # the ratios and the chart have all
# CGAL has no interpolatory scheme for quads: Kobbelt's is beside its Catmull-Clark
BESIDE = {"kobbelt": "catmull-clark"}


def size_name(size: int) -> str:
    return f"{size // 1_000_000} M" if size >= 1_000_000 else f"{size // 1000} k"


def number(x: float) -> str:
    return f"{x:.0f}" if x >= 100 else f"{x:.1f}" if x >= 10 else f"{x:.2f}"


def table(header: list[str], rows: list[list[str]]) -> list[str]:
    lines = [header, ["---"] + ["---:"] * (len(header) - 1)] + rows
    return ["| " + " | ".join(line) + " |" for line in lines] + [""]


class Page:
    def __init__(self, medians: Medians):
        self.medians = medians
        self.schemes = [s for s in TITLES if any(r.scheme == s for r in medians)]
        self.detailed = [s for s in self.schemes if s in DETAILED]
        self.sizes = sorted({r.size for r in medians if (r.kind, r.process) == ("regular", "warm")})

    def find(self, scheme: str, job: str, size: int, threads: int = 1, kind: str = "regular",
             process: str = "warm") -> Median | None:
        m = self.medians.get(Run(scheme, kind, size, process, job, threads))
        beside = BESIDE.get(scheme, "")
        if m is None and beside and job.startswith("cgal/"):
            return self.find(beside, job, size, threads, kind, process)
        return m

    def tables_of_meshes(self, size: int) -> list[str]:
        """regular and other control meshes, fresh processes and huge pages"""
        columns = (("regular", "warm"), ("irregular", "warm"), ("real", "warm"),
                   ("regular", "fresh"), ("regular", "huge"))
        lines = []
        for scheme in self.detailed:
            rows = []
            for job in NAMES:
                found = [self.find(scheme, job, size, 1, *c) for c in columns]
                if any(found):
                    rows.append([NAMES[job]] + [number(m.ns_per_face()) if m else "" for m in found])
            lines += [f"### {TITLES[scheme]}", ""]
            lines += table(["", "regular", "irregular", "real", "regular, fresh process", "regular, huge pages"], rows)
        return lines

    def table_of_ratios(self) -> list[str]:
        """point-normal subdivision to CGAL's linear functions"""
        rows = []
        for scheme in self.schemes:
            for threads in (1, 2):
                row = [TITLES[scheme] + (", 2 threads" if threads == 2 else "")]
                for size in self.sizes:
                    pn = self.find(scheme, "pn/surface-mesh", size, threads)
                    other = self.find(scheme, "cgal/surface-mesh", size)
                    row.append(f"{pn.ns_per_face() / other.ns_per_face():.2f}" if pn and other else "")
                if any(row[1:]):
                    rows.append(row)
        return table([""] + [f"{size_name(s)}, / CGAL" for s in self.sizes], rows)

    def lines(self) -> list[str]:
        lines = ["", "## Ratios", ""] + self.table_of_ratios()
        size = max((r.size for r in self.medians if r.kind == "irregular"), default=self.sizes[-1])
        lines += ["## Whole jobs", "", f"Nanoseconds a refined face, about {size_name(size)} faces, one thread; the chart has other sizes. "
                  "A `Surface_refiner` and tables of stencils get all control points again.", ""]
        return lines + self.tables_of_meshes(size)


BEGIN, END = "<!-- begin of the tables -->", "<!-- end of the tables -->"


def write(page: Path, medians: Medians, machine: list[str]) -> None:
    """puts the tables between the marks of the page"""
    before, rest = page.read_text().split(BEGIN)
    after = rest.split(END)[1]
    lines = [BEGIN, ""] + [f"- {line}" for line in machine] + Page(medians).lines() + [END]
    page.write_text(before + "\n".join(lines) + after)
