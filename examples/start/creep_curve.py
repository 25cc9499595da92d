import matplotlib.pyplot as pyplot
import numpy as np
import rollcon as rc

creepage = np.array([1e-5, 4e-4, 8e-4, 1.2e-3, 1.6e-3, 2e-3, 2.4e-3, 2.8e-3, 3.2e-3])
contact_says = [0.007015, 0.2588, 0.4742, 0.6482, 0.7831, 0.8816, 0.9467, 0.9832, 0.9976]
LOAD, MU, SHEAR, POISSON = 106700, 0.33, 82000, 0.28

context = rc.Context()
steel = rc.Body(context, "halfspace")
steel.set_elastic(2 * SHEAR * (1 + POISSON), POISSON)


def curve(set_frame):
    contact = rc.Contact(context, steel, steel)
    set_frame(contact)
    contact.set_gap_quadratic(0.0008, 0.0002814173138)
    contact.set_friction(MU)
    contact.set_rolling(10000)
    contact.prescribe("normal", "force", LOAD)
    forces = []
    for value in creepage:
        contact.set_creep(-value)
        contact.solve()
        forces.append(contact.resultant()[0][0] / (MU * LOAD))
    print(f"approach {contact.motion()[0]:.5f} mm, largest pressure {contact.stat('max_pressure'):.1f} MPa")
    return forces


free = curve(lambda contact: None)
grid = curve(lambda contact: contact.frame_rectangle("quad4", 43, 47, -6.3, 6.3, -13.3, 13.3))
print("creepage  no frame  43 x 47  CONTACT")
for row in zip(creepage, free, grid, contact_says):
    print("{:8.1e} {:9.4f} {:8.4f} {:8.4f}".format(*row))
figure, axes = pyplot.subplots(figsize=(6, 4), layout="constrained")
axes.plot(creepage, free, label="rollcon, no frame")
axes.plot(creepage, contact_says, "o", mfc="none", label="CONTACT, 44 × 48")
axes.set(xlabel="creepage", ylabel="force / (μ Fn)")
axes.legend()
figure.savefig("beside_contact.png")
