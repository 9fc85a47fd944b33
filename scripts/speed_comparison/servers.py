# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Processes that run jobs: a line in, a line out (see benchmark/PN_subdivision_3/peers/peers.cpp)."""

import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from refinery import run

VTK_PEER = Path(__file__).parent.with_name("vtk_peer.py")


@dataclass(frozen=True)
class Measurement:
    faces: int
    seconds: float
    page_faults: int


class Server:
    """one process, which keeps what it has warmed up"""

    def __init__(self, command: list[str], threads: int, has_huge_pages: bool):
        environment = dict(os.environ, OMP_NUM_THREADS=str(threads))
        if has_huge_pages:  # the allocator asks for them; of use where the system grants them then
            environment["GLIBC_TUNABLES"] = "glibc.malloc.hugetlb=1"
        self.threads = threads
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        text=True, env=environment)

    def run(self, job: str, control: str, rounds: int) -> Measurement:
        assert self.process.stdin and self.process.stdout
        print(job, control, rounds, self.threads, file=self.process.stdin, flush=True)
        words = self.process.stdout.readline().split()
        if len(words) != 3:
            raise RuntimeError(f"{job} on {control} failed")
        return Measurement(int(words[0]), float(words[1]), int(words[2]))

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
            lines = run(self.peers, option).splitlines()
            if self.vtk:
                lines += run(self.vtk, VTK_PEER, option).splitlines()
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
