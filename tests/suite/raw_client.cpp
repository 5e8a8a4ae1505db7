#include "raw_client.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <sstream>
#include <stdexcept>

namespace animado::suite {
namespace {

constexpr int kPatience_ms = 20000;  // far more than any answer takes, so that only a hang ends it

}  // namespace

Bytes packed(int64_t id, const std::string& method, const Json& params) {
  return Json::to_msgpack(Json::array({0, id, method, Json::array({params})}));
}

RawClient::RawClient(const std::filesystem::path& socket)
    : fd_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, socket.c_str(), sizeof address.sun_path - 1);
  if (connect(fd_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    throw std::runtime_error("cannot connect to " + socket.string() + ": " + std::strerror(errno));
  }
}

RawClient::~RawClient() {
  close(fd_);
}

void RawClient::send(const Bytes& bytes) {
  for (size_t sent = 0; sent < bytes.size();) {
    const ssize_t n = ::send(fd_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (n < 0) return;  // closed: receive() tells
    sent += static_cast<size_t>(n);
  }
}

std::optional<Answer> RawClient::receive() {
  const auto message = receive_message();
  if (!message) return std::nullopt;
  return Answer{message->at(1), message->at(2), message->at(3)};
}

std::optional<Json> RawClient::receive_message() {
  while (true) {
    if (!received_.empty()) {
      std::istringstream bytes(std::string(received_.begin(), received_.end()));
      const Json message = Json::from_msgpack(bytes, false, false);
      if (!message.is_discarded()) {
        received_.erase(received_.begin(), received_.begin() + bytes.tellg());
        return message;
      }
    }
    pollfd waiting{fd_, POLLIN, 0};
    if (poll(&waiting, 1, kPatience_ms) != 1) throw std::runtime_error("no answer in time");
    uint8_t buffer[65536];
    const ssize_t n = recv(fd_, buffer, sizeof buffer, 0);
    if (n <= 0) return std::nullopt;
    received_.insert(received_.end(), buffer, buffer + n);
  }
}

bool RawClient::closed() {
  while (receive()) {
  }
  return true;
}

std::optional<Answer> RawClient::call_packed(const Bytes& message) {
  send(message);
  return receive();
}

std::optional<Answer> RawClient::call(const std::string& method, const Json& params) {
  return call_packed(packed(++id_, method, params));
}

void RawClient::hello() {
  const auto answer = call("hello", {{"protocol", "animado"}, {"version", 1}});
  if (!answer || !answer->error.is_null()) throw std::runtime_error("hello was refused");
}

}  // namespace animado::suite
