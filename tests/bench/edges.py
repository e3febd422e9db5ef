#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the antialiasing methods of scenes and prints the tables, each figure beside its bound.

usage: edges.py [--program PATH] [--quick] [--scenes A,B] [--measures rmse,crawl,bloat,time] [--save FILE | --load FILE]

Build the program first: cmake --build BUILD --target burin_bench. Real models come from BURIN_SHARED_DATA (or
../shared/data beside the repository) and are left out where absent. On two cores --quick takes ten minutes, a full run
two hours. Never a test: machines are noisy, and the bounds are goals.
"""
import argparse
import collections
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
RESOLVE = "resolve"
OVERDRAW = ("unsorted", "sorted")
# Methods that every figure of another is divided by, in the tables of ratios.
AGAINST = ("2x2", "4x MSAA")
# (clean models, harder scenes): ratios that the edge modes must not pass.
BOUNDS = {
    "rmse": {RESOLVE: {"2x2": (0.5, 0.9), "4x MSAA": (0.5, 0.85)}},
    "crawl": {RESOLVE: {"2x2": (0.4, 0.75)}},
    "second": {mode: {"2x2": (0.25, 0.25)} for mode in OVERDRAW},
    "frame": {RESOLVE: (1.4, 2.0), **{mode: (1.3, 1.7) for mode in OVERDRAW}},
}
# (signed area error aimed at, how far off it may be), pixels.
BLOAT_BOUNDS = {RESOLVE: (0.0, 0.01), **{mode: (0.50, 0.03) for mode in OVERDRAW}}
SHORTEST_BOUND_FRAME_MS = 4.0


class Results:
    """Figures by measure, scene and method, in the order in which they came."""

    def __init__(self):
        self.values = {}
        self.scenes = {}
        self.methods = []
        self.device = ""

    def add(self, line):
        figure = json.loads(line)
        if figure["measure"] == "device":
            self.device = figure["method"]
            return
        self.values[figure["measure"], figure["scene"], figure["method"]] = figure["value"]
        self.scenes[figure["scene"]] = figure["clean"]
        if figure["method"] and figure["method"] not in self.methods:
            self.methods.append(figure["method"])

    def get(self, measure, scene, method):
        return self.values.get((measure, scene, method))

    def scenes_with(self, measure):
        return [scene for scene in self.scenes if any(key[:2] == (measure, scene) for key in self.values)]


def table(title, head, rows):
    widths = [max(len(row[i]) for row in [head, *rows]) for i in range(len(head))]
    print(f"\n{title}\n")
    for row in [head, ["-" * width for width in widths], *rows]:
        cells = [cell.ljust(width) if i == 0 else cell.rjust(width) for i, (cell, width) in enumerate(zip(row, widths))]
        print("| " + " | ".join(cells) + " |")


def number(value, digits=2):
    return "" if value is None else f"{value:.{digits}f}"


def judged(value, bound, digits=2):
    """A figure beside its bound; a star where it passes it."""
    if value is None:
        return ""
    return f"{value:.{digits}f}{'*' if value > bound else ' '} <= {bound:g}"


def ratio(a, b):
    return a / b if a is not None and b else None


def plain_table(results, measure, title, digits=2):
    scenes = results.scenes_with(measure)
    if not scenes:
        return
    methods = [m for m in results.methods if any(results.get(measure, s, m) is not None for s in scenes)]
    rows = []
    for scene in scenes:
        share = results.get("edge share", scene, "")
        name = scene if share is None else f"{scene} ({100 * share:.0f} %)"
        rows.append([name, *(number(results.get(measure, scene, m), digits) for m in methods)])
    table(title, ["scene", *methods], rows)


def ratio_table(results, measure, kind, title):
    """Each bound method's figures over those of what it is held against, scene by scene, bounds beside."""
    scenes = results.scenes_with(measure)
    columns = [(mode, other, bounds) for mode, others in BOUNDS[kind].items() if mode in results.methods
               for other, bounds in others.items()]
    if not scenes or not columns:
        return
    rows = []
    for scene in scenes:
        cells = [judged(ratio(results.get(measure, scene, mode), results.get(measure, scene, other)),
                        bounds[0 if results.scenes[scene] else 1]) for mode, other, bounds in columns]
        rows.append([scene, *cells])
    table(title, ["scene", *(f"{mode} / {other}" for mode, other, _ in columns)], rows)


def bloat_table(results):
    scene = "half-plane"
    rows = []
    for method in results.methods:
        signed = results.get("bloat", scene, method)
        if signed is None:
            continue
        aim, off = BLOAT_BOUNDS.get(method, (None, None))
        star = "" if aim is None else "*" if abs(signed - aim) > off else " "
        bound = "" if aim is None else f"{aim:.2f} +- {off:.2f}"
        rows.append([method, f"{signed:+.4f}{star}", number(results.get("bloat abs", scene, method), 4), bound])
    if rows:
        table("Bloat on an isolated edge, 12 angles, pixels across the edge", ["method", "signed", "mean abs", "bound"], rows)


