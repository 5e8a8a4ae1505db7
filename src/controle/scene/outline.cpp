// The grammar, line by line; blanks separate words:
//
//   line       = [ heading | opening | definition | property ] [ "#" comment ]
//   heading    = "#####" ( "OBJETOS ENVOLVIDOS" [":"] NAME { ("," | "e") NAME }
//                        | "CARACTERISTICAS DO" NAME | "CONDICOES INICIAIS DO" NAME | "TEMPO NA ANIMACAO" |
//                        "MUNDO" )
//   opening    = "object" NAME | "world" | "time"                          and their Portuguese
//   definition = NAME "." NAME { "." NAME } "=" expression
//   property   = words of the vocabulary [ "do" NAME ] [ "=" | ":" ] value
#include "controle/scene/outline.hpp"

#include <array>

#include "controle/scene/lines.hpp"
#include "controle/scene/refusal.hpp"
#include "interexpserv/functions.hpp"
#include "interexpserv/parser.hpp"

namespace animado::controle {
namespace {

constexpr std::array<std::string_view, 2> kObjectWords = {"object", "objeto"},
                                          kWorldWords = {"world", "mundo"}, kTimeWords = {"time", "tempo"};
constexpr std::array<std::string_view, 2> kInvolved = {"objetos envolvidos", "objects involved"};
constexpr std::array<std::string_view, 8> kAbout = {
    "caracteristicas do",     "caracteristicas da", "condicoes iniciais do",     "condicoes iniciais da",
    "characteristics of the", "characteristics of", "initial conditions of the", "initial conditions of"};
constexpr std::array<std::string_view, 5> kTimeHeadings = {"tempo na animacao", "tempo da animacao",
                                                           "time of the animation", "time in the animation",
                                                           "animation time"};
constexpr std::array<std::string_view, 7> kOf = {"of the", "of", "do", "da", "de", "dos", "das"};

constexpr std::string_view kBlocks = "write `object NAME`, `world` or `time` on a line of its own above it";

template <size_t N>
size_t match_any(std::string_view folded, const std::array<std::string_view, N>& phrases) {
  for (const std::string_view phrase : phrases) {
    if (const size_t length = match_phrase(folded, phrase)) return length;
  }
  return 0;
}

template <size_t N>
bool is_any(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class OutlineReader {
 public:
  explicit OutlineReader(const std::string& path) { outline_.path = path; }

  Outline run(std::string_view text) {
    const std::vector<Line> lines = lines_of(text, outline_.path);
    for (const Line& line : lines) read(line);
    for (const Definition& definition : outline_.names) check_prefix(definition);
    return std::move(outline_);
  }

 private:
  void read(const Line& line) {
    if (line.heading() < line.folded().size()) return read_heading(line);
    const size_t at = line.skip_blanks(0);
    if (at == line.folded().size() || read_opening(line, at) || read_definition(line, at)) return;
    read_property(line, at);
  }

  // --- blocks

  void read_heading(const Line& line) {
    const std::string_view text = std::string_view(line.folded()).substr(line.heading());
    if (const size_t length = match_any(text, kInvolved)) return read_involved(line, line.heading() + length);
    const std::string_view bare = text.substr(0, text.find_last_not_of(" \t#") + 1);
    if (is_any(bare, kWorldWords)) return open(Block::world, line.place(line.heading()));
    if (is_any(bare, kTimeWords) || is_any(bare, kTimeHeadings))
      return open(Block::time, line.place(line.heading()));
    if (const size_t length = match_any(text, kAbout)) {
      const size_t begin = line.skip_blanks(line.heading() + length);
      const std::string name = read_name(line, begin);
      if (is_any(name, kWorldWords)) return open(Block::world, line.place(begin));
      if (involved_ && !find_object(name)) refuse_uninvolved(line.place(begin), name);
      open_object(line, begin);
      refuse_rest(line, line.end_of_word(begin), "the object's name");
    }
  }

  void read_involved(const Line& line, size_t at) {
    at = line.skip_blanks(at);
    if (at < line.folded().size() && line.folded()[at] == ':') ++at;
    involved_ = true;
    while (true) {
      at = line.skip_blanks(at);
      open_object(line, at);
      at = line.skip_blanks(line.end_of_word(at));
      const size_t and_then =
          match_any(std::string_view(line.folded()).substr(std::min(at, line.folded().size())),
                    std::array<std::string_view, 2>{"e", "and"});
      if (and_then > 0) {
        at += and_then;
      } else if (at < line.folded().size() && line.folded()[at] == ',') {
        ++at;
      } else {
        break;
      }
    }
    refuse_rest(line, at, "the names of the objects, with commas or `e` between them");
    block_.reset();
  }

  bool read_opening(const Line& line, size_t at) {
    const std::string& folded = line.folded();
    const size_t end = line.end_of_word(at);
    const std::string_view word = std::string_view(folded).substr(at, end - at);
    if (is_any(word, kObjectWords)) {
      const size_t name = line.skip_blanks(end);
      open_object(line, name);
      refuse_rest(line, line.end_of_word(name), "the object's name");
      return true;
    }
    const size_t after = line.skip_blanks(end);
    const bool alone = after == folded.size() || (folded[after] == ':' && after + 1 == folded.size());
    if (!alone || (!is_any(word, kWorldWords) && !is_any(word, kTimeWords))) return false;
    open(is_any(word, kWorldWords) ? Block::world : Block::time, line.place(at));
    return true;
  }

  void open(Block block, Place place) {
    block_ = block;
    Section& section = here();
    if (section.place.line == 0) section.place = place;
  }

  void open_object(const Line& line, size_t at) {
    const std::string folded = read_name(line, at);
    const std::string written = line.written(at, at + folded.size());
    block_ = Block::object;
    if (const auto known = find_object(folded)) {
      object_ = *known;
      return;
    }
    object_ = outline_.objects.size();
    index_[folded] = object_;
    outline_.objects.push_back({written, folded, line.place(at), {}});
  }

  std::string read_name(const Line& line, size_t at) const {
    const size_t end = line.end_of_word(at);
    if (at >= line.folded().size() || !is_letter(line.folded()[at])) {
      refuse(outline_.path, line.place(at), Code::syntax, "expected the name of an object" + found(line, at),
             "a name is a letter and then letters, digits or _");
    }
    std::string name = line.folded().substr(at, end - at);
    const bool block_word =
        (is_any(name, kWorldWords) && line.heading() == line.folded().size()) || is_any(name, kTimeWords);
    if (block_word || interexpserv::is_reserved(name)) {
      refuse(outline_.path, line.place(at), Code::conflict,
             fmt::format("`{}` is a word of the language", name), "choose another name for the object");
    }
    return name;
  }

  // --- definitions

  bool read_definition(const Line& line, size_t at) {
    const std::string& folded = line.folded();
    size_t end = at;
    size_t dots = 0;
    while (end < folded.size() && is_letter(folded[end])) {
      end = line.end_of_word(end);
      if (end >= folded.size() || folded[end] != '.') break;
      ++end;
      ++dots;
    }
    if (end > at && folded[end - 1] != '.' && read_function(line, at, end)) return true;
    const size_t equals = line.skip_blanks(end);
    if (dots == 0 || folded[end - 1] == '.' || equals >= folded.size() || folded[equals] != '=') return false;
    define(line, at, folded.substr(at, end - at), equals + 1);
    return true;
  }

  // f(x, y) = expression: a definition whose value begins with the parameters.
  bool read_function(const Line& line, size_t at, size_t end) {
    const size_t open = line.skip_blanks(end);
    if (!interexpserv::is_function_text(line.folded().substr(std::min(open, line.folded().size()))))
      return false;
    const std::string name = line.folded().substr(at, end - at);
    if (interexpserv::is_function(name)) {
      refuse(outline_.path, line.place(at), Code::conflict,
             fmt::format("`{}` is a function of the language", name), "choose another name");
    }
    define(line, at, name, open);
    return true;
  }

  void define(const Line& line, size_t at, const std::string& name, size_t value) {
    for (const Definition& known : outline_.names) {
      if (known.name == name) {
        refuse(outline_.path, line.place(at), Code::conflict,
               fmt::format("`{}` is defined twice, first in line {}", name, known.value.place.line),
               "take one of them away");
      }
    }
    outline_.names.push_back({name, read_value(line, value, name)});
    definition_places_.push_back(line.place(at));
  }

  // Only here are all the objects known.
  void check_prefix(const Definition& definition) const {
    const Place place = definition_places_[static_cast<size_t>(&definition - outline_.names.data())];
    const std::string prefix = definition.name.substr(0, definition.name.find('.'));
    if (find_object(prefix)) {
      refuse(outline_.path, place, Code::conflict,
             fmt::format("`{}` is an object: its names are given", prefix),
             fmt::format("write a property as a line of `object {}`, or begin the name differently", prefix));
    }
    const auto property = longest_property(prefix);
    if ((property && property->length == prefix.size()) || prefix == "orientation") {
      refuse(outline_.path, place, Code::conflict,
             fmt::format("`{}` is a property, not a name to define", prefix),
             fmt::format("write the whole value: {} (x, y, z)", prefix));
    }
    if (interexpserv::is_reserved(prefix) || is_any(prefix, kWorldWords) || is_any(prefix, kTimeWords)) {
      refuse(outline_.path, place, Code::conflict, fmt::format("`{}` is a word of the language", prefix),
             "begin the name differently");
    }
  }

  // --- properties

  void read_property(const Line& line, size_t at) {
    const auto match = longest_property(std::string_view(line.folded()).substr(at));
    if (!match) refuse_unknown(line, at);
    const Property& property = *match->property;
    if (!block_) {
      refuse(outline_.path, line.place(at), Code::syntax,
             fmt::format("`{}` stands in no block", property.canonical), std::string(kBlocks));
    }
    if (property.block != *block_) {
      refuse(outline_.path, line.place(at), Code::conflict,
             fmt::format("`{}` belongs to `{}`, this is the block of `{}`", property.canonical,
                         name_of(property.block), here().name),
             property.block == Block::object
                 ? "write it under `object NAME`"
                 : fmt::format("write it under a line `{}`", name_of(property.block)));
    }
    const Entry* first = here().find(property.canonical);
    if (first && !property.adds_up) {
      refuse(outline_.path, line.place(at), Code::conflict,
             fmt::format("`{}` of `{}` is given twice, first in line {}, column {}", property.canonical,
                         here().name, first->place.line, first->place.column),
             "take one of them away");
    }
    const size_t end = skip_owner(line, at + match->length);
    size_t value = line.skip_blanks(end);
    if (value < line.folded().size() && (line.folded()[value] == '=' || line.folded()[value] == ':')) ++value;
    here().entries.push_back({&property, line.place(at), read_value(line, value, property.canonical)});
  }

  Expression read_value(const Line& line, size_t at, std::string_view what) const {
    at = line.skip_blanks(at);
    if (at >= line.folded().size()) {
      const auto property = longest_property(what);
      const std::string_view value =
          property && property->length == what.size() ? property->property->value : "an expression";
      refuse(outline_.path, line.place(at), Code::syntax, fmt::format("`{}` has no value", what),
             fmt::format("write: {}", value));
    }
    const bool owned = block_ == Block::object;
    return {line.written(at, line.folded().size()), line.place(at), owned ? static_cast<int>(object_) : -1};
  }

  // "massa do cubo": the object may be said again, and has to be the block's.
  size_t skip_owner(const Line& line, size_t at) const {
    const size_t begin = line.skip_blanks(at);
    if (block_ != Block::object || begin == at) return at;
    const size_t of = match_any(std::string_view(line.folded()).substr(begin), kOf);
    if (of == 0) return at;
    const size_t name_at = line.skip_blanks(begin + of), end = line.end_of_word(name_at);
    const std::string name = line.folded().substr(name_at, end - name_at);
    if (name == here().folded_name) return end;
    refuse(outline_.path, line.place(name_at), find_object(name) ? Code::conflict : Code::unknown_name,
           fmt::format("expected `{}`, whose block this is{}", here().name, found(line, name_at)),
           fmt::format("write it in the block of `{}`, or leave the name out",
                       name.empty() ? "the object" : name));
  }

  // --- refusals

  [[noreturn]] void refuse_unknown(const Line& line, size_t at) const {
    const std::string& folded = line.folded();
    std::vector<size_t> ends;  // of the words that may be the name of a property
    for (size_t word = at; word < folded.size() && is_letter(folded[word]);
         word = line.skip_blanks(ends.back())) {
      ends.push_back(line.end_of_word(word));
    }
    if (ends.empty()) {
      refuse(outline_.path, line.place(at), Code::syntax, "expected a property" + found(line, at),
             "a line is `property value`, `object NAME`, `world`, `time`, or a comment after #");
    }
    const std::string_view first = std::string_view(folded).substr(at, ends.front() - at);
    const bool opens = is_any(first, kWorldWords) || is_any(first, kTimeWords);
    std::vector<std::string> known = block_ ? names_in(*block_) : std::vector<std::string>{};
    if (!opens) known.insert(known.end(), {"object", "world", "time"});
    std::string remedy;
    for (size_t k = ends.size(); k > 0 && remedy.empty(); --k) {
      remedy = suggestion(folded.substr(at, ends[k - 1] - at), known, "");
    }
    if (opens && remedy.empty()) {
      const size_t after = line.skip_blanks(ends.front());
      refuse_rest(line, after + (folded[after] == ':' ? 1 : 0), fmt::format("`{}`", first));
    }
    if (remedy.empty()) remedy = block_ ? "docs/scene-format.md lists the properties" : std::string(kBlocks);
    refuse(outline_.path, line.place(at), Code::unknown_name,
           fmt::format("unknown property `{}`{}", line.written(at, ends.back()),
                       block_ ? fmt::format(" in the block of `{}`", here().name) : ""),
           remedy);
  }

  [[noreturn]] void refuse_uninvolved(Place place, const std::string& name) const {
    const std::vector<std::string> known = outline_.object_names();
    refuse(outline_.path, place, Code::unknown_name,
           fmt::format("`{}` is not among the objects involved", name),
           suggestion(name, known, "add it to the heading, or open it with `object " + name + "`"));
  }

  void refuse_rest(const Line& line, size_t at, std::string_view after) const {
    at = line.skip_blanks(at);
    const size_t end =
        line.folded().find_first_not_of(line.heading() < line.folded().size() ? " \t#" : ":", at);
    if (end == std::string::npos || at >= line.folded().size()) return;
    refuse(outline_.path, line.place(at), Code::syntax,
           fmt::format("expected nothing after {}{}", after, found(line, at)),
           "give each property a line of its own");
  }

  std::string found(const Line& line, size_t at) const {
    if (at >= line.folded().size()) return ", found the end of the line";
    return fmt::format(", found `{}`", line.written(at, std::max(at + 1, line.end_of_word(at))));
  }

  Section& here() {
    return block_ == Block::object  ? outline_.objects[object_]
           : block_ == Block::world ? outline_.world
                                    : outline_.time;
  }
  const Section& here() const { return const_cast<OutlineReader*>(this)->here(); }

  std::optional<size_t> find_object(const std::string& folded) const {
    const auto found = index_.find(folded);
    return found == index_.end() ? std::nullopt : std::optional(found->second);
  }

  Outline outline_;
  std::map<std::string, size_t> index_;  // of the objects
  std::vector<Place> definition_places_;
  std::optional<Block> block_;
  size_t object_ = 0;
  bool involved_ = false;
};

}  // namespace

const Entry* Section::find(std::string_view canonical) const {
  for (const Entry& entry : entries) {
    if (entry.property->canonical == canonical) return &entry;
  }
  return nullptr;
}

std::vector<std::string> Outline::object_names() const {
  std::vector<std::string> known;
  for (const Section& object : objects) known.push_back(object.folded_name);
  return known;
}

Outline read_outline(std::string_view text, const std::string& path) {
  return OutlineReader(path).run(text);
}

}  // namespace animado::controle
