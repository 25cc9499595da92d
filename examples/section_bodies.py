#!/usr/bin/env python3
"""Bodies by their sections: the paper's two rings beside finite and boundary elements, a wheel with a web on a rail, a
roller between two rings.

    python3 section_bodies.py [rings|wheel|roller ...]      all of them unless named

Leaves section_bodies_wheel.png where matplotlib is installed. Units: mm, N, MPa.
"""
import sys
import time

import numpy as np
import rollcon as rc

UPSIDE_DOWN = [[1, 0, 0], [0, -1, 0], [0, 0, -1]]


def with_halves(line):
    return np.sort(np.concatenate([line, 0.5 * (line[1:] + line[:-1])]))


def fine_at_ends(n, a, b):
    return 0.5 * (a + b) - 0.5 * (b - a) * np.cos(np.pi * np.arange(n + 1) / n)


def quad8(first, second, place):
    """Nodes place(a, b) and quad8 elements between lines of two coordinates, and the numbers of the nodes."""
    first, second = with_halves(first), with_halves(second)
    number, nodes = -np.ones((len(first), len(second)), int), []
    for i, a in enumerate(first):
        for j, b in enumerate(second):
            if not (i % 2 and j % 2):
                number[i, j] = len(nodes)
                nodes.append(place(a, b))
    steps = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))
    cells = [(i, j) for i in range(0, len(first) - 1, 2) for j in range(0, len(second) - 1, 2)]
    return np.array(nodes), np.array([[number[i + a, j + b] for a, b in steps] for i, j in cells]), number


def section(context, mesh, held, contact, young=210000, poisson=0.3):
    """A body that turns its section about the y axis."""
    nodes, elements, _ = mesh
    body = rc.Body(context, "section")
    body.set_nodes(nodes)
    body.add_elements("quad8", elements, 0)
    body.set_elastic(young, poisson)
    body.tag_faces_of_nodes(contact, 2)
    body.set_contact_faces([2])
    body.set_support(held, "xyz")
    body.revolve([0, 0, 0], [0, 1, 0])
    return body


# ------------------------------------------------------------------------------------ the paper's two rings

def rectangle(n, inner, outer, half_width):
    mesh = quad8(fine_at_ends(n, -half_width, half_width), fine_at_ends(n, inner, outer), lambda y, z: (0, y, z))
    return mesh, mesh[2][:, 0][mesh[2][:, 0] >= 0], mesh[2][:, -1][mesh[2][:, -1] >= 0]


def ring_by_section(context):
    mesh, bore, tread = rectangle(12, 25, 50, 4)
    return section(context, mesh, bore, tread, 1e4), len(mesh[0])


def ring_of_elements(context, kind):
    """The whole ring in hex20, or its surface in quad8, with 12 elements on 3 mm of the tread."""
    zone = np.linspace(-0.03, 0.03, 13)
    far = 0.03 + np.cumsum(np.geomspace(0.006, 1, 9)) / np.geomspace(0.006, 1, 9).sum() * (np.pi - 0.03)
    angle = with_halves(np.concatenate([zone, far, 2 * np.pi - far[-2::-1]]))[:-1]  # the last line is the first one
    y, r = with_halves(fine_at_ends(6, -4, 4)), with_halves(50 - np.geomspace(26, 1, 6) + 1)
    number, nodes = {}, []
    for i, a in enumerate(angle):
        for j, b in enumerate(y):
            for k, c in enumerate(r):
                outside = k in (0, len(r) - 1) or j in (0, len(y) - 1)
                if i % 2 + j % 2 + k % 2 < 2 and (kind == "fem" or outside):
                    number[i, j, k] = len(nodes)
                    nodes.append([c * np.sin(a), b, c * np.cos(a)])
    nodes = np.array(nodes)

    def of(i, j, k):
        return number[i % len(angle), j, k]
    edges = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))
    sides = ([(i, j) for i in range(0, len(angle), 2) for j in range(0, len(y) - 1, 2)],
             [(i, k) for i in range(0, len(angle), 2) for k in range(0, len(r) - 1, 2)])
    body = rc.Body(context, kind)
    body.set_nodes(nodes)
    if kind == "bem":
        n, m = len(r) - 1, len(y) - 1
        body.add_elements("quad8", [[of(i + a, j + b, n) for a, b in edges] for i, j in sides[0]], 0)
        body.add_elements("quad8", [[of(i + b, j + a, 0) for a, b in edges] for i, j in sides[0]], 0)
        body.add_elements("quad8", [[of(i + a, 0, k + b) for a, b in edges] for i, k in sides[1]], 0)
        body.add_elements("quad8", [[of(i + b, m, k + a) for a, b in edges] for i, k in sides[1]], 0)
    else:
        corners = [(a, b, c) for c in (0, 2) for a, b in edges[:4]]
        middles = [(a, b, c) for c in (0, 2) for a, b in edges[4:]] + [(a, b, 1) for a, b in edges[:4]]
        body.add_elements("hex20", [[of(i + a, j + b, k + c) for a, b, c in corners + middles]
                                    for i, j in sides[0] for k in range(0, len(r) - 1, 2)], 0)
    body.set_elastic(1e4, 0.3)
    radius = np.hypot(nodes[:, 0], nodes[:, 2])
    body.set_support(np.where(radius < 25.001)[0], "xyz")
    body.tag_faces_of_nodes(np.where((radius > 49.999) & (np.abs(nodes[:, 0]) < 6) & (nodes[:, 2] > 0))[0], 2)
    body.set_contact_faces([2])
    return body, len(nodes)


