# Draws a mirror ball and a white one under the exported sky into floats: RGB, top row first. Godot 3, in a window:
#   godot3 --path FOLDER -- SCRIPT OUT SIZE
# An orthographic eye at +Z that the ball fills; light is linear, without a tone curve.
extends Node

func _ready():
	var words = OS.get_cmdline_args()
	var at = words.size() - 3
	var exported = load(words[at])
	var out = words[at + 1]
	var size = int(words[at + 2])
	var viewport = Viewport.new()
	viewport.size = Vector2(size, size)
	viewport.hdr = true
	viewport.keep_3d_linear = true
	viewport.own_world = true
	viewport.render_target_update_mode = Viewport.UPDATE_ALWAYS
	add_child(viewport)
	var world = World.new()
	world.environment = exported.make_environment(words[at].get_base_dir().plus_file("godot.hdr"))
	viewport.world = world
	var ball = MeshInstance.new()
	var mesh = SphereMesh.new()
	mesh.radius = 1
	mesh.height = 2
	mesh.radial_segments = 256
	mesh.rings = 128
	ball.mesh = mesh
	viewport.add_child(ball)
	var camera = Camera.new()
	camera.set_orthogonal(2, 0.1, 10)
	camera.translation = Vector3(0, 0, 5)
	camera.current = true
	viewport.add_child(camera)
	for kind in ["metal", "diffuse"]:
		var material = SpatialMaterial.new()
		material.metallic = 1 if kind == "metal" else 0
		material.metallic_specular = 0
		material.roughness = 0 if kind == "metal" else 1
		ball.material_override = material
		for i in range(8): # the sky's radiance is filtered over some frames
			yield(get_tree(), "idle_frame")
		yield(VisualServer, "frame_post_draw")
		var image = viewport.get_texture().get_data()
		image.flip_y()
		image.convert(Image.FORMAT_RGBF)
		var file = File.new()
		file.open(out + "/" + kind + ".raw", File.WRITE)
		file.store_buffer(image.get_data())
		file.close()
	get_tree().quit()
