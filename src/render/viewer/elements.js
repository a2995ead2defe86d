// Elements of the page.
'use strict';

const make = (kind, properties = {}) => Object.assign(document.createElement(kind), properties);
