#include "controle/scene/read_world.hpp"

#include <array>

#include "base/fold.hpp"
#include "controle/scene/read_body.hpp"
#include "controle/scene/refusal.hpp"

namespace animado::controle {
namespace {

constexpr std::array<std::string_view, 13> kMethods = {
    "rk4",  "gill",       "rk38",      "heun3",  "midpoint", "heun",    "euler",
    "bs23", "fehlberg45", "cash_karp", "dopri5", "dop853",   "verner87"};
// Methods of fred that cannot move rigid bodies: why, and what to use instead.
struct Unfit {
  std::string_view name, reason, remedy;
};
constexpr std::string_view kNotSeparable =
    "is for separable systems: bodies that turn are none, nor are forces that depend on velocities";
constexpr std::string_view kForLongTimes = "use dop853, which keeps the energy to its `tolerance`";
constexpr std::array<Unfit, 3> kUnfit = {
    {{"symplectic_euler", kNotSeparable, kForLongTimes},
     {"verlet", kNotSeparable, kForLongTimes},
     {"radau5",
      "is implicit: it needs the derivatives of all forces by the state, which contacts do not have",
      "use dopri5 with a `tolerance`, which takes steps as short as a stiff force needs"}}};

constexpr double kMaxFrames = 1e7;  // ten gigabytes of states.csv for one body: surely a slip in `step`

struct SectionReader {
  const Outline& outline;
  const Section& section;
  const Constants& constants;

  Places places() const {
    Places all;
    for (const Entry& entry : section.entries) all.emplace(entry.property->canonical, entry.place);
    return all;
  }

  double positive(const Entry& entry) const {
    const double value = constants.number(entry.value);
    if (value <= 0)
      fail(entry.value.place, Code::refused, fmt::format("a {} of {:g}", entry.property->canonical, value),
           "it is greater than 0");
    return value;
  }

  // The position of the word in the list.
  template <size_t N>
  size_t choice(const Entry& entry, const std::array<Word, N>& words) const {
    const std::string folded = fold(entry.value.text);
    const std::string_view canonical = canonical_word(words, folded);
    for (size_t i = 0; i < N; ++i) {
      if (words[i].canonical == canonical) return i;
    }
    const std::vector<std::string> known = all_forms(words);
    std::vector<std::string> list;
    for (const Word& word : words) list.emplace_back(word.canonical);
    fail(entry.value.place, Code::unknown_name,
         fmt::format("unknown {} `{}`", entry.property->canonical, entry.value.text),
         suggestion(folded, known, "it is " + list_of(list)));
  }

  [[noreturn]] void fail(Place place, Code code, std::string message, std::string remedy) const {
    refuse(outline.path, place, code, std::move(message), std::move(remedy));
  }
};

const std::array<Word, 3>& responses() {
  static const std::array<Word, 3> words = {
      {{"impulse", {"impulso"}}, {"system15", {"sistema15"}}, {"spring", {"mola"}}}};
  return words;
}

const std::array<Word, 4>& rules() {
  static const std::array<Word, 4> words = {
      {{"product", {"produto"}}, {"min", {"minimo"}}, {"max", {"maximo"}}, {"mean", {"media"}}}};
  return words;
}

std::array<Word, kMethods.size()> methods() {
  std::array<Word, kMethods.size()> words;
  for (size_t i = 0; i < words.size(); ++i) words[i].canonical = kMethods[i];
  return words;
}

std::string read_method(const SectionReader& reader, const Entry& entry) {
  const std::string folded = fold(entry.value.text);
  for (const Unfit& method : kUnfit) {
    if (method.name != folded) continue;
    reader.fail(entry.value.place, Code::refused, fmt::format("`{}` {}", method.name, method.reason),
                std::string(method.remedy));
  }
  return std::string(kMethods[reader.choice(entry, methods())]);
}

void read_springs(const SectionReader& reader, World& world) {
  const Section& section = reader.section;
  if (const Entry* entry = section.find("spring k")) world.spring_stiffness_N_m = reader.positive(*entry);
  if (const Entry* entry = section.find("spring damping")) {
    world.spring_damping_N_s_m = number_at_least(reader.outline, *entry, reader.constants, 0);
  }
  if (world.response == Response::spring && world.spring_stiffness_N_m == 0) {
    reader.fail(section.find("response")->place, Code::refused, "`response spring` without its stiffness",
                "give `spring k`, in N/m");
  }
}

const Entry& needed(const SectionReader& reader, std::string_view canonical) {
  if (const Entry* entry = reader.section.find(canonical)) return *entry;
  const bool open = reader.section.place.line > 0;
  reader.fail(open ? reader.section.place : Place{1, 1}, Code::refused,
              fmt::format("the scene does not say its `{}` of time", canonical),
              "give `end` and `step` under a line `time`, in seconds");
}

}  // namespace

std::span<const std::string_view> known_methods() {
  return kMethods;
}

World read_world(const Outline& outline, const Constants& constants) {
  const SectionReader reader{outline, outline.world, constants};
  const Section& section = outline.world;
  World world;
  world.places = reader.places();
  if (const Entry* entry = section.find("gravity")) world.gravity_m_s2 = constants.vector(entry->value);
  if (const Entry* entry = section.find("method")) world.method = read_method(reader, *entry);
  if (const Entry* entry = section.find("substep")) world.substep_s = reader.positive(*entry);
  if (const Entry* entry = section.find("tolerance")) world.tolerance = reader.positive(*entry);
  if (const Entry* entry = section.find("response"))
    world.response = static_cast<Response>(reader.choice(*entry, responses()));
  if (const Entry* entry = section.find("restitution rule")) {
    world.restitution_rule = static_cast<RestitutionRule>(reader.choice(*entry, rules()));
  }
  if (const Entry* entry = section.find("contact threshold")) {
    world.contact_threshold_m_s = number_at_least(outline, *entry, constants, 0);
  }
  read_springs(reader, world);
  return world;
}

Time read_time(const Outline& outline, const Constants& constants) {
  const SectionReader reader{outline, outline.time, constants};
  Time time;
  time.places = reader.places();
  if (const Entry* entry = outline.time.find("start")) time.start_s = constants.number(entry->value);
  const Entry& end = needed(reader, "end");
  time.end_s = constants.number(end.value);
  const Entry& step = needed(reader, "step");
  time.step_s = reader.positive(step);
  if (time.end_s < time.start_s) {
    reader.fail(end.value.place, Code::refused,
                fmt::format("the end, {:g} s, lies before the start, {:g} s", time.end_s, time.start_s),
                "let time go forward");
  }
  if ((time.end_s - time.start_s) / time.step_s > kMaxFrames) {
    reader.fail(
        step.value.place, Code::limit, fmt::format("more than {:g} frames", kMaxFrames),
        "`step` is the time between frames; for small steps of the motion give `substep` under `world`");
  }
  return time;
}

}  // namespace animado::controle
