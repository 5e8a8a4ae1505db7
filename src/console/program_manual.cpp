#include "console/program_manual.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <sstream>

namespace animado {
namespace {

// Text as troff shows it: its own signs, and what it would turn into typographic ones, are written by name.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '\\':
        out += "\\e";
        break;
      case '-':
        out += "\\-";
        break;
      case '\'':
        out += "\\(aq";
        break;
      case '`':
        out += "\\(ga";
        break;
      case '^':
        out += "\\(ha";
        break;
      case '~':
        out += "\\(ti";
        break;
      default:
        out += c;
    }
  }
  return out.starts_with('.') ? "\\&" + out : out;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

// "--out DIR", the names in bold.
std::string option_text(const CLI::Option& option) {
  if (option.get_positional()) return fmt::format("\\fI{}\\fR", escaped(option.get_name()));
  std::string names;
  for (const std::string& name : option.get_snames()) names += fmt::format("\\fB\\-{}\\fR, ", escaped(name));
  for (const std::string& name : option.get_lnames())
    names += fmt::format("\\fB\\-\\-{}\\fR, ", escaped(name));
  names.resize(names.size() - 2);
  const bool takes_value = option.get_items_expected_max() > 0 && !option.get_type_name().empty();
  return takes_value ? fmt::format("{} \\fI{}\\fR", names, escaped(option.get_type_name())) : names;
}

std::string synopsis(const CLI::App& app, const std::string& name) {
  std::string text =
      app.get_parent() == nullptr
          ? fmt::format("\\fB{}\\fR", escaped(name))
          : fmt::format("\\fB{} {}\\fR", escaped(app.get_parent()->get_name()), escaped(app.get_name()));
  text += " [\\fIOPTIONS\\fR]";
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional()) continue;
    const std::string shown = option_text(*option);
    text += option->get_required() ? " " + shown : fmt::format(" [{}]", shown);
  }
  return app.get_subcommands({}).empty() ? text : text + " \\fICOMMAND\\fR";
}

// The indented lines as they stand, the others as paragraphs.
std::string examples_text(const std::string& examples) {
  std::istringstream lines(examples);
  std::string out;
  bool verbatim = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  ") != verbatim) {
      verbatim = !verbatim;
      out += verbatim ? ".nf\n" : ".fi\n";
    }
    out += line.empty() ? ".PP\n" : escaped(line) + "\n";
  }
  return verbatim ? out + ".fi\n" : out;
}

std::string options_text(const CLI::App& app) {
  std::string out;
  for (const CLI::Option* option : app.get_options())
    out += fmt::format(".TP\n{}\n{}\n", option_text(*option), escaped(option->get_description()));
  return out;
}

std::string commands_text(const CLI::App& app) {
  std::string out;
  for (const CLI::App* command : app.get_subcommands({}))
    out += fmt::format(".TP\n\\fB{}\\fR\n{}\n", escaped(command->get_name()),
                       escaped(command->get_description()));
  return out;
}

}  // namespace

std::string ExamplesFirst::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  const std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
  return mode == CLI::AppFormatMode::Normal ? examples_ + "\n" + help : help;
}

std::string man_page(const CLI::App& app, const std::string& name) {
  std::string page =
      fmt::format(".TH {0} 1 \"\" \"ANIMADO {1}\" \"ANIMADO\"\n.SH NAME\n{2} \\- {3}\n", escaped(upper(name)),
                  ANIMADO_VERSION, escaped(name), escaped(app.get_description()));
  page += fmt::format(".SH SYNOPSIS\n{}\n", synopsis(app, name));
  if (const auto* formatter = dynamic_cast<const ExamplesFirst*>(app.get_formatter().get()))
    page += ".SH EXAMPLES\n" + examples_text(formatter->examples());
  page += ".SH OPTIONS\n" + options_text(app);
  const std::string commands = commands_text(app);
  return commands.empty() ? page : page + ".SH COMMANDS\n" + commands;
}

void add_manual(CLI::App& app, const std::string& name, const std::string& examples) {
  app.formatter(std::make_shared<ExamplesFirst>(examples));
  const auto print = [&app, name] {
    fmt::print("{}", man_page(app, name));
    throw CLI::Success();
  };
  app.add_flag_callback("--man", print, "print the manual page, for man -l -");
}

}  // namespace animado
