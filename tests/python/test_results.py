"""Arrays in and out: shapes, agreement of the results with each other, layouts of the input."""

import gc
import pathlib
import tempfile
import unittest

import numpy as np
import rollcon as rc
from scene import LOAD, MU, NODES, SIDE, Scene


class Results(Scene):

    def test_a_rolling_sphere(self):
        contact = self.contact()
        contact.prescribe(rc.LONGITUDINAL, rc.BY_FORCE, 0.75 * MU * LOAD)
        self.assertEqual(contact.solve(), rc.OK)
        t = contact.tractions()
        self.assertEqual(t.shape, (NODES, 3))
        force, moment = contact.resultant()
        self.assertEqual((force.shape, moment.shape), ((3,), (3,)))
        np.testing.assert_allclose(force, [0.75 * MU * LOAD, 0, -LOAD], atol=1e-5 * LOAD)
        weight = contact.field(rc.FIELD_WEIGHT)
        np.testing.assert_allclose(weight @ t, force, atol=1e-8 * LOAD)
        pressure = contact.field(rc.FIELD_PRESSURE)
        np.testing.assert_allclose(pressure, -t[:, 2], atol=1e-12 * pressure.max())
        self.assertTrue((np.hypot(t[:, 0], t[:, 1]) <= MU * pressure + 1e-6 * pressure.max()).all())
        self.assertEqual(contact.field(rc.FIELD_SLIP).shape, (NODES, 2))
        self.assertEqual(contact.field(rc.FIELD_SLIP, rc.GLOBAL).shape, (NODES, 3))
        np.testing.assert_allclose(contact.field(rc.FIELD_POINT, rc.GLOBAL), self.x, atol=1e-14)
        state = contact.node_status()
        self.assertEqual(state.dtype, np.int32)
        np.testing.assert_array_equal(state == rc.OPEN, pressure <= 0)
        approach, creep = contact.motion()
        self.assertGreater(approach, 0)
        self.assertLess(creep[0], 0)  # a force forwards on body 1 needs slip backwards
        rows = contact.history()
        self.assertEqual(rows.shape[1], 8)
        self.assertGreaterEqual(len(rows), 1)
        convergence = contact.error_function()
        self.assertEqual(convergence.shape, (len(rows), 2))
        self.assertLess(convergence[-1, 0], 1e-12)
        self.assertTrue(np.array_equal(convergence[:, 1], rows[:, 7]))
        self.assertTrue(contact.plan())
        self.assertTrue(all(np.isfinite(contact.stat(name)) for name in rc.stat_names()))
        self.assertEqual(contact.displacements_at(1, self.x[:, :2]).shape, (NODES, 3))

    def test_sensitivity_is_the_slope_of_solves(self):
        contact = self.contact()
        contact.set("tolerance", 1e-13)
        value = {rc.LONGITUDINAL: 8.0, rc.LATERAL: 2e-4, rc.NORMAL: LOAD, rc.SPIN: 1e-4,
                 rc.FRICTION: MU}
        by_force = (rc.LONGITUDINAL, rc.NORMAL)

        def solve(parameter, v):
            if parameter == rc.FRICTION:
                contact.set_friction(v)
            else:
                how = rc.BY_FORCE if parameter in by_force else rc.BY_MOTION
                contact.prescribe(parameter, how, v)
            self.assertEqual(contact.solve(), rc.OK)
            approach, creep = contact.motion()
            return np.concatenate([*contact.resultant(), [approach], creep]), contact.node_status()

        for parameter, v in value.items():
            solve(parameter, v)
        for parameter, v in value.items():
            result, state = solve(parameter, v)
            force, moment, approach, creep = contact.sensitivity(parameter)
            found = np.concatenate([force, moment, [approach], creep])
            (low, a), (high, b) = solve(parameter, (1 - 1e-4) * v), solve(parameter, (1 + 1e-4) * v)
            np.testing.assert_array_equal(a, state)
            np.testing.assert_array_equal(b, state)
            slope = (high - low) / 2e-4  # by a factor on the parameter
            found *= 1 if parameter == rc.FRICTION else v
            size = np.abs(result)
            size[:6] = np.hypot(*result[:2])
            error = (np.abs(found - slope) / size).max()
            print(f"sensitivity to {parameter}: error {error:.1e} (bound 1e-6)")
            self.assertLess(error, 1e-6)
            solve(parameter, v)

    def test_layouts_give_the_same_nodes(self):
        wide = np.zeros((NODES, 8))
        wide[:, 2:5] = self.x
        for x in (self.x, np.asfortranarray(self.x), wide[:, 2:5], self.x[:, :2], self.x.tolist(),
                  self.x[::-1][::-1], self.x.astype(">f8")):
            contact = self.contact()
            contact.set_frame_nodes(x)
            contact.add_frame_elements(rc.QUAD4, self.elements + 1, index_base=1)
            self.assertEqual(contact.size, (NODES, (SIDE - 1)**2))
            contact.solve()
            np.testing.assert_allclose(contact.field(rc.FIELD_POINT, rc.GLOBAL), self.x, atol=1e-14)

    @unittest.skipUnless(rc.has_feature("vtu"), "this build writes no VTU files")
    def test_file(self):
        contact = self.contact()
        contact.solve()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "contact.vtu"
            contact.write(path)
            self.assertTrue(path.exists())


class Life(Scene):

    def test_with_blocks_and_collection_release(self):
        with rc.Body(self.context, rc.BODY_RIGID) as body:
            value = body.id
            self.assertGreater(value, 0)
        from rollcon._library import lib
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

    def test_library_facts(self):
        self.assertTrue(rc.has_feature("halfspace"))
        self.assertFalse(rc.has_feature("no such feature"))
        self.assertTrue(rc.build_info())
        self.assertEqual(rc.version_string(), rc.__version__)
        self.assertNotEqual(rc.status_string(rc.ERR_MESH), rc.status_string(rc.OK))
        names = [option.name for option in rc.option_table()]
        self.assertIn("tolerance", names)
        self.assertTrue(all(option.doc for option in rc.option_table()))

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


if __name__ == "__main__":
    unittest.main()
