#include "live/web_server.hpp"

#include <fmt/format.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <set>
#include <vector>

#include "base/error.hpp"
#include "live/token.hpp"

namespace animado::live {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using Tcp = asio::ip::tcp;
using boost::system::error_code;
using Request = http::request<http::string_body>;
using Text = std::shared_ptr<const std::string>;

constexpr size_t kMostRequest = 64 * 1024;           // bytes of a message from a page
constexpr size_t kMostWaiting = 200;                 // messages for a page that does not read
constexpr auto kPatience = std::chrono::seconds(2);  // with who is slow to say what it wants

// The value of `token` in a target such as /live?token=…; empty when there is none.
std::string_view token_of(std::string_view target) {
  constexpr std::string_view kKey = "token=";
  const size_t query = target.find('?');
  const size_t at = query == target.npos ? target.npos : target.find(kKey, query);
  if (at == target.npos) return {};
  const std::string_view rest = target.substr(at + kKey.size());
  return rest.substr(0, rest.find('&'));
}

std::string_view path_of(std::string_view target) {
  return target.substr(0, target.find('?'));
}

}  // namespace

// --- a page's socket

class WebServer::Listener {
 public:
  class Page;
  class Visit;

  Listener(uint16_t port, std::string page, Callbacks callbacks);

  uint16_t port() const { return acceptor_.local_endpoint().port(); }
  void accept();
  void tick();
  void stop();

  asio::io_context context{1};
  const std::string page, token = random_token();
  const Callbacks callbacks;
  std::set<std::shared_ptr<Page>> pages;
  bool ending = false;

 private:
  Tcp::acceptor acceptor_;
  asio::steady_timer timer_;
};

class WebServer::Listener::Page : public std::enable_shared_from_this<Page> {
 public:
  Page(Listener& listener, Tcp::socket socket) : listener_(listener), socket_(std::move(socket)) {
    auto timeout = beast::websocket::stream_base::timeout::suggested(beast::role_type::server);
    timeout.handshake_timeout = kPatience;  // a farewell has it too
    socket_.set_option(timeout);
    socket_.read_message_max(kMostRequest);
  }

  void open(const Request& request) {
    socket_.async_accept(request, [self = shared_from_this()](error_code failed) {
      if (failed) return;
      self->listener_.pages.insert(self);
      for (std::string& message : self->listener_.callbacks.on_open())
        self->send(std::make_shared<const std::string>(std::move(message)), false);
      self->read();
    });
  }

  void send(const Text& message, bool may_be_left_out) {
    if (may_be_left_out && waiting_.size() > kMostWaiting) return;
    waiting_.push_back(message);
    if (waiting_.size() == 1) write();
  }

  // Closes when all is sent.
  void finish() {
    if (waiting_.empty()) close();
  }

 private:
  void read() {
    socket_.async_read(buffer_, [self = shared_from_this()](error_code failed, size_t) {
      if (failed) return self->leave();
      self->listener_.callbacks.on_message(beast::buffers_to_string(self->buffer_.data()));
      self->buffer_.clear();
      self->read();
    });
  }

  void write() {
    socket_.text(true);
    socket_.async_write(asio::buffer(*waiting_.front()),
                        [self = shared_from_this()](error_code failed, size_t) {
                          if (failed) return self->leave();
                          self->waiting_.pop_front();
                          if (!self->waiting_.empty()) return self->write();
                          if (self->listener_.ending) self->close();
                        });
  }

  void close() {
    socket_.async_close(beast::websocket::close_code::normal,
                        [self = shared_from_this()](error_code) { self->leave(); });
  }

  void leave() {
    waiting_.clear();
    listener_.pages.erase(shared_from_this());
  }

  Listener& listener_;
  beast::websocket::stream<beast::tcp_stream, false> socket_;  // uncompressed: it does not leave the machine
  beast::flat_buffer buffer_;
  std::deque<Text> waiting_;
};

// --- a request over HTTP: the page, or a WebSocket to be

class WebServer::Listener::Visit : public std::enable_shared_from_this<Visit> {
 public:
  Visit(Listener& listener, Tcp::socket socket) : listener_(listener), stream_(std::move(socket)) {}

