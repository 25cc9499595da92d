"""Tests a wheel on its rail over the library itself: the Manchester benchmark at y = 2 mm (mm, N, s), and lives of
contacts."""

import math
import unittest

import numpy as np
import rollcon as rc


class OnRail(unittest.TestCase):

    def setUp(self):
        self.context = rc.Context(threads=1)
        bodies = []
        for shape in ("s1002", "60e1"):
            body = rc.Body(self.context, "halfspace")
            body.set_elastic(2 * 82000 * 1.28, 0.28)
            body.set_profile_shape(shape, [1.0])
            bodies.append(body)
        self.bodies = bodies
        self.wheelrail = rc.WheelRail(self.context, *bodies, side="right")
        self.wheelrail.set_track(1435, 14, math.atan(1 / 40))
        self.wheelrail.set_wheelset(1360, -70, 460)
        self.wheelrail.set_position([0, 2, 0.1529, -1.128e-4, 4.8e-3, 0])
        self.wheelrail.set_velocity([2000, 0, 0, 0, 0, -4.3459197])

    def test_benchmark(self):
        """Compares with CONTACT's forces on the rail: 9799 normal, -517.3 along, -2893 across."""
        wheelrail = self.wheelrail
        with self.assertRaisesRegex(rc.RollconError, "set_friction"):
            wheelrail.solve()
        wheelrail.set_friction(0.3)
        self.assertEqual(wheelrail.solve(), rc.OK)
        self.assertEqual(wheelrail.patch_count, 1)
        found = [wheelrail.patch_stat(0, name) for name in ("normal_force", "longitudinal_force", "lateral_force")]
        np.testing.assert_allclose(found, [9799, 517.3, 2893], atol=0.01 * 9799)
        wheelrail.prescribe_vertical("by_force", 10000)
        self.assertEqual(wheelrail.solve(), rc.OK)
        force, _ = wheelrail.resultant()
        self.assertAlmostEqual(force[2], -10000, delta=0.01)
        turned, _ = wheelrail.resultant("in_wheelset")
        self.assertAlmostEqual(np.linalg.norm(turned), np.linalg.norm(force), delta=1e-8)
        for name, *_ in rc.stat_table("wheelrail"):
            self.assertTrue(np.isfinite(wheelrail.stat(name)), name)
        for name, *_ in rc.stat_table(rc.OF_PATCH):
            self.assertTrue(np.isfinite(wheelrail.patch_stat(0, name)), name)

    def test_contacts(self):
        self.wheelrail.set_friction(0.3)
        self.wheelrail.solve()
        contact, = self.wheelrail.contacts
        force, _ = contact.resultant()
        self.assertAlmostEqual(-force[2], self.wheelrail.patch_stat(0, "normal_force"), delta=1e-6)
        self.wheelrail.close()
        np.testing.assert_array_equal(contact.resultant()[0], force)
        self.assertEqual(contact.tractions().shape, (contact.size[0], 3))

    def test_rolling_radii_coefficient(self):
        """Tests cones on narrow rail heads: their difference of 2 g y turns a wheelset round the radius e r / (2 g
        y)."""
        slope, shift, curve = 0.05, 3.0, 5e5
        self.bodies[0].set_profile([[-60, 60 * slope], [80, -80 * slope]])
        self.bodies[1].set_profile_shape("arc", [-1.0, 0.99])
        wheelset = [rc.WheelRail(self.context, *self.bodies, side=side) for side in ("left", "right")]
        for wheel in wheelset:
            wheel.set_track(1500, 0, 0)
            wheel.set_wheelset(1360, -70, 460)
        points = rc.contact_points(*wheelset, [0.0])
        distance, radius = points.right.y[0] - points.left.y[0], points.right.rolling_radius[0]
        found = rc.rolling_radii_coefficient(*wheelset, shift, curve)
        self.assertAlmostEqual(found, 2 * slope * shift * curve / (distance * radius), delta=2e-3 * found)
        self.assertAlmostEqual(rc.rolling_radii_coefficient(*wheelset, -shift, curve), -found, delta=1e-9)

    def test_conicity(self):
        """Compares with a conicity that is often quoted as 0.18 at 3 mm."""
        wheelset = [rc.WheelRail(self.context, *self.bodies, side=side) for side in ("left", "right")]
        for wheel in wheelset:
            wheel.set_track(1435, 14, math.atan(1 / 40))
            wheel.set_wheelset(1360, -70, 460)
        found, _ = rc.conicity(*wheelset, [3.0])
        self.assertAlmostEqual(found[0], 0.18, delta=0.002)
        at_two_and_four, _ = rc.conicity(*wheelset, [2.0, 4.0])
        parameter = rc.nonlinearity_parameter(*wheelset)
        self.assertAlmostEqual(parameter, (at_two_and_four[1] - at_two_and_four[0]) / 2, delta=1e-12)
        self.assertAlmostEqual(parameter, -0.0327, delta=5e-4)
        points = rc.contact_points(*wheelset, [-2.0, 0.0, 2.0])
        np.testing.assert_allclose(points.difference, -points.difference[::-1], atol=1e-9)
        np.testing.assert_allclose(points.left.y, -points.right.y[::-1], atol=1e-9)


if __name__ == "__main__":
    unittest.main()
