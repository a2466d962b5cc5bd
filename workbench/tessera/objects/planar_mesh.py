# SPDX-License-Identifier: MIT
"""A finite-element mesh that follows a sketch or a planar shape.

The class path and the property names are stored in users' files: they never change.
"""

import FreeCAD

from tessera.meshing import NARROW_GAPS
from tessera.objects.size_properties import (
    SIZE_PROPERTIES,
    apply_local_sizes,
    links_of,
    links_to,
    local_sizes_of,
)
from tessera.shapes import container_placement
from tessera.tools import preferences
from tessera.tools.links import CONTAINER_PLACEMENTS, containers_moved, note_containers
from tessera.tools.mesh_history import MeshHistory
from tessera.tools.plain_errors import recomputing
from tessera.tools.progress import RecomputeProgress
from tessera.tools.request import FILLS, MeshRequest, default_size
from tessera.tools.stateless import Stateless

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

FEM_TYPE = "Fem::FemMeshObjectPython"

_NORMAL, _READ_ONLY, _HIDDEN = 0, 1, 1 | 4

# (name, type, group, description, default, attributes). A property that an older file lacks is
# added when the file is opened.
PROPERTIES = (
    (
        "Source",
        "App::PropertyLinkGlobal",
        "Mesh",
        QT_TRANSLATE_NOOP("App::Property", "Sketch or planar shape that is meshed"),
        None,
        _NORMAL,
    ),
    (
        "Faces",
        "App::PropertyLinkSubGlobal",
        "Mesh",
        QT_TRANSLATE_NOOP("App::Property", "Faces of Source that are meshed; none: all of it"),
        None,
        _NORMAL,
    ),
    (
        "Constraints",
        "App::PropertyLinkSubListGlobal",
        "Mesh",
        QT_TRANSLATE_NOOP(
            "App::Property", "Edges that are kept in the mesh but do not bound what is meshed"
        ),
        None,
        _NORMAL,
    ),
    (
        "Boundaries",
        "App::PropertyLinkSubListGlobal",
        "Mesh",
        QT_TRANSLATE_NOOP("App::Property", "Edges of Source that bound whatever they connect"),
        None,
        _NORMAL,
    ),
    (
        "Ignored",
        "App::PropertyLinkSubListGlobal",
        "Mesh",
        QT_TRANSLATE_NOOP("App::Property", "Edges of Source that are left out"),
        None,
        _NORMAL,
    ),
    (
        "Construction",
        "App::PropertyBool",
        "Mesh",
        QT_TRANSLATE_NOOP(
            "App::Property", "Construction geometry of the sketch is kept in the mesh too"
        ),
        None,
        _NORMAL,
    ),
    (
        "Size",
        "App::PropertyLength",
        "Mesh",
        QT_TRANSLATE_NOOP("App::Property", "Length of the mesh edges"),
        None,
        _NORMAL,
    ),
    (
        "Count",
        "App::PropertyIntegerConstraint",
        "Mesh",
        QT_TRANSLATE_NOOP(
            "App::Property", "Number of triangles to aim for, instead of Size; 0: Size decides"
        ),
        (0, 0, 100_000_000, 1000),
        _NORMAL,
    ),
    (
        "MaxArea",
        "App::PropertyArea",
        "Mesh",
        QT_TRANSLATE_NOOP("App::Property", "No triangle is larger than this; 0: no bound"),
        None,
        _NORMAL,
    ),
    (
        "FreezeBoundary",
        "App::PropertyBool",
        "Mesh",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Straight edges stay whole; curved ones are divided by size and curvature only",
        ),
        None,
        _NORMAL,
    ),
    (
        "NarrowGaps",
        "App::PropertyFloatConstraint",
        "Mesh",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Triangles that may be spent on gaps far narrower than the size, as a multiple of the"
            " others; 0: such gaps are left coarse",
        ),
        (NARROW_GAPS, 0.0, 1e6, 1.0),
        _NORMAL,
    ),
    (
        "GrowthRate",
        "App::PropertyFloatConstraint",
        "Mesh",
        QT_TRANSLATE_NOOP(
            "App::Property", "Greatest change of the edge length per length, from 0.01 to 1"
        ),
        (0.3, 0.01, 1.0, 0.05),
        _NORMAL,
    ),
    (
        "ElementOrder",
        "App::PropertyIntegerConstraint",
        "Mesh",
        QT_TRANSLATE_NOOP(
            "App::Property", "1: triangles with 3 nodes; 2: with 6 nodes, curved edges followed"
        ),
        (1, 1, 2, 1),
        _NORMAL,
    ),
    (
        "Fill",
        "App::PropertyEnumeration",
        "Mesh",
        QT_TRANSLATE_NOOP("App::Property", "Which parts between the curves are meshed"),
        list(FILLS),
        _NORMAL,
    ),
    (
        "Weld",
        "App::PropertyLength",
        "Mesh",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Ends of curves closer than this become one; 0: the tolerance of the source",
        ),
        None,
        _NORMAL,
    ),
    *SIZE_PROPERTIES,
    (
        "Triangles",
        "App::PropertyInteger",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Number of triangles"),
        None,
        _READ_ONLY,
    ),
    (
        "Area",
        "App::PropertyArea",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Area of all triangles"),
        None,
        _READ_ONLY,
    ),
    (
        "MinAngle",
        "App::PropertyAngle",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Smallest angle of any triangle"),
        None,
        _READ_ONLY,
    ),
    (
        "MeanQuality",
        "App::PropertyFloat",
        "Result",
        QT_TRANSLATE_NOOP(
            "App::Property", "Mean quality of the triangles; 1: all of them equilateral"
        ),
        None,
        _READ_ONLY,
    ),
    (
        "Regions",
        "App::PropertyInteger",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Number of connected parts, separated by boundaries"),
        None,
        _READ_ONLY,
    ),
    (
        "Crossings",
        "App::PropertyInteger",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Number of points where curves cross"),
        None,
        _READ_ONLY,
    ),
    (
        "Messages",
        "App::PropertyStringList",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "What the mesher has to say about the source"),
        None,
        _READ_ONLY,
    ),
    CONTAINER_PLACEMENTS,
    (
        "MeshRevision",
        "App::PropertyInteger",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Changes whenever the mesh does"),
        None,
        _HIDDEN,
    ),
)


