/** The command line and the WebAssembly module in Node say the same, to the last bit. */
import { expect, it } from 'vitest';
import { createEngine } from '../../web/src/engine/engine';
import { spawnAround, testCore } from '../../web/src/engine/test-engine';
import { parityMotions } from './motions';
import { nativeReports, withoutName } from './native';

const tables = [
  { kind: 'keyposes-json', options: [] },
  { kind: 'candidates-json', options: ['--candidates'] },
  { kind: 'traces-json', options: ['--traces'] },
] as const;

it('gives the reports of the command line', async ({ skip }) => {
  const core = await testCore();
  const motions = parityMotions(core);
  const native = tables.map(({ options }) => nativeReports(motions, ...options));
  const engine = createEngine({ spawn: spawnAround(core), workers: 1 });
  for (const [id, { name, bytes }] of motions.entries()) {
    await engine.open(id, { name, folder: '', blob: new Blob([bytes]) }, {}, {});
    for (const [table, { kind }] of tables.entries()) {
      const lines = native[table] ?? null;
      if (lines === null) return skip();
      expect(lines).toHaveLength(motions.length);
      // A line is too long to be shown where it differs.
      const isSame = withoutName(await engine.exportText(id, kind)) === lines[id];
      expect(isSame, `${name} ${kind}`).toBe(true);
    }
    engine.close(id);
  }
  engine.destroy();
}, 240_000);
