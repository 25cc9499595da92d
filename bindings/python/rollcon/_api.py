# Generated from bindings/api.toml by bindings/generate.py; do not edit.
"""The C interface of rollcon 1.0.0-rc2 for ctypes: enumerators, callback types, prototypes.

Handles are c_void_p, arrays are pointers; None passes NULL.
"""

from ctypes import CFUNCTYPE, POINTER, c_char_p, c_double, c_int32, c_int64, c_void_p

VERSION = (1, 0, 0)
VERSION_TEXT = "1.0.0-rc2"
ABI = 1

# status
OK = 0
NOT_CONVERGED = 1
NO_CONTACT = 2
CANCELLED = 3
RIM_CONTACT = 4
COARSE = 5
INACCURATE = 6
TOO_DEEP = 7
DERAILED = 8
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
BODY_SECTION = 5
BODY_CONDENSED = 6

# form of a matrix
STIFFNESS = 1
FLEXIBILITY = 2

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
TILT_1 = 6
TILT_2 = 7

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
FIELD_TEMPERATURE = 13

# side
LEFT = -1
RIGHT = 1

# body of a contact
BODY1 = 1
BODY2 = 2

# moving contact
CONTACT_ITSELF = 0

# profile of a wheel on its rail
WHEEL = 1
RAIL = 2

# inside of a profile
BODY_BELOW = 1
BODY_ABOVE = -1

# axes of points
IN_CONTACT = 0
IN_BODY = 1

# axes of the track
IN_TRACK = 0
IN_WHEELSET = 1

# node status
OPEN = 0
STICK = 1
SLIP = 2
EXCLUDED = 3

# step
STEADY = 0
ROLLING_STEP = 1
SHIFT_STEP = 2

# log level
LOG_ERROR = 1
LOG_WARNING = 2
LOG_INFO = 3
LOG_DEBUG = 4

# option type
TYPE_INT = 1
TYPE_REAL = 2
TYPE_STR = 3

