#include "report/template.hpp"

// The page's first byte and the one behind its last: template.S.
extern "C" const char animado_page_begin[];
extern "C" const char animado_page_end[];

namespace animado::report {

bool has_page_template() {
  return true;
}

std::string_view page_template() {
  return {animado_page_begin, animado_page_end};
}

}  // namespace animado::report
