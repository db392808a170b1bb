'use strict';
(() => {
  const root = document.documentElement;
  const slides = [...document.querySelectorAll('article')];
  const links = new Map([...document.querySelectorAll('nav li a')].map((a) => [a.hash.slice(1), a]));
  const spoken = document.getElementById('spoken');
  let current = 0;

  // Language: words on the page by style sheet, words for those who cannot see the pictures here.
  const speak = (language) => {
    root.lang = language;
    for (const image of document.querySelectorAll('[data-en]')) {
      image.setAttribute(image.tagName === 'IMG' ? 'alt' : 'aria-label', image.dataset[language]);
    }
    document.getElementById('language').textContent = language === 'en' ? 'Nederlands' : 'English';
  };
  document.getElementById('language').addEventListener('click', () => speak(root.lang === 'en' ? 'nl' : 'en'));
  speak(navigator.language.startsWith('nl') ? 'nl' : 'en');

  // Presentation: one figure fills the screen, arrow keys step.
  const isOn = () => root.classList.contains('show');
  const mark = (k) => {
    current = Math.max(0, Math.min(slides.length - 1, k));
    slides.forEach((slide, at) => slide.classList.toggle('current', at === current));
    links.forEach((a, id) => {
      if (id === slides[current].id) a.setAttribute('aria-current', 'true');
      else a.removeAttribute('aria-current');
    });
  };
  const step = (k) => {
    mark(k);
    window.scrollTo(0, 0);
    history.replaceState(null, '', '#' + slides[current].id);
    spoken.textContent = slides[current].querySelector('h3').innerText;
  };
  const visible = () => {
    const below = slides.findIndex((slide) => slide.getBoundingClientRect().bottom > 120);
    return below < 0 ? slides.length - 1 : below;
  };
  const start = () => {
    const k = visible();
    root.classList.add('show');
    step(k);
    if (root.requestFullscreen) root.requestFullscreen().catch(() => {});
  };
  const stop = () => {
    root.classList.remove('show');
    if (document.fullscreenElement) document.exitFullscreen();
    slides[current].scrollIntoView();
  };
  document.getElementById('present').addEventListener('click', start);
  document.getElementById('before').addEventListener('click', () => step(current - 1));
  document.getElementById('after').addEventListener('click', () => step(current + 1));
  document.getElementById('leave').addEventListener('click', stop);
  document.addEventListener('fullscreenchange', () => {
    if (!document.fullscreenElement && isOn()) stop();
  });
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (!isOn()) {
      if (event.key === 'f' && event.target === document.body) start();
      return;
    }
    const to = {
      ArrowRight: current + 1, ArrowDown: current + 1, PageDown: current + 1, ' ': current + 1,
      ArrowLeft: current - 1, ArrowUp: current - 1, PageUp: current - 1, Home: 0, End: slides.length - 1,
    }[event.key];
    // A slide that is taller than the screen is read to its end first.
    const more = window.scrollY + window.innerHeight < root.scrollHeight - 2;
    if (more && ['ArrowDown', 'PageDown', ' '].includes(event.key)) return;
    if (window.scrollY > 0 && ['ArrowUp', 'PageUp'].includes(event.key)) return;
    if (to !== undefined) {
      event.preventDefault();
      step(to);
    } else if (event.key === 'Escape') {
      stop();
    }
  });
  let waiting = false;
  document.addEventListener('scroll', () => {
    if (waiting || isOn()) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      mark(visible());
    });
  }, { passive: true });
  if (slides.length) mark(Math.max(0, slides.findIndex((slide) => '#' + slide.id === location.hash)));
})();
