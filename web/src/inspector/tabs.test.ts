import { expect, test } from 'vitest';
import { tabByKey } from './tabs';

test('keys go round the tabs', () => {
  expect(tabByKey('ArrowRight', 'method')).toBe('body');
  expect(tabByKey('ArrowRight', 'export')).toBe('method');
  expect(tabByKey('ArrowLeft', 'method')).toBe('export');
  expect(tabByKey('ArrowLeft', 'export')).toBe('doctor');
  expect(tabByKey('Home', 'doctor')).toBe('method');
  expect(tabByKey('End', 'body')).toBe('export');
  expect(tabByKey('k', 'body')).toBeNull();
});
