/**
 * Controller languages for the editor: their colours, and what opens and closes in them.
 *
 * @import { ProgramDoc } from '../../model/document.js'
 */
import { StreamLanguage } from '@codemirror/language';
import { tags } from '@lezer/highlight';
import { READERS } from './codeTokens.js';

const KAREL = StreamLanguage.define({
  token: READERS.karel,
  languageData: { commentTokens: { line: '--' }, closeBrackets: { brackets: ['(', '[', "'"] } },
});

const TP = StreamLanguage.define({
  token: READERS['fanuc-tp'],
  tokenTable: { lineNumber: tags.lineComment },
  languageData: { commentTokens: { line: '!' } },
});

const KRL = StreamLanguage.define({ token: READERS.krl, languageData: { commentTokens: { line: ';' } } });

/** @type {Record<ProgramDoc['language'], StreamLanguage<unknown>>} */
export const LANGUAGES = { karel: KAREL, 'fanuc-tp': TP, krl: KRL };
