"""Lists of load cases."""

import unittest

import numpy as np
import rollcon as rc
from scene import LOAD, NODES, Scene


class SolveMany(Scene):

    def setUp(self):
        super().setUp()
        lateral, load = np.meshgrid(np.linspace(-2e-3, 2e-3, 5), LOAD * np.array([0.8, 1, 1.2]))
        self.values = np.column_stack([lateral.ravel(), load.ravel()])
        self.parameters = [rc.LATERAL, rc.NORMAL]

    def test_results_are_those_of_single_solves(self):
        contact = self.contact()
        cases = contact.solve_many(self.parameters, self.values, names=["iterations", "max_pressure"],
                                   derivatives=True, tractions=True)
        self.assertEqual(cases.worst, rc.OK)
        n = len(self.values)
        self.assertEqual(cases.status.tolist(), [rc.OK] * n)
        self.assertEqual(cases.derivatives.shape, (n, 2, 10))
        self.assertEqual(cases.tractions.shape, (n, NODES, 3))
        for i, (lateral, load) in enumerate(self.values):
            contact.prescribe(rc.LATERAL, rc.BY_MOTION, lateral)
            contact.prescribe(rc.NORMAL, rc.BY_FORCE, load)
            contact.solve()
            force, moment = contact.resultant()
            approach, creep = contact.motion()
            np.testing.assert_allclose(cases.force[i], force, atol=1e-8 * LOAD)
            np.testing.assert_allclose(cases.moment[i], moment, atol=1e-8 * LOAD)
            np.testing.assert_allclose(cases.approach[i], approach, rtol=1e-8)
            np.testing.assert_allclose(cases.creep[i], creep, atol=1e-12)
            np.testing.assert_allclose(cases.tractions[i], contact.tractions(), atol=1e-6 * LOAD)
            np.testing.assert_allclose(cases["max_pressure"][i], contact.stat("max_pressure"),
                                       rtol=1e-7)
            slope = np.concatenate([np.atleast_1d(v) for v in contact.sensitivity(rc.LATERAL)])
            np.testing.assert_allclose(cases.derivatives[i, 0], slope, rtol=1e-5,
                                       atol=1e-5 * np.abs(slope).max())
        self.assertGreater(cases["iterations"].sum(), 0)

    def test_threads_change_nothing(self):
        contact = self.contact()
        one = contact.solve_many(self.parameters, self.values)
        self.context.set_threads(3)
        several = contact.solve_many(self.parameters, self.values)
        np.testing.assert_array_equal(one.force, several.force)
        self.assertFalse(hasattr(several, "tractions"))

    def test_failures(self):
        contact = self.contact()
        contact.prescribe(rc.LATERAL, rc.BY_FORCE, 0)
        cases = contact.solve_many([rc.LATERAL], [[0], [LOAD]])
        self.assertEqual(cases.worst, rc.NOT_CONVERGED)
        self.assertEqual(cases.status.tolist(), [rc.OK, rc.ERR_LOAD])
        self.assertTrue(np.isnan(cases.force[1]).all() and not np.isnan(cases.force[0]).any())
        with self.assertRaises(ValueError):
            contact.solve_many([rc.LATERAL], [1, 2, 3])
        with self.assertRaises(ValueError):
            contact.solve_many(np.array([[rc.LATERAL, rc.NORMAL]]), [[1.0]])
        # Names are counted as the library counts them.
        many = contact.solve_many([rc.LATERAL], [[0.0]], names=["iterations " * 3])
        self.assertEqual(many.statistics.shape, (1, 3))
        self.assertEqual(contact.solve_many([rc.LATERAL], [[0.0]], names="iterations").statistics.shape,
                         (1, 1))
        with self.assertRaises(rc.RollconError):
            contact.solve_many([rc.NORMAL], [[-1.0]])
        with self.assertRaises(rc.RollconError):
            contact.solve_many([rc.LATERAL], [[0]], names=["cost"])

    def test_progress(self):
        contact = self.contact()
        phases = []
        contact.set_progress(lambda event: phases.append(event.phase))
        contact.solve_many(self.parameters, self.values)
        self.assertEqual(phases.count(rc.PHASE_CASES), len(self.values))
        contact.set_progress(lambda event: True)
        self.assertEqual(contact.solve_many(self.parameters, self.values).worst, rc.CANCELLED)

        def stumble(event):
            raise RuntimeError("a callback")
        contact.set_progress(stumble)
        with self.assertRaises(RuntimeError):
            contact.solve_many(self.parameters, self.values)


if __name__ == "__main__":
    unittest.main()
