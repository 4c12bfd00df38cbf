/** For tests: the words of every page in both languages, as when all of them have been fetched. */
import { book as english } from './book-en';
import { book as japanese } from './book-ja';
import { addWords } from './catalogue';
import { book as englishSets } from './set-book-en';
import { book as japaneseSets } from './set-book-ja';

addWords('en', english);
addWords('en', englishSets);
addWords('ja', japanese);
addWords('ja', japaneseSets);
