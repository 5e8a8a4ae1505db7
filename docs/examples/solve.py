"""Calls EGESP from Python: solves 2x + y = 3, x + 3y = 5. Its argument is the socket of interexpserv."""
import sys

from service import array, find, numbers

egesp = find("egesp", interexpserv=sys.argv[1])
reply = egesp.call("solve", matrices=array(2, 1, 1, 3, shape=[2, 2]), right_sides=array(3, 5))
print("x = %g, y = %g" % numbers(reply["solutions"]))
