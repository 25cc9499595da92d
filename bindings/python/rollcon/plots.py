"""Draws pictures by matplotlib, one call each. They draw into the axes given, or into new ones, and return them;
nothing is shown or saved before matplotlib.pyplot's show() or the figure's savefig() is called. The methods plot_...
of Contact, Body and WheelRail call these; matplotlib is imported by the first of them."""

from __future__ import annotations

import os

import numpy as np

from . import _api, wheelrail as wheelrail_module
from ._library import RollconError, enumerator
from .stresses import stress_invariants

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
    """Returns x, y of the nodes in the contact's axes, and what is in contact."""
    point = contact.field("point")
    state = contact.node_states()
    if not len(state):
        raise ValueError("nothing to draw: the contact has no nodes; solve it first")
    return point[:, 0], point[:, 1], (state == _api.STICK) | (state == _api.SLIP), state


def _triangles(x, y, touching):
    """Returns triangles between nodes, without those that bridge patches; None for nodes on one line."""
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
    """Puts both axes in one scale, unless the contact is so slender that nothing would be seen."""
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
    """Draws the pressure over the contact."""
    x, y, touching, _ = _nodes(contact)
    return _over_plane(contact, np.where(touching, contact.field("pressure"), 0), touching, x, y, ax, "pressure", cmap)


def tractions(contact, ax=None, arrows=400):
    """Draws tangential tractions on body 1 as arrows over where the nodes stick and slip; about so many arrows at
    most."""
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
    """Draws pressure, longitudinal and lateral traction, and the limit of friction, along the rolling direction
    through the nodes nearest to y; None: through the largest pressure."""
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


def stress(contact, which=1, measure="von_mises", y=None, ax=None, cmap="inferno"):
    """Draws a measure of stress, von_mises, shear or orthogonal_shear, below a half-space in the plane of the rolling
    direction and the depth, at y or through the place of the largest, which a cross marks."""
    if measure not in ("von_mises", "shear", "orthogonal_shear"):
        raise ValueError(f"measure is {measure!r}; allowed: von_mises, shear, orthogonal_shear")
    value, place = contact.find_stress(which, measure)
    x, ys, touching, _ = _nodes(contact)
    middle, half = (x[touching].max() + x[touching].min()) / 2, np.ptp(x[touching]) / 2
    depth = 1.5 * max(min(half, np.ptp(ys[touching]) / 2), abs(place[2]))
    x, z = np.meshgrid(middle + 2 * half * np.linspace(-1, 1, 81), depth * np.linspace(0, 1, 41) ** 1.5)
    side = 1 if place[2] > 0 else -1
    points = np.stack([x, np.full_like(x, place[1] if y is None else y), side * z], axis=-1).reshape(-1, 3)
    found = contact.fields_at(which, points)[1]
    shown = (np.abs(found[:, 4]) if measure == "orthogonal_shear"
             else stress_invariants(found)[1 if measure == "von_mises" else 2])
    ax = _axes(ax)
    drawn = ax.contourf(x, z, shown.reshape(x.shape), 12, cmap=cmap)
    ax.figure.colorbar(drawn, ax=ax, label=measure.replace("_", " "))
    if y is None:
        ax.plot(place[0], abs(place[2]), "c+", ms=10)
        ax.set_title(f"{value:.4g} at depth {abs(place[2]):.3g}", fontsize="medium")
    ax.set_xlabel("x, rolling direction")
    ax.set_ylabel("depth")
    ax.invert_yaxis()
    return ax


def creep_curve(contact, creepages, direction="longitudinal", ax=None):
    """Draws forces over a list of creepages (or spins) in a direction that is prescribed by motion, which is the
    standard. Each is solved; at the end the contact is solved again in its first state. Forces are over the normal
    force."""
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
    """Draws the profile of a body: y to the right, z down, which is the field's convention."""
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


def _curve(body, points):
    """Returns points and curvatures at equal arc lengths of a profile."""
    at = [body.profile_point(s) for s in np.linspace(0, body.profile_length(), points)]
    return np.array([p for p, _, _ in at]), np.array([c for _, _, c in at])


def _distance(point, line):
    """Returns the distance of a point from a line through points."""
    along, off = np.diff(line, axis=0), point - line[:-1]
    part = np.clip((off * along).sum(axis=1) / (along * along).sum(axis=1), 0, 1)
    return np.hypot(*(off - part[:, None] * along).T).min()


