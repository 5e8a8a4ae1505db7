#include "report/template.hpp"
#include "base/error.hpp"

namespace animado::report {

bool has_page_template() {
  return false;
}

std::string_view page_template() {
  throw Error(Code::unavailable, "this program was built without the page of the report", "report.html",
              "install npm, then: cmake --preset release -DANIMADO_WEB=ON && scripts/build release programs");
}

}  // namespace animado::report
