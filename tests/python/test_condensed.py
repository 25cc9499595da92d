"""Bodies whose stiffness or flexibility is given: as the finite elements that were condensed, and what is refused."""
import os
import tempfile
import unittest

import numpy as np
from test_loads import block, box, scene
from test_sections import lay_frame

import rollcon as rc

N = 8
NODES = box(N, 2, 3)[0]
TOP = np.where(NODES[:, 2] > -1e-9)[0]


def faces():
    number = np.arange((N + 1) ** 2).reshape(N + 1, N + 1)
    return np.stack([number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], -1).reshape(-1, 4)


def surface(context, young=1000):
    body = rc.Body(context, "condensed")
    body.set_nodes(NODES[TOP])
    body.add_elements("quad4", faces(), 0)
    body.set_elastic(young, 0.3)
    return body


def read_market(path):
    with open(path, encoding="ascii") as file:
        lines = [line for line in file if not line.startswith("%")]
    n = int(lines[0].split()[0])
    matrix = np.zeros((n, n))
    matrix[np.triu_indices(n)] = np.array(lines[1:], float)  # columns of the lower triangle
    return matrix + np.triu(matrix, 1).T


def substructure(stiffness, order, first, by_component):
    """A file as CalculiX writes it, component by component, or as Abaqus does; `order` lists places of nodes."""
    n, rows = len(order), np.concatenate([[3 * k, 3 * k + 1, 3 * k + 2] for k in order])
    names = np.repeat(order, 3) if by_component else np.asarray(order)
    text = f"**\n** GENERATION OF SUBSTRUCTURE\n*USER ELEMENT,NODES={len(names)},LINEAR\n** ELEMENT NODES\n"
    for k in range(0, len(names), 10):
        text += "**" + ",".join(f"{name + first:10d}" for name in names[k:k + 10]) + "\n"
    if by_component:
        text += "         1\n" + "".join(f"{k + 1:10d},{k % 3 + 1:10d}\n" for k in range(1, 3 * n))
    else:
        text += "1, 2, 3\n"
    text += "*MATRIX,TYPE=STIFFNESS\n"
    for i, row in enumerate(rows):
        values = [f"{stiffness[row, r]:.16e}" for r in rows[:i + 1]]
        text += "".join(",".join(values[k:k + 4]) + ("," if k + 4 <= i else "") + "\n" for k in range(0, i + 1, 4))
    return text


