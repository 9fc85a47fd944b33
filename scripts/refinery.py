# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Runs the command pn_subdivide for scripts that draw or measure what it writes."""

import os
import shlex
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
DATA = ROOT / "data/meshes"
COMMAND = ROOT / "build/release/src/pn_subdivide/pn_subdivide"


def run(*words: Any, folder: Path = ROOT) -> str:
    """What a program prints; its messages are shown only if it fails."""
    done = subprocess.run(list(map(str, words)), cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{shlex.join(done.args)}\n{done.stdout}{done.stderr}")
    return done.stdout


@dataclass
class Usage:
    megabytes: float  # at most
    processor: float  # seconds


def measured(*words: Any) -> Usage:
    process = os.spawnvp(os.P_NOWAIT, str(words[0]), list(map(str, words)))
    _, status, usage = os.wait4(process, 0)
    if status != 0:
        sys.exit(f"failed: {shlex.join(map(str, words))}")
    return Usage(usage.ru_maxrss / 1024, usage.ru_utime + usage.ru_stime)


class Refinery:
    """Refined meshes in a folder, each made once."""

    def __init__(self, command: Path, folder: Path) -> None:
        if not os.access(command, os.X_OK):
            sys.exit(f"{command} is missing: scripts/build.sh {command.name} builds it")
        self.command, self.folder = command.resolve(), folder
        self.files: dict[tuple[Path, str, str], Path] = {}

    def file(self, mesh: str | Path, options: str, name: str = "ply") -> Path:
        """The mesh, a file or one of data/meshes, refined; a name without an ending is the ending."""
        key = DATA / mesh, options, name
        if key not in self.files:
            result = self.folder / (name if "." in name else f"{len(self.files)}.{name}")
            self.run(mesh, result, options)
            self.files[key] = result
        return self.files[key]

    def run(self, mesh: str | Path, result: Path, options: str) -> str:
        return run(self.command, "surface", DATA / mesh, result, *shlex.split(options), "--quiet")
