"""Draws curves and bars of docs/procedures.md, by gnuplot."""

import os
import subprocess

SOLVERS = {"lu": "LU", "gmres": "GMRES", "gmres_adaptive": "adaptive GMRES"}


def gnuplot(path, lines, size=(820, 480)):
    script = [f"set terminal pngcairo size {size[0]},{size[1]} font 'Sans,11'",
              f"set output '{path}'"] + lines
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)
    return "images/" + os.path.basename(path)


def style(name, names):
    """Returns the colour by method, dashes and points by linear solver."""
    method, _, solver = name.rpartition(", ")
    methods = list(dict.fromkeys(n.rpartition(", ")[0] for n in names))
    kind = {"GMRES": 2, "adaptive GMRES": 3}.get(solver, 1)
    colour = methods.index(method) if len(methods) > 1 else names.index(name)
    return f"lc {1 + colour} dt {kind} lw 2", f"pt {(5, 7, 9)[kind - 1]}"


def curves(path, title, xlabel, ylabel, series, options=(), with_points=True):
    """Draws series: name -> [(x, y)], with a logarithmic ordinate."""
    series = {n: points for n, points in series.items() if points}
    if not series:
        return None
    names = list(series)
    x = [p[0] for points in series.values() for p in points]
    lines = [f"set title '{title}'", f"set xlabel '{xlabel}'", f"set ylabel '{ylabel}'",
             "set logscale y", "set grid", "set key outside right", *options]
    if "set logscale x" in options:
        y = [p[1] for points in series.values() for p in points if p[1] and p[1] > 0]
        lines += [f"set xrange [{min(x) / 1.2}:{max(x) * 1.2}]", "set format x '%g'"]
        if max(y) / min(y) < 100:
            lines.append(f"set yrange [{min(y) / 1.2}:{max(y) * 1.2}]")
    lines.append("plot " + ", ".join(
        f"'-' with {'linespoints' if with_points else 'lines'} {style(n, names)[0]} "
        + (style(n, names)[1] if with_points else "") + f" title '{n}'" for n in names))
    for points in series.values():
        lines += [f"{x} {y}" for x, y in points if y and y > 0] + ["e"]
    return gnuplot(path, lines, (960, 500))


def bars(path, title, ylabel, groups):
    """Draws groups: name -> solver -> height; a solver without height leaves a gap."""
    if not groups:
        return None
    heights = [h for g in groups.values() for h in g.values() if h]
    lines = [f"set title '{title}'", f"set ylabel '{ylabel}'", "set style data histogram",
             "set style histogram cluster gap 1", "set style fill solid 0.8 border -1",
             "set logscale y", f"set yrange [{min(heights) / 2}:{max(heights) * 2}]",
             "set xtics rotate by -25", "set grid y", "set key top left",
             "$bars << EOD"]
    for name, group in groups.items():
        lines.append(f'"{name}" ' + " ".join(f"{group[s]}" if group.get(s) else "NaN"
                                             for s in SOLVERS))
    lines.append("EOD")
    lines.append("plot " + ", ".join(f"$bars using {2 + k}:xtic(1) title '{label}'"
                                     for k, label in enumerate(SOLVERS.values())))
    return gnuplot(path, lines)
