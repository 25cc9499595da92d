/*
 * rollcon 1.0.0-rc2: frictional rolling contact of elastic bodies.
 *
 * Generated from bindings/api.toml by bindings/generate.py; do not edit.
 * Copyright (c) the rollcon authors. BSD-3-Clause.
 *
 * C90 with <stdint.h>, C++98; no other header is needed.
 *
 * What holds for all functions; their comments say the rest (docs/api.md says more):
 *  - A function that can fail returns a rollcon_status: 0 success, > 0 usable with a caveat,
 *    < 0 failed, and then the object is unchanged unless the function's comment says otherwise.
 *  - rollcon_last_error() tells in words why the last call of this thread that failed did so,
 *    rollcon_last_caveat() what the last one that returned a status > 0 has to say.
 *  - NULL gives ROLLCON_ERR_ARGUMENT, as does a value out of range, unless a comment says
 *    otherwise; released, garbage and wrong-kind handles give ROLLCON_ERR_HANDLE; an object that
 *    another call is using ROLLCON_ERR_BUSY. Comments list what else is returned.
 *  - Threads: one at a time per object, unless a comment says "any": then any thread at any time.
 *  - Arguments: the object, inputs (count before array), outputs. Inputs are copied, results are
 *    copied out. NaN and infinity are refused (ROLLCON_ERR_NONFINITE).
 *  - A text comes out as (capacity, text, needed): bytes at text, the NUL counted, and the bytes
 *    needed; other results of unknown length alike. Capacity 0 only asks for the need, with NULL
 *    for the result; one that is too small is ROLLCON_ERR_CAPACITY and tells the need, too. The
 *    need may be NULL otherwise.
 *  - New handles are the caller's to release, and NULL after a failure.
 *  - Programs that check once, at their end, set rollcon_context_set_latch.
 *  - Vectors are stored x y z, x y z, ...: x[n][3] in C, x(3,n) in Fortran.
 *  - Any consistent set of units; the reference says force, length and time. Angles in radians.
 *  - Axes: n is the outward normal of body 1, t1 the rolling direction, t2 = n x t1. Tractions and
 *    forces are those on body 1; slip is that of body 1 relative to body 2.
 */
#ifndef ROLLCON_H
#define ROLLCON_H

#include <stdint.h>

#define ROLLCON_VERSION_MAJOR 1
#define ROLLCON_VERSION_MINOR 0
#define ROLLCON_VERSION_PATCH 0
#define ROLLCON_VERSION_PRERELEASE "rc2" /* "rc2" and the like; empty: a release */
#define ROLLCON_VERSION_STRING "1.0.0-rc2"
/* Number of the binary interface: of the shared library's SONAME; for rollcon_context_create. */
#define ROLLCON_ABI 1

/* Consumers of a static library on Windows define ROLLCON_STATIC; the build of the shared one
   defines ROLLCON_BUILDING. */
#ifndef ROLLCON_API
#if defined(_WIN32) && defined(ROLLCON_STATIC)
#define ROLLCON_API
#elif defined(_WIN32) && defined(ROLLCON_BUILDING)
#define ROLLCON_API __declspec(dllexport)
#elif defined(_WIN32)
#define ROLLCON_API __declspec(dllimport)
#elif defined(__GNUC__)
#define ROLLCON_API __attribute__((visibility("default")))
#else
#define ROLLCON_API
#endif
#endif
#if defined(_WIN32)
#define ROLLCON_CALL __cdecl
#else
#define ROLLCON_CALL
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Handles: opaque, never dereferenced, reference counted. */
typedef struct rollcon_context rollcon_context;
typedef struct rollcon_body rollcon_body;
typedef struct rollcon_contact rollcon_contact;
typedef struct rollcon_wheelrail rollcon_wheelrail;
typedef struct rollcon_table rollcon_table;
/* Only inside a progress callback. */
typedef struct rollcon_event rollcon_event;

/* Returned by every function that can fail: 0 success, > 0 usable with a caveat, < 0 failed. */
enum {
  ROLLCON_OK              = 0,    /* success */
  ROLLCON_NOT_CONVERGED   = 1,    /* iteration limit reached; the best iterate is kept */
  ROLLCON_NO_CONTACT      = 2,    /* the bodies do not touch; tractions are zero */
  ROLLCON_CANCELLED       = 3,    /* stopped by the progress callback or by a cancel request */
  ROLLCON_RIM_CONTACT     = 4,    /* the contact reaches the rim of the frame (a body's own edge does not count) or the end of a profile: caveat and plan say what to mend */
  ROLLCON_COARSE          = 5,    /* too few nodes touch, results may be off by half and more: refine the frame there */
  ROLLCON_INACCURATE      = 6,    /* the accuracy asked for (option frame_accuracy) was not reached (statistic error_estimate says which was), or the mesh of a body is too coarse to show what the contact does to it */
  ROLLCON_TOO_DEEP        = 7,    /* the bodies are pressed together as no linear material bears: by more than half of a thickness or radius, with pressures above the modulus of contact, or a wheel by more than a thousandth of its radius; check shapes, heights, load and units */
  ROLLCON_DERAILED        = 8,    /* the wheel is beside its rail, whatever its height; forces are zero */
  ROLLCON_ERR_ARGUMENT    = -1,   /* NULL, negative count, value out of range, unknown number */
  ROLLCON_ERR_HANDLE      = -2,   /* released, garbage or wrong-kind handle */
  ROLLCON_ERR_NONFINITE   = -3,   /* NaN or infinity among the inputs, or among the results */
  ROLLCON_ERR_MESH        = -4,   /* node id out of range; degenerate or flipped elements, ... */
  ROLLCON_ERR_STATE       = -5,   /* calls in the wrong order, or something is missing */
  ROLLCON_ERR_OPTION      = -6,   /* unknown name, wrong type or value out of range */
  ROLLCON_ERR_CAPACITY    = -7,   /* the caller's array is too small; the need is reported */
  ROLLCON_ERR_SINGULAR    = -8,   /* a linear system is singular; a body is not held */
  ROLLCON_ERR_MEMORY      = -9,   /* out of memory or of handles */
  ROLLCON_ERR_UNSUPPORTED = -10,  /* not in this build of the library, or made for another one */
  ROLLCON_ERR_BUSY        = -11,  /* the object is in use by another call */
  ROLLCON_ERR_LOAD        = -12,  /* the prescribed forces have no steady solution */
  ROLLCON_ERR_IO          = -13,  /* a file cannot be written or read */
  ROLLCON_ERR_INTERNAL    = -99   /* a defect of rollcon; please report it */
};
typedef int32_t rollcon_status;

/* Model of a body. */
enum {
  ROLLCON_BODY_FEM       = 1,    /* finite elements: a volume mesh, one material for each tag (ROLLCON_ERR_UNSUPPORTED in builds without them) */
  ROLLCON_BODY_BEM       = 2,    /* boundary elements: a closed surface mesh, one material (ROLLCON_ERR_UNSUPPORTED in builds without them) */
  ROLLCON_BODY_HALFSPACE = 3,    /* elastic half-space: material, no mesh; a profile only to compute gaps */
  ROLLCON_BODY_RIGID     = 4,    /* rigid: no material; a surface mesh or a profile only to compute gaps */
  ROLLCON_BODY_SECTION   = 5,    /* the plane mesh of a section, one material for each tag, turned about an axis (rollcon_body_revolve) or drawn along a line (rollcon_body_extrude); ROLLCON_ERR_UNSUPPORTED in builds without finite elements */
  ROLLCON_BODY_CONDENSED = 6     /* surface elements on nodes whose stiffness or flexibility is given (rollcon_body_set_condensed, rollcon_body_read_condensed), one material; ROLLCON_ERR_UNSUPPORTED in builds without finite elements */
};

/* What a given matrix tells of a body. */
enum {
  ROLLCON_STIFFNESS   = 1,    /* forces under displacements */
  ROLLCON_FLEXIBILITY = 2     /* displacements under forces; a component that does not move has zeros */
};

/* Elements of contact frames, of the surfaces of bodies, and of finite-element bodies. Surface
   elements: corners counter-clockwise seen from the tip of the normal (of bodies: the outward
   one), then the edge midpoints in the same order (the first between corners 1 and 2), then the
   centre. Volume elements: tetrahedra have corners 1 2 3 counter-clockwise seen from corner 4,
   wedges and hexahedra a bottom face counter-clockwise seen from the top, then the top face above
   it; then the edge midpoints, of tetrahedra 12 23 31 14 24 34, of wedges 12 23 31 45 56 64 14 25
   36, of hexahedra 12 23 34 41 56 67 78 85 15 26 37 48. Faces by their corners: tetrahedron 123,
   124, 234, 134; wedge 123, 456, 1254, 2365, 3146; hexahedron 1234, 5678, 1265, 2376, 3487, 4158. */
enum {
  ROLLCON_TRI3    = 203,  /* linear triangle */
  ROLLCON_TRI6    = 206,  /* quadratic triangle */
  ROLLCON_QUAD4   = 214,  /* bilinear quadrilateral */
  ROLLCON_QUAD8   = 218,  /* serendipity quadrilateral */
  ROLLCON_QUAD9   = 219,  /* biquadratic quadrilateral */
  ROLLCON_TET4    = 304,  /* linear tetrahedron; stiff, and refused near incompressibility: prefer TET10 */
  ROLLCON_TET10   = 310,  /* quadratic tetrahedron */
  ROLLCON_WEDGE6  = 326,  /* linear wedge */
  ROLLCON_WEDGE15 = 335,  /* serendipity wedge */
  ROLLCON_HEX8    = 338,  /* trilinear hexahedron, cured of locking */
  ROLLCON_HEX20   = 350   /* serendipity hexahedron */
};

/* Displacement components that a support holds, in the axes of the body's nodes; they may be
   added. */
enum {
  ROLLCON_DOF_X   = 1,    /* along x */
  ROLLCON_DOF_Y   = 2,    /* along y */
  ROLLCON_DOF_Z   = 4,    /* along z */
  ROLLCON_DOF_XYZ = 7     /* all three */
};

/* Directions of loads and motions, in the axes (t1, t2, n) of the contact. */
enum {
  ROLLCON_LONGITUDINAL = 1,    /* along t1, the rolling direction */
  ROLLCON_LATERAL      = 2,    /* along t2 = n x t1 */
  ROLLCON_NORMAL       = 3,    /* along n, the outward normal of body 1 */
  ROLLCON_SPIN         = 4,    /* rotation about n */
  ROLLCON_TILT_1       = 6,    /* rotation about t1 (5 is ROLLCON_FRICTION) */
  ROLLCON_TILT_2       = 7     /* rotation about t2 */
};

/* Parameters of rollcon_contact_get_sensitivity besides the directions, which stand for what is
   prescribed there. */
enum {
  ROLLCON_FRICTION = 5     /* a factor on the friction coefficient of every node */
};

/* Ways to prescribe a direction. */
enum {
  ROLLCON_BY_MOTION = 1,    /* approach, creepage or spin is given; the force is found */
  ROLLCON_BY_FORCE  = 2     /* force or moment is given; approach, creepage or spin is found */
};

/* Components of results. */
enum {
  ROLLCON_LOCAL  = 0,    /* (t1, t2, n) of the contact; on curved frames that of each node */
  ROLLCON_GLOBAL = 1     /* (x, y, z) in which the frame's nodes were given */
};

/* Nodal results: values per node in brackets. Slip has 2 values in local axes, 3 in global ones;
   scalars ignore the axes. */
enum {
  ROLLCON_FIELD_POINT          = 1,    /* [3] position of the node */
  ROLLCON_FIELD_TRACTION       = 2,    /* [3] traction on body 1; normal component <= 0, along levelled normals (rollcon_contact_get_tractions) */
  ROLLCON_FIELD_GAP            = 3,    /* [1] gap of the deformed bodies along levelled normals */
  ROLLCON_FIELD_SLIP           = 4,    /* [2 or 3] slip velocity of body 1 relative to body 2 */
  ROLLCON_FIELD_DISPLACEMENT1  = 5,    /* [3] elastic displacement of body 1 */
  ROLLCON_FIELD_DISPLACEMENT2  = 6,    /* [3] elastic displacement of body 2 */
  ROLLCON_FIELD_AREA           = 7,    /* [1] area of the node's median-dual cell */
  ROLLCON_FIELD_FRICTION       = 8,    /* [1] friction coefficient: the law's greatest one, or the one at the slip speed found */
  ROLLCON_FIELD_PRESSURE       = 9,    /* [1] contact pressure >= 0, along levelled normals */
  ROLLCON_FIELD_RIGID_SLIP     = 10,   /* [2 or 3] slip velocity of the undeformed bodies */
  ROLLCON_FIELD_FRICTION_POWER = 11,   /* [1] frictional power per area, >= 0 */
  ROLLCON_FIELD_WEIGHT         = 12,   /* [1] integral of the shape function */
  ROLLCON_FIELD_TEMPERATURE    = 13    /* [2] temperature of the surfaces of bodies 1 and 2 (rollcon_contact_set_heat) */
};

/* Side of the track, seen in the direction x of the track. */
enum {
  ROLLCON_LEFT  = -1,   /* y < 0 */
  ROLLCON_RIGHT = 1     /* y > 0 */
};

/* The bodies of a contact. */
enum {
  ROLLCON_BODY1 = 1,    /* the body on which tractions and forces are those reported; n points out of it */
  ROLLCON_BODY2 = 2     /* the other one */
};

/* What rollcon_contact_set_velocity takes besides the bodies. */
enum {
  ROLLCON_CONTACT_ITSELF = 0     /* the contact itself, which travels over both bodies */
};

/* The bodies of a wheel on its rail. */
enum {
  ROLLCON_WHEEL = 1,    /* the wheel */
  ROLLCON_RAIL  = 2     /* the rail */
};

/* The side of a profile on which its body lies. */
enum {
  ROLLCON_BODY_BELOW = 1,    /* at greater z: a rail with z down */
  ROLLCON_BODY_ABOVE = -1    /* at lesser z: a wheel with z down */
};

/* Axes in which points inside a body, and fields there, are given. */
enum {
  ROLLCON_IN_CONTACT = 0,    /* (t1, t2, n) of the contact, from their origin */
  ROLLCON_IN_BODY    = 1     /* those of the body (rollcon_contact_set_pose) */
};

/* Components of the results of a wheel on its rail. */
enum {
  ROLLCON_IN_TRACK    = 0,    /* x forward, y to the right, z down, of the track */
  ROLLCON_IN_WHEELSET = 1     /* x, y, z turned with the wheelset's yaw and roll */
};

/* State of a node of the frame. */
enum {
  ROLLCON_OPEN     = 0,    /* no contact */
  ROLLCON_STICK    = 1,    /* in contact, no slip */
  ROLLCON_SLIP     = 2,    /* in contact, slipping */
  ROLLCON_EXCLUDED = 3     /* belongs to no element: carries no traction */
};

/* Kinds of a solve in time. */
enum {
  ROLLCON_STEADY       = 0,    /* steady rolling, without a past */
  ROLLCON_ROLLING_STEP = 1,    /* one step of rolling: material comes with the displacements of the step before */
  ROLLCON_SHIFT_STEP   = 2     /* one step of bodies that are shifted against each other and do not roll */
};

/* Levels of messages; a sink gets those up to its own level. 0 turns the log off. */
enum {
  ROLLCON_LOG_ERROR   = 1,    /* failures of calls */
  ROLLCON_LOG_WARNING = 2,    /* results to be taken with care */
  ROLLCON_LOG_INFO    = 3,    /* one line per phase of a solve */
  ROLLCON_LOG_DEBUG   = 4     /* one line per iteration */
};

/* Type of a solver setting. */
enum {
  ROLLCON_TYPE_INT  = 1,    /* integer: ..._set_int */
  ROLLCON_TYPE_REAL = 2,    /* real: ..._set_real */
  ROLLCON_TYPE_STR  = 3     /* text: ..._set_str */
};

/* Objects that have settings or statistics. */
enum {
  ROLLCON_OF_BODY      = 2,    /* a body */
  ROLLCON_OF_CONTACT   = 3,    /* a contact */
  ROLLCON_OF_WHEELRAIL = 4,    /* a wheel on its rail */
  ROLLCON_OF_PATCH     = 6,    /* a patch of a wheel on its rail */
  ROLLCON_OF_PROCEDURE = 7     /* options of rollcon_contact_set_procedure */
};

/* Entries of an event that a progress callback can read: integers below 100, reals above. */
enum {
  ROLLCON_EVENT_PHASE     = 1,    /* one of ROLLCON_PHASE_... */
  ROLLCON_EVENT_ITERATION = 2,    /* iteration within the phase, from 0 */
  ROLLCON_EVENT_RESIDUAL  = 101,  /* relative residual of the iterate */
  ROLLCON_EVENT_SECONDS   = 102   /* seconds since the solve began */
};

/* Phases of a solve. */
enum {
  ROLLCON_PHASE_COMPLIANCE = 1,    /* bodies, and their compliance on the frame; iteration 0 is its end, 1, 2, ... come before */
  ROLLCON_PHASE_NORMAL     = 2,    /* normal problem alone */
  ROLLCON_PHASE_TANGENTIAL = 3,    /* tangential problem at given pressure */
  ROLLCON_PHASE_FULL       = 4,    /* normal and tangential problem together */
  ROLLCON_PHASE_CASES      = 5     /* a case of rollcon_contact_solve_many ended; the iteration is the number of those solved so far */
};

/* Receives log messages. `message` has no newline at its end and is valid during the call only.
   The library calls it in the floating-point environment of the host. */
typedef void (ROLLCON_CALL *rollcon_log_fn)(int32_t level, const char *message, void *user);

/* Receives the progress of a solve, once per iteration and now and then during preparation, in
   the thread that called rollcon_contact_solve and in the floating-point environment of the host.
   A non-zero return cancels. The event is valid during the call only. The contact itself is busy
   meanwhile: of its functions only rollcon_contact_request_cancel works. */
typedef int32_t (ROLLCON_CALL *rollcon_progress_fn)(const rollcon_event *event, void *user);

/* ----------------------------------------------------------------------------- Library facts */
/* These functions may be called at any time, from any thread, need no object and never fail. */

/*
 * Returns the version of the library: 10000 major + 100 minor + patch.
 * Threads: any.
 */
ROLLCON_API int32_t ROLLCON_CALL rollcon_version(void);

/*
 * Returns the binary interface number of the library, which is that of the shared library's
 * SONAME and equals ROLLCON_ABI of a header that fits.
 * Threads: any.
 */
ROLLCON_API int32_t ROLLCON_CALL rollcon_abi(void);

/*
 * Returns the version as text, "major.minor.patch".
 * Threads: any.
 */
ROLLCON_API const char *ROLLCON_CALL rollcon_version_string(void);

/*
 * Returns the licences that this build carries and how it was built, as one line of text.
 * Threads: any.
 */
ROLLCON_API const char *ROLLCON_CALL rollcon_build_info(void);

/*
 * Returns 1 if this build has the feature, 0 if not or if the name is unknown or NULL.
 *   name  may be NULL; one of the features listed in the reference
 * Threads: any.
 */
ROLLCON_API int32_t ROLLCON_CALL rollcon_has_feature(const char *name);

/*
 * Returns one line of text for a status; "unknown status" for other numbers.
 *   status  any number
 * Threads: any.
 */
