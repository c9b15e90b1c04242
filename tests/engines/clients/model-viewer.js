// The balls of balls.glb in <model-viewer>, which brings a three.js of its own: its scene is drawn by its renderer through an orthographic
// eye, into floats, before tone mapping.
import { FloatType, WebGLRenderTarget } from 'three';
import '/npm/@google/model-viewer/dist/model-viewer.min.js';

/** A member that model-viewer keeps under a symbol, its own or a class's. */
function inside(viewer, name) {
  for (let owner = viewer; owner; owner = Object.getPrototypeOf(owner))
    for (const symbol of Object.getOwnPropertySymbols(owner))
      if (symbol.description === name)
        return viewer[symbol];
  throw new Error(`model-viewer has no ${name}`);
}

export async function open({ folder, name, size }) {
  const viewer = document.createElement('model-viewer');
  viewer.style.width = viewer.style.height = `${size}px`;
  const loaded = new Promise((resolve, reject) => {
    viewer.addEventListener('load', resolve);
    viewer.addEventListener('error', event => reject(new Error(`model-viewer: ${event.detail?.type}: ${event.detail?.sourceError}`)));
  });
  const lit = new Promise(resolve => viewer.addEventListener('environment-change', resolve));
  viewer.src = '/balls.glb';
  viewer.environmentImage = `${folder}/${name}.hdr`;
  document.body.append(viewer);
  await Promise.all([loaded, lit]);
  const scene = inside(viewer, 'scene'), renderer = inside(viewer, 'renderer').threeRenderer;
  const balls = {};
  scene.traverse(thing => {
    if (thing.isMesh && /^(metal|diffuse)/.test(thing.material.name ?? ''))
      balls[thing.material.name] = thing;
  });
  const camera = scene.camera.clone();
  Object.assign(camera, { isPerspectiveCamera: false, isOrthographicCamera: true, parent: null });
  camera.matrixAutoUpdate = false;
  camera.updateMatrixWorld = () => {};
  camera.updateProjectionMatrix = () => {};
  camera.projectionMatrix.set(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.2, -1, 0, 0, 0, 1);
  camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
  const target = new WebGLRenderTarget(size, size, { type: FloatType });
  return {
    async render({ kind, roughness }) {
      const wanted = kind === 'metal' ? 'metal' + Math.round(100 * roughness) : 'diffuse';
      for (const [word, ball] of Object.entries(balls))
        ball.visible = word === wanted;
      const ball = balls[wanted];
      ball.updateWorldMatrix(true, false);
      const { background } = scene;
      scene.background = null;
      // The ball's center, seen from +Z; model-viewer moves and scales models.
      const at = ball.matrixWorld.elements;
      const scale = Math.hypot(at[0], at[1], at[2]);
      camera.matrixWorld.makeTranslation(at[12], at[13], at[14] + 5 * scale);
      camera.matrixWorldInverse.copy(camera.matrixWorld).invert();
      camera.projectionMatrix.set(1 / scale, 0, 0, 0, 0, 1 / scale, 0, 0, 0, 0, -0.1 / scale, 0, 0, 0, 0, 1);
      camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
      renderer.setRenderTarget(target);
      renderer.setViewport?.(0, 0, size, size);
      renderer.clear();
      renderer.render(scene, camera);
      const rgba = new Float32Array(4 * size * size);
      renderer.readRenderTargetPixels(target, 0, 0, size, size, rgba);
      renderer.setRenderTarget(null);
      scene.background = background;
      return window.upright(rgba, size);
    },
  };
}