def time_table(results):
    scenes = results.scenes_with("frame ratio")
    if not scenes:
        return
    methods = [m for m in results.methods if any(results.get("frame ratio", s, m) is not None for s in scenes)]
    rows = []
    for scene in scenes:
        base = results.get("frame ms", scene, "none")
        cells = []
        for method in methods[1:]:
            value = results.get("frame ratio", scene, method)
            bound = BOUNDS["frame"].get(method)
            is_bound = bound and base is not None and base >= SHORTEST_BOUND_FRAME_MS
            cells.append(judged(value, bound[0 if results.scenes[scene] else 1]) if is_bound else number(value))
        rows.append([scene, number(base), *cells])
    table(f"Frame time at 1024x1024 over none (bounds: frames of {SHORTEST_BOUND_FRAME_MS:g} ms and more)",
          ["scene", "none, ms", *methods[1:]], rows)


def report(results):
    print(f"device: {results.device}")
    print("\nLinear light over an opaque dark grey, all of red, green and blue, clamped to 0..1; only pixels within two "
          "pixels of a\nvisible discontinuity edge (their share of the frame in brackets). 4x MSAA is the mean of four "
          "renderings at the\ndevice's own sample positions: visibility as the hardware resolves it, shading at every "
          "sample. 2x2 and 4x4 are\nmeans in the same way, so that all take textures at the reference's detail; their "
          "frame times are those of --samples.\nA star: over the bound.")
    plain_table(results, "rmse", "RMSE x 255 near edges")
    ratio_table(results, "rmse", "rmse", "RMSE against supersampling")
    for name, what in (("pan", "0.05 pixels a frame sideways"), ("turn", "orbit and roll, about 0.05 pixels a frame")):
        plain_table(results, f"crawl {name}", f"Crawl, mean |dI - dI of the reference| x 255 ({what})", 3)
        ratio_table(results, f"crawl {name}", "crawl", f"Crawl against supersampling ({name})")
        plain_table(results, f"second {name}", f"Excess second difference, mean |d2I| less the reference's, x 255 ({name})", 3)
        if name == "pan":  # a turned reference has too few samples: its own steps would flatter whatever is smooth
            ratio_table(results, f"second {name}", "second", f"Excess second difference against supersampling ({name})")
    bloat_table(results)
    time_table(results)


def run(options):
    program = pathlib.Path(options.program)
    if not program.exists():
        sys.exit(f"edges: {program} is not there; build it: cmake --build BUILD --target burin_bench")
    command = [str(program)]
    if options.quick:
        command.append("--quick")
    for name in ("scenes", "measures", "size", "samples", "pan-samples", "turn-samples", "frames", "device", "dump"):
        value = getattr(options, name.replace("-", "_"))
        if value is not None:
            command += [f"--{name}", str(value)]
    shared = os.environ.get("BURIN_SHARED_DATA", str(ROOT.parent / "shared" / "data"))
    command += ["--shared-data", shared]
    lines = []
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        seen = collections.OrderedDict()
        for line in process.stdout:
            lines.append(line)
            figure = json.loads(line)
            step = (figure["scene"], figure["measure"])
            if step not in seen:
                seen[step] = True
                print(f"edges: {figure['scene']}: {figure['measure']}", file=sys.stderr, flush=True)
    if process.returncode != 0:
        sys.exit(f"edges: {program} exited {process.returncode}")
    if options.save:
        pathlib.Path(options.save).write_text("".join(lines))
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(ROOT / "build/release/bench/edge_quality"))
    parser.add_argument("--quick", action="store_true", help="smaller and shorter: minutes instead of hours")
    parser.add_argument("--scenes", help="names separated by commas (default: all)")
    parser.add_argument("--measures", help="of rmse,crawl,bloat,time (default: all)")
    parser.add_argument("--size", type=int)
    parser.add_argument("--samples", type=int)
    parser.add_argument("--pan-samples", type=int, help="of each frame of the pan's reference, a pixel")
    parser.add_argument("--turn-samples", type=int, help="of each frame of the turn's reference, a pixel")
    parser.add_argument("--frames", type=int)
    parser.add_argument("--device")
    parser.add_argument("--dump", help="a folder for every picture and the mask, as PPM")
    parser.add_argument("--save", help="keep the figures, one JSON object a line")
    parser.add_argument("--load", help="print the tables of figures kept before")
    options = parser.parse_args()
    lines = pathlib.Path(options.load).read_text().splitlines() if options.load else run(options)
    results = Results()
    for line in lines:
        results.add(line)
    report(results)


if __name__ == "__main__":
    main()
