// The services linked into this process. A call goes straight to its handler with typed values: nothing is
// encoded, and nothing else differs from a call over a socket.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "rpc/dispatcher.hpp"
#include "rpc/inbox.hpp"

namespace animado::rpc {

class LocalChannel final : public Channel {
 public:
  // trace and seq belong to the suite, and number its calls over all its channels.
  LocalChannel(std::unique_ptr<Service> service, std::unique_ptr<Log> log, Suite& suite,
               const std::string& trace, int64_t& seq);
  ~LocalChannel() override;

  Service& service() { return *service_; }
  UniqueFd take_descriptor() override { return first_of(received_); }

 protected:
  void exchange(const MessageCodec& message, const void* request, void* reply) override;
  // Nothing can arrive while the one thread of this process waits here: looks at what has come, whatever the
  // time limit.
  bool next_notification(const MessageCodec& message, void* request, double timeout_s) override;

 private:
  Service::Delivery post(std::string_view message);
  const Service::Entry& find(const MessageCodec& message, const Marks& marks);

  std::unique_ptr<Service> service_;
  std::unique_ptr<Log> log_;
  Dispatcher dispatcher_;
  const std::string& trace_;
  int64_t& seq_;
  std::vector<UniqueFd> received_;
  Inbox inbox_;
  bool is_full_ = false;
};

class LocalSuite final : public Suite {
 public:
  struct Options {
    std::filesystem::path logs;  // folder for a log a module; none when empty
    std::string trace;
  };
  LocalSuite() : LocalSuite(Options{}) {}
  explicit LocalSuite(Options options);
  ~LocalSuite() override;

  Service& add(std::unique_ptr<Service> service);
  Service& add(const std::string& name, const std::function<void(Service&, Suite&)>& fill_table);

  Channel& channel(std::string_view service) override;
  SharedArrays& arrays() override;  // needs interexpserv among the services

 private:
  Options options_;
  int64_t seq_ = 0;
  std::map<std::string, std::unique_ptr<LocalChannel>, std::less<>> channels_;
  std::unique_ptr<SharedArrays> arrays_;
};

}  // namespace animado::rpc
