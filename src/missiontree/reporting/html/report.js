"use strict";
(() => {
  const SVG = "http://www.w3.org/2000/svg";
  const PLAYED_IN_MS = 20000;
  const plan = document.documentElement.dataset.plan;
  const motions = JSON.parse(document.getElementById("motion").textContent);
  const radios = [...document.querySelectorAll('input[name="alternative"]')];
  const clock = document.getElementById("clock");
  const slider = document.getElementById("time");
  const reading = document.getElementById("reading-of-time");
  const play = document.getElementById("play");
  const marks = new Map();
  let now = 0, touched = false, playing = 0;

  // The chosen alternative is remembered while the browser is open; a browser may forbid it.
  const remember = (rank) => { try { sessionStorage.setItem(plan, rank); } catch { /* then not */ } };
  const remembered = () => { try { return sessionStorage.getItem(plan); } catch { return null; } };
  const before = radios.find((radio) => radio.value === remembered());
  if (before) before.checked = true;
  const chosen = () => {
    const radio = radios.find((one) => one.checked);
    return radio ? radio.value : document.querySelector(".way")?.dataset.rank;
  };

  const inWords = (ms, end) => {
    if (end < 600000) return `${(ms / 1000).toFixed(1)} s`;
    const whole = Math.round(ms / 1000), two = (part) => String(part % 60).padStart(2, "0");
    return `${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60))}:${two(whole)}`;
  };
  const stepFor = (end) => {
    let step = 1;
    while (step * 500 < end) step *= /^1/.test(step) ? 2 : /^2/.test(step) ? 2.5 : 2;
    return step;
  };
  const drawn = (parent, name, attributes) => {
    const element = document.createElementNS(SVG, name);
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    return parent.appendChild(element);
  };

  // Between two frames of one floor in proportion to time, else where the frame says; null where nobody knows.
  const place = (mover, t) => {
    let at = -1;
    while (at + 1 < mover.frames.length && mover.frames[at + 1][0] <= t) at += 1;
    const frame = mover.frames[at], next = mover.frames[at + 1];
    if (!frame || frame.length < 4) return null;
    let [, x, y] = frame;
    if (next && next.length === 4 && next[3] === frame[3] && next[0] > frame[0]) {
      const share = (t - frame[0]) / (next[0] - frame[0]);
      x += share * (next[1] - x);
      y += share * (next[2] - y);
    }
    return [x / 10 + mover.dx, y / 10 + mover.dy];
  };
  const doing = (mover, t, end) => {
    const busy = mover.doings.find(([from, to]) => from <= t && (t < to || (t === to && from === to)));
    if (busy) return `now: ${busy[2]}`;
    const next = mover.doings.find(([from]) => from > t);
    return next ? `from ${inWords(next[0], end)}: ${next[2]}` : "done";
  };

  // Marks are made when they are first needed, one set per alternative.
  const marksOf = (rank) => {
    if (marks.has(rank)) return marks.get(rank);
    const made = { movers: [], cursor: null, says: [...document.querySelectorAll(`.way-${rank} .says`)] };
    const map = document.querySelector(`#map-${rank} > svg`);
    if (map) {
      const layer = drawn(map, "g", { "aria-hidden": "true" });
      const robotsLast = [...motions[rank].movers].sort((a, b) => !!a.letter - !!b.letter);
      for (const mover of robotsLast) {
        const mark = drawn(layer, "g", { class: mover.hue < 0 ? "mover" : `mover hue-${mover.hue}` });
        drawn(mark, "circle", { r: mover.letter ? 8.5 : 5.5 });
        if (mover.letter) drawn(mark, "text", { y: 3.6, "text-anchor": "middle" }).textContent = mover.letter;
        drawn(mark, "title", {}).textContent = mover.label;
        made.movers.push([mover, mark]);
      }
    }
    const chart = document.querySelector(`#gantt-${rank} > svg`);
    const upright = (path) => /^M([\d.]+) ([\d.]+) V([\d.]+)$/.exec(path.getAttribute("d"));
    const start = chart && [...chart.querySelectorAll(".mt-hair")].map(upright).find(Boolean);
    const end = start && [...chart.querySelectorAll(".mt-line")].map(upright).find((one) => one && one[2] === start[2]);
    if (end) {
      const cursor = drawn(chart, "line", { class: "cursor", "aria-hidden": "true", y1: start[2], y2: start[3] });
      made.cursor = [cursor, Number(start[1]), Number(end[1])];
    }
    marks.set(rank, made);
    return made;
  };

  // A wide tree begins with its root, not with its left edge.
  const centred = new IntersectionObserver((seen) => {
    for (const { target, isIntersecting } of seen) {
      if (!isIntersecting) continue;
      target.scrollLeft = (target.scrollWidth - target.clientWidth) / 2;
      centred.unobserve(target);
    }
  });
  for (const box of document.querySelectorAll("#tree .picture")) centred.observe(box);

  const show = () => {
    const rank = chosen(), motion = motions[rank];
    clock.hidden = !motion;
    if (!motion) return;
    const step = stepFor(motion.end);
    slider.step = step;
    slider.max = Math.ceil(motion.end / step) * step;
    now = Math.min(now, motion.end);
    if (Number(slider.value) < motion.end || now < motion.end) slider.value = now;
    const words = inWords(now, motion.end);
    reading.value = words;
    slider.setAttribute("aria-valuetext", words);
    if (!touched) return;
    const made = marksOf(rank);
    for (const [mover, mark] of made.movers) {
      const at = place(mover, now);
      mark.setAttribute("visibility", at ? "visible" : "hidden");
      if (at) mark.setAttribute("transform", `translate(${at[0].toFixed(1)} ${at[1].toFixed(1)})`);
    }
    if (made.cursor) {
      const [cursor, left, right] = made.cursor, x = (left + ((right - left) * now) / motion.end).toFixed(1);
      cursor.setAttribute("x1", x);
      cursor.setAttribute("x2", x);
    }
    for (const element of made.says) {
      const mover = motion.movers.find((one) => one.id === element.dataset.robot);
      element.textContent = mover ? doing(mover, now, motion.end) : "";
      element.closest(".live").hidden = !mover;
    }
  };

  const stop = () => {
    cancelAnimationFrame(playing);
    playing = 0;
    play.textContent = "Play";
  };
  const run = () => {
    const { end } = motions[chosen()];
    if (now >= end) now = 0;
    const from = now, began = performance.now();
    const tick = (time) => {
      now = Math.min(end, from + (Math.max(0, time - began) * end) / PLAYED_IN_MS);
      show();
      if (now < end) playing = requestAnimationFrame(tick); else stop();
    };
    play.textContent = "Pause";
    playing = requestAnimationFrame(tick);
  };
  slider.addEventListener("input", () => { stop(); touched = true; now = Number(slider.value); show(); });
  play.addEventListener("click", () => { touched = true; if (playing) stop(); else run(); });
  for (const radio of radios) radio.addEventListener("change", () => { stop(); remember(radio.value); show(); });
  show();

  // Paper has no folds.
  let folded = [];
  addEventListener("beforeprint", () => {
    folded = [...document.querySelectorAll("details:not([open])")];
    for (const one of folded) one.open = true;
  });
  addEventListener("afterprint", () => { for (const one of folded) one.open = false; });
})();
