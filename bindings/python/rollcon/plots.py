"""Pictures by matplotlib, one call each. They draw into the axes given, or into new ones, and return them; nothing is
shown or saved before matplotlib.pyplot's show() or the figure's savefig() is called. The methods plot_... of Contact,
Body and WheelRail call these; matplotlib is imported by the first of them."""

from __future__ import annotations

import numpy as np

from . import _api
from ._library import enumerator

STICK_COLOUR, SLIP_COLOUR = "#1f4e9c", "#c8442b"


def _axes(ax, **options):
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot as pyplot
    except ImportError as error:
        raise ImportError("pictures need matplotlib (Debian: python3-matplotlib, elsewhere pip install matplotlib)"
                          ) from error
    return pyplot.subplots(layout="constrained", **options)[1]


def _nodes(contact):
    """x, y of the nodes in the contact's axes, and what is in contact."""
    point = contact.field("point")
    state = contact.node_status()
    if not len(state):
        raise ValueError("nothing to draw: the contact has no nodes; solve it first")
    return point[:, 0], point[:, 1], (state == _api.STICK) | (state == _api.SLIP), state


def _triangles(x, y, touching):
    """Triangles between nodes, without those that bridge patches; None for nodes on one line."""
    from matplotlib.tri import Triangulation
    try:
        mesh = Triangulation(x, y)
    except (RuntimeError, ValueError):
        return None
    corners = mesh.triangles
    side = np.max([np.hypot(x[corners[:, i]] - x[corners[:, i - 1]], y[corners[:, i]] - y[corners[:, i - 1]])
                   for i in range(3)], axis=0)
    mesh.set_mask((side > 4 * np.median(side)) & ~touching[corners].all(axis=1))
    return mesh


def _label(ax, x, y):
    """Both axes in one scale, unless the contact is so slender that nothing would be seen."""
    if 0.1 < np.ptp(x) / max(np.ptp(y), 1e-300) < 10:
        ax.set_aspect("equal")
    ax.set_xlabel("x, rolling direction")
    ax.set_ylabel("y")
    return ax


def _over_plane(contact, values, touching, x, y, ax, label, cmap):
    ax = _axes(ax)
    mesh = _triangles(x, y, touching)
    if mesh is None:
        raise ValueError("the nodes lie on one line: plot_section draws those")
    drawn = ax.tripcolor(mesh, values, shading="gouraud", cmap=cmap)
    ax.figure.colorbar(drawn, ax=ax, label=label)
    return _label(ax, x[touching], y[touching])


def pressure(contact, ax=None, cmap="viridis"):
    """Pressure over the contact."""
    x, y, touching, _ = _nodes(contact)
    return _over_plane(contact, np.where(touching, contact.field("pressure"), 0), touching, x, y, ax, "pressure", cmap)


