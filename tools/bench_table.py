# SPDX-License-Identifier: MIT
"""Tables of benchmark results: `bench_table.py RESULT.json... [--write FILE.md]`.

Reads what the executables of benchmarks/ (benchmarks/section.h) write as JSON. Prints one table
with a line for each input: our time, its ratio to the peers' times, bytes per vertex, targets.
--write puts each section into a file too, with the machine and all engines' figures, in place of
the section of that title if there is one; the file's other sections stay.
"""

import argparse
import datetime
import json
import os
import platform
import re
from pathlib import Path
from statistics import median

HEAD = """\
# Benchmarks

Made by `tools/bench --write`; each section tells on what machine and when.

Medians of process CPU time (seven runs, one of what takes seconds); one thread; all engines of a
section in one process, in random order, on the same input. **ratio** is Tessera's time over the
peer's, **bytes** the greatest growth of the heap during the job over the number of vertices of its
result. Absolute times drift with the machine's load, ratios less.
"""


class Engine:
    """The runs of one engine on one input."""

    def __init__(self, name, runs):
        self.name = name
        self.ms = median(run.get("own ms", run["cpu_time"]) for run in runs)
        known = {"vertices", "bytes/vertex", "own ms"}
        self.vertices = runs[0].get("vertices")
        self.bytes = max((run.get("bytes/vertex", 0) for run in runs), default=0) or None
        first = list(runs[0])
        extra = first[first.index("time_unit") + 1 :]
        self.columns = {key: median(run[key] for run in runs) for key in extra if key not in known}


class Case:
    """One input with its engines, ours first, and what is expected of ours."""

    def __init__(self, name, engines, expectation):
        self.name = name
        self.engines = engines
        self.reference, ratio, size, columns = (expectation or "|0|0|").split("|")
        self.ratio_target, self.bytes_target = float(ratio), float(size)
        self.column_targets = re.findall(r"([^;]+?)([<>])=([^;]+);", columns)

    def ratio(self, engine):
        return self.engines[0].ms / engine.ms

    def columns(self):
        """Our columns that have a target: value, target, and whether it is missed."""
        parts = []
        for title, sign, text in self.column_targets:
            value, target = self.engines[0].columns[title], float(text)
            missed = value < target if sign == ">" else value > target
            parts.append(
                f"{title} {value:.4g} {'≥' if sign == '>' else '≤'} {target:g}"
                + (" missed" if missed else "")
            )
        return ", ".join(parts)

    def find(self, name):
        return next((engine for engine in self.engines if engine.name == name), None)


class Section:
    def __init__(self, path):
        result = json.loads(Path(path).read_text())
        context = result["context"]
        self.title = context.get("title", Path(path).stem)
        self.peers = context.get("peers", "")
        self.compiler = context.get("compiler", "")
        self.note = context.get("note", "")
        self.load = max(context.get("load_avg") or [0])
        runs = {}
        for run in result["benchmarks"]:
            if run["run_type"] == "iteration" and not run.get("error_occurred"):
                case, engine = run["name"].split("/")[:2]
                runs.setdefault(case, {}).setdefault((run["family_index"], engine), []).append(run)
        self.cases = [
            Case(
                case,
                [Engine(name, found) for (_, name), found in sorted(engines.items())],
                context.get(f"expect {case}"),
            )
            for case, engines in runs.items()
        ]
        first = {case: min(engines)[0] for case, engines in runs.items()}
        self.cases.sort(key=lambda case: first[case.name])
        self.has_peer = any(
            case.find(case.reference) or case.column_targets for case in self.cases
        )


def number(value, digits=3):
    """Three significant digits; whole numbers in full, with separators."""
    if value is None:
        return ""
    if abs(value) >= 100 or value == int(value):
        return f"{round(value):,}"
    return f"{value:.{digits}g}"


def at_most(value, target):
    """The target, and whether it is reached."""
    if not target:
        return ""
    return f"≤ {target:g}{'' if value <= target else ' missed'}"


