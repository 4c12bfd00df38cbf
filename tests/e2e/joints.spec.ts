/** A person's word that a joint is a part of the body: computed with, handed on, taken back. */
import { expectResult } from './support/expect-result';
import { sampleFiles } from './support/motions';
import { type Report, reportOf } from './support/reports';
import { expect, test } from './support/test';

test('a joint is corrected, for other clips of its skeleton, for those that come later; and back', async ({
  app,
  page,
}) => {
  const [first = '', second = '', later = ''] = sampleFiles(
    'walk-hik-30',
    'slow-dance-hik-30',
    'run-hik-30',
  );
  const usual = reportOf(first);
  const jointOf = ({ body }: Report, role: string): string =>
    body.joints.find((one) => one.role === role)?.joint ?? '';
  const finger = jointOf(usual, 'left_finger');
  const wrist = jointOf(usual, 'left_wrist');
  const option = ['--joint', `left_finger=${wrist}`];
  await app.openWith(first, second);
  await app.tab('Body');
  const field = app.field('Left finger');
  const shown = () =>
    field.evaluate((select: HTMLSelectElement) => select.selectedOptions[0]?.text);
  const row = page.locator('.joint-row', { has: field });
  const name = finger.replace(/\/end$/, ' · end');
  const open = (path: string) =>
    app
      .row(path.split('/').pop() ?? '')
      .getByRole('button')
      .first()
      .click();
  const expectJoint = async (path: string, byHand: boolean): Promise<void> => {
    await open(path);
    await app.settled();
    await expect.poll(shown).toBe(byHand ? wrist : name);
    await expect(row.locator('.joint-source')).toHaveAttribute(
      'title',
      byHand ? 'by hand' : 'by name',
    );
    await app.tab('Method');
    await expectResult(app, reportOf(path, ...(byHand ? option : [])));
    await app.tab('Body');
  };
  await expectJoint(first, false);
  await field.focus();
  await expect(row).toHaveClass(/pointed/);
  await expect(page.locator('.joint-ring')).toHaveCount(1);
  await field.selectOption({ label: wrist });
  await expectJoint(first, true);
  await expectJoint(second, false);
  await open(first);
  await app.button('Apply to the other clip with this skeleton').click();
  await expectJoint(second, true);
  await app.drop(later);
  await expect(app.rows).toHaveCount(3);
  await expectJoint(later, true);
  await open(second);
  await app.button('Undo: joint').click();
  await expectJoint(second, false);
  await expectJoint(first, true);
  await app.button('Back to automatic: Left finger').click();
  await expectJoint(first, false);
});
