// SPDX-License-Identifier: Apache-2.0
// Bad glTF files and the exact texts that refuse them.

#include <limits>

#include "scene_fixture.h"

namespace burin::scene {
namespace {

TEST(GltfRefusal, ReadsTheUneditedTriangle) { EXPECT_EQ(Refusal({}), "read"); }

TEST(GltfRefusal, NamesValuesOfAWrongType) {
  EXPECT_EQ(Refusal({{R"("scene":0)", R"("scene":"hello")"}}),
            R"(scene: expected an index in "scenes", found "hello")");
  EXPECT_EQ(Refusal({{R"([{"mesh":0}])", R"({"mesh":0})"}}), "nodes: expected an array, found an object");
  EXPECT_EQ(Refusal({{R"([{"mesh":0}])", "[7]"}}), "nodes[0]: expected an object, found 7");
  EXPECT_EQ(Refusal({{R"({"mesh":0})", R"({"mesh":0,"name":42})"}}), "nodes[0].name: expected a string, found 42");
  EXPECT_EQ(Refusal({{R"({"mesh":0})", R"({"mesh":-1})"}}),
            R"(nodes[0].mesh: expected an index in "meshes", found -1)");
  EXPECT_EQ(Refusal({{R"({"mesh":0})", R"({"mesh":0,"scale":[1,true,1]})"}}),
            "nodes[0].scale[1]: expected a number, found true");
  EXPECT_EQ(Refusal({{R"({"mesh":0})", R"({"mesh":0,"scale":[1,1]})"}}), "nodes[0].scale: expected 3 numbers, found 2");
  EXPECT_EQ(Refusal({{R"({"mesh":0})", R"({"mesh":0,"scale":[1,1e300,1]})"}}),
            "nodes[0].scale[1]: expected a number in the range of a 32-bit float, found 1e+300");
  EXPECT_EQ(Refusal({{R"("count":3)", R"("count":2.5)"}}),
            "accessors[0].count: expected an integer that is not negative, found 2.5");
  EXPECT_EQ(Refusal({{R"("count":3)", R"("count":0)"}}), "accessors[0].count: expected at least 1, found 0");
  EXPECT_EQ(Refusal({{R"("type":"VEC3")", R"("type":"VEC5")"}}),
            R"(accessors[0].type: expected one of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4, found "VEC5")");
  EXPECT_EQ(Refusal({{"5126", "5124"}}),
            "accessors[0].componentType: expected one of 5120, 5121, 5122, 5123, 5125, 5126, found 5124");
  EXPECT_EQ(Refusal({{R"({"mesh":0})", R"({"mesh":0,"extensions":{"KHR_lights_punctual":3}})"}}),
            "nodes[0].extensions.KHR_lights_punctual: expected an object, found 3");
}

TEST(GltfRefusal, CountsWholeFloatsAsIntegers) { EXPECT_EQ(Refusal({{R"("count":3)", R"("count":3.0)"}}), "read"); }

TEST(GltfRefusal, NamesMissingProperties) {
  EXPECT_EQ(Refusal({{R"("asset":{"version":"2.0"},)", ""}}), R"("asset" is missing)");
  EXPECT_EQ(Refusal({{R"("componentType":5126,)", ""}}), R"(accessors[0]: "componentType" is missing)");
  EXPECT_EQ(Refusal({{R"("byteLength":36)", R"("byteOffset":0)"}}), R"(bufferViews[0]: "byteLength" is missing)");
}

TEST(GltfRefusal, NamesIndicesOutOfRange) {
  EXPECT_EQ(Refusal({{R"("scene":0)", R"("scene":1)"}}), R"(scene: index 1 is out of range, "scenes" has 1)");
  EXPECT_EQ(Refusal({{R"("nodes":[0])", R"("nodes":[0,9])"}}),
            R"(scenes[0].nodes[1]: index 9 is out of range, "nodes" has 1)");
  EXPECT_EQ(Refusal({{R"("NORMAL":1)", R"("NORMAL":7)"}}),
            R"(meshes[0].primitives[0].attributes.NORMAL: index 7 is out of range, "accessors" has 3)");
  EXPECT_EQ(Refusal({{R"("indices":2)", R"("indices":2,"material":0)"}}),
            R"(meshes[0].primitives[0].material: index 0 is out of range, "materials" has 0)");
  EXPECT_EQ(Refusal({{R"("bufferView":1)", R"("bufferView":18446744073709551615)"}}),
            R"(accessors[1].bufferView: index 18446744073709551615 is out of range, "bufferViews" has 3)");
  EXPECT_EQ(Refusal({{R"("nodes":[{"mesh":0}])",
                      R"("nodes":[{"mesh":0}],"textures":[{"source":2}],"images":[{"uri":"a.png"}])"}}),
            R"(textures[0].source: index 2 is out of range, "images" has 1)");
}

TEST(GltfRefusal, KeepsAccessorsInsideTheirViews) {
  EXPECT_EQ(
      Refusal({{R"("count":3)", R"("count":4)"}}),
      "meshes[0].primitives[0].attributes.POSITION: accessor 0: 4 elements of 12 bytes, 12 apart, from byte 0 do not "
      "fit in buffer view 0 of 36 bytes");
  EXPECT_EQ(
      Refusal({{R"("count":3)", R"("count":4503599627370496)"}}),
      "meshes[0].primitives[0].attributes.POSITION: accessor 0: 4503599627370496 elements of 12 bytes, 12 apart, from "
      "byte 0 do not fit in buffer view 0 of 36 bytes");
  EXPECT_EQ(Refusal({{R"({"bufferView":0,)", R"({"bufferView":0,"byteOffset":9007199254740988,)"}}),
            "meshes[0].primitives[0].attributes.POSITION: accessor 0: 3 elements of 12 bytes, 12 apart, from byte "
            "9007199254740988 do not fit in buffer view 0 of 36 bytes");
  EXPECT_EQ(
      Refusal({{R"("byteOffset":36,"byteLength":36)", R"("byteOffset":36,"byteLength":36,"byteStride":16)"}}),
      "meshes[0].primitives[0].attributes.NORMAL: accessor 1: 3 elements of 12 bytes, 16 apart, from byte 0 do not "
      "fit in buffer view 1 of 36 bytes");
  EXPECT_EQ(Refusal({{R"("byteOffset":36,"byteLength":36)", R"("byteOffset":36,"byteLength":36,"byteStride":14)"}}),
            "bufferViews[1].byteStride: expected a multiple of 4, found 14");
}

TEST(GltfRefusal, KeepsViewsInsideTheirBuffers) {
  EXPECT_EQ(Refusal({{R"("byteOffset":72)", R"("byteOffset":75)"}}),
            "bufferViews[2]: 6 bytes from 75 do not fit in buffer 0 of 80 bytes");
  EXPECT_EQ(Refusal({{R"("byteOffset":72)", R"("byteOffset":9007199254740991)"}}),
            "bufferViews[2]: 6 bytes from 9007199254740991 do not fit in buffer 0 of 80 bytes");
  EXPECT_EQ(Refusal({{R"("byteLength":80)", R"("byteLength":81)"}}),
            "buffers[0]: byteLength is 81, but its data has 80 bytes");
  EXPECT_EQ(Refusal({{R"("byteLength":80)", R"("byteLength":9000000000000000)"}}),
            "buffers[0]: byteLength is 9000000000000000, but its data has 80 bytes");
}

TEST(GltfRefusal, BoundsWhatAnAccessorWithoutDataTakes) {
  EXPECT_EQ(
      Refusal({{R"({"bufferView":0,"componentType":5126,"count":3)", R"({"componentType":5126,"count":2000000000)"}}),
      "meshes[0].primitives[0].attributes.POSITION: accessor 0: 2000000000 elements without a buffer view, over the "
      "limit of 16777216");
}

TEST(GltfRefusal, BoundsWhatManyPrimitivesTakeOfOneAccessor) {
  // 16 million points are 192 MiB of zeros and 64 MiB of indices: two do not fit in the half gigabyte of a small file
  // while the second's are made.
  const std::string many = R"({"attributes":{"POSITION":0},"mode":0})";
  EXPECT_EQ(Refusal({{R"({"bufferView":0,"componentType":5126,"count":3)", R"({"componentType":5126,"count":16777216)"},
                     {R"({"attributes":{"POSITION":0,"NORMAL":1},"indices":2})", many + "," + many + "," + many}}),
            "meshes[0].primitives[1]: the arrays of a scene of this size may not take more than 512 MiB");
}

TEST(GltfRefusal, ChecksAttributesAgainstPosition) {
  EXPECT_EQ(Refusal({{R"({"bufferView":1,"componentType":5126,"count":3)",
                      R"({"bufferView":1,"componentType":5126,"count":2)"}}),
            "meshes[0].primitives[0].attributes.NORMAL: accessor 1 has 2 elements, POSITION has 3");
  EXPECT_EQ(Refusal({{R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC3")",
                      R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC2")"}}),
            "meshes[0].primitives[0].attributes.NORMAL: accessor 1: expected VEC3, found VEC2");
  EXPECT_EQ(Refusal({{R"("NORMAL":1)", R"("NORMAL":1,"TEXCOORD_1":1)"}}),
            "meshes[0].primitives[0].attributes.TEXCOORD_1: is there without TEXCOORD_0; sets are numbered from 0 "
            "without gaps");
  EXPECT_EQ(Refusal({{R"("NORMAL":1)", R"("NORMAL":1,"JOINTS_0":1)"}}),
            "meshes[0].primitives[0].attributes.JOINTS_0: is there without WEIGHTS_0");
  EXPECT_EQ(Refusal({{R"("NORMAL":1)", R"("NORMAL":1,"COLOR_x":1)"}}),
            "meshes[0].primitives[0].attributes.COLOR_x: is no attribute set of glTF");
}

TEST(GltfRefusal, ChecksIndices) {
  const std::string positions = TriangleBin().substr(0, 72);
  EXPECT_EQ(Refusal({}, positions + BytesOf<std::uint16_t>({0, 1, 3, 0})),
            "meshes[0].primitives[0].indices: accessor 2: element 2 is 3, but there are 3 vertices");
  EXPECT_EQ(Refusal({{R"({"bufferView":2,"componentType":5123)", R"({"bufferView":2,"componentType":5122)"}}),
            "meshes[0].primitives[0].indices: accessor 2: expected unsigned integers, found component type 5122");
}

TEST(GltfRefusal, WantsFiniteNumbersAndNormalsOfSomeLength) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::string normals = BytesOf<float>({0, 0, 1, 0, 0, 1, 0, 0, 1});
  const std::string indices = BytesOf<std::uint16_t>({0, 1, 2, 0});
  EXPECT_EQ(Refusal({}, BytesOf<float>({0, 0, 0, 1, 0, 0, 0, -kInfinity, 0}) + normals + indices),
            "meshes[0].primitives[0].attributes.POSITION: accessor 0: element 2 holds -inf");
  const std::string positions = TriangleBin().substr(0, 36);
  EXPECT_EQ(Refusal({}, positions + BytesOf<float>({0, 0, 1, 0, 0, 0, 0, 0, 1}) + indices),
            "meshes[0].primitives[0].attributes.NORMAL: the normal of vertex 1 has no length");
  // A triangle without area is never seen: its normals may be anything.
  EXPECT_EQ(
      Refusal({}, BytesOf<float>({0, 0, 0, 1, 0, 0, 2, 0, 0}) + BytesOf<float>({0, 0, 0, 0, 0, 0, 0, 0, 0}) + indices),
      "read");
}

TEST(GltfRefusal, ChecksSparseData) {
  const std::string head =
      R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0])";
  const auto sparse = [&](const std::string& body) { return Refusal({{head, head + R"(,"sparse":)" + body}}); };
  EXPECT_EQ(sparse(R"({"count":4,"indices":{"bufferView":2,"componentType":5123},"values":{"bufferView":1}})"),
            "meshes[0].primitives[0].attributes.POSITION: accessor 0: sparse count 4 is over the accessor's count 3");
  EXPECT_EQ(
      sparse(R"({"count":3,"indices":{"bufferView":2,"componentType":5125},"values":{"bufferView":1}})"),
      "meshes[0].primitives[0].attributes.POSITION: accessor 0: its 3 sparse indices do not fit in buffer view 2");
  EXPECT_EQ(
      sparse(R"({"count":3,"indices":{"bufferView":2,"componentType":5123},"values":{"bufferView":1,"byteOffset":4}})"),
      "meshes[0].primitives[0].attributes.POSITION: accessor 0: its 3 sparse values do not fit in buffer view 1");
  EXPECT_EQ(sparse(R"({"count":3,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0}})"),
            "meshes[0].primitives[0].attributes.POSITION: accessor 0: its sparse indices do not increase");
  EXPECT_EQ(
      sparse(
          R"({"count":1,"indices":{"bufferView":1,"byteOffset":11,"componentType":5121},"values":{"bufferView":0}})"),
      "meshes[0].primitives[0].attributes.POSITION: accessor 0: sparse index 63 is out of range, the count is 3");
}

