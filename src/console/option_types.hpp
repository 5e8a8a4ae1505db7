// Names of what an option takes: --help and manual pages show them, and completion knows what to offer.
#pragma once

namespace animado {

inline constexpr auto kSceneType = "SCENE", kFolderType = "DIR", kFileType = "FILE";

}  // namespace animado
