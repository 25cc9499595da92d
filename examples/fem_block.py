"""A first body of finite elements in Python: a rigid ball rolls over a soft layer on a stiffer base
and transmits 60 % of the force at which it would slide. The frame of the contact is a mesh of its
own that does not match the block's. Units: mm, N, MPa. fem_block.c and .f90 print the same."""
import numpy as np
import rollcon as rc

NX, NY, NZ = 17, 17, 9  # nodes of the block along x, y, z, 1 mm apart; its top is z = 0
ALONG = 12  # elements along each side of the frame, a square in the middle of the top
BASE, TREAD = 1, 2  # tags of elements: materials
TOP = 1  # tag of faces
RADIUS, LOAD, MU, SPEED, HALF = 200.0, 1500.0, 0.3, 10.0, 5.0


def show(name, *values):
    """Six digits; what is zero up to rounding is printed as zero."""
    fields = [f"{v:13d}" if isinstance(v, int) else
              "     0.000000" if abs(v) < 5e-7 else f"{v:13.5E}" for v in values]
    print(f"{name:14s}" + "".join(fields))


# Step 1 makes the block: nodes; six layers of elements are the base, two the tread.
context = rc.Context()
block = rc.Body(context, rc.BODY_FEM)
z, y, x = np.meshgrid(np.arange(NZ) - 8.0, np.arange(NY) - 8.0, np.arange(NX) - 8.0, indexing="ij")
block.set_nodes(np.column_stack([x.ravel(), y.ravel(), z.ravel()]))
node = np.arange(NX * NY * NZ).reshape(NZ, NY, NX)
for k in range(NZ - 1):
    # The bottom face comes first, counter-clockwise seen from above, then the top face.
    corners = [node[layer, j:j + NY - 1, i:i + NX - 1] for layer in (k, k + 1)
               for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    block.add_elements(rc.HEX8, np.stack(corners, axis=-1).reshape(-1, 8),
                       tag=BASE if k < 6 else TREAD)

# Step 2 gives materials by tag, holds the bottom's nodes, and names the faces of contact by the top's nodes.
block.set_elastic(1e4, 0.3, tag=BASE)
block.set_elastic(2e3, 0.45, tag=TREAD)
block.set_support(node[0].ravel())
block.tag_faces_of_nodes(node[-1].ravel(), TOP)
block.set_contact_faces([TOP])

# Step 3 makes the ball, which is rigid, its shape given as a gap, and the frame: 12 x 12 elements laid on the block,
# about as large as its faces.
ball = rc.Body(context, rc.BODY_RIGID)
contact = rc.Contact(context, block, ball)
contact.frame_rectangle(rc.QUAD4, ALONG, ALONG, -HALF, HALF, -HALF, HALF)
contact.set_gap_quadratic(1 / (2 * RADIUS), 1 / (2 * RADIUS))

# Step 4 sets friction, speed and loads: the ball is pressed and driven by forces.
contact.set_friction(MU)
contact.set_rolling(SPEED)
contact.prescribe(rc.NORMAL, rc.BY_FORCE, LOAD)
contact.prescribe(rc.LONGITUDINAL, rc.BY_FORCE, 0.6 * MU * LOAD)

# Step 5 solves: assembles and factorises the block, condenses it to the frame, then iterates.
status = contact.solve()

# Step 6 reads the results.
force, _ = contact.resultant()
approach, creep = contact.motion()
t = contact.tractions()
state = contact.node_states()
show("status", status)
show("block", *block.size)
show("unknowns", block.stat("unknowns"))
show("force", *force)
show("approach", approach)
show("creepages", *creep)
show("max pressure", -t[:, 2].min())
show("open stk slip", *(int((state == s).sum()) for s in (rc.OPEN, rc.STICK, rc.SLIP)))
show("centre", *t[len(t) // 2])
