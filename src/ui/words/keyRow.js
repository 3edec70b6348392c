/** The keys above the keyboard of a touch screen: what each shows, and what it is called. */

export const KEY_ROW = {
  label: 'Keys for numbers and units',
  minus: ['−', 'Minus'],
  pi: ['π', 'Pi'],
  root: ['√', 'Square root'],
  brackets: ['( )', 'Bracket'],
  divide: ['/', 'Divided by'],
  mm: ['mm', 'Millimetres'],
  inch: ['in', 'Inches'],
  deg: ['°', 'Degrees'],
  rad: ['rad', 'Radians'],
  done: 'Done',
};
