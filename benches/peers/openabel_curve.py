"""openAbel on a whole curve of equidistant samples, its forward transform. Prints nothing where it is not installed."""
import math
import statistics
import time

try:
    import numpy
    import openabel
except ImportError:
    raise SystemExit(0)

REACH = 3.0


def main():
    # The error is that of the Gaussian, whose transform is known; the work does not depend on the values.
    for points in (10_001, 100_000):
        r = numpy.linspace(0.0, REACH, points)
        values = numpy.exp(-r * r)
        truth = math.sqrt(math.pi) * values * numpy.vectorize(math.erf)(numpy.sqrt(REACH * REACH - r * r))
        for order in (7, 19):
            plan = openabel.Abel(points, -1, 0.0, r[1] - r[0], method=3, order=order)
            found = numpy.asarray(plan.execute(values)).ravel()
            error = float(numpy.max(numpy.abs(found - truth)[: points // 2]) / truth[0])
            times = []
            for _ in range(15):
                start = time.process_time_ns()
                plan.execute(values)
                times.append(time.process_time_ns() - start)
            print(f"curve,openAbel,{points} points order {order},{statistics.median(times) / points:.5g},{error:.3g},0")


if __name__ == "__main__":
    main()
