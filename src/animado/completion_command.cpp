// animado completion: what makes a shell complete this program's command line.
#include "animado/commands.hpp"
#include "animado/completion.hpp"

namespace animado {

void add_completion_command(CommandLine& line) {
  const auto shell = std::make_shared<std::string>();
  CLI::App& command = add_command(line, "completion", "Print what completes this program in a shell",
                                  "  source <(animado completion bash)      in ~/.bashrc\n"
                                  "  source <(animado completion zsh)       in ~/.zshrc, after compinit\n\n"
                                  "Commands, options, scenes and folders of results complete with Tab.\n");
  command.add_option("shell", *shell, "bash or zsh")->required()->check(CLI::IsMember({"bash", "zsh"}));
  command.callback([&line, shell] {
    fmt::print("{}", *shell == "bash" ? bash_completion(line.app) : zsh_completion(line.app));
  });
}

}  // namespace animado
