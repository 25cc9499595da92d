"""Tests that pictures show what the contact has, that reprs tell it, that names stand for enumerators, and that the
text for a library that is not found helps."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import rollcon as rc
from rollcon import plots
from scene import LOAD, MU, Scene

import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

PACKAGE = pathlib.Path(rc.__file__).parent


class Pictures(Scene):

    def setUp(self):
        super().setUp()
        self.drawn = self.contact()
        self.drawn.set_creep(-1e-3, 5e-4, 0.0)
        self.drawn.solve()

    def tearDown(self):
        pyplot.close("all")
        super().tearDown()

    def test_stress_below(self):
        value, place = self.drawn.find_stress(1, "shear")
        self.assertLess(place[2], 0)
        drawn = self.drawn.plot_stress(1, "shear")
        x, depth = drawn.lines[0].get_xydata()[0]
        self.assertAlmostEqual(x, place[0])
        self.assertAlmostEqual(depth, -place[2])
        self.assertIn(f"{value:.4g}", drawn.get_title())
        self.assertRaises(ValueError, self.drawn.plot_stress, 1, "dang_van")

    def test_pressure_and_tractions(self):
        values = self.drawn.plot_pressure().collections[0].get_array()
        self.assertAlmostEqual(values.max(), self.drawn.field("pressure").max())
        lines = self.drawn.plot_tractions().lines
        state = self.drawn.node_states()
        self.assertEqual([len(line.get_xdata()) for line in lines], [(state == s).sum() for s in (rc.STICK, rc.SLIP)])

    def test_section(self):
        ax = self.drawn.plot_section()
        lines = {line.get_label(): line for line in ax.lines}
        pressure, traction = (lines[name].get_ydata() for name in ("pressure", "longitudinal traction"))
        self.assertAlmostEqual(pressure.max(), self.drawn.field("pressure").max())
        self.assertTrue((np.abs(traction) <= MU * np.maximum(pressure, 0) * (1 + 1e-9) + 1e-9).all())
        self.assertGreater(np.abs(traction).max(), 0)

    def test_creep_curve(self):
        before = self.drawn.resultant()[0]
        ax = self.drawn.plot_creep_curve([-1e-3, 0, 1e-3])
        force = ax.lines[0].get_ydata()
        self.assertAlmostEqual(force[0], before[0] / LOAD, places=7)
        self.assertGreater(force[0], force[1])
        self.assertGreater(force[1], force[2])
        np.testing.assert_allclose(self.drawn.resultant()[0], before, atol=1e-7 * LOAD)
        with self.assertRaisesRegex(ValueError, "allowed: longitudinal, lateral, spin"):
            self.drawn.plot_creep_curve([0], "normal")

    def test_filtered_profile(self):
        radius, noise = 80.0, 0.005
        turn = np.arange(-0.4, 0.4, 0.2 / radius)
        off = radius + noise * np.sin(77 * np.arange(len(turn)) ** 2)
        arc = np.column_stack([off * np.sin(turn), radius - off * np.cos(turn)])
        ax = plots.filtered(self.context, arc, [4, 12])
        drawn = {line.get_label(): line.get_xydata() for line in ax.lines}
        self.assertEqual(len(drawn), 3)
        error = []
        for label, xy in drawn.items():
            inside = np.abs(xy[:, 0]) < 25
            error.append(np.abs(xy[inside, 1] * radius - 1).max())
        self.assertGreater(error[0], 10)  # the noise is all that is seen
        self.assertGreater(error[1], 3 * error[2])
        self.assertLess(error[2], 0.1)
        moved = [float(label.split("moves by ")[1].split(",")[0]) for label in list(drawn)[1:]]
        for way in moved:
            self.assertGreater(way, 0.5 * noise)
            self.assertLess(way, 1.5 * noise)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "arc.txt"
            np.savetxt(path, 1e-3 * arc)
            again = plots.filtered(self.context, path, 12, unit=1000.0)
        np.testing.assert_allclose(again.lines[1].get_ydata(), ax.lines[2].get_ydata(), atol=1e-6)
        with self.assertRaisesRegex(ValueError, "allowed: lengths above 0"):
            plots.filtered(self.context, arc, 0)

    def test_profiles_and_patches(self):
        bodies = [rc.Body(self.context, "halfspace") for _ in range(2)]
        for body, shape in zip(bodies, ("s1002", "60e1")):
            body.set_elastic(2.1e5, 0.28)
            body.set_profile_shape(shape, [1])
            line = body.plot_profile().lines[0]
            np.testing.assert_allclose(line.get_xydata()[0], body.profile_point(0)[0])
        wheel = rc.WheelRail(self.context, *bodies, "right")
        wheel.set_track(1435, 14, 1 / 40)
        wheel.set_wheelset(1360, -70, 460)
        wheel.set_friction(0.3)
        wheel.prescribe_vertical("force", 1e4)
        wheel.set_position([0, 5, 0, 0, 0, 0])
        wheel.set_velocity([2000, 0, 0, 0, 0, -2000 / 460])
        self.assertIn("not solved", repr(wheel))
        self.assertIn(wheel.solve(), (rc.OK, rc.COARSE))
        ax = wheel.plot_patches()
        self.assertEqual([line.get_label() for line in ax.lines], ["wheel", "rail"])
        self.assertEqual(len(ax.patches), wheel.patch_count)
        # The patch is where pressures are drawn; y and z count from its reference.
        for k, drawn in enumerate(ax.patches):
            corners = drawn.get_xy()
            self.assertLess(corners[:, 0].min(), wheel.patch_stat(k, "y"))
            self.assertGreater(corners[:, 0].max(), wheel.patch_stat(k, "y"))
        left = rc.WheelRail(self.context, *bodies, "left")
        left.set_track(1435, 14, 1 / 40)
        left.set_wheelset(1360, -70, 460)
        shift = [-2.0, 0.0, 2.0]
        points = rc.contact_points(left, wheel, shift)
        lines = plots.contact_points(left, wheel, shift).lines
        np.testing.assert_array_equal(lines[0].get_ydata(), points.left.wheel_y)
        np.testing.assert_array_equal(lines[1].get_ydata(), points.right.wheel_y)
        line = plots.rolling_radius_difference(left, wheel, shift).lines[0]
        np.testing.assert_array_equal(line.get_ydata(), points.difference)
        line = plots.conicity(left, wheel, [2.0, 3.0]).lines[0]
        np.testing.assert_array_equal(line.get_ydata(), rc.conicity(left, wheel, [2.0, 3.0])[0])
        self.assertIn("-10000", repr(wheel))

    def test_nothing_solved(self):
        with self.assertRaises((rc.RollconError, ValueError)):
            rc.Contact(self.context, self.drawn_body(), self.drawn_body()).plot_pressure()

    def drawn_body(self):
        return rc.Body(self.context, "halfspace")


class Words(Scene):

    def test_reprs(self):
        contact = self.contact()
        self.assertIn("not solved", repr(contact))
        status = contact.solve()
        self.assertEqual((repr(status), status, f"{status}", f"{status:3d}"), ("OK (0)", 0, "OK (0)", "  0"))
        self.assertIn(f"{contact.size[0]} nodes", repr(contact))
        self.assertIn("force on body 1", repr(contact))
        self.assertIn("half-space", repr(rc.Body(self.context, "halfspace")))
        contact.close()
        self.assertEqual(repr(contact), "<rollcon.Contact, closed>")

    def test_properties(self):
        contact = self.contact()
        contact.prescribe("longitudinal", "force", 0.5 * MU * LOAD)
        contact.solve()
        for given, methods in (((contact.force, contact.moment), contact.resultant()),
                               ((contact.approach, contact.creepages), contact.motion())):
            for one, two in zip(given, methods):
                np.testing.assert_array_equal(one, two)
        self.assertLess(contact.creepages[0], 0)
        self.assertGreater(contact.approach, 0)
        np.testing.assert_array_equal(contact.pressure, contact.field(rc.FIELD_PRESSURE))

    def test_names(self):
        body = rc.Body(self.context, "rigid")
        with self.assertRaisesRegex(ValueError, "allowed: x, y, z"):
            body.set_support([0], "x w")
        from rollcon._library import enumerator
        self.assertEqual(enumerator("x z", "dof", ""), rc.DOF_X | rc.DOF_Z)
        self.assertEqual(rc.status_string("err_busy"), rc.status_string(rc.ERR_BUSY))

    def imported(self, folder, **environment):
        kept = {k: v for k, v in os.environ.items() if k not in ("ROLLCON_LIBRARY", "LD_LIBRARY_PATH")}
        return subprocess.run([sys.executable, "-c", "import rollcon; print(rollcon.library_path)"], text=True,
                              capture_output=True, env={**kept, "PYTHONPATH": str(folder), **environment})

    def test_where_the_library_is(self):
        with tempfile.TemporaryDirectory() as place:
            packages = pathlib.Path(place).resolve() / "lib/python3/dist-packages"
            shutil.copytree(PACKAGE, packages / "rollcon")
            run = self.imported(packages)
            if run.returncode:  # no library is installed in this system
                for word in ("finds no library librollcon.so", "ROLLCON_LIBRARY=", "pip install"):
                    self.assertIn(word, run.stderr)
            lib = packages.parents[1] / f"librollcon.so.{rc._api.ABI}"
            beside = packages / "rollcon" / lib.name
            for path in (lib, beside):
                shutil.copy(rc.library_path, path)
                self.assertEqual(self.imported(packages).stdout.strip(), str(path))
            beside.write_bytes(b"no library")
            self.assertEqual(self.imported(packages).stdout.strip(), str(lib))
            lib.unlink()
            run = self.imported(packages)
            if run.returncode:
                self.assertIn("could not use", run.stderr)

    def test_no_picture_is_needed(self):
        code = "import sys, rollcon; sys.exit(any(m.split('.')[0] == 'matplotlib' for m in sys.modules))"
        self.assertEqual(subprocess.run([sys.executable, "-c", code]).returncode, 0)


if __name__ == "__main__":
    unittest.main()
