// SPDX-License-Identifier: Apache-2.0
#include "core/translucency/medium_spec.h"

#include <gtest/gtest.h>

namespace burin::translucency {
namespace {

std::string ErrorOf(const std::string& text) {
  const auto parsed = ParseAssignment(text);
  return parsed ? "" : parsed.error().message;
}

TEST(MediumSpec, NamesNumbersAndNone) {
  EXPECT_EQ(ParseMedium("marble").value().value(), *FindMeasuredMedium("Marble"));
  EXPECT_FALSE(ParseMedium("none").value().has_value());
  const Medium wax = ParseMedium("scattering:2,2.5,3;absorption:0.01;ior:1.4").value().value();
  EXPECT_EQ(wax.reduced_scattering, glm::vec3(2.0f, 2.5f, 3.0f));
  EXPECT_EQ(wax.absorption, glm::vec3(0.01f));
  EXPECT_EQ(wax.ior, 1.4f);
  EXPECT_EQ(wax.name, "scattering:2,2.5,3;absorption:0.01;ior:1.4");
  EXPECT_EQ(ParseMedium("albedo:0.8,0.7,0.6;path:2").value()->ReducedExtinction().x, 0.5f);
}

TEST(MediumSpec, ErrorsSayWhatWasFoundAndExpected) {
  EXPECT_EQ(ErrorOf("Skin"),
            "\"Skin\": expected GLOB=MEDIUM, a material's name or pattern and a measured material, none, "
            "\"scattering:R,G,B;absorption:R,G,B[;ior:N]\" or \"albedo:R,G,B;path:R,G,B[;ior:N]\"");
  EXPECT_EQ(ErrorOf("Skin=skin3"),
            "\"skin3\" is no medium; expected a measured material, none, "
            "\"scattering:R,G,B;absorption:R,G,B[;ior:N]\" or \"albedo:R,G,B;path:R,G,B[;ior:N]\". Measured: Apple, "
            "Chicken1, Chicken2, Cream, Ketchup, Marble, Potato, Skimmilk, Skin1, Skin2, Spectralon, Wholemilk");
  EXPECT_EQ(ErrorOf("a=scattering:1,2;absorption:1"), "scattering: 2 numbers, expected one or three");
  EXPECT_EQ(ErrorOf("a=scattering:1,x,2;absorption:1"), "scattering: \"x\" is no number");
  EXPECT_EQ(ErrorOf("a=scattering:1;absorption:nan"), "absorption: \"nan\" is no number");
  EXPECT_EQ(ErrorOf("a=scattering:1;absorption:-1"),
            "absorption: -1,-1,-1 is out of range; expected 0 to 1000000 per millimetre");
  EXPECT_EQ(ErrorOf("a=scattering:1e9;absorption:1"),
            "scattering: 1e+09,1e+09,1e+09 is out of range; expected 0 to 1000000 per millimetre");
  EXPECT_EQ(ErrorOf("a=albedo:1.5;path:1"), "albedo: 1.5,1.5,1.5 is out of range; expected 0 to 1");
  EXPECT_EQ(ErrorOf("a=albedo:.5;path:0"), "path: 0,0,0 is out of range; expected 0.000001 to 1000000 millimetres");
  EXPECT_EQ(ErrorOf("a=albedo:.5"), "\"albedo:.5\": expected scattering and absorption, or albedo and path");
  EXPECT_EQ(ErrorOf("a=albedo:.5;path:1;ior:9"), "ior: 9 is out of range; expected 1 to 4");
  EXPECT_EQ(ErrorOf("a=albedo:.5;albedo:.5"), "albedo: given twice in \"albedo:.5;albedo:.5\"");
}

// The coefficients that the paper's figure 8 prints under each other's names.
TEST(MediumSpec, WarnsOfExchangedCoefficients) {
  const Medium figure = ParseMedium("scattering:0.00162,0.00053,0.00024;absorption:2.58,2.54,1.6").value().value();
  ASSERT_EQ(CheckMedium(figure).size(), 1u);
  EXPECT_EQ(
      CheckMedium(figure)[0],
      "medium \"scattering:0.00162,0.00053,0.00024;absorption:2.58,2.54,1.6\": absorption (2.58, 2.54, 1.6) is far "
      "above scattering (0.00162, 0.00053, 0.00024), so it will be black; were the two exchanged?");
  for (const Medium& medium : MeasuredMedia()) EXPECT_TRUE(CheckMedium(medium).empty()) << medium.name;
}

TEST(MediumSpec, WarnsOfWrongUnits) {
  const Medium marble = *FindMeasuredMedium("marble");
  EXPECT_EQ(CheckScale(marble, 100.0, 0.4, 1000.0), "");
  EXPECT_EQ(
      CheckScale(marble, 2000.0, 8.0, 1000.0),
      "medium \"Marble\": its longest mean free path is 0.456 mm, below a texel of 8 mm in an object of 2e+03 mm, "
      "so it looks opaque; is --unit-mm 1000 right?");
  EXPECT_EQ(CheckScale(marble, 0.1, 0.0004, 1.0),
            "medium \"Marble\": its shortest mean free path is 0.333 mm, above the object's 0.1 mm, where diffusion no "
            "longer holds; is --unit-mm 1 right?");
  EXPECT_EQ(CheckScale(marble, 4e-30, 1e-32, 1000.0),
            "medium \"Marble\": an object of it has all its vertices in one place, so nothing scatters");
}

scene::Scene SceneOf(std::initializer_list<const char*> names) {
  scene::Scene scene;
  scene.path = "a.gltf";
  for (const char* name : names) {
    scene.materials.emplace_back();
    scene.materials.back().name = name;
  }
  return scene;
}

TEST(SceneMedia, TheLastFittingAssignmentWins) {
  scene::Scene scene = SceneOf({"Skin.face", "Skin.hand", "Cloth"});
  scene.materials[2].translucency = "Ketchup";
  const std::vector<Assignment> assignments = {ParseAssignment("Skin*=skin1").value(),
                                               ParseAssignment("*hand=skin2").value()};
  const SceneMedia media = ResolveMedia(scene, assignments, 1000.0).value();
  EXPECT_EQ(media.of_material[0]->name, "Skin1");
  EXPECT_EQ(media.of_material[1]->name, "Skin2");
  EXPECT_EQ(media.of_material[2]->name, "Ketchup");
  EXPECT_TRUE(media.warnings.empty());
  const SceneMedia opaque = ResolveMedia(scene, {ParseAssignment("*=none").value()}, 1000.0).value();
  for (const auto& medium : opaque.of_material) EXPECT_FALSE(medium);
}

TEST(SceneMedia, SaysWhenNothingFits) {
  const SceneMedia media = ResolveMedia(SceneOf({"A", "B"}), {ParseAssignment("Skin*=skin1").value()}, 1000.0).value();
  ASSERT_EQ(media.warnings.size(), 1u);
  EXPECT_EQ(media.warnings[0], "--translucency \"Skin*\": no material has such a name; a.gltf has \"A\", \"B\"");
}

TEST(SceneMedia, NamesTheMaterialWhoseExtrasAreWrong) {
  scene::Scene scene = SceneOf({"A"});
  scene.materials[0].translucency = "scattering:1;absorption:-1";
  const auto media = ResolveMedia(scene, {}, 1000.0);
  ASSERT_FALSE(media);
  EXPECT_EQ(media.error().kind, ErrorKind::kInput);
  EXPECT_EQ(
      media.error().message,
      "a.gltf: materials[0] \"A\".extras.translucency: absorption: -1,-1,-1 is out of range; expected 0 to 1000000 "
      "per millimetre");
}

TEST(SceneMedia, DiffuseTransmissionInAVolumeIsAMedium) {
  scene::Scene scene = SceneOf({"A"});
  scene.materials[0].diffuse_transmission = 1.0f;
  scene.materials[0].attenuation_color = glm::vec3(0.5f);
  EXPECT_FALSE(ResolveMedia(scene, {}, 1000.0).value().of_material[0]);  // an infinite distance attenuates nothing
  scene.materials[0].attenuation_distance = 0.01f;
  const Medium medium = ResolveMedia(scene, {}, 1000.0).value().of_material[0].value();
  EXPECT_NEAR(medium.EffectiveTransport().x, 0.0693f, 1e-3f);  // ln 2 over 10 mm
}

}  // namespace
}  // namespace burin::translucency
