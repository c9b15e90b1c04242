#!/usr/bin/env python3
"""Error of two filtering methods against the reference sum, where a sun makes it hard: prints a line a method.

compare_methods.py [PROBE]
"""

import sys

import mirrorball


def main(probe="builtin:sky"):
    source = mirrorball.Source(mirrorball.reproject(mirrorball.read_probe(probe).map, "latlong", 64))
    truth = mirrorball.prefilter(source, "ggx:0.1", size=16, method="reference").map
    for method in ("spectral", "importance", "mip"):
        filtered = mirrorball.prefilter(source, "ggx:0.1", size=16, method=method)
        error = mirrorball.error_metrics(filtered.map, truth)
        print(f"{method:12} rel_rms {error['rel_rms']:.2e}  p99_rel {error['p99_rel']:.2e}")


if __name__ == "__main__":
    main(*sys.argv[1:])
