// A page and its WebSockets on 127.0.0.1, for whoever has the token: one thread, which is the caller's.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace animado::live {

class WebServer {
 public:
  struct Callbacks {
    // A page connected: what it is told first.
    std::function<std::vector<std::string>()> on_open;
    std::function<void(const std::string& message)> on_message;
    std::function<void()> on_tick;  // every kTick_ms
  };
  static constexpr int kTick_ms = 25;

  // Listens at once. port 0: any that is free. Throws Error(unavailable) when the port is taken.
  WebServer(uint16_t port, std::string page, Callbacks callbacks);
  ~WebServer();

  std::string address() const;  // http://127.0.0.1:PORT/?token=…

  // Serves until stop(), which any thread may call; what was sent before it is still delivered. Throws what
  // a callback throws; run() again goes on, without ticks when it was theirs.
  void run();
  void stop();
  void post(std::function<void()> work);  // is done by the thread that runs; any thread may ask

  // To all pages. Called from the callbacks only. Who reads too slowly misses messages that may be left out.
  void send(const std::string& message, bool may_be_left_out = false);

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace animado::live