# kind of object
OF_BODY = 2
OF_CONTACT = 3
OF_WHEELRAIL = 4
OF_PATCH = 6
OF_PROCEDURE = 7

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
    6: "INACCURATE",
    7: "TOO_DEEP",
    8: "DERAILED",
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
    "rollcon_last_error": (c_char_p, []),
    "rollcon_last_caveat": (c_char_p, []),
    "rollcon_context_create": (c_int32, [c_int32, POINTER(c_void_p)]),
    "rollcon_context_release": (None, [c_void_p]),
    "rollcon_context_set_log": (c_int32, [c_void_p, c_int32, log_fn, c_void_p]),
    "rollcon_context_set_threads": (c_int32, [c_void_p, c_int32]),
    "rollcon_context_set_communicator": (c_int32, [c_void_p, c_int32]),
    "rollcon_context_set_latch": (c_int32, [c_void_p, c_int32]),
    "rollcon_context_check": (c_int32, [c_void_p]),
    "rollcon_body_create": (c_int32, [c_void_p, c_int32, POINTER(c_void_p)]),
    "rollcon_body_release": (None, [c_void_p]),
    "rollcon_body_set_elastic": (c_int32, [c_void_p, c_int32, c_double, c_double]),
    "rollcon_body_set_viscoelastic": (c_int32, [
        c_void_p, c_int32, c_int64,
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_body_set_moduli": (c_int32, [
        c_void_p, c_int32, c_int64,
        POINTER(c_double), POINTER(c_double), POINTER(c_double)]),
    "rollcon_body_prepare": (c_int32, [c_void_p]),
    "rollcon_body_get_kind": (c_int32, [c_void_p, POINTER(c_int32)]),
    "rollcon_body_save": (c_int32, [c_void_p, c_char_p]),
    "rollcon_body_load": (c_int32, [c_void_p, c_char_p, POINTER(c_void_p)]),
    "rollcon_body_copy": (c_int32, [c_void_p, POINTER(c_void_p)]),
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
    "rollcon_body_set_body_force": (c_int32, [c_void_p, c_int32, POINTER(c_double)]),
    "rollcon_body_set_rotation": (c_int32, [
        c_void_p, c_int32, c_double,
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_body_set_pressure": (c_int32, [c_void_p, c_int32, c_double]),
    "rollcon_body_set_springs": (c_int32, [c_void_p, c_int32, POINTER(c_double)]),
    "rollcon_body_set_node_tractions": (c_int32, [
        c_void_p, c_int32, c_int64, POINTER(c_int32),
        c_int32, POINTER(c_double), POINTER(c_double)]),
    "rollcon_body_set_contact_faces": (c_int32, [c_void_p, c_int64, POINTER(c_int32)]),
    "rollcon_body_revolve": (c_int32, [c_void_p, POINTER(c_double), POINTER(c_double)]),
    "rollcon_body_extrude": (c_int32, [c_void_p, POINTER(c_double), POINTER(c_double), c_double]),
    "rollcon_body_set_condensed": (c_int32, [c_void_p, c_int32, c_int64, POINTER(c_double)]),
    "rollcon_body_read_condensed": (c_int32, [c_void_p, c_int32, c_char_p]),
    "rollcon_body_write_condensed": (c_int32, [c_void_p, c_int32, c_char_p]),
    "rollcon_body_read_mesh": (c_int32, [c_void_p, c_char_p, c_char_p]),
    "rollcon_body_tag_group": (c_int32, [c_void_p, c_char_p, c_int32]),
    "rollcon_body_get_group_count": (c_int32, [c_void_p, POINTER(c_int32)]),
    "rollcon_body_get_group_name": (c_int32, [
        c_void_p, c_int32, c_int64,
        c_char_p, POINTER(c_int64)]),
    "rollcon_body_get_group_nodes": (c_int32, [
        c_void_p, c_char_p, c_int32,
        c_int64, POINTER(c_int32), POINTER(c_int64)]),
    "rollcon_body_set_int": (c_int32, [c_void_p, c_char_p, c_int64]),
    "rollcon_body_set_real": (c_int32, [c_void_p, c_char_p, c_double]),
    "rollcon_body_get_int": (c_int32, [c_void_p, c_char_p, POINTER(c_int64)]),
    "rollcon_body_get_real": (c_int32, [c_void_p, c_char_p, POINTER(c_double)]),
    "rollcon_body_set_profile": (c_int32, [c_void_p, c_int64, POINTER(c_double), c_double]),
    "rollcon_body_set_profile_shape": (c_int32, [c_void_p, c_char_p, c_int64, POINTER(c_double)]),
    "rollcon_body_read_profile": (c_int32, [c_void_p, c_char_p, c_double, c_int32, c_double]),
    "rollcon_body_add_slice": (c_int32, [c_void_p, c_double, c_int64, POINTER(c_double)]),
    "rollcon_body_read_slices": (c_int32, [
        c_void_p, c_char_p, c_double,
        c_double, c_int32, c_double]),
    "rollcon_body_add_wave": (c_int32, [c_void_p, c_double, c_double, c_double]),
    "rollcon_body_write_profile": (c_int32, [c_void_p, c_char_p, c_double]),
    "rollcon_body_extrude_profile": (c_int32, [
        c_void_p, POINTER(c_double),
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_body_revolve_profile": (c_int32, [
        c_void_p, POINTER(c_double),
        POINTER(c_double), c_double]),
    "rollcon_body_get_profile_length": (c_int32, [c_void_p, POINTER(c_double)]),
    "rollcon_body_get_profile_point": (c_int32, [
        c_void_p, c_double, POINTER(c_double),
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_body_get_size": (c_int32, [c_void_p, POINTER(c_int64), POINTER(c_int64)]),
    "rollcon_body_get_displacements": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_body_get_node_stresses": (c_int32, [
        c_void_p, c_int64,
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_body_get_point_stresses": (c_int32, [
        c_void_p, c_int64, POINTER(c_double), c_int64,
        POINTER(c_double), POINTER(c_double), POINTER(c_int64)]),
    "rollcon_body_get_fields_at": (c_int32, [
        c_void_p, c_int64, POINTER(c_double), c_int64,
        POINTER(c_double), POINTER(c_double), POINTER(c_double)]),
    "rollcon_body_write": (c_int32, [c_void_p, c_char_p, c_int64, POINTER(c_double)]),
    "rollcon_body_get_reaction": (c_int32, [c_void_p, POINTER(c_double), POINTER(c_double)]),
    "rollcon_body_get_stat": (c_int32, [c_void_p, c_char_p, POINTER(c_double)]),
    "rollcon_contact_create": (c_int32, [c_void_p, c_void_p, c_void_p, POINTER(c_void_p)]),
    "rollcon_contact_release": (None, [c_void_p]),
    "rollcon_contact_frame_nodes": (c_int32, [
        c_void_p, c_int64, POINTER(c_double),
        c_int64, c_int64]),
    "rollcon_contact_frame_add_elements": (c_int32, [
        c_void_p, c_int32, c_int64,
        POINTER(c_int32), c_int32, c_int32]),
    "rollcon_contact_frame_from_file": (c_int32, [c_void_p, c_char_p, c_char_p]),
    "rollcon_contact_frame_from_body": (c_int32, [c_void_p, c_int32, c_int32]),
    "rollcon_contact_frame_rectangle": (c_int32, [
        c_void_p, c_int32, c_int32, c_int32,
        c_double, c_double, c_double, c_double]),
    "rollcon_contact_frame_ellipse": (c_int32, [
        c_void_p, c_int32, c_int32,
        c_double, c_double, c_double]),
    "rollcon_contact_frame_strips": (c_int32, [c_void_p, c_int32, c_int64, POINTER(c_double)]),
    "rollcon_contact_frame_automatic": (c_int32, [c_void_p]),
    "rollcon_contact_set_pose": (c_int32, [
        c_void_p, c_int32,
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_set_axes": (c_int32, [
        c_void_p, POINTER(c_double),
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_set_gap": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_contact_set_gap_quadratic": (c_int32, [c_void_p, c_double, c_double, c_double]),
    "rollcon_contact_set_gap_grid": (c_int32, [
        c_void_p, c_int32, c_double, c_double,
        c_double, c_double, c_int64, POINTER(c_double)]),
    "rollcon_contact_set_rolling": (c_int32, [c_void_p, c_double]),
    "rollcon_contact_set_creep": (c_int32, [c_void_p, c_double, c_double, c_double]),
    "rollcon_contact_set_step": (c_int32, [c_void_p, c_int32, c_double]),
    "rollcon_contact_set_velocity": (c_int32, [
        c_void_p, c_int32, POINTER(c_double),
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_set_creep_field": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_contact_prescribe": (c_int32, [c_void_p, c_int32, c_int32, c_double]),
    "rollcon_contact_set_friction": (c_int32, [c_void_p, c_char_p, c_int32, POINTER(c_double)]),
    "rollcon_contact_set_friction_memory": (c_int32, [c_void_p, c_double, c_double]),
    "rollcon_contact_set_layer": (c_int32, [c_void_p, c_double, c_double, c_double]),
    "rollcon_contact_set_friction_across": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_contact_set_heat": (c_int32, [c_void_p, c_int32, c_double, c_double, c_double]),
    "rollcon_contact_set_friction_field": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_contact_set_int": (c_int32, [c_void_p, c_char_p, c_int64]),
    "rollcon_contact_set_real": (c_int32, [c_void_p, c_char_p, c_double]),
    "rollcon_contact_set_str": (c_int32, [c_void_p, c_char_p, c_char_p]),
    "rollcon_contact_get_int": (c_int32, [c_void_p, c_char_p, POINTER(c_int64)]),
    "rollcon_contact_get_real": (c_int32, [c_void_p, c_char_p, POINTER(c_double)]),
    "rollcon_contact_get_str": (c_int32, [c_void_p, c_char_p, c_int64, c_char_p, POINTER(c_int64)]),
    "rollcon_contact_set_procedure": (c_int32, [c_void_p, c_char_p]),
    "rollcon_contact_set_progress": (c_int32, [c_void_p, progress_fn, c_void_p]),
    "rollcon_event_get_int": (c_int32, [c_void_p, c_int32, POINTER(c_int64)]),
    "rollcon_event_get_real": (c_int32, [c_void_p, c_int32, POINTER(c_double)]),
    "rollcon_contact_request_cancel": (c_int32, [c_void_p]),
    "rollcon_contact_solve": (c_int32, [c_void_p]),
    "rollcon_contact_solve_many": (c_int32, [
        c_void_p, c_char_p, c_int64, POINTER(c_double), c_char_p,
        c_int64, POINTER(c_double), POINTER(c_int64), POINTER(c_int32)]),
    "rollcon_contact_repeat_step": (c_int32, [c_void_p]),
    "rollcon_contact_past_get": (c_int32, [c_void_p, c_int64, POINTER(c_double), POINTER(c_int64)]),
    "rollcon_contact_past_set": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_contact_reset": (c_int32, [c_void_p]),
    "rollcon_contact_get_size": (c_int32, [c_void_p, POINTER(c_int64), POINTER(c_int64)]),
    "rollcon_contact_get_tractions": (c_int32, [c_void_p, c_int32, c_int64, POINTER(c_double)]),
    "rollcon_contact_get_field": (c_int32, [
        c_void_p, c_int32, c_int32,
        c_int64, POINTER(c_double), POINTER(c_int64)]),
    "rollcon_contact_get_node_states": (c_int32, [c_void_p, c_int64, POINTER(c_int32)]),
    "rollcon_contact_get_resultant": (c_int32, [
        c_void_p, c_int32,
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_get_motion": (c_int32, [c_void_p, POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_get_tilt": (c_int32, [c_void_p, POINTER(c_double)]),
    "rollcon_contact_get_sensitivity": (c_int32, [
        c_void_p, c_int32, POINTER(c_double),
        POINTER(c_double), POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_get_displacements_at": (c_int32, [
        c_void_p, c_int32, c_int64,
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_get_fields_at": (c_int32, [
        c_void_p, c_int32, c_int64, POINTER(c_double),
        c_int32, POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_find_stress": (c_int32, [
        c_void_p, c_int32, c_char_p, c_int32,
        POINTER(c_double), POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_get_body_displacements": (c_int32, [
        c_void_p, c_int32, c_int64,
        POINTER(c_double), POINTER(c_int64)]),
    "rollcon_contact_get_body_power": (c_int32, [
        c_void_p, c_int32, c_int64,
        POINTER(c_double), POINTER(c_int64)]),
    "rollcon_contact_write_body": (c_int32, [c_void_p, c_int32, c_char_p]),
    "rollcon_contact_write_loads": (c_int32, [c_void_p, c_int32, c_char_p]),
    "rollcon_contact_get_temperatures_at": (c_int32, [
        c_void_p, c_int64,
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_get_fatigue_index": (c_int32, [c_void_p, c_double, POINTER(c_double)]),
    "rollcon_contact_get_equivalent_ellipse": (c_int32, [
        c_void_p, POINTER(c_double),
        POINTER(c_double)]),
    "rollcon_contact_get_wear": (c_int32, [
        c_void_p, c_char_p, c_int32, POINTER(c_double),
        c_int64, POINTER(c_double), POINTER(c_double), POINTER(c_double)]),
    "rollcon_wear_profile": (c_int32, [
        c_int64, POINTER(c_double), POINTER(c_double), c_int32, c_double,
        c_double, c_double, POINTER(c_double), POINTER(c_double)]),
    "rollcon_stress_invariants": (c_int32, [
        c_int64, POINTER(c_double), POINTER(c_double),
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_contact_get_stat": (c_int32, [c_void_p, c_char_p, POINTER(c_double)]),
    "rollcon_contact_get_history": (c_int32, [
        c_void_p, c_char_p, c_int64,
        POINTER(c_double), POINTER(c_int64)]),
    "rollcon_contact_get_plan": (c_int32, [c_void_p, c_int64, c_char_p, POINTER(c_int64)]),
    "rollcon_contact_write": (c_int32, [c_void_p, c_char_p]),
    "rollcon_wheelrail_create": (c_int32, [
        c_void_p, c_void_p, c_void_p,
        c_int32, POINTER(c_void_p)]),
    "rollcon_wheelrail_release": (None, [c_void_p]),
    "rollcon_wheelrail_set_track": (c_int32, [c_void_p, c_double, c_double, c_double]),
    "rollcon_wheelrail_set_wheelset": (c_int32, [c_void_p, c_double, c_double, c_double]),
    "rollcon_wheelrail_place_rail": (c_int32, [c_void_p, c_double, c_double, c_double]),
    "rollcon_wheelrail_set_roller": (c_int32, [c_void_p, c_double, c_double]),
    "rollcon_wheelrail_set_step": (c_int32, [c_void_p, c_int32, c_double]),
    "rollcon_wheelrail_repeat_step": (c_int32, [c_void_p]),
    "rollcon_wheelrail_past_get": (c_int32, [
        c_void_p, c_int64,
        POINTER(c_double), POINTER(c_int64)]),
    "rollcon_wheelrail_past_set": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_wheelrail_set_tape_circle": (c_int32, [c_void_p, c_double]),
    "rollcon_wheelrail_set_flexibility": (c_int32, [
        c_void_p, POINTER(c_double),
        POINTER(c_double)]),
    "rollcon_wheelrail_set_rail_springs": (c_int32, [
        c_void_p, POINTER(c_double),
        POINTER(c_double)]),
    "rollcon_wheelrail_set_rail_deviation": (c_int32, [
        c_void_p, POINTER(c_double),
        POINTER(c_double)]),
    "rollcon_wheelrail_set_position": (c_int32, [c_void_p, POINTER(c_double)]),
    "rollcon_wheelrail_set_velocity": (c_int32, [c_void_p, POINTER(c_double)]),
    "rollcon_wheelrail_prescribe_vertical": (c_int32, [c_void_p, c_int32, c_double]),
    "rollcon_wheelrail_prescribe_longitudinal": (c_int32, [c_void_p, c_int32, c_double]),
    "rollcon_wheelrail_set_friction": (c_int32, [c_void_p, c_char_p, c_int32, POINTER(c_double)]),
    "rollcon_wheelrail_set_law_by_angle": (c_int32, [
        c_void_p, c_char_p, c_int32,
        c_int32, POINTER(c_double)]),
    "rollcon_wheelrail_set_friction_memory": (c_int32, [c_void_p, c_double, c_double]),
    "rollcon_wheelrail_set_layer": (c_int32, [c_void_p, c_double, c_double, c_double]),
    "rollcon_wheelrail_set_heat": (c_int32, [c_void_p, c_int32, c_double, c_double, c_double]),
    "rollcon_wheelrail_set_table": (c_int32, [c_void_p, c_void_p]),
    "rollcon_wheelrail_solve": (c_int32, [c_void_p]),
    "rollcon_wheelrail_request_cancel": (c_int32, [c_void_p]),
    "rollcon_wheelrail_solve_many": (c_int32, [
        c_void_p, c_int64, POINTER(c_double), POINTER(c_double),
        c_char_p, POINTER(c_double), POINTER(c_int32)]),
    "rollcon_wheelrail_find_wear": (c_int32, [
        c_void_p, c_int64, POINTER(c_double), POINTER(c_double), POINTER(c_double), c_char_p, c_int32,
        POINTER(c_double), c_int64, POINTER(c_double), POINTER(c_double), POINTER(c_double), POINTER(c_int32)]),
    "rollcon_wheelrail_snapshot": (c_int32, [c_void_p, c_int32]),
    "rollcon_wheelrail_rollback": (c_int32, [c_void_p, c_int32]),
    "rollcon_wheelrail_copy": (c_int32, [c_void_p, POINTER(c_void_p)]),
    "rollcon_wheelrail_reset": (c_int32, [c_void_p]),
    "rollcon_wheelrail_set_int": (c_int32, [c_void_p, c_char_p, c_int64]),
    "rollcon_wheelrail_set_real": (c_int32, [c_void_p, c_char_p, c_double]),
    "rollcon_wheelrail_get_int": (c_int32, [c_void_p, c_char_p, POINTER(c_int64)]),
    "rollcon_wheelrail_get_real": (c_int32, [c_void_p, c_char_p, POINTER(c_double)]),
    "rollcon_wheelrail_get_patch_count": (c_int32, [c_void_p, POINTER(c_int64)]),
    "rollcon_wheelrail_get_resultant": (c_int32, [
        c_void_p, c_int32,
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_wheelrail_get_derivative": (c_int32, [
        c_void_p, c_int32, POINTER(c_double),
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_wheelrail_get_stat": (c_int32, [c_void_p, c_char_p, POINTER(c_double)]),
    "rollcon_wheelrail_get_profile_point": (c_int32, [
        c_void_p, c_int32,
        c_double, POINTER(c_double)]),
    "rollcon_wheelrail_get_patch_stat": (c_int32, [c_void_p, c_int32, c_char_p, POINTER(c_double)]),
    "rollcon_wheelrail_get_patch_axes": (c_int32, [
        c_void_p, c_int32,
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_wheelrail_get_contact": (c_int32, [c_void_p, c_int32, POINTER(c_void_p)]),
    "rollcon_wheelrail_find_contact_points": (c_int32, [
        c_void_p, c_void_p, c_int64,
        POINTER(c_double), c_char_p, POINTER(c_double)]),
    "rollcon_wheelrail_find_conicity": (c_int32, [
        c_void_p, c_void_p, c_int64,
        POINTER(c_double), POINTER(c_double), POINTER(c_double)]),
    "rollcon_option_count": (c_int32, [c_int32]),
    "rollcon_option_info": (c_int32, [
        c_int32, c_int32, c_int64, c_char_p, c_char_p,
        POINTER(c_int64), POINTER(c_int32), POINTER(c_double), POINTER(c_double), POINTER(c_double)]),
    "rollcon_stat_count": (c_int32, [c_int32]),
    "rollcon_stat_info": (c_int32, [
        c_int32, c_int32, c_int64, c_char_p,
        c_char_p, POINTER(c_int64), POINTER(c_int32)]),
    "rollcon_report": (c_int32, [c_void_p, c_int32, c_char_p]),
    "rollcon_context_retain": (c_int32, [c_void_p]),
    "rollcon_body_retain": (c_int32, [c_void_p]),
    "rollcon_contact_retain": (c_int32, [c_void_p]),
    "rollcon_wheelrail_retain": (c_int32, [c_void_p]),
    "rollcon_table_retain": (c_int32, [c_void_p]),
    "rollcon_id_of": (c_int32, [c_void_p]),
    "rollcon_context_from_id": (c_void_p, [c_int32]),
    "rollcon_body_from_id": (c_void_p, [c_int32]),
    "rollcon_contact_from_id": (c_void_p, [c_int32]),
    "rollcon_wheelrail_from_id": (c_void_p, [c_int32]),
    "rollcon_table_from_id": (c_void_p, [c_int32]),
    "rollcon_table_create": (c_int32, [c_void_p, POINTER(c_void_p)]),
    "rollcon_table_release": (None, [c_void_p]),
    "rollcon_table_load": (c_int32, [c_void_p, c_char_p, POINTER(c_void_p)]),
    "rollcon_table_standard": (c_int32, [c_void_p, POINTER(c_void_p)]),
    "rollcon_table_set_ratios": (c_int32, [c_void_p, c_int32, c_double, c_double]),
    "rollcon_table_set_resolution": (c_int32, [c_void_p, c_int32, c_int32, c_int32]),
    "rollcon_table_set_frame": (c_int32, [c_void_p, c_int32, c_int32]),
    "rollcon_table_set_poissons": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_table_set_bodies": (c_int32, [
        c_void_p, POINTER(c_double), POINTER(c_double),
        c_int64, POINTER(c_double)]),
    "rollcon_table_set_progress": (c_int32, [c_void_p, progress_fn, c_void_p]),
    "rollcon_table_request_cancel": (c_int32, [c_void_p]),
    "rollcon_table_make": (c_int32, [c_void_p, c_int32, c_int32]),
    "rollcon_table_get_samples": (c_int32, [
        c_void_p, c_int64,
        POINTER(c_double), POINTER(c_int64)]),
    "rollcon_table_add_samples": (c_int32, [c_void_p, c_int64, POINTER(c_double)]),
    "rollcon_table_save": (c_int32, [c_void_p, c_char_p]),
    "rollcon_table_evaluate": (c_int32, [c_void_p, c_int64, POINTER(c_double), POINTER(c_double)]),
    "rollcon_table_evaluate_derivatives": (c_int32, [
        c_void_p, c_int64, POINTER(c_double),
        POINTER(c_double), POINTER(c_double)]),
    "rollcon_table_evaluate_contact": (c_int32, [c_void_p, c_void_p, c_double, POINTER(c_double)]),
}

# Names of the values of enumerations, with and without what all of them begin with.
ENUMERATORS = {
    "status": {
        "ok": 0, "not_converged": 1, "no_contact": 2, "cancelled": 3, "rim_contact": 4, "coarse":
        5, "inaccurate": 6, "too_deep": 7, "derailed": 8, "err_argument": -1, "err_handle": -2,
        "err_nonfinite": -3, "err_mesh": -4, "err_state": -5, "err_option": -6, "err_capacity":
        -7, "err_singular": -8, "err_memory": -9, "err_unsupported": -10, "err_busy": -11,
        "err_load": -12, "err_io": -13, "err_internal": -99
    },
    "body kind": {
        "fem": 1, "bem": 2, "halfspace": 3, "rigid": 4, "section": 5, "condensed": 6, "body_fem":
        1, "body_bem": 2, "body_halfspace": 3, "body_rigid": 4, "body_section": 5,
        "body_condensed": 6
    },
    "form of a matrix": {"stiffness": 1, "flexibility": 2},
    "element type": {
        "tri3": 203, "tri6": 206, "quad4": 214, "quad8": 218, "quad9": 219, "tet4": 304, "tet10":
        310, "wedge6": 326, "wedge15": 335, "hex8": 338, "hex20": 350
    },
    "dof": {"x": 1, "y": 2, "z": 4, "xyz": 7, "dof_x": 1, "dof_y": 2, "dof_z": 4, "dof_xyz": 7},
    "direction": {
        "longitudinal": 1, "lateral": 2, "normal": 3, "spin": 4, "tilt_1": 6, "tilt_2": 7
    },
    "parameter": {"friction": 5},
    "how": {"motion": 1, "force": 2, "by_motion": 1, "by_force": 2},
    "axes": {"local": 0, "global": 1},
    "field": {
        "point": 1, "traction": 2, "gap": 3, "slip": 4, "displacement1": 5, "displacement2": 6,
        "area": 7, "friction": 8, "pressure": 9, "rigid_slip": 10, "friction_power": 11, "weight":
        12, "temperature": 13, "field_point": 1, "field_traction": 2, "field_gap": 3,
        "field_slip": 4, "field_displacement1": 5, "field_displacement2": 6, "field_area": 7,
        "field_friction": 8, "field_pressure": 9, "field_rigid_slip": 10, "field_friction_power":
        11, "field_weight": 12, "field_temperature": 13
    },
    "side": {"left": -1, "right": 1},
    "body of a contact": {"body1": 1, "body2": 2},
    "moving contact": {"itself": 0, "contact_itself": 0},
    "profile of a wheel on its rail": {"wheel": 1, "rail": 2},
    "inside of a profile": {"below": 1, "above": -1, "body_below": 1, "body_above": -1},
    "axes of points": {"contact": 0, "body": 1, "in_contact": 0, "in_body": 1},
    "axes of the track": {"track": 0, "wheelset": 1, "in_track": 0, "in_wheelset": 1},
    "node status": {"open": 0, "stick": 1, "slip": 2, "excluded": 3},
    "step": {"steady": 0, "rolling_step": 1, "shift_step": 2},
    "log level": {
        "error": 1, "warning": 2, "info": 3, "debug": 4, "log_error": 1, "log_warning": 2,
        "log_info": 3, "log_debug": 4
    },
    "option type": {"int": 1, "real": 2, "str": 3, "type_int": 1, "type_real": 2, "type_str": 3},
    "kind of object": {
        "body": 2, "contact": 3, "wheelrail": 4, "patch": 6, "procedure": 7, "of_body": 2,
        "of_contact": 3, "of_wheelrail": 4, "of_patch": 6, "of_procedure": 7
    },
    "event key": {
        "phase": 1, "iteration": 2, "residual": 101, "seconds": 102, "event_phase": 1,
        "event_iteration": 2, "event_residual": 101, "event_seconds": 102
    },
    "phase": {
        "compliance": 1, "normal": 2, "tangential": 3, "full": 4, "cases": 5, "phase_compliance":
        1, "phase_normal": 2, "phase_tangential": 3, "phase_full": 4, "phase_cases": 5
    },
}

# Names of arguments and, of enumerators, their enumerations.
ARGUMENTS = {
    "rollcon_version": [],
    "rollcon_abi": [],
    "rollcon_version_string": [],
    "rollcon_build_info": [],
    "rollcon_has_feature": [("name", "")],
    "rollcon_status_string": [("status", "")],
    "rollcon_last_error": [],
    "rollcon_last_caveat": [],
    "rollcon_context_create": [("header_abi", ""), ("context", "")],
    "rollcon_context_release": [("context", "")],
    "rollcon_context_set_log": [
        ("context", ""), ("max_level", "log level"), ("fn", ""), ("user", "")
    ],
    "rollcon_context_set_threads": [("context", ""), ("n", "")],
    "rollcon_context_set_communicator": [("context", ""), ("communicator", "")],
    "rollcon_context_set_latch": [("context", ""), ("on", "")],
    "rollcon_context_check": [("context", "")],
    "rollcon_body_create": [("context", ""), ("kind", "body kind"), ("body", "")],
    "rollcon_body_release": [("body", "")],
    "rollcon_body_set_elastic": [("body", ""), ("tag", ""), ("young", ""), ("poisson", "")],
    "rollcon_body_set_viscoelastic": [
        ("body", ""), ("tag", ""), ("n", ""), ("ratios", ""), ("times", "")
    ],
    "rollcon_body_set_moduli": [
        ("body", ""), ("tag", ""), ("n", ""), ("frequencies", ""), ("storage", ""), ("loss", "")
    ],
    "rollcon_body_prepare": [("body", "")],
    "rollcon_body_get_kind": [("body", ""), ("kind", "")],
    "rollcon_body_save": [("body", ""), ("path", "")],
    "rollcon_body_load": [("context", ""), ("path", ""), ("body", "")],
    "rollcon_body_copy": [("body", ""), ("copy", "")],
    "rollcon_body_set_nodes": [
        ("body", ""), ("n", ""), ("x", ""), ("node_stride", ""), ("component_stride", "")
    ],
    "rollcon_body_add_elements": [
        ("body", ""), ("type", "element type"), ("n", ""), ("connectivity", ""), ("index_base",
        ""), ("tag", "")
    ],
    "rollcon_body_tag_faces": [
        ("body", ""), ("n", ""), ("elements", ""), ("faces", ""), ("index_base", ""), ("tag", "")
    ],
    "rollcon_body_tag_faces_of_nodes": [
        ("body", ""), ("n", ""), ("nodes", ""), ("index_base", ""), ("tag", "")
    ],
    "rollcon_body_set_support": [
        ("body", ""), ("n", ""), ("nodes", ""), ("index_base", ""), ("dof_mask", "dof"),
        ("values", "")
    ],
    "rollcon_body_set_traction": [("body", ""), ("tag", ""), ("traction", "")],
    "rollcon_body_set_body_force": [("body", ""), ("tag", ""), ("force", "")],
    "rollcon_body_set_rotation": [
        ("body", ""), ("tag", ""), ("density", ""), ("origin", ""), ("rate", "")
    ],
    "rollcon_body_set_pressure": [("body", ""), ("tag", ""), ("pressure", "")],
    "rollcon_body_set_springs": [("body", ""), ("tag", ""), ("stiffness", "")],
    "rollcon_body_set_node_tractions": [
        ("body", ""), ("tag", ""), ("n", ""), ("nodes", ""), ("index_base", ""), ("along", ""),
        ("tractions", "")
    ],
    "rollcon_body_set_contact_faces": [("body", ""), ("n", ""), ("tags", "")],
    "rollcon_body_revolve": [("body", ""), ("origin", ""), ("axis", "")],
    "rollcon_body_extrude": [("body", ""), ("origin", ""), ("direction", ""), ("period", "")],
    "rollcon_body_set_condensed": [
        ("body", ""), ("form", "form of a matrix"), ("n", ""), ("matrix", "")
    ],
    "rollcon_body_read_condensed": [("body", ""), ("form", "form of a matrix"), ("path", "")],
    "rollcon_body_write_condensed": [("body", ""), ("form", "form of a matrix"), ("path", "")],
    "rollcon_body_read_mesh": [("body", ""), ("path", ""), ("part", "")],
    "rollcon_body_tag_group": [("body", ""), ("group", ""), ("tag", "")],
    "rollcon_body_get_group_count": [("body", ""), ("n", "")],
    "rollcon_body_get_group_name": [
        ("body", ""), ("i", ""), ("capacity", ""), ("text", ""), ("needed", "")
    ],
    "rollcon_body_get_group_nodes": [
        ("body", ""), ("group", ""), ("index_base", ""), ("capacity", ""), ("nodes", ""),
        ("n_nodes", "")
    ],
    "rollcon_body_set_int": [("body", ""), ("name", ""), ("value", "")],
    "rollcon_body_set_real": [("body", ""), ("name", ""), ("value", "")],
    "rollcon_body_get_int": [("body", ""), ("name", ""), ("value", "")],
    "rollcon_body_get_real": [("body", ""), ("name", ""), ("value", "")],
    "rollcon_body_set_profile": [("body", ""), ("n", ""), ("points", ""), ("filter_length", "")],
    "rollcon_body_set_profile_shape": [("body", ""), ("shape", ""), ("n", ""), ("parameters", "")],
    "rollcon_body_read_profile": [
        ("body", ""), ("path", ""), ("unit", ""), ("mirror", ""), ("filter_length", "")
    ],
    "rollcon_body_add_slice": [("body", ""), ("u", ""), ("n", ""), ("features", "")],
    "rollcon_body_read_slices": [
        ("body", ""), ("path", ""), ("mm", ""), ("unit", ""), ("mirror", ""), ("filter_length",
        "")
    ],
    "rollcon_body_add_wave": [("body", ""), ("amplitude", ""), ("wavelength", ""), ("phase", "")],
    "rollcon_body_write_profile": [("body", ""), ("path", ""), ("unit", "")],
    "rollcon_body_extrude_profile": [("body", ""), ("origin", ""), ("along", ""), ("z_axis", "")],
    "rollcon_body_revolve_profile": [("body", ""), ("origin", ""), ("axis", ""), ("radius", "")],
    "rollcon_body_get_profile_length": [("body", ""), ("length", "")],
    "rollcon_body_get_profile_point": [
        ("body", ""), ("s", ""), ("point", ""), ("tangent", ""), ("curvature", "")
    ],
    "rollcon_body_get_size": [("body", ""), ("nodes", ""), ("elements", "")],
    "rollcon_body_get_displacements": [("body", ""), ("capacity", ""), ("u", "")],
    "rollcon_body_get_node_stresses": [("body", ""), ("nodes", ""), ("u", ""), ("stress", "")],
    "rollcon_body_get_point_stresses": [
        ("body", ""), ("nodes", ""), ("u", ""), ("capacity", ""), ("stress", ""), ("xyz", ""),
        ("n_rows", "")
    ],
    "rollcon_body_get_fields_at": [
        ("body", ""), ("nodes", ""), ("u", ""), ("n", ""), ("xyz", ""), ("displacement", ""),
        ("stress", "")
    ],
    "rollcon_body_write": [("body", ""), ("path", ""), ("nodes", ""), ("u", "")],
    "rollcon_body_get_reaction": [("body", ""), ("force", ""), ("moment", "")],
    "rollcon_body_get_stat": [("body", ""), ("name", ""), ("value", "")],
    "rollcon_contact_create": [("context", ""), ("body1", ""), ("body2", ""), ("contact", "")],
    "rollcon_contact_release": [("contact", "")],
    "rollcon_contact_frame_nodes": [
        ("contact", ""), ("n", ""), ("x", ""), ("node_stride", ""), ("component_stride", "")
    ],
    "rollcon_contact_frame_add_elements": [
        ("contact", ""), ("type", "element type"), ("n", ""), ("connectivity", ""), ("index_base",
        ""), ("tag", "")
    ],
    "rollcon_contact_frame_from_file": [("contact", ""), ("path", ""), ("part", "")],
    "rollcon_contact_frame_from_body": [
        ("contact", ""), ("which", "body of a contact"), ("tag", "")
    ],
    "rollcon_contact_frame_rectangle": [
        ("contact", ""), ("type", "element type"), ("nx", ""), ("ny", ""), ("x_least", ""),
        ("x_greatest", ""), ("y_least", ""), ("y_greatest", "")
    ],
    "rollcon_contact_frame_ellipse": [
        ("contact", ""), ("along", ""), ("across", ""), ("a", ""), ("b", ""), ("angle", "")
    ],
    "rollcon_contact_frame_strips": [("contact", ""), ("along", ""), ("n", ""), ("lines", "")],
    "rollcon_contact_frame_automatic": [("contact", "")],
    "rollcon_contact_set_pose": [
        ("contact", ""), ("which", "body of a contact"), ("rotation", ""), ("translation", "")
    ],
    "rollcon_contact_set_axes": [("contact", ""), ("origin", ""), ("rolling", ""), ("normal", "")],
    "rollcon_contact_set_gap": [("contact", ""), ("n", ""), ("gap", "")],
    "rollcon_contact_set_gap_quadratic": [("contact", ""), ("a", ""), ("b", ""), ("c", "")],
    "rollcon_contact_set_gap_grid": [
        ("contact", ""), ("nx", ""), ("x_least", ""), ("x_greatest", ""), ("y_least", ""),
        ("y_greatest", ""), ("n", ""), ("gap", "")
    ],
    "rollcon_contact_set_rolling": [("contact", ""), ("speed", "")],
    "rollcon_contact_set_creep": [
        ("contact", ""), ("longitudinal", ""), ("lateral", ""), ("spin", "")
    ],
    "rollcon_contact_set_step": [("contact", ""), ("kind", "step"), ("dt", "")],
    "rollcon_contact_set_velocity": [
        ("contact", ""), ("which", "body of a contact or moving contact"), ("velocity", ""),
        ("angular_velocity", ""), ("point", "")
    ],
    "rollcon_contact_set_creep_field": [("contact", ""), ("n", ""), ("slip", "")],
    "rollcon_contact_prescribe": [
        ("contact", ""), ("direction", "direction"), ("how", "how"), ("value", "")
    ],
    "rollcon_contact_set_friction": [("contact", ""), ("law", ""), ("n", ""), ("parameters", "")],
    "rollcon_contact_set_friction_memory": [("contact", ""), ("length", ""), ("least_speed", "")],
    "rollcon_contact_set_layer": [
        ("contact", ""), ("flexibility", ""), ("stress", ""), ("hardening", "")
    ],
    "rollcon_contact_set_friction_across": [("contact", ""), ("n", ""), ("points", "")],
    "rollcon_contact_set_heat": [
        ("contact", ""), ("which", "body of a contact"), ("conductivity", ""), ("heat_capacity",
        ""), ("temperature", "")
    ],
    "rollcon_contact_set_friction_field": [("contact", ""), ("n", ""), ("mu", "")],
    "rollcon_contact_set_int": [("contact", ""), ("name", ""), ("value", "")],
    "rollcon_contact_set_real": [("contact", ""), ("name", ""), ("value", "")],
    "rollcon_contact_set_str": [("contact", ""), ("name", ""), ("value", "")],
    "rollcon_contact_get_int": [("contact", ""), ("name", ""), ("value", "")],
    "rollcon_contact_get_real": [("contact", ""), ("name", ""), ("value", "")],
    "rollcon_contact_get_str": [
        ("contact", ""), ("name", ""), ("capacity", ""), ("text", ""), ("needed", "")
    ],
    "rollcon_contact_set_procedure": [("contact", ""), ("procedure", "")],
    "rollcon_contact_set_progress": [("contact", ""), ("fn", ""), ("user", "")],
    "rollcon_event_get_int": [("event", ""), ("key", "event key"), ("value", "")],
    "rollcon_event_get_real": [("event", ""), ("key", "event key"), ("value", "")],
    "rollcon_contact_request_cancel": [("contact", "")],
    "rollcon_contact_solve": [("contact", "")],
    "rollcon_contact_solve_many": [
        ("contact", ""), ("parameters", ""), ("n_cases", ""), ("values", ""), ("columns", ""),
        ("capacity", ""), ("results", ""), ("n_results", ""), ("status", "")
    ],
    "rollcon_contact_repeat_step": [("contact", "")],
    "rollcon_contact_past_get": [("contact", ""), ("capacity", ""), ("past", ""), ("n_values", "")],
    "rollcon_contact_past_set": [("contact", ""), ("n", ""), ("past", "")],
    "rollcon_contact_reset": [("contact", "")],
    "rollcon_contact_get_size": [("contact", ""), ("nodes", ""), ("elements", "")],
    "rollcon_contact_get_tractions": [
        ("contact", ""), ("axes", "axes"), ("capacity", ""), ("t", "")
    ],
    "rollcon_contact_get_field": [
        ("contact", ""), ("field", "field"), ("axes", "axes"), ("capacity", ""), ("v", ""),
        ("n_values", "")
    ],
    "rollcon_contact_get_node_states": [("contact", ""), ("capacity", ""), ("status", "")],
    "rollcon_contact_get_resultant": [
        ("contact", ""), ("axes", "axes"), ("force", ""), ("moment", "")
    ],
    "rollcon_contact_get_motion": [("contact", ""), ("approach", ""), ("creep", "")],
    "rollcon_contact_get_tilt": [("contact", ""), ("tilt", "")],
    "rollcon_contact_get_sensitivity": [
        ("contact", ""), ("parameter", "direction or parameter"), ("force", ""), ("moment", ""),
        ("approach", ""), ("creep", "")
    ],
    "rollcon_contact_get_displacements_at": [
        ("contact", ""), ("which", "body of a contact"), ("n", ""), ("xy", ""), ("u", "")
    ],
    "rollcon_contact_get_fields_at": [
        ("contact", ""), ("which", "body of a contact"), ("n", ""), ("xyz", ""), ("in_axes",
        "axes of points"), ("u", ""), ("stress", "")
    ],
    "rollcon_contact_find_stress": [
        ("contact", ""), ("which", "body of a contact"), ("measure", ""), ("n", ""),
        ("parameters", ""), ("value", ""), ("place", "")
    ],
    "rollcon_contact_get_body_displacements": [
        ("contact", ""), ("which", "body of a contact"), ("capacity", ""), ("u", ""), ("n_values",
        "")
    ],
    "rollcon_contact_get_body_power": [
        ("contact", ""), ("which", "body of a contact"), ("capacity", ""), ("power", ""),
        ("n_values", "")
    ],
    "rollcon_contact_write_body": [("contact", ""), ("which", "body of a contact"), ("path", "")],
    "rollcon_contact_write_loads": [("contact", ""), ("which", "body of a contact"), ("path", "")],
    "rollcon_contact_get_temperatures_at": [
        ("contact", ""), ("n", ""), ("xy", ""), ("temperature", "")
    ],
    "rollcon_contact_get_fatigue_index": [("contact", ""), ("shear_yield", ""), ("index", "")],
    "rollcon_contact_get_equivalent_ellipse": [("contact", ""), ("inputs", ""), ("center", "")],
    "rollcon_contact_get_wear": [
        ("contact", ""), ("law", ""), ("n", ""), ("parameters", ""), ("points", ""), ("y", ""),
        ("depth", ""), ("volume", "")
    ],
    "rollcon_wear_profile": [
        ("points", ""), ("yz", ""), ("rate", ""), ("side", "inside of a profile"), ("distance",
        ""), ("most_depth", ""), ("smoothing", ""), ("worn", ""), ("taken", "")
    ],
    "rollcon_stress_invariants": [
        ("n", ""), ("stress", ""), ("principal", ""), ("von_mises", ""), ("shear", "")
    ],
    "rollcon_contact_get_stat": [("contact", ""), ("name", ""), ("value", "")],
    "rollcon_contact_get_history": [
        ("contact", ""), ("columns", ""), ("capacity", ""), ("rows", ""), ("n_rows", "")
    ],
    "rollcon_contact_get_plan": [("contact", ""), ("capacity", ""), ("text", ""), ("needed", "")],
    "rollcon_contact_write": [("contact", ""), ("path", "")],
    "rollcon_wheelrail_create": [
        ("context", ""), ("wheel", ""), ("rail", ""), ("side", "side"), ("wheelrail", "")
    ],
    "rollcon_wheelrail_release": [("wheelrail", "")],
    "rollcon_wheelrail_set_track": [
        ("wheelrail", ""), ("gauge", ""), ("gauge_height", ""), ("cant", "")
    ],
    "rollcon_wheelrail_set_wheelset": [
        ("wheelrail", ""), ("back_to_back", ""), ("flange_back", ""), ("radius", "")
    ],
    "rollcon_wheelrail_place_rail": [("wheelrail", ""), ("y", ""), ("z", ""), ("cant", "")],
    "rollcon_wheelrail_set_roller": [("wheelrail", ""), ("radius", ""), ("rate", "")],
    "rollcon_wheelrail_set_step": [("wheelrail", ""), ("kind", "step"), ("dt", "")],
    "rollcon_wheelrail_repeat_step": [("wheelrail", "")],
    "rollcon_wheelrail_past_get": [
        ("wheelrail", ""), ("capacity", ""), ("past", ""), ("n_values", "")
    ],
    "rollcon_wheelrail_past_set": [("wheelrail", ""), ("n", ""), ("past", "")],
    "rollcon_wheelrail_set_tape_circle": [("wheelrail", ""), ("y", "")],
    "rollcon_wheelrail_set_flexibility": [("wheelrail", ""), ("displacement", ""), ("rate", "")],
    "rollcon_wheelrail_set_rail_springs": [("wheelrail", ""), ("stiffness", ""), ("force", "")],
    "rollcon_wheelrail_set_rail_deviation": [("wheelrail", ""), ("deviation", ""), ("rate", "")],
    "rollcon_wheelrail_set_position": [("wheelrail", ""), ("position", "")],
    "rollcon_wheelrail_set_velocity": [("wheelrail", ""), ("velocity", "")],
    "rollcon_wheelrail_prescribe_vertical": [("wheelrail", ""), ("how", "how"), ("force", "")],
    "rollcon_wheelrail_prescribe_longitudinal": [("wheelrail", ""), ("how", "how"), ("force", "")],
    "rollcon_wheelrail_set_friction": [
        ("wheelrail", ""), ("law", ""), ("n", ""), ("parameters", "")
    ],
    "rollcon_wheelrail_set_law_by_angle": [
        ("wheelrail", ""), ("law", ""), ("points", ""), ("n", ""), ("parameters", "")
    ],
    "rollcon_wheelrail_set_friction_memory": [
        ("wheelrail", ""), ("length", ""), ("least_speed", "")
    ],
    "rollcon_wheelrail_set_layer": [
        ("wheelrail", ""), ("flexibility", ""), ("stress", ""), ("hardening", "")
    ],
    "rollcon_wheelrail_set_heat": [
        ("wheelrail", ""), ("which", "profile of a wheel on its rail"), ("conductivity", ""),
        ("heat_capacity", ""), ("temperature", "")
    ],
    "rollcon_wheelrail_set_table": [("wheelrail", ""), ("table", "")],
    "rollcon_wheelrail_solve": [("wheelrail", "")],
    "rollcon_wheelrail_request_cancel": [("wheelrail", "")],
    "rollcon_wheelrail_solve_many": [
        ("wheelrail", ""), ("n", ""), ("positions", ""), ("velocities", ""), ("columns", ""),
        ("totals", ""), ("status", "")
    ],
    "rollcon_wheelrail_find_wear": [
        ("wheelrail", ""), ("n_cases", ""), ("positions", ""), ("velocities", ""), ("weights",
        ""), ("law", ""), ("n", ""), ("parameters", ""), ("points", ""), ("wheel", ""), ("rail",
        ""), ("volumes", ""), ("status", "")
    ],
    "rollcon_wheelrail_snapshot": [("wheelrail", ""), ("place", "")],
    "rollcon_wheelrail_rollback": [("wheelrail", ""), ("place", "")],
    "rollcon_wheelrail_copy": [("wheelrail", ""), ("copy", "")],
    "rollcon_wheelrail_reset": [("wheelrail", "")],
    "rollcon_wheelrail_set_int": [("wheelrail", ""), ("name", ""), ("value", "")],
    "rollcon_wheelrail_set_real": [("wheelrail", ""), ("name", ""), ("value", "")],
    "rollcon_wheelrail_get_int": [("wheelrail", ""), ("name", ""), ("value", "")],
    "rollcon_wheelrail_get_real": [("wheelrail", ""), ("name", ""), ("value", "")],
    "rollcon_wheelrail_get_patch_count": [("wheelrail", ""), ("patches", "")],
    "rollcon_wheelrail_get_resultant": [
        ("wheelrail", ""), ("axes", "axes of the track"), ("force", ""), ("moment", "")
    ],
    "rollcon_wheelrail_get_derivative": [
        ("wheelrail", ""), ("entry", ""), ("force", ""), ("moment", ""), ("z", "")
    ],
    "rollcon_wheelrail_get_stat": [("wheelrail", ""), ("name", ""), ("value", "")],
    "rollcon_wheelrail_get_profile_point": [
        ("wheelrail", ""), ("which", "profile of a wheel on its rail"), ("share", ""), ("point",
        "")
    ],
    "rollcon_wheelrail_get_patch_stat": [
        ("wheelrail", ""), ("patch", ""), ("name", ""), ("value", "")
    ],
    "rollcon_wheelrail_get_patch_axes": [
        ("wheelrail", ""), ("patch", ""), ("origin", ""), ("axes", "")
    ],
    "rollcon_wheelrail_get_contact": [("wheelrail", ""), ("patch", ""), ("contact", "")],
    "rollcon_wheelrail_find_contact_points": [
        ("left", ""), ("right", ""), ("n", ""), ("shift", ""), ("columns", ""), ("points", "")
    ],
    "rollcon_wheelrail_find_conicity": [
        ("left", ""), ("right", ""), ("n", ""), ("amplitude", ""), ("conicity", ""),
        ("wavelength", "")
    ],
    "rollcon_option_count": [("kind", "kind of object")],
    "rollcon_option_info": [
        ("kind", "kind of object"), ("i", ""), ("capacity", ""), ("name", ""), ("doc", ""),
        ("needed", ""), ("type", ""), ("low", ""), ("high", ""), ("standard", "")
    ],
    "rollcon_stat_count": [("kind", "kind of object")],
    "rollcon_stat_info": [
        ("kind", "kind of object"), ("i", ""), ("capacity", ""), ("name", ""), ("doc", ""),
        ("needed", ""), ("inside", "")
    ],
    "rollcon_report": [("handle", ""), ("status", ""), ("message", "")],
    "rollcon_context_retain": [("context", "")],
    "rollcon_body_retain": [("body", "")],
    "rollcon_contact_retain": [("contact", "")],
    "rollcon_wheelrail_retain": [("wheelrail", "")],
    "rollcon_table_retain": [("table", "")],
    "rollcon_id_of": [("handle", "")],
    "rollcon_context_from_id": [("id", "")],
    "rollcon_body_from_id": [("id", "")],
    "rollcon_contact_from_id": [("id", "")],
    "rollcon_wheelrail_from_id": [("id", "")],
    "rollcon_table_from_id": [("id", "")],
    "rollcon_table_create": [("context", ""), ("table", "")],
    "rollcon_table_release": [("table", "")],
    "rollcon_table_load": [("context", ""), ("path", ""), ("table", "")],
    "rollcon_table_standard": [("context", ""), ("table", "")],
    "rollcon_table_set_ratios": [("table", ""), ("intervals", ""), ("least", ""), ("greatest", "")],
    "rollcon_table_set_resolution": [
        ("table", ""), ("magnitudes", ""), ("angles", ""), ("directions", "")
    ],
    "rollcon_table_set_frame": [("table", ""), ("along", ""), ("across", "")],
    "rollcon_table_set_poissons": [("table", ""), ("n", ""), ("poissons", "")],
    "rollcon_table_set_bodies": [
        ("table", ""), ("youngs", ""), ("poissons", ""), ("n", ""), ("frictions", "")
    ],
    "rollcon_table_set_progress": [("table", ""), ("fn", ""), ("user", "")],
    "rollcon_table_request_cancel": [("table", "")],
    "rollcon_table_make": [("table", ""), ("part", ""), ("parts", "")],
    "rollcon_table_get_samples": [("table", ""), ("capacity", ""), ("samples", ""), ("count", "")],
    "rollcon_table_add_samples": [("table", ""), ("n", ""), ("samples", "")],
    "rollcon_table_save": [("table", ""), ("path", "")],
    "rollcon_table_evaluate": [("table", ""), ("n", ""), ("inputs", ""), ("results", "")],
    "rollcon_table_evaluate_derivatives": [
        ("table", ""), ("n", ""), ("inputs", ""), ("results", ""), ("derivatives", "")
    ],
    "rollcon_table_evaluate_contact": [
        ("table", ""), ("contact", ""), ("friction", ""), ("results", "")
    ],
}


def declare(library):
    """Gives every function of a loaded library its types."""
    for name, (restype, argtypes) in FUNCTIONS.items():
        function = getattr(library, name)
        function.restype = restype
        function.argtypes = argtypes
    return library
