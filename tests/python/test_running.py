# SPDX-License-Identifier: MIT
"""Progress, cancel, time limit, threads."""

import os
import signal
import threading
import time

import pytest

import tessera

SQUARE = [(0, 0), (1000, 0), (1000, 1000), (0, 1000)]
LONG = 0.5  # about nine million triangles; no test waits for them


def test_progress_rises_to_one_and_is_limited_in_rate():
    calls = []
    began = time.monotonic()
    tessera.mesh(SQUARE, size=3.0, progress=lambda *call: calls.append(call))
    took = time.monotonic() - began
    fractions = [fraction for fraction, stage in calls]
    assert fractions == sorted(fractions)
    assert 0.0 <= fractions[0] and fractions[-1] == 1.0
    assert calls[-1][1] == "done"
    assert len(calls) <= took / 0.05 + 2
    assert all(isinstance(stage, str) for fraction, stage in calls)


def test_cancel_from_another_thread():
    execution = tessera.Execution()
    threading.Timer(0.1, execution.cancel).start()
    began = time.monotonic()
    with pytest.raises(tessera.CancelledError):
        tessera.mesh(SQUARE, size=LONG, execution=execution)
    assert time.monotonic() - began < 30.0


def test_cancel_before_the_start():
    execution = tessera.Execution()
    execution.cancel()
    with pytest.raises(tessera.CancelledError):
        tessera.mesh(SQUARE, size=100.0, execution=execution)


def test_time_limit():
    with pytest.raises(tessera.TimeLimitError):
        tessera.mesh(SQUARE, size=LONG, time_limit=0.1)


def test_exception_of_progress_ends_the_run_and_is_passed_on():
    def stop(fraction, stage):
        raise RuntimeError("enough")

    began = time.monotonic()
    with pytest.raises(RuntimeError, match="enough"):
        tessera.mesh(SQUARE, size=LONG, progress=stop)
    assert time.monotonic() - began < 30.0


def test_progress_that_returns_false_cancels():
    stages = []

    def stop_at_second_call(fraction, stage):
        stages.append(stage)
        return len(stages) < 2

    with pytest.raises(tessera.CancelledError):
        tessera.mesh(SQUARE, size=LONG, progress=stop_at_second_call)
    assert len(stages) == 2
    with pytest.raises(tessera.CancelledError):
        tessera.mesh(SQUARE, size=100.0, progress=lambda fraction, stage: False)


def test_other_answers_of_progress_go_on():
    for answer in (None, True, 0, "", 1.0):
        mesh = tessera.mesh(SQUARE, size=100.0, progress=lambda fraction, stage: answer)
        assert len(mesh.triangles) > 0


@pytest.fixture
def control_c():
    """Python's own answer to SIGINT; a shell switches it off for what runs in the background."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def test_control_c_ends_the_run(control_c):
    threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        tessera.mesh(SQUARE, size=LONG)


def test_other_threads_run_meanwhile():
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(None)
            time.sleep(0.005)

    ticker = threading.Thread(target=tick)
    ticker.start()
    tessera.mesh(SQUARE, size=1.0)
    done.set()
    ticker.join()
    assert len(ticks) > 5


def test_runs_in_parallel_do_not_disturb_each_other():
    sizes = [40.0, 30.0, 20.0, 10.0]
    alone = [tessera.mesh(SQUARE, size=size).nodes.tobytes() for size in sizes]
    results = [None] * len(sizes)

    def run(i):
        results[i] = tessera.mesh(SQUARE, size=sizes[i]).nodes.tobytes()

    threads = [threading.Thread(target=run, args=(i,)) for i in range(len(sizes))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert results == alone


def test_prepared_source_can_be_meshed_on_another_thread():
    from tessera.sources import prepare

    prepared = prepare(SQUARE)
    results = []
    thread = threading.Thread(target=lambda: results.append(tessera.mesh(prepared, size=50.0)))
    thread.start()
    thread.join()
    assert results[0].report["area"] == pytest.approx(1e6)
