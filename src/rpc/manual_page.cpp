#include "rpc/manual_page.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace animado::rpc {
namespace {

using Rows = std::vector<Describe::FieldRow>;

// The record inside a list of records or an optional one; null when there is none.
const Type* record_in(const Type& type) {
  const Type* inner = &type;
  while (inner->element != nullptr) inner = inner->element;
  return inner->kind == Type::Kind::record ? inner : nullptr;
}

std::string default_text(const Field& field, const void* record) {
  if (field.required || field.type->kind == Type::Kind::optional) return {};
  std::string text;
  summarize(*field.type, static_cast<const char*>(record) + field.offset, text);
  return text;
}

void add_rows(const Type& type, std::string_view side, const std::string& prefix, Rows& rows) {
  const Value sample = type.make();
  for (const Field& field : type.fields) {
    const std::string path = prefix + std::string(field.name);
    rows.push_back({std::string(side), path, type_text(*field.type), std::string(field.doc), field.required,
                    default_text(field, sample.get())});
    if (const Type* inner = record_in(*field.type)) add_rows(*inner, side, path + ".", rows);
  }
}

std::string table(const Rows& rows, std::string_view side) {
  std::string text;
  for (const auto& row : rows) {
    if (row.side != side) continue;
    std::string need;
    if (side == "request")
      need = row.required          ? ""
             : row.initial.empty() ? ", optional"
                                   : fmt::format(", default {}", row.initial);
    text += fmt::format("| `{}` | {}{} | {} |\n", row.path, row.type, need, row.doc);
  }
  if (text.empty()) return {};
  return fmt::format("\n| {} | type | meaning |\n|---|---|---|\n{}", side, text);
}

}  // namespace

Describe::Message described(const MessageCodec& codec) {
  Describe::Message message{std::string(codec.name), std::string(codec.doc), {}};
  add_rows(codec.request, "request", "", message.rows);
  add_rows(codec.reply, "reply", "", message.rows);
  return message;
}

std::string manual_page(std::string_view service, std::string_view introduction,
                        std::span<const MessageCodec* const> messages) {
  std::string page = fmt::format("## {}\n\n{}\n", service, introduction);
  for (const MessageCodec* codec : messages) {
    const Describe::Message message = described(*codec);
    page += fmt::format("\n### {}\n\n{}\n", message.name, message.doc);
    page += table(message.rows, "request");
    page += table(message.rows, "reply");
  }
  return page;
}

std::string common_pages() {
  std::string page = R"(# The protocol

This page is made from the lists of messages in the sources (`src/*/protocol.hpp`): `animado protocol > docs/protocol.md`. A test
compares the two.

## The wire

MessagePack-RPC over Unix stream sockets: a request is `[0, id, method, [params]]`, its reply `[1, id, error, result]`, a notification
`[2, method, [params]]`. MessagePack values end by themselves, so nothing stands between messages. `params` and `result` are
maps, field by name. A field that is missing, unknown or of the wrong type is an error; an integer is good where a number is meant.
Beside its fields `params` may hold `_trace` (text: the run) and `_seq` (integer: the number of the call), which the log repeats.

The first call on a connection is `hello`. A service answers one request after the other, in the order in which they came.
Any request may be sent again: the same request on the same arrays gives the same bits.

A message holds at most 64 MiB, 4194304 values, 32 levels. A longer one is refused as soon as its length is known, and the
connection ends.

### Arrays

An array is a map: inline `{shape, data}`, where data is `bin` (little-endian float64, row-major) or a list of numbers, or shared
`{shape, shared, offset}`, which names an array of interexpserv and its first element. Nested lists of numbers are good too.
A shared array is a memory file whose size is sealed; its descriptor comes with the reply of `array_create` or `array_open` as
`SCM_RIGHTS`.

### Mailboxes

A client that calls often may open a mailbox beside its connection, through which a short call takes half the time. The
reply to `mailbox` brings three descriptors: a memory file of 8192 bytes with its size sealed, the server's bell and the client's
bell (eventfds). The first half of the memory is for a request, the second for its answer: the number of letters so far (uint32,
little-endian), the size of this one in bytes (uint32), whether who takes it is awake (uint32), and the letter: a message as it would go
over the socket, or several. Who leaves a letter writes it, then its size, then its number, and adds 1 to the other's bell where the
other is not awake. A client that sets the word in the half of answers looks for them by itself; before it waits for the bell it writes 0
there and looks once more. A client that leaves the word alone is rung for.

A letter is one call while nothing else is under way on the connection. What came as a letter is answered by one if the answer fits and
brings no descriptor, over the socket otherwise. The socket does all else, and the mailbox ends with it.

### Errors

An error is a map `{code, message, where, remedy}`. The codes:

)";
  for (int i = 0; i <= static_cast<int>(Code::internal); ++i) {
    page += fmt::format("{}`{}`", i == 0 ? "" : ", ", name_of(static_cast<Code>(i)));
  }
  const auto common = codecs<CommonMessages>();
  return page + ".\n\n" +
         manual_page("every service", "The messages that each of the services answers.", common);
}

}  // namespace animado::rpc
