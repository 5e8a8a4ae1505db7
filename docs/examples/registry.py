"""INTEREXPSERV from Python: two names in one transaction, a change that is told, a change that comes too late.

Its argument is the socket of interexpserv: interexpserv.sock in the folder that `animado ps --json` tells."""
import socket
import sys

import msgpack


class Registry:
    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(path)
        self.messages, self.last_id, self.told = msgpack.Unpacker(), 0, []
        self.call("hello", protocol="animado", version=1, client="registry.py")

    def receive(self):
        while True:
            for message in self.messages:
                return message
            self.messages.feed(self.socket.recv(65536))

    def call(self, method, **fields):
        self.last_id += 1
        self.socket.sendall(msgpack.packb([0, self.last_id, method, [fields]]))
        while True:
            message = self.receive()
            if message[0] == 2:  # a notification that came before the reply
                self.told.append(message)
                continue
            _kind, _id, error, result = message
            if error:
                raise RuntimeError(f"{error['code']}: {error['message']}")
            return result

    def next_change(self):
        _kind, method, [fields] = self.told.pop(0) if self.told else self.receive()
        return method, fields


registry, watcher = Registry(sys.argv[1]), Registry(sys.argv[1])
watcher.call("watch", prefix="spring.*")
registry.call("define", definitions=[{"name": "ball.mass", "text": "2"}, {"name": "spring.k", "text": "3*ball.mass"}])
registry.call("set", name="ball.mass", text="4")  # spring.k follows
for _ in range(2):
    method, change = watcher.next_change()
    print(method, change["name"], change["values"][0], "version", change["version"])
try:
    registry.call("set", name="spring.k", text="1", expected=1)  # it was read when its version was 1
except RuntimeError as error:
    print(error)
