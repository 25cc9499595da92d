"""Tests fields inside finite elements and half-spaces from Python, and their VTU files read back."""

import os
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np
import rollcon as rc


def read_back(path):
    """Returns the arrays of a VTU file by their names."""
    piece = ElementTree.parse(path).getroot().find("UnstructuredGrid/Piece")
    return {a.get("Name"): np.array(a.text.split(), dtype=float).reshape(-1, int(a.get("NumberOfComponents")))
            for a in piece.iter("DataArray")}


def block(n):
    """Returns a unit cube of n^3 trilinear hexahedra: nodes, elements."""
    line = np.linspace(0, 1, n + 1)
    x = np.stack(np.meshgrid(line, line, line, indexing="ij"), axis=-1).reshape(-1, 3)
    corner = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
    first = np.stack(np.meshgrid(*3 * [np.arange(n)], indexing="ij"), axis=-1).reshape(-1, 1, 3)
    return x, (first + corner) @ np.array([(n + 1) ** 2, n + 1, 1])


class BodyFields(unittest.TestCase):
    def setUp(self):
        self.context = rc.Context()
        try:
            self.body = rc.Body(self.context, "fem")
        except rc.RollconError as error:
            if error.status != rc.ERR_UNSUPPORTED:
                raise
            self.skipTest("no finite elements in this build")
        self.x, self.element = block(3)
        self.body.set_nodes(self.x)
        self.body.add_elements("hex8", self.element)
        self.body.set_elastic(1000, 0.3)
        bottom = np.flatnonzero(self.x[:, 2] == 0)
        self.body.set_support(bottom)
        self.body.prepare()

    def test_stretch(self):
        """Stretches the block along z: stresses follow Hooke's law, everywhere the same."""
        u = np.zeros_like(self.x)
        u[:, 2] = 1e-3 * self.x[:, 2]
        lame = 1000 * 0.3 / (1.3 * 0.4)
        expected = 1e-3 * np.array([lame, lame, lame + 1000 / 1.3, 0, 0, 0])
        np.testing.assert_allclose(self.body.node_stresses(u), np.tile(expected, (len(u), 1)), atol=1e-12)
        stress, place = self.body.point_stresses(u)
        np.testing.assert_allclose(stress, np.tile(expected, (8 * 27, 1)), atol=1e-12)
        self.assertTrue(np.all((place > 0) & (place < 1)))
        points = np.random.default_rng(1).random((50, 3))
        moved, stress = self.body.fields_at(points, u)
        np.testing.assert_allclose(moved[:, 2], 1e-3 * points[:, 2], atol=1e-15)
        np.testing.assert_allclose(stress, np.tile(expected, (50, 1)), atol=1e-12)

    def test_file(self):
        u = 1e-3 * np.sin(self.x)
        path = os.path.join(tempfile.mkdtemp(), "body.vtu")
        try:
            self.body.write(path, u)
        except rc.RollconError as error:
            if error.status != rc.ERR_UNSUPPORTED:
                raise
            self.skipTest("no VTU files in this build")
        data = read_back(path)
        np.testing.assert_array_equal(data["points"], self.x)
        np.testing.assert_array_equal(data["displacement"], u)
        np.testing.assert_array_equal(data["connectivity"].reshape(-1, 8), self.element)
        np.testing.assert_array_equal(data["types"], 12)
        stress = self.body.node_stresses(u)
        np.testing.assert_array_equal(data["stress"], stress[:, [0, 1, 2, 3, 5, 4]])
        np.testing.assert_array_equal(data["von_mises"][:, 0], rc.stress_invariants(stress)[1])
        try:
            import meshio
        except ImportError:
            return
        mesh = meshio.read(path)
        np.testing.assert_array_equal(mesh.points, self.x)
        np.testing.assert_array_equal(mesh.cells_dict["hexahedron"], self.element)
        np.testing.assert_array_equal(mesh.point_data["displacement"], u)


class BlockOfHalfSpace(unittest.TestCase):
    """The file of a half-space holds a block around the contact, in the body's axes, with the fields of the solve."""

    def test_both_bodies(self):
        context = rc.Context()
        steel = rc.Body(context, "halfspace")
        steel.set_elastic(206e3, 0.3)
        contact = rc.Contact(context, steel, steel)
        contact.frame_rectangle("quad4", 16, 12, -0.4, 0.4, -0.3, 0.3)
        contact.set_gap_quadratic(1 / 40, 1 / 30)
        contact.set_friction(0.3)
        contact.set_creep(longitudinal=0.001)
        contact.prescribe("normal", "force", 100)
        turn = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
        contact.set_pose("body2", turn, [1, 2, 3])
        contact.solve()
        for body, side in (("body1", -1), ("body2", 1)):
            path = os.path.join(tempfile.mkdtemp(), "block.vtu")
            try:
                contact.write_body(body, path)
            except rc.RollconError as error:
                if error.status != rc.ERR_UNSUPPORTED:
                    raise
                self.skipTest("no VTU files in this build")
            data = read_back(path)
            x = data["points"]
            u, stress = contact.fields_at(body, x, rc.IN_BODY)
            self.assertGreater(abs(stress).max(), 500)
            np.testing.assert_allclose(data["displacement"], u, rtol=0, atol=1e-14)
            np.testing.assert_allclose(data["stress"], stress[:, [0, 1, 2, 3, 5, 4]], rtol=0, atol=1e-9)
            np.testing.assert_allclose(data["von_mises"][:, 0], rc.stress_invariants(stress)[1], rtol=0, atol=1e-9)
            # In the axes of the contact the block is under its middle, three times as long and wide, in the body alone.
            place = x @ turn.T + [1, 2, 3] if side > 0 else x
            touched = contact.field("point")[contact.node_states() != 0]
            low, high = place.min(0), place.max(0)
            np.testing.assert_allclose((low + high)[:2], (touched.min(0) + touched.max(0))[:2], atol=0.06)
            np.testing.assert_allclose((high - low)[:2] / np.ptp(touched, 0)[:2], 3, atol=0.7)
            self.assertEqual(np.min(side * place[:, 2]), 0)
            # Its elements are not turned inside out, and fill it.
            corner = x[data["connectivity"].astype(int).reshape(-1, 8)]
            edge = [corner[:, k] - corner[:, 0] for k in (1, 3, 4)]
            volume = np.einsum("ij,ij->i", np.cross(edge[0], edge[1]), edge[2])
            self.assertGreater(volume.min(), 0)
            self.assertAlmostEqual(volume.sum() / np.prod(high - low), 1)
            try:
                import meshio
            except ImportError:
                continue
            mesh = meshio.read(path)
            np.testing.assert_array_equal(mesh.points, x)
            np.testing.assert_array_equal(mesh.point_data["stress"], data["stress"])


if __name__ == "__main__":
    unittest.main()
