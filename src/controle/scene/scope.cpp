#include "controle/scene/scope.hpp"

#include "controle/scene/lines.hpp"
#include "controle/scene/refusal.hpp"
#include "controle/scene/text_file.hpp"
#include "interexpserv/parser.hpp"

namespace animado::controle {
namespace {

using interexpserv::Input;
using interexpserv::Symbol;
using interexpserv::Type;
using interexpserv::Value;

std::vector<std::string> names_of(const std::vector<Body>& bodies) {
  std::vector<std::string> names;
  for (const Body& body : bodies) names.push_back(body.folded_name);
  return names;
}

// v turned by the body's quaternion (w, q): v + 2 q × (q × v + w v).
constexpr std::string_view kTurned =
    "local_force + 2 * cross((orientation.qx, orientation.qy, orientation.qz), "
    "cross((orientation.qx, orientation.qy, orientation.qz), local_force) + orientation.qw * local_force)";

[[noreturn]] void refuse_at(std::string_view path, const Expression& expression, size_t column,
                            const Error& error) {
  const Place place = {expression.place.line, expression.place.column + static_cast<int>(column)};
  refuse(path, place, error.code(), error.message(), error.remedy());
}

}  // namespace

std::string vector_sum(const std::vector<Expression>& expressions) {
  if (expressions.size() == 1) return expressions.front().text;
  std::string text;
  for (const Expression& expression : expressions)
    text += (text.empty() ? "(" : " + (") + expression.text + ")";
  return text.empty() ? "(0, 0, 0)" : text;
}

SceneScope::SceneScope(const Scene& scene) : scene_(scene), names_(names_of(scene.bodies)) {}

std::optional<Symbol> SceneScope::find(std::string_view folded_name) const {
  if (const auto reading = names_.find(folded_name)) {
    if (reading->body < 0) return Input{"t", Type::scalar};
    const Body& body = scene_.bodies[static_cast<size_t>(reading->body)];
    switch (reading->member) {
      case Member::mass:
        return Value::scalar(body.mass_kg);
      case Member::force:
        return force_of(body);
      case Member::local_force:
        return local_force_of(body);
      default:
        return Input{std::string(folded_name), type_of(reading->member)};
    }
  }
  for (const Definition& name : scene_.names) {
    if (name.name != folded_name) continue;
    const int owner = name.value.owner;
    return interexpserv::Definition{name.name, name.value.text,
                                    owner < 0 ? "" : scene_.bodies[static_cast<size_t>(owner)].folded_name};
  }
  return std::nullopt;
}

interexpserv::Definition SceneScope::force_of(const Body& body) const {
  std::string text = vector_sum(body.forces);
  if (!body.local_forces.empty()) text = fmt::format("({}) + {}", text, kTurned);
  return {body.folded_name + ".force", std::move(text), body.folded_name};
}

interexpserv::Definition SceneScope::local_force_of(const Body& body) const {
  return {body.folded_name + ".local_force", vector_sum(body.local_forces), body.folded_name};
}

std::string SceneScope::path_of(std::string_view written) const {
  return beside(scene_.path, written);
}

std::vector<std::string> SceneScope::known_names() const {
  std::vector<std::string> names = names_.known_names();
  for (const Definition& name : scene_.names) names.push_back(name.name);
  return names;
}

interexpserv::Program SceneScope::compile(const Expression& expression, std::optional<Type> expected) const {
  const int owner = expression.owner;
  const std::string_view home =
      owner < 0 ? std::string_view() : scene_.bodies[static_cast<size_t>(owner)].folded_name;
  return compile_at(scene_.path, expression, *this, home, expected);
}

std::string SceneScope::qualified(const Expression& expression) const {
  if (expression.owner < 0) return expression.text;
  const std::string prefix = scene_.bodies[static_cast<size_t>(expression.owner)].folded_name + ".";
  std::vector<size_t> columns;  // of the names that lack it
  const interexpserv::Expression parsed = interexpserv::parse({expression.text, {}});
  const auto& parameters = parsed.parameters;
  for (const interexpserv::Node& node : parsed) {
    if (node.kind != interexpserv::Node::Kind::name) continue;
    const std::string name(node.name);
    const bool component = name.ends_with(".x") || name.ends_with(".y") || name.ends_with(".z");
    const std::string whole = component ? name.substr(0, name.size() - 2) : name;
    if (std::find(parameters.begin(), parameters.end(), whole) != parameters.end()) continue;
    if (names_.find(prefix + name) || names_.find(prefix + whole)) columns.push_back(node.column);
  }
  std::sort(columns.begin(), columns.end());
  const Line line(expression.place.line, expression.text);
  std::string text;
  size_t from = 0;
  for (const size_t column : columns) {
    text += line.written(from, column) + prefix;
    from = column;
  }
  return text + line.written(from, line.folded().size());
}

interexpserv::Program compile_at(std::string_view path, const Expression& expression,
                                 const interexpserv::Scope& scope, std::string_view home,
                                 std::optional<Type> expected) {
  try {
    if (home.empty()) return interexpserv::compile(expression.text, scope, {}, expected);
    return interexpserv::compile(expression.text, interexpserv::HomeScope(scope, home), {}, expected);
  } catch (const interexpserv::ExpressionError& error) {
    refuse_at(path, expression, error.column(), error);
  } catch (const Error& error) {
    if (!error.where().empty()) throw;  // of another expression, which this one needs
    refuse_at(path, expression, 0, error);
  }
}

}  // namespace animado::controle
