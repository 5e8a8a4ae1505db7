#!/bin/sh
# INTEREXPSERV from the shell, while the services run. What follows the name goes to every command: --run NAME, or --socket-dir DIR.
set -eu

animado set ball.mass 2 spring.k "3*ball.mass" "$@"   # both or none
animado snapshot before.txt "$@"
animado set ball.mass 4 "$@"
animado get spring.k "$@"                             # 12: it follows
animado set spring.k 1 --if-version 1 "$@" || echo "somebody was faster"
animado restore before.txt "$@"
animado get spring.k "$@"                             # 6
animado call interexpserv history '{"name": "ball.mass"}' "$@"