def rings():
    print("two rings (radii 25 and 50 mm, width 8 mm, E 10 GPa) roll on each other under 1233.85 N")
    print("  rings by            nodes   pressure in the middle   creepage    approach   seconds")
    for name in ("section", "hex20", "quad8"):
        context = rc.Context()
        began = time.process_time()
        ring, nodes = ring_by_section(context) if name == "section" else \
            ring_of_elements(context, "fem" if name == "hex20" else "bem")
        contact = rc.Contact(context, ring, ring)
        contact.set_pose(2, UPSIDE_DOWN, [0, 0, 100])
        contact.set_axes([0, 0, 50], [1, 0, 0], [0, 0, 1])
        contact.frame_rectangle("quad4", 24, 16, -1.2, 1.2, -4, 4)
        contact.set_friction(0.1)
        contact.set_rolling(10)
        contact.prescribe("normal", "force", 1233.85)
        contact.prescribe("longitudinal", "force", 0.06271 * 1233.85)
        contact.solve()
        pressure = contact.tractions()[:, 2].reshape(25, 17)[:, 8].min()
        depth, creep = contact.motion()[:2]
        print(f"  {name:16} {nodes:8}   {-pressure:12.2f} MPa      {1e3 * creep[0]:9.4f}e-3"
              f"   {depth:.5f}   {time.process_time() - began:6.1f}")


# ------------------------------------------------------------------------------------- a wheel with a web

def wheel_mesh():
    """Hub, web and rim of a wheel of 460 mm with a cylindrical tread: the half-width changes with the radius."""
    radius = np.concatenate([np.linspace(90, 130, 4), [145, 165, 190], np.linspace(220, 370, 6), [390, 402],
                             460 - np.geomspace(48, 4, 6), [460]])
    half_width = np.interp(radius, [90, 130, 190, 370, 402, 412, 460], [80, 80, 13, 11, 40, 65, 65])
    across = np.array([-1, -0.75, -0.5, -0.32, -0.16, 0, 0.16, 0.32, 0.5, 0.75, 1])
    return quad8(radius, across, lambda z, eta: (0, np.interp(z, radius, half_width) * eta, z))


def wheel():
    context = rc.Context()
    nodes, elements, number = wheel_mesh()
    elements = elements[:, [0, 3, 2, 1, 7, 6, 5, 4]]
    body = section(context, (nodes, elements, number), number[0][number[0] >= 0], number[-1][number[-1] >= 0])
    rail = rc.Body(context, "halfspace")
    rail.set_elastic(210000, 0.3)
    rail.set_profile_shape("60e1", [1])
    rail.extrude_profile([0, 0, 0], [1, 0, 0], [0, 0, -1])
    contact = rc.Contact(context, rail, body)
    contact.set_pose(2, UPSIDE_DOWN, [0, 30, 460])  # 30 mm off, so that the web bends
    contact.set_axes([0, 0, 0], [1, 0, 0], [0, 0, 1])
    contact.set_friction(0.3)
    contact.set_rolling(20000)
    contact.prescribe("normal", "force", 80000)
    contact.prescribe("longitudinal", "force", 8000)
    status = contact.solve()
    print(f"\nwheel with a web on a rail, 80 kN: {len(nodes)} nodes, {int(status)}; largest pressure "
          f"{contact.stat('max_pressure'):.0f} MPa, approach {contact.motion()[0]:.4f} mm")
    u, stress = contact.fields_at(2, nodes, "body")
    s = stress.T
    mises = np.sqrt(0.5 * ((s[0] - s[1]) ** 2 + (s[1] - s[2]) ** 2 + (s[2] - s[0]) ** 2)
                    + 3 * (s[3] ** 2 + s[4] ** 2 + s[5] ** 2))
    web = (nodes[:, 2] > 190) & (nodes[:, 2] < 370)
    print(f"largest stress of the web {mises[web].max():.1f} MPa (von Mises), which moves by up to "
          f"{np.abs(u[web]).max():.4f} mm")
    draw(nodes, elements, u, mises)


