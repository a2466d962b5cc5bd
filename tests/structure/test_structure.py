# SPDX-License-Identifier: MIT
"""The architecture as a test: which module may include which, what the core may use, and what every
file of the project has in common. Each check is a function of a folder, so that the second half of
this file can show that it finds what it should find."""

import re
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]

def module_graph():
    """The graph of ARCHITECTURE.md: {module: the modules that its line names}."""
    text = (PROJECT / "ARCHITECTURE.md").read_text()
    graph = text[text.index("    base\n") :]
    lines = re.findall(r"^    (\w+)(?: +<- ([\w, ]+))?$", graph, re.MULTILINE)
    return {module: used.split(", ") if used else [] for module, used in lines}


USES = module_graph()
FOREIGN_ALLOWED = {"io", "expression", "occt", "vtk", "python", "cli"}
PEERS_FOR_TESTS_ONLY = re.compile(r"\b(CGAL|geos|geos_c|gmsh|triangle)\b", re.IGNORECASE)

STANDARD_HEADERS = set(
    """algorithm any array atomic barrier bit bitset cassert cctype cerrno cfenv cfloat charconv
    chrono cinttypes climits clocale cmath codecvt compare complex concepts condition_variable
    coroutine csetjmp csignal cstdarg cstddef cstdint cstdio cstdlib cstring ctime cuchar cwchar
    cwctype deque exception execution expected filesystem format forward_list fstream functional
    future initializer_list iomanip ios iosfwd iostream istream iterator latch limits list locale
    map memory memory_resource mutex new numbers numeric optional ostream queue random ranges ratio
    regex scoped_allocator semaphore set shared_mutex source_location span sstream stack stdexcept
    stop_token streambuf string string_view system_error thread tuple type_traits typeindex typeinfo
    unordered_map unordered_set utility valarray variant vector version""".split()
)

