// The files as other readers see them: ktx-parse for .ktx2, and that every level of it is where its header says.
//   node check_containers.mjs MIRRORBALL
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { read, write } from 'ktx-parse';

const folder = mkdtempSync(join(tmpdir(), 'mirrorball-ktx-'));
let failed = 0;
const check = (name, passed, shown) => {
  failed += !passed;
  console.log(`${passed ? 'ok  ' : 'FAIL'} ktx-parse   ${name} ${shown}`);
};
try {
  execFileSync(process.argv[2], ['export', '--probe', 'builtin:axes', '--for', 'bevy', '--name', 'light', '-o', folder], { stdio: 'ignore' });
  for (const [file, edge, levels] of [['light_diffuse.ktx2', 32, 1], ['light_specular.ktx2', 256, 9]]) {
    const bytes = readFileSync(join(folder, file));
    const container = read(bytes);
    check(`${file} size`, container.pixelWidth === edge && container.faceCount === 6 && container.levels.length === levels, `${container.pixelWidth}, ${container.levels.length} levels`);
    check(`${file} levels`, container.levels.every((level, i) => level.levelData.length === 6 * 8 * Math.max(1, edge >> i) ** 2), '');
    const [descriptor] = container.dataFormatDescriptor;
    check(`${file} descriptor`, container.vkFormat === 97 && descriptor.colorModel === 1 && descriptor.samples.length === 4 && descriptor.bytesPlane[0] === 8, `VkFormat ${container.vkFormat}`);
    check(`${file} metadata`, String(container.keyValue.KTXorientation ?? '').startsWith('rd'), JSON.stringify(container.keyValue));
    // Written again by ktx-parse, it says the same: nothing was lost or misread.
    const again = read(write(container));
    check(`${file} round trip`, again.levels.every((level, i) => Buffer.compare(Buffer.from(level.levelData), Buffer.from(container.levels[i].levelData)) === 0), '');
  }
} finally {
  rmSync(folder, { recursive: true, force: true });
}
process.exit(failed ? 1 : 0);
