#include "controle/results/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.hpp"

namespace animado::controle {
namespace {

constexpr size_t kBufferBytes = size_t{1} << 18;  // a few system calls a megabyte

}  // namespace

OutputFile::OutputFile(std::filesystem::path path)
    : path_(std::move(path)),
      descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) fail("create");
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::write(std::string_view bytes) {
  buffer_ += bytes;
  if (buffer_.size() >= kBufferBytes) flush();
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("write");
    rest.remove_prefix(static_cast<size_t>(written));
  }
  buffer_.clear();
}

void OutputFile::close() {
  flush();
  // EINVAL: what cannot be synced, as a pipe, keeps nothing that could be lost.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail("write");
  if (::close(std::exchange(descriptor_, -1)) != 0) fail("close");
}

void OutputFile::fail(std::string_view action) const {
  const int cause = errno;
  throw Error(Code::unavailable, fmt::format("cannot {}: {}", action, std::strerror(cause)), path_.string(),
              cause == ENOSPC || cause == EDQUOT ? "free space on the disk, or write to another one"
                                                 : "write to a folder that exists and takes new files");
}

void write_whole(const std::filesystem::path& path, std::string_view text) {
  std::error_code unknown;
  const bool replaces = std::filesystem::is_regular_file(path, unknown);
  // What is there and no file, as a terminal or a pipe, stays what it is.
  const bool in_place = !replaces && std::filesystem::exists(path, unknown);
  const std::filesystem::path written = in_place ? path.string() : path.string() + ".part";
  OutputFile file(written);
  try {
    file.write(text);
    file.close();
    if (in_place) return;
    std::error_code failed;
    std::filesystem::rename(written, path, failed);
    if (failed) throw Error(Code::unavailable, failed.message(), path.string(), "write to another folder");
  } catch (const Error&) {
    if (!in_place) std::filesystem::remove(written, unknown);
    throw;
  }
}

}  // namespace animado::controle
