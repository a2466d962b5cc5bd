# SPDX-License-Identifier: MIT
"""The task panel of planar meshes: makes new ones of sketches and edits those that exist.

Nothing enters the document before there is a mesh. All that the panel does to the document is one
step of undo: OK ends it, Cancel takes it back.
"""

from dataclasses import replace

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

import tessera
from tessera.objects import planar_mesh
from tessera.taskpanels.sizes import SizesForm
from tessera.taskpanels.task_panel import TaskPanel
from tessera.tools import forms, resources
from tessera.tools.mesh_job import MeshJob
from tessera.tools.number_field import NumberField
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


class PlanarMeshPanel(TaskPanel):
    """Task panel in FreeCAD's sense: form, accept, reject, getStandardButtons."""

    def __init__(self, targets):
        self._main = forms.load("planar_mesh")
        self._document = targets[0].document
        self._document_name = self._document.Name
        self._targets = targets
        self._edited = targets[0].object()
        self._sizes = SizesForm(targets)
        self._sizes.said.connect(self._say)
        self.form = [self._main, self._sizes.form]  # each in a box of its own, which can be closed
        self._size = NumberField(self._main.sizeField)
        self._weld = NumberField(self._main.weldField)
        self._growth = NumberField(self._main.growthField, is_length=False)
        self._roles = {}  # (object's name, edge): (object, role), in the order of adding
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
        form = self._main
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
        form.countField.setValue(request.count)
        form.freezeField.setChecked(request.freeze_boundary)
        self._weld.set(request.weld)
        self._growth.set(request.growth)
        form.orderField.setCurrentIndex(request.order - 1)
        form.fillField.setCurrentIndex(form.fillField.findData(request.fill))
        for role, label, explanation in _role_texts():
            form.roleField.addItem(label, role)
            last = form.roleField.count() - 1
            form.roleField.setItemData(last, explanation, QtCore.Qt.ToolTipRole)
            for owner, names in getattr(request, role):
                self._roles.update({(owner.Name, name): (owner, role) for name in names})
        form.constructionField.setChecked(request.construction)
        self._list_roles()
        self._sizes.set(request)
        self._show_running(False)
        if self._edited is not None and self._edited.Triangles > 0:
            self._show_summary([self._edited])
        else:
            self._show_message("")

    def _connect(self):
        form = self._main
        forms.connect(form.meshButton, "clicked()", self.start)
        forms.connect(form.stopButton, "clicked()", self.stop)
        forms.connect(form.addButton, "clicked()", self._add_roles)
        forms.connect(form.removeButton, "clicked()", self._remove_roles)
        forms.connect(form.countField, "valueChanged(int)", self._enable_size)

    def _enable_size(self, count):
        """A number of triangles decides instead of the size."""
        self._main.sizeField.setEnabled(count == 0)

    def _source_text(self):
        names = []
        for target in self._targets:
            label = target.source.Label if target.source else translate("Tessera", "none")
            names.append(f"{label}: {', '.join(target.faces)}" if target.faces else label)
        return ", ".join(names)

    def _add_roles(self):
        sources = {target.source.Name for target in self._targets if target.source}
        role = self._main.roleField.itemData(self._main.roleField.currentIndex())
        refused = []
        for owner, names in selected_edges():
            if owner.Name not in sources and role != "constraints":
                refused.append(owner.Label)
                continue
            for name in names:
                if name or owner.Name not in sources:
                    self._roles.pop((owner.Name, name), None)
                    self._roles[(owner.Name, name)] = (owner, role)
        self._list_roles()
        if refused:
            text = translate("Tessera", "{} is not what is meshed: its edges can be constraints only.")
            self._say(text.format(", ".join(refused)))

    def _remove_roles(self):
        rows = {index.row() for index in self._main.constraintList.selectedIndexes()}
        keys = list(self._roles)
        for row in rows:
            del self._roles[keys[row]]
        self._list_roles()

    def _list_roles(self):
        labels = {role: label for role, label, _ in _role_texts()}
        self._main.constraintList.clear()
        for (_, name), (owner, role) in self._roles.items():
            edge = f"{owner.Label}: {name}" if name else owner.Label
            self._main.constraintList.addItem(f"{edge} ({labels[role]})")
        self._main.constraintList.setVisible(bool(self._roles))
        self._main.removeButton.setEnabled(bool(self._roles))

    def _links(self, role, source):
        """Edges with the role, of one of several sources only."""
        links = {}
        for (_, name), (owner, given) in self._roles.items():
            if given == role and (len(self._targets) == 1 or owner is source):
                links.setdefault(owner, []).append(name)
        return tuple((owner, tuple(names)) for owner, names in links.items())

    def requests(self):
        """What the form asks for, one request for each target."""
        return [self._request(target) for target in self._targets]

    def _request(self, target):
        values = self._sizes.values()
        if len(self._targets) > 1:
            values = self._sizes.of_source(values, target.source)
        return replace(  # what has no field stays as it is
            self._shown,
            source=target.source,
            faces=tuple(target.faces),
            size=self._size.get(),
            count=self._main.countField.value(),
            freeze_boundary=self._main.freezeField.isChecked(),
            weld=self._weld.get(),
            growth=self._growth.get(),
            order=self._main.orderField.currentIndex() + 1,
            fill=self._main.fillField.itemData(self._main.fillField.currentIndex()),
            constraints=self._links("constraints", target.source),
            boundaries=self._links("boundaries", target.source),
            ignored=self._links("ignored", target.source),
            construction=self._main.constructionField.isChecked(),
            **values,
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
        self._main.progressBar.setValue(int(1000 * fraction))
        self._main.progressBar.setFormat(f"{_stage_text(stage)} %p%")

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
        self._main.stopButton.setEnabled(False)
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

    def _say(self, text):
        self._show_message(text, _INFORMATION)

    def _show_running(self, running):
        form = self._main
        form.meshButton.setVisible(not running)
        form.progressBar.setVisible(running)
        form.progressBar.setValue(0)
        form.stopButton.setVisible(running)
        form.stopButton.setEnabled(True)
        for widget in (
            form.countField,
            form.growthField,
            form.orderField,
            form.fillField,
            form.weldField,
            form.freezeField,
            form.constraintsBox,
            self._sizes.form,
        ):
            widget.setEnabled(not running)
        form.sizeField.setEnabled(not running and form.countField.value() == 0)

    def _show_message(self, text, kind=None):
        icon = QtGui.QPixmap()
        if kind is not None:
            icon = self._main.style().standardIcon(kind).pixmap(16, 16)
        self._main.messageIcon.setPixmap(icon)
        self._main.messageIcon.setVisible(bool(text))
        self._main.message.setText(text)
        self._main.message.setVisible(bool(text))

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


def _role_texts():
    """(field of a request, label, explanation) of each role."""
    return (
        (
            "constraints",
            translate("Tessera", "Constraint"),
            translate("Tessera", "Kept in the mesh, but does not bound what is meshed"),
        ),
        (
            "boundaries",
            translate("Tessera", "Boundary"),
            translate("Tessera", "Bounds what is meshed"),
        ),
        ("ignored", translate("Tessera", "Ignored"), translate("Tessera", "Left out")),
    )


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
