"""Bodies by a section: rings that roll, mesh files, saved bodies, Hertz's pressure."""
import os
import tempfile
import unittest

import numpy as np

import rollcon as rc


def spread(n, a, b):
    """Lines from a to b that are fine at both ends."""
    return 0.5 * (a + b) - 0.5 * (b - a) * np.cos(np.pi * np.arange(n + 1) / n)


def plane(y, z):
    """Nodes and quad8 elements between lines in the plane (y, z)."""
    def halves(line):
        return np.sort(np.concatenate([line, 0.5 * (line[1:] + line[:-1])]))
    y, z = halves(y), halves(z)
    number, nodes = -np.ones((len(y), len(z)), int), []
    for i, a in enumerate(y):
        for j, b in enumerate(z):
            if not (i % 2 and j % 2):
                number[i, j] = len(nodes)
                nodes.append([0, a, b])
    quads = [[number[i + a, j + b] for a, b in
              ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))]
             for i in range(0, len(y) - 1, 2) for j in range(0, len(z) - 1, 2)]
    return np.array(nodes, float), np.array(quads)


def ring(context, n):
    nodes, quads = plane(spread(n, -4, 4), spread(n, 25, 50))
    body = rc.Body(context, "section")
    body.set_nodes(nodes)
    body.add_elements("quad8", quads, 0)
    body.set_elastic(1e4, 0.3)
    body.tag_faces_of_nodes(np.where(np.abs(nodes[:, 2] - 50) < 1e-9)[0], 2)
    body.set_contact_faces([2])
    body.set_support(np.where(np.abs(nodes[:, 2] - 25) < 1e-9)[0], 7)
    body.revolve([0, 0, 0], [0, 1, 0])
    return body


def lay_frame(contact, half_x, half_y, nx, ny, z):
    x, y = np.linspace(-half_x, half_x, nx + 1), np.linspace(-half_y, half_y, ny + 1)
    contact.frame_nodes([[a, b, z] for a in x for b in y])
    number = np.arange((nx + 1) * (ny + 1)).reshape(nx + 1, ny + 1)
    quads = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], -1)
    contact.frame_add_elements("quad4", quads.reshape(-1, 4))
    return y


class Rings(unittest.TestCase):
    """Two equal rings of the paper's first example, whose fine meshes have 106.45 MPa and -1.505e-3."""

    def pair(self, context, ring1, ring2):
        contact = rc.Contact(context, ring1, ring2)
        contact.set_pose(2, [[1, 0, 0], [0, -1, 0], [0, 0, -1]], [0, 0, 100])
        contact.set_axes([0, 0, 50], [1, 0, 0], [0, 0, 1])
        lay_frame(contact, 1.2, 4, 24, 16, 50)
        contact.set_friction(0.1)
        contact.set_rolling(10)
        contact.prescribe("normal", "force", 1233.85)
        contact.prescribe("longitudinal", "force", 0.06271 * 1233.85)
        self.assertEqual(contact.solve(), 0)
        return contact

    def test_roll(self):
        context = rc.Context()
        first, second = ring(context, 12), ring(context, 12)
        contact = self.pair(context, first, second)
        middle = -contact.tractions()[:, 2].reshape(25, 17)[:, 8]
        self.assertLess(abs(middle.max() / 106.45 - 1), 0.003)
        self.assertLess(abs(contact.motion()[1][0] / -1.505e-3 - 1), 0.016)
        self.assertEqual(first.stat("shared") + second.stat("shared"), 1)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "ring.body")
            first.save(path)
            other = rc.Context()
            loaded = rc.Body.load(other, path)
            self.assertEqual(loaded.stat("factorizations"), 0)
            # Fields inside and the picture come from harmonics that are factorised once more.
            contact.write_body(1, os.path.join(folder, "ring.vtu"))
            self.assertGreater(os.path.getsize(os.path.join(folder, "ring.vtu")), 1000)
        again = self.pair(other, loaded, loaded)
        np.testing.assert_allclose(again.tractions(), contact.tractions(), rtol=1e-6, atol=1e-6)


