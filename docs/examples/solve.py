"""Calls EGESP from Python: solves two equations. Its argument is the socket of interexpserv, which knows where the others are."""
import socket
import struct
import sys

import msgpack


class Service:
    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(path)
        self.replies, self.last_id = msgpack.Unpacker(), 0
        self.call("hello", protocol="animado", version=1, client="solve.py")

    def call(self, method, **fields):
        self.last_id += 1
        self.socket.sendall(msgpack.packb([0, self.last_id, method, [fields]]))
        while True:
            for _kind, _id, error, result in self.replies:
                if error:
                    raise RuntimeError(f"{error['message']} ({error['remedy']})")
                return result
            self.replies.feed(self.socket.recv(65536))


def array(shape, *numbers):
    return {"shape": shape, "data": struct.pack(f"<{len(numbers)}d", *numbers)}


interexpserv = Service(sys.argv[1])
egesp = Service(interexpserv.call("lookup", name="egesp")["socket"])
reply = egesp.call("solve", matrices=array([2, 2], 2, 1, 1, 3), right_sides=array([2], 3, 5))
print("x = %g, y = %g" % struct.unpack("<2d", reply["solutions"]["data"]))  # of 2x + y = 3, x + 3y = 5
