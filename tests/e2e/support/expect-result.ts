// What the panel says of a result, against the command line's. In: the app with its tab Method chosen.
import { expect } from '@playwright/test';
import type { AppPage } from './app-page';
import type { Report } from './reports';

export async function expectResult(app: AppPage, report: Report): Promise<void> {
  await app.settled();
  const zero = report.candidates.filter(({ intensity }) => intensity === 0).length;
  const result = app.section('Result');
  await expect(result).toContainText(
    `${report.candidates.length} candidates, ${zero} of zero intensity, in ${report.clusters} cluster`,
  );
  const count = report.keyposes.length;
  await expect(result).toContainText(`${count} keypose${count === 1 ? '' : 's'}`);
}
