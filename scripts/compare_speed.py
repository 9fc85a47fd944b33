#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Times this package beside other libraries, and writes the page on speed of the manual.

The program `peers` of benchmark/PN_subdivision_3 is built if need be, with what it finds of CGAL,
OpenMesh and OpenSubdiv; VTK is timed from Python where that has it. All jobs on a control mesh run in
turn. The standard set takes about seven minutes on an idle machine.
"""

import argparse
import datetime
import itertools
import platform
import sys
import tempfile
from pathlib import Path

from refinery import ROOT, run
from speed_comparison import measurements, page
from speed_comparison.measurements import Medians, Servers

BUILD = ROOT / "build" / "release"
PEERS = BUILD / "benchmark" / "PN_subdivision_3" / "peers"
PAGE = ROOT / "doc" / "PN_subdivision_3" / "Speed.md"
CHART = ROOT / "doc" / "PN_subdivision_3" / "fig" / "speed.svg"


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--schemes", nargs="+", choices=list(page.TITLES), default=list(page.TITLES))
    parser.add_argument("--sizes", nargs="+", type=int, metavar="FACES",
                        default=[10_000, 100_000, 1_000_000, 10_000_000])
    parser.add_argument("--repetitions", type=int, default=15)
    parser.add_argument("--seconds", type=float, default=1,
                        help="a job that has taken as long is not repeated (default: 1)")
    parser.add_argument("--regular-only", action="store_true",
                        help="neither other control meshes nor fresh processes nor huge pages")
    parser.add_argument("--results", type=Path, metavar="FILE.csv",
                        help="where to keep what was measured")
    parser.add_argument("--from", type=Path, dest="measured", metavar="FILE.csv",
                        help="what was measured before, in place of measuring")
    return parser.parse_args()


def processor() -> str:
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return platform.processor()


def machine(servers: Servers) -> list[str]:
    cache = (BUILD / "CMakeCache.txt").read_text().splitlines()
    compiler = next(line.split("=", 1)[1] for line in cache if line.startswith("CMAKE_CXX_COMPILER:"))
    version = run(compiler, "--version").splitlines()[0]
    cores = run("nproc").strip()
    return [
        f"machine: {processor()}, {cores} cores, {platform.system()} {platform.release()}",
        f"compiler: {version}, Release (-O3), portable build",
        "libraries: " + ", ".join(servers.listing("--libraries")),
        f"date: {datetime.date.today().isoformat()}",
    ]


def measure(options: argparse.Namespace, servers: Servers, folder: Path) -> Medians:
    medians: Medians = {}
    groups = [("regular", size, "warm", (1, 2)) for size in options.sizes]
    if not options.regular_only:
        middle = [size for size in options.sizes if size in (100_000, 1_000_000)]
        others = (("irregular", "warm"), ("real", "warm"), ("regular", "fresh"), ("regular", "huge"))
        groups += [(kind, size, process, (1,)) for kind, process in others for size in middle]
    for scheme, (kind, size, process, threads) in itertools.product(options.schemes, groups):
        if scheme == "kobbelt" and kind != "regular":
            continue  # it takes quads only
        print(f"{scheme}, {kind}, {size} faces, {process}", file=sys.stderr)
        runs = measurements.runs_of_group(servers, scheme, kind, size, process, threads)
        # the standard run of every day is the regular one: of the others less is enough
        is_standard = (kind, process) == ("regular", "warm")
        medians |= measurements.measure_group(servers, runs, folder,
                                              options.repetitions if is_standard else 5,
                                              options.seconds if is_standard else options.seconds / 2)
        if options.results:
            measurements.write(options.results, medians, machine(servers))
    return medians


def main() -> None:
    options = arguments()
    if options.measured:
        medians, of_machine = measurements.read(options.measured)
    else:
        run("scripts/build.sh", "peers")
        servers = Servers(PEERS)
        of_machine = machine(servers)
        with tempfile.TemporaryDirectory() as folder:
            medians = measure(options, servers, Path(folder))
    page.write(PAGE, medians, of_machine)
    page.write_chart(CHART, medians)


if __name__ == "__main__":
    main()
