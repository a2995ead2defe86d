// Elements of the page.
'use strict';

const make = (kind, properties = {}) => Object.assign(document.createElement(kind), properties);

const cssColour = (c) => `rgb(${c.join()})`;

function makeSwatch(colour) {
  const swatch = make('i');
  swatch.style.setProperty('--colour', cssColour(colour));
  return swatch;
}
