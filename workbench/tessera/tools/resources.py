# SPDX-License-Identifier: MIT
"""Where the files lie that the workbench shows: icons, forms, translations."""

from pathlib import Path

_ROOT = Path(__file__).resolve().parents[3] / "resources"


def folder(name):
    """Path of a folder of resources: "icons", "ui", "translations", "macros", "examples"."""
    return str(_ROOT / name)


def icon(name):
    return str(_ROOT / "icons" / f"{name}.svg")


def form(name):
    return str(_ROOT / "ui" / f"{name}.ui")
