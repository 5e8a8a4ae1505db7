// Joins the registry, the leases and the shared arrays to their messages. One request at a time: nothing here
// is locked.
#include "interexpserv/server.hpp"

#include <fmt/chrono.h>

#include <chrono>
#include <set>
#include <thread>

#include "base/fold.hpp"
#include "base/nearest_name.hpp"
#include "interexpserv/leases.hpp"
#include "interexpserv/names.hpp"
#include "interexpserv/protocol.hpp"
#include "interexpserv/published.hpp"
#include "interexpserv/store.hpp"
#include "rpc/shared_array.hpp"

namespace animado::interexpserv {
namespace {

using rpc::Call;
using rpc::ConnectionId;
using rpc::SharedArray;

constexpr size_t kMaxArrays = 512;  // each holds a descriptor, and a process may open 1024
// How long an array may be under way. Writing one takes microseconds; a writer that was put aside for longer
// than this is dead, and everybody else waits.
constexpr std::chrono::milliseconds kMaxWait(100);

std::string utc_now() {
  return fmt::format("{:%FT%TZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

// The shared arrays, each held for the connection that made it or handed it back last.
class ArrayTable {
 public:
  const SharedArray& create(const std::string& name, const std::vector<int64_t>& shape, ConnectionId owner) {
    if (name.empty())
      throw Error(Code::bad_params, "an array needs a name", "name", "choose one that is used once");
    if (const auto known = arrays_.find(name); known != arrays_.end()) {
      if (known->second.array.shape() != shape) {
        throw Error(Code::conflict,
                    fmt::format("there is an array `{}` of another shape ({})", name,
                                fmt::join(known->second.array.shape(), ", ")),
                    name, "use a name once, or release that array first");
      }
      known->second.owner = owner;
      return known->second.array;
    }
    return add(name, SharedArray(SharedArray::make(name, shape), shape, name), owner);
  }

  void adopt(const std::string& name, const std::vector<int64_t>& shape, rpc::UniqueFd fd,
             ConnectionId owner) {
    if (!fd)
      throw Error(Code::bad_params, "no descriptor came with the request", name, "send it with SCM_RIGHTS");
    const auto known = arrays_.find(name);
    if (known == arrays_.end()) {
      add(name, SharedArray(std::move(fd), shape, name), owner);
    } else {
      known->second.owner = owner;  // its former connection ended, and nobody has noticed yet
    }
  }

  const SharedArray& find(const std::string& name) const {
    const auto known = arrays_.find(name);
    if (known != arrays_.end()) return known->second.array;
    std::vector<std::string> names;
    for (const auto& [other, entry] : arrays_) names.push_back(other);
    const std::string near = nearest_name(name, names);
    throw Error(Code::unknown_array, fmt::format("no shared array `{}`", name), name,
                near.empty() ? "create it; the arrays of a program that ended are gone"
                             : fmt::format("did you mean `{}`?", near));
  }

  void release(const std::string& name) { arrays_.erase(name); }
  void end(ConnectionId owner) {
    std::erase_if(arrays_, [&](const auto& entry) { return entry.second.owner == owner; });
  }
  ArrayList::Reply list() const {
    ArrayList::Reply reply;
    for (const auto& [name, entry] : arrays_) reply.arrays.push_back({name, entry.array.shape()});
    return reply;
  }

 private:
  struct Entry {
    SharedArray array;
    ConnectionId owner;
  };

  const SharedArray& add(const std::string& name, SharedArray array, ConnectionId owner) {
    if (arrays_.size() == kMaxArrays) {
      throw Error(Code::limit, fmt::format("there are {} shared arrays already", kMaxArrays), name,
                  "release some, or put several into one");
    }
    return arrays_.emplace(name, Entry{std::move(array), owner}).first->second.array;
  }

  std::map<std::string, Entry, std::less<>> arrays_;
};

// One consistent picture of each array that a request reads, taken when it is first needed.
class Pictures {
 public:
  explicit Pictures(const ArrayTable& arrays) : arrays_(arrays) {}

  std::span<const double> operator()(const std::string& name) {
    const auto [at, is_new] = taken_.try_emplace(name);
    if (is_new) at->second = take(name);
    return at->second;
  }

 private:
  std::vector<double> take(const std::string& name) const {
    const std::span<const double> array = arrays_.find(name).values();
    std::vector<double> copy(array.size());
    const auto deadline = std::chrono::steady_clock::now() + kMaxWait;
    do {
      if (array.empty() || read_published(array, copy)) return copy;
      std::this_thread::yield();
    } while (std::chrono::steady_clock::now() < deadline);
    throw Error(Code::unavailable, fmt::format("`{}` is being written all the time", name), name,
                "ask again; if its writer was killed, restart it");
  }

  const ArrayTable& arrays_;
  std::map<std::string, std::vector<double>> taken_;
};

NameState state_of(const NameRow& row) {
  return {row.name, row.text, static_cast<Kind>(row.kind), row.type, row.version, {}};
}

std::vector<double> numbers_of(const Value& value) {
  return {value.v.begin(), value.v.begin() + static_cast<ptrdiff_t>(width_of(value.type))};
}

class Registry {
 public:
  Registry(rpc::Service& service, const std::filesystem::path& file) : service_(service) {
    if (file.empty()) return;
    store_ = std::make_unique<Store>(file);
    names_ = Names([this](int64_t version, std::span<const NameRow> rows) { store_->commit(version, rows); });
    const Store::Contents contents = store_->load();
    names_.restore(contents.rows, contents.version);
  }

  void enter(const rpc::Register::Request& r, ConnectionId connection) {
    leases_.grant({r.name, r.socket, r.version, utc_now(), r.pid, connection});
  }

  rpc::Lookup::Reply lookup(const rpc::Lookup::Request& r) const {
    const Lease& lease = leases_.find(r.name);
    return {lease.socket, lease.version, lease.pid};
  }

  List::Reply list() const {
    List::Reply reply;
    for (const Lease& l : leases_.list())
      reply.services.push_back({l.name, l.socket, l.version, l.since, l.pid});
    return reply;
  }

  Changed define(const Define::Request& r) {
    std::vector<NamedText> definitions;
    for (const auto& [name, text] : r.definitions) definitions.push_back({name, text});
    return tell(names_.define(definitions));
  }

  Changed set(const Set::Request& r) { return tell(names_.define(std::vector<NamedText>{{r.name, r.text}})); }
  Changed remove(const Remove::Request& r) { return tell(names_.remove(r.names)); }

  Changed bind(const Bind::Request& r) {
    std::vector<NamedBinding> bindings;
    for (const Bind::Bound& bound : r.names) {
      refuse_outside(bound);
      bindings.push_back({bound.name, bound.type, {bound.array, bound.element, bound.stride}});
    }
    return tell(names_.bind(bindings));
  }

  Get::Reply get(const Get::Request& r) const {
    Get::Reply reply{{}, names_.version()};
    Pictures pictures(arrays_);
    for (const std::string& name : r.names) {
      reply.names.push_back(state_of(names_.row(name)));
      reply.names.back().values = numbers_of(names_.value(name, std::ref(pictures)));
    }
    if (!r.names.empty()) return reply;
    for (const NameRow& row : names_.rows(r.prefix)) reply.names.push_back(with_value(row, pictures));
    return reply;
  }

  Evaluate::Reply evaluate(const Evaluate::Request& r) const {
    Pictures pictures(arrays_);
    const Value value = names_.evaluate(r.text, r.home, std::ref(pictures));
    return {value.type, numbers_of(value)};
  }

  Changes::Reply changes(const Changes::Request& r) const {
    Changes::Reply reply{{}, names_.version()};
    for (const NameRow& row : names_.changes(r.since)) reply.names.push_back(state_of(row));
    return reply;
  }

  Watch::Reply watch(const Watch::Request& r, ConnectionId connection) {
    watches_[connection].insert(fold(r.prefix));
    return {names_.version()};
  }

  void unwatch(const Unwatch::Request& r, ConnectionId connection) {
    watches_[connection].erase(fold(r.prefix));
  }

  void end(ConnectionId connection) {
    leases_.end(connection);
    arrays_.end(connection);
    watches_.erase(connection);
  }

  ArrayTable& arrays() { return arrays_; }

 private:
  void refuse_outside(const Bind::Bound& bound) const {
    const auto count = static_cast<int64_t>(arrays_.find(bound.array).values().size());
    const auto steps = static_cast<int64_t>(width_of(bound.type)) - 1;
    const auto inside = [&](int64_t element) { return element >= 1 && element < count; };
    const bool near = bound.stride >= -count && bound.stride <= count;  // so that nothing below overflows
    if (inside(bound.element) && near && inside(bound.element + steps * bound.stride)) return;
    throw Error(
        Code::bad_shape,
        fmt::format("`{}` would lie outside `{}`, which has {} elements", bound.name, bound.array, count),
        bound.name, "element 0 is the counter; give elements behind it");
  }

  NameState with_value(const NameRow& row, Pictures& pictures) const {
    NameState state = state_of(row);
    if (row.kind == NameRow::Kind::removed) return state;
    try {
      state.values = numbers_of(names_.value(row.name, std::ref(pictures)));
    } catch (const Error&) {
      state.values.clear();  // a value that waits for a program to run is told by its absence
    }
    return state;
  }

  // Notifies whoever watches a name that changed, once a name.
  Changed tell(const std::vector<NameRow>& rows) {
    Changed reply{names_.version(), {}};
    Pictures pictures(arrays_);
    for (const NameRow& row : rows) {
      reply.changed.push_back(row.name);
      for (const auto& [connection, prefixes] : watches_) {
        const auto covers = [&](const std::string& prefix) { return is_within(row.name, prefix); };
        if (std::none_of(prefixes.begin(), prefixes.end(), covers)) continue;
        const NameState state = with_value(row, pictures);
        service_.notify(connection, rpc::codec<NameChanged>(), &state);
      }
    }
    return reply;
  }

  rpc::Service& service_;
  std::unique_ptr<Store> store_;
  Names names_;
  Leases leases_;
  ArrayTable arrays_;
  std::map<ConnectionId, std::set<std::string>> watches_;
};

void add_services(rpc::Service& service, const std::shared_ptr<Registry>& r) {
  service
      .on<rpc::Register>([r](const auto& request, Call& call) {
        r->enter(request, call.connection());
        return Nothing{};
      })
      .on<rpc::Lookup>([r](const auto& request) { return r->lookup(request); })
      .on<List>([r](const auto&) { return r->list(); });
}

void add_names(rpc::Service& service, const std::shared_ptr<Registry>& r) {
  service.on<Define>([r](const auto& request) { return r->define(request); })
      .on<Set>([r](const auto& request) { return r->set(request); })
      .on<Remove>([r](const auto& request) { return r->remove(request); })
      .on<Get>([r](const auto& request) { return r->get(request); })
      .on<Evaluate>([r](const auto& request) { return r->evaluate(request); })
      .on<Changes>([r](const auto& request) { return r->changes(request); })
      .on<Bind>([r](const auto& request) { return r->bind(request); })
      .on<Watch>([r](const auto& request, Call& call) { return r->watch(request, call.connection()); })
      .on<Unwatch>([r](const auto& request, Call& call) {
        r->unwatch(request, call.connection());
        return Nothing{};
      });
}

void add_arrays(rpc::Service& service, const std::shared_ptr<Registry>& r) {
  service
      .on<rpc::ArrayCreate>([r](const auto& request, Call& call) {
        const SharedArray& array = r->arrays().create(request.name, request.shape, call.connection());
        call.send_descriptor(array.descriptor());
        return rpc::ArrayCreate::Reply{array.shape()};
      })
      .on<rpc::ArrayOpen>([r](const auto& request, Call& call) {
        const SharedArray& array = r->arrays().find(request.name);
        call.send_descriptor(array.descriptor());
        return rpc::ArrayOpen::Reply{array.shape()};
      })
      .on<rpc::ArrayAdopt>([r](const auto& request, Call& call) {
        r->arrays().adopt(request.name, request.shape, call.take_descriptor(), call.connection());
        return Nothing{};
      })
      .on<ArrayRelease>([r](const auto& request) {
        r->arrays().release(request.name);
        return Nothing{};
      })
      .on<ArrayList>([r](const auto&) { return r->arrays().list(); });
}

}  // namespace

void fill_table(rpc::Service& service, rpc::Suite&) {
  fill_table_with_store(service, {});
}

void fill_table_with_store(rpc::Service& service, const std::filesystem::path& file) {
  const auto registry = std::make_shared<Registry>(service, file);
  add_services(service, registry);
  add_names(service, registry);
  add_arrays(service, registry);
  service.on_disconnect = [registry](ConnectionId connection) { registry->end(connection); };
}

}  // namespace animado::interexpserv
