#include "controle/scene/vocabulary.hpp"

#include <algorithm>

#include "controle/scene/lines.hpp"

namespace animado::controle {
namespace {

constexpr Block kObject = Block::object, kWorld = Block::world, kTime = Block::time;

using interexpserv::Dimension;
constexpr Dimension measured(int m, int kg, int s) {
  const auto twelfths = [](int exponent) { return static_cast<int16_t>(12 * exponent); };
  return {true, twelfths(m), twelfths(kg), twelfths(s)};
}
constexpr Dimension kNone = interexpserv::kPlain;
constexpr Dimension kNumber = interexpserv::kOne;  // or an angle
constexpr Dimension kLength = measured(1, 0, 0);
constexpr Dimension kMass = measured(0, 1, 0);
constexpr Dimension kDuration = measured(0, 0, 1);
constexpr Dimension kRate = measured(0, 0, -1);
constexpr Dimension kVelocity = measured(1, 0, -1);
constexpr Dimension kAcceleration = measured(1, 0, -2);
constexpr Dimension kForce = measured(1, 1, -2);
constexpr Dimension kTorque = measured(2, 1, -2);
constexpr Dimension kInertia = measured(2, 1, 0);
constexpr Dimension kDensity = measured(-3, 1, 0);
constexpr Dimension kStiffness = measured(0, 1, -2);
constexpr Dimension kDamping = measured(0, 1, -1);

const std::vector<Property>& table() {
  static const std::vector<Property> properties = {
      {"shape", kObject, kNone, {"forma"}, "a shape, below", "by the object's name, below"},
      {"motion",
       kObject,
       kNone,
       {"movimento"},
       "`dynamic`, `static`, `path` or `script(\"file.csv\")`",
       "`dynamic`"},
      {"path position",
       kObject,
       kLength,
       {"posicao da trajetoria"},
       "vector, m, of `t` and names",
       "`position`"},
      {"path rotation",
       kObject,
       kNumber,
       {"rotacao da trajetoria"},
       "vector, rad, as `rotation`, of `t` and names",
       "`rotation`"},
      {"mass", kObject, kMass, {"massa"}, "kg, > 0", ""},
      {"density", kObject, kDensity, {"densidade"}, "kg/m³, > 0, in place of `mass`", ""},
      {"center of mass",
       kObject,
       kLength,
       {"centre of mass", "centro de massa"},
       "vector, m, body frame",
       "the shape's"},
      {"moments of inertia",
       kObject,
       kInertia,
       {"moment of inertia", "momentos de inercia", "momento de inercia"},
       "(Ixx, Iyy, Izz), kg m², about the centre of mass",
       "from shape and mass"},
      {"products of inertia",
       kObject,
       kInertia,
       {"product of inertia", "produtos de inercia", "produto de inercia"},
       "(Ixy, Ixz, Iyz), the tensor's elements: Ixy = −∫ xy dm",
       "0 beside given moments, else from shape and mass"},
      {"restitution",
       kObject,
       kNumber,
       {"coefficient of restitution", "elasticity", "coeficiente de elasticidade",
        "coeficiente de restituicao"},
       "0 … 1",
       "0.5"},
      {"friction",
       kObject,
       kNumber,
       {"coefficient of friction", "coeficiente de friccao", "coeficiente de atrito", "atrito"},
       "≥ 0",
       "0"},
      {"position",
       kObject,
       kLength,
       {"initial position", "posicao inicial", "posicao"},
       "vector, m, of the body frame's origin",
       "(0, 0, 0)"},
      {"rotation",
       kObject,
       kNumber,
       {"initial rotation", "inclinacao", "rotacao"},
       "vector, rad, angles about x, y, z",
       "(0, 0, 0)"},
      {"rotation order",
       kObject,
       kNone,
       {"ordem das rotacoes"},
       "`xyz`, `zyx` …: the fixed axes, first one first",
       "`xyz`"},
      {"velocity",
       kObject,
       kVelocity,
       {"initial velocity", "linear velocity", "velocidade linear inicial", "velocidade linear",
        "velocidade inicial", "velocidade"},
       "vector, m/s, of the body frame's origin, each component at most the speed of light",
       "(0, 0, 0)"},
      {"angular velocity",
       kObject,
       kRate,
       {"initial angular velocity", "velocidade angular inicial", "velocidade angular"},
       "vector, rad/s, world axes",
       "(0, 0, 0)"},
      {"force",
       kObject,
       kForce,
       {"forca"},
       "vector, N, world axes, through the centre of mass, of `t` and names",
       "none",
       true},
      {"torque",
       kObject,
       kTorque,
       {"momento de forca"},
       "vector, N m, world axes, of `t` and names",
       "none",
       true},
      {"local force",
       kObject,
       kForce,
       {"forca local"},
       "vector, N, body axes, of `t` and names",
       "none",
       true},
      {"local torque",
       kObject,
       kTorque,
       {"torque local"},
       "vector, N m, body axes, of `t` and names",
       "none",
       true},
      {"linear damping", kObject, kRate, {"amortecimento linear"}, "1/s, ≥ 0", "0"},
      {"angular damping", kObject, kRate, {"amortecimento angular"}, "1/s, ≥ 0", "0"},
      {"color",
       kObject,
       kNone,
       {"colour", "cor"},
       "a CSS name, or (r, g, b) in 0 … 1",
       "one of a palette, in turn"},
      {"group", kObject, kNone, {"grupo"}, "a name", "none"},
      {"collides with", kObject, kNone, {"colide com"}, "names of groups, with commas", "all"},

      {"gravity", kWorld, kAcceleration, {"gravidade"}, "vector, m/s²", "(0, 0, 0)"},
      {"method", kWorld, kNone, {"metodo"}, "a method of fred", "`rk4`"},
      {"substep",
       kWorld,
       kDuration,
       {"subpasso"},
       "s, > 0, the largest step inside a frame",
       "chosen by controle"},
      {"tolerance", kWorld, kNumber, {"tolerancia"}, "> 0, of the error of a step", "chosen by controle"},
      {"response", kWorld, kNone, {"resposta"}, "`impulse`, `system15` or `spring`", "`impulse`"},
      {"spring k", kWorld, kStiffness, {"k da mola"}, "N/m, > 0, for `response spring`", ""},
      {"spring damping",
       kWorld,
       kDamping,
       {"amortecimento da mola"},
       "N s/m, ≥ 0, for `response spring`",
       "0"},
      {"contact threshold", kWorld, kVelocity, {"limiar de contato"}, "m/s, ≥ 0", "0.01"},
      {"restitution rule",
       kWorld,
       kNone,
       {"regra de restituicao"},
       "`product`, `min`, `max` or `mean`",
       "`product`"},

      {"start", kTime, kDuration, {"initial time", "tempo inicial", "inicio"}, "s", "0"},
      {"end", kTime, kDuration, {"final time", "tempo final", "fim"}, "s, not before `start`", ""},
      {"step", kTime, kDuration, {"increment", "incremento", "passo"}, "s, > 0, between frames", ""},
  };
  return properties;
}

}  // namespace

std::string_view name_of(Block block) {
  return block == Block::object ? "object" : block == Block::world ? "world" : "time";
}

std::span<const Property> vocabulary() {
  return table();
}

std::vector<std::string> names_in(Block block) {
  std::vector<std::string> names;
  for (const Property& property : table()) {
    if (property.block != block) continue;
    names.emplace_back(property.canonical);
    names.insert(names.end(), property.synonyms.begin(), property.synonyms.end());
  }
  return names;
}

size_t match_phrase(std::string_view folded, std::string_view phrase) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  size_t at = 0;
  for (const char c : phrase) {
    if (c == ' ') {
      const size_t before = at;
      while (at < folded.size() && blank(folded[at])) ++at;
      if (at == before) return 0;
    } else if (at < folded.size() && folded[at] == c) {
      ++at;
    } else {
      return 0;
    }
  }
  return at < folded.size() && is_word_char(folded[at]) ? 0 : at;
}

std::optional<Match> longest_property(std::string_view folded) {
  std::optional<Match> best;
  const auto consider = [&](const Property& property, std::string_view name) {
    const size_t length = match_phrase(folded, name);
    if (length > (best ? best->length : 0)) best = Match{&property, length};
  };
  for (const Property& property : table()) {
    consider(property, property.canonical);
    for (const std::string_view synonym : property.synonyms) consider(property, synonym);
  }
  return best;
}

std::string_view canonical_word(std::span<const Word> words, std::string_view folded) {
  for (const Word& word : words) {
    if (word.canonical == folded) return word.canonical;
    if (std::find(word.synonyms.begin(), word.synonyms.end(), folded) != word.synonyms.end())
      return word.canonical;
  }
  return {};
}

std::vector<std::string> all_forms(std::span<const Word> words) {
  std::vector<std::string> forms;
  for (const Word& word : words) {
    forms.emplace_back(word.canonical);
    forms.insert(forms.end(), word.synonyms.begin(), word.synonyms.end());
  }
  return forms;
}

}  // namespace animado::controle
