# Copyright (c) 2026  PN_subdivision_3 developers
# All rights reserved.
#
# This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: LGPL-3.0-or-later
# Author(s): PN_subdivision_3 developers
"""The numbers of the page that shows the figures: `<!--NAME-->value<!---->`."""

import re

PLACE = re.compile(r"<!--(\d+_\w+)-->([^<]*)<!---->")
ROUNDING = 2e-15  # below: what is exact but for rounding, whose last digit may be another elsewhere


def shown(value: float) -> str:
    if value == 0 or value == int(value) and abs(value) < 1000:
        return str(int(value))
    text = f"{value:.2g}"
    if "e" in text:
        mantissa, exponent = text.split("e")
        return f"{mantissa}e{int(exponent)}"
    return text


def with_numbers(page: str, numbers: dict[str, float]) -> str:
    def put(place: re.Match[str]) -> str:
        name = place[1]
        return f"<!--{name}-->{shown(numbers[name])}<!---->" if name in numbers else place[0]

    return PLACE.sub(put, page)


def differences(page: str, numbers: dict[str, float]) -> list[str]:
    """What the page says otherwise."""
    wrong = []
    for name, text in PLACE.findall(page):
        if name not in numbers:
            continue
        value, stated = numbers[name], float(text)
        if max(value, stated) > ROUNDING and abs(value - stated) > 0.06 * abs(value):
            wrong.append(f"{name} is {shown(value)}, not {text}")
    return wrong
