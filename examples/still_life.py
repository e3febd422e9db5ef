# SPDX-License-Identifier: Apache-2.0
"""A still life: pots, fruit, a knot and a lamp on a chequered cloth. Turned surfaces, one textured, one with vertex colours."""

import math

from gltf_builder import Builder, Surface, add, cross, looking, png, rotation, scaled, sub, unit

TAU = 2 * math.pi


def lathe(profile, around, smooth=True):
    """Turns a profile of (radius, height), bottom to top, about the y axis."""
    surface = Surface()
    rows = len(profile) - 1

    def slope(j):
        a, b = profile[max(j - 1, 0)], profile[min(j + 1, rows)]
        return (b[0] - a[0], b[1] - a[1])

    def point(u, v):
        j = round(v * rows)
        radius, height = profile[j]
        dr, dy = slope(j)
        c, s = math.sin(TAU * u), math.cos(TAU * u)
        return (radius * c, height, radius * s), unit((dy * c, -dr, dy * s))

    surface.grid(around, rows, lambda u, v: point(u, 1 - v))
    return surface


def curve(points, steps):
    """A Catmull-Rom curve through (radius, height) points, doubled at its ends."""
    through = [points[0]] + points + [points[-1]]
    out = []
    for i in range(1, len(through) - 2):
        p0, p1, p2, p3 = through[i - 1:i + 3]
        for k in range(steps):
            t = k / steps
            out.append(tuple(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t +
                                    (3 * b - a - 3 * c + d) * t ** 3) for a, b, c, d in zip(p0, p1, p2, p3)))
    return out + [points[-1]]


def sphere(radius, around, rows):
    return lathe([(radius * math.sin(math.pi * j / rows), -radius * math.cos(math.pi * j / rows))
                  for j in range(rows + 1)], around)


def knot(around, rows, tube):
    """A (2, 3) torus knot."""
    def centre(t):
        r = 0.62 + 0.25 * math.cos(3 * t)
        return (r * math.cos(2 * t), 0.25 * math.sin(3 * t), r * math.sin(2 * t))

    def point(u, v):
        t = -TAU * u
        forward = unit(sub(centre(t + 1e-3), centre(t - 1e-3)))
        side = unit(cross(forward, (centre(t)[0], 0.35, centre(t)[2])))
        up = cross(side, forward)
        angle = TAU * v
        normal = add(scaled(side, math.cos(angle)), scaled(up, math.sin(angle)))
        return add(centre(t), scaled(normal, tube)), normal

    return Surface().grid(around, rows, point)


def cloth():
    """A square with a slow wave, textured."""
    def height(x, z):
        return 0.02 * math.sin(2.1 * x + 0.6) * math.cos(1.7 * z)

    def point(u, v):
        x, z = 5.0 * (u - 0.5), 5.0 * (v - 0.5)
        e = 1e-3
        normal = unit((height(x - e, z) - height(x + e, z), 2 * e, height(x, z - e) - height(x, z + e)))
        return (x, height(x, z), z), normal

    return Surface().grid(16, 16, point)


def crystal():
    """A bipyramid with a colour at each corner, its faces apart and without normals: they are flat."""
    surface = Surface()
    ring = [(0.34 * math.cos(TAU * i / 6), 0.42, 0.34 * math.sin(TAU * i / 6)) for i in range(6)]
    hues = [(230, 60, 50), (240, 170, 40), (120, 200, 60), (40, 180, 190), (60, 90, 220), (190, 60, 200)]
    top, bottom = (0.0, 1.15, 0.0), (0.0, 0.0, 0.0)
    for i in range(6):
        j = (i + 1) % 6
        for corners in (((ring[j], hues[j]), (ring[i], hues[i]), (top, (250, 250, 250))),
                        ((ring[i], hues[i]), (ring[j], hues[j]), (bottom, (40, 40, 60)))):
            first = len(surface.positions)
            for position, colour in corners:
                surface.positions.append(position)
                surface.colors.append(tuple(colour) + (255,))
            surface.triangles.append((first, first + 1, first + 2))
    return surface


