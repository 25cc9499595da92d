"""The six steps in Python: an elastic sphere rolls on a rigid plane and transmits 75 % of the force
at which it would slide. Units: mm, N, MPa. six_steps.c, .f90 and _77.f print the same."""
import rollcon as rc

RADIUS, YOUNG, POISSON, MU = 50.0, 1e4, 0.3, 0.1
LOAD, SPEED = 298.6, 10.0
TRACTION_FORCE = 0.75 * MU * LOAD


def show(name, *values):
    """Six digits; what is zero up to rounding is printed as zero."""
    fields = [f"{v:13d}" if isinstance(v, int) else
              "     0.000000" if abs(v) < 5e-7 else f"{v:13.5E}" for v in values]
    print(f"{name:14s}" + "".join(fields))


# Step 1 makes the bodies; a failure raises rc.RollconError with the library's own words.
context = rc.Context()
sphere = rc.Body(context, rc.BODY_HALFSPACE)
plane = rc.Body(context, rc.BODY_RIGID)

# Step 2 gives the gap between them; the library makes the mesh of the contact, its frame, to fit.
contact = rc.Contact(context, sphere, plane)
contact.set_gap_quadratic(1 / (2 * RADIUS), 1 / (2 * RADIUS))

# Step 3 sets the materials.
sphere.set_elastic(YOUNG, POISSON)
contact.set_friction(MU)

# Step 4 sets creepages and loads.
contact.set_rolling(SPEED)
contact.set_creep(0.0, 0.0, 0.0)
contact.prescribe(rc.NORMAL, rc.BY_FORCE, LOAD)
contact.prescribe(rc.LONGITUDINAL, rc.BY_FORCE, TRACTION_FORCE)

# Step 5 solves.
status = contact.solve()

# Step 6 reads the results.
force, moment = contact.resultant()
approach, creep = contact.motion()
t = contact.tractions()
state = contact.node_states()
show("status", status)
show("force", *force)
show("moment", *moment)
show("approach", approach)
show("creepages", *creep)
show("max pressure", -t[:, 2].min())
show("stick slip rim", *(int((state == s).sum()) for s in (rc.STICK, rc.SLIP, rc.EXCLUDED)))
show("centre", *t[len(t) // 2])
