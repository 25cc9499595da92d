"""A wheel and a rail wear each other over 10,000 km of hunting: S1002 on 60E1, both wheels alike. What is worn off and
the equivalent conicity are printed every 1000 km; the worn profiles are written to worn_wheel.txt and worn_rail.txt
and, where matplotlib is there, pictures to worn_wheel.png. An argument is another distance, in km. Units: mm, N, s.

The line is short and busy: 4 km, on which 240 such wheels run, so that each place of the rail sees 60 wheels for every
km that one of them runs.

The motion is a sine of the wheelset, of its own wavelength at each amplitude, sampled at equal phases; amplitudes have
weights. Wear: rates of the steel R8T by regimes of T-gamma (Braghin, Lewis, Dwyer-Joyce and Bruni, Wear 261, 2006). The
profiles are worn in steps of at most 0.02 mm and smoothed over 4 mm, which keeps the volume."""

import sys
import time

import numpy as np
import rollcon as rc

PRINT_EVERY = 1e9  # 1000 km
RADIUS, LOAD, SPEED, FRICTION = 460.0, 80e3, 30e3, 0.3
AMPLITUDES, SHARES, PHASES = (1.5, 3.0, 4.5), (0.5, 0.35, 0.15), 8
POINTS, DEEPEST, SMOOTHING = 401, 0.02, 4.0
LINE, WHEELS = 4e6, 240
# The rates are over the density: 5.3 T-gamma/A ug/m/mm^2 at first, 55.12 between T-gamma/A = 10.4 and 77.2 N/mm^2, then
# 61.9 more for each N/mm^2.
MASS = 7850e3  # ug/mm^3 times mm/m
T_GAMMA = [10.4, 55.12 / MASS, 77.2, 55.12 / MASS, 87.2, (55.12 + 619) / MASS]


def half_space(context):
    body = rc.Body(context, "halfspace")
    body.set_elastic(2.1e5, 0.28)
    return body


def wheelset(context, wheel, rail):
    """Left and right wheel of this profile on their rails."""
    pair = []
    for side in ("left", "right"):
        one = rc.WheelRail(context, wheel, rail, side)
        one.set_track(1435, 14, 0.025)
        one.set_wheelset(1360, -70, RADIUS)
        one.set_friction(FRICTION)
        one.prescribe_vertical("by_force", LOAD)
        pair.append(one)
    return pair


def hunting(left, right):
    """Positions, velocities and weights of the spectrum."""
    phase = 2 * np.pi * (np.arange(PHASES) + 0.5) / PHASES
    _, wavelength = rc.conicity(left, right, AMPLITUDES)
    positions, velocities, weights = [], [], []
    for amplitude, length, share in zip(AMPLITUDES, wavelength, SHARES):
        k = 2 * np.pi / length
        y, slope = amplitude * np.sin(phase), k * amplitude * np.cos(phase)
        order = np.argsort(y)
        roll = np.empty(PHASES)
        roll[order] = rc.contact_points(left, right, y[order]).roll
        zero = np.zeros(PHASES)
        positions.append(np.column_stack([zero, y, zero, roll, slope, zero]))
        velocities.append(np.column_stack([zero + SPEED, SPEED * slope, zero, zero, -SPEED * k * k * y,
                                           zero - SPEED / RADIUS]))
        weights.append(np.full(PHASES, share / PHASES))
    return np.vstack(positions), np.vstack(velocities), np.concatenate(weights)


def points_of(body):
    return np.array([body.profile_point(s)[0] for s in np.linspace(0, body.profile_length(), POINTS)])


class Worn:
    """A body's profile as it wears."""

    def __init__(self, context, shape, side, passes):
        """side: of the body, as rc.wear_profile takes it; passes: of the other body, per length that a wheel runs."""
        self.body, self.side, self.passes = half_space(context), side, passes
        self.body.set_profile_shape(shape, [1.0])
        self.context, self.volume = context, 0.0
        self.fresh = self.points = points_of(self.body)

    def step(self, depth, distance):
        """What would be worn over the distance, and as much of it as the deepest step allows."""
        return rc.wear_profile(self.points, depth * self.passes, self.side, distance, DEEPEST, SMOOTHING)

    def take(self, depth, volume, distance):
        self.points, _ = self.step(depth, distance)
        self.volume += distance * volume * self.passes
        self.body = half_space(self.context)
        self.body.set_profile(self.points)
        self.points = points_of(self.body)

    def worn(self, points):
        """Depth along z at the places of the fresh profile; z points down."""
        order = np.argsort(points[:, 0])
        return self.side * (np.interp(self.fresh[:, 0], points[order, 0], points[order, 1]) - self.fresh[:, 1])