ROLLCON_API const char *ROLLCON_CALL rollcon_status_string(int32_t status);

/* ---------------------------------------------------------------------------------- Failures */
/* The calls of this group tell in words what went wrong. They may be called at any time, from any
   thread. */

/*
 * Returns the text of the last call that failed in this thread: name of the function, offending
 * entry, allowed range. It is empty before the first failure. Every negative status leaves its
 * text, also that of a dead handle; successes do not change the last text. It is valid until the
 * next failure in this thread; texts beyond 2047 bytes are cut.
 * Threads: any.
 */
ROLLCON_API const char *ROLLCON_CALL rollcon_last_error(void);

/*
 * Returns the text of the last call in this thread that returned a status above zero: name of the
 * function, what the status means, and what is known of this case: how many nodes touch, how far
 * the iteration came, where the frame ends. It is empty before the first one, and failures and
 * successes do not change it. It is valid until the next such call in this thread; texts beyond
 * 1023 bytes are cut.
 * Threads: any.
 */
ROLLCON_API const char *ROLLCON_CALL rollcon_last_caveat(void);

/* ----------------------------------------------------------------------------------- Context */
/* Owns the log sink, the thread budget and the latch. Different contexts are independent. */

/*
 * Makes a context.
 *   header_abi  ROLLCON_ABI of the caller's header; ROLLCON_ERR_UNSUPPORTED if the library has
 *               another
 *   context     new handle
 * Ownership: The caller owns the new handle: release it. *context is NULL after a failure.
 * Also returns: ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_MEMORY.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_context_create(int32_t header_abi,
    rollcon_context **context);

/*
 * Drops a reference; the handle is dead after the last one. Bodies and contacts made from the
 * context keep what they need of it. NULL and dead handles are ignored.
 *   context  may be NULL
 * Threads: any.
 */
ROLLCON_API void ROLLCON_CALL rollcon_context_release(rollcon_context *context);

/*
 * Sets the log sink.
 *   max_level  0 (off) to 4: most talkative level wanted
 *   fn         NULL turns the log off
 *   user       handed to fn
 * Ownership: `user` stays the caller's and must live until the sink is replaced or the context
 *   and all it made are gone.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_context_set_log(rollcon_context *context,
    int32_t max_level, rollcon_log_fn fn, void *user);

/*
 * Sets the most threads that each solve, each preparation of a body and each list of cases,
 * positions or samples in this context may use. Many parts use fewer: the BLAS has one thread on
 * frames of less than 2000 nodes and where operators are not dense, sparse factorisations have
 * one and that of the BLAS, each case of a list has one, and inside a parallel region of the
 * caller everything has one.
 *   n        0 to 4096; 0 (standard): as many as OpenMP would use
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_context_set_threads(rollcon_context *context,
    int32_t n);

/*
 * Lets the ranks of an MPI program share work. All ranks of the communicator make the same calls
 * with the same data. From then on rollcon_contact_solve_many, rollcon_wheelrail_solve_many,
 * rollcon_wheelrail_find_wear and rollcon_table_make are joint calls of all ranks, on this
 * context and on all that is made from it: each rank solves its share, and every rank gets all
 * results and statuses, the same to the bit as on one rank. So is rollcon_body_prepare of finite
 * elements with option factor_ranks, which all ranks factorise together. A failure on one rank is
 * a failure on all of them, and the text names the rank. The cases left to a rank that is asked
 * to stop are cancelled. This call itself is a joint call of all ranks. Calls that are not named
 * here are each rank's own. The communicator remains the caller's, who frees it after the
 * context. ROLLCON_ERR_STATE: MPI does not run. ROLLCON_ERR_UNSUPPORTED: the build is without MPI
 * (rollcon_has_feature "mpi").
 *   communicator  its Fortran handle: MPI_Comm_c2f(communicator) in C, communicator%MPI_VAL in
 *                 mpi_f08
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_UNSUPPORTED.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_context_set_communicator(
    rollcon_context *context, int32_t communicator);

/*
 * Turns the latch on or off, for programs that check once, at the end. While the latch is on, the
 * first call that fails on the context or on what was made from it is remembered, and every later
 * one does nothing and returns the same status, with the same last error. Release, retain,
 * rollcon_contact_request_cancel, rollcon_body_get_kind and the calls of this latch work on.
 * Outputs of calls that do nothing keep the values that they had, handles to be made are NULL.
 * Calls that have no live handle belong to no context.
 *   on       1: on, 0: off (standard); either forgets what was remembered
 * Also returns: ROLLCON_ERR_MEMORY.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_context_set_latch(rollcon_context *context,
    int32_t on);

/*
 * Returns the first failure since the latch was set, whose text becomes the last error; without
 * one the first status > 0 (a solve that did not converge, ...); without either, or with the
 * latch off, ROLLCON_OK. Any negative status may be returned.
 * Also returns: ROLLCON_NOT_CONVERGED, ROLLCON_NO_CONTACT, ROLLCON_CANCELLED,
 *   ROLLCON_RIM_CONTACT.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_context_check(const rollcon_context *context);

/* -------------------------------------------------------------- Body: making, material, life */
/* One of the two bodies of a contact. A prepared body is frozen, and contacts in many threads may
   use it at once. Half-spaces need a material only and rigid planes nothing; all others have a
   mesh. */

/*
 * Makes a body.
 *   kind     ROLLCON_BODY_...
 *   body     new handle
 * Ownership: The caller owns the new handle: release it. The body keeps what it needs of the
 *   context. *body is NULL after a failure.
 * Also returns: ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_create(rollcon_context *context,
    int32_t kind, rollcon_body **body);

/*
 * Drops a reference; the handle is dead after the last one. Contacts keep their bodies alive.
 * NULL and dead handles are ignored.
 *   body  may be NULL
 * Threads: any.
 */
ROLLCON_API void ROLLCON_CALL rollcon_body_release(rollcon_body *body);

/*
 * Sets an isotropic linear elastic material.
 *   body     not rigid, not prepared (ROLLCON_ERR_STATE)
 *   tag      finite elements: tag of the volume elements that get the material; half-spaces and
 *            boundary-element bodies, of one material, ignore it
 *   young    Young's modulus E > 0, force/length^2
 *   poisson  Poisson's ratio, -1 < nu <= 0.5; finite elements take up to 0.4999999, TET4 and
 *            WEDGE6 up to 0.45 (ROLLCON_ERR_UNSUPPORTED from rollcon_body_prepare)
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_elastic(rollcon_body *body, int32_t tag,
    double young, double poisson);

/*
 * Lets a material of a half-space or a section relax: at a time t after a strain Young's modulus
 * is E (1 - sum of ratio (1 - exp(-t / time))), where E is that of rollcon_body_set_elastic.
 * Poisson's ratio does not change. Such bodies are solved in steady rolling only, at the speed of
 * rollcon_contact_set_rolling: time steps, conformal contacts, wear, tables and wheels on rails
 * end with ROLLCON_ERR_UNSUPPORTED. The statistic rolling_resistance is the force that rolling
 * costs.
 *   body    a half-space or a section, not prepared (ROLLCON_ERR_STATE)
 *   tag     sections: tag of the elements; half-spaces, of one material, ignore it
 *   n       terms, 0 to 100; 0: the material is elastic
 *   ratios  [n]; part of E that each term loses, 0 <= ratio < 1; their sum is less than 1 - 1e-6
 *   times   [n]; relaxation time of each term, > 0
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, section 3.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_viscoelastic(rollcon_body *body,
    int32_t tag, int64_t n, const double *ratios, const double *times);

/*
 * Lets a material relax as rollcon_body_set_viscoelastic does, by moduli over frequency instead
 * of terms. They take the place of Young's modulus; rollcon_body_set_elastic gives Poisson's
 * ratio before. Sections take the moduli as they are: linear in the logarithm of the frequency
 * between points; beyond them the storage modulus stays, and the loss modulus falls with the
 * frequency or its inverse. Half-spaces take the Prony series, eight terms a decade, that is
 * nearest to them. ROLLCON_ERR_ARGUMENT: it is off a modulus by more than 10 %; beyond 2 % the
 * log warns.
 *   body         a half-space or a section, not prepared (ROLLCON_ERR_STATE)
 *   tag          sections: tag of the elements; half-spaces, of one material, ignore it
 *   n            points, 0 to 10,000; 0: the material is elastic
 *   frequencies  [n]; angular frequencies, > 0 and ascending, radians per time
 *   storage      [n]; storage modulus at each, > 0, force/length^2
 *   loss         [n]; loss modulus at each, >= 0, force/length^2
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, section 3.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_moduli(rollcon_body *body, int32_t tag,
    int64_t n, const double *frequencies, const double *storage, const double *loss);

/*
 * Checks that the body is complete and its mesh and supports sound, assembles and factorises its
 * equations, and freezes it. The call is optional: the first solve does it. Calling it again does
 * nothing. (Finite elements with many contact faces and no loads of their own are factorised when
 * a frame tells which part of the faces takes part.) ROLLCON_ERR_MESH names the offending
 * elements or nodes: double nodes, degenerate or repeated elements, neighbours of opposite
 * orientation, and for elastic bodies open edges, normals that point inwards, more than one outer
 * shell; for finite elements turned elements, faces that meet without matching, parts that share
 * no face, tagged faces that are not on the boundary. A body equal to one that is prepared in the
 * same context (mesh, tags, material, supports, loads, contact faces, options) uses its
 * equations: nothing is assembled again. ROLLCON_ERR_SINGULAR: the supports leave the body free
 * to move, and the text says how; hold it (three nodes not on a line, or a hub), since what is
 * held is also what approach and creepage move.
 * Ownership: After a failure the body is unchanged and not prepared; mend it and prepare it
 *   again.
 * Also returns: ROLLCON_ERR_MESH, ROLLCON_ERR_STATE, ROLLCON_ERR_SINGULAR, ROLLCON_ERR_MEMORY,
 *   ROLLCON_ERR_UNSUPPORTED.
 * Source: docs/theory.md, sections 9 and 10; equations (53) to (57) and (61) of the paper.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_prepare(rollcon_body *body);

/*
 * Returns the model given to rollcon_body_create.
 *   kind  out; ROLLCON_BODY_...
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_kind(const rollcon_body *body,
    int32_t *kind);

/*
 * Writes the body, prepared if it was not, to a file: all that was given, the factors, and the
 * responses to frames that it has cached (option cache_bytes). The file appears whole or not at
 * all; an older one is replaced. Poses belong to contacts and are not written. Every library of
 * the same ABI number and format reads it, on any machine of the same byte order with IEEE
 * numbers.
 *   path  name of the file
 * Also returns: ROLLCON_ERR_IO, ROLLCON_ERR_MESH, ROLLCON_ERR_STATE, ROLLCON_ERR_SINGULAR,
 *   ROLLCON_ERR_MEMORY, ROLLCON_ERR_UNSUPPORTED.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_save(rollcon_body *body, const char *path);

/*
 * Makes a prepared body from a file of rollcon_body_save: nothing is assembled or factorised, and
 * solves give the same tractions as with the body that was saved. Statistics count what is done
 * from here on. A body equal to one of this context uses its factors, just as after
 * rollcon_body_prepare. ROLLCON_ERR_IO: the file cannot be read, is none of these, truncated or
 * changed; ROLLCON_ERR_UNSUPPORTED: it is of another ABI number, format or byte order, or has a
 * kind of body or of factors that this build does not have (hierarchical ones:
 * rollcon_has_feature "hmat"). The text names the file and what is wrong, where.
 *   path     name of the file
 *   body     new handle
 * Ownership: The caller owns the new handle: release it. The body keeps what it needs of the
 *   context. *body is NULL after a failure.
 * Also returns: ROLLCON_ERR_IO, ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_load(rollcon_context *context,
    const char *path, rollcon_body **body);

/*
 * Makes another body that was given the same and is not prepared, from one that is or is not.
 * Changed in its loads and prescribed displacements alone, and prepared, it takes the equations
 * of the first, and their factors: so several load cases of one body cost one assembly and
 * factorisation. (Finite elements factorise once more, with nothing condensed, for all cases
 * after the first, unless option keep_factors is 0; boundary elements integrate over loaded and
 * moved elements only.)
 *   copy  new handle
 * Ownership: The caller owns the new handle: release it. *copy is NULL after a failure.
 * Also returns: ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, section 10.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_copy(const rollcon_body *body,
    rollcon_body **copy);

/* ------------------------------------------------------------ Body: mesh, supports and loads */
/* These calls give bodies with a mesh what they are made of, in the body's own axes
   (rollcon_contact_set_pose says where it stands): nodes first, then elements, then what refers
   to them, and nothing after rollcon_body_prepare (ROLLCON_ERR_STATE). Half-spaces take none of
   it and rigid bodies no supports and loads (ROLLCON_ERR_STATE). */

