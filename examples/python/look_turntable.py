#!/usr/bin/env python3
"""A turntable of a material: a picture for each turn of the environment, as numpy arrays and as files.

look_turntable.py [OUT_FOLDER]
"""

import pathlib
import sys

import mirrorball


def main(folder="turntable"):
    folder = pathlib.Path(folder)
    folder.mkdir(exist_ok=True)
    scene = mirrorball.Scene("builtin:studio", "car-paint")
    scene["view.width"], scene["view.height"] = 160, 120
    for turn in range(0, 360, 120):
        scene["probe.yaw"] = turn
        radiance = scene.render()
        scene.save_picture(folder / f"turn_{turn:03}.png")
        print(f"turn {turn:3}: mean radiance {radiance[..., :3].mean():.4f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
