// src/controle/results/animation_glb.cpp: the file is read back by another reader's rules (glTF 2.0
// specification).
#include "controle/results/animation_glb.hpp"

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <cmath>
#include <numbers>
#include <set>

#include "base/euler.hpp"
#include "base/state.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::controle {
namespace {

// A ball that turns about y and moves along x, over a floor.
class ScriptedMotion {
 public:
  explicit ScriptedMotion(double turn_a_frame_rad, int frames = 4, double start_s = 2, double step_s = 0.25) {
    AnimationGlb animation(
        {{.name = "ball", .shape = Sphere{1}, .color_srgb = {1, 0, 0.5}},
         {.name = "floor", .shape = HalfSpace{Vec3::UnitY(), -1}, .motion = Motion::fixed},
         {.name = "twin", .shape = Sphere{1}, .motion = Motion::kinematic, .color_srgb = {1, 0, 0.5}}});
    for (int k = 0; k < frames; ++k) {
      std::vector<double> state(3 * kStateRows);
      BodyState ball, rest;
      ball.pose.position_m = {0.5 * k, 0, 0};
      ball.pose.orientation = orientation_of({0, turn_a_frame_rad * k, 0}, {0, 1, 2});
      store_body(state.data(), 3, 0, ball);
      store_body(state.data(), 3, 1, rest);
      store_body(state.data(), 3, 2, ball);
      animation.frame(start_s + step_s * k, state);
    }
    animation.write(file());
    std::string error, warning;
    EXPECT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &error, &warning, file().string())) << error;
    EXPECT_EQ(error + warning, "");
  }

  std::filesystem::path file() const { return directory_.path() / "animation.glb"; }

  std::vector<float> floats(int accessor_index) const {
    const tinygltf::Accessor& accessor = model.accessors[static_cast<size_t>(accessor_index)];
    const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(accessor.bufferView)];
    std::vector<float> numbers(view.byteLength / sizeof(float));
    std::memcpy(numbers.data(), model.buffers[0].data.data() + view.byteOffset, view.byteLength);
    return numbers;
  }

  // The keys of a node, times and values; empty when it has none.
  std::pair<std::vector<float>, std::vector<float>> keys(int node, const std::string& path) const {
    for (const tinygltf::AnimationChannel& channel : model.animations.at(0).channels) {
      if (channel.target_node != node || channel.target_path != path) continue;
      const tinygltf::AnimationSampler& sampler =
          model.animations[0].samplers[static_cast<size_t>(channel.sampler)];
      EXPECT_EQ(sampler.interpolation, "LINEAR");
      return {floats(sampler.input), floats(sampler.output)};
    }
    return {};
  }

  tinygltf::Model model;

 private:
  TemporaryDirectory directory_;
};

TEST(AnimationGlb, ANodeABody) {
  const ScriptedMotion motion(0.1);
  ASSERT_EQ(motion.model.nodes.size(), 3u);
  EXPECT_EQ(motion.model.nodes[0].name, "ball");
  EXPECT_EQ(motion.model.nodes[1].name, "floor");
  EXPECT_EQ(motion.model.nodes[2].name, "twin");
  EXPECT_EQ(motion.model.scenes.at(0).nodes, (std::vector<int>{0, 1, 2}));
}

TEST(AnimationGlb, BodiesThatLookAlikeShareAMesh) {
  const ScriptedMotion motion(0.1);
  EXPECT_EQ(motion.model.meshes.size(), 2u);
  EXPECT_EQ(motion.model.nodes[0].mesh, motion.model.nodes[2].mesh);
  EXPECT_NE(motion.model.nodes[0].mesh, motion.model.nodes[1].mesh);
}

TEST(AnimationGlb, StartsAtZeroWithAKeyAFrame) {
  const ScriptedMotion motion(0.1);
  const auto [times, places] = motion.keys(0, "translation");
  EXPECT_EQ(times, (std::vector<float>{0, 0.25, 0.5, 0.75}));
  EXPECT_EQ(places, (std::vector<float>{0, 0, 0, 0.5, 0, 0, 1, 0, 0, 1.5, 0, 0}));
}

TEST(AnimationGlb, RotationsAreXyzw) {
  const ScriptedMotion motion(std::numbers::pi / 2);
  const auto [times, turns] = motion.keys(2, "rotation");
  ASSERT_EQ(turns.size(), 16u);
  const auto half = static_cast<float>(std::sqrt(0.5));
  EXPECT_FLOAT_EQ(turns[5], half);  // y of the second key
  EXPECT_FLOAT_EQ(turns[7], half);  // its w
}

// Turned on and on, q comes back as −q: a viewer that goes from one to the other would spin backwards.
TEST(AnimationGlb, ConsecutiveKeysLieInOneHemisphere) {
  const ScriptedMotion motion(2.5, 40);
  const auto [times, turns] = motion.keys(0, "rotation");
  ASSERT_EQ(turns.size(), 160u);
  for (size_t k = 4; k < turns.size(); k += 4) {
    float along = 0, length = 0;
    for (size_t c = 0; c < 4; ++c)
      along += turns[k + c] * turns[k + c - 4], length += turns[k + c] * turns[k + c];
    EXPECT_NEAR(along, std::cos(1.25), 1e-5);
    EXPECT_NEAR(length, 1, 1e-6);
  }
}