/*
 * Sets the nodes and forgets elements, supports, loads and contact faces. Component j of node i
 * is x[i * node_stride + j * component_stride]: packed x[n][3] has strides 3 and 1, Fortran's
 * X(n,3) 1 and n.
 *   n                 nodes, 1 to 2147483647
 *   x                 [n*3]; coordinates, length
 *   node_stride       >= 1, in doubles
 *   component_stride  >= 1, in doubles
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_nodes(rollcon_body *body, int64_t n,
    const double *x, int64_t node_stride, int64_t component_stride);

/*
 * Adds elements of one type; types may be mixed by several calls. Surface elements: corners run
 * counter-clockwise seen from outside the body, so that normals point outwards. Finite-element
 * bodies take volume elements, whose outer faces are their surface, and surface elements too,
 * which only give their tag to the boundary face with the same nodes. Shapes, orientation and
 * closedness are checked by rollcon_body_prepare (ROLLCON_ERR_MESH there).
 *   type          ROLLCON_TRI3, TRI6, QUAD4, QUAD8 or QUAD9; finite elements: also ROLLCON_TET4,
 *                 TET10, WEDGE6, WEDGE15, HEX8, HEX20
 *   n             elements, >= 0
 *   connectivity  [n][nodes of the type]; node ids
 *   index_base    0 or 1: id of the first node; messages count the same way
 *   tag           surface elements: names these faces in loads, contact faces and
 *                 rollcon_contact_frame_from_body; tractions may jump where tags meet. Volume
 *                 elements: names their material
 * Also returns: ROLLCON_ERR_MESH, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_add_elements(rollcon_body *body,
    int32_t type, int64_t n, const int32_t *connectivity, int32_t index_base, int32_t tag);

/*
 * Gives a tag to boundary faces of finite elements, by element and face. Boundary faces that no
 * call names have tag 0; later calls win. Faces inside the body are found by rollcon_body_prepare
 * (ROLLCON_ERR_MESH there).
 *   body        of finite elements (else ROLLCON_ERR_STATE)
 *   n           faces, >= 0
 *   elements    [n]; volume elements, in the order in which they were added over all calls
 *   faces       [n]; face of each, in the order of ROLLCON_TET4, ...: see the element types
 *   index_base  0 or 1: number of the first element and of the first face of an element
 *   tag         names these faces in loads, contact faces and rollcon_contact_frame_from_body
 * Also returns: ROLLCON_ERR_MESH, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_tag_faces(rollcon_body *body, int64_t n,
    const int32_t *elements, const int32_t *faces, int32_t index_base, int32_t tag);

/*
 * Gives a tag to the faces all of whose nodes are given, midside nodes too: boundary faces of
 * finite elements (later calls win over earlier ones), or surface elements added so far.
 * rollcon_body_prepare refuses loads and contact faces whose tag is then on no face
 * (ROLLCON_ERR_MESH).
 *   body        with elements
 *   n           nodes, >= 0
 *   nodes       [n]; node ids; ROLLCON_ERR_MESH if out of range
 *   index_base  0 or 1: id of the first node
 *   tag         names these faces in loads, contact faces and rollcon_contact_frame_from_body
 * Also returns: ROLLCON_ERR_MESH, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_tag_faces_of_nodes(rollcon_body *body,
    int64_t n, const int32_t *nodes, int32_t index_base, int32_t tag);

/*
 * Holds displacement components of nodes, at zero or at given values. The call adds to what is
 * held already; a component held twice takes the last value. A face is held where all its nodes
 * are. A contact moves what is held rigidly with approach and creepage; values deform the body on
 * top of that.
 *   n           nodes to hold, >= 0
 *   nodes       [n]; node ids; ROLLCON_ERR_MESH if out of range
 *   index_base  0 or 1: id of the first node
 *   dof_mask    sum of ROLLCON_DOF_X, DOF_Y, DOF_Z: the components held, 1 to 7
 *   values      [n][3]; displacements x y z, length, -1e100 to 1e100; components outside of
 *               dof_mask are ignored; NULL: zero
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MESH, ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_support(rollcon_body *body, int64_t n,
    const int32_t *nodes, int32_t index_base, int32_t dof_mask, const double *values);

/*
 * Prescribes the traction on the faces with a tag; replaces an earlier one. A pressure on the
 * same tag is added to it. Faces without load or support are free.
 *   tag       of some face (else ROLLCON_ERR_ARGUMENT)
 *   traction  [3]; force/length^2 along x y z, -1e100 to 1e100
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_traction(rollcon_body *body,
    int32_t tag, const double *traction);

/*
 * Prescribes a force per volume, such as weight, on the finite elements with a tag; replaces an
 * earlier one. ROLLCON_ERR_STATE: a body without volume elements, and at rollcon_body_prepare a
 * tag that no element has.
 *   tag    of volume elements
 *   force  [3]; force/length^3 along x y z: density times acceleration; -1e100 to 1e100
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, section 10.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_body_force(rollcon_body *body,
    int32_t tag, const double *force);

/*
 * Prescribes the centrifugal forces of a steady rotation on the finite elements with a tag, added
 * to rollcon_body_set_body_force; replaces an earlier one. The stiffness is that of the body at
 * rest.
 *   tag      of volume elements
 *   density  mass/length^3, 0 to 1e100
 *   origin   [3]; on the axis of rotation, length
 *   rate     [3]; along the axis, radian/time
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, section 10.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_rotation(rollcon_body *body,
    int32_t tag, double density, const double *origin, const double *rate);

/*
 * Prescribes a pressure on the faces with a tag, against their outward normals; replaces an
 * earlier one and adds to a traction on the same tag.
 *   tag       of some face (else ROLLCON_ERR_ARGUMENT)
 *   pressure  force/length^2, -1e100 to 1e100; > 0 compresses
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_pressure(rollcon_body *body,
    int32_t tag, double pressure);

/*
 * Puts the faces with a tag on springs: a rail on its pad, a wheel on the rubber of its tyre. The
 * traction of the springs is minus the stiffness times the displacement. Springs hold a body as
 * supports do. Faces on springs are no contact faces unless rollcon_body_set_contact_faces names
 * them. rollcon_body_get_reaction returns the forces on held nodes, without those of springs.
 *   body       of finite elements, or a section (else ROLLCON_ERR_UNSUPPORTED)
 *   tag        of some face (else ROLLCON_ERR_ARGUMENT)
 *   stiffness  [3]; along x, y and z, force/length^3, 0 to 1e100
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_UNSUPPORTED,
 *   ROLLCON_ERR_MEMORY.
 * Source: docs/sections.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_springs(rollcon_body *body, int32_t tag,
    const double *stiffness);

/*
 * Prescribes tractions at nodes of the faces with a tag, interpolated by the faces' shape
 * functions, zero at nodes not named; replaces what an earlier call gave for the tag, and adds to
 * its traction and pressure. With a direction, `along`, the three components act along its part
 * in the surface, across (the outward normal times that), and along the outward normal. At
 * rollcon_body_prepare, ROLLCON_ERR_MESH: a node is on no face with the tag, or the direction is
 * normal to one.
 *   tag         of some face (else ROLLCON_ERR_ARGUMENT)
 *   n           nodes, >= 0; 0: none any more
 *   nodes       [n]; node ids; ROLLCON_ERR_MESH if out of range
 *   index_base  0 or 1: id of the first node
 *   along       [3]; direction of the first component; NULL or 0 0 0: components along x y z
 *   tractions   [n][3]; force/length^2, -1e100 to 1e100
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MESH, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, section 10.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_node_tractions(rollcon_body *body,
    int32_t tag, int64_t n, const int32_t *nodes, int32_t index_base, const double *along,
    const double *tractions);

/*
 * Says which faces may come into contact: gaps are computed and frames laid on them. The standard
 * is all faces that are neither held nor loaded.
 *   n     tags, >= 0; 0 returns to the standard
 *   tags  [n]; each of some face (else ROLLCON_ERR_ARGUMENT); NULL only with n = 0
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_contact_faces(rollcon_body *body,
    int64_t n, const int32_t *tags);

/*
 * Turns the plane mesh of a section into a body of revolution: a wheel, a ring, a roller. The
 * section's nodes lie in a half plane that ends at the axis. Supports, tractions and given
 * displacements are the same all the way round: their components are along x, y and z where the
 * section lies, and turn with it. A prepared body has the nodes and faces of the surface that its
 * contact edges sweep.
 *   body    a section, not prepared (else ROLLCON_ERR_STATE)
 *   origin  [3]; point of the axis, length
 *   axis    [3]; direction, of any length but 0
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 * Source: docs/sections.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_revolve(rollcon_body *body,
    const double *origin, const double *axis);

/*
 * Draws the plane mesh of a section along a line: a rail, a raceway strip. The section's nodes
 * lie in the plane through the origin at right angles to the line. Supports, tractions and given
 * displacements are the same all along the line. The contact's load repeats after the period,
 * which is long enough when results do not depend on it. The surface reaches as far to both sides
 * of the section as the section is wide: the contact must lie there.
 *   body       a section, not prepared (else ROLLCON_ERR_STATE)
 *   origin     [3]; a point in the section's plane, length
 *   direction  [3]; of the line, of any length but 0
 *   period     length after which all repeats, > 0
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 * Source: docs/sections.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_extrude(rollcon_body *body,
    const double *origin, const double *direction, double period);

/*
 * Gives a body of kind ROLLCON_BODY_CONDENSED its matrix: stiffness or flexibility of all its
 * nodes, in its axes, rows x, y, z of each node in their order, as another program condensed it.
 * rollcon_body_set_elastic gives the constants of the half-space between the nodes. Supports hold
 * nodes of a stiffness; a rigid motion that nothing holds ends rollcon_body_prepare with
 * ROLLCON_ERR_SINGULAR, which names it. ROLLCON_ERR_ARGUMENT names an entry that is not symmetric
 * (1e-6); preparing also checks that the matrix is definite. A matrix that gives way between
 * neighbouring nodes as one of a modulus more than 30 times larger or smaller does (other units)
 * makes solves end with ROLLCON_INACCURATE, and the caveat tells the factor.
 *   body    of kind condensed, with nodes, not prepared (else ROLLCON_ERR_STATE)
 *   form    ROLLCON_STIFFNESS or ROLLCON_FLEXIBILITY
 *   n       numbers, the square of three times the nodes
 *   matrix  [n]; row by row, force/length or length/force
 * Ownership: The numbers are copied. After a failure the body is unchanged.
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/condensed.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_condensed(rollcon_body *body,
    int32_t form, int64_t n, const double *matrix);

/*
 * Reads what rollcon_body_set_condensed takes from a file: MatrixMarket (array or coordinate,
 * general or symmetric), or a stiffness that Abaqus or CalculiX wrote for a substructure
 * (*SUBSTRUCTURE GENERATE and *SUBSTRUCTURE MATRIX OUTPUT), whose nodes are found by the numbers
 * that they have in the mesh's file, or are in the order in which the substructure names them if
 * the body's nodes are from arrays. ROLLCON_ERR_IO names file and line.
 *   body  of kind condensed, with nodes, not prepared (else ROLLCON_ERR_STATE)
 *   form  ROLLCON_STIFFNESS or ROLLCON_FLEXIBILITY
 *   path  name of the file
 * Ownership: The file is closed. After a failure the body is unchanged.
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_IO, ROLLCON_ERR_MEMORY.
 * Source: docs/condensed.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_read_condensed(rollcon_body *body,
    int32_t form, const char *path);

/*
 * Writes the stiffness or flexibility of a prepared body with a mesh on the nodes of its contact
 * faces, in the order of their ids, as a symmetric MatrixMarket file that
 * rollcon_body_read_condensed and other programs read. A comment lists the nodes' numbers. A
 * flexibility has zeros for components that supports hold; a stiffness then ends with
 * ROLLCON_ERR_SINGULAR.
 *   body  elastic, with a mesh, prepared
 *   form  ROLLCON_STIFFNESS or ROLLCON_FLEXIBILITY
 *   path  name of the file; an existing one is replaced
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_SINGULAR, ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_IO,
 *   ROLLCON_ERR_MEMORY.
 * Source: docs/condensed.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_write_condensed(const rollcon_body *body,
    int32_t form, const char *path);

/*
 * Takes nodes, elements and names from a file, in place of the whole former mesh: a file of Gmsh
 * if the name ends in .msh (versions 2 to 2.2 and 4.1, text or binary), of Abaqus or CalculiX if
 * it ends in .inp. Linear and quadratic tetrahedra, wedges and hexahedra for finite-element
 * bodies, with the surface elements that have a name; triangles and quadrilaterals for all
 * others, also as faces of volume elements that the surface `part` names. Orders of nodes are
 * changed to those of rollcon; hexahedra of 27 nodes and wedges of 18 lose those inside their
 * faces. Nodes that no element has are left out, the others keep the order of the file. Groups
 * are Gmsh's physical groups (nameless ones: "surface 2", ...), Abaqus's sets and surfaces. An
 * element's tag is its (first) physical group in Gmsh, else 0: rollcon_body_tag_group.
 * ROLLCON_ERR_IO names the file, the line (in binary files the byte) and what is wrong there;
 * ROLLCON_ERR_MESH: no element that the body could take. Shapes are checked by
 * rollcon_body_prepare.
 *   body  with a mesh, not prepared (else ROLLCON_ERR_STATE)
 *   path  name of the file, which ends in .msh or .inp
 *   part  name of a group (in any case): only its elements; "": those of the whole file
 * Ownership: After a failure the body is unchanged. The file is closed.
 * Also returns: ROLLCON_ERR_MESH, ROLLCON_ERR_STATE, ROLLCON_ERR_IO, ROLLCON_ERR_UNSUPPORTED,
 *   ROLLCON_ERR_MEMORY.
 * Source: docs/meshes.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_read_mesh(rollcon_body *body,
    const char *path, const char *part);

/*
 * Gives a tag to what the mesh's file has in a group: to volume elements (their material), to
 * surface elements and faces (loads, contact faces). A group of nodes alone names the faces all
 * of whose nodes it has. Later calls win.
 *   body   with a mesh that was read, not prepared (else ROLLCON_ERR_STATE)
 *   group  name, in any case; ROLLCON_ERR_ARGUMENT lists those that there are
 *   tag    that of rollcon_body_add_elements
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/meshes.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_tag_group(rollcon_body *body,
    const char *group, int32_t tag);

/*
 * Returns how many groups of the mesh's file name something of the body; 0 for a mesh that was
 * not read, and for a body that was saved and loaded.
 *   n     out; groups
 * Source: docs/meshes.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_group_count(const rollcon_body *body,
    int32_t *n);

/*
 * Returns the name of a group in the file's spelling.
 *   i         0 to rollcon_body_get_group_count - 1
 *   capacity  bytes at text
 *   text      [capacity], out, may be NULL; the name
 *   needed    out, may be NULL; bytes, the NUL counted
 * Also returns: ROLLCON_ERR_CAPACITY.
 * Source: docs/meshes.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_group_name(const rollcon_body *body,
    int32_t i, int64_t capacity, char *text, int64_t *needed);

/*
 * Returns the nodes of all that a group has, ascending, for rollcon_body_set_support and
 * rollcon_body_tag_faces_of_nodes.
 *   group       name, in any case; ROLLCON_ERR_ARGUMENT lists those that there are
 *   index_base  0 or 1: id of the first node
 *   capacity    ids at nodes; 0 only asks for the need
 *   nodes       [capacity], out; node ids; NULL only with capacity 0
 *   n_nodes     out, may be NULL; nodes of the group; set after ROLLCON_ERR_CAPACITY too
 * Also returns: ROLLCON_ERR_CAPACITY, ROLLCON_ERR_MEMORY.
 * Source: docs/meshes.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_group_nodes(const rollcon_body *body,
    const char *group, int32_t index_base, int64_t capacity, int32_t *nodes, int64_t *n_nodes);

/* ---------------------------------------------------------------------------- Body: settings */
/* Settings of a body by name, in the manner of those of a contact: unknown name, wrong type and
   out of range are errors. Bodies without equations of their own have settings, too, and ignore
   them. */

/*
 * Sets an integer option.
 *   body   not prepared (ROLLCON_ERR_STATE)
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_int(rollcon_body *body,
    const char *name, int64_t value);

/*
 * Sets a real option.
 *   body   not prepared (ROLLCON_ERR_STATE)
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_real(rollcon_body *body,
    const char *name, double value);

/*
 * Returns the value of an integer option.
 *   value  out
 * Also returns: ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_int(const rollcon_body *body,
    const char *name, int64_t *value);

/*
 * Returns the value of a real option.
 *   value  out
 * Also returns: ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_real(const rollcon_body *body,
    const char *name, double *value);

/* ----------------------------------------------------------------------------- Body: profile */
/* A curve in a plane as the surface of a half-space or of a rigid body without a mesh: extruded
   (a rail, a raceway strip) or revolved (a wheel, a roller, a ring), in the body's own axes;
   rollcon_contact_set_pose says where they are. A contact on a frame, for which no gap is given,
   computes it from the surfaces of its bodies. A profile has no inside: it looks where the normal
   of the contact's axes says. Half-spaces keep their compliance, and their frame stays flat.
   Profiles cannot be set after rollcon_body_prepare (ROLLCON_ERR_STATE). */

/*
 * Sets a profile through points, in either order: a cubic spline in arc length with two
 * derivatives continuous, broken at kinks (turns of 30 degrees and more, three times as much as
 * beside them). Points nearer to each other than a thousandth of the usual distance are dropped,
 * and where the path goes back and forth again the two points are replaced by their mean. The
 * former profile and its place are forgotten. ROLLCON_ERR_ARGUMENT names the point at which the
 * path turns back.
 *   body           a half-space or rigid, without a mesh (else ROLLCON_ERR_STATE)
 *   n              points, 2 to 10000000
 *   points         [n][2]; y and z of each, length
 *   filter_length  0: through the points; else they are smoothed before: waves of this length to
 *                  one half, shorter ones to nothing, longer ones stay; at most the length of the
 *                  profile
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/profiles.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_profile(rollcon_body *body, int64_t n,
    const double *points, double filter_length);

/*
 * Sets a profile in closed form: "line" half_width, slope; "arc" radius, half_width: the circle
 * through (0, 0) about z = -radius, up to half of it; "arcs" y, z and angle of the start, then
 * length and curvature (0: a line; positive: from y to z) of each arc, each going on in the
 * direction in which the one before ends; "roller" half_width, relief, k (0 to 1), edge_radius: z
 * = relief ln(1 - k (y/half_width)^2), logarithmic after Lundberg (k = 1) or Johns and Gohar (k <
 * 1), up to where it is 45 degrees steep, and beyond quarter circles of the edge's radius (0:
 * none, sharp ends); relief 0 is a straight roller; "s1002" unit: the wheel, in lengths of which
 * `unit` is a millimetre, the middle of the tread at (0, 0), z down, the flange at y < 0; "60e1"
 * unit: the head of the rail, upright, its top at (0, 0), z down. The former profile and its
 * place are forgotten.
 *   body        a half-space or rigid, without a mesh (else ROLLCON_ERR_STATE)
 *   shape       line, arc, arcs, roller, s1002 or 60e1
 *   n           parameters, of the shape
 *   parameters  [n]; of the shape, in its order; radian, length
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/profiles.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_set_profile_shape(rollcon_body *body,
    const char *shape, int64_t n, const double *parameters);

/*
 * Sets a profile through the points of a file, just as rollcon_body_set_profile does: a file of
 * Simpack if the name ends in .prr or .prw (its keys are obeyed except for smoothing), of
 * Miniprof if it ends in .ban, .whl or .mpt, else columns, y and z (docs/profiles.md). Simpack's
 * and Miniprof's numbers are millimetres. ROLLCON_ERR_IO names the line of a file that cannot be
 * read, ROLLCON_ERR_ARGUMENT that of a point at which the path turns back. z goes where the file
 * says: mirror it where the file counts upwards.
 *   body           a half-space or rigid, without a mesh (else ROLLCON_ERR_STATE)
 *   path           name of the file
 *   unit           factor on its numbers: length of a millimetre, > 0
 *   mirror         0: no; 1: in y, 2: in z, 3: in both; 4: in z only if the shape shows that z
 *                  counts upwards; 5: as 4, and in y
 *   filter_length  that of rollcon_body_set_profile, length
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_IO, ROLLCON_ERR_MEMORY.
 * Source: docs/profiles.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_read_profile(rollcon_body *body,
    const char *path, double unit, int32_t mirror, double filter_length);

/*
 * Takes the profile as that of one place, a length along the body or an angle round it, and waits
 * for the profile of the next: a switch, a crossing or a wheel that is out of round is given by
 * several. Each slice is divided at its features, points that correspond from slice to slice, and
 * between two that neighbours have in common lines of equal fractions of arc length are joined by
 * cubic splines (option smooth_slices). Beyond the first and last slice a rail stays as it is
 * there; round a wheel they are periodic. Angles count from the body's z about its axis, for a
 * wheel about y from below to ahead. One slice is an ordinary profile.
 *   body      with a profile (else ROLLCON_ERR_STATE)
 *   u         place of the slice, length or radian; none is there yet
 *   n         features, 0: both ends of the profile; 2 to 1000, as many for each slice
 *   features  [n]; arc lengths from the end where y is less, ascending; < 0: this slice does not
 *             have it; beyond the end: the end. What lies before the first and behind the last is
 *             left out
 * Ownership: The features are copied. After a failure the body is unchanged.
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/profiles.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_add_slice(rollcon_body *body, double u,
    int64_t n, const double *features);

/*
 * Reads all slices of a rail (.slcs) or wheel (.slcw) from a list. Its places are lengths or
 * angles, and it names the files of the profiles (docs/profiles.md). The former profile, slices
 * and waves are forgotten.
 *   body           a half-space or rigid, without a mesh (else ROLLCON_ERR_STATE)
 *   path           name of the list
 *   mm             length of a millimetre, in which the list counts places and features, > 0
 *   unit           factor on the profiles' numbers: that of rollcon_body_read_profile
 *   mirror         0: no; 1: in y, 2: in z, 3: in both
 *   filter_length  that of rollcon_body_set_profile, length
 * Ownership: All files are closed. After a failure the body is unchanged.
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_IO, ROLLCON_ERR_MEMORY.
 * Source: docs/profiles.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_read_slices(rollcon_body *body,
    const char *path, double mm, double unit, int32_t mirror, double filter_length);

/*
 * Adds amplitude sin(2 pi u / wavelength + phase) to z of the profile, at the length or angle u:
 * corrugation of a rail, a polygon of a wheel. Several add up.
 *   body        with a profile (else ROLLCON_ERR_STATE)
 *   amplitude   length
 *   wavelength  length along a rail; round a wheel an angle, 2 pi over a whole number
 *   phase       radian
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/profiles.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_add_wave(rollcon_body *body,
    double amplitude, double wavelength, double phase);

/*
 * Writes points of the profile to a file: of Simpack if the name ends in .prr or .prw, else two
 * columns. A profile through points is the same when read again, one in closed form within 1e-9
 * of its size where its curvature is continuous. The file appears whole or not at all.
 *   body  with a profile (else ROLLCON_ERR_STATE)
 *   path  name of the file
 *   unit  divides its numbers: length of a millimetre, > 0
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_IO, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_write_profile(const rollcon_body *body,
    const char *path, double unit);

/*
 * Makes the profile, moved along a straight line without end, the surface of the body: x of the
 * profile points along `along`, z along z_axis, y along z_axis x along.
 *   body    with a profile (else ROLLCON_ERR_STATE)
 *   origin  [3]; where the profile's point (0, 0) lies, length
 *   along   [3]; direction, of any length but 0
 *   z_axis  [3]; direction, not parallel to along; what is normal to it counts
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_extrude_profile(rollcon_body *body,
    const double *origin, const double *along, const double *z_axis);

/*
 * Makes the profile, turned about an axis, the surface of the body: its points lie at y along the
 * axis and at radius + z away from it. An axis of the opposite direction mirrors it in y.
 *   body    with a profile (else ROLLCON_ERR_STATE)
 *   origin  [3]; point of the axis at which y is 0, length
 *   axis    [3]; direction of y, of any length but 0
 *   radius  radius at z = 0, length; radius + z >= 0 all along the profile
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_revolve_profile(rollcon_body *body,
    const double *origin, const double *axis, double radius);

/*
 * Returns the arc length of the profile. It works before rollcon_body_prepare.
 *   body    with a profile (else ROLLCON_ERR_STATE)
 *   length  out; length
 * Also returns: ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_profile_length(const rollcon_body *body,
    double *length);

/*
 * Returns point, tangent and curvature of the profile at an arc length, counted from the end
 * where y is less. It works before rollcon_body_prepare.
 *   body       with a profile (else ROLLCON_ERR_STATE)
 *   s          0 to rollcon_body_get_profile_length, length
 *   point      [2], out; y and z, length
 *   tangent    [2], out; y and z of the unit vector in the direction of greater arc length
 *   curvature  out; 1/length, positive where the curve turns from y to z
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_profile_point(const rollcon_body *body,
    double s, double *point, double *tangent, double *curvature);

/* ----------------------------------------------------------------------------- Body: results */
/* Results of a prepared body by itself: statics under its own loads and given displacements, with
   no contact acting; in the body's axes. ROLLCON_ERR_STATE before rollcon_body_prepare or a solve
   that did it, and for half-spaces. */

