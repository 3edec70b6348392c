// Bootstrap's ES modules, one plugin at a time; the types are those of its built files.
declare module 'bootstrap/js/src/dropdown.js' {
  export { default } from 'bootstrap/js/dist/dropdown';
}
declare module 'bootstrap/js/src/modal.js' {
  export { default } from 'bootstrap/js/dist/modal';
}
