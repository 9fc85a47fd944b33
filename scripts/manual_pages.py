#!/usr/bin/env python3
# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""What CGAL's documentation build does around Doxygen, for the manual that is built outside of CGAL.

  manual_pages.py prepare OUT    writes the pages that are made of other files: the bibliography (PN_subdivision_3.bib), which
                                 function reads which named parameters of this package (its check_are_read<...>()), wrong
                                 changes (mutate.py), and what has moved since 0.1 (moves.py)
  manual_pages.py finish HTML    numbers figures and citations in Doxygen's pages, and turns formulas
                                 into MathML, which browsers show without a script and a network

Formulas need the program blahtexml (a Debian package of 0.2 MB); without it they stay with MathJax,
which browsers load from the network. `finish` fails if a reference or a formula cannot be resolved, an entry
does not name its header, or a page has the folder of the build.
"""

import argparse
import html
import re
import shutil
import subprocess
import sys
from pathlib import Path

import moves
import mutate

ROOT = Path(__file__).resolve().parent.parent
DOC = ROOT / "doc" / "PN_subdivision_3"
ACCENTS = {'"': "uml", "'": "acute", "`": "grave", "^": "circ", "~": "tilde"}


# --- the bibliography ---

def entries(text: str) -> dict[str, dict[str, str]]:
    """Key to fields of each entry of a BibTeX file whose values are in braces."""
    found = {}
    for kind, key, body in re.findall(r"(?ms)^@(\w+)\{([^,\s]+),\n(.*?)^\}", text):
        fields = dict(re.findall(r"(?ms)^\s*(\w+)\s*=\s*\{(.*?)\},?$", body))
        found[key] = {name: plain(value) for name, value in fields.items()} | {"kind": kind}
    return found


def plain(value: str) -> str:
    """TeX as HTML."""
    value = re.sub(r"\{\\(.)(\w)\}", lambda m: f"&{m[2]}{ACCENTS[m[1]]};", value)
    value = re.sub(r"\\(['\"`^~])\{?(\w)\}?", lambda m: f"&{m[2]}{ACCENTS[m[1]]};", value)
    value = value.replace(r"$\sqrt{3}$", "&radic;3")
    value = re.sub(r"\$(\w)\^(\w)\$", r"\1<sup>\2</sup>", value)
    value = value.replace("--", "&ndash;").replace("~", "&nbsp;")
    return " ".join(re.sub(r"[{}]", "", value).split())


def ordered_keys(works: dict[str, dict[str, str]]) -> list[str]:
    def names(key: str) -> tuple[str, str]:
        authors = works[key]["author"].split(" and ")
        return " ".join(author.split()[-1] for author in authors), works[key]["year"]
    return sorted(works, key=names)


def description(work: dict[str, str]) -> str:
    where = [work[name] for name in ("journal", "booktitle", "school", "publisher", "note") if name in work]
    if "volume" in work:
        where[0] += f" {work['volume']}" + (f"({work['number']})" if "number" in work else "")
    if "pages" in work:
        where.append(work["pages"])
    if "eprint" in work:
        where.append(f"arXiv:{work['eprint']}")
    where.append(work["year"])
    text = f"{', '.join(work['author'].split(' and '))}. <em>{work['title']}</em>. {', '.join(where)}."
    if "url" in work:
        text += f' <a href="{work["url"]}">{work["url"]}</a>'
    return text


def bibliography() -> str:
    works = entries((DOC / "PN_subdivision_3.bib").read_text())
    rows = [f'<tr><td><span class="bibkey">{key}</span></td><td>{description(works[key])}</td></tr>'
            for key in ordered_keys(works)]
    return "\n".join(["/*!", "\\page citelist Bibliography", '<table class="bibliography">', *rows,
                      "</table>", "*/", ""])


# --- named parameters ---

FUNCTION = re.compile(r"\n {0,2}(?!return|if|else)[^\n/*;{}=]*?(\w+)\((?:const )?[\w:]+(?:<[^()]*>)?[&* ]+\w+[,)]")
CALLED = {"subdivide_by_variant": "CatmullClark_subdivision"}
LIKE = {"subdivide": "`subdivide()`, functions of other schemes",
        "CatmullClark_subdivision": "`CatmullClark_subdivision()`, `Loop_subdivision()`"}


def read_parameters() -> dict[str, set[str]]:
    """Function to the parameters of this package that it does not refuse."""
    texts = [path.read_text() for path in sorted((ROOT / "include").rglob("*.h"))]
    packs = {name: set(re.findall(r"(\w+)_t\b", tags)) for text in texts for name, tags in
             re.findall(r"struct (\w+)\s*:\s*(?:internal::)?Read_parameters<([^>]*)>", text)}
    found: dict[str, set[str]] = {}
    for text in texts:
        for check in re.finditer(r"check_are_read<([\w:,\s]*)>\(\)", text):
            functions = FUNCTION.findall(text[:check.start()])
            names = set(re.findall(r"(\w+)_t\b", check[1])).union(
                *(tags for pack, tags in packs.items() if pack in check[1]))
            if functions and names:
                found.setdefault(CALLED.get(functions[-1], functions[-1]), set()).update(names)
    return found


def parameter_page() -> str:
    found = read_parameters()
    if "subdivide" not in found:
        sys.exit("manual_pages.py: the checks of named parameters in include/ are not found")
    mesh = found["subdivide"] - {"attributes"}

    def row(function: str) -> str:
        own = found[function]
        names = (["those of a control mesh"] if mesh <= own else []) + [
            f"`parameters::{name}()`" for name in sorted(own - mesh if mesh <= own else own)]
        return f"| {LIKE.get(function, f'`{function}()`')} | {', '.join(names)} |"

    listed = ", ".join(f"`parameters::{name}()`" for name in sorted(mesh))
    return "\n".join(["namespace CGAL::PN_subdivision_3 {", "/*!",
                      "\\page PN_subdivision_3_parameters Which Function Reads Which Named Parameter", "",
                      f"Functions and constructors refuse other parameters of this package. Those of a control mesh are {listed}.", "",
                      "| function | parameters of this package |", "|---|---|", *map(row, sorted(found, key=str.lower)), "*/", "}", ""])


def example_page() -> str:
    """Doxygen shows the source of what an `\\example` names."""
    folder = ROOT / "examples"
    names = [path.relative_to(folder) for path in sorted(folder.glob("*/*")) if path.suffix in (".cpp", ".h")]
    return "\n".join(["/*!", *(f"\\example {name}" for name in names), "*/", ""])


def prepare(out: Path) -> None:
    out.mkdir(parents=True, exist_ok=True)
    (out / "examples.txt").write_text(example_page())
    (out / "bibliography.txt").write_text(bibliography())
    (out / "parameters.txt").write_text(parameter_page())
    (out / "moving.txt").write_text(moves.page())
    mutate.write_table(out / "mutations.txt")


# --- the pages ---

def number_citations(pages: dict[Path, str]) -> list[str]:
    works = entries((DOC / "PN_subdivision_3.bib").read_text())
    numbers = {key: str(i) for i, key in enumerate(ordered_keys(works), 1)}
    wrong = []

    def cite(match: re.Match[str]) -> str:
        key = html.unescape(match[1])
        if key not in numbers:
            wrong.append(f"{key} is not in PN_subdivision_3.bib")
            return match[0]
        return f'<a class="el" href="citelist.html#CITEREF_{key}">[{numbers[key]}]</a>'

    def work(match: re.Match[str]) -> str:
        key = html.unescape(match[1])
        return f'<a id="CITEREF_{key}"></a>[{numbers[key]}]'

    for path, text in pages.items():
        text = re.sub(r'<span class="cite">(.*?)</span>', cite, text)
        pages[path] = re.sub(r'<span class="bibkey">(.*?)</span>', work, text)
    return wrong


def number_figures(pages: dict[Path, str]) -> list[str]:
    """Figures are numbered on each page; a reference from elsewhere names the page too."""
    figures: dict[str, tuple[Path, int, str]] = {}
    for path, text in pages.items():
        title = re.search(r"<title>(?:[^<]*: )?([^<]*)</title>", text)
        for number, name in enumerate(re.findall(r'<span class="figure" id="fig__(\w+)">', text), 1):
            figures[name] = path, number, title[1] if title else path.stem
    wrong, used = [], set()
    for path, text in pages.items():
        def caption(match: re.Match[str]) -> str:
            return f'<span class="figure" id="fig__{match[1]}">Figure {figures[match[1]][1]}.</span>'

        def reference(match: re.Match[str]) -> str:
            name = match[1]
            used.add(name)
            if name not in figures:
                wrong.append(f"{path.name} refers to the figure {name}, which is not there")
                return match[0]
            page, number, title = figures[name]
            where = "" if page == path else f" of {title}"
            link = "" if page == path else page.name
            return f'<a class="el" href="{link}#fig__{name}">Figure {number}</a>{where}'

        text = re.sub(r'<span class="figure" id="fig__(\w+)"></span>', caption, text)
        pages[path] = re.sub(r'<span class="figureref">(\w+)</span>', reference, text)
    wrong += [f"no text refers to the figure {name}" for name in figures.keys() - used]
    return wrong


def mathml(tex: str, display: bool, blahtexml: str) -> str:
    tex = tex.replace(r"\,", r"\, ").replace(r"\bigl", r"\big").replace(r"\Bigl", r"\Big")
    tex = tex.replace(r"\bigr", r"\big").replace(r"\Bigr", r"\Big").replace(r"\mbox", r"\text")
    options = ["--mathml", "--spacing", "moderate"] + (["--displaymath"] if display else [])
    answer = subprocess.run([blahtexml, *options], input=tex, text=True, capture_output=True).stdout
    markup = re.search(r"<markup>\s*(.*?)\s*</markup>", answer, re.S)
    if not markup:
        raise ValueError(f"{tex}: {' '.join(re.findall('<message>(.*?)</message>', answer))}")
    content = markup[1].replace(">-</mo>", ">&#x2212;</mo>")
    kind = ' display="block"' if display else ""
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML"{kind}>{content}</math>'


def write_formulas(pages: dict[Path, str]) -> list[str]:
    blahtexml = shutil.which("blahtexml")
    if not blahtexml:
        print("blahtexml is not installed: formulas need the network when the manual is read")
        return []
    known: dict[tuple[str, bool], str] = {}
    wrong = []
    for path, text in pages.items():
        if r"\(" not in text and r"\[" not in text and "MathJax" not in text:
            continue

        def formula(match: re.Match[str]) -> str:
            display = match[0].startswith(r"\[")
            tex = html.unescape(match[1] if display else match[2]).strip()
            if (tex, display) not in known:
                try:
                    known[tex, display] = mathml(tex, display, blahtexml)
                except ValueError as error:
                    wrong.append(f"{path.name}: {error}")
                    return match[0]
            return known[tex, display]

        # programs and scripts stay as they are
        pieces = re.split(r'(<div class="fragment">.*?</div><!-- fragment -->|<script.*?</script>|<pre.*?</pre>)',
                          text, flags=re.S)
        pieces[::2] = [re.sub(r"\\\[(.*?)\\\]|\\\((.*?)\\\)", formula, piece, flags=re.S)
                       for piece in pieces[::2]]
        text = "".join(piece for piece in pieces
                       if not (piece.startswith("<script") and "mathjax" in piece.lower()))
        pages[path] = text
    return wrong


def unlisted(pages: dict[Path, str]) -> list[str]:
    """Public names that are neither in the classified list of PackageDescription.txt, nor a named parameter or a concept's model."""
    description = (DOC / "PackageDescription.txt").read_text()
    concepts = "".join(path.read_text() for path in sorted((DOC / "Concepts").glob("*.h")))
    listed = set(re.findall(r"`(?:CGAL::PN_subdivision_3::)?(?:\w+::)*(\w+)(?:\(\))?`", description)).union(
        *read_parameters().values(), re.findall(r"\\cgalHasModels\{CGAL::PN_subdivision_3::(\w+)", concepts))
    found = set()
    for path, text in pages.items():
        if path.name.startswith("group__"):
            found |= set(re.findall(r'class="memItemRight"[^>]*><a class="el" '
                                    r'href="(?:(?:class|struct)[^"]*|[^"]*#[^"]*)">([\w:]+)', text))
    names = {name.split("::")[-1] for name in found} - {"curve_svg"}
    return [f"{name} is not in the classified list of PackageDescription.txt"
            for name in sorted(names - listed)]


