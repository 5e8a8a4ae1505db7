// A terminal as a page that is drawn again and again. What was there before comes back at the end, however
// that comes: by a key, an error or Ctrl-C.
#pragma once

#include <termios.h>

#include <string_view>

namespace animado {

class Screen {
 public:
  static bool is_possible();  // stdin and stdout are a terminal
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  void draw(std::string_view page);  // in the place of the last one
  // Waits that long. False when the user wants to leave: q, Ctrl-C, SIGTERM, or the terminal is gone.
  bool wait(double time_s);

 private:
  termios before_{};
};

}  // namespace animado
