# SPDX-License-Identifier: MIT
"""The task panel of planar meshes: makes new ones of sketches and edits those that exist.

Nothing enters the document before there is a mesh. All that the panel does to the document is one
step of undo: OK ends it, Cancel takes it back.
"""

import math
from dataclasses import replace

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

import tessera
from tessera.objects import planar_mesh
from tessera.tools import resources
from tessera.tools.mesh_job import MeshJob
from tessera.tools.request import FILLS, MeshRequest, default_size
from tessera.tools.selection import select_places, selected_edges

translate = FreeCAD.Qt.translate

_INFORMATION = QtGui.QStyle.SP_MessageBoxInformation
_WARNING = QtGui.QStyle.SP_MessageBoxWarning
_CRITICAL = QtGui.QStyle.SP_MessageBoxCritical


class Target:
    """One mesh that the panel makes: of what, and the document object that holds it, once there is
    one."""

    def __init__(self, source, faces=(), obj=None):
        self.source = source
        self.faces = faces
        self.document = (obj or source).Document
        self.name = obj.Name if obj else None

    @classmethod
    def of_object(cls, obj):
        return cls(obj.Source, planar_mesh.faces_of(obj), obj)

    def object(self):
        """The document object, or None: it may be gone by undo."""
        return self.document.getObject(self.name) if self.name else None


class _Number:
    """A field that shows a number rounded: what the user leaves alone keeps all its digits.

    FreeCAD's fields for lengths silently replace what was typed but is no length, some at once,
    some when they lose the focus: get() raises ValueError with that text, and again as long as the
    field shows it."""

    def __init__(self, field, is_length=True):
        self._field = field
        self._is_length = is_length
        self._value = self._shown = 0.0
        self._refused = None
        self._edit = field.findChild(QtGui.QLineEdit)
        if is_length:
            self._edit.textEdited.connect(self._note_typed)

    def _note_typed(self, text):
        self._refused = None if _is_length(text, self._field.locale()) else text

    def set(self, value):
        if self._is_length:
            quantity = FreeCAD.Units.Quantity(value, FreeCAD.Units.Length)
            self._field.setProperty("value", quantity)
        else:
            self._field.setValue(value)
        self._value, self._shown, self._refused = value, self._read(), None

    def get(self):
        """Lengths in millimeters."""
        if self._refused is not None:
            text = self._refused
            if self._edit.text() != text:
                self._refused = None
            raise ValueError(text)
        shown = self._read()
        return self._value if shown == self._shown else shown

    def _read(self):
        return float(self._field.property("rawValue" if self._is_length else "value"))


def _is_length(text, locale):
    """The text is a length of 0 or more, or a number; its unit and separators are the user's."""
    plain = text.replace(locale.groupSeparator(), "").replace(locale.decimalPoint(), ".")
    for candidate in (text, plain):
        try:
            quantity = FreeCAD.Units.Quantity(candidate)
        except (ValueError, OSError, ArithmeticError, FreeCAD.Base.FreeCADError):
            continue
        is_length = quantity.Unit in (FreeCAD.Units.Length, FreeCAD.Units.Unit())
        if is_length and math.isfinite(quantity.Value) and quantity.Value >= 0.0:
            return bool(candidate.strip())
    return False


