/**
 * How much a file may be. Far above any robot, and low enough that a hostile file is refused in milliseconds.
 */
export const MAX_TEXT_LENGTH = 1024 * 1024;
export const MAX_ELEMENTS = 4000;
export const MAX_DEPTH = 32;
export const MAX_ATTRIBUTE_LENGTH = 10_000;
export const MAX_ATTRIBUTES = 100; // of one element, namespace declarations included
export const MAX_ISSUES = 100; // that are listed of one file; nobody reads more
