"""Makes the scene of the Python tests: a sphere of radius 50 on a rigid plane, 8 x 8 elements."""

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

    def contact(self):
        contact = rc.Contact(self.context, self.sphere, self.plane)
        contact.frame_rectangle(rc.QUAD4, SIDE - 1, SIDE - 1, -1.3, 1.3, -1.3, 1.3)
        contact.set_gap_quadratic(0.01, 0.01)
        contact.set_friction(MU)
        contact.set_rolling(10.0)
        contact.prescribe(rc.NORMAL, rc.BY_FORCE, LOAD)
        return contact
