"""Tests objects of Python over the library itself: results that fit each other, lives of handles, what callbacks
raise."""

import gc
import unittest

import numpy as np
import rollcon as rc
from rollcon._library import lib
from scene import LOAD, MU, NODES, SIDE, Scene


class Results(Scene):

    def test_a_rolling_sphere(self):
        contact = self.contact()
        contact.prescribe(rc.LONGITUDINAL, rc.BY_FORCE, 0.75 * MU * LOAD)
        self.assertEqual(contact.solve(), rc.OK)
        t, pressure = contact.tractions(), contact.field(rc.FIELD_PRESSURE)
        force, _ = contact.resultant()
        np.testing.assert_allclose(force, [0.75 * MU * LOAD, 0, -LOAD], atol=1e-5 * LOAD)
        np.testing.assert_allclose(contact.field(rc.FIELD_WEIGHT) @ t, force, atol=1e-8 * LOAD)
        np.testing.assert_allclose(pressure, -t[:, 2], atol=1e-12 * pressure.max())
        np.testing.assert_allclose(contact.field(rc.FIELD_POINT, rc.GLOBAL), self.x, atol=1e-14)
        np.testing.assert_array_equal(contact.node_states() == rc.OPEN, pressure <= 0)
        rows = contact.history()
        np.testing.assert_array_equal(contact.history("seconds step")[:, 0], rows[:, 7])
        self.assertTrue(contact.plan())
        self.assertTrue(all(np.isfinite(contact.stat(name)) for name, *_ in rc.stat_table()))
        self.assertEqual(rc.version_string().replace("-", ""), rc.__version__)  # in the form of PEP 440

    def test_a_mesh_of_ones_own_does_what_the_rectangle_does(self):
        made, given = self.contact(), self.contact()
        k = np.arange(NODES).reshape(SIDE, SIDE)
        corners = (k[:-1, :-1], k[:-1, 1:], k[1:, 1:], k[1:, :-1])
        given.frame_nodes(self.x)
        given.frame_add_elements(rc.QUAD4, np.stack(corners, axis=-1).reshape(-1, 4))
        for contact in (made, given):
            contact.set_creep(1e-3, -5e-4, 0.0)
            self.assertEqual(contact.solve(), rc.OK)
        self.assertGreater(np.abs(made.tractions()).max(), 100)
        np.testing.assert_allclose(given.tractions(), made.tractions(), atol=1e-8)

    def test_rubber_resists_rolling_and_is_refused_where_it_is_not_known(self):
        roller, table = rc.Body(self.context, "halfspace"), rc.Body(self.context, "rigid")
        roller.set_elastic(10, 0.48)
        roller.set_viscoelastic([0.3, 0.2], [0.01, 0.1])
        contact = rc.Contact(self.context, roller, table)
        contact.set_gap_quadratic(0.01, 0.001)
        contact.set_friction(0.0)
        contact.prescribe(rc.NORMAL, rc.BY_FORCE, 100)
        resistance = []
        for speed in (1e-6, 100, 1e9):
            contact.set_rolling(speed)
            self.assertEqual(contact.solve(), rc.OK)
            resistance.append(contact.stat("rolling_resistance"))
            self.assertEqual(contact.stat("body_power"), speed * resistance[-1])
        self.assertGreater(resistance[1], 1)
        self.assertLess(max(abs(resistance[0]), resistance[2]), 1e-3)
        with self.assertRaisesRegex(rc.RollconError, "viscoelastic.*elastic and rigid bodies"):
            contact.equivalent_ellipse()
        wheel, rail = rc.Body(self.context, "halfspace"), rc.Body(self.context, "halfspace")
        for body, shape in ((wheel, "s1002"), (rail, "60e1")):
            body.set_elastic(2e5, 0.3)
            body.set_profile_shape(shape, [1])
        rail.set_viscoelastic([0.1], [1])
        with self.assertRaisesRegex(rc.RollconError, "the rail is viscoelastic"):
            rc.WheelRail(self.context, wheel, rail, "right")

    def test_a_grid_of_gaps_is_an_array(self):
        x, y = np.linspace(-2, 2, 7), np.linspace(-3, 3, 5)
        gap = 0.01 * x**2 + 0.02 * y[:, None] ** 2
        forces = []
        for values in (gap, gap.ravel()):
            contact = self.contact()
            contact.set_gap_grid(7, -2, 2, -3, 3, values)
            contact.solve()
            forces.append(contact.tractions())
        np.testing.assert_array_equal(*forces)
        for values in (gap.T, gap[None], 1.0):
            with self.assertRaisesRegex(ValueError, "set_gap_grid: expected gap of shape"):
                contact.set_gap_grid(7, -2, 2, -3, 3, values)

    def test_a_case_is_a_solve(self):
        contact = self.contact()
        cases = contact.solve_many([rc.NORMAL], [[LOAD], [0.8 * LOAD]], derivatives=True, tractions=True)
        self.assertEqual(cases.status.tolist(), [rc.OK, rc.OK])
        contact.solve()
        np.testing.assert_allclose(cases.force[0], contact.resultant()[0], atol=1e-8 * LOAD)
        np.testing.assert_allclose(cases.tractions[0], contact.tractions(), atol=1e-6 * LOAD)
        slope = np.concatenate([np.atleast_1d(v) for v in contact.sensitivity(rc.NORMAL)])
        np.testing.assert_allclose(cases.derivatives[0, 0], slope, atol=1e-5 * np.abs(slope).max())
        contact.prescribe(rc.LATERAL, rc.BY_FORCE, 0)
        cases = contact.solve_many([rc.LATERAL], [[0], [LOAD]])
        self.assertEqual((cases.worst, cases.status.tolist()), (rc.NOT_CONVERGED, [rc.OK, rc.ERR_LOAD]))
        self.assertTrue(np.isnan(cases.force[1]).all() and not np.isnan(cases.force[0]).any())
        # Names are counted as the library counts them.
        many = contact.solve_many([rc.LATERAL], [[0.0]], names=["iterations " * 3])
        self.assertEqual(many.statistics.shape, (1, 3))

    def test_settings(self):
        contact = self.contact()
        settings = (("tolerance", 1e-9), ("pressure_length", 2), ("max_iterations", 50), ("convection", "godunov"))
        for name, value in settings:
            contact.set(name, value)
            self.assertEqual(contact.get(name), value)
        for option in rc.option_table("body"):
            self.assertEqual(self.sphere.get(option.name), option.standard)
        self.sphere.set("accuracy", 1e-5)
        self.assertEqual(self.sphere.get("accuracy"), 1e-5)


