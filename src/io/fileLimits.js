/**
 * How much a file may be. Far above any robot, and low enough that a hostile file is refused in milliseconds.
 */
export const MAX_TEXT_LENGTH = 1024 * 1024;
export const MAX_ELEMENTS = 2000;
export const MAX_DEPTH = 32;
export const MAX_ATTRIBUTE_LENGTH = 10_000;
