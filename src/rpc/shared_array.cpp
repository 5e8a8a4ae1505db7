#include "rpc/shared_array.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/error.hpp"
#include "rpc/common.hpp"

namespace animado::rpc {
namespace {

constexpr int kSeals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;
constexpr int64_t kMaxBytes = int64_t{1} << 40;

// The bytes of an array; throws bad_shape when the shape cannot be.
size_t bytes_of(const std::vector<int64_t>& shape, std::string_view name) {
  int64_t bytes = sizeof(double);
  for (int64_t extent : shape) {
    if (extent < 0 || (extent > 0 && bytes > kMaxBytes / extent)) {
      throw Error(Code::bad_shape, fmt::format("an array cannot have shape ({})", fmt::join(shape, ", ")),
                  std::string(name), "give extents that are not negative and ask for less than 1 TiB");
    }
    bytes *= extent;
  }
  return static_cast<size_t>(bytes);
}

[[noreturn]] void refuse_memory(std::string_view name, size_t bytes) {
  throw Error(Code::limit, fmt::format("no shared memory for {} bytes: {}", bytes, std::strerror(errno)),
              std::string(name), "ask for less, or free memory");
}

}  // namespace

UniqueFd SharedArray::make(std::string_view name, const std::vector<int64_t>& shape) {
  const size_t bytes = bytes_of(shape, name);
  UniqueFd fd(memfd_create("animado-array", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!fd || ftruncate(fd.get(), static_cast<off_t>(bytes)) != 0 ||
      fcntl(fd.get(), F_ADD_SEALS, kSeals) != 0) {
    refuse_memory(name, bytes);
  }
  return fd;
}

SharedArray::SharedArray(UniqueFd fd, std::vector<int64_t> shape, std::string_view name)
    : fd_(std::move(fd)), shape_(std::move(shape)) {
  const size_t bytes = bytes_of(shape_, name);
  const int seals = fcntl(fd_.get(), F_GET_SEALS);
  struct stat status {};
  if (seals < 0 || (seals & kSeals) != kSeals || fstat(fd_.get(), &status) != 0 ||
      status.st_size != static_cast<off_t>(bytes)) {
    throw Error(Code::bad_shape, fmt::format("this is not a sealed memory file of {} bytes", bytes),
                std::string(name),
                "hand over the descriptor that array_create gave, with the shape it was made with");
  }
  if (bytes == 0) return;
  void* pages = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, fd_.get(), 0);
  if (pages == MAP_FAILED) refuse_memory(name, bytes);
  values_ = {static_cast<double*>(pages), bytes / sizeof(double)};
}

SharedArray::SharedArray(SharedArray&& other) noexcept
    : fd_(std::move(other.fd_)), shape_(std::move(other.shape_)), values_(std::exchange(other.values_, {})) {}

SharedArray::~SharedArray() {
  if (!values_.empty()) munmap(values_.data(), values_.size_bytes());
}

SharedArray& SharedArrays::create(const std::string& name, const std::vector<int64_t>& shape) {
  interexpserv_.call<ArrayCreate>({name, shape});
  SharedArray array(interexpserv_.take_descriptor(), shape, name);
  const auto [at, added] = made_.emplace(name, std::move(array));
  if (!added)
    throw Error(Code::conflict, "this process made an array of that name before", name, "use a name once");
  return at->second;
}

SharedArray& SharedArrays::open(const std::string& name) {
  if (const auto made = made_.find(name); made != made_.end()) return made->second;
  auto found = opened_.find(name);
  if (found == opened_.end()) {
    const auto reply = interexpserv_.call<ArrayOpen>({name});
    SharedArray array(interexpserv_.take_descriptor(), reply.shape, name);
    if (opened_.size() == kMaxOpened) {
      const auto older = [](const auto& a, const auto& b) { return a.second.last_use < b.second.last_use; };
      opened_.erase(std::min_element(opened_.begin(), opened_.end(), older));
    }
    found = opened_.emplace(name, Opened{std::move(array), 0}).first;
  }
  found->second.last_use = ++uses_;
  return found->second.array;
}

void SharedArrays::drop(const std::string& name) {
  made_.erase(name);
  opened_.erase(name);
}

}  // namespace animado::rpc
