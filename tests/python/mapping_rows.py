# Generated from bindings/api.toml by bindings/generate.py; do not edit.
"""Calls of the plain methods: object, method, arguments, function of C, what is written down, results."""

from collections import namedtuple
from itertools import starmap

Row = namedtuple("Row", "object method property arguments function record result")
ROWS = list(starmap(Row, [
    ('context', 'set_threads', False, (11,), 'context_set_threads', 'context1 11', None),
    ('context', 'set_latch', False, (11,), 'context_set_latch', 'context1 11', None),
    ('context', 'set_latch', False, (), 'context_set_latch', 'context1 1', None),
    ('context', 'check', False, (), 'context_check', 'context1', None),
    ('body', 'set_elastic', False, (2.5, 3.5, 11), 'body_set_elastic', 'body1 11 2.5 3.5', None),
    ('body', 'set_elastic', False, (2.5, 3.5), 'body_set_elastic', 'body1 0 2.5 3.5', None),
    ('body', 'prepare', False, (), 'body_prepare', 'body1', None),
    ('body', 'kind', True, (), 'body_get_kind', 'body1 room', 100),
    ('body', 'save', False, ('text 1',), 'body_save', 'body1 <text 1>', None),
    ('body', 'set_traction', False, (11, [2.125, 2.25, 2.375]), 'body_set_traction', 'body1 11 [2.125 2.25 2.375]', None),
    ('body', 'set_pressure', False, (11, 2.5), 'body_set_pressure', 'body1 11 2.5', None),
    ('body', 'set_contact_faces', False, ([21, 22],), 'body_set_contact_faces', 'body1 2 [21 22]', None),
    ('body', 'size', True, (), 'body_get_size', 'body1 room room', (3, 2)),
    ('body', 'reaction', False, (), 'body_get_reaction', 'body1 room room', ([100.5, 101.5, 102.5], [200.5, 201.5, 202.5])),
    ('body', 'stat', False, ('text 1',), 'body_get_stat', 'body1 <text 1> room', 200.5),
    ('contact', 'frame_from_body', False, (11, 21), 'contact_frame_from_body', 'contact1 11 21', None),
    ('contact', 'set_axes', False, ([1.125, 1.25, 1.375], [2.125, 2.25, 2.375], [3.125, 3.25, 3.375]), 'contact_set_axes', 'contact1 [1.125 1.25 1.375] [2.125 2.25 2.375] [3.125 3.25 3.375]', None),
    ('contact', 'set_gap', False, ([2.125, 2.25],), 'contact_set_gap', 'contact1 2 [2.125 2.25]', None),
    ('contact', 'set_gap_quadratic', False, (1.5, 2.5, 3.5), 'contact_set_gap_quadratic', 'contact1 1.5 2.5 3.5', None),
    ('contact', 'set_gap_quadratic', False, (1.5, 2.5), 'contact_set_gap_quadratic', 'contact1 1.5 2.5 0', None),
    ('contact', 'set_rolling', False, (1.5,), 'contact_set_rolling', 'contact1 1.5', None),
    ('contact', 'set_creep', False, (1.5, 2.5, 3.5), 'contact_set_creep', 'contact1 1.5 2.5 3.5', None),
    ('contact', 'set_creep', False, (), 'contact_set_creep', 'contact1 0 0 0', None),
    ('contact', 'set_creep_field', False, ([[2.125, 2.25], [2.375, 2.5]],), 'contact_set_creep_field', 'contact1 2 [2.125 2.25 2.375 2.5]', None),
    ('contact', 'set_creep_field', False, (None,), 'contact_set_creep_field', 'contact1 0 null', None),
    ('contact', 'prescribe', False, (11, 21, 3.5), 'contact_prescribe', 'contact1 11 21 3.5', None),
    ('contact', 'set_friction_field', False, ([2.125, 2.25],), 'contact_set_friction_field', 'contact1 2 [2.125 2.25]', None),
    ('contact', 'set_friction_field', False, (None,), 'contact_set_friction_field', 'contact1 0 null', None),
    ('contact', 'request_cancel', False, (), 'contact_request_cancel', 'contact1', None),
    ('contact', 'reset', False, (), 'contact_reset', 'contact1', None),
    ('contact', 'size', True, (), 'contact_get_size', 'contact1 room room', (3, 2)),
    ('contact', 'resultant', False, (11,), 'contact_get_resultant', 'contact1 11 room room', ([200.5, 201.5, 202.5], [300.5, 301.5, 302.5])),
    ('contact', 'resultant', False, (), 'contact_get_resultant', 'contact1 0 room room', ([200.5, 201.5, 202.5], [300.5, 301.5, 302.5])),
    ('contact', 'motion', False, (), 'contact_get_motion', 'contact1 room room', (100.5, [200.5, 201.5, 202.5])),
    ('contact', 'sensitivity', False, (11,), 'contact_get_sensitivity', 'contact1 11 room room room room', ([200.5, 201.5, 202.5], [300.5, 301.5, 302.5], 400.5, [500.5, 501.5, 502.5])),
    ('contact', 'stat', False, ('text 1',), 'contact_get_stat', 'contact1 <text 1> room', 200.5),
    ('contact', 'plan', False, (), 'contact_get_plan', 'contact1 25 room room', 'text of contact_get_plan'),
    ('contact', 'write', False, ('text 1',), 'contact_write', 'contact1 <text 1>', None),
]))