/*
 * Returns the nodes and elements given so far; 0 for bodies without a mesh. It works before
 * rollcon_body_prepare.
 *   nodes     out, may be NULL
 *   elements  out, may be NULL
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_size(const rollcon_body *body,
    int64_t *nodes, int64_t *elements);

/*
 * Returns the displacement of every node under the body's own loads and given displacements; zero
 * when there are none, and for rigid bodies.
 *   capacity  nodes that fit into u; at least those of the body
 *   u         [capacity][3], out; displacement x y z, length
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_CAPACITY.
 * Source: docs/theory.md, section 9.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_displacements(const rollcon_body *body,
    int64_t capacity, double *u);

/*
 * Returns smoothed stresses at all nodes of a body of finite elements under given displacements
 * of its nodes, or of finite or boundary elements under its own loads. Each element's stresses
 * are taken as the nearest function that is linear in the element (in a hexahedron: in each
 * direction), and averaged at its nodes by volume, also across materials. Stresses of boundary
 * elements follow from tractions and displacements along the surface, averaged by area, over
 * edges as well. Tension is positive; axes of the body. ROLLCON_ERR_UNSUPPORTED: another kind of
 * body, or u for boundary elements; ROLLCON_ERR_ARGUMENT: another number of nodes, or stresses
 * overflow.
 *   nodes   as many as the body has
 *   u       [nodes][3]; those of rollcon_contact_get_body_displacements, length; NULL: those of
 *           rollcon_body_get_displacements
 *   stress  [nodes][6], out; s11, s22, s33, s12, s13, s23, force/length^2
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_UNSUPPORTED,
 *   ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, inside of finite elements.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_node_stresses(const rollcon_body *body,
    int64_t nodes, const double *u, double *stress);

/*
 * Returns stresses at the integration points of all finite elements, element by element, with
 * which the elements themselves balance loads, and the points' places. The call is otherwise like
 * rollcon_body_get_node_stresses.
 *   nodes     as many as the body has
 *   u         [nodes][3]; displacements of the nodes; NULL: those of
 *             rollcon_body_get_displacements
 *   capacity  points that fit; 0 asks for their number
 *   stress    [capacity][6], out; s11, s22, s33, s12, s13, s23, force/length^2; NULL: not wanted
 *   xyz       [capacity][3], out; places in the body's axes, length; NULL: not wanted
 *   n_rows    out, may be NULL; points there are; set after ROLLCON_ERR_CAPACITY too
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_UNSUPPORTED,
 *   ROLLCON_ERR_CAPACITY, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, inside of finite elements.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_point_stresses(const rollcon_body *body,
    int64_t nodes, const double *u, int64_t capacity, double *stress, double *xyz,
    int64_t *n_rows);

/*
 * Returns displacements and stresses at any points inside a body: for finite elements the
 * smoothed ones of nodes, interpolated by the elements' shape functions, for boundary elements by
 * Somigliana's identities, as near to the surface as wanted, and on it. The call is otherwise
 * like rollcon_body_get_node_stresses. ROLLCON_ERR_ARGUMENT also: a point is outside (a millionth
 * of the element's size beyond its faces is still inside).
 *   nodes         as many as the body has
 *   u             [nodes][3]; displacements of the nodes; NULL: those of
 *                 rollcon_body_get_displacements
 *   n             points, >= 0
 *   xyz           [n][3]; in the body's axes, length
 *   displacement  [n][3], out; x y z, length; NULL: not wanted
 *   stress        [n][6], out; s11, s22, s33, s12, s13, s23, force/length^2; NULL: not wanted
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_UNSUPPORTED,
 *   ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, inside of finite elements.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_fields_at(const rollcon_body *body,
    int64_t nodes, const double *u, int64_t n, const double *xyz, double *displacement,
    double *stress);

/*
 * Writes the elements of a body of finite or boundary elements with displacements, smoothed
 * stresses (xx, yy, zz, xy, yz, xz, in ParaView's order) and von Mises's stress at the nodes as a
 * VTU file for ParaView and meshio. A section is written as the elements that its part of option
 * sector sweeps. The call is otherwise like rollcon_body_get_node_stresses.
 *   path   name of the file; an existing one is replaced
 *   nodes  as many as the body has
 *   u      [nodes][3]; displacements of the nodes; NULL: those of rollcon_body_get_displacements
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_UNSUPPORTED,
 *   ROLLCON_ERR_IO, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, inside of finite elements.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_write(const rollcon_body *body,
    const char *path, int64_t nodes, const double *u);

/*
 * Returns the resultant of the forces that the supports exert on the body under its own loads and
 * given displacements, and its moment about the origin of the body's axes. It balances the loads
 * up to the error of the discretisation: a measure of it.
 *   force   [3], out, may be NULL; force
 *   moment  [3], out, may be NULL; force x length
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_reaction(const rollcon_body *body,
    double *force, double *moment);

/*
 * Returns one number about a prepared body: unknowns, assemblies, factorisations, condition,
 * seconds, bytes; 0 for bodies without equations. Names: rollcon_stat_info. Counts are those of
 * the equations, which equal bodies of a context have in common: "shared" is 1 for a body for
 * which nothing was assembled because an equal one was prepared before, "loaded" for one from a
 * file.
 *   value  out
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_get_stat(const rollcon_body *body,
    const char *name, double *value);

/* ----------------------------------------------------------- Contact: making, frame and axes */
/* A pair of bodies, the frame (mesh) on which their tractions live, and what happens there. */

/*
 * Makes a contact of two bodies. The standard scene has axes (x, y, z) at the origin, speed 1,
 * approach, creepages and spin 0, all by motion, bodies in the pose of their own axes. Without a
 * frame the library makes one (rollcon_contact_frame_automatic). Friction has no standard, the
 * gap only if a body has a mesh or a profile: solving without them is ROLLCON_ERR_STATE. At least
 * one of the bodies must be elastic.
 *   body1    tractions are those on this body; n points out of it
 *   body2    may be of another context, and the same as body1
 *   contact  new handle
 * Ownership: The caller owns the new handle: release it. The contact keeps bodies and context
 *   alive. *contact is NULL after a failure.
 * Also returns: ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_create(rollcon_context *context,
    rollcon_body *body1, rollcon_body *body2, rollcon_contact **contact);

/*
 * Drops a reference; the handle is dead after the last one. NULL and dead handles are ignored.
 *   contact  may be NULL
 * Threads: any.
 */
ROLLCON_API void ROLLCON_CALL rollcon_contact_release(rollcon_contact *contact);

/*
 * Sets the nodes of the frame and forgets its elements, the gap array and the creep and friction
 * fields. Component j of node i is x[i * node_stride + j * component_stride]: packed x[n][3] has
 * strides 3 and 1, Fortran's X(n,3) 1 and n.
 *   n                 nodes, 1 to 2147483647
 *   x                 [n*3]; coordinates, length
 *   node_stride       >= 1, in doubles
 *   component_stride  >= 1, in doubles
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_frame_nodes(rollcon_contact *contact,
    int64_t n, const double *x, int64_t node_stride, int64_t component_stride);

/*
 * Adds elements of one type to the frame. Types may be mixed by several calls. Shapes are checked
 * by the solve (ROLLCON_ERR_MESH there).
 *   type          ROLLCON_TRI3, TRI6, QUAD4, QUAD8 or QUAD9
 *   n             elements, >= 0
 *   connectivity  [n][nodes of the type]; node ids
 *   index_base    0 or 1: id of the first node; messages count the same way
 *   tag           free label of these elements, written to files
 * Also returns: ROLLCON_ERR_MESH, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_frame_add_elements(
    rollcon_contact *contact, int32_t type, int64_t n, const int32_t *connectivity,
    int32_t index_base, int32_t tag);

/*
 * Makes the surface elements of a mesh file the frame; replaces frame and all that was given for
 * its nodes. The files are those of rollcon_body_read_mesh. Tags of elements are Gmsh's physical
 * groups, else 0.
 *   path     name of the file, which ends in .msh or .inp
 *   part     name of a group (in any case): only its elements; "": those of the whole file
 * Ownership: After a failure the frame is unchanged. The file is closed.
 * Also returns: ROLLCON_ERR_MESH, ROLLCON_ERR_STATE, ROLLCON_ERR_IO, ROLLCON_ERR_MEMORY.
 * Source: docs/meshes.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_frame_from_file(rollcon_contact *contact,
    const char *path, const char *part);

/*
 * Makes the faces of a body that carry a tag the frame: replaces nodes and elements of the frame
 * and forgets the gap array and the creep and friction fields. Its nodes are those of the faces,
 * in the order of their ids in the body, and follow the body's pose. For finite-element bodies
 * with tri6 among these faces (tet10, the ends of wedge15) they are the corners alone, and the
 * frame's elements linear: rollcon_contact_get_size tells how many. Faces of body 2 are turned
 * over, so that the frame's normals point out of body 1.
 *   which    ROLLCON_BODY1 or ROLLCON_BODY2, prepared or not
 *   tag      of some element of it (else ROLLCON_ERR_ARGUMENT)
 * Ownership: The faces are copied: later changes of an unprepared body do not reach the frame.
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_MESH, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_frame_from_body(rollcon_contact *contact,
    int32_t which, int32_t tag);

/*
 * Makes a rectangle in the present plane of the axes the frame: nx by ny elements of one size.
 * Replaces nodes and elements of the frame and forgets the gap array and the creep and friction
 * fields. Nodes come line by line along t1, from the least y. Linear quadrilaterals make a
 * regular frame, which half-spaces solve by fast Fourier transforms.
 *   type        ROLLCON_TRI3, TRI6, QUAD4, QUAD8 or QUAD9
 *   nx          elements along t1, 1 to 30000
 *   ny          elements along t2, 1 to 30000
 *   x_least     along t1 from the origin of the axes, length
 *   x_greatest  > x_least
 *   y_least     along t2 from the origin of the axes, length
 *   y_greatest  > y_least
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_frame_rectangle(rollcon_contact *contact,
    int32_t type, int32_t nx, int32_t ny, double x_least, double x_greatest, double y_least,
    double y_greatest);

/*
 * Makes an ellipse in the present plane of the axes the frame: strips along the rolling
 * direction, like those of rollcon_contact_frame_strips, on lines that lie closer towards the
 * sides. It is meant to be the contact itself.
 *   along    elements along each strip, 2 to 10000
 *   across   strips, 2 to 10000
 *   a        semi-axis at `angle` from t1, length, > 0
 *   b        the other semi-axis, length, > 0
 *   angle    radian, from t1 towards t2
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, section 4.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_frame_ellipse(rollcon_contact *contact,
    int32_t along, int32_t across, double a, double b, double angle);

/*
 * Makes strips along the rolling direction the frame: what the contact covers of lines at
 * ascending y. Each has along + 1 nodes from end to end, close together near the ends, where
 * tractions grow like the square root of the distance. Nodes come line by line. Replaces the
 * frame just as rollcon_contact_frame_rectangle does. Nodes on the outline carry no traction
 * (ROLLCON_EXCLUDED): bodies that overlap there are reported as ROLLCON_RIM_CONTACT.
 *   along    elements along each strip, 2 to 10000
 *   n        lines, 3 to 10001
 *   lines    [n][3]; y of each line, ascending, and the least and greatest x that the contact
 *            covers of it, the first less than the second (equal on the first and the last line,
 *            if it is a point), length
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, section 4.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_frame_strips(rollcon_contact *contact,
    int32_t along, int64_t n, const double *lines);

/*
 * Leaves the frame to the library, which is the state of a new contact: solves then find the
 * contact from the gap (of the bodies' meshes and profiles, rollcon_contact_set_gap_quadratic,
 * rollcon_contact_set_gap_grid) and from load or approach, and lay strips on it whose ends are
 * found with the pressures, finer ones until the option frame_accuracy is met or
 * ROLLCON_INACCURATE says that it was not. Friction forces, spin moment and creepages under
 * Coulomb's law, and their sensitivities, are extrapolated from two counts of strips. Where
 * strips do not fit, two frames are fitted to the edge of each patch, and forces, moment,
 * approach, creepages, their sensitivities and the statistics contact_area and error_estimate are
 * extrapolated from both. Nodes and fields are those of the finest frame, which the next solve
 * may replace. The error is that of the frame: what a body's own mesh adds is not counted.
 * Also returns: ROLLCON_ERR_STATE.
 * Source: docs/theory.md, section 4.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_frame_automatic(rollcon_contact *contact);

/*
 * Says where a body with a mesh stands: x = rotation x_body + translation, at approach 0.
 * Standard: identity and zero. Half-spaces ignore it: their surface is the frame's.
 *   which        ROLLCON_BODY1 or ROLLCON_BODY2
 *   rotation     [3][3]; by rows; orthonormal with determinant +1 to 1e-6 (else
 *                ROLLCON_ERR_ARGUMENT), then made exactly so
 *   translation  [3]; length
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE.
 * Source: docs/theory.md, signs and axes.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_pose(rollcon_contact *contact,
    int32_t which, const double *rotation, const double *translation);

/*
 * Sets the axes: n along `normal`, t1 along the projection of `rolling` on the tangent plane, t2
 * = n x t1. Vectors need not have unit length. Creepages, spin and moments belong to the origin.
 *   origin   [3]; length
 *   rolling  [3]; rolling direction, not parallel to normal
 *   normal   [3]; outward normal of body 1
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE.
 * Source: docs/theory.md, signs and axes.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_axes(rollcon_contact *contact,
    const double *origin, const double *rolling, const double *normal);

/*
 * Sets the gap of the undeformed bodies at approach 0, node by node; replaces a quadratic gap.
 * Where a body has a mesh or a profile and no gap is given, it is measured along the frame's
 * normals between the surfaces; a body without either is then the plane through the origin of the
 * axes. These normals are level along the rolling direction (rollcon_contact_get_tractions): a
 * gap along the surface's own would be longer by half the square of the angle between them.
 *   n        nodes of the frame
 *   gap      [n]; length
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_gap(rollcon_contact *contact,
    int64_t n, const double *gap);

/*
 * Sets the gap of the undeformed bodies at approach 0 to h = a x^2 + b y^2 + c x y in the axes
 * (t1, t2); replaces a gap array.
 *   a        1/length; 1/(2 R) for a sphere
 *   b        1/length
 *   c        1/length
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_gap_quadratic(
    rollcon_contact *contact, double a, double b, double c);

/*
 * Sets the gap of the undeformed bodies at approach 0 by its values on a regular grid in the axes
 * (t1, t2): between the points it is bicubic, with continuous slopes. Values that are +infinity
 * say that a body is not there: the contact ends at the cells beside them, and there only
 * (rollcon_contact_frame_automatic); the grid's own rim is no such edge. Replaces a gap array or
 * a quadratic gap. A frame must lie within the cells that have a gap.
 *   nx          points along t1 of each line, 2 or more
 *   x_least     x of the first point of a line, length
 *   x_greatest  x of the last point, length
 *   y_least     y of the first line, length
 *   y_greatest  y of the last line, length
 *   n           points: nx times the number of lines, which is 2 or more
 *   gap         [n]; line by line, length
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_gap_grid(rollcon_contact *contact,
    int32_t nx, double x_least, double x_greatest, double y_least, double y_greatest, int64_t n,
    const double *gap);

/* ------------------------------------------------------- Contact: motion, loads and friction */
/* These calls set what changes in a time loop. Setting values that are already set costs nothing
   at the next solve, and none of these calls allocates once the sizes are known. */

