"""Writes what to call for which task: the list of docs/calls.md, in all languages, and that of the C reference."""

from generator import reference_fortran, reference_python

# Tasks, each with names of C functions without rollcon_. The names in the other layers are looked up.
TASKS = [
    ("Begin and end", [
        ("begin; one for each thread of your own", ["context_create"]),
        ("check once, at the end", ["context_set_latch", "context_check"]),
        ("read what went wrong, or the caveat", ["last_error", "last_caveat"]),
        ("say how many threads to use", ["context_set_threads"]),
        ("share lists with other MPI ranks", ["context_set_communicator"]),
        ("end", ["contact_release", "body_release", "context_release"])]),
    ("Bodies", [
        ("half-space, rigid, finite or boundary elements", ["body_create"]),
        ("material; rubber", ["body_set_elastic", "body_set_viscoelastic", "body_set_moduli"]),
        ("profile: a closed form, points, a file", ["body_set_profile_shape", "body_set_profile", "body_read_profile"]),
        ("profile as a roller or wheel, as a rail", ["body_revolve_profile", "body_extrude_profile"]),
        ("mesh: a file, arrays", ["body_read_mesh", "body_set_nodes", "body_add_elements"]),
        ("names of the file: a material, faces, nodes", ["body_tag_group", "body_get_group_nodes"]),
        ("what is held, what may touch", ["body_set_support", "body_set_contact_faces"]),
        ("loads of the body itself", ["body_set_pressure", "body_set_rotation"]),
        ("prepare once, keep for later", ["body_prepare", "body_save", "body_load"])]),
    ("Contact", [
        ("a pair of bodies", ["contact_create"]),
        ("gap: two radii, a grid; where a body stands", ["contact_set_gap_quadratic", "contact_set_gap_grid",
                                                         "contact_set_pose"]),
        ("frame: ellipse, grid, file (none: the library's)", ["contact_frame_ellipse", "contact_frame_rectangle",
                                                              "contact_frame_from_file"]),
        ("law of friction; third-body layer; heat", ["contact_set_friction", "contact_set_layer", "contact_set_heat"]),
        ("rolling speed and creepages, or velocities", ["contact_set_rolling", "contact_set_creep",
                                                        "contact_set_velocity"]),
        ("force given or motion given, in any direction", ["contact_prescribe"]),
        ("a step in time instead of steady rolling", ["contact_set_step"]),
        ("settings by name", ["contact_set_real", "contact_set_int", "contact_set_str"])]),
    ("Solve", [
        ("one case; a list on all threads", ["contact_solve", "contact_solve_many"]),
        ("watch, stop", ["contact_set_progress", "contact_request_cancel"]),
        ("step back in time", ["contact_past_get", "contact_past_set"])]),
    ("Results", [
        ("force and moment; approach and creepages", ["contact_get_resultant", "contact_get_motion"]),
        ("tractions, stick and slip, other fields", ["contact_get_tractions", "contact_get_node_states",
                                                     "contact_get_field"]),
        ("numbers by name: largest pressure, power, error", ["contact_get_stat"]),
        ("stresses and displacements inside", ["contact_get_fields_at", "body_get_node_stresses"]),
        ("largest shear, von Mises, Dang Van, Crossland, Lundberg-Palmgren", ["contact_find_stress"]),
        ("derivatives", ["contact_get_sensitivity"]),
        ("wear; railways' fatigue index; temperatures", ["contact_get_wear", "contact_get_fatigue_index",
                                               "contact_get_temperatures_at"]),
        ("a file for ParaView; what the solve did", ["contact_write", "contact_get_plan"])]),
    ("Wheel on rail", [
        ("a wheel; track; wheelset", ["wheelrail_create", "wheelrail_set_track", "wheelrail_set_wheelset"]),
        ("position, velocity, load", ["wheelrail_set_position", "wheelrail_set_velocity",
                                      "wheelrail_prescribe_vertical"]),
        ("friction; a table for the forces", ["wheelrail_set_friction", "wheelrail_set_table"]),
        ("solve; forces; derivatives", ["wheelrail_solve", "wheelrail_get_resultant", "wheelrail_get_derivative"]),
        ("each patch: numbers, its contact", ["wheelrail_get_patch_count", "wheelrail_get_patch_stat",
                                              "wheelrail_get_contact"]),
        ("step back; many positions", ["wheelrail_snapshot", "wheelrail_rollback", "wheelrail_solve_many"]),
        ("equivalent conicity; contact points", ["wheelrail_find_conicity", "wheelrail_find_contact_points"])]),
    ("Creep-force tables", [
        ("the one for steel; a file; forces", ["table_standard", "table_load", "table_evaluate"]),
        ("make one", ["table_create", "table_make", "table_save"])]),
]


