#!/bin/sh
# Asks FRED for e, by y' = y from 0 to 1. Its argument is the socket directory of a running suite.
animado call fred integrate --socket-dir "$1" \
  '{"equations": ["y'\'' = y"], "from": [{"name": "y", "value": 1}], "t1": 1, "tolerance": 1e-12, "method": "dop853"}'
