import { expect, test } from 'vitest';
import { svgSheet, tag, textTag } from './svg-text';

test('names from files cannot leave their place', () => {
  expect(textTag('a<b> & "c"\u0001', { x: 1 })).toBe(
    '<text x="1">a&lt;b&gt; &amp; &quot;c&quot;</text>',
  );
  expect(tag('rect', { fill: '"><script' })).toBe('<rect fill="&quot;&gt;&lt;script"/>');
});

test('numbers have at most three digits after the point', () => {
  expect(tag('rect', { x: 1 / 3, width: 2 })).toBe('<rect x="0.333" width="2"/>');
});

test('a sheet has its ground and its title', () => {
  const sheet = svgSheet({ width: 10, height: 5, ground: '#fff', title: 'a & b' }, '<g/>');
  expect(sheet).toContain('viewBox="0 0 10 5"');
  expect(sheet).toContain('<title>a &amp; b</title><rect width="10" height="5" fill="#fff"/><g/>');
});