class AsCondensed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.context = rc.Context()
        cls.fem = block(cls.context, N)
        cls.fem.prepare()
        for form in ("stiffness", "flexibility"):
            cls.fem.write_condensed(form, cls.path(form))
        cls.stiffness, cls.flexibility = (read_market(cls.path(form)) for form in ("stiffness", "flexibility"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder.name, name + ".mtx")

    def write(self, name, text):
        with open(self.path(name), "w", encoding="ascii") as file:
            file.write(text)
        return self.path(name)

    def contact(self, body, frame=None, context=None):
        context = context or self.context
        contact = scene(rc.Contact(context, body, rc.Body(context, "rigid")),
                        frame or (lambda c: lay_frame(c, 0.9, 0.9, 12, 12, 0)))
        contact.prescribe("normal", "force", 20)
        # Its elements are as deep as the contact is wide, which is told.
        self.assertIn(contact.solve(), (0, 5, 6) if frame else (0, 6), contact.plan())
        return contact

    def expect_same(self, body, what, frame=None):
        old, new = self.contact(self.fem, frame), self.contact(body, frame)
        for name, a, b in (("tractions", old.tractions(), new.tractions()),
                           ("displacements", old.displacements_at(1, [[0.1, 0.2], [1.2, 0.3]]),
                            new.displacements_at(1, [[0.1, 0.2], [1.2, 0.3]])),
                           ("of all nodes", old.body_displacements(1)[TOP], new.body_displacements(1))):
            error = np.abs(np.subtract(a, b)).max() / np.abs(a).max()
            print(f"{what}, {name}: {error:.1e}, bound 1e-9")
            self.assertLess(error, 1e-9)

    def test_arrays_and_files(self):
        self.assertLess(np.abs(self.stiffness @ self.flexibility - np.eye(len(self.stiffness))).max(), 1e-9)
        for form, matrix in (("stiffness", self.stiffness), ("flexibility", self.flexibility)):
            read, given = surface(self.context), surface(self.context)
            read.read_condensed(form, self.path(form))
            given.set_condensed(form, matrix)
            self.expect_same(read, f"{form} from a file")
            self.expect_same(given, f"{form} from an array, its own faces", lambda c: lay_frame(c, 1, 1, 4, 4, 0))
        contact = self.contact(read)
        with self.assertRaisesRegex(rc.RollconError, "rollcon_contact_write_loads"):
            contact.write_body(1, self.path("picture"))

    def test_substructures(self):
        order = np.random.default_rng(1).permutation(len(TOP))
        for by_component in (True, False):
            body = surface(self.context)
            permuted = np.concatenate([[3 * k, 3 * k + 1, 3 * k + 2] for k in order])
            text = substructure(self.stiffness[np.ix_(permuted, permuted)], np.argsort(order), 76, by_component)
            # Nodes from arrays have the order in which the file names them.
            with self.assertRaisesRegex(rc.RollconError, "allowed|has a stiffness"):
                body.read_condensed("flexibility", self.write("sub", text))
            body.read_condensed("stiffness", self.path("sub"))
            self.expect_same(body, "substructure")

    def test_supports_and_loads(self):
        """Held nodes and tractions, by stiffness, by flexibility, and by numpy."""
        held, push = np.array([0, 1, 9]), [0.3, -0.2, 0.5]
        moved = [[0.01, 0, 0.02]] * 3
        rows = np.concatenate([3 * held, 3 * held + 1, 3 * held + 2])
        force = np.zeros(len(self.stiffness))
        for face in faces()[:N]:  # a strip of faces, each of area 1/4
            for k in face:
                force[3 * k:3 * k + 3] += 0.25 / 4 * np.array(push)
        u = np.zeros(len(force))
        for k in range(3):
            u[3 * held + k] = np.array(moved)[:, k]
        free = np.setdiff1d(np.arange(len(force)), rows)
        u[free] = np.linalg.solve(self.stiffness[np.ix_(free, free)],
                                  force[free] - self.stiffness[np.ix_(free, rows)] @ u[rows])
        given = moved
        for form, matrix, held in (("stiffness", self.stiffness, held), ("flexibility", self.flexibility, [])):
            if form == "flexibility":  # is held already: supports are refused, and loads alone act
                u, given = self.flexibility @ force, np.zeros((0, 3))
            body = surface(self.context)
            body.set_condensed(form, matrix)
            body.tag_faces_of_nodes(np.arange(2 * (N + 1)), 7)
            body.set_support(held, 7, given)
            body.set_traction(7, push)
            body.prepare()
            error = np.abs(body.displacements() - u.reshape(-1, 3)).max() / np.abs(u).max()
            print(f"{form} with loads beside numpy: {error:.1e}, bound 1e-9")
            self.assertLess(error, 1e-9)
            np.testing.assert_allclose(body.reaction()[0], -np.array(push) * N / 4, rtol=1e-9)
        body = surface(self.context)
        body.set_condensed("flexibility", self.flexibility)
        body.set_support([3], 1)
        with self.assertRaisesRegex(rc.RollconError, "node 3 .* has a support, but the flexibility"):
            body.prepare()

    def test_saved(self):
        body = surface(self.context)
        body.read_condensed("stiffness", self.path("stiffness"))
        expected = self.contact(body).tractions()
        body.save(self.path("saved"))
        other = rc.Context()
        loaded = rc.Body.load(other, self.path("saved"))
        np.testing.assert_array_equal(self.contact(loaded, context=other).tractions(), expected)

    def test_rigid_motions(self):
        """A stiffness that nothing holds is told, and held by the caller's choice."""
        rigid = np.zeros((len(self.stiffness), 6))
        for k, x in enumerate(NODES[TOP]):
            rigid[3 * k:3 * k + 3] = np.hstack([np.eye(3), np.cross(np.eye(3), x).T])
        q, _ = np.linalg.qr(rigid)
        off = np.eye(len(q)) - q @ q.T
        body = surface(self.context)
        body.set_condensed("stiffness", off @ self.stiffness @ off)
        with self.assertRaisesRegex(rc.RollconError, "6 rigid motion.s. are free.*translation"):
            body.prepare()
        body.set_support([0, 1, 9], 7)
        body.prepare()

    def test_units(self):
        """A factor of 1000 between matrix and modulus is told; the usual one is not far from 1."""
        for young, told in ((1000, False), (1e6, True), (1, True)):
            body = surface(self.context, young)
            body.read_condensed("flexibility", self.path("flexibility"))
            contact = scene(rc.Contact(self.context, body, rc.Body(self.context, "rigid")),
                            lambda c: lay_frame(c, 0.9, 0.9, 12, 12, 0))
            contact.prescribe("normal", "force", 20)
            self.assertEqual(contact.solve() != 0, told)
            if told:
                print(rc.last_caveat())
                self.assertIn("check the units of matrix", rc.last_caveat())

    def test_refusals(self):
        def refuses(text, form, matrix):
            body = surface(self.context)
            with self.assertRaisesRegex(rc.RollconError, text):
                body.set_condensed(form, matrix)
                body.prepare()
        k = self.stiffness
        wrong = k.copy()
        wrong[7, 3] += 1
        refuses("not symmetric: for y of node 2 and x of node 1", "stiffness", wrong)
        refuses("n is 4; needed: 59049", "stiffness", np.eye(2))
        wrong = k.copy()
        wrong[5, 5] = -1
        refuses("not positive definite: a force at component z of node 1", "stiffness", wrong)
        wrong[5, 5] = np.nan
        refuses("z of node 1 and z of node 1 .* is nan", "stiffness", wrong)
        refuses("flexibility is not positive definite: a force at component", "flexibility",
                self.flexibility - 1.5 * np.linalg.eigvalsh(self.flexibility)[0] * np.eye(len(k)))
        refuses("stiffness is not positive definite: a force at component", "stiffness",
                k - 1.5 * np.linalg.eigvalsh(k)[0] * np.eye(len(k)))
        refuses("form is 3; allowed", 3, k)
        body = surface(self.context)
        with self.assertRaisesRegex(rc.RollconError, "has no stiffness or flexibility"):
            body.prepare()
        market = "%%MatrixMarket matrix "
        for text, told in ((market + "array real general\n12 12\n", "line 2: a matrix of 12 rows; needed: 243"),
                           (market + "array real symmetric\n243 243\n1\n2\n", "line 4: the matrix ends early"),
                           (market + "coordinate real general\n243 243 1\n244 1 2\n", "line 3: an index"),
                           (market + "coordinate real general\n243 243 1e30\n", "line 2: more entries"),
                           (market + "coordinate complex general\n", "line 1: allowed"),
                           ("1 2 3\n", "neither a MatrixMarket file nor a substructure"), ("", "it is empty")):
            with self.assertRaisesRegex(rc.RollconError, told):
                body.read_condensed("stiffness", self.write("wrong", text))
        held = np.eye(243)  # CalculiX 2.20 condenses nothing and leaves such zeros
        with self.assertRaisesRegex(rc.RollconError, "most entries are exactly zero: nothing was condensed"):
            body.read_condensed("stiffness", self.write("wrong", substructure(held, np.arange(81), 1, True)))
        with self.assertRaisesRegex(rc.RollconError, "a finite-element body takes no stiffness"):
            block(self.context, N).set_condensed("stiffness", k)
        body.set_condensed("stiffness", k)
        self.expect_same(body, "after refusals")


if __name__ == "__main__":
    unittest.main()
