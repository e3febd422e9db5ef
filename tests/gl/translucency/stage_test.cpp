// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/gl/translucency/stand_test.h"

namespace burin::translucency {
namespace {

using gbuffer::Attribute;
using testing::HasSubstr;

/// A scene of one translucent material and its pictures.
class StageTest : public TranslucencyTest {
 protected:
  StageTest() {
    scene::Material material;
    material.name = "medium";
    material.metallic = 0.0f;
    scene_.materials.push_back(material);
  }

  int AddMesh(const Surface& surface, int material, const glm::mat4& world = glm::mat4(1.0f)) {
    scene_.meshes.emplace_back();
    scene_.meshes.back().primitives.push_back(ToPrimitive(surface, material));
    scene_.nodes.emplace_back();
    scene_.nodes.back().mesh = static_cast<int>(scene_.meshes.size()) - 1;
    scene_.nodes.back().matrix = world;
    scene_.roots.push_back(static_cast<int>(scene_.nodes.size()) - 1);
    return scene_.nodes.back().mesh;
  }
  void AddLight(const scene::Light& light, const glm::mat4& world) {
    scene_.lights.push_back(light);
    scene_.nodes.emplace_back();
    scene_.nodes.back().light = static_cast<int>(scene_.lights.size()) - 1;
    scene_.nodes.back().matrix = world;
    scene_.roots.push_back(static_cast<int>(scene_.nodes.size()) - 1);
  }
  void AddLamp(const glm::vec3& at, float intensity = 14000.0f) {
    scene::Light light;
    light.type = scene::LightType::kPoint;
    light.intensity = intensity;
    AddLight(light, glm::translate(glm::mat4(1.0f), at));
  }

  void Start(const char* medium, Scattering scattering = Scattering::kFast) {
    const image::Image black = FloatMap(8, 4, [](const glm::dvec3&) { return glm::dvec3(0.0); });
    TranslucencyOptions options;
    options.unit_mm = 1.0;
    options.scattering = scattering;
    options.most_map_bytes = most_map_bytes_;
    options.assignments = {Take(ParseAssignment(std::string("medium=") + medium))};
    stage_ = Take(TranslucencyRenderer::Create(scene_, &black, options));
    renderer_ = Take(gbuffer::SceneRenderer::Create(scene_, &black));
  }

  image::Image Draw(Attribute attribute, const glm::vec3& eye = {0, 0, 80}) {
    return std::move(DrawAll({attribute}, eye).front());
  }
  std::vector<image::Image> DrawAll(const std::vector<Attribute>& attributes, const glm::vec3& eye = {0, 0, 80}) {
    std::vector<gl::Texture> targets;
    const auto drawn = Try(attributes, eye, &targets);
    EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().message);
    std::vector<image::Image> images;
    for (const gl::Texture& target : targets) {
      images.push_back(gl::Read(target, image::SampleType::kF32, 4, image::Encoding::kData));
    }
    return images;
  }
  Result<void> Try(const std::vector<Attribute>& attributes, const glm::vec3& eye, std::vector<gl::Texture>* drawn) {
    scene::View view;
    view.view_from_world = glm::lookAt(eye, glm::vec3(0.0f), glm::vec3(0.0f, 1.0f, 0.0f));
    view.clip_from_view = glm::perspectiveRH_ZO(0.6f, 1.0f, 5.0f, 500.0f);
    view.znear = 5.0f;
    view.zfar = 500.0f;
    std::vector<gl::Texture> targets;
    std::vector<gbuffer::Request> requests;
    for (std::size_t i = 0; i < attributes.size(); ++i) {
      targets.push_back(
          Take(gl::Texture::Create(gl::PlainFormat(gl::Numeric::kFloat, 32, 4), kSize, kSize, 1, "stage test")));
    }
    for (std::size_t i = 0; i < attributes.size(); ++i) {
      requests.push_back({attributes[i], &targets[i], image::Encoding::kSceneLinear});
    }
    const scene::Pose pose = scene::EvaluatePose(scene_, {}, 0.0);
    const std::vector<scene::DrawItem> items = scene::BuildDrawItems(scene_, pose, pose);
    gbuffer::FrameInput input{view, view, &pose, items, glm::vec4(0.0f), nullptr, stage_.get()};
    const auto result = renderer_->Render(input, requests);
    if (drawn != nullptr) *drawn = std::move(targets);
    return result;
  }

