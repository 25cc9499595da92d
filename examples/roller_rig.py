#!/usr/bin/env python3
"""A wheelset on a roller rig: S1002 on rollers with the profile 60E1, beside the same wheelset on track.

    python3 roller_rig.py [radius of the rollers]      500 mm unless given

Prints what the rollers' radius makes of pressures and areas, where a yawed wheelset touches, and the force over the
creepage of a wheelset that is braked, counted from the rate at which it rolls freely. Leaves roller_rig.png where
matplotlib is installed. Units: mm, N, s.
"""
import sys

import numpy as np
import rollcon as rc

RADIUS, SPEED, LOAD, FRICTION = 460.0, 10e3, 60e3, 0.3


def half_space(context, profile):
    body = rc.Body(context, "halfspace")
    body.set_elastic(2.1e5, 0.28)
    body.set_profile_shape(profile, [1.0])
    return body


def wheelset(context, roller):
    """Left and right wheel on rollers of this radius, or on track where it is 0."""
    wheels = []
    for side in ("left", "right"):
        wheel = rc.WheelRail(context, half_space(context, "s1002"), half_space(context, "60e1"), side)
        wheel.set_track(1435, 14, 0)
        wheel.set_wheelset(1360, -70, RADIUS)
        wheel.set_friction(FRICTION)
        wheel.prescribe_vertical("by_force", LOAD)
        if roller:
            wheel.set_roller(roller, SPEED / roller)
        wheels.append(wheel)
    return wheels


def pull(wheels, roller, yaw, pitch_rate):
    """Longitudinal force of both wheels on the wheelset."""
    force = 0.0
    for wheel in wheels:
        wheel.set_position([0, 0, 0, 0, yaw, 0])
        wheel.set_velocity([0 if roller else SPEED, 0, 0, 0, 0, pitch_rate])
        wheel.solve()
        force += wheel.resultant("in_track")[0][0]
    return force


def main():
    context = rc.Context()
    own = float(sys.argv[1]) if len(sys.argv) > 1 else 500.0
    creepages, curves = np.linspace(0, 0.01, 11), {}
    for name, roller in ((f"rollers of {own:g} mm", own), ("rollers of 2000 mm", 2000.0), ("track", 0.0)):
        wheels = wheelset(context, roller)
        right = wheels[1]
        for wheel in wheels:
            wheel.prescribe_longitudinal("by_force", 0)
        pull(wheels, roller, 0, -SPEED / RADIUS)
        rolling = right.stat("pitch_rate")
        for wheel in wheels:
            wheel.prescribe_longitudinal("by_motion")
        print(f"{name}: largest pressure {right.patch_stat(0, 'max_pressure'):.0f} MPa, area "
              f"{right.patch_stat(0, 'area'):.1f} mm2")
        pull(wheels, roller, 0.01, rolling)
        print(f"  yawed by 10 mrad the right wheel touches at x = {right.patch_stat(0, 'x'):.2f} mm")
        forces = [pull(wheels, roller, 0, rolling * (1 - c)) / (2 * FRICTION * LOAD) for c in creepages]
        print("  braked by", ", ".join(f"{c:.3f}: {-f:.3f}" for c, f in zip(creepages[1:6], forces[1:6])), "of mu Fz")
        curves[name] = -np.array(forces)
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError:
        return
    figure, axes = plt.subplots(figsize=(6, 4))
    for name, curve in curves.items():
        axes.plot(100 * creepages, curve, label=name)
    axes.set_xlabel("creepage of the braked wheelset, %")
    axes.set_ylabel("longitudinal force / (μ Fz)")
    axes.legend()
    figure.tight_layout()
    figure.savefig("roller_rig.png", dpi=110)


if __name__ == "__main__":
    main()
