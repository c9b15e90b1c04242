// Filament shows what 8 bits hold: five exposures of a picture make one of any range that a lamp or a sun's glow has, up to 4096.
const load = url => new Promise((resolve, reject) => {
  const script = document.createElement('script');
  script.src = url;
  script.onload = resolve;
  script.onerror = () => reject(new Error('cannot load ' + url));
  document.head.append(script);
});

export async function open({ canvas, folder, name, size, ktx }) {
  await load('/npm/gl-matrix/gl-matrix.js').catch(() => load('/npm/gl-matrix/gl-matrix-min.js'));
  for (const key of ['vec4', 'mat3', 'mat4', 'vec3', 'quat'])
    window[key] = window.glMatrix[key];
  await load('/npm/filament/filament.js');
  const ibl = `${folder}/${name}_ibl.ktx`, skybox = `${folder}/${name}_skybox.ktx`;
  const balls = ['/balls.glb'];
  await new Promise(resolve => window.Filament.init([ibl, skybox, ...balls], resolve));
  const Filament = window.Filament; // init() replaces the function by the module
  canvas.width = canvas.height = size;
  const engine = Filament.Engine.create(canvas, { preserveDrawingBuffer: true, antialias: false });
  const scene = engine.createScene();
  const { addLight } = await import(`${folder}/${name}_filament.js`);
  const light = addLight(engine, scene, folder + '/');
  scene.setSkybox(null);
  const renderer = engine.createRenderer(), swapChain = engine.createSwapChain(), view = engine.createView();
  const camera = engine.createCamera(Filament.EntityManager.get().create());
  camera.setProjection(Filament.Camera$Projection.ORTHO, -1, 1, -1, 1, 0.1, 10);
  camera.lookAt([0, 0, 5], [0, 0, 0], [0, 1, 0]);
  camera.setExposure(1.0, 1.2, 100.0);
  view.setCamera(camera);
  view.setScene(scene);
  view.setViewport([0, 0, size, size]);
  view.setPostProcessingEnabled(false); // linear light as it is, clipped
  view.setAntiAliasing(Filament.View$AntiAliasing.NONE);
  const loader = engine.createAssetLoader();
  const asset = loader.createAsset('/balls.glb');
  await new Promise(resolve => asset.loadResources(resolve, () => {}, null, 1));
  const gl = canvas.getContext('webgl2');
  const shown = async (entity, intensity) => {
    light.setIntensity(intensity);
    scene.addEntity(entity);
    const bytes = new Uint8Array(4 * size * size);
    for (let frame = 0; frame < 3; ++frame) {
      renderer.render(swapChain, view);
      engine.execute();
      await new Promise(resolve => requestAnimationFrame(resolve));
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    scene.remove(entity);
    return bytes;
  };
  return {
    async render({ kind, roughness }) {
      const wanted = kind === 'metal' ? 'metal' + Math.round(100 * roughness) : 'diffuse';
      const entity = asset.getFirstEntityByName(wanted);
      if (!entity)
        throw new Error('no ball named ' + wanted);
      const rgba = new Float32Array(4 * size * size);
      const darkest = 1 / 4096;
      for (const intensity of [darkest, 1 / 512, 1 / 64, 1 / 8, 1]) {
        const bytes = await shown(entity, intensity);
        bytes.forEach((byte, i) => {
          if (byte < 255 || intensity === darkest)
            rgba[i] = byte / 255 / intensity;
        });
      }
      return window.upright(rgba, size);
    },
  };
}
