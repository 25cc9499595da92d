"""Draws panels of log-log curves with one legend, by gnuplot: every element has a colour of its own."""

import os
import subprocess

# The entries are colour and point type; boundary elements and frames are solid, finite elements dashed.
STYLES = {
    "quad4": ("#1f77b4", 5), "tri3": ("#ff7f0e", 9), "quad8": ("#2ca02c", 7),
    "quad9": ("#8c564b", 13), "tri6": ("#d62728", 11),
    "tri3 rings": ("#9467bd", 8), "tri6 rings": ("#e377c2", 10),
    "quad4 graded": ("#1f77b4", 4), "tri3 graded": ("#ff7f0e", 8),
    "quad8 graded": ("#2ca02c", 6), "tri6 graded": ("#d62728", 10),
    "hex8": ("#17becf", 4), "wedge6": ("#bcbd22", 12), "tet4": ("#7f7f7f", 8),
    "hex20": ("#00007f", 6), "wedge15": ("#556b2f", 14), "tet10": ("#800000", 10),
    "hex8 on quad4": ("#17becf", 1), "hex20 on quad8": ("#00007f", 2),
    "laid on quad8": ("#ff00ff", 15), "laid on hex20": ("#6a5acd", 14),
    "godunov": ("#7f7f7f", 9), "least squares": ("#1f77b4", 5), "characteristic": ("#d62728", 7),
}
FINITE = ("hex", "wedge", "tet")
OTHERS = ("#1f77b4", "#ff7f0e", "#2ca02c", "#d62728", "#9467bd", "#8c564b", "#e377c2", "#17becf",
          "#bcbd22", "#7f7f7f")


def style_of(name, number):
    """Returns colour, point and dash of a curve: those of its element, the first words of its name. CONTACT's
    published and measured figures are black."""
    if name.startswith("CONTACT"):
        return ("#000000", 2, 4) if "published" in name else ("#000000", 3, 1)
    for length in (3, 2, 1):
        key = " ".join(name.replace(",", "").split()[:length])
        if key in STYLES:
            colour, point = STYLES[key]
            dash = 1
            if key.startswith(FINITE):
                dash = 2
            if "graded" in name or " on quad" in name and "laid" not in name or "block" in name:
                dash = 3
            return colour, point, dash
    return OTHERS[number % len(OTHERS)], 4 + number % 10, 1


class Panel:
    """Holds curves: name -> [(x, y)], or clouds of points with a diagonal; the floor is the uncertainty of the
    reference, drawn as a grey line."""

    def __init__(self, title, xlabel, curves, floor=0, cloud=False):
        self.title, self.xlabel, self.floor, self.cloud = title, xlabel, floor, cloud
        self.curves = {name: [(x, y) for x, y in points if x and x > 0 and y and y > 0]
                       for name, points in curves.items()}
        self.curves = {name: points for name, points in self.curves.items() if points}


def span(values):
    """Returns a range a little wider than the values, for a logarithmic axis."""
    low, high = min(values), max(values)
    margin = max(1.15, (high / low) ** 0.04)
    return low / margin, high * margin


def axis(low, high):
    """Returns range and tics of a logarithmic x axis: plain numbers over less than two decades."""
    lines = [f"set xrange [{low:g}:{high:g}]"]
    if high / low >= 100:
        return lines + ["set format x '10^{%L}'", "set xtics autofreq"]
    steps = (1, 2, 5) if high / low > 4 else (1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9)
    tics = [m * 10.0 ** e for e in range(-7, 7) for m in steps if low <= m * 10.0 ** e <= high]
    return lines + ["set format x '%g'", "set xtics (" + ", ".join(f"{t:g}" for t in tics) + ")"]


def panels(path, ylabel, rows):
    """Draws rows, lists of panels; all have one y axis, those of a row with the same label one x axis."""
    rows = [[p for p in row if p.curves] for row in rows]
    rows = [row for row in rows if row]
    if not rows:
        return None
    names = list(dict.fromkeys(name for row in rows for p in row for name in p.curves))
    columns = max(len(row) for row in rows)
    key_rows = -(-len(names) // 6)
    width = max(150 + 330 * columns, 900)
    heights = 330 * len(rows)
    key_height = 24 * key_rows + 16
    total = heights + key_height
    ys = [y for row in rows for p in row for points in p.curves.values() for _, y in points]
    # A curve that crosses its reference dips without meaning: a decade below most is enough.
    low, high = span([y for y in ys if y >= 0.03 * sorted(ys)[len(ys) // 10]])
    script = [f"set terminal pngcairo size {width},{total} font 'Sans,10'",
              f"set output '{path}'", "set multiplot", "set logscale xy",
              "set format y '10^{%L}'", "set format x '10^{%L}'", "unset key",
              "set grid xtics ytics back lt 1 lw 0.5 lc rgb '#d0d0d0'",
              f"set yrange [{low:g}:{high:g}]"]
    styles = {}
    for k, name in enumerate(names, 1):
        colour, point, dash = style_of(name, k)
        styles[name] = k
        script.append(f"set style line {k} lc rgb '{colour}' pt {point} ps 1.0 lw 1.5 dt {dash}")
    left, right, gap = 85 / width, 1 - 15 / width, 25 / width
    each = (right - left - gap * (columns - 1)) / columns
    for i, row in enumerate(rows):
        top = 1 - (330 * i + 30) / total
        bottom = 1 - (330 * (i + 1) - 52) / total
        shared = {}  # panels of one label have one range
        for p in row:
            shared.setdefault(p.xlabel, []).extend(x for c in p.curves.values() for x, _ in c)
        for j, p in enumerate(row):
            x0 = left + j * (each + gap)
            script += [f"set lmargin at screen {x0:.4f}",
                       f"set rmargin at screen {x0 + each:.4f}",
                       f"set tmargin at screen {top:.4f}", f"set bmargin at screen {bottom:.4f}",
                       f"set title '{p.title}' offset 0,-0.6",
                       f"set xlabel '{p.xlabel}' offset 0,0.4",
                       *axis(*span(shared[p.xlabel])),
                       f"set ylabel '{ylabel if j == 0 else ''}'",
                       "set format y '10^{%L}'" if j == 0 else "set format y ''"]
            drawn = "points" if p.cloud else "linespoints"
            items = [f"'-' with {drawn} ls {styles[n]}" for n in p.curves]
            if p.cloud:
                items.append("x with lines lc rgb '#909090' lw 2")
            if p.floor > low:
                items.append(f"{p.floor:g} with lines lc rgb '#909090' lw 2 dt 4")
            script.append("plot " + ", ".join(items))
            for points in p.curves.values():
                script += [f"{x:g} {y:g}" for x, y in points] + ["e"]
    script += ["unset title", "unset xlabel", "unset ylabel", "unset grid", "unset border",
               "unset tics", "unset logscale", "set lmargin at screen 0.02",
               "set rmargin at screen 0.98", f"set bmargin at screen {4 / total:.4f}",
               f"set tmargin at screen {(key_height - 4) / total:.4f}",
               "set xrange [0:1]", "set yrange [0:1]",
               f"set key center center horizontal Left reverse maxrows {key_rows} samplen 3 spacing 1.1",
               "plot " + ", ".join(f"2 with linespoints ls {styles[n]} title '{n}'"
                                   for n in names),
               "unset multiplot"]
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)
    return "images/" + os.path.basename(path)
