#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""Counts the long sentences of the manual and of the documentation in public headers, and those that begin with What, Of, Where or That.

  sentences.py [PAGE...]    a line for each page or header, and its worst twenty sentences

check_sources.py compares the shares with the goals. Without PAGE all pages of doc/PN_subdivision_3 and all public headers are read, each kind with its shares. Code, tables, formulas and headings are no sentences; an
item of a list begins one. A formula, a name in backquotes and a link count as a word.
"""

import argparse
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DOC = ROOT / "doc" / "PN_subdivision_3"
WORDS = 35
LONG_SHARE = 0.03
OPENINGS = ("What", "Of", "Where", "That")
OPENING_SHARE = 0.02
WORST = 20


def pages() -> list[Path]:
    return sorted(path for path in DOC.iterdir() if path.suffix in (".txt", ".md"))


def headers() -> list[Path]:
    return sorted(path for path in (ROOT / "include").rglob("*.h") if "internal" not in path.parts)


def prose(path: Path) -> str:
    """The text of a page; an empty line stands where a sentence cannot go on."""
    text = path.read_text()
    if path.suffix != ".md":
        text = re.sub(r"(?m)^((?:[ \t]*///[^\n]*\n)+)", r"/*!\n\1*/\n", text)
        text = "\n\n".join(re.findall(r"(?s)/\*!(.*?)\*/", text))
        text = re.sub(r"(?ms)^\\(?:code|verbatim).*?^\\end(?:code|verbatim)$", "\n", text)
    else:
        text = re.sub(r"(?ms)^```.*?^```$|^(?:    [^\n]*\n)+(?=\n)", "\n", text)
    text = re.sub(r"(?s)<!--.*?-->|<pre>.*?</pre>|<table.*?</table>", "", text)
    text = re.sub(r"(?s)\\f\[.*?\\f\]|\\f\$.*?\\f\$|`[^`]*`", " X ", text)
    text = re.sub(r'\\ref\s+"?[\w/.]+"?(\s+"([^"]*)")?', lambda m: m[2] or "X", text)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"\*+(\w[^*]*)\*+", r"\1", text)
    text = re.sub(r"\\cgal(?:Cite|FigureRef)\s*\{[^}]*\}", "X", text)
    lines = []
    for line in text.splitlines():
        if re.match(r"\s*(\||#|\\cgalFigure|\\cgalCRP|\\(sub)*section|\\page|\\anchor|\\authors|\\cgal\w+$|\\example|"
                    r"\\image|\\cgalExample|\\cgalHas|\\mainpage|\\(defgroup|ingroup|addtogroup)|\\cgalPkg)", line):
            lines.append("")
            continue
        if re.match(r"\s*(- |-# |\* |\d+\. |<d[td]>|<li>|\\(?:throws|t?param|returns?|pre|post|sa|cgalParam\w+)\b)", line):
            lines.append("")
        lines.append(re.sub(r"\\em\b|\\(?=cgal\b)|<[^>]*>|^\s*(?:- |-# |\* |/// ?)", "", line))
    return "\n".join(lines)


def sentences(path: Path) -> list[str]:
    found = []
    for paragraph in re.split(r"\n\s*\n", prose(path)):
        paragraph = " ".join(paragraph.split())
        for sentence in re.split(r"(?<=[.!?])[)\"]?\s+(?=[(\"]?[A-Z0-9])", paragraph):
            if len(words(sentence)) > 2:
                found.append(sentence)
    return found


def words(sentence: str) -> list[str]:
    return re.findall(r"[\w'\-/.,]*\w[\w'\-]*", sentence)


def is_long(sentence: str) -> bool:
    return len(words(sentence)) > WORDS


def begins_badly(sentence: str) -> bool:
    return sentence.split()[0] in OPENINGS


def shares(found: list[str]) -> tuple[float, float]:
    number = max(len(found), 1)
    return sum(map(is_long, found)) / number, sum(map(begins_badly, found)) / number


def misses(whose: str, found: list[str]) -> list[str]:
    """The goals that sentences miss."""
    goals = (LONG_SHARE, f"have more than {WORDS} words"), (OPENING_SHARE, f"begin with one of {OPENINGS}")
    return [f"{share:.1%} of the sentences of {whose} {what}, at most {most:.0%} may: see scripts/sentences.py"
            for share, (most, what) in zip(shares(found), goals) if share > most]


def line(name: str, found: list[str]) -> str:
    long, opening = shares(found)
    return (f"{name}: {len(found)} sentences, {long:.1%} of more than {WORDS} words, "
            f"{opening:.1%} begin with {', '.join(OPENINGS[:-1])} or {OPENINGS[-1]}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("page", nargs="*", type=Path)
    options = parser.parse_args()
    kinds = {"all": options.page} if options.page else {"the manual": pages(), "the public headers": headers()}
    for whose, paths in kinds.items():
        everything = []
        for path in paths:
            found = sentences(path)
            everything += found
            print(line(path.name, found))
            worst = sorted(filter(lambda s: is_long(s) or begins_badly(s), found), key=lambda s: len(words(s)), reverse=True)
            print("".join(f"  {len(words(sentence))}: {sentence}\n" for sentence in worst[:WORST]), end="")
        print(line(whose, everything))


if __name__ == "__main__":
    main()
