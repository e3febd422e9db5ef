# SPDX-License-Identifier: Apache-2.0
"""burin check, info and effects, and effects with errors: places, several messages in a run, status 3."""
import json
import re
import unittest

from burin_cli import BurinTest, gradient, identity, write_png

PLACE = r"^{}:(\d+):(\d+): error: "


class Check(BurinTest):
    def errors(self, name, text, *arguments):
        self.write(name, text)
        result = self.burin("check", name, *arguments, status=3)
        self.assertEqual(result.stdout, b"")
        return result.stderr

    def lines_of(self, stderr, name):
        return [int(line) for line, _ in re.findall(PLACE.format(re.escape(name)), stderr, re.MULTILINE)]

    def test_a_good_effect_has_status_0(self):
        self.write("e.fx", identity())
        result = self.burin("check", "e.fx")
        self.assertEqual((result.stdout, result.stderr), (b"", "e.fx: good\n"))
        self.assertEqual(self.burin("check", "e.fx", "-q").stderr, "")

    def test_a_syntax_error_has_line_column_and_caret(self):
        stderr = self.errors("e.fx", "float a = 1\nfloat b = 2;\n")
        self.assertEqual(self.lines_of(stderr, "e.fx")[0] in (1, 2), True, stderr)
        self.assertRegex(stderr, r"(?m)^\s*(\d+ \| )?\s*\^")

    def test_several_errors_in_one_run(self):
        stderr = self.errors("e.fx", "float4 A(float2 uv : TEXCOORD0) : COLOR { return nope; }\n"
                                     "float4 B(float2 uv : TEXCOORD0) : COLOR { return uv.q9; }\n"
                                     "technique T { pass P { PixelShader = compile ps_2_0 A(); } }\n"
                                     "technique U { pass P { PixelShader = compile ps_2_0 B(); } }\n")
        self.assertEqual(self.lines_of(stderr, "e.fx"), [1, 2], stderr)

    def test_errors_are_mapped_through_includes_and_macros(self):
        self.write("inc/part.fxh", "\n\nfloat4 Bad() { return missing; }\n")
        stderr = self.errors("e.fx", '#include "part.fxh"\n' + identity(), "-I", "inc")
        self.assertEqual(self.lines_of(stderr, "inc/part.fxh"), [3], stderr)
        self.assertIn("e.fx:1", stderr)
        stderr = self.errors("m.fx", "#define BROKEN missing\n\nfloat4 Bad() { return BROKEN; }\n" + identity())
        self.assertEqual(self.lines_of(stderr, "m.fx"), [3], stderr)
        self.assertIn("BROKEN", stderr)

    def test_a_missing_include_names_the_folders(self):
        (self.folder / "inc").mkdir()
        stderr = self.errors("e.fx", '#include "gone.fxh"\n' + identity(), "-I", "inc")
        self.assertIn("gone.fxh", stderr)
        self.assertIn("inc", stderr)
        self.assertEqual(self.lines_of(stderr, "e.fx"), [1], stderr)

    def test_glsl_writes_the_shaders_of_every_pass(self):
        self.write("e.fx", "float4 A(float2 uv : TEXCOORD0) : COLOR { return uv.xyxy; }\n"
                           "technique First { pass P { PixelShader = compile ps_2_0 A(); } pass { PixelShader = compile "
                           "ps_2_0 A(); } }\ntechnique { pass P { PixelShader = compile ps_2_0 A(); } }\n")
        self.burin("check", "e.fx", "--glsl", "out/glsl", "-q")
        names = sorted(path.name for path in (self.folder / "out/glsl").iterdir())
        self.assertEqual(names, ["e.1.P.frag", "e.1.P.vert", "e.First.1.frag", "e.First.1.vert", "e.First.P.frag",
                                 "e.First.P.vert"])
        self.assertTrue((self.folder / "out/glsl/e.1.P.frag").read_text().startswith("#version 450 core"))
        self.write("file", "")
        self.assertIn("'file'", self.burin("check", "e.fx", "--glsl", "file", status=1).stderr)

    def test_include_cycles_end(self):
        self.write("a.fxh", '#include "b.fxh"\n')
        self.write("b.fxh", '#include "a.fxh"\n')
        stderr = self.errors("e.fx", '#include "a.fxh"\n' + identity())
        self.assertIn("error", stderr)

    def test_unknown_attributes_and_formats(self):
        stderr = self.errors("e.fx", "texture GBAnormall_A8R8G8B8;\n" + identity())
        self.assertEqual(self.lines_of(stderr, "e.fx"), [1], stderr)
        self.assertIn("normall", stderr)
        self.assertIn("normal", stderr.replace("normall", ""))
        stderr = self.errors("f.fx", "texture GBAnormal_A8R8G8B9;\n" + identity())
        self.assertEqual(self.lines_of(stderr, "f.fx"), [1], stderr)

    def test_a_result_of_a_pass_that_is_not_there(self):
        stderr = self.errors("e.fx", "texture PASS7_A8R8G8B8;\n" + identity())
        self.assertEqual(self.lines_of(stderr, "e.fx")[0], 1, stderr)

    def test_reading_what_the_pass_writes(self):
        stderr = self.errors("e.fx", "texture PASS0_A8R8G8B8;\nsampler S = sampler_state { Texture = <PASS0_A8R8G8B8>; };\n"
                                     "float4 F(float2 uv : TEXCOORD0) : COLOR { return tex2D(S, uv); }\n"
                                     "technique T { pass P { PixelShader = compile ps_2_0 F(); } }\n")
        self.assertIn("PASS0_A8R8G8B8", stderr)

    def test_binary_rubbish_is_refused(self):
        (self.folder / "e.fx").write_bytes(bytes(range(256)) * 40)
        self.assertIn("error", self.burin("check", "e.fx", status=3).stderr)

    def test_an_effect_without_a_technique_cannot_render(self):
        self.write("empty.fx", "float Unused;\n")
        self.burin("check", "empty.fx")
        result = self.burin("render", "empty.fx", "-o", "b.png", status=3)
        self.assertIn("empty.fx: ", result.stderr)
        self.assertIn("technique", result.stderr)

    def test_json_has_every_diagnostic(self):
        self.write("e.fx", "float4 A() { return nope; }\n" + identity())
        report = json.loads(self.burin("check", "e.fx", "--json", status=3).stdout)
        self.assertEqual(report[0]["file"], "e.fx")
        self.assertEqual(report[0]["errors"], 1)
        self.assertEqual(report[0]["diagnostics"][0]["line"], 1)
        self.assertEqual(report[0]["diagnostics"][0]["severity"], "error")

    def test_no_colours_without_a_terminal(self):
        self.assertNotIn("\x1b", self.errors("e.fx", "float4 A() { return nope; }\n"))

    def test_render_refuses_a_broken_effect_and_writes_nothing(self):
        self.write("e.fx", "technique T { pass P { PixelShader = compile ps_2_0 Gone(); } }\n")
        write_png(self.folder / "a.png", gradient(5, 3, 3), 3)
        result = self.burin("render", "e.fx", "a.png", "-o", "b.png", status=3)
        self.assertEqual(self.lines_of(result.stderr, "e.fx"), [1], result.stderr)
        self.assertIn("burin: error: e.fx: 1 error\n", result.stderr)
        self.assertEqual(self.names(), ["a.png", "e.fx"])


