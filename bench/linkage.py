# SciPy's linkage on the same vectors. In: a file of 64-bit numbers, how many make a vector, a method. Out: one
# line of JSON with the milliseconds from the vectors to the tree and the sum of its heights.
import json
import sys
import time

import numpy
import scipy
from scipy.cluster.hierarchy import linkage

path, width, method = sys.argv[1], int(sys.argv[2]), sys.argv[3]
vectors = numpy.fromfile(path, dtype="<f8").reshape(-1, width)
linkage(vectors[:100], method)
start = time.perf_counter()
merges = linkage(vectors, method)
milliseconds = 1e3 * (time.perf_counter() - start)
print(json.dumps({"scipy": scipy.__version__, "ms": milliseconds, "heights": float(merges[:, 2].sum())}))
