/**
 * Lists of statements, up to the word that ends them, and how the parser goes on after a fault: a statement that is none is
 * left out, up to the next line; a word that ends a block which nobody opened is left out, too.
 *
 * @import { Comment, Statement } from '../tree.js'
 * @import { Cursor } from './cursor.js'
 */
import { finished, PIECE } from '../slices.js';
import { FAULT, shownToken } from './cursor.js';

const CLOSERS = new Set(
  `ELSE ENDIF ENDFOR ENDWHILE UNTIL ENDSELECT CASE END ENDUSING ENDCONDITION ENDMOVE WHEN BEGIN ROUTINE PROGRAM VAR CONST
   TYPE`.split(/\s+/),
);

/** What only ever stands outside of statements: a body that lacks its END ends there. */
const OUTSIDE = new Set(['END', 'BEGIN', 'ROUTINE', 'PROGRAM', 'VAR', 'CONST', 'TYPE']);

/**
 * Statements up to one of `enders`, which is left for the caller.
 * @param {Cursor} cursor
 * @param {readonly string[]} enders
 * @param {(cursor: Cursor) => Statement | null} readStatement
 * @param {() => boolean} [isEnd]  another end than by a word
 * @returns {Statement[]}
 */
export const readBody = (cursor, enders, readStatement, isEnd) =>
  finished(bodyInSlices(cursor, enders, readStatement, isEnd));

/**
 * The same, some statements at a time.
 * @param {Cursor} cursor
 * @param {readonly string[]} enders
 * @param {(cursor: Cursor) => Statement | null} readStatement
 * @param {() => boolean} [isEnd]
 * @returns {Generator<null, Statement[]>}
 */
export function* bodyInSlices(cursor, enders, readStatement, isEnd = () => false) {
  /** @type {Statement[]} */
  const body = [];
  cursor.outside();
  while (true) {
    body.push(...cursor.commentsHere());
    if (cursor.takeSign(';')) continue;
    const token = cursor.peek();
    if (cursor.atEnd() || isEnd()) return body;
    if (token.type === 'word' && CLOSERS.has(token.upper) && !cursor.isSign('=', 1)) {
      if (enders.includes(token.upper) || OUTSIDE.has(token.upper) || isExpectedOutside(cursor, token.upper))
        return body;
      cursor.report(
        'error',
        'syntax',
        `Expected a statement, got ${shownToken(token)}, which ends nothing here.`,
        token.start,
        token.end,
      );
      skipLine(cursor);
      continue;
    }
    const from = cursor.position();
    const around = cursor.opened.length;
    cursor.opened.push(enders);
    try {
      const statement = readStatement(cursor);
      cursor.opened.pop();
      body.push(...cursor.swallowedComments());
      if (statement) body.push(statement);
      endStatement(cursor);
    } catch (fault) {
      if (fault !== FAULT) throw fault;
      cursor.opened.length = around;
      cursor.outside();
      skipLine(cursor, from);
    }
    if (body.length % PIECE === 0) yield null;
  }
}

/** @param {Cursor} cursor @param {string} word */
const isExpectedOutside = (cursor, word) => cursor.opened.some((enders) => enders.includes(word));

/** A statement ends with its line, or ";" — or with a word that ends its block. @param {Cursor} cursor */
export function endStatement(cursor) {
  if (!cursor.needsEnd()) return;
  if (!cursor.continues() || cursor.isSign(';') || cursor.atEnd()) return;
  const token = cursor.peek();
  if (token.type === 'word' && (CLOSERS.has(token.upper) || isExpectedOutside(cursor, token.upper))) return;
  cursor.fail('";" or a new line');
}

/** To the beginning of the next line, or behind ";". @param {Cursor} cursor @param {number} [from]  at least one token further */
export function skipLine(cursor, from = cursor.position()) {
  if (cursor.position() <= from && !cursor.atEnd()) cursor.advance();
  while (!cursor.atEnd() && !cursor.peek().fresh && !cursor.isSign(';')) cursor.advance();
  cursor.swallowedComments();
}

/**
 * Read what may be faulty; after a fault go on at one of `words`, if it is still on this line, or at the next line.
 * @template T @param {Cursor} cursor @param {() => T} read @param {readonly string[]} words @param {T} otherwise @returns {T}
 */
export function recovered(cursor, read, words, otherwise) {
  const from = cursor.position();
  try {
    return read();
  } catch (fault) {
    if (fault !== FAULT) throw fault;
    cursor.outside();
    cursor.goTo(Math.max(from, cursor.position()));
    while (
      !cursor.atEnd() &&
      !words.some((word) => cursor.isWord(word)) &&
      !(cursor.position() > from && cursor.peek().fresh)
    ) {
      cursor.advance();
    }
    return otherwise;
  }
}

/** The word behind a header, as THEN: a fault if it is missing, but no reason to give the block up. @param {Cursor} cursor @param {string} word */
export function expectWord(cursor, word) {
  recovered(cursor, () => void cursor.needWord(word), [word], undefined);
  if (cursor.isWord(word)) cursor.advance();
}

/** A comment that was found behind something and is put elsewhere. @param {Comment} comment @returns {Comment} */
export const withoutTrailing = ({ kind, text, span }) => ({ kind, text, span });
