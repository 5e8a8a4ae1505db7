#include "controle/scene/check_dimensions.hpp"

#include <algorithm>

#include "base/fold.hpp"
#include "controle/scene/lines.hpp"
#include "controle/scene/refusal.hpp"
#include "controle/scene/scope.hpp"

namespace animado::controle {
namespace {

// Without a letter there is neither a unit nor a name, as with most of the numbers of a large scene.
bool may_measure(const Entry& entry) {
  return entry.property->dimension.known && std::ranges::any_of(fold(entry.value.text), is_letter);
}

}  // namespace

void check_dimensions(const Outline& outline, const Scene& scene) {
  const SceneScope scope(scene);
  const auto check = [&](const Section& section) {
    for (const Entry& entry : section.entries) {
      if (!may_measure(entry)) continue;
      const interexpserv::Dimension &meant = entry.property->dimension,
                                    found = scope.compile(entry.value).dimension();
      if (!found.known || found == meant) continue;
      refuse(outline.path, entry.value.place, Code::type,
             fmt::format("`{}` measures {}, this is {}", entry.property->canonical, text_of(meant),
                         text_of(found)),
             "write it in a unit that measures the same, or without one, in SI");
    }
  };
  std::ranges::for_each(outline.objects, check);
  check(outline.world);
  check(outline.time);
}

}  // namespace animado::controle
