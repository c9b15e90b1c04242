import * as pc from 'playcanvas';

/** An application that draws only when it is asked to. */
export function application(canvas) {
  const app = new pc.Application(canvas, { graphicsDeviceOptions: { antialias: false } });
  app.autoRender = false;
  app.start();
  return app;
}

/** A latlong's file as a texture. */
export async function latlong(app, url) {
  const asset = new pc.Asset('latlong', 'texture', { url }, { mipmaps: false, projection: 'equirect' });
  await new Promise((resolve, reject) => {
    asset.on('load', resolve);
    asset.on('error', reject);
    app.assets.add(asset);
    app.assets.load(asset);
  });
  asset.resource.projection = pc.TEXTUREPROJECTION_EQUIRECT;
  return asset.resource;
}

/** PlayCanvas' own prefilter of it: its envAtlas. */
export function ownAtlas(texture) {
  return pc.EnvLighting.generateAtlas(pc.EnvLighting.generateLightingSource(texture));
}
