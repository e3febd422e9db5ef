// SPDX-License-Identifier: Apache-2.0
#include "core/render/plan.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>

namespace burin::render {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

SourceInfo Scene(std::vector<long> frames = {1}) {
  SourceInfo info;
  info.kind = SourceKind::kScene;
  info.frames = std::move(frames);
  return info;
}

SourceInfo Video(int width = 320, int height = 240) {
  SourceInfo info;
  info.kind = SourceKind::kVideo;
  info.width = width;
  info.height = height;
  info.rate = video::FrameRate{30000, 1001};
  info.has_alpha = false;
  return info;
}

SourceInfo Picture(image::SampleType type, bool has_alpha) {
  SourceInfo info;
  info.kind = SourceKind::kImage;
  info.width = 7;
  info.height = 5;
  info.type = type;
  info.has_alpha = has_alpha;
  info.frames = {1};
  return info;
}

Job To(const std::string& output) {
  Job job;
  job.output = output;
  job.source = "source";
  return job;
}

Plan Planned(const Job& job, const SourceInfo& source) {
  auto output = ClassifyOutput(job);
  EXPECT_TRUE(output) << (output ? "" : output.error().message);
  auto plan = MakePlan(job, *std::move(output), source);
  EXPECT_TRUE(plan) << (plan ? "" : plan.error().message);
  return plan.value_or(Plan());
}

std::string Refusal(const Job& job, const SourceInfo& source) {
  auto output = ClassifyOutput(job);
  if (!output) {
    EXPECT_EQ(output.error().kind, ErrorKind::kUsage);
    return output.error().message;
  }
  const auto plan = MakePlan(job, *std::move(output), source);
  if (plan) return "accepted";
  EXPECT_EQ(plan.error().kind, ErrorKind::kUsage);
  return plan.error().message;
}

TEST(Plan, ASceneGivesOneFrameToOneFileAndAllToSeveral) {
  EXPECT_THAT(Planned(To("a.png"), Scene({1, 2, 3})).frames, ElementsAre(1));
  EXPECT_THAT(Planned(To("a.##.png"), Scene({1, 2, 3})).frames, ElementsAre(1, 2, 3));
  EXPECT_THAT(Planned(To("a.mkv"), Scene({1, 2, 3})).frames, ElementsAre(1, 2, 3));
}

TEST(Plan, AVideoGivesAllItsFramesUnlessSomeAreChosen) {
  EXPECT_TRUE(Planned(To("a.mkv"), Video()).frames.empty());
  Job job = To("a.####.png");
  job.frames = {3, 5};
  const Plan plan = Planned(job, Video());
  EXPECT_THAT(plan.frames, ElementsAre(3, 5));
  EXPECT_TRUE(plan.frames_were_asked_for);
}

TEST(Plan, SeveralFramesNeedAPlaceForTheNumber) {
  Job job = To("out/a.png");
  job.frames = {1, 2, 3};
  EXPECT_EQ(Refusal(job, Scene()),
            "out/a.png: 3 frames need a name with a place for the number, such as out/a.####.png; or choose one by "
            "--frames");
  EXPECT_EQ(
      Refusal(To("a.png"), Video()),
      "a.png: all frames of a video need a name with a place for the number, such as a.####.png; or choose one by "
      "--frames");
  job.frames = {2};
  EXPECT_THAT(Planned(job, Scene()).frames, ElementsAre(2));
}

TEST(Plan, TheSizeIsTheSourcesOrTheDefaultOrWhatWasAskedFor) {
  EXPECT_EQ(Planned(To("a.mkv"), Video()).width, 320);
  EXPECT_EQ(Planned(To("a.png"), Scene()).width, 1280);
  EXPECT_EQ(Planned(To("a.png"), Scene()).height, 720);
  Job job = To("a.mkv");
  job.size = std::pair(64, 48);
  EXPECT_EQ(Planned(job, Video()).height, 48);
}

TEST(Plan, TheRateIsTheOptionsThenTheSourcesThen24) {
  EXPECT_EQ(Planned(To("a.mkv"), Video()).rate.numerator, 30000);
  EXPECT_EQ(Planned(To("a.mkv"), Scene()).rate.numerator, 24);
  Job job = To("a.mkv");
  job.fps = video::FrameRate{25, 1};
  EXPECT_EQ(Planned(job, Video()).rate.numerator, 25);
}

TEST(Plan, SamplesFollowTheFormatAndTheSource) {
  using enum image::SampleType;
  EXPECT_EQ(Planned(To("a.png"), Picture(kU8, false)).output.type, kU8);
  EXPECT_EQ(Planned(To("a.png"), Picture(kU16, false)).output.type, kU16);
  EXPECT_EQ(Planned(To("a.jpg"), Picture(kU16, false)).output.type, kU8);
  EXPECT_EQ(Planned(To("a.exr"), Picture(kU8, false)).output.type, kF16);
  EXPECT_EQ(Planned(To("a.exr"), Picture(kU8, false)).output.encoding, image::Encoding::kSceneLinear);
  Job job = To("a.exr");
  job.depth_bits = 32;
  EXPECT_EQ(Planned(job, Scene()).output.type, kF32);
}

TEST(Plan, AlphaIsKeptWhereTheSourceHasIt) {
  using enum image::SampleType;
  EXPECT_EQ(Planned(To("a.png"), Picture(kU8, true)).output.channels, 4);
  EXPECT_EQ(Planned(To("a.png"), Picture(kU8, false)).output.channels, 3);
  EXPECT_EQ(Planned(To("a.jpg"), Picture(kU8, true)).output.channels, 3);
  Job job = To("a.jpg");
  job.alpha = AlphaOutput::kKeep;
  EXPECT_THAT(Refusal(job, Picture(kU8, true)), HasSubstr("a.jpg: "));
}

TEST(Plan, VideoRefusesWhatItCannotHold) {
  Job job = To("a.mkv");
  job.depth_bits = 16;
  EXPECT_EQ(Refusal(job, Video()),
            "a.mkv: video holds 8 bits a channel, not 16; write an image sequence instead "
            "(frame.####.png or frame.####.exr)");
  job.depth_bits = 0;
  job.alpha = AlphaOutput::kKeep;
  EXPECT_EQ(Refusal(job, Video()),
            "a.mkv: video holds no alpha; write an image sequence instead (frame.####.png or frame.####.exr)");
}

TEST(Plan, H264NeedsEvenSizes) {
  EXPECT_EQ(Refusal(To("a.mp4"), Video(65, 48)),
            "a.mp4: H.264 needs an even width and height, the frame is 65x48; use --size, or .mkv (FFV1)");
  EXPECT_EQ(Refusal(To("a.mkv"), Video(65, 49)), "accepted");
}

TEST(Plan, AttributesNeedLayersOrStandAlone) {
  Job job = To("a.png");
  job.attributes = {"normal", "depth"};
  EXPECT_EQ(Refusal(job, Scene()), "a.png: 2 attributes need layers; expected an .exr output, or one attribute");
  job.attributes = {"normal"};
  EXPECT_FALSE(Planned(job, Scene()).has_frame);
  job.effects = {"e.fx"};
  EXPECT_EQ(Refusal(job, Scene()),
            "a.png: --attributes beside an effect's frame needs layers; expected an .exr output");
  job.output = "a.exr";
  EXPECT_TRUE(Planned(job, Scene()).has_frame);
}

TEST(Plan, UnknownAttributesAreNamedWithTheNearest) {
  Job job = To("a.exr");
  job.attributes = {"normals"};
  EXPECT_EQ(Refusal(job, Scene()),
            "--attributes: unknown attribute 'normals', did you mean normal?; burin-attributes(7) lists them");
  job.attributes = {"depth", "Depth"};
  EXPECT_EQ(Refusal(job, Scene()), "--attributes: 'Depth' stands twice");
}

TEST(Output, UnknownNamesAreRefused) {
  EXPECT_EQ(Refusal(To(""), Scene()), "no output; expected -o FILE (or -o - for a stream on stdout)");
  EXPECT_EQ(
      Refusal(To("a.doc"), Scene()),
      "a.doc: unknown extension .doc; expected an image (.png .jpg .tif .exr), a video (.mkv .mp4 .avi .mov .y4m) "
      "or -");
  EXPECT_THAT(Refusal(To("a"), Scene()), HasSubstr("a: no extension; expected an image"));
  EXPECT_EQ(Refusal(To("a.##.mkv"), Scene()), "a.##.mkv: a video is one file, its name takes no frame number");
}

TEST(Output, AMissingFolderIsNamedAndMadeOnDemand) {
  const auto folder = std::filesystem::temp_directory_path() / ("burin_output_" + std::to_string(getpid()));
  const auto output = ClassifyOutput(To((folder / "deep" / "a.png").string()));
  ASSERT_TRUE(output);
  const auto missing = CheckPlace(*output, false);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::kFailed);
  EXPECT_EQ(missing.error().message, (folder / "deep" / "a.png").string() + ": the folder " +
                                         (folder / "deep").string() + " is not there; --mkdir makes it");
  EXPECT_TRUE(CheckPlace(*output, true));
  EXPECT_TRUE(std::filesystem::is_directory(folder / "deep"));
  std::filesystem::remove_all(folder);
}

TEST(Source, IsToldByItsName) {
  EXPECT_EQ(ClassifySource(""), SourceKind::kNone);
  EXPECT_EQ(ClassifySource("-"), SourceKind::kY4mStream);
  EXPECT_EQ(ClassifySource("a.GLB"), SourceKind::kScene);
  EXPECT_EQ(ClassifySource("a.gltf"), SourceKind::kScene);
  EXPECT_EQ(ClassifySource("a.y4m"), SourceKind::kY4mFile);
  EXPECT_EQ(ClassifySource("a.mp4"), SourceKind::kVideo);
  EXPECT_EQ(ClassifySource("a.####.png"), SourceKind::kSequence);
  EXPECT_EQ(ClassifySource("a.png"), SourceKind::kImage);
}

}  // namespace
}  // namespace burin::render
