"""A wheel wears on a rail over 10,000 km of hunting: S1002 on 60E1, both wheels alike. Its profile, what is worn off and
its equivalent conicity are printed every 1000 km; the worn profile is written to worn_wheel.txt and, where matplotlib
is there, pictures to worn_wheel.png. An argument is another distance, in km. Units: mm, N, s.

The motion is a sine of the wheelset, of its own wavelength at each amplitude, sampled at equal phases; amplitudes have
weights. Wear: rates of the steel R8T by regimes of T-gamma (Braghin, Lewis, Dwyer-Joyce and Bruni, Wear 261, 2006). The
profile is worn in steps of at most 0.02 mm and smoothed over 4 mm, which keeps the volume."""

import sys
import time

import numpy as np
import rollcon as rc

PRINT_EVERY = 1e9  # 1000 km
RADIUS, LOAD, SPEED, FRICTION = 460.0, 80e3, 30e3, 0.3
AMPLITUDES, SHARES, PHASES = (1.5, 3.0, 4.5), (0.5, 0.35, 0.15), 8
POINTS, DEEPEST, SMOOTHING = 401, 0.02, 4.0
# Over the density: 5.3 T-gamma/A ug/m/mm^2 at first, 55.12 between T-gamma/A = 10.4 and 77.2 N/mm^2, then 61.9 more for each N/mm^2.
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


def wear(context, distance):
    rail = half_space(context)
    rail.set_profile_shape("60e1", [1.0])
    wheel = half_space(context)
    wheel.set_profile_shape("s1002", [1.0])
    fresh = points_of(wheel)
    gone, volume, steps, history = 0.0, 0.0, 0, []
    rows, profiles = [], []
    print("   km    worn off, mm^2   deepest, mm   conicity at 1.5, 3, 4.5 mm")
    while True:
        left, right = wheelset(context, wheel, rail)
        conicity, _ = rc.conicity(left, right, AMPLITUDES)
        history.append((gone, *conicity))
        points = points_of(wheel)
        if gone >= PRINT_EVERY * len(rows):
            depth = np.max(np.interp(points[:, 0], fresh[:, 0], fresh[:, 1]) - points[:, 1])
            rows.append((gone / 1e6, volume, depth, *conicity))
            print("{:6.0f} {:13.3f} {:13.3f} {:13.4f} {:7.4f} {:7.4f}".format(*rows[-1]), flush=True)
            profiles.append((gone / 1e6, points))
        if gone >= distance:
            return fresh, wheel, profiles, np.array(history), steps
        spectrum = hunting(left, right)
        found = right.find_wear(*spectrum[:2], "t_gamma", T_GAMMA, POINTS, weights=spectrum[2])
        # Both wheels run through the same positions; a pass of each point is one revolution.
        revolution = 2 * np.pi * RADIUS
        until = min(PRINT_EVERY * len(rows), distance)
        points, taken = rc.wear_profile(points, found.wheel / revolution, -1, until - gone, DEEPEST, SMOOTHING)
        gone = until if taken == until - gone else gone + taken
        volume += taken * found.volumes[0] / revolution
        steps += 1
        wheel = half_space(context)
        wheel.set_profile(points)


def draw(fresh, profiles, history):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    figure, (profile, worn, conicity) = pyplot.subplots(3, 1, figsize=(7, 9), layout="constrained")
    shades = pyplot.get_cmap("viridis")
    for km, points in profiles[::2]:
        colour = shades(0.9 * km / 1e4)
        profile.plot(points[:, 0], -points[:, 1], color=colour, lw=0.8)
        worn.plot(points[:, 0], np.interp(points[:, 0], fresh[:, 0], fresh[:, 1]) - points[:, 1], color=colour, lw=1,
                  label=f"{km:.0f} km")
    profile.set(xlabel="y, mm", ylabel="height, mm", title="profile", aspect="equal")
    worn.set(xlabel="y, mm", ylabel="worn, mm", title="wear", xlim=(-45, 50))
    worn.legend(fontsize=7)
    for amplitude, column in zip(AMPLITUDES, history[:, 1:].T):
        conicity.plot(history[:, 0] / 1e6, column, label=f"{amplitude} mm")
    conicity.set(xlabel="distance, km", ylabel="equivalent conicity", title="conicity at amplitudes of", ylim=(0, None))
    conicity.legend(fontsize=7)
    figure.savefig("worn_wheel.png", dpi=110)


def main():
    distance = 1e6 * float(sys.argv[1]) if len(sys.argv) > 1 else 1e10
    began = time.perf_counter()
    with rc.Context() as context:
        fresh, wheel, profiles, history, steps = wear(context, distance)
        wheel.write_profile("worn_wheel.txt", 1.0)
    print(f"{steps} steps, {time.perf_counter() - began:.0f} s", file=sys.stderr)
    try:
        draw(fresh, profiles, history)
    except ImportError:
        print("no pictures without matplotlib", file=sys.stderr)


if __name__ == "__main__":
    main()
