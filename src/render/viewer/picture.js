// Saving what is seen, with its scale bar and axes, as PNG.
'use strict';

class Picture {
  constructor(viewer) {
    this.viewer = viewer;
    document.getElementById('save').addEventListener('click', () => this.save());
  }

  ground() {
    const choice = document.getElementById('ground').value;
    if (choice === 'none') return null;
    if (choice === 'white') return '#ffffff';
    return getComputedStyle(document.documentElement).getPropertyValue('--stage').trim();
  }

  // The picture as a canvas of so many pixels for each of the page.
  paint(times) {
    const {viewer} = this;
    const {width, height} = viewer.size();
    const limit = viewer.drawing.gl.getParameter(viewer.drawing.gl.MAX_RENDERBUFFER_SIZE);
    const dense = Math.min(times, limit / Math.max(width, height));
    const out = document.createElement('canvas');
    out.width = Math.round(width * dense);
    out.height = Math.round(height * dense);
    const ctx = out.getContext('2d');
    const ground = this.ground();
    if (ground !== null) {
      ctx.fillStyle = ground;
      ctx.fillRect(0, 0, out.width, out.height);
    }
    viewer.drawSolid(dense);
    ctx.drawImage(viewer.canvas, 0, 0, out.width, out.height);
    ctx.scale(dense, dense);
    // On white, and on what is none, as paper has it.
    const asShown = document.getElementById('ground').value === 'page';
    viewer.marks.paint(ctx, viewer.seen(asShown ? viewer.theme.shown : 'light'));
    viewer.drawNow();
    return out;
  }

  save() {
    const out = this.paint(Number(document.getElementById('times').value));
    out.toBlob((blob) => {
      const link = document.createElement('a');
      link.href = URL.createObjectURL(blob);
      link.download = (this.viewer.page.title || 'solid').replace(/[\/\\:*?"<>|]/g, '_') + '.png';
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    });
  }
}
