# SPDX-License-Identifier: MIT
"""While the mesher runs."""

import threading

import FreeCAD
import pytest
import sketches
import window
from PySide import QtCore

from tessera.tools.mesh_job import MeshJob
from tessera.tools.request import MeshRequest

#: About a million triangles.
MANY = "0.04 mm"


@pytest.fixture
def endless(monkeypatch):
    """However fast the machine, a run goes on until it is stopped: from a fifth of its work on it
    waits where it reports its progress."""
    stopped = threading.Event()
    mesh, cancel = MeshRequest.mesh, MeshJob.cancel

    def slow_mesh(request, prepared, progress, *rest):
        def report(fraction, stage):
            progress(fraction, stage)
            if fraction > 0.2:
                stopped.wait()

        return mesh(request, prepared, report, *rest)

    def stop(job):
        cancel(job)
        stopped.set()

    monkeypatch.setattr(MeshRequest, "mesh", slow_mesh)
    monkeypatch.setattr(MeshJob, "cancel", stop)
    yield
    stopped.set()


def running_panel(document):
    panel = window.open_panel(sketches.plate(document))
    panel.set_size(MANY)
    panel.press_mesh()
    window.wait_until(lambda: panel.widget("progressBar").value() > 0)
    assert panel.running
    return panel


def mesher_threads():
    return [t for t in threading.enumerate() if t.name == "Tessera mesher"]


def test_stop(document, output, endless):
    panel = running_panel(document)
    objects, undo_count = len(document.Objects), document.UndoCount
    assert panel.widget("stopButton").isVisible()
    assert not panel.widget("meshButton").isVisible()
    window.picture(output / "running.png", 0.0)
    panel.widget("stopButton").click()
    window.wait_until(lambda: not panel.running)
    assert panel.message.startswith("Stopped")
    assert (len(document.Objects), document.UndoCount) == (objects, undo_count)
    assert not mesher_threads()
    panel.set_size("20 mm")
    panel.mesh()
    assert "triangles" in panel.message


def test_window_stays_alive(document, endless):
    """The window's timers go off and its fields answer while the mesher is at work."""
    ticks = []
    timer = QtCore.QTimer()
    timer.timeout.connect(lambda: ticks.append(None))
    panel = running_panel(document)
    timer.start(10)
    window.wait_until(lambda: len(ticks) > 20)
    timer.stop()
    assert panel.running
    assert panel.widget("progressBar").value() > 0
    panel.widget("stopButton").click()
    window.wait_until(lambda: not panel.running)


def test_cancel_of_the_panel_while_running(document, endless):
    panel = running_panel(document)
    objects = len(document.Objects)
    panel.press("Cancel")
    assert window.Panel.find() is None
    assert not mesher_threads()
    window.wait(0.3)
    assert len(document.Objects) == objects


def test_ok_has_to_wait(document, endless):
    panel = running_panel(document)
    panel.press("Ok")
    assert window.Panel.find() is not None
    assert panel.running
    panel.press("Cancel")


def test_sketch_that_changes_meanwhile(document):
    panel = window.open_panel(sketches.plate(document))
    panel.set_size("0.3 mm")
    panel.press_mesh()
    document.getObject("Plate").setDatum(0, FreeCAD.Units.Quantity("10 mm"))
    document.recompute()
    window.wait_until(lambda: not panel.running)
    assert "changed" in panel.message
    assert not window.planar_meshes(document)


def test_signals_arrive_on_the_main_thread(document):
    sketch = sketches.plate(document)
    request = MeshRequest(sketch, size=1.0)
    seen = []
    job = MeshJob([request, request])
    job.progressed.connect(lambda *_: seen.append(threading.current_thread()))
    job.finished.connect(lambda meshes: seen.append((threading.current_thread(), len(meshes))))
    job.start()
    window.wait_until(lambda: seen and isinstance(seen[-1], tuple))
    job.wait()
    assert seen[-1] == (threading.main_thread(), 2)
    assert set(seen[:-1]) == {threading.main_thread()}
