# SPDX-License-Identifier: Apache-2.0
"""Curved surfaces from the command line: --tessellation and its options, the scenes that hold patches, and tessellate."""
import struct
import unittest

from burin_cli import SOURCE, BurinTest, read_png

SIZE = ("--size", "96x64")
BENT = "1\n2 1\n0 0 0\n0 1 0\n0.5 0 1\n0.5 1 1\n1 0 0\n1 1 0\n"
ROOF = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0.5 1 0\nv 0.5 1 1\nf 1 5 6 4\nf 2 3 6 5\n"


class Tessellation(BurinTest):
    def setUp(self):
        super().setUp()
        (self.folder / "bent.bpt").write_text(BENT)
        (self.folder / "roof.obj").write_text(ROOF)
        self.jug = SOURCE / "examples" / "jug.bpt"
        self.walk = SOURCE / "examples" / "walk.glb"

    def render(self, source, *options, name="a.png"):
        self.burin("render", source, "-o", name, *SIZE, *options)
        return (self.folder / name).read_bytes()

    def refused(self, *arguments, status=2):
        return self.burin(*arguments, status=status).stderr

    def test_patch_models_are_curved_by_default(self):
        default = self.render(self.jug)
        self.assertEqual(default, self.render(self.jug, "--tessellation", "fractional"))
        self.assertEqual(default, self.render(self.jug, "--edge-length", "8"))
        pictures = {self.render(self.jug, *o) for o in (
            (), ("--tessellation", "off"), ("--tessellation", "integer"), ("--edge-length", "20"),
            ("--tessellation-factor", "3"))}
        self.assertEqual(len(pictures), 5)

    def test_meshes_are_curved_when_asked(self):
        plain = self.render(self.walk)
        self.assertEqual(plain, self.render(self.walk, "--tessellation", "off"))
        for options in (("--tessellation", "fractional"), ("--edge-length", "6"), ("--tessellation-factor", "4")):
            self.assertNotEqual(plain, self.render(self.walk, *options), options)

    def test_one_frame_alone_is_that_of_a_full_run(self):
        options = ("--tessellation", "fractional", "--turntable", "4")
        self.burin("render", self.jug, "-o", "all.####.png", *SIZE, *options)
        alone = self.render(self.jug, *options, "--frames", "3")
        self.assertEqual(alone, (self.folder / "all.0003.png").read_bytes())

    def test_subdivision_surfaces_and_patches_are_scenes(self):
        self.assertNotEqual(self.render("roof.obj"), self.render("roof.obj", "--tessellation", "off"))
        info = self.burin("info", "bent.bpt").stdout.decode()
        self.assertIn("1 patch", info)

    def test_verbose_says_what_was_done(self):
        err = self.burin("render", "bent.bpt", "-o", "a.png", *SIZE, "--tessellation-factor", "4", "-v").stderr
        self.assertIn("burin: tessellation: 1 patches, 32 triangles in frame 1", err)
        self.assertRegex(err, r"tessellation: up to 32 triangles a frame, \S+ ms a frame, \S+ % of the time")

    def test_factors_beyond_the_range_are_clamped_with_one_warning(self):
        err = self.burin("render", "bent.bpt", "-o", "a.png", *SIZE, "--tessellation-factor", "0.25").stderr
        self.assertEqual(err.count("warning"), 1)
        self.assertIn("--tessellation-factor 0.25 is not between 1 and 256; 1 is taken", err)
        err = self.burin("tessellate", "bent.bpt", "-o", "a.ply", "--tessellation-factor", "1e9").stderr
        self.assertEqual(err.count("warning"), 1)
        self.assertIn("; 256 is taken", err)

    def test_wrong_values_are_refused(self):
        for options, text in (
                (("--tessellation", "on"), "--tessellation on: expected one of off|integer|fractional"),
                (("--tessellation-factor", "nan"), "--tessellation-factor nan: expected a number"),
                (("--tessellation-factor", "four"), "--tessellation-factor four: expected a number"),
                (("--edge-length", "inf"), "--edge-length inf: expected a number"),
                (("--edge-length", "x"), "--edge-length x: expected a number"),
                (("--edge-length", "-4"), "--edge-length: -4 is not between 0.25 and 10000"),
                (("--edge-length", "0"), "--edge-length: 0 is not between 0.25 and 10000")):
            self.assertIn(text, self.refused("tessellate", "bent.bpt", "-o", "a.ply", *options))
        self.assertIn("--edge-length: 0 is not", self.refused("render", "bent.bpt", "-o", "a.png", *options))

    def test_faulty_models_name_file_patch_and_point(self):
        (self.folder / "nan.bpt").write_text(BENT.replace("0.5 1 1", "0.5 nan 1"))
        (self.folder / "short.bpt").write_text(BENT[:-4])
        (self.folder / "bad.obj").write_text(ROOF + "f 1 2 9\n")
        for name, text in (("nan.bpt", "nan.bpt: line 6: patch 1, point 4: found 'nan', expected a finite number"),
                           ("short.bpt", "short.bpt: ends in patch 1, point 6 of 6; expected 1 patch"),
                           ("bad.obj", "bad.obj: line 9: f: vertex: index 9, but there are 6 so far")):
            for command in (("tessellate", name, "-o", "a.ply"), ("info", name)):
                self.assertIn(text, self.refused(*command, status=3))
        self.assertIn(text, self.refused("render", name, "-o", "a.png", status=3))
        self.assertFalse((self.folder / "a.png").exists() or (self.folder / "a.ply").exists())

    def test_too_much_is_refused(self):
        err = self.refused("tessellate", self.walk, "-o", "a.ply", "--tessellation-factor", "256", status=1)
        self.assertIn("over the limit of 32000000", err)
        self.assertFalse((self.folder / "a.ply").exists())

    def test_every_format_has_the_same_triangles(self):
        count = 2 * 4 * 4
        for name in ("a.obj", "a.ply", "a.glb"):
            self.burin("tessellate", "bent.bpt", "-o", name, "--tessellation", "integer", "--tessellation-factor", "4")
        self.assertEqual(sum(line.startswith("f ") for line in (self.folder / "a.obj").read_text().splitlines()), count)
        self.assertIn(f"element face {count}\n".encode(), (self.folder / "a.ply").read_bytes())
        self.assertIn(f"{count} triangles", self.burin("info", "a.glb").stdout.decode())
        self.assertIn(f"{count} triangles", self.burin("info", "a.obj").stdout.decode())

    def test_positions_keep_their_bits(self):
        for name in ("a.obj", "a.ply", "a.glb"):
            self.burin("tessellate", self.jug, "-o", name, "--tessellation-factor", "3.3")
        lines = [line.split() for line in (self.folder / "a.obj").read_text().splitlines() if line.startswith("v ")]
        written = [struct.pack("<3f", *map(float, line[1:4])) for line in lines]
        ply = (self.folder / "a.ply").read_bytes()
        body = ply[ply.index(b"end_header\n") + 11:]
        self.assertEqual(written, [body[24 * i:24 * i + 12] for i in range(len(written))])
        glb = (self.folder / "a.glb").read_bytes()
        start = 20 + struct.unpack("<I", glb[12:16])[0] + 8
        self.assertEqual(b"".join(written), glb[start:start + 12 * len(written)])

    def test_a_written_mesh_renders_as_the_surface_does(self):
        self.burin("tessellate", self.jug, "-o", "a.glb", *SIZE)
        surface = self.render(self.jug, "--edges", "off")
        rows, width, _ = read_png(self.folder / "a.png")
        self.render("a.glb", "--edges", "off", name="b.png")
        again, _, _ = read_png(self.folder / "b.png")
        self.assertTrue(surface)
        differing = sum(a[4 * x:4 * x + 4] != b[4 * x:4 * x + 4] for a, b in zip(rows, again) for x in range(width))
        self.assertLess(differing, 0.03 * width * len(rows))

    def test_stdout_takes_a_glb(self):
        self.burin("tessellate", "bent.bpt", "-o", "a.glb", "--tessellation-factor", "2")
        piped = self.burin("tessellate", "bent.bpt", "-o", "-", "--tessellation-factor", "2").stdout
        self.assertEqual(piped, (self.folder / "a.glb").read_bytes())

    def test_tessellate_says_what_is_missing(self):
        self.assertIn("no model; expected burin tessellate MODEL -o OUT", self.refused("tessellate", "-o", "a.ply"))
        self.assertIn("no output; expected -o FILE", self.refused("tessellate", "bent.bpt"))
        self.assertIn("a.stl: expected a mesh to write: .glb, .obj, .ply, or -",
                      self.refused("tessellate", "bent.bpt", "-o", "a.stl"))
        self.assertIn("two models, bent.bpt and roof.obj; expected one",
                      self.refused("tessellate", "bent.bpt", "roof.obj", "-o", "a.ply"))
        self.assertIn("--frames: 2 frames, expected one",
                      self.refused("tessellate", "bent.bpt", "-o", "a.ply", "--frames", "1-2"))
        self.assertIn("a.png: expected a model", self.refused("tessellate", "a.png", "-o", "a.ply"))
        self.assertIn("none.bpt: no such file", self.refused("tessellate", "none.bpt", "-o", "a.ply", status=3))

    def test_an_old_file_stays_when_the_model_is_faulty(self):
        (self.folder / "a.ply").write_text("old")
        (self.folder / "nan.bpt").write_text(BENT.replace("0.5 1 1", "0.5 nan 1"))
        self.refused("tessellate", "nan.bpt", "-o", "a.ply", status=3)
        self.assertEqual((self.folder / "a.ply").read_text(), "old")
        self.assertEqual(sorted(p.name for p in self.folder.iterdir() if p.name.startswith(".")), [])


if __name__ == "__main__":
    unittest.main()
