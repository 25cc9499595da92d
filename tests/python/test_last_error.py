"""Tests what a user is told: texts of failures, names of enumerators, copies, paths, the latch."""

import copy
import os
import pickle
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import rollcon as rc
from scene import LOAD, Scene


class LastError(Scene):

    def raises(self, kind, words, function, *arguments, **named):
        with self.assertRaises(kind) as caught:
            function(*arguments, **named)
        for word in words:
            self.assertIn(word, str(caught.exception))
        return caught.exception

    def test_a_closed_body_has_a_text_of_its_own(self):
        body = rc.Body(self.context, rc.BODY_HALFSPACE)
        self.raises(rc.RollconError, ["young is -1"], body.set_elastic, -1, 0.3)
        body.close()
        error = self.raises(rc.RollconError, ["rollcon_body_set_elastic", "body is NULL"],
                            body.set_elastic, 1, 0.3)
        self.assertEqual(error.status, rc.ERR_ARGUMENT)
        self.assertEqual(error.message, rc.last_error())
        self.assertNotIn("young", error.message)

    def test_enumerators_by_name(self):
        body = rc.Body(self.context, "halfspace")
        self.assertEqual(body.kind, rc.BODY_HALFSPACE)
        self.assertEqual(rc.Body(self.context, "BODY_RIGID").kind, rc.BODY_RIGID)
        contact = rc.Contact(self.context, self.sphere, self.plane)
        contact.frame_nodes([[0, 0], [1, 0], [1, 1], [0, 1]])
        contact.frame_add_elements("quad4", [[0, 1, 2, 3]])
        contact.frame_rectangle("quad4", 8, 8, -1.3, 1.3, -1.3, 1.3)
        contact.set_gap_quadratic(0.01, 0.01)
        contact.set_friction(0.1)
        contact.prescribe("normal", "by_force", LOAD)
        self.assertEqual(contact.solve(), rc.OK)
        np.testing.assert_array_equal(contact.field("traction", "global"),
                                      contact.field(rc.FIELD_TRACTION, rc.GLOBAL))
        np.testing.assert_array_equal(contact.sensitivity("friction")[0],
                                      contact.sensitivity(rc.FRICTION)[0])
        cases = contact.solve_many("normal", [[LOAD], [LOAD / 2]])
        by_number = contact.solve_many([rc.NORMAL], [[LOAD], [LOAD / 2]])
        np.testing.assert_array_equal(cases.force, by_number.force)
        self.raises(ValueError, ["direction is 'upwards'", "longitudinal, lateral, normal, spin"],
                    contact.prescribe, "upwards", "by_force", 1)
        self.raises(ValueError, ["element_type is 'quad5'", "quad4"],
                    contact.frame_add_elements, "quad5", [[0, 1, 2, 3]])
        self.raises(ValueError, ["kind is 'steel'", "fem, bem"], rc.Body, self.context, "steel")
        self.raises(ValueError, ["tag is 'rim'", "a number"], contact.frame_from_body, 1, "rim")
        self.raises(TypeError, ["how must be an integer, not 2.5"],
                    contact.prescribe, "normal", 2.5, 1)
        self.raises(TypeError, ["speed must be a number"], contact.set_rolling, None)
        self.raises(rc.RollconError, ["parameters has '77'"], contact.solve_many, [77], [[1.0]])

    def test_a_copy_is_another_reference(self):
        body = rc.Body(self.context, rc.BODY_RIGID)
        other = copy.copy(body)
        self.assertEqual(other.id, body.id)
        del other
        self.assertEqual(body.kind, rc.BODY_RIGID)
        other = copy.copy(body)
        body.close()
        self.assertEqual(other.kind, rc.BODY_RIGID)
        closed = copy.copy(body)
        self.raises(rc.RollconError, ["body is NULL"], closed.prepare)
        contact = copy.copy(self.contact())
        calls = []
        contact.set_progress(lambda event: calls.append(event.phase))
        twin = copy.copy(contact)
        del contact
        self.assertEqual(twin.solve(), rc.OK)
        self.assertTrue(calls)
        for function in (copy.deepcopy, pickle.dumps):
            self.raises(TypeError, ["a contact cannot be"], function, twin)
            self.raises(TypeError, ["a context cannot be"], function, self.context)

    def test_paths(self):
        contact = self.contact()
        self.assertEqual(contact.solve(), rc.OK)
        for path in (None, 5, 1.5, ["x"]):
            self.raises(TypeError, ["path must be the name of a file"], contact.write, path)
            self.raises(TypeError, ["path must be the name of a file"], self.plane.save, path)
            self.raises(TypeError, ["path must be"], rc.Body.load, self.context, path)
        for path in ("a\0b", b"a\0b"):
            self.raises(ValueError, ["NUL"], contact.write, path)
            self.raises(ValueError, ["NUL"], self.plane.save, path)
        self.assertFalse(os.path.exists("None") or os.path.exists("5") or os.path.exists("a"))
        for name in ("tolerance\0x", 5, None, b"tolerance"):
            self.raises((TypeError, ValueError), ["name"], contact.get, name)
            self.raises((TypeError, ValueError), ["name"], contact.stat, name)
        self.raises(ValueError, ["NUL"], contact.set, "convection", "godunov\0")
        if rc.has_feature("vtu"):
            with tempfile.TemporaryDirectory() as folder:
                for path in (folder + "/text.vtu", os.fsencode(folder + "/bytes.vtu"),
                             Path(folder) / "path.vtu"):
                    contact.write(path)
                    self.assertTrue(os.path.getsize(path) > 0)

    def test_the_latch(self):
        contact = self.contact()
        self.context.set_latch()
        self.assertEqual(contact.get("tolerance"), 1e-10)  # types are looked up, not tried
        self.assertEqual(contact.get("convection"), "characteristic")
        self.assertEqual(self.context.check(), rc.OK)
        self.assertEqual(contact.solve(), rc.OK)
        self.raises(rc.RollconError, ["speed is -1"], contact.set_rolling, -1)
        self.raises(rc.RollconError, ["speed is -1"], contact.solve)
        self.raises(rc.RollconError, ["speed is -1"], rc.Body, self.context, "rigid")
        self.raises(rc.RollconError, ["rollcon_contact_set_rolling: speed is -1"],
                    self.context.check)
        self.context.set_latch(0)
        self.assertEqual(contact.solve(), rc.OK)
        self.raises(rc.RollconError, ["unknown option 'tolerances'"], contact.get, "tolerances")

    def test_a_wrong_library_is_an_import_error(self):
        with tempfile.TemporaryDirectory() as folder:
            text = Path(folder) / "notes.txt"
            text.write_text("no library")
            libc = "libc.so.6"
            for path, word in ((folder + "/absent.so", "cannot load"), (text, "cannot load"),
                               (libc, "is not librollcon")):
                run = subprocess.run([sys.executable, "-c", "import rollcon"], text=True,
                                     env={**os.environ, "ROLLCON_LIBRARY": str(path)},
                                     stderr=subprocess.PIPE, check=False)
                self.assertEqual(run.returncode, 1)
                self.assertRegex(run.stderr, f"ImportError: .*{word}")
                self.assertIn("ROLLCON_LIBRARY", run.stderr)
                self.assertIn(str(path), run.stderr)


if __name__ == "__main__":
    unittest.main()
