"""Forces of a contact on the nodes of its bodies: their sums are the contact's."""
import os
import tempfile
import unittest

import numpy as np
from test_sections import lay_frame

import rollcon as rc


def box(n, size, height):
    """Nodes and hex8 elements of a block [-size, size]^2 x [-height, 0]."""
    x, z = np.linspace(-size, size, n + 1), np.linspace(-height, 0, n + 1)
    nodes = np.array([[a, b, c] for c in z for b in x for a in x])
    number = np.arange((n + 1) ** 3).reshape(n + 1, n + 1, n + 1)
    corners = [number[k:k + n, j:j + n, i:i + n] for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return nodes, np.stack(corners, -1).reshape(-1, 8)


def hold(body, nodes, mesh):
    """A body with this mesh, held below, its top for contact."""
    mesh(body)
    body.set_elastic(1000, 0.3)
    body.set_support(np.where(nodes[:, 2] < -2.99)[0], 7)
    body.tag_faces_of_nodes(np.arange(len(nodes) - round(len(nodes) ** (1 / 3)) ** 2, len(nodes)), 4)
    body.set_contact_faces([4])
    return body


def block(context, n=5, nodes=None):
    usual, elements = box(n, 2, 3)
    nodes = usual if nodes is None else nodes
    return hold(rc.Body(context, "fem"), nodes,
                lambda b: (b.set_nodes(nodes), b.add_elements("hex8", elements, 0)))


def scene(contact, frame):
    """A ball that is pressed on and dragged; below it the surface is a plane."""
    frame(contact)
    contact.set_gap_quadratic(0.05, 0.05, 0)
    contact.set_friction(0.3)
    contact.set_rolling(10)
    contact.prescribe("normal", "force", 50)
    contact.set_creep(2e-3, 1e-3, 0)
    return contact


def vector(contact, which):
    """Forces by node as MatrixMarket has them, and as cards; these have to agree."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [os.path.join(folder, "loads" + end) for end in (".mtx", ".inp")]
        for path in paths:
            contact.write_loads(which, path)
        with open(paths[0], encoding="ascii") as file:
            lines = [line for line in file if not line.startswith("%")]
        with open(paths[1], encoding="ascii") as file:
            cards = [line.split(",") for line in file if not line.startswith("*")]
    force = np.array(lines[1:], float).reshape(-1, 3)
    assert lines[0].split() == [str(force.size), "1"]
    again = np.zeros_like(force)
    for node, component, value in cards:
        assert len(value.strip()) <= 20, "CalculiX reads no more"
        again[int(node) - 1, int(component) - 1] = float(value)
    np.testing.assert_array_equal(again, force)
    return force


class Sums(unittest.TestCase):
    def check(self, contact, which, nodes, pose=None, axes=None):
        """Sums of nodal forces in space, beside the contact's force and moment."""
        rotation, origin = (np.eye(3), np.zeros(3)) if pose is None else (np.array(pose[0], float), np.array(pose[1]))
        axes = np.array(axes if axes is not None else np.eye(3), float)  # rows t1, t2, n
        about = getattr(self, "origin", np.zeros(3))
        own = vector(contact, which)
        force, place = own @ rotation.T, np.asarray(nodes) @ rotation.T + origin - about
        local, moment = contact.resultant("local")
        sign = 1 if which == 1 else -1
        size = np.abs(local).max()
        found = np.abs(sign * axes @ force.sum(0) - local).max() / size
        turned = np.abs(sign * axes @ np.cross(place, force).sum(0) - moment).max() / size
        print(f"body {which}: sums beside the contact's, force {found:.1e}, moment {turned:.1e}; bound 1e-9")
        self.assertLess(found, 1e-9)
        self.assertLess(turned, 1e-9)
        return own

    def test_flat(self):
        context = rc.Context()
        body, plane = block(context), rc.Body(context, "rigid")
        nodes = box(5, 2, 3)[0]
        for frame in (lambda c: lay_frame(c, 1.3, 1.3, 12, 12, 0), lambda c: c.frame_from_body(1, 4)):
            contact = scene(rc.Contact(context, body, plane), frame)
            self.assertIn(contact.solve(), (0, 4, 5, 6))  # sums hold whatever is told of the mesh
            force = self.check(contact, 1, nodes)
            self.assertEqual(np.abs(force[nodes[:, 2] < -1e-9]).max(), 0)
        with self.assertRaisesRegex(rc.RollconError, "body 2 is a rigid body without a mesh"):
            contact.write_loads(2, "never.inp")
        with self.assertRaisesRegex(rc.RollconError, "'loads.txt' ends in neither"):
            contact.write_loads(1, "loads.txt")
        with self.assertRaisesRegex(rc.RollconError, "/nowhere/loads.inp"):
            contact.write_loads(1, "/nowhere/loads.inp")

    def test_second_body_that_stands_elsewhere(self):
        context = rc.Context()
        pose = [[1, 0, 0], [0, -1, 0], [0, 0, -1]], [3, 4, 5]
        contact = rc.Contact(context, rc.Body(context, "rigid"), block(context))
        contact.set_pose(2, *pose)
        contact.set_axes([3, 4, 5], [1, 0, 0], [0, 0, 1])

        def frame(c):
            x = np.linspace(-1.3, 1.3, 13)
            c.frame_nodes([[a + 3, b + 4, 5] for a in x for b in x])
            number = np.arange(169).reshape(13, 13)
            quads = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], -1)
            c.frame_add_elements("quad4", quads.reshape(-1, 4))
        scene(contact, frame)
        self.assertEqual(contact.solve(), 6)  # its elements are deep for the contact
        self.origin = np.array([3, 4, 5])
        self.check(contact, 2, box(5, 2, 3)[0], pose)

    def test_curved(self):
        """A flat frame on a round ridge: the surfaces of both are not one."""
        nodes, elements = box(6, 2, 3)
        nodes[:, 2] -= (nodes[:, 0] ** 2 / 8 + nodes[:, 1] ** 2 / 12) * (1 + nodes[:, 2] / 3)
        context = rc.Context()
        contact = rc.Contact(context, block(context, 6, nodes), rc.Body(context, "rigid"))
        scene(contact, lambda c: lay_frame(c, 1.3, 1.3, 14, 14, 0))
        self.assertEqual(contact.solve(), 6)  # its elements are deep for the contact
        self.check(contact, 1, nodes)

    def test_numbers_of_the_file(self):
        """Nodes keep the numbers of their file, also in saved bodies."""
        nodes, elements = box(3, 2, 3)
        text = "*NODE\n" + "".join(f"{7 * k + 100}, {x}, {y}, {z}\n" for k, (x, y, z) in enumerate(nodes))
        text += "*ELEMENT, TYPE=C3D8\n"
        text += "".join(f"{k + 1}, " + ", ".join(str(7 * a + 100) for a in e) + "\n" for k, e in enumerate(elements))
        top = {7 * k + 100 for k in np.where(nodes[:, 2] > -1e-9)[0]}
        with tempfile.TemporaryDirectory() as folder:
            path, saved, loads = (os.path.join(folder, name) for name in ("block.inp", "block.body", "loads.inp"))
            with open(path, "w", encoding="ascii") as file:
                file.write(text)
            context, other = rc.Context(), rc.Context()
            body = hold(rc.Body(context, "fem"), nodes, lambda b: b.read_mesh(path))
            body.save(saved)
            for where, own in ((context, body), (other, rc.Body.load(other, saved))):
                contact = scene(rc.Contact(where, own, rc.Body(where, "rigid")), lambda c: c.frame_from_body(1, 4))
                contact.solve()
                contact.write_loads(1, loads)
                with open(loads, encoding="ascii") as file:
                    cards = {int(line.split(",")[0]) for line in file if not line.startswith("*")}
                self.assertTrue(cards and cards <= top, cards - top)


if __name__ == "__main__":
    unittest.main()
