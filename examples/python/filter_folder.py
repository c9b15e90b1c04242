#!/usr/bin/env python3
"""Filters every probe of a folder, two at a time, and keeps going where one cannot be read.

filter_folder.py FOLDER OUT_FOLDER
"""

import concurrent.futures
import pathlib
import sys

import mirrorball


def filter_one(probe, folder):
    """One probe on one thread: several of these run side by side, since none of them holds the interpreter."""
    filtered = mirrorball.prefilter(probe, "phong:50", to="cube", size=64, threads=1)
    out = folder / (probe.stem + ".exr")
    filtered.write(out, half=True)
    return out


def main(folder, out_folder):
    out_folder = pathlib.Path(out_folder)
    out_folder.mkdir(parents=True, exist_ok=True)
    probes = sorted(file for file in pathlib.Path(folder).iterdir() if file.suffix in {".hdr", ".exr"})
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = {pool.submit(filter_one, probe, out_folder): probe for probe in probes}
        for job in concurrent.futures.as_completed(jobs):
            try:
                print(job.result())
            except mirrorball.Error as error:
                print(error, file=sys.stderr)
                failed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
