// Light and dark: as the system has it, or as chosen; remembered where the browser lets a page do so.
'use strict';

class Theme {
  constructor(changed) {
    this.system = window.matchMedia('(prefers-color-scheme: dark)');
    this.system.addEventListener('change', () => this.apply(changed));
    this.buttons = [...document.querySelectorAll('[data-theme-choice]')];
    for (const button of this.buttons) {
      button.addEventListener('click', () => {
        this.remember(button.dataset.themeChoice);
        this.apply(changed);
      });
    }
    this.choice = 'system';
    try {
      this.choice = localStorage.getItem('tetloft-theme') || 'system';
    } catch (error) {
      // A page without storage follows the system.
    }
    this.apply(() => {});
  }

  remember(choice) {
    this.choice = choice;
    try {
      localStorage.setItem('tetloft-theme', choice);
    } catch (error) {
      // Chosen for this time only.
    }
  }

  get shown() {
    if (this.choice === 'light' || this.choice === 'dark') return this.choice;
    return this.system.matches ? 'dark' : 'light';
  }

  apply(changed) {
    document.documentElement.dataset.theme = this.shown;
    for (const button of this.buttons) {
      button.setAttribute('aria-checked', String(button.dataset.themeChoice === this.choice));
    }
    changed();
  }

  // The other of the two.
  toggle(changed) {
    this.remember(this.shown === 'dark' ? 'light' : 'dark');
    this.apply(changed);
  }
}
