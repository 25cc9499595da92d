"""Tests texts by one table: the call, and the words that its text must have or must not have."""

import math
import os
import tempfile
import unittest

import rollcon as rc

CUBE = """*NODE
1,0,0,-2
2,2,0,-2
3,2,2,-2
4,0,2,-2
5,0,0,0
6,2,0,0
7,2,2,0
8,0,2,0
9,5,0,0
*ELEMENT, TYPE=C3D8, ELSET=cube
1, 1,2,3,4,5,6,7,8
*ELEMENT, TYPE=B31
4, 7,9
"""


def half_spaces(context, number=2):
    bodies = [rc.Body(context, "halfspace") for _ in range(number)]
    for body in bodies:
        body.set_elastic(2.1e5, 0.28)
    return bodies


def wheel(context, side="right"):
    wheel_body, rail = half_spaces(context)
    wheel_body.set_profile_shape("s1002", [1.0])
    rail.set_profile_shape("60e1", [1.0])
    made = rc.WheelRail(context, wheel_body, rail, side)
    made.set_track(1435, 14, math.atan(1 / 40))
    made.set_wheelset(1360, -70, 460)
    made.set_position([0, 2, 0, 0, 0, 0])
    made.set_velocity([2000, 0, 0, 0, 0, -4.35])
    made.prescribe_vertical("by_force", 1e4)
    return made


def refusal(call):
    try:
        call()
    except rc.RollconError as error:
        return str(error)
    return "not refused"


def caveat(call):
    call()
    return rc.last_caveat()


def spinning_backwards(context):
    made = wheel(context)
    made.set_friction(0.3)
    made.set_velocity([2000, 0, 0, 0, 0, 4.4])
    return refusal(made.solve)


def without_friction(context):
    return refusal(wheel(context).solve)


def friction_by_angle_alone(context):
    made = wheel(context)
    made.set_friction([[-1.0, 0.1], [0.0, 0.3]], "by_angle")
    return str(int(made.solve()))


def one_wheel_for_both_sides(context):
    left = wheel(context, "left")
    return refusal(lambda: rc.conicity(left, left, [3.0]))


def light_wheel(context):
    made = wheel(context)
    made.set_friction(0.3)
    made.prescribe_vertical("by_force", 1e-9)
    return caveat(made.solve)


def beyond_a_profile(context):
    wheel_body, rail = half_spaces(context)
    wheel_body.set_profile_shape("line", [20.0, 0.0])
    rail.set_profile_shape("arc", [-80.0, 79.0])
    made = rc.WheelRail(context, wheel_body, rail, "right")
    made.set_track(1500, 14, 0)
    made.set_wheelset(1300, -100 - math.sqrt(80**2 - 66**2), 300)
    made.set_friction(0.3)
    made.set_position([0, -19, 0, 0, 0, 0])
    made.set_velocity([1000, 0, 0, 0, 0, -1000 / 300])
    made.prescribe_vertical("by_force", 5e4)
    return caveat(made.solve)


def saddle(context):
    contact = rc.Contact(context, *half_spaces(context))
    contact.set_gap_quadratic(0.01, -0.01)
    contact.set_friction(0.3)
    contact.prescribe("normal", "by_force", 1.0)
    return refusal(contact.solve)


def ratio_beyond_a_table(context):
    return refusal(lambda: rc.Table.standard(context).evaluate([8e4, 0.3, 0.3, 25.0000003, 1.0, 100.0, 0, 0, 0]))


def few_nodes(element, load):
    def text(context):
        contact = rc.Contact(context, *half_spaces(context))
        contact.set_gap_quadratic(0.01, 0.01)
        contact.frame_rectangle(element, 12, 12, -1.5, 1.5, -1.5, 1.5)
        contact.set_friction(0.3)
        contact.set_rolling(1.0)
        contact.prescribe("normal", "by_force", load)
        contact.set_creep(1e-3, 5e-3, 1e-3)
        return caveat(contact.solve)
    return text


def faces_that_look_away(flipped):
    def text(context):
        contact = rc.Contact(context, *half_spaces(context))
        x = [[i, j, 0] for j in range(4) for i in range(4)]
        quads = [[4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4] for j in range(3) for i in range(3)]
        for k in flipped:
            quads[k] = quads[k][::-1]
        contact.frame_nodes(x)
        contact.frame_add_elements("quad4", quads)
        contact.set_gap_quadratic(0.01, 0.01)
        contact.set_friction(0)
        contact.prescribe("normal", "by_motion", 0.01)
        return refusal(contact.solve)
    return text


def plan_of_a_mesh_file(context):
    if not rc.has_feature("fem"):
        return "passed over: elements of type B31 (1)"
    body, partner = rc.Body(context, "fem"), rc.Body(context, "rigid")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "cube.inp")
        with open(path, "w", encoding="ascii") as file:
            file.write(CUBE)
        body.read_mesh(path)
    body.set_elastic(2.1e5, 0.28)
    body.set_support([0, 1, 2, 3], 7)
    contact = rc.Contact(context, body, partner)
    contact.set_axes([1, 1, 0], [1, 0, 0], [0, 0, 1])
    contact.frame_rectangle("quad4", 8, 8, -0.9, 0.9, -0.9, 0.9)
    contact.set_gap_quadratic(0.01, 0.01)
    contact.set_friction(0)
    contact.prescribe("normal", "by_motion", 0.001)
    contact.solve()
    return contact.plan()


# Each row has a text, words that it has, and words that it has not.
TEXTS = [
    (spinning_backwards, ["pitch rate, entry 5 of velocity, is 4.4", "has about -4.34"], ["contact_set_velocity"]),
    (without_friction, ["set_friction first"], []),
    (friction_by_angle_alone, ["0"], []),
    (one_wheel_for_both_sides, ["right is a wheel on the left", "ROLLCON_RIGHT"], ["in use"]),
    (light_wheel, ["for 1e-09", "brought it nearer"], []),
    (beyond_a_profile, ["end of a profile", "ends where a profile does"], ["units", "sign"]),
    (saddle, ["0.01 x^2 - 0.01 y^2 + 0 x y"], ["+ -"]),
    (ratio_beyond_a_table, ["a / b of entry 0 is 25.0000003; the table has 0.04 to 25"], []),
    (few_nodes("quad8", 2e-3), ["5 touch", "times what friction carries"], []),
    (few_nodes("quad4", 2e-3), ["too few nodes"], ["times what friction carries"]),
    (faces_that_look_away([4]), ["element that looks away from the normal n", "1 such"], ["order of nodes"]),
    (faces_that_look_away(range(9)), ["all elements look away from the normal n", "9 such"], []),
    (plan_of_a_mesh_file, ["passed over: elements of type B31 (1)"], []),
]


class Texts(unittest.TestCase):

    def test_say_what_belongs_there(self):
        context = rc.Context(threads=1)
        for number, (text_of, has, has_not) in enumerate(TEXTS):
            with self.subTest(number=number, text=text_of.__name__):
                text = text_of(context)
                for words in has:
                    self.assertIn(words, text)
                for words in has_not:
                    self.assertNotIn(words, text)


if __name__ == "__main__":
    unittest.main()
