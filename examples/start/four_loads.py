from concurrent.futures import ThreadPoolExecutor

import rollcon as rc

steel = rc.Body(rc.Context(), "halfspace")
steel.set_elastic(210000, 0.28)
steel.prepare()


def pressure(load):
    contact = rc.Contact(rc.Context(), steel, steel)   # a context and a contact of this thread's own
    contact.set_gap_quadratic(1 / 920, 1 / 600)
    contact.set_friction(0.3)
    contact.prescribe("normal", "force", load)
    contact.solve()
    return contact.stat("max_pressure")


with ThreadPoolExecutor(max_workers=2) as pool:
    print(*(f"{value:.0f}" for value in pool.map(pressure, (20e3, 40e3, 80e3, 160e3))), "MPa")
