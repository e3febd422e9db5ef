# SPDX-License-Identifier: Apache-2.0
"""What the command-line tests share: running the program, and small readers and writers of PNG, y4m and EXR headers.

Nothing but Python's standard library, so that the pixels are looked at by other code than the program's own.
Environment: BURIN_PROGRAM, BURIN_SOURCE_DIR; BURIN_SHARED_DATA for parts that need real files.
"""
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

LEAK_CHECKER_CRASHED = b"LeakSanitizer has encountered a fatal error"
PROGRAM = os.environ.get("BURIN_PROGRAM", "burin")
SOURCE = pathlib.Path(os.environ.get("BURIN_SOURCE_DIR", pathlib.Path(__file__).resolve().parents[2]))
SHARED = pathlib.Path(os.environ.get("BURIN_SHARED_DATA", SOURCE / ".." / "shared" / "data"))
SCENES = SOURCE / "tests" / "data" / "scene"

IDENTITY = """
texture GBAcolor_%(format)s;
sampler Source = sampler_state { Texture = <GBAcolor_%(format)s>;
  MinFilter = Point; MagFilter = Point; AddressU = Clamp; AddressV = Clamp; };
float4 Copy(float2 uv : TEXCOORD0) : COLOR { return tex2D(Source, uv); }
technique Identity { pass P0 { PixelShader = compile ps_2_0 Copy(); } }
"""
INVERT = """
texture GBAcolor_A8R8G8B8;
sampler Source = sampler_state { Texture = <GBAcolor_A8R8G8B8>;
  MinFilter = Point; MagFilter = Point; AddressU = Clamp; AddressV = Clamp; };
float4 Invert(float2 uv : TEXCOORD0) : COLOR { float4 c = tex2D(Source, uv); return float4(1 - c.rgb, c.a); }
technique Main { pass P0 { PixelShader = compile ps_2_0 Invert(); } }
"""
# The red channel is the frame's number, so that every output says which frame it is.
NUMBERS = """
float FrameNumber : FRAME;
float Frame;
float4 Fill(float2 uv : TEXCOORD0) : COLOR { return float4(Frame / 255.0, uv.x, uv.y, 1); }
technique Main { pass P0 { PixelShader = compile ps_2_0 Fill(); } }
"""


def identity(name="A8R8G8B8"):
    return IDENTITY % {"format": name}


class BurinTest(unittest.TestCase):
    """A test in a folder of its own, which is the working folder of the program."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="burin_cli_"))
        self.addCleanup(shutil.rmtree, self.folder, True)

    def environment(self):
        environment = dict(os.environ)
        for name in ("OCIO", "BURIN_EFFECTS_PATH", "NO_COLOR"):
            environment.pop(name, None)
        return environment

    def burin(self, *arguments, status=0, stdin=None, **options):
        """Runs the program; the result's stdout is bytes, its stderr text."""
        environment = self.environment()
        environment.update(options.pop("env", {}))
        for attempt in range(4):
            if attempt == 3:
                environment["ASAN_OPTIONS"] = environment.get("ASAN_OPTIONS", "") + ":detect_leaks=0"
            result = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, input=stdin,
                                    stdin=None if stdin is not None else subprocess.DEVNULL,
                                    capture_output=True, timeout=300, env=environment, **options)
            # The leak checker itself can crash while it stops the libraries' threads at exit: it has then checked
            # nothing. A leak that it finds is reported in other words, and fails. Where it crashes time and again the
            # command is judged without it.
            if LEAK_CHECKER_CRASHED not in result.stderr:
                break
            print(f"burin_cli: the leak checker crashed, once more: {arguments}", file=sys.stderr)
        result.stderr = result.stderr.decode(errors="replace")
        self.assertEqual(result.returncode, status,
                         f"burin {' '.join(map(str, arguments))}\n{result.stderr}\n{result.stdout[:500]!r}")
        return result

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def names(self):
        """Every file in the folder, hidden ones too."""
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*") if path.is_file())

    def shared(self, name):
        path = SHARED / name
        if not path.exists():
            self.skipTest(f"{path} is not there")
        return path