TEST(GltfRefusal, WantsAForestOfNodes) {
  EXPECT_EQ(Refusal({{R"([{"mesh":0}])", R"([{"children":[1]},{"children":[0]}])"}}),
            "nodes[0]: is among its own ancestors");
  EXPECT_EQ(Refusal({{R"([{"mesh":0}])", R"([{"children":[0]}])"}}), "nodes[0]: is among its own ancestors");
  EXPECT_EQ(Refusal({{R"([{"mesh":0}])", R"([{"children":[2]},{"children":[2]},{"mesh":0}])"}}),
            "nodes[2]: is a child of both nodes[0] and nodes[1]; a node has one parent");
  EXPECT_EQ(Refusal({{R"("nodes":[0])", R"("name":"none")"}}), "scenes[0]: has no nodes: nothing to draw");
  EXPECT_EQ(Refusal({{R"({"mesh":0})", R"({"mesh":0,"matrix":[1,0,0,0.5,0,1,0,0,0,0,1,0,0,0,0,1]})"}}),
            "nodes[0].matrix: its last row is not 0 0 0 1");
}

TEST(GltfRefusal, NamesRequiredExtensionsThatAreMissing) {
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_texture_basisu"}) {
    EXPECT_EQ(Refusal({{R"("scene":0)", std::string(R"("extensionsRequired":[")") + name + R"("],"scene":0)"}}),
              std::string("needs the extension ") + name + ", which is not supported");
  }
  EXPECT_EQ(Refusal({{R"("scene":0)", R"("extensionsRequired":["KHR_materials_unlit"],"scene":0)"}}), "read");
}

