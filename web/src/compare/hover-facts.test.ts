import { expect, test } from 'vitest';
import type { Explanation } from '../engine/comparison-types';
import { HoverFacts } from './hover-facts';

const turn = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

test('of the pairs that a pointer ran over, the first and the last are asked for', async () => {
  const asked: string[] = [];
  const explain = async (a: number, b: number): Promise<Explanation> => {
    asked.push(`${a} ${b}`);
    await turn();
    return { a, b } as Explanation;
  };
  const facts = new HoverFacts({ explain });
  for (const b of [1, 2, 3]) facts.ask({ a: 0, b });
  await turn();
  await turn();
  await turn();
  expect(asked).toEqual(['0 1', '0 3']);
  expect(facts.known.value).toMatchObject({ a: 0, b: 3 });
});

test('what is known is not asked for again, until it is forgotten', async () => {
  let count = 0;
  const facts = new HoverFacts({
    explain: (a, b) => {
      count += 1;
      return Promise.resolve({ a, b } as Explanation);
    },
  });
  facts.ask({ a: 0, b: 1 });
  await turn();
  facts.ask({ a: 0, b: 1 });
  await turn();
  expect(count).toBe(1);
  facts.forget();
  facts.ask({ a: 0, b: 1 });
  await turn();
  expect(count).toBe(2);
});

test('a pair that cannot be explained leaves what was known', async () => {
  const facts = new HoverFacts({ explain: () => Promise.reject(new Error('gone')) });
  facts.ask({ a: 0, b: 1 });
  await turn();
  expect(facts.known.value).toBeNull();
});

test('what was asked of a pair that the pointer has left is given up, and asked again if it returns', async () => {
  const told: string[] = [];
  const facts = new HoverFacts({
    explain: (a, b, { signal } = {}) =>
      new Promise((resolve, reject) => {
        const timer = setTimeout(() => resolve({ a, b } as Explanation));
        signal?.addEventListener('abort', () => {
          told.push(`${a} ${b} given up`);
          clearTimeout(timer);
          reject(new DOMException('', 'AbortError'));
        });
      }),
  });
  facts.ask({ a: 0, b: 1 });
  facts.ask({ a: 0, b: 1 });
  expect(told).toEqual([]);
  facts.ask({ a: 0, b: 2 });
  facts.ask({ a: 0, b: 1 });
  await turn();
  await turn();
  expect(told).toEqual(['0 1 given up']);
  expect(facts.known.value).toMatchObject({ a: 0, b: 1 });
});
