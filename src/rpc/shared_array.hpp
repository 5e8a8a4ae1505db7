// Numbers that several processes see at once: a memory file of a sealed size, mapped. A seal means that no
// peer can shrink it under another, so that a mapping which was checked once can be read without fear of
// SIGBUS.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "rpc/channel.hpp"
#include "rpc/unique_fd.hpp"

namespace animado::rpc {

// One array, mapped while this lives.
class SharedArray {
 public:
  // A memory file of that many zeros with its size sealed. Throws Code::limit when there is no memory for it.
  static UniqueFd make(std::string_view name, const std::vector<int64_t>& shape);
  // Maps a descriptor that came from someone else. Throws bad_shape when it is not sealed or does not hold
  // what the shape asks for.
  SharedArray(UniqueFd fd, std::vector<int64_t> shape, std::string_view name);
  SharedArray(SharedArray&& other) noexcept;
  SharedArray& operator=(SharedArray&&) = delete;
  ~SharedArray();

  std::span<double> values() const { return values_; }
  const std::vector<int64_t>& shape() const { return shape_; }
  int descriptor() const { return fd_.get(); }

 private:
  UniqueFd fd_;
  std::vector<int64_t> shape_;
  std::span<double> values_;
};

// The arrays that this process has made or opened, by name. The one who makes an array picks a name that is
// used once, so a mapping never goes stale. Spans stay valid for the arrays made here until they are dropped,
// and for those opened until kMaxOpened others have been opened.
class SharedArrays {
 public:
  static constexpr size_t kMaxOpened =
      64;  // a request names 4 at most; old runs' arrays should not stay mapped for ever

  explicit SharedArrays(Channel& interexpserv) : interexpserv_(interexpserv) {}

  SharedArray& create(const std::string& name, const std::vector<int64_t>& shape);
  SharedArray& open(const std::string& name);
  void drop(const std::string& name);  // unmaps it here

  // Those made here, by name: what an interexpserv that was restarted gets back.
  const std::map<std::string, SharedArray, std::less<>>& made() const { return made_; }

 private:
  struct Opened {
    SharedArray array;
    uint64_t last_use;
  };
  Channel& interexpserv_;
  std::map<std::string, SharedArray, std::less<>> made_;
  std::map<std::string, Opened, std::less<>> opened_;
  uint64_t uses_ = 0;
};

}  // namespace animado::rpc
