// A ball of radius 1, seen from +Z by an orthographic camera that it fills: the pixel says the normal.
import * as THREE from 'three';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';

export async function open({ canvas, folder, name, size, own }) {
  const renderer = new THREE.WebGLRenderer({ canvas });
  renderer.toneMapping = THREE.NoToneMapping;
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
  camera.position.z = 5;
  const scene = new THREE.Scene();
  const ball = new THREE.Mesh(new THREE.SphereGeometry(1, 512, 256));
  scene.add(ball);
  if (own) { // the engine's own prefilter of the latlong
    const latlong = await new HDRLoader().setDataType(THREE.FloatType).loadAsync(`${folder}/${name}.hdr`);
    latlong.mapping = THREE.EquirectangularReflectionMapping;
    scene.environment = new THREE.PMREMGenerator(renderer).fromEquirectangular(latlong).texture;
  } else {
    scene.environment = await (await import(`${folder}/${name}_three.js`)).loadEnvironment();
  }
  const probe = own ? null : await (await import(`${folder}/${name}_three.js`)).loadLightProbe();
  const target = new THREE.WebGLRenderTarget(size, size, { type: THREE.FloatType });
  return {
    async render({ kind, roughness }) {
      const environment = scene.environment;
      ball.material = kind === 'metal' ? new THREE.MeshStandardMaterial({ metalness: 1, roughness })
        : new THREE.MeshPhysicalMaterial({ metalness: 0, roughness: 1, specularIntensity: 0 });
      if (kind === 'sh') {
        scene.environment = null;
        scene.add(probe);
      }
      renderer.setRenderTarget(target);
      renderer.render(scene, camera);
      const rgba = new Float32Array(4 * size * size);
      renderer.readRenderTargetPixels(target, 0, 0, size, size, rgba);
      scene.environment = environment;
      if (kind === 'sh')
        scene.remove(probe);
      return window.upright(rgba, size);
    },
  };
}
