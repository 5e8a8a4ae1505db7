#include "rpc/registration.hpp"

#include <fmt/format.h>

#include "rpc/endpoint.hpp"
#include "rpc/wire.hpp"

namespace animado::rpc {
namespace {

// interexpserv's socket shows up in the folder when it comes back; this is for the case that a look at it
// came to nothing all the same.
constexpr std::chrono::milliseconds kTryAgain{500};

}  // namespace

Registration::Registration(const std::filesystem::path& directory, Register::Request entry, Log& log)
    : socket_(socket_path(directory, kWellKnown, 0)),
      entry_(std::move(entry)),
      log_(log),
      watch_(directory) {}

void Registration::step() {
  try {
    if (connection_) {
      read_answers();
    } else {
      watch_.clear();
      connect();
    }
  } catch (const Error& error) {
    lose(error.what());
  }
}

void Registration::connect() {
  next_try_ = Clock::now() + kTryAgain;
  UniqueFd fd = connect_to(socket_);
  if (!fd) return;
  connection_.emplace(std::move(fd));
  answers_ = 0;
  Encoder out(connection_->out());
  begin_request(1, Hello::name, out);
  const Hello::Request hello{std::string(kProtocolName), kProtocolVersion, entry_.name, {}};
  pack(type_of<Hello::Request>(), &hello, out);
  begin_request(2, Register::name, out);
  pack(type_of<Register::Request>(), &entry_, out);
  if (!connection_->flush()) return lose("it closed the connection");
  next_try_ = Clock::time_point::max();
}

void Registration::read_answers() {
  if (connection_->receive() == Connection::Received::closed) return lose("it closed the connection");
  std::string_view message;
  while (connection_->next_message(message)) {
    Envelope envelope;
    read_envelope(message, envelope);
    if (!envelope.error.empty()) throw read_error(envelope.error);
    if (++answers_ == 2) log_.info("registered with interexpserv");
  }
}

void Registration::lose(std::string_view why) {
  connection_.reset();
  answers_ = 0;
  next_try_ = Clock::now() + kTryAgain;
  log_.warn(fmt::format("not registered with interexpserv: {}", why));
}

}  // namespace animado::rpc