def filtered(context, profile, filter_length, ax=None, unit=1.0, mirror=0, points=1000):
    """Draws the curvature of a measured profile over y before and after its filter. profile: the name of a file
    (Body.read_profile, with unit and mirror), or points[n, 2] (Body.set_profile); filter_length: one length or several.
    The legend has how far each filter moves the curve at most, and the largest curvature after it."""
    from .body import Body

    def read(length):
        body = Body(context, "rigid")
        if isinstance(profile, (str, os.PathLike)):
            body.read_profile(profile, unit, mirror, length)
        else:
            body.set_profile(profile, length)
        return _curve(body, points)

    lengths = np.atleast_1d(filter_length)
    if not (lengths > 0).all():
        raise ValueError(f"filter_length is {filter_length}; allowed: lengths above 0")
    raw, curvature = read(0)
    ax = _axes(ax)
    ax.plot(raw[:, 0], curvature, color="0.7", linewidth=0.8, label="no filter")
    most = 0
    for length in lengths:
        at, after = read(length)
        moved = max(_distance(p, raw) for p in at[:: max(points // 200, 1)])
        most = max(most, np.abs(after).max())
        largest = np.abs(after).max()
        ax.plot(at[:, 0], after, label=f"filter {length:g}: moves by {moved:.2g}, curvature up to {largest:.3g}")
    ax.set_ylim(-1.5 * most, 1.5 * most)
    ax.set_xlabel("y")
    ax.set_ylabel("curvature")
    ax.legend()
    return ax


def patches(wheelrail, ax=None, points=2000):
    """Draws wheel and rail in the track where they touch, y to the right and z down. The largest pressure of each
    line of nodes of a patch is drawn along the rail, as a height over its tangent; a patch without nodes (Hertzian)
    is a line along its normal. The legend has the numbers."""
    ax = _axes(ax)
    count = wheelrail.patch_count
    if not count:
        raise ValueError("nothing to draw: the wheel has no patch; solve it first, where it touches its rail")
    stat = [{name: wheelrail.patch_stat(k, name) for name in ("y", "z", "angle", "normal_force", "max_pressure")}
            for k in range(count)]
    across = [_pressure_across(wheelrail, k) for k in range(count)]
    y = np.concatenate([[s["y"] for s in stat], *[a[0][:, 0] for a in across]])
    half = max(1.25 * np.ptp(y), 5e-3 * np.abs(y).max())  # half size of what is drawn
    middle = (y.min() + y.max()) / 2
    low, high = middle - half, middle + half
    outlines = []
    for body, colour, name in ((1, "0.45", "wheel"), (2, "k", "rail")):
        at = np.array([wheelrail.profile_point(body, share) for share in np.linspace(0, 1, points)])
        ax.plot(at[:, 0], at[:, 1], "-", color=colour, lw=1.2, label=name)
        outlines.append(at[(at[:, 0] > low) & (at[:, 0] < high)])
    greatest = max(s["max_pressure"] for s in stat)
    for k, (s, (place, p, up)) in enumerate(zip(stat, across)):
        height = 0.5 * half
        if len(p):
            tip = place + height * (p / greatest)[:, None] * up
        else:
            place = np.array([[s["y"], s["z"]]] * 2)
            tip = place + np.array([[0], [height * s["max_pressure"] / greatest]]) * [np.sin(s["angle"]),
                                                                                  -np.cos(s["angle"])]
        ax.fill(*np.concatenate([place, tip[::-1]]).T, alpha=0.6, lw=1.5, color=f"C{k}",
                label=f"patch {k}: {s['normal_force']:.4g}, pressure {s['max_pressure']:.4g}, angle {s['angle']:.3f}")
    z = np.concatenate([o[:, 1] for o in outlines])
    ax.set_xlim(low, high)
    ax.set_ylim(z.max() + 0.1 * half, min(z.min(), min(s["z"] for s in stat) - 0.6 * half))
    ax.set_aspect("equal", adjustable="box")
    ax.set_xlabel("y in the track")
    ax.set_ylabel("z, down")
    ax.legend(fontsize="small", loc="lower center", bbox_to_anchor=(0.5, 1.02))
    return ax


def _pressure_across(wheelrail, patch):
    """Returns places in the track of the lines of nodes across a patch, the largest pressure of each, and the
    directions out of the rail: the lines of a conformal patch lie along the profiles."""
    origin, axes = wheelrail.patch_axes(patch)
    t2, n = np.reshape(axes, (3, 3))[1:, 1:]
    contact = wheelrail.contact(patch)
    try:
        (y, z), p = contact.field("point")[:, 1:].T, contact.field("pressure")
    except RollconError:
        return np.empty((0, 2)), np.empty(0), np.empty((0, 2))
    spacing = 1e-9 * np.ptp(y)
    lines, first, line = np.unique(np.round(y / spacing), return_index=True, return_inverse=True)
    lines, z = lines * spacing, z[first]
    greatest = np.zeros(len(lines))
    np.maximum.at(greatest, line, p)
    slope = np.gradient(z, lines)[:, None]
    up = (slope * t2 - n) / np.hypot(slope, 1)
    return np.asarray(origin)[1:] + lines[:, None] * t2 + z[:, None] * n, greatest, up


def contact_points(left, right, shift, ax=None):
    """Draws where both wheels of a wheelset touch, y on their profiles, over its lateral shift[n]."""
    ax = _axes(ax)
    found = wheelrail_module.contact_points(left, right, shift)
    for touch, marker, name in ((found.left, "<", "left"), (found.right, ">", "right")):
        ax.plot(found.shift, touch.wheel_y, marker, ms=3, label=f"{name} wheel")
    ax.set_ylabel("y on the wheel's profile")
    return _over_shift(ax)


def rolling_radius_difference(left, right, shift, ax=None):
    """Draws the rolling radius on the right less that on the left, over the wheelset's lateral shift[n]."""
    ax = _axes(ax)
    found = wheelrail_module.contact_points(left, right, shift)
    ax.plot(found.shift, found.difference, "k-", label="right less left")
    ax.set_ylabel("rolling-radius difference")
    return _over_shift(ax)


def _over_shift(ax):
    ax.set_xlabel("lateral shift of the wheelset")
    ax.grid(alpha=0.3)
    ax.legend(fontsize="small")
    return ax


def passage(wheelrail, positions, velocities, ax=None, points=400):
    """Solves positions[n, 6] with velocities ([n, 6], or [6] for all) one after the other, and draws a wheel that
    passes a rail: the rail from above, darker where it is higher, with the patches, whose area grows with the normal
    force; below that, over the wheelset's x, each patch's normal force and the force on the rail. ax: two axes, or
    None. Returns both. wheelrail is left at the last position."""
    positions = np.asarray(positions, dtype=float).reshape(-1, 6)
    velocities = np.broadcast_to(np.asarray(velocities, dtype=float), positions.shape)
    names = ("x", "y", "share", "normal_force", "max_pressure")
    sections, patch, force = [], [], []
    for position, velocity in zip(positions, velocities):
        wheelrail.set_position(position)
        wheelrail.set_velocity(velocity)
        wheelrail.solve()
        sections.append([wheelrail.profile_point(_api.RAIL, share) for share in np.linspace(0, 1, points)])
        force.append(-wheelrail.resultant()[0])
        patch += [[position[0], *(wheelrail.patch_stat(k, name) for name in names)]
                  for k in range(wheelrail.patch_count)]
    if not patch:
        raise ValueError("nothing to draw: the wheel touches the rail nowhere")
    sections, force, (at, x, y, share, normal, pressure) = np.array(sections), np.array(force), np.array(patch).T
    if ax is None:
        axes = _axes(None, nrows=2, sharex=True, figsize=(8, 7))
    else:
        axes = np.ravel(ax)
        if len(axes) != 2:
            raise ValueError(f"{len(axes)} axes; allowed: two, for the rail from above and for forces")
    across = np.linspace(sections[:, :, 0].min(), sections[:, :, 0].max(), points)
    top = np.array([_seen_from_above(section, across) for section in sections])
    depth = 0.2 * np.ptp(across)  # what lies deeper is white
    axes[0].pcolormesh(positions[:, 0], across, top.T, shading="nearest", cmap="Greys_r", rasterized=True,
                       vmin=np.nanmin(top) - depth, vmax=np.nanmin(top) + depth / 2)
    drawn = axes[0].scatter(x, y, 120 * share * normal / normal.max(), pressure, cmap="viridis", alpha=0.8, lw=0)
    axes[0].figure.colorbar(drawn, ax=axes[0], label="largest pressure")
    axes[0].set_ylabel("y in the track")
    axes[0].invert_yaxis()
    axes[1].plot(at, share * normal, "k.", label="normal force of a patch")
    for component, name in zip(force.T, ("longitudinal", "lateral", "vertical")):
        axes[1].plot(positions[:, 0], component, label=f"{name}, on the rail")
    axes[1].set_xlabel("x of the wheelset")
    axes[1].set_ylabel("force")
    axes[1].legend(fontsize="small")
    axes[1].grid(alpha=0.3)
    return axes


def _seen_from_above(section, y):
    """Returns the least z that a section[n, 2] has at each y, NaN beside it. Steps far longer than the others bridge
    what the section does not have."""
    step = np.diff(section, axis=0)
    size = np.hypot(*step.T)
    top = np.full(len(y), np.nan)
    own = size < 20 * np.median(size)
    for (y0, z0), (dy, dz) in zip(section[:-1][own], step[own]):
        if dy == 0:
            continue
        there = (y >= min(y0, y0 + dy)) & (y <= max(y0, y0 + dy))
        top[there] = np.fmin(top[there], z0 + (y[there] - y0) / dy * dz)
    return top


def conicity(left, right, amplitude, ax=None):
    """Draws the equivalent conicity (EN 15302) over the amplitude[n] of the wheelset's motion."""
    ax = _axes(ax)
    ax.plot(np.asarray(amplitude), wheelrail_module.conicity(left, right, amplitude)[0], "k.-")
    ax.set_xlabel("amplitude of the lateral motion")
    ax.set_ylabel("equivalent conicity")
    ax.set_ylim(bottom=0)
    ax.grid(alpha=0.3)
    return ax
