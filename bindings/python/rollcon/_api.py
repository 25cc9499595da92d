# Generated from bindings/api.toml by bindings/generate.py; do not edit.
"""The C interface of rollcon 0.1.0 for ctypes: enumerators, callback types, prototypes.

Handles are c_void_p, arrays are pointers; None passes NULL.
"""

from ctypes import CFUNCTYPE, POINTER, c_char_p, c_double, c_int32, c_int64, c_void_p

VERSION = (0, 1, 0)
ABI = 1

# status
OK = 0
NOT_CONVERGED = 1
NO_CONTACT = 2
CANCELLED = 3
RIM_CONTACT = 4
COARSE = 5
ERR_ARGUMENT = -1
ERR_HANDLE = -2
ERR_NONFINITE = -3
ERR_MESH = -4
ERR_STATE = -5
ERR_OPTION = -6
ERR_CAPACITY = -7
ERR_SINGULAR = -8
ERR_MEMORY = -9
ERR_UNSUPPORTED = -10
ERR_BUSY = -11
ERR_LOAD = -12
ERR_IO = -13
ERR_INTERNAL = -99

# body kind
BODY_FEM = 1
BODY_BEM = 2
BODY_HALFSPACE = 3
BODY_RIGID = 4

# element type
TRI3 = 203
TRI6 = 206
QUAD4 = 214
QUAD8 = 218
QUAD9 = 219
TET4 = 304
TET10 = 310
WEDGE6 = 326
WEDGE15 = 335
HEX8 = 338
HEX20 = 350

# dof
DOF_X = 1
DOF_Y = 2
DOF_Z = 4
DOF_XYZ = 7

# direction
LONGITUDINAL = 1
LATERAL = 2
NORMAL = 3
SPIN = 4

# parameter
FRICTION = 5

# how
BY_MOTION = 1
BY_FORCE = 2

# axes
LOCAL = 0
GLOBAL = 1

# field
FIELD_POINT = 1
FIELD_TRACTION = 2
FIELD_GAP = 3
FIELD_SLIP = 4
FIELD_DISPLACEMENT1 = 5
FIELD_DISPLACEMENT2 = 6
FIELD_AREA = 7
FIELD_FRICTION = 8
FIELD_PRESSURE = 9
FIELD_RIGID_SLIP = 10
FIELD_FRICTION_POWER = 11
FIELD_WEIGHT = 12

# node status
OPEN = 0
STICK = 1
SLIP = 2
EXCLUDED = 3

# log level
LOG_ERROR = 1
LOG_WARNING = 2
LOG_INFO = 3
LOG_DEBUG = 4

# option type
TYPE_INT = 1
TYPE_REAL = 2
TYPE_STR = 3

# event key
EVENT_PHASE = 1
EVENT_ITERATION = 2
EVENT_RESIDUAL = 101
EVENT_SECONDS = 102

# phase
PHASE_COMPLIANCE = 1
PHASE_NORMAL = 2
PHASE_TANGENTIAL = 3
PHASE_FULL = 4
PHASE_CASES = 5

log_fn = CFUNCTYPE(None, c_int32, c_char_p, c_void_p)
progress_fn = CFUNCTYPE(c_int32, c_void_p, c_void_p)

STATUS_NAMES = {
    0: "OK",
    1: "NOT_CONVERGED",
    2: "NO_CONTACT",
    3: "CANCELLED",
    4: "RIM_CONTACT",
    5: "COARSE",
    -1: "ERR_ARGUMENT",
    -2: "ERR_HANDLE",
    -3: "ERR_NONFINITE",
    -4: "ERR_MESH",
    -5: "ERR_STATE",
    -6: "ERR_OPTION",
    -7: "ERR_CAPACITY",
    -8: "ERR_SINGULAR",
    -9: "ERR_MEMORY",
    -10: "ERR_UNSUPPORTED",
    -11: "ERR_BUSY",
    -12: "ERR_LOAD",
    -13: "ERR_IO",
    -99: "ERR_INTERNAL",
}

