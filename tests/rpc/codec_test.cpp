// src/rpc/schema.hpp, codec.cpp, unpack.cpp, summary.cpp, json.cpp: every kind of field there and back, and
// every refusal.
#include "rpc/codec.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <limits>
#include <msgpack.hpp>

#include "fixture.hpp"
#include "rpc/decoder.hpp"
#include "rpc/encoder.hpp"

namespace animado::rpc::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const Type& echo() {
  return type_of<Echo::Request>();
}

std::string packed(const Echo::Request& request) {
  std::string bytes;
  Encoder out(bytes);
  pack(echo(), &request, out);
  return bytes;
}

Echo::Request decoded(std::string_view bytes, Numbers numbers = Numbers::finite) {
  Echo::Request request;
  Decoder in(bytes, numbers);
  unpack(echo(), in, &request, "echo");
  EXPECT_TRUE(in.at_end());
  return request;
}

Echo::Request read_json(std::string_view json) {
  Echo::Request request;
  from_json(echo(), json, &request, "echo");
  return request;
}

Error refusal(std::string_view json) {
  return error_of([&] { read_json(json); });
}

TEST(Codec, EveryKindOfFieldComesBackAsItWent) {
  const Echo::Request sent = full_request();
  const Echo::Request got = decoded(packed(sent));
  EXPECT_EQ(got.flag, sent.flag);
  EXPECT_EQ(got.count, sent.count);
  EXPECT_EQ(got.ratio, sent.ratio);
  EXPECT_EQ(got.label, sent.label);
  EXPECT_EQ(got.color, sent.color);
  EXPECT_EQ(got.array.shape, sent.array.shape);
  EXPECT_EQ(got.array.values, sent.array.values);
  EXPECT_TRUE(std::signbit(got.array.values[1])) << "-0.0 keeps its sign";
  EXPECT_EQ(got.list, sent.list);
  EXPECT_EQ(got.lists, sent.lists);
  ASSERT_EQ(got.points.size(), 2u);
  EXPECT_EQ(got.points[1].y_m, 4);
  EXPECT_EQ(got.maybe, sent.maybe);
  EXPECT_FALSE(got.out.has_value());
}

TEST(Codec, IntegersOfEverySizeComeBack) {
  for (int64_t value :
       {0l, -1l, -32l, -33l, 127l, 128l, 255l, 65536l, -129l, -40000l, 1l << 40, INT64_MAX, INT64_MIN}) {
    Echo::Request request;
    request.count = value;
    EXPECT_EQ(decoded(packed(request)).count, value);
  }
}

TEST(Codec, NumbersKeepTheirBits) {
  for (double value : {-0.0, 2.0, 1e300, 5e-324, -1.0 / 3}) {
    Echo::Request request;
    request.ratio = value;
    EXPECT_EQ(std::bit_cast<uint64_t>(decoded(packed(request)).ratio), std::bit_cast<uint64_t>(value))
        << value;
  }
}

TEST(Codec, AnyMsgpackLibraryReadsIt) {
  const std::string bytes = packed(full_request());
  const msgpack::object_handle handle = msgpack::unpack(bytes.data(), bytes.size());
  const auto map = handle.get().as<std::map<std::string, msgpack::object>>();
  EXPECT_EQ(map.at("label").as<std::string>(), "olá");
  EXPECT_EQ(map.at("ratio").type, msgpack::type::FLOAT64) << "2.0 stays a number";
  const auto array = map.at("array").as<std::map<std::string, msgpack::object>>();
  EXPECT_EQ(array.at("data").via.bin.size, 4 * sizeof(double));
  EXPECT_EQ(map.count("out"), 0u) << "what has no value is left out";
}

TEST(Codec, MissingFieldsKeepTheirInitializersAndGivenOnesReplaceThem) {
  const Echo::Request request = read_json(R"({"count": 1})");
  EXPECT_EQ(request.ratio, 0.5);
  EXPECT_EQ(request.color, Color::green);
  EXPECT_THAT(request.list, ElementsAre(7));
  EXPECT_THAT(read_json(R"({"count": 1, "list": []})").list, ElementsAre());
}

TEST(Codec, AnIntegerIsGoodWhereANumberIsMeant) {
  EXPECT_EQ(read_json(R"({"count": 1, "ratio": 2})").ratio, 2.0);
}

TEST(Codec, ArraysMayBeWrittenByHand) {
  const Array nested = read_json(R"({"count": 1, "array": [[1, 2, 3], [4, 5, 6]]})").array;
  EXPECT_THAT(nested.shape, ElementsAre(2, 3));
  EXPECT_THAT(nested.values, ElementsAre(1, 2, 3, 4, 5, 6));
  const Array flat = read_json(R"({"count": 1, "array": {"shape": [2, 1], "data": [1.5, 2]}})").array;
  EXPECT_THAT(flat.shape, ElementsAre(2, 1));
  const Array shared =
      read_json(R"({"count": 1, "array": {"shape": [2], "shared": "a", "offset": 3}})").array;
  EXPECT_EQ(shared.shared, "a");
  EXPECT_EQ(shared.offset, 3);
  EXPECT_EQ(read_json(R"({"count": 1, "array": {"shape": [0, 3], "data": []}})").array.count(), 0);
}

