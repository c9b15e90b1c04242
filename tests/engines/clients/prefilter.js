// An engine's own prefilter of a latlong, read back: picture({ level, face }) is a face of a level as the texture holds it, RGB floats,
// its first row first; picture({}) is [edge of level 0, levels, milliseconds that the prefilter took]. PlayCanvas' is an atlas: picture({}) is
// [edge, 0, milliseconds], picture({ atlas: true }) its bytes as RGBA, each a float.
export async function open({ canvas, folder, name, engine }) {
  if (engine === 'playcanvas')
    return playCanvas({ canvas, url: `${folder}/${name}.hdr` });
  const { gl, texture, size, levels, milliseconds } = await own[engine]({ canvas, url: `${folder}/${name}.hdr` });
  gl.getExtension('EXT_color_buffer_float');
  gl.getExtension('EXT_color_buffer_half_float');
  const framebuffer = gl.createFramebuffer();
  return {
    async render({ level, face }) {
      if (level === undefined)
        return new Float32Array([size, levels, milliseconds]);
      const edge = Math.max(1, size >> level), rgba = new Float32Array(4 * edge * edge);
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_CUBE_MAP_POSITIVE_X + face, texture, level);
      if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE)
        throw new Error(`level ${level} cannot be read`);
      gl.readPixels(0, 0, edge, edge, gl.RGBA, gl.FLOAT, rgba);
      if (gl.getError() !== gl.NO_ERROR)
        throw new Error(`level ${level} cannot be read as floats`);
      return rgba.filter((_, i) => i % 4 !== 3);
    },
  };
}

const own = {
  async three({ canvas, url }) {
    const THREE = await import('three');
    const { HDRLoader } = await import('three/addons/loaders/HDRLoader.js');
    const renderer = new THREE.WebGLRenderer({ canvas });
    const latlong = await new HDRLoader().setDataType(THREE.FloatType).loadAsync(url);
    latlong.mapping = THREE.EquirectangularReflectionMapping;
    const gl = renderer.getContext(), start = performance.now();
    const { texture } = new THREE.PMREMGenerator(renderer).fromEquirectangular(latlong);
    gl.finish();
    return { gl, texture: renderer.properties.get(texture).__webglTexture, size: texture.image?.width ?? texture.source.data[0].width,
      levels: texture.mipmaps.length, milliseconds: performance.now() - start };
  },
  async babylon({ canvas, url }) {
    const { Engine } = await import('@babylonjs/core/Engines/engine.js');
    const { Scene } = await import('@babylonjs/core/scene.js');
    const { HDRCubeTexture } = await import('@babylonjs/core/Materials/Textures/hdrCubeTexture.js');
    await Promise.all(['engine.cubeTexture', 'engine.renderTarget', 'engine.rawTexture', 'engine.prefilteredCubeTexture', 'engine.renderTargetCube']
      .map(extension => import(`@babylonjs/core/Engines/Extensions/${extension}.js`)));
    const engine = new Engine(canvas), scene = new Scene(engine), start = performance.now();
    const texture = await new Promise((resolve, reject) => {
      const made = new HDRCubeTexture(url, scene, 256, false, true, false, true, () => resolve(made), (_, error) => reject(error ?? new Error('the environment does not load')));
    });
    const gl = engine._gl;
    gl.finish();
    return { gl, texture: texture.getInternalTexture()._hardwareTexture.underlyingResource, size: texture.getSize().width,
      levels: Math.log2(texture.getSize().width) + 1, milliseconds: performance.now() - start };
  },
};

async function playCanvas({ canvas, url }) {
  const pc = await import('playcanvas');
  const { application, latlong, ownAtlas } = await import('./playcanvas_latlong.js');
  const texture = await latlong(application(canvas), url), start = performance.now();
  const atlas = ownAtlas(texture);
  const bytes = await atlas.read(0, 0, atlas.width, atlas.height, { immediate: true });
  const milliseconds = performance.now() - start;
  if (atlas.type !== pc.TEXTURETYPE_RGBP || bytes.length !== 4 * atlas.width * atlas.height)
    throw new Error(`the atlas is of type ${atlas.type}, ${bytes.length} bytes`);
  return { render: async ({ atlas: whole }) => whole ? Float32Array.from(bytes) : new Float32Array([atlas.width, 0, milliseconds]) };
}
