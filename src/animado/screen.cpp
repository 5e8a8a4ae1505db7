#include "animado/screen.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "console/terminal.hpp"

namespace animado {

namespace {

constexpr auto kEnter = "\x1b[?1049h\x1b[?25l";  // the alternate screen, no cursor
constexpr auto kLeave = "\x1b[?25h\x1b[?1049l";

// A signal handler reaches nothing but globals. SIGINT comes as a key: the terminal is told so.
volatile sig_atomic_t g_ended = 0;
void on_signal(int) {
  g_ended = 1;
}

// The lines erase what is left of those before (ESC[K), and the page what is left of a longer one (ESC[J).
std::string page_text(std::string_view page) {
  std::string text = "\x1b[H";
  for (const char c : page) text += c == '\n' ? "\x1b[K\r\n" : std::string(1, c);
  return text + "\x1b[J";
}

}  // namespace

bool Screen::is_possible() {
  return is_terminal(STDIN_FILENO) && is_terminal(STDOUT_FILENO);
}

Screen::Screen() {
  tcgetattr(STDIN_FILENO, &before_);
  termios raw = before_;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG);
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  struct sigaction action {};
  action.sa_handler = on_signal;  // without SA_RESTART: it ends the poll
  for (const int signal : {SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  fmt::print("{}", kEnter);
}

Screen::~Screen() {
  fmt::print("{}", kLeave);
  std::fflush(stdout);
  tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

void Screen::draw(std::string_view page) {
  fmt::print("{}", page_text(page));
  std::fflush(stdout);
}

bool Screen::wait(double time_s) {
  using Clock = std::chrono::steady_clock;
  constexpr char kCtrlC = 3;
  const auto end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time_s));
  while (!g_ended) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
    if (left <= 0) return true;
    pollfd keyboard{STDIN_FILENO, POLLIN, 0};
    if (poll(&keyboard, 1, static_cast<int>(left)) <= 0) continue;
    char key = 0;
    if (read(STDIN_FILENO, &key, 1) != 1 || key == 'q' || key == 'Q' || key == kCtrlC) return false;
  }
  return false;
}

}  // namespace animado
