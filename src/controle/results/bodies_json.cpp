#include "controle/results/bodies_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "controle/results/json_vector.hpp"

namespace animado::controle {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> kMotions = {"dynamic", "static", "kinematic"};

Vec3 vector_of(const Json& json) {
  return Vec3(json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>());
}

struct ShapeWriter {
  Json operator()(const Sphere& s) const { return {{"kind", "sphere"}, {"radius_m", s.radius_m}}; }
  Json operator()(const Box& s) const { return {{"kind", "box"}, {"size_m", json_vector(2 * s.half_m)}}; }
  Json operator()(const Capsule& s) const { return round("capsule", s.radius_m, 2 * s.half_height_m); }
  Json operator()(const Cylinder& s) const { return round("cylinder", s.radius_m, 2 * s.half_height_m); }
  Json operator()(const Cone& s) const { return round("cone", s.radius_m, s.height_m); }
  Json operator()(const Hull& s) const {
    Json vertices = Json::array();
    for (const Vec3& v : s.vertices_m) vertices.push_back(json_vector(v));
    return {{"kind", "hull"}, {"vertices_m", vertices}, {"faces", s.faces}};
  }
  Json operator()(const HalfSpace& s) const {
    return {{"kind", "plane"}, {"normal", json_vector(s.normal)}, {"offset_m", s.offset_m}};
  }
  static Json round(const char* kind, double radius_m, double height_m) {
    return {{"kind", kind}, {"radius_m", radius_m}, {"height_m", height_m}};
  }
};

Hull hull_of(const Json& json) {
  Hull hull;
  for (const Json& v : json.at("vertices_m")) hull.vertices_m.push_back(vector_of(v));
  hull.faces = json.at("faces").get<std::vector<std::vector<int>>>();
  const auto count = static_cast<int>(hull.vertices_m.size());
  for (const auto& face : hull.faces) {
    const auto is_vertex = [&](int v) { return v >= 0 && v < count; };
    if (face.size() < 3 || !std::ranges::all_of(face, is_vertex))
      throw Error(Code::bad_params, "a face of a hull names a vertex that is not there");
  }
  return hull;
}

Shape shape_of(const Json& json) {
  const std::string kind = json.at("kind");
  const auto number = [&](const char* name) { return json.at(name).get<double>(); };
  if (kind == "sphere") return Sphere{number("radius_m")};
  if (kind == "box") return Box{vector_of(json.at("size_m")) / 2};
  if (kind == "capsule") return Capsule{number("radius_m"), number("height_m") / 2};
  if (kind == "cylinder") return Cylinder{number("radius_m"), number("height_m") / 2};
  if (kind == "cone") return Cone{number("radius_m"), number("height_m")};
  if (kind == "hull") return hull_of(json);
  if (kind == "plane") return HalfSpace{vector_of(json.at("normal")), number("offset_m")};
  throw Error(Code::bad_params, fmt::format("no shape is named '{}'", kind));
}

RecordedBody body_of(const Json& json) {
  const std::string motion = json.at("motion");
  const auto found = std::ranges::find(kMotions, motion);
  if (found == kMotions.end()) throw Error(Code::bad_params, fmt::format("no motion is named '{}'", motion));
  return {json.at("name"), static_cast<Motion>(found - kMotions.begin()), json.at("mass_kg"),
          vector_of(json.at("color")), shape_of(json.at("shape"))};
}

}  // namespace

std::string bodies_text(const std::vector<RecordedBody>& bodies) {
  std::string text = "{\"bodies\": [";
  for (size_t i = 0; i < bodies.size(); ++i) {
    const RecordedBody& body = bodies[i];
    const Json json = {{"name", body.name},
                       {"motion", kMotions[static_cast<size_t>(body.motion)]},
                       {"mass_kg", body.mass_kg},
                       {"color", json_vector(body.color_srgb)},
                       {"shape", std::visit(ShapeWriter(), body.shape)}};
    text += (i == 0 ? "\n" : ",\n") + json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return text + "\n]}\n";
}

std::vector<RecordedBody> parse_bodies(const std::string& text, const std::string& where) {
  constexpr auto kRemedy = "simulate the scene again: animado run SCENE";
  try {
    const Json page = Json::parse(text);
    std::vector<RecordedBody> bodies;
    for (const Json& body : page.at("bodies")) bodies.push_back(body_of(body));
    return bodies;
  } catch (const nlohmann::json::exception& error) {
    throw Error(Code::bad_params, fmt::format("these are not the bodies of a run: {}", error.what()), where,
                kRemedy);
  } catch (const Error& error) {
    throw Error(error.code(), error.message(), where, kRemedy);
  }
}

}  // namespace animado::controle