def draw(nodes, elements, u, mises):
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError:
        return
    scale = 200
    y, z = (nodes + scale * u)[:, 1], (nodes + scale * u)[:, 2]
    a, b, c, d, e, f, g, h = elements.T
    triangles = np.concatenate([np.stack(t, -1) for t in
                                ((a, e, h), (e, b, f), (f, c, g), (g, d, h), (e, f, g), (e, g, h))])
    figure, axes = plt.subplots(figsize=(5, 8))
    drawn = axes.tripcolor(y, z, triangles, mises, shading="gouraud", vmax=np.quantile(mises, 0.98), cmap="viridis")
    for element in elements:
        outline = element[[0, 4, 1, 5, 2, 6, 3, 7, 0]]
        axes.plot(nodes[outline, 1], nodes[outline, 2], color="0.8", linewidth=0.4, zorder=0)
        axes.plot(y[outline], z[outline], color="black", linewidth=0.25)
    axes.set_aspect("equal")
    axes.set_xlabel("y, mm")
    axes.set_ylabel("radius, mm")
    axes.set_title(f"displacements {scale} times")
    figure.colorbar(drawn, label="von Mises's stress, MPa")
    figure.savefig("section_bodies_wheel.png", dpi=120, bbox_inches="tight")
    print("drawn: section_bodies_wheel.png")


# --------------------------------------------------------------------------------- a roller between two rings

def roller():
    context = rc.Context()
    mesh, bore, tread = rectangle(8, 40, 60, 12)
    inner = section(context, mesh, bore, tread)
    mesh, bore, tread = rectangle(10, 1, 10, 8)
    pin = section(context, mesh, bore, tread)
    mesh, raceway, outside = rectangle(8, 80, 95, 12)
    outer = rc.Body(context, "section")
    outer.set_nodes(mesh[0])
    outer.add_elements("quad8", mesh[1], 0)
    outer.set_elastic(210000, 0.3)
    outer.tag_faces_of_nodes(raceway, 2)
    outer.tag_faces_of_nodes(outside, 3)
    outer.set_springs(3, [100, 100, 100])                # a soft housing, N/mm^3
    outer.set_contact_faces([2])
    outer.revolve([0, 0, 0], [0, 1, 0])
    print("\na roller of 20 x 16 mm between two rings, 10 kN")
    for name, ring, place in (("inner", inner, 60), ("outer", outer, 80)):
        # The roller stands on the inner ring; it hangs on the outer one, which is seen from below.
        turn, top = ([[1, 0, 0], [0, -1, 0], [0, 0, -1]], 70) if name == "inner" else (np.eye(3), 70)
        contact = rc.Contact(context, *((ring, pin) if name == "inner" else (pin, ring)))
        contact.set_pose(2 if name == "inner" else 1, turn, [0, 0, top])
        contact.set_axes([0, 0, place], [1, 0, 0], [0, 0, 1])
        contact.frame_rectangle("quad4", 24, 32, -0.6, 0.6, -8, 8)
        contact.set_friction(0)
        contact.prescribe("normal", "force", 10000)
        status = contact.solve()
        u = contact.body_displacements(1 if name == "inner" else 2)
        print(f"  on the {name} ring: largest pressure {contact.stat('max_pressure'):.0f} MPa, approach "
              f"{contact.motion()[0]:.4f} mm, its raceway moves by up to {np.abs(u[:, 2]).max():.4f} mm "
              f"({int(status)})")


if __name__ == "__main__":
    for part in sys.argv[1:] or ("rings", "wheel", "roller"):
        {"rings": rings, "wheel": wheel, "roller": roller}[part]()
