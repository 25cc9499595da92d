"""A solid tyre of rubber rolls at speeds of five decades: its resistance, and how much power each harmonic of the way
round it loses. Leaves solid_tyre.csv and solid_tyre_harmonics.csv, which plot_solid_tyre.gp draws. Units: mm, N, s."""

import numpy as np

import rollcon as rc

context = rc.Context()
y, z = np.linspace(-20, 20, 17), np.append(np.linspace(100, 135, 7), np.linspace(138, 150, 6))  # mm
nodes = np.array([[0, a, b] for a in y for b in z])
number = np.arange(len(nodes)).reshape(len(y), len(z))
n = len(z)
first = number[:-2:2, :-2:2].reshape(-1, 1)
quads = first + np.array([0, 2 * n, 2 * n + 2, 2, n, 2 * n + 1, n + 2, 1, n + 1])

tyre, floor = rc.Body(context, "section"), rc.Body(context, "rigid")
tyre.set_nodes(nodes)
tyre.add_elements("quad9", quads, 0)
tyre.set_elastic(12, 0.48)
tyre.set_viscoelastic([0.25, 0.25, 0.2], [1e-3, 1e-2, 1e-1])
tyre.set_support(number[:, 0], 7)                             # the rim
tyre.tag_faces_of_nodes(number[:, -1], 2)                     # the tread
tyre.set_contact_faces([2])
tyre.revolve([0, 0, 0], [0, 1, 0])
contact = rc.Contact(context, tyre, floor)
contact.set_axes([0, 0, 150], [1, 0, 0], [0, 0, 1])
contact.set_friction(0.0)
contact.prescribe("normal", "force", 300)
contact.frame_rectangle("quad4", 20, 16, -25, 25, -20, 20)

drawn = {}
with open("solid_tyre.csv", "w") as file:
    print("speed,resistance", file=file)
    for k in range(21):
        speed = 10 ** (k / 4)
        contact.set_rolling(speed)
        contact.solve()
        power, moment = contact.body_power(1), contact.resultant()[1]
        resistance = contact.stat("rolling_resistance")
        print(f"{speed:.6g},{resistance:.6g}", file=file)
        if k % 4 == 0:
            drawn[k // 4] = power[:61] / power.sum()
            print(f"{speed:7.0f} mm/s: {resistance:.3f} N, by the moment of pressures {moment[1] / 150:.3f} N")
        if abs(moment[1] / 150 - resistance) > 0.15 * resistance:
            raise SystemExit("the harmonics lose another power than the pressures drive")
with open("solid_tyre_harmonics.csv", "w") as file:
    print("harmonic," + ",".join(f"1e{k}" for k in range(1, 5)), file=file)
    for n in range(61):
        print(f"{n}," + ",".join(f"{drawn[k][n]:.6g}" for k in range(1, 5)), file=file)
