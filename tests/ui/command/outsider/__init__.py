"""An outsider's own computation of metrics, points and score, from the files that `hallux export` writes and nothing else.

It follows docs/metrics.md and docs/data_format.md alone, shares no line with the program, and needs Python's standard library
only. Each function names the paragraph or the row of a table that it follows. Where a function and the program disagree, one of
the three is wrong: the page, the program or this.

    export      the files of an attempt, read
    geometry    poses, planes, percentiles, distances
    solids      closed meshes and what a line meets of them
    work        forces, the minding of the saw, times, break-throughs
    order       order of the steps
    movement    low pass, smoothness, idling
    entries     entries into the bone
    zones       contacts with danger zones
    faces       kerfs, finished faces, wedge, closing, thickness
    fixation    fragments, wires and screws
    recompute   all of them, by metric and subject; what is left out, and why
    points      from metrics to points, and from points to a score
"""