def without_header(pages: dict[Path, str]) -> list[str]:
    """Functions and types whose entry does not name the header to include."""
    wrong = []
    for path, text in pages.items():
        if path.name.startswith("group__"):
            for entry in text.split('<h2 class="memtitle">')[1:]:
                title = re.sub(r"<[^>]*>|&[^;]*;", "", entry.split("</h2>")[0]).strip()
                if "#include" not in entry:
                    wrong.append(f"{path.name}: {title} does not name its header")
    return wrong


def paths_of_build(pages: dict[Path, str]) -> list[str]:
    return [f"{path.name} has the folder of the build or of the sources" for path, text in pages.items()
            if str(DOC.parent.parent) in text or str(path.parent) in text]


def without_concept_headers(pages: dict[Path, str]) -> None:
    """A concept has no header to include; Doxygen names the file of its documentation, in whose build it may be."""
    for path, text in pages.items():
        pages[path] = re.sub(r"<p><code>#include &lt;[^&]*/Concepts/[^&]*&gt;</code></p>\n", "", text)


def finish(folder: Path) -> list[str]:
    before = {path: path.read_text() for path in sorted(folder.glob("*.html"))}
    pages = dict(before)
    without_concept_headers(pages)
    wrong = unlisted(pages) + without_header(pages) + paths_of_build(pages)
    wrong += number_citations(pages) + number_figures(pages) + write_formulas(pages)
    for path, text in pages.items():
        if text != before[path]:
            path.write_text(text)
    return wrong


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("step", choices=("prepare", "finish"))
    parser.add_argument("folder", type=Path)
    arguments = parser.parse_args()
    if arguments.step == "prepare":
        prepare(arguments.folder)
    else:
        sys.exit("\n".join(f"manual: {line}" for line in finish(arguments.folder)) or 0)


if __name__ == "__main__":
    main()
