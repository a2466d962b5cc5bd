# SPDX-License-Identifier: MIT
"""How a planar mesh looks in the tree and in the 3D view, and how it is edited."""

from tessera.viewproviders.panel_opener import PanelOpener

#: Display mode with the edges of the triangles; named so by FreeCAD.
_FACES_AND_EDGES = "Faces & Wireframe"
_COLOR = (0.62, 0.83, 0.82)


class ViewProviderPlanarMesh(PanelOpener):
    """Proxy of the view object."""

    ICON = "tessera_planar_mesh"

    def __init__(self, view_object):
        super().__init__(view_object)
        view_object.DisplayMode = _FACES_AND_EDGES
        _paint(view_object)
        view_object.LineWidth = 1.0
        view_object.BackfaceCulling = False

    @staticmethod
    def panel(obj):
        from tessera.taskpanels.planar_mesh import PlanarMeshPanel, Target

        return PlanarMeshPanel([Target.of_object(obj)])


def _paint(view_object):
    """Matt: a shiny plane is white when seen from above."""
    if "ShapeAppearance" in view_object.PropertiesList:
        material = view_object.ShapeAppearance[0]
    else:  # before FreeCAD 1.0
        material = view_object.ShapeMaterial
    material.DiffuseColor = _COLOR
    material.SpecularColor = (0.0, 0.0, 0.0)
    if "ShapeAppearance" in view_object.PropertiesList:
        view_object.ShapeAppearance = (material,)
    else:
        view_object.ShapeMaterial = material
