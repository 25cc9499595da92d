"""Provides bodies."""

from __future__ import annotations

import ctypes
from ctypes import byref, c_int64
from typing import TYPE_CHECKING

from . import _api
from ._arrays import VOLUME_TYPES, elements, flat, integer_list, nodes, reals, room, vector
from ._library import Handle, c_path, c_text, call, check, lib
from ._plain import BodyPlain
from ._settings import Settings

if TYPE_CHECKING:
    import os

    import numpy as np
    from numpy.typing import ArrayLike

    from .context import Context


class Body(Settings, BodyPlain, Handle):
    """Represents a body of a kind: BODY_FEM, BODY_BEM, BODY_HALFSPACE or BODY_RIGID ("fem", ...)."""

    _kind = "body"

    def __init__(self, context, kind):
        made = ctypes.c_void_p()
        check(call(lib.rollcon_body_create, context.handle, kind, byref(made)))
        super().__init__(made.value, context)

    @classmethod
    def load(cls, context: Context, path: str | os.PathLike) -> Body:
        """Loads a prepared body from a file that save() wrote: nothing is assembled or factorised."""
        made = ctypes.c_void_p()
        check(call(lib.rollcon_body_load, context.handle, c_path(path), byref(made)))
        body = cls.__new__(cls)
        Handle.__init__(body, made.value, context)
        return body

    def copy(self) -> Body:
        """Returns another body that was given the same, not prepared. With other loads alone it takes the equations
        of this one and their factors when it is prepared: a load case."""
        made = ctypes.c_void_p()
        self._call("copy", byref(made))
        body = type(self).__new__(type(self))
        Handle.__init__(body, made.value, self._context)
        return body

    # -------------------------------------------------------------- mesh, supports and loads

    def set_nodes(self, x: ArrayLike) -> None:
        """Gives nodes x[n, 3] of the surface or, for finite elements, of the volume; forgets elements, tags,
        supports, loads and contact faces."""
        x, layout = nodes(x)
        self._call("set_nodes", *layout)

    def add_elements(self, element_type: int | str, connectivity: ArrayLike, tag: int | None = None,
                     index_base: int = 0) -> None:
        """Adds elements of one type, connectivity[n, nodes per element]. Surface elements (TRI3 or "tri3", ...),
        normals outwards, have tag 1 if None. Finite elements take volume elements (TET4, ...), whose tag (0 if None)
        names their material, and surface elements, which give their tag to the boundary faces with the same nodes."""
        element_type, ids, address = elements(element_type, connectivity)
        if tag is None:
            tag = 0 if element_type in VOLUME_TYPES else 1
        self._call("add_elements", element_type, len(ids), address, index_base, tag)

    def tag_faces(self, element_numbers: ArrayLike, faces: ArrayLike, tag: int, index_base: int = 0) -> None:
        """Tags boundary faces of finite elements: faces[i] of volume element element_numbers[i],
        in the order in which they were added. Faces that no call names have tag 0; later calls
        win."""
        numbers, at = integer_list(element_numbers, "element numbers")
        faces, address = integer_list(faces, "faces")
        if len(faces) != len(numbers):
            raise ValueError(f"{len(faces)} faces for {len(numbers)} elements")
        self._call("tag_faces", len(numbers), at, address, index_base, tag)

    def tag_faces_of_nodes(self, ids: ArrayLike, tag: int, index_base: int = 0) -> None:
        """Tags the faces all of whose nodes are given: boundary faces of finite elements, or the
        surface elements added so far."""
        ids, address = integer_list(ids, "node ids")
        self._call("tag_faces_of_nodes", len(ids), address, index_base, tag)

    def set_support(self, ids: ArrayLike, dof_mask: int | str = _api.DOF_XYZ, values: ArrayLike | None = None,
                    index_base: int = 0) -> None:
        """Holds displacement components (a sum of DOF_X, DOF_Y, DOF_Z) of nodes, at zero or at
        values[n, 3]."""
        ids, address = integer_list(ids, "node ids")
        at = None
        if values is not None:
            values, at = reals(values, 3)
            if len(values) != len(ids):
                raise ValueError(f"{len(values)} values for {len(ids)} nodes")
        self._call("set_support", len(ids), address, index_base, dof_mask, at)

    def set_condensed(self, form: int | str, matrix: ArrayLike) -> None:
        """Gives a condensed body its "stiffness" or "flexibility", a square matrix with rows x, y, z of each node."""
        matrix, at = flat(matrix)
        self._call("set_condensed", form, matrix.size, at)

    def set_node_tractions(self, tag: int, ids: ArrayLike, tractions: ArrayLike, along: ArrayLike | None = None,
                           index_base: int = 0) -> None:
        """Gives tractions[n, 3] at nodes of the faces with a tag, linear or quadratic between them like the faces,
        added to the tag's traction and pressure. With a direction, along, they have components along its part in the
        surface, across, and along the outward normal; else x y z."""
        ids, address = integer_list(ids, "node ids")
        tractions, at = reals(tractions, 3)
        if len(tractions) != len(ids):
            raise ValueError(f"{len(tractions)} tractions for {len(ids)} nodes")
        direction, along_at = (None, None) if along is None else vector(along)
        self._call("set_node_tractions", tag, len(ids), address, index_base, along_at, at)

    @property
    def groups(self) -> list[str]:
        """Returns the names of what the mesh's file has names for, after read_mesh()."""
        return [self.group_name(i) for i in range(self.group_count())]

    def group_nodes(self, group: str, index_base: int = 0) -> np.ndarray:
        """Returns the nodes of all that a group of the mesh's file has, ascending, [n] of int32."""
        name, need = c_text(group, "group"), c_int64()
        self._call("get_group_nodes", name, index_base, 0, None, byref(need))
        nodes, address = room(need.value, dtype="int32")
        self._call("get_group_nodes", name, index_base, len(nodes), address, byref(need))
        return nodes

    # ------------------------------------------------------------------------------- results

    def displacements(self) -> np.ndarray:
        """Returns displacements [n, 3] of a prepared body under its own loads, with no contact acting."""
        u, address = room(self.size[0], 3)
        self._call("get_displacements", len(u), address)
        return u

    def _nodal(self, u):
        """Returns displacements of all nodes as an argument: number, array to hold, address; None: the body's own."""
        if u is None:
            return self.size[0], None, None
        u, address = reals(u, 3)
        return len(u), u, address

    def node_stresses(self, u: ArrayLike | None = None) -> np.ndarray:
        """Returns smoothed stresses [nodes, 6] (s11, s22, s33, s12, s13, s23) of finite elements under displacements
        u[nodes, 3], which Contact.body_displacements() returns; None: under the body's own loads, for boundary
        elements too."""
        nodes, u, given = self._nodal(u)
        stress, address = room(nodes, 6)
        self._call("get_node_stresses", nodes, given, address)
        return stress

    def point_stresses(self, u: ArrayLike | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Returns stresses [n, 6] at the integration points of all finite elements, and their places [n, 3]."""
        nodes, u, given = self._nodal(u)
        need = ctypes.c_int64()
        self._call("get_point_stresses", nodes, given, 0, None, None, byref(need))
        stress, first = room(need.value, 6)
        xyz, second = room(need.value, 3)
        self._call("get_point_stresses", nodes, given, need.value, first, second, byref(need))
        return stress, xyz

    def fields_at(self, xyz: ArrayLike, u: ArrayLike | None = None) -> tuple[np.ndarray, np.ndarray]:
        """Returns displacements [n, 3] and stresses [n, 6] at points xyz[n, 3] inside finite elements, or boundary
        elements under their own loads."""
        nodes, u, given = self._nodal(u)
        xyz, points = reals(xyz, 3)
        displacement, first = room(len(xyz), 3)
        stress, second = room(len(xyz), 6)
        self._call("get_fields_at", nodes, given, len(xyz), points, first, second)
        return displacement, stress

    def write(self, path: str | os.PathLike, u: ArrayLike | None = None) -> None:
        """Writes elements with displacements, smoothed stresses and von Mises's stress, as a VTU file."""
        nodes, u, given = self._nodal(u)
        self._call("write", c_path(path), nodes, given)

    def _about(self):
        kind = {1: "finite elements", 2: "boundary elements", 3: "half-space", 4: "rigid", 5: "section",
                6: "condensed"}.get(self.kind, "body")
        nodes, elements = self.size
        return f"{kind}, {nodes} nodes, {elements} elements" if nodes else kind

    def plot_profile(self, ax=None, **options):
        """Draws the body's profile; returns the axes of matplotlib. See rollcon.plots."""
        from . import plots
        return plots.profile(self, ax, **options)
