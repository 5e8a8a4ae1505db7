#include "controle/scene/obj_file.hpp"

#include <charconv>

#include "base/error.hpp"
#include "controle/scene/text_file.hpp"

namespace animado::controle {
namespace {

// "7", "7/1", "7/1/2", "7//2"; from 1, negative from the end: the position of the vertex.
size_t vertex_of(std::string_view corner, size_t vertices, const std::string& where) {
  const std::string_view digits = corner.substr(0, corner.find('/'));
  long index = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  const long count = static_cast<long>(vertices);
  if (index < 0) index += count + 1;
  if (status != std::errc() || end != digits.data() + digits.size() || index < 1 || index > count) {
    throw Error(Code::syntax, fmt::format("a face names vertex `{}`, there are {}", corner, vertices), where,
                "vertices stand before the faces that use them and count from 1");
  }
  return static_cast<size_t>(index - 1);
}

}  // namespace

std::vector<Vec3> read_obj(const std::string& path) {
  const std::string text = read_text(path);
  std::vector<Vec3> vertices;
  std::vector<bool> used;
  bool faces = false;
  size_t number = 0;
  for (std::string_view rest = text; !rest.empty();) {
    const size_t end = std::min(rest.find('\n'), rest.size());
    const auto words = split(rest.substr(0, end), " \t\r");
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::string where = fmt::format("{}:{}", path, ++number);
    if (words.empty()) continue;
    if (words[0] == "v") {
      if (words.size() < 4)
        throw Error(Code::syntax, "a vertex has three coordinates", where, "write v x y z");
      vertices.emplace_back(to_number(words[1], where), to_number(words[2], where),
                            to_number(words[3], where));
      used.push_back(false);
    } else if (words[0] == "f") {
      faces = true;
      for (size_t k = 1; k < words.size(); ++k) used[vertex_of(words[k], vertices.size(), where)] = true;
    }
  }
  std::vector<Vec3> points;
  for (size_t i = 0; i < vertices.size(); ++i) {
    if (!faces || used[i]) points.push_back(vertices[i]);
  }
  return points;
}

}  // namespace animado::controle