INCLUDE = re.compile(r'^\s*#\s*include\s+(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)
CODE = {".h", ".cpp", ".py", ".sh", ".cmake", ".FCMacro"}
TEXT = CODE | {".md", ".txt", ".json", ".xml", ".ui", ".svg", ".ts", ".yml"}
NOT_OURS = re.compile(r"build(-.*)?|demo|__pycache__|\..*")


def files(root):
    """All files of the project below root: no build folders, no results, no caches."""
    for path in sorted(root.iterdir()):
        if path.is_dir() and not path.is_symlink():
            if path.name == ".ci" or not NOT_OURS.fullmatch(path.name):
                yield from files(path)
        elif path.is_file():
            yield path


def is_script(path):
    with path.open("rb") as stream:
        return stream.read(2) == b"#!"


def code_files(root):
    return [
        path
        for path in files(root)
        if path.suffix in CODE or path.name == "CMakeLists.txt" or is_script(path)
    ]


def text_files(root):
    names = {"LICENSE", ".gitignore", "CMakeLists.txt", "CMakePresets.json"}
    return [f for f in files(root) if f.suffix in TEXT or f.name in names or is_script(f)]


def may_use(module):
    reached, open_ = set(), [module]
    while open_:
        current = open_.pop()
        if current not in reached:
            reached.add(current)
            open_ += USES[current]
    return reached


# What the core asks of the operating system: a hint, without which it works as well.
SYSTEM_HEADERS = {("src/base/huge_pages.cpp", "sys/mman.h")}


def module_of(path, source):
    parts = path.relative_to(source).parts
    return parts[0] if len(parts) > 1 else path.stem


def wrong_includes(root):
    """Includes against the module order, of unknown modules, and foreign headers in the core."""
    source = root / "src"
    problems = []
    for path in files(source):
        if path.suffix not in (".h", ".cpp"):
            continue
        module, where = module_of(path, source), path.relative_to(root)
        if module not in USES:
            problems.append(f"{where}: module '{module}' is not in the module graph")
            continue
        for quoted, angled in INCLUDE.findall(path.read_text()):
            if quoted:
                target = quoted.split("/")[0] if "/" in quoted else Path(quoted).stem
                if not (source / quoted).is_file():
                    problems.append(f"{where}: include \"{quoted}\" relative to src")
                elif target not in may_use(module):
                    problems.append(f"{where}: '{module}' may not use '{target}' ({quoted})")
            elif (
                module not in FOREIGN_ALLOWED
                and angled not in STANDARD_HEADERS
                and (str(where), angled) not in SYSTEM_HEADERS
            ):
                problems.append(f"{where}: the core may not use <{angled}>")
            elif PEERS_FOR_TESTS_ONLY.search(angled):
                problems.append(f"{where}: <{angled}> belongs to tests and benchmarks")
    return problems


def missing_license_lines(root):
    return [
        str(path.relative_to(root))
        for path in code_files(root)
        if "SPDX-License-Identifier: MIT" not in "".join(path.open().readlines()[:3])
    ]


def machine_paths(root):
    """Lines with a path that exists on one machine only."""
    pattern = re.compile(r"(?<![\w.$}])/(?:home|work|Users|farm|root)/\w")
    found = []
    for path in text_files(root):
        # Inside the test root of Debian 13 there is one user, whose folder is known.
        if path.parent == root / "tools":
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if pattern.search(line):
                found.append(f"{path.relative_to(root)}:{number}: {line.strip()[:80]}")
    return found


def unfinished(root):
    words = re.compile(r"\b(?:TO" r"DO|FIX" r"ME|XX" r"X|NotImple" r"mented\w*)\b")
    return [
        f"{path.relative_to(root)}:{number}"
        for path in code_files(root)
        for number, line in enumerate(path.read_text().splitlines(), 1)
        if words.search(line)
    ]


def long_files(root, limit=700):
    return [
        f"{path.relative_to(root)}: {count} lines"
        for path in code_files(root)
        if (count := len(path.read_text().splitlines())) > limit
    ]


def importable_names(root):
    """Folders that would become importable under a name that other workbenches use too."""
    taken = ("workbench", "tests", "resources", "tools")
    return [name for name in taken if (root / name / "__init__.py").exists()]


@pytest.mark.parametrize(
    "check",
    [
        wrong_includes,
        missing_license_lines,
        machine_paths,
        unfinished,
        long_files,
        importable_names,
    ],
)
def test_project_keeps_the_rule(check):
    assert check(PROJECT) == []


def test_module_graph_has_every_source_folder():
    folders = {path.name for path in (PROJECT / "src").iterdir() if path.is_dir()}
    assert folders == set(USES) - {"pipeline"}


def test_module_graph_has_no_cycle():
    for module, used in USES.items():
        for other in used:
            assert module not in may_use(other), f"{module} and {other} use each other"


def test_top_level_files_are_there():
    for name in ("src", "workbench", "resources", "tests", "CMakeLists.txt", "InitGui.py"):
        assert (PROJECT / name).exists(), name


@pytest.fixture
def tree(tmp_path):
    """A small project that keeps every rule."""
    header = "// SPDX-License-Identifier: MIT\n"
    for name, text in {
        "src/base/vec2.h": "#include <cmath>\n",
        "src/delaunay/locate.cpp": '#include "base/vec2.h"\n',
        "src/vtk/write.cpp": "#include <vtkPoints.h>\n",
    }.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(header + text)
    return tmp_path


def test_checks_accept_a_clean_tree(tree):
    for check in (wrong_includes, missing_license_lines, machine_paths, unfinished, long_files):
        assert check(tree) == []


@pytest.mark.parametrize(
    "check, name, text, expected",
    [
        (wrong_includes, "src/base/a.cpp", '#include "delaunay/locate.cpp"\n', "may not use"),
        (wrong_includes, "src/base/a.cpp", "#include <vtkPoints.h>\n", "the core may not use"),
        (wrong_includes, "src/vtk/a.cpp", "#include <CGAL/Point_2.h>\n", "tests and benchmarks"),
        (wrong_includes, "src/base/a.cpp", '#include "vec2.h"\n', "relative to src"),
        (wrong_includes, "src/other/a.cpp", "", "not in the module graph"),
        (missing_license_lines, "workbench/a.py", "import os\n", "a.py"),
        (machine_paths, "docs/a.md", "see /" "home/somebody/mesh.vtu\n", "a.md:1"),
        (unfinished, "src/base/a.cpp", "// TO" "DO later\n", "a.cpp:1"),
        (long_files, "src/base/a.cpp", "int a;\n" * 701, "701 lines"),
    ],
)
def test_checks_find_what_they_should(tree, check, name, text, expected):
    path = tree / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    found = check(tree)
    assert len(found) == 1 and expected in found[0]
