#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Checks the sources: that each file says whose it is, that package_info/.../dependencies lists the CGAL packages whose headers
the package's headers include, directly or not, that version.h, CMakeLists.txt, vcpkg.json, conanfile.py, the npm package,
CHANGES.md and CITATION.cff agree on the version, that links of pages in Markdown lead to files and headings that are there,
that README and manual are short, and that sentences of the manual and of public headers are (sentences.py), and that the
constants of proven bounds are those of enclosure_constants.py.

With --fix the headers of files and the dependencies are written anew; else the exit code is 1 if
something is wrong. Needs Python 3.11 and, for the dependencies, a C++ compiler and CGAL.
"""

import argparse
import re
import shlex
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import enclosure_constants
import moves
import sentences
from refinery import ROOT, run

NAME = "PN_subdivision_3"
NOTICE = f"""Copyright (c) 2026  {NAME} developers
All rights reserved.

This file is part of {NAME}, a package for CGAL (www.cgal.org).

SPDX-License-Identifier: LGPL-3.0-or-later
Author(s): {NAME} developers
"""
FOLDERS = ("include", "test_support", "src", "python", "examples", "demo", "test", "benchmark", "scripts", "doc", "cmake")
COMMENTS = {".h": "//", ".cpp": "//", ".ts": "//", ".mjs": "//", ".py": "#", ".sh": "#"}
# Folders of these names hold what is not the package's: interfaces that are only documented, libraries.
NOT_OURS = {"Concepts", "node_modules"}
MANUAL = ROOT / "doc" / NAME / f"{NAME}.txt"
# What is read first; what needs more words has pages of its own in doc/.
WORDS_OF_README = 700
BYTES_OF_MANUAL = 32000
LINES_OF_FIRST_STEPS = 20  # without comments and blank lines
# The version of CGAL from whose headers the list of dependencies is derived: each names its package.
REFERENCE_CGAL = "5.5"


def notice(comment: str) -> str:
    return "".join(f"{comment} {line}".rstrip() + "\n" for line in NOTICE.splitlines())


def sources() -> Iterator[Path]:
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in COMMENTS and NOT_OURS.isdisjoint(path.parts):
                yield path


def without_notice(text: str, comment: str) -> tuple[str, str]:
    """The line #!..., if any, and the text after the comment on top that names the license."""
    lines = text.splitlines(keepends=True)
    first = 1 if lines and lines[0].startswith("#!") else 0
    end = first
    while end < len(lines) and lines[end].startswith(comment):
        end += 1
        if "Author(s)" in lines[end - 1]:
            break
    if not any("SPDX" in line for line in lines[first:end]):
        end = first
    return "".join(lines[:first]), "".join(lines[end:])


def check_notices(fix: bool) -> list[str]:
    wrong = []
    for path in sources():
        comment = COMMENTS[path.suffix]
        text = path.read_text()
        first, rest = without_notice(text, comment)
        right = first + notice(comment) + rest
        if text != right and fix:
            path.write_text(right)
        elif text != right:
            wrong.append(f"{path.relative_to(ROOT)} does not begin with the package's notice")
    return wrong


def included_headers(compiler: list[str], package: str) -> list[Path]:
    """CGAL's and our headers that a package's headers include, by the compiler's list of dependencies."""
    include = ROOT / "include"
    with tempfile.NamedTemporaryFile("w", suffix=".cpp") as file:
        for header in sorted((include / "CGAL" / package).rglob("*.h")):
            file.write(f"#include <{header.relative_to(include)}>\n")
        file.flush()
        rule = run(*compiler, "-std=c++17", "-M", f"-I{include}", file.name)
    return [p for p in map(Path, rule.replace("\\\n", " ").split()[1:]) if "CGAL" in p.parts]


def packages_of(headers: list[Path]) -> tuple[set[str], set[str]]:
    """The packages that headers are of, and CGAL's versions."""
    packages, versions = set(), set()
    for header in headers:
        if header.is_relative_to(ROOT / "include"):
            packages.add(header.relative_to(ROOT / "include" / "CGAL").parts[0])
            continue
        # $URL: https://github.com/CGAL/cgal/blob/v5.5.1/BGL/include/CGAL/... $
        where = re.search(r"\$URL: \S+/v([0-9.]+)/(\w+)/", header.read_text(errors="replace"))
        if where:
            versions.add(where[1])
            packages.add(where[2])
    return packages, versions


