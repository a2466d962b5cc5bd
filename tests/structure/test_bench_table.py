# SPDX-License-Identifier: MIT
"""The file that `tools/bench --write` keeps: sections are replaced by title, the others stay."""

import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

import bench_table  # noqa: E402


def section(tmp_path, title, milliseconds, note=""):
    runs = [
        {
            "name": f"stars/{engine}",
            "family_index": index,
            "run_type": "iteration",
            "cpu_time": time,
            "time_unit": "ms",
        }
        for index, engine in enumerate(("Tessera", "CGAL"))
        for time in (milliseconds * (1 + index), milliseconds * (1 + index), 1e6)
    ]
    context = {"title": title, "peers": "CGAL 5.5", "expect stars": "CGAL|0.4|0|", "note": note}
    path = tmp_path / "result.json"
    path.write_text(json.dumps({"context": context, "benchmarks": runs}))
    return bench_table.Section(path)


def test_sections_are_replaced_by_title_and_the_others_stay(tmp_path):
    table = tmp_path / "table.md"
    bench_table.update(table, [section(tmp_path, "A", 111), section(tmp_path, "B", 555)])
    first = table.read_text()
    assert first.startswith("# Benchmarks\n") and "CGAL 5.5" in first
    assert first.index("## A") < first.index("111") < first.index("## B") < first.index("555")
    assert " 0.5 |" in first and "≤ 0.4 missed" in first

    bench_table.update(table, [section(tmp_path, "A", 333, "As told.")])
    second = table.read_text()
    assert "111" not in second and "As told." in second
    assert second.index("## A") < second.index("333") < second.index("## B")
    assert second[second.index("## B") :] == first[first.index("## B") :]

    bench_table.update(table, [section(tmp_path, "C", 444)])
    assert table.read_text().startswith(second) and table.read_text().count("## ") == 3
