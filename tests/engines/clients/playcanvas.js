import * as pc from 'playcanvas';
import { application, latlong, ownAtlas } from './playcanvas_latlong.js';

export async function open({ canvas, folder, name, size, own }) {
  const app = application(canvas);
  if (own) {
    app.scene.envAtlas = ownAtlas(await latlong(app, `${folder}/${own}`));
  } else {
    await (await import(`${folder}/${name}_playcanvas.js`)).addLight(app, folder + '/');
  }
  app.scene.ambientLight = new pc.Color(0, 0, 0);
  const texture = new pc.Texture(app.graphicsDevice, { width: size, height: size, format: pc.PIXELFORMAT_RGBA32F, mipmaps: false });
  const target = new pc.RenderTarget({ colorBuffer: texture, depth: true, samples: 1 });
  const eye = new pc.Entity();
  eye.addComponent('camera', { projection: pc.PROJECTION_ORTHOGRAPHIC, orthoHeight: 1, nearClip: 990, farClip: 1010, clearColor: new pc.Color(0, 0, 0, 1) });
  eye.camera.gammaCorrection = pc.GAMMA_NONE;
  eye.camera.toneMapping = pc.TONEMAP_NONE;
  eye.camera.renderTarget = target;
  eye.camera.layers = [pc.LAYERID_WORLD];
  eye.setPosition(0, 0, 1000); // its shader sees from a point even so; far away, that is parallel
  app.root.addChild(eye);
  const mesh = pc.Mesh.fromGeometry(app.graphicsDevice, new pc.SphereGeometry({ radius: 1, latitudeBands: 200, longitudeBands: 200 }));
  const instance = new pc.MeshInstance(mesh, new pc.StandardMaterial());
  const ball = new pc.Entity();
  ball.addComponent('render', { meshInstances: [instance] });
  app.root.addChild(ball);
  return {
    async render({ kind, roughness }) {
      const material = new pc.StandardMaterial();
      material.diffuse = new pc.Color(1, 1, 1);
      if (kind === 'metal') {
        material.useMetalness = true;
        material.metalness = 1;
        material.gloss = 1 - roughness;
      } else {
        material.specular = new pc.Color(0, 0, 0);
        material.gloss = 0;
      }
      material.update();
      instance.material = material;
      for (let frame = 0; frame < 3; ++frame) {
        app.renderNextFrame = true;
        await new Promise(resolve => app.once('frameend', resolve));
      }
      const rgba = await texture.read(0, 0, size, size, { renderTarget: target, immediate: true });
      return window.upright(rgba, size);
    },
  };
}
