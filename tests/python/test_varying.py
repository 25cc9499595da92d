"""Tests rails that vary and wheels out of round: derivatives, ends, slopes, waves, sections, a picture."""

import pathlib
import tempfile
import unittest

import numpy as np
import rollcon as rc
from scene import Scene

import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


class Varying(Scene):

    def tearDown(self):
        pyplot.close("all")
        super().tearDown()

    def steel(self, shape, parameters):
        body = rc.Body(self.context, "halfspace")
        body.set_elastic(2.1e5, 0.28)
        body.set_profile_shape(shape, parameters)
        return body

    def rail(self, places, height=lambda x: 0):
        """Returns a head of radius 300, 40 wide, by slices; its top is at this z."""
        rail = self.steel("arc", [-300, 20])
        turn = np.arcsin(20 / 300)
        for x in places:
            rail.set_profile_shape("arcs", [-20, 300 * (1 - np.cos(turn)) + height(x), -turn, 600 * turn, 1 / 300])
            rail.add_slice(x, [])
        return rail

    def wheel(self, wheel, rail, x=0.0, pitch=0.0, rate=0.0, y=0.0):
        made = rc.WheelRail(self.context, wheel, rail, "right")
        made.place_rail(750, 0, 0)
        made.set_wheelset(1360, -70, 460)
        made.set_friction(0.3)
        made.prescribe_vertical("force", 1e4)
        made.set_position([x, y, 0, 0, 0, pitch])
        made.set_velocity([2000, 0, rate, 0, 0, -2000 / 460])
        return made

    def test_derivatives_by_place_and_turn(self):
        wheel = self.steel("line", [60, -0.025])
        wheel.add_wave(0.05, 2 * np.pi / 8, 0.3)
        rail = self.rail(np.arange(-300, 301, 50), lambda x: 0.3 * np.sin(x / 80))
        solved = self.wheel(wheel, rail, 20, 0.2)
        solved.solve()
        for entry, step in ((0, 0.02), (5, 1e-4)):
            ends = []
            for sign in (-1, 1):
                at = self.wheel(wheel, rail, 20 + sign * step * (entry == 0), 0.2 + sign * step * (entry == 5))
                at.solve()
                ends.append([*at.resultant()[0], at.stat("z")])
            force, _, z = solved.derivative(entry)
            wanted = (np.array(ends[1]) - ends[0]) / (2 * step)
            self.assertGreater(abs(wanted[3]), 1e-3)
            self.assertAlmostEqual(z, wanted[3], delta=1e-3 * abs(wanted[3]))
            self.assertAlmostEqual(force[0], wanted[0], delta=1e-2 * abs(wanted[0]))

    def test_where_a_rail_begins_and_ends(self):
        rail = self.steel("arc", [-300, 20])
        for x in (0, 100, 200, 300):
            rail.add_slice(x, [0, 1e9, -1, -1] if x < 150 else [-1, -1, 0, 1e9])
        wheel = self.steel("line", [60, -0.025])
        height = []
        for x in (100, 200):
            at = self.wheel(wheel, rail, x)
            self.assertGreaterEqual(at.solve(), 0)
            self.assertEqual(at.patch_count, 1)
            height.append(at.stat("z"))
        self.assertAlmostEqual(*height, delta=1e-3)
        with self.assertRaisesRegex(rc.RollconError, "derailed"):
            self.wheel(wheel, rail, 150).solve()

    def test_rail_that_rises_steeply(self):
        # A circle on an inclined plane: R sqrt(1 + k^2) over it, touching R sin of the inclination ahead.
        wheel = self.steel("line", [60, 0])
        plain = self.wheel(wheel, self.rail([0]))
        plain.solve()
        for k in (0.1, 0.4):
            at = self.wheel(wheel, self.rail(np.arange(-400, 401, 100), lambda x, k=k: -k * x), rate=-2000 * k)
            at.solve()
            self.assertAlmostEqual(at.patch_stat(0, "x"), 460 * k / np.hypot(1, k), delta=0.2)
            self.assertAlmostEqual(at.stat("z"), plain.stat("z") + 460 * (1 - np.hypot(1, k)), delta=0.02)

    def test_waves_that_are_refused(self):
        wheel, rail = self.steel("line", [60, 0]), self.steel("arc", [-300, 20])
        rail.add_wave(1e-3, 4.5, 0)
        with self.assertRaisesRegex(rc.RollconError, "wave of length 4.5; allowed: from 4.6 on"):
            self.wheel(wheel, rail).solve()
        round_wheel = self.steel("line", [60, 0])
        round_wheel.add_wave(1e-3, 2 * np.pi / 1000, 0)
        with self.assertRaisesRegex(rc.RollconError, "allowed: from 0.01 on"):
            self.wheel(round_wheel, self.rail([0])).solve()
        deep = self.steel("line", [60, 0])
        deep.add_wave(500, 2 * np.pi / 6, 0)
        with self.assertRaisesRegex(rc.RollconError, "waves of 500 reach the axis"):
            self.wheel(deep, self.rail([0])).solve()

    def test_lists_that_contradict_themselves(self):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            (folder / "a.txt").write_text("".join(f"{y} {y * y / 600}\n" for y in range(-20, 21)))
            lines = ["0 1", "2", "2", "1", "0 'a.txt'", "100 'a.txt'", "0 0 999", "100 0 999"]
            for row, text, words in ((None, "", ""), (6, "5 0 999", "features at 5.*slice is at 0"),
                                     (0, "0 0", "scale may not be 0"), (0, "0 1e308", "place is inf")):
                given = [text if k == row else line for k, line in enumerate(lines)]
                (folder / "list.slcs").write_text("\n".join(given) + "\n")
                body = self.steel("arc", [-300, 20])
                length = body.profile_length()
                if not words:
                    body.read_slices(str(folder / "list.slcs"), 1, 1)
                    continue
                with self.assertRaisesRegex(rc.RollconError, words):
                    body.read_slices(str(folder / "list.slcs"), 1, 1)
                self.assertEqual(body.profile_length(), length)

    def test_spoilt_lists_are_read_or_refused(self):
        random = np.random.default_rng(5)
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            (folder / "a.txt").write_text("".join(f"{y} {y * y / 600}\n" for y in range(-20, 21)))
            (folder / "b.txt").write_text("".join(f"{y} {y * y / 400 - 0.5}\n" for y in range(-18, 23)))
            lines = ["0 1", "3", "3 1", "1 1", "0 'a.txt'", "50 'b.txt'", "100 'a.txt'", "none", "0 0 15 999",
                     "50 0 15 999", "100 -1 15 999", "1", "0.1 200 0.3"]
            text = "\n".join(lines) + "\n"
            body, count = self.steel("arc", [-300, 20]), {"read": 0, "refused": 0}
            for case in range(600):
                given, kind = text, case % 5
                at = random.integers(len(text))
                if kind == 0:
                    given = text[:at]
                elif kind == 1:
                    given = text[:at] + chr(random.integers(1, 127)) + text[at + 1:]
                elif kind == 2:
                    given = text[:at] + text[random.integers(len(text)):]
                else:
                    row = random.integers(len(lines))
                    words = lines[row].split()
                    words[random.integers(len(words))] = random.choice(
                        ["nan", "-1", "1e308", "1e-320", "0", "99999", "'c.txt'", "", "-inf", "2"])
                    given = "\n".join(lines[:row] + [" ".join(words)] + (lines[row:] if kind == 3 else lines[row + 1:]))
                (folder / "list.slcs").write_text(given)
                before = body.profile_length()
                try:
                    body.read_slices(str(folder / "list.slcs"), 1, 1)
                    count["read"] += 1
                    self.assertTrue(np.isfinite(body.profile_point(body.profile_length() / 2)[0]).all(), given)
                except rc.RollconError as error:
                    count["refused"] += 1
                    self.assertRegex(str(error), "ERR_(IO|ARGUMENT|NONFINITE)", given)
                    self.assertEqual(body.profile_length(), before, given)
            self.assertGreater(min(count.values()), 50, count)

    def test_points_are_those_of_the_section(self):
        wheel = self.steel("line", [60, 0])
        wheel.add_wave(2, 2 * np.pi / 4, 0)
        rail = self.rail(np.arange(-300, 301, 50), lambda x: 3 * np.sin(x / 200))
        at = self.wheel(wheel, rail, 100, 0.3)
        at.solve()
        self.assertAlmostEqual(at.profile_point(rc.RAIL, 0.5)[1], 3 * np.sin(0.5), places=9)
        self.assertAlmostEqual(at.profile_point(rc.WHEEL, 0.5)[1], at.stat("z") + 2 * np.sin(4 * -0.3), places=9)

    def test_picture_of_a_passage(self):
        rail = self.rail(np.arange(-100, 101, 20), lambda x: -1e-4 * x * x)
        passing = self.wheel(self.steel("line", [60, -0.025]), rail)
        way = np.array([-40.0, 0, 40])
        upper, lower = passing.plot_passage(np.outer(way, [1, 0, 0, 0, 0, 0]), [2000, 0, 0, 0, 0, -2000 / 460])
        x, y = upper.collections[1].get_offsets().T
        self.assertAlmostEqual(x[-1], passing.patch_stat(0, "x"))
        self.assertAlmostEqual(y[-1], passing.patch_stat(0, "y"))
        np.testing.assert_allclose(lower.lines[3].get_ydata(), 1e4, rtol=1e-4)
        top = upper.collections[0].get_array().reshape(-1, 3)
        np.testing.assert_allclose(np.nanmin(top, axis=0), [-0.16, 0, -0.16], atol=0.01)
        with self.assertRaisesRegex(ValueError, "allowed: two"):
            passing.plot_passage([[0] * 6], [2000, 0, 0, 0, 0, -4], ax=[upper])

    def test_what_becomes_of_points(self):
        y = np.arange(-40, 40.1, 0.25)
        points = np.c_[y, 0.5 * np.exp(-y**2 / 64)]
        body = rc.Body(self.context, "halfspace")
        moved = []
        for order in 3, 2:
            body.set("filter_order", order)
            body.set_profile(points, 12)
            moved.append(body.stat("filter_moved"))
            self.assertGreater(body.stat("filter_curvature"), 0.02 / 64)
            self.assertLess(abs(body.stat("filter_y")), 1)
        self.assertGreater(moved[1], 1.5 * moved[0])
        body.set_profile(points)
        for name in "filter_moved", "filter_curvature", "kinks", "zigzags":
            self.assertEqual(body.stat(name), 0, name)
        points[[100, 101]] = points[[101, 100]]
        body.set_profile(points)
        self.assertEqual(body.stat("zigzags"), 1)
        roof = np.c_[y, 0.2 * abs(y)]
        body.set_profile(roof)
        self.assertEqual(body.stat("kinks"), 0)
        body.set("kink_angle", 20.0)
        body.set_profile(roof)
        self.assertEqual(body.stat("kinks"), 1)
        with self.assertRaisesRegex(rc.RollconError, "'zigzag_angle' is 170; allowed: 1 to 150"):
            body.set("zigzag_angle", 170.0)


if __name__ == "__main__":
    unittest.main()
