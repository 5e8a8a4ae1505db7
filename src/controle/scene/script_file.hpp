// The paper's description file ("arquivo de descrição"): the motion of a body as a table.
#pragma once

#include "controle/scene/scene.hpp"

namespace animado::controle {

// Rows of `t,x,y,z,qw,qx,qy,qz` (s, m, unit quaternion body → world), by time; a heading and lines of # may
// stand among them. Quaternions are normalized, and take the sign nearer to the row before. Throws Error with
// file:line.
std::vector<ScriptRow> read_script(const std::string& path);

}  // namespace animado::controle