class Pictures(unittest.TestCase):
    """Files show the whole ring, a sector around the contact or the surface alone, with the displacements inside."""

    def picture(self, sector):
        context = rc.Context()
        body = ring(context, 3)
        body.set("sector", sector)
        contact = rc.Contact(context, body, rc.Body(context, "rigid"))
        # The ring touches 0.6 radian away from where the section is drawn.
        sine, cosine = np.sin(0.6), np.cos(0.6)
        contact.set_axes([50 * sine, 0, 50 * cosine], [cosine, 0, -sine], [sine, 0, cosine])
        x, y = np.linspace(-1.2, 1.2, 7), np.linspace(-4, 4, 5)
        contact.frame_nodes([[50 * sine + a * cosine, b, 50 * cosine - a * sine] for a in x for b in y])
        number = np.arange(35).reshape(7, 5)
        quads = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], -1)
        contact.frame_add_elements("quad4", quads.reshape(-1, 4))
        contact.set_gap([a * a / 100 for a in x for b in y])
        contact.set_friction(0)
        contact.prescribe("normal", "force", 1000)
        contact.solve()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "ring.vtu")
            contact.write_body(1, path)
            try:
                import meshio
            except ImportError:
                raise unittest.SkipTest("no meshio")
            return contact, meshio.read(path)

    def test_whole_and_sector(self):
        for sector in (360, 50):
            contact, mesh = self.picture(sector)
            self.assertEqual([block.type for block in mesh.cells], ["hexahedron20"])
            corner = mesh.points[mesh.cells[0].data[:, :8]]
            volume = sum(np.einsum("ij,ij->i", np.cross(corner[:, a] - corner[:, 0], corner[:, b] - corner[:, 0]),
                                   corner[:, 6] - corner[:, 0]) / 6
                         for a, b in ((1, 2), (2, 3), (3, 7), (7, 4), (4, 5), (5, 1)))
            self.assertGreater(volume.min(), 0)
            share = volume.sum() / (np.pi * (50 ** 2 - 25 ** 2) * 8 * sector / 360)
            self.assertLess(abs(share - 0.99), 0.01, "elements have straight sides here")
            angle = np.degrees(np.arctan2(mesh.points[:, 0], mesh.points[:, 2]) - 0.6)
            if sector < 360:
                self.assertLess(abs(np.abs(angle).max() - sector / 2), 0.5)
            moved, stress = contact.fields_at(1, mesh.points[::50], "body")
            np.testing.assert_allclose(mesh.point_data["displacement"][::50], moved, atol=1e-9 * np.abs(moved).max())
            most = np.argmax(np.abs(mesh.point_data["displacement"]).sum(axis=1))
            self.assertLess(abs(angle[most]), 2)

    def test_surface_alone(self):
        _, mesh = self.picture(0)
        self.assertEqual([block.type for block in mesh.cells], ["quad9"])


