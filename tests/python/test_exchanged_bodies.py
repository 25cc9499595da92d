"""Tests that the order of bodies does not matter: a ball rolls and spins in a groove, on plane and conformal frames."""

import unittest

import numpy as np
import rollcon as rc

LOAD, MU, RADIUS, GROOVE = 2000.0, 0.3, 6.0, 6.3


def solve(context, ball_first, conformal):
    """Returns the force on the ball in space, over mu times the load, and approach and largest pressure."""
    groove, ball = (rc.Body(context, "halfspace") for _ in range(2))
    for body in (groove, ball):
        body.set_elastic(2.1e5, 0.3)
    y = np.linspace(-5.5, 5.5, 111)
    groove.set_profile(np.column_stack([y, GROOVE - np.sqrt(GROOVE**2 - y**2)]))
    groove.extrude_profile([0, 0, 0], [1, 0, 0], [0, 0, 1])
    ball.set_profile_shape("arc", [RADIUS, 0.98 * RADIUS])
    ball.revolve_profile([0, 0, RADIUS], [0, 1, 0], RADIUS)
    contact = rc.Contact(context, *((ball, groove) if ball_first else (groove, ball)))
    contact.set_axes([0, 0, 0], [1, 0, 0], [0, 0, -1 if ball_first else 1])
    contact.set_friction(MU)
    contact.set("conformal", conformal)
    contact.set("frame_accuracy", 0.02)
    contact.prescribe("normal", "force", LOAD)
    of_ball = 1 if ball_first else 2
    contact.set_velocity(3 - of_ball, [-1000, 0, 0], [0, 0, 0], [0, 0, 0])
    contact.set_velocity(of_ball, [0, 0.5, 0], [0.05, 1.002 * 1000 / RADIUS, 3], [0, 0, RADIUS])
    contact.set_rolling(1000)
    status = contact.solve()
    force, _ = contact.resultant("global")
    return status, (1 if ball_first else -1) * force / (MU * LOAD), contact.approach, contact.stat("max_pressure")


class ExchangedBodies(unittest.TestCase):

    def test_a_ball_in_a_groove(self):
        context = rc.Context(1)
        for conformal in (0, 1):
            with self.subTest(conformal=conformal):
                first, second = (solve(context, ball_first, conformal) for ball_first in (False, True))
                off = np.abs(first[1] - second[1]).max()
                print(f"conformal {conformal}: forces differ by {off:.1e} of mu Fn (bound 1e-6)")
                self.assertEqual(first[0], second[0])
                self.assertLess(off, 1e-6)
                self.assertGreater(np.hypot(*first[1][:2]), 0.2)
                np.testing.assert_allclose(first[2:], second[2:], rtol=1e-6)


if __name__ == "__main__":
    unittest.main()