def gradient(width, height, channels, maximum=255, seed=1):
    """Rows of samples without any symmetry."""
    rows = []
    state = seed
    for _ in range(height):
        row = []
        for _ in range(width * channels):
            state = (state * 1103515245 + 12345) & 0x7FFFFFFF
            row.append((state >> 8) % (maximum + 1))
        rows.append(row)
    return rows


PNG_CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}


def write_png(path, rows, channels, bits=8):
    """PNG (W3C, 2nd edition) with filter 0 in every row."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    color_type = {count: kind for kind, count in PNG_CHANNELS.items()}[channels]
    width = len(rows[0]) // channels
    pack = (lambda row: bytes(row)) if bits == 8 else (lambda row: struct.pack(f">{len(row)}H", *row))
    data = b"".join(b"\0" + pack(row) for row in rows)
    header = struct.pack(">IIBBBBB", width, len(rows), bits, color_type, 0, 0, 0)
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b""))


def unfilter(kind, row, above, step):
    """One row by its filter (PNG, clause 9)."""
    for i, value in enumerate(row):
        left = row[i - step] if i >= step else 0
        up = above[i]
        corner = above[i - step] if i >= step else 0
        if kind == 1:
            value += left
        elif kind == 2:
            value += up
        elif kind == 3:
            value += (left + up) // 2
        elif kind == 4:
            guess = left + up - corner
            distances = (abs(guess - left), abs(guess - up), abs(guess - corner))
            value += (left, up, corner)[distances.index(min(distances))]
        row[i] = value & 255


def read_png(path):
    """(rows, channels, bits) of a PNG without interlace or palette."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, color_type, _, _, interlace = struct.unpack(">IIBBBBB", body)
            assert interlace == 0
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    channels = PNG_CHANNELS[color_type]
    stride, step = width * channels * bits // 8, channels * bits // 8
    raw, rows, above = zlib.decompress(packed), [], bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        row = bytearray(raw[start + 1:start + 1 + stride])
        unfilter(raw[start], row, above, step)
        rows.append(list(row) if bits == 8 else list(struct.unpack(f">{stride // 2}H", row)))
        above = row
    return rows, channels, bits


def write_y4m(frames, width, height, rate="25:1", chroma="444"):
    """A YUV4MPEG2 stream; each frame is the bytes of its planes."""
    return f"YUV4MPEG2 W{width} H{height} F{rate} Ip A1:1 C{chroma}\n".encode() + b"".join(b"FRAME\n" + f for f in frames)


def read_y4m(data):
    """(header fields, frames) of a 4:4:4 or 4:2:0 stream."""
    end = data.index(b"\n")
    fields = {field[:1]: field[1:] for field in data[:end].decode().split(" ")[1:]}
    width, height = int(fields["W"]), int(fields["H"])
    chroma = (width + 1) // 2 * ((height + 1) // 2) if fields.get("C", "420").startswith("420") else width * height
    size, at, frames = width * height + 2 * chroma, end + 1, []
    while at < len(data):
        line = data.index(b"\n", at)
        assert data[at:line].startswith(b"FRAME"), data[at:line]
        frames.append(data[line + 1:line + 1 + size])
        at = line + 1 + size
    return fields, frames


def grey_frames(count, width, height):
    """4:4:4 frames, each of one grey that grows with its number, neutral chroma."""
    return [bytes([40 + 10 * i]) * (width * height) + bytes([128]) * (2 * width * height) for i in range(count)]


def read_exr_channels(path):
    """{channel name: pixel type} of a single-part OpenEXR file (OpenEXR file layout, "chlist"); 0 uint, 1 half, 2 float."""
    data = pathlib.Path(path).read_bytes()
    assert data[:4] == b"\x76\x2f\x31\x01", path
    at = 8

    def text():
        nonlocal at
        end = data.index(b"\0", at)
        value = data[at:end].decode()
        at = end + 1
        return value

    while data[at] != 0:
        name, kind = text(), text()
        size, = struct.unpack("<I", data[at:at + 4])
        at += 4
        stop = at + size
        if (name, kind) == ("channels", "chlist"):
            channels = {}
            while data[at] != 0:
                channel = text()
                channels[channel], = struct.unpack("<I", data[at:at + 4])
                at += 16
            return channels
        at = stop
    raise AssertionError(f"{path}: no channels")
