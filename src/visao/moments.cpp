#include "visao/moments.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/error.hpp"

namespace animado::visao {

namespace {

using controle::RecordedRun;

std::optional<size_t> number_of(std::string_view text) {
  size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw Error(Code::bad_params, fmt::format("`{}`: {}", text, why), "--frames",
              "give a number of frames (12), some of them (3,5,8) or all from one to another (10..20)");
}

size_t frame_named(std::string_view word, const std::string& text, size_t frames) {
  const auto number = number_of(word);
  if (!number) refuse(text, fmt::format("`{}` is not a frame's number", word));
  if (*number >= frames) refuse(text, fmt::format("the frames of this run are 0 to {}", frames - 1));
  return *number;
}

std::vector<size_t> listed(const std::string& text, size_t frames) {
  std::vector<size_t> found;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    found.push_back(frame_named(std::string_view(text).substr(begin, end - begin), text, frames));
    begin = end + 1;
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

std::vector<size_t> even_frames(size_t frames, size_t wanted) {
  std::vector<size_t> chosen;
  const size_t count = std::min(frames, wanted);
  for (size_t k = 0; k < count; ++k) {
    const size_t gaps = std::max<size_t>(count - 1, 1);
    chosen.push_back((k * (frames - 1) + gaps / 2) / gaps);
  }
  return chosen;
}

std::vector<size_t> named_frames(const std::string& text, size_t frames) {
  const size_t dots = text.find("..");
  if (dots != std::string::npos) {
    const size_t first = frame_named(std::string_view(text).substr(0, dots), text, frames);
    const size_t last = frame_named(std::string_view(text).substr(dots + 2), text, frames);
    if (first > last) refuse(text, "its first frame comes after its last");
    std::vector<size_t> found;
    for (size_t frame = first; frame <= last; ++frame) found.push_back(frame);
    return found;
  }
  if (text.find(',') != std::string::npos) return listed(text, frames);
  const auto wanted = number_of(text);
  if (!wanted || *wanted == 0) refuse(text, "this names no frames");
  return even_frames(frames, *wanted);
}

std::vector<Pose> poses_at_frame(const RecordedRun& run, size_t frame) {
  std::vector<Pose> poses;
  for (size_t body = 0; body < run.bodies.size(); ++body) poses.push_back(run.at(frame, body).pose);
  return poses;
}

std::vector<Pose> poses_at(const RecordedRun& run, double time_s) {
  const auto after = std::ranges::upper_bound(run.times_s, time_s);
  if (after == run.times_s.begin()) return poses_at_frame(run, 0);
  if (after == run.times_s.end()) return poses_at_frame(run, run.frames() - 1);
  const auto next = static_cast<size_t>(after - run.times_s.begin());
  const double part = (time_s - run.times_s[next - 1]) / (run.times_s[next] - run.times_s[next - 1]);
  std::vector<Pose> poses = poses_at_frame(run, next - 1);
  for (size_t body = 0; body < poses.size(); ++body) {
    const Pose& end = run.at(next, body).pose;
    poses[body].position_m += part * (end.position_m - poses[body].position_m);
    poses[body].orientation = poses[body].orientation.slerp(part, end.orientation);
  }
  return poses;
}

}  // namespace animado::visao