def wear(context, distance):
    wheel = Worn(context, "s1002", -1, 1 / (2 * np.pi * RADIUS))
    rail = Worn(context, "60e1", 1, WHEELS / LINE)
    gone, steps, conicities, profiles = 0.0, 0, [], []
    print("   km   worn off, mm^2: wheel, rail   deepest, mm: wheel, rail   conicity at 1.5, 3, 4.5 mm")
    while True:
        left, right = wheelset(context, wheel.body, rail.body)
        conicity, _ = rc.conicity(left, right, AMPLITUDES)
        conicities.append((gone, *conicity))
        if gone >= PRINT_EVERY * len(profiles):
            profiles.append((gone / 1e6, wheel.points, rail.points))
            print("{:6.0f} {:14.3f} {:11.3f} {:14.3f} {:9.3f} {:12.4f} {:7.4f} {:7.4f}".format(
                gone / 1e6, wheel.volume, rail.volume, wheel.worn(wheel.points).max() + 0, rail.worn(rail.points).max() + 0,
                *conicity), flush=True)
        if gone >= distance:
            return wheel, rail, profiles, np.array(conicities), steps
        positions, velocities, weights = hunting(left, right)
        # Both wheels run through the same positions.
        found = right.find_wear(positions, velocities, "t_gamma", T_GAMMA, POINTS, weights=weights)
        goal = min(PRINT_EVERY * len(profiles), distance)
        until = goal - gone
        taken = min(wheel.step(found.wheel, until)[1], rail.step(found.rail, until)[1])
        wheel.take(found.wheel, found.volumes[0], taken)
        rail.take(found.rail, found.volumes[1], taken)
        gone = goal if taken == until else gone + taken
        steps += 1


def draw(wheel, rail, profiles, conicities):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    figure, axes = pyplot.subplots(3, 2, figsize=(11, 9), layout="constrained")
    shades = pyplot.get_cmap("viridis")
    for column, (body, name) in enumerate(((wheel, "wheel"), (rail, "rail"))):
        profile, worn = axes[0, column], axes[1, column]
        for km, *points in profiles[::2]:
            colour = shades(0.9 * km / max(profiles[-1][0], 1))
            points = points[column]
            profile.plot(points[:, 0], -points[:, 1], color=colour, lw=0.8)
            worn.plot(body.fresh[:, 0], body.worn(points), color=colour, lw=1, label=f"{km:.0f} km")
        profile.set(xlabel="y, mm", ylabel="height, mm", title=f"profile of the {name}", aspect="equal")
        worn.set(xlabel="y, mm", ylabel="worn, mm", title=f"wear of the {name}")
        worn.legend(fontsize=7)
    axes[1, 0].set(xlim=(-45, 50))
    axes[1, 1].set(xlim=(-36, 36), ylim=(0, None))
    conicity, change = axes[2]
    for amplitude, column in zip(AMPLITUDES, conicities[:, 1:].T):
        conicity.plot(conicities[:, 0] / 1e6, column, label=f"{amplitude} mm")
        change.plot(conicities[:, 0] / 1e6, column - column[0], label=f"{amplitude} mm")
    conicity.set(xlabel="distance, km", ylabel="equivalent conicity", title="conicity at amplitudes of", ylim=(0, None))
    change.set(xlabel="distance, km", ylabel="change", title="its change")
    conicity.legend(fontsize=7)
    figure.savefig("worn_wheel.png", dpi=110)


def main():
    distance = 1e6 * float(sys.argv[1]) if len(sys.argv) > 1 else 1e10
    began = time.perf_counter()
    with rc.Context() as context:
        wheel, rail, profiles, conicities, steps = wear(context, distance)
        wheel.body.write_profile("worn_wheel.txt", 1.0)
        rail.body.write_profile("worn_rail.txt", 1.0)
    print(f"{steps} steps, {time.perf_counter() - began:.0f} s", file=sys.stderr)
    try:
        draw(wheel, rail, profiles, conicities)
    except ImportError:
        print("no pictures without matplotlib", file=sys.stderr)


if __name__ == "__main__":
    main()