class PlanarMesh(Stateless):
    """Proxy of the document object."""

    Type = "Tessera::PlanarMesh"

    def __init__(self, obj):
        self._offered = None
        obj.Proxy = self
        add_properties(obj)

    @property
    def history(self):
        """The meshes that undo and redo may need."""
        return self.__dict__.setdefault("_history", MeshHistory())

    def offer(self, request, mesh):
        """A finished mesh that the next recompute takes if the properties still ask for it."""
        self._offered = (request, mesh)

    def mustExecute(self, obj):
        """Asked by FreeCAD at every recompute: moving the part that contains the source, or curves
        that are kept, does not touch them."""
        return containers_moved(obj)

    @property
    def execute(self):
        """Called by FreeCAD, with the object, to recompute; after an error its mesh stays."""
        return recomputing(self._recompute)

    def _recompute(self, obj):
        request = request_of(obj)
        offered, self._offered = self.__dict__.get("_offered"), None
        if offered is not None and offered[0] == request:
            mesh = offered[1]
        else:
            mesh = self._mesh(obj, request)
        self._publish(obj, request, mesh)

    def _mesh(self, obj, request):
        with RecomputeProgress(translate("Tessera", "Meshing {}").format(obj.Label)) as progress:
            return request.mesh(request.prepare(), progress, threads=preferences.threads())

    def _publish(self, obj, request, mesh):
        fem = mesh.to_fem()
        note_containers(obj)
        container = container_placement(request.source)
        if not container.isIdentity():
            fem.transformGeometry(container.toMatrix())
        if obj.MeshRevision not in self.history:
            self.history.remember(obj.MeshRevision, obj.FemMesh.copy())
        revision = self.history.next_revision(obj.MeshRevision)
        self.history.remember(revision, fem)
        obj.MeshRevision = revision  # onChanged assigns the mesh

        report = mesh.report
        obj.Triangles = report["triangles"]
        obj.Area = report["area"]
        obj.MinAngle = report["min_angle_deg"]
        obj.MeanQuality = report["mean_quality"]
        obj.Regions = report["regions"]
        obj.Crossings = report["crossings"]
        obj.Messages = report["messages"] + _size_found(report)

    def onChanged(self, obj, name):
        """Called by FreeCAD after each change of a property, also by undo and redo."""
        if obj.Document.Restoring:
            return
        if name == "MeshRevision":
            # FreeCAD's own undo of a FemMesh does nothing: old and new share their data.
            fem = self.history.get(obj.MeshRevision)
            if fem is not None:
                obj.FemMesh = fem
            elif obj.MeshRevision > 0:
                obj.touch()
        elif name in ("Source", "Faces") and hasattr(obj, "Size") and obj.Size.Value == 0.0:
            obj.Size = default_size(obj.Source, faces_of(obj))

    def onDocumentRestored(self, obj):
        add_properties(obj)
        if FreeCAD.GuiUp and obj.ViewObject is not None and obj.ViewObject.Proxy is None:
            # The file was written without a window.
            from tessera.viewproviders.planar_mesh import ViewProviderPlanarMesh

            ViewProviderPlanarMesh(obj.ViewObject)


def add_properties(obj):
    """Adds the properties that are missing."""
    known = set(obj.PropertiesList)
    for name, kind, group, description, default, attributes in PROPERTIES:
        if name not in known:
            obj.addProperty(kind, name, group, description, attributes)
            if default is not None:
                setattr(obj, name, default)


