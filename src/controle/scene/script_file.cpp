#include "controle/scene/script_file.hpp"

#include "base/error.hpp"
#include "base/fold.hpp"
#include "controle/scene/text_file.hpp"

namespace animado::controle {
namespace {

constexpr double kNormSlack = 1e-2;  // a quaternion printed with three digits is as far from unit length
constexpr std::string_view kRow = "a row is t,x,y,z,qw,qx,qy,qz, the quaternion of length 1";

ScriptRow row_of(const std::vector<std::string_view>& cells, const std::string& where) {
  if (cells.size() != 8)
    throw Error(Code::syntax, fmt::format("{} values in a row of eight", cells.size()), where,
                std::string(kRow));
  std::array<double, 8> v{};
  for (size_t k = 0; k < 8; ++k) v[k] = to_number(cells[k], where);
  const Quat q(v[4], v[5], v[6], v[7]);
  if (std::abs(q.norm() - 1) > kNormSlack) {
    throw Error(Code::refused, fmt::format("a quaternion of length {:g}", q.norm()), where,
                std::string(kRow));
  }
  return {v[0], {{v[1], v[2], v[3]}, q.normalized()}};
}

}  // namespace

std::vector<ScriptRow> read_script(const std::string& path) {
  const std::string text = read_text(path);
  std::vector<ScriptRow> rows;
  size_t number = 0;
  for (std::string_view rest = text; !rest.empty();) {
    const size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, std::min(rest.substr(0, end).find('#'), end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::string where = fmt::format("{}:{}", path, ++number);
    const auto cells = split(line, ", \t\r");
    const bool heading = !cells.empty() && rows.empty() && fold(cells[0]) == "t";
    if (cells.empty() || heading) continue;
    ScriptRow row = row_of(cells, where);
    if (!rows.empty()) {
      if (row.time_s <= rows.back().time_s) {
        throw Error(Code::refused,
                    fmt::format("time {:g} s does not come after {:g} s", row.time_s, rows.back().time_s),
                    where, "put the rows in the order of their times");
      }
      Quat& q = row.pose.orientation;
      if (q.dot(rows.back().pose.orientation) < 0) q.coeffs() = -q.coeffs();
    }
    rows.push_back(row);
  }
  if (rows.empty()) throw Error(Code::syntax, "the file has no rows", path, std::string(kRow));
  return rows;
}

}  // namespace animado::controle
