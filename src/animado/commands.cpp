#include "animado/commands.hpp"

namespace animado {

namespace {

class ExamplesFirst : public CLI::Formatter {
 public:
  explicit ExamplesFirst(std::string examples) : examples_(std::move(examples)) {}

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    const std::string help = CLI::Formatter::make_help(app, name, mode);
    return mode == CLI::AppFormatMode::Normal ? examples_ + "\n" + help : help;
  }

 private:
  std::string examples_;
};

}  // namespace

CLI::App& add_command(CommandLine& line, const std::string& name, const std::string& description,
                      const std::string& examples) {
  CLI::App& command = *line.app.add_subcommand(name, description);
  command.formatter(std::make_shared<ExamplesFirst>(examples));
  return command;
}

}  // namespace animado