  static constexpr int kSize = 48;
  static glm::vec3 At(const image::Image& image, int x, int y) {
    const float* p = image.As<float>().data() + 4 * (static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x));
    return {p[0], p[1], p[2]};
  }
  static glm::dvec3 Mean(const image::Image& image) {
    glm::dvec3 sum(0.0);
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) sum += glm::dvec3(At(image, x, y));
    }
    return sum / static_cast<double>(kSize * kSize);
  }

  scene::Scene scene_;
  std::size_t most_map_bytes_ = TranslucencyOptions().most_map_bytes;
  std::unique_ptr<TranslucencyRenderer> stage_;
  std::unique_ptr<gbuffer::SceneRenderer> renderer_;
};

TEST_F(StageTest, IrradianceIsTheLampsTimesWhatEnters) {
  AddMesh(Block({30, 30, 8}, 4), 0);
  AddLamp({0, 0, 74});  // 70 mm above the front
  Start("marble");
  const glm::vec3 middle = At(Draw(Attribute::kIrradiance), kSize / 2, kSize / 2);
  EXPECT_NEAR(middle.g, 14000.0 / (70.0 * 70.0) * 0.96, 0.01);  // 4 % are reflected at eta 1.5
}

TEST_F(StageTest, EveryKindOfLightEnters) {
  for (const scene::LightType type :
       {scene::LightType::kDirectional, scene::LightType::kPoint, scene::LightType::kSpot}) {
    scene_.meshes.clear();
    scene_.nodes.clear();
    scene_.roots.clear();
    scene_.lights.clear();
    AddMesh(Block({30, 30, 8}, 4), 0);
    scene::Light light;
    light.type = type;
    light.intensity = type == scene::LightType::kDirectional ? 2.0f : 2.0f * 70.0f * 70.0f;
    light.inner_cone_rad = 0.3f;
    light.outer_cone_rad = 0.4f;
    AddLight(light, glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, 74.0f)));
    Start("marble");
    EXPECT_NEAR(At(Draw(Attribute::kIrradiance), kSize / 2, kSize / 2).g, 1.92, 0.02) << static_cast<int>(type);
  }
}

/// A slab lit from above, and something between it and the lamp.
class ShadowTest : public StageTest {
 protected:
  ShadowTest() {
    AddMesh(Block({30, 30, 8}, 4), 0);
    AddLamp({0, 0, 74});
    scene_.materials.emplace_back();
    caster_ = 1;
  }
  /// 10 mm wide and 34 mm below the lamp; counter-clockwise as seen from the lamp, or from the slab.
  scene::Primitive& AddSheet(bool faces_lamp) {
    Surface sheet;
    const double side = faces_lamp ? 5.0 : -5.0;
    sheet.positions = {{-side, -5, 0}, {side, -5, 0}, {side, 5, 0}, {-side, 5, 0}};
    sheet.normals.assign(4, {0, 0, faces_lamp ? 1 : -1});
    sheet.indices = {0, 1, 2, 0, 2, 3};
    const int mesh = AddMesh(sheet, caster_, glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, 40.0f)));
    return scene_.meshes[static_cast<std::size_t>(mesh)].primitives[0];
  }
  scene::Material& caster() { return scene_.materials[static_cast<std::size_t>(caster_)]; }

  struct Shadow {
    int pixels = 0;
    int that_scatter = 0;  ///< of those, what light reaches inside the slab
  };
  /// Of the slab's top, seen aslant from beside the sheet.
  Shadow Find() {
    Start("marble");
    const std::vector<image::Image> pictures = DrawAll(
        {Attribute::kIrradiance, Attribute::kTranslucency, Attribute::kObjectId, Attribute::kNormal}, {60, 0, 60});
    Shadow shadow;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const bool is_top = At(pictures[2], x, y).x == 1.0f && At(pictures[3], x, y).z > 0.9f;
        if (!is_top || At(pictures[0], x, y).g > 0.0f) continue;
        ++shadow.pixels;
        if (At(pictures[1], x, y).g > 0.0f) ++shadow.that_scatter;
      }
    }
    return shadow;
  }

  int caster_ = scene::kNone;
};

