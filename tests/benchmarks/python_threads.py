#!/usr/bin/env python3
"""How much two threads of Python gain: 100 probes filtered by one thread, then by two, one thread of work a call.

PYTHONPATH=build/ci/python /usr/bin/python3 tests/benchmarks/python_threads.py [PROBES] [ROUNDS]
Prints both times, the ratio of each round and the median ratio; 2 is the most that two cores give.
"""

import concurrent.futures
import statistics
import sys
import time

import numpy as np

import mirrorball


def main(probes=100, rounds=3):
    rng = np.random.default_rng(5)
    maps = [mirrorball.EnvironmentMap("latlong", rng.random((256, 512, 3), dtype=np.float32)) for _ in range(probes)]

    def work(map):
        return mirrorball.prefilter(map, "phong:50", to="cube", size=128, threads=1).band_limit

    ratios = []
    work(maps[0])  # tables and code are there
    for _ in range(rounds):
        seconds = {}
        for threads in (1, 2):
            with concurrent.futures.ThreadPoolExecutor(threads) as pool:
                start = time.perf_counter()
                list(pool.map(work, maps))
                seconds[threads] = time.perf_counter() - start
        ratios.append(seconds[1] / seconds[2])
        print(f"one thread {seconds[1]:.2f} s, two {seconds[2]:.2f} s: {ratios[-1]:.2f} times as fast")
    print(f"median {statistics.median(ratios):.2f}")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
