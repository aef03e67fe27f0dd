# SPDX-License-Identifier: Apache-2.0
"""Visible lines of a mesh by Blender's Line Art, for comparison:
    blender -b --factory-startup --python-exit-code 2 -P bench/blender_lines.py -- [front|top] [intersections] MODEL LINES.txt

Isometric, or from the front or the top; contours, creases from 30 degrees and open edges, and with `intersections` lines where faces cross. MODEL: .off,
or what Blender reads (.stl, .ply, .obj). Writes a row "x0 y0 x1 y1" for each line, in units of the model, as `epura study
paper --rival` wants it, and prints the seconds of each stage on stderr: `hlr` is the evaluation of the modifier.
"""

import math
import sys
import time

import bpy
from mathutils import Matrix, Vector


VIEWERS = {"front": (0, -1, 0), "top": (0, 0, 1), "isometric": (1, -1, 1)}


def read_off(path):
    words = open(path).read().split()
    corners, faces = int(words[1]), int(words[2])
    numbers = list(map(float, words[4:4 + 3 * corners]))
    mesh = bpy.data.meshes.new("model")
    at, polygons = 4 + 3 * corners, []
    for _ in range(faces):
        count = int(words[at])
        polygons.append([int(word) for word in words[at + 1:at + 1 + count]])
        at += count + 1
    mesh.from_pydata(list(zip(numbers[0::3], numbers[1::3], numbers[2::3])), [], polygons)
    model = bpy.data.objects.new("model", mesh)
    bpy.context.scene.collection.objects.link(model)
    return model


def read(path):
    extension = path.rpartition(".")[2].lower()
    if extension == "off":
        return read_off(path)
    if extension == "obj":
        bpy.ops.wm.obj_import(filepath=path, forward_axis="Y", up_axis="Z")
    elif extension == "stl":
        bpy.ops.import_mesh.stl(filepath=path)
    else:
        bpy.ops.import_mesh.ply(filepath=path)
    return bpy.context.selected_objects[0]


def look_at(model, right, up, viewer):
    """An orthographic camera in front of all, for whose picture lines are made."""
    corners = [Vector(corner) for corner in model.bound_box]
    middle = sum(corners, Vector()) / len(corners)
    size = max((corner - middle).length for corner in corners)
    camera = bpy.data.cameras.new("camera")
    camera.type = "ORTHO"
    camera.ortho_scale = 2.2 * size
    camera.clip_start, camera.clip_end = 0.1 * size, 10 * size
    place = Matrix((right, up, viewer)).transposed().to_4x4()
    place.translation = middle + 3 * size * viewer
    item = bpy.data.objects.new("camera", camera)
    item.matrix_world = place
    bpy.context.scene.collection.objects.link(item)
    bpy.context.scene.camera = item
    # What lies outside the picture is not drawn.
    bpy.context.scene.render.resolution_x = bpy.context.scene.render.resolution_y = 1080


def add_line_art(intersections):
    data = bpy.data.grease_pencils.new("lines")
    data.layers.new("lines").frames.new(0)
    material = bpy.data.materials.new("lines")
    bpy.data.materials.create_gpencil_data(material)
    data.materials.append(material)
    lines = bpy.data.objects.new("lines", data)
    bpy.context.scene.collection.objects.link(lines)
    art = lines.grease_pencil_modifiers.new("lines", "GP_LINEART")
    art.source_type = "SCENE"
    art.target_layer = "lines"
    art.target_material = material
    art.use_intersection = intersections
    art.crease_threshold = math.radians(180 - 30)  # the angle between faces, not between their normals
    art.chaining_image_threshold = 0
    return lines


def main(*arguments):
    *options, path, output = arguments
    for item in list(bpy.data.objects):
        bpy.data.objects.remove(item)
    start = time.perf_counter()
    model = read(path)
    viewer = Vector(next((VIEWERS[word] for word in options if word in VIEWERS), VIEWERS["isometric"])).normalized()
    right = Vector((0, 1, 0) if viewer.z == 1 else (0, 0, 1)).cross(viewer).normalized()
    up = viewer.cross(right)
    look_at(model, right, up, viewer)
    bpy.context.view_layer.update()
    was_read = time.perf_counter()
    lines = add_line_art("intersections" in options)
    graph = bpy.context.evaluated_depsgraph_get()
    graph.update()
    drawn = lines.evaluated_get(graph).data
    done = time.perf_counter()
    count = 0
    with open(output, "w") as file:
        for stroke in (s for layer in drawn.layers for frame in layer.frames for s in frame.strokes):
            points = [(point.co.dot(right), point.co.dot(up)) for point in stroke.points]
            for (x0, y0), (x1, y1) in zip(points, points[1:]):
                file.write(f"{x0!r} {y0!r} {x1!r} {y1!r}\n")
                count += 1
    print(f"read {was_read - start:.6f} s\nhlr {done - was_read:.6f} s\nwrite {time.perf_counter() - done:.6f} s\n"
          f"visible {count}\nhidden 0", file=sys.stderr)


main(*sys.argv[sys.argv.index("--") + 1:])
