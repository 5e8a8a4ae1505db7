// src/live/watch.cpp and web_server.cpp: a page as a browser would be, on a real socket.
#include "live/watch.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <fstream>

#include "base/error.hpp"
#include "rpc/line_reader.hpp"
#include "tests/temporary_directory.hpp"

namespace animado::live {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using Tcp = boost::asio::ip::tcp;
using Json = nlohmann::json;

constexpr auto kScene =
    "object ball\nshape sphere(radius=0.1)\nmass 2\nforce (0, -9.81*mass, 0)\ntime\nstart 0\nend 1\nstep "
    "0.1\n";

struct Address {
  std::string port, token;
};

Address parsed(const std::string& address) {
  const std::string before = "http://127.0.0.1:", between = "/?token=";
  const size_t query = address.find(between);
  EXPECT_TRUE(address.starts_with(before));
  return {address.substr(before.size(), query - before.size()), address.substr(query + between.size())};
}

class Page {
 public:
  explicit Page(const Address& address, const std::string& origin = {}) {
    Tcp::resolver resolver(context_);
    boost::asio::connect(beast::get_lowest_layer(socket_), resolver.resolve("127.0.0.1", address.port));
    const std::string host = "127.0.0.1:" + address.port;
    socket_.set_option(beast::websocket::stream_base::decorator([&](beast::websocket::request_type& request) {
      request.set(http::field::origin, origin.empty() ? "http://" + host : origin);
    }));
    socket_.handshake(host, "/live?token=" + address.token);
  }

  void send(const Json& message) { socket_.write(boost::asio::buffer(message.dump())); }

  // The next message of a type; others on the way are passed over.
  Json next(const std::string& type) {
    for (;;) {
      beast::flat_buffer buffer;
      socket_.read(buffer);
      Json message = Json::parse(beast::buffers_to_string(buffer.data()));
      if (message.at("type") == type) return message;
    }
  }

 private:
  boost::asio::io_context context_;
  beast::websocket::stream<Tcp::socket> socket_{context_};
};

http::status get(const Address& address, const std::string& target, const std::string& host,
                 std::string* body = nullptr) {
  boost::asio::io_context context;
  Tcp::socket socket(context);
  boost::asio::connect(socket, Tcp::resolver(context).resolve("127.0.0.1", address.port));
  http::request<http::empty_body> request(http::verb::get, target, 11);
  request.set(http::field::host, host);
  http::write(socket, request);
  beast::flat_buffer buffer;
  http::response<http::string_body> response;
  http::read(socket, buffer, response);
  if (body) *body = response.body();
  return response.result();
}

class WatchTest : public testing::Test {
 protected:
  WatchTest() {
    watch_ =
        std::make_unique<Watch>(Watched{controle::parse_scene(kScene), directory_.path(), "<p>the page</p>",
                                        0, [this](const std::string& name, const std::string& text) {
                                          if (text == "lost") throw Error(Code::unavailable, "no registry");
                                          edits_.push_back(name + " = " + text);
                                        }});
    address_ = parsed(watch_->address());
  }

