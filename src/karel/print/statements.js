/**
 * Statements as lines of text.
 *
 * @import { Clause, Conditions, Expression, Item, Move, MoveTarget, Setting, Statement, Term } from '../tree.js'
 */
import {
  BREAK,
  callText,
  designatorText,
  expressionText,
  listText,
  pathPartText,
  termText,
} from '../expressionPrinter.js';
import { isPort } from '../ports.js';
import { identifier, word } from '../words.js';
import { directiveText } from './directives.js';
import { commentText, indented } from './lines.js';

/** @param {readonly Statement[]} body */
const bodyLines = (body) => indented(body.flatMap(statementLines));

const bracketed = (/** @type {Expression} */ number) => `[${expressionText(number)}]`;

/** @param {Statement} statement @returns {string[]} */
export function statementLines(statement) {
  switch (statement.kind) {
    case 'comment':
      return [commentText(statement)];
    case 'directive':
      return [directiveText(statement)];
    case 'assign':
      return [`${designatorText(statement.target)} = ${BREAK}${expressionText(statement.value)}`];
    case 'call':
      return [callText(statement)];
    case 'if':
    case 'select':
    case 'for':
    case 'while':
    case 'repeat':
    case 'using':
      return blockLines(statement);
    case 'label':
      return [`${identifier(statement.name)}::`];
    case 'goto':
      return [`GOTO ${identifier(statement.label)}`];
    case 'return':
      return [statement.value ? `RETURN(${expressionText(statement.value)})` : 'RETURN'];
    case 'abort':
    case 'pause':
      return [`${statement.kind.toUpperCase()}${statement.task ? ` PROGRAM${bracketed(statement.task)}` : ''}`];
    case 'delay':
      return [`DELAY ${expressionText(statement.milliseconds)}`];
    case 'wait':
      return [`WAIT FOR ${conditionsText(statement.conditions)}`];
    case 'pulse': {
      const { port, milliseconds, nowait } = statement;
      return [`PULSE ${designatorText(port)} FOR ${expressionText(milliseconds)}${nowait ? ' NOWAIT' : ''}`];
    }
    case 'open-file': {
      const { file, usage, path } = statement;
      return [`OPEN FILE ${designatorText(file)} (${listText([usage, path].map(expressionText))})`];
    }
    case 'close-file':
      return [`CLOSE FILE ${designatorText(statement.file)}`];
    case 'cancel-file':
      return [`CANCEL FILE ${designatorText(statement.file)}`];
    case 'write':
    case 'read': {
      const { kind, file, items } = statement;
      if (items.length === 0) throw new RangeError(`Expected something to ${kind.toUpperCase()}, got nothing.`);
      const device =
        file === undefined ? '' : ` ${typeof file === 'string' ? identifier(file) : designatorText(file)} `;
      return [`${kind.toUpperCase()}${device}(${listText(items.map(itemText))})`];
    }
    case 'condition': {
      const { number, settings, clauses } = statement;
      const lines = [...(settings ? [settingsText(settings)] : []), ...clauses.flatMap(clauseLines)];
      return [`CONDITION${bracketed(number)}:`, ...indented(lines), 'ENDCONDITION'];
    }
    case 'handler-control':
      return [`${word(statement.action)} CONDITION${bracketed(statement.number)}`];
    case 'signal':
      return [`SIGNAL ${word(statement.what)}${bracketed(statement.number)}`];
    case 'timer':
      return [
        `${word(statement.action)} TIMER ${statement.action === 'CONNECT' ? 'TO ' : ''}${designatorText(statement.variable)}`,
      ];
    case 'motion-control': {
      const { action, groups } = statement;
      return [`${word(action)}${groups ? ` GROUP[${listText(groups.map(expressionText))}]` : ''}`];
    }
    case 'action':
      return [word(statement.action)];
    case 'hand':
      return [`${word(statement.action)} HAND ${expressionText(statement.number)}`];
    case 'move':
      return moveLines(statement);
    default: {
      /** @type {never} */
      const unknown = statement;
      throw new TypeError(`Expected a statement, got ${JSON.stringify(unknown)}.`);
    }
  }
}

