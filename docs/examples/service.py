"""A client of ANIMADO's services in plain Python: MessagePack-RPC over a Unix socket (docs/protocol.md)."""
import pathlib
import socket
import struct
import sys

import msgpack


class Service:
    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(path)
        self.messages, self.last_id, self.notifications = msgpack.Unpacker(), 0, []
        self.call("hello", protocol="animado", version=1, client=pathlib.Path(sys.argv[0]).name)

    def call(self, method, **fields):
        self.last_id += 1
        self.socket.sendall(msgpack.packb([0, self.last_id, method, [fields]]))
        while (message := self.receive())[0] == 2:  # a notification that came before the reply
            self.notifications.append(message)
        _kind, _id, error, result = message
        if error:
            raise RuntimeError(f"{error['code']}: {error['message']} ({error['remedy']})")
        return result

    def next_notification(self):
        _kind, method, [fields] = self.notifications.pop(0) if self.notifications else self.receive()
        return method, fields

    def receive(self):
        while True:
            for message in self.messages:
                return message
            self.messages.feed(self.socket.recv(65536))


def find(name, interexpserv):
    """The service of that name; `interexpserv`, whose socket is at the given path, knows where it is."""
    return Service(Service(interexpserv).call("lookup", name=name)["socket"])


def array(*numbers, shape=None):
    return {"shape": shape or [len(numbers)], "data": struct.pack(f"<{len(numbers)}d", *numbers)}


def numbers(array):
    return struct.unpack(f"<{len(array['data']) // 8}d", array["data"])
