// What a service does with messages that no client of ours would send: it answers each with an error that
// names a remedy, or closes the connection; it never dies, and keeps nothing.
#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "raw_client.hpp"
#include "services.hpp"

namespace animado::suite {
namespace {

constexpr std::array<const char*, 4> kServices = {"interexpserv", "egesp", "fred", "colisao"};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A sanitizer keeps what is freed for a while, and tells of leaks by itself.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int64_t kMayGrow_kB = 1 << 20;
#else
constexpr int64_t kMayGrow_kB = 1 << 10;
#endif

int64_t resident_kB(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmRSS:", 0) == 0) return std::stoll(line.substr(6));
  }
  return -1;
}

void expect_error(const std::optional<Answer>& answer, const std::string& code, const std::string& what) {
  ASSERT_TRUE(answer) << what << ": the connection was closed";
  ASSERT_TRUE(answer->error.is_object()) << what << ": no error, but " << answer->result.dump();
  EXPECT_EQ(answer->error.at("code"), code) << what << ": " << answer->error.dump();
  EXPECT_FALSE(answer->error.at("message").get<std::string>().empty()) << what;
  EXPECT_FALSE(answer->error.at("remedy").get<std::string>().empty()) << what << ": " << answer->error.dump();
}

// A value of the wrong type for any field.
const Json kWrong = Json::array({Json::object({{"no", "such"}})});

}  // namespace

class HostileMessages : public testing::TestWithParam<const char*> {
 protected:
  static Services& services() {
    static Services all;
    return all;
  }
  std::string service() const { return GetParam(); }
  void TearDown() override { EXPECT_TRUE(services().is_running(service())) << service() << " died"; }

  // The messages of the service, from its own description.
  Json messages(RawClient& raw) { return raw.call("describe", Json::object())->result.at("messages"); }
};

TEST_P(HostileMessages, UnknownMethodAndUnknownFieldAreNamed) {
  RawClient raw(services().socket(service()));
  raw.hello();
  expect_error(raw.call("pimg", Json::object()), "unknown_method", "pimg");
  for (const Json& message : messages(raw)) {
    const std::string name = message.at("name");
    expect_error(raw.call(name, {{"no_such_field", 1}}), "bad_params", name + " with an unknown field");
  }
}

TEST_P(HostileMessages, WrongTypesAreNamedFieldByField) {
  RawClient raw(services().socket(service()));
  raw.hello();
  for (const Json& message : messages(raw)) {
    const std::string name = message.at("name");
    expect_error(raw.call(name, "not a map"), "bad_params", name + " with a string for its params");
    for (const Json& field : message.at("fields")) {
      const std::string path = field.at("path");
      if (field.at("side") != "request" || path.find('.') != std::string::npos) continue;
      expect_error(raw.call(name, {{path, kWrong}}), "bad_params", name + " with a wrong " + path);
    }
  }
}

TEST_P(HostileMessages, HelloComesFirstAndInTheRightVersion) {
  {
    RawClient raw(services().socket(service()));
    expect_error(raw.call("ping", Json::object()), "protocol", "ping before hello");
  }
  {
    RawClient raw(services().socket(service()));
    expect_error(raw.call("hello", {{"protocol", "animado"}, {"version", 99}}), "protocol",
                 "hello of version 99");
  }
}

TEST_P(HostileMessages, TruncatedFramesAndForeignBytesOnlyCostTheirConnection) {
  const Bytes whole = packed(1, "ping", Json::object());
  for (size_t length = 1; length < whole.size(); ++length) {
    RawClient raw(services().socket(service()));
    raw.hello();
    raw.send(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)));
  }
  for (const std::string& bytes :
       {std::string("GET / HTTP/1.1\r\n\r\n"), std::string("\xc1\xc1\xc1"), std::string(100, '\x91')}) {
    RawClient raw(services().socket(service()));
    raw.send(Bytes(bytes.begin(), bytes.end()));
    EXPECT_TRUE(raw.closed());
  }
  RawClient raw(services().socket(service()));
  raw.hello();
}

TEST_P(HostileMessages, LengthOfOneGibibyteIsRefusedUnseen) {
  const int64_t before_kB = resident_kB(services().pid(service()));
  // [0, 1, "ping", [{"x": …
  const Bytes head = {0x94, 0x00, 0x01, 0xa4, 'p', 'i', 'n', 'g', 0x91, 0x81, 0xa1, 'x'};
  for (const uint8_t kind :
       Bytes{0xc6 /* bin */, 0xdb /* str */, 0xdd /* array */, 0xdf /* map */, 0xc9 /* ext */}) {
    RawClient raw(services().socket(service()));
    raw.hello();
    Bytes message = head;
    for (const uint8_t byte : Bytes{kind, 0x40, 0x00, 0x00, 0x00}) message.push_back(byte);
    raw.send(message);
    EXPECT_TRUE(raw.closed()) << "kind " << static_cast<int>(kind);
  }
  EXPECT_LT(resident_kB(services().pid(service())) - before_kB, 8 * 1024);
}

TEST_P(HostileMessages, HundredThousandOfThemLeaveNoMemoryBehind) {
  RawClient raw(services().socket(service()));
  raw.hello();
  std::vector<std::pair<std::string, Json>> bad = {{"no_such_message", Json::object()}};
  for (const Json& message : messages(raw)) {
    bad.emplace_back(message.at("name"), Json::object({{"no_such_field", 1}}));
    for (const Json& field : message.at("fields")) {
      if (field.at("side") == "request")
        bad.emplace_back(message.at("name"), Json::object({{field.at("path"), kWrong}}));
    }
  }
  std::vector<Bytes> messages_packed;
  for (const auto& [name, params] : bad) messages_packed.push_back(packed(1, name, params));
  int64_t warm_kB = 0;
  constexpr int kMessages = 100000, kWarm = 10000;
  for (int i = 0; i < kMessages; ++i) {
    const auto answer = raw.call_packed(messages_packed[static_cast<size_t>(i) % messages_packed.size()]);
    ASSERT_TRUE(answer && !answer->error.is_null()) << i;
    if (i == kWarm) warm_kB = resident_kB(services().pid(service()));
  }
  EXPECT_LT(resident_kB(services().pid(service())) - warm_kB, kMayGrow_kB);
}