class PlanarMeshPanel:
    """Task panel in FreeCAD's sense: form, accept, reject, getStandardButtons."""

    def __init__(self, targets):
        self.form = FreeCADGui.PySideUic.loadUi(resources.form("planar_mesh"))
        self._document = targets[0].document
        self._document_name = self._document.Name
        self._targets = targets
        self._edited = targets[0].object()
        self._size = _Number(self.form.sizeField)
        self._weld = _Number(self.form.weldField)
        self._growth = _Number(self.form.growthField, is_length=False)
        self._constraints = []
        self._job = None
        self._requests = []
        self._shapes = []
        self._transaction = False
        self._closing = False
        self._meshed = None
        self._fill_form()
        self._connect()

    # Form

    def _fill_form(self):
        form = self.form
        form.setWindowIcon(QtGui.QIcon(resources.icon("tessera_mesh_sketch")))
        form.sourceName.setText(self._source_text())
        for key, label, explanation in _fill_texts():
            form.fillField.addItem(label, key)
            last = form.fillField.count() - 1
            form.fillField.setItemData(last, explanation, QtCore.Qt.ToolTipRole)
        if self._edited is None:
            sizes = [default_size(target.source, target.faces) for target in self._targets]
            request = MeshRequest(None, size=min((s for s in sizes if s > 0.0), default=0.0))
        else:
            request = planar_mesh.request_of(self._edited)
            self._meshed = [request]
        self._shown = request
        self._size.set(request.size)
        self._weld.set(request.weld)
        self._growth.set(request.growth)
        form.orderField.setCurrentIndex(request.order - 1)
        form.fillField.setCurrentIndex(form.fillField.findData(request.fill))
        self._constraints = [
            (owner, name) for owner, names in request.constraints for name in names
        ]
        self._list_constraints()
        self._show_running(False)
        if self._edited is not None and self._edited.Triangles > 0:
            self._show_summary([self._edited])
        else:
            self._show_message("")

    def _connect(self):
        form = self.form
        form.meshButton.clicked.connect(self.start)
        form.stopButton.clicked.connect(self.stop)
        form.addButton.clicked.connect(self._add_constraints)
        form.removeButton.clicked.connect(self._remove_constraints)

    def _source_text(self):
        names = []
        for target in self._targets:
            label = target.source.Label if target.source else translate("Tessera", "none")
            names.append(f"{label}: {', '.join(target.faces)}" if target.faces else label)
        return ", ".join(names)

    def _add_constraints(self):
        known = {(owner.Name, name) for owner, name in self._constraints}
        sources = {target.source.Name for target in self._targets if target.source}
        for owner, names in selected_edges():
            self._constraints += [
                (owner, name)
                for name in names
                if (owner.Name, name) not in known and (name or owner.Name not in sources)
            ]
        self._list_constraints()

    def _remove_constraints(self):
        rows = {index.row() for index in self.form.constraintList.selectedIndexes()}
        self._constraints = [c for row, c in enumerate(self._constraints) if row not in rows]
        self._list_constraints()

    def _list_constraints(self):
        self.form.constraintList.clear()
        for owner, name in self._constraints:
            self.form.constraintList.addItem(f"{owner.Label}: {name}" if name else owner.Label)
        self.form.constraintList.setVisible(bool(self._constraints))
        self.form.removeButton.setEnabled(bool(self._constraints))

    def requests(self):
        """What the form asks for, one request for each target."""
        return [self._request(target) for target in self._targets]

    def _request(self, target):
        alone = len(self._targets) == 1
        constraints = {}
        for owner, name in self._constraints:
            if alone or owner is target.source:
                constraints.setdefault(owner, []).append(name)
        return replace(  # what has no field stays as it is
            self._shown,
            source=target.source,
            faces=tuple(target.faces),
            size=self._size.get(),
            weld=self._weld.get(),
            growth=self._growth.get(),
            order=self.form.orderField.currentIndex() + 1,
            fill=self.form.fillField.itemData(self.form.fillField.currentIndex()),
            constraints=tuple((owner, tuple(names)) for owner, names in constraints.items()),
        )

    # Run

    def start(self):
        """Meshes, without holding up the window."""
        if self._job is not None:
            return
        self._show_message("")
        try:
            requests = self.requests()
            self._shapes = [_shape_of(request.source) for request in requests]
        except ReferenceError:
            text = translate("Tessera", "What was to be meshed has been deleted; close the panel.")
            self._show_message(text, _CRITICAL)
            return
        except ValueError as error:
            text = translate("Tessera", "'{}' cannot be used here; give a number, such as 2 mm.")
            self._show_message(text.format(error), _CRITICAL)
            return
        self._requests = requests
        self._job = MeshJob(requests)
        self._job.progressed.connect(self._on_progress)
        self._job.finished.connect(self._on_finished)
        self._job.failed.connect(self._on_failed)
        self._show_running(True)
        self._job.start()

    def stop(self):
        if self._job is not None:
            self._job.cancel()

    def _on_progress(self, fraction, stage):
        self.form.progressBar.setValue(int(1000 * fraction))
        self.form.progressBar.setFormat(f"{_stage_text(stage)} %p%")

    def _on_failed(self, number, error):
        self._end_job()
        self._closing = False
        if isinstance(error, tessera.CancelledError):
            self._show_message(translate("Tessera", "Stopped; nothing has changed."), _INFORMATION)
            return
        source = self._targets[number].source
        text = str(error) or type(error).__name__
        if len(self._targets) > 1:
            text = f"{source.Label}: {text}"
        self._show_message(text, _CRITICAL)
        if isinstance(error, tessera.Error) and self._document_is_open() and source is not None:
            select_places(source, error.places)
        elif not isinstance(error, (tessera.Error, ImportError)):
            FreeCAD.Console.PrintError(f"Tessera: {type(error).__name__}: {error}\n")

    def _on_finished(self, meshes):
        if self._job.cancelled:
            self._on_failed(0, tessera.CancelledError("Cancelled."))
            return
        requests = self._requests
        closing, self._closing = self._closing, False
        if not self._document_is_open():
            self._end_job()
            FreeCADGui.Control.closeDialog()
            return
        changed = self._changed_source(requests)
        if changed is not None:
            self._end_job()
            text = translate("Tessera", "{} has changed in the meantime; press Mesh again.")
            self._show_message(text.format(changed.Label), _WARNING)
            return
        # FreeCAD takes some seconds for a million triangles and does not answer meanwhile.
        self._on_progress(1.0, "store")
        self.form.stopButton.setEnabled(False)
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            QtGui.QApplication.processEvents(QtCore.QEventLoop.ExcludeUserInputEvents)
            published = self._publish(requests, meshes)
        finally:
            QtGui.QApplication.restoreOverrideCursor()
            self._end_job()
        if published and closing:
            self._commit()
            self._leave_edit()
            FreeCADGui.Control.closeDialog()

    def _changed_source(self, requests):
        """A source that was recomputed while the mesher ran, or None."""
        for request, shape in zip(requests, self._shapes):
            if not _is_same(shape, _shape_of(request.source)):
                return request.source
        return None

    def _end_job(self):
        # The thread may still be leaving its last signal; the job may not go before it.
        self._job.wait()
        self._job = None
        self._show_running(False)

    # Document

    def _publish(self, requests, meshes):
        """Puts the meshes into the document; False, with a message, if that failed."""
        if not (self._transaction and self._document.HasPendingTransaction):
            self._document.openTransaction(translate("Tessera", "Mesh sketch"))
            self._transaction = True
        objects = []
        for target, request, mesh in zip(self._targets, requests, meshes):
            obj = target.object()
            if obj is None:
                obj = planar_mesh.make(request, active_analysis(self._document))
                target.name = obj.Name
            else:
                planar_mesh.apply_request(obj, request)
            obj.Proxy.offer(request, mesh)
            obj.touch()
            objects.append(obj)
        self._document.recompute(objects)
        for obj in objects:
            if not obj.isValid():
                self._show_message(obj.getStatusString(), _CRITICAL)
                return False
        self._meshed = requests
        self._show_summary(objects)
        return True

    def _up_to_date(self):
        objects = [target.object() for target in self._targets]
        return self._meshed == self.requests() and all(
            obj is not None
            and obj.MeshRevision > 0
            and obj.isValid()
            and "Touched" not in obj.State
            for obj in objects
        )

    def _commit(self):
        if self._transaction and self._document.HasPendingTransaction:
            self._document.commitTransaction()

    def _document_is_open(self):
        return self._document_name in FreeCAD.listDocuments()

    # What FreeCAD calls

    def getStandardButtons(self):
        return int(QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel)

    def isAllowedAlterSelection(self):
        return True

    def isAllowedAlterView(self):
        return True

    def isAllowedAlterDocument(self):
        return True

    def accept(self):
        """OK: what the form asks for is meshed first, unless it is already. FreeCAD closes the
        panel if the answer is True."""
        if self._job is not None:
            return False
        if self._document_is_open():
            if not self._up_to_date():
                self._closing = True
                self.start()
                return False
            self._commit()
            self._leave_edit()
        return True

    def reject(self):
        """Cancel: the document is as it was before the panel opened."""
        if self._job is not None:
            self._job.blockSignals(True)
            self._job.cancel()
            self._job.wait()
            self._job = None
        if self._document_is_open():
            if self._transaction and self._document.HasPendingTransaction:
                self._document.abortTransaction()
            self._leave_edit()
        return True

    def _leave_edit(self):
        document = FreeCADGui.getDocument(self._document_name)
        if document.getInEdit() is not None:
            document.resetEdit()

    # Messages

    def _show_running(self, running):
        form = self.form
        form.meshButton.setVisible(not running)
        form.progressBar.setVisible(running)
        form.progressBar.setValue(0)
        form.stopButton.setVisible(running)
        form.stopButton.setEnabled(True)
        for widget in (
            form.sizeField,
            form.growthField,
            form.orderField,
            form.fillField,
            form.weldField,
            form.constraintsBox,
        ):
            widget.setEnabled(not running)

    def _show_message(self, text, kind=None):
        icon = QtGui.QPixmap()
        if kind is not None:
            icon = self.form.style().standardIcon(kind).pixmap(16, 16)
        self.form.messageIcon.setPixmap(icon)
        self.form.messageIcon.setVisible(bool(text))
        self.form.message.setText(text)
        self.form.message.setVisible(bool(text))

    def _show_summary(self, objects):
        """Number and quality of the triangles, then what the mesher has to say."""
        template = translate(
            "Tessera", "{triangles} triangles, smallest angle {angle}°, mean quality {quality}"
        )
        lines = []
        for obj in objects:
            line = template.format(
                triangles=f"{obj.Triangles:,}",
                angle=f"{float(obj.MinAngle):.1f}",
                quality=f"{obj.MeanQuality:.3f}",
            )
            lines.append(f"{obj.Source.Label}: {line}" if len(objects) > 1 else line)
            lines += obj.Messages
        self._show_message("\n".join(lines), _INFORMATION)