/*
 * Sets the speed V at which the contact travels over both surfaces along +t1 (omega R for a
 * wheel). Forgets the velocity of the contact (rollcon_contact_set_velocity).
 *   speed    V > 0, length/time
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE.
 * Source: docs/theory.md, signs and axes.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_rolling(rollcon_contact *contact,
    double speed);

/*
 * Prescribes creepages and spin by motion: rigid slip c = V (longitudinal - spin y, lateral +
 * spin x) of body 1 relative to body 2. The call stands for three calls of
 * rollcon_contact_prescribe, and forgets the velocities of rollcon_contact_set_velocity.
 *   longitudinal  creepage along t1, dimensionless
 *   lateral       creepage along t2, dimensionless
 *   spin          1/length
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE.
 * Source: docs/theory.md, signs and axes.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_creep(rollcon_contact *contact,
    double longitudinal, double lateral, double spin);

/*
 * Makes every solve from now on a step in time of length dt; ROLLCON_STEADY makes it a steady
 * state again. ROLLCON_ROLLING_STEP: the contact rolls on by V dt, creepages and spin mean what
 * they mean in steady rolling. ROLLCON_SHIFT_STEP: no rolling; what is prescribed as creepages is
 * the shift of body 1 against body 2 in this step (longitudinal and lateral, length) and its turn
 * (spin, radians), and so it is in what rollcon_contact_get_motion returns; velocities and creep
 * fields count by dt. Loads, motions, approach, friction and gap may change from step to step.
 * The first step starts from the steady state solved last, or from rest where there is none
 * (rollcon_contact_reset); a step that fails does not change the one before. A frame that follows
 * its contact takes the past along (half-spaces and rigid bodies; meshed bodies:
 * ROLLCON_ERR_STATE from the solve).
 *   kind     ROLLCON_STEADY, ROLLCON_ROLLING_STEP or ROLLCON_SHIFT_STEP
 *   dt       > 0, time; ignored if the kind is ROLLCON_STEADY
 * Also returns: ROLLCON_ERR_NONFINITE.
 * Source: docs/time.md; Kalker 1990.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_step(rollcon_contact *contact,
    int32_t kind, double dt);

/*
 * Says how a body or the contact itself moves: its point at x has the velocity v + omega x (x -
 * point). Creepages and spin then follow from the velocities of both bodies;
 * rollcon_contact_get_motion returns them after a solve. Where bodies have profiles or meshes the
 * relative velocity is taken between their surfaces, node by node: rolling radius and spin vary
 * over the contact. The speed V follows from the velocity of the contact, less the mean of both
 * bodies'; where that is not given it is the one set by rollcon_contact_set_rolling; one of the
 * two is needed. A body whose velocity is not given is at rest. What was set last counts:
 * rollcon_contact_set_creep forgets all velocities, rollcon_contact_prescribe replaces one
 * creepage or the spin and leaves the rest of the slip.
 *   which             ROLLCON_BODY1, ROLLCON_BODY2 or ROLLCON_CONTACT_ITSELF
 *   velocity          [3]; velocity of its point at `point`, length/time
 *   angular_velocity  [3]; 1/time
 *   point             [3]; in space, length
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE.
 * Source: docs/theory.md, signs and axes.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_velocity(rollcon_contact *contact,
    int32_t which, const double *velocity, const double *angular_velocity, const double *point);

/*
 * Adds a rigid slip velocity given node by node to that of creepages and spin. On a curved frame
 * its components are along the local axes of each node.
 *   n        nodes of the frame; 0 removes the field
 *   slip     [n][2]; velocity along t1 and t2, length/time; NULL only with n = 0
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_creep_field(rollcon_contact *contact,
    int64_t n, const double *slip);

/*
 * Prescribes one direction by motion or by force; the other quantity is found by the solve.
 * Forces act on body 1. A tilt turns body 1 against body 2 about t1 or t2 through the origin: at
 * (x, y) of a flat frame it takes (tilt 1) y - (tilt 2) x from the gap. Its moment is that of the
 * contact's tractions on body 1 about the same axis: a load F that presses body 1 at (x, y) asks
 * for the moments -F y (tilt 1) and F x (tilt 2). The standard is all by motion, 0.
 *   direction  ROLLCON_LONGITUDINAL, LATERAL, NORMAL, SPIN, TILT_1 or TILT_2
 *   how        ROLLCON_BY_MOTION or ROLLCON_BY_FORCE
 *   value      motion: creepage, spin (1/length), approach (length), tilt (radian, small); force:
 *              force, moment about the axis through the origin, and for NORMAL the compressive
 *              load >= 0
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE.
 * Source: docs/theory.md, loads.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_prescribe(rollcon_contact *contact,
    int32_t direction, int32_t how, double value);

/*
 * Sets the law of friction for the whole frame. "coulomb": mu. "orthotropic": mu1 and mu2 along
 * axes that are turned by an angle (radian) from t1 towards t2 (on curved frames those of each
 * node), slip normal to the ellipse of the tractions; "orthotropic_collinear": the same ellipse,
 * slip against the traction. "linear", "rational", "exponential": friction that falls with the
 * slip speed s, muk + mu1 f(s/s1) and, with 5 parameters, + mu2 f(s/s2), each half as great or
 * less at its speed: f(x) = max(0, 1 - x/2), 1/(1 + x) (of the second term 1/(1 + x^2)), or 2^-x.
 * "temperature": linear in the surface temperature between points T1, mu1, T2, mu2, ... with
 * ascending temperatures, constant beyond them (needs rollcon_contact_set_heat; steady rolling,
 * no sensitivities). Where friction falls several solutions may exist then: a solve from nothing
 * begins with the friction of rest, a warm one continues the last solution, the plan says which;
 * ROLLCON_FIELD_FRICTION gives the coefficient at the node's slip. Where
 * rollcon_contact_set_friction_field gives coefficients, each is the greatest of its node (at
 * rest) and the law keeps its ratios. The published procedures (rollcon_contact_set_procedure)
 * take "coulomb" alone (ROLLCON_ERR_UNSUPPORTED at the solve).
 *   law         a name of a law
 *   n           parameters of the law: 1; 3 for the orthotropic ones; 3 or 5 for those that fall;
 *               4 to 64, even, for temperature
 *   parameters  [n]; mu; mu1, mu2, angle; muk, mu1, s1, mu2, s2; T1, mu1, T2, mu2, ...
 *               Coefficients >= 0, of an ellipse at most 1000 times apart; speeds > 0,
 *               length/time
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE.
 * Source: docs/friction.md; Coulomb: equation (16) of the paper.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_friction(rollcon_contact *contact,
    const char *law, int32_t n, const double *parameters);

/*
 * Gives friction that falls with the slip speed a memory: for a particle of the surface d mu/dt =
 * -max(s, s0)/dc (mu - mu_s(s)), where mu_s is what the law without memory says; where surfaces
 * come into contact mu is that at rest. Coefficients then follow the whole solution and are found
 * by solves with given ones (statistics friction_rounds and friction_change). The memory holds
 * for whatever law is set, if it falls, else the solve ends with ROLLCON_ERR_STATE. It is for
 * steady rolling only (steps in time: ROLLCON_ERR_UNSUPPORTED from the solve), and there are no
 * sensitivities (ROLLCON_ERR_UNSUPPORTED).
 *   length       dc, length of slip, >= 0; 0: no memory
 *   least_speed  s0 >= 0, slip speed, length/time
 * Also returns: ROLLCON_ERR_NONFINITE.
 * Source: docs/friction.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_friction_memory(
    rollcon_contact *contact, double length, double least_speed);

/*
 * Puts a thin layer between the bodies that gives way along the surface in proportion to the
 * tangential traction at each point, in series with both: thickness over shear modulus. The
 * displacements of the bodies do not contain it, slip does. The monolithic system
 * (rollcon_contact_set_procedure) does not take it (ROLLCON_ERR_UNSUPPORTED at the solve). With a
 * yield stress the layer, which may be stiff (flexibility 0), flows along the surface under a
 * traction of stress + hardening times the flow since the surfaces came into contact. Where that
 * is less than friction it bounds the traction, and what friction would call slip is flow. It
 * flows with the laws "coulomb", "temperature", and those that fall with a memory; others end
 * with ROLLCON_ERR_UNSUPPORTED at the solve. The flow is found by solves with given coefficients,
 * as with rollcon_contact_set_friction_memory: for steady rolling only, without sensitivities.
 *   flexibility  thickness over shear modulus, length^3/force, >= 0
 *   stress       >= 0, force/length^2; 0: never flows, and with flexibility 0 there is no layer
 *   hardening    force/length^3; negative: softening
 * Also returns: ROLLCON_ERR_NONFINITE.
 * Source: docs/friction.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_layer(rollcon_contact *contact,
    double flexibility, double stress, double hardening);

/*
 * Sets friction coefficients along t2, linear between points and constant beyond them, for frames
 * of any maker: they replace the (greatest) coefficient of rollcon_contact_set_friction, where
 * rollcon_contact_set_friction_field gives none.
 *   n        points; 0 removes them
 *   points   [n][2]; y along t2 from the origin of the axes, ascending, length, and mu >= 0; NULL
 *            only with n = 0
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MEMORY.
 * Source: docs/friction.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_friction_across(
    rollcon_contact *contact, int64_t n, const double *points);

/*
 * Says what a body does with heat, for the surface temperatures of a solution
 * (rollcon_contact_get_temperatures_at, ROLLCON_FIELD_TEMPERATURE) and for friction that depends
 * on them. The call is needed for both bodies; one of them may take up no heat.
 *   which          ROLLCON_BODY1 or ROLLCON_BODY2
 *   conductivity   >= 0, power/(length temperature)
 *   heat_capacity  >= 0, energy/(volume temperature): density times specific heat
 *   temperature    temperature far from the contact
 * Also returns: ROLLCON_ERR_NONFINITE.
 * Source: docs/friction.md; Ertz and Knothe 2002.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_heat(rollcon_contact *contact,
    int32_t which, double conductivity, double heat_capacity, double temperature);

/*
 * Sets the friction coefficient node by node, in place of that of rollcon_contact_set_friction.
 *   n        nodes of the frame; 0 removes the field
 *   mu       [n]; >= 0; NULL only with n = 0
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_friction_field(
    rollcon_contact *contact, int64_t n, const double *mu);

/* --------------------------------------------------------------------------- Solver settings */
/* Settings by name. The table can be listed at run time; unknown name, wrong type and out of
   range are errors. */

/*
 * Sets an integer option.
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_int(rollcon_contact *contact,
    const char *name, int64_t value);

/*
 * Sets a real option.
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE, ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_real(rollcon_contact *contact,
    const char *name, double value);

/*
 * Sets a text option.
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_str(rollcon_contact *contact,
    const char *name, const char *value);

/*
 * Returns the value of an integer option.
 *   value    out
 * Also returns: ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_int(const rollcon_contact *contact,
    const char *name, int64_t *value);

/*
 * Returns the value of a real option.
 *   value    out
 * Also returns: ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_real(const rollcon_contact *contact,
    const char *name, double *value);

/*
 * Returns the value of a text option.
 * Also returns: ROLLCON_ERR_OPTION, ROLLCON_ERR_CAPACITY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_str(const rollcon_contact *contact,
    const char *name, int64_t capacity, char *text, int64_t *needed);

/*
 * Chooses one of the published solution procedures in place of the library's own iteration, by
 * options and values: "system=monolithic jacobian=reduced"; what is not named has its standard
 * value, and "" is the library's own. rollcon_option_info lists them (ROLLCON_OF_PROCEDURE).
 * Combinations that make no sense are ROLLCON_ERR_OPTION when a solve begins, builds without the
 * procedures ROLLCON_ERR_UNSUPPORTED.
 *   procedure  option=value, separated by blanks
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_OPTION.
 * Source: docs/procedures.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_procedure(rollcon_contact *contact,
    const char *procedure);

/* ------------------------------------------------------------------------ Solve, watch, stop */
/* Each solve finds one steady state, or one step in time (rollcon_contact_set_step), started from
   the last one. */

/*
 * Sets the callback that is called once per iteration, and about every tenth of a second while
 * bodies and operators are prepared (ROLLCON_PHASE_COMPLIANCE; the iteration then counts from 1).
 *   fn       NULL removes the callback
 *   user     handed to fn
 * Ownership: `user` stays the caller's and must live until the callback is replaced or the
 *   contact is gone.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_set_progress(rollcon_contact *contact,
    rollcon_progress_fn fn, void *user);

/*
 * Returns an integer of the event, inside the progress callback.
 *   event  what the callback got; ROLLCON_ERR_HANDLE outside of the callback
 *   key    ROLLCON_EVENT_PHASE or ROLLCON_EVENT_ITERATION
 *   value  out
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_event_get_int(const rollcon_event *event,
    int32_t key, int64_t *value);

/*
 * Returns a real of the event, inside the progress callback.
 *   event  what the callback got; ROLLCON_ERR_HANDLE outside of the callback
 *   key    ROLLCON_EVENT_RESIDUAL or ROLLCON_EVENT_SECONDS
 *   value  out
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_event_get_real(const rollcon_event *event,
    int32_t key, double *value);

/*
 * Asks a running solve to stop (an atomic store): at its next iteration, or, while bodies and
 * operators are prepared, within moments; only a sparse factorisation runs to its end. The solve
 * returns ROLLCON_CANCELLED; the contact stays usable. What was cancelled during its preparation
 * has no results, and the next solve prepares it anew.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_request_cancel(rollcon_contact *contact);

/*
 * Solves the steady rolling contact: tractions, slip, and whatever motion was prescribed by
 * force. Starts from the last solution unless the option "warm_start" is 0. After
 * ROLLCON_NOT_CONVERGED and ROLLCON_CANCELLED the best iterate can be read. ROLLCON_COARSE says
 * that no node in contact has all its neighbours in contact (with friction: fewer than 5 have);
 * the solution is that of the frame, not of the bodies. Log and plan tell more. A failed solve
 * does not change the scene but discards the last solution. Bodies that are not prepared are
 * prepared first and may fail the way rollcon_body_prepare does (ROLLCON_ERR_MESH,
 * ROLLCON_ERR_SINGULAR); the text names the body. Creepages (whose slip, times speed or
 * stiffness, would come to 1e305) and approaches (to pressures of 1e150) that double precision
 * cannot calculate with are ROLLCON_ERR_ARGUMENT; the text names a node and what is allowed.
 * Nodes that are never to touch may have any gap, with the monolithic system
 * (rollcon_contact_set_procedure) up to that limit.
 * Also returns: ROLLCON_NOT_CONVERGED, ROLLCON_NO_CONTACT, ROLLCON_CANCELLED,
 *   ROLLCON_RIM_CONTACT, ROLLCON_COARSE, ROLLCON_INACCURATE, ROLLCON_TOO_DEEP, ROLLCON_ERR_MESH,
 *   ROLLCON_ERR_STATE, ROLLCON_ERR_SINGULAR, ROLLCON_ERR_MEMORY, ROLLCON_ERR_OPTION,
 *   ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_LOAD.
 * Source: docs/theory.md; contact laws: equations (16) to (24) of the paper.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_solve(rollcon_contact *contact);

/*
 * Solves the scene for many load cases, each with some of what is prescribed replaced, on the
 * threads of the context. What is replaced and what is wanted is said by names, the columns of
 * two tables with a row for each case. A direction stands for the value prescribed there, as
 * motion or as force (rollcon_contact_prescribe); friction for a factor on the friction
 * coefficients that are set at the nodes (1: no change). Results do not depend on the order of
 * the cases nor on the number of threads: the library orders them itself, solves equal ones once
 * and starts warm along chains of neighbours (unless the option "warm_start" is 0). A case that
 * fails has its negative status and NaN for results and does not affect the others; texts go to
 * the log as warnings. The status returned is the worst in the order that holds for all calls;
 * CANCELLED says that some cases were not solved. A negative one means that no case was solved.
 * All results are in local axes. The scene does not change, and the last solution stays unless
 * something was set since. Where no frame was given each case is solved on frames of its own
 * (rollcon_contact_frame_automatic), steadily: then tractions are no column, and friction is a
 * parameter of Coulomb's law alone. The progress callback receives the iterations of the calling
 * thread, and of ROLLCON_PHASE_CASES. The procedures of the paper use one thread.
 *   parameters  columns of values, separated by blanks, each once, of: longitudinal, lateral,
 *               normal, spin, friction, tilt_1, tilt_2; NULL: none
 *   n_cases     >= 0
 *   values      [n_cases][parameters]; a normal load, and a factor on friction, are >= 0; NULL
 *               only without cases or parameters
 *   columns     columns of results, separated by blanks, of: force (3 numbers, on body 1), moment
 *               (3, about the origin of the axes), approach, creep (3: longitudinal, lateral,
 *               spin), tilt (2), derivatives (10 for each parameter: by its value, of force,
 *               moment, approach and creep, see rollcon_contact_get_sensitivity; NaN where there
 *               are none, such as by friction at 0), tractions (3 for each node of the frame, on
 *               body 1), and the statistics iterations, fallbacks, residual_normal,
 *               residual_tangential, nodes_contact, contact_area, max_pressure, friction_power,
 *               friction_power_balance; NULL: none
 *   capacity    numbers for each case at results; at least those of the columns; 0 with columns
 *               only asks for the need
 *   results     [n_cases][capacity], out; a row for each case, the columns side by side; what is
 *               beyond them is not written; NULL only with capacity 0
 *   n_results   out, may be NULL; numbers for each case; set after ROLLCON_ERR_CAPACITY too
 *   status      [n_cases], out, may be NULL; what rollcon_contact_solve would return for each
 * Also returns: ROLLCON_NOT_CONVERGED, ROLLCON_NO_CONTACT, ROLLCON_CANCELLED,
 *   ROLLCON_RIM_CONTACT, ROLLCON_COARSE, ROLLCON_INACCURATE, ROLLCON_TOO_DEEP,
 *   ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MESH, ROLLCON_ERR_STATE, ROLLCON_ERR_OPTION,
 *   ROLLCON_ERR_CAPACITY, ROLLCON_ERR_SINGULAR, ROLLCON_ERR_MEMORY, ROLLCON_ERR_UNSUPPORTED.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_solve_many(rollcon_contact *contact,
    const char *parameters, int64_t n_cases, const double *values, const char *columns,
    int64_t capacity, double *results, int64_t *n_results, int32_t *status);

/*
 * Lets the next solve start from where the last step did, as if that had not been, for a host
 * that tries loads or motions again before it goes on. It works once after each step.
 * Also returns: ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_repeat_step(rollcon_contact *contact);

/*
 * Returns what the next step starts from, as numbers: a header with a version, time, tractions, a
 * checksum. They serve another run, or another contact of such bodies on the same frame.
 *   capacity  doubles at past; 0 only asks for the need
 *   past      [capacity], out; NULL only with capacity 0
 *   n_values  out, may be NULL; doubles of the past; set after ROLLCON_ERR_CAPACITY too
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_CAPACITY.
 * Source: docs/time.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_past_get(const rollcon_contact *contact,
    int64_t capacity, double *past, int64_t *n_values);

/*
 * Lets the next step start from what rollcon_contact_past_get gave. Prepares bodies and frame
 * where nothing was solved yet. Numbers of another frame, or that were changed, are refused and
 * do not change the past; results of the last solve are gone.
 *   past     [n]; what rollcon_contact_past_get gave
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MESH.
 * Source: docs/time.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_past_set(rollcon_contact *contact,
    int64_t n, const double *past);

/*
 * Forgets the solution, the warm start, the iteration log and what was before a time step (bodies
 * are at rest); keeps the scene and all that was computed for the frame.
 * Also returns: ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_reset(rollcon_contact *contact);

/* ----------------------------------------------------------------------------------- Results */
/* Results of the last solve are copied into the caller's arrays; ROLLCON_ERR_STATE before one. */

