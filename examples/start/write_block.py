import numpy as np

x = y = np.linspace(-8, 8, 17)
z = np.linspace(-8, 0, 9)
points = [(a, b, c) for c in z for b in y for a in x]
node = 1 + np.arange(len(points)).reshape(len(z), len(y), len(x))
square = [(0, 0), (1, 0), (1, 1), (0, 1)]
quads = lambda k: np.stack([node[k, j:j + 16, i:i + 16] for i, j in square], -1).reshape(-1, 4)
hexahedra = np.hstack([np.vstack([quads(k) for k in range(8)]), np.vstack([quads(k) for k in range(1, 9)])])
bottom, top = quads(0)[:, ::-1], quads(8)

with open("block.msh", "w") as file:
    print("$MeshFormat\n2.2 0 8\n$EndMeshFormat", file=file)
    print("$PhysicalNames\n3\n3 1 \"steel\"\n2 2 \"bottom\"\n2 3 \"top\"\n$EndPhysicalNames", file=file)
    print("$Nodes", len(points), sep="\n", file=file)
    for number, point in enumerate(points, 1):
        print(number, *point, file=file)
    print("$EndNodes\n$Elements", len(hexahedra) + len(bottom) + len(top), sep="\n", file=file)
    elements = [(5, 1, e) for e in hexahedra] + [(3, 2, e) for e in bottom] + [(3, 3, e) for e in top]
    for number, (kind, group, nodes) in enumerate(elements, 1):
        print(number, kind, 2, group, group, *nodes, file=file)
    print("$EndElements", file=file)

with open("block.inp", "w") as file:
    print("*NODE", file=file)
    for number, point in enumerate(points, 1):
        print(number, *point, sep=", ", file=file)
    print("*ELEMENT, TYPE=C3D8, ELSET=steel", file=file)
    for number, nodes in enumerate(hexahedra, 1):
        print(number, *nodes, sep=", ", file=file)
    print(f"*NSET, NSET=bottom, GENERATE\n1, {17 * 17}, 1", file=file)
    print(f"*ELSET, ELSET=layer, GENERATE\n{len(hexahedra) - 255}, {len(hexahedra)}, 1", file=file)
    print("*SURFACE, NAME=top\nlayer, S2", file=file)
