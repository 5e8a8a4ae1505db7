#include "interexpserv/server.arrays.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "base/error.hpp"
#include "base/nearest_name.hpp"
#include "interexpserv/published.hpp"

namespace animado::interexpserv {
namespace {

constexpr size_t kMaxArrays = 512;  // each holds a descriptor, and a process may open 1024
// How long an array may be under way. Writing one takes microseconds; a writer that was put aside for longer
// than this is dead, and everybody else waits.
constexpr std::chrono::milliseconds kMaxWait(100);

}  // namespace

const SharedArray& ArrayTable::create(const std::string& name, const std::vector<int64_t>& shape,
                                      ConnectionId owner) {
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

void ArrayTable::adopt(const std::string& name, const std::vector<int64_t>& shape, rpc::UniqueFd fd,
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

const SharedArray& ArrayTable::find(const std::string& name) const {
  const auto known = arrays_.find(name);
  if (known != arrays_.end()) return known->second.array;
  std::vector<std::string> names;
  for (const auto& [other, entry] : arrays_) names.push_back(other);
  const std::string near = nearest_name(name, names);
  throw Error(Code::unknown_array, fmt::format("no shared array `{}`", name), name,
              near.empty() ? "create it; the arrays of a program that ended are gone"
                           : fmt::format("did you mean `{}`?", near));
}

void ArrayTable::end(ConnectionId owner) {
  std::erase_if(arrays_, [&](const auto& entry) { return entry.second.owner == owner; });
}

ArrayList::Reply ArrayTable::list() const {
  ArrayList::Reply reply;
  for (const auto& [name, entry] : arrays_) reply.arrays.push_back({name, entry.array.shape()});
  return reply;
}

const SharedArray& ArrayTable::add(const std::string& name, SharedArray array, ConnectionId owner) {
  if (arrays_.size() == kMaxArrays) {
    throw Error(Code::limit, fmt::format("there are {} shared arrays already", kMaxArrays), name,
                "release some, or put several into one");
  }
  return arrays_.emplace(name, Entry{std::move(array), owner}).first->second.array;
}

std::span<const double> Pictures::operator()(const std::string& name) {
  const auto [at, is_new] = taken_.try_emplace(name);
  if (is_new) at->second = take(name);
  return at->second;
}

std::vector<double> Pictures::take(const std::string& name) const {
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

}  // namespace animado::interexpserv
