# SPDX-License-Identifier: MIT
# Shared by run_app and run_gui: a FreeCAD home of its own, with this source tree as an addon.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
export TESSERA_TEST_OUTPUT=${TESSERA_TEST_OUTPUT:-$root/build/test-output}
mkdir -p "$TESSERA_TEST_OUTPUT"
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
mkdir -p "$home/Mod"
ln -s "$root" "$home/Mod/Tessera"
export FREECAD_USER_HOME=$home
# The start page's web engine of FreeCAD 0.20 refuses to run as root otherwise.
export QTWEBENGINE_DISABLE_SANDBOX=1

run_tests() { # FOLDER PART_OF_NAME PROGRAM...: pytest inside FreeCAD, a line for each test, a count
    local folder=$1 name=$2 status=0 results=$TESSERA_TEST_OUTPUT/$1.xml
    shift 2
    rm -f "$results"
    TESSERA_PYTEST=$(printf '%s\n' -q --tb=short "--junitxml=$results" \
        ${name:+-k "$name"} "$here/$folder")
    export TESSERA_PYTEST
    timeout --kill-after=20 "${TESSERA_TEST_TIMEOUT:-1200}" "$@" "$here/run_pytest.py" || status=$?
    python3 - "$results" "$status" <<'END'
import sys
import xml.etree.ElementTree as ElementTree

try:
    cases = list(ElementTree.parse(sys.argv[1]).iter("testcase"))
except OSError:
    sys.exit(f"FreeCAD ended before its tests did (status {sys.argv[2]})\n0 passed, 1 failed")
words = {"failure": "FAILED", "error": "FAILED", "skipped": "skipped"}
results = []
for case in cases:
    word = next((words[tag] for tag in words if case.find(tag) is not None), "passed")
    results.append(word)
    print(word, f"{case.get('classname')}.{case.get('name')} ({float(case.get('time')):.1f} s)")
for case in cases:  # once more at the end, where a reader looks first
    for failure in (found for tag in ("failure", "error") for found in case.iter(tag)):
        print(f"\n{case.get('name')}:\n{failure.text}\n")
print(f"{results.count('passed')} passed, {results.count('FAILED')} failed")
END
    return "$status"
}
