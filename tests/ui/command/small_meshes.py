"""Meshes small enough to write by hand, whole and broken."""

BLOCK_QUADS = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def block(x_mm, y_mm, z_mm):
    """A block about the origin: 8 points and 12 outward triangles."""
    corners = ((-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))
    points = [(a * x_mm / 2, b * y_mm / 2, c * z_mm / 2) for a, b, c in corners]
    triangles = [half for a, b, c, d in BLOCK_QUADS for half in ((a, b, c), (a, c, d))]
    return points, triangles


def ply_text(points, triangles):
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}",
             *(f"property double {axis}" for axis in "xyz"),
             f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]
    lines += [" ".join(map(str, point)) for point in points]
    lines += ["3 " + " ".join(map(str, triangle)) for triangle in triangles]
    return "\n".join(lines) + "\n"


def block_ply(x_mm, y_mm, z_mm):
    return ply_text(*block(x_mm, y_mm, z_mm))
