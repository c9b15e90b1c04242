# Renders a mirror ball and a white one in Cycles under the exported world: blender -b --factory-startup -P ball_blender.py -- SCRIPT OUT SIZE
# The pictures are RGB floats, top row first, in glTF's axes: the eye stands at glTF's +Z, which is Blender's -Y.
import array
import importlib.util
import sys

import bpy

script, out, size = sys.argv[sys.argv.index("--") + 1:]
size = int(size)
spec = importlib.util.spec_from_file_location("exported", script)
exported = importlib.util.module_from_spec(spec)
spec.loader.exec_module(exported)

bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
scene = bpy.context.scene
exported.set_world(script.rsplit("/", 1)[0])
bpy.ops.mesh.primitive_uv_sphere_add(segments=256, ring_count=128, radius=1)
ball = bpy.context.object
bpy.ops.object.shade_smooth()
camera = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
camera.data.type = "ORTHO"
camera.data.ortho_scale = 2
camera.location = (0, -5, 0)
camera.rotation_euler = (1.5707963267948966, 0, 0)
scene.collection.objects.link(camera)
scene.camera = camera
scene.render.engine = "CYCLES"
scene.cycles.device = "CPU"
scene.cycles.use_denoising = False
scene.cycles.filter_width = 0.01
scene.cycles.max_bounces = 1
scene.cycles.sample_clamp_indirect = 0
scene.render.resolution_x = scene.render.resolution_y = size
scene.render.resolution_percentage = 100
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.view_settings.view_transform = "Raw"

material = bpy.data.materials.new("ball")
material.use_nodes = True
ball.data.materials.append(material)
nodes, links = material.node_tree.nodes, material.node_tree.links
for kind, node, samples in (("metal", "ShaderNodeBsdfGlossy", 4), ("diffuse", "ShaderNodeBsdfDiffuse", 256)):
    nodes.clear()
    shader, output = nodes.new(node), nodes.new("ShaderNodeOutputMaterial")
    shader.inputs["Color"].default_value = (1, 1, 1, 1)
    shader.inputs["Roughness"].default_value = 0
    links.new(shader.outputs[0], output.inputs["Surface"])
    scene.cycles.samples = samples
    scene.render.filepath = out + "-" + kind + ".exr"
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    image.colorspace_settings.name = "Raw"
    pixels = list(image.pixels)
    rgb = array.array("f")
    for y in range(size - 1, -1, -1):
        for x in range(size):
            at = 4 * (y * size + x)
            rgb.extend(pixels[at:at + 3])
    with open(out + "-" + kind + ".raw", "wb") as file:
        rgb.tofile(file)