TEST(GltfRefusal, RefusesOtherVersions) {
  EXPECT_EQ(Refusal({{R"("2.0")", R"("1.0")"}}), "asset.version: glTF 1.0 is not supported, expected 2.0");
  EXPECT_EQ(Refusal({{R"("2.0")", R"("2.1","minVersion":"2.1")"}}),
            "asset.minVersion: needs glTF 2.1, this program reads 2.0");
}

TEST(GltfRefusal, ChecksCamerasAndLights) {
  const auto camera = [](const std::string& body) {
    return Refusal({{R"("scene":0)", R"("scene":0,"cameras":[)" + body + "]"}});
  };
  EXPECT_EQ(camera(R"({"type":"perspective","perspective":{"yfov":1,"znear":2,"zfar":2}})"),
            "cameras[0]: zfar 2 is not beyond znear 2");
  EXPECT_EQ(camera(R"({"type":"perspective","perspective":{"yfov":0,"znear":2}})"),
            "cameras[0].perspective.yfov: expected a number greater than 0, found 0");
  EXPECT_EQ(camera(R"({"type":"orthographic","orthographic":{"xmag":0,"ymag":1,"znear":0,"zfar":1}})"),
            "cameras[0].orthographic: xmag and ymag must not be 0");
  EXPECT_EQ(camera(R"({"type":"perspective"})"), R"(cameras[0]: "perspective" is missing)");
  EXPECT_EQ(
      Refusal({{R"("scene":0)", R"("scene":0,"extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot"}]}})"}}),
      R"(extensions.KHR_lights_punctual.lights[0]: "spot" is missing)");
  EXPECT_EQ(Refusal({{R"("scene":0)", R"("scene":0,"extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","spot":
                      {"innerConeAngle":0.5,"outerConeAngle":0.5}}]}})"}}),
            "extensions.KHR_lights_punctual.lights[0].spot: innerConeAngle 0.5 is not below outerConeAngle 0.5");
}