/*
 * Returns the nodes and elements of the frame. It works before a solve.
 *   nodes     out, may be NULL
 *   elements  out, may be NULL
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_size(const rollcon_contact *contact,
    int64_t *nodes, int64_t *elements);

/*
 * Returns tractions on body 1 at the nodes; the normal component is <= 0 in compression. Normals
 * follow a surface across the rolling direction only: along it all have the inclination at the
 * origin of the axes. At a distance x from there, on a radius R, they are off the surface's own
 * by x/R: pressures by half its square (0.02 % at x/R = 0.02, 0.5 % at 0.1), and the part p x/R
 * of a pressure along the surface is no traction.
 *   axes      ROLLCON_LOCAL or ROLLCON_GLOBAL
 *   capacity  nodes that fit into t; at least those of the frame
 *   t         [capacity][3], out; force/length^2
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_CAPACITY.
 * Source: docs/theory.md, contact laws.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_tractions(
    const rollcon_contact *contact, int32_t axes, int64_t capacity, double *t);

/*
 * Returns a nodal field: n_values = nodes x values per node, node after node.
 * ROLLCON_ERR_NONFINITE: a value is beyond the range of double precision.
 *   field     ROLLCON_FIELD_...
 *   axes      ROLLCON_LOCAL or ROLLCON_GLOBAL
 *   capacity  doubles at v; 0 only asks for the need
 *   v         [capacity], out; values; NULL only with capacity 0
 *   n_values  out, may be NULL; doubles of the field; set after ROLLCON_ERR_CAPACITY too
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_CAPACITY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_field(const rollcon_contact *contact,
    int32_t field, int32_t axes, int64_t capacity, double *v, int64_t *n_values);

/*
 * Returns the state of each node: ROLLCON_OPEN, STICK, SLIP or EXCLUDED.
 *   capacity  numbers at status; at least the nodes of the frame
 *   status    [capacity], out
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_CAPACITY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_node_states(
    const rollcon_contact *contact, int64_t capacity, int32_t *status);

/*
 * Returns the resultant force on body 1 and its moment about the origin of the axes.
 *   axes     ROLLCON_LOCAL or ROLLCON_GLOBAL
 *   force    [3], out, may be NULL; force
 *   moment   [3], out, may be NULL; force x length
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_resultant(
    const rollcon_contact *contact, int32_t axes, double *force, double *moment);

/*
 * Returns approach, creepages and spin, given or found for prescribed forces.
 *   approach  out, may be NULL; length
 *   creep     [3], out, may be NULL; longitudinal, lateral (dimensionless), spin (1/length)
 * Also returns: ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_motion(
    const rollcon_contact *contact, double *approach, double *creep);

/*
 * Returns rotations of body 1 against body 2 about t1 and t2, given or found for prescribed
 * moments (rollcon_contact_prescribe).
 *   tilt     [2], out; radian
 * Also returns: ROLLCON_ERR_STATE.
 * Source: docs/theory.md, loads.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_tilt(const rollcon_contact *contact,
    double *tilt);

/*
 * Returns the derivatives of what rollcon_contact_get_resultant (local axes) and
 * rollcon_contact_get_motion give, by one parameter. A direction stands for the value last solved
 * with there: creepage, spin or approach where the motion was prescribed; force, spin moment or
 * compressive load where the force was; motions that were found then change with it. FRICTION
 * stands for a factor, now 1, on every friction coefficient: for d/dmu of a uniform mu divide by
 * mu. They are those of Newton's system at the solution, the state of every node held: at most
 * one factorisation for all parameters (one more for NORMAL where pressures stand alone) and one
 * right side each; kept until the next solve. After ROLLCON_NO_CONTACT only a prescribed motion's
 * derivative by itself is not 0. ROLLCON_ERR_STATE: no solution, one that did not converge, or
 * the parameter is a tangential force or spin moment without friction. ROLLCON_ERR_SINGULAR: a
 * load at the limit of friction. ROLLCON_ERR_UNSUPPORTED: friction follows the whole solution (of
 * temperature, with a memory, of a layer that flows).
 *   parameter  ROLLCON_LONGITUDINAL, LATERAL, NORMAL, SPIN, FRICTION, TILT_1 or TILT_2
 *   force      [3], out, may be NULL; derivative of the force on body 1, local axes
 *   moment     [3], out, may be NULL; derivative of its moment about the origin, local axes
 *   approach   out, may be NULL; derivative of the approach
 *   creep      [3], out, may be NULL; derivatives of longitudinal and lateral creepage and spin
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_SINGULAR,
 *   ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, Newton's iteration.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_sensitivity(
    const rollcon_contact *contact, int32_t parameter, double *force, double *moment,
    double *approach, double *creep);

/*
 * Returns the elastic displacement of a body at any points of the contact surface, on the frame
 * or off it, in local axes (of the point, if curved).
 *   which    ROLLCON_BODY1 or ROLLCON_BODY2
 *   n        points, >= 0
 *   xy       [n][2]; positions along t1 and t2 from the origin, length
 *   u        [n][3], out; displacement (t1, t2, n), length
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, half-spaces.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_displacements_at(
    const rollcon_contact *contact, int32_t which, int64_t n, const double *xy, double *u);

/*
 * Returns displacements and stresses at any points inside a body, or on its surface, under the
 * tractions of the last solve and the body's own loads. Tension is positive. Half-spaces:
 * tractions (rollcon_contact_get_tractions) are interpolated by the frame's shape functions; body
 * 1 fills n <= 0 and body 2 n >= 0, on the surface n = 0 results are the limits from inside;
 * every stress is within the option stress_accuracy times the largest traction of the exact
 * integrals. Where tractions jump (at the rim of a frame that ends under load) stresses along the
 * surface grow like a logarithm and are given for a depth of 1e-8 of the smallest element. On a
 * curved frame the local components of tractions act on the plane of the axes, which they do in
 * the solve, too. Finite elements: what rollcon_body_get_fields_at gives for
 * rollcon_contact_get_body_displacements. Boundary elements: Somigliana's identities, as near to
 * the surface as wanted, and on it; errors there are those of the solution, and largest where
 * tractions jump. ROLLCON_ERR_UNSUPPORTED: a rigid body; ROLLCON_ERR_ARGUMENT: a point is
 * outside, and by how much of a surface of boundary elements (a millionth of the element's size
 * beyond its faces is still inside).
 *   which    ROLLCON_BODY1 or ROLLCON_BODY2
 *   n        points, >= 0
 *   xyz      [n][3]; in these axes, length
 *   in_axes  ROLLCON_IN_CONTACT or ROLLCON_IN_BODY: of points and results
 *   u        [n][3], out; displacement, length; NULL: not wanted
 *   stress   [n][6], out; s11, s22, s33, s12, s13, s23, force/length^2; NULL: not wanted
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_SINGULAR,
 *   ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, inside of half-spaces, of finite elements, of boundary elements.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_fields_at(
    const rollcon_contact *contact, int32_t which, int64_t n, const double *xyz, int32_t in_axes,
    double *u, double *stress);

/*
 * Searches a half-space under the last solve for the largest value of a measure of stress, and
 * says where it is. "von_mises", "shear" (half the difference of the extreme principal stresses)
 * and "orthogonal_shear" (|s13|) take no parameters. Measures of the history of a particle that
 * passes through the contact along t1: "dang_van" and "crossland" take the weight a of the
 * hydrostatic stress h, and are max(shear of the deviator less the centre of its least ball + a
 * h) and radius of the least ball/sqrt(2) + a max h. "lundberg_palmgren" takes exponents c and h
 * and a least depth: value is the integral of amplitude(s13)^c/depth^h over t2 and depth, which
 * times the length of the track is the volume integral of a bearing's life; place is that of the
 * largest amplitude. Values are those of the solution's tractions: at a sharp end they depend on
 * the frame. ROLLCON_ERR_OPTION: no such measure; ROLLCON_ERR_STATE: no solution, or no contact;
 * ROLLCON_ERR_UNSUPPORTED: no half-space, or a conformal contact.
 *   which       ROLLCON_BODY1 or ROLLCON_BODY2
 *   measure     von_mises, shear, orthogonal_shear, dang_van, crossland or lundberg_palmgren
 *   n           parameters of the measure
 *   parameters  [n]; of the measure, in its order
 *   value       out; force/length^2; of lundberg_palmgren that to the power c, times length^(2 -
 *               h)
 *   place       [3], out; along t1, t2 and n, length
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_OPTION, ROLLCON_ERR_STATE,
 *   ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, inside of half-spaces.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_find_stress(
    const rollcon_contact *contact, int32_t which, const char *measure, int32_t n,
    const double *parameters, double *value, double *place);

/*
 * Returns displacements of all nodes of a body of finite or boundary elements under the tractions
 * of the last solve and the body's own loads, in the body's axes. Under a frame of its own finer
 * than the body's faces these are the tractions that the elements feel (docs/theory.md, section
 * 10). The first call for a body factorises its stiffness once more, with nothing condensed;
 * contacts and solves after that use the factors (unless its option keep_factors is 0); boundary
 * elements have theirs. ROLLCON_ERR_UNSUPPORTED: another kind of body.
 *   which     ROLLCON_BODY1 or ROLLCON_BODY2
 *   capacity  doubles that fit into u; 0 asks for their number
 *   u         [capacity], out, may be NULL; displacement x y z of each node, length
 *   n_values  out, may be NULL; three for each node of the body; set after ROLLCON_ERR_CAPACITY
 *             too
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_SINGULAR, ROLLCON_ERR_UNSUPPORTED,
 *   ROLLCON_ERR_CAPACITY, ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, inside of finite elements.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_body_displacements(
    const rollcon_contact *contact, int32_t which, int64_t capacity, double *u,
    int64_t *n_values);

/*
 * Returns the power that a viscoelastic section loses in each harmonic of its way under the
 * tractions of the last solve: it heats the body. The sum over all bodies is the statistic
 * body_power. ROLLCON_ERR_UNSUPPORTED: another body.
 *   which     ROLLCON_BODY1 or ROLLCON_BODY2
 *   capacity  doubles that fit into power; 0 asks for their number
 *   power     [capacity], out, may be NULL; power of harmonics 0, 1, 2, ..., force length/time
 *   n_values  out, may be NULL; harmonics; set after ROLLCON_ERR_CAPACITY too
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_CAPACITY,
 *   ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, section 3.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_body_power(
    const rollcon_contact *contact, int32_t which, int64_t capacity, double *power,
    int64_t *n_values);

/*
 * Writes the elements of a body of finite or boundary elements, or a block of a half-space around
 * the contact, three times as long and wide, with displacements, smoothed stresses (xx, yy, zz,
 * xy, yz, xz, in ParaView's order) and von Mises's stress at the nodes, under the tractions of
 * the last solve and the body's own loads, as a VTU file for ParaView and meshio. A section is
 * written as the elements that its part of option sector sweeps, around the contact. The call is
 * otherwise like rollcon_contact_get_fields_at.
 *   which    ROLLCON_BODY1 or ROLLCON_BODY2
 *   path     name of the file; an existing one is replaced
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_SINGULAR, ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_IO,
 *   ROLLCON_ERR_MEMORY.
 * Source: docs/theory.md, inside of boundary elements.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_write_body(
    const rollcon_contact *contact, int32_t which, const char *path);

/*
 * Writes what the contact does to a body with a mesh as forces on the body's own nodes, in its
 * axes: the integrals of the last solve's tractions times the nodes' shape functions. A name that
 * ends in .inp gets *CLOAD cards of Abaqus and CalculiX, of components that are not zero; one
 * that ends in .mtx a MatrixMarket vector of x, y, z of each node in the order of the body. Nodes
 * have the numbers of the file that the mesh was read from; of arrays the first is 1. The sums of
 * force and moment are those of the contact (rollcon_contact_get_resultant; the second body takes
 * the opposite): a frame and curved faces under it are not one surface, and what is missing is
 * spread linearly over the loaded nodes. The file tells the resultant about the origin of the
 * body's axes, and by how much that moved the forces. Forces of the body's own loads and supports
 * are not among them. ROLLCON_ERR_UNSUPPORTED: a body without a mesh, or a build without finite
 * elements.
 *   which    ROLLCON_BODY1 or ROLLCON_BODY2
 *   path     name of the file, which ends in .inp or .mtx; an existing one is replaced
 * Also returns: ROLLCON_ERR_MESH, ROLLCON_ERR_STATE, ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_IO,
 *   ROLLCON_ERR_MEMORY.
 * Source: docs/howto/calculix.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_write_loads(
    const rollcon_contact *contact, int32_t which, const char *path);

/*
 * Returns temperatures of the surfaces of both bodies at any points of the plane of the axes by
 * the frictional heat of the last solve, steady rolling, and what the bodies have far away
 * (rollcon_contact_set_heat): before the contact, in it, where both have the same, and behind it.
 * Heat is carried along the rolling direction and spreads into the depth alone, which holds where
 * the speed times half the length of the contact is well above the diffusivity (conductivity over
 * heat capacity). Frictional power varies linearly between nodes. ROLLCON_ERR_STATE: no solution,
 * no heat given, or a step in time.
 *   n            points, >= 0
 *   xy           [n][2]; positions along t1 and t2 from the origin, length
 *   temperature  [n][2], out; temperatures of bodies 1 and 2
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/friction.md; Ertz and Knothe 2002.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_temperatures_at(
    const rollcon_contact *contact, int64_t n, const double *xy, double *temperature);

/*
 * Returns the railways' index of surface-initiated rolling contact fatigue of wheels, after
 * Ekberg, Kabo and Andersson (bearings: rollcon_contact_find_stress), FI = sqrt(F1^2 + F2^2)/Fn -
 * 2 A k/(3 Fn), with the area A in contact (statistic contact_area; pi a b for an ellipse) and
 * the yield stress k in shear; positive where fatigue is to be expected. ROLLCON_ERR_STATE: no
 * solution, or no normal force. The wear number T-gamma, force times creepage, is the statistic
 * t_gamma.
 *   shear_yield  k, force/length^2, above 0
 *   index        out; dimensionless
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 * Source: docs/theory.md, statistics (Ekberg, Kabo, Andersson 2002).
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_fatigue_index(
    const rollcon_contact *contact, double shear_yield, double *index);

/*
 * Returns the Hertzian contact that stands for this one, in the form of inputs of
 * rollcon_table_evaluate. The ellipse has the area in contact (statistic contact_area) and, along
 * over across, the second moments of the pressures. Load, creepages and spin are those of the
 * solution, the latter by least squares weighted with pressure about its centre; the solution
 * needs no friction. Friction is the mean over the pressure, for falling laws at the speed of the
 * rigid slip; inputs[2] may be replaced. Elastic constants: mean values of 1/G and nu/G; where
 * pressure strains one body more than the other, the longitudinal creepage has the mean
 * difference of these strains on top. A moment about the contact's origin has center[0] F2 -
 * center[1] F1 more than one about the centre. ROLLCON_ERR_STATE: no solution, no load, several
 * patches far apart, or a shift; ROLLCON_ERR_UNSUPPORTED: a body has a mesh, a layer is between
 * the bodies, or friction depends on the direction.
 *   inputs   [9], out; shear modulus, Poisson's ratio, friction, semi-axes along and across the
 *            rolling direction, load, longitudinal and lateral creepage, spin
 *   center   [2], out; along t1 and t2
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_UNSUPPORTED.
 * Source: docs/tables.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_equivalent_ellipse(
    const rollcon_contact *contact, double *inputs, double *center);

/*
 * Returns the depth that one pass of the contact wears off, along t2: the integral of the law's
 * rate along the rolling direction, at the friction, pressure and slip of the last solve; after a
 * step in time, what that step takes off. Material is given to the points by the functions that
 * are 1 at a point and linear to its neighbours: the sum of depth times the point's length of y
 * is the volume exactly. A body that comes by once per revolution has this depth per revolution,
 * and the same law may be asked for each body with its own coefficients. Half-spaces and rigid
 * bodies in steady rolling, with all of the contact on the frame, lose what the balance of work
 * says (statistic friction_power_balance), which misses nothing on coarse frames; others what
 * slip at nodes takes (friction_power). Laws: "archard": rate = i p |s|/V; with i1, i2 and an
 * angle p |(i1 s1, i2 s2)|/V, in axes turned by the angle from t1 towards t2. "t_gamma": pairs
 * (e, r) of energy density e = |t s|/V, ascending, and rate r (depth per length rolled), linear
 * between, from (0, 0), and beyond the last pair. ROLLCON_ERR_ARGUMENT: y does not cover the
 * nodes in contact.
 *   law         archard or t_gamma
 *   n           parameters of the law
 *   parameters  [n]; i; i1, i2, angle (length^2/force, radian); e, r, e, r, ... (force/length^2,
 *               dimensionless)
 *   points      2 to 1000000
 *   y           [points]; places along t2, ascending, length
 *   depth       [points], out; per pass, length; NULL: not wanted
 *   volume      out; per length rolled, length^2; NULL: not wanted
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_OPTION, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/wear.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_wear(const rollcon_contact *contact,
    const char *law, int32_t n, const double *parameters, int64_t points, const double *y,
    double *depth, double *volume);

/*
 * Moves points of a profile into their body by what wears off over a distance: along the normal,
 * by the rate smoothed, of as much of the distance as wears no point deeper than most_depth.
 * Smoothing keeps the volume: waves as long as `smoothing` keep one half, and nothing gets below
 * the least rate or above the greatest.
 *   points      2 to 1000000
 *   yz          [points][2]; in the order of the profile, length
 *   rate        [points]; depth per distance, >= 0
 *   side        ROLLCON_BODY_BELOW or ROLLCON_BODY_ABOVE
 *   distance    >= 0
 *   most_depth  > 0, length
 *   smoothing   length of waves, >= 0; 0: none
 *   worn        [points][2], out; may be yz
 *   taken       out; part of the distance that was taken; NULL: not wanted
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MEMORY.
 * Threads: any.
 * Source: docs/wear.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wear_profile(int64_t points, const double *yz,
    const double *rate, int32_t side, double distance, double most_depth, double smoothing,
    double *worn, double *taken);

/*
 * Returns principal stresses, von Mises's stress and the largest shear stress of n stresses,
 * which may come from rollcon_contact_get_fields_at or elsewhere. Principal stresses are exact to
 * rounding, relative to the largest of the three.
 *   n          stresses, >= 0
 *   stress     [n][6]; s11, s22, s33, s12, s13, s23, tension positive
 *   principal  [n][3], out; the largest first; NULL: not wanted
 *   von_mises  [n], out; sqrt(3/2) times the norm of the deviator; NULL: not wanted
 *   shear      [n], out; half the difference of the first and the last principal stress; NULL:
 *              not wanted
 * Also returns: ROLLCON_ERR_NONFINITE.
 * Threads: any.
 * Source: docs/theory.md, inside of half-spaces.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_stress_invariants(int64_t n,
    const double *stress, double *principal, double *von_mises, double *shear);

/*
 * Returns one number about the last solve: residuals, error estimates, iterations, areas, power,
 * seconds, bytes. Names: rollcon_stat_info; meanings: docs/theory.md, section 8. An error
 * estimate is computed when one of its numbers is asked for, at about the price of a solve.
 *   value    out
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_OPTION, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_stat(const rollcon_contact *contact,
    const char *name, double *value);

/*
 * Returns the iterations of the last solve, one row each, with the columns asked for: phase,
 * iteration, residual_normal, residual_tangential, step (its length), nodes_contact, nodes_slip,
 * seconds (since the solve began), error_function: half the sum of the squared residuals of the
 * contact laws over all nodes, each over the largest pressure or tangential traction of the
 * iterate, and of the squared relative errors of the loads, times the nodes in contact. No rows
 * before a solve.
 *   columns   names separated by blanks, each a number of a row
 *   capacity  rows that fit; 0 only asks for the need
 *   rows      [capacity][columns], out; the columns side by side; NULL only with capacity 0
 *   n_rows    out, may be NULL; rows there are; set after ROLLCON_ERR_CAPACITY too
 * Also returns: ROLLCON_ERR_OPTION, ROLLCON_ERR_CAPACITY.
 * Source: docs/procedures.md, error function.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_history(
    const rollcon_contact *contact, const char *columns, int64_t capacity, double *rows,
    int64_t *n_rows);

/*
 * Returns how the last solve was done (sizes, schemes, linear solver and why), as text for
 * people.
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_CAPACITY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_get_plan(const rollcon_contact *contact,
    int64_t capacity, char *text, int64_t *needed);

/*
 * Writes frame and fields, in global axes, as a VTU file for ParaView and meshio. A field beyond
 * the range of double precision is ROLLCON_ERR_NONFINITE; nothing is written.
 *   path     name of the file; an existing one is replaced
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_IO, ROLLCON_ERR_MEMORY,
 *   ROLLCON_ERR_UNSUPPORTED.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_write(const rollcon_contact *contact,
    const char *path);

/* ------------------------------------------------------------- Wheel on rail: making, inputs */
/* A wheel of a wheelset on its rail takes profiles, dimensions, position and velocity, and gives
   patches and forces. Axes of the track: x forward, y to the right, z down, the origin midway
   between the rails at the height of their top. Roll, yaw and pitch are about x, z and y: a point
   of the wheelset is pitched about its axle, rolled about x, then yawed about z, all axes but the
   axle's fixed in the track; the option roll_outside changes that order. Everything that is set
   stays; docs/wheelrail.md has the figures. */

/*
 * Makes a wheel on its rail. The profile of the wheel has y from the tread's datum, the flange at
 * lesser y, and z down (like "s1002"); that of the rail is upright, with its gauge side at lesser
 * y and z down. Both are the same on both sides of the track: what is on the left is the mirror
 * image. Where the profiles lie in their bodies (rollcon_body_extrude_profile,
 * rollcon_body_revolve_profile) does not matter, and the bodies stay free for other uses.
 * Sections are prepared, and their contact edges are the profile (docs/wheelrail.md). A profile
 * or elastic constants that the bodies are given later count from the next solve. At least one
 * body must be elastic. The standard is rails without deviation, height prescribed by motion,
 * accuracy 0.01; everything else must be set before a solve.
 *   wheel      a half-space or rigid, with a profile (else ROLLCON_ERR_STATE), or a section
 *   rail       a half-space or rigid, with a profile (else ROLLCON_ERR_STATE), or a section; may
 *              be of another context
 *   side       ROLLCON_LEFT or ROLLCON_RIGHT
 *   wheelrail  new handle
 * Ownership: The caller owns the new handle: release it. It keeps bodies and context alive.
 *   *wheelrail is NULL after a failure.
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY, ROLLCON_ERR_MESH, ROLLCON_ERR_SINGULAR.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_create(rollcon_context *context,
    rollcon_body *wheel, rollcon_body *rail, int32_t side, rollcon_wheelrail **wheelrail);

/*
 * Drops a reference; the handle is dead after the last one. Contacts of its patches live on. NULL
 * and dead handles are ignored.
 *   wheelrail  may be NULL
 * Threads: any.
 */
ROLLCON_API void ROLLCON_CALL rollcon_wheelrail_release(rollcon_wheelrail *wheelrail);