def faces_of(obj):
    """Names of the faces of the source that are meshed; none: all of it."""
    link = getattr(obj, "Faces", None)
    if not link or link[0] is not obj.Source:
        return ()
    return tuple(name for name in link[1] if name)


def request_of(obj):
    """What the object's properties ask for."""
    return MeshRequest(
        source=obj.Source,
        faces=faces_of(obj),
        size=obj.Size.Value,
        count=obj.Count,
        max_area=obj.MaxArea.Value,
        freeze_boundary=obj.FreezeBoundary,
        narrow_gaps=obj.NarrowGaps,
        growth=obj.GrowthRate,
        order=obj.ElementOrder,
        fill=obj.Fill,
        weld=obj.Weld.Value,
        constraints=links_of(obj.Constraints),
        boundaries=links_of(obj.Boundaries),
        ignored=links_of(obj.Ignored),
        construction=obj.Construction,
        min_size=obj.MinSize.Value,
        curvature=obj.Curvature,
        chord_error=obj.ChordError.Value,
        gap=obj.GapElements,
        local_sizes=local_sizes_of(obj),
        expression=obj.SizeExpression,
        size_file=obj.SizeFile,
        size_array=obj.SizeArray,
    )


def _size_found(report):
    """Which size gives the number of triangles that was asked for: a line, or none."""
    if "count" not in report:
        return []
    size = FreeCAD.Units.Quantity(report["count"]["size"], FreeCAD.Units.Length).UserString
    return [translate("Tessera", "The size found is {}.").format(size)]


def apply_request(obj, request):
    """Sets the object's properties, as far as they differ: a property that is set counts as
    changed."""
    values = {
        "Source": request.source,
        "Faces": (request.source, list(request.faces)) if request.faces else None,
        "Size": request.size,
        "Count": request.count,
        "MaxArea": request.max_area,
        "FreezeBoundary": request.freeze_boundary,
        "NarrowGaps": request.narrow_gaps,
        "GrowthRate": request.growth,
        "ElementOrder": request.order,
        "Fill": request.fill,
        "Weld": request.weld,
        "Constraints": links_to(request.constraints),
        "Boundaries": links_to(request.boundaries),
        "Ignored": links_to(request.ignored),
        "Construction": request.construction,
        "MinSize": request.min_size,
        "Curvature": request.curvature,
        "ChordError": request.chord_error,
        "GapElements": request.gap,
        "SizeExpression": request.expression,
        "SizeFile": request.size_file,
        "SizeArray": request.size_array,
    }
    current = request_of(obj)
    same = {
        "Source": current.source is request.source,
        "Faces": current.faces == request.faces,
        "Size": current.size == request.size,
        "Count": current.count == request.count,
        "MaxArea": current.max_area == request.max_area,
        "FreezeBoundary": current.freeze_boundary == request.freeze_boundary,
        "NarrowGaps": current.narrow_gaps == request.narrow_gaps,
        "GrowthRate": current.growth == request.growth,
        "ElementOrder": current.order == request.order,
        "Fill": current.fill == request.fill,
        "Weld": current.weld == request.weld,
        "Constraints": current.constraints == request.constraints,
        "Boundaries": current.boundaries == request.boundaries,
        "Ignored": current.ignored == request.ignored,
        "Construction": current.construction == request.construction,
        "MinSize": current.min_size == request.min_size,
        "Curvature": current.curvature == request.curvature,
        "ChordError": current.chord_error == request.chord_error,
        "GapElements": current.gap == request.gap,
        "SizeExpression": current.expression == request.expression,
        "SizeFile": current.size_file == request.size_file,
        "SizeArray": current.size_array == request.size_array,
    }
    for name, value in values.items():
        if not same[name]:
            setattr(obj, name, value)
    apply_local_sizes(obj, request.local_sizes)


def is_planar_mesh(obj):
    return isinstance(getattr(obj, "Proxy", None), PlanarMesh)


def make(request, analysis=None):
    """A new document object beside the source, touched; recompute it to mesh. It joins the analysis
    if one is given."""
    import Fem  # noqa: F401  (makes FreeCAD know the type)

    obj = request.source.Document.addObject(FEM_TYPE, "PlanarMesh")
    obj.Label = translate("Tessera", "{} mesh").format(request.source.Label)
    PlanarMesh(obj)
    apply_request(obj, request)
    if FreeCAD.GuiUp:
        from tessera.viewproviders.planar_mesh import ViewProviderPlanarMesh

        ViewProviderPlanarMesh(obj.ViewObject)
    if analysis is not None:
        analysis.addObject(obj)
    return obj


def make_planar_mesh(source, analysis=None, **options):
    """For macros: a mesh object of a sketch or a planar shape; options as MeshRequest has them.
    Call the document's recompute() to mesh."""
    options.setdefault("size", default_size(source, options.get("faces", ())))
    return make(MeshRequest(source, **options), analysis)
