/**
 * A lint rule for the types in comments, read as TypeScript reads them. They are imported with `@import` at the top of a
 * file, since dependency-cruiser does not see bracket imports in every place that TypeScript allows one; and no type
 * is `any` or another name for it.
 *
 * @import { Rule } from 'eslint'
 * @import { Node } from 'typescript'
 */
import ts from 'typescript';

const BRACKET_IMPORT = 'Import types with @import at the top of the file, where the import rule sees them.';
const SILENCED = 'Correct the type, or use @ts-expect-error with the reason.';
const ANY = 'Say what it is: no type is any, * or Function.';

/**
 * @param {Node} node
 * @returns {string | undefined} what is wrong with it, as a type
 */
function problemOf(node) {
  if (ts.isImportTypeNode(node) && !node.isTypeOf) return BRACKET_IMPORT; // a module's own type has no other spelling
  if (node.kind === ts.SyntaxKind.AnyKeyword || ts.isJSDocAllType(node)) return ANY;
  if (ts.isTypeReferenceNode(node) && ts.isIdentifier(node.typeName) && node.typeName.text === 'Function') return ANY;
  return undefined;
}

/**
 * @param {Node} node
 * @param {(node: Node) => void} visit
 */
function visitAll(node, visit) {
  visit(node);
  const { jsDoc = [] } = /** @type {{ jsDoc?: Node[] }} */ (/** @type {unknown} */ (node)); // not in the published types
  for (const comment of jsDoc) visitAll(comment, visit);
  ts.forEachChild(node, (child) => visitAll(child, visit));
}

/** @type {Rule.RuleModule} */
export const jsdocTypes = {
  meta: { type: 'problem', schema: [] },
  create: ({ report, filename, sourceCode }) => ({
    Program() {
      const { text } = sourceCode;
      const file = ts.createSourceFile(filename, text, ts.ScriptTarget.Latest, true, ts.ScriptKind.JS);
      visitAll(file, (node) => {
        const message = problemOf(node);
        if (message) report({ loc: sourceCode.getLocFromIndex(node.getStart(file)), message });
      });
      for (const { value, loc } of sourceCode.getAllComments()) {
        if (loc && /@ts-(ignore|nocheck)\b/.test(value)) report({ loc, message: SILENCED });
      }
    },
  }),
};