/*
 * Says where the rails lie: each is canted, its top is at z = 0, and its gauge side is half the
 * gauge from the middle of the track.
 *   gauge         > 0, length
 *   gauge_height  below the top of the rails, where the gauge is measured; length; 0 places the
 *                 rail by its profile's origin: half the gauge from the middle, z = 0
 *   cant          of each rail towards the middle of the track, radian, -0.5 to 0.5; 0 if the
 *                 profile is canted already
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_track(rollcon_wheelrail *wheelrail,
    double gauge, double gauge_height, double cant);

/*
 * Sets the dimensions of the wheelset.
 *   back_to_back  distance between the backs of the flanges, > 0, length
 *   flange_back   y of the flange's back in the profile of the wheel, length
 *   radius        radius at the profile's z = 0, > 0, length; radius + z > 0 all along the
 *                 profile
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_wheelset(
    rollcon_wheelrail *wheelrail, double back_to_back, double flange_back, double radius);

/*
 * Places the rail by the origin of its profile in the track, in place of
 * rollcon_wheelrail_set_track. Deviations of the rail roll about this origin then.
 *   y          distance of the origin from the middle of the track, > 0 towards the side of the
 *              rail, length
 *   z          of the origin, length
 *   cant       inwards, -0.5 to 0.5, radian; about the origin
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_place_rail(
    rollcon_wheelrail *wheelrail, double y, double z, double cant);

/*
 * Makes the rail a roller of a test rig: its profile turns about an axis along y, one radius
 * below the top of the rail, or below the origin of a rail that is placed by its origin
 * (rollcon_wheelrail_place_rail). The contact moves over the roller at the rate times the radius
 * plus the forward speed of the wheelset, which is 0 on a rig. Entry 0 of the position is the
 * distance of the wheelset from the place above the axis, length. ROLLCON_ERR_ARGUMENT: the track
 * has a cant. The solve refuses profiles that vary, tables, conformal contacts and sections
 * (ROLLCON_ERR_UNSUPPORTED).
 *   radius     of the roller, > 0, length; more than its profile is deep; 0: a rail (standard)
 *   rate       at which the roller turns about y, 1/time; > 0 where wheels on it roll forward
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_roller(
    rollcon_wheelrail *wheelrail, double radius, double rate);

/*
 * Makes every solve from now on a step in time of length dt; ROLLCON_STEADY makes it a steady
 * state again. ROLLCON_ROLLING_STEP: the wheel rolls on as its velocity says. ROLLCON_SHIFT_STEP:
 * nothing rolls, velocities times dt are shifts, and the forward speed may be 0. Patches carry
 * their tractions from step to step and hand them on by place where they move, part or merge. The
 * first step starts from the steady state that was solved last, or from rest if there is none;
 * for rest call rollcon_wheelrail_reset. A step that fails keeps the state before it. The solve
 * refuses sections, tables and conformal contacts, and calls with lists of positions refuse steps
 * (ROLLCON_ERR_UNSUPPORTED).
 *   kind       ROLLCON_STEADY, ROLLCON_ROLLING_STEP or ROLLCON_SHIFT_STEP
 *   dt         > 0, time; ignored if the kind is ROLLCON_STEADY
 * Also returns: ROLLCON_ERR_NONFINITE.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_step(rollcon_wheelrail *wheelrail,
    int32_t kind, double dt);

/*
 * Takes the last step back: the next solve starts from where that step started. This is possible
 * once after each step that succeeded (else ROLLCON_ERR_STATE).
 * Also returns: ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_repeat_step(
    rollcon_wheelrail *wheelrail);

/*
 * Copies what the next step in time starts from to an array of the caller's, as numbers: a header
 * with a version; axes, grids and tractions of the patches, in the caller's units; a checksum.
 * Another run, or another handle of the same wheel and rail, can start from them.
 * ROLLCON_ERR_STATE: no step was made.
 *   capacity   doubles at past; 0 only asks for the need
 *   past       [capacity], out; NULL only with capacity 0
 *   n_values   out, may be NULL; doubles of the past; set after ROLLCON_ERR_CAPACITY too
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_CAPACITY.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_past_get(
    const rollcon_wheelrail *wheelrail, int64_t capacity, double *past, int64_t *n_values);

/*
 * Lets the next step start from numbers that rollcon_wheelrail_past_get gave; they are copied.
 * Track and wheelset must be set (ROLLCON_ERR_STATE). ROLLCON_ERR_ARGUMENT: the numbers were
 * changed, or belong to the other side or to other elastic constants; the past stays as it was.
 * The results of the last solve are gone.
 *   past       [n]; what rollcon_wheelrail_past_get gave
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_NONFINITE, ROLLCON_ERR_UNSUPPORTED,
 *   ROLLCON_ERR_MEMORY.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_past_set(rollcon_wheelrail *wheelrail,
    int64_t n, const double *past);

/*
 * Says where on the wheel's profile the radius of rollcon_wheelrail_set_wheelset is measured,
 * after that call, which takes it where the profile has z = 0.
 *   y          of the tape circle in the profile, length
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_tape_circle(
    rollcon_wheelrail *wheelrail, double y);

/*
 * Displaces the wheel in the axes of the wheelset, which bends, and says how that changes. The
 * wheel is displaced at the origin of its profile below the axle, and turned there. The standard
 * is 0.
 *   displacement  [6]; along x, y, z, length; about x, z, y (roll, yaw, pitch), radian; roll and
 *                 yaw -0.5 to 0.5
 *   rate          [6]; rates of these, length/time and 1/time
 * Also returns: ROLLCON_ERR_NONFINITE.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_flexibility(
    rollcon_wheelrail *wheelrail, const double *displacement, const double *rate);

/*
 * Puts the rail on springs along y and z of the track: beside its deviation it gives way until
 * stiffness times deflection is the force of the wheel on it plus the force given here.
 * Statistics rail_deflection_y and _z are what was found.
 *   stiffness  [2]; along y and z, force/length, > 0, or 0: rigid (standard)
 *   force      [2]; on the rail beside that of the wheel, along y and z
 * Also returns: ROLLCON_ERR_NONFINITE.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_rail_springs(
    rollcon_wheelrail *wheelrail, const double *stiffness, const double *force);

/*
 * Sets the deviation of the rail from its place in the track and how it changes: irregularities,
 * and rails that give way. The standard is 0.
 *   deviation  [3]; along y and z, length; roll, radian, about the point where the gauge is
 *              measured, at the height of the rails' top, -0.5 to 0.5
 *   rate       [3]; rates of these, length/time and 1/time
 * Also returns: ROLLCON_ERR_NONFINITE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_rail_deviation(
    rollcon_wheelrail *wheelrail, const double *deviation, const double *rate);

/*
 * Sets the position of the wheelset. z = 0 is where the tread's datum of a centred wheelset is at
 * the height of the rails' top; z is not used where a vertical force is prescribed (statistic "z"
 * is what was found), except as the start of the search.
 *   position   [6]; of the wheelset's centre: x, y, z, length; roll, yaw and pitch, radian; roll
 *              and yaw -0.5 to 0.5
 * Also returns: ROLLCON_ERR_NONFINITE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_position(
    rollcon_wheelrail *wheelrail, const double *position);

/*
 * Sets the velocity of the wheelset.
 *   velocity   [6]; rates of the position, length/time and 1/time; the forward speed, the first,
 *              is not 0 but on a roller or in a shift; the pitch rate of a wheel that rolls
 *              forward is negative
 * Also returns: ROLLCON_ERR_NONFINITE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_velocity(
    rollcon_wheelrail *wheelrail, const double *velocity);

/*
 * Prescribes the height of the wheelset by motion, from its position (standard), or by the
 * vertical force; z is then found by the solve.
 *   how        ROLLCON_BY_MOTION or ROLLCON_BY_FORCE
 *   force      force of this wheel on its rail, along z of the track, >= 0; ignored by motion
 * Also returns: ROLLCON_ERR_NONFINITE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_prescribe_vertical(
    rollcon_wheelrail *wheelrail, int32_t how, double force);

/*
 * Prescribes the pitch rate by motion, from the velocity (standard), or the force on the wheel
 * along the wheelset's x; the pitch rate is then found by the solve, from that of the velocity on
 * (statistic "pitch_rate").
 *   how        ROLLCON_BY_MOTION or ROLLCON_BY_FORCE
 *   force      on the wheel, forwards; ignored by motion
 * Also returns: ROLLCON_ERR_NONFINITE.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_prescribe_longitudinal(
    rollcon_wheelrail *wheelrail, int32_t how, double force);

/*
 * Sets the law of friction: one of rollcon_contact_set_friction, or "by_angle", Coulomb's law by
 * the inclination of the rail, angle1, mu1, angle2, mu2, ...
 * (rollcon_wheelrail_set_law_by_angle). Angles of orthotropic laws count in the axes of the
 * patch, those of a left wheel in the mirror. Where friction falls and several solutions exist, a
 * solve continues the last one, and one from nothing begins with the friction of rest.
 *   law         a name of a law, or by_angle
 *   n           parameters of the law; 2, 4, 6, ... for by_angle
 *   parameters  [n]; those of rollcon_contact_set_friction; angle1, mu1, angle2, mu2, ... The
 *               greatest coefficient is 0 to 10
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MEMORY.
 * Source: docs/friction.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_friction(
    rollcon_wheelrail *wheelrail, const char *law, int32_t n, const double *parameters);

/*
 * Sets a law whose parameters follow the inclination of the rail's surface, linear between points
 * and constant beyond them: lubricated gauge faces under dry heads. The inclination is atan dz/dy
 * of a right rail with y to the right and z down, its cant included, its deviation not: negative
 * on the gauge face; left rails are mirrored, so that one table serves both. The greatest
 * coefficient follows the inclination across a patch, the form of the law is that at the
 * reference of the patch.
 *   law         a name of a law (rollcon_contact_set_friction)
 *   points      1 to 1000
 *   n           points times one more than the law has parameters
 *   parameters  [n]; for each point its angle, ascending, radian, and then the parameters of the
 *               law there
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_MEMORY.
 * Source: docs/friction.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_law_by_angle(
    rollcon_wheelrail *wheelrail, const char *law, int32_t points, int32_t n,
    const double *parameters);

/*
 * Gives friction that falls with the slip speed a memory, as for a contact.
 *   length       length of slip, >= 0; 0: no memory
 *   least_speed  >= 0, slip speed, length/time
 * Also returns: ROLLCON_ERR_NONFINITE.
 * Source: docs/friction.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_friction_memory(
    rollcon_wheelrail *wheelrail, double length, double least_speed);

/*
 * Puts a thin layer between wheel and rail, as between the bodies of a contact.
 *   flexibility  thickness over shear modulus, length^3/force, >= 0
 *   stress       >= 0, force/length^2; 0: never flows, and with flexibility 0 there is no layer
 *   hardening    force/length^3; negative: softening
 * Also returns: ROLLCON_ERR_NONFINITE.
 * Source: docs/friction.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_layer(rollcon_wheelrail *wheelrail,
    double flexibility, double stress, double hardening);

/*
 * Says what wheel or rail does with heat, for the temperatures of the contacts of patches
 * (rollcon_contact_get_temperatures_at) and for friction that depends on them. The call is needed
 * for both.
 *   which          ROLLCON_WHEEL or ROLLCON_RAIL
 *   conductivity   >= 0, power/(length temperature)
 *   heat_capacity  >= 0, energy/(volume temperature): density times specific heat
 *   temperature    temperature far from the contact
 * Also returns: ROLLCON_ERR_NONFINITE.
 * Source: docs/friction.md; Ertz and Knothe 2002.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_heat(rollcon_wheelrail *wheelrail,
    int32_t which, double conductivity, double heat_capacity, double temperature);

/*
 * Looks forces along the surfaces and spin moments up in a creep-force table from now on, for an
 * ellipse that has the linear theory of each patch, which is solved without friction: its contact
 * then has pressures alone. The table keeps what it takes to calibrate the ellipses of a pair of
 * profiles, which is found when it is first needed. A patch that the table does not have (ratio
 * of its axes, Poisson's ratio, no single ellipse, or a place on the profile without one) is
 * solved in full; statistic by_table of the patch is 0. The wheel keeps the table; NULL solves
 * all patches in full again. ROLLCON_ERR_STATE: the table is not made yet.
 *   table      NULL: no table
 * Also returns: ROLLCON_ERR_STATE.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_table(rollcon_wheelrail *wheelrail,
    const rollcon_table *table);

/*
 * Finds the patches and solves each as a steady rolling contact, from the last solution where
 * there is one. The status is the worst of the patches' in the order that holds for all calls.
 * RIM_CONTACT: a patch ends at the end of a profile, or is not within its frame; NO_CONTACT: the
 * wheel is lifted; the log has the numbers. ROLLCON_ERR_STATE names the call that is missing.
 * ROLLCON_ERR_ARGUMENT: with this z wheel and rail overlap by more than a tenth of the wheel's
 * radius. ROLLCON_ERR_LOAD: with this y no height brings the wheel on the rail, or no overlap up
 * to a tenth of the radius carries the vertical force. ROLLCON_ERR_MESH: a conformal patch
 * (option conformal) turns by more than 60 degrees to a side.
 * Also returns: ROLLCON_NOT_CONVERGED, ROLLCON_NO_CONTACT, ROLLCON_CANCELLED,
 *   ROLLCON_RIM_CONTACT, ROLLCON_COARSE, ROLLCON_TOO_DEEP, ROLLCON_DERAILED,
 *   ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_SINGULAR, ROLLCON_ERR_MEMORY,
 *   ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_LOAD, ROLLCON_ERR_MESH.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_solve(rollcon_wheelrail *wheelrail);

/*
 * Asks a running rollcon_wheelrail_solve or rollcon_wheelrail_solve_many to stop (an atomic
 * store) before its next patch, height or position. It returns ROLLCON_CANCELLED; the wheel stays
 * usable.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_request_cancel(
    rollcon_wheelrail *wheelrail);

/*
 * Solves many positions on the threads of the context, each by itself from nothing, as after
 * rollcon_wheelrail_reset, with what else is set: results do not depend on the other positions,
 * their order, or the number of threads, to the last bit. Columns of totals are force_x, force_y,
 * force_z, moment_x, moment_y, moment_z on the wheel in the track
 * (rollcon_wheelrail_get_resultant), z, vertical_force, friction_power. A position that fails has
 * its negative status and NaN and does not affect the others; texts go to the log as warnings.
 * The status returned is the worst in the order that holds for all calls; CANCELLED says that
 * some were not solved. The wheel and its last solution do not change.
 *   n           >= 0
 *   positions   [n][6]; those of rollcon_wheelrail_set_position; NULL only with n = 0
 *   velocities  [n][6]; those of rollcon_wheelrail_set_velocity; NULL only with n = 0
 *   columns     names separated by blanks, each a number of a row
 *   totals      [n][columns], out; a row for each position, the columns side by side; NULL only
 *               with n = 0
 *   status      [n], out, may be NULL; what rollcon_wheelrail_solve would return for each
 * Also returns: ROLLCON_NOT_CONVERGED, ROLLCON_NO_CONTACT, ROLLCON_CANCELLED,
 *   ROLLCON_RIM_CONTACT, ROLLCON_COARSE, ROLLCON_TOO_DEEP, ROLLCON_DERAILED, ROLLCON_ERR_OPTION,
 *   ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY, ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_MESH.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_solve_many(
    rollcon_wheelrail *wheelrail, int64_t n, const double *positions, const double *velocities,
    const char *columns, double *totals, int32_t *status);

/*
 * Finds the wear of wheel and rail by a spectrum of positions: solves them like
 * rollcon_wheelrail_solve_many, and adds the depths that a pass of each wears off either body
 * (rollcon_contact_get_wear) times its weight. A pass is one revolution of the wheel, or one
 * wheel over the rail. Depths are normal to the profiles, at points at equal arc lengths from end
 * to end (rollcon_body_get_profile_point); depth times the points' lengths of the profile adds up
 * to the volume. Patches of a wheel count with their weights. Positions without a solution wear
 * nothing, and are reported the way rollcon_wheelrail_solve_many reports them. ROLLCON_ERR_STATE:
 * something is missing, or forces come from a table (rollcon_wheelrail_set_table), which knows of
 * no slip.
 *   n_cases     1 to 100000
 *   positions   [n_cases][6]; those of rollcon_wheelrail_set_position
 *   velocities  [n_cases][6]; those of rollcon_wheelrail_set_velocity
 *   weights     [n_cases]; >= 0; NULL: each 1/n_cases
 *   law         that of rollcon_contact_get_wear
 *   n           parameters of the law
 *   parameters  [n]; of the law
 *   points      2 to 1000000, times n_cases at most 2e7
 *   wheel       [points], out; depth per pass, length; NULL: not wanted
 *   rail        [points], out; depth per pass, length; NULL: not wanted
 *   volumes     [2], out; per length rolled, of wheel and rail, length^2; NULL: not wanted
 *   status      [n_cases], out, may be NULL; what rollcon_wheelrail_solve would return for each
 * Also returns: ROLLCON_NOT_CONVERGED, ROLLCON_NO_CONTACT, ROLLCON_CANCELLED,
 *   ROLLCON_RIM_CONTACT, ROLLCON_COARSE, ROLLCON_TOO_DEEP, ROLLCON_DERAILED,
 *   ROLLCON_ERR_NONFINITE, ROLLCON_ERR_OPTION, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY,
 *   ROLLCON_ERR_UNSUPPORTED.
 * Source: docs/wear.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_find_wear(rollcon_wheelrail *wheelrail,
    int64_t n_cases, const double *positions, const double *velocities, const double *weights,
    const char *law, int32_t n, const double *parameters, int64_t points, double *wheel,
    double *rail, double *volumes, int32_t *status);

/*
 * Takes a snapshot of what is set and of the last solution, kept at a place within the wheel, for
 * rollcon_wheelrail_rollback, because integrators step back. Nothing is allocated where as much
 * was kept before.
 *   place      0 to 15
 * Also returns: ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_snapshot(rollcon_wheelrail *wheelrail,
    int32_t place);

/*
 * Goes back to a snapshot: inputs, results, and later solves are as if nothing had been done
 * since, to the last bit. ROLLCON_ERR_STATE: there is no snapshot at this place, or track or
 * wheelset have been set since. The snapshot stays. Contacts of patches that were new since then
 * are no longer those of this wheel.
 *   place      0 to 15
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_rollback(rollcon_wheelrail *wheelrail,
    int32_t place);

/*
 * Makes another wheel on its rail with the same bodies, inputs and last solution, and no
 * snapshots: both go on alike to the last bit.
 *   copy       new handle
 * Ownership: The caller owns the new handle: release it. *copy is NULL after a failure.
 * Also returns: ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_copy(
    const rollcon_wheelrail *wheelrail, rollcon_wheelrail **copy);

/*
 * Forgets the solution, the warm starts and what was before a step in time (bodies are at rest);
 * keeps what was set and all that was computed for the frames.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_reset(rollcon_wheelrail *wheelrail);

/* ------------------------------------------------------------------- Wheel on rail: settings */
/* Settings by name, in the manner of those of a contact. They count from the next solve. */

