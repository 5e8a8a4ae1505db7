// Pictures → MP4, by the program ffmpeg, which reads them from a pipe. The film has a hidden name until it is
// whole: who is interrupted leaves none.
#pragma once

#include <sys/types.h>

#include <filesystem>

#include "visao/picture.hpp"

namespace animado::visao {

class Encoder {
 public:
  // Throws Error(unavailable) with the command that installs ffmpeg where it is missing.
  Encoder(std::filesystem::path file, Size size, int frames_a_second);
  ~Encoder();  // without finish(): no film
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  void add(const Picture& picture);  // all of one size; throws Error(unavailable), as does finish()
  void finish();

 private:
  void start(Size size, int frames_a_second);
  void close_pipe();
  int wait();  // for ffmpeg: what it returned, or 128 + the signal that killed it

  std::filesystem::path file_, partial_;
  int pipe_ = -1;
  pid_t process_ = -1;
};

}  // namespace animado::visao