class Lattice(unittest.TestCase):
    """A coarse section under a fine regular frame: half-spaces by FFT and a correction, beside matrices."""

    def solve(self, operators):
        context = rc.Context()
        nodes, quads = plane(np.array([-40, -25, -12, -4, 4, 12, 25, 40.]), 100 - np.array([60, 40, 25, 14, 7, 3, 0.]))
        wheel = rc.Body(context, "section")
        wheel.set_nodes(nodes)
        wheel.add_elements("quad8", quads, 0)
        wheel.set_elastic(2e5, 0.3)
        wheel.tag_faces_of_nodes(np.where(np.abs(nodes[:, 2] - 100) < 1e-9)[0], 2)
        wheel.set_contact_faces([2])
        wheel.set_support(np.where(np.abs(nodes[:, 2] - 40) < 1e-9)[0], 7)
        wheel.revolve([0, 0, 0], [0, 1, 0])
        contact = rc.Contact(context, wheel, rc.Body(context, "rigid"))
        contact.set_axes([0, 0, 100], [1, 0, 0], [0, 0, 1])
        x, y = (lay_frame(contact, 3, 3, 34, 34, 100) for _ in range(2))
        contact.set_gap([a * a / 200 + (b - 0.2) ** 2 / 100 for a in x for b in y])
        contact.set_friction(0.3)
        contact.set_creep(-1e-3, 4e-4, 0)
        contact.set("operators", operators)
        contact.prescribe("normal", "force", 6000)
        self.assertEqual(contact.solve(), 0)
        return contact

    def test_corrected_lattice_has_the_answers_of_matrices(self):
        corrected, dense = self.solve("auto"), self.solve("dense")
        self.assertGreater(corrected.stat("operator_applications"), 0)
        self.assertLess(corrected.stat("operator_bytes"), 0.5 * dense.stat("operator_bytes"))
        scale = np.abs(dense.tractions()).max()
        np.testing.assert_allclose(corrected.tractions(), dense.tractions(), rtol=0, atol=1e-4 * scale)
        np.testing.assert_allclose(corrected.resultant()[0], dense.resultant()[0], rtol=1e-5)
        self.assertLess(abs(corrected.motion()[0] / dense.motion()[0] - 1), 1e-6)
        self.assertLess(abs(corrected.stat("error_estimate") / dense.stat("error_estimate") - 1), 0.01)