def tractions(contact, ax=None, arrows=400):
    """Tangential tractions on body 1 as arrows over where the nodes stick and slip; about so many arrows at most."""
    x, y, touching, state = _nodes(contact)
    t = contact.tractions()
    ax = _axes(ax)
    for number, colour, name in ((_api.STICK, STICK_COLOUR, "stick"), (_api.SLIP, SLIP_COLOUR, "slip")):
        there = state == number
        ax.plot(x[there], y[there], "o", ms=4, mew=0, alpha=0.5, color=colour, label=f"{name}, {there.sum()} nodes")
    chosen = np.flatnonzero(touching)
    chosen = chosen[::max(1, len(chosen) // arrows)]
    ax.quiver(x[chosen], y[chosen], t[chosen, 0], t[chosen, 1], angles="xy", width=0.002, pivot="tail")
    ax.legend(loc="upper right", fontsize="small")
    return _label(ax, x[touching], y[touching])


def section(contact, y=None, ax=None):
    """Pressure, longitudinal and lateral traction, and the limit of friction, along the rolling direction through the
    nodes nearest to y; None: through the largest pressure."""
    px, py, touching, _ = _nodes(contact)
    p, t, mu = contact.field("pressure"), contact.tractions(), contact.field("friction")
    wanted = py[np.argmax(np.where(touching, p, -np.inf))] if y is None else y
    line = py[np.argmin(np.abs(py - wanted))]
    there = np.flatnonzero(np.abs(py - line) <= 1e-6 * max(np.ptp(py), np.ptp(px)))
    if len(there) < 4:  # no line of nodes: a band as wide as nodes are apart
        there = np.flatnonzero(np.abs(py - line) <= np.ptp(py) / np.sqrt(len(py)))
    there = there[np.argsort(px[there])]
    ax = _axes(ax)
    limit = np.where(touching, mu * p, 0)[there]
    ax.fill_between(px[there], -limit, limit, color="0.9", label="limit of friction")
    ax.plot(px[there], p[there], "k-", label="pressure")
    ax.plot(px[there], t[there, 0], "-", color=STICK_COLOUR, label="longitudinal traction")
    ax.plot(px[there], t[there, 1], "-", color=SLIP_COLOUR, label="lateral traction")
    ax.set_xlabel("x, rolling direction")
    line = 0 if abs(line) < 1e-9 * np.ptp(px) else line
    ax.set_title(f"section at y = {line:.4g}", fontsize="medium")
    ax.legend(fontsize="small", loc="lower center", ncols=2)
    ax.margins(y=0.15)
    return ax


def creep_curve(contact, creepages, direction="longitudinal", ax=None):
    """Forces over a list of creepages (or spins) in a direction that is prescribed by motion, as is the standard. Each is
    solved; at the end the contact is solved again as it was. Forces are over the normal force."""
    names = ("longitudinal", "lateral", "normal", "spin")
    direction = names[enumerator(direction, "direction", "direction") - 1]
    if direction == "normal":
        raise ValueError("direction is 'normal'; allowed: longitudinal, lateral, spin")
    contact.solve()
    before = dict(zip(("longitudinal", "lateral", "spin"), contact.motion()[1]))
    creepages, force = np.asarray(creepages, dtype=float), []
    try:
        for value in creepages:
            contact.set_creep(**{**before, direction: value})
            contact.solve()
            force.append(contact.resultant()[0])
    finally:
        contact.set_creep(**before)
        contact.solve()
    force = np.array(force).reshape(-1, 3)
    force = force / np.abs(force[:, 2:])
    ax = _axes(ax)
    ax.plot(creepages, force[:, 0], "o-", ms=3, color=STICK_COLOUR, label="longitudinal force")
    ax.plot(creepages, force[:, 1], "s-", ms=3, color=SLIP_COLOUR, label="lateral force")
    ax.axhline(0, color="0.7", lw=0.8)
    ax.set_xlabel("spin" if direction == "spin" else f"{direction} creepage")
    ax.set_ylabel("force over normal force")
    ax.legend(fontsize="small")
    return ax


def profile(body, ax=None, points=400, **line):
    """The profile of a body: y to the right, z down as the field draws it."""
    at = np.array([body.profile_point(s)[0] for s in np.linspace(0, body.profile_length(), points)])
    ax = _axes(ax)
    first = not ax.lines
    ax.plot(at[:, 0], at[:, 1], **line)
    if first:
        ax.set_aspect("equal")
        ax.invert_yaxis()
        ax.set_xlabel("y")
        ax.set_ylabel("z, down")
    return ax


def patches(wheelrail, ax=None):
    """Where the wheel touches: each patch at its place in the track, y to the right and z down, at the end of a line along
    its normal, as long as its force; the legend has the numbers."""
    ax = _axes(ax)
    force = [wheelrail.patch_stat(k, "normal_force") for k in range(wheelrail.patch_count)]
    for k, normal in enumerate(force):
        y, z, angle = (wheelrail.patch_stat(k, name) for name in ("y", "z", "angle"))
        length = 10 * normal / max(force)
        ax.plot([y + length * np.sin(angle), y], [z - length * np.cos(angle), z], "-", marker=".", markevery=[1],
                label=f"patch {k}: {normal:.4g}, angle {angle:.3f}")
    ax.set_xlabel("y in the track")
    ax.set_ylabel("z, down")
    ax.set_aspect("equal", adjustable="datalim")
    ax.margins(0.4)
    ax.invert_yaxis()
    ax.legend(fontsize="small")
    return ax