class Names:
    """Knows the names of a function in all layers."""

    def __init__(self, table, read):
        self.functions = {f.name.removeprefix("rollcon_"): f for f in table.functions}
        self.methods = {}
        plain = reference_python.parsed(read, "_plain")
        settings = reference_python.class_of(reference_python.parsed(read, "_settings"), "Settings")
        for name, (module,) in reference_python.CLASSES:
            parts = [reference_python.class_of(reference_python.parsed(read, module), name),
                     reference_python.class_of(plain, f"{name.capitalize()}Plain"), settings]
            self.methods[name.lower()] = {m.name: "(" in reference_python.heading(m, "x")[1]
                                          for m in reference_python.methods(parts)}
        self.bindings = {kind.removeprefix("rc_"): {name for file in reference_fortran.FILES[kind]
                                                    for name, _ in reference_fortran.bound(read(f"fortran/{file}.f90"))}
                         for kind in reference_fortran.TYPES}

    def python(self, name):
        function = self.functions[name]
        if function.group not in self.methods:
            return f"rc.{name}()"
        if function.verb in ("create", "release"):
            made = {"wheelrail": "WheelRail"}.get(function.group, function.group.capitalize())
            return f"rc.{made}()" if function.verb == "create" else ".close()"
        known = self.methods[function.group]
        verb = function.python.get("name", function.verb)
        for each in (verb, verb.removeprefix("get_"), verb.removeprefix("find_"), verb.rsplit("_", 1)[0]):
            if each in known:
                return f".{each}" + ("()" if known[each] else "")
        free = {"wheelrail_find_conicity": "rc.conicity()", "wheelrail_find_contact_points": "rc.contact_points()"}
        return free[name]

    def fortran(self, name):
        function = self.functions[name]
        if function.group not in self.bindings:
            return f"rc_{name}()"
        known = self.bindings[function.group]
        options = {"set_real": "set", "set_int": "set", "set_str": "set", "release": "free", "write": "write_vtu"}
        for each in (function.fortran, function.verb, options.get(function.verb, "")):
            if each in known:
                return f"%{each}"
        raise KeyError(f"{name} has no procedure in Fortran")

    def f77(self, name):
        return self.functions[name].f77[0]


def listed(words):
    """Writes names as code, each once."""
    return " ".join(f"`{word}`" for word in dict.fromkeys(words))


def every_language(table, read):
    """Returns the list of docs/calls.md."""
    names = Names(table, read)
    out = ["| task | C, Octave | Fortran 2008 | FORTRAN 77 | Python |\n| --- | --- | --- | --- | --- |\n"]
    for title, rows in TASKS:
        out.append(f"| **{title}** | | | | |\n")
        for task, calls in rows:
            columns = [calls, *([layer(c) for c in calls] for layer in (names.fortran, names.f77, names.python))]
            out.append(f"| {task} | {' | '.join(map(listed, columns))} |\n")
    return "".join(out)


def reference_index(table):
    """Returns the functions of C by task, each a link to its section; then all others by group."""
    out = ["### Functions by task\n\n| task | functions |\n| --- | --- |\n"]
    for title, rows in TASKS:
        out.append(f"| **{title}** | |\n")
        out += [f"| {task} | {', '.join(f'[{c}](#rollcon_{c})' for c in calls)} |\n" for task, calls in rows]
    used = {"rollcon_" + c for _, rows in TASKS for _, calls in rows for c in calls}
    out.append("\nAll others, by what they belong to:\n\n| group | functions |\n| --- | --- |\n")
    for group in table.groups:
        rest = [f.name.removeprefix("rollcon_") for f in group.functions if f.name not in used]
        if rest:
            out.append(f"| {group.title} | {', '.join(f'[{c}](#rollcon_{c})' for c in rest)} |\n")
    return "".join(out) + "\n"
