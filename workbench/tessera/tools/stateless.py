# SPDX-License-Identifier: MIT
"""Proxies without a state of their own."""


class Stateless:
    """Base of proxies of document and view objects: nothing of them is saved, all that lasts stands
    in properties. FreeCAD makes restored proxies without calling __init__, so nothing may rely on
    it."""

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps  # FreeCAD before 1.0
    __setstate__ = loads
