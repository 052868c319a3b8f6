//! The style sheet of all pages, for light and dark mode, screen and print, and all widths.

/// The content of a `style` element.
pub(super) const SHEET: &str = "\
:root{color-scheme:light dark;--paper:#fff;--ink:#222;--rule:#ccc;--good:#006d4e;--bad:#b03a00;--quiet:#555}\
@media(prefers-color-scheme:dark){:root{--paper:#16181b;--ink:#e4e4e4;--rule:#444;--good:#5fd0a8;--bad:#ff9a66;--quiet:#aaa}}\
html{font:16px/1.5 system-ui,sans-serif;background:var(--paper);color:var(--ink)}\
body{max-width:60rem;margin:2rem auto;padding:0 1rem}\
table{border-collapse:collapse;margin:1rem 0;display:block;overflow-x:auto}\
td,th{border:1px solid var(--rule);padding:.2rem .6rem;text-align:right;font-variant-numeric:tabular-nums}\
th:first-child,td:first-child{text-align:left}\
.passed{color:var(--good)}.failed{color:var(--bad)}.sources{font-size:.85rem;color:var(--quiet)}\
pre{overflow-x:auto;border:1px solid var(--rule);padding:.6rem}\
figure{margin:1rem 0}svg{max-width:100%;height:auto;background:#fff}\
math[display=block]{overflow-x:auto;margin:.8rem 0}summary{cursor:pointer}\
@media print{html{font-size:10pt;background:#fff;color:#000}body{max-width:none;margin:0}figure,tr{break-inside:avoid}@page{size:A4;margin:2cm}}";
