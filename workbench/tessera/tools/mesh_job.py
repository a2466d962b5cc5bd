# SPDX-License-Identifier: MIT
"""Runs the mesher on a thread of its own, so that FreeCAD's window stays alive."""

import threading

from PySide import QtCore

import tessera
from tessera.tools import preferences


class MeshJob(QtCore.QObject):
    """Meshes several requests one after the other. The signals arrive on the thread that made the
    job; one of finished and failed comes last, also after cancel()."""

    progressed = QtCore.Signal(float, str)  #: fraction of the whole, stage
    finished = QtCore.Signal(object)  #: list of tessera.Mesh
    failed = QtCore.Signal(int, object)  #: number of the request, exception

    def __init__(self, requests):
        super().__init__()
        self._requests = requests
        self._prepared = []
        self._execution = None
        self._threads = preferences.threads()
        self._thread = None
        self.cancelled = False  #: a result that was already on its way is not wanted any more

    def start(self):
        """Reads the document, then leaves the thread to its work. Bad input fails at once."""
        for number, request in enumerate(self._requests):
            try:
                self._prepared.append(request.prepare())
            except Exception as error:  # anything must reach the user, who would wait for ever
                self.failed.emit(number, error)
                return
        self._execution = tessera.Execution()
        self._thread = threading.Thread(target=self._run, name="Tessera mesher", daemon=True)
        self._thread.start()

    def cancel(self):
        """Ends the run soon; failed comes with a tessera.CancelledError, or finished if the mesh
        was there already."""
        self.cancelled = True
        if self._execution is not None:
            self._execution.cancel()

    def wait(self):
        """Returns when the thread has ended. Signals that it sent may still be on their way."""
        if self._thread is not None:
            self._thread.join()

    def _run(self):
        meshes = []
        count = len(self._requests)
        for number, (request, prepared) in enumerate(zip(self._requests, self._prepared)):

            def progress(fraction, stage, done=number):
                self.progressed.emit((done + fraction) / count, stage)

            try:
                meshes.append(request.mesh(prepared, progress, self._execution, self._threads))
            except Exception as error:  # as above
                self.failed.emit(number, error)
                return
        self.finished.emit(meshes)
