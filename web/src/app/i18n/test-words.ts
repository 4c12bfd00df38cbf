/** For tests: the sentences of every page, as when all of them have been fetched. */
import { addWords } from './catalogue';
import { setWords } from './set-words';

addWords(setWords);
