# SPDX-License-Identifier: Apache-2.0
"""Effects in the dialects of other hosts, on scenes and on pictures."""
import unittest

from burin_cli import SOURCE, BurinTest, gradient, read_png, write_png

EFFECTS = SOURCE / "tests/data/fx/dialects"
SCENE = SOURCE / "examples/still_life.glb"


class Dialects(BurinTest):
    def pixels(self, name):
        """Red, green and blue of every pixel."""
        rows, channels, _ = read_png(self.folder / name)
        return [tuple(row[at:at + 3]) for row in rows for at in range(0, len(row), channels)]

    def test_a_postprocess_script_works_on_a_picture(self):
        write_png(self.folder / "a.png", gradient(7, 5, 3), 3)
        self.burin("render", EFFECTS / "sas_invert.fx", "a.png", "-o", "b.png")
        expected = [tuple(255 - value for value in pixel) for pixel in self.pixels("a.png")]
        # Direct3D 9's half pixel is given 63/64 of its length, so that a linear filter blends 1/128 of a neighbour in.
        for actual, wanted in zip(self.pixels("b.png"), expected, strict=True):
            for a, b in zip(actual, wanted):
                self.assertLessEqual(abs(a - b), 3, (actual, wanted))

    def test_a_picture_stands_in_for_the_objects_of_a_scene(self):
        write_png(self.folder / "a.png", gradient(24, 16, 3), 3)
        result = self.burin("render", EFFECTS / "sas_plastic.fx", "a.png", "-o", "b.png")
        self.assertIn("it draws the geometry of a scene; the source is none, so the picture stands in", result.stderr)
        self.assertGreater(len(set(self.pixels("b.png"))), 30)

    def test_effects_of_every_dialect_draw_a_scene(self):
        if not SCENE.exists():
            self.skipTest(f"{SCENE} is not there")
        for name in ("d3d9_lambert.fx", "sas_plastic.fx", "cg_phong.cgfx", "d3d9_by_name.fx", "d3d9_fixed.fx",
                     "d3d9_skin.fx", "engine_stages.fx", "mme_object.fx", "mme_mask.fx", "sas_shadow.fx", "sas_bump.fx",
                     "dxsas_lights.fx", "xna_post.fx"):
            result = self.burin("render", EFFECTS / name, SCENE, "-o", "a.png", "--size", "48x32")
            self.assertGreater(len(set(self.pixels("a.png"))), 30, name)
            self.assertNotIn("burin: warning", result.stderr, name)

    def test_objects_show_their_own_colours(self):
        """The blue bowl and the red cloth, by an effect that only asks for a texture and a light."""
        if not SCENE.exists():
            self.skipTest(f"{SCENE} is not there")
        for name in ("d3d9_by_name.fx", "mme_object.fx", "sas_bump.fx"):
            self.burin("render", EFFECTS / name, SCENE, "-o", "a.png", "--size", "96x64")
            pixels = self.pixels("a.png")
            self.assertGreater(sum(b > 1.5 * r and b > 60 for r, g, b in pixels), 40, name)
            self.assertGreater(sum(r > 2 * g and r > 100 for r, g, b in pixels), 100, name)

    def test_an_offscreen_target_is_drawn_by_its_own_effect(self):
        if not SCENE.exists():
            self.skipTest(f"{SCENE} is not there")
        self.burin("render", EFFECTS / "mme_mask.fx", SCENE, "-o", "a.png", "--size", "96x64")
        pixels = self.pixels("a.png")
        self.assertGreater(sum(r >= 125 for r, g, b in pixels), 2000)     # half of red on every object
        self.assertEqual(pixels[0], (0, 0, 51))                             # half of the target's own blue behind them

    def test_a_picture_is_what_register_0_shows(self):
        write_png(self.folder / "a.png", gradient(7, 5, 3), 3)
        self.burin("render", EFFECTS / "xna_post.fx", "a.png", "-o", "b.png", "--param", "Saturation=1")
        for actual, wanted in zip(self.pixels("b.png"), self.pixels("a.png"), strict=True):
            for a, b in zip(actual, wanted):
                self.assertLessEqual(abs(a - b), 1, (actual, wanted))

    def test_a_file_that_an_effect_names_is_missed_but_one_that_is_asked_for_must_be_there(self):
        write_png(self.folder / "a.png", gradient(7, 5, 3), 3)
        effect = self.folder / "e.fx"
        effect.write_text('texture t < string ResourceName = "stone.dds"; >; sampler s = sampler_state { Texture = <t>; };'
                          "float4 PS(float2 u : TEXCOORD0) : COLOR { return tex2D(s, u); }"
                          "technique T { pass { PixelShader = compile ps_2_0 PS(); } }")
        result = self.burin("render", effect, "a.png", "-o", "b.png", "-I", "pictures")
        self.assertIn("texture 't' names a file that is not there ('stone.dds' not found; searched: ", result.stderr)
        self.assertIn("pictures): what is drawn gives its own", result.stderr)
        result = self.burin("render", effect, "a.png", "-o", "b.png", "--texture", "t=none.png", status=3)
        self.assertIn("'none.png' not found; searched: ", result.stderr)

    def test_info_says_what_a_user_may_set(self):
        result = self.burin("info", EFFECTS / "sas_bump.fx")
        self.assertIn("float Height = 1   (0 to 3 in steps of 0.01)", result.stdout.decode())

    def test_values_outside_the_effects_limits_are_said(self):
        write_png(self.folder / "a.png", gradient(7, 5, 3), 3)
        result = self.burin("render", EFFECTS / "sas_bloom.fx", "a.png", "-o", "b.png", "--param", "Glow=9")
        self.assertIn("parameter 'Glow' is 9, above its greatest 2", result.stderr)

    def test_a_texture_takes_a_picture(self):
        write_png(self.folder / "a.png", gradient(7, 5, 3), 3)
        effect = EFFECTS / "d3d9_macros.fx"
        self.burin("render", effect, "-o", "b.png", "--size", "8x8")
        self.burin("render", effect, "-o", "c.png", "--size", "8x8", "--texture", "FirstTex=a.png")
        self.assertNotEqual(self.pixels("b.png"), self.pixels("c.png"))


if __name__ == "__main__":
    unittest.main()
