#include "controle/scene/constants.hpp"

#include "base/number_text.hpp"
#include "controle/mass/mass_properties.hpp"
#include "controle/scene/refusal.hpp"
#include "controle/scene/scope.hpp"
#include "controle/scene/shape_syntax.hpp"
#include "controle/scene/text_file.hpp"
#include "interexpserv/parser.hpp"

namespace animado::controle {
namespace {

using interexpserv::Input;
using interexpserv::Symbol;
using interexpserv::Type;
using interexpserv::Value;

constexpr size_t kMaxOpen =
    100;  // names that need names: far above what is read with pleasure, and each is a level of the stack

}  // namespace

class Constants::Open {
 public:
  Open(const Constants& constants, std::string name) : constants_(constants) {
    std::vector<std::string>& open = constants.open_;
    const auto first = std::find(open.begin(), open.end(), name);
    if (first != open.end()) {
      std::string path;
      for (auto it = first; it != open.end(); ++it) path += *it + " → ";
      fail(Code::cycle, "names that need each other: " + path + name,
           "define one of them by a value that does not need the others");
    }
    if (open.size() == kMaxOpen)
      fail(Code::limit, fmt::format("more than {} names that need each other", kMaxOpen),
           "write some as numbers");
    open.push_back(std::move(name));
  }
  ~Open() { constants_.open_.pop_back(); }
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;

 private:
  [[noreturn]] void fail(Code code, std::string message, std::string remedy) const {
    const Place place = constants_.reading_.empty() ? Place{} : constants_.reading_.back().place;
    refuse(constants_.outline_.path, place, code, std::move(message), std::move(remedy));
  }
  const Constants& constants_;
};

Constants::Constants(const Outline& outline) : outline_(outline), names_(outline.object_names()) {}

double Constants::number(const Expression& expression) const {
  return evaluate(expression, Type::scalar).v[0];
}

Vec3 Constants::vector(const Expression& expression) const {
  const Value value = evaluate(expression, Type::vector);
  return {value.v[0], value.v[1], value.v[2]};
}

Value Constants::evaluate(const Expression& expression, Type type) const {
  const interexpserv::Program program = compile(expression, type);
  if (!program.is_constant()) {
    refuse(
        outline_.path, expression.place, Code::refused,
        fmt::format("`{}` has to be constant, it changes with `{}`", expression.text,
                    program.inputs().front().name),
        "use numbers, masses and names made of them; force, torque and path alone may depend on t and state");
  }
  const Value value = program.constant();
  for (size_t i = 0; i < interexpserv::width_of(type); ++i) {
    if (!std::isfinite(value.v[i])) {
      refuse(outline_.path, expression.place, Code::not_finite,
             fmt::format("`{}` is {}", expression.text, number_text(value.v[i])),
             "a finite number is needed: look for a division by zero, a root or a logarithm of a negative "
             "number");
    }
  }
  return value;
}

interexpserv::Program Constants::compile(const Expression& expression, std::optional<Type> expected) const {
  reading_.push_back(expression);
  const std::string_view home = expression.owner < 0
                                    ? std::string_view()
                                    : outline_.objects[static_cast<size_t>(expression.owner)].folded_name;
  interexpserv::Program program = compile_at(outline_.path, expression, *this, home, expected);
  reading_.pop_back();
  return program;
}

void Constants::check_definitions() const {
  for (const Definition& definition : outline_.names) find(definition.name);
}

const Shape& Constants::shape(size_t body) const {
  if (const auto known = shapes_.find(body); known != shapes_.end()) return known->second;
  return shapes_[body] = read_shape(outline_, body, *this);
}

double Constants::mass_kg(size_t body) const {
  if (const auto known = masses_.find(body); known != masses_.end()) return known->second;
  const Open open(*this, outline_.objects[body].folded_name + ".mass");
  return masses_[body] = compute_mass(body);
}

double Constants::compute_mass(size_t body) const {
  const Section& object = outline_.objects[body];
  const Entry* mass = object.find("mass");
  const Entry* density = object.find("density");
  if (!mass && !density) {
    const Place place = reading_.empty() ? object.place : reading_.back().place;
    refuse(outline_.path, place, Code::refused, fmt::format("`{}` has no mass", object.name),
           fmt::format("give `mass` or `density` in the block of `{}`", object.name));
  }
  if (mass && density) {
    refuse(outline_.path, density->place, Code::conflict,
           fmt::format("`{}` has a density and, in line {}, a mass", object.name, mass->place.line),
           "take one of them away");
  }
  const Entry& given = mass ? *mass : *density;
  const double value = number(given.value);
  if (value <= 0) {
    refuse(outline_.path, given.value.place, Code::refused,
           fmt::format("a {} of {:g}", given.property->canonical, value),
           fmt::format("a {} is greater than 0", given.property->canonical));
  }
  if (mass) return value;
  if (std::holds_alternative<HalfSpace>(shape(body))) {
    refuse(outline_.path, density->place, Code::refused, "a plane has no volume to give a density to",
           "leave the density out");
  }
  return value * volume_m3(shape(body));
}

std::optional<Symbol> Constants::find(std::string_view folded_name) const {
  if (const auto reading = names_.find(folded_name)) {
    if (reading->member == Member::mass) return Value::scalar(mass_kg(static_cast<size_t>(reading->body)));
    return Input{std::string(folded_name), type_of(reading->member)};
  }
  if (const auto known = definitions_.find(folded_name); known != definitions_.end()) return known->second;
  for (const Definition& definition : outline_.names) {
    if (definition.name == folded_name)
      return definitions_.emplace(definition.name, compute_definition(definition)).first->second;
  }
  return std::nullopt;
}

Symbol Constants::compute_definition(const Definition& definition) const {
  const Open open(*this, definition.name);
  const interexpserv::Program program = compile(definition.value, {});
  const std::string& text = definition.value.text;
  if (program.is_constant() || interexpserv::is_function_text(text)) {
    const int owner = definition.value.owner;
    return interexpserv::Definition{
        definition.name, text, owner < 0 ? "" : outline_.objects[static_cast<size_t>(owner)].folded_name};
  }
  return Input{definition.name, program.type()};  // it varies, and that is all that a constant needs to know
}

std::string Constants::path_of(std::string_view written) const {
  return beside(outline_.path, written);
}

std::vector<std::string> Constants::known_names() const {
  std::vector<std::string> names = names_.known_names();
  for (const Definition& definition : outline_.names) names.push_back(definition.name);
  return names;
}

}  // namespace animado::controle
