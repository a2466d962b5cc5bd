# SPDX-License-Identifier: MIT
"""What FreeCAD asks of all task panels."""

from PySide import QtGui


class TaskPanel:
    """Base of the panels: OK and Cancel, while the user goes on in the 3D view and the tree. A
    subclass has form, accept() and reject()."""

    def getStandardButtons(self):
        return int(QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel)

    def isAllowedAlterSelection(self):
        return True

    def isAllowedAlterView(self):
        return True

    def isAllowedAlterDocument(self):
        return True
