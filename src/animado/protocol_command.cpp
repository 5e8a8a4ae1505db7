// animado protocol: the manual page of every message, made from the lists that the programs themselves are
// made from.
#include "animado/commands.hpp"
#include "colisao/protocol.hpp"
#include "egesp/protocol.hpp"
#include "fred/protocol.hpp"
#include "interexpserv/protocol.hpp"
#include "rpc/manual_page.hpp"

namespace animado {

namespace {

template <class Messages, class Notifications = std::tuple<>>
std::string page(std::string_view service, std::string_view introduction) {
  auto messages = rpc::codecs<Messages>();
  for (const rpc::MessageCodec* notification : rpc::codecs<Notifications>()) messages.push_back(notification);
  return "\n" + rpc::manual_page(service, introduction, messages);
}

}  // namespace

void add_protocol_command(CommandLine& line) {
  CLI::App& command = add_command(line, "protocol", "Print docs/protocol.md: all messages of all services",
                                  "  animado protocol > docs/protocol.md\n");
  command.callback([] {
    fmt::print("{}{}{}{}{}", rpc::common_pages(),
               page<interexpserv::Messages, interexpserv::Notifications>(
                   "interexpserv",
                   "Started first, at the one well-known address: who offers what, named values and "
                   "expressions, shared arrays."),
               page<egesp::Messages>("egesp", "Solves systems of linear equations. It knows no physics."),
               page<fred::Messages, fred::Notifications>(
                   "fred", "Integrates ordinary differential equations. It knows no physics."),
               page<colisao::Messages>("colisao", "Finds collisions and answers them."));
  });
}

}  // namespace animado
