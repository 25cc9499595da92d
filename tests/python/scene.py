"""The scene of the Python tests: a sphere of radius 50 on a rigid plane, 8 x 8 elements."""

import unittest

import numpy as np
import rollcon as rc

SIDE = 9
NODES = SIDE * SIDE
LOAD, MU = 298.6, 0.1


class Scene(unittest.TestCase):

    def setUp(self):
        self.context = rc.Context(threads=1)
        self.sphere = rc.Body(self.context, rc.BODY_HALFSPACE)
        self.sphere.set_elastic(1e4, 0.3)
        self.plane = rc.Body(self.context, rc.BODY_RIGID)
        side = np.linspace(-1.3, 1.3, SIDE)
        x, y = np.meshgrid(side, side)
        self.x = np.column_stack([x.ravel(), y.ravel(), np.zeros(NODES)])
        k = np.arange(NODES).reshape(SIDE, SIDE)
        corners = (k[:-1, :-1], k[:-1, 1:], k[1:, 1:], k[1:, :-1])
        self.elements = np.stack(corners, axis=-1).reshape(-1, 4)

    def contact(self):
        contact = rc.Contact(self.context, self.sphere, self.plane)
        contact.set_frame_nodes(self.x)
        contact.add_frame_elements(rc.QUAD4, self.elements)
        contact.set_gap_quadratic(0.01, 0.01)
        contact.set_friction(MU)
        contact.set_rolling(10.0)
        contact.prescribe(rc.NORMAL, rc.BY_FORCE, LOAD)
        return contact