TEST(AnimationGlb, AFixedBodyHasAPlaceAndNoChannels) {
  const ScriptedMotion motion(0.1);
  EXPECT_TRUE(motion.keys(1, "translation").first.empty());
  EXPECT_TRUE(motion.keys(1, "rotation").first.empty());
  EXPECT_EQ(motion.model.nodes[1].translation.size(), 3u);
  EXPECT_EQ(motion.model.animations.at(0).channels.size(), 4u);
}

TEST(AnimationGlb, ColoursAreLinear) {
  const ScriptedMotion motion(0.1);
  const std::vector<double>& color = motion.model.materials[0].pbrMetallicRoughness.baseColorFactor;
  EXPECT_EQ(color[0], 1);
  EXPECT_EQ(color[1], 0);
  EXPECT_NEAR(color[2], 0.2140411, 1e-7);  // IEC 61966-2-1 of one half
}

TEST(AnimationGlb, RangesAreThoseOfTheNumbers) {
  const ScriptedMotion motion(0.1);
  for (const tinygltf::Mesh& mesh : motion.model.meshes) {
    const int index = mesh.primitives[0].attributes.at("POSITION");
    const tinygltf::Accessor& accessor = motion.model.accessors[static_cast<size_t>(index)];
    const std::vector<float> numbers = motion.floats(index);
    for (size_t c = 0; c < 3; ++c) {
      double low = numbers[c], high = numbers[c];
      for (size_t k = c; k < numbers.size(); k += 3)
        low = std::fmin(low, numbers[k]), high = std::fmax(high, numbers[k]);
      EXPECT_EQ(accessor.minValues.at(c), low);
      EXPECT_EQ(accessor.maxValues.at(c), high);
    }
  }
  const tinygltf::Accessor& times =
      motion.model.accessors[static_cast<size_t>(motion.model.animations[0].samplers[0].input)];
  EXPECT_EQ(times.minValues, std::vector<double>{0});
  EXPECT_EQ(times.maxValues, std::vector<double>{0.75});
}

TEST(AnimationGlb, ViewsAreAligned) {
  const ScriptedMotion motion(0.1);
  for (const tinygltf::BufferView& view : motion.model.bufferViews) EXPECT_EQ(view.byteOffset % 4, 0u);
  EXPECT_EQ(std::filesystem::file_size(motion.file()) % 4, 0u);
}

TEST(AnimationGlb, TimesThatSinglePrecisionCannotTellApartAreLeftOut) {
  const ScriptedMotion motion(0.1, 4, 0, 1e-60);
  EXPECT_EQ(motion.keys(0, "translation").first.size(), 1u);
}

// The drafts, on request: what a physics engine would take over.
class WithPhysics : public testing::Test {
 protected:
  WithPhysics() {
    AnimationGlb animation({{.name = "cone", .shape = Cone{1, 4}},
                            {.name = "floor", .shape = HalfSpace{Vec3::UnitX(), 2}, .motion = Motion::fixed},
                            {.name = "rock", .shape = tetrahedron()}});
    animation.with_physics({{Cone{1, 4}, Motion::dynamic, 3, Vec3(0, 0, 1), inertia(), 0.5, 0.25},
                            {HalfSpace{Vec3::UnitX(), 2}, Motion::fixed},
                            {tetrahedron(), Motion::kinematic}},
                           "multiply");
    std::vector<double> state(3 * kStateRows);
    BodyState cone;
    cone.pose.orientation =
        orientation_of({0, 0, std::numbers::pi / 2}, {0, 1, 2});  // its x is the world's y
    cone.velocity_m_s = {0, 5, 0};
    cone.angular_velocity_body_rad_s = {0, 2, 0};
    for (size_t i = 0; i < 3; ++i) store_body(state.data(), 3, i, i == 0 ? cone : BodyState());
    animation.frame(0, state);
    animation.write(directory_ / "animation.glb");
    std::string error, warning;
    EXPECT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(&model_, &error, &warning,
                                                        (directory_ / "animation.glb").string()));
  }

  static Hull tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  }
  static Mat3 inertia() { return Vec3(2, 3, 4).asDiagonal(); }
  tinygltf::Value of_node(size_t node) const {
    const auto& extensions = model_.nodes[node].extensions;
    const auto found = extensions.find("KHR_physics_rigid_bodies");
    return found == extensions.end() ? tinygltf::Value() : found->second;
  }
  static Vec3 vector(const tinygltf::Value& list) {
    return {list.Get(0).GetNumberAsDouble(), list.Get(1).GetNumberAsDouble(),
            list.Get(2).GetNumberAsDouble()};
  }

  TemporaryDirectory directory_;
  tinygltf::Model model_;
};

