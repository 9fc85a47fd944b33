#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Runs the commands that README.md and the manual show, as they stand, in a copy of the package's folder.

A command is one of an indented or fenced block of README.md and of the manual's pages in Markdown, or of a
block \\code{.sh} of its other pages. What installs, builds or measures is not run here; the list ELSEWHERE
says what runs it. Pictures are drawn where Python has VTK. The exit code is 1 if a command fails or leaves no
output that it names.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGES = [ROOT / "README.md", *sorted(path for path in (ROOT / "doc/PN_subdivision_3").iterdir()
                                    if path.suffix in (".md", ".txt"))]
DRAWING_NOT_INSTALLED = 69  # what render.py then exits with
# a pattern for the begin of a command, and what runs it
ELSEWHERE = (
    (r"sudo apt-get install ", "scripts/install_dependencies.sh installs these packages"),
    (r"(\./)?scripts/(demo|test)\.sh\b", ".ci/run, which is scripts/test.sh, and who releases a version"),
    (r"cmake --preset |cmake --build |ctest --preset ", "scripts/build.sh and scripts/test.sh"),
    (r"cmake -B build( -DCMAKE_BUILD_TYPE=Release)?$|cmake --install ", "the test install_without_building"),
    (r"g\+\+ .*pkg-config ", "the test pkg_config_consumer"),
    (r"scripts/install_dependencies\.sh --manual", "who builds the manual"),
    (r"scripts/check_style\.sh", "who changes the sources"),
    (r"scripts/make_paper_figures\.py", "the test numbers_of_paper_figures"),
    (r"scripts/compare_speed\.py", "who measures, see doc/PN_subdivision_3/Speed.md"),
)


def blocks_of(page: Path) -> list[str]:
    text = page.read_text()
    if page.suffix == ".txt":
        return re.findall(r"(?ms)^\\code\{\.sh\}\n(.*?)^\\endcode", text)
    fenced = re.findall(r"(?ms)^```sh\n(.*?)^```", text)
    text = re.sub(r"(?ms)^```.*?^```", "", text)
    indented = re.findall(r"(?m)^\n((?:    .*\n)+)", text)
    shell = re.compile(r"\./|scripts/|pn_subdivide |printf |cmake |ctest |g\+\+ |sudo ")
    return fenced + [re.sub(r"(?m)^    ", "", block) for block in indented if shell.match(block.strip())]


def unread(path: Path, blocks: list[str]) -> list[str]:
    """Lines of a page that are commands to a reader, but in no block that is run."""
    read = {line.strip() for block in blocks for line in block.splitlines()}
    shown = re.findall(r"(?m)^ *((?:\./scripts/|pn_subdivide ).*)", path.read_text())
    return [f"{path.relative_to(ROOT)} shows what is not run: {line}" for line in shown if line.strip() not in read]


def commands(block: str) -> list[str]:
    if "control.obj" in block:  # a file of the reader's, and sizes that no test has
        return []
    lines = (re.sub(r"(^|\s+)# .*", "", line).strip() for line in block.replace("\\\n", " ").splitlines())
    return [line for line in lines if line]


def elsewhere(command: str) -> bool:
    return any(re.match(pattern, command) for pattern, _ in ELSEWHERE)


def sandbox(folder: Path, command: Path) -> None:
    """The package's folder, with the command where a build puts it."""
    for entry in ROOT.iterdir():
        if not entry.name.startswith((".git", "build", "out")):
            (folder / entry.name).symlink_to(entry)
    built = folder / "build/src/pn_subdivide"
    built.mkdir(parents=True)
    (built / "pn_subdivide").symlink_to(command.resolve())


def run(blocks: list[str], folder: Path, command: Path) -> list[str]:
    environment = dict(os.environ, PATH=f"{command.resolve().parent}:{os.environ['PATH']}")
    wrong, done = [], set()
    for block in blocks:
        for line in commands(block):
            if elsewhere(line) or line in done:
                continue
            if line.startswith("cmake -B build"):
                # the options must be known; what is configured is not built
                line = line.replace("cmake -B build", "cmake -B configured", 1) + " -Werror=dev"
            done.add(line)
            print(f"$ {line}", flush=True)
            result = subprocess.run(["bash", "-euo", "pipefail", "-c", line], cwd=folder, env=environment,
                                    capture_output=True, text=True)
            if "render.py" in line and result.returncode == DRAWING_NOT_INSTALLED:
                print(f"left out: {result.stderr.strip()}", flush=True)
                continue
            if result.returncode != 0 or "unused variable" in result.stderr or "were not used" in result.stderr:
                wrong.append(f"{line}\n  exit code {result.returncode}: {result.stderr.strip()[-400:]}")
                continue
            named = re.findall(r"(?:--output|--comb|-o|>) ([\w.]+)|(?:surface|curve) \S+ ([\w.]+)", line)
            for name in filter(None, sum(named, ())):
                if not (folder / name).exists() or (folder / name).stat().st_size == 0:
                    wrong.append(f"{line}\n  does not write {name}")
    return wrong


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", type=Path, help="pn_subdivide")
    arguments = parser.parse_args()
    blocks = [block for page in PAGES for block in blocks_of(page)]
    wrong = [line for page in PAGES for line in unread(page, blocks)]
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        sandbox(folder, arguments.command)
        wrong += run(blocks, folder, arguments.command)
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()
