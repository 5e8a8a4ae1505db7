#include "controle/scene/read_body.hpp"

#include "base/fold.hpp"
#include "controle/scene/colors.hpp"
#include "controle/scene/limits.hpp"
#include "controle/scene/refusal.hpp"
#include "controle/scene/text_file.hpp"

namespace animado::controle {
namespace {

class BodyReader {
 public:
  BodyReader(const Outline& outline, size_t index, const Constants& constants)
      : outline_(outline), object_(outline.objects[index]), constants_(constants), index_(index) {}

  Body run() {
    body_.name = object_.name;
    body_.folded_name = object_.folded_name;
    body_.places["object"] = object_.place;
    for (const Entry& entry : object_.entries) body_.places.emplace(entry.property->canonical, entry.place);
    body_.shape = constants_.shape(index_);
    read_motion(outline_, object_, body_);
    read_mass(outline_, index_, constants_, body_);
    read_surface();
    read_start();
    read_forces();
    read_look();
    return std::move(body_);
  }

 private:
  const Entry* find(std::string_view canonical) const { return object_.find(canonical); }

  void read_surface() {
    if (const Entry* entry = find("restitution")) {
      body_.restitution = constants_.number(entry->value);
      if (body_.restitution < 0 || body_.restitution > 1) {
        fail(entry->value.place, Code::refused, fmt::format("a restitution of {:g}", body_.restitution),
             "it lies between 0 (no bounce) and 1 (no loss)");
      }
    }
    if (const Entry* entry = find("friction"))
      body_.friction = number_at_least(outline_, *entry, constants_, 0);
    if (const Entry* entry = find("linear damping"))
      body_.linear_damping_1_s = number_at_least(outline_, *entry, constants_, 0);
    if (const Entry* entry = find("angular damping"))
      body_.angular_damping_1_s = number_at_least(outline_, *entry, constants_, 0);
  }

  void read_start() {
    if (const Entry* entry = find("position")) body_.position_m = vector_within(*entry, kUniverse_m, "m");
    if (const Entry* entry = find("rotation order")) body_.rotation_order = order_of(entry->value);
    if (const Entry* entry = find("rotation")) body_.euler_rad = constants_.vector(entry->value);
    body_.orientation = orientation_of(body_.euler_rad, body_.rotation_order);
    body_.velocity_m_s = start_velocity("velocity", kSpeedOfLight_m_s, "m/s");
    body_.angular_velocity_rad_s = start_velocity("angular velocity", kFastestTurn_rad_s, "rad/s");
  }

  Vec3 vector_within(const Entry& entry, double most, std::string_view unit) const {
    const Vec3 value = constants_.vector(entry.value);
    const double largest = value.lpNorm<Eigen::Infinity>();
    if (largest > most) {
      fail(entry.value.place, Code::refused, fmt::format("{:.9g} {} is more than can be", largest, unit),
           fmt::format("the most is {:.9g} {}: look at the units", most, unit));
    }
    return value;
  }

  Vec3 start_velocity(std::string_view canonical, double most, std::string_view unit) const {
    const Entry* entry = find(canonical);
    if (!entry) return Vec3::Zero();
    const Vec3 value = vector_within(*entry, most, unit);
    if (body_.motion != Motion::dynamic && !value.isZero(0)) {
      fail(entry->place, Code::refused,
           fmt::format("`{}` is not dynamic and takes no {}", body_.name, canonical),
           body_.motion == Motion::fixed ? "leave it out, or give the object `motion path`"
                                         : "leave it out: its path says how fast it is");
    }
    return value;
  }

  // "xyz", "z y x", "x, y, z"
  RotationOrder order_of(const Expression& value) const {
    std::string axes;
    for (const char c : fold(value.text)) {
      if (c != ' ' && c != ',' && c != '\t') axes += c;
    }
    std::string sorted = axes;
    std::sort(sorted.begin(), sorted.end());
    if (sorted != "xyz") {
      fail(value.place, Code::syntax, fmt::format("`{}` is no order of rotations", value.text),
           "write each axis once: xyz, zyx, yxz …");
    }
    return {axes[0] - 'x', axes[1] - 'x', axes[2] - 'x'};
  }

  void read_forces() {
    for (const Entry& entry : object_.entries) {
      const std::string_view name = entry.property->canonical;
      std::vector<Expression>* lines = name == "force"          ? &body_.forces
                                       : name == "torque"       ? &body_.torques
                                       : name == "local force"  ? &body_.local_forces
                                       : name == "local torque" ? &body_.local_torques
                                                                : nullptr;
      if (!lines) continue;
      if (body_.motion != Motion::dynamic) {
        fail(entry.place, Code::refused, fmt::format("`{}` is not dynamic: no {} moves it", body_.name, name),
             "leave it out, or take the line `motion` away");
      }
      lines->push_back(entry.value);
    }
  }

  void read_look() {
    body_.color = palette_color(index_);
    if (const Entry* entry = find("color")) body_.color = color_of(entry->value);
    if (const Entry* entry = find("group"))
      body_.group = group_name(fold(entry->value.text), entry->value.place);
    if (const Entry* entry = find("collides with")) {
      const std::string groups = fold(entry->value.text);
      for (const std::string_view name : split(groups, ", \t")) {
        if (name != "and" && name != "e")
          body_.collides_with.push_back(group_name(std::string(name), entry->value.place));
      }
    }
  }

  Color color_of(const Expression& value) const {
    const std::string name = fold(value.text);
    if (const auto color = color_named(name)) return *color;
    if (!name.starts_with('(')) {
      const std::vector<std::string> known = color_names();
      fail(value.place, Code::unknown_name, fmt::format("unknown color `{}`", value.text),
           suggestion(name, known, "write a name of CSS, as tomato or steelblue, or (r, g, b) in 0 … 1"));
    }
    const Vec3 rgb = constants_.vector(value);
    if (rgb.minCoeff() < 0 || rgb.maxCoeff() > 1) {
      fail(value.place, Code::refused,
           fmt::format("a color of ({:g}, {:g}, {:g})", rgb.x(), rgb.y(), rgb.z()),
           "red, green and blue lie between 0 and 1");
    }
    return {rgb.x(), rgb.y(), rgb.z()};
  }

  std::string group_name(const std::string& name, Place place) const {
    const bool word = std::all_of(name.begin(), name.end(), [](char c) {
      return c == '_' || c == '-' || std::isalnum(static_cast<unsigned char>(c));
    });
    if (!word)
      fail(place, Code::syntax, fmt::format("`{}` is no name of a group", name),
           "a group has one word as its name");
    return name;
  }

  [[noreturn]] void fail(Place place, Code code, std::string message, std::string remedy) const {
    refuse(outline_.path, place, code, std::move(message), std::move(remedy));
  }

  const Outline& outline_;
  const Section& object_;
  const Constants& constants_;
  size_t index_;
  Body body_;
};

}  // namespace

Body read_body(const Outline& outline, size_t object, const Constants& constants) {
  return BodyReader(outline, object, constants).run();
}

double number_at_least(const Outline& outline, const Entry& entry, const Constants& constants, double least) {
  const double value = constants.number(entry.value);
  if (value < least) {
    refuse(outline.path, entry.value.place, Code::refused,
           fmt::format("a {} of {:g}", entry.property->canonical, value),
           fmt::format("it is at least {:g}", least));
  }
  return value;
}

}  // namespace animado::controle