TEST_F(WithPhysics, AMotionIsInTheNodesAxes) {
  const tinygltf::Value motion = of_node(0).Get("motion");
  EXPECT_EQ(motion.Get("mass").GetNumberAsDouble(), 3);
  EXPECT_EQ(vector(motion.Get("centerOfMass")), Vec3(0, 0, 1));
  EXPECT_LT((vector(motion.Get("inertiaDiagonal")) - Vec3(2, 3, 4)).norm(), 1e-12);
  EXPECT_LT((vector(motion.Get("angularVelocity")) - Vec3(0, 2, 0)).norm(), 1e-12);
  // 5 m/s along the body's x, and (0, 2, 0) × (0, 0, 1) on top: the centre of mass lies off the origin.
  EXPECT_LT((vector(motion.Get("linearVelocity")) - Vec3(7, 0, 0)).norm(), 1e-12);
  EXPECT_FALSE(of_node(1).Has("motion"));
  EXPECT_TRUE(of_node(2).Get("motion").Get("isKinematic").Get<bool>());
}

TEST_F(WithPhysics, AConeIsACylinderThatEndsInAPointAndStandsHigher) {
  ASSERT_EQ(model_.nodes.size(), 5u);
  EXPECT_EQ(model_.nodes[0].children, std::vector<int>{3});
  EXPECT_EQ(model_.nodes[3].name, "cone collider");
  EXPECT_EQ(model_.nodes[3].translation, (std::vector<double>{0, 1, 0}));
  const tinygltf::Value shapes = model_.extensions.at("KHR_implicit_shapes").Get("shapes");
  const int shape = of_node(3).Get("collider").Get("geometry").Get("shape").GetNumberAsInt();
  const tinygltf::Value cylinder = shapes.Get(shape).Get("cylinder");
  EXPECT_EQ(cylinder.Get("height").GetNumberAsDouble(), 4);
  EXPECT_EQ(cylinder.Get("radiusBottom").GetNumberAsDouble(), 1);
  EXPECT_EQ(cylinder.Get("radiusTop").GetNumberAsDouble(), 0);
}

TEST_F(WithPhysics, APlanesNormalIsItsNodesY) {
  const tinygltf::Node& node = model_.nodes[4];
  EXPECT_EQ(node.translation, (std::vector<double>{2, 0, 0}));
  const Quat turn(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
  EXPECT_LT((turn * Vec3::UnitY() - Vec3::UnitX()).norm(), 1e-12);
  const tinygltf::Value shapes = model_.extensions.at("KHR_implicit_shapes").Get("shapes");
  const tinygltf::Value plane =
      shapes.Get(of_node(4).Get("collider").Get("geometry").Get("shape").GetNumberAsInt());
  EXPECT_TRUE(plane.Get("plane").IsObject());
  EXPECT_FALSE(plane.Get("plane").Has("sizeX")) << "it is infinite";
}

TEST_F(WithPhysics, AHullIsThatOfItsMesh) {
  const tinygltf::Value geometry = of_node(2).Get("collider").Get("geometry");
  EXPECT_EQ(geometry.Get("node").GetNumberAsInt(), 2);
  EXPECT_TRUE(geometry.Get("convexHull").Get<bool>());
}

// Of two such bodies the product is the friction that the run has for them: √(0.25·0.25).
TEST_F(WithPhysics, FrictionsCombineToTheirGeometricMean) {
  const tinygltf::Value materials = model_.extensions.at("KHR_physics_rigid_bodies").Get("physicsMaterials");
  EXPECT_EQ(materials.Get(0).Get("dynamicFriction").GetNumberAsDouble(), 0.5);
  EXPECT_EQ(materials.Get(0).Get("frictionCombine").Get<std::string>(), "multiply");
  EXPECT_EQ(materials.Get(0).Get("restitution").GetNumberAsDouble(), 0.5);
}

TEST_F(WithPhysics, TheFileSaysThatItUsesThemAndNotThatItNeedsThem) {
  EXPECT_EQ(model_.extensionsUsed,
            (std::vector<std::string>{"KHR_physics_rigid_bodies", "KHR_implicit_shapes"}));
  EXPECT_TRUE(model_.extensionsRequired.empty());
}

TEST(AnimationGlb, HasNoExtensionsUnasked) {
  EXPECT_TRUE(ScriptedMotion(0.1).model.extensionsUsed.empty());
}

TEST(AnimationGlb, NoFramesMeanNoAnimation) {
  const ScriptedMotion motion(0.1, 0);
  EXPECT_EQ(motion.model.nodes.size(), 3u);
  EXPECT_TRUE(motion.model.animations.empty());
}

TEST(AnimationGlb, TheSameMotionGivesTheSameBytes) {
  EXPECT_EQ(text_of(ScriptedMotion(0.3).file()), text_of(ScriptedMotion(0.3).file()));
}

}  // namespace
}  // namespace animado::controle
