#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes jug.bpt and jug.mtl beside this script: a jug with a lip and a handle, of bicubic Bézier patches."""
import math
import pathlib

KAPPA = 4 / 3 * (math.sqrt(2) - 1)   # a quarter of a circle as a cubic

# Cubic segments of the wall's section as (radius, height), from the middle of the foot up outside and down inside.
# Where two segments meet smoothly their inner points lie on one line with the joint.
WALL = [
    [(0, 0), (0.25, 0), (0.45, 0), (0.52, 0.02)],
    [(0.52, 0.02), (0.57, 0.035), (0.56, 0.08), (0.6, 0.16)],
    [(0.6, 0.16), (0.68, 0.32), (0.84, 0.5), (0.84, 0.8)],
    [(0.84, 0.8), (0.84, 1.15), (0.5, 1.25), (0.5, 1.6)],
    [(0.5, 1.6), (0.5, 1.8), (0.56, 1.9), (0.62, 2)],
    [(0.62, 2), (0.65, 2.05), (0.58, 2.06), (0.56, 2)],
    [(0.56, 2), (0.5, 1.82), (0.42, 1.76), (0.42, 1.6)],
    [(0.42, 1.6), (0.42, 1.25), (0.76, 1.15), (0.76, 0.8)],
    [(0.76, 0.8), (0.76, 0.4), (0.5, 0.1), (0, 0.1)],
]
# The handle's middle line, on the other side of the lip, and the half axes of its section.
HANDLE = [
    [(-0.5, 1.78), (-0.72, 1.86), (-1.1, 1.98), (-1.2, 1.7)],
    [(-1.2, 1.7), (-1.32, 1.364), (-1.1, 0.98), (-0.78, 0.82)],
]
ACROSS, ALONG = 0.065, 0.11


def quarter(k):
    """Control points of the k-th quarter of the unit circle."""
    turn = [(1, 0), (0, 1), (-1, 0), (0, -1)]
    (ax, ay), (bx, by) = turn[k % 4], turn[(k + 1) % 4]
    return [(ax, ay), (ax + KAPPA * bx, ay + KAPPA * by), (bx + KAPPA * ax, by + KAPPA * ay), (bx, by)]


def lip(height):
    """How far the lip is drawn out at a height: linear, so that smooth joints of the wall stay smooth."""
    return 0.26 * max(0.0, (height - 1.82) / 0.18)


def wall_patches():
    for segment in WALL:
        for k in range(4):
            net = []
            for i, (c, s) in enumerate(quarter(k)):
                # Control points at the lip's middle and beside it move together: both sides meet smoothly there.
                is_at_lip = (k == 0 and i < 2) or (k == 3 and i > 1)
                net.append([(r * c + (lip(h) if is_at_lip else 0.0), h, -r * s) for r, h in segment])
            yield net


def normal(a, b):
    """Across the direction from a to b, in the handle's plane."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    size = math.hypot(dx, dy)
    return (-dy / size, dx / size)


def handle_patches():
    end = normal(HANDLE[0][0], HANDLE[0][1])
    for line in HANDLE:
        start, end = end, normal(line[2], line[3])   # where segments meet both have the very same points
        sides = [start, start, end, end]   # constant where segments meet: the tube is smooth there
        for k in range(4):
            yield [[(x + ACROSS * c * n[0], y + ACROSS * c * n[1], ALONG * s) for (x, y), n in zip(line, sides)]
                   for c, s in quarter(k)]


def main():
    folder = pathlib.Path(__file__).resolve().parent
    patches = [*wall_patches(), *handle_patches()]
    lines = [str(len(patches))]
    for net in patches:
        lines.append("3 3")
        lines += ["%.7g %.7g %.7g" % tuple(c + 0.0 for c in point) for row in net for point in row]
    (folder / "jug.bpt").write_text("\n".join(lines) + "\n", encoding="ascii")
    (folder / "jug.mtl").write_text(
        "# The material of jug.bpt: glazed earthenware.\nnewmtl glaze\nKd 0.09 0.23 0.33\nPr 0.22\n", encoding="ascii")


if __name__ == "__main__":
    main()
