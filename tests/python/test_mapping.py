"""Tests that every function of C gets its arguments in their places, and that its results come back, over a library
that only writes them down (tests/bindings/record.h): the generated rows, then the methods that are written by hand."""

import tempfile
import unittest
from pathlib import Path

import numpy as np
import rollcon as rc
from mapping_case import WRITTEN, X, MappingCase, said
from mapping_rows import ROWS
from rollcon._library import lib
from rollcon._settings import _types


class Mapping(MappingCase):

    def test_a_rows(self):
        for row in ROWS:
            with self.subTest(method=row.method, arguments=row.arguments):
                thing = getattr(self, row.object)

                def call(thing=thing, row=row):
                    method = getattr(thing, row.method)
                    return method if row.property else method(*row.arguments)
                result = call()
                self.told(row.function, row.record)
                if row.result is not None:
                    np.testing.assert_equal(result, row.result)
                self.fails(call)

    def test_facts_and_tables(self):
        self.assertTrue(rc.has_feature("some name"))
        self.told("has_feature", "<some name>")
        self.assertEqual((rc.version(), rc.version_string()), (2, "text of version_string"))
        self.assertEqual((rc.build_info(), rc.last_error()), ("text of build_info", "text of last_error"))
        self.assertEqual(rc.last_caveat(), "text of last_caveat")
        principal, von_mises, shear = rc.stress_invariants(np.hstack([X, X]))
        self.told("stress_invariants", "2 [1.5 2.5 3.5 1.5 2.5 3.5 4.5 5.5 6.5 4.5 5.5 6.5] room room room")
        np.testing.assert_equal(principal, [[200.5, 201.5, 202.5], [203.5, 204.5, 205.5]])
        np.testing.assert_equal(von_mises, [300.5, 301.5])
        np.testing.assert_equal(shear, [400.5, 401.5])
        self.refuses("shape", rc.stress_invariants, X)
        self.assertEqual(rc.status_string(-7), "text of status_string")
        self.told("status_string", "-7")
        text = "text of option_info"
        self.assertEqual(rc.option_table("body")[1], (text, 600, 700.5, 800.5, 900.5, text))
        self.told("option_info", "2 1 20 room room null room room room room")
        self.told("option_count", "2")
        text = "text of stat_info"
        self.assertEqual(rc.stat_table(rc.OF_PATCH)[1], (text, text, 600))
        self.told("stat_info", "6 1 18 room room null room")
        self.told("stat_count", "6")
        self.fails(rc.option_table)
        self.fails(rc.stat_table)

    def test_lives(self):
        self.told("context_create", "1 room")
        self.told("body_create", "context1 4 room")
        self.told("contact_create", "context1 body1 body2 room")
        self.told("wheelrail_create", "context1 body1 body2 -1 room")
        self.told("table_create", "context1 room")
        for kind in ("context", "body", "contact", "wheelrail", "table"):
            thing = getattr(self, kind)
            again = type(thing).__new__(type(thing))
            again.__dict__.update(thing.__dict__)
            again._call("retain")
            self.told(f"{kind}_retain", kind + "1")
            again.close()
            self.told(f"{kind}_release", kind + "1")
            again.close()
        self.assertEqual(self.body.id, (2 << 28) + 1)
        loaded = rc.Body.load(self.context, Path("a path"))
        self.told("body_load", "context1 <a path> room")
        self.assertNotEqual(loaded.id, self.body.id)
        self.fails(rc.Body.load, self.context, "a path")
        copy = self.body.copy()
        self.told("body_copy", "body1 room")
        self.assertNotEqual(copy.id, self.body.id)
        self.fails(self.body.copy)
        self.fails(rc.Body, self.context, "fem")
        self.fails(rc.Context)
        self.fails(rc.Contact, self.context, self.body, self.other)
        self.fails(rc.WheelRail, self.context, self.body, self.other, rc.RIGHT)

    def test_meshes(self):
        wide = np.zeros((2, 8))
        wide[:, 2:5] = X
        for owner, name, kind in ((self.body, "set_nodes", "body"), (self.contact, "frame_nodes", "contact")):
            for x in (X, np.asfortranarray(X), wide[:, 2:5], X[::-1].copy()[::-1], X.tolist(), X.astype(">f8")):
                getattr(owner, name)(x)
                self.told(f"{kind}_{name}", f"{kind}1 2 {WRITTEN}")
            getattr(owner, name)(X[:, :2])
            self.told(f"{kind}_{name}", f"{kind}1 2 [1.5 2.5 0 4.5 5.5 0]")
            self.refuses("shape", getattr(owner, name), np.zeros((4, 5)))
            self.fails(getattr(owner, name), X)
        ids = [[1, 2, 3], [4, 5, 6]]
        for owner, name, kind in ((self.body, "add_elements", "body"), (self.contact, "frame_add_elements", "contact")):
            add = getattr(owner, name)
            add("tri3", ids, 9, 5)
            self.told(f"{kind}_{name}", f"{kind}1 203 2 [1 2 3 4 5 6] 5 9")
            add(rc.TRI3, np.array(ids, dtype=np.int64))
            self.told(f"{kind}_{name}", f"{kind}1 203 2 [1 2 3 4 5 6] 0 1")
            self.refuses("does not fit", add, rc.TRI6, ids)
            self.refuses("integers", add, rc.TRI3, np.array(ids) + 0.5)
            self.refuses("32 bits", add, rc.TRI3, np.array(ids) + 2**32)
            self.fails(add, rc.TRI3, ids)
        for element_type, width in {rc.TET4: 4, rc.TET10: 10, rc.WEDGE6: 6, rc.WEDGE15: 15, rc.HEX8: 8,
                                    rc.HEX20: 20}.items():
            self.body.add_elements(element_type, [range(width)])
            self.assertTrue(said("body_add_elements").endswith("] 0 0"), "the standard tag of volumes")
            self.refuses("does not fit", self.body.add_elements, element_type, [range(width + 1)])

    def test_tags_and_supports(self):
        body = self.body
        body.tag_faces([5, 6], [2, 3], 9, 1)
        self.told("body_tag_faces", "body1 2 [5 6] [2 3] 1 9")
        body.tag_faces([], [], 9)
        self.told("body_tag_faces", "body1 0 [] [] 0 9")
        body.tag_faces_of_nodes([5, 6], 9, 1)
        self.told("body_tag_faces_of_nodes", "body1 2 [5 6] 1 9")
        body.set_support([5, 6], rc.DOF_Y, X, 1)
        self.told("body_set_support", f"body1 2 [5 6] 1 2 {WRITTEN}")
        body.set_support([5, 6])
        self.told("body_set_support", "body1 2 [5 6] 0 7 null")
        body.set_node_tractions(9, [5, 6], X, [7.5, 8.5, 9.5], 1)
        self.told("body_set_node_tractions", f"body1 9 2 [5 6] 1 [7.5 8.5 9.5] {WRITTEN}")
        body.set_node_tractions(9, [5, 6], X)
        self.told("body_set_node_tractions", f"body1 9 2 [5 6] 0 null {WRITTEN}")
        self.refuses("1 tractions for 2", body.set_node_tractions, 9, [5, 6], X[:1])
        self.refuses("1 faces for 2", body.tag_faces, [5, 6], [2], 9)
        self.refuses("1 values for 2", body.set_support, [5, 6], values=X[:1])
        for ids, words in (([[0, 1]], "one dimension"), ([0.5], "integers"), ([2**31], "32 bits")):
            self.refuses(words, body.tag_faces, ids, ids, 9)
            self.refuses(words, body.tag_faces_of_nodes, ids, 9)
            self.refuses(words, body.set_support, ids)
        for function, arguments in ((body.tag_faces, ([5], [2], 9)), (body.tag_faces_of_nodes, ([5], 9)),
                                    (body.set_support, ([5],))):
            self.fails(function, *arguments)

    def test_scene_and_settings(self):
        contact = self.contact
        contact.set_pose(2, X[[0, 1, 0]], [7, 8, 9])
        self.told("contact_set_pose", "contact1 2 [1.5 2.5 3.5 4.5 5.5 6.5 1.5 2.5 3.5] [7 8 9]")
        contact.set_pose(1)
        self.told("contact_set_pose", "contact1 1 [1 0 0 0 1 0 0 0 1] [0 0 0]")
        self.refuses("shape", contact.set_pose, 1, np.eye(4))
        contact.set_friction(0.25)
        self.told("contact_set_friction", "contact1 <coulomb> 1 [0.25]")
        contact.set_friction([0.25, 0.5], law="other")
        self.told("contact_set_friction", "contact1 <other> 2 [0.25 0.5]")
        contact.prescribe(np.int64(3), "by_force", np.float32(1.0))
        self.told("contact_prescribe", "contact1 3 2 1")
        self.refuses("does not fit", contact.prescribe, 2**32 + 1, rc.BY_FORCE, 1.0)  # not cut to a valid direction
        for thing, kind in ((self.body, "body"), (contact, "contact"), (self.wheelrail, "wheelrail")):
            thing.set("a name", 2**40)
            self.told(f"{kind}_set_int", f"{kind}1 <a name> {2**40}")
            thing.set("a name", 1.5)
            self.told(f"{kind}_set_real", f"{kind}1 <a name> 1.5")
            self.assertEqual(thing.get("a name"), 200)
            self.told(f"{kind}_get_int", f"{kind}1 <a name> room")
            _types[kind]["a real"] = rc.TYPE_REAL
            self.assertEqual(thing.get("a real"), 200.5)
            self.told(f"{kind}_get_real", f"{kind}1 <a real> room")
        contact.set("a name", "a value")
        self.told("contact_set_str", "contact1 <a name> <a value>")
        _types["contact"]["a text"] = rc.TYPE_STR
        self.assertEqual(contact.get("a text"), "text of contact_get_str")
        self.told("contact_get_str", "contact1 <a text> 24 room room")
        self.refuses("no setting of a body is a text", self.body.set, "a name", "a value")

    def test_callbacks(self):
        events, lines = [], []
        self.contact.set_progress(lambda e: events.append((e.phase, e.iteration, e.residual, e.seconds)))
        self.told("contact_set_progress", "contact1 0")
        self.told("event_get_int", "7 2 room")
        self.told("event_get_real", "7 102 room")
        self.assertEqual(events, [(200, 200, 200.5, 200.5)])
        self.contact.set_progress(lambda e: True)
        self.told("contact_set_progress", "contact1 1")
        self.contact.set_progress(None)
        self.told("contact_set_progress", "contact1 null")
        self.context.set_log("info", lambda level, text: lines.append((level, text)))
        self.told("context_set_log", "context1 3 0")
        self.assertEqual(lines, [(2, "a message")])
        self.context.set_log(0)
        self.told("context_set_log", "context1 0 null")

    def test_results(self):
        """Reads results: the frame has 3 nodes, a field 6 values, a solve 2 iterations."""
        contact = self.contact
        lib.recorder_answers(rc.NOT_CONVERGED)
        self.assertEqual(contact.solve(), rc.NOT_CONVERGED)
        self.told("contact_solve", "contact1")
        lib.recorder_answers(rc.OK)

        def check(got, shape, first, function, record):
            np.testing.assert_equal(got, first + np.arange(np.prod(shape)).reshape(shape))
            self.told(function, record)
        check(self.body.displacements(), (3, 3), 200.5, "body_get_displacements", "body1 3 room")
        check(self.body.group_nodes("Top"), (3,), 400, "body_get_group_nodes", "body1 <Top> 0 3 room room")
        self.assertEqual(self.body.group_nodes("Top", 1).dtype, np.int32)
        self.told("body_get_group_nodes", "body1 <Top> 1 3 room room")
        self.assertEqual(len(self.body.groups), self.body.group_count())
        check(contact.tractions("global"), (3, 3), 300.5, "contact_get_tractions", "contact1 1 3 room")
        check(contact.tractions(), (3, 3), 300.5, "contact_get_tractions", "contact1 0 3 room")
        check(contact.field("slip", rc.GLOBAL), (3, 2), 400.5, "contact_get_field", "contact1 4 1 6 room room")
        check(contact.field(rc.FIELD_SLIP), (3, 2), 400.5, "contact_get_field", "contact1 4 0 6 room room")
        past = contact.past_get()
        self.told("contact_past_get", f"contact1 {past.size} room room")
        check(contact.node_states(), (3,), 200, "contact_get_node_states", "contact1 3 room")
        self.assertEqual(contact.node_states().dtype, np.int32)
        check(contact.displacements_at(2, X[:, :2]), (2, 3), 400.5, "contact_get_displacements_at",
              "contact1 2 2 [1.5 2.5 4.5 5.5] room")
        self.refuses("shape", contact.displacements_at, 2, X)
        u, stress = contact.fields_at("body2", X, "body")
        check(u, (2, 3), 500.5, "contact_get_fields_at", f"contact1 2 2 {WRITTEN} 1 room room")
        np.testing.assert_equal(stress, 600.5 + np.arange(12).reshape(2, 6))
        contact.fields_at(2, X)
        self.told("contact_get_fields_at", f"contact1 2 2 {WRITTEN} 0 room room")
        self.refuses("shape", contact.fields_at, 2, X[:, :2])
        check(contact.body_displacements(2), (2, 3), 300.5, "contact_get_body_displacements", "contact1 2 6 room room")
        check(contact.body_power(2), (6,), 300.5, "contact_get_body_power", "contact1 2 6 room room")
        check(self.body.node_stresses(X), (2, 6), 300.5, "body_get_node_stresses", f"body1 2 {WRITTEN} room")
        check(self.body.node_stresses(), (3, 6), 300.5, "body_get_node_stresses", "body1 3 null room")
        stress, xyz = self.body.point_stresses(X)
        check(stress, (2, 6), 400.5, "body_get_point_stresses", f"body1 2 {WRITTEN} 2 room room room")
        np.testing.assert_equal(xyz, 500.5 + np.arange(6).reshape(2, 3))
        u, stress = self.body.fields_at(X, X)
        check(u, (2, 3), 500.5, "body_get_fields_at", f"body1 2 {WRITTEN} 2 {WRITTEN} room room")
        np.testing.assert_equal(stress, 600.5 + np.arange(12).reshape(2, 6))
        self.body.write("a file", X)
        self.told("body_write", f"body1 <a file> 2 {WRITTEN}")
        self.body.set_condensed("flexibility", [[1.5, 2.5], [3.5, 4.5]])
        self.told("body_set_condensed", "body1 2 4 [1.5 2.5 3.5 4.5]")
        contact.write_body(2, "a file")
        self.told("contact_write_body", "contact1 2 <a file>")
        self.refuses("shape", self.body.node_stresses, X[:, :2])
        value, place = contact.find_stress("body2", "a measure", [1.5, 2.5])
        check(place, (3,), 600.5, "contact_find_stress", "contact1 2 <a measure> 2 [1.5 2.5] room room")
        self.assertEqual(value, 500.5)
        depth, volume = contact.wear("a law", 1.5, [2.5, 3.5])
        check(depth, (2,), 600.5, "contact_get_wear", "contact1 <a law> 1 [1.5] 2 [2.5 3.5] room room")
        self.assertEqual(volume, 700.5)
        worn, taken = rc.wear_profile(X[:, :2], [4.5, 5.5], -1, 6.5, 7.5, 8.5)
        check(worn, (2, 2), 700.5, "wear_profile", "2 [1.5 2.5 4.5 5.5] [4.5 5.5] -1 6.5 7.5 8.5 room room")
        self.assertEqual(taken, 800.5)
        check(contact.temperatures_at(X[:, :2]), (2, 2), 300.5, "contact_get_temperatures_at",
              "contact1 2 [1.5 2.5 4.5 5.5] room")
        self.refuses("shape", contact.temperatures_at, X)
        check(contact.history("step seconds"), (2, 2), 300.5, "contact_get_history",
              "contact1 <step seconds> 2 room room")
        self.assertEqual(contact.history().shape, (2, 9))
        for function, arguments in ((self.body.displacements, ()), (self.body.node_stresses, ()),
                                    (contact.tractions, ()), (contact.field, (1,)),
                                    (contact.node_states, ()), (contact.history, ()),
                                    (contact.displacements_at, (1, X[:, :2])), (contact.solve, ()),
                                    (contact.temperatures_at, (X[:, :2],)), (contact.fields_at, (1, X)),
                                    (rc.stress_invariants, (np.hstack([X, X]),)),
                                    (self.body.set, ("a name", 1)), (self.body.get, ("a name",))):
            self.fails(function, *arguments)

    def test_cases(self):
        """Reads the columns of the table: 3 + 3 + 1 + 3 + 2 + 20 + 9 + 2 numbers, the first of which is 600.5."""
        cases = self.contact.solve_many(["normal", rc.FRICTION], X[:, :2], names=["iterations ", "seconds"],
                                        derivatives=True, tractions=True)
        self.told("contact_solve_many", "contact1 <normal friction> 2 [1.5 2.5 4.5 5.5] <force moment approach creep tilt "
                  "derivatives tractions iterations seconds> 43 room null room")
        table = 600.5 + np.arange(86).reshape(2, 43)
        np.testing.assert_equal(cases.status, [800, 801])
        for name, shape, at in (("force", (3,), 0), ("moment", (3,), 3), ("approach", (), 6), ("creep", (3,), 7),
                                ("tilt", (2,), 10), ("derivatives", (2, 10), 12), ("tractions", (3, 3), 32),
                                ("statistics", (2,), 41)):
            width = int(np.prod(shape))
            np.testing.assert_equal(getattr(cases, name), table[:, at:at + width].reshape((2, *shape)), name)
        np.testing.assert_equal(cases["seconds"], table[:, 42])
        self.assertEqual(cases.worst, rc.OK)
        few = self.contact.solve_many("longitudinal lateral spin", X, names="seconds")
        self.assertFalse(hasattr(few, "tractions") or hasattr(few, "derivatives"))
        self.told("contact_solve_many", f"contact1 <longitudinal lateral spin> 2 {WRITTEN} "
                  "<force moment approach creep tilt seconds> 13 room null room")
        self.refuses("shape", self.contact.solve_many, [rc.LATERAL], [1, 2, 3])
        with self.assertRaises(ValueError):
            self.contact.solve_many(np.array([[rc.LATERAL, rc.NORMAL]]), [[1.0]])
        self.fails(self.contact.solve_many, [rc.LATERAL], [[1.0]])

    def test_tables(self):
        rows = np.arange(18.0).reshape(2, 9)
        written = "[" + " ".join(f"{v:g}" for v in rows.ravel()) + "]"
        rc.Table.load(self.context, "a path")
        self.told("table_load", "context1 <a path> room")
        rc.Table.standard(self.context)
        self.told("table_standard", "context1 room")
        self.assertEqual(self.table.evaluate(rows).shape, (2, 3))
        self.told("table_evaluate", f"table1 2 {written} room")
        results, by = self.table.evaluate(rows[0], derivatives=True)
        self.assertEqual((results.shape, by.shape), ((3,), (3, 9)))
        self.assertEqual(self.table.evaluate_contact(self.contact).shape, (3,))
        self.told("table_evaluate_contact", "table1 contact1 -1 room")
        self.table.evaluate_contact(self.contact, 0.25)
        self.told("table_evaluate_contact", "table1 contact1 0.25 room")
        self.assertEqual(self.table.make(), rc.OK)
        self.told("table_make", "table1 0 1")
        self.table.samples
        self.table.set_progress(lambda e: True)
        self.assertEqual(said("table_set_progress")[:7], "table1 ")
        self.table.set_progress(None)
        self.told("table_set_progress", "table1 null")
        self.fails(self.table.evaluate, rows)
        self.fails(self.table.make)
        self.fails(rc.Table.standard, self.context)

    def test_patches(self):
        wheelrail = self.wheelrail
        wheelrail.set_table(self.table)
        self.told("wheelrail_set_table", "wheelrail1 table1")
        wheelrail.set_table(None)
        self.told("wheelrail_set_table", "wheelrail1 null")
        wheelrail.set_friction(0.25)
        self.told("wheelrail_set_friction", "wheelrail1 <coulomb> 1 [0.25]")
        wheelrail.set_friction([[-1.0, 0.25], [0.0, 0.5]], "by_angle")
        self.told("wheelrail_set_friction", "wheelrail1 <by_angle> 4 [-1 0.25 0 0.5]")
        self.fails(wheelrail.set_friction, 0.25)
        wheelrail.set("a name", 2)
        self.told("wheelrail_set_int", "wheelrail1 <a name> 2")
        self.fails(wheelrail.set_table, self.table)
        of_patch = wheelrail.contact(11)
        self.told("wheelrail_get_contact", "wheelrail1 11 room")
        self.assertEqual(of_patch.id, self.contact.id + 1)
        of_patch.close()
        self.told("contact_release", "contact2")
        self.refuses("6 components", wheelrail.set_position, [0, 0, 0])
        self.refuses("allowed: track", wheelrail.resultant, "local")
        self.fails(wheelrail.contact, 0)

    def test_wheelsets(self):
        wheelrail = self.wheelrail
        points = rc.contact_points(wheelrail, wheelrail, [1.5, 2.5])
        self.told("wheelrail_find_contact_points", "wheelrail1 wheelrail1 2 [1.5 2.5] <z roll radius_difference left_y left_z left_angle left_wheel_y "
                  "left_radius right_y right_z right_angle right_wheel_y right_radius> room")
        numbers = np.arange(26).reshape(2, 13) + 500.5
        for column, got in zip(numbers.T, (points.z, points.roll, points.difference, points.left.y, points.left.z,
                                           points.left.angle, points.left.wheel_y, points.left.rolling_radius,
                                           points.right.y, points.right.z, points.right.angle, points.right.wheel_y,
                                           points.right.rolling_radius)):
            np.testing.assert_array_equal(got, column)
        found, wavelength = rc.conicity(wheelrail, wheelrail, [1.5, 2.5])
        self.told("wheelrail_find_conicity", "wheelrail1 wheelrail1 2 [1.5 2.5] room room")
        np.testing.assert_array_equal(found, [400.5, 401.5])
        np.testing.assert_array_equal(wavelength, [500.5, 501.5])
        positions, velocities = [[1.5, 2.5, 3.5, 4.5, 5.5, 6.5]], [[6.5, 5.5, 4.5, 3.5, 2.5, 1.5]]
        many = wheelrail.solve_many(positions, velocities)
        self.told("wheelrail_solve_many",
                  "wheelrail1 1 [1.5 2.5 3.5 4.5 5.5 6.5] [6.5 5.5 4.5 3.5 2.5 1.5] <force_x force_y force_z moment_x "
                  "moment_y moment_z z vertical_force friction_power> room room")
        np.testing.assert_array_equal(many.force, [[500.5, 501.5, 502.5]])
        np.testing.assert_array_equal(many.moment, [[503.5, 504.5, 505.5]])
        np.testing.assert_array_equal([many.z[0], many.vertical_force[0], many.friction_power[0]],
                                      [506.5, 507.5, 508.5])
        np.testing.assert_array_equal(many.status, [600])
        self.refuses("2 positions, but 1", wheelrail.solve_many, 2 * positions, velocities)
        wear = wheelrail.find_wear(positions, velocities, "a law", [8.5], 2, weights=[7.5])
        self.told("wheelrail_find_wear", "wheelrail1 1 [1.5 2.5 3.5 4.5 5.5 6.5] [6.5 5.5 4.5 3.5 2.5 1.5] [7.5] "
                  "<a law> 1 [8.5] 2 room room room room")
        np.testing.assert_array_equal([*wear.wheel, *wear.rail, *wear.volumes],
                                      [900.5, 901.5, 1000.5, 1001.5, 1100.5, 1101.5])
        np.testing.assert_array_equal(wear.status, [1200])
        self.refuses("2 weights", wheelrail.find_wear, positions, velocities, "a law", 1, 2, [1, 2])
        other = wheelrail.copy()
        self.told("wheelrail_copy", "wheelrail1 room")
        self.assertEqual(other.id, wheelrail.id + 1)
        other.close()
        past = wheelrail.past_get()
        self.told("wheelrail_past_get", f"wheelrail1 {past.size} room room")
        self.fails(wheelrail.copy)
        self.fails(wheelrail.solve_many, positions, velocities)
        self.fails(rc.contact_points, wheelrail, wheelrail, [1.5])
        self.fails(rc.conicity, wheelrail, wheelrail, [1.5])

    def test_z_every_function_is_called(self):
        """Leaves out the functions for layers over C."""
        self.assertEqual(lib.recorder_missing().decode(), "report context_from_id body_from_id contact_from_id "
                         "wheelrail_from_id table_from_id")


if __name__ == "__main__":
    unittest.main()