  void read() {
    parser_.emplace();
    parser_->body_limit(kMostRequest);
    stream_.expires_after(kPatience);
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](error_code failed, size_t) {
      if (!failed) self->answer(self->parser_->release());
    });
  }

 private:
  void answer(const Request& request) {
    const std::string_view target(request.target().data(), request.target().size());
    // A page of somebody else's that found the port has neither the token nor this host's name.
    const std::string host = fmt::format("127.0.0.1:{}", listener_.port());
    const bool knows = request[http::field::host] == host && same_token(token_of(target), listener_.token);
    if (!knows)
      return reply(http::status::forbidden, "text/plain",
                   "open the address that animado printed, with its token\n");
    if (path_of(target) == "/live" && beast::websocket::is_upgrade(request)) {
      if (request[http::field::origin] != "http://" + host)
        return reply(http::status::forbidden, "text/plain", "from another page\n");
      stream_.expires_never();
      std::make_shared<Page>(listener_, stream_.release_socket())->open(request);
      return;
    }
    if (path_of(target) != "/" || request.method() != http::verb::get)
      return reply(http::status::not_found, "text/plain", "there is one page here: /\n");
    reply(http::status::ok, "text/html; charset=utf-8", listener_.page);
  }

  void reply(http::status status, const char* type, const std::string& body) {
    const auto response = std::make_shared<http::response<http::string_body>>(status, 11, body);
    response->set(http::field::content_type, type);
    response->set(http::field::cache_control, "no-store");
    response->set("Referrer-Policy", "no-referrer");
    response->set("X-Content-Type-Options", "nosniff");
    response->keep_alive(false);
    response->prepare_payload();
    http::async_write(stream_, *response, [self = shared_from_this(), response](error_code, size_t) {
      error_code ignored;
      self->stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
    });
  }

  Listener& listener_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
};

// --- the listener

WebServer::Listener::Listener(uint16_t port, std::string html, Callbacks calls)
    : page(std::move(html)), callbacks(std::move(calls)), acceptor_(context), timer_(context) {
  const Tcp::endpoint here(asio::ip::address_v4::loopback(), port);
  error_code failed;
  acceptor_.open(here.protocol());
  acceptor_.set_option(asio::socket_base::reuse_address(true));
  acceptor_.bind(here, failed);
  if (!failed) acceptor_.listen(asio::socket_base::max_listen_connections, failed);
  if (failed) {
    throw Error(Code::unavailable, fmt::format("port {} of 127.0.0.1: {}", port, failed.message()), "--port",
                "choose another, or none: then any that is free is taken");
  }
}

void WebServer::Listener::accept() {
  acceptor_.async_accept([this](error_code failed, Tcp::socket socket) {
    if (!acceptor_.is_open()) return;
    if (!failed) std::make_shared<Visit>(*this, std::move(socket))->read();
    accept();
  });
}

void WebServer::Listener::tick() {
  timer_.expires_after(std::chrono::milliseconds(kTick_ms));
  timer_.async_wait([this](error_code failed) {
    if (failed || ending) return;
    callbacks.on_tick();
    tick();
  });
}

void WebServer::Listener::stop() {
  ending = true;
  acceptor_.close();
  timer_.cancel();
  const auto open = pages;
  for (const auto& watching : open) watching->finish();
}

WebServer::WebServer(uint16_t port, std::string page, Callbacks callbacks)
    : listener_(std::make_unique<Listener>(port, std::move(page), std::move(callbacks))) {
  listener_->accept();
  listener_->tick();
}

WebServer::~WebServer() = default;

std::string WebServer::address() const {
  return fmt::format("http://127.0.0.1:{}/?token={}", listener_->port(), listener_->token);
}

void WebServer::run() {
  listener_->context.run();
}

void WebServer::stop() {
  asio::post(listener_->context, [this] { listener_->stop(); });
}

void WebServer::post(std::function<void()> work) {
  asio::post(listener_->context, std::move(work));
}

void WebServer::send(const std::string& message, bool may_be_left_out) {
  const auto text = std::make_shared<const std::string>(message);
  const auto open = listener_->pages;
  for (const auto& watching : open) watching->send(text, may_be_left_out);
}

}  // namespace animado::live
