# SPDX-License-Identifier: Apache-2.0
"""Two things that light scatters through, modelled in millimetres and scaled to metres: a candle of red wax lit by its own flame, and a
horned head lit from behind."""

import math

from gltf_builder import Builder, Surface, add, cross, dot, looking, scaled, sub, unit

TAU = 2 * math.pi


def lathe(profile, sides):
    """A closed surface round the y axis; the profile (radius, height) goes from the axis below to the axis above."""
    profile = [(1000.0 * r, 1000.0 * y) for r, y in profile]
    rows = len(profile) - 1

    def point(u, v):
        j = min(int(round(v * rows)), rows)
        before, after = profile[max(j - 1, 0)], profile[min(j + 1, rows)]
        dr, dy = after[0] - before[0], after[1] - before[1]
        c, s = math.cos(TAU * u), math.sin(TAU * u)
        r, y = profile[j]
        normal = (dy * c, -dr, -dy * s)
        if dot(normal, normal) < 1e-12:
            normal = (0.0, -1.0 if j == 0 else 1.0, 0.0)
        return (r * c, y, -r * s), unit(normal)

    surface = Surface()
    surface.grid(sides, rows, point)
    return outwards(surface)


def outwards(surface):
    """Turns each triangle the way that its normals look."""
    p, n = surface.positions, surface.normals
    for i, (a, b, c) in enumerate(surface.triangles):
        face = cross(sub(p[b], p[a]), sub(p[c], p[a]))
        if dot(face, add(n[a], add(n[b], n[c]))) < 0:
            surface.triangles[i] = (a, c, b)
    return surface


def smooth(points):
    """The same profile, each piece in eight along a Catmull-Rom curve."""
    out = []
    for i in range(len(points) - 1):
        a, b, c, d = (points[min(max(k, 0), len(points) - 1)] for k in (i - 1, i, i + 1, i + 2))
        for k in range(8):
            t = k / 8
            out.append(tuple(max(0.0, 0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t * t
                                             + (3 * q - p - 3 * r + s) * t ** 3)) if axis == 0 else
                             0.5 * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t * t + (3 * q - p - 3 * r + s) * t ** 3)
                             for axis, (p, q, r, s) in enumerate(zip(a, b, c, d))))
    return out + [points[-1]]


def head():
    """A ball whose radius swells into two horns, two ears and a snout."""
    bumps = [((0.5, 0.8, -0.1), 0.85, 60.0), ((-0.5, 0.8, -0.1), 0.85, 60.0), ((0.95, 0.2, -0.1), 0.4, 40.0),
             ((-0.95, 0.2, -0.1), 0.4, 40.0), ((0.0, -0.25, 1.0), 0.35, 6.0)]

    def place(u, v):
        theta, phi = math.pi * v, TAU * u
        d = (math.sin(theta) * math.cos(phi), math.cos(theta), -math.sin(theta) * math.sin(phi))
        r = 1.0 + sum(size * math.exp(-width * (1.0 - dot(d, unit(to)))) for to, size, width in bumps)
        return scaled(d, 11.0 * r)

    def point(u, v):
        e = 1e-3
        if v < e or v > 1 - e:
            return place(u, v), (0.0, 1.0 if v < 0.5 else -1.0, 0.0)
        n = unit(cross(sub(place(u, v + e), place(u, v - e)), sub(place(u + e, v), place(u - e, v))))
        p = place(u, v)
        return p, n if dot(n, p) > 0 else scaled(n, -1.0)

    surface = Surface()
    surface.grid(128, 96, point)
    return outwards(surface)


def finish(b, eye, target, lights):
    b.use("KHR_lights_punctual")
    b.doc["extensions"] = {"KHR_lights_punctual": {"lights": [light for light, _ in lights]}}
    for i, (_, at) in enumerate(lights):
        b.root(b.add("nodes", translation=list(at), extensions={"KHR_lights_punctual": {"light": i}}))
    camera = b.add("cameras", type="perspective", perspective={"yfov": 0.5, "aspectRatio": 1.0, "znear": 0.01, "zfar": 5.0})
    b.root(b.add("nodes", name="camera", camera=camera, translation=list(eye),
                 rotation=[round(x, 6) for x in looking(eye, target)]))
    return b.glb()


def place(b, name, surface, material):
    mesh = b.add("meshes", name=name, primitives=[surface.primitive(b, material)])
    b.root(b.add("nodes", name=name, mesh=mesh, scale=[0.001, 0.001, 0.001]))


def make_candle():
    b = Builder()
    wax = b.add("materials", name="wax", pbrMetallicRoughness={"metallicFactor": 0.0, "roughnessFactor": 0.45},
                extras={"translucency": {"scattering": [1.6, 1.1, 0.9], "absorption": [0.004, 0.09, 0.14], "ior": 1.4}})
    wick = b.add("materials", name="wick", pbrMetallicRoughness={"baseColorFactor": [0.03, 0.02, 0.02, 1.0], "metallicFactor": 0.0})
    b.use("KHR_materials_unlit")
    flame = b.add("materials", name="flame", extensions={"KHR_materials_unlit": {}},
                  pbrMetallicRoughness={"baseColorFactor": [1.0, 0.78, 0.35, 1.0], "metallicFactor": 0.0})
    # A pool of molten wax within the rim: the flame shines into it and through the wall.
    body = smooth([(0.0, 0.0), (0.018, 0.0), (0.02, 0.002), (0.02, 0.02), (0.0195, 0.05), (0.0197, 0.068), (0.019, 0.072),
                   (0.0175, 0.0715), (0.014, 0.066), (0.006, 0.064), (0.0, 0.0638)])
    place(b, "candle", lathe(body, 96), wax)
    place(b, "wick", lathe([(0.0, 0.063), (0.0006, 0.063), (0.0006, 0.071), (0.0, 0.0712)], 12), wick)
    place(b, "flame", lathe(smooth([(0.0, 0.0705), (0.0028, 0.074), (0.0036, 0.078), (0.0024, 0.085), (0.0, 0.092)]), 24), flame)
    fire = {"name": "fire", "type": "point", "color": [1.0, 0.72, 0.38], "intensity": 0.0035}
    return finish(b, (0.0, 0.105, 0.24), (0.0, 0.046, 0.0), [(fire, (0.0, 0.08, 0.0))])


def make_head():
    b = Builder()
    skin = b.add("materials", name="head", pbrMetallicRoughness={"metallicFactor": 0.0, "roughnessFactor": 0.4})
    place(b, "head", head(), skin)
    lamp = {"name": "lamp", "type": "point", "color": [1.0, 1.0, 1.0], "intensity": 0.012}
    return finish(b, (0.012, 0.012, 0.085), (0.0, 0.002, 0.0), [(lamp, (-0.025, 0.04, -0.05))])
