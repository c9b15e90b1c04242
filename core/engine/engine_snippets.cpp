#include "engine_snippets.h"

#include <array>

namespace mirrorball {

namespace {

struct Snippet {
    std::string_view word{};
    std::string_view text{};
};

constexpr std::array snippets{
    Snippet{
        "three",
        R"js(// Light for three.js r187 and later. Prefiltered levels, as its PMREM shader reads them: nothing is filtered in the browser.
//   scene.environment = await loadEnvironment();
import * as THREE from 'three';
import { read } from 'three/addons/libs/ktx-parse.module.js';

export async function loadEnvironment(url = new URL('./{name}_pmrem.ktx2', import.meta.url)) {
  const container = read(new Uint8Array(await (await fetch(url)).arrayBuffer()));
  const edge = container.pixelWidth;
  const faces = Array.from({ length: 6 }, () => ({ mipmaps: [], width: edge, height: edge }));
  container.levels.forEach(({ levelData }, level) => {
    const size = edge >> level, texels = 4 * size * size;
    const halves = new Uint16Array(levelData.slice().buffer);
    faces.forEach((face, i) => face.mipmaps.push({ data: halves.slice(i * texels, (i + 1) * texels), width: size, height: size }));
  });
  const texture = new THREE.CompressedCubeTexture(faces, THREE.RGBAFormat, THREE.HalfFloatType);
  texture.mipmaps = faces[0].mipmaps;
  texture.minFilter = THREE.LinearMipmapLinearFilter;
  texture.magFilter = THREE.LinearFilter;
  texture.generateMipmaps = false;
  texture.isPMREMTexture = true;
  texture.needsUpdate = true;
  return texture;
}

// Diffuse light alone: scene.add(await loadLightProbe()).
export async function loadLightProbe(url = new URL('./{name}_sh.json', import.meta.url)) {
  const { three } = await (await fetch(url)).json();
  const probe = new THREE.LightProbe();
  three.forEach((c, i) => probe.sh.coefficients[i].fromArray(c));
  return probe;
}
)js"},
    Snippet{"model-viewer", R"html(<!doctype html>
<meta charset="utf-8">
<title>{name}</title>
<script type="module" src="https://unpkg.com/@google/model-viewer@4.4.0/dist/model-viewer.min.js"></script>
<model-viewer src="model.glb" environment-image="{name}.hdr" skybox-image="{name}.hdr" tone-mapping="neutral" camera-controls
  style="width: 100%; height: 90vh"></model-viewer>
)html"},
    Snippet{"filament", R"js(// Light for Filament on the web; native applications give the same two files to ktxreader::Ktx1Reader.
//   Filament.init(['{name}_ibl.ktx', '{name}_skybox.ktx'], () => { ... addLight(engine, scene); });
// With camera.setExposure(1.0, 1.2, 100.0), intensity 1 shows radiance as it is.
export function addLight(engine, scene, folder = '') {
  const light = engine.createIblFromKtx1(folder + '{name}_ibl.ktx');
  light.setIntensity(1);
  scene.setIndirectLight(light);
  scene.setSkybox(engine.createSkyFromKtx1(folder + '{name}_skybox.ktx'));
  return light;
}
)js"},
    Snippet{"babylon", R"js(// Light for Babylon.js.
//   scene.environmentTexture = loadEnvironment(scene);
import { CubeTexture } from '@babylonjs/core/Materials/Textures/cubeTexture.js';

export function loadEnvironment(scene, url = new URL('./{name}.env', import.meta.url).href) {
  const texture = CubeTexture.CreateFromPrefilteredData(url, scene, '.env');
  if (scene.useRightHandedSystem)
    texture.rotationY = Math.PI; // a right-handed scene shows every environment turned by half a turn
  return texture;
}
)js"},
    Snippet{"playcanvas", R"js(// Light for PlayCanvas: the atlas is read as it is, the cube shows behind the scene.
//   await addLight(app);
import * as pc from 'playcanvas';

const load = (app, name, type, file, data) => new Promise((resolve, reject) => {
  const asset = new pc.Asset(name, type, file, data);
  asset.on('load', () => resolve(asset.resource));
  asset.on('error', reject);
  app.assets.add(asset);
  app.assets.load(asset);
});

export async function addLight(app, folder = new URL('.', import.meta.url).href) {
  const atlas = { url: folder + '{name}_atlas.png', filename: '{name}_atlas.png' };
  app.scene.envAtlas = await load(app, '{name}_atlas', 'texture', atlas, { type: pc.TEXTURETYPE_RGBP, mipmaps: false, addressu: 'clamp', addressv: 'clamp' });
  const skybox = { url: folder + '{name}_skybox.dds', filename: '{name}_skybox.dds' };
  app.scene.skybox = await load(app, '{name}_skybox', 'texture', skybox, {});
}
)js"},
    Snippet{"bevy", R"rs(// Light for Bevy: put the two .ktx2 files into assets/.
use bevy::prelude::*;

pub fn environment_light(assets: &AssetServer) -> EnvironmentMapLight {
    EnvironmentMapLight {
        diffuse_map: assets.load("{name}_diffuse.ktx2"),
        specular_map: assets.load("{name}_specular.ktx2"),
        intensity: 1000.0, // radiance 1 as 1000 cd/m^2
        ..default()
    }
}
)rs"},
    Snippet{"blender", R"py(# World light for Blender: blender --python {name}_blender.py, or run it in the text editor.
# To install the lights for good, copy studiolights/ into Blender's datafiles folder. The latlong is turned for Blender's axes: +Y of the probe is up, its -Z is Blender's +Y, as in glTF.
import os
import bpy


def set_world(folder=os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else "//"):
    world = bpy.data.worlds.new("{name}")
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    nodes.clear()
    image = nodes.new("ShaderNodeTexEnvironment")
    image.image = bpy.data.images.load(os.path.join(folder, "studiolights", "world", "{name}.exr"))
    image.image.colorspace_settings.name = "Linear"
    background = nodes.new("ShaderNodeBackground")
    output = nodes.new("ShaderNodeOutputWorld")
    links.new(image.outputs["Color"], background.inputs["Color"])
    links.new(background.outputs["Background"], output.inputs["Surface"])
    bpy.context.scene.world = world
    return world


def install_studio_light(folder=os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else "//"):
    """Adds the light to the viewport's list of worlds."""
    bpy.context.preferences.studio_lights.load(os.path.join(folder, "studiolights", "world", "{name}.exr"), "WORLD")


if __name__ == "__main__":
    set_world()
)py"},
    Snippet{"godot", R"gd(# Light for Godot 3: put both files into the project; in _ready():
#   get_viewport().world.environment = preload("{name}_godot.gd").make_environment()
extends Reference

static func make_environment(path = "res://{name}.hdr"):
	var texture = load(path) if ResourceLoader.exists(path) else null
	if texture == null:
		var image = Image.new()
		image.load(path)
		texture = ImageTexture.new()
		texture.create_from_image(image, Texture.FLAG_FILTER)
	var sky = PanoramaSky.new()
	sky.panorama = texture
	sky.radiance_size = Sky.RADIANCE_SIZE_512
	var environment = Environment.new()
	environment.background_mode = Environment.BG_SKY
	environment.background_sky = sky
	environment.ambient_light_sky_contribution = 1.0
	return environment
)gd"},
    Snippet{"unity", R"cs(// Imports {name}.hdr as a cube with specular convolution. Put Editor/ and the picture into Assets.
using UnityEditor;
using UnityEngine;

public class {id}Import : AssetPostprocessor
{
    void OnPreprocessTexture()
    {
        if (!assetPath.EndsWith("{name}.hdr"))
            return;
        var importer = (TextureImporter)assetImporter;
        importer.textureShape = TextureImporterShape.TextureCube;
        importer.generateCubemap = TextureImporterGenerateCubemap.Cylindrical;
        var settings = new TextureImporterSettings();
        importer.ReadTextureSettings(settings);
        settings.cubemapConvolution = TextureImporterCubemapConvolution.Specular;
        settings.seamlessCubemap = true;
        importer.SetTextureSettings(settings);
        importer.sRGBTexture = false;
        importer.mipmapEnabled = true;
    }
}
)cs"},
    Snippet{"unreal",
            R"py(# Imports {name}.hdr as a cube and lights the level with it: run it in Unreal's Python console, with the folder's path.
import os
import unreal


def import_light(folder, destination="/Game/Light"):
    task = unreal.AssetImportTask()
    task.filename = os.path.join(folder, "{name}.hdr")
    task.destination_path = destination
    task.automated = True
    task.save = True
    unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks([task])
    cube = unreal.load_asset(destination + "/{name}")
    light = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.SkyLight, unreal.Vector(0.0, 0.0, 0.0))
    component = light.light_component
    component.set_editor_property("source_type", unreal.SkyLightSourceType.SLS_SPECIFIED_CUBEMAP)
    component.set_editor_property("cubemap", cube)
    component.set_editor_property("mobility", unreal.ComponentMobility.MOVABLE)
    return light
)py"},
    Snippet{"usd", R"usda(#usda 1.0
(
    defaultPrim = "{id}"
    metersPerUnit = 1
    upAxis = "Y"
)

def DomeLight "{id}"
{
    float inputs:intensity = 1
    asset inputs:texture:file = @./{name}.exr@
    token inputs:texture:format = "latlong"
}
)usda"},
    Snippet{"materialx", R"mtlx(<?xml version="1.0"?>
<materialx version="1.38" colorspace="lin_rec709">
  <!-- MaterialXView takes the picture itself: materialxview --envRad {name}.hdr -->
  <nodegraph name="environment_{id}">
    <latlongimage name="radiance" type="color3">
      <input name="file" type="filename" value="{name}.hdr" />
    </latlongimage>
    <output name="out" type="color3" nodename="radiance" />
  </nodegraph>
</materialx>
)mtlx"},
};

void replaceAll(std::string& text, std::string_view mark, std::string_view with)
{
    for (size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + with.size()))
        text.replace(at, mark.size(), with);
}

/// A name as languages take it.
std::string identifier(std::string_view name)
{
    std::string word(name);
    for (char& c : word)
        if (c == '-')
            c = '_';
    return word.empty() || (word.front() >= '0' && word.front() <= '9') ? "_" + word : word;
}

} // namespace

std::string engineSnippet(std::string_view word, std::string_view name)
{
    for (const Snippet& snippet : snippets)
        if (snippet.word == word) {
            std::string text(snippet.text);
            replaceAll(text, "{name}", name);
            replaceAll(text, "{id}", identifier(name));
            return text;
        }
    return {};
}

} // namespace mirrorball