def check_dependencies(compiler: list[str], fix: bool) -> list[str]:
    wrong = []
    for package in sorted(path.name for path in (ROOT / "package_info").iterdir()):
        packages, versions = packages_of(included_headers(compiler, package))
        path = ROOT / "package_info" / package / "dependencies"
        if not all(version.startswith(REFERENCE_CGAL) for version in versions):
            print(f"dependencies: not checked, since this is not CGAL {REFERENCE_CGAL}")
            return []
        if fix:
            path.write_text("".join(f"{name}\n" for name in sorted(packages)))
        listed = set(path.read_text().split())
        wrong += [f"{path.relative_to(ROOT)} lacks {p}, which is included" for p in sorted(packages - listed)]
        wrong += [f"{path.relative_to(ROOT)} lists {p}, which is not included" for p in sorted(listed - packages)]
    return wrong


def check_version() -> list[str]:
    def named(file: str, pattern: str) -> list[tuple[str, ...]]:
        return [m.groups() for m in re.finditer(pattern, (ROOT / file).read_text(), re.MULTILINE)]

    version = r"(\d+\.\d+\.\d+)"
    header = f"include/CGAL/{NAME}/version.h"
    texts = [*named("CMakeLists.txt", rf"^ *VERSION {version}$")]
    changes = named("CHANGES.md", rf"^## {version}( \(in development\))?$")
    if not texts or not changes:
        return ["CMakeLists.txt or the first section of CHANGES.md names no version"]
    (text,), (top, in_development) = texts[0], changes[0]
    number = "1" + "".join(f"{int(part):02}" for part in text.split("."))
    shown = text + ("-dev" if in_development else "")
    wrong = []

    def expect(file: str, pattern: str, value: str) -> None:
        if [(value,)] != named(file, pattern):
            wrong.append(f"{file} does not name the version {value} once")

    expect(header, r'^#define CGAL_PN_SUBDIVISION_3_VERSION "(.*)"$', shown)
    expect(header, r"^#define CGAL_PN_SUBDIVISION_3_VERSION_NR (\d+)$", number)
    expect("vcpkg.json", r'^ *"version": "(.*)",$', text)
    expect("conanfile.py", r'^ *version = "(.*)"$', text)
    expect("demo/PN_subdivision_3/library/package.json", r'^ *"version": "(.*)",$', text)
    if top != text:
        wrong.append(f"CHANGES.md begins with {top}, but CMakeLists.txt names {text}")
    if any(later for _, later in changes[1:]):
        wrong.append("CHANGES.md: only the section on top can be in development")
    released = [closed for closed, later in changes if not later]
    if released:
        expect("CITATION.cff", r"^version: (.*)$", released[0])
    return wrong


def headings(text: str) -> set[str]:
    """The anchors that code hosts make of a page's headings."""
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
            for title in re.findall(r"(?m)^#+ +(.+?) *$", text)}


def check_links() -> list[str]:
    wrong = []
    pages = [*ROOT.glob("*.md"), *(page for folder in (*FOLDERS, "data")
                                   for page in sorted((ROOT / folder).rglob("*.md"))
                                   if NOT_OURS.isdisjoint(page.parts))]
    for page in pages:
        text = re.sub(r"(?ms)^```.*?^```|`[^`\n]*`", "", page.read_text())
        for target in re.findall(r"\]\(([^()\s]+)\)|(?:src|href)=\"([^\"]+)\"", text):
            path, _, anchor = "".join(target).partition("#")
            if re.match(r"\w+:", path):
                continue
            file = page.parent / path if path else page
            if not file.exists():
                wrong.append(f"{page.relative_to(ROOT)} links to {path}, which is not there")
            elif anchor and anchor not in headings(file.read_text()):
                wrong.append(f"{page.relative_to(ROOT)} links to #{anchor}, which {file.name} does not have")
    return wrong


MACROS = "near far small interface emit slots signals foreach Bool Status None True False Success".split()


