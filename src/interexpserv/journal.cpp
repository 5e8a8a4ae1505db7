#include "interexpserv/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/error.hpp"

namespace animado::interexpserv {
namespace {

constexpr size_t kHead = 2 * sizeof(uint32_t);

// FNV-1a, 32 bits: tells a frame from what a crash left, not from malice.
uint32_t checksum(std::string_view bytes) {
  uint32_t sum = 2166136261u;
  for (const char byte : bytes) sum = (sum ^ static_cast<uint8_t>(byte)) * 16777619u;
  return sum;
}

template <class T>
void put(std::string& out, T value) {
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void put(std::string& out, const std::string& text) {
  put(out, static_cast<uint32_t>(text.size()));
  out += text;
}

void put(std::string& out, const NamedRevision& named) {
  const Revision& r = named.revision;
  put(out, static_cast<uint8_t>(r.kind));
  put(out, static_cast<uint8_t>(r.type));
  for (const int64_t number : {r.binding.element, r.binding.stride, r.version, r.time_us}) put(out, number);
  for (const std::string* text : {&named.name, &r.text, &r.binding.array, &r.who}) put(out, *text);
}

// Takes values from the front of bytes whose checksum was right.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}
  bool at_end() const { return bytes_.empty(); }

  NamedRevision revision() {
    NamedRevision named;
    Revision& r = named.revision;
    r.kind = static_cast<Revision::Kind>(number<uint8_t>());
    r.type = static_cast<Type>(number<uint8_t>());
    for (int64_t* value : {&r.binding.element, &r.binding.stride, &r.version, &r.time_us})
      *value = number<int64_t>();
    for (std::string* text : {&named.name, &r.text, &r.binding.array, &r.who})
      *text = take(number<uint32_t>());
    return named;
  }

 private:
  template <class T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view take(size_t count) {
    assert(count <= bytes_.size());
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }

  std::string_view bytes_;
};

}  // namespace

Journal::Journal(const std::filesystem::path& file)
    : file_(file), fd_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
  if (fd_ < 0) fail("open");
  if (::flock(fd_, LOCK_EX | LOCK_NB) != 0) {
    ::close(fd_);
    throw Error(Code::conflict, "another process keeps its names there", file_.string(),
                "end it first, or give another file to --store");
  }
}

Journal::~Journal() {
  ::close(fd_);
}

std::vector<NamedRevision> Journal::read() const {
  std::string bytes(static_cast<size_t>(std::filesystem::file_size(file_)), '\0');
  const ssize_t count = ::pread(fd_, bytes.data(), bytes.size(), 0);
  if (count < 0) fail("read");
  std::string_view rest(bytes.data(), static_cast<size_t>(count));
  std::vector<NamedRevision> revisions;
  while (rest.size() >= kHead) {
    uint32_t head[2];
    std::memcpy(head, rest.data(), kHead);
    rest.remove_prefix(kHead);
    if (head[0] > rest.size() || checksum(rest.substr(0, head[0])) != head[1]) break;
    for (Reader reader(rest.substr(0, head[0])); !reader.at_end();) revisions.push_back(reader.revision());
    rest.remove_prefix(head[0]);
  }
  return revisions;
}

void Journal::append(std::span<const NamedRevision> transaction) {
  frame_.assign(kHead, '\0');
  for (const NamedRevision& revision : transaction) put(frame_, revision);
  const std::string_view payload = std::string_view(frame_).substr(kHead);
  const uint32_t head[2] = {static_cast<uint32_t>(payload.size()), checksum(payload)};
  std::memcpy(frame_.data(), head, kHead);
  const ssize_t written = ::pwrite(fd_, frame_.data(), frame_.size(), size_);
  if (written != static_cast<ssize_t>(frame_.size())) fail("write");
  size_ += written;
}

void Journal::clear() {
  if (::ftruncate(fd_, 0) != 0) fail("empty");
  size_ = 0;
}

void Journal::fail(std::string_view doing) const {
  throw Error(Code::unavailable, fmt::format("cannot {}: {}", doing, std::strerror(errno)), file_.string(),
              "see that its folder exists, can be written and has room");
}

}  // namespace animado::interexpserv
