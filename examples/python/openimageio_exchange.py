#!/usr/bin/env python3
"""From OpenImageIO to Mirrorball and back: a picture that OpenImageIO changed is filtered, and the map becomes an ImageBuf again.

openimageio_exchange.py [PROBE] [OUT]
"""

import sys

import OpenImageIO as oiio
import numpy as np

import mirrorball


def to_map(buffer, kind="latlong"):
    """The first three channels of an ImageBuf as a map."""
    return mirrorball.EnvironmentMap(kind, buffer.get_pixels(oiio.FLOAT)[..., :3])


def to_buffer(map):
    """A map as an ImageBuf."""
    buffer = oiio.ImageBuf(oiio.ImageSpec(map.width, map.height, 3, oiio.FLOAT))
    buffer.set_pixels(oiio.ROI(), np.asarray(map))
    return buffer


def main(probe="probe.exr", out="shiny.exr"):
    picture = oiio.ImageBuf(probe)
    if picture.has_error:
        raise SystemExit(f"{probe}: {picture.geterror()}")
    brighter = oiio.ImageBufAlgo.mul(picture, 2.0)
    shiny = mirrorball.prefilter(to_map(brighter), mirrorball.Lobe.phong(50), to="latlong", size=64).map
    result = to_buffer(shiny)
    if not result.write(out):
        raise SystemExit(f"{out}: {result.geterror()}")
    print(f"{out}: {result.spec().width} x {result.spec().height}, mean {np.mean(result.get_pixels(oiio.FLOAT)):.4f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
