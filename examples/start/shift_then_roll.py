import matplotlib.pyplot as pyplot
import rollcon as rc

context = rc.Context()
sphere = rc.Body(context, "halfspace")
sphere.set_elastic(2 * 1.0 * 1.28, 0.28)
contact = rc.Contact(context, sphere, sphere)
contact.frame_rectangle("quad4", 30, 30, -4.2, 4.2, -4.2, 4.2)
contact.set_gap_quadratic(0.002963, 0.002963)
contact.set_friction(0.4013)
contact.prescribe("normal", "force", 0.4705)
contact.prescribe("longitudinal", "force", -0.657 * 0.4013 * 0.4705)
contact.set_step(rc.SHIFT_STEP, 1.0)
contact.solve()
contact.set_rolling(1.0)
contact.set_step(rc.ROLLING_STEP, 0.25)
creepage = []
for _ in range(40):
    contact.solve()
    creepage.append(contact.motion()[1][0])
print(f"creepage of the first step {creepage[0]:.6f}, of the last {creepage[-1]:.6f}")
figure, axes = pyplot.subplots(figsize=(6, 4), layout="constrained")
axes.plot(range(1, 41), creepage, label="rollcon")
axes.plot([1, 40], [0.001824, 0.003101], "o", mfc="none", label="CONTACT")
axes.set(xlabel="step of rolling", ylabel="creepage")
axes.legend()
figure.savefig("shift_then_roll.png")
