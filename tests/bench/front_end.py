#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the effect language's front end, text to GLSL, against glslang's HLSL mode in one run. Never a test.

usage: front_end.py [--burin PATH] [--runs N] [--lines N]
One effect of some 500 lines and the same functions as HLSL for glslangValidator -D (package glslang-tools). Start-up is
taken off both: burin checks many copies in one call and one copy in another, glslangValidator --version is timed too.
Commands run in turn, A B A B ...; medians, and the median of the pair-by-pair ratios.
"""
import argparse
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
COPIES = 101

FUNCTION = """
float4 Step{i}(float4 color, float2 uv, float weight)
{{
    float2 offset = float2({i}.0, {i}.5) / Size;
    float4 a = SAMPLE(uv + offset);
    float4 b = SAMPLE(uv - offset);
    float luma = dot(lerp(a, b, weight).rgb, float3(0.299, 0.587, 0.114));
    if (luma > 0.5 * weight)
        color.rgb += saturate(a.rgb - b.rgb) * luma;
    else
        color.rgb = pow(abs(color.rgb), 1.0 + 0.1 * weight);
    for (int i = 0; i < 3; i++)
        color.rgb = color.rgb * 0.9 + normalize(a.rgb + i) * 0.1;
    return clamp(color, 0.0, 1.0);
}}
"""


def functions(lines):
    count = max(1, (lines - 30) // (FUNCTION.count("\n") - 1))
    body = "".join(FUNCTION.format(i=i) for i in range(count))
    calls = "".join(f"    color = Step{i}(color, uv, Weights[{i % 4}]);\n" for i in range(count))
    return body, "    float4 color = SAMPLE(uv);\n" + calls + "    return color;\n"


def effect_text(lines):
    body, calls = functions(lines)
    return ("texture Picture;\nsampler2D Source = sampler_state { Texture = <Picture>; MinFilter = LINEAR; };\n"
            "float2 Size = { 640, 480 };\nfloat4 Weights = { 0.1, 0.2, 0.3, 0.4 };\n"
            "#define SAMPLE(p) tex2D(Source, p)\n" + body +
            "float4 PS(float2 uv : TEXCOORD0) : COLOR\n{\n" + calls + "}\n"
            "technique T { pass P { ZEnable = false; PixelShader = compile ps_3_0 PS(); } }\n")


def hlsl_text(lines):
    body, calls = functions(lines)
    return ("Texture2D Picture; SamplerState Source;\nfloat2 Size;\nfloat4 Weights;\n"
            "#define SAMPLE(p) Picture.Sample(Source, p)\n" + body +
            "float4 PS(float2 uv : TEXCOORD0) : SV_Target\n{\n" + calls + "}\n")


def wall(command):
    start = time.perf_counter()
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    seconds = time.perf_counter() - start
    if done.returncode != 0:
        sys.exit(f"front_end: {' '.join(command[:6])} exited {done.returncode}:\n{done.stdout[-2000:]}")
    return seconds


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--burin", default=str(ROOT / "build/release/bin/burin"))
    options.add_argument("--runs", type=int, default=9)
    options.add_argument("--lines", type=int, default=500)
    options = options.parse_args()
    if shutil.which("glslangValidator") is None:
        sys.exit("front_end: no glslangValidator (package glslang-tools)")
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work)
        text = effect_text(options.lines)
        files = []
        for i in range(COPIES):
            path = folder / f"effect{i}.fx"
            path.write_text(text)
            files.append(str(path))
        hlsl = folder / "shader.hlsl"
        hlsl.write_text(hlsl_text(options.lines))
        glslang = ["glslangValidator", "-D", "-S", "frag", "-e", "PS", "-V", "--auto-map-bindings", "--auto-map-locations",
                   "-o", str(folder / "out.spv"), str(hlsl)]
        ours, theirs, ratios, batch = [], [], [], []
        for _ in range(options.runs):
            one = wall([options.burin, "check", "-q", files[0]])
            many = wall([options.burin, "check", "-q", *files])
            peer = wall(glslang) - wall(["glslangValidator", "--version"])
            ours.append((many - one) / (COPIES - 1))
            theirs.append(peer)
            ratios.append(peer / ours[-1])
            batch.append(many / COPIES * 100)
        print(f"{text.count(chr(10))} lines, medians of {options.runs} runs")
        print(f"  burin check, an effect           {statistics.median(ours) * 1e3:8.2f} ms")
        print(f"  glslangValidator -D, the shader  {statistics.median(theirs) * 1e3:8.2f} ms")
        print(f"  ratio                            {statistics.median(ratios):8.1f}")
        print(f"  burin check, 100 files, start-up included {statistics.median(batch):6.3f} s")


if __name__ == "__main__":
    main()
