#include "report/style.hpp"

namespace tetloft::internal::report {

const char* const kStyle = R"(
:root { color-scheme: light dark;
  --paper: #ffffff; --card: #f6f5f2; --ink: #1c2028; --soft: #5d6470; --rule: #dcdad4;
  --accent: #2f6f8f; --contour: #14181f; --lower: #b3402f;
  --good: #1d6b3f; --good-paper: #e2f1e7; --bad: #a3241c; --bad-paper: #fbe5e2;
  --open: #6a5a1e; --open-paper: #f4eed6; }
@media (prefers-color-scheme: dark) { :root {
  --paper: #14171c; --card: #1d2128; --ink: #e8e8e4; --soft: #a0a7b3; --rule: #343a44;
  --accent: #74b3d1; --contour: #f4f4f0; --lower: #ff9d86;
  --good: #8fd6ab; --good-paper: #17321f; --bad: #ff9b90; --bad-paper: #43201c;
  --open: #e3d08a; --open-paper: #36301a; }
  .area { fill-opacity: 0.5; } }
* { box-sizing: border-box; }
html { background: var(--paper); color: var(--ink); -webkit-text-size-adjust: 100%; }
body { margin: 0 auto; max-width: 62rem; padding: 2.2rem 1.4rem 4rem;
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0; overflow-wrap: anywhere; }
h2 { font-size: 1.2rem; margin: 2.6rem 0 0.7rem; padding-top: 0.7rem;
  border-top: 1px solid var(--rule); }
p { margin: 0.4rem 0 0.8rem; max-width: 46rem; }
ul { margin: 0.3rem 0; padding-left: 1.2rem; }
.sub, .note, figcaption { color: var(--soft); }
.sub { margin: 0.3rem 0 1rem; overflow-wrap: anywhere; }
.note { font-size: 0.9rem; }
.banner { border-radius: 8px; padding: 0.6rem 0.9rem; font-weight: 600; margin: 1rem 0; }
.banner.holds, .verdict.holds { background: var(--good-paper); color: var(--good); }
.banner.fails, .verdict.fails { background: var(--bad-paper); color: var(--bad); }
.banner.unchecked, .verdict.unchecked { background: var(--open-paper); color: var(--open); }
.verdict { border-radius: 99px; padding: 0.1rem 0.7rem; font-weight: 600; white-space: nowrap; }
.tiles { display: grid; grid-template-columns: repeat(5, minmax(0, 1fr)); gap: 0.7rem;
  margin: 1rem 0; padding: 0; }
.tiles div { background: var(--card); border-radius: 8px; padding: 0.6rem 0.8rem; }
.tiles div:nth-child(9) { grid-column: span 2; }
.tiles dt { color: var(--soft); font-size: 0.82rem; }
.tiles dd { margin: 0; font-size: 1.15rem; font-weight: 600; font-variant-numeric: tabular-nums;
  overflow-wrap: anywhere; }
figure { margin: 0; break-inside: avoid; }
figcaption { font-size: 0.82rem; line-height: 1.35; margin-top: 0.3rem; }
svg { display: block; width: 100%; height: auto; }
svg text { fill: currentColor; font-family: inherit; }
.pictures { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 1rem; }
.picture svg { background: var(--card); border-radius: 8px; }
.picture svg svg { background: none; border-radius: 0; }
.letter { font-size: 22px; font-weight: 600; fill: var(--soft); }
.scale path { fill: none; stroke: currentColor; }
.panels { display: grid; grid-template-columns: repeat(auto-fill, minmax(12rem, 1fr)); gap: 1rem 0.9rem;
  margin: 0.6rem 0 1.4rem; align-items: start; }
.panel svg { background: var(--card); border-radius: 6px; }
.bar-panel { align-self: end; }
.bar-panel svg { background: none; }
.contour, .above, .below, .outline { fill: none; stroke: var(--contour); stroke-width: 10;
  stroke-linejoin: round; }
.below { stroke: var(--lower); stroke-dasharray: 34 26; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(19rem, 1fr)); gap: 1.2rem 1.6rem;
  align-items: start; }
.plots figure, .plots div { min-width: 0; }
.plot text { font-size: 12px; fill: var(--soft); font-variant-numeric: tabular-nums; }
.plot .label { fill: var(--ink); }
.plot .grid { stroke: var(--rule); }
.plot .axis { stroke: var(--soft); }
.plot .bar { fill: var(--accent); }
.plot .solid { fill: none; stroke: var(--accent); stroke-width: 1.7; stroke-linejoin: round; }
.plot .given { fill: var(--lower); }
.wide { overflow-x: auto; margin: 0.6rem 0; }
table { border-collapse: collapse; font-size: 0.9rem; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: 0.34rem 0.9rem 0.34rem 0;
  border-bottom: 1px solid var(--rule); }
thead th { color: var(--soft); font-weight: 500; vertical-align: bottom; }
thead th + th { text-align: right; }
.decisions thead th { text-align: left; }
tbody th { font-weight: 500; }
tfoot th, tfoot td { font-weight: 700; border-bottom: 0; }
.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.decisions .n { text-align: left; }
.guarantees td ul { margin-top: 0.4rem; color: var(--bad); }
.guarantees td { overflow-wrap: anywhere; }
.guarantees th { min-width: 7.5rem; }
.guarantees .n { text-align: left; color: var(--soft); }
.figures, .warnings { font-size: 0.92rem; }
.warnings li { margin-bottom: 0.2rem; overflow-wrap: anywhere; }
.swatch { display: inline-block; width: 0.8em; height: 0.8em; border-radius: 2px; margin-right: 0.5em;
  border: 1px solid rgba(128, 128, 128, 0.5); print-color-adjust: exact;
  -webkit-print-color-adjust: exact; }
.made dt { color: var(--soft); float: left; clear: left; width: 9rem; }
.made dd { margin: 0 0 0.25rem 9.6rem; overflow-wrap: anywhere; }
code { font: 0.92em ui-monospace, "SF Mono", Menlo, Consolas, monospace; }
@media (max-width: 36rem) {
  body { padding: 1.2rem 1rem 3rem; }
  h1 { font-size: 1.5rem; }
  .panels { grid-template-columns: repeat(2, minmax(0, 1fr)); }
  .tiles { grid-template-columns: repeat(2, minmax(0, 1fr)); }
  .pictures, .plots { grid-template-columns: minmax(0, 1fr); }
  .guarantees, .guarantees tbody { display: block; }
  .guarantees tr { display: grid; grid-template-columns: 1.3rem 1fr auto; padding: 0.6rem 0;
    border-bottom: 1px solid var(--rule); gap: 0.2rem 0.3rem; }
  .guarantees td, .guarantees th { border: 0; padding: 0; }
  .guarantees td:nth-child(3) { grid-column: 2 / 4; grid-row: 2; }
  .made dt { float: none; width: auto; }
  .made dd { margin-left: 0; } }
@page { margin: 16mm 15mm; }
@media print {
  :root { color-scheme: light;
    --paper: #ffffff; --card: #f6f5f2; --ink: #1c2028; --soft: #50565f; --rule: #dcdad4;
    --accent: #2f6f8f; --contour: #14181f; --lower: #b3402f;
    --good: #1d6b3f; --good-paper: #e2f1e7; --bad: #a3241c; --bad-paper: #fbe5e2;
    --open: #6a5a1e; --open-paper: #f4eed6; }
  body { max-width: none; padding: 0; font-size: 9.5pt; }
  h2 { break-after: avoid; margin-top: 1.6rem; }
  tr, .tiles div, .banner { break-inside: avoid; }
  .banner, .verdict, .tiles div, .picture svg, .panel svg { print-color-adjust: exact;
    -webkit-print-color-adjust: exact; }
  .pictures, .plots { grid-template-columns: repeat(2, minmax(0, 1fr)); }
  .panels { grid-template-columns: repeat(4, minmax(0, 1fr)); }
  .picture svg { height: 58mm; }
  .picture svg svg { height: auto; }
  th, td { padding-right: 0.5rem; }
  table { font-size: 8.5pt; }
  .tiles dd { font-size: 10.5pt; }
  .tiles dt { font-size: 8pt; }
  .area { fill-opacity: 1; }
  .plots { gap: 0.8rem; }
  section p { break-after: avoid; }
  .wide { overflow: visible; } }
)";

}  // namespace tetloft::internal::report
