"""Two equal spheres are shifted by a force and then roll under it, step by step. shift_and_roll.c has
the story; it and shift_and_roll_77.f print the same. docs/time.md."""
import rollcon as rc

SHEAR, POISSON, CURVATURE, LOAD, MU = 1.0, 0.28, 0.002963, 0.4705, 0.4013

context = rc.Context()
sphere = rc.Body(context, rc.BODY_HALFSPACE)
sphere.set_elastic(2 * SHEAR * (1 + POISSON), POISSON)
contact = rc.Contact(context, sphere, sphere)
contact.frame_rectangle(rc.QUAD4, 30, 30, -4.2, 4.2, -4.2, 4.2)
contact.set_gap_quadratic(CURVATURE, CURVATURE)
contact.set_friction(MU)
contact.prescribe(rc.NORMAL, rc.BY_FORCE, LOAD)
contact.prescribe(rc.LONGITUDINAL, rc.BY_FORCE, -0.657 * MU * LOAD)


def step(name, rolled):
    """Solves a step and prints what moved."""
    status = contact.solve()
    _, motion = contact.motion()
    slipping = int((contact.node_states() == rc.SLIP).sum())
    print(f"{name:8s}{status:4d}{rolled:9.2f}{motion[0]:13.5E}{slipping:6d}")


contact.set_step(rc.SHIFT_STEP, 1.0)
step("shift", 0.0)
contact.set_rolling(1.0)
contact.set_step(rc.ROLLING_STEP, 0.25)
for k in range(1, 9):
    step("roll", 0.25 * k)
past = contact.past_get()
for k in range(9, 41):
    if k % 8 == 0:
        step("roll", 0.25 * k)
    else:
        contact.solve()
contact.past_set(past)
step("again", 2.25)
