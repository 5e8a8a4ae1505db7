"""Lets FRED throw a ball: where does it land? Its argument is the socket of interexpserv."""
import sys

from service import find


def values(**named):
    return [{"name": name, "value": value} for name, value in named.items()]


fred = find("fred", interexpserv=sys.argv[1])
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