FUNCTIONS = {
    "rollcon_version": (c_int32, []),
    "rollcon_abi": (c_int32, []),
    "rollcon_version_string": (c_char_p, []),
    "rollcon_build_info": (c_char_p, []),
    "rollcon_has_feature": (c_int32, [c_char_p]),
    "rollcon_status_string": (c_char_p, [c_int32]),
    "rollcon_context_create": (c_int32, [c_int32, POINTER(c_void_p)]),
    "rollcon_context_retain": (c_int32, [c_void_p]),
    "rollcon_context_release": (None, [c_void_p]),
    "rollcon_context_set_log": (c_int32, [c_void_p, c_int32, log_fn, c_void_p]),
    "rollcon_context_set_threads": (c_int32, [c_void_p, c_int32]),
    "rollcon_context_get_error": (c_int32, [c_void_p, c_int64, c_char_p, POINTER(c_int64)]),
    "rollcon_body_create": (c_int32, [c_void_p, c_int32, POINTER(c_void_p)]),
    "rollcon_body_retain": (c_int32, [c_void_p]),
    "rollcon_body_release": (None, [c_void_p]),
    "rollcon_body_set_elastic": (c_int32, [c_void_p, c_int32, c_double, c_double]),
    "rollcon_body_prepare": (c_int32, [c_void_p]),
    "rollcon_body_get_kind": (c_int32, [c_void_p, POINTER(c_int32)]),
    "rollcon_body_save": (c_int32, [c_void_p, c_char_p]),
    "rollcon_body_load": (c_int32, [c_void_p, c_char_p, POINTER(c_void_p)]),
    "rollcon_body_set_nodes": (c_int32, [c_void_p, c_int64, POINTER(c_double), c_int64, c_int64]),
    "rollcon_body_add_elements": (c_int32, [
        c_void_p, c_int32, c_int64,
        POINTER(c_int32), c_int32, c_int32]),
    "rollcon_body_tag_faces": (c_int32, [
        c_void_p, c_int64, POINTER(c_int32),
        POINTER(c_int32), c_int32, c_int32]),
    "rollcon_body_tag_faces_of_nodes": (c_int32, [
        c_void_p, c_int64, POINTER(c_int32),
        c_int32, c_int32]),
    "rollcon_body_set_support": (c_int32, [
        c_void_p, c_int64, POINTER(c_int32),
        c_int32, c_int32, POINTER(c_double)]),
    "rollcon_body_set_traction": (c_int32, [c_void_p, c_int32, POINTER(c_double)]),
    "rollcon_body_set_pressure": (c_int32, [c_void_p, c_int32, c_double]),
    "rollcon_body_set_contact_faces": (c_int32, [c_void_p, c_int64, POINTER(c_int32)]),
    "rollcon_body_set_int": (c_int32, [c_void_p, c_char_p, c_int64]),
    "rollcon_body_set_real": (c_int32, [c_void_p, c_char_p, c_double]),
    "rollcon_body_get_int": (c_int32, [c_void_p, c_char_p, POINTER(c_int64)]),
    "rollcon_body_get_real": (c_int32, [c_void_p, c_char_p, POINTER(c_double)]),
    "rollcon_body_option_count": (c_int32, []),
    "rollcon_body_option_info": (c_int32, [
        c_int32, c_int64, c_char_p, POINTER(c_int32),
        POINTER(c_double), POINTER(c_double), POINTER(c_double)]),
    "rollcon_body_option_doc": (c_int32, [c_int32, c_int64, c_char_p, POINTER(c_int64)]),
    "rollcon_body_get_size": (c_int32, [c_void_p, POINTER(c_int64), POINTER(c_int64)]),
    "rollcon_body_get_displacements": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_body_get_reaction": (c_int32, [c_void_p, POINTER(c_double), POINTER(c_double)]),
    "rollcon_body_get_stat": (c_int32, [c_void_p, c_char_p, POINTER(c_double)]),
    "rollcon_body_stat_count": (c_int32, []),
    "rollcon_body_stat_name": (c_int32, [c_int32, c_int64, c_char_p, POINTER(c_int64)]),
    "rollcon_contact_create": (c_int32, [c_void_p, c_void_p, c_void_p, POINTER(c_void_p)]),
    "rollcon_contact_retain": (c_int32, [c_void_p]),
    "rollcon_contact_release": (None, [c_void_p]),
    "rollcon_contact_set_frame_nodes": (c_int32, [
        c_void_p, c_int64, POINTER(c_double),
        c_int64, c_int64]),
    "rollcon_contact_add_frame_elements": (c_int32, [
        c_void_p, c_int32, c_int64,
        POINTER(c_int32), c_int32, c_int32]),
    "rollcon_contact_frame_from_body": (c_int32, [c_void_p, c_int32, c_int32]),
    "rollcon_contact_set_pose": (c_int32, [
        c_void_p, c_int32,
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_set_axes": (c_int32, [
        c_void_p, POINTER(c_double),
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_set_gap": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_contact_set_gap_quadratic": (c_int32, [c_void_p, c_double, c_double, c_double]),
    "rollcon_contact_set_rolling": (c_int32, [c_void_p, c_double]),
    "rollcon_contact_set_creep": (c_int32, [c_void_p, c_double, c_double, c_double]),
    "rollcon_contact_set_creep_field": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_contact_prescribe": (c_int32, [c_void_p, c_int32, c_int32, c_double]),
    "rollcon_contact_set_friction": (c_int32, [c_void_p, c_char_p, c_int32, POINTER(c_double)]),
    "rollcon_contact_set_friction_field": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_contact_set_int": (c_int32, [c_void_p, c_char_p, c_int64]),
    "rollcon_contact_set_real": (c_int32, [c_void_p, c_char_p, c_double]),
    "rollcon_contact_set_str": (c_int32, [c_void_p, c_char_p, c_char_p]),
    "rollcon_contact_get_int": (c_int32, [c_void_p, c_char_p, POINTER(c_int64)]),
    "rollcon_contact_get_real": (c_int32, [c_void_p, c_char_p, POINTER(c_double)]),
    "rollcon_contact_get_str": (c_int32, [c_void_p, c_char_p, c_int64, c_char_p, POINTER(c_int64)]),
    "rollcon_option_count": (c_int32, []),
    "rollcon_option_info": (c_int32, [
        c_int32, c_int64, c_char_p, POINTER(c_int32),
        POINTER(c_double), POINTER(c_double), POINTER(c_double)]),
    "rollcon_option_doc": (c_int32, [c_int32, c_int64, c_char_p, POINTER(c_int64)]),
    "rollcon_contact_set_progress": (c_int32, [c_void_p, progress_fn, c_void_p]),
    "rollcon_event_get_int": (c_int32, [c_void_p, c_int32, POINTER(c_int64)]),
    "rollcon_event_get_real": (c_int32, [c_void_p, c_int32, POINTER(c_double)]),
    "rollcon_contact_request_cancel": (c_int32, [c_void_p]),
    "rollcon_contact_solve": (c_int32, [c_void_p]),
    "rollcon_contact_solve_many": (c_int32, [
        c_void_p, c_int32, POINTER(c_int32), c_int64, POINTER(c_double), c_char_p, c_int64, POINTER(c_int32),
        POINTER(c_double), POINTER(c_double), POINTER(c_double), POINTER(c_double), POINTER(c_double), POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_reset": (c_int32, [c_void_p]),
    "rollcon_contact_get_size": (c_int32, [c_void_p, POINTER(c_int64), POINTER(c_int64)]),
    "rollcon_contact_get_tractions": (c_int32, [c_void_p, c_int32, c_int64, POINTER(c_double)]),
    "rollcon_contact_get_field": (c_int32, [
        c_void_p, c_int32, c_int32,
        c_int64, POINTER(c_double), POINTER(c_int64)]),
    "rollcon_contact_get_status": (c_int32, [c_void_p, c_int64, POINTER(c_int32)]),
    "rollcon_contact_get_resultant": (c_int32, [
        c_void_p, c_int32,
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_get_motion": (c_int32, [c_void_p, POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_get_sensitivity": (c_int32, [
        c_void_p, c_int32, POINTER(c_double),
        POINTER(c_double), POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_get_displacements_at": (c_int32, [
        c_void_p, c_int32, c_int64,
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_get_stat": (c_int32, [c_void_p, c_char_p, POINTER(c_double)]),
    "rollcon_stat_count": (c_int32, []),
    "rollcon_stat_name": (c_int32, [c_int32, c_int64, c_char_p, POINTER(c_int64)]),
    "rollcon_contact_get_history": (c_int32, [
        c_void_p, c_int64,
        POINTER(c_double), POINTER(c_int64)]),
    "rollcon_contact_get_error_function": (c_int32, [
        c_void_p, c_int64, POINTER(c_double),
        POINTER(c_double), POINTER(c_int64)]),
    "rollcon_contact_get_plan": (c_int32, [c_void_p, c_int64, c_char_p, POINTER(c_int64)]),
    "rollcon_contact_write": (c_int32, [c_void_p, c_char_p]),
    "rollcon_id_of": (c_int32, [c_void_p]),
    "rollcon_context_from_id": (c_void_p, [c_int32]),
    "rollcon_body_from_id": (c_void_p, [c_int32]),
    "rollcon_contact_from_id": (c_void_p, [c_int32]),
}


def declare(library):
    """Gives every function of a loaded library its types."""
    for name, (restype, argtypes) in FUNCTIONS.items():
        function = getattr(library, name)
        function.restype = restype
        function.argtypes = argtypes
    return library
