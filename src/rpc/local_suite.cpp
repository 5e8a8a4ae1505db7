#include "rpc/local_suite.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>

namespace animado::rpc {
namespace {

constexpr ConnectionId kTheConnection = 1;  // the process has one to each service

UniqueFd duplicate(int fd) {
  return UniqueFd(fcntl(fd, F_DUPFD_CLOEXEC, 0));
}

}  // namespace

LocalChannel::LocalChannel(std::unique_ptr<Service> service, std::unique_ptr<Log> log, Suite& suite,
                           const std::string& trace, int64_t& seq)
    : service_(std::move(service)),
      log_(std::move(log)),
      dispatcher_(*service_, suite, *log_),
      trace_(trace),
      seq_(seq) {
  service_->post = [this](ConnectionId, std::string_view message) { return post(message); };
}

Service::Delivery LocalChannel::post(std::string_view message) {
  is_full_ |= inbox_.bytes() > kMaxUnread;
  if (is_full_) return Service::Delivery::full;
  inbox_.put(message);
  return Service::Delivery::sent;
}

LocalChannel::~LocalChannel() {
  if (service_->on_disconnect) service_->on_disconnect(kTheConnection);
}

void LocalChannel::exchange(const MessageCodec& message, const void* request, void* reply) {
  const Marks marks{trace_, ++seq_};
  ServedCall call(kTheConnection, dispatcher_.suite());
  const Dispatcher::Outcome outcome =
      dispatcher_.run(find(message, marks), request, reply, call, Clock::now());
  dispatcher_.record(message, request, marks, outcome, outcome.begin);
  dispatcher_.was_busy(outcome.end - outcome.begin);
  if (outcome.error) throw Error(*outcome.error);
  received_.clear();
  for (int fd : call.outgoing()) received_.push_back(duplicate(fd));
}

const Service::Entry& LocalChannel::find(const MessageCodec& message, const Marks& marks) {
  try {
    return dispatcher_.entry(message.name);
  } catch (const Error& error) {
    dispatcher_.refuse(message.name, marks, error);
    throw;
  }
}

bool LocalChannel::next_notification(const MessageCodec& message, void* request, double) {
  const bool taken = inbox_.take(message, request);
  if (is_full_ && inbox_.empty()) {
    is_full_ = false;
    if (service_->on_drained) service_->on_drained(kTheConnection);
  }
  return taken;
}

LocalSuite::LocalSuite(Options options) : options_(std::move(options)) {}
LocalSuite::~LocalSuite() = default;

Service& LocalSuite::add(std::unique_ptr<Service> service) {
  const std::string name = service->name();
  auto log = options_.logs.empty() ? std::make_unique<Log>()
                                   : std::make_unique<Log>(name, options_.logs / (name + ".log"));
  auto channel =
      std::make_unique<LocalChannel>(std::move(service), std::move(log), *this, options_.trace, seq_);
  const auto [at, added] = channels_.try_emplace(name, std::move(channel));
  assert(added && "two services of one name");
  return at->second->service();
}

Service& LocalSuite::add(const std::string& name, const std::function<void(Service&, Suite&)>& fill_table) {
  auto service = std::make_unique<Service>(name);
  fill_table(*service, *this);
  return add(std::move(service));
}

Channel& LocalSuite::channel(std::string_view service) {
  const auto found = channels_.find(service);
  if (found != channels_.end()) return *found->second;
  throw Error(Code::unavailable, fmt::format("{} is not linked into this process", service),
              std::string(service), "run without --in-process, or add the service");
}

SharedArrays& LocalSuite::arrays() {
  if (!arrays_) arrays_ = std::make_unique<SharedArrays>(channel("interexpserv"));
  return *arrays_;
}

}  // namespace animado::rpc
