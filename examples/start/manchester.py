import rollcon as rc

# wheel, y, z, roll, rate of rotation; CONTACT's normal, longitudinal, lateral force, largest pressure
CASES = [("right", 0.5, 0.1938, -2.304e-5, -4.3474134, (9870, 880.0, 2579, 632.5)),
         ("right", 2.0, 0.1529, -1.128e-4, -4.3459197, (9799, 517.3, 2893, 744.8)),
         ("right", 6.5, -3.0468, -4.376e-3, -4.2748834, (15440, 1987, 4170, 2603)),
         ("left", 1.0, 0.1840, -5.049e-5, -4.3465752, (10050, -829.2, 2893, 423.9))]

context = rc.Context()
tread, rail = rc.Body(context, "halfspace"), rc.Body(context, "halfspace")
for body, shape in ((tread, "s1002"), (rail, "60e1")):
    body.set_elastic(2 * 82000 * 1.28, 0.28)
    body.set_profile_shape(shape, [1])
print("wheel  y, mm            normal  longitudinal  lateral  largest pressure")
for side, y, z, roll, rate, published in CASES:
    wheel = rc.WheelRail(context, tread, rail, side)
    wheel.set("roll_outside", 1)                           # CONTACT's order of roll and yaw
    wheel.set_track(1435, 14, 1 / 40)
    wheel.set_wheelset(1360, -70, 460)
    wheel.set_friction(0.3)
    wheel.set_position([0, y, z, roll, 2.4e-3 * y, 0])
    wheel.set_velocity([2000, 0, 0, 0, 0, rate])
    wheel.solve()
    names = "normal_force", "longitudinal_force", "lateral_force", "max_pressure"
    solved = (wheel.patch_stat(0, name) for name in names)
    for name, numbers in (("rollcon", solved), ("CONTACT", published)):
        print("{:6} {:5.1f}  {} {:8.0f} {:13.0f} {:8.0f} {:17.0f}".format(side, y, name, *numbers))
    if (side, y) == ("right", 2.0):
        wheel.plot_patches().figure.savefig("manchester.png")
