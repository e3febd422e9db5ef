#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures burin against its peers in one run and prints a table of ratios. Never a test: machines are noisy.

usage: bench.py [--burin PATH] [--runs N] [--work FOLDER]
Peers: ffmpeg (package ffmpeg) and oiiotool (package openimageio-tools). Commands of a pair run in turn, A B A B ...;
the table gives each side's median and the median of the pair-by-pair ratios.
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


def run_once(command):
    """Wall seconds and peak memory (MiB) of one shell command, output discarded."""
    start = time.perf_counter()
    process = subprocess.Popen(["/bin/sh", "-c", "exec " + command if "|" not in command else command],
                               stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    _, errors = process.communicate()
    wall = time.perf_counter() - start
    if process.returncode != 0:
        sys.exit(f"bench: '{command}' exited {process.returncode}:\n{errors.decode(errors='replace')}")
    return wall


def memory_of(command):
    """Peak resident MiB of one command, measured in a fresh interpreter so that earlier runs don't count."""
    code = ("import resource,subprocess,sys;subprocess.run(sys.argv[1],shell=True,check=True,stdout=subprocess.DEVNULL,"
            "stderr=subprocess.DEVNULL);print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)")
    result = subprocess.run([sys.executable, "-c", code, command], capture_output=True, text=True, check=True)
    return int(result.stdout) / 1024


def compare(name, ours, theirs, runs, bound):
    run_once(ours), run_once(theirs)
    pairs = [(run_once(ours), run_once(theirs)) for _ in range(runs)]
    a, b = (statistics.median(column) for column in zip(*pairs))
    ratio = statistics.median(x / y for x, y in pairs)
    print(f"{name:<44} {a:>9.3f} s {b:>9.3f} s {ratio:>8.3f}   {bound}", flush=True)
    return ratio


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--burin", default=str(ROOT / "build/release/bin/burin"))
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--work", help="folder for the inputs, kept (default: a temporary one)")
    options = parser.parse_args()
    for tool in ("ffmpeg", "oiiotool"):
        if not shutil.which(tool):
            sys.exit(f"bench: {tool} is not installed (apt-get install ffmpeg openimageio-tools)")
    burin = options.burin
    work = pathlib.Path(options.work or tempfile.mkdtemp(prefix="burin-bench-"))
    work.mkdir(parents=True, exist_ok=True)
    clip, tile, long_clip = work / "clip1080.mp4", work / "tile.png", work / "long.mp4"
    quiet = "ffmpeg -v error -nostdin -y"
    if not clip.exists():
        run_once(f"{quiet} -f lavfi -i testsrc2=size=1920x1080:rate=30 -frames:v 120 -pix_fmt yuv420p {clip}")
    if not tile.exists():
        run_once(f"{quiet} -f lavfi -i testsrc2=size=64x64 -frames:v 1 {tile}")
    if not long_clip.exists():
        run_once(f"{quiet} -f lavfi -i testsrc2=size=640x360:rate=30 -frames:v 300 -pix_fmt yuv420p {long_clip}")

    print(f"{'what (A against B)':<44} {'A':>11} {'B':>11} {'A/B':>8}   bound")
    sobel = f"{burin} render -q {ROOT}/effects/edges/sobel.fx {clip} -o -"
    compare("1080p Sobel of 120 frames, y4m: burin, ffmpeg", f"{sobel} >/dev/null",
            f"ffmpeg -v error -nostdin -i {clip} -vf format=gbrp,sobel -f yuv4mpegpipe -pix_fmt yuv444p - >/dev/null",
            options.runs, "<= 0.5")
    for arguments in ("--version", "help", f"check {ROOT}/effects/edges/sobel.fx"):
        label = arguments.split("/")[0].replace(str(ROOT), "").strip()
        compare(f"burin {label}, oiiotool --version", f"{burin} {arguments}", "oiiotool --version", options.runs, "<= 0.3")
    compare("64x64 PNG through one pass, oiiotool copy",
            f"{burin} render -q {ROOT}/effects/basic/identity.fx {tile} -o {work}/tile_out.png",
            f"oiiotool {tile} -o {work}/tile_copy.png", options.runs, "<= 1.3")

    print()
    print(f"{'peak memory':<44} {'MiB':>11}")
    for frames in (30, 300):
        command = f"{burin} render -q {ROOT}/effects/edges/sobel.fx {long_clip} --frames 1-{frames} -o {work}/memory.mkv"
        print(f"Sobel of {frames} frames, 640x360, to FFV1{'':<10} {memory_of(command):>11.0f}", flush=True)
    if not options.work:
        shutil.rmtree(work)


if __name__ == "__main__":
    main()