  // The next line that the run would read.
  std::string command() {
    while (commands_.empty()) {
      pollfd ready{watch_->pace_fd(), POLLIN, 0};
      poll(&ready, 1, 10'000);
      reader().read_lines([&](const std::string& line) { commands_.push_back(line); });
    }
    const std::string first = commands_.front();
    commands_.erase(commands_.begin());
    return first;
  }
  rpc::LineReader& reader() {
    if (!reader_) reader_.emplace(watch_->pace_fd());
    return *reader_;
  }

  TemporaryDirectory directory_;
  std::vector<std::string> edits_, commands_;
  std::unique_ptr<Watch> watch_;
  std::optional<rpc::LineReader> reader_;
  Address address_;
};

TEST_F(WatchTest, ServesThePageToWhoKnowsTheToken) {
  const std::string host = "127.0.0.1:" + address_.port;
  std::string body;
  EXPECT_EQ(get(address_, "/?token=" + address_.token, host, &body), http::status::ok);
  EXPECT_EQ(body, "<p>the page</p>");
  EXPECT_EQ(get(address_, "/other?token=" + address_.token, host), http::status::not_found);
  EXPECT_EQ(get(address_, "/", host), http::status::forbidden);
  EXPECT_EQ(get(address_, "/?token=" + std::string(32, '0'), host), http::status::forbidden);
}

TEST_F(WatchTest, AnotherHostsNameOrPageIsTurnedAway) {
  EXPECT_EQ(get(address_, "/?token=" + address_.token, "evil.example:" + address_.port),
            http::status::forbidden);
  EXPECT_THROW(Page(address_, "http://evil.example"), boost::system::system_error);
  EXPECT_THROW(Page({address_.port, std::string(32, '0')}), boost::system::system_error);
}

TEST_F(WatchTest, TheRunWaitsUntilAPageIsThere) {
  EXPECT_EQ(command(), "speed 1");
  EXPECT_EQ(command(), "pause");
  Page page(address_);
  const Json hello = page.next("hello");
  EXPECT_EQ(hello["bodies"][0]["name"], "ball");
  EXPECT_EQ(hello["frames"], 11);
  EXPECT_EQ(hello["names"], Json({{{"name", "ball.force"}, {"text", "(0, -9.81*mass, 0)"}},
                                  {{"name", "ball.torque"}, {"text", "(0, 0, 0)"}}}));
  EXPECT_EQ(command(), "resume");
  EXPECT_EQ(page.next("pace"), Json({{"type", "pace"}, {"paused", false}, {"speed", 1.0}}));
}

TEST_F(WatchTest, ThePageTellsHowFastToGo) {
  Page page(address_);
  page.next("pace");
  page.send({{"type", "pause"}});
  EXPECT_EQ(page.next("pace")["paused"], true);
  page.send({{"type", "step"}});
  page.send({{"type", "speed"}, {"value", 0.5}});
  page.send({{"type", "speed"}, {"value", 1e9}});
  page.send({{"type", "resume"}});
  std::vector<std::string> commands;
  for (int i = 0; i < 8; ++i) commands.push_back(command());
  EXPECT_EQ(commands, (std::vector<std::string>{"speed 1", "pause", "resume", "pause", "step", "speed 0.5",
                                                "speed 1024", "resume"}));
}

TEST_F(WatchTest, AnExpressionIsCheckedAsItIsTyped) {
  Page page(address_);
  page.send({{"type", "check"}, {"name", "ball.force"}, {"text", "(0, sin(t, 0)"}});
  EXPECT_NE(page.next("checked")["error"]["message"].get<std::string>().find('^'), std::string::npos);
  page.send({{"type", "check"}, {"name", "ball.force"}, {"text", "(0, sin(t), 0)"}});
  EXPECT_TRUE(page.next("checked")["error"].is_null());
  EXPECT_TRUE(edits_.empty());
}

TEST_F(WatchTest, AnEditThatMakesSenseIsSent) {
  Page page(address_);
  page.send({{"type", "edit"}, {"name", "ball.force"}, {"text", "(0, wind, 0)"}});
  EXPECT_NE(page.next("refused")["error"]["message"].get<std::string>().find("wind"), std::string::npos);
  page.send({{"type", "edit"}, {"name", "wind"}, {"text", "3"}});
  EXPECT_TRUE(page.next("checked")["error"].is_null());
  page.send({{"type", "edit"}, {"name", "ball.force"}, {"text", "(0, wind, 0)"}});
  EXPECT_TRUE(page.next("checked")["error"].is_null());
  page.send({{"type", "edit"}, {"name", "ball.mass"}, {"text", "3"}});
  page.next("refused");
  page.send({{"type", "edit"}, {"name", "wind"}, {"text", "lost"}});
  page.next("refused");
  EXPECT_EQ(edits_, (std::vector<std::string>{"wind = 3", "ball.force = (0, wind, 0)"}));
}

TEST_F(WatchTest, AnEditThatActsIsTold) {
  Page page(address_);
  std::ofstream(directory_.path() / "events.jsonl")
      << R"({"kind": "edit", "time_s": 0.5, "name": "wind", "value": "3"})" << '\n';
  EXPECT_EQ(page.next("edited"),
            Json({{"type", "edited"}, {"name", "wind"}, {"text", "3"}, {"time_s", 0.5}}));
}

TEST_F(WatchTest, WhatIsNoMessageHarmsNobody) {
  Page page(address_);
  for (const Json& message :
       {Json(3), Json("x"), Json::object(), Json({{"type", 7}}), Json({{"type", "speed"}, {"value", "fast"}}),
        Json({{"type", "edit"}, {"name", 3}, {"text", {1}}})})
    page.send(message);
  page.next("pace");
  page.send({{"type", "pause"}});
  EXPECT_EQ(page.next("pace")["paused"], true);
  EXPECT_TRUE(edits_.empty());
}

TEST_F(WatchTest, APageThatComesLaterIsToldWhatWas) {
  Page first(address_);
  std::ofstream(directory_.path() / "events.jsonl") << "{\"kind\": \"impact\", \"time_s\": 0.5}\n";
  first.next("event");
  Page second(address_);
  EXPECT_EQ(second.next("event")["time_s"], 0.5);
}

TEST_F(WatchTest, TellsTheRestAndTheEndAndCloses) {
  Page page(address_);
  page.next("pace");
  std::ofstream(directory_.path() / "events.jsonl") << "{\"kind\": \"impact\", \"time_s\": 0.5}\n";
  watch_->end("done", "0123");
  EXPECT_EQ(page.next("event")["kind"], "impact");
  EXPECT_EQ(page.next("end"), Json({{"type", "end"}, {"status", "done"}, {"state_hash", "0123"}}));
  EXPECT_THROW(page.next("anything"), boost::system::system_error);
}

TEST_F(WatchTest, ARunWhosePageFailsGoesOnWithoutIt) {
  Page page(address_);
  page.next("pace");
  std::ofstream(directory_.path() / "events.jsonl") << "no JSON\n";
  EXPECT_THROW(page.next("anything"), boost::system::system_error);
  while (command() != "resume") {
  }
  pollfd closed{watch_->pace_fd(), POLLIN, 0};
  ASSERT_EQ(poll(&closed, 1, 10'000), 1);
  EXPECT_FALSE(reader().read_lines([](const std::string&) {}));
  watch_->end("done", "0123");
}

TEST_F(WatchTest, APortThatIsTakenIsToldWithARemedy) {
  try {
    WebServer(static_cast<uint16_t>(std::stoi(address_.port)), "", {});
    FAIL() << "two servers on one port";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "--port");
  }
}

}  // namespace
}  // namespace animado::live