class Files(unittest.TestCase):
    """The tube of Lame, its section from files of Abaqus and Gmsh."""

    def tube(self, text, end, tag_edges):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "tube" + end)
            with open(path, "w", encoding="ascii") as file:
                file.write(text)
            body = rc.Body(rc.Context(), "section")
            body.read_mesh(path)
        tag_edges(body)
        body.set_elastic(1000, 0.3)
        body.set_support(np.arange(body.size[0]), 2)
        body.set_pressure(3, 60)
        body.set_contact_faces([4])
        # Nothing else holds a tube from turning: z, the way at the section's place.
        body.set_support(body.group_nodes("inner"), 4)
        body.revolve([0, 0, 0], [0, 1, 0])
        body.prepare()
        u = body.displacements()
        exact = 1.3 * 60 / 3000 * (0.4 * 2 + 4 / 2)
        self.assertLess(abs(np.hypot(u[:, 0], u[:, 2]).max() / exact - 1), 2e-3)

    def test_abaqus(self):
        nodes = [(i, 1 + 0.125 * (i % 9), 0.5 * (i // 9)) for i in range(27)]
        text = "*NODE\n" + "".join(f"{i + 1}, {x}, {y}, 0\n" for i, x, y in nodes)
        text += "*ELEMENT, TYPE=CAX8\n"
        for k in range(4):
            a = 2 * k + 1
            text += f"{k + 1}, {a}, {a + 2}, {a + 20}, {a + 18}, {a + 1}, {a + 11}, {a + 19}, {a + 9}\n"
        text += "*NSET, NSET=INNER\n1, 10, 19\n*NSET, NSET=OUTER\n9, 18, 27\n"
        self.tube(text, ".inp", lambda b: (b.tag_group("inner", 3), b.tag_group("outer", 4)))

    def test_gmsh(self):
        n, m = 17, 3
        nodes = [(i * m + j + 1, 1 + i / (n - 1), 0.5 * j) for i in range(n) for j in range(m)]
        lines = [(1, 0, j) for j in range(m - 1)] + [(2, n - 1, j) for j in range(m - 1)]
        text = '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 "inner"\n1 2 "outer"\n2 5 "steel"\n'
        text += f"$EndPhysicalNames\n$Nodes\n{len(nodes)}\n" + "".join(f"{i} {x} {y} 0\n" for i, x, y in nodes)
        cells = [(i, j) for i in range(n - 1) for j in range(m - 1)]
        text += f"$EndNodes\n$Elements\n{len(lines) + len(cells)}\n"
        for k, (tag, i, j) in enumerate(lines):
            text += f"{k + 1} 1 2 {tag} {tag} {i * m + j + 1} {i * m + j + 2}\n"
        for k, (i, j) in enumerate(cells):
            a = i * m + j + 1
            text += f"{k + 10} 3 2 5 1 {a} {a + m} {a + m + 1} {a + 1}\n"
        text += "$EndElements\n"
        self.tube(text, ".msh", lambda b: (b.tag_group("inner", 3), b.tag_group("outer", 4), b.tag_group("steel", 0)))


class Hertz(unittest.TestCase):
    """A ball on a block without ends, whose section is deep: Hertz's pressure and radius."""

    def block(self, context):
        side = np.geomspace(0.5, 37, 9)
        fine = np.concatenate([-3 - side[::-1], np.linspace(-3, 3, 25), 3 + side])
        deep = np.concatenate([-np.geomspace(60, 0.3, 16), [0]])
        nodes, quads = plane(fine, deep)
        block = rc.Body(context, "section")
        block.set_nodes(nodes)
        block.add_elements("quad8", quads, 0)
        block.set_elastic(2e5, 0.3)
        block.tag_faces_of_nodes(np.where((nodes[:, 2] > -1e-9) & (np.abs(nodes[:, 1]) < 3.01))[0], 2)
        block.set_contact_faces([2])
        block.set_support(np.where(nodes[:, 2] < -59.99)[0], 7)
        block.extrude([0, 0, 0], [1, 0, 0], 400)
        block.set("stations", 1600)
        return block

    def press(self, contact):
        radius, force, modulus = 100, 4000, 2e5 / 0.91
        contact.set_friction(0)
        contact.prescribe("normal", "force", force)
        self.assertEqual(contact.solve(), 0)
        a = (0.75 * force * radius / modulus) ** (1 / 3)
        p0 = 1.5 * force / (np.pi * a * a)
        return contact.stat("max_pressure") / p0 - 1

    def test_frame_laid_on(self):
        context = rc.Context()
        contact = rc.Contact(context, self.block(context), rc.Body(context, "rigid"))
        contact.set_axes([0, 0, 0], [1, 0, 0], [0, 0, 1])
        y = lay_frame(contact, 2.4, 2.4, 32, 32, 0)
        contact.set_gap([(a * a + b * b) / 200 for a in y for b in y])
        self.assertLess(abs(self.press(contact)), 0.005)

    def test_automatic_frame(self):
        context = rc.Context()
        ball = rc.Body(context, "rigid")
        ball.set_profile_shape("arc", [100, 10])
        ball.revolve_profile([0, 0, 100], [0, 1, 0], 100)
        contact = rc.Contact(context, self.block(context), ball)
        contact.set_axes([0, 0, 0], [1, 0, 0], [0, 0, 1])
        error = self.press(contact)
        self.assertLess(abs(error), 0.01)


class Rail(unittest.TestCase):
    """A rail of foot, web and head on a foundation, beside a beam on Winkler's foundation that shears."""

    def test_deflection_far_from_the_load(self):
        young, poisson, foundation, period, force = 210000, 0.3, 60, 9000, 50000
        z = np.array([-172, -163, -154, -148, -140, -105, -70, -52, -44, -38, -20, 0.])
        half = np.array([75, 75, 70, 20, 8.25, 8.25, 8.25, 9, 25, 36, 36, 36])
        nodes, quads = plane(np.linspace(-1, 1, 5), z)
        nodes[:, 1] *= np.interp(nodes[:, 2], z, half)
        context = rc.Context()
        rail = rc.Body(context, "section")
        rail.set_nodes(nodes)
        rail.add_elements("quad8", quads, 0)
        rail.set_elastic(young, poisson)
        rail.tag_faces_of_nodes(np.where(nodes[:, 2] > -1e-9)[0], 2)
        rail.set_contact_faces([2])
        rail.tag_faces_of_nodes(np.where(nodes[:, 2] < -171.99)[0], 3)
        rail.set_springs(3, [1e-6, foundation / 150, foundation / 150])
        rail.extrude([0, 0, 0], [1, 0, 0], period)
        contact = rc.Contact(context, rail, rc.Body(context, "rigid"))
        contact.set_axes([0, 0, 0], [1, 0, 0], [0, 0, 1])
        lay_frame(contact, 15, 15, 4, 4, 0)
        contact.set_gap(np.zeros(25))
        contact.set_friction(0)
        contact.prescribe("normal", "force", force)
        contact.solve()

        fine = np.linspace(z[0], z[-1], 20001)
        width, step = 2 * np.interp(fine, z, half), fine[1] - fine[0]
        area = width.sum() * step
        middle = (width * fine).sum() * step / area
        inertia = (width * (fine - middle) ** 2).sum() * step
        first = np.cumsum(width * (fine - middle)) * step
        bends = young * inertia
        shears = young / 2 / (1 + poisson) * inertia ** 2 / ((first ** 2 / width).sum() * step)
        wave = 2 * np.pi * np.arange(20000) / period
        part = np.where(wave == 0, 1, 2) * force / period * (1 + bends * wave ** 2 / shears) / (
            bends * wave ** 4 + foundation * bends * wave ** 2 / shears + foundation)
        place = [300, 500, 800, 1200, 2000]
        moved, _ = contact.fields_at(1, [[x, 0, middle] for x in place], "body")
        for x, u in zip(place, moved[:, 2]):
            error = (-u - (part * np.cos(wave * x)).sum()) / part.sum()
            self.assertLess(abs(error), 0.01, f"at {x} mm")


class Wheel(unittest.TestCase):
    """A wheel that touches a rail in two places."""

    def test_two_patches(self):
        context = rc.Context()
        y = np.linspace(-50, 50, 201)
        rail = rc.Body(context, "halfspace")
        rail.set_elastic(210000, 0.3)
        rail.set_profile(np.stack([y, np.minimum((y + 22) ** 2 / 600, (y - 22) ** 2 / 500)], 1))
        forces, heights = [], []
        for kind in ("halfspace", "section"):
            wheel = rc.Body(context, kind)
            wheel.set_elastic(210000, 0.3)
            if kind == "halfspace":
                wheel.set_profile([[-50, 0], [50, 0]])
            else:
                # The wheel is so thick and wide that it is nearly a half-space.
                line = [-130, -80, -48, -34, -26, -22, -18, -9, 9, 18, 22, 26, 34, 48, 80, 130]
                nodes, quads = plane(np.array(line, float), 460 - np.array([360, 200, 110, 60, 30, 14, 6, 0.]))
                wheel.set_nodes(nodes)
                wheel.add_elements("quad8", quads, 0)
                wheel.tag_faces_of_nodes(np.where(nodes[:, 2] > 459.99)[0], 2)
                wheel.set_contact_faces([2])
                wheel.set_support(np.where(nodes[:, 2] < 100.01)[0], 7)
                wheel.revolve([0, 0, 0], [0, 1, 0])
            handle = rc.WheelRail(context, wheel, rail, "right")
            handle.set_track(1435, 0, 0)
            handle.set_wheelset(1435, 0, 460)
            handle.set_friction(0.3)
            handle.set_position([0, 0, 0, 0, 0, 0])
            handle.set_velocity([20000, 0, 0, 0, 0, -20010 / 460])
            handle.prescribe_vertical("by_force", 120000)
            self.assertEqual(handle.solve(), 0)
            self.assertEqual(handle.patch_count, 2)
            forces.append([handle.patch_stat(k, "normal_force") for k in range(2)])
            heights.append(handle.stat("z"))
        self.assertAlmostEqual(sum(forces[1]) / 120000, 1, places=5)
        np.testing.assert_allclose(forces[1], forces[0], rtol=0.02)
        self.assertLess(abs(heights[1] / heights[0] - 1), 0.03)


if __name__ == "__main__":
    unittest.main()
