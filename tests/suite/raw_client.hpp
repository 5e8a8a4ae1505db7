// A client that shares no code with src/rpc: it speaks to a socket as another language would, and may say
// anything.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace animado::suite {

using Json = nlohmann::json;
using Bytes = std::vector<uint8_t>;

// [1, id, error, result], taken apart.
struct Answer {
  int64_t id = 0;
  Json error, result;
};

class RawClient {
 public:
  explicit RawClient(const std::filesystem::path& socket);
  ~RawClient();
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  // [0, id, method, [params]], and what came back; nothing when the connection was closed instead.
  std::optional<Answer> call(const std::string& method, const Json& params);
  std::optional<Answer> call_packed(const Bytes& message);
  void hello();

  void send(const Bytes& bytes);
  std::optional<Answer> receive();
  std::optional<Json> receive_message();  // an answer, or a notification: [2, method, [params]]
  bool closed();                          // waits until the service has closed the connection

 private:
  int fd_ = -1;
  int64_t id_ = 0;
  Bytes received_;
};

Bytes packed(int64_t id, const std::string& method, const Json& params);

}  // namespace animado::suite