TEST(GltfRefusal, ChecksAnimations) {
  const auto animation = [](const std::string& channel, const std::string& sampler) {
    return Refusal({{R"("scene":0)",
                     R"("scene":0,"animations":[{"channels":[)" + channel + R"(],"samplers":[)" + sampler + "]}]"}});
  };
  const std::string move = R"({"sampler":0,"target":{"node":0,"path":"translation"}})";
  // Accessor 1 as times: VEC3. There is no SCALAR float accessor, so the indices serve as times 0, 1, 2.
  EXPECT_EQ(animation(move, R"({"input":1,"output":0})"),
            "animations[0].samplers[0].input: accessor 1: expected SCALAR, found VEC3");
  EXPECT_EQ(animation(R"({"sampler":1,"target":{"node":0,"path":"translation"}})", R"({"input":2,"output":0})"),
            R"(animations[0].channels[0].sampler: index 1 is out of range, "samplers" has 1)");
  EXPECT_EQ(animation(move, R"({"input":2,"output":0,"interpolation":"CUBICSPLINE"})"),
            "animations[0].samplers[0].output: accessor 0 has 3 elements, 3 keys need 9");
  EXPECT_EQ(animation(R"({"sampler":0,"target":{"node":0,"path":"rotation"}})", R"({"input":2,"output":0})"),
            "animations[0].samplers[0].output: accessor 0: expected VEC4, found VEC3");
  EXPECT_EQ(animation(move, R"({"input":2,"output":0})"), "read");
}

