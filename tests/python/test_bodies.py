"""Bodies with a mesh: a stretched cube, and bad input with the status that it deserves."""

import math
import pathlib
import tempfile
import unittest

import numpy as np
import rollcon as rc

NAN = math.nan
YOUNG, POISSON = 200.0, 0.3
X = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0],
              [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)
# Tags 1 to 6: x = 0, x = 1, y = 0, y = 1, z = 0, z = 1.
FACES = [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]]


@unittest.skipUnless(rc.has_feature("bem"), "this build has no boundary elements")
class Bodies(unittest.TestCase):

    def setUp(self):
        self.context = rc.Context(threads=1)
        self.plane = rc.Body(self.context, rc.BODY_RIGID)

    def cube(self, x=X):
        body = rc.Body(self.context, rc.BODY_BEM)
        body.set_elastic(YOUNG, POISSON)
        body.set_nodes(x)
        for tag, face in enumerate(FACES, 1):
            body.add_elements(rc.QUAD4, [face], tag)
        return body

    def fails(self, status, function, *arguments, **named):
        with self.assertRaises(rc.RollconError) as caught:
            function(*arguments, **named)
        self.assertEqual(caught.exception.status, status, caught.exception.message)
        return caught.exception.message

    def test_a_stretched_cube(self):
        for x in (X, np.asfortranarray(X), X.tolist()):
            body = self.cube(x)
            body.set_support([0, 1, 2, 3], rc.DOF_Z)
            body.set_support(np.array([1, 2]), rc.DOF_Y, index_base=1)
            body.set_support([0], rc.DOF_X)
            body.set_traction(6, [0, 0, 3])
            body.set_pressure(6, 1.0)
            body.prepare()
            self.assertEqual(body.size, (8, 6))
            exact = 2 / YOUNG * X * [-POISSON, -POISSON, 1]
            np.testing.assert_allclose(body.displacements(), exact, atol=1e-6 * 2 / YOUNG)
            force, moment = body.reaction()
            np.testing.assert_allclose(force, [0, 0, -2], atol=1e-6)
            np.testing.assert_allclose(moment, [-1, 1, 0], atol=1e-6)
            self.assertTrue(all(np.isfinite(body.stat(name)) for name in rc.body_stat_names()))
            self.assertEqual(body.stat("assemblies"), 1)

    def test_given_displacements(self):
        body = self.cube()
        body.set_support([0, 1, 2, 3])
        lift = np.tile([0.0, 0.0, 0.01], (4, 1))
        body.set_support([4, 5, 6, 7], values=lift)
        body.prepare()
        np.testing.assert_array_equal(body.displacements()[4:], lift)

    def test_saved_and_loaded(self):
        body = self.cube()
        body.set_support([0, 1, 2, 3])
        body.set_pressure(6, 2.0)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "cube.rcb"
            self.fails(rc.ERR_IO, rc.Body.load, self.context, path)
            body.save(path)
            again = rc.Body.load(rc.Context(threads=1), path)
            self.assertEqual(again.size, body.size)
            self.assertEqual(again.kind, rc.BODY_BEM)
            self.assertEqual(again.stat("loaded"), 1)
            self.assertEqual(again.stat("factorizations"), 0)
            np.testing.assert_array_equal(again.displacements(), body.displacements())
            data = bytearray(path.read_bytes())
            data[len(data) // 2] ^= 1
            path.write_bytes(data)
            text = self.fails(rc.ERR_IO, rc.Body.load, self.context, path)
            self.assertIn(str(path), text)
            self.fails(rc.ERR_IO, body.save, folder + "/no/such/folder")

    def test_equal_bodies_share(self):
        one, two = self.cube(), self.cube()
        for body in (one, two):
            body.set_support([0, 1, 2, 3])
            body.prepare()
        self.assertEqual((one.stat("shared"), two.stat("shared")), (0, 1))
        self.assertEqual(two.stat("assemblies"), 1)

    def test_meshes(self):
        body = rc.Body(self.context, rc.BODY_BEM)
        self.assertEqual(body.kind, rc.BODY_BEM)
        self.fails(rc.ERR_STATE, body.add_elements, rc.QUAD4, FACES)
        self.fails(rc.ERR_NONFINITE, body.set_nodes, [[0, NAN, 0]])
        with self.assertRaises(ValueError):
            body.set_nodes(np.zeros((4, 5)))
        body.set_nodes(X)
        with self.assertRaises(ValueError):
            body.add_elements(rc.TRI3, FACES)
        with self.assertRaises(ValueError):
            body.add_elements(rc.QUAD4, np.array(FACES) + 0.5)
        self.fails(rc.ERR_MESH, body.add_elements, rc.QUAD4, [[0, 1, 2, 8]])
        self.fails(rc.ERR_ARGUMENT, body.add_elements, 999, FACES)
        self.assertEqual(body.size, (8, 0))
        halfspace = rc.Body(self.context, rc.BODY_HALFSPACE)
        self.fails(rc.ERR_STATE, halfspace.set_nodes, X)

    def test_supports_and_loads(self):
        body = self.cube()
        self.fails(rc.ERR_SINGULAR, body.prepare)
        self.fails(rc.ERR_MESH, body.set_support, [0, 8])
        self.fails(rc.ERR_MESH, body.set_support, [0], index_base=1)
        self.fails(rc.ERR_ARGUMENT, body.set_support, [0], 8)
        self.fails(rc.ERR_NONFINITE, body.set_support, [0], values=[[0, NAN, 0]])
        with self.assertRaises(ValueError):
            body.set_support([0, 1], values=[[0, 0, 0]])
        with self.assertRaises(ValueError):
            body.set_support([[0, 1]])
        with self.assertRaises(ValueError):
            body.set_support([0.5])
        self.fails(rc.ERR_ARGUMENT, body.set_traction, 7, [0, 0, 1])
        self.fails(rc.ERR_NONFINITE, body.set_traction, 6, [0, 0, NAN])
        self.fails(rc.ERR_ARGUMENT, body.set_pressure, 7, 1.0)
        self.fails(rc.ERR_NONFINITE, body.set_pressure, 6, NAN)
        self.fails(rc.ERR_ARGUMENT, body.set_contact_faces, [6, 9])
        body.set_contact_faces([6])
        body.set_contact_faces([])
        self.fails(rc.ERR_STATE, self.plane.set_pressure, 1, 1.0)
        self.fails(rc.ERR_STATE, body.displacements)
        self.fails(rc.ERR_STATE, body.reaction)
        self.fails(rc.ERR_STATE, body.stat, "bytes")
        body.set_support([0, 1, 2])
        body.prepare()
        self.fails(rc.ERR_STATE, body.set_support, [0])
        self.fails(rc.ERR_OPTION, body.stat, "no such number")

    def test_options(self):
        body = rc.Body(self.context, rc.BODY_BEM)
        for option in rc.body_option_table():
            self.assertEqual(body.get(option.name), option.standard)
            self.assertTrue(option.doc)
        self.fails(rc.ERR_OPTION, body.set, "no such option", 1)
        self.fails(rc.ERR_OPTION, body.get, "no such option")
        self.fails(rc.ERR_OPTION, body.set, "accuracy", 7.0)
        self.fails(rc.ERR_OPTION, body.set, "keep_factors", 0.5)
        with self.assertRaises(TypeError):
            body.set("accuracy", "tight")
        body.set("edge_angle", 30.0)
        self.assertEqual(body.get("edge_angle"), 30.0)

    def test_poses_and_frames(self):
        body = self.cube()
        body.set_support([0, 1, 2, 3])
        contact = rc.Contact(self.context, body, self.plane)
        turn = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
        self.fails(rc.ERR_ARGUMENT, contact.set_pose, 3, turn)
        self.fails(rc.ERR_ARGUMENT, contact.set_pose, 1, -turn)
        self.fails(rc.ERR_ARGUMENT, contact.set_pose, 1, 2 * turn)
        self.fails(rc.ERR_NONFINITE, contact.set_pose, 1, turn, [0, NAN, 0])
        with self.assertRaises(ValueError):
            contact.set_pose(1, np.eye(4))
        self.fails(rc.ERR_ARGUMENT, contact.frame_from_body, 1, 9)
        self.fails(rc.ERR_STATE, contact.frame_from_body, 2, 6)
        contact.frame_from_body(1, 6)
        self.assertEqual(contact.size, (4, 1))
        contact.set_pose(1, turn, [0, 0, 1])
        contact.set_gap_quadratic(0, 0)
        contact.set_friction(0.1)
        contact.prescribe(rc.NORMAL, rc.BY_MOTION, -1.0)
        self.assertEqual(contact.solve(), rc.NO_CONTACT)
        np.testing.assert_allclose(contact.field(rc.FIELD_POINT, rc.GLOBAL),
                                   X[4:] @ turn.T + [0, 0, 1], atol=1e-14)


if __name__ == "__main__":
    unittest.main()
