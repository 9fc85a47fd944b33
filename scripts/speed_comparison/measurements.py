# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""What is measured, by processes that run jobs: a line in, a line out (see benchmark/PN_subdivision_3/peers/peers.cpp)."""

import csv
import os
import random
import statistics
import subprocess
import sys
import time
from collections import defaultdict
from dataclasses import astuple, dataclass, fields
from pathlib import Path

from refinery import run as output_of

from .control_meshes import control_mesh

VTK_PEER = Path(__file__).parent.with_name("vtk_peer.py")


@dataclass(frozen=True, order=True)
class Run:
    """a job on a control mesh; `process` is warm, fresh or huge (warm, with huge pages)"""

    scheme: str
    kind: str
    size: int
    process: str
    job: str  # library/variant
    threads: int


@dataclass(frozen=True)
class Median:
    """of what was measured, once or several times"""

    faces: int
    seconds: float
    page_faults: float
    repetitions: int

    def ns_per_face(self) -> float:
        return 1e9 * self.seconds / self.faces


Medians = dict[Run, Median]

# jobs that run on several threads, too
PARALLEL = ("pn/surface-mesh", "pn/refiner", "pn-linear/refiner", "opensubdiv/stencils")
# a table of stencils for 10 M faces takes several gigabytes while it is made
LARGEST = {"opensubdiv/stencils": 2_000_000}


class Server:
    """one process, which keeps what it has warmed up"""

    def __init__(self, command: list[str], threads: int, has_huge_pages: bool):
        environment = dict(os.environ, OMP_NUM_THREADS=str(threads))
        if has_huge_pages:  # the allocator asks for them; of use where the system grants them then
            environment["GLIBC_TUNABLES"] = "glibc.malloc.hugetlb=1"
        self.threads = threads
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        text=True, env=environment)

    def run(self, job: str, control: str, rounds: int) -> Median:
        assert self.process.stdin and self.process.stdout
        print(job, control, rounds, self.threads, file=self.process.stdin, flush=True)
        words = self.process.stdout.readline().split()
        if len(words) != 3:
            raise RuntimeError(f"{job} on {control} failed")
        return Median(int(words[0]), float(words[1]), int(words[2]), 1)

    def close(self) -> None:
        if self.process.stdin:
            self.process.stdin.close()
        self.process.wait()


def python_with_vtk() -> str:
    """an interpreter that has VTK, or nothing"""
    for python in (sys.executable, "/usr/bin/python3"):
        has_vtk = subprocess.run([python, "-c", "import vtk, numpy"], capture_output=True, check=False)
        if has_vtk.returncode == 0:
            return python
    return ""


class Servers:
    """one for each library and number of threads, started where it is first needed"""

    def __init__(self, peers: Path):
        self.peers = peers
        self.vtk = python_with_vtk()
        self.running: dict[tuple[str, int, bool], Server] = {}
        self.listings: dict[str, list[str]] = {}

    def listing(self, option: str) -> list[str]:
        if option not in self.listings:
            lines = output_of(self.peers, option).splitlines()
            if self.vtk:
                lines += output_of(self.vtk, VTK_PEER, option).splitlines()
            self.listings[option] = lines
        return self.listings[option]

    def start(self, job: str, threads: int, has_huge_pages: bool = False) -> Server:
        is_vtk = job.startswith("vtk/")
        command = [self.vtk, str(VTK_PEER)] if is_vtk else [str(self.peers)]
        return Server(command, threads, has_huge_pages)

    def warm(self, job: str, threads: int, has_huge_pages: bool) -> Server:
        key = job.split("/")[0], threads, has_huge_pages
        if key not in self.running:
            self.running[key] = self.start(job, threads, has_huge_pages)
        return self.running[key]

    def close(self) -> None:
        for server in self.running.values():
            server.close()
        self.running.clear()


# --- runs ---


def jobs_of(servers: Servers, scheme: str) -> list[str]:
    names = [line.rsplit("/", 1) for line in servers.listing("--list")]
    return [job for job, of_scheme in names if of_scheme == scheme]


def runs_of_group(servers: Servers, scheme: str, kind: str, size: int, process: str,
                  threads: tuple[int, ...]) -> list[Run]:
    return [
        Run(scheme, kind, size, process, job, t)
        for job in jobs_of(servers, scheme) if size <= LARGEST.get(job, size)
        for t in threads if t == 1 or job in PARALLEL
    ]


def median(found: list[Median]) -> Median:
    return Median(found[0].faces, statistics.median(m.seconds for m in found),
                  statistics.median(m.page_faults for m in found), len(found))


def measure_group(servers: Servers, runs: list[Run], folder: Path, repetitions: int,
                  seconds_each: float) -> Medians:
    """All runs of a group in turn, in another order each time; a run that has taken `seconds_each`
    is not repeated. The first time of a warm process does not count, unless it takes long."""
    first = runs[0]
    control = control_mesh(folder, first.scheme, first.kind, first.size)
    found: dict[Run, list[Median]] = defaultdict(list)
    spent: dict[Run, float] = defaultdict(float)
    order = random.Random(first.size)
    for repetition in range(repetitions + 1):
        for run in order.sample(runs, len(runs)):
            if found[run] and spent[run] > seconds_each:
                continue
            is_warm = run.process != "fresh"
            server = (servers.warm(run.job, run.threads, run.process == "huge") if is_warm else
                      servers.start(run.job, run.threads))
            begin = time.perf_counter()
            m = server.run(f"{run.job}/{run.scheme}", str(control.file), control.rounds)
            spent[run] += time.perf_counter() - begin
            if not is_warm:
                server.close()
            if repetition > 0 or not is_warm or 2 * m.seconds > seconds_each:
                found[run].append(m)
    servers.close()
    return {run: median(found[run]) for run in runs}


def write(file: Path, medians: Medians, machine: list[str]) -> None:
    with file.open("w", newline="") as out:
        out.writelines(f"# {line}\n" for line in machine)
        table = csv.writer(out)
        table.writerow([f.name for f in fields(Run)] + [f.name for f in fields(Median)])
        table.writerows(astuple(run) + astuple(m) for run, m in sorted(medians.items()))


def read(file: Path) -> tuple[Medians, list[str]]:
    lines = file.read_text().splitlines()
    machine = [line[2:] for line in lines if line.startswith("# ")]
    medians = {}
    for row in csv.DictReader(line for line in lines if not line.startswith("# ")):
        run = Run(row["scheme"], row["kind"], int(row["size"]), row["process"], row["job"],
                  int(row["threads"]))
        medians[run] = Median(int(row["faces"]), float(row["seconds"]), float(row["page_faults"]),
                              int(row["repetitions"]))
    return medians, machine
