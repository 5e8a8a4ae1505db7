#include "rpc/dispatcher.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iterator>

#include "base/nearest_name.hpp"
#include "rpc/mailbox.hpp"
#include "rpc/manual_page.hpp"

namespace animado::rpc {
namespace {

constexpr size_t kMaxShown = 40;  // characters of a name from outside that a log line or an error repeats
constexpr std::string_view kUnknown = "?";  // under which unknown messages are counted

Hello::Reply answer_hello(const Hello::Request& request, const std::string& service) {
  if (request.protocol != kProtocolName || request.version != kProtocolVersion) {
    throw Error(Code::protocol,
                fmt::format("'{}' version {} is not spoken here", request.protocol.substr(0, kMaxShown),
                            request.version),
                service,
                fmt::format("say hello with protocol '{}' and version {}", kProtocolName, kProtocolVersion));
  }
  return {service, ANIMADO_VERSION, kProtocolVersion, getpid()};
}

}  // namespace

// --- the call

std::span<double> ServedCall::pages(const Array& array) {
  const std::span<double> all = suite_.arrays().open(array.shared).values();
  const int64_t count = array.count();
  const auto size = static_cast<int64_t>(all.size());
  if (count < 0 || array.offset < 0 || count > size || array.offset > size - count) {
    throw Error(Code::bad_shape,
                fmt::format("{} numbers from {} do not fit into {}", count, array.offset, size), array.shared,
                "give a shape and an offset inside the shared array");
  }
  return all.subspan(static_cast<size_t>(array.offset), static_cast<size_t>(count));
}

std::span<const double> ServedCall::read(const Array& array) {
  if (array.is_shared()) return pages(array);
  if (array.count() != static_cast<int64_t>(array.values.size())) {
    throw Error(Code::bad_shape,
                fmt::format("shape ({}) needs {} numbers, there are {}", fmt::join(array.shape, ", "),
                            array.count(), array.values.size()),
                {}, "give as many numbers as the shape asks for");
  }
  return array.values;
}

std::span<double> ServedCall::write(const Array& array) {
  if (!array.is_shared()) {
    throw Error(Code::bad_params, "a result cannot be written into an inline array", "out",
                "name a shared array, or leave the field out to get the result in the reply");
  }
  return pages(array);
}

// --- the dispatcher

Dispatcher::Dispatcher(Service& service, Suite& suite, Log& log)
    : service_(service), suite_(suite), log_(log) {
  add_common();
}

void Dispatcher::add_common() {
  service_.on<Hello>(
      [this](const Hello::Request& request) { return answer_hello(request, service_.name()); });
  service_.on<Ping>([](const Nothing&) { return Nothing{}; });
  service_.on<OpenMailbox>([this](const Nothing&, Call& call) {
    if (!service_.open_mailbox)
      throw Error(Code::refused, "in one process there is no connection that could have a mailbox",
                  service_.name(), "call: nothing is nearer");
    for (int fd : service_.open_mailbox(call.connection())) call.send_descriptor(fd);
    return OpenMailbox::Reply{Mailbox::kRoom};
  });
  service_.on<Statistics>([this](const Nothing&) { return statistics(); });
  service_.on<Describe>([this](const Nothing&) {
    Describe::Reply reply;
    for (const auto& [name, entry] : service_.entries()) reply.messages.push_back(described(*entry.codec));
    return reply;
  });
}

Statistics::Reply Dispatcher::statistics() const {
  const auto seconds_of = [](Clock::duration time) { return std::chrono::duration<double>(time).count(); };
  const Load now = load ? load() : Load{};
  Statistics::Reply reply{.service = service_.name(),
                          .version = ANIMADO_VERSION,
                          .up_since = up_since_,
                          .pid = getpid(),
                          .requests = total_.requests,
                          .errors = total_.errors,
                          .messages = {},
                          .latency = latency_.rows(),
                          .up_s = seconds_of(Clock::now() - start_),
                          .busy_s = seconds_of(busy_),
                          .connections = now.connections,
                          .waiting = now.waiting,
                          .unsent_bytes = now.unsent_bytes};
  for (const auto& [name, count] : counts_)
    reply.messages.push_back({std::string(name), count.requests, count.errors, seconds_of(count.time)});
  return reply;
}

const Service::Entry& Dispatcher::entry(std::string_view method) const {
  if (const Service::Entry* found = service_.find(method)) return *found;
  std::vector<std::string> known;
  for (const auto& row : service_.entries()) known.push_back(row.first);
  const std::string near = nearest_name(method, known);
  throw Error(Code::unknown_method, fmt::format("there is no message '{}'", method.substr(0, kMaxShown)),
              service_.name(),
              fmt::format("{}messages: {}", near.empty() ? "" : fmt::format("did you mean '{}'? ", near),
                          fmt::join(known, ", ")));
}

Dispatcher::Outcome Dispatcher::run(const Service::Entry& entry, const void* request, void* reply, Call& call,
                                    Clock::time_point begin) {
  Outcome outcome;
  outcome.begin = begin;
  try {
    entry.handler(request, reply, call);
  } catch (const Error& error) {
    outcome.error = error;
  } catch (const std::exception& exception) {
    outcome.error.emplace(Code::internal, exception.what(),
                          fmt::format("{}.{}", service_.name(), entry.codec->name),
                          "this is a bug of the service: please report it with its log");
  }
  outcome.end = Clock::now();
  return outcome;
}

void Dispatcher::count(std::string_view message, bool failed, Clock::duration time) {
  for (Count* count : {&total_, &counts_[message]}) {
    ++count->requests;
    count->errors += failed;
    count->time += time;
  }
}

void Dispatcher::refuse(std::string_view method, const Marks& marks, const Error& error) {
  // Only names that are known are counted by name: a client must not fill our memory with others.
  const Service::Entry* found = service_.find(method);
  count(found ? found->codec->name : kUnknown, true);
  const Type& unread = type_of<Nothing>();
  const Nothing nothing;
  const Clock::time_point now = Clock::now();
  write_line({method, {}, unread, unread}, &nothing, marks, {error, now, now});
}

void Dispatcher::record(const MessageCodec& codec, const void* request, const Marks& marks,
                        const Outcome& outcome, Clock::time_point arrival) {
  count(codec.name, outcome.error.has_value(), outcome.end - outcome.begin);
  latency_.count(outcome.end - arrival);
  write_line(codec, request, marks, outcome);
}

void Dispatcher::write_line(const MessageCodec& codec, const void* request, const Marks& marks,
                            const Outcome& outcome) {
  const LogLevel level = outcome.error ? LogLevel::warning : LogLevel::info;
  if (!log_.enabled(level)) return;
  line_.clear();
  append_printable(marks.trace.empty() ? "-" : marks.trace.substr(0, kMaxShown), line_);
  line_ += '#';
  append_integer(marks.seq, line_);
  line_ += ' ';
  append_printable(codec.name.substr(0, kMaxShown), line_);
  line_ += ' ';
  summarize(codec.request, request, line_);
  if (line_.back() != ' ') line_ += ' ';
  const int64_t tenths_us = ((outcome.end - outcome.begin).count() + 50) / 100;
  append_integer(tenths_us / 10, line_);
  line_ += '.';
  append_integer(tenths_us % 10, line_);
  line_ += " µs ";
  if (outcome.error) {
    line_ += name_of(outcome.error->code());
    line_ += ": ";
    append_printable(outcome.error->what(), line_);
  } else {
    line_ += "ok";
  }
  log_.write(level, line_, outcome.end);
}

}  // namespace animado::rpc
