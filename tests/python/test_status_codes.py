"""Bad input raises RollconError with the status that it deserves."""

import math
import unittest

import numpy as np
import rollcon as rc
from scene import LOAD, MU, NODES, Scene

NAN, INFINITY = math.nan, math.inf


class StatusCodes(Scene):

    def fails(self, status, function, *arguments, **named):
        with self.assertRaises(rc.RollconError) as caught:
            function(*arguments, **named)
        self.assertEqual(caught.exception.status, status, caught.exception.message)
        self.assertTrue(caught.exception.message)
        return caught.exception.message

    def test_closed_and_foreign_handles(self):
        body = rc.Body(self.context, rc.BODY_RIGID)
        stale = body.handle
        body.close()
        body.close()
        self.assertEqual(body.id, 0)
        self.fails(rc.ERR_ARGUMENT, body.prepare)
        for value in (stale, self.context.handle, 123456789, 2**40):
            body._handle = value
            try:
                self.fails(rc.ERR_HANDLE, body.prepare)
            finally:
                body._handle = None
        self.fails(rc.ERR_ARGUMENT, rc.Contact, self.context, self.sphere, body)

    def test_bodies(self):
        if rc.has_feature("fem"):
            self.assertEqual(rc.Body(self.context, rc.BODY_FEM).kind, rc.BODY_FEM)
        else:
            self.fails(rc.ERR_UNSUPPORTED, rc.Body, self.context, rc.BODY_FEM)
        self.fails(rc.ERR_ARGUMENT, rc.Body, self.context, 77)
        body = rc.Body(self.context, rc.BODY_HALFSPACE)
        self.assertEqual(body.kind, rc.BODY_HALFSPACE)
        self.fails(rc.ERR_STATE, body.prepare)
        for young, poisson in ((0.0, 0.3), (-1.0, 0.3), (1.0, -1.0), (1.0, 0.501)):
            text = self.fails(rc.ERR_ARGUMENT, body.set_elastic, young, poisson)
            self.assertIn("rollcon_body_set_elastic", text)
            self.assertEqual(text, rc.last_error())
        for young, poisson in ((NAN, 0.3), (1.0, INFINITY)):
            self.fails(rc.ERR_NONFINITE, body.set_elastic, young, poisson)
        self.fails(rc.ERR_STATE, self.plane.set_elastic, 1.0, 0.3)

    def test_frames(self):
        contact = rc.Contact(self.context, self.sphere, self.plane)
        self.fails(rc.ERR_STATE, contact.add_frame_elements, rc.QUAD4, self.elements)
        self.fails(rc.ERR_ARGUMENT, contact.set_frame_nodes, np.zeros((0, 3)))
        x = self.x.copy()
        x[4, 1] = NAN
        self.fails(rc.ERR_NONFINITE, contact.set_frame_nodes, x)
        with self.assertRaises(ValueError):
            contact.set_frame_nodes(np.zeros((4, 5)))
        contact.set_frame_nodes(self.x)
        with self.assertRaises(ValueError):
            contact.add_frame_elements(rc.TRI3, self.elements)
        with self.assertRaises(ValueError):
            contact.add_frame_elements(rc.QUAD4, self.elements + 0.5)
        with self.assertRaises(ValueError):
            contact.add_frame_elements(rc.QUAD4, self.elements + 2**32)
        self.fails(rc.ERR_ARGUMENT, contact.add_frame_elements, 999, self.elements)
        self.fails(rc.ERR_MESH, contact.add_frame_elements, rc.QUAD4, [[0, 1, 2, NODES]])
        self.fails(rc.ERR_MESH, contact.add_frame_elements, rc.QUAD4, [[0, 1, 2, -1]])
        self.fails(rc.ERR_ARGUMENT, contact.set_axes, [0, 0, 0], [0, 0, 1], [0, 0, 1])
        self.fails(rc.ERR_NONFINITE, contact.set_axes, [0, NAN, 0], [1, 0, 0], [0, 0, 1])

    def test_broken_elements_are_found_by_the_solve(self):
        last = self.elements[-1]
        for bad, kept in ((last, self.elements), ([0, 1, 1, 0], self.elements),
                          (last[::-1], self.elements[:-1])):
            contact = self.contact()
            contact.set_frame_nodes(self.x)
            contact.add_frame_elements(rc.QUAD4, kept)

            def finish(contact=contact, bad=bad):
                contact.add_frame_elements(rc.QUAD4, [list(bad)])
                contact.solve()
            self.fails(rc.ERR_MESH, finish)

    def test_scene(self):
        contact = self.contact()
        bad = np.full(NODES, 0.1)
        bad[-1] = NAN
        self.fails(rc.ERR_ARGUMENT, contact.set_gap, np.zeros(5))
        self.fails(rc.ERR_NONFINITE, contact.set_gap, bad)
        self.fails(rc.ERR_NONFINITE, contact.set_friction_field, bad)
        self.fails(rc.ERR_ARGUMENT, contact.set_friction_field, np.full(NODES, -0.1))
        self.fails(rc.ERR_NONFINITE, contact.set_creep_field, np.full((NODES, 2), INFINITY))
        self.fails(rc.ERR_NONFINITE, contact.set_gap_quadratic, NAN, 1.0)
        self.fails(rc.ERR_ARGUMENT, contact.set_rolling, 0.0)
        self.fails(rc.ERR_ARGUMENT, contact.set_rolling, -1.0)
        self.fails(rc.ERR_NONFINITE, contact.set_creep, NAN)
        self.fails(rc.ERR_ARGUMENT, contact.prescribe, rc.NORMAL, rc.BY_FORCE, -1.0)
        self.fails(rc.ERR_ARGUMENT, contact.prescribe, 9, rc.BY_FORCE, 1.0)
        self.fails(rc.ERR_NONFINITE, contact.prescribe, rc.SPIN, rc.BY_FORCE, INFINITY)
        self.fails(rc.ERR_ARGUMENT, contact.set_friction, -0.1)
        self.fails(rc.ERR_NONFINITE, contact.set_friction, NAN)
        self.fails(rc.ERR_ARGUMENT, contact.set_friction, 0.1, law="glue")
        with self.assertRaises(OverflowError):  # not cut to a valid direction
            contact.prescribe(2**32 + 1, rc.BY_FORCE, 1.0)
        contact.prescribe(np.int64(rc.NORMAL), rc.BY_FORCE, np.float32(1.0))

    def test_options(self):
        contact = self.contact()
        self.fails(rc.ERR_OPTION, contact.set, "no such option", 1)
        self.fails(rc.ERR_OPTION, contact.get, "no such option")
        self.fails(rc.ERR_OPTION, contact.set, "max_iterations", 1.5)
        self.fails(rc.ERR_OPTION, contact.set, "max_iterations", 0)
        self.fails(rc.ERR_OPTION, contact.set, "tolerance", "tight")
        self.fails(rc.ERR_OPTION, contact.set, "tolerance", 7.0)
        self.fails(rc.ERR_OPTION, contact.set, "convection", "upwards")
        for name, value in (("tolerance", 1e-9), ("max_iterations", 50), ("convection", "godunov")):
            contact.set(name, value)
            self.assertEqual(contact.get(name), value)
        self.fails(rc.ERR_OPTION, contact.get, "no such option")

    def test_results_before_a_solve(self):
        contact = self.contact()
        for get in (contact.tractions, contact.node_status, contact.resultant, contact.motion,
                    contact.plan, lambda: contact.field(rc.FIELD_SLIP),
                    lambda: contact.sensitivity(rc.SPIN)):
            self.fails(rc.ERR_STATE, get)
        self.fails(rc.ERR_STATE, rc.Contact(self.context, self.sphere, self.plane).solve)

    def test_solves_that_end_otherwise(self):
        contact = self.contact()
        contact.prescribe(rc.LONGITUDINAL, rc.BY_FORCE, 1.5 * MU * LOAD)
        self.fails(rc.ERR_LOAD, contact.solve)
        contact.set_creep()
        contact.prescribe(rc.NORMAL, rc.BY_MOTION, -0.001)
        self.assertEqual(contact.solve(), rc.NO_CONTACT)
        contact.prescribe(rc.NORMAL, rc.BY_FORCE, LOAD)
        contact.set_creep(1e-3)
        contact.reset()
        contact.set("max_iterations", 1)
        self.assertEqual(contact.solve(), rc.NOT_CONVERGED)
        self.fails(rc.ERR_STATE, contact.sensitivity, rc.FRICTION)
        self.assertEqual(contact.tractions().shape, (NODES, 3))

    def test_progress(self):
        contact = self.contact()
        seen = []

        def watch(event):
            seen.append((event.phase, event.iteration, event.residual, event.seconds))
            self.fails(rc.ERR_BUSY, contact.set_rolling, 11.0)
            return True
        contact.set_progress(watch)
        self.assertEqual(contact.solve(), rc.CANCELLED)
        self.assertEqual(len(seen), 1)
        contact.set_progress(lambda event: 1 / 0)
        with self.assertRaises(ZeroDivisionError):
            contact.solve()
        contact.set_progress(None)
        self.assertEqual(contact.solve(), rc.OK)

    def test_after_a_solve(self):
        contact = self.contact()
        contact.solve()
        self.fails(rc.ERR_ARGUMENT, contact.field, 99)
        self.fails(rc.ERR_OPTION, contact.stat, "no such number")
        self.fails(rc.ERR_ARGUMENT, contact.displacements_at, 3, [[0.0, 0.0]])
        self.fails(rc.ERR_NONFINITE, contact.displacements_at, 1, [[NAN, 0.0]])
        wanted = rc.ERR_IO if rc.has_feature("vtu") else rc.ERR_UNSUPPORTED
        self.fails(wanted, contact.write, "/no/such/directory/contact.vtu")
        contact.reset()
        self.fails(rc.ERR_STATE, contact.tractions)


if __name__ == "__main__":
    unittest.main()