INSTANTIATE_TEST_SUITE_P(, HostileMessages, testing::ValuesIn(kServices),
                         [](const auto& service) { return std::string(service.param); });

// --- what is wrong with the numbers

class HostileNumbers : public testing::Test {
 protected:
  static Services& services() {
    static Services all;
    return all;
  }
  std::optional<Answer> call(const std::string& service, const std::string& method, const Json& params) {
    RawClient raw(services().socket(service));
    raw.hello();
    return raw.call(method, params);
  }
};

TEST_F(HostileNumbers, EgespRefusesThem) {
  const Json b = {1, 2};
  const Json identity = {{1, 0}, {0, 1}};
  expect_error(call("egesp", "solve", {{"matrices", {{1, kNan}, {0, 1}}}, {"right_sides", b}}), "not_finite",
               "NaN");
  expect_error(call("egesp", "solve", {{"matrices", identity}, {"right_sides", {1, kInfinity}}}),
               "not_finite", "infinity");
  expect_error(call("egesp", "solve", {{"matrices", {{1, 0, 0}, {0, 1, 0}}}, {"right_sides", b}}),
               "bad_shape", "2×3");
  expect_error(call("egesp", "solve", {{"matrices", identity}, {"right_sides", {1, 2, 3}}}), "bad_shape",
               "3 for 2");
  expect_error(call("egesp", "solve", {{"matrices", {{1, 2}, {2, 4}}}, {"right_sides", b}}), "singular",
               "singular");
  expect_error(call("egesp", "solve",
                    {{"matrices", {{"shape", {2, 2}}, {"shared", "nobody/made/this"}}}, {"right_sides", b}}),
               "unknown_array", "an array that is not there");
  expect_error(call("egesp", "solve",
                    {{"matrices", {{"shape", {-1, 2}}, {"data", Json::array()}}}, {"right_sides", b}}),
               "bad_shape", "negative extent");
  const auto good = call("egesp", "solve", {{"matrices", {{2, 0}, {0, 4}}}, {"right_sides", b}});
  ASSERT_TRUE(good && good->error.is_null()) << good->error.dump();
}

TEST_F(HostileNumbers, FredRefusesThem) {
  const Json from = Json::array({{{"name", "x"}, {"value", 1}}});
  expect_error(
      call("fred", "integrate", {{"equations", {"x' = -x"}}, {"from", from}, {"t1", 1}, {"method", "rk5"}}),
      "unknown_name", "method");
  expect_error(call("fred", "integrate", {{"equations", {"x' = -x +"}}, {"from", from}, {"t1", 1}}), "syntax",
               "expression");
  expect_error(call("fred", "integrate", {{"equations", {"x' = -y"}}, {"from", from}, {"t1", 1}}),
               "unknown_name", "name");
  expect_error(
      call(
          "fred", "integrate",
          {{"equations", {"x' = -x"}}, {"from", Json::array({{{"name", "x"}, {"value", kNan}}})}, {"t1", 1}}),
      "not_finite", "NaN");
  expect_error(
      call("fred", "stage", {{"stage", 9}, {"step", 0.1}, {"state", {1, 2}}, {"derivatives", {{1, 2}}}}),
      "bad_params", "stage 9");
  expect_error(
      call("fred", "stage", {{"stage", 1}, {"step", 0.1}, {"state", {1, 2}}, {"derivatives", {{1, 2, 3}}}}),
      "bad_shape", "shape");
}

TEST_F(HostileNumbers, ColisaoRefusesThem) {
  const Json ball = {{"name", "ball"},
                     {"shape", "sphere"},
                     {"size_m", {1}},
                     {"mass_kg", 1},
                     {"inertia_kg_m2", {1, 0, 0, 0, 1, 0, 0, 0, 1}}};
  Json massless = ball, hollow = ball;
  massless["mass_kg"] = 0;
  hollow["size_m"] = {-1};
  expect_error(call("colisao", "prepare", {{"bodies", Json::array({massless})}}), "refused", "no mass");
  expect_error(call("colisao", "prepare", {{"bodies", Json::array({hollow})}}), "refused", "negative radius");
  const Json state = {{"shape", {13, 1}}, {"data", std::vector<double>(13, 0.5)}};
  expect_error(call("colisao", "contacts", {{"handle", "nobody"}, {"state", state}}), "unknown_handle",
               "handle");
  const auto prepared = call("colisao", "prepare", {{"bodies", Json::array({ball})}});
  ASSERT_TRUE(prepared && prepared->error.is_null()) << prepared->error.dump();
  const Json handle = prepared->result.at("handle");
  const Json small = {{"shape", {12, 1}}, {"data", std::vector<double>(12, 0.5)}};
  expect_error(call("colisao", "contacts", {{"handle", handle}, {"state", small}}), "bad_shape", "12 rows");
  std::vector<double> numbers(13, 0.5);
  numbers[3] = kNan;
  expect_error(
      call("colisao", "contacts", {{"handle", handle}, {"state", {{"shape", {13, 1}}, {"data", numbers}}}}),
      "not_finite", "NaN");
}

}  // namespace animado::suite
