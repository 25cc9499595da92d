/*
 * rollcon 1.0.0-rc2: what layers over rollcon.h need.
 *
 * Generated from bindings/api.toml by bindings/generate.py; do not edit.
 * Copyright (c) the rollcon authors. BSD-3-Clause.
 */
#ifndef ROLLCON_LAYERS_H
#define ROLLCON_LAYERS_H

#include <rollcon.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------- For layers in other languages */
/* These functions serve layers over this interface: more references to an object, handles as
   integers for languages without pointers, failures of the layer's own. Programs do without them.
   They are declared in rollcon_layers.h. */

/*
 * Makes a text the thread's last error and tells log and latch of the object's context, as a
 * failing function does; it serves layers over this interface that check arguments of their own.
 * Returns the status.
 *   handle   may be NULL; object that the caller was given; others: no log, no latch
 *   status   < 0; others stand for ROLLCON_ERR_ARGUMENT
 *   message  may be NULL; "name of the function: what is wrong"
 * Threads: any.
 */
ROLLCON_API int32_t ROLLCON_CALL rollcon_report(const void *handle, int32_t status,
    const char *message);

/*
 * Adds a reference.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_context_retain(rollcon_context *context);

/*
 * Adds a reference.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_body_retain(rollcon_body *body);

/*
 * Adds a reference.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_contact_retain(rollcon_contact *contact);

/*
 * Adds a reference.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_wheelrail_retain(rollcon_wheelrail *wheelrail);

/*
 * Adds a reference.
 * Threads: any.
 */
ROLLCON_API rollcon_status ROLLCON_CALL rollcon_table_retain(rollcon_table *table);

/*
 * Returns the positive number of a handle; 0 for NULL and for handles that are not alive.
 *   handle  may be NULL; of any kind
 * Threads: any.
 */
ROLLCON_API int32_t ROLLCON_CALL rollcon_id_of(const void *handle);

/*
 * Returns the handle with this number; NULL for 0. It is not checked here: its use is
 * (ROLLCON_ERR_HANDLE).
 * Threads: any.
 */
ROLLCON_API rollcon_context *ROLLCON_CALL rollcon_context_from_id(int32_t id);

/*
 * Returns the handle with this number; NULL for 0. It is not checked here: its use is
 * (ROLLCON_ERR_HANDLE).
 * Threads: any.
 */
ROLLCON_API rollcon_body *ROLLCON_CALL rollcon_body_from_id(int32_t id);

/*
 * Returns the handle with this number; NULL for 0. It is not checked here: its use is
 * (ROLLCON_ERR_HANDLE).
 * Threads: any.
 */
ROLLCON_API rollcon_contact *ROLLCON_CALL rollcon_contact_from_id(int32_t id);

/*
 * Returns the handle with this number; NULL for 0. It is not checked here: its use is
 * (ROLLCON_ERR_HANDLE).
 * Threads: any.
 */
ROLLCON_API rollcon_wheelrail *ROLLCON_CALL rollcon_wheelrail_from_id(int32_t id);

/*
 * Returns the handle with this number; NULL for 0. It is not checked here: its use is
 * (ROLLCON_ERR_HANDLE).
 * Threads: any.
 */
ROLLCON_API rollcon_table *ROLLCON_CALL rollcon_table_from_id(int32_t id);

#ifdef __cplusplus
}
#endif

#endif