/** @param {Extract<Statement, { kind: 'if' | 'select' | 'for' | 'while' | 'repeat' | 'using' }>} statement @returns {string[]} */
function blockLines(statement) {
  switch (statement.kind) {
    case 'if':
      return [
        `IF ${expressionText(statement.condition)} THEN`,
        ...bodyLines(statement.then),
        ...(statement.else ? ['ELSE', ...bodyLines(statement.else)] : []),
        'ENDIF',
      ];
    case 'select':
      return [
        `SELECT ${expressionText(statement.value)} OF`,
        ...indented([
          ...statement.cases.flatMap(({ values, body }) => [
            `CASE(${listText(values.map(expressionText))}):`,
            ...bodyLines(body),
          ]),
          ...(statement.else ? ['ELSE:', ...bodyLines(statement.else)] : []),
        ]),
        'ENDSELECT',
      ];
    case 'for': {
      const { variable, from, down, to, body } = statement;
      const range = `${expressionText(from)} ${down ? 'DOWNTO' : 'TO'} ${expressionText(to)}`;
      return [`FOR ${designatorText(variable)} = ${range} DO`, ...bodyLines(body), 'ENDFOR'];
    }
    case 'while':
      return [`WHILE ${expressionText(statement.condition)} DO`, ...bodyLines(statement.body), 'ENDWHILE'];
    case 'repeat':
      return ['REPEAT', ...bodyLines(statement.body), `UNTIL ${expressionText(statement.until)}`];
    case 'using':
      return [
        `USING ${listText(statement.variables.map(designatorText))} DO`,
        ...bodyLines(statement.body),
        'ENDUSING',
      ];
  }
}

/** @param {Item} item */
function itemText(item) {
  if (item.kind === 'new-line') return 'CR';
  if (item.kind !== 'format') return expressionText(item);
  return [item.value, ...item.formats].map(expressionText).join('::');
}

/** @param {Conditions} conditions */
function conditionsText({ operator, terms }) {
  if (terms.length === 0 || (terms.length > 1 && operator === undefined)) {
    throw new RangeError('Expected terms of a condition with AND or OR between them, got none or no such word.');
  }
  return terms.map(termOrEventText).join(` ${operator} ${BREAK}`);
}

/** @param {Term} term */
function termOrEventText(term) {
  if (term.kind === 'occurrence') {
    if (term.argument === undefined) return word(term.name);
    return `${word(term.name)}[${term.argument === '*' ? '*' : expressionText(term.argument)}]`;
  }
  if (term.kind !== 'edge') return termText(term);
  if (!isPort(term.port)) throw new RangeError('Expected a port before + or -.');
  return `${designatorText(term.port)}${term.rising ? '+' : '-'}`;
}

/** @param {readonly Setting[]} settings */
const settingsText = (settings) =>
  `WITH ${listText(settings.map(({ variable, value }) => `${designatorText(variable)} = ${expressionText(value)}`))}`;

/** @param {Clause} clause */
const clauseLines = ({ conditions, actions }) => [`WHEN ${conditionsText(conditions)} DO`, ...bodyLines(actions)];

/** @param {Move} move */
function moveLines({ settings, target, nowait, when = [], until = [] }) {
  const head = `${settings ? `${settingsText(settings)} ${BREAK}` : ''}MOVE ${targetText(target)}${nowait ? ' NOWAIT' : ''}`;
  if (when.length + until.length === 0) return [head];
  const untilLines = until.map((conditions) => `UNTIL ${conditionsText(conditions)}`);
  return [`${head},`, ...indented([...when.flatMap(clauseLines), ...untilLines]), 'ENDMOVE'];
}

/** @param {MoveTarget} target */
function targetText(target) {
  switch (target.to) {
    case 'TO':
      return `TO ${expressionText(target.position)}${target.via ? ` VIA ${expressionText(target.via)}` : ''}`;
    case 'NEAR':
      return `NEAR ${expressionText(target.position)} BY ${expressionText(target.by)}`;
    case 'AWAY':
    case 'RELATIVE':
      return `${target.to} ${expressionText(target.by)}`;
    case 'ABOUT':
      return `ABOUT ${expressionText(target.vector)} BY ${expressionText(target.by)}`;
    case 'AXIS':
      return `AXIS ${expressionText(target.axis)} BY ${expressionText(target.by)}`;
    case 'ALONG':
      return `ALONG ${pathPartText(target.path)}`;
    default: {
      /** @type {never} */
      const unknown = target;
      throw new TypeError(`Expected where to MOVE, got ${JSON.stringify(unknown)}.`);
    }
  }
}
