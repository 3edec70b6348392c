/**
 * Bootstrap's dropdown with the look of our menus: what is fetched when the first of them is about to be opened.
 */
import '../css/menus.css';

export { default as Dropdown } from 'bootstrap/js/src/dropdown.js';