def _shape_of(source):
    shape = getattr(source, "Shape", None)
    return None if shape is None or shape.isNull() else shape


def _is_same(shape, other):
    """Nothing was recomputed in between."""
    if shape is None or other is None:
        return shape is other
    return shape.isSame(other)


def active_analysis(document):
    """The analysis that new FEM objects of the document join, or None."""
    import FemGui

    analysis = FemGui.getActiveAnalysis()
    if analysis is None or analysis.Document.Name != document.Name:
        return None
    return analysis


def _stage_text(stage):
    texts = {
        "arrange": translate("Tessera", "Finding crossings"),
        "sample": translate("Tessera", "Dividing curves"),
        "triangulate": translate("Tessera", "Triangulating"),
        "recover": translate("Tessera", "Recovering curves"),
        "color": translate("Tessera", "Removing the outside"),
        "refine": translate("Tessera", "Refining"),
        "optimize": translate("Tessera", "Optimizing"),
        "extract": translate("Tessera", "Collecting results"),
        "store": translate("Tessera", "Storing"),
    }
    return texts.get(stage, "")


def _fill_texts():
    """(value of the property, label, explanation) of each fill rule."""
    return (
        (
            "Even-odd",
            translate("Tessera", "Even-odd"),
            translate("Tessera", "Loops inside others are holes, loops inside holes are filled"),
        ),
        (
            "Nonzero",
            translate("Tessera", "Nonzero"),
            translate("Tessera", "Loops inside others are holes if they run the other way around"),
        ),
        (
            "Positive",
            translate("Tessera", "Positive"),
            translate("Tessera", "What more loops surround counter-clockwise than clockwise"),
        ),
        (
            "Negative",
            translate("Tessera", "Negative"),
            translate("Tessera", "What more loops surround clockwise than counter-clockwise"),
        ),
        ("All", translate("Tessera", "All"), translate("Tessera", "All that any curves enclose")),
        (
            "Hull",
            translate("Tessera", "Hull"),
            translate("Tessera", "The convex hull of everything"),
        ),
    )