TEST(GltfRefusal, ChecksSkins) {
  EXPECT_EQ(Refusal({{R"("scene":0)", R"("scene":0,"skins":[{"joints":[]}])"}}), "skins[0].joints: is empty");
  EXPECT_EQ(Refusal({{R"("scene":0)", R"("scene":0,"skins":[{"joints":[0],"inverseBindMatrices":0}])"}}),
            "skins[0].inverseBindMatrices: accessor 0: expected MAT4, found VEC3");
  // Joints 0, 1, 2, 63 of float bytes: the skin has one joint.
  EXPECT_EQ(Refusal({{R"("scene":0)", R"("scene":0,"skins":[{"joints":[0]}])"},
                     {R"({"mesh":0})", R"({"mesh":0,"skin":0})"},
                     {R"("NORMAL":1)", R"("NORMAL":1,"JOINTS_0":3,"WEIGHTS_0":3)"},
                     {R"("accessors":[)", R"("accessors":[)"},
                     {R"("type":"SCALAR"})",
                      R"("type":"SCALAR"},{"bufferView":1,"componentType":5121,"count":3,"type":"VEC4"})"}}),
            "nodes[0]: skin 0 has 1 joints, but meshes[0].primitives[0].attributes.JOINTS_0 names joint 128");
}

TEST(GltfRefusal, ChecksMorphTargets) {
  EXPECT_EQ(Refusal({{R"("indices":2)", R"("indices":2,"targets":[{"POSITION":2}])"}}),
            "meshes[0].primitives[0].targets[0].POSITION: accessor 2: expected VEC3, found SCALAR");
  EXPECT_EQ(Refusal({{R"("indices":2}])", R"("indices":2,"targets":[{"POSITION":1}]}],"weights":[1,2])"}}),
            "meshes[0].weights: 2 weights for 1 morph targets");
  EXPECT_EQ(
      Refusal({{R"("indices":2}])", R"("indices":2,"targets":[{"POSITION":1}]},{"attributes":{"POSITION":0}}])"}}),
      "meshes[0].primitives[1]: has 0 morph targets, the mesh's first primitive has 1");
  EXPECT_EQ(Refusal({{R"({"mesh":0})", R"({"mesh":0,"weights":[1]})"}}),
            "nodes[0].weights: 1 weights for 0 morph targets");
}

TEST(GltfRefusal, SaysWhereJsonBreaks) {
  EXPECT_EQ(
      Refusal({{R"("scene":0)", R"("scene":)"}}),
      "not valid JSON: parse error at line 1, column 36: syntax error while parsing value - unexpected ','; expected "
      "'[', '{', or a literal");
  EXPECT_EQ(
      Refusal({{R"("scene":0)", "\"extras\":" + std::string(200, '[') + std::string(200, ']') + R"(,"scene":0)"}}),
      "JSON nests deeper than 128 levels");
}

}  // namespace
}  // namespace burin::scene
