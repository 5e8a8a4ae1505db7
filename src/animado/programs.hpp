// The other programs of the suite: they lie beside this one.
#pragma once

#include <filesystem>
#include <string>

namespace animado {

inline std::filesystem::path program(const std::string& name) {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
}

}  // namespace animado
