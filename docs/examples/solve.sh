#!/bin/sh
# Solves systems from Matrix Market files. `animado` must be in the PATH; no service has to run.
set -eu

cat > A.mtx <<END
%%MatrixMarket matrix coordinate real symmetric
3 3 5
1 1 2
2 1 -1
2 2 2
3 2 -1
3 3 2
END
cat > b.mtx <<END
%%MatrixMarket matrix array real general
3 1
1
2
4
END
animado solve A.mtx b.mtx                             # a coordinate file: a sparse system
animado solve A.mtx b.mtx --method dense -o x.mtx     # the same by Gauss–Jordan elimination, into a file
cat x.mtx

cat > line.mtx <<END
%%MatrixMarket matrix array integer general
4 2
1
1
1
1
0
1
2
3
END
cat > y.mtx <<END
%%MatrixMarket matrix array real general
4 1
1
3
5
8
END
animado solve line.mtx y.mtx --least-squares          # y = x₀ + x₁ t: the line nearest to four points
