#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Renders every example into out/ with the exact commands that a user would type; prints each before it runs.
set -euo pipefail
cd "$(dirname "$0")/.."
burin=${BURIN:-build/release/bin/burin}
out=${1:-out}
[ -x "$burin" ] || { echo "render.sh: error: $burin is not built; run ./quickstart first" >&2; exit 1; }
mkdir -p "$out/effects"

run() {
  printf '\n$ burin'
  printf ' %q' "$@"
  printf '\n'
  "$burin" "$@"
}

# A scene through an effect, as PNG and as EXR.
run render edges/dilated_edges examples/still_life.glb -o "$out/dilated_edges.png" --size 1024x1024
run render filter/supersample examples/still_life.glb -o "$out/supersample.exr" --size 1024x1024
# The scene itself, and its G-buffer as the layers of one EXR.
run render examples/still_life.glb -o "$out/still_life.png" --size 1024x1024
run render examples/still_life.glb --attributes color,normal,depth,position,objectid,velocity -o "$out/gbuffer.exr" --size 1024x1024
# Lines from the scene's own edges: an effect that inks them, and the attributes that it reads.
run render npr/ink examples/still_life.glb -o "$out/ink.png" --size 1024x1024
run render examples/still_life.glb --attributes color,edges,edgedist -o "$out/edge_lines.exr" --size 1024x1024
# A jug of Bézier patches: smooth at any size, its parameterisation as attributes, and its triangles as a mesh.
run render examples/jug.bpt -o "$out/jug.png" --size 1024x1024
run render npr/ink examples/jug.bpt -o "$out/jug_ink.png" --size 1024x1024
run render examples/jug.bpt --attributes color,patchuv,patchid -o "$out/jug_patches.exr" --size 1024x1024
run tessellate examples/jug.bpt -o "$out/jug.glb" --tessellation-factor 16
# A low-polygon animation with smooth outlines: triangles that follow their normals.
run render examples/walk.glb --tessellation fractional --frames 1-48 --fps 24 --size 640x480 -o "$out/walk_smooth.mkv"
# An animation to video.
run render edges/dilated_edges examples/walk.glb --frames 1-48 --fps 24 --size 640x480 -o "$out/walk_edges.mkv"
run render examples/walk.glb --frames 1-48 --fps 24 --size 640x480 -o "$out/walk.mkv"
# A video through effects.
run render edges/sobel "$out/walk.mkv" -o "$out/walk_sobel.mkv"
run render filter/gaussian "$out/walk.mkv" -o "$out/walk_gaussian.mp4"
# Light that scatters inside, as the method's paper shows it: a candle lit by its flame; translucent and opaque; the light
# from nearby and what came through; the paper's kernels with the histograms of what they make; an object that swells into its bounding sphere.
run render examples/candle.glb -o "$out/candle.png" --size 768x768 --background black
run render examples/head.glb --translucency 'head=marble' -o "$out/head_marble.png" --size 768x768 --background black
run render examples/head.glb -o "$out/head_opaque.png" --size 768x768 --background black
run render examples/head.glb --translucency 'head=skin1' --attributes translucency,localscattering,globalscattering \
  -o "$out/head_parts.exr" --size 768x768
for kernel in 3 4 5 6; do
  run render filter/histogram examples/head.glb --translucency 'head=marble' --scattering paper \
    --paper-kernel "$kernel" -o "$out/head_paper_$kernel.png" --size 768x768
done
for t in 0 0.25 0.5 0.75 1; do
  run render examples/head.glb --translucency 'head=albedo:.83,.79,.75;path:2' --morph-to-sphere "$t" \
    -o "$out/head_morph_$t.png" --size 512x512 --background black
done
# Each shipped effect on the same scene.
"$burin" effects | while read -r name _; do
  run render "$name" examples/still_life.glb -o "$out/effects/${name//\//_}.png" --size 800x600 </dev/null
done

printf '\nThe pictures and videos are in %s/:\n' "$out"
find "$out" -type f | sort | sed 's/^/  /'
