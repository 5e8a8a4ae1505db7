// What --help and the manual page say of a program or a command: both are made from its table of options, so
// that they cannot disagree. Examples come first, for they are what is looked for.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Formatter.hpp>
#include <string>
#include <utility>

namespace animado {

class ExamplesFirst : public CLI::Formatter {
 public:
  // examples: lines indented by two blanks; after an empty line, what else is to be said.
  explicit ExamplesFirst(std::string examples) : examples_(std::move(examples)) {}

  const std::string& examples() const { return examples_; }
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;

 private:
  std::string examples_;
};

// The page in the macros of man(7). name: of the page, as "animado-run"; its synopsis says "animado run" when
// the app is a command of another.
std::string man_page(const CLI::App& app, const std::string& name);

// --help of a program with its examples first, and --man, which prints its manual page.
void add_manual(CLI::App& app, const std::string& name, const std::string& examples);

}  // namespace animado
