# Renders a mirror ball and a white one in Godot 3 under the exported environment: godot3 -s ball_godot.gd --path FOLDER
# FOLDER holds the export, named light; pictures are RGB floats, top row first.
extends SceneTree

const SIZE = 128

func _init():
	call_deferred("draw")

func draw():
	var exported = load("res://light_godot.gd")
	var viewport = Viewport.new()
	viewport.size = Vector2(SIZE, SIZE)
	viewport.own_world = true
	viewport.hdr = true
	viewport.keep_3d_linear = true
	viewport.render_target_update_mode = Viewport.UPDATE_ALWAYS
	viewport.render_target_v_flip = true
	get_root().add_child(viewport)
	var environment = exported.make_environment("res://light.hdr")
	environment.tonemap_mode = Environment.TONE_MAPPER_LINEAR
	var world = WorldEnvironment.new()
	world.environment = environment
	viewport.add_child(world)
	var camera = Camera.new()
	camera.set_orthogonal(2.0, 0.1, 10.0)
	camera.translation = Vector3(0, 0, 5)
	viewport.add_child(camera)
	camera.current = true
	var mesh = SphereMesh.new()
	mesh.radial_segments = 256
	mesh.rings = 128
	var ball = MeshInstance.new()
	ball.mesh = mesh
	viewport.add_child(ball)
	for kind in ["metal", "diffuse"]:
		var material = SpatialMaterial.new()
		material.albedo_color = Color(1, 1, 1)
		material.metallic = 1.0 if kind == "metal" else 0.0
		material.metallic_specular = 0.0 if kind == "diffuse" else 0.5
		material.roughness = 0.0 if kind == "metal" else 1.0
		ball.material_override = material
		for _frame in range(12): # the sky is filtered over several frames
			yield(self, "idle_frame")
		var image = viewport.get_texture().get_data()
		image.convert(Image.FORMAT_RGBF)
		var file = File.new()
		file.open("res://" + kind + ".raw", File.WRITE)
		file.store_buffer(image.get_data())
		file.close()
	quit()