class Info(BurinTest):
    def test_an_effect_in_words_json_and_dot(self):
        self.write("e.fx", "float Width = 2.5;\n" + identity())
        text = self.burin("info", "e.fx").stdout.decode()
        self.assertIn("float Width = 2.5", text)
        self.assertIn("GBAcolor_A8R8G8B8   attribute color, A8R8G8B8, frame size", text)
        self.assertIn("Identity   used; its frame is display-encoded", text)
        self.assertIn("GBAcolor_A8R8G8B8 -> the frame", text)
        report = json.loads(self.burin("info", "e.fx", "--json").stdout)
        self.assertEqual(report["textures"][0]["attribute"], "color")
        self.assertEqual(report["techniques"][0]["passes"][0]["reads"], ["GBAcolor_A8R8G8B8"])
        dot = self.burin("info", "e.fx", "--dot").stdout.decode()
        self.assertIn("digraph", dot)
        self.assertIn("-> frame;", dot)

    def test_an_image(self):
        write_png(self.folder / "a.png", gradient(5, 3, 4), 4)
        report = json.loads(self.burin("info", "a.png", "--json").stdout)
        self.assertEqual((report["width"], report["height"], report["alpha"]), (5, 3, True))

    def test_several_files_make_one_json_list(self):
        write_png(self.folder / "a.png", gradient(5, 3, 4), 4)
        self.write("e.fx", identity())
        self.assertEqual(len(json.loads(self.burin("info", "a.png", "e.fx", "--json").stdout)), 2)


class Shipped(BurinTest):
    def test_every_shipped_effect_is_listed_and_good(self):
        listed = json.loads(self.burin("effects", "--json").stdout)
        names = [effect["name"] for effect in listed]
        self.assertIn("edges/sobel", names)
        self.assertEqual(names, sorted(names))
        for effect in listed:
            self.assertTrue(effect["purpose"], effect["name"])
            self.burin("check", effect["name"])

    def test_a_line_each(self):
        lines = self.burin("effects", "sobel").stdout.decode().splitlines()
        self.assertTrue(any(re.match(r"edges/sobel\s+\S", line) for line in lines), lines)

    def test_a_name_is_enough(self):
        write_png(self.folder / "a.png", gradient(9, 7, 3), 3)
        for number, name in enumerate(("edges/sobel", "edges/sobel.fx", "sobel")):
            self.burin("render", name, "a.png", "-o", f"{number}.png")
        self.assertEqual((self.folder / "0.png").read_bytes(), (self.folder / "2.png").read_bytes())
        self.assertEqual((self.folder / "0.png").read_bytes(), (self.folder / "1.png").read_bytes())
        self.assertIn("did you mean", self.burin("render", "sobbel", "a.png", "-o", "b.png", status=3).stderr)


if __name__ == "__main__":
    unittest.main()
