#include "animado/run_report.hpp"

#include "base/error.hpp"
#include "console/terminal.hpp"
#include "report/page.hpp"
#include "report/template.hpp"

namespace animado {

namespace {

namespace fs = std::filesystem;

void tell(const std::string& what, const std::string& remedy, const fs::path& final_results) {
  const std::string page = (final_results / "report.html").string();
  print_error(Error(Code::unavailable, "no page of the run: " + what, page, remedy));
  print_note(fmt::format("  the numbers are whole; for the page: animado report {}",
                         fs::proximate(final_results).string()));
}

}  // namespace

void add_report(const fs::path& results, const fs::path& final_results) try {
  if (!report::has_page_template()) return;  // who built it so knows; `animado report` tells the others
  report::write_report(results);
} catch (const Error& error) {
  tell(error.message(), error.remedy(), final_results);
} catch (const std::exception& error) {  // no memory is left, for one
  tell(error.what(), "", final_results);
}

}  // namespace animado
