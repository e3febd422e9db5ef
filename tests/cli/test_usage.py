# SPDX-License-Identifier: Apache-2.0
"""Commands, options and exit status 2: what is refused before anything runs, and what comes at once."""
import os
import subprocess
import unittest

from burin_cli import PROGRAM, BurinTest, gradient, identity, write_png


class Usage(BurinTest):
    def refused(self, *arguments, message, status=2):
        result = self.burin(*arguments, status=status)
        self.assertEqual(result.stdout, b"")
        self.assertIn(message, result.stderr)
        return result

    def test_no_command_shows_the_commands(self):
        result = self.burin(status=2)
        self.assertIn("Usage: burin COMMAND", result.stderr)

    def test_help_goes_to_stdout(self):
        for arguments in (["help"], ["--help"], ["help", "render"], ["render", "--help"], ["check", "-h"]):
            result = self.burin(*arguments)
            self.assertTrue(result.stdout.startswith((b"burin renders", b"Usage: burin")), arguments)
            self.assertEqual(result.stderr, "")
        self.assertEqual(self.burin("help", "render").stdout, self.burin("render", "--help").stdout)

    def test_version_is_one_line(self):
        self.assertRegex(self.burin("--version").stdout, rb"\Aburin \d+\.\d+\.\d+\n\Z")

    def test_unknown_words_are_refused_with_the_nearest(self):
        self.refused("rendr", message="unknown command 'rendr', did you mean render?")
        self.refused("help", "rendr", message="no command 'rendr'; did you mean render?")
        self.refused("render", "--sise", "1x1", message="unknown option --sise; did you mean --size?")
        self.refused("--vershun", message="unknown option '--vershun'")

    def test_malformed_values_are_refused(self):
        self.refused("render", "a.png", "-o", "b.png", "--size", "big", message="--size big: expected WIDTHxHEIGHT")
        self.refused("render", "a.png", "-o", "b.png", "--frames", "1:10", message="'a:b' is not a range; write 1-10")
        self.refused("render", "a.png", "-o", "b.png", "--progress-fd", "77", message="--progress-fd 77: Bad file descriptor")
        self.refused("render", "a.glb", "-o", "b.png", "--samples", "8", message="--samples 8: expected one of 1|4|16")
        self.refused("render", "a.png", "-o", message="--output needs a value: --output FILE")

    def test_a_macro_or_parameter_needs_a_name(self):
        for option in ("--define", "--param"):
            self.refused("render", "a.png", "-o", "b.png", option, "9x=1", message=f"{option} 9x=1")

    def test_nothing_to_do_is_refused(self):
        self.refused("render", message="no output; expected -o FILE")
        self.refused("render", "-o", "a.png", message="nothing to render: no source and no effect")
        self.refused("check", message="no effect; expected burin check EFFECT.fx")
        self.refused("info", message="no file; expected burin info FILE")

    def test_two_sources_are_refused(self):
        self.refused("render", "a.glb", "b.glb", "-o", "c.png", message="two sources, a.glb and b.glb; expected one")

    def test_outputs_that_cannot_be_are_refused_before_rendering(self):
        write_png(self.folder / "a.png", gradient(5, 3, 3), 3)
        self.refused("render", "a.png", "-o", "b.doc", message="b.doc: unknown extension .doc")
        self.refused("render", "a.png", "--frames", "1-3", "-o", "b.png",
                     message="3 frames need a name with a place for the number, such as b.####.png")
        self.refused("render", "a.png", "-o", "b.mp4", message="H.264 needs an even width and height, the frame is 5x3")
        self.refused("render", "a.png", "-o", "b.mkv", "--depth", "16", message="video holds 8 bits a channel, not 16")
        self.refused("render", "a.png", "-o", "b.mkv", "--alpha", "keep", message="video holds no alpha")
        self.refused("render", "a.png", "-o", "b.jpg", "--depth", "16", message="b.jpg")
        self.refused("render", "a.png", "-o", "b.png", "--attributes", "color,alpha", message="2 attributes need layers")
        self.refused("render", "a.png", "-o", "b.exr", "--attributes", "colour", message="unknown attribute 'colour'")
        self.refused("render", "a.png", "-o", "b/##/c.png", message="stands in a folder's name")
        self.assertEqual(self.names(), ["a.png"])

    def test_places_that_cannot_be_written_fail(self):
        write_png(self.folder / "a.png", gradient(5, 3, 3), 3)
        self.refused("render", "a.png", "-o", "none/b.png", status=1, message="the folder none is not there; --mkdir makes it")
        (self.folder / "taken.png").mkdir()
        self.refused("render", "a.png", "-o", "taken.png", status=1, message="taken.png: is no regular file")
        if os.geteuid() != 0:
            (self.folder / "locked").mkdir(mode=0o555)
            self.refused("render", "a.png", "-o", "locked/b.png", status=1, message="cannot write in the folder locked")
        self.burin("render", "a.png", "-o", "made/deep/b.png", "--mkdir")
        self.assertIn("made/deep/b.png", self.names())

    def test_inputs_that_are_not_there_have_status_3(self):
        self.refused("render", "none.png", "-o", "b.png", status=3, message="none.png: no such file")
        self.refused("render", "none.####.png", "-o", "b.####.png", status=3, message="no file has such a name")
        self.refused("render", "none.glb", "-o", "b.png", status=3, message="none.glb: no such file")
        self.refused("render", "none.fx", "-o", "b.png", status=3, message="none.fx: no such file, and no shipped effect")
        self.refused("check", "none.fx", status=3, message="none.fx: no such file, and no shipped effect")
        self.refused("info", "none.exr", status=3, message="none.exr: no such file")

    def test_unknown_parameters_and_techniques_are_refused(self):
        self.write("e.fx", "float Width = 1;\n" + identity())
        write_png(self.folder / "a.png", gradient(5, 3, 3), 3)
        self.refused("render", "e.fx", "a.png", "-o", "b.png", "--param", "Widht=2", message="--param Widht: ")
        self.refused("render", "e.fx", "a.png", "-o", "b.png", "--technique", "Other",
                     message="--technique Other: no such technique; there are: Identity")
        self.refused("render", "a.png", "-o", "b.png", "--param", "a=2", message="--param a: there is no effect")

    def test_completion_is_valid_bash(self):
        script = self.burin("completion", "bash").stdout
        subprocess.run(["bash", "-n"], input=script, check=True)
        self.refused("completion", "tcl", message="expected the shell's name: bash")


class Starting(BurinTest):
    def test_light_commands_load_no_heavy_library(self):
        self.write("e.fx", identity())
        for arguments in (["--version"], ["help"], ["help", "render"], ["check", "e.fx"], ["effects"], ["render", "--nope"]):
            environment = self.environment()
            environment["LD_DEBUG"] = "files"
            result = subprocess.run([PROGRAM, *arguments], cwd=self.folder, env=environment, capture_output=True, timeout=60)
            trace = result.stderr.decode(errors="replace")
            for library in ("OpenImageIO", "opencv", "libEGL", "OpenColorIO"):
                self.assertNotIn(library, trace, arguments)


if __name__ == "__main__":
    unittest.main()
