#include "rpc/mailbox.hpp"

#include <fmt/format.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/error.hpp"

namespace animado::rpc {
namespace {

constexpr std::string_view kName = "mailbox";
const std::vector<int64_t> kShape{2 * 4096 / sizeof(double)};

UniqueFd make_bell() {
  UniqueFd bell(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC));
  if (!bell)
    throw Error(Code::limit, fmt::format("no bell: {}", std::strerror(errno)), std::string(kName),
                "close files, or raise ulimit -n");
  return bell;
}

}  // namespace

Mailbox Mailbox::make() {
  return {Side::server, SharedArray::make(kName, kShape), make_bell(), make_bell()};
}

Mailbox Mailbox::open(std::vector<UniqueFd> descriptors) {
  if (descriptors.size() != 3)
    throw Error(Code::bad_shape, fmt::format("{} descriptors came in place of 3", descriptors.size()),
                std::string(kName), "hand over those that the reply to mailbox brings");
  return {Side::client, std::move(descriptors[0]), std::move(descriptors[2]), std::move(descriptors[1])};
}

Mailbox::Mailbox(Side side, UniqueFd memory, UniqueFd own_bell, UniqueFd other_bell)
    : memory_(std::move(memory), kShape, kName),
      own_bell_(std::move(own_bell)),
      other_bell_(std::move(other_bell)) {
  auto* const slots = reinterpret_cast<Slot*>(memory_.values().data());
  in_ = slots + (side == Side::server ? 0 : 1);
  out_ = slots + (side == Side::server ? 1 : 0);
  taken_ = in_->number.load(std::memory_order_acquire);
  put_ = out_->number.load(std::memory_order_relaxed);
}

std::array<int, 3> Mailbox::descriptors() const {
  return {memory_.descriptor(), own_bell_.get(), other_bell_.get()};
}

bool Mailbox::put(std::string_view letter) {
  if (letter.size() > kRoom) return false;
  std::memcpy(out_->bytes, letter.data(), letter.size());
  out_->size.store(static_cast<uint32_t>(letter.size()), std::memory_order_relaxed);
  // Either the other side sees the letter before it sleeps, or we see that it sleeps: these two and those in
  // fall_asleep() have one order, as all have that are sequentially consistent.
  out_->number.store(++put_);
  if (out_->awake.load() != 0) return true;
  const uint64_t one = 1;
  // Full only when somebody else wrote 2⁶⁴ − 2 into it: who waits for this letter then hears of it when its
  // time is over.
  [[maybe_unused]] const auto written = ::write(other_bell_.get(), &one, sizeof one);
  return true;
}

std::optional<size_t> Mailbox::take(char* into) {
  taken_ = in_->number.load(std::memory_order_acquire);
  const size_t size = in_->size.load(std::memory_order_relaxed);
  if (size > kRoom) return {};
  std::memcpy(into, in_->bytes, size);
  return size;
}

}  // namespace animado::rpc
