#include "controle/results/animation_glb.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/state.hpp"
#include "controle/results/output_file.hpp"
#include "controle/results/tessellate.hpp"

namespace animado::controle {
namespace {

using Floats = std::vector<float>;

// A glTF model under construction. Everything lies in one buffer, a view an array: floats and indices have
// four bytes, so that each view is aligned as the format wants it.
class Builder {
 public:
  int add_floats(const Floats& numbers, int type, int target = 0) {
    return add_accessor(numbers.data(), numbers.size(), TINYGLTF_COMPONENT_TYPE_FLOAT, type, target);
  }
  int add_indices(const std::vector<uint32_t>& indices) {
    return add_accessor(indices.data(), indices.size(), TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                        TINYGLTF_TYPE_SCALAR, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  }
  void set_range(int accessor, const Floats& numbers, size_t components);
  tinygltf::Model take();

  tinygltf::Model model;

 private:
  int add_accessor(const void* numbers, size_t count, int component_type, int type, int target);

  std::vector<unsigned char> bytes_;
};

int Builder::add_accessor(const void* numbers, size_t count, int component_type, int type, int target) {
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes_.size();
  view.byteLength = count * 4;
  view.target = target;
  const auto* first = static_cast<const unsigned char*>(numbers);
  bytes_.insert(bytes_.end(), first, first + view.byteLength);

  tinygltf::Accessor accessor;
  accessor.bufferView = static_cast<int>(model.bufferViews.size());
  accessor.componentType = component_type;
  accessor.type = type;
  accessor.count = count / static_cast<size_t>(tinygltf::GetNumComponentsInType(static_cast<uint32_t>(type)));
  model.bufferViews.push_back(std::move(view));
  model.accessors.push_back(std::move(accessor));
  return static_cast<int>(model.accessors.size()) - 1;
}

void Builder::set_range(int accessor, const Floats& numbers, size_t components) {
  std::vector<double>& low = model.accessors[static_cast<size_t>(accessor)].minValues;
  std::vector<double>& high = model.accessors[static_cast<size_t>(accessor)].maxValues;
  low.assign(numbers.begin(), numbers.begin() + static_cast<ptrdiff_t>(components));
  high = low;
  for (size_t k = 0; k < numbers.size(); ++k) {
    low[k % components] = std::min(low[k % components], static_cast<double>(numbers[k]));
    high[k % components] = std::max(high[k % components], static_cast<double>(numbers[k]));
  }
}

tinygltf::Model Builder::take() {
  model.buffers.emplace_back().data = std::move(bytes_);
  return std::move(model);
}

void append(Floats& numbers, const auto& vector) {
  for (const double x : vector) numbers.push_back(static_cast<float>(x));
}

Floats floats_of(const std::vector<Vec3>& vectors) {
  Floats numbers;
  for (const Vec3& v : vectors) append(numbers, v);
  return numbers;
}

// IEC 61966-2-1: what CSS writes → the light that glTF wants.
double linear_of(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

int add_material(tinygltf::Model& model, const AnimatedBody& body) {
  tinygltf::Material& material = model.materials.emplace_back();
  material.name = body.name;
  const Vec3& c = body.color_srgb;
  material.pbrMetallicRoughness.baseColorFactor = {linear_of(c.x()), linear_of(c.y()), linear_of(c.z()), 1};
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 0.6;
  return static_cast<int>(model.materials.size()) - 1;
}

int add_mesh(Builder& builder, const std::string& name, const TriangleMesh& triangles, int material) {
  const Floats positions_m = floats_of(triangles.positions_m);
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = material;
  const int positions = builder.add_floats(positions_m, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
  builder.set_range(positions, positions_m, 3);
  primitive.attributes["POSITION"] = positions;
  primitive.attributes["NORMAL"] =
      builder.add_floats(floats_of(triangles.normals), TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
  primitive.indices = builder.add_indices(triangles.triangles);
  tinygltf::Mesh& mesh = builder.model.meshes.emplace_back();
  mesh.name = name;
  mesh.primitives.push_back(std::move(primitive));
  return static_cast<int>(builder.model.meshes.size()) - 1;
}

// Bodies that look alike share a mesh: ten thousand boxes need not be ten thousand times in the file.
void add_nodes(Builder& builder, const std::vector<AnimatedBody>& bodies, double plane_extent_m) {
  using Look = std::tuple<Floats, std::vector<uint32_t>, double, double, double>;
  std::map<Look, int> meshes;
  tinygltf::Scene& scene = builder.model.scenes.emplace_back();
  for (const AnimatedBody& body : bodies) {
    const TriangleMesh triangles = tessellate(body.shape, plane_extent_m);
    const Vec3& c = body.color_srgb;
    const auto [mesh, is_new] =
        meshes.try_emplace({floats_of(triangles.positions_m), triangles.triangles, c.x(), c.y(), c.z()});
    if (is_new) mesh->second = add_mesh(builder, body.name, triangles, add_material(builder.model, body));
    tinygltf::Node& node = builder.model.nodes.emplace_back();
    node.name = body.name;
    node.mesh = mesh->second;
    scene.nodes.push_back(static_cast<int>(builder.model.nodes.size()) - 1);
  }
  builder.model.defaultScene = 0;
}

void add_channel(tinygltf::Animation& animation, size_t node, const char* path, int input, int output) {
  tinygltf::AnimationSampler& sampler = animation.samplers.emplace_back();
  sampler.input = input;
  sampler.output = output;
  sampler.interpolation = "LINEAR";  // spherical for rotations
  tinygltf::AnimationChannel& channel = animation.channels.emplace_back();
  channel.sampler = static_cast<int>(animation.samplers.size()) - 1;
  channel.target_node = static_cast<int>(node);
  channel.target_path = path;
}

void save(const tinygltf::Model& model, const std::filesystem::path& file) {
  std::ostringstream bytes;
  constexpr bool kPretty = false, kBinary = true;
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, bytes, kPretty, kBinary)) {
    throw Error(Code::internal, "the animation could not be encoded", file.string());
  }
  OutputFile output(file);
  output.write(bytes.view());
  output.close();
}

// Viewers turn from one key to the next by the shorter arc of the quaternions as they stand: of q and −q, the
// one nearer to the key before is written.
void append_key(Floats& keys, Quat rotation) {
  rotation.normalize();
  double along = 1;
  if (!keys.empty()) {
    const float* last = keys.data() + keys.size() - 4;
    along = rotation.x() * last[0] + rotation.y() * last[1] + rotation.z() * last[2] + rotation.w() * last[3];
  }
  append(keys, (along < 0 ? -1.0 : 1.0) * rotation.coeffs());
}

}  // namespace

AnimationGlb::AnimationGlb(std::vector<AnimatedBody> bodies, double plane_extent_m)
    : bodies_(std::move(bodies)),
      plane_extent_m_(plane_extent_m),
      translations_m_(bodies_.size()),
      rotations_(bodies_.size()) {}

void AnimationGlb::with_physics(std::vector<BodyPhysics> physics, std::string restitution_combine) {
  assert(physics.size() == bodies_.size());
  physics_ = std::move(physics);
  restitution_combine_ = std::move(restitution_combine);
}

void AnimationGlb::frame(double time_s, std::span<const double> state) {
  assert(state.size() == bodies_.size() * kStateRows);
  if (times_s_.empty()) {
    first_time_s_ = time_s;
    for (size_t i = 0; i < physics_.size(); ++i)
      physics_[i].start = load_body(state.data(), bodies_.size(), i);
  }
  const auto key_time_s = static_cast<float>(time_s - first_time_s_);
  if (!times_s_.empty() && key_time_s <= times_s_.back()) return;
  const bool is_first = times_s_.empty();
  times_s_.push_back(key_time_s);
  for (size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].motion == Motion::fixed && !is_first) continue;
    const Pose pose = load_body(state.data(), bodies_.size(), i).pose;
    append(translations_m_[i], pose.position_m);
    append_key(rotations_[i], pose.orientation);
  }
}

void AnimationGlb::write(const std::filesystem::path& file) const {
  Builder builder;
  builder.model.asset.version = "2.0";
  builder.model.asset.generator = "ANIMADO " ANIMADO_VERSION;
  add_nodes(builder, bodies_, plane_extent_m_);
  tinygltf::Animation animation;
  int times = -1;
  for (size_t i = 0; i < bodies_.size() && !times_s_.empty(); ++i) {
    tinygltf::Node& node = builder.model.nodes[i];
    node.translation.assign(translations_m_[i].begin(), translations_m_[i].begin() + 3);
    node.rotation.assign(rotations_[i].begin(), rotations_[i].begin() + 4);
    if (bodies_[i].motion == Motion::fixed) continue;
    if (times < 0) {
      times = builder.add_floats(times_s_, TINYGLTF_TYPE_SCALAR);
      builder.set_range(times, times_s_, 1);
    }
    add_channel(animation, i, "translation", times,
                builder.add_floats(translations_m_[i], TINYGLTF_TYPE_VEC3));
    add_channel(animation, i, "rotation", times, builder.add_floats(rotations_[i], TINYGLTF_TYPE_VEC4));
  }
  add_physics(builder.model, physics_, restitution_combine_);
  if (!animation.channels.empty()) builder.model.animations.push_back(std::move(animation));
  save(builder.take(), file);
}

}  // namespace animado::controle