TEST_F(ShadowTest, OtherObjectsThrowShadowsIntoWhichLightScatters) {
  AddMesh(Block({10, 10, 1}, 1), scene::kNone, glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, 40.0f)));
  const Shadow shadow = Find();
  EXPECT_GT(shadow.pixels, 20);
  EXPECT_EQ(shadow.pixels, shadow.that_scatter);
}

TEST_F(ShadowTest, BacksOfOneSidedSurfacesThrowNone) {
  AddSheet(true);
  EXPECT_GT(Find().pixels, 20);
  scene_.meshes.pop_back();
  scene_.nodes.pop_back();
  scene_.roots.pop_back();
  AddSheet(false);
  EXPECT_EQ(Find().pixels, 0);
  caster().double_sided = true;
  EXPECT_GT(Find().pixels, 20);
}

TEST_F(ShadowTest, MirroredSheetsKeepTheirFront) {
  AddSheet(true);
  scene_.nodes.back().matrix = *scene_.nodes.back().matrix * glm::scale(glm::mat4(1.0f), glm::vec3(-1.0f, 1.0f, 1.0f));
  EXPECT_GT(Find().pixels, 20);
}

TEST_F(ShadowTest, MasksLetLightThrough) {
  scene::Primitive& sheet = AddSheet(true);
  const int whole = Find().pixels;
  caster().base_color.a = 0.25f;
  EXPECT_EQ(Find().pixels, whole);  // alpha means nothing to an opaque material
  caster().alpha_mode = scene::AlphaMode::kMask;
  EXPECT_EQ(Find().pixels, 0);
  caster().base_color.a = 1.0f;
  sheet.colors = {{1, 1, 1, 0}, {1, 1, 1, 1}, {1, 1, 1, 1}, {1, 1, 1, 0}};
  EXPECT_NEAR(Find().pixels, 0.5 * whole, 0.15 * whole);
  sheet.colors.clear();
  sheet.texcoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  image::Image halves = image::MakeImage(2, 1, 4, image::SampleType::kU8, image::Encoding::kDisplay);
  const std::array<std::uint8_t, 8> texels = {255, 255, 255, 0, 255, 255, 255, 255};
  std::ranges::copy(texels, halves.As<std::uint8_t>().begin());
  scene_.images.push_back(halves);
  caster().base_color_texture.image = 0;
  caster().base_color_texture.sampler.mag = caster().base_color_texture.sampler.min = scene::Filter::kNearest;
  EXPECT_NEAR(Find().pixels, 0.5 * whole, 0.15 * whole);
}

// A lamp amid the object's box takes six maps.
TEST_F(StageTest, LampBetweenTwoBallsLightsBothInsides) {
  AddMesh(TwoBalls(), 0, glm::scale(glm::mat4(1.0f), glm::vec3(1.0f)));
  AddLamp({0, 12, 0}, 300.0f);
  Start("marble");
  const image::Image light = Draw(Attribute::kIrradiance, {0, 70, 30});
  double left = 0.0;
  double right = 0.0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) (x < kSize / 2 ? left : right) += static_cast<double>(At(light, x, y).g);
  }
  EXPECT_GT(left, 1.0);
  EXPECT_NEAR(left / right, 1.0, 0.02);
}