class Callbacks(Scene):

    def test_progress(self):
        contact = self.contact()
        seen = []

        def watch(event):
            seen.append(event.phase)
            with self.assertRaises(rc.RollconError) as caught:
                contact.set_rolling(11.0)
            self.assertEqual(caught.exception.status, rc.ERR_BUSY)
            return True
        contact.set_progress(watch)
        self.assertEqual(contact.solve(), rc.CANCELLED)
        self.assertEqual(len(seen), 1)
        contact.set_progress(lambda event: 1 / 0)
        with self.assertRaises(ZeroDivisionError):
            contact.solve()
        with self.assertRaises(ZeroDivisionError):
            contact.solve_many([rc.NORMAL], [[LOAD]])
        contact.set_progress(lambda event: seen.append(event.phase))
        contact.solve_many([rc.NORMAL], [[LOAD], [0.8 * LOAD]])
        self.assertEqual(seen.count(rc.PHASE_CASES), 2)
        contact.set_progress(None)
        self.assertEqual(contact.solve(), rc.OK)

    def test_log(self):
        lines = []
        self.context.set_log(rc.LOG_ERROR, lambda level, text: lines.append((level, text)))
        with self.assertRaises(rc.RollconError) as caught:
            self.contact().set_rolling(-1.0)
        self.assertEqual(lines, [(rc.LOG_ERROR, caught.exception.message)])
        self.context.set_log(0)
        with self.assertRaises(rc.RollconError):
            self.contact().set_rolling(-1.0)
        self.assertEqual(len(lines), 1)


class Life(Scene):

    def test_with_blocks_and_collection_release(self):
        with rc.Body(self.context, rc.BODY_RIGID) as body:
            value = body.id
            self.assertGreater(value, 0)
        self.assertEqual(lib.rollcon_id_of(lib.rollcon_body_from_id(value)), 0)
        contact = self.contact()
        contact.set_progress(lambda event: False)
        value = contact.id
        del contact
        gc.collect()
        self.assertEqual(lib.rollcon_id_of(lib.rollcon_contact_from_id(value)), 0)

    def test_a_contact_keeps_its_bodies(self):
        contact = self.contact()
        self.sphere.close()
        self.plane.close()
        self.assertEqual(contact.solve(), rc.OK)
        self.assertEqual(contact.tractions().shape, (NODES, 3))

    def test_closed_and_foreign_handles(self):
        body = rc.Body(self.context, rc.BODY_RIGID)
        stale = body.handle
        body.close()
        body.close()
        self.assertEqual(body.id, 0)
        for value, status in ((None, rc.ERR_ARGUMENT), (stale, rc.ERR_HANDLE), (self.context.handle, rc.ERR_HANDLE),
                              (2**40, rc.ERR_HANDLE)):
            body._handle = value
            with self.assertRaises(rc.RollconError) as caught:
                body.prepare()
            body._handle = None
            self.assertEqual(caught.exception.status, status)


if __name__ == "__main__":
    unittest.main()
