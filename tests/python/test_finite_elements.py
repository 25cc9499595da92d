"""Finite-element bodies: a pressed block of two materials, and bad input with the status that it
deserves."""

import unittest

import numpy as np
import rollcon as rc

SIDE = 3
TOP = 1


def box():
    """The unit cube in 2 x 2 x 2 hexahedra: nodes, connectivity from 0."""
    z, y, x = np.meshgrid(*3 * [np.linspace(0, 1, SIDE)], indexing="ij")
    nodes = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
    k = np.arange(SIDE**3).reshape(SIDE, SIDE, SIDE)
    low, high = slice(None, -1), slice(1, None)
    bottom = [k[low, low, low], k[low, low, high], k[low, high, high], k[low, high, low]]
    top = [k[high, low, low], k[high, low, high], k[high, high, high], k[high, high, low]]
    return nodes, np.stack(bottom + top, axis=-1).reshape(-1, 8)


@unittest.skipUnless(rc.has_feature("fem"), "this build has no finite elements")
class FiniteElements(unittest.TestCase):

    def setUp(self):
        self.context = rc.Context(threads=1)
        self.plane = rc.Body(self.context, rc.BODY_RIGID)
        self.x, self.hexahedra = box()

    def fails(self, status, function, *arguments, **named):
        with self.assertRaises(rc.RollconError) as caught:
            function(*arguments, **named)
        self.assertEqual(caught.exception.status, status, caught.exception.message)
        return caught.exception.message

    def block(self):
        """Lower half of modulus 200, upper one of 100, no lateral contraction."""
        body = rc.Body(self.context, rc.BODY_FEM)
        body.set_nodes(self.x)
        body.add_elements(rc.HEX8, self.hexahedra[:4], 1)
        body.add_elements(rc.HEX8, self.hexahedra[4:] + 1, 2, index_base=1)
        body.set_elastic(200.0, 0.0, 1)
        body.set_elastic(100.0, 0.0, 2)
        body.set_support(np.arange(9), rc.DOF_Z)
        body.set_support([0], rc.DOF_X + rc.DOF_Y)
        body.set_support([2], rc.DOF_Y)
        body.set("between_nodes", 1)
        return body

    def pressed(self, body, tag):
        """Force on the block under a flat rigid punch without friction."""
        contact = rc.Contact(self.context, body, self.plane)
        contact.frame_from_body(1, tag)
        self.assertEqual(contact.size, (9, 4))
        contact.set_axes([0.5, 0.5, 1], [1, 0, 0], [0, 0, 1])
        contact.set_gap_quadratic(0, 0)
        contact.set_friction(0.0)
        contact.prescribe(rc.NORMAL, rc.BY_MOTION, 0.03)
        self.assertEqual(contact.solve(), rc.OK)
        return contact.resultant()[0]

    def test_a_pressed_block_of_two_materials(self):
        by_faces, by_nodes = self.block(), self.block()
        by_faces.tag_faces([4, 5, 6, 7], np.full(4, TOP), 6)
        by_nodes.tag_faces_of_nodes(np.arange(19, 28), 6, index_base=1)
        for body in (by_faces, by_nodes):
            # Springs in series: 0.03 / (0.5 / 200 + 0.5 / 100).
            np.testing.assert_allclose(self.pressed(body, 6), [0, 0, -4], atol=4e-9)
            self.assertEqual(body.size, (27, 8))
            self.assertGreater(body.stat("condensed_unknowns"), 0)

    def test_tags(self):
        body = rc.Body(self.context, rc.BODY_FEM)
        body.set_nodes(self.x)
        self.fails(rc.ERR_STATE, body.tag_faces, [0], [0], 6)
        self.fails(rc.ERR_STATE, body.tag_faces_of_nodes, [0], 6)
        body.add_elements(rc.HEX8, self.hexahedra)
        self.assertIn("0 to 7", self.fails(rc.ERR_MESH, body.tag_faces, [8], [0], 6))
        self.assertIn("1 to 6", self.fails(rc.ERR_MESH, body.tag_faces, [1], [7], 6, index_base=1))
        self.assertIn("0 to 26", self.fails(rc.ERR_MESH, body.tag_faces_of_nodes, [27], 6))
        for elements, faces in (([0, 1], [0]), ([[0]], [[0]]), ([0.5], [0])):
            with self.assertRaises(ValueError):
                body.tag_faces(elements, faces, 6)
        for ids in ([[0, 1]], [0.5], [2**31]):
            with self.assertRaises(ValueError):
                body.tag_faces_of_nodes(ids, 6)
        body.tag_faces([], [], 6)
        body.tag_faces_of_nodes([], 6)
        body.tag_faces([0], [TOP], 6)
        body.set_elastic(200.0, 0.3)
        body.set_support(np.arange(9))
        text = self.fails(rc.ERR_MESH, body.prepare)
        self.assertIn("face 1 of element 0", text)
        if not rc.has_feature("bem"):
            return
        boundary = rc.Body(self.context, rc.BODY_BEM)
        self.fails(rc.ERR_STATE, boundary.tag_faces, [0], [0], 6)

    def test_one_material_needs_no_tag(self):
        body = rc.Body(self.context, rc.BODY_FEM)
        body.set_elastic(200.0, 0.3)
        body.set_nodes(self.x)
        body.add_elements(rc.HEX8, self.hexahedra)
        body.add_elements(rc.QUAD4, [[18, 19, 22, 21]])
        body.set_support(np.arange(9))
        body.set_pressure(1, 5.0)
        body.prepare()
        force, _ = body.reaction()
        np.testing.assert_allclose(force, [0, 0, 5.0 / 4], atol=1e-12)
        self.assertEqual(body.kind, rc.BODY_FEM)

    def test_meshes_and_materials(self):
        widths = {rc.TET4: 4, rc.TET10: 10, rc.WEDGE6: 6, rc.WEDGE15: 15, rc.HEX8: 8, rc.HEX20: 20}
        body = rc.Body(self.context, rc.BODY_FEM)
        body.set_nodes(self.x)
        for element_type, width in widths.items():
            with self.assertRaises(ValueError):
                body.add_elements(element_type, np.zeros((1, width + 1), dtype=int))
            self.fails(rc.ERR_MESH, body.add_elements, element_type, np.full((1, width), 27))
        body.add_elements(rc.HEX8, self.hexahedra, 3)
        body.set_support(np.arange(9))
        body.set_elastic(200.0, 0.3)
        self.assertIn("tag 3", self.fails(rc.ERR_STATE, body.prepare))
        body.set_elastic(200.0, 0.5, 3)
        self.fails(rc.ERR_UNSUPPORTED, body.prepare)
        body.set_elastic(200.0, 0.3, 3)
        body.prepare()
        if not rc.has_feature("bem"):
            return
        boundary = rc.Body(self.context, rc.BODY_BEM)
        boundary.set_nodes(self.x)
        self.fails(rc.ERR_ARGUMENT, boundary.add_elements, rc.HEX8, self.hexahedra)


if __name__ == "__main__":
    unittest.main()
