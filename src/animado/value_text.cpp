#include "animado/value_text.hpp"

#include "base/number_text.hpp"

namespace animado {

using interexpserv::Type;

std::string value_text(Type type, std::span<const double> values) {
  if (values.empty()) return "-";
  switch (type) {
    case Type::boolean:
      return values[0] != 0 ? "true" : "false";
    case Type::scalar:
      return number_text(values[0]);
    case Type::vector:
      break;
  }
  return fmt::format("({}, {}, {})", number_text(values[0]), number_text(values[1]), number_text(values[2]));
}

nlohmann::ordered_json value_json(Type type, std::span<const double> values) {
  if (values.empty()) return nullptr;
  switch (type) {
    case Type::boolean:
      return values[0] != 0;
    case Type::scalar:
      return values[0];
    case Type::vector:
      break;
  }
  return {values[0], values[1], values[2]};
}

nlohmann::ordered_json name_json(const interexpserv::NameState& name) {
  nlohmann::ordered_json page = {
      {"name", name.name}, {"type", name_of(name.type)}, {"value", value_json(name.type, name.values)}};
  if (!name.text.empty()) page["expression"] = name.text;
  page["version"] = name.version;
  return page;
}

}  // namespace animado
