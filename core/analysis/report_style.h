// How the report's page looks, light and dark.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace relievo {

inline constexpr const char* kReportStyle = R"(
html{color-scheme:light dark}:root{--paper:#fff;--ink:#1c1c1e;--soft:#5f6368;--line:#d9dadd;--plate:#f5f5f6;--good:#e2f2ea;--accent:#0072b2}
@media screen and (prefers-color-scheme:dark){:root{--paper:#1b1b1d;--ink:#e8e8ea;--soft:#a0a3a8;--line:#3a3b3f;--plate:#242427;--good:#1d3a2e;--accent:#4aa8e0}}
*{box-sizing:border-box}
body{margin:0 auto;max-width:1336px;padding:32px 24px 64px;background:var(--paper);color:var(--ink);font:14px/1.5 system-ui,"Noto Sans",sans-serif}
h1{font-size:26px;line-height:1.2;margin:0 0 4px}h2{font-size:18px;margin:40px 0 4px}h3{font-size:14px;margin:20px 0 6px}
p{margin:4px 0 12px;max-width:860px;color:var(--soft)}p.lead{font-size:15px}
ul.legend{list-style:none;display:flex;flex-wrap:wrap;gap:4px 20px;padding:8px 12px;margin:8px 0 12px;background:var(--plate);border-radius:4px}
ul.legend li{display:flex;align-items:center;gap:7px}svg.key{width:28px;height:12px}
.plots{display:grid;max-width:1288px;grid-template-columns:repeat(auto-fit,minmax(290px,1fr));gap:16px 24px;margin:8px 0 16px}
@media (min-width:1100px){.plots.four{grid-template-columns:repeat(4,1fr)}.plots.large{grid-template-columns:repeat(2,1fr)}.plots.two{grid-template-columns:repeat(2,310px)}.plots.one{grid-template-columns:310px}.plots.three{grid-template-columns:repeat(3,310px)}}
svg.plot{width:100%;max-width:420px;height:auto;font:11px system-ui,"Noto Sans",sans-serif;fill:var(--soft);font-variant-numeric:tabular-nums}
.large svg.plot{max-width:640px}svg.plot .title{font-size:13px;font-weight:600;fill:var(--ink)}svg .grid{stroke:var(--line);stroke-width:1}
svg polyline{fill:none;stroke:var(--c);stroke-width:1.6;stroke-linejoin:round}svg .dashed polyline{stroke-dasharray:4 3}
svg circle,svg rect,svg path{fill:var(--c);stroke:var(--paper);stroke-width:.8}
.scroll{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums;white-space:nowrap;margin:4px 0 12px}
th,td{padding:3px 7px;text-align:right;border-bottom:1px solid var(--line)}th{font-weight:600;color:var(--soft);vertical-align:bottom}
th:first-child,td:first-child{text-align:left;white-space:normal;min-width:120px;padding-left:0;position:sticky;left:0;background:var(--paper)}
th.band{text-align:center;border-bottom:1px solid var(--soft);color:var(--ink)}
td.first,th.first{padding-left:20px}th.first:first-child{position:static;min-width:0;text-align:right;padding-left:20px;white-space:nowrap}tr.top td{border-top:1px solid var(--soft)}td.none{background:var(--good)}
details{border-top:1px solid var(--line)}details:last-of-type{border-bottom:1px solid var(--line)}
summary{cursor:pointer;padding:7px 0;font-weight:600}summary span{font-weight:400;color:var(--soft);margin-left:8px}
.heats{display:grid;grid-template-columns:repeat(auto-fill,minmax(220px,1fr));gap:20px 16px;margin-top:12px}
figure{margin:0}figure img{display:block;width:100%;image-rendering:auto;margin-bottom:4px;border-radius:2px}
figcaption{line-height:1.35}figcaption b{display:block}figcaption span{color:var(--soft);font-variant-numeric:tabular-nums}
.scales{display:flex;flex-wrap:wrap;gap:32px}.scale{width:300px}.scale i{display:block;height:10px;border-radius:2px}
.scale div{display:flex;justify-content:space-between;color:var(--soft);font-variant-numeric:tabular-nums}
@media print{body{max-width:none;padding:0;font-size:10px}h2{break-after:avoid}svg.plot,figure,tr{break-inside:avoid}.plots{grid-template-columns:repeat(2,1fr)}}
)";

} // namespace relievo
