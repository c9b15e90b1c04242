import { Engine } from '@babylonjs/core/Engines/engine.js';
import { Scene } from '@babylonjs/core/scene.js';
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Camera } from '@babylonjs/core/Cameras/camera.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Color3, Color4 } from '@babylonjs/core/Maths/math.color.js';
import { CreateSphere } from '@babylonjs/core/Meshes/Builders/sphereBuilder.js';
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js';
import { RenderTargetTexture } from '@babylonjs/core/Materials/Textures/renderTargetTexture.js';
import { HDRCubeTexture } from '@babylonjs/core/Materials/Textures/hdrCubeTexture.js';
import { Constants } from '@babylonjs/core/Engines/constants.js';
import '@babylonjs/core/Materials/Textures/Loaders/envTextureLoader.js';
import '@babylonjs/core/Materials/Textures/Loaders/ddsTextureLoader.js';
import '@babylonjs/core/Engines/Extensions/engine.cubeTexture.js';
import '@babylonjs/core/Engines/Extensions/engine.renderTarget.js';
import '@babylonjs/core/Engines/Extensions/engine.rawTexture.js';
import '@babylonjs/core/Engines/Extensions/engine.readTexture.js';
import '@babylonjs/core/Materials/Textures/baseTexture.polynomial.js';
import '@babylonjs/core/Engines/Extensions/engine.prefilteredCubeTexture.js';

export async function open({ canvas, folder, name, size, own, rightHanded }) {
  const engine = new Engine(canvas, false, { preserveDrawingBuffer: true });
  const scene = new Scene(engine);
  scene.useRightHandedSystem = !!rightHanded;
  scene.clearColor = new Color4(0, 0, 0, 1);
  scene.imageProcessingConfiguration.applyByPostProcess = true; // leaves radiance as it is
  // The eye stands before the ball: at +Z where the system is right-handed, else at -Z, so that +X is on the right.
  const camera = new FreeCamera('camera', new Vector3(0, 0, rightHanded ? 1000 : -1000), scene);
  camera.setTarget(Vector3.Zero());
  camera.mode = Camera.ORTHOGRAPHIC_CAMERA;
  [camera.minZ, camera.maxZ] = [990, 1010]; // its shader sees from a point even so; far away, that is parallel
  [camera.orthoLeft, camera.orthoRight, camera.orthoBottom, camera.orthoTop] = [-1, 1, -1, 1];
  const ball = CreateSphere('ball', { diameter: 2, segments: 128 }, scene);
  const { loadEnvironment } = await import(`${folder}/${name}_babylon.js`);
  const environment = own ? new HDRCubeTexture(`${folder}/${own}`, scene, 256, false, true, false, true) : loadEnvironment(scene);
  await new Promise((resolve, reject) => {
    const check = () => environment.isReady() ? resolve() : setTimeout(check, 20);
    setTimeout(() => reject(new Error('the environment does not load')), 60000);
    check();
  });
  scene.environmentTexture = environment;
  const target = new RenderTargetTexture('picture', size, scene, { type: Constants.TEXTURETYPE_FLOAT, generateMipMaps: false });
  target.renderList.push(ball);
  target.activeCamera = camera;
  return {
    async render({ kind, roughness }) {
      const material = new PBRMaterial('white', scene);
      material.albedoColor = Color3.White();
      material.metallic = kind === 'metal' ? 1 : 0;
      material.roughness = kind === 'metal' ? roughness : 1;
      if (kind !== 'metal')
        material.metallicF0Factor = 0;
      ball.material = material;
      await material.forceCompilationAsync(ball);
      while (!target.isReadyForRendering())
        await new Promise(resolve => setTimeout(resolve, 20));
      target.render();
      return window.upright(await target.readPixels(), size);
    },
  };
}