TEST(Codec, RefusalsSayWhereAndWhatToDo) {
  const Error unknown = refusal(R"({"count": 1, "ratoi": 1})");
  EXPECT_EQ(unknown.code(), Code::bad_params);
  EXPECT_THAT(unknown.remedy(), HasSubstr("did you mean 'ratio'?"));
  const Error missing = refusal(R"({"ratio": 1})");
  EXPECT_EQ(missing.code(), Code::bad_params);
  EXPECT_EQ(missing.where(), "echo.count");
  const Error nested = refusal(R"({"count": 1, "points": [{"x_m": 1}, {"x_m": "far"}]})");
  EXPECT_EQ(nested.where(), "echo.points[1].x_m");
  EXPECT_THAT(nested.message(), HasSubstr("expected a number, found text"));
  EXPECT_THAT(refusal(R"({"count": 1, "color": "gren"})").remedy(), HasSubstr("red, green, blue"));
}

TEST(Codec, WrongTypesAreRefused) {
  for (const char* json :
       {R"({"count": 1.5})", R"({"count": "1"})", R"({"count": null})", R"({"count": 1, "flag": 1})",
        R"({"count": 1, "label": 3})", R"({"count": 1, "list": 3})", R"({"count": 1, "list": [1.5]})",
        R"({"count": 1, "lists": [1]})", R"({"count": 1, "points": {}})", R"({"count": 1, "array": 3})",
        R"({"count": 1, "array": {"shape": [1], "data": "x"}})", R"({"count": 1, "array": {"shape": [1]}})",
        R"({"count": 1, "array": {"shared": "x"}})", R"({"count": 18446744073709551615})", R"([1])", R"(3)",
        R"({"count": 1, "array": {"shape": [1], "dta": [1]}})"}) {
    EXPECT_EQ(refusal(json).code(), Code::bad_params) << json;
    EXPECT_FALSE(refusal(json).remedy().empty()) << json;
  }
}

TEST(Codec, ImpossibleShapesAreRefused) {
  for (const char* array :
       {R"({"shape": [-1], "data": []})", R"({"shape": [3], "data": [1, 2]})",
        R"({"shape": [4294967296, 4294967296], "data": []})",
        R"({"shape": [0, 4611686018427387904], "data": []})",
        R"({"shape": [1,1,1,1,1,1,1,1,1], "data": [1]})", R"([[1, 2], [3]])", R"([[1, 2], 3])", R"([1, [2]])",
        R"({"shape": [1], "shared": "a", "offset": -1})"}) {
    EXPECT_EQ(refusal(fmt::format(R"({{"count": 1, "array": {}}})", array)).code(), Code::bad_shape) << array;
  }
}

TEST(Codec, NotANumberIsRefusedInRequestsAndNamed) {
  Echo::Request request = full_request();
  request.array.values[2] = std::copysign(kNaN, -1.0);  // as x86 divides 0 by 0
  const Error in_array = error_of([&] { decoded(packed(request)); });
  EXPECT_EQ(in_array.code(), Code::not_finite);
  EXPECT_EQ(in_array.where(), "echo.array.data[2]");
  EXPECT_EQ(in_array.message(), "nan is not a finite number");
  EXPECT_TRUE(std::isnan(decoded(packed(request), Numbers::any).array.values[2])) << "a reply may say so";
  request = full_request();
  request.maybe = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error_of([&] { decoded(packed(request)); }).where(), "echo.maybe");
}

TEST(Codec, AMessageCutAnywhereIsRefused) {
  const std::string bytes = packed(full_request());
  for (size_t length = 0; length < bytes.size(); ++length) {
    Echo::Request request;
    Decoder in(std::string_view(bytes).substr(0, length));
    EXPECT_EQ(error_of([&] { unpack(echo(), in, &request, "echo"); }).code(), Code::protocol) << length;
  }
}

TEST(Codec, AFieldGivenTwiceIsRefused) {
  EXPECT_EQ(error_of([&] { decoded("\x82\xa5"s + "count\x01\xa5" + "count\x02"); }).code(), Code::bad_params);
}

TEST(Codec, MarksTravelBesideTheFields) {
  std::string bytes;
  Encoder out(bytes);
  const Echo::Request sent = full_request();
  pack_params(echo(), &sent, {"7f3a", 12}, out);
  Decoder in(bytes, Numbers::finite);
  Echo::Request got;
  unpack(echo(), in, &got, "echo");
  EXPECT_EQ(in.marks.trace, "7f3a");
  EXPECT_EQ(in.marks.seq, 12);
  EXPECT_EQ(refusal(R"({"count": 1, "_other": 1})").code(), Code::bad_params);
}

TEST(Codec, ALogLineIsShortAndStaysOneLine) {
  Echo::Request request = full_request();
  request.label = "a\nb\x1b[2J";
  request.list = {1, 2, 3, 4, 5};
  std::string text;
  summarize(echo(), &request, text);
  EXPECT_EQ(
      text,
      R"(flag=true count=-3 ratio=2 label="a?b?[2J" color=blue array=(2,2) list=[5] lists=[[1] [] [2 3]] points=[2] maybe=0.25)");
  text.clear();
  request.label = std::string(1000, 'x');
  summarize(echo(), &request, text);
  EXPECT_LT(text.size(), 250u);
}

TEST(Codec, JsonThatIsNotJsonIsASyntaxError) {
  EXPECT_EQ(refusal("{count: 1}").code(), Code::syntax);
}

TEST(Codec, JsonShowsArraysInFull) {
  Echo::Request request;
  request.array = Array::inlined({2}, {0.1, kNaN});
  EXPECT_THAT(to_json(echo(), &request), HasSubstr(R"("array":{"shape":[2],"data":[0.1,null]})"));
}

}  // namespace
}  // namespace animado::rpc::testing
