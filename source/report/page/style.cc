// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/page/style.h>

namespace abut
{
  // Colours of curves: M. Okabe, K. Ito, Color Universal Design (2008), lighter ones on dark paper.
  const char *const page_style = R"(
:root { color-scheme: light dark; --paper: #fff; --ink: #1c2126; --faint: #59636e; --line: #d5dae0; --panel: #f4f6f8;
  --good: #0b6b3a; --bad: #a3210f; --warn: #fff4d6; --warn-line: #b98900; --pressure: #c8102e;
  --c0: #0072b2; --c1: #c44e00; --c2: #007a5a; --c3: #a8447f; --c4: #8a6d00; --c5: #1c2126; --c6: #59636e; --c7: #c8102e; }
@media (prefers-color-scheme: dark) { :root { --paper: #14181c; --ink: #e6eaee; --faint: #a3adb8; --line: #39424c;
  --panel: #1e242a; --good: #5fd39a; --bad: #ff8f7d; --warn: #332a10; --warn-line: #d9a514; --pressure: #ff6b78;
  --c0: #56b4e9; --c1: #ff8a3d; --c2: #2fc79a; --c3: #e39cc6; --c4: #f0d23c; --c5: #e6eaee; --c6: #a3adb8; --c7: #ff6b78; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 1rem/1.5 system-ui, sans-serif; }
main, footer { max-width: 72rem; margin: 0 auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 1.5rem 0 .5rem; overflow-wrap: anywhere; }
h2 { font-size: 1.25rem; margin: 2.2rem 0 .6rem; border-bottom: 1px solid var(--line); }
h3 { font-size: 1.05rem; margin: 1.4rem 0 .4rem; overflow-wrap: anywhere; }
p { margin: .5rem 0; max-width: 60rem; }
.verdict { font-size: 1.08rem; }
.status { padding: .1rem .5rem; border: 2px solid currentColor; border-radius: .3rem; margin-right: .3rem; }
.good { color: var(--good); }
.bad { color: var(--bad); }
.warnings { background: var(--warn); border-left: .35rem solid var(--warn-line); padding: .2rem 1rem; margin: 1rem 0; }
.warnings h2 { border: 0; margin: .4rem 0; }
.note, figcaption { color: var(--faint); font-size: .92rem; }
.wide { overflow-x: auto; margin: .8rem 0; }
table { border-collapse: collapse; font-size: .94rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding: .2rem 0; }
th, td { padding: .2rem .5rem; border-bottom: 1px solid var(--line); text-align: right; vertical-align: top; }
thead th { vertical-align: bottom; background: var(--panel); }
tbody th { font-weight: 400; }
.many { font-size: .88rem; }
.many th, .many td { padding: .2rem .35rem; }
th:first-child { text-align: left; }
td { white-space: nowrap; }
sup { line-height: 0; }
.bar { display: inline-block; height: .7em; min-width: 1px; background: var(--c0); }
figure { margin: 0; }
figcaption { margin: .4rem 0; }
.beside { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 24rem), 1fr)); gap: 0 2rem; }
.beside figcaption { grid-column: 1 / -1; }
svg { display: block; width: 100%; height: auto; font-family: inherit; }
svg text { fill: var(--ink); font-size: 12px; }
.bodies { max-height: 80vh; }
.cells path { stroke-width: 2; stroke-linejoin: round; }
.rigid { fill: #9aa3ad; }
.comb { fill: var(--pressure); fill-opacity: .18; }
.tips { fill: none; stroke: var(--pressure); stroke-width: 7; stroke-linejoin: round; }
.comb-key { display: inline-block; width: 2.2em; border-top: 3px solid var(--pressure); vertical-align: middle; }
.scale { max-width: 30rem; margin-top: .8rem; }
.tick { stroke: var(--ink); }
.diagram { max-width: 36rem; }
.grid path { stroke: var(--line); }
.frame { fill: none; stroke: var(--faint); }
.curve path { fill: none; stroke-width: 2; stroke-linejoin: round; }
.c0 { stroke: var(--c0); color: var(--c0); }
.c1 { stroke: var(--c1); color: var(--c1); stroke-dasharray: 7 4; }
.c2 { stroke: var(--c2); color: var(--c2); stroke-dasharray: 2 3; }
.c3 { stroke: var(--c3); color: var(--c3); stroke-dasharray: 9 3 2 3; }
.c4 { stroke: var(--c4); color: var(--c4); stroke-dasharray: 4 2; }
.c5 { stroke: var(--c5); color: var(--c5); stroke-opacity: .35; }
.c5 path { stroke-width: 6; }
.c6 { stroke: var(--c6); color: var(--c6); stroke-dasharray: 12 4; }
.c7 { stroke: var(--c7); color: var(--c7); stroke-dasharray: 9 3 2 3 2 3; }
.curve text { stroke: none; }
.mark { fill: currentColor; stroke: none; }
.spot { fill: transparent; stroke: none; }
.spot:hover { fill: currentColor; }
#chooser { display: flex; flex-wrap: wrap; align-items: center; gap: .6rem; margin: .6rem 0; }
#chooser[hidden] { display: none; }
#slider { flex: 1 1 10rem; max-width: 30rem; accent-color: var(--c0); min-height: 2rem; }
button { font: inherit; min-width: 2.6rem; min-height: 2.2rem; color: var(--ink); background: var(--panel);
  border: 1px solid var(--faint); border-radius: .3rem; }
button:disabled { opacity: .4; }
:focus-visible { outline: 3px solid var(--c0); outline-offset: 2px; }
summary { cursor: pointer; }
.chosen summary { display: none; }
footer { margin-top: 2.5rem; padding-bottom: 2rem; color: var(--faint); font-size: .92rem; }
a { color: var(--c0); }
@media print { .screen { display: none !important; } body { font-size: 10pt; } .wide { overflow: visible; }
  figure, tr, li { break-inside: avoid; } h2, h3, caption { break-after: avoid; }
  .beside { grid-template-columns: 1fr 1fr; } table { font-size: 8.5pt; } .many { font-size: 5.5pt; }
  th, td { padding: 1pt 2pt; } .many th, .many td { padding: 1pt; } .bodies { max-height: none; } main, footer { max-width: none; } }
)";

  const char *const page_script = R"(
(function () {
  'use strict';
  var pictures = Array.from(document.querySelectorAll('details.pass'));
  var chooser = document.getElementById('chooser');
  if (!chooser || !pictures.length) return;
  var slider = document.getElementById('slider'), shown = document.getElementById('shown');
  var back = document.getElementById('back'), on = document.getElementById('on');
  function show(k) {
    pictures.forEach(function (picture, i) { picture.hidden = i !== k; });
    shown.textContent = pictures[k].dataset.pass;
    slider.setAttribute('aria-valuetext', pictures[k].querySelector('figcaption').textContent);
    slider.value = k;
    back.disabled = k === 0;
    on.disabled = k === pictures.length - 1;
  }
  pictures.forEach(function (picture) { picture.open = true; picture.classList.add('chosen'); });
  slider.max = pictures.length - 1;
  slider.addEventListener('input', function () { show(Number(slider.value)); });
  back.addEventListener('click', function () { show(Number(slider.value) - 1); });
  on.addEventListener('click', function () { show(Number(slider.value) + 1); });
  chooser.hidden = pictures.length === 1;
  show(pictures.length - 1);
})();
)";
} // namespace abut
