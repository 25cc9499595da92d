"""Turns numpy arrays into the library's arguments, and back."""

from ctypes import POINTER, c_double, c_int32

import numpy as np

from . import _api
from ._library import enumerator

_NODES = {_api.TRI3: 3, _api.TRI6: 6, _api.QUAD4: 4, _api.QUAD8: 8, _api.QUAD9: 9,
          _api.TET4: 4, _api.TET10: 10, _api.WEDGE6: 6, _api.WEDGE15: 15, _api.HEX8: 8,
          _api.HEX20: 20}
VOLUME_TYPES = (_api.TET4, _api.TET10, _api.WEDGE6, _api.WEDGE15, _api.HEX8, _api.HEX20)


def reals(values, columns=None):
    """Returns a contiguous float64 array and its address; makes a copy only where the argument is not one."""
    array = np.ascontiguousarray(values, dtype=np.float64)
    if columns is not None and (array.ndim != 2 or array.shape[1] != columns):
        raise ValueError(f"expected an array of shape (n, {columns}), got {array.shape}")
    if columns is None and array.ndim != 1:
        raise ValueError(f"expected an array of one dimension, got shape {array.shape}")
    return array, array.ctypes.data_as(POINTER(c_double))


def vector(values, size=3):
    array, address = reals(values)
    if array.size != size:
        raise ValueError(f"expected {size} components, got {array.size}")
    return array, address


def flat(values):
    """Returns reals() of all numbers of an array, row by row."""
    return reals(np.ravel(values))


def integers(values, what):
    """Returns a contiguous int32 array of one dimension or two, and its address."""
    array = np.asarray(values)
    if array.size == 0:
        array = array.astype(np.int32)
    if not np.issubdtype(array.dtype, np.integer):
        raise ValueError(f"{what} must be integers")
    if array.size and not -2**31 <= array.min() <= array.max() < 2**31:
        raise ValueError(f"{what} must fit 32 bits")
    array = np.ascontiguousarray(array, dtype=np.int32)
    return array, array.ctypes.data_as(POINTER(c_int32))


def nodes(x):
    """Returns coordinates x[n, 3] (or x[n, 2]: z = 0) and what the library is told of them: number, address and
    strides in doubles. Positive strides pass without a copy."""
    x = np.require(x, np.float64, "A")
    if x.ndim == 2 and x.shape[1] == 2:
        x = np.column_stack([x, np.zeros(len(x))])
    if x.ndim != 2 or x.shape[1] != 3:
        raise ValueError(f"expected an array of shape (n, 3), got {x.shape}")
    if any(s <= 0 or s % x.itemsize for s in x.strides):
        x = np.ascontiguousarray(x).copy()
    return x, (x.shape[0], x.ctypes.data_as(POINTER(c_double)), x.strides[0] // x.itemsize,
               x.strides[1] // x.itemsize)


def integer_list(values, what):
    """Returns integers() of one dimension."""
    array, address = integers(values, what)
    if array.ndim != 1:
        raise ValueError(f"expected {what} of one dimension, got shape {array.shape}")
    return array, address


def elements(element_type, connectivity):
    """Returns the number of the type, node ids connectivity[n, nodes per element] and their address."""
    element_type = enumerator(element_type, "element type", "element_type")
    array, address = integers(connectivity, "node ids")
    if array.ndim != 2 or array.shape[1] != _NODES.get(element_type, array.shape[1]):
        raise ValueError(f"connectivity of shape {array.shape} does not fit the element type")
    return element_type, array, address


def room(*shape, dtype=np.float64):
    array = np.zeros(shape, dtype=dtype)
    c_type = c_double if dtype is np.float64 else c_int32
    return array, array.ctypes.data_as(POINTER(c_type))