TEST_F(StageTest, NearAndFarMakeTheWhole) {
  AddMesh(Block({30, 30, 2}, 4), 0);
  AddLamp({10, 10, -74});
  Start("skin1");
  const std::vector<image::Image> parts =
      DrawAll({Attribute::kTranslucency, Attribute::kLocalScattering, Attribute::kGlobalScattering});
  const glm::dvec3 all = Mean(parts[0]);
  const glm::dvec3 near = Mean(parts[1]);
  const glm::dvec3 far = Mean(parts[2]);
  EXPECT_GT(all.r, 0.0);
  EXPECT_NEAR(all.r, near.r + far.r, 1e-6);
  EXPECT_GT(far.r, 5.0 * near.r);  // lit from behind
}

TEST_F(StageTest, ColorHoldsWhatScatters) {
  AddMesh(Block({30, 30, 2}, 4), 0);
  AddLamp({10, 10, -74});
  Start("skin1");
  const std::vector<image::Image> pictures = DrawAll({Attribute::kColor, Attribute::kTranslucency});
  // The lamp is behind and the sky is black: there is nothing else.
  const glm::vec3 color = At(pictures[0], kSize / 2, kSize / 2);
  const glm::vec3 scattered = At(pictures[1], kSize / 2, kSize / 2);
  EXPECT_GT(color.r, 0.0f);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c], scattered[c], 1e-6f);
}

TEST_F(StageTest, BaseColorTintsWhatEntersAndWhatLeaves) {
  AddMesh(Ball(15.0, 48), 0);
  AddLamp({0, 0, 74});
  Start("marble");
  const glm::dvec3 white = Mean(Draw(Attribute::kTranslucency));
  scene_.materials[0].base_color = glm::vec4(0.25f, 1.0f, 0.0f, 1.0f);
  Start("marble");
  const glm::dvec3 tinted = Mean(Draw(Attribute::kTranslucency));
  EXPECT_NEAR(tinted.r / white.r, 0.25, 0.001);
  EXPECT_NEAR(tinted.g / white.g, 1.0, 0.001);
  EXPECT_EQ(tinted.b, 0.0);
}

// What is kept when only the camera moves is what would be made anew, bit for bit.
TEST_F(StageTest, MovingTheCameraAloneChangesNoBit) {
  AddMesh(TwoBalls(), 0);
  AddLamp({30, 20, 60});
  Start("skin1");
  (void)Draw(Attribute::kColor, {0, 0, 80});
  const image::Image kept = Draw(Attribute::kColor, {40, 20, 60});
  Start("skin1");
  const image::Image anew = Draw(Attribute::kColor, {40, 20, 60});
  EXPECT_EQ(kept.pixels, anew.pixels);
}

TEST_F(StageTest, MovedLampIsNoticed) {
  AddMesh(Ball(15.0, 48), 0);
  AddLamp({0, 0, 74});
  Start("skin1");
  const glm::dvec3 front = Mean(Draw(Attribute::kTranslucency));
  scene_.nodes.back().matrix = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, -74.0f));
  EXPECT_LT(Mean(Draw(Attribute::kTranslucency)).g, 0.2 * front.g);
}

TEST_F(StageTest, MirroredObjectsLookTheSame) {
  AddMesh(Ball(15.0, 48), 0);
  AddLamp({0, 20, 74});
  Start("marble");
  const glm::dvec3 plain = Mean(Draw(Attribute::kTranslucency));
  scene_.nodes[0].matrix = glm::scale(glm::mat4(1.0f), glm::vec3(-1.0f, 1.0f, 1.0f));
  Start("marble");
  EXPECT_NEAR(Mean(Draw(Attribute::kTranslucency)).g / plain.g, 1.0, 0.002);
}