def check_macros() -> list[str]:
    """Words of our headers that <windows.h>, Qt and <X11/Xlib.h> define; pn_headers_alone compiles them, which takes longer."""
    wrong = []
    for path in sorted(p for p in (ROOT / "include").rglob("*.*") if p.suffix in COMMENTS):
        code = re.sub(r"(?s)/\*.*?\*/|//[^\n]*|\"(?:[^\"\\]|\\.)*\"|^ *# *include[^\n]*", "", path.read_text())
        wrong += [f"{path.relative_to(ROOT)} has the name {word}, which is a macro of others"
                  for word in MACROS if re.search(rf"\b{word}\b", code)]
    return wrong


def check_names() -> list[str]:
    """Headers and examples that the first page of the manual names, and what the page on the layout says is in headers."""
    there = {path.name for folder in ("include", "examples") for path in (ROOT / folder).rglob("*.*")}
    named = re.findall(r"`(?:[\w/]+/)?(\w+\.(?:h|cpp))`", MANUAL.read_text())
    wrong = [f"{MANUAL.relative_to(ROOT)} names {name}, which is not there" for name in named if name not in there]
    layout = (MANUAL.parent / "layout.txt").read_text()
    for folder, lines in re.findall(r"(?s)below `([\w/]+)`[^\\]*\\verbatim(.*?)\\endverbatim", layout):
        for file, name in re.findall(r"(\S+\.h): (\w+)", lines):
            path = ROOT / "include" / "CGAL" / folder / file
            if not path.is_file() or not re.search(rf"\b((class|struct) {name}\b|{name}\()", path.read_text()):
                wrong.append(f"layout.txt: there is no {name} in {folder}/{file}")
    return wrong


def check_example() -> list[str]:
    """The README shows the code of an example."""
    example = ROOT / "examples" / NAME / "readme_example.cpp"
    code = example.read_text()
    shown = "```cpp\n" + code[code.index("#include"):] + "```" in (ROOT / "README.md").read_text()
    return [] if shown else [f"README.md does not show the code of {example.relative_to(ROOT)}: copy it there"]


def check_lengths() -> list[str]:
    words = len((ROOT / "README.md").read_text().split())
    wrong = [f"README.md has {words} words, more than {WORDS_OF_README}"] if words > WORDS_OF_README else []
    if MANUAL.stat().st_size > BYTES_OF_MANUAL:
        wrong.append(f"{MANUAL.relative_to(ROOT)} has {MANUAL.stat().st_size} bytes, more than {BYTES_OF_MANUAL}: "
                     "details go to the pages beside it")
    for path in sorted((ROOT / "examples" / NAME / "first_steps").glob("*.cpp")):
        lines = [line for line in path.read_text().splitlines() if line.strip() and not line.lstrip().startswith("//")]
        if len(lines) > LINES_OF_FIRST_STEPS:
            wrong.append(f"{path.relative_to(ROOT)} has {len(lines)} lines, more than {LINES_OF_FIRST_STEPS}")
    for whose, paths in (("the manual", sentences.pages()), ("the public headers", sentences.headers())):
        wrong += sentences.misses(whose, [s for path in paths for s in sentences.sentences(path)])
    return wrong


def check_conflicts() -> list[str]:
    """Lines that a merge with conflicts leaves."""
    texts = [path for folder in (*FOLDERS, "package_info") for path in (ROOT / folder).rglob("*")
             if path.suffix in (*COMMENTS, ".txt", ".md", ".toml", ".tsv", ".cmake") and NOT_OURS.isdisjoint(path.parts)]
    return [f"{path.relative_to(ROOT)} has the rest of a conflict" for path in texts
            if re.search(r"(?m)^(<{7}|>{7})( |$)", path.read_text(errors="replace"))]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--compiler", default="c++ -I/usr/include/eigen3", type=shlex.split,
                        help="the compiler with the options that it needs to find CGAL and Eigen")
    parser.add_argument("--fix", action="store_true", help="write what can be derived")
    arguments = parser.parse_args()
    wrong = check_notices(arguments.fix) + check_version() + check_links() + check_macros() + check_names() + check_example() + check_lengths()
    wrong += check_conflicts() + enclosure_constants.wrong() + check_dependencies(arguments.compiler, arguments.fix)
    wrong += [f"scripts/moves.tsv: {new} is not there" for _, new in moves.table("moves.tsv") if not (ROOT / new).is_file()]
    if wrong:
        sys.exit("\n".join([*wrong, "scripts/check_sources.py --fix mends notices and dependencies."]))


if __name__ == "__main__":
    main()