def chequers():
    palette = [(222, 214, 196), (150, 62, 52), (206, 197, 178), (136, 54, 46)]
    rows = []
    for y in range(64):
        rows.append([(((x // 16) + (y // 16)) % 2) + 2 * ((x * 7 + y * 13) % 5 == 0) for x in range(64)])
    return png(64, 64, palette, rows)


def material(b, name, color, metallic, roughness, **more):
    return b.add("materials", name=name, pbrMetallicRoughness={
        "baseColorFactor": list(color) + [1.0], "metallicFactor": metallic, "roughnessFactor": roughness}, **more)


def make():
    b = Builder()
    b.use("KHR_lights_punctual")
    b.use("KHR_materials_emissive_strength")
    b.use("KHR_texture_transform")
    sampler = b.add("samplers", magFilter=9729, minFilter=9987, wrapS=10497, wrapT=10497)
    texture = b.add("textures", sampler=sampler, source=b.image(chequers(), "chequers"))
    cloth_material = b.add("materials", name="cloth", pbrMetallicRoughness={
        "baseColorTexture": {"index": texture, "extensions": {"KHR_texture_transform": {
            "scale": [4, 4], "rotation": 0.35, "offset": [0.1, 0.0]}}},
        "metallicFactor": 0.0, "roughnessFactor": 0.95})
    clay = material(b, "terracotta", (0.55, 0.2, 0.1), 0.0, 0.85, doubleSided=True)
    glaze = material(b, "blue glaze", (0.03, 0.14, 0.35), 0.0, 0.18, doubleSided=True)
    gold = material(b, "gold", (1.0, 0.72, 0.3), 1.0, 0.22)
    copper = material(b, "brushed copper", (0.93, 0.55, 0.42), 1.0, 0.45)
    colours = material(b, "coloured crystal", (1.0, 1.0, 1.0), 0.0, 0.3)
    lamp = material(b, "lamp", (1.0, 0.9, 0.7), 0.0, 0.5, emissiveFactor=[1.0, 0.72, 0.4],
                    extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 4.0}})
    fruit = material(b, "orange", (0.9, 0.35, 0.03), 0.0, 0.55)

    vase = lathe(curve([(0.0, 0.0), (0.3, 0.0), (0.42, 0.35), (0.34, 0.8), (0.13, 1.15), (0.17, 1.4), (0.24, 1.5)], 4), 28)
    bowl = lathe(curve([(0.0, 0.0), (0.22, 0.0), (0.24, 0.06), (0.5, 0.22), (0.62, 0.44), (0.59, 0.45), (0.45, 0.24),
                        (0.0, 0.12)], 3), 32)
    ball, orange = sphere(0.36, 28, 14), sphere(0.19, 18, 9)

    def place(name, surface, mat, at, uvs=False, **more):
        mesh = b.add("meshes", name=name, primitives=[surface.primitive(b, mat, uvs)])
        return b.root(b.add("nodes", name=name, mesh=mesh, translation=list(at), **more))

    place("cloth", cloth(), cloth_material, (0, 0, 0), uvs=True)
    place("vase", vase, clay, (-0.95, 0.02, -0.35))
    place("bowl", bowl, glaze, (0.62, 0.02, 0.55))
    place("gold ball", ball, gold, (-0.35, 0.38, 0.72))
    place("knot", knot(96, 8, 0.12), copper, (0.78, 0.66, -0.85), rotation=rotation((1, 0.25, 0.3), 70), scale=[0.68, 0.68, 0.68])
    place("crystal", crystal(), colours, (-0.05, 0.02, -0.2), rotation=rotation((0, 1, 0), 20))
    first = place("orange", orange, fruit, (0.5, 0.4, 0.55))
    mesh = b.doc["nodes"][first]["mesh"]
    b.root(b.add("nodes", name="second orange", mesh=mesh, translation=[0.76, 0.39, 0.66], scale=[0.92, 0.9, 0.92]))
    b.root(b.add("nodes", name="third orange", mesh=mesh, translation=[0.63, 0.38, 0.33], scale=[-0.95, 0.95, 0.95]))
    place("lamp", sphere(0.13, 20, 10), lamp, (-0.98, 0.15, 0.98))

    b.doc["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"name": "key", "type": "directional", "color": [1.0, 0.96, 0.9], "intensity": 2.6},
        {"name": "fill", "type": "point", "color": [0.6, 0.75, 1.0], "intensity": 5.0, "range": 20.0},
        {"name": "lamp light", "type": "point", "color": [1.0, 0.7, 0.4], "intensity": 1.2, "range": 6.0},
        {"name": "spot", "type": "spot", "color": [1.0, 0.9, 0.8], "intensity": 18.0,
         "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.5}}]}}

    def light(index, at, target=(0.0, 0.4, 0.0)):
        b.root(b.add("nodes", translation=list(at), rotation=looking(at, target),
                     extensions={"KHR_lights_punctual": {"light": index}}))

    light(0, (-3.0, 5.0, 3.0))
    light(1, (3.5, 2.5, 2.5))
    light(2, (-0.98, 0.45, 0.98))
    light(3, (1.0, 4.0, -2.5))
    eye, target = (1.1, 2.15, 4.9), (-0.02, 0.55, 0.0)
    camera = b.add("cameras", name="table", type="perspective",
                   perspective={"yfov": 0.56, "aspectRatio": 1.0, "znear": 0.1, "zfar": 50.0})
    b.root(b.add("nodes", name="camera", camera=camera, translation=list(eye), rotation=looking(eye, target)))
    for node in b.doc["nodes"]:
        for key in ("rotation", "translation"):
            if key in node:
                node[key] = [round(x, 6) for x in node[key]]
    return b.glb()
