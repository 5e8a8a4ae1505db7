"""Heat in a rod of 100 points, 20 implicit steps: EGESP factors the sparse matrix once and solves with it at every step.
Its argument is the socket of interexpserv."""
import sys

from service import array, find, numbers

points, steps, ratio = 100, 20, 0.5  # ratio: a dt / dx², as large as one likes: the method is implicit
rows, columns, values = [], [], []
for i in range(points):
    for j in range(max(i - 1, 0), min(i + 2, points)):
        rows.append(i)
        columns.append(j)
        values.append(1 + 2 * ratio if i == j else -ratio)

egesp = find("egesp", interexpserv=sys.argv[1])
matrix = {"size": points, "rows": array(*rows), "columns": array(*columns), "values": array(*values)}
prepared = egesp.call("sparse_prepare", matrix=matrix)

heat = array(*(1.0 if i == points // 2 else 0.0 for i in range(points)))
for _ in range(steps):
    heat = egesp.call("sparse_solve_prepared", handle=prepared["handle"], right_sides=heat)["solutions"]
egesp.call("release", handle=prepared["handle"])

heat = numbers(heat)
print("total %.6f, at the middle %.6f" % (sum(heat), heat[points // 2]))
