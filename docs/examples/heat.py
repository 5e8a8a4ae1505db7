"""Heat in a rod of 100 points, 20 implicit steps: EGESP factors the sparse matrix once and solves with it at every step.
Its argument is the socket of interexpserv, which knows where the others are."""
import socket
import struct
import sys

import msgpack


class Service:
    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(path)
        self.replies, self.last_id = msgpack.Unpacker(), 0
        self.call("hello", protocol="animado", version=1, client="heat.py")

    def call(self, method, **fields):
        self.last_id += 1
        self.socket.sendall(msgpack.packb([0, self.last_id, method, [fields]]))
        while True:
            for _kind, _id, error, result in self.replies:
                if error:
                    raise RuntimeError(f"{error['message']} ({error['remedy']})")
                return result
            self.replies.feed(self.socket.recv(65536))


def array(numbers):
    return {"shape": [len(numbers)], "data": struct.pack(f"<{len(numbers)}d", *numbers)}


points, steps, ratio = 100, 20, 0.5  # ratio: a dt / dx², as large as one likes: the method is implicit
rows, columns, values = [], [], []
for i in range(points):
    for j in range(max(i - 1, 0), min(i + 2, points)):
        rows.append(i)
        columns.append(j)
        values.append(1 + 2 * ratio if i == j else -ratio)

egesp = Service(Service(sys.argv[1]).call("lookup", name="egesp")["socket"])
matrix = {"size": points, "rows": array(rows), "columns": array(columns), "values": array(values)}
prepared = egesp.call("sparse_prepare", matrix=matrix)

heat = array([1.0 if i == points // 2 else 0.0 for i in range(points)])
for _ in range(steps):
    heat = egesp.call("sparse_solve_prepared", handle=prepared["handle"], right_sides=heat)["solutions"]
egesp.call("release", handle=prepared["handle"])

heat = struct.unpack(f"<{points}d", heat["data"])
print("total %.6f, at the middle %.6f" % (sum(heat), heat[points // 2]))