// A sheet has a box without depth; one triangle has next to nothing.
TEST_F(StageTest, FlatAndEmptyShapesAreNoTrouble) {
  Surface sheet;
  sheet.positions = {{-15, -15, 0}, {15, -15, 0}, {15, 15, 0}, {-15, 15, 0}};
  sheet.normals.assign(4, {0, 0, 1});
  sheet.indices = {0, 1, 2, 0, 2, 3};
  AddMesh(sheet, 0);
  Surface point = sheet;
  point.positions.assign(4, {0, 0, 0});
  AddMesh(point, 0);
  AddLamp({0, 0, 74});
  Start("marble");
  const image::Image picture = Draw(Attribute::kTranslucency);
  for (const float value : picture.As<float>()) EXPECT_TRUE(std::isfinite(value));
  // A plane gives off R_total of even light; the sheet's lamp is nearly even, its rims lose some.
  const double even =
      14000.0 / (74.0 * 74.0) * 0.96 * MakeDipoles(*FindMeasuredMedium("marble"))[1].Total() * 0.96 / glm::pi<double>();
  EXPECT_NEAR(At(picture, kSize / 2, kSize / 2).g / even, 0.95, 0.05);
}

TEST_F(StageTest, SurfacesWithoutNormalsStayUnlit) {
  const int mesh = AddMesh(Ball(15.0, 24), 0);
  scene_.meshes[static_cast<std::size_t>(mesh)].primitives[0].normals.clear();
  Start("marble");
  EXPECT_GT(Mean(Draw(Attribute::kColor)).g, 0.0);
  EXPECT_EQ(Mean(Draw(Attribute::kTranslucency)).g, 0.0);
}

TEST_F(StageTest, WithoutAbsorptionItStaysFinite) {
  AddMesh(Ball(15.0, 48), 0);
  AddLamp({0, 20, 74});
  Start("spectralon", Scattering::kFull);
  const image::Image picture = Draw(Attribute::kTranslucency);
  for (const float value : picture.As<float>()) ASSERT_TRUE(std::isfinite(value));
}

TEST_F(StageTest, SaysHowFarLightGoesAndWhenTheUnitLooksWrong) {
  AddMesh(Ball(15.0, 24), 0);
  scene_.nodes[0].name = "Ball";
  Start("marble");
  (void)Draw(Attribute::kColor);
  const std::vector<std::string> notes = stage_->TakeNotes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_THAT(notes[0],
              HasSubstr("translucency: node \"Ball\", 30.1 mm of Marble: mean free path 0.456 0.381 0.333 mm"));
  EXPECT_THAT(notes[0], HasSubstr("1/sigma_tr 8.51 5.57 3.95 mm"));
  EXPECT_TRUE(stage_->TakeWarnings().empty());
  (void)Draw(Attribute::kColor);
  EXPECT_TRUE(stage_->TakeNotes().empty());
  scene_.nodes[0].matrix = glm::scale(glm::mat4(1.0f), glm::vec3(0.001f));
  Start("marble");
  (void)Draw(Attribute::kColor, {0.0f, 0.0f, 0.08f});
  const std::vector<std::string> warnings = stage_->TakeWarnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr("where diffusion no longer holds; is --unit-mm 1 right?"));
}

TEST_F(StageTest, ObjectsWhoseMapsDoNotFitAreRefused) {
  for (int i = 0; i < 7; ++i) AddMesh(Ball(1.0, 4), 0);
  AddLamp({0, 0, 74});
  most_map_bytes_ = std::size_t{200} << 20;
  Start("marble", Scattering::kFull);
  const auto drawn = Try({Attribute::kColor}, {0, 0, 80}, nullptr);
  ASSERT_FALSE(drawn);
  EXPECT_EQ(drawn.error().kind, ErrorKind::kFailed);
  EXPECT_EQ(drawn.error().message,
            "translucency: the maps of 7 translucent objects, 34 MiB each, need more than the limit of 200 MiB; with "
            "--scattering fast they are 12 MiB or more; surfaces of one node and medium are one object");
  most_map_bytes_ = std::size_t{240} << 20;
  Start("marble", Scattering::kFull);
  EXPECT_TRUE(Try({Attribute::kColor}, {0, 0, 80}, nullptr));
}

TEST_F(StageTest, IsNotThereWithoutATranslucentMaterial) {
  AddMesh(Ball(15.0, 24), 0);
  EXPECT_EQ(Take(TranslucencyRenderer::Create(scene_, nullptr, {})), nullptr);
}

}  // namespace
}  // namespace burin::translucency
