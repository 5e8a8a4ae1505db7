// Joins the registry, the leases and the shared arrays to their messages. One request at a time: nothing here
// is locked.
#include "interexpserv/server.hpp"

#include <fmt/chrono.h>

#include <chrono>

#include "interexpserv/leases.hpp"
#include "interexpserv/names.hpp"
#include "interexpserv/protocol.hpp"
#include "interexpserv/server.arrays.hpp"
#include "interexpserv/store.hpp"
#include "interexpserv/watches.hpp"

namespace animado::interexpserv {
namespace {

using rpc::Call;

std::string utc_text(int64_t time_us) {
  return fmt::format("{:%FT%TZ}", fmt::gmtime(static_cast<std::time_t>(time_us / 1'000'000)));
}

int64_t now_us() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

Terms terms_of(const Call& call, std::span<const Expected> expected = {}) {
  Terms terms{std::string(call.client()), now_us(), {}};
  for (const auto& [name, version] : expected) terms.expected.push_back({name, version});
  return terms;
}

NameState state_of(const NameRow& row) {
  return {row.name, row.text, static_cast<Kind>(row.kind), row.type, row.version, {}};
}

std::vector<double> numbers_of(const Value& value) {
  return {value.v.begin(), value.v.begin() + static_cast<ptrdiff_t>(width_of(value.type))};
}

class Registry {
 public:
  Registry(rpc::Service& service, const std::filesystem::path& file) : service_(service) {
    service.on_drained = [this](ConnectionId connection) { tell_what_was_lost(connection); };
    if (file.empty()) return;
    store_ = std::make_unique<Store>(file);
    names_ = Names([this](std::span<const NamedRevision> revisions) { store_->commit(revisions); });
    names_.load(store_->load());
  }

  void enter(const rpc::Register::Request& r, ConnectionId connection) {
    leases_.grant({r.name, r.socket, r.version, utc_text(now_us()), r.pid, connection});
  }

  rpc::Lookup::Reply lookup(const rpc::Lookup::Request& r) {
    const Lease& lease = leases_.take_turn(r.name);
    return {lease.socket, lease.version, lease.pid};
  }

  List::Reply list() const {
    List::Reply reply;
    for (const Lease& l : leases_.list())
      reply.services.push_back({l.name, l.socket, l.version, l.since, l.pid, l.restarts});
    return reply;
  }

  Changed define(const Define::Request& r, const Call& call) {
    std::vector<NamedText> definitions;
    for (const auto& [name, text] : r.definitions) definitions.push_back({name, text});
    return tell(names_.define(definitions, terms_of(call, r.expected)));
  }

  Changed set(const Set::Request& r, const Call& call) {
    Terms terms = terms_of(call);
    if (r.expected) terms.expected = {{r.name, *r.expected}};
    return tell(names_.define(std::array{NamedText{r.name, r.text}}, terms));
  }

  Changed remove(const Remove::Request& r, const Call& call) {
    return tell(names_.remove(r.names, terms_of(call, r.expected)));
  }

  Changed bind(const Bind::Request& r, const Call& call) {
    std::vector<NamedBinding> bindings;
    for (const Bind::Bound& bound : r.names) {
      refuse_outside(bound);
      bindings.push_back({bound.name, bound.type, {bound.array, bound.element, bound.stride}});
    }
    return tell(names_.bind(bindings, terms_of(call)));
  }

  History::Reply history(const History::Request& r) const {
    History::Reply reply;
    for (const Revision& revision : names_.history(r.name)) {
      reply.revisions.push_back({revision.version, utc_text(revision.time_us), revision.who,
                                 revision.text.empty() ? revision.binding.array : revision.text,
                                 static_cast<Kind>(revision.kind)});
    }
    return reply;
  }

  Snapshot::Reply snapshot(const Snapshot::Request& r) const {
    Snapshot::Reply reply{names_.version(), {}, {}};
    for (auto& [name, text] : names_.definitions(r.prefix)) {
      reply.names.push_back(std::move(name));
      reply.texts.push_back(std::move(text));
    }
    return reply;
  }

  Restore::Reply restore(const Restore::Request& r, const Call& call) {
    if (r.names.size() != r.texts.size()) {
      throw Error(Code::bad_params, fmt::format("{} names and {} texts", r.names.size(), r.texts.size()),
                  "restore.texts", "give each name its expression, as snapshot does");
    }
    std::vector<NamedText> definitions;
    for (size_t i = 0; i < r.names.size(); ++i) definitions.push_back({r.names[i], r.texts[i]});
    const Changed done = tell(names_.replace(definitions, folded_prefix(r.prefix), terms_of(call)));
    return {done.version, static_cast<int64_t>(done.changed.size())};
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
    watches_.add(connection, folded_prefix(r.prefix));
    return {names_.version(), watches_.sequence()};
  }

  void unwatch(const Unwatch::Request& r, ConnectionId connection) {
    watches_.remove(connection, folded_prefix(r.prefix));
  }

  void end(ConnectionId connection) {
    leases_.end(connection);
    arrays_.end(connection);
    watches_.end(connection);
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

  // Tells whoever watches a name that changed. Its value is computed, and the message packed, for the first
  // of them; the others get the same bytes.
  Changed tell(const std::vector<NameRow>& rows) {
    Changed reply{names_.version(), {}};
    Pictures pictures(arrays_);
    for (const NameRow& row : rows) {
      reply.changed.push_back(row.name);
      std::string message;
      watches_.tell(row.name, row.version, [&](ConnectionId connection) {
        if (message.empty())
          message = rpc::notification<NameChanged>({with_value(row, pictures), watches_.sequence()});
        return service_.post(connection, message) == rpc::Service::Delivery::sent;
      });
    }
    return reply;
  }

  void tell_what_was_lost(ConnectionId connection) {
    const auto gap = watches_.caught_up(connection);
    if (!gap) return;
    const FellBehind::Request lost{gap->first_lost, watches_.sequence(), gap->since, names_.version()};
    service_.notify(connection, rpc::codec<FellBehind>(), &lost);
  }

  rpc::Service& service_;
  std::unique_ptr<Store> store_;
  Names names_;
  Leases leases_;
  ArrayTable arrays_;
  Watches watches_;
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
  service.on<Define>([r](const auto& request, Call& call) { return r->define(request, call); })
      .on<Set>([r](const auto& request, Call& call) { return r->set(request, call); })
      .on<Remove>([r](const auto& request, Call& call) { return r->remove(request, call); })
      .on<Get>([r](const auto& request) { return r->get(request); })
      .on<Evaluate>([r](const auto& request) { return r->evaluate(request); })
      .on<Changes>([r](const auto& request) { return r->changes(request); })
      .on<History>([r](const auto& request) { return r->history(request); })
      .on<Snapshot>([r](const auto& request) { return r->snapshot(request); })
      .on<Restore>([r](const auto& request, Call& call) { return r->restore(request, call); })
      .on<Bind>([r](const auto& request, Call& call) { return r->bind(request, call); })
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
