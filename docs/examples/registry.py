"""INTEREXPSERV from Python: two names in one transaction, a change that is told, a change that comes too late.

Its argument is the socket of interexpserv: interexpserv.sock in the folder that `animado ps --json` tells."""
import sys

from service import Service

registry, watcher = Service(sys.argv[1]), Service(sys.argv[1])
watcher.call("watch", prefix="spring.*")
registry.call("define", definitions=[{"name": "ball.mass", "text": "2"}, {"name": "spring.k", "text": "3*ball.mass"}])
registry.call("set", name="ball.mass", text="4")  # spring.k follows
for _ in range(2):
    method, change = watcher.next_notification()
    print(method, change["name"], change["values"][0], "version", change["version"])
try:
    registry.call("set", name="spring.k", text="1", expected=1)  # it was read when its version was 1
except RuntimeError as error:
    print(error)
