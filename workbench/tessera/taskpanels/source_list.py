# SPDX-License-Identifier: MIT
"""A list of sources in a form, with buttons that add what is selected and remove what is marked."""

from tessera.tools import cells, forms
from tessera.tools.selection import selected_sources


class SourceList:
    """The widgets {stem}List, {stem}Add and {stem}Remove of a form; changed() is called when the user
    has changed the list."""

    def __init__(self, form, stem, changed):
        self.links = []
        self._labels = []
        self._changed = changed
        self._list = getattr(form, f"{stem}List")
        forms.connect(getattr(form, f"{stem}Add"), "clicked()", self._add)
        forms.connect(getattr(form, f"{stem}Remove"), "clicked()", self._remove)

    def set(self, links):
        """links: [(object, names of faces)]; those of one object are joined."""
        joined = {}
        for owner, names in links:
            joined.setdefault(owner, []).extend(name for name in names if name)
        self.links = [(owner, tuple(dict.fromkeys(names))) for owner, names in joined.items()]
        self._labels = [cells.label_of(item) for item in self.items()]
        self._list.clear()
        self._list.addItems(self._labels)

    def values(self):
        """As a property takes them."""
        return [(owner, list(names) or [""]) for owner, names in self.links]

    def items(self):
        return cells.items_of(self.links)

    def drop_deleted(self):
        """Takes what is no longer in the document out of the list; gives its labels."""
        gone = [
            label for (owner, _), label in zip(self.links, self._labels) if is_deleted(owner)
        ]
        if gone:
            self.set([link for link in self.links if not is_deleted(link[0])])
        return gone

    def _add(self):
        self.drop_deleted()
        self.set([*self.links, *selected_sources()])
        self._changed()

    def _remove(self):
        rows = {index.row() for index in self._list.selectedIndexes()}
        kept = [link for row, link in enumerate(self.links) if row not in rows]
        self.set([link for link in kept if not is_deleted(link[0])])
        self._changed()


def is_deleted(obj):
    """The document object is no longer in its document."""
    try:
        return obj.Document is None
    except ReferenceError:
        return True