def aligned(rows):
    """A Markdown table that is readable as it is: titles first; text left, numbers right."""
    columns = list(zip(*rows))
    widths = [max(map(len, column)) for column in columns]
    left = [
        i == 0 or any(re.match(r"[A-Za-z]", cell) for cell in column[1:])
        for i, column in enumerate(columns)
    ]
    lines = []
    for row in rows:
        cells = [c.ljust(w) if l else c.rjust(w) for c, w, l in zip(row, widths, left)]
        lines.append("| " + " | ".join(cells) + " |")
    rule = ["-" * w if l else "-" * (w - 1) + ":" for w, l in zip(widths, left)]
    return "\n".join([lines[0], "| " + " | ".join(rule) + " |", *lines[1:]])


def summary(sections):
    """One line for each input that has a peer."""
    rows = [["input", "ms", "peer", "ratio", "target", "bytes", "target", "ratio to others", "also"]]
    for section in sections:
        if len(sections) > 1:
            rows.append([f"**{section.title}**"] + [""] * 8)
        for case in section.cases:
            ours, reference = case.engines[0], case.find(case.reference)
            if reference is None and not case.column_targets:
                continue
            others = [e for e in case.engines[1:] if e is not reference]
            ratio = case.ratio(reference) if reference else None
            rows.append(
                [
                    case.name,
                    number(ours.ms),
                    reference.name if reference else "",
                    f"{ratio:.2g}" if reference else "",
                    at_most(ratio, case.ratio_target) if reference else "",
                    number(ours.bytes),
                    at_most(ours.bytes or 0, case.bytes_target),
                    ", ".join(f"{e.name} {case.ratio(e):.2g}" for e in others),
                    case.columns(),
                ]
            )
    filled = [i for i in range(len(rows[0])) if any(row[i] for row in rows[1:])]
    return aligned([[row[i] for i in filled] for row in rows])


def details(section):
    titles = []
    for case in section.cases:
        for engine in case.engines:
            titles += [title for title in engine.columns if title not in titles]
    rows = [["input", "engine", "ms", "vertices", "bytes", *titles]]
    for case in section.cases:
        for engine in case.engines:
            rows.append(
                [
                    case.name if engine is case.engines[0] else "",
                    engine.name,
                    number(engine.ms),
                    number(engine.vertices),
                    number(engine.bytes),
                    *(number(engine.columns.get(title)) for title in titles),
                ]
            )
    filled = [i for i in range(len(rows[0])) if any(row[i] for row in rows[1:])]
    return aligned([[row[i] for i in filled] for row in rows])


def machine(sections):
    """CPU, memory, system, compiler, peers, load, date."""
    cpu = re.search(r"model name\s*:\s*(.+)", Path("/proc/cpuinfo").read_text())
    system = re.search(r'PRETTY_NAME="(.+)"', Path("/etc/os-release").read_text())
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    peers = sorted({peer for section in sections for peer in section.peers.split(", ") if peer})
    compilers = sorted({section.compiler for section in sections if section.compiler})
    parts = [
        (cpu.group(1) if cpu else platform.machine()) + f", {os.cpu_count()} cores",
        f"{memory:.0f} GB",
        system.group(1) if system else platform.system(),
        *compilers,
        *peers,
        f"load average up to {max(section.load for section in sections):.0f}",
        datetime.date.today().isoformat(),
    ]
    return "; ".join(parts)


def chapter(section):
    parts = [f"## {section.title}", f"On {machine([section])}."]
    parts += [section.note] if section.note else []
    parts += [summary([section])] if section.has_peer else []
    return "\n\n".join([*parts, details(section)]) + "\n"


def update(path, sections):
    """Puts the sections into the file in place of those of the same titles, or at its end."""
    text = path.read_text() if path.exists() else HEAD
    head, *chapters = re.split(r"^(?=## )", text, flags=re.MULTILINE)
    chapters = {chapter.splitlines()[0]: chapter for chapter in chapters}
    chapters |= {f"## {section.title}": chapter(section) for section in sections}
    path.write_text("\n".join(part.rstrip("\n") + "\n" for part in [head, *chapters.values()]))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", nargs="+")
    parser.add_argument("--write", metavar="FILE.md")
    arguments = parser.parse_args()
    sections = [Section(path) for path in arguments.results]
    print(f"\n{machine(sections)}")
    if any(section.has_peer for section in sections):
        print(f"\n{summary([section for section in sections if section.has_peer])}")
    for section in sections:
        if not section.has_peer:
            print(f"\n{section.title}\n\n{details(section)}")
    if arguments.write:
        update(Path(arguments.write), sections)


if __name__ == "__main__":
    main()
