// The card: what is told of a point that was picked, or of a distance.
'use strict';

class Card {
  constructor(viewer) {
    this.viewer = viewer;
    this.element = document.getElementById('card');
    document.getElementById('forget').addEventListener('click', () => viewer.forget());
  }

  // [what, value] of each row.
  facts() {
    const {page, state, ends, measuring, layers} = this.viewer;
    if (!measuring) return state.picked ? describe(page, state.picked, layers.length > 1) : [];
    const points = ends.map((end, k) => [k === 0 ? 'From' : 'To', page.pointText(mapped(end.layer.file, end.own))]);
    if (ends.length === 2) return [['Distance', page.lengthText(distanceOf(ends))], ...points];
    return [...points, ['Distance', ends.length === 0 ? 'pick the first point' : 'pick the second point']];
  }

  show() {
    const facts = this.facts();
    document.getElementById('facts').replaceChildren(...facts.map(([what, value]) => {
      const pair = make('div');
      pair.append(make('dt', {textContent: what}), make('dd', {textContent: value}));
      return pair;
    }));
    this.element.hidden = facts.length === 0;
  }

  // Beside the picture where there is room.
  place(overPicture) { document.getElementById(overPicture ? 'stage' : 'panel').append(this.element); }
}
