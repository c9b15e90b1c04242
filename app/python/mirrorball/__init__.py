"""Materials with environment maps: light probes, prefiltering, sphere maps, scenes.

Maps are numpy arrays [y, x, c] of float32 in linear Rec.709, row 0 on top; directions are [..., 3] with +Y up and +Z in the middle of a
latlong. Angles are in degrees. Work runs without holding the interpreter, on as many `threads` as are given (0: one per core); `progress`
is called with the share that is done; Ctrl-C stops it. Errors are Error, and below it WorkError, InvalidArgument (a ValueError), FileError
(an OSError too) and Cancelled, with the words of the command line.

    import mirrorball

    probe = mirrorball.read_probe("probe.hdr")
    shiny = mirrorball.prefilter(probe.map, mirrorball.Lobe.phong(50), to="cube", size=256)
    shiny.map.radiance([[0, 1, 0]])
    shiny.write("shiny.exr", half=True)
"""

from ._mirrorball import (
    Brdf,
    Cancelled,
    EnvironmentMap,
    Error,
    FileError,
    FilteredMap,
    InvalidArgument,
    Lobe,
    Probe,
    Scene,
    Source,
    SphereMap,
    WorkError,
    __version__,
    diagnose,
    error_metrics,
    mip_levels,
    prefilter,
    presets,
    read_probe,
    report,
    reproject,
    write_map,
)

__all__ = [
    "Brdf",
    "Cancelled",
    "EnvironmentMap",
    "Error",
    "FileError",
    "FilteredMap",
    "InvalidArgument",
    "Lobe",
    "Probe",
    "Scene",
    "Source",
    "SphereMap",
    "WorkError",
    "__version__",
    "diagnose",
    "error_metrics",
    "mip_levels",
    "prefilter",
    "presets",
    "read_probe",
    "report",
    "reproject",
    "write_map",
]
