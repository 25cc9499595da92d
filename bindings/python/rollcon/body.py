"""Bodies."""

import ctypes
import os
from ctypes import byref, c_double, c_int64

from . import _api
from ._arrays import VOLUME_TYPES, elements, integers, nodes, reals, room, vector
from ._library import Handle, call, check, lib
from ._settings import Settings


def _list(values, what):
    array, address = integers(values, what)
    if array.ndim != 1:
        raise ValueError(f"expected {what} of one dimension, got shape {array.shape}")
    return array, address


class Body(Settings, Handle):
    """A body of a kind: BODY_FEM, BODY_BEM, BODY_HALFSPACE or BODY_RIGID."""

    _kind = "body"

    def __init__(self, context, kind):
        made = ctypes.c_void_p()
        check(call(lib.rollcon_body_create, context.handle, kind, byref(made)), context)
        super().__init__(made.value, context)

    @classmethod
    def load(cls, context, path):
        """A prepared body from a file that save() wrote: nothing is assembled or factorised."""
        made = ctypes.c_void_p()
        check(call(lib.rollcon_body_load, context.handle, os.fsencode(path), byref(made)), context)
        body = cls.__new__(cls)
        Handle.__init__(body, made.value, context)
        return body

    def set_elastic(self, young, poisson, tag=0):
        """Young's modulus > 0 and Poisson's ratio in (-1, 0.5]: of the finite elements with this
        tag, or of the whole body."""
        self._call("set_elastic", tag, young, poisson)

    # -------------------------------------------------------------- mesh, supports and loads

    def set_nodes(self, x):
        """Nodes x[n, 3] of the surface or, of finite elements, of the volume; forgets elements,
        tags, supports, loads and contact faces."""
        x, layout = nodes(x)
        self._call("set_nodes", *layout)

    def add_elements(self, element_type, connectivity, tag=None, index_base=0):
        """Elements of one type, connectivity[n, nodes per element]. Surface elements (TRI3, ...),
        normals outwards: tag 1 if None. Finite elements take volume elements (TET4, ...), whose
        tag (0 if None) names their material, and surface elements, which give their tag to the
        boundary faces with the same nodes."""
        if tag is None:
            tag = 0 if element_type in VOLUME_TYPES else 1
        ids, address = elements(element_type, connectivity)
        self._call("add_elements", element_type, len(ids), address, index_base, tag)

    def tag_faces(self, element_numbers, faces, tag, index_base=0):
        """Tags boundary faces of finite elements: faces[i] of volume element element_numbers[i],
        in the order in which they were added. Faces that no call names have tag 0; later calls
        win."""
        numbers, at = _list(element_numbers, "element numbers")
        faces, address = _list(faces, "faces")
        if len(faces) != len(numbers):
            raise ValueError(f"{len(faces)} faces for {len(numbers)} elements")
        self._call("tag_faces", len(numbers), at, address, index_base, tag)

    def tag_faces_of_nodes(self, ids, tag, index_base=0):
        """Tags the faces all of whose nodes are given: boundary faces of finite elements, or the
        surface elements added so far."""
        ids, address = _list(ids, "node ids")
        self._call("tag_faces_of_nodes", len(ids), address, index_base, tag)

    def set_support(self, ids, dof_mask=_api.DOF_XYZ, values=None, index_base=0):
        """Holds displacement components (a sum of DOF_X, DOF_Y, DOF_Z) of nodes, at zero or at
        values[n, 3]."""
        ids, address = _list(ids, "node ids")
        at = None
        if values is not None:
            values, at = reals(values, 3)
            if len(values) != len(ids):
                raise ValueError(f"{len(values)} values for {len(ids)} nodes")
        self._call("set_support", len(ids), address, index_base, dof_mask, at)

    def set_traction(self, tag, traction):
        """Traction (x, y, z) on the faces with a tag."""
        t, address = vector(traction)
        self._call("set_traction", tag, address)

    def set_pressure(self, tag, pressure):
        """Pressure against the outward normals of the faces with a tag."""
        self._call("set_pressure", tag, pressure)

    def set_contact_faces(self, tags):
        """Tags of the faces that may come into contact; none: all neither held nor loaded."""
        tags, address = integers(tags, "tags")
        self._call("set_contact_faces", tags.size, address)

    def prepare(self):
        """Checks that the body is complete, factorises its equations and freezes it; a solve does
        it if nobody did."""
        self._call("prepare")

    def save(self, path):
        """Writes the body, prepared if it was not, to a file; Body.load makes it again."""
        self._call("save", os.fsencode(path))

    # ------------------------------------------------------------------------------- results

    @property
    def kind(self):
        value = ctypes.c_int32()
        self._call("get_kind", byref(value))
        return value.value

    @property
    def size(self):
        """(nodes, elements) of the mesh."""
        n, m = c_int64(), c_int64()
        self._call("get_size", byref(n), byref(m))
        return n.value, m.value

    def displacements(self):
        """Displacements [n, 3] of a prepared body under its own loads, no contact acting."""
        u, address = room(self.size[0], 3)
        self._call("get_displacements", len(u), address)
        return u

    def reaction(self):
        """(force, moment about the origin) of the supports on a prepared body."""
        (force, pf), (moment, pm) = room(3), room(3)
        self._call("get_reaction", pf, pm)
        return force, moment

    def stat(self, name):
        """A number about a prepared body; body_stat_names() lists them."""
        value = c_double()
        self._call("get_stat", name.encode(), byref(value))
        return value.value
