#!/usr/bin/env python3
"""Compares ISO/TS 16281's slice model of rollers with full solutions of the same rollers: slices.py prints the table of
docs/tutorials/bearings.md. Units: mm, N."""

import numpy as np
import rollcon as rc

YOUNG, POISSON, RADIUS, HALF, SLICES = 206e3, 0.3, 6.0, 5.0, 51
MODULUS = YOUNG / (2 * (1 - POISSON**2))      # E* of both
OVER = 0.2                                    # length over which pressures are means


def relief(line_load):
    return line_load / (np.pi * MODULUS)


def sliced(drop, tilt, load):
    """Returns approach, moment and largest pressure of the slice model: lines that do not feel each other, each with
    the standard's spring. Its 35948 N/mm^(10/9) is that of a roller between two raceways, of which one gives half."""
    y = HALF * ((np.arange(SLICES) + 0.5) / SLICES * 2 - 1)
    spring = 35948 * 2 ** (10 / 9) * (2 * HALF) ** (8 / 9) / SLICES
    below = drop(y) + tilt * y
    low, high = below.min(), below.min() + 1
    for _ in range(100):
        approach = (low + high) / 2
        force = spring * (approach - below).clip(0) ** (10 / 9)
        low, high = (approach, high) if force.sum() < load else (low, approach)
    per_length = force / (2 * HALF / SLICES)
    return approach, force @ y, np.sqrt(per_length.max() * MODULUS / (np.pi * RADIUS))


def full(shape, parameters, tilt, load):
    context = rc.Context()
    plane, roller = rc.Body(context, "halfspace"), rc.Body(context, "halfspace")
    for body in (plane, roller):
        body.set_elastic(YOUNG, POISSON)
    roller.set_profile_shape(shape, parameters)
    roller.revolve_profile([0, 0, RADIUS], [0, 1, 0], RADIUS)
    contact = rc.Contact(context, plane, roller)
    contact.set_friction(0)
    contact.prescribe("normal", "force", load)
    contact.set_pose("body2", [[1, 0, 0], [0, np.cos(tilt), -np.sin(tilt)], [0, np.sin(tilt), np.cos(tilt)]])
    contact.set("pressure_length", OVER)
    contact.solve()
    _, moment = contact.resultant()
    return contact.approach, abs(moment[0]), contact.stat("max_pressure")


def main():
    c = relief(150)
    rollers = [("straight, sharp ends", "line", [HALF, 0], lambda y: 0 * y),
               ("crown of 2000 mm", "arc", [2000, HALF], lambda y: y**2 / 4000),
               ("logarithmic, k 0.999", "roller", [HALF, c, 0.999, 0],
                lambda y: -c * np.log(1 - 0.999 * (y / HALF) ** 2))]
    print("| roller | load, N | tilt, mrad | pressure, MPa | slices | approach, um | slices | moment, N mm | slices |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for name, shape, parameters, drop in rollers:
        for load in (1500, 6000):
            for tilt in (0, 5e-4, 1e-3):
                a, m, p = full(shape, parameters, tilt, load)
                b, n, q = sliced(drop, tilt, load)
                moment = f"{m:.0f} | {100 * (abs(n) / m - 1):+.1f} %" if tilt else "0 | "
                print(f"| {name} | {load} | {1e3 * tilt:.1f} | {p:.0f} | {100 * (q / p - 1):+.0f} % "
                      f"| {1e3 * a:.2f} | {100 * (b / a - 1):+.0f} % | {moment} |")


if __name__ == "__main__":
    main()
