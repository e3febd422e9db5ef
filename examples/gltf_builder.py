# SPDX-License-Identifier: Apache-2.0
"""Writes small glTF 2.0 files, the same bytes on every machine. Python 3 standard library only."""

import json
import math
import struct
import zlib

FLOAT, U8, U16, U32, I8, I16 = 5126, 5121, 5123, 5125, 5120, 5122
_FORMAT = {FLOAT: "f", U8: "B", U16: "H", U32: "I", I8: "b", I16: "h"}
_WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def rounded(value):
    """Drops the last bits, in which C libraries differ."""
    return math.floor(value * 65536.0 + 0.5) / 65536.0


def flat(values):
    out = []
    for value in values:
        if isinstance(value, (list, tuple)):
            out.extend(flat(value))
        else:
            out.append(value)
    return out


def png(width, height, palette, rows):
    """An indexed PNG of up to 256 colours, in stored deflate blocks: no compressor whose output could change."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    raw = b"".join(b"\0" + bytes(row) for row in rows)
    blocks = b""
    for at in range(0, len(raw), 65535):
        part = raw[at:at + 65535]
        last = at + 65535 >= len(raw)
        blocks += struct.pack("<BHH", last, len(part), len(part) ^ 0xFFFF) + part
    stream = b"\x78\x01" + blocks + struct.pack(">I", zlib.adler32(raw))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)) +
            chunk(b"PLTE", bytes(flat(palette))) + chunk(b"IDAT", stream) + chunk(b"IEND", b""))


class Builder:
    """Collects the parts of one file; add(...) returns the index of what it added."""

    def __init__(self, generator="burin examples"):
        self.doc = {"asset": {"version": "2.0", "generator": generator}, "scene": 0, "scenes": [{"nodes": []}]}
        self.data = bytearray()

    def add(self, collection, **entry):
        self.doc.setdefault(collection, []).append(entry)
        return len(self.doc[collection]) - 1

    def use(self, extension, required=False):
        for name in ["extensionsUsed"] + (["extensionsRequired"] if required else []):
            names = self.doc.setdefault(name, [])
            if extension not in names:
                names.append(extension)

    def root(self, node):
        self.doc["scenes"][0]["nodes"].append(node)
        return node

    def view(self, data, **properties):
        self.data += b"\0" * (-len(self.data) % 4)
        offset = len(self.data)
        self.data += data
        return self.add("bufferViews", buffer=0, byteOffset=offset, byteLength=len(data), **properties)

    def pack(self, values, component):
        numbers = flat(values)
        if component == FLOAT:
            numbers = [rounded(n) for n in numbers]
        return struct.pack("<%d%s" % (len(numbers), _FORMAT[component]), *numbers)

    def accessor(self, values, kind="VEC3", component=FLOAT, bounds=False, **properties):
        count = len(flat(values)) // _WIDTH[kind]
        if bounds:
            columns = list(zip(*[[rounded(c) for c in v] if kind != "SCALAR" else [rounded(v)] for v in values]))
            properties["min"] = [min(c) for c in columns]
            properties["max"] = [max(c) for c in columns]
        return self.add("accessors", bufferView=self.view(self.pack(values, component)), componentType=component,
                        count=count, type=kind, **properties)

    def bytes4(self, values, kind="VEC4"):
        """Normalised bytes, four to an element."""
        return self.accessor(values, kind, U8, normalized=True)

    def indices(self, values):
        return self.accessor(values, "SCALAR", U16 if max(values) < 65535 else U32)

    def sparse(self, count, changes, kind="VEC3"):
        """An accessor of zeros but for {index: value}."""
        places = sorted(changes)
        return self.add("accessors", componentType=FLOAT, count=count, type=kind, sparse={
            "count": len(places),
            "indices": {"bufferView": self.view(self.pack(places, U16)), "componentType": U16},
            "values": {"bufferView": self.view(self.pack([changes[p] for p in places], FLOAT))}})

    def image(self, data, name):
        return self.add("images", name=name, mimeType="image/png", bufferView=self.view(data))

    def _json(self):
        return json.dumps(self.doc, separators=(",", ":")).encode()

    def glb(self):
        self.data += b"\0" * (-len(self.data) % 4)
        self.doc["buffers"] = [{"byteLength": len(self.data)}]
        text = self._json()
        text += b" " * (-len(text) % 4)
        body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(self.data), 0x004E4942) + self.data
        return struct.pack("<III", 0x46546C67, 2, 12 + len(body)) + body

    def gltf(self, bin_name):
        """The JSON text and the bytes of the .bin file beside it."""
        self.doc["buffers"] = [{"byteLength": len(self.data), "uri": bin_name}]
        return json.dumps(self.doc, indent=1).encode() + b"\n", bytes(self.data)


class Surface:
    """Positions, normals, texture coordinates and triangles of one mesh."""

    def __init__(self):
        self.positions, self.normals, self.uvs, self.colors, self.triangles = [], [], [], [], []

    def grid(self, columns, rows, point):
        """point(u, v) -> (position, normal) over u, v in 0..1; triangles counter-clockwise seen against the normal."""
        first = len(self.positions)
        for j in range(rows + 1):
            for i in range(columns + 1):
                u, v = i / columns, j / rows
                position, normal = point(u, v)
                self.positions.append(position)
                self.normals.append(normal)
                self.uvs.append((u, v))
        for j in range(rows):
            for i in range(columns):
                a = first + j * (columns + 1) + i
                b, c, d = a + 1, a + columns + 1, a + columns + 2
                for triangle in ((a, c, b), (b, c, d)):
                    if self._area(triangle) > 1e-12:
                        self.triangles.append(triangle)
        return self

    def _area(self, triangle):
        a, b, c = (self.positions[i] for i in triangle)
        n = cross(sub(b, a), sub(c, a))
        return dot(n, n)

    def primitive(self, builder, material, uvs=False, **attributes):
        entry = {"POSITION": builder.accessor(self.positions, bounds=True)}
        if self.normals:
            entry["NORMAL"] = builder.accessor(self.normals)
        if uvs:
            entry["TEXCOORD_0"] = builder.accessor(self.uvs, "VEC2")
        if self.colors:
            entry["COLOR_0"] = builder.bytes4(self.colors)
        entry.update(attributes)
        return {"attributes": entry, "indices": builder.indices(flat(self.triangles)), "material": material}


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scaled(a, s):
    return tuple(x * s for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(dot(a, a))
    return scaled(a, 1.0 / length)


def rotation(axis, angle):
    """A quaternion (x, y, z, w); the angle in degrees."""
    half = math.radians(angle) / 2
    return list(scaled(unit(axis), math.sin(half))) + [math.cos(half)]


def turned(*steps):
    """The product of quaternions, the first applied last."""
    x, y, z, w = steps[0]
    for X, Y, Z, W in steps[1:]:
        x, y, z, w = (w * X + x * W + y * Z - z * Y, w * Y - x * Z + y * W + z * X,
                      w * Z + x * Y - y * X + z * W, w * W - x * X - y * Y - z * Z)
    return [x, y, z, w]


def looking(eye, target):
    """The rotation of a camera or light at eye that looks at target, y up."""
    z = unit(sub(eye, target))
    x = unit(cross((0.0, 1.0, 0.0), z))
    y = cross(z, x)
    w = math.sqrt(max(0.0, 1.0 + x[0] + y[1] + z[2])) / 2
    return [(y[2] - z[1]) / (4 * w), (z[0] - x[2]) / (4 * w), (x[1] - y[0]) / (4 * w), w]
