// SPDX-License-Identifier: Apache-2.0
#include "core/gbuffer/gpu_blocks.h"

namespace burin::gbuffer {

static_assert(sizeof(FrameBlock) == 3 * 64 + 4 * 16 + 9 * 16 + 16);
static_assert(sizeof(DrawBlock) == 2 * 64 + 3 * 16 + 16);
static_assert(sizeof(MaterialBlock) == 4 * 16 + 10 * 16);
static_assert(sizeof(LightRecord) == 64);
static_assert(sizeof(FaceSample) == 9 * 16);

std::string_view BlockDeclarations() {
  return R"(
layout(std140, binding = 0) uniform Frame {
  mat4 clip_from_world;
  mat4 previous_clip_from_world;
  mat4 view_from_world;
  vec4 eye;
  vec4 viewport;
  vec4 key_position;
  vec4 key_direction;
  vec4 irradiance[9];
  vec4 environment;
};
layout(std140, binding = 1) uniform Draw {
  mat4 world_from_object;
  mat4 previous_world_from_object;
  vec4 normal_columns[3];
  uvec4 ids;
};
layout(std140, binding = 2) uniform Material {
  vec4 base_color;
  vec4 emissive_cutoff;
  vec4 factors;
  vec4 reflectance;
  vec4 uv_rows[10];
};
)";
}

}  // namespace burin::gbuffer
