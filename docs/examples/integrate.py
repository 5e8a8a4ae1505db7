"""Lets FRED throw a ball: where does it land? Its argument is the socket of interexpserv, which knows where the others are."""
import socket
import sys

import msgpack


class Service:
    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(path)
        self.replies, self.last_id = msgpack.Unpacker(), 0
        self.call("hello", protocol="animado", version=1, client="integrate.py")

    def call(self, method, **fields):
        self.last_id += 1
        self.socket.sendall(msgpack.packb([0, self.last_id, method, [fields]]))
        while True:
            for _kind, _id, error, result in self.replies:
                if error:
                    raise RuntimeError(f"{error['message']} ({error['remedy']})")
                return result
            self.replies.feed(self.socket.recv(65536))


def values(**named):
    return [{"name": name, "value": value} for name, value in named.items()]


interexpserv = Service(sys.argv[1])
fred = Service(interexpserv.call("lookup", name="fred")["socket"])
reply = fred.call(
    "integrate",
    equations=["x' = u", "y' = v", "u' = 0", "v' = -g"],
    constants=values(g=9.81),
    **{"from": values(x=0.0, y=0.0, u=3.0, v=4.905)},
    t1=10.0,
    tolerance=1e-9,
    events=[{"expression": "y = 0", "crossing": "falling", "terminal": True}],
)
print("%s: after %g s at x = %g m" % (reply["stop"], reply["t"], reply["state"][0]))
