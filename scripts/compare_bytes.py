#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Compares what two programs pn_subdivide write, byte by byte, over data, schemes and options.

    scripts/compare_bytes.py [--jobs N] [--only TEXT] OLD NEW
    scripts/compare_bytes.py [--jobs N] [--only TEXT] --record TABLE PROGRAM
    scripts/compare_bytes.py [--only TEXT] --list

Runs each job of byte_jobs.py, prints those of which status, files or messages (but for times) differ, and ends with 1
if there are any. OLD is a program or a table that was recorded: a line per job with the command line, the exit status,
the SHA-256 of the output and standard error. --only takes the jobs whose command line contains TEXT.

A tool for changes that should not alter a bit, not a test: bits depend on compiler and options, and tables of
different ones cannot be compared. Build both programs with the same preset.
"""

import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

import byte_jobs

MESHES = pathlib.Path(__file__).resolve().parent.parent / "data" / "meshes"
TIME_LIMIT = 120  # seconds of a job
COLUMNS = ["status", "output", "messages"]


def write_inputs(folder):
    shutil.copytree(MESHES, folder)
    for name, text in byte_jobs.written().items():
        (folder / name).write_text(text)


def digest(folder):
    """Of the only file, or of the names and digests of all; - if there are none."""
    files = sorted(file for file in folder.rglob("*") if file.is_file())
    digests = [hashlib.sha256(file.read_bytes()).hexdigest() for file in files]
    if len(files) < 2:
        return "".join(digests) or "-"
    names = [str(file.relative_to(folder)) for file in files]
    return hashlib.sha256(repr(list(zip(names, digests))).encode()).hexdigest()


def without_times(text):
    text = re.sub(r"\b\d+(\.\d+)?(e[+-]?\d+)? (s|ms|min|h|seconds?|minutes?|hours?)\b", "TIME", text)
    return " | ".join(text.replace("\t", " ").splitlines())


def run(program, job, work):
    """Status, digest and messages of a job, in a folder of its own beside that of the inputs."""
    command, _, source = job.replace("@", "../inputs/").partition(" < ")
    with tempfile.TemporaryDirectory(dir=work) as name:
        folder = pathlib.Path(name)
        with open(folder / source if source else os.devnull, "rb") as stdin:
            try:
                done = subprocess.run([program, *command.split()], cwd=folder, stdin=stdin, capture_output=True,
                                      timeout=TIME_LIMIT)
            except subprocess.TimeoutExpired:
                return "does not end", "-", ""
        if done.stdout:
            (folder / "standard output").write_text(without_times(done.stdout.decode(errors="replace")))
        return str(done.returncode), digest(folder), without_times(done.stderr.decode(errors="replace"))


def results(program, jobs, parallel):
    """Of all jobs; says what they took."""
    def seconds():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime
    began = seconds()
    program = str(pathlib.Path(program).resolve(strict=True))
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(parallel) as pool:
        work = pathlib.Path(name)
        write_inputs(work / "inputs")
        table = dict(zip(jobs, pool.map(lambda job: run(program, job, work), jobs)))
    print(f"{len(jobs)} jobs, {seconds() - began:.0f} s of processors: {program}", file=sys.stderr)
    return table


def write_table(name, table):
    rows = [["job", *COLUMNS], *([job, *result] for job, result in table.items())]
    pathlib.Path(name).write_text("".join("\t".join(row) + "\n" for row in rows))


def read_table(name):
    """None if the file is no table."""
    with open(name, "rb") as file:
        if not file.read(4) == b"job\t":
            return None
    rows = (line.split("\t") for line in pathlib.Path(name).read_text().split("\n")[1:-1])
    return {row[0]: tuple(row[1:]) for row in rows}


def print_differences(old, new):
    """How many jobs differ; those that the old table does not have are none."""
    different = [job for job in new if job in old and old[job] != new[job]]
    for job in different:
        print(job)
        for column, before, after in zip(COLUMNS, old[job], new[job]):
            if before != after:
                print(f"  {column}: {before[:400]}\n  {' ' * len(column)}  {after[:400]}")
    missing = sum(job not in old for job in new)
    print(f"{len(different)} of {len(new) - missing} jobs differ" + (f", {missing} are new" if missing else ""))
    return len(different)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="*", metavar="PROGRAM")
    parser.add_argument("--record", metavar="TABLE")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--only", default="", metavar="TEXT")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    jobs = [job for job in byte_jobs.jobs() if options.only in job]
    if options.list:
        print("\n".join(jobs))
        return 0
    if len(options.programs) != (1 if options.record else 2):
        parser.error("OLD and NEW are expected, or --record TABLE and PROGRAM")
    if options.record:
        write_table(options.record, results(options.programs[0], jobs, options.jobs))
        return 0
    old, new = options.programs
    before = read_table(old) or results(old, jobs, options.jobs)
    return 1 if print_differences(before, results(new, jobs, options.jobs)) else 0


if __name__ == "__main__":
    sys.exit(main())
