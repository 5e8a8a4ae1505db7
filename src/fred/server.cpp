#include "fred/server.hpp"

#include "base/number_text.hpp"
#include "fred/methods.hpp"
#include "fred/protocol.hpp"
#include "fred/server.messages.hpp"

namespace animado::fred {
namespace {

Methods::Method described(const Method& method) {
  Methods::Method row;
  row.name = method.name;
  row.reference = method.reference;
  row.kind = method.kind;
  row.order = method.order;
  row.error_order = method.error_order;
  row.dense_order = method.dense_order;
  row.stages = method.stages;
  if (method.tableau == nullptr) {
    row.matrix.shape = row.errors.shape = {0, 0};
    return row;
  }
  const Tableau& tableau = *method.tableau;
  row.derivatives = static_cast<int64_t>(tableau.derivatives());
  row.nodes = tableau.nodes;
  row.weights = tableau.weights;
  row.extra_nodes = tableau.extra_nodes;
  row.matrix = Array::inlined({row.stages, row.stages}, tableau.matrix);
  row.errors.shape = {static_cast<int64_t>(tableau.errors.size()), row.stages + 1};
  for (const auto& error : tableau.errors)
    row.errors.values.insert(row.errors.values.end(), error.begin(), error.end());
  return row;
}

Methods::Reply list(const rpc::Nothing&) {
  Methods::Reply reply;
  for (const Method& method : methods()) reply.methods.push_back(described(method));
  return reply;
}

}  // namespace

void refuse_infinite(double value, const std::string& where) {
  if (std::isfinite(value)) return;
  throw Error(Code::not_finite, fmt::format("{} is {}", where, number_text(value)), where,
              "send finite numbers only");
}

Tolerance checked_tolerance(std::vector<double> absolute, std::vector<double> relative, size_t size) {
  const auto check = [&](const std::vector<double>& values, const char* where, bool may_be_zero) {
    if (values.size() != 1 && values.size() != size) {
      throw Error(Code::bad_params, fmt::format("{} tolerances for {} numbers", values.size(), size), where,
                  "give one, or one of each");
    }
    for (const double value : values) {
      refuse_infinite(value, where);
      if (value > 0 || (may_be_zero && value == 0)) continue;
      throw Error(
          Code::bad_params, fmt::format("a tolerance of {}", value), where,
          may_be_zero ? "give a number ≥ 0" : "give a number > 0, the error that does not matter near zero");
    }
  };
  check(absolute, "absolute_tolerance", false);
  check(relative, "relative_tolerance", true);
  return Tolerance(std::move(absolute), std::move(relative), size);
}

void fill_table(rpc::Service& service, rpc::Suite& suite) {
  service.on<Methods>(list);
  add_stage_messages(service);
  add_integrate_message(service, suite);
}

}  // namespace animado::fred