/*
 * Sets an integer option.
 * Also returns: ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_int(rollcon_wheelrail *wheelrail,
    const char *name, int64_t value);

/*
 * Sets a real option.
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_set_real(rollcon_wheelrail *wheelrail,
    const char *name, double value);

/*
 * Returns the value of an integer option.
 *   value      out
 * Also returns: ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_get_int(
    const rollcon_wheelrail *wheelrail, const char *name, int64_t *value);

/*
 * Returns the value of a real option.
 *   value      out
 * Also returns: ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_get_real(
    const rollcon_wheelrail *wheelrail, const char *name, double *value);

/* -------------------------------------------------------------------- Wheel on rail: results */
/* Results of the last solve; ROLLCON_ERR_STATE before one. Forces are those on the wheel. */

/*
 * Returns the number of patches, from 0.
 *   patches    out
 * Also returns: ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_get_patch_count(
    const rollcon_wheelrail *wheelrail, int64_t *patches);

/*
 * Returns the force of all patches on the wheel and its moment about the wheelset's centre.
 *   axes       ROLLCON_IN_TRACK or ROLLCON_IN_WHEELSET
 *   force      [3], out, may be NULL; force
 *   moment     [3], out, may be NULL; force x length
 * Also returns: ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_get_resultant(
    const rollcon_wheelrail *wheelrail, int32_t axes, double *force, double *moment);

/*
 * Returns the derivatives of the totals of the last solve by one entry of its position or
 * velocity: those of what rollcon_wheelrail_get_resultant gives in the track, and derivatives of
 * the wheelset's z. Where the height was found from a vertical force, that force stays and z
 * follows; entry 2 has none then. They are those of Newton's systems at the solutions of the
 * patches, whose axes and strips move; with a creep-force table, on conformal frames, with laws
 * other than Coulomb's and with a layer, central differences of solves. The first call finds all
 * twelve and keeps them until the next solve. ROLLCON_ERR_STATE: no solution, or one that did not
 * converge. ROLLCON_ERR_SINGULAR: a patch begins or ends here.
 *   entry      0 to 5: of the position (rollcon_wheelrail_set_position); 6 to 11: of the velocity
 *   force      [3], out, may be NULL; derivative of the force on the wheel
 *   moment     [3], out, may be NULL; derivative of its moment about the wheelset's centre, which
 *              moves along
 *   z          out, may be NULL; of the wheelset's z
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_SINGULAR, ROLLCON_ERR_MEMORY.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_get_derivative(
    rollcon_wheelrail *wheelrail, int32_t entry, double *force, double *moment, double *z);

/*
 * Returns one number about the last solve: height, vertical force, frictional power, counts.
 * Names: rollcon_stat_info; meanings: docs/wheelrail.md.
 *   value      out
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_get_stat(
    const rollcon_wheelrail *wheelrail, const char *name, double *value);

/*
 * Returns where a point of the wheel's or the rail's profile stood in the last solve, in the
 * track, for pictures. The wheel's profile is that in the plane of its axle, below it; of
 * profiles that vary, the section there.
 *   which      ROLLCON_WHEEL or ROLLCON_RAIL
 *   share      fraction of the length of that body's profile, 0 to 1, from the end where y is
 *              less
 *   point      [2], out; y and z, length
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_get_profile_point(
    const rollcon_wheelrail *wheelrail, int32_t which, double share, double *point);

/*
 * Returns one number about a patch: position, angle, rolling radius, creepages, forces, status.
 * Names: rollcon_stat_info; meanings: docs/wheelrail.md.
 *   patch      0 to rollcon_wheelrail_get_patch_count - 1
 *   value      out
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_OPTION.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_get_patch_stat(
    const rollcon_wheelrail *wheelrail, int32_t patch, const char *name, double *value);

/*
 * Returns origin and axes of the contact of a patch (rollcon_wheelrail_get_contact) in the track:
 * a node at (x, y, z) of the contact is at origin + x t1 + y t2 + z n. The axes of a left wheel
 * are a mirror image: a left-handed triple.
 *   patch      0 to rollcon_wheelrail_get_patch_count - 1
 *   origin     [3], out, may be NULL; the middle of its overlap; x counts from the wheelset's, as
 *              in the statistic, length
 *   axes       [9], out, may be NULL; unit vectors t1 (the rolling direction), t2 (across), n
 *              (into the rail)
 * Also returns: ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_get_patch_axes(
    const rollcon_wheelrail *wheelrail, int32_t patch, double *origin, double *axes);

/*
 * Returns the contact of a patch: body 1 is the wheel, body 2 the rail, and all its results are
 * in the axes contact of the patch, t1 along the rolling direction. It is there to be read: calls
 * that change a contact are ROLLCON_ERR_STATE, except rollcon_contact_set_progress and
 * rollcon_contact_request_cancel. The next solve of the wheel on its rail changes it. Its
 * solution at nodes is made by this call, and by each solve while the contact is held. Both are
 * one object to threads: while either is in use, so is the other.
 *   patch      0 to rollcon_wheelrail_get_patch_count - 1
 *   contact    of the patch
 * Ownership: The caller owns a reference: release it. It outlives the wheel on its rail, which
 *   then changes it no more. *contact is NULL after a failure.
 * Also returns: ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_get_contact(
    const rollcon_wheelrail *wheelrail, int32_t patch, rollcon_contact **contact);

/* ----------------------------------------------- Wheel on rail: rigid geometry of a wheelset */
/* A wheelset that rolls on rigid rails: from track, wheelset and deviations of the rails alone;
   nothing else need be set. Both handles are in use. */

/*
 * Finds where both wheels of a wheelset touch over its lateral shift, without yaw: the roll
 * follows from contact on both sides. Columns of points are z and roll of the wheelset and
 * radius_difference, the rolling radius on the right less that on the left; of the left wheel
 * left_y and left_z of the contact in the track, left_angle, left_wheel_y on the wheel's profile,
 * left_radius; of the right wheel right_y, ...
 *   left     made with ROLLCON_LEFT
 *   right    made with ROLLCON_RIGHT
 *   n        >= 0
 *   shift    [n]; y of the wheelset's centre, length; such that both wheels find their rails
 *   columns  names separated by blanks, each a number of a row
 *   points   [n][columns], out; a row for each shift, the columns side by side; what is behind a
 *            shift that fails is not written
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_OPTION, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/wheelrail.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_find_contact_points(
    rollcon_wheelrail *left, rollcon_wheelrail *right, int64_t n, const double *shift,
    const char *columns, double *points);

/*
 * Finds the equivalent conicities of EN 15302: those of cones whose free wheelset has the same
 * wavelength at the same amplitude of its kinematic motion, from the rolling-radius difference by
 * integration of y'' = -difference / (e r). Shifts count at the height of the rails.
 *   left        made with ROLLCON_LEFT
 *   right       made with ROLLCON_RIGHT
 *   n           >= 0
 *   amplitude   [n]; half the distance of the turning points, > 0, length; such that the wheelset
 *               comes back
 *   conicity    [n], out; tan gamma_e
 *   wavelength  [n], out, may be NULL; of the motion, length: with the distance e of the points
 *               of contact and the rolling radius r where the wheelset runs straight on
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/wheelrail.md; EN 15302.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_find_conicity(rollcon_wheelrail *left,
    rollcon_wheelrail *right, int64_t n, const double *amplitude, double *conicity,
    double *wavelength);

/* --------------------------------------------------------- Tables of settings and statistics */
/* Settings (..._set_int, ...) and statistics (..._get_stat) have names; these functions list
   them, with their meanings. They need no object. */

/*
 * Returns the number of options of a kind of object; 0 for kinds without options and for unknown
 * numbers.
 *   kind  ROLLCON_OF_...
 * Threads: any.
 */
ROLLCON_API int32_t ROLLCON_CALL rollcon_option_count(int32_t kind);

/*
 * Returns a row of the table of options. For text options low, high and standard are 0, and the
 * meaning ends with the values allowed.
 *   kind      ROLLCON_OF_...
 *   i         0 to rollcon_option_count - 1
 *   capacity  bytes at name, and at doc; 0 with needed NULL: no texts are wanted
 *   name      [capacity], out, may be NULL; its name; 32 bytes are enough for every name
 *   doc       [capacity], out, may be NULL; what it means
 *   needed    out, may be NULL; bytes of the longer text of those wanted (with capacity 0: of
 *             both), the NUL counted
 *   type      out, may be NULL; ROLLCON_TYPE_...
 *   low       out, may be NULL; least value allowed
 *   high      out, may be NULL; greatest value allowed
 *   standard  out, may be NULL; value of a new object
 * Also returns: ROLLCON_ERR_CAPACITY.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_option_info(int32_t kind, int32_t i,
    int64_t capacity, char *name, char *doc, int64_t *needed, int32_t *type, double *low,
    double *high, double *standard);

/*
 * Returns the number of statistics of a kind of object; 0 for kinds without statistics and for
 * unknown numbers.
 *   kind  ROLLCON_OF_...
 * Threads: any.
 */
ROLLCON_API int32_t ROLLCON_CALL rollcon_stat_count(int32_t kind);

/*
 * Returns a row of the table of statistics. Some count work inside the library: they help to
 * understand a solve, and another version may count otherwise or leave them out.
 *   kind      ROLLCON_OF_...
 *   i         0 to rollcon_stat_count - 1
 *   capacity  bytes at name, and at doc; 0 with needed NULL: no texts are wanted
 *   name      [capacity], out, may be NULL; its name; 32 bytes are enough for every name
 *   doc       [capacity], out, may be NULL; what it means
 *   needed    out, may be NULL; bytes of the longer text of those wanted (with capacity 0: of
 *             both), the NUL counted
 *   inside    out, may be NULL; 1: counts work inside the library, which is promised to nobody;
 *             0: stays
 * Also returns: ROLLCON_ERR_CAPACITY.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_stat_info(int32_t kind, int32_t i,
    int64_t capacity, char *name, char *doc, int64_t *needed, int32_t *inside);

/* ------------------------------------------------------------------------ Creep-force tables */
/* A table gives forces and spin moment of Hertzian steady rolling, from solved cases, in about a
   microsecond. What a table is given or makes stays: once it is there, any number of threads
   evaluate it. docs/tables.md has its errors. */

/*
 * Makes a table without samples. The standard is semi-axes' ratios a / b 1/25 to 25 in 12
 * intervals, 18 magnitudes, 16 angles, 16 directions, the frames of rollcon_table_set_frame(12,
 * 10), Poisson's ratios 0.28 and 0.3.
 *   table    new handle
 * Ownership: The caller owns the new handle: release it. It keeps the context alive. *table is
 *   NULL after a failure.
 * Also returns: ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_create(rollcon_context *context,
    rollcon_table **table);

/*
 * Drops a reference; the handle is dead after the last one. NULL and dead handles are ignored.
 *   table  may be NULL
 * Threads: any.
 */
ROLLCON_API void ROLLCON_CALL rollcon_table_release(rollcon_table *table);

/*
 * Makes a table from a file of rollcon_table_save. ROLLCON_ERR_IO: the file cannot be read, is
 * none of these, truncated or changed; ROLLCON_ERR_UNSUPPORTED: it is of another ABI number,
 * format or byte order.
 *   path     name of the file
 *   table    new handle
 * Ownership: The caller owns the new handle: release it. *table is NULL after a failure.
 * Also returns: ROLLCON_ERR_IO, ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_load(rollcon_context *context,
    const char *path, rollcon_table **table);

/*
 * Makes the table that comes with the library: steel on steel, Poisson's ratios 0.24 to 0.34,
 * ratios of semi-axes 1/25 to 25. Its file steel.rct is looked for in the folder that the
 * environment variable ROLLCON_DATA names, in share/rollcon above the library, and where the
 * library was to be installed (else ROLLCON_ERR_IO).
 *   table    new handle
 * Ownership: The caller owns the new handle: release it. *table is NULL after a failure.
 * Also returns: ROLLCON_ERR_IO, ROLLCON_ERR_UNSUPPORTED, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_standard(rollcon_context *context,
    rollcon_table **table);

/*
 * Sets which ratios a / b of semi-axes the table has. Call it before the first sample (else
 * ROLLCON_ERR_STATE).
 *   intervals  intervals of the logarithm of the ratio, 4 to 100
 *   least      0.01 or more
 *   greatest   more than the least, at most 100
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_set_ratios(rollcon_table *table,
    int32_t intervals, double least, double greatest);

/*
 * Sets how fine the table is in the creepages. Call it before the first sample (else
 * ROLLCON_ERR_STATE).
 *   magnitudes  intervals from none to vast creepages, 4 to 100
 *   angles      intervals from pure spin to none, 4 to 100
 *   directions  directions of the translational creepage in half a turn, even, 4 to 32
 * Also returns: ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_set_resolution(rollcon_table *table,
    int32_t magnitudes, int32_t angles, int32_t directions);

/*
 * Sets the coarser of the two frames of strips on which samples of circles are solved; those of
 * longer ellipses have more cells along their length and fewer across. Call it before the first
 * sample (else ROLLCON_ERR_STATE).
 *   along   elements along each strip, 6 to 100; the finer frame has twice as many
 *   across  strips, 4 to 100; the finer frame has twice as many
 * Also returns: ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_set_frame(rollcon_table *table,
    int32_t along, int32_t across);

/*
 * Makes it a table of bodies of equal elastic constants, which a new one is, and sets its
 * Poisson's ratios; it is linear between two and beyond them (by twice their distance and at most
 * 0.04, up to 0.5), cubic between more. Call it before the first sample (else ROLLCON_ERR_STATE).
 *   n         1 to 16
 *   poissons  [n]; ascending, -1 to 0.5
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_set_poissons(rollcon_table *table,
    int64_t n, const double *poissons);

/*
 * Makes it a table of two bodies whose elastic constants differ, one of which may be rigid: wheel
 * on rail of another metal, rubber on steel. Forces of such bodies depend on friction by itself:
 * the table has coefficients of friction, is linear in the logarithm of two and cubic in that of
 * more, and has none beyond. rollcon_table_evaluate then takes as shear and poisson the mean
 * values of the bodies (rollcon_contact_get_equivalent_ellipse), and creepages without the strain
 * under the pressure. Each coefficient of friction takes as long as two to three Poisson's ratios
 * of like bodies. Bodies whose (1 - 2 nu)/(2 G) are the same make a table of like bodies. Call it
 * before the first sample (else ROLLCON_ERR_STATE).
 *   youngs     [2]; Young's moduli of bodies 1 and 2, in any unit; 0: rigid, not both
 *   poissons   [2]; -1 to 0.5; ignored for a rigid body
 *   n          1 to 16
 *   frictions  [n]; coefficients of friction, ascending, above 0 to 10
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 * Source: docs/tables.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_set_bodies(rollcon_table *table,
    const double *youngs, const double *poissons, int64_t n, const double *frictions);

/*
 * Sets the callback that rollcon_table_make calls about ten times a second
 * (ROLLCON_PHASE_COMPLIANCE, the iteration counts the calls); a non-zero return cancels.
 *   fn     NULL removes the callback
 *   user   handed to fn
 * Ownership: `user` stays the caller's and must live until the callback is replaced or the table
 *   is gone.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_set_progress(rollcon_table *table,
    rollcon_progress_fn fn, void *user);

/*
 * Asks a running rollcon_table_make to stop: it returns ROLLCON_CANCELLED within a few solves.
 * What was solved stays, and the next call goes on.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_request_cancel(rollcon_table *table);

/*
 * Solves the samples of a part of the table that are not there yet, over the context's threads;
 * with the last sample the table is made. Results depend neither on the number of threads nor on
 * the parts. Several processes make a part each, one of them then adds the samples of the others.
 *   part   0 to parts - 1
 *   parts  1 or more; 1: the whole table
 * Also returns: ROLLCON_CANCELLED, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY, ROLLCON_ERR_INTERNAL.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_make(rollcon_table *table, int32_t part,
    int32_t parts);

/*
 * Returns all samples; NaN where one is not solved yet. There are none in a table that was
 * loaded, or before rollcon_table_make.
 *   capacity  numbers that fit; 0: only the need
 *   samples   [capacity], out, may be NULL
 *   count     out; numbers that there are
 * Also returns: ROLLCON_ERR_CAPACITY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_get_samples(const rollcon_table *table,
    int64_t capacity, double *samples, int64_t *count);

/*
 * Adds the samples that another table of the same settings has (rollcon_table_get_samples); NaN
 * adds none. With the last sample the table is made.
 *   n        as many as the other has
 *   samples  [n]
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_add_samples(rollcon_table *table,
    int64_t n, const double *samples);

/*
 * Writes the table, with what wheels found to calibrate ellipses, to a file, whole or not at all;
 * an older one is replaced. ROLLCON_ERR_STATE: the table is not made yet.
 *   path   name of the file
 * Also returns: ROLLCON_ERR_IO, ROLLCON_ERR_STATE, ROLLCON_ERR_MEMORY.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_save(rollcon_table *table,
    const char *path);

/*
 * Returns forces and spin moments on body 1 of n contacts, by the signs of
 * rollcon_contact_get_resultant. |F| is never above friction times load. Nothing is allocated.
 * Inputs are those of a Hertzian contact: shear modulus, Poisson's ratio, coefficient of
 * friction, semi-axes along and across the rolling direction, load, creepages along and across
 * it, spin. The first entry that the table does not have is ROLLCON_ERR_ARGUMENT
 * (ROLLCON_ERR_NONFINITE) and ends the call; results before it are there. ROLLCON_ERR_STATE: the
 * table is not made yet.
 *   n        entries
 *   inputs   [n][9]; shear > 0, force/length^2; poisson, within the table; friction 0 to 10; a
 *            and b > 0, length; load >= 0, force; longitudinal and lateral creepage; spin,
 *            1/length
 *   results  [n][3], out; force along t1 and t2; moment about n, force length
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 * Threads: any.
 * Source: docs/tables.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_evaluate(const rollcon_table *table,
    int64_t n, const double *inputs, double *results);

/*
 * Does what rollcon_table_evaluate does, and returns derivatives by all inputs, which are
 * continuous.
 *   n            entries
 *   inputs       [n][9]; those of rollcon_table_evaluate
 *   results      [n][3], out; those of rollcon_table_evaluate
 *   derivatives  [n][3][9], out; derivative of each result by each input
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE.
 * Threads: any.
 * Source: docs/tables.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_evaluate_derivatives(
    const rollcon_table *table, int64_t n, const double *inputs, double *results,
    double *derivatives);

/*
 * Returns tangential forces and spin moment on body 1 of a solved contact, from the Hertzian
 * contact that stands for it (rollcon_contact_get_equivalent_ellipse): friction of a contact that
 * was solved without, at the price of its pressures. The moment is about the contact's origin.
 * ROLLCON_ERR_ARGUMENT: the table does not have this ellipse, Poisson's ratio, friction, or pair
 * of bodies; asked about unlike bodies, a table of like ones adds the mean strain under the
 * pressure to the longitudinal creepage. ROLLCON_ERR_STATE, ROLLCON_ERR_UNSUPPORTED: for the
 * reasons of rollcon_contact_get_equivalent_ellipse, or the table is not made yet.
 *   friction  coefficient, 0 to 10; -1: the contact's own, mean over its pressure
 *   results   [3], out; force along t1 and t2; moment about n, force length
 * Also returns: ROLLCON_ERR_NONFINITE, ROLLCON_ERR_STATE, ROLLCON_ERR_UNSUPPORTED.
 * Source: docs/tables.md.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_evaluate_contact(
    const rollcon_table *table, const rollcon_contact *contact, double friction,
    double *results);

#ifdef __cplusplus
}
#endif

#endif
