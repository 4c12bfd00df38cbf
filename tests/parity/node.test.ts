/** The command line and the WebAssembly module in Node say the same, to the last bit. */
import { expect, it } from 'vitest';
import { createEngine } from '../../web/src/engine/engine';
import { spawnAround, testCore } from '../../web/src/engine/test-engine';
import { parityMotions } from './motions';
import { nativeReports, withoutName } from './native';

it('gives the reports of the command line', async ({ skip }) => {
  const core = await testCore();
  const motions = parityMotions(core);
  const native = nativeReports(motions);
  if (native === null) return skip();
  expect(native).toHaveLength(motions.length);
  const engine = createEngine({ spawn: spawnAround(core), workers: 1 });
  for (const [id, { name, bytes }] of motions.entries()) {
    await engine.open(id, { name, folder: '', blob: new Blob([bytes]) }, {}, {});
    const line = await engine.exportText(id, 'keyposes-json');
    expect(withoutName(line), name).toBe(native[id]);
    engine.close(id);
  }
  engine.destroy();
}, 120_000);
