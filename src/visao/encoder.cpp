#include "visao/encoder.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "base/error.hpp"

namespace animado::visao {

namespace {

// Its own process group: Ctrl-C is for us, who then say what becomes of the film.
pid_t spawn(std::vector<std::string> words, int input) {
  std::vector<char*> raw;
  for (std::string& word : words) raw.push_back(word.data());
  raw.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, STDERR_FILENO, STDOUT_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = -1;
  const int error = posix_spawnp(&process, raw[0], &files, &attributes, raw.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (error == 0) return process;
  throw Error(Code::unavailable, fmt::format("cannot start ffmpeg: {}", std::strerror(error)), "--mp4",
              "films are made by ffmpeg: sudo apt-get install ffmpeg");
}

}  // namespace

Encoder::Encoder(std::filesystem::path file, Size size, int frames_a_second)
    : file_(std::move(file)),
      partial_(file_.parent_path() / fmt::format(".{}.partial-{}", file_.filename().string(), getpid())) {
  start(size, frames_a_second);
}

void Encoder::start(Size size, int frames_a_second) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error(Code::unavailable, "no pipe to ffmpeg");
  pipe_ = ends[1];
  try {
    process_ = spawn({"ffmpeg",
                      "-nostdin",
                      "-hide_banner",
                      "-loglevel",
                      "error",
                      "-y",  //
                      "-f",
                      "rawvideo",
                      "-pix_fmt",
                      "rgb24",  //
                      "-video_size",
                      fmt::format("{}x{}", size.width_px, size.height_px),  //
                      "-framerate",
                      std::to_string(frames_a_second),
                      "-i",
                      "pipe:0",  //
                      "-vf",
                      "scale=out_color_matrix=bt709:out_range=tv",  //
                      "-colorspace",
                      "bt709",
                      "-color_primaries",
                      "bt709",
                      "-color_trc",
                      "bt709",  //
                      "-c:v",
                      "libx264",
                      "-preset",
                      "fast",
                      "-crf",
                      "18",
                      "-pix_fmt",
                      "yuv420p",  //
                      "-movflags",
                      "+faststart",
                      "-f",
                      "mp4",
                      partial_.string()},
                     ends[0]);
  } catch (const Error&) {
    close(ends[0]);
    close_pipe();
    throw;
  }
  close(ends[0]);
}

Encoder::~Encoder() {
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  close_pipe();
  wait();
  std::error_code ignored;  // it may not have been there yet
  std::filesystem::remove(partial_, ignored);
}

void Encoder::add(const Picture& picture) {
  const uint8_t* bytes = picture.bytes();
  size_t left =
      3 * static_cast<size_t>(picture.size().width_px) * static_cast<size_t>(picture.size().height_px);
  while (left > 0) {
    const ssize_t written = write(pipe_, bytes, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      throw Error(Code::unavailable, "ffmpeg takes no more pictures", file_.string(),
                  "what it said stands above; is the disk full?");
    }
    bytes += written;
    left -= static_cast<size_t>(written);
  }
}

void Encoder::finish() {
  close_pipe();
  const int status = wait();
  std::error_code failure;
  if (status == 0) std::filesystem::rename(partial_, file_, failure);
  if (status == 0 && !failure) return;
  std::error_code ignored;  // the reason for the lost film is told below
  std::filesystem::remove(partial_, ignored);
  throw Error(Code::unavailable,
              status != 0 ? fmt::format("ffmpeg ended with status {}", status)
                          : "cannot name the film: " + failure.message(),
              file_.string(), "the film can be made again: animado render DIR --mp4");
}

void Encoder::close_pipe() {
  if (pipe_ >= 0) close(pipe_);
  pipe_ = -1;
}

int Encoder::wait() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace animado::visao
