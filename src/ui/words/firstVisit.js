/** The hint at the first visit. */

export const FIRST_VISIT = {
  title: 'Three ways to move this arm',
  line: 'Pull a slider to move the arm',
  ways: [
    { title: 'Pull a slider', detail: 'One joint at a time.' },
    { title: 'Give the tool a target', detail: 'The joints follow by themselves.' },
    { title: 'Change a number', detail: 'Cells take units and sums.' },
  ],
  undo: 'Everything can be undone:',
  control: 'Ctrl',
  done: 'Got it',
};
