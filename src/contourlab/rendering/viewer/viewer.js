"use strict";var contourlab=(()=>{var Wc=Object.defineProperty;var Ag=Object.getOwnPropertyDescriptor;var Cg=Object.getOwnPropertyNames;var Rg=Object.prototype.hasOwnProperty;var Pg=(i,e)=>{for(var t in e)Wc(i,t,{get:e[t],enumerable:!0})},Ig=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of Cg(e))!Rg.call(i,s)&&s!==t&&Wc(i,s,{get:()=>e[s],enumerable:!(n=Ag(e,s))||n.enumerable});return i};var Lg=i=>Ig(Wc({},"__esModule",{value:!0}),i);var Rb={};Pg(Rb,{page:()=>Ab,render:()=>Cb,show:()=>pg,unpacked:()=>td});var Md='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var bd=`.plot { position: relative; }
.plot:focus-visible { outline: 2px solid var(--accent, #0b5a94); }
.cl-panel { position: relative; }
.cl-panel > canvas { margin: 0 auto; }
.cl-head { display: flex; flex-wrap: wrap; gap: .1rem 1rem; justify-content: space-between; padding: .3rem 0 0; font-size: 12px; color: var(--muted, #5b6774); }
.cl-head b { font-weight: 600; }
.cl-legend { display: flex; flex-wrap: wrap; gap: .1rem .9rem; }
.cl-legend button { display: flex; align-items: center; gap: .4rem; font: inherit; font-size: 13px; text-align: left; color: inherit; background: none; border: 0; padding: .1rem 0; cursor: pointer; }
.cl-legend button[aria-pressed="false"] { opacity: .45; text-decoration: line-through; }
.cl-legend i { flex: none; width: 1.5rem; }
.cl-legend .cl-glyph { width: 1rem; font-style: normal; text-align: center; color: var(--muted, #5b6774); }
.cl-tip { position: absolute; z-index: 5; pointer-events: none; max-width: 22rem; padding: .25rem .5rem; font-size: 12px; line-height: 1.4; color: var(--ink, #1d2733); background: var(--card, #fff); border: 1px solid var(--edge, #c9d0d7); border-radius: 5px; box-shadow: 0 1px 4px #0003; }
.cl-tip[hidden] { display: none; }
.cl-tip i { display: inline-block; width: .6rem; height: .6rem; margin-right: .35rem; border-radius: 2px; }
.cl-tools { display: flex; flex-wrap: wrap; align-items: center; gap: .4rem .8rem; margin: 0 0 .5rem; font-size: .9rem; }
.cl-tools button { font: inherit; color: var(--ink, #1d2733); background: var(--card, #fff); border: 1px solid var(--edge, #c9d0d7); border-radius: 6px; padding: .15rem .7rem; cursor: pointer; }
.cl-slider + .cl-tools { margin: .8rem 0 0; }
.cl-sides { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 24rem), 1fr)); gap: 1.5rem; align-items: start; }
.cl-slider { display: grid; grid-template-columns: minmax(0, 1fr) minmax(5rem, 9rem) 3.4rem; gap: .7rem; align-items: center; padding: .2rem 0; font-size: .92rem; }
.cl-slider input { width: 100%; accent-color: var(--accent, #0b5a94); }
.cl-slider output { text-align: right; }
.u-select { background: var(--accent, #0b5a94); opacity: .15; }
.u-hz .u-cursor-x { border-right-color: var(--muted, #5b6774); }
.plot canvas { display: block; }
.printing .cl-legend [aria-pressed="false"] { display: none; }
.live-row { display: grid; grid-template-columns: minmax(10rem, 1.3fr) minmax(6rem, 1fr) 6.5rem 6.5rem; gap: .7rem; align-items: center; padding: .2rem 0; font-size: .92rem; }
.live-row [type="range"] { width: 100%; accent-color: var(--accent, #0b5a94); }
.live-row [type="number"], .live-row select, .cl-tools select { font: inherit; color: var(--ink, #1d2733); background: var(--card, #fff); border: 1px solid var(--edge, #c9d0d7); border-radius: 6px; padding: .1rem .3rem; }
.live-row [type="number"] { width: 100%; box-sizing: border-box; text-align: right; }
.live-name { display: flex; flex-wrap: wrap; gap: .1rem .6rem; justify-content: space-between; }
.live-unit { min-width: 0; overflow-wrap: anywhere; color: var(--muted, #5b6774); }
.live-table.figures th, .live-table td { white-space: normal; min-width: 0; padding: .3rem .5rem; font-size: .875rem; }
.live-table td.n { text-align: right; }
.live-said { min-height: 1.6em; margin: .6rem 0 0; }
.cl-tools button:disabled { opacity: .45; cursor: default; }
@media (max-width: 640px) { .live-row { grid-template-columns: minmax(0, 1fr) 6.5rem 4.5rem; } .live-name { grid-column: 1 / -1; } .live-said { position: sticky; bottom: 0; z-index: 4; background: var(--card, #fff); } }
@media print { .live-rows, .cl-tools, .live-same, section:has(.live-same) { display: none; } }
.cl-show { --ink: #1d2733; --muted: #5b6774; --line: #dfe4e9; --soft: #f5f7f9; --card: #fff; --edge: #c9d0d7; --good: #0f6b52; --poor: #a8321e; --accent: #0b5a94; color: var(--ink); font: 14px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
.cl-show.cl-dark { --ink: #e3e9ef; --muted: #a3afbb; --line: #333d47; --soft: #252d35; --card: #1b2127; --edge: #4a5662; --good: #4cc79f; --poor: #ff9076; --accent: #74b9ee; }
.cl-show summary { cursor: pointer; font-weight: 600; padding: .3rem 0; }
.cl-show .plot { box-sizing: border-box; background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: .7rem .8rem .5rem; }
.cl-show p { margin: .2rem 0 .6rem; color: var(--muted); font-size: .9em; }
.cl-show pre { margin: .4rem 0; padding: .5rem .7rem; color: inherit; background: var(--soft); border: 0; white-space: pre-wrap; overflow-wrap: anywhere; }
.cl-show :is(th, td) { padding: .2rem .7rem .2rem 0; text-align: left; background: none; border: 0; }
`;var pi=()=>document.documentElement.classList.contains("printing");function _r(i){if(pi())return 640;let e=getComputedStyle(i);return Math.max(i.clientWidth-parseFloat(e.paddingLeft)-parseFloat(e.paddingRight),200)}function It(i,e={},...t){let n=Object.assign(document.createElement(i),e);return n.append(...t),n}var Ze=(i,e,t="",...n)=>i.appendChild(It(e,{className:t},...n));function Ss(i){let e=getComputedStyle(i),t=(s,r)=>e.getPropertyValue(`--${s}`).trim()||r,n=t("card","#ffffff");return{card:n,ink:t("ink","#1d2733"),muted:t("muted","#5b6774"),line:t("line","#e4e8ec"),edge:t("edge","#b9c1c9"),band:qn("#0f7b5f",n),limit:qn("#a33b3b",n)}}function wd(i){let e=i.length===4?i.replace(/[0-9a-f]/gi,"$&$&"):i;return[1,3,5].map(t=>parseInt(e.slice(t,t+2),16))}function Xc(i){let[e,t,n]=i.map(s=>s/255).map(s=>s<=.04045?s/12.92:((s+.055)/1.055)**2.4);return .2126*e+.7152*t+.0722*n}function qc(i){for(let e=pi()?null:i;e;e=e.parentElement??e.getRootNode().host??null){let[t,n,s,r=1]=getComputedStyle(e).backgroundColor.match(/[\d.]+/g)?.map(Number)??[0,0,0,0];if(r>.5)return Xc([t,n,s])<.2}return!1}function qn(i,e){let t=Xc(wd(e)),n=wd(i);if(t>.2||n.some(Number.isNaN))return i;for(let s=0;s<12&&(Xc(n)+.05)/(t+.05)<4.5;s+=1)n=n.map(r=>r+(255-r)*.12);return"#"+n.map(s=>Math.round(s).toString(16).padStart(2,"0")).join("")}var ho=i=>i.match(/\[(.*)\]$/)?.[1]??"",Yc=i=>i.replace(/\s*\[[^\]]*\]$/,"");function Ft(i,e="",t=4){let n=String(Number(i.toPrecision(t)));return e&&e!=="1"?`${n} ${e}`:n}function ha(i){let e=10**Math.floor(Math.log10(i)+1e-12);return([5,2].find(t=>t<=i/e*(1+1e-12))??1)*e}function ua(i,e){let t=0,n=i.length-1;for(;n-t>1;){let s=t+n>>1;i[s]<=e?t=s:n=s}return t}function uo(i,e,t,n){let s=Ze(i,"div","cl-legend"),r=e.filter((o,a)=>e.findIndex(l=>l.name===o.name)===a);for(let o of r){let a=Ze(s,"button");a.type="button";let l=Ze(a,"i",o.glyph?"cl-glyph":"",o.glyph??"");o.glyph||(l.style.borderTop=`3px ${{dash:"dashed",dot:"dotted"}[o.dash]??"solid"} ${o.colour}`),a.append(o.name),a.setAttribute("aria-pressed",String(!t.has(o.name))),a.addEventListener("click",()=>{t.delete(o.name)||t.add(o.name),a.setAttribute("aria-pressed",String(!t.has(o.name))),n()})}return s}var ys=class{constructor(e){this.host=e;this.box=Ze(e,"div","cl-tip"),this.box.hidden=!0}host;box;show(e,t,n){this.box.replaceChildren();for(let[o,a]of n){let l=Ze(this.box,"div");a&&(Ze(l,"i").style.background=a),l.append(o)}this.box.hidden=n.length===0;let s=this.box.offsetWidth,r=e+14+s>this.host.clientWidth;this.box.style.left=`${Math.max(r?e-14-s:e+14,0)}px`,this.box.style.top=`${Math.max(Math.min(t,this.host.clientHeight-this.box.offsetHeight),0)}px`}hide(){this.box.hidden=!0}};function da(i,e,t){let n=pi()?3:Math.max(devicePixelRatio,1);i.width=Math.round(e*n),i.height=Math.round(t*n),Object.assign(i.style,{width:`${e}px`,height:`${t}px`});let s=i.getContext("2d");return s.scale(n,n),s.clearRect(0,0,e,t),s.font=xr,s.lineJoin="round",s}var xr="12px system-ui, -apple-system, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif",vr={solid:[],dash:[7,4],dot:[2,3]};var Ug="uplot",Fg="u-hz",Og="u-vt",Bg="u-title",kg="u-wrap",zg="u-under",Vg="u-over",Gg="u-axis",qs="u-off",Hg="u-select",Wg="u-cursor-x",Xg="u-cursor-y",qg="u-cursor-pt",Yg="u-legend",$g="u-live",Zg="u-inline",Jg="u-series",Kg="u-marker",Ed="u-label",jg="u-value",po="width",mo="height";var Td="bottom",yr="left",$c="right",uh="#000",Ad=uh+"0",Zc="mousemove",Cd="mousedown",Jc="mouseup",Rd="mouseenter",Pd="mouseleave",Id="dblclick",Qg="resize",e0="scroll",Ld="change",_a="dppxchange",dh="--",Ar=typeof window<"u",th=Ar?document:null,Mr=Ar?window:null,t0=Ar?navigator:null,Ut,fa;function nh(){let i=devicePixelRatio;Ut!=i&&(Ut=i,fa&&sh(Ld,fa,nh),fa=matchMedia(`(min-resolution: ${Ut-.001}dppx) and (max-resolution: ${Ut+.001}dppx)`),Ys(Ld,fa,nh),Mr.dispatchEvent(new CustomEvent(_a)))}function ti(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function ih(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function tn(i,e,t){i.style[e]=t+"px"}function Mi(i,e,t,n){let s=th.createElement(i);return e!=null&&ti(s,e),t?.insertBefore(s,n),s}function mi(i,e){return Mi("div",i,e)}var Dd=new WeakMap;function ki(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Dd.get(i);r!=o&&(i.style.transform=r,Dd.set(i,r),e<0||t<0||e>n||t>s?ti(i,qs):ih(i,qs))}var Nd=new WeakMap;function Ud(i,e,t){let n=e+t,s=Nd.get(i);n!=s&&(Nd.set(i,n),i.style.background=e,i.style.borderColor=t)}var Fd=new WeakMap;function Od(i,e,t,n){let s=e+""+t,r=Fd.get(i);s!=r&&(Fd.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var fh={passive:!0},n0={...fh,capture:!0};function Ys(i,e,t,n){e.addEventListener(i,t,n?n0:fh)}function sh(i,e,t,n){e.removeEventListener(i,t,fh)}Ar&&nh();function bi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:ni((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function df(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var ff=i=>i!=null,pf=i=>i!=null&&i>0,ya=df(ff),i0=df(pf);function s0(i,e,t,n=0,s=!1){let r=s?i0:ya,o=s?pf:ff;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Yt,l??-Yt]}function Sa(i,e,t,n){let s=zd(i),r=zd(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?Qi:mf,a=s==1?ni:gi,l=r==1?gi:ni,c=a(o(yn(i))),h=l(o(yn(e))),d=br(t,c),u=br(t,h);return t==10&&(c<0&&(d=$t(d,-c)),h<0&&(u=$t(u,-h))),n||t==2?(i=d*s,e=u*r):(i=vf(i,d),e=Ma(e,u)),[i,e]}function ph(i,e,t,n){let s=Sa(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var mh=.1,Bd={mode:3,pad:mh},_o={pad:0,soft:null,mode:0},r0={min:_o,max:_o};function xa(i,e,t,n){return ba(t)?kd(i,e,t):(_o.pad=t,_o.soft=n?0:null,_o.mode=n?3:0,kd(i,e,r0))}function Lt(i,e){return i??e}function o0(i,e,t){for(e=Lt(e,0),t=Lt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function kd(i,e,t){let n=t.min,s=t.max,r=Lt(n.pad,0),o=Lt(s.pad,0),a=Lt(n.hard,-Yt),l=Lt(s.hard,Yt),c=Lt(n.soft,Yt),h=Lt(s.soft,-Yt),d=Lt(n.mode,0),u=Lt(s.mode,0),f=e-i,g=Qi(f),y=Vn(yn(i),yn(e)),m=Qi(y),p=yn(m-g);(f<1e-24||p>10)&&(f=0,(i==0||e==0)&&(f=1e-24,d==2&&c!=Yt&&(r=0),u==2&&h!=-Yt&&(o=0)));let v=f||y||1e3,A=Qi(v),b=br(10,ni(A)),P=v*(f==0?i==0?.1:1:r),C=$t(vf(i-P,b/10),24),x=i>=c&&(d==1||d==3&&C<=c||d==2&&C>=c)?c:Yt,T=Vn(a,C<x&&i>=x?x:wi(x,C)),z=v*(f==0?e==0?.1:1:o),F=$t(Ma(e+z,b/10),24),D=e<=h&&(u==1||u==3&&F>=h||u==2&&F<=h)?h:-Yt,q=wi(l,F>D&&e<=D?D:Vn(D,F));return T==q&&T==0&&(q=100),[T,q]}var a0=new Intl.NumberFormat(Ar?t0.language:"en-US"),gh=i=>a0.format(i),ii=Math,ga=ii.PI,yn=ii.abs,ni=ii.floor,vn=ii.round,gi=ii.ceil,wi=ii.min,Vn=ii.max,br=ii.pow,zd=ii.sign,Qi=ii.log10,mf=ii.log2,l0=(i,e=1)=>ii.sinh(i)*e,Kc=(i,e=1)=>ii.asinh(i/e),Yt=1/0;function Vd(i){return(Qi((i^i>>31)-(i>>31))|0)+1}function rh(i,e,t){return wi(Vn(i,e),t)}function gf(i){return typeof i=="function"}function yt(i){return gf(i)?i:()=>i}var c0=()=>{},_f=i=>i,xf=(i,e)=>e,h0=i=>null,Gd=i=>!0,Hd=(i,e)=>i==e,u0=/\.\d*?(?=9{6,}|0{6,})/gm,$s=i=>{if(Sf(i)||bs.has(i))return i;let e=`${i}`,t=e.match(u0);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${$s(s)}e${r}`}return $t(i,n)};function Ws(i,e){return $s($t($s(i/e))*e)}function Ma(i,e){return $s(gi($s(i/e))*e)}function vf(i,e){return $s(ni($s(i/e))*e)}function $t(i,e=0){if(Sf(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return vn(n)/t}var bs=new Map;function yf(i){return((""+i).split(".")[1]||"").length}function vo(i,e,t,n){let s=[],r=n.map(yf);for(let o=e;o<t;o++){let a=yn(o),l=$t(br(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=i==10?h:$t(h,d);s.push(u),bs.set(u,d)}}return s}var xo={},_h=[],wr=[null,null],Ms=Array.isArray,Sf=Number.isInteger,d0=i=>i===void 0;function Wd(i){return typeof i=="string"}function ba(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function f0(i){return i!=null&&typeof i=="object"}var p0=Object.getPrototypeOf(Uint8Array),Mf="__proto__";function Er(i,e=ba){let t;if(Ms(i)){let n=i.find(s=>s!=null);if(Ms(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Er(i[s],e)}else t=i.slice()}else if(i instanceof p0)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Mf&&(t[n]=Er(i[n],e))}else t=i;return t}function _n(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Mf&&(ba(i[s])?_n(i[s],Er(n[s])):i[s]=Er(n[s]))}return i}var m0=0,g0=1,_0=2;function x0(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function v0(i,e){if(M0(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return b0(o[0])||(o=S0(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],d=Array(s).fill(void 0),u=e?e[o][c]:g0,f=[];for(let g=0;g<h.length;g++){let y=h[g],m=r.get(l[g]);y===null?u!=m0&&(d[m]=y,u==_0&&f.push(m)):d[m]=y}x0(d,f,s),n.push(d)}}return n}var y0=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function S0(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function M0(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function b0(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Vn(1,ni((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var bf=["January","February","March","April","May","June","July","August","September","October","November","December"],wf=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Ef(i){return i.slice(0,3)}var w0=wf.map(Ef),E0=bf.map(Ef),T0={MMMM:bf,MMM:E0,WWWW:wf,WWW:w0};function fo(i){return(i<10?"0":"")+i}function A0(i){return(i<10?"00":i<100?"0":"")+i}var C0={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>fo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>fo(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>fo(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>fo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>fo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>A0(i.getMilliseconds())};function xh(i,e){e=e||T0;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?C0[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var R0=new Intl.DateTimeFormat().resolvedOptions().timeZone;function P0(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==R0?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Tf=i=>i%1==0,va=[1,2,2.5,5],I0=vo(10,-32,0,va),Af=vo(10,0,32,va),L0=Af.filter(Tf),Xs=I0.concat(Af),vh=`
`,Cf="{YYYY}",Xd=vh+Cf,Rf="{M}/{D}",go=vh+Rf,pa=go+"/{YY}",Pf="{aa}",D0="{h}:{mm}",Sr=D0+Pf,qd=vh+Sr,Yd=":{ss}",Ot=null;function If(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?vo(10,0,3,va).filter(Tf):vo(10,-3,0,va)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Cf,Ot,Ot,Ot,Ot,Ot,Ot,1],[s*28,"{MMM}",Xd,Ot,Ot,Ot,Ot,Ot,1],[s,Rf,Xd,Ot,Ot,Ot,Ot,Ot,1],[n,"{h}"+Pf,pa,Ot,go,Ot,Ot,Ot,1],[t,Sr,pa,Ot,go,Ot,Ot,Ot,1],[e,Yd,pa+" "+Sr,Ot,go+" "+Sr,Ot,qd,Ot,1],[i,Yd+".{fff}",pa+" "+Sr,Ot,go+" "+Sr,Ot,qd,Ot,1]];function h(d){return(u,f,g,y,m,p)=>{let v=[],A=m>=o,b=m>=r&&m<o,P=d(g),C=$t(P*i,3),x=jc(P.getFullYear(),A?0:P.getMonth(),b||A?1:P.getDate()),T=$t(x*i,3);if(b||A){let z=b?m/r:0,F=A?m/o:0,D=C==T?C:$t(jc(x.getFullYear()+F,x.getMonth()+z,1)*i,3),q=new Date(vn(D/i)),$=q.getFullYear(),I=q.getMonth();for(let V=0;D<=y;V++){let te=jc($+F*V,I+z*V,1),k=te-d($t(te*i,3));D=$t((+te+k)*i,3),D<=y&&v.push(D)}}else{let z=m>=s?s:m,F=ni(g)-ni(C),D=T+F+Ma(C-T,z);v.push(D);let q=d(D),$=q.getHours()+q.getMinutes()/t+q.getSeconds()/n,I=m/n,V=u.axes[f]._space,te=p/V;for(;D=$t(D+m,i==1?0:3),!(D>y);)if(I>1){let k=ni($t($+I,6))%24,re=d(D).getHours()-k;re>1&&(re=-1),D-=re*n,$=($+I)%24;let ce=v[v.length-1];$t((D-ce)/m,3)*te>=.7&&v.push(D)}else v.push(D)}return v}}return[l,c,h]}var[N0,U0,F0]=If(1),[O0,B0,k0]=If(.001);vo(2,-53,53,[1]);function $d(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Zd(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,d,u,f;return n.map(g=>{let y=i(g),m=y.getFullYear(),p=y.getMonth(),v=y.getDate(),A=y.getHours(),b=y.getMinutes(),P=y.getSeconds(),C=m!=l&&a[2]||p!=c&&a[3]||v!=h&&a[4]||A!=d&&a[5]||b!=u&&a[6]||P!=f&&a[7]||a[1];return l=m,c=p,h=v,d=A,u=b,f=P,C(y)})}}function z0(i,e){let t=xh(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function jc(i,e,t){return new Date(i,e,t)}function Jd(i,e){return e(i)}var V0="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Kd(i,e){return(t,n,s,r)=>r==null?dh:e(i(n))}function G0(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function H0(i,e){return i.series[e].fill(i,e)}var W0={show:!0,live:!0,isolate:!1,mount:c0,markers:{show:!0,width:2,stroke:G0,fill:H0,dash:"solid"},idx:null,idxs:null,values:[]};function X0(i,e){let t=i.cursor.points,n=mi(),s=t.size(i,e);tn(n,po,s),tn(n,mo,s);let r=s/-2;tn(n,"marginLeft",r),tn(n,"marginTop",r);let o=t.width(i,e,s);return o&&tn(n,"borderWidth",o),n}function q0(i,e){let t=i.series[e].points;return t._fill||t._stroke}function Y0(i,e){let t=i.series[e].points;return t._stroke||t._fill}function $0(i,e){return i.series[e].points.size}var Qc=[0,0];function Z0(i,e,t){return Qc[0]=e,Qc[1]=t,Qc}function ma(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function eh(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var J0={show:!0,x:!0,y:!0,lock:!1,move:Z0,points:{one:!1,show:X0,size:$0,width:0,stroke:Y0,fill:q0},bind:{mousedown:ma,mouseup:ma,click:ma,dblclick:ma,mousemove:eh,mouseleave:eh,mouseenter:eh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Lf={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},yh=_n({},Lf,{filter:xf}),Df=_n({},yh,{size:10}),Nf=_n({},Lf,{show:!1}),Sh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Uf="bold "+Sh,Ff=1.5,jd={show:!0,scale:"x",stroke:uh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Uf,side:2,grid:yh,ticks:Df,border:Nf,font:Sh,lineGap:Ff,rotate:0},K0="Value",j0="Time",Qd={show:!0,scale:"x",auto:!1,sorted:1,min:Yt,max:-Yt,idxs:[]};function Q0(i,e,t,n,s){return e.map(r=>r==null?"":gh(r))}function e_(i,e,t,n,s,r,o){let a=[],l=bs.get(s)||0;t=o?t:$t(Ma(t,s),l);for(let c=t;c<=n;c=$t(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function oh(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?Qi:mf,h=ni(c(t));s=br(l,h),l==10&&(s=Xs[bi(s,Xs)]);let d=t,u=s*l;l==10&&(u=Xs[bi(u,Xs)]);do a.push(d),d=d+s,l==10&&!bs.has(d)&&(d=$t(d,bs.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=Xs[bi(u,Xs)]));while(d<=n);return a}function t_(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?oh(i,e,Vn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?oh(i,e,Vn(l,-n),-t,s):[l]).reverse().map(u=>-u).concat(h,c)}var Of=/./,n_=/[12357]/,i_=/[125]/,ef=/1/,ah=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function s_(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),d=l(9,o)-h>=c?Of:l(7,o)-h>=c?n_:l(5,o)-h>=c?i_:ef;if(d==ef){let u=yn(l(1,o)-h);if(u<c)return ah(e.slice().reverse(),a.distr,d,gi(c/u)).reverse()}return ah(e,a.distr,d,1)}function r_(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=yn(l(1,o)-l(2,o));return c<a?ah(e.slice().reverse(),3,Of,gi(a/c)).reverse():e}function o_(i,e,t,n){return n==null?dh:e==null?"":gh(e)}var tf={show:!0,scale:"y",stroke:uh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Uf,side:3,grid:yh,ticks:Df,border:Nf,font:Sh,lineGap:Ff,rotate:0};function a_(i,e){let t=3+(i||1)*2;return $t(t*e,3)}function l_(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=yn(o-r),l=i.series[e],c=a/(l.points.space*Ut);return n[1]-n[0]<=c}var nf={scale:null,auto:!0,sorted:0,min:Yt,max:-Yt},Bf=(i,e,t,n,s)=>s,sf={show:!0,auto:!0,sorted:0,gaps:Bf,alpha:1,facets:[_n({},nf,{scale:"x"}),_n({},nf,{scale:"y"})]},rf={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Bf,alpha:1,points:{show:l_,filter:null},values:null,min:Yt,max:-Yt,idxs:[],path:null,clip:null};function c_(i,e,t,n,s){return t/10}var kf={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},h_=_n({},kf,{time:!1,ori:1}),of={};function zf(i,e){let t=of[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(of[i]=t)),t}var Tr=1,lh=2;function Zs(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],d=n==2?o[s.facets[1].scale]:o[s.scale],u=a.left,f=a.top,g=a.width,y=a.height,m=i.valToPosH,p=i.valToPosV;return h.ori==0?t(s,l,c,h,d,m,p,u,f,g,y,Ea,Cr,Aa,Gf,Wf):t(s,l,c,h,d,p,m,f,u,y,g,Ta,Rr,wh,Hf,Xf)}function Mh(i,e){let t=0,n=0,s=Lt(i.bands,_h);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function u_(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function es(i,e,t,n,s,r){return Zs(i,e,(o,a,l,c,h,d,u,f,g,y,m)=>{let p=o.pxRound,v=c.dir*(c.ori==0?1:-1),A=c.ori==0?Cr:Rr,b,P;v==1?(b=t,P=n):(b=n,P=t);let C=p(d(a[b],c,y,f)),x=p(u(l[b],h,m,g)),T=p(d(a[P],c,y,f)),z=p(u(r==1?h.max:h.min,h,m,g)),F=new Path2D(s);return A(F,T,z),A(F,C,z),A(F,C,x),F})}function wa(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Aa:wh,l=t;for(let d=0;d<i.length;d++){let u=i[d];if(u[1]>u[0]){let f=u[0]-l;f>0&&a(o,l,n,f,n+r),l=u[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function d_(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function bh(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let d=c,u=c;if(s==1)for(;++c<=n&&e[c]===null;)u=c;else for(;--c>=t&&e[c]===null;)u=c;let f=r(i[d]),g=u==d?f:r(i[u]),y=d-s;f=o<=0&&y>=0&&y<l?r(i[y]):f;let p=u+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=f&&a.push([f,g])}return a}function af(i){return i==0?_f:i==1?vn:e=>Ws(e,i)}function Vf(i){let e=i==0?Ea:Ta,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=wi(c,a/2,l/2),h=wi(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Ea=(i,e,t)=>{i.moveTo(e,t)},Ta=(i,e,t)=>{i.moveTo(t,e)},Cr=(i,e,t)=>{i.lineTo(e,t)},Rr=(i,e,t)=>{i.lineTo(t,e)},Aa=Vf(0),wh=Vf(1),Gf=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},Hf=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Wf=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Xf=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function qf(i){return(e,t,n,s,r)=>Zs(e,t,(o,a,l,c,h,d,u,f,g,y,m)=>{let{pxRound:p,points:v}=o,A,b;c.ori==0?(A=Ea,b=Gf):(A=Ta,b=Hf);let P=$t(v.width*Ut,3),C=(v.size-v.width)/2*Ut,x=$t(C*2,3),T=new Path2D,z=new Path2D,{left:F,top:D,width:q,height:$}=e.bbox;Aa(z,F-x,D-x,q+x*2,$+x*2);let I=V=>{if(l[V]!=null){let te=p(d(a[V],c,y,f)),k=p(u(l[V],h,m,g));A(T,te+C,k),b(T,te,k,C,0,ga*2)}};if(r)r.forEach(I);else for(let V=n;V<=s;V++)I(V);return{stroke:P>0?T:null,fill:T,clip:z,flags:Tr|lh}})}function Yf(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var f_=Yf(Cr),p_=Yf(Rr);function $f(i){let e=Lt(i?.alignGaps,0);return(t,n,s,r)=>Zs(t,n,(o,a,l,c,h,d,u,f,g,y,m)=>{[s,r]=ya(l,s,r);let p=o.pxRound,v=$=>p(d($,c,y,f)),A=$=>p(u($,h,m,g)),b,P;c.ori==0?(b=Cr,P=f_):(b=Rr,P=p_);let C=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Tr},T=x.stroke,z=!1;if(r-s>=y*4){let $=me=>t.posToVal(me,c.key,!0),I=null,V=null,te,k,pe,Q=v(a[C==1?s:r]),re=v(a[s]),ce=v(a[r]),de=$(C==1?re+1:ce-1);for(let me=C==1?s:r;me>=s&&me<=r;me+=C){let oe=a[me],Ee=(C==1?oe<de:oe>de)?Q:v(oe),Ce=l[me];Ee==Q?Ce!=null?(k=Ce,I==null?(b(T,Ee,A(k)),te=I=V=k):k<I?I=k:k>V&&(V=k)):Ce===null&&(z=!0):(I!=null&&P(T,Q,A(I),A(V),A(te),A(k)),Ce!=null?(k=Ce,b(T,Ee,A(k)),I=V=te=k):(I=V=null,Ce===null&&(z=!0)),Q=Ee,de=$(Q+C))}I!=null&&I!=V&&pe!=Q&&P(T,Q,A(I),A(V),A(te),A(k))}else for(let $=C==1?s:r;$>=s&&$<=r;$+=C){let I=l[$];I===null?z=!0:I!=null&&b(T,v(a[$]),A(I))}let[D,q]=Mh(t,n);if(o.fill!=null||D!=0){let $=x.fill=new Path2D(T),I=o.fillTo(t,n,o.min,o.max,D),V=A(I),te=v(a[s]),k=v(a[r]);C==-1&&([k,te]=[te,k]),b($,k,V),b($,te,V)}if(!o.spanGaps){let $=[];z&&$.push(...bh(a,l,s,r,C,v,e)),x.gaps=$=o.gaps(t,n,s,r,$),x.clip=wa($,c.ori,f,g,y,m)}return q!=0&&(x.band=q==2?[es(t,n,s,r,T,-1),es(t,n,s,r,T,1)]:es(t,n,s,r,T,q)),x})}function m_(i){let e=Lt(i.align,1),t=Lt(i.ascDesc,!1),n=Lt(i.alignGaps,0),s=Lt(i.extend,!1);return(r,o,a,l)=>Zs(r,o,(c,h,d,u,f,g,y,m,p,v,A)=>{[a,l]=ya(d,a,l);let b=c.pxRound,{left:P,width:C}=r.bbox,x=re=>b(g(re,u,v,m)),T=re=>b(y(re,f,A,p)),z=u.ori==0?Cr:Rr,F={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Tr},D=F.stroke,q=u.dir*(u.ori==0?1:-1),$=T(d[q==1?a:l]),I=x(h[q==1?a:l]),V=I,te=I;s&&e==-1&&(te=P,z(D,te,$)),z(D,I,$);for(let re=q==1?a:l;re>=a&&re<=l;re+=q){let ce=d[re];if(ce==null)continue;let de=x(h[re]),me=T(ce);e==1?z(D,de,$):z(D,V,me),z(D,de,me),$=me,V=de}let k=V;s&&e==1&&(k=P+C,z(D,k,$));let[pe,Q]=Mh(r,o);if(c.fill!=null||pe!=0){let re=F.fill=new Path2D(D),ce=c.fillTo(r,o,c.min,c.max,pe),de=T(ce);z(re,k,de),z(re,te,de)}if(!c.spanGaps){let re=[];re.push(...bh(h,d,a,l,q,x,n));let ce=c.width*Ut/2,de=t||e==1?ce:-ce,me=t||e==-1?-ce:ce;re.forEach(oe=>{oe[0]+=de,oe[1]+=me}),F.gaps=re=c.gaps(r,o,a,l,re),F.clip=wa(re,u.ori,m,p,v,A)}return Q!=0&&(F.band=Q==2?[es(r,o,a,l,D,-1),es(r,o,a,l,D,1)]:es(r,o,a,l,D,Q)),F})}function lf(i,e,t,n,s,r,o=Yt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=yn(i[l]-i[a]);h<c&&(c=h,o=yn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function g_(i){i=i||xo;let e=Lt(i.size,[.6,Yt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=Lt(e[1],Yt),l=Lt(e[2],1),c=Lt(i.disp,xo),h=Lt(i.each,f=>{}),{fill:d,stroke:u}=c;return(f,g,y,m)=>Zs(f,g,(p,v,A,b,P,C,x,T,z,F,D)=>{let q=p.pxRound,$=t,I=n*Ut,V=a*Ut,te=l*Ut,k,pe;b.ori==0?[k,pe]=r(f,g):[pe,k]=r(f,g);let Q=b.dir*(b.ori==0?1:-1),re=b.ori==0?Aa:wh,ce=b.ori==0?h:(Ie,et,ot,Re,bt,Ve,Ke)=>{h(Ie,et,ot,bt,Re,Ke,Ve)},de=Lt(f.bands,_h).find(Ie=>Ie.series[0]==g),me=de!=null?de.dir:0,oe=p.fillTo(f,g,p.min,p.max,me),be=q(x(oe,P,D,z)),Ee,Ce,Te,We=F,nt=q(p.width*Ut),qe=!1,ct=null,rt=null,it=null,Dt=null;d!=null&&(nt==0||u!=null)&&(qe=!0,ct=d.values(f,g,y,m),rt=new Map,new Set(ct).forEach(Ie=>{Ie!=null&&rt.set(Ie,new Path2D)}),nt>0&&(it=u.values(f,g,y,m),Dt=new Map,new Set(it).forEach(Ie=>{Ie!=null&&Dt.set(Ie,new Path2D)})));let{x0:Ct,size:Wt}=c;if(Ct!=null&&Wt!=null){$=1,v=Ct.values(f,g,y,m),Ct.unit==2&&(v=v.map(ot=>f.posToVal(T+ot*F,b.key,!0)));let Ie=Wt.values(f,g,y,m);Wt.unit==2?Ce=Ie[0]*F:Ce=C(Ie[0],b,F,T)-C(0,b,F,T),We=lf(v,A,C,b,F,T,We),Te=We-Ce+I}else We=lf(v,A,C,b,F,T,We),Te=We*o+I,Ce=We-Te;Te<1&&(Te=0),nt>=Ce/2&&(nt=0),Te<5&&(q=_f);let Mt=Te>0,rn=We-Te-(Mt?nt:0);Ce=q(rh(rn,te,V)),Ee=($==0?Ce/2:$==Q?0:Ce)-$*Q*(($==0?I/2:0)+(Mt?nt/2:0));let pt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},kt=qe?null:new Path2D,Vt=null;if(de!=null)Vt=f.data[de.series[1]];else{let{y0:Ie,y1:et}=c;Ie!=null&&et!=null&&(A=et.values(f,g,y,m),Vt=Ie.values(f,g,y,m))}let Xt=k*Ce,O=pe*Ce;for(let Ie=Q==1?y:m;Ie>=y&&Ie<=m;Ie+=Q){let et=A[Ie];if(et==null)continue;if(Vt!=null){let Z=Vt[Ie]??0;if(et-Z==0)continue;be=x(Z,P,D,z)}let ot=b.distr!=2||c!=null?v[Ie]:Ie,Re=C(ot,b,F,T),bt=x(Lt(et,oe),P,D,z),Ve=q(Re-Ee),Ke=q(Vn(bt,be)),E=q(wi(bt,be)),M=Ke-E;if(et!=null){let Z=et<0?O:Xt,B=et<0?Xt:O;qe?(nt>0&&it[Ie]!=null&&re(Dt.get(it[Ie]),Ve,E+ni(nt/2),Ce,Vn(0,M-nt),Z,B),ct[Ie]!=null&&re(rt.get(ct[Ie]),Ve,E+ni(nt/2),Ce,Vn(0,M-nt),Z,B)):re(kt,Ve,E+ni(nt/2),Ce,Vn(0,M-nt),Z,B),ce(f,g,Ie,Ve-nt/2,E,Ce+nt,M)}}return nt>0?pt.stroke=qe?Dt:kt:qe||(pt._fill=p.width==0?p._fill:p._stroke??p._fill,pt.width=0),pt.fill=qe?rt:kt,pt})}function __(i,e){let t=Lt(e?.alignGaps,0);return(n,s,r,o)=>Zs(n,s,(a,l,c,h,d,u,f,g,y,m,p)=>{[r,o]=ya(c,r,o);let v=a.pxRound,A=k=>v(u(k,h,m,g)),b=k=>v(f(k,d,p,y)),P,C,x;h.ori==0?(P=Ea,x=Cr,C=Wf):(P=Ta,x=Rr,C=Xf);let T=h.dir*(h.ori==0?1:-1),z=A(l[T==1?r:o]),F=z,D=[],q=[];for(let k=T==1?r:o;k>=r&&k<=o;k+=T)if(c[k]!=null){let Q=l[k],re=A(Q);D.push(F=re),q.push(b(c[k]))}let $={stroke:i(D,q,P,x,C,v),fill:null,clip:null,band:null,gaps:null,flags:Tr},I=$.stroke,[V,te]=Mh(n,s);if(a.fill!=null||V!=0){let k=$.fill=new Path2D(I),pe=a.fillTo(n,s,a.min,a.max,V),Q=b(pe);x(k,F,Q),x(k,z,Q)}if(!a.spanGaps){let k=[];k.push(...bh(l,c,r,o,T,A,t)),$.gaps=k=a.gaps(n,s,r,o,k),$.clip=wa(k,h.ori,g,y,m,p)}return te!=0&&($.band=te==2?[es(n,s,r,o,I,-1),es(n,s,r,o,I,1)]:es(n,s,r,o,I,te)),$})}function x_(i){return __(v_,i)}function v_(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=e[u+1]-e[u],d[u]=i[u+1]-i[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,i[u]+d[u]/3,e[u]+l[u]*d[u]/3,i[u+1]-d[u]/3,e[u+1]-l[u+1]*d[u]/3,i[u+1],e[u+1])}return a}var ch=new Set;function cf(){for(let i of ch)i.syncRect(!0)}Ar&&(Ys(Qg,Mr,cf),Ys(e0,Mr,cf,!0),Ys(_a,Mr,()=>{dn.pxRatio=Ut}));var y_=$f(),S_=qf();function hf(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>hh(r,o,e,t))}function M_(i,e){return i.map((t,n)=>n==0?{}:_n({},e,t))}function hh(i,e,t,n){return _n({},e==0?t:n,i)}function Zf(i,e,t){return e==null?wr:[e,t]}var b_=Zf;function w_(i,e,t){return e==null?wr:xa(e,t,mh,!0)}function Jf(i,e,t,n){return e==null?wr:Sa(e,t,i.scales[n].log,!1)}var E_=Jf;function Kf(i,e,t,n){return e==null?wr:ph(e,t,i.scales[n].log,!1)}var T_=Kf;function A_(i,e,t,n,s){let r=Vn(Vd(i),Vd(e)),o=e-i,a=bi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?bs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function uf(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=vn((t=+s)*Ut))+"px"),[i,e,t]}function C_(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=$t(e[2]*Ut,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function dn(i,e,t){let n={mode:Lt(i.mode,1)},s=n.mode;function r(_,w,R,L){let G=w.valToPct(_);return L+R*(w.dir==-1?1-G:G)}function o(_,w,R,L){let G=w.valToPct(_);return L+R*(w.dir==-1?G:1-G)}function a(_,w,R,L){return w.ori==0?r(_,w,R,L):o(_,w,R,L)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=mi(Ug);if(i.id!=null&&(c.id=i.id),ti(c,i.class),i.title){let _=mi(Bg,c);_.textContent=i.title}let h=Mi("canvas"),d=n.ctx=h.getContext("2d"),u=mi(kg,c);Ys("click",u,_=>{_.target===g&&(jt!=dr||on!=fr)&&Rn.click(n,_)},!0);let f=n.under=mi(zg,u);u.appendChild(h);let g=n.over=mi(Vg,u);i=Er(i);let y=+Lt(i.pxAlign,1),m=af(y);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let p=i.ms||.001,v=n.series=s==1?hf(i.series||[],Qd,rf,!1):M_(i.series||[null],sf),A=n.axes=hf(i.axes||[],jd,tf,!0),b=n.scales={},P=n.bands=i.bands||[];P.forEach(_=>{_.fill=yt(_.fill||null),_.dir=Lt(_.dir,-1)});let C=s==2?v[1].facets[0].scale:v[0].scale,x={axes:Ki,series:ut},T=(i.drawOrder||["axes","series"]).map(_=>x[_]);function z(_){let w=_.distr==3?R=>Qi(R>0?R:_.clamp(n,R,_.min,_.max,_.key)):_.distr==4?R=>Kc(R,_.asinh):_.distr==100?R=>_.fwd(R):R=>R;return R=>{let L=w(R),{_min:G,_max:ie}=_,fe=ie-G;return(L-G)/fe}}function F(_){let w=b[_];if(w==null){let R=(i.scales||xo)[_]||xo;if(R.from!=null){F(R.from);let L=_n({},b[R.from],R,{key:_});L.valToPct=z(L),b[_]=L}else{w=b[_]=_n({},_==C?kf:h_,R),w.key=_;let L=w.time,G=w.range,ie=Ms(G);if((_!=C||s==2&&!L)&&(ie&&(G[0]==null||G[1]==null)&&(G={min:G[0]==null?Bd:{mode:1,hard:G[0],soft:G[0]},max:G[1]==null?Bd:{mode:1,hard:G[1],soft:G[1]}},ie=!1),!ie&&ba(G))){let fe=G;G=(Me,Pe,Oe)=>Pe==null?wr:xa(Pe,Oe,fe)}w.range=yt(G||(L?b_:_==C?w.distr==3?E_:w.distr==4?T_:Zf:w.distr==3?Jf:w.distr==4?Kf:w_)),w.auto=yt(ie?!1:w.auto),w.clamp=yt(w.clamp||c_),w._min=w._max=null,w.valToPct=z(w)}}}F("x"),F("y"),s==1&&v.forEach(_=>{F(_.scale)}),A.forEach(_=>{F(_.scale)});for(let _ in i.scales)F(_);let D=b[C],q=D.distr,$,I;D.ori==0?(ti(c,Fg),$=r,I=o):(ti(c,Og),$=o,I=r);let V={};for(let _ in b){let w=b[_];(w.min!=null||w.max!=null)&&(V[_]={min:w.min,max:w.max},w.min=w.max=null)}let te=i.tzDate||(_=>new Date(vn(_/p))),k=i.fmtDate||xh,pe=p==1?F0(te):k0(te),Q=Zd(te,$d(p==1?U0:B0,k)),re=Kd(te,Jd(V0,k)),ce=[],de=n.legend=_n({},W0,i.legend),me=n.cursor=_n({},J0,{drag:{y:s==2}},i.cursor),oe=de.show,be=me.show,Ee=de.markers;de.idxs=ce,Ee.width=yt(Ee.width),Ee.dash=yt(Ee.dash),Ee.stroke=yt(Ee.stroke),Ee.fill=yt(Ee.fill);let Ce,Te,We,nt=[],qe=[],ct,rt=!1,it={};if(de.live){let _=v[1]?v[1].values:null;rt=_!=null,ct=rt?_(n,1,0):{_:0};for(let w in ct)it[w]=dh}if(oe)if(Ce=Mi("table",Yg,c),We=Mi("tbody",null,Ce),de.mount(n,Ce),rt){Te=Mi("thead",null,Ce,We);let _=Mi("tr",null,Te);Mi("th",null,_);for(var Dt in ct)Mi("th",Ed,_).textContent=Dt}else ti(Ce,Zg),de.live&&ti(Ce,$g);let Ct={show:!0},Wt={show:!1};function Mt(_,w){if(w==0&&(rt||!de.live||s==2))return wr;let R=[],L=Mi("tr",Jg,We,We.childNodes[w]);ti(L,_.class),_.show||ti(L,qs);let G=Mi("th",null,L);if(Ee.show){let Me=mi(Kg,G);if(w>0){let Pe=Ee.width(n,w);Pe&&(Me.style.border=Pe+"px "+Ee.dash(n,w)+" "+Ee.stroke(n,w)),Me.style.background=Ee.fill(n,w)}}let ie=mi(Ed,G);_.label instanceof HTMLElement?ie.appendChild(_.label):ie.textContent=_.label,w>0&&(Ee.show||(ie.style.color=_.width>0?Ee.stroke(n,w):Ee.fill(n,w)),pt("click",G,Me=>{if(me._lock)return;Je(Me);let Pe=v.indexOf(_);if((Me.ctrlKey||Me.metaKey)!=de.isolate){let Oe=v.some((ze,$e)=>$e>0&&$e!=Pe&&ze.show);v.forEach((ze,$e)=>{$e>0&&Ui($e,Oe?$e==Pe?Ct:Wt:Ct,!0,gn.setSeries)})}else Ui(Pe,{show:!_.show},!0,gn.setSeries)},!1),Fe&&pt(Rd,G,Me=>{me._lock||(Je(Me),Ui(v.indexOf(_),mr,!0,gn.setSeries))},!1));for(var fe in ct){let Me=Mi("td",jg,L);Me.textContent="--",R.push(Me)}return[L,R]}let rn=new Map;function pt(_,w,R,L=!0){let G=rn.get(w)||{},ie=me.bind[_](n,w,R,L);ie&&(Ys(_,w,G[_]=ie),rn.set(w,G))}function kt(_,w,R){let L=rn.get(w)||{};for(let G in L)(_==null||G==_)&&(sh(G,w,L[G]),delete L[G]);_==null&&rn.delete(w)}let Vt=0,Xt=0,O=0,Ie=0,et=0,ot=0,Re=et,bt=ot,Ve=O,Ke=Ie,E=0,M=0,Z=0,B=0;n.bbox={};let W=!1,ae=!1,le=!1,K=!1,ne=!1,he=!1;function N(_,w,R){(R||_!=n.width||w!=n.height)&&j(_,w),mt(!1),le=!0,ae=!0,In()}function j(_,w){n.width=Vt=O=_,n.height=Xt=Ie=w,et=ot=0,Ae(),Ye();let R=n.bbox;E=R.left=Ws(et*Ut,.5),M=R.top=Ws(ot*Ut,.5),Z=R.width=Ws(O*Ut,.5),B=R.height=Ws(Ie*Ut,.5)}let ee=3;function ye(){let _=!1,w=0;for(;!_;){w++;let R=cr(w),L=Ni(w);_=w==ee||R&&L,_||(j(n.width,n.height),ae=!0)}}function ge({width:_,height:w}){N(_,w)}n.setSize=ge;function Ae(){let _=!1,w=!1,R=!1,L=!1;A.forEach((G,ie)=>{if(G.show&&G._show){let{side:fe,_size:Me}=G,Pe=fe%2,Oe=G.label!=null?G.labelSize:0,ze=Me+Oe;ze>0&&(Pe?(O-=ze,fe==3?(et+=ze,L=!0):R=!0):(Ie-=ze,fe==0?(ot+=ze,_=!0):w=!0))}}),Pn[0]=_,Pn[1]=R,Pn[2]=w,Pn[3]=L,O-=Un[1]+Un[3],et+=Un[3],Ie-=Un[2]+Un[0],ot+=Un[0]}function Ye(){let _=et+O,w=ot+Ie,R=et,L=ot;function G(ie,fe){switch(ie){case 1:return _+=fe,_-fe;case 2:return w+=fe,w-fe;case 3:return R-=fe,R+fe;case 0:return L-=fe,L+fe}}A.forEach((ie,fe)=>{if(ie.show&&ie._show){let Me=ie.side;ie._pos=G(Me,ie._size),ie.label!=null&&(ie._lpos=G(Me,ie.labelSize))}})}if(me.dataIdx==null){let _=me.hover,w=_.skip=new Set(_.skip??[]);w.add(void 0);let R=_.prox=yt(_.prox),L=_.bias??=0;me.dataIdx=(G,ie,fe,Me)=>{if(ie==0)return fe;let Pe=fe,Oe=R(G,ie,fe,Me)??Yt,ze=Oe>=0&&Oe<Yt,$e=D.ori==0?O:Ie,ft=me.left,Nt=e[0],Pt=e[ie];if(w.has(Pt[fe])){Pe=null;let xt=null,lt=null,Qe;if(L==0||L==-1)for(Qe=fe;xt==null&&Qe-- >0;)w.has(Pt[Qe])||(xt=Qe);if(L==0||L==1)for(Qe=fe;lt==null&&Qe++<Pt.length;)w.has(Pt[Qe])||(lt=Qe);if(xt!=null||lt!=null)if(ze){let en=xt==null?-1/0:$(Nt[xt],D,$e,0),hn=lt==null?1/0:$(Nt[lt],D,$e,0),Tn=ft-en,Ht=hn-ft;Tn<=Ht?Tn<=Oe&&(Pe=xt):Ht<=Oe&&(Pe=lt)}else Pe=lt==null?xt:xt==null?lt:fe-xt<=lt-fe?xt:lt}else ze&&yn(ft-$(Nt[fe],D,$e,0))>Oe&&(Pe=null);return Pe}}let Je=_=>{me.event=_};me.idxs=ce,me._lock=!1;let ue=me.points;ue.show=yt(ue.show),ue.size=yt(ue.size),ue.stroke=yt(ue.stroke),ue.width=yt(ue.width),ue.fill=yt(ue.fill);let Ne=n.focus=_n({},i.focus||{alpha:.3},me.focus),Fe=Ne.prox>=0,we=Fe&&ue.one,tt=[],_t=[],fn=[];function ks(_,w){let R=ue.show(n,w);if(R instanceof HTMLElement)return ti(R,qg),ti(R,_.class),ki(R,-10,-10,O,Ie),g.insertBefore(R,tt[w]),R}function ps(_,w){if(s==1||w>0){let R=s==1&&b[_.scale].time,L=_.value;_.value=R?Wd(L)?Kd(te,Jd(L,k)):L||re:L||o_,_.label=_.label||(R?j0:K0)}if(we||w>0){_.width=_.width==null?1:_.width,_.paths=_.paths||y_||h0,_.fillTo=yt(_.fillTo||u_),_.pxAlign=+Lt(_.pxAlign,y),_.pxRound=af(_.pxAlign),_.stroke=yt(_.stroke||null),_.fill=yt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let R=a_(Vn(1,_.width),1),L=_.points=_n({},{size:R,width:Vn(1,R*.2),stroke:_.stroke,space:R*2,paths:S_,_stroke:null,_fill:null},_.points);L.show=yt(L.show),L.filter=yt(L.filter),L.fill=yt(L.fill),L.stroke=yt(L.stroke),L.paths=yt(L.paths),L.pxAlign=_.pxAlign}if(oe){let R=Mt(_,w);nt.splice(w,0,R[0]),qe.splice(w,0,R[1]),de.values.push(null)}if(be){ce.splice(w,0,null);let R=null;we?w==0&&(R=ks(_,w)):w>0&&(R=ks(_,w)),tt.splice(w,0,R),_t.splice(w,0,0),fn.splice(w,0,0)}En("addSeries",w)}function lr(_,w){w=w??v.length,_=s==1?hh(_,w,Qd,rf):hh(_,w,{},sf),v.splice(w,0,_),ps(v[w],w)}n.addSeries=lr;function zs(_){if(v.splice(_,1),oe){de.values.splice(_,1),qe.splice(_,1);let w=nt.splice(_,1)[0];kt(null,w.firstChild),w.remove()}be&&(ce.splice(_,1),tt.splice(_,1)[0].remove(),_t.splice(_,1),fn.splice(_,1)),En("delSeries",_)}n.delSeries=zs;let Pn=[!1,!1,!1,!1];function Wn(_,w){if(_._show=_.show,_.show){let R=_.side%2,L=b[_.scale];L==null&&(_.scale=R?v[1].scale:C,L=b[_.scale]);let G=L.time;_.size=yt(_.size),_.space=yt(_.space),_.rotate=yt(_.rotate),Ms(_.incrs)&&_.incrs.forEach(fe=>{!bs.has(fe)&&bs.set(fe,yf(fe))}),_.incrs=yt(_.incrs||(L.distr==2?L0:G?p==1?N0:O0:Xs)),_.splits=yt(_.splits||(G&&L.distr==1?pe:L.distr==3?oh:L.distr==4?t_:e_)),_.stroke=yt(_.stroke),_.grid.stroke=yt(_.grid.stroke),_.ticks.stroke=yt(_.ticks.stroke),_.border.stroke=yt(_.border.stroke);let ie=_.values;_.values=Ms(ie)&&!Ms(ie[0])?yt(ie):G?Ms(ie)?Zd(te,$d(ie,k)):Wd(ie)?z0(te,ie):ie||Q:ie||Q0,_.filter=yt(_.filter||(L.distr>=3&&L.log==10?s_:L.distr==3&&L.log==2?r_:xf)),_.font=uf(_.font),_.labelFont=uf(_.labelFont),_._size=_.size(n,null,w,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Pn[w]=!0,_._el=mi(Gg,u))}}function Xn(_,w,R,L){let[G,ie,fe,Me]=R,Pe=w%2,Oe=0;return Pe==0&&(Me||ie)&&(Oe=w==0&&!G||w==2&&!fe?vn(jd.size/3):0),Pe==1&&(G||fe)&&(Oe=w==1&&!ie||w==3&&!Me?vn(tf.size/2):0),Oe}let ms=n.padding=(i.padding||[Xn,Xn,Xn,Xn]).map(_=>yt(Lt(_,Xn))),Un=n._padding=ms.map((_,w)=>_(n,w,Pn,0)),Jt,Gt=null,Kt=null,Kn=s==1?v[0].idxs:null,Fn=null,Di=!1;function X(_,w){if(e=_??[],n.data=n._data=e,s==2){Jt=0;for(let R=1;R<v.length;R++)Jt+=e[R][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),Fn=e[0],Jt=Fn.length;let R=e;if(q==2){R=e.slice();let L=R[0]=Array(Jt);for(let G=0;G<Jt;G++)L[G]=G}n._data=e=R}if(mt(!0),En("setData"),q==2&&(le=!0),w!==!1){let R=D;R.auto(n,Di)?_e():_s(C,R.min,R.max),K=K||me.left>=0,he=!0,In()}}n.setData=X;function _e(){Di=!0;let _,w;s==1&&(Jt>0?(Gt=Kn[0]=0,Kt=Kn[1]=Jt-1,_=e[0][Gt],w=e[0][Kt],q==2?(_=Gt,w=Kt):_==w&&(q==3?[_,w]=Sa(_,_,D.log,!1):q==4?[_,w]=ph(_,_,D.log,!1):D.time?w=_+vn(86400/p):[_,w]=xa(_,w,mh,!0))):(Gt=Kn[0]=_=null,Kt=Kn[1]=w=null)),_s(C,_,w)}let De,Xe,Ge,S,U,H,Y,J,xe,ve;function Se(_,w,R,L,G,ie){_??=Ad,R??=_h,L??="butt",G??=Ad,ie??="round",_!=De&&(d.strokeStyle=De=_),G!=Xe&&(d.fillStyle=Xe=G),w!=Ge&&(d.lineWidth=Ge=w),ie!=U&&(d.lineJoin=U=ie),L!=H&&(d.lineCap=H=L),R!=S&&d.setLineDash(S=R)}function Le(_,w,R,L){w!=Xe&&(d.fillStyle=Xe=w),_!=Y&&(d.font=Y=_),R!=J&&(d.textAlign=J=R),L!=xe&&(d.textBaseline=xe=L)}function Be(_,w,R,L,G=0){if(L.length>0&&_.auto(n,Di)&&(w==null||w.min==null)){let ie=Lt(Gt,0),fe=Lt(Kt,L.length-1),Me=R.min==null?s0(L,ie,fe,G,_.distr==3):[R.min,R.max];_.min=wi(_.min,R.min=Me[0]),_.max=Vn(_.max,R.max=Me[1])}}let je={min:null,max:null};function at(){for(let L in b){let G=b[L];V[L]==null&&(G.min==null||V[C]!=null&&G.auto(n,Di))&&(V[L]=je)}for(let L in b){let G=b[L];V[L]==null&&G.from!=null&&V[G.from]!=null&&(V[L]=je)}V[C]!=null&&mt(!0);let _={};for(let L in V){let G=V[L];if(G!=null){let ie=_[L]=Er(b[L],f0);if(G.min!=null)_n(ie,G);else if(L!=C||s==2)if(Jt==0&&ie.from==null){let fe=ie.range(n,null,null,L);ie.min=fe[0],ie.max=fe[1]}else ie.min=Yt,ie.max=-Yt}}if(Jt>0){v.forEach((L,G)=>{if(s==1){let ie=L.scale,fe=V[ie];if(fe==null)return;let Me=_[ie];if(G==0){let Pe=Me.range(n,Me.min,Me.max,ie);Me.min=Pe[0],Me.max=Pe[1],Gt=bi(Me.min,e[0]),Kt=bi(Me.max,e[0]),Kt-Gt>1&&(e[0][Gt]<Me.min&&Gt++,e[0][Kt]>Me.max&&Kt--),L.min=Fn[Gt],L.max=Fn[Kt]}else L.show&&L.auto&&Be(Me,fe,L,e[G],L.sorted);L.idxs[0]=Gt,L.idxs[1]=Kt}else if(G>0&&L.show&&L.auto){let[ie,fe]=L.facets,Me=ie.scale,Pe=fe.scale,[Oe,ze]=e[G],$e=_[Me],ft=_[Pe];$e!=null&&Be($e,V[Me],ie,Oe,ie.sorted),ft!=null&&Be(ft,V[Pe],fe,ze,fe.sorted),L.min=fe.min,L.max=fe.max}});for(let L in _){let G=_[L],ie=V[L];if(G.from==null&&(ie==null||ie.min==null)){let fe=G.range(n,G.min==Yt?null:G.min,G.max==-Yt?null:G.max,L);G.min=fe[0],G.max=fe[1]}}}for(let L in _){let G=_[L];if(G.from!=null){let ie=_[G.from];if(ie.min==null)G.min=G.max=null;else{let fe=G.range(n,ie.min,ie.max,L);G.min=fe[0],G.max=fe[1]}}}let w={},R=!1;for(let L in _){let G=_[L],ie=b[L];if(ie.min!=G.min||ie.max!=G.max){ie.min=G.min,ie.max=G.max;let fe=ie.distr;ie._min=fe==3?Qi(ie.min):fe==4?Kc(ie.min,ie.asinh):fe==100?ie.fwd(ie.min):ie.min,ie._max=fe==3?Qi(ie.max):fe==4?Kc(ie.max,ie.asinh):fe==100?ie.fwd(ie.max):ie.max,w[L]=R=!0}}if(R){v.forEach((L,G)=>{s==2?G>0&&w.y&&(L._paths=null):w[L.scale]&&(L._paths=null)});for(let L in w)le=!0,En("setScale",L);be&&me.left>=0&&(K=he=!0)}for(let L in V)V[L]=null}function ke(_){let w=rh(Gt-1,0,Jt-1),R=rh(Kt+1,0,Jt-1);for(;_[w]==null&&w>0;)w--;for(;_[R]==null&&R<Jt-1;)R++;return[w,R]}function ut(){if(Jt>0){let _=v.some(w=>w._focus)&&ve!=Ne.alpha;_&&(d.globalAlpha=ve=Ne.alpha),v.forEach((w,R)=>{if(R>0&&w.show&&(Zt(R,!1),Zt(R,!0),w._paths==null)){let L=ve;ve!=w.alpha&&(d.globalAlpha=ve=w.alpha);let G=s==2?[0,e[R][0].length-1]:ke(e[R]);w._paths=w.paths(n,R,G[0],G[1]),ve!=L&&(d.globalAlpha=ve=L)}}),v.forEach((w,R)=>{if(R>0&&w.show){let L=ve;ve!=w.alpha&&(d.globalAlpha=ve=w.alpha),w._paths!=null&&Et(R,!1);{let G=w._paths!=null?w._paths.gaps:null,ie=w.points.show(n,R,Gt,Kt,G),fe=w.points.filter(n,R,ie,G);(ie||fe)&&(w.points._paths=w.points.paths(n,R,Gt,Kt,fe),Et(R,!0))}ve!=L&&(d.globalAlpha=ve=L),En("drawSeries",R)}}),_&&(d.globalAlpha=ve=1)}}function Zt(_,w){let R=w?v[_].points:v[_];R._stroke=R.stroke(n,_),R._fill=R.fill(n,_)}function Et(_,w){let R=w?v[_].points:v[_],{stroke:L,fill:G,clip:ie,flags:fe,_stroke:Me=R._stroke,_fill:Pe=R._fill,_width:Oe=R.width}=R._paths;Oe=$t(Oe*Ut,3);let ze=null,$e=Oe%2/2;w&&Pe==null&&(Pe=Oe>0?"#fff":Me);let ft=R.pxAlign==1&&$e>0;if(ft&&d.translate($e,$e),!w){let Nt=E-Oe/2,Pt=M-Oe/2,xt=Z+Oe,lt=B+Oe;ze=new Path2D,ze.rect(Nt,Pt,xt,lt)}w?He(Me,Oe,R.dash,R.cap,Pe,L,G,fe,ie):Rt(_,Me,Oe,R.dash,R.cap,Pe,L,G,fe,ze,ie),ft&&d.translate(-$e,-$e)}function Rt(_,w,R,L,G,ie,fe,Me,Pe,Oe,ze){let $e=!1;Pe!=0&&P.forEach((ft,Nt)=>{if(ft.series[0]==_){let Pt=v[ft.series[1]],xt=e[ft.series[1]],lt=(Pt._paths||xo).band;Ms(lt)&&(lt=ft.dir==1?lt[0]:lt[1]);let Qe,en=null;Pt.show&&lt&&o0(xt,Gt,Kt)?(en=ft.fill(n,Nt)||ie,Qe=Pt._paths.clip):lt=null,He(w,R,L,G,en,fe,Me,Pe,Oe,ze,Qe,lt),$e=!0}}),$e||He(w,R,L,G,ie,fe,Me,Pe,Oe,ze)}let qt=Tr|lh;function He(_,w,R,L,G,ie,fe,Me,Pe,Oe,ze,$e){Se(_,w,R,L,G),(Pe||Oe||$e)&&(d.save(),Pe&&d.clip(Pe),Oe&&d.clip(Oe)),$e?(Me&qt)==qt?(d.clip($e),ze&&d.clip(ze),vt(G,fe),ln(_,ie,w)):Me&lh?(vt(G,fe),d.clip($e),ln(_,ie,w)):Me&Tr&&(d.save(),d.clip($e),ze&&d.clip(ze),vt(G,fe),d.restore(),ln(_,ie,w)):(vt(G,fe),ln(_,ie,w)),(Pe||Oe||$e)&&d.restore()}function ln(_,w,R){R>0&&(w instanceof Map?w.forEach((L,G)=>{d.strokeStyle=De=G,d.stroke(L)}):w!=null&&_&&d.stroke(w))}function vt(_,w){w instanceof Map?w.forEach((R,L)=>{d.fillStyle=Xe=L,d.fill(R)}):w!=null&&_&&d.fill(w)}function Ji(_,w,R,L){let G=A[_],ie;if(L<=0)ie=[0,0];else{let fe=G._space=G.space(n,_,w,R,L),Me=G._incrs=G.incrs(n,_,w,R,L,fe);ie=A_(w,R,Me,L,fe)}return G._found=ie}function pn(_,w,R,L,G,ie,fe,Me,Pe,Oe){let ze=fe%2/2;y==1&&d.translate(ze,ze),Se(Me,fe,Pe,Oe,Me),d.beginPath();let $e,ft,Nt,Pt,xt=G+(L==0||L==3?-ie:ie);R==0?(ft=G,Pt=xt):($e=G,Nt=xt);for(let lt=0;lt<_.length;lt++)w[lt]!=null&&(R==0?$e=Nt=_[lt]:ft=Pt=_[lt],d.moveTo($e,ft),d.lineTo(Nt,Pt));d.stroke(),y==1&&d.translate(-ze,-ze)}function cr(_){let w=!0;return A.forEach((R,L)=>{if(!R.show)return;let G=b[R.scale];if(G.min==null){R._show&&(w=!1,R._show=!1,mt(!1));return}else R._show||(w=!1,R._show=!0,mt(!1));let ie=R.side,fe=ie%2,{min:Me,max:Pe}=G,[Oe,ze]=Ji(L,Me,Pe,fe==0?O:Ie);if(ze==0)return;let $e=G.distr==2,ft=R._splits=R.splits(n,L,Me,Pe,Oe,ze,$e),Nt=G.distr==2?ft.map(Qe=>Fn[Qe]):ft,Pt=G.distr==2?Fn[ft[1]]-Fn[ft[0]]:Oe,xt=R._values=R.values(n,R.filter(n,Nt,L,ze,Pt),L,ze,Pt);R._rotate=ie==2?R.rotate(n,xt,L,ze):0;let lt=R._size;R._size=gi(R.size(n,xt,L,_)),lt!=null&&R._size!=lt&&(w=!1)}),w}function Ni(_){let w=!0;return ms.forEach((R,L)=>{let G=R(n,L,Pn,_);G!=Un[L]&&(w=!1),Un[L]=G}),w}function Ki(){for(let _=0;_<A.length;_++){let w=A[_];if(!w.show||!w._show)continue;let R=w.side,L=R%2,G,ie,fe=w.stroke(n,_),Me=R==0||R==3?-1:1,[Pe,Oe]=w._found;if(w.label!=null){let kn=w.labelGap*Me,ei=vn((w._lpos+kn)*Ut);Le(w.labelFont[0],fe,"center",R==2?"top":Td),d.save(),L==1?(G=ie=0,d.translate(ei,vn(M+B/2)),d.rotate((R==3?-ga:ga)/2)):(G=vn(E+Z/2),ie=ei);let Hs=gf(w.label)?w.label(n,_,Pe,Oe):w.label;d.fillText(Hs,G,ie),d.restore()}if(Oe==0)continue;let ze=b[w.scale],$e=L==0?Z:B,ft=L==0?E:M,Nt=w._splits,Pt=ze.distr==2?Nt.map(kn=>Fn[kn]):Nt,xt=ze.distr==2?Fn[Nt[1]]-Fn[Nt[0]]:Pe,lt=w.ticks,Qe=w.border,en=lt.show?lt.size:0,hn=vn(en*Ut),Tn=vn((w.alignTo==2?w._size-en-w.gap:w.gap)*Ut),Ht=w._rotate*-ga/180,un=m(w._pos*Ut),jn=(hn+Tn)*Me,Bn=un+jn;ie=L==0?Bn:0,G=L==1?Bn:0;let di=w.font[0],yi=w.align==1?yr:w.align==2?$c:Ht>0?yr:Ht<0?$c:L==0?"center":R==3?$c:yr,Oi=Ht||L==1?"middle":R==2?"top":Td;Le(di,fe,yi,Oi);let Qn=w.font[1]*w.lineGap,fi=Nt.map(kn=>m(a(kn,ze,$e,ft))),Si=w._values;for(let kn=0;kn<Si.length;kn++){let ei=Si[kn];if(ei!=null){L==0?G=fi[kn]:ie=fi[kn],ei=""+ei;let Hs=ei.indexOf(`
`)==-1?[ei]:ei.split(/\n/gm);for(let zn=0;zn<Hs.length;zn++){let Sd=Hs[zn];Ht?(d.save(),d.translate(G,ie+zn*Qn),d.rotate(Ht),d.fillText(Sd,0,0),d.restore()):d.fillText(Sd,G,ie+zn*Qn)}}}lt.show&&pn(fi,lt.filter(n,Pt,_,Oe,xt),L,R,un,hn,$t(lt.width*Ut,3),lt.stroke(n,_),lt.dash,lt.cap);let Bi=w.grid;Bi.show&&pn(fi,Bi.filter(n,Pt,_,Oe,xt),L,L==0?2:1,L==0?M:E,L==0?B:Z,$t(Bi.width*Ut,3),Bi.stroke(n,_),Bi.dash,Bi.cap),Qe.show&&pn([un],[1],L==0?1:0,L==0?1:2,L==1?M:E,L==1?B:Z,$t(Qe.width*Ut,3),Qe.stroke(n,_),Qe.dash,Qe.cap)}En("drawAxes")}function mt(_){v.forEach((w,R)=>{R>0&&(w._paths=null,_&&(s==1?(w.min=null,w.max=null):w.facets.forEach(L=>{L.min=null,L.max=null})))})}let cn=!1,On=!1,zt=[];function mn(){On=!1;for(let _=0;_<zt.length;_++)En(...zt[_]);zt.length=0}function In(){cn||(y0(id),cn=!0)}function aa(_,w=!1){cn=!0,On=w,_(n),id(),w&&zt.length>0&&queueMicrotask(mn)}n.batch=aa;function id(){if(W&&(at(),W=!1),le&&(ye(),le=!1),ae){if(tn(f,yr,et),tn(f,"top",ot),tn(f,po,O),tn(f,mo,Ie),tn(g,yr,et),tn(g,"top",ot),tn(g,po,O),tn(g,mo,Ie),tn(u,po,Vt),tn(u,mo,Xt),h.width=vn(Vt*Ut),h.height=vn(Xt*Ut),A.forEach(({_el:_,_show:w,_size:R,_pos:L,side:G})=>{if(_!=null)if(w){let ie=G===3||G===0?R:0,fe=G%2==1;tn(_,fe?"left":"top",L-ie),tn(_,fe?"width":"height",R),tn(_,fe?"top":"left",fe?ot:et),tn(_,fe?"height":"width",fe?Ie:O),ih(_,qs)}else ti(_,qs)}),De=Xe=Ge=U=H=Y=J=xe=S=null,ve=1,lo(!0),et!=Re||ot!=bt||O!=Ve||Ie!=Ke){mt(!1);let _=O/Ve,w=Ie/Ke;if(be&&!K&&me.left>=0){me.left*=_,me.top*=w,hr&&ki(hr,vn(me.left),0,O,Ie),ur&&ki(ur,0,vn(me.top),O,Ie);for(let R=0;R<tt.length;R++){let L=tt[R];L!=null&&(_t[R]*=_,fn[R]*=w,ki(L,gi(_t[R]),gi(fn[R]),O,Ie))}}if(Qt.show&&!ne&&Qt.left>=0&&Qt.width>0){Qt.left*=_,Qt.width*=_,Qt.top*=w,Qt.height*=w;for(let R in zc)tn(pr,R,Qt[R])}Re=et,bt=ot,Ve=O,Ke=Ie}En("setSize"),ae=!1}Vt>0&&Xt>0&&(d.clearRect(0,0,h.width,h.height),En("drawClear"),T.forEach(_=>_()),En("draw")),Qt.show&&ne&&(la(Qt),ne=!1),be&&K&&(Gs(null,!0,!1),K=!1),de.show&&de.live&&he&&(Bc(),he=!1),l||(l=!0,n.status=1,En("ready")),Di=!1,cn=!1}n.redraw=(_,w)=>{le=w||!1,_!==!1?_s(C,D.min,D.max):In()};function Uc(_,w){let R=b[_];if(R.from==null){if(Jt==0){let L=R.range(n,w.min,w.max,_);w.min=L[0],w.max=L[1]}if(w.min>w.max){let L=w.min;w.min=w.max,w.max=L}if(Jt>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;_==C&&R.distr==2&&Jt>0&&(w.min=bi(w.min,e[0]),w.max=bi(w.max,e[0]),w.min==w.max&&w.max++),V[_]=w,W=!0,In()}}n.setScale=Uc;let Fc,Oc,hr,ur,sd,rd,dr,fr,od,ad,jt,on,gs=!1,Rn=me.drag,bn=Rn.x,wn=Rn.y;be&&(me.x&&(Fc=mi(Wg,g)),me.y&&(Oc=mi(Xg,g)),D.ori==0?(hr=Fc,ur=Oc):(hr=Oc,ur=Fc),jt=me.left,on=me.top);let Qt=n.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),pr=Qt.show?mi(Hg,Qt.over?g:f):null;function la(_,w){if(Qt.show){for(let R in _)Qt[R]=_[R],R in zc&&tn(pr,R,_[R]);w!==!1&&En("setSelect")}}n.setSelect=la;function mg(_){if(v[_].show)oe&&ih(nt[_],qs);else if(oe&&ti(nt[_],qs),be){let R=we?tt[0]:tt[_];R!=null&&ki(R,-10,-10,O,Ie)}}function _s(_,w,R){Uc(_,{min:w,max:R})}function Ui(_,w,R,L){w.focus!=null&&yg(_),w.show!=null&&v.forEach((G,ie)=>{ie>0&&(_==ie||_==null)&&(G.show=w.show,mg(ie),s==2?(_s(G.facets[0].scale,null,null),_s(G.facets[1].scale,null,null)):_s(G.scale,null,null),In())}),R!==!1&&En("setSeries",_,w),L&&co("setSeries",n,_,w)}n.setSeries=Ui;function gg(_,w){_n(P[_],w)}function _g(_,w){_.fill=yt(_.fill||null),_.dir=Lt(_.dir,-1),w=w??P.length,P.splice(w,0,_)}function xg(_){_==null?P.length=0:P.splice(_,1)}n.addBand=_g,n.setBand=gg,n.delBand=xg;function vg(_,w){v[_].alpha=w,be&&tt[_]!=null&&(tt[_].style.opacity=w),oe&&nt[_]&&(nt[_].style.opacity=w)}let ji,xs,Vs,mr={focus:!0};function yg(_){if(_!=Vs){let w=_==null,R=Ne.alpha!=1;v.forEach((L,G)=>{if(s==1||G>0){let ie=w||G==0||G==_;L._focus=w?null:ie,R&&vg(G,ie?1:Ne.alpha)}}),Vs=_,R&&In()}}oe&&Fe&&pt(Pd,Ce,_=>{me._lock||(Je(_),Vs!=null&&Ui(null,mr,!0,gn.setSeries))});function Fi(_,w,R){let L=b[w];R&&(_=_/Ut-(L.ori==1?ot:et));let G=O;L.ori==1&&(G=Ie,_=G-_),L.dir==-1&&(_=G-_);let ie=L._min,fe=L._max,Me=_/G,Pe=ie+(fe-ie)*Me,Oe=L.distr;return Oe==3?br(10,Pe):Oe==4?l0(Pe,L.asinh):Oe==100?L.bwd(Pe):Pe}function Sg(_,w){let R=Fi(_,C,w);return bi(R,e[0],Gt,Kt)}n.valToIdx=_=>bi(_,e[0]),n.posToIdx=Sg,n.posToVal=Fi,n.valToPos=(_,w,R)=>b[w].ori==0?r(_,b[w],R?Z:O,R?E:0):o(_,b[w],R?B:Ie,R?M:0),n.setCursor=(_,w,R)=>{jt=_.left,on=_.top,Gs(null,w,R)};function ld(_,w){tn(pr,yr,Qt.left=_),tn(pr,po,Qt.width=w)}function cd(_,w){tn(pr,"top",Qt.top=_),tn(pr,mo,Qt.height=w)}let oo=D.ori==0?ld:cd,ao=D.ori==1?ld:cd;function Mg(){if(oe&&de.live)for(let _=s==2?1:0;_<v.length;_++){if(_==0&&rt)continue;let w=de.values[_],R=0;for(let L in w)qe[_][R++].firstChild.nodeValue=w[L]}}function Bc(_,w){if(_!=null&&(_.idxs?_.idxs.forEach((R,L)=>{ce[L]=R}):d0(_.idx)||ce.fill(_.idx),de.idx=ce[0]),oe&&de.live){for(let R=0;R<v.length;R++)(R>0||s==1&&!rt)&&bg(R,ce[R]);Mg()}he=!1,w!==!1&&En("setLegend")}n.setLegend=Bc;function bg(_,w){let R=v[_],L=_==0&&q==2?Fn:e[_],G;rt?G=R.values(n,_,w)??it:(G=R.value(n,w==null?null:L[w],_,w),G=G==null?it:{_:G}),de.values[_]=G}function Gs(_,w,R){od=jt,ad=on,[jt,on]=me.move(n,jt,on),me.left=jt,me.top=on,be&&(hr&&ki(hr,vn(jt),0,O,Ie),ur&&ki(ur,0,vn(on),O,Ie));let L,G=Gt>Kt;ji=Yt,xs=null;let ie=D.ori==0?O:Ie,fe=D.ori==1?O:Ie;if(jt<0||Jt==0||G){L=me.idx=null;for(let Me=0;Me<v.length;Me++){let Pe=tt[Me];Pe!=null&&ki(Pe,-10,-10,O,Ie)}Fe&&Ui(null,mr,!0,_==null&&gn.setSeries),de.live&&(ce.fill(L),he=!0)}else{let Me,Pe,Oe;s==1&&(Me=D.ori==0?jt:on,Pe=Fi(Me,C),L=me.idx=bi(Pe,e[0],Gt,Kt),Oe=$(e[0][L],D,ie,0));let ze=-10,$e=-10,ft=0,Nt=0,Pt=!0,xt="",lt="";for(let Qe=s==2?1:0;Qe<v.length;Qe++){let en=v[Qe],hn=ce[Qe],Tn=hn==null?null:s==1?e[Qe][hn]:e[Qe][1][hn],Ht=me.dataIdx(n,Qe,L,Pe),un=Ht==null?null:s==1?e[Qe][Ht]:e[Qe][1][Ht];if(he=he||un!=Tn||Ht!=hn,ce[Qe]=Ht,Qe>0&&en.show){let jn=Ht==null?-10:Ht==L?Oe:$(s==1?e[0][Ht]:e[Qe][0][Ht],D,ie,0),Bn=un==null?-10:I(un,s==1?b[en.scale]:b[en.facets[1].scale],fe,0);if(Fe&&un!=null){let di=D.ori==1?jt:on,yi=yn(Ne.dist(n,Qe,Ht,Bn,di));if(yi<ji){let Oi=Ne.bias;if(Oi!=0){let Qn=Fi(di,en.scale),fi=un>=0?1:-1,Si=Qn>=0?1:-1;Si==fi&&(Si==1?Oi==1?un>=Qn:un<=Qn:Oi==1?un<=Qn:un>=Qn)&&(ji=yi,xs=Qe)}else ji=yi,xs=Qe}}if(he||we){let di,yi;D.ori==0?(di=jn,yi=Bn):(di=Bn,yi=jn);let Oi,Qn,fi,Si,Bi,kn,ei=!0,Hs=ue.bbox;if(Hs!=null){ei=!1;let zn=Hs(n,Qe);fi=zn.left,Si=zn.top,Oi=zn.width,Qn=zn.height}else fi=di,Si=yi,Oi=Qn=ue.size(n,Qe);if(kn=ue.fill(n,Qe),Bi=ue.stroke(n,Qe),we)Qe==xs&&ji<=Ne.prox&&(ze=fi,$e=Si,ft=Oi,Nt=Qn,Pt=ei,xt=kn,lt=Bi);else{let zn=tt[Qe];zn!=null&&(_t[Qe]=fi,fn[Qe]=Si,Od(zn,Oi,Qn,ei),Ud(zn,kn,Bi),ki(zn,gi(fi),gi(Si),O,Ie))}}}}if(we){let Qe=Ne.prox,en=Vs==null?ji<=Qe:ji>Qe||xs!=Vs;if(he||en){let hn=tt[0];hn!=null&&(_t[0]=ze,fn[0]=$e,Od(hn,ft,Nt,Pt),Ud(hn,xt,lt),ki(hn,gi(ze),gi($e),O,Ie))}}}if(Qt.show&&gs)if(_!=null){let[Me,Pe]=gn.scales,[Oe,ze]=gn.match,[$e,ft]=_.cursor.sync.scales,Nt=_.cursor.drag;if(bn=Nt._x,wn=Nt._y,bn||wn){let{left:Pt,top:xt,width:lt,height:Qe}=_.select,en=_.scales[$e].ori,hn=_.posToVal,Tn,Ht,un,jn,Bn,di=Me!=null&&Oe(Me,$e),yi=Pe!=null&&ze(Pe,ft);di&&bn?(en==0?(Tn=Pt,Ht=lt):(Tn=xt,Ht=Qe),un=b[Me],jn=$(hn(Tn,$e),un,ie,0),Bn=$(hn(Tn+Ht,$e),un,ie,0),oo(wi(jn,Bn),yn(Bn-jn))):oo(0,ie),yi&&wn?(en==1?(Tn=Pt,Ht=lt):(Tn=xt,Ht=Qe),un=b[Pe],jn=I(hn(Tn,ft),un,fe,0),Bn=I(hn(Tn+Ht,ft),un,fe,0),ao(wi(jn,Bn),yn(Bn-jn))):ao(0,fe)}else Vc()}else{let Me=yn(od-sd),Pe=yn(ad-rd);if(D.ori==1){let ft=Me;Me=Pe,Pe=ft}bn=Rn.x&&Me>=Rn.dist,wn=Rn.y&&Pe>=Rn.dist;let Oe=Rn.uni;Oe!=null?bn&&wn&&(bn=Me>=Oe,wn=Pe>=Oe,!bn&&!wn&&(Pe>Me?wn=!0:bn=!0)):Rn.x&&Rn.y&&(bn||wn)&&(bn=wn=!0);let ze,$e;bn&&(D.ori==0?(ze=dr,$e=jt):(ze=fr,$e=on),oo(wi(ze,$e),yn($e-ze)),wn||ao(0,fe)),wn&&(D.ori==1?(ze=dr,$e=jt):(ze=fr,$e=on),ao(wi(ze,$e),yn($e-ze)),bn||oo(0,ie)),!bn&&!wn&&(oo(0,0),ao(0,0))}if(Rn._x=bn,Rn._y=wn,_==null){if(R){if(yd!=null){let[Me,Pe]=gn.scales;gn.values[0]=Me!=null?Fi(D.ori==0?jt:on,Me):null,gn.values[1]=Pe!=null?Fi(D.ori==1?jt:on,Pe):null}co(Zc,n,jt,on,O,Ie,L)}if(Fe){let Me=R&&gn.setSeries,Pe=Ne.prox;Vs==null?ji<=Pe&&Ui(xs,mr,!0,Me):ji>Pe?Ui(null,mr,!0,Me):xs!=Vs&&Ui(xs,mr,!0,Me)}}he&&(de.idx=L,Bc()),w!==!1&&En("setCursor")}let vs=null;Object.defineProperty(n,"rect",{get(){return vs==null&&lo(!1),vs}});function lo(_=!1){_?vs=null:(vs=g.getBoundingClientRect(),En("syncRect",vs))}function hd(_,w,R,L,G,ie,fe){me._lock||gs&&_!=null&&_.movementX==0&&_.movementY==0||(kc(_,w,R,L,G,ie,fe,!1,_!=null),_!=null?Gs(null,!0,!0):Gs(w,!0,!1))}function kc(_,w,R,L,G,ie,fe,Me,Pe){if(vs==null&&lo(!1),Je(_),_!=null)R=_.clientX-vs.left,L=_.clientY-vs.top;else{if(R<0||L<0){jt=-10,on=-10;return}let[Oe,ze]=gn.scales,$e=w.cursor.sync,[ft,Nt]=$e.values,[Pt,xt]=$e.scales,[lt,Qe]=gn.match,en=w.axes[0].side%2==1,hn=D.ori==0?O:Ie,Tn=D.ori==1?O:Ie,Ht=en?ie:G,un=en?G:ie,jn=en?L:R,Bn=en?R:L;if(Pt!=null?R=lt(Oe,Pt)?a(ft,b[Oe],hn,0):-10:R=hn*(jn/Ht),xt!=null?L=Qe(ze,xt)?a(Nt,b[ze],Tn,0):-10:L=Tn*(Bn/un),D.ori==1){let di=R;R=L,L=di}}Pe&&(w==null||w.cursor.event.type==Zc)&&((R<=1||R>=O-1)&&(R=Ws(R,O)),(L<=1||L>=Ie-1)&&(L=Ws(L,Ie))),Me?(sd=R,rd=L,[dr,fr]=me.move(n,R,L)):(jt=R,on=L)}let zc={width:0,height:0,left:0,top:0};function Vc(){la(zc,!1)}let ud,dd,fd,pd;function md(_,w,R,L,G,ie,fe){gs=!0,bn=wn=Rn._x=Rn._y=!1,kc(_,w,R,L,G,ie,fe,!0,!1),_!=null&&(pt(Jc,th,gd,!1),co(Cd,n,dr,fr,O,Ie,null));let{left:Me,top:Pe,width:Oe,height:ze}=Qt;ud=Me,dd=Pe,fd=Oe,pd=ze}function gd(_,w,R,L,G,ie,fe){gs=Rn._x=Rn._y=!1,kc(_,w,R,L,G,ie,fe,!1,!0);let{left:Me,top:Pe,width:Oe,height:ze}=Qt,$e=Oe>0||ze>0,ft=ud!=Me||dd!=Pe||fd!=Oe||pd!=ze;if($e&&ft&&la(Qt),Rn.setScale&&$e&&ft){let Nt=Me,Pt=Oe,xt=Pe,lt=ze;if(D.ori==1&&(Nt=Pe,Pt=ze,xt=Me,lt=Oe),bn&&_s(C,Fi(Nt,C),Fi(Nt+Pt,C)),wn)for(let Qe in b){let en=b[Qe];Qe!=C&&en.from==null&&en.min!=Yt&&_s(Qe,Fi(xt+lt,Qe),Fi(xt,Qe))}Vc()}else me.lock&&(me._lock=!me._lock,Gs(w,!0,_!=null));_!=null&&(kt(Jc,th),co(Jc,n,jt,on,O,Ie,null))}function wg(_,w,R,L,G,ie,fe){if(me._lock)return;Je(_);let Me=gs;if(gs){let Pe=!0,Oe=!0,ze=10,$e,ft;D.ori==0?($e=bn,ft=wn):($e=wn,ft=bn),$e&&ft&&(Pe=jt<=ze||jt>=O-ze,Oe=on<=ze||on>=Ie-ze),$e&&Pe&&(jt=jt<dr?0:O),ft&&Oe&&(on=on<fr?0:Ie),Gs(null,!0,!0),gs=!1}jt=-10,on=-10,ce.fill(null),Gs(null,!0,!0),Me&&(gs=Me)}function _d(_,w,R,L,G,ie,fe){me._lock||(Je(_),_e(),Vc(),_!=null&&co(Id,n,jt,on,O,Ie,null))}function xd(){A.forEach(C_),N(n.width,n.height,!0)}Ys(_a,Mr,xd);let gr={};gr.mousedown=md,gr.mousemove=hd,gr.mouseup=gd,gr.dblclick=_d,gr.setSeries=(_,w,R,L)=>{let G=gn.match[2];R=G(n,w,R),R!=-1&&Ui(R,L,!0,!1)},be&&(pt(Cd,g,md),pt(Zc,g,hd),pt(Rd,g,_=>{Je(_),lo(!1)}),pt(Pd,g,wg),pt(Id,g,_d),ch.add(n),n.syncRect=lo);let ca=n.hooks=i.hooks||{};function En(_,w,R){On?zt.push([_,w,R]):_ in ca&&ca[_].forEach(L=>{L.call(null,n,w,R)})}(i.plugins||[]).forEach(_=>{for(let w in _.hooks)ca[w]=(ca[w]||[]).concat(_.hooks[w])});let vd=(_,w,R)=>R,gn=_n({key:null,setSeries:!1,filters:{pub:Gd,sub:Gd},scales:[C,v[1]?v[1].scale:null],match:[Hd,Hd,vd],values:[null,null]},me.sync);gn.match.length==2&&gn.match.push(vd),me.sync=gn;let yd=gn.key,Gc=zf(yd);function co(_,w,R,L,G,ie,fe){gn.filters.pub(_,w,R,L,G,ie,fe)&&Gc.pub(_,w,R,L,G,ie,fe)}Gc.sub(n);function Eg(_,w,R,L,G,ie,fe){gn.filters.sub(_,w,R,L,G,ie,fe)&&gr[_](null,w,R,L,G,ie,fe)}n.pub=Eg;function Tg(){Gc.unsub(n),ch.delete(n),rn.clear(),sh(_a,Mr,xd),c.remove(),Ce?.remove(),En("destroy")}n.destroy=Tg;function Hc(){En("init",i,e),X(e||i.data,!1),V[C]?Uc(C,V[C]):_e(),ne=Qt.show&&(Qt.width>0||Qt.height>0),K=he=!0,N(i.width,i.height)}return v.forEach(ps),A.forEach(Wn),t?t instanceof HTMLElement?(t.appendChild(c),Hc()):t(n,Hc):Hc(),n}dn.assign=_n;dn.fmtNum=gh;dn.rangeNum=xa;dn.rangeLog=Sa;dn.rangeAsinh=ph;dn.orient=Zs;dn.pxRatio=Ut;dn.join=v0;dn.fmtDate=xh,dn.tzDate=P0;dn.sync=zf;{dn.addGap=d_,dn.clipGaps=wa;let i=dn.paths={points:qf};i.linear=$f,i.stepped=m_,i.bars=g_,i.spline=x_}var Eh={reversal:"▲",corner:"◆","first zero":"●","curvature step":"▼",peak:"▲"},Pr={alone:250,each:170,paper:120,axis:40,gap:8};function Ca(i,e){return new Th(i,e)}var Th=class{constructor(e,t){this.host=e;this.chart=t;this.whole=this.range=R_(t),e.tabIndex=0,e.addEventListener("keydown",this.key),this.body=Ze(e,"div"),this.resize()}host;chart;range;whole;hidden=new Set;views=[];body;resize(){this.views.forEach(l=>l.plot.destroy()),this.body.replaceChildren();let e=Ss(this.host),{panels:t}=this.chart,n=t.flatMap(l=>l.curves.map(c=>({name:c.name,dash:c.dash,colour:qn(c.colour,e.card),glyph:c.half?"●":void 0}))),s=t.flatMap(l=>l.ticks.map(c=>({name:c.mark,dash:"",colour:e.muted,glyph:Eh[c.mark]}))),r=uo(this.body,[...n,...s],this.hidden,()=>this.redraw());n.filter(l=>l.glyph).forEach(l=>{let c=[...r.children].find(h=>h.lastChild.textContent===l.name);c.firstChild.style.color=l.colour});let o=t.flatMap(l=>l.y_ticks.map(([,c])=>c.length)),a=Math.max(58,7*Math.max(0,...o)+14);this.views=t.map((l,c)=>new Ah(this,l,this.body,e,a,c===t.length-1))}zoom(e=this.whole){let t=this.chart.panels[0].log_x,[n,s]=e;(t?s/n>1.0001:s-n>1e-9*(this.whole[1]-this.whole[0]))&&(this.range=[Math.max(n,this.whole[0]),Math.min(s,this.whole[1])]),this.redraw()}redraw(){this.views.forEach(e=>e.plot.redraw())}update(){this.views.some(e=>e.isBehind)?this.resize():this.redraw()}point(e,t){this.views.forEach(n=>{n!==t&&n.moved(e)})}destroy(){this.views.forEach(e=>e.plot.destroy()),this.host.removeEventListener("keydown",this.key),this.host.replaceChildren()}key=e=>{let t=this.chart.panels[0].log_x,n=t?Math.log:h=>h,s=t?Math.exp:h=>h,[r,o]=this.range.map(n),a=n(this.views[0].at??s((r+o)/2)),l={ArrowLeft:-.01,ArrowRight:.01}[e.key],c={"+":.5,"-":2}[e.key];if(l)this.point(s(Math.min(Math.max(a+l*(o-r),r),o)));else if(c)this.zoom([s(a-c*(a-r)),s(a+c*(o-a))]);else if(e.key==="0"||e.key==="Escape")this.zoom();else return;e.preventDefault()}};function R_(i){let e=1/0,t=-1/0;for(let r of i.panels)for(let o of r.curves)for(let a of o.x.values)a<e&&(e=a),a>t&&(t=a);let n=i.panels[0].log_x;if(e>t)return[n?.1:0,1];if(e===t)return n?[e/2,e*2]:[e-.5,e+.5];let s=!n&&(i.loops||i.panels.some(r=>r.curves.some(o=>o.half)))?.015*(t-e):0;return[e-s,t+s]}var Ah=class{constructor(e,t,n,s,r,o){this.group=e;this.panel=t;this.colours=s;let a=Ze(n,"div","cl-head");Ze(a,"b","",t.y_label);for(let[y,m]of this.notes())Ze(a,"span","",y).style.color=m;let l=Ze(n,"div","cl-panel"),c=this.scale,h=e.chart.panels.length,d=e.chart.panel_height||(h===1?Pr.alone:pi()?Pr.paper:Pr.each);l.style.setProperty("zoom",String(1/c)),this.tip=new ys(l);let u=`${12*c}px ${xr.slice(5)}`,f={values:(y,m,p,v,A)=>m.map(b=>b===null?"":L_(b,y.scales[y.axes[p].scale].distr===3?b:A)),stroke:s.muted,font:u,labelFont:u,gap:5*c,grid:{stroke:s.line,width:c},ticks:{stroke:s.edge,width:c,size:4*c},border:{show:!0,stroke:s.edge,width:c}},g=t.y_ticks;this.plot=new dn({width:_r(n.parentElement)*c,height:(d+(o?Pr.axis:Pr.gap))*c,padding:[6*c,22*c,0,0],scales:{x:{time:!1,distr:t.log_x?3:1,range:()=>e.range},y:{distr:t.log_y?3:1,range:()=>this.heights()}},series:[{},...t.curves.map(y=>this.series(y))],axes:[{...f,...t.log_x?{splits:jf,filter:I_}:{},size:(o?24:Pr.gap)*c,space:70*c,...o?{label:t.x_label,labelSize:16*c,labelGap:0}:{values:()=>[]}},{...f,...t.log_y?{splits:(y,m,p,v)=>jf(y,m,p,v).filter(A=>v<2e3*p||P_(A))}:{},size:r*c,space:32*c,...g.length?{splits:()=>g.map(([y])=>y),values:()=>g.map(([,y])=>y)}:{}}],legend:{show:!1},cursor:{y:!1,points:{show:!1},drag:{setScale:!1,x:!0,y:!1}},hooks:{drawAxes:[()=>this.shade()],draw:[()=>this.mark()],setCursor:[y=>this.pointed(y)],setSelect:[y=>this.selected(y)]}},[e.whole,...t.curves.map(()=>[1,1])],l),this.plot.over.addEventListener("dblclick",()=>e.zoom())}group;panel;colours;plot;at=null;tip;scale=pi()?2:1;get isBehind(){return this.plot.series.length!==this.panel.curves.length+1}get shown(){return this.panel.curves.filter(e=>!this.group.hidden.has(e.name))}notes(){let{band:e,y_range:t,levels:n,far:s}=this.panel,r=", off scale",o=[];e&&o.push([this.panel.band_label+(t&&e[1]>t[1]?r:""),this.colours.band]),this.panel.span&&o.push([this.panel.span_label,this.colours.band]);for(let a of n)a.label&&o.push([a.label+(s?r:""),this.colours.limit]);return o}heights(){let{y_range:e,log_y:t,band:n,levels:s,far:r}=this.panel;if(e)return e;let[o,a]=this.group.range,l=1/0,c=-1/0,h=u=>{!Number.isFinite(u)||t&&u<=0||(u<l&&(l=u),u>c&&(c=u))};for(let{x:u,y:f,half:g}of this.shown)for(let y=0;y<u.values.length;y+=1)!(u.values[y]>=o&&u.values[y]<=a)&&!(y>0&&u.values[y-1]<a&&u.values[y]>o)||(h(f.values[y]-(g?g.values[y]:0)),h(f.values[y]+(g?g.values[y]:0)));if(!t)for(let u of n??[])h(u);if(!r)for(let u of s)h(u.value);for(let[u]of this.panel.y_ticks)h(u-.5),h(u+.5);if(l>c)return t?[1,10]:[0,1];if(t)return[l/1.3,c*1.3];let d=this.panel.y_ticks.length?0:.07*(c-l||Math.abs(c)||1);return[l-d,c+d]}series(e){let t=qn(e.colour,this.colours.card),n=this.scale;return{cap:e.dash==="solid"&&e.width<3?"round":"butt",stroke:t,width:(e.half?1:e.width)*n,dash:vr[e.dash].map(s=>s*n),points:{show:!1},fill:e.half?t:void 0,paths:s=>this.group.hidden.has(e.name)?null:this.path(s,e)}}path(e,{x:t,y:n,half:s,width:r}){let o=ws(e,"x"),a=ws(e,"y"),l=new Path2D,c=new Path2D,h=(1.3+1.3*r)*this.scale*dn.pxRatio,d=!1;for(let p=0;p<t.values.length;p+=1){let v=o(t.values[p]),A=a(n.values[p]);if(!Number.isFinite(v)||!Number.isFinite(A)){d=!1;continue}s?(c.moveTo(v+h,A),c.arc(v,A,h,0,7),s.values[p]>0&&(l.moveTo(v,a(n.values[p]-s.values[p])),l.lineTo(v,a(n.values[p]+s.values[p])))):(d||l.moveTo(v,A),l.lineTo(v,A)),d=!0}let{left:u,top:f,width:g,height:y}=e.bbox,m=new Path2D;return m.rect(u,f,g,y),{stroke:l,fill:s?c:null,clip:m}}shade(){let{band:e,span:t}=this.panel,{ctx:n}=this.plot,{left:s,top:r,width:o,height:a}=this.plot.bbox,l=ws(this.plot,"x"),c=ws(this.plot,"y");n.save(),n.beginPath(),n.rect(s,r,o,a),n.clip(),n.fillStyle=n.strokeStyle=this.colours.band,n.globalAlpha=.1,e&&n.fillRect(s,c(e[1]),o,c(e[0])-c(e[1])),t&&n.fillRect(l(t[0]),r,l(t[1])-l(t[0]),a),n.globalAlpha=1;for(let h of e??[])h!==0&&this.across(c(h),vr.dot);n.restore()}across(e,t){let{ctx:n,bbox:s}=this.plot,r=this.scale*dn.pxRatio;n.lineWidth=1.1*r,n.setLineDash(t.map(o=>o*r)),n.beginPath(),n.moveTo(s.left,e),n.lineTo(s.left+s.width,e),n.stroke(),n.setLineDash([])}mark(){let{levels:e,ticks:t,far:n}=this.panel,{ctx:s,bbox:r}=this.plot,o=this.scale*dn.pxRatio,a=ws(this.plot,"x"),l=ws(this.plot,"y");s.save(),s.strokeStyle=this.colours.limit;for(let c of n?[]:e){let h=l(c.value);h>=r.top&&h<=r.top+r.height&&this.across(h,vr.dash)}s.fillStyle=this.colours.muted,s.font=`${9*o}px ${xr.slice(5)}`,s.textAlign="center",s.textBaseline="bottom";for(let c of t){let h=a(c.x);h>=r.left&&h<=r.left+r.width&&!this.group.hidden.has(c.mark)&&s.fillText(Eh[c.mark]??"●",h,r.top+r.height)}s.restore()}selected(e){let{left:t,width:n}=e.select;n<3||(e.setSelect({left:0,top:0,width:0,height:0},!1),this.group.zoom([e.posToVal(t,"x"),e.posToVal(t+n,"x")]))}pointed(e){if(!e.cursor.event)return;let{left:t=-1,top:n=-1}=e.cursor;this.at=t<0?null:e.posToVal(t,"x"),this.tell(t,n),this.group.point(this.at,this)}moved(e){this.at=e;let t=e===null?-10:this.plot.valToPos(e,"x");this.plot.setCursor({left:t,top:-10},!1),this.tell(t,8)}tell(e,t){if(this.at===null)return this.tip.hide();let n=this.group.chart.loops&&t!==8?this.nearest(e,t):this.values(this.at);this.tip.show(this.plot.over.offsetLeft+e,this.plot.over.offsetTop+t,n)}values(e){let{x_label:t,y_label:n,ticks:s,y_ticks:r}=this.panel,{valToPos:o}=this.plot,a=[],l=h=>Math.abs(o(h,"x")-o(e,"x"));if(this.group.chart.loops)return a;for(let h of this.shown){let d=D_(h.x.values,e),u=h.y.values[d];if(d<0||!Number.isFinite(u)||l(h.x.values[d])>24)continue;let f=r.length?"":` ${Ft(u,ho(n))}`;a.length||a.push([Ft(h.x.values[d],ho(t),6)]),a.push([h.name+f,qn(h.colour,this.colours.card)])}let c=s.reduce((h,d)=>l(d.x)<(h?l(h.x):6)?d:h,null);return c&&a.length&&a.push([`${Eh[c.mark]??""} ${c.label}`]),a}nearest(e,t){let n=ws(this.plot,"x",!1),s=ws(this.plot,"y",!1),r=30**2,o=null;for(let u of this.shown)u.x.values.forEach((f,g)=>{let y=(n(f)-e)**2+(s(u.y.values[g])-t)**2;y<r&&([r,o]=[y,[u,g]])});if(!o)return[];let[a,l]=o,{x_label:c,y_label:h}=this.panel,d=a.numbers?` ${a.numbers.values[l]}`:"";return[[a.name+d,qn(a.colour,this.colours.card)],[`${Yc(c)} ${Ft(a.x.values[l],ho(c))}`],[`${Yc(h)} ${Ft(a.y.values[l],ho(h))}`]]}};function ws(i,e,t=!0){let{min:n,max:s,distr:r}=i.scales[e],{bbox:o}=i,a=t?1:dn.pxRatio,l=r===3?Math.log:f=>f,c=l(n),h=l(s)-c,d=(e==="x"?o.width:o.height)/a,u=t?e==="x"?o.left:o.top:0;return e==="x"?f=>u+d*(l(f)-c)/h:f=>u+d*(1-(l(f)-c)/h)}function jf(i,e,t,n){let s=Math.floor(Math.log10(t)),r=9*(Math.ceil(Math.log10(n))-s)+1;return Array.from({length:r},(a,l)=>+`${1+l%9}e${s+Math.floor(l/9)}`).filter(a=>a>=t&&a<=n)}var P_=i=>i.toExponential()[0]==="1";function I_(i,e){let t=Math.abs(i.valToPos(10,"x")-i.valToPos(1,"x")),n=t>240?"125":"1";return e.map(s=>n.includes(s.toExponential()[0])?s:null)}function L_(i,e){let t=Math.ceil(-Math.log10(e))+1;return t>7?Ft(i):i.toLocaleString("en",{maximumFractionDigits:Math.max(t,0)})}function D_(i,e){let t=0,n=i.length-1;for(;n-t>1;){let s=t+n>>1;for(;s<n&&Number.isNaN(i[s]);)s+=1;if(s===n){n=t+n>>1;continue}i[s]<=e?t=s:n=s}return n<0?-1:Math.abs(i[t]-e)<=Math.abs(i[n]-e)?t:n}var Ch=92,N_=40,U_="#444444";function ep(i,e){let t=e.y_names.length,n=e.x_names.length,{values:s}=e.values,r=Ze(i,"div","cl-panel"),o=Ze(r,"canvas"),a=new ys(r),l=0,c=[1,1],h=0;function d(f){if(!Number.isFinite(f))return U_;let g=Math.min(Math.max((f-e.low)/(e.high-e.low||1),0),1),y=e.colours.findIndex(([C])=>C>g);y<0&&(y=e.colours.length-1);let[[m,p],[v,A]]=[e.colours[y-1],e.colours[y]],b=(g-m)/(v-m||1);return`rgb(${[1,3,5].map(C=>{let x=parseInt(p.slice(C,C+2),16),T=parseInt(A.slice(C,C+2),16);return Math.round(x+Math.min(b,1)*(T-x))}).join()})`}function u(){let f=_r(i),g=Ss(i);l=14+7*Math.max(...e.y_names.map(v=>v.length),3)+18,h=Math.min(Math.max(16*t,90),420),c=[(f-l-Ch)/n,h/t];let y=da(o,f,h+N_+8);y.translate(0,8);for(let v=0;v<t;v+=1)for(let A=0;A<n;A+=1)y.fillStyle=d(s[v*n+A]),y.fillRect(l+A*c[0],h-(v+1)*c[1],c[0]+.5,c[1]+.5);y.fillStyle=g.muted,y.font=xr,y.textBaseline="middle",y.textAlign="right",Qf(t,c[1],16,v=>y.fillText(e.y_names[v],l-6,h-(v+.5)*c[1])),y.textAlign="center";let m=7*Math.max(...e.x_names.map(v=>v.length))+10;Qf(n,c[0],m,v=>y.fillText(e.x_names[v],l+(v+.5)*c[0],h+11)),y.fillText(e.x_label,l+n*c[0]/2,h+29),y.save(),y.translate(8,h/2),y.rotate(-Math.PI/2),y.fillText(e.y_label,0,0),y.restore();for(let v=0;v<h;v+=1)y.fillStyle=d(e.low+(e.high-e.low)*(v+.5)/h),y.fillRect(f-Ch+14,h-v-1,12,1.5);y.fillStyle=g.muted,y.textAlign="left";let p=e.colours.find(([v],A)=>A>0&&v===e.colours[A-1][0])?.[0];for(let v of[0,p??.5,1]){if(v%1&&Math.min(v,1-v)*h<14)continue;let A=Ft(e.low+v*(e.high-e.low),"",3)+(v===1?` ${e.unit}`:"");y.fillText(A,f-Ch+30,Math.min(Math.max(h*(1-v),5),h-5))}}return o.addEventListener("pointermove",f=>{let g=Math.floor((f.offsetX-l)/c[0]),y=Math.floor((h+8-f.offsetY)/c[1]);if(g<0||y<0||g>=n||y>=t)return a.hide();let m=s[y*n+g],p=Number.isFinite(m)?Ft(m,e.unit):"diverged, or not judged";a.show(f.offsetX,f.offsetY,[[`${e.x_label} ${e.x_names[g]}`],[`${e.y_label} ${e.y_names[y]}`],[p]])}),o.addEventListener("pointerleave",()=>a.hide()),u(),{resize:u,destroy:()=>i.replaceChildren()}}function Qf(i,e,t,n){let s=Math.max(Math.ceil(t/e),1);for(let r=0;r<i;r+=s)n(r)}var tp=`.cl-path { --p-ink: #1d2733; --p-muted: #5b6774; --p-edge: #c9d0d7; --p-paper: var(--card, #ffffff); --p-path: #7d8791; --p-rapid: #b4bdc6; --p-band: #8cc3b3;
  --p-poor: #a8321e; --p-picked: #f0a202; --p-accent: #0b5a94; color: var(--p-ink); font-size: .9rem; }
.cl-dark .cl-path { --p-ink: #e3e9ef; --p-muted: #9aa7b4; --p-edge: #3d4752; --p-paper: var(--card, #14191f); --p-path: #8d98a4; --p-rapid: #505b67; --p-band: #2f6f5e;
  --p-poor: #ff8f78; --p-picked: #ffb52e; --p-accent: #7cc0f5; }
.cl-path * { box-sizing: border-box; }
.cl-path .path-row { display: flex; flex-wrap: wrap; align-items: center; gap: .4rem .9rem; padding: .45rem 0; }
.cl-path .path-which { display: contents; }
.cl-path .path-views { display: inline-flex; gap: .25rem; }
.cl-path button, .cl-path select { font: inherit; color: var(--p-ink); background: var(--p-paper); border: 1px solid var(--p-edge);
  border-radius: 6px; padding: .15rem .6rem; cursor: pointer; }
.cl-path button:hover, .cl-path select:hover { border-color: var(--p-accent); }
.cl-path :focus-visible { outline: 2px solid var(--p-accent); outline-offset: 1px; }
.cl-path label { display: inline-flex; align-items: center; gap: .35rem; }
.cl-path input { accent-color: var(--p-accent); margin: 0; }
.cl-path input[type=range] { flex: 1 1 9rem; min-width: 6rem; }
.cl-path label i { flex: none; width: 1rem; height: .25rem; border-radius: 2px; }
.cl-path .path-stage { position: relative; height: clamp(300px, 62vh, 600px); background: var(--p-paper); border: 1px solid var(--p-edge);
  border-radius: 8px; overflow: hidden; touch-action: pan-y; cursor: grab; user-select: none; -webkit-user-select: none;
  print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.cl-path .path-stage:active { cursor: grabbing; }
.cl-path canvas, .cl-path svg { position: absolute; inset: 0; width: 100%; height: 100%; }
.cl-path svg { pointer-events: none; }
.cl-path svg text { font-size: 12px; fill: var(--p-ink); stroke: var(--p-paper); stroke-width: 3.5px; paint-order: stroke; stroke-linejoin: round; }
.cl-path svg .path-over { fill: var(--p-poor); font-weight: 600; }
.cl-path svg .path-mark { fill: none; stroke: var(--p-ink); stroke-width: 1.6px; }
.cl-path svg .path-lead { stroke: var(--p-muted); }
.cl-path svg .path-tool { stroke: var(--p-paper); stroke-width: 2px; }
.cl-path svg .path-worst { pointer-events: auto; cursor: pointer; }
.cl-path .path-key, .cl-path .path-bar { position: absolute; left: 12px; pointer-events: none; font-size: 12px; color: var(--p-muted); }
.cl-path .path-key { top: 10px; width: 190px; max-width: 45%; }
.cl-path .path-scale { position: relative; height: 9px; border-radius: 3px; margin: 3px 0 2px; }
.cl-path .path-scale i { position: absolute; top: -3px; bottom: -3px; border-left: 2px solid var(--p-ink); }
.cl-path .path-ends { display: flex; justify-content: space-between; }
.cl-path .path-bar { bottom: 10px; }
.cl-path .path-bar i { display: block; height: 5px; border: 1.5px solid var(--p-ink); border-top: 0; margin-bottom: 2px; }
.cl-path output { font-variant-numeric: tabular-nums; }
.cl-path .path-times { min-width: 7rem; font-weight: 600; }
.cl-path .path-said { display: block; min-height: 1.5em; color: var(--p-muted); }
@media print { .cl-path .path-row, .cl-path .path-said { display: none; } .cl-path .path-stage { break-inside: avoid; } }
`;var Ap=0,iu=1,Cp=2;var Xo=1,Rp=2,jr=3,Os=0,Hn=1,qi=2,ir=0,Qr=1,su=2,ru=3,ou=4,Pp=5;var sr=100,Ip=101,Lp=102,Dp=103,Np=104,Up=200,Fp=201,Op=202,Bp=203,au=204,lu=205,kp=206,zp=207,Vp=208,Gp=209,Hp=210,Wp=211,Xp=212,qp=213,Yp=214,Qa=0,el=1,tl=2,Xr=3,nl=4,il=5,sl=6,rl=7,cu=0,$p=1,Zp=2,Yi=0,hu=1,uu=2,du=3,fu=4,pu=5,mu=6,gu=7;var _u=300,rr=301,eo=302,Nl=303,Ul=304,ol=1e3,Vi=1001,al=1002,Cn=1003,Jp=1004;var qo=1005;var Gn=1006,Fl=1007;var cs=1008;var ui=1009,xu=1010,vu=1011,to=1012,Ol=1013,Ri=1014,Pi=1015,Ii=1016,Bl=1017,kl=1018,or=1020,yu=35902,Su=35899,Mu=1021,bu=1022,Li=1023,as=1026,hs=1027,wu=1028,zl=1029,Bs=1030,Vl=1031;var Gl=1033,Yo=33776,$o=33777,Zo=33778,Jo=33779,Hl=35840,Wl=35841,Xl=35842,ql=35843,Yl=36196,$l=37492,Zl=37496,Jl=37488,Kl=37489,Ko=37490,jl=37491,Ql=37808,ec=37809,tc=37810,nc=37811,ic=37812,sc=37813,rc=37814,oc=37815,ac=37816,lc=37817,cc=37818,hc=37819,uc=37820,dc=37821,fc=36492,pc=36494,mc=36495,gc=36283,_c=36284,jo=36285,xc=36286;var To=2300,ll=2301,Ka=2302,Kh=2303,jh=2400,Qh=2401,eu=2402;var Kp=3200;var Eu=0,jp=1,us="",oi="srgb",Ao="srgb-linear",Co="linear",Bt="srgb";var ja=7680;var Qp=519,em=512,tm=513,nm=514,Tu=515,im=516,sm=517,Au=518,Cu=519,rm=35044;var Qo="300 es",xi=2e3,Ro=2001;function O_(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function B_(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Po(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function om(){let i=Po("canvas");return i.style.display="block",i}var np={},qr=null;function Ru(...i){let e="THREE."+i.shift();qr?qr("log",e,...i):console.log(e,...i)}function am(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function st(...i){i=am(i);let e="THREE."+i.shift();if(qr)qr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function ht(...i){i=am(i);let e="THREE."+i.shift();if(qr)qr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Eo(...i){let e=i.join(" ");e in np||(np[e]=!0,st(...i))}function lm(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var cm={[Qa]:Qa,[tl]:sl,[nl]:nl,[Xr]:il,[el]:el,[sl]:tl,[rl]:rl,[il]:Xr},Gi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Ln=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Rh=Math.PI/180,cl=180/Math.PI;function ea(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Ln[i&255]+Ln[i>>8&255]+Ln[i>>16&255]+Ln[i>>24&255]+"-"+Ln[e&255]+Ln[e>>8&255]+"-"+Ln[e>>16&15|64]+Ln[e>>24&255]+"-"+Ln[t&63|128]+Ln[t>>8&255]+"-"+Ln[t>>16&255]+Ln[t>>24&255]+Ln[n&255]+Ln[n>>8&255]+Ln[n>>16&255]+Ln[n>>24&255]).toLowerCase()}function wt(i,e,t){return Math.max(e,Math.min(t,i))}function k_(i,e){return(i%e+e)%e}function Ph(i,e,t){return(1-t)*i+t*e}function hm(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Pu(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function z_(i,e){if(e.constructor===Float32Array)return i;let t=Pu(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function V_(i,e){if(e.constructor===Float32Array)return i;let t=Pu(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Tt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=wt(this.x,e.x,t.x),this.y=wt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=wt(this.x,e,t),this.y=wt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(wt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(wt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Hi=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],d=n[s+3],u=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(d!==y||l!==u||c!==f||h!==g){let m=l*u+c*f+h*g+d*y;m<0&&(u=-u,f=-f,g=-g,y=-y,m=-m);let p=1-a;if(m<.9995){let v=Math.acos(m),A=Math.sin(v);p=Math.sin(p*v)/A,a=Math.sin(a*v)/A,l=l*p+u*a,c=c*p+f*a,h=h*p+g*a,d=d*p+y*a}else{l=l*p+u*a,c=c*p+f*a,h=h*p+g*a,d=d*p+y*a;let v=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=v,c*=v,h*=v,d*=v}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],d=r[o],u=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+h*d+l*f-c*u,e[t+1]=l*g+h*u+c*d-a*f,e[t+2]=c*g+h*f+a*u-l*d,e[t+3]=h*g-a*d-l*u-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),d=a(r/2),u=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*f*g,this._y=c*f*d-u*h*g,this._z=c*h*g+u*f*d,this._w=c*h*d-u*f*g;break;case"YXZ":this._x=u*h*d+c*f*g,this._y=c*f*d-u*h*g,this._z=c*h*g-u*f*d,this._w=c*h*d+u*f*g;break;case"ZXY":this._x=u*h*d-c*f*g,this._y=c*f*d+u*h*g,this._z=c*h*g+u*f*d,this._w=c*h*d-u*f*g;break;case"ZYX":this._x=u*h*d-c*f*g,this._y=c*f*d+u*h*g,this._z=c*h*g-u*f*d,this._w=c*h*d+u*f*g;break;case"YZX":this._x=u*h*d+c*f*g,this._y=c*f*d+u*h*g,this._z=c*h*g-u*f*d,this._w=c*h*d-u*f*g;break;case"XZY":this._x=u*h*d-c*f*g,this._y=c*f*d-u*h*g,this._z=c*h*g+u*f*d,this._w=c*h*d+u*f*g;break;default:st("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],d=t[10],u=n+a+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>d){let f=2*Math.sqrt(1+n-a-d);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-n-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+d-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(wt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},se=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(ip.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(ip.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),d=2*(r*n-o*t);return this.x=t+l*c+o*d-a*h,this.y=n+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=wt(this.x,e.x,t.x),this.y=wt(this.y,e.y,t.y),this.z=wt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=wt(this.x,e,t),this.y=wt(this.y,e,t),this.z=wt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(wt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Ih.copy(this).projectOnVector(e),this.sub(Ih)}reflect(e){return this.sub(Ih.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(wt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ih=new se,ip=new Hi,dt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],f=n[5],g=n[8],y=s[0],m=s[3],p=s[6],v=s[1],A=s[4],b=s[7],P=s[2],C=s[5],x=s[8];return r[0]=o*y+a*v+l*P,r[3]=o*m+a*A+l*C,r[6]=o*p+a*b+l*x,r[1]=c*y+h*v+d*P,r[4]=c*m+h*A+d*C,r[7]=c*p+h*b+d*x,r[2]=u*y+f*v+g*P,r[5]=u*m+f*A+g*C,r[8]=u*p+f*b+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=h*o-a*c,u=a*l-h*r,f=c*r-o*l,g=t*d+n*u+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=d*y,e[1]=(s*c-h*n)*y,e[2]=(a*n-s*o)*y,e[3]=u*y,e[4]=(h*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=f*y,e[7]=(n*l-c*t)*y,e[8]=(o*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Eo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Lh.makeScale(e,t)),this}rotate(e){return Eo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Lh.makeRotation(-e)),this}translate(e,t){return Eo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Lh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Lh=new dt,sp=new dt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),rp=new dt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function G_(){let i={enabled:!0,workingColorSpace:Ao,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Bt&&(s.r=os(s.r),s.g=os(s.g),s.b=os(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Bt&&(s.r=Wr(s.r),s.g=Wr(s.g),s.b=Wr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===us?Co:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ao]:{primaries:e,whitePoint:n,transfer:Co,toXYZ:sp,fromXYZ:rp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:oi},outputColorSpaceConfig:{drawingBufferColorSpace:oi}},[oi]:{primaries:e,whitePoint:n,transfer:Bt,toXYZ:sp,fromXYZ:rp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:oi}}}),i}var St=G_();function os(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Wr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Ir,hl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Ir===void 0&&(Ir=Po("canvas")),Ir.width=e.width,Ir.height=e.height;let s=Ir.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Ir}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Po("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=os(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(os(t[n]/255)*255):t[n]=os(t[n]);return{data:t,width:e.width,height:e.height}}else return st("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},H_=0,Yr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:H_++}),this.uuid=ea(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Dh(s[o].image)):r.push(Dh(s[o]))}else r=Dh(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Dh(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?hl.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(st("Texture: Unable to serialize Texture."),{})}var W_=0,Nh=new se,Zn=class i extends Gi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Vi,s=Vi,r=Gn,o=cs,a=Li,l=ui,c=i.DEFAULT_ANISOTROPY,h=us){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:W_++}),this.uuid=ea(),this.name="",this.source=new Yr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Tt(0,0),this.repeat=new Tt(1,1),this.center=new Tt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new dt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Nh).x}get height(){return this.source.getSize(Nh).y}get depth(){return this.source.getSize(Nh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){st(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){st(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==_u)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case ol:e.x=e.x-Math.floor(e.x);break;case Vi:e.x=e.x<0?0:1;break;case al:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case ol:e.y=e.y-Math.floor(e.y);break;case Vi:e.y=e.y<0?0:1;break;case al:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Zn.DEFAULT_IMAGE=null;Zn.DEFAULT_MAPPING=_u;Zn.DEFAULT_ANISOTROPY=1;var sn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],g=l[9],y=l[2],m=l[6],p=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-y)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+y)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,b=(f+1)/2,P=(p+1)/2,C=(h+u)/4,x=(d+y)/4,T=(g+m)/4;return A>b&&A>P?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=C/n,r=x/n):b>P?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=C/s,r=T/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=x/r,s=T/r),this.set(n,s,r,t),this}let v=Math.sqrt((m-g)*(m-g)+(d-y)*(d-y)+(u-h)*(u-h));return Math.abs(v)<.001&&(v=1),this.x=(m-g)/v,this.y=(d-y)/v,this.z=(u-h)/v,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=wt(this.x,e.x,t.x),this.y=wt(this.y,e.y,t.y),this.z=wt(this.z,e.z,t.z),this.w=wt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=wt(this.x,e,t),this.y=wt(this.y,e,t),this.z=wt(this.z,e,t),this.w=wt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(wt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ul=class extends Gi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Gn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new sn(0,0,e,t),this.scissorTest=!1,this.viewport=new sn(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Zn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Gn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Yr(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},li=class extends ul{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Io=class extends Zn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=Vi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var dl=class extends Zn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=Vi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var an=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,d,u,f,g,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,d,u,f,g,y,m)}set(e,t,n,s,r,o,a,l,c,h,d,u,f,g,y,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=d,p[14]=u,p[3]=f,p[7]=g,p[11]=y,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Lr.setFromMatrixColumn(e,0).length(),r=1/Lr.setFromMatrixColumn(e,1).length(),o=1/Lr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let u=o*h,f=o*d,g=a*h,y=a*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=f+g*c,t[5]=u-y*c,t[9]=-a*l,t[2]=y-u*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let u=l*h,f=l*d,g=c*h,y=c*d;t[0]=u+y*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*d,t[5]=o*h,t[9]=-a,t[2]=f*a-g,t[6]=y+u*a,t[10]=o*l}else if(e.order==="ZXY"){let u=l*h,f=l*d,g=c*h,y=c*d;t[0]=u-y*a,t[4]=-o*d,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*h,t[9]=y-u*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let u=o*h,f=o*d,g=a*h,y=a*d;t[0]=l*h,t[4]=g*c-f,t[8]=u*c+y,t[1]=l*d,t[5]=y*c+u,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let u=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=y-u*d,t[8]=g*d+f,t[1]=d,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=f*d+g,t[10]=u-y*d}else if(e.order==="XZY"){let u=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=u*d+y,t[5]=o*h,t[9]=f*d-g,t[2]=g*d-f,t[6]=a*h,t[10]=y*d+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(X_,e,q_)}lookAt(e,t,n){let s=this.elements;return si.subVectors(e,t),si.lengthSq()===0&&(si.z=1),si.normalize(),Es.crossVectors(n,si),Es.lengthSq()===0&&(Math.abs(n.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Es.crossVectors(n,si)),Es.normalize(),Ra.crossVectors(si,Es),s[0]=Es.x,s[4]=Ra.x,s[8]=si.x,s[1]=Es.y,s[5]=Ra.y,s[9]=si.y,s[2]=Es.z,s[6]=Ra.z,s[10]=si.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],f=n[13],g=n[2],y=n[6],m=n[10],p=n[14],v=n[3],A=n[7],b=n[11],P=n[15],C=s[0],x=s[4],T=s[8],z=s[12],F=s[1],D=s[5],q=s[9],$=s[13],I=s[2],V=s[6],te=s[10],k=s[14],pe=s[3],Q=s[7],re=s[11],ce=s[15];return r[0]=o*C+a*F+l*I+c*pe,r[4]=o*x+a*D+l*V+c*Q,r[8]=o*T+a*q+l*te+c*re,r[12]=o*z+a*$+l*k+c*ce,r[1]=h*C+d*F+u*I+f*pe,r[5]=h*x+d*D+u*V+f*Q,r[9]=h*T+d*q+u*te+f*re,r[13]=h*z+d*$+u*k+f*ce,r[2]=g*C+y*F+m*I+p*pe,r[6]=g*x+y*D+m*V+p*Q,r[10]=g*T+y*q+m*te+p*re,r[14]=g*z+y*$+m*k+p*ce,r[3]=v*C+A*F+b*I+P*pe,r[7]=v*x+A*D+b*V+P*Q,r[11]=v*T+A*q+b*te+P*re,r[15]=v*z+A*$+b*k+P*ce,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],d=e[6],u=e[10],f=e[14],g=e[3],y=e[7],m=e[11],p=e[15],v=l*f-c*u,A=a*f-c*d,b=a*u-l*d,P=o*f-c*h,C=o*u-l*h,x=o*d-a*h;return t*(y*v-m*A+p*b)-n*(g*v-m*P+p*C)+s*(g*A-y*P+p*x)-r*(g*b-y*C+m*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=e[9],u=e[10],f=e[11],g=e[12],y=e[13],m=e[14],p=e[15],v=t*a-n*o,A=t*l-s*o,b=t*c-r*o,P=n*l-s*a,C=n*c-r*a,x=s*c-r*l,T=h*y-d*g,z=h*m-u*g,F=h*p-f*g,D=d*m-u*y,q=d*p-f*y,$=u*p-f*m,I=v*$-A*q+b*D+P*F-C*z+x*T;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/I;return e[0]=(a*$-l*q+c*D)*V,e[1]=(s*q-n*$-r*D)*V,e[2]=(y*x-m*C+p*P)*V,e[3]=(u*C-d*x-f*P)*V,e[4]=(l*F-o*$-c*z)*V,e[5]=(t*$-s*F+r*z)*V,e[6]=(m*b-g*x-p*A)*V,e[7]=(h*x-u*b+f*A)*V,e[8]=(o*q-a*F+c*T)*V,e[9]=(n*F-t*q-r*T)*V,e[10]=(g*C-y*b+p*v)*V,e[11]=(d*b-h*C-f*v)*V,e[12]=(a*z-o*D-l*T)*V,e[13]=(t*D-n*z+s*T)*V,e[14]=(y*A-g*P-m*v)*V,e[15]=(h*P-d*A+u*v)*V,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,d=a+a,u=r*c,f=r*h,g=r*d,y=o*h,m=o*d,p=a*d,v=l*c,A=l*h,b=l*d,P=n.x,C=n.y,x=n.z;return s[0]=(1-(y+p))*P,s[1]=(f+b)*P,s[2]=(g-A)*P,s[3]=0,s[4]=(f-b)*C,s[5]=(1-(u+p))*C,s[6]=(m+v)*C,s[7]=0,s[8]=(g+A)*x,s[9]=(m-v)*x,s[10]=(1-(u+y))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=Lr.set(s[0],s[1],s[2]).length(),a=Lr.set(s[4],s[5],s[6]).length(),l=Lr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ei.copy(this);let c=1/o,h=1/a,d=1/l;return Ei.elements[0]*=c,Ei.elements[1]*=c,Ei.elements[2]*=c,Ei.elements[4]*=h,Ei.elements[5]*=h,Ei.elements[6]*=h,Ei.elements[8]*=d,Ei.elements[9]*=d,Ei.elements[10]*=d,t.setFromRotationMatrix(Ei),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=xi,l=!1){let c=this.elements,h=2*r/(t-e),d=2*r/(n-s),u=(t+e)/(t-e),f=(n+s)/(n-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===xi)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Ro)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=xi,l=!1){let c=this.elements,h=2/(t-e),d=2/(n-s),u=-(t+e)/(t-e),f=-(n+s)/(n-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===xi)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===Ro)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Lr=new se,Ei=new an,X_=new se(0,0,0),q_=new se(1,1,1),Es=new se,Ra=new se,si=new se,op=new an,ap=new Hi,Is=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(wt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-wt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(wt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-wt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(wt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-wt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:st("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return op.makeRotationFromQuaternion(e),this.setFromRotationMatrix(op,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return ap.setFromEuler(this),this.setFromQuaternion(ap,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Is.DEFAULT_ORDER="XYZ";var Lo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Y_=0,lp=new se,Dr=new Hi,ts=new an,Pa=new se,yo=new se,$_=new se,Z_=new Hi,cp=new se(1,0,0),hp=new se(0,1,0),up=new se(0,0,1),dp={type:"added"},J_={type:"removed"},Nr={type:"childadded",child:null},Uh={type:"childremoved",child:null},ci=class i extends Gi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Y_++}),this.uuid=ea(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new se,t=new Is,n=new Hi,s=new se(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new an},normalMatrix:{value:new dt}}),this.matrix=new an,this.matrixWorld=new an,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Lo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Dr.setFromAxisAngle(e,t),this.quaternion.multiply(Dr),this}rotateOnWorldAxis(e,t){return Dr.setFromAxisAngle(e,t),this.quaternion.premultiply(Dr),this}rotateX(e){return this.rotateOnAxis(cp,e)}rotateY(e){return this.rotateOnAxis(hp,e)}rotateZ(e){return this.rotateOnAxis(up,e)}translateOnAxis(e,t){return lp.copy(e).applyQuaternion(this.quaternion),this.position.add(lp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(cp,e)}translateY(e){return this.translateOnAxis(hp,e)}translateZ(e){return this.translateOnAxis(up,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ts.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Pa.copy(e):Pa.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),yo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ts.lookAt(yo,Pa,this.up):ts.lookAt(Pa,yo,this.up),this.quaternion.setFromRotationMatrix(ts),s&&(ts.extractRotation(s.matrixWorld),Dr.setFromRotationMatrix(ts),this.quaternion.premultiply(Dr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ht("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(dp),Nr.child=e,this.dispatchEvent(Nr),Nr.child=null):ht("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(J_),Uh.child=e,this.dispatchEvent(Uh),Uh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ts.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ts.multiply(e.parent.matrixWorld)),e.applyMatrix4(ts),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(dp),Nr.child=e,this.dispatchEvent(Nr),Nr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(yo,e,$_),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(yo,Z_,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),d=o(e.shapes),u=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ci.DEFAULT_UP=new se(0,1,0);ci.DEFAULT_MATRIX_AUTO_UPDATE=!0;ci.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var er=class extends ci{constructor(){super(),this.isGroup=!0,this.type="Group"}},K_={type:"move"},$r=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new er,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new er,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new se,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new se),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new er,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new se,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new se,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let m=t.getJointPose(y,n),p=this._getHandJoint(c,y);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,g=.005;c.inputState.pinching&&u>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(K_)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new er;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},um={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ts={h:0,s:0,l:0},Ia={h:0,s:0,l:0};function Fh(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var At=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=oi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=n,St.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=St.workingColorSpace){if(e=k_(e,1),t=wt(t,0,1),n=wt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Fh(o,r,e+1/3),this.g=Fh(o,r,e),this.b=Fh(o,r,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=oi){function n(r){r!==void 0&&parseFloat(r)<1&&st("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:st("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);st("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=oi){let n=um[e.toLowerCase()];return n!==void 0?this.setHex(n,t):st("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=os(e.r),this.g=os(e.g),this.b=os(e.b),this}copyLinearToSRGB(e){return this.r=Wr(e.r),this.g=Wr(e.g),this.b=Wr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=oi){return St.workingToColorSpace(Dn.copy(this),e),Math.round(wt(Dn.r*255,0,255))*65536+Math.round(wt(Dn.g*255,0,255))*256+Math.round(wt(Dn.b*255,0,255))}getHexString(e=oi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(Dn.copy(this),t);let n=Dn.r,s=Dn.g,r=Dn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(Dn.copy(this),t),e.r=Dn.r,e.g=Dn.g,e.b=Dn.b,e}getStyle(e=oi){St.workingToColorSpace(Dn.copy(this),e);let t=Dn.r,n=Dn.g,s=Dn.b;return e!==oi?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Ts),this.setHSL(Ts.h+e,Ts.s+t,Ts.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Ts),e.getHSL(Ia);let n=Ph(Ts.h,Ia.h,t),s=Ph(Ts.s,Ia.s,t),r=Ph(Ts.l,Ia.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Dn=new At;At.NAMES=um;var Do=class extends ci{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Is,this.environmentIntensity=1,this.environmentRotation=new Is,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ti=new se,ns=new se,Oh=new se,is=new se,Ur=new se,Fr=new se,fp=new se,Bh=new se,kh=new se,zh=new se,Vh=new sn,Gh=new sn,Hh=new sn,Ps=class i{constructor(e=new se,t=new se,n=new se){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ti.subVectors(e,t),s.cross(Ti);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ti.subVectors(s,t),ns.subVectors(n,t),Oh.subVectors(e,t);let o=Ti.dot(Ti),a=Ti.dot(ns),l=Ti.dot(Oh),c=ns.dot(ns),h=ns.dot(Oh),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(c*l-a*h)*u,g=(o*h-a*l)*u;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,is)===null?!1:is.x>=0&&is.y>=0&&is.x+is.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,is)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,is.x),l.addScaledVector(o,is.y),l.addScaledVector(a,is.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Vh.setScalar(0),Gh.setScalar(0),Hh.setScalar(0),Vh.fromBufferAttribute(e,t),Gh.fromBufferAttribute(e,n),Hh.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Vh,r.x),o.addScaledVector(Gh,r.y),o.addScaledVector(Hh,r.z),o}static isFrontFacing(e,t,n,s){return Ti.subVectors(n,t),ns.subVectors(e,t),Ti.cross(ns).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ti.subVectors(this.c,this.b),ns.subVectors(this.a,this.b),Ti.cross(ns).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Ur.subVectors(s,n),Fr.subVectors(r,n),Bh.subVectors(e,n);let l=Ur.dot(Bh),c=Fr.dot(Bh);if(l<=0&&c<=0)return t.copy(n);kh.subVectors(e,s);let h=Ur.dot(kh),d=Fr.dot(kh);if(h>=0&&d<=h)return t.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(Ur,o);zh.subVectors(e,r);let f=Ur.dot(zh),g=Fr.dot(zh);if(g>=0&&f<=g)return t.copy(r);let y=f*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(Fr,a);let m=h*g-f*d;if(m<=0&&d-h>=0&&f-g>=0)return fp.subVectors(r,s),a=(d-h)/(d-h+(f-g)),t.copy(s).addScaledVector(fp,a);let p=1/(m+y+u);return o=y*p,a=u*p,t.copy(n).addScaledVector(Ur,o).addScaledVector(Fr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ls=class{constructor(e=new se(1/0,1/0,1/0),t=new se(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ai.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ai.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ai.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ai):Ai.fromBufferAttribute(r,o),Ai.applyMatrix4(e.matrixWorld),this.expandByPoint(Ai);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),La.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),La.copy(n.boundingBox)),La.applyMatrix4(e.matrixWorld),this.union(La)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ai),Ai.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(So),Da.subVectors(this.max,So),Or.subVectors(e.a,So),Br.subVectors(e.b,So),kr.subVectors(e.c,So),As.subVectors(Br,Or),Cs.subVectors(kr,Br),Js.subVectors(Or,kr);let t=[0,-As.z,As.y,0,-Cs.z,Cs.y,0,-Js.z,Js.y,As.z,0,-As.x,Cs.z,0,-Cs.x,Js.z,0,-Js.x,-As.y,As.x,0,-Cs.y,Cs.x,0,-Js.y,Js.x,0];return!Wh(t,Or,Br,kr,Da)||(t=[1,0,0,0,1,0,0,0,1],!Wh(t,Or,Br,kr,Da))?!1:(Na.crossVectors(As,Cs),t=[Na.x,Na.y,Na.z],Wh(t,Or,Br,kr,Da))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ai).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ai).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ss[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ss[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ss[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ss[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ss[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ss[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ss[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ss[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ss),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ss=[new se,new se,new se,new se,new se,new se,new se,new se],Ai=new se,La=new Ls,Or=new se,Br=new se,kr=new se,As=new se,Cs=new se,Js=new se,So=new se,Da=new se,Na=new se,Ks=new se;function Wh(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Ks.fromArray(i,r);let a=s.x*Math.abs(Ks.x)+s.y*Math.abs(Ks.y)+s.z*Math.abs(Ks.z),l=e.dot(Ks),c=t.dot(Ks),h=n.dot(Ks);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var xn=new se,Ua=new Tt,j_=0,Yn=class extends Gi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:j_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=rm,this.updateRanges=[],this.gpuType=Pi,this.version=0,this._normalizationScale=e!==void 0?Pu(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Ua.fromBufferAttribute(this,t),Ua.applyMatrix3(e),this.setXY(t,Ua.x,Ua.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix3(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix4(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.applyNormalMatrix(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.transformDirection(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):z_(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):V_(e,this.array)}};var No=class extends Yn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Uo=class extends Yn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var $n=class extends Yn{constructor(e,t,n){super(new Float32Array(e),t,n)}},Q_=new Ls,Mo=new se,Xh=new se,tr=class{constructor(e=new se,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Q_.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Mo.subVectors(e,this.center);let t=Mo.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Mo,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Xh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Mo.copy(e.center).add(Xh)),this.expandByPoint(Mo.copy(e.center).sub(Xh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},ex=0,_i=new an,qh=new ci,zr=new se,ri=new Ls,bo=new Ls,An=new se,Wi=class i extends Gi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:ex++}),this.uuid=ea(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(O_(e)?Uo:No)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new dt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return _i.makeRotationFromQuaternion(e),this.applyMatrix4(_i),this}rotateX(e){return _i.makeRotationX(e),this.applyMatrix4(_i),this}rotateY(e){return _i.makeRotationY(e),this.applyMatrix4(_i),this}rotateZ(e){return _i.makeRotationZ(e),this.applyMatrix4(_i),this}translate(e,t,n){return _i.makeTranslation(e,t,n),this.applyMatrix4(_i),this}scale(e,t,n){return _i.makeScale(e,t,n),this.applyMatrix4(_i),this}lookAt(e){return qh.lookAt(e),qh.updateMatrix(),this.applyMatrix4(qh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(zr).negate(),this.translate(zr.x,zr.y,zr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new $n(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&st("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ls);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ht("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new se(-1/0,-1/0,-1/0),new se(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(An.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(An),An.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(An)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ht('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new tr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ht("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new se,1/0);return}if(e){let n=this.boundingSphere.center;if(ri.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];bo.setFromBufferAttribute(a),this.morphTargetsRelative?(An.addVectors(ri.min,bo.min),ri.expandByPoint(An),An.addVectors(ri.max,bo.max),ri.expandByPoint(An)):(ri.expandByPoint(bo.min),ri.expandByPoint(bo.max))}ri.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)An.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(An));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)An.fromBufferAttribute(a,c),l&&(zr.fromBufferAttribute(e,c),An.add(zr)),s=Math.max(s,n.distanceToSquared(An))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ht('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ht("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Yn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let z=0;z<n.count;z++)a[z]=new se,l[z]=new se;let h=new se,d=new se,u=new se,f=new Tt,g=new Tt,y=new Tt,m=new se,p=new se;function v(z,F,D){c[z]=c[F]=c[D]=1,h.fromBufferAttribute(n,z),d.fromBufferAttribute(n,F),u.fromBufferAttribute(n,D),f.fromBufferAttribute(r,z),g.fromBufferAttribute(r,F),y.fromBufferAttribute(r,D),d.sub(h),u.sub(h),g.sub(f),y.sub(f);let q=1/(g.x*y.y-y.x*g.y);isFinite(q)&&(m.copy(d).multiplyScalar(y.y).addScaledVector(u,-g.y).multiplyScalar(q),p.copy(u).multiplyScalar(g.x).addScaledVector(d,-y.x).multiplyScalar(q),a[z].add(m),a[F].add(m),a[D].add(m),l[z].add(p),l[F].add(p),l[D].add(p))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let z=0,F=A.length;z<F;++z){let D=A[z],q=D.start,$=D.count;for(let I=q,V=q+$;I<V;I+=3)v(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let b=new se,P=new se,C=new se,x=new se;function T(z){C.fromBufferAttribute(s,z),x.copy(C);let F=a[z];b.copy(F),b.sub(C.multiplyScalar(C.dot(F))).normalize(),P.crossVectors(x,F);let q=P.dot(l[z])<0?-1:1;o.setXYZW(z,b.x,b.y,b.z,q)}for(let z=0,F=n.count;z<F;++z)c[z]&&T(z);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Yn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let u=0,f=n.count;u<f;u++)n.setXYZ(u,0,0,0);let s=new se,r=new se,o=new se,a=new se,l=new se,c=new se,h=new se,d=new se;if(e)for(let u=0,f=e.count;u<f;u+=3){let g=e.getX(u+0),y=e.getX(u+1),m=e.getX(u+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,m),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,f=t.count;u<f;u+=3)s.fromBufferAttribute(t,u+0),r.fromBufferAttribute(t,u+1),o.fromBufferAttribute(t,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)An.fromBufferAttribute(e,t),An.normalize(),e.setXYZ(t,An.x,An.y,An.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),f=0,g=0;for(let y=0,m=l.length;y<m;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*h;for(let p=0;p<h;p++)u[g++]=c[f++]}return new Yn(u,h,d)}if(this.index===null)return st("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],f=e(u,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let f=c[d];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Yh=new se,tx=new se,nx=new dt,Ci=class{constructor(e=new se(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Yh.subVectors(n,t).cross(tx.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Yh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||nx.getNormalMatrix(e),s=this.coplanarPoint(Yh).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},ix=0,Ds=class extends Gi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:ix++}),this.uuid=ea(),this.name="",this.type="Material",this.blending=Qr,this.side=Os,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=au,this.blendDst=lu,this.blendEquation=sr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new At(0,0,0),this.blendAlpha=0,this.depthFunc=Xr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Qp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ja,this.stencilZFail=ja,this.stencilZPass=ja,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){st(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){st(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new At().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Ci().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Tt().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Tt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var rs=new se,$h=new se,Fa=new se,Oa=new se,Fo=class{constructor(e=new se,t=new se(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,rs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=rs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(rs.copy(this.origin).addScaledVector(this.direction,t),rs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){$h.copy(e).add(t).multiplyScalar(.5),Fa.copy(t).sub(e).normalize(),Oa.copy(this.origin).sub($h);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Fa),a=Oa.dot(this.direction),l=-Oa.dot(Fa),c=Oa.lengthSq(),h=Math.abs(1-o*o),d,u,f,g;if(h>0)if(d=o*l-a,u=o*a-l,g=r*h,d>=0)if(u>=-g)if(u<=g){let y=1/h;d*=y,u*=y,f=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u<=-g?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c):u<=g?(d=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy($h).addScaledVector(Fa,u),f}intersectSphere(e,t){if(e.radius<0)return null;rs.subVectors(e.center,this.origin);let n=rs.dot(this.direction),s=rs.dot(rs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(e.min.x-u.x)*c,s=(e.max.x-u.x)*c):(n=(e.max.x-u.x)*c,s=(e.min.x-u.x)*c),h>=0?(r=(e.min.y-u.y)*h,o=(e.max.y-u.y)*h):(r=(e.max.y-u.y)*h,o=(e.min.y-u.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-u.z)*d,l=(e.max.z-u.z)*d):(a=(e.max.z-u.z)*d,l=(e.min.z-u.z)*d),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,rs)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=e.x-o.x,u=e.y-o.y,f=e.z-o.z,g=t.x-o.x,y=t.y-o.y,m=t.z-o.z,p=n.x-o.x,v=n.y-o.y,A=n.z-o.z,b=Math.abs(l),P=Math.abs(c),C=Math.abs(h),x,T,z,F,D,q,$,I,V,te,k,pe;if(b>=P&&b>=C?(z=l,q=d,V=g,pe=p,l>=0?(x=c,T=h,F=u,D=f,$=y,I=m,te=v,k=A):(x=h,T=c,F=f,D=u,$=m,I=y,te=A,k=v)):P>=C?(z=c,q=u,V=y,pe=v,c>=0?(x=h,T=l,F=f,D=d,$=m,I=g,te=A,k=p):(x=l,T=h,F=d,D=f,$=g,I=m,te=p,k=A)):(z=h,q=f,V=m,pe=A,h>=0?(x=l,T=c,F=d,D=u,$=g,I=y,te=p,k=v):(x=c,T=l,F=u,D=d,$=y,I=g,te=v,k=p)),z===0)return null;let Q=x/z,re=T/z,ce=1/z,de=F-Q*q,me=D-re*q,oe=$-Q*V,be=I-re*V,Ee=te-Q*pe,Ce=k-re*pe,Te=Ee*be-Ce*oe,We=de*Ce-me*Ee,nt=oe*me-be*de;if(s){if(Te<0||We<0||nt<0)return null}else if((Te<0||We<0||nt<0)&&(Te>0||We>0||nt>0))return null;let qe=Te+We+nt;if(qe===0)return null;let ct=ce*(Te*q+We*V+nt*pe);return(qe>0?ct<0:ct>0)?null:this.at(ct/qe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},fl=class extends Ds{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new At(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Is,this.combine=cu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},pp=new an,js=new Fo,Ba=new tr,mp=new se,ka=new se,za=new se,Va=new se,Zh=new se,Ga=new se,gp=new se,Ha=new se,Xi=class extends ci{constructor(e=new Wi,t=new fl){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Ga.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&(Zh.fromBufferAttribute(d,e),o?Ga.addScaledVector(Zh,h):Ga.addScaledVector(Zh.sub(t),h))}t.add(Ga)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ba.copy(n.boundingSphere),Ba.applyMatrix4(r),js.copy(e.ray).recast(e.near),!(Ba.containsPoint(js.origin)===!1&&(js.intersectSphere(Ba,mp)===null||js.origin.distanceToSquared(mp)>(e.far-e.near)**2))&&(pp.copy(r).invert(),js.copy(e.ray).applyMatrix4(pp),!(n.boundingBox!==null&&js.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,js)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=u.length;g<y;g++){let m=u[g],p=o[m.materialIndex],v=Math.max(m.start,f.start),A=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,P=A;b<P;b+=3){let C=a.getX(b),x=a.getX(b+1),T=a.getX(b+2);s=Wa(this,p,e,n,c,h,d,C,x,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let m=g,p=y;m<p;m+=3){let v=a.getX(m),A=a.getX(m+1),b=a.getX(m+2);s=Wa(this,o,e,n,c,h,d,v,A,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=u.length;g<y;g++){let m=u[g],p=o[m.materialIndex],v=Math.max(m.start,f.start),A=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,P=A;b<P;b+=3){let C=b,x=b+1,T=b+2;s=Wa(this,p,e,n,c,h,d,C,x,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let m=g,p=y;m<p;m+=3){let v=m,A=m+1,b=m+2;s=Wa(this,o,e,n,c,h,d,v,A,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function sx(i,e,t,n,s,r,o,a){let l;if(e.side===Hn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===Os,a),l===null)return null;Ha.copy(a),Ha.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Ha);return c<t.near||c>t.far?null:{distance:c,point:Ha.clone(),object:i}}function Wa(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,ka),i.getVertexPosition(l,za),i.getVertexPosition(c,Va);let h=sx(i,e,t,n,ka,za,Va,gp);if(h){let d=new se;Ps.getBarycoord(gp,ka,za,Va,d),s&&(h.uv=Ps.getInterpolatedAttribute(s,a,l,c,d,new Tt)),r&&(h.uv1=Ps.getInterpolatedAttribute(r,a,l,c,d,new Tt)),o&&(h.normal=Ps.getInterpolatedAttribute(o,a,l,c,d,new se),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new se,materialIndex:0};Ps.getNormal(ka,za,Va,u.normal),h.face=u,h.barycoord=d}return h}var pl=class extends Zn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Cn,h=Cn,d,u){super(null,o,a,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Qs=new tr,rx=new Tt(.5,.5),Xa=new se,nr=class{constructor(e=new Ci,t=new Ci,n=new Ci,s=new Ci,r=new Ci,o=new Ci){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=xi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],f=r[7],g=r[8],y=r[9],m=r[10],p=r[11],v=r[12],A=r[13],b=r[14],P=r[15];if(s[0].setComponents(c-o,f-h,p-g,P-v).normalize(),s[1].setComponents(c+o,f+h,p+g,P+v).normalize(),s[2].setComponents(c+a,f+d,p+y,P+A).normalize(),s[3].setComponents(c-a,f-d,p-y,P-A).normalize(),n)s[4].setComponents(l,u,m,b).normalize(),s[5].setComponents(c-l,f-u,p-m,P-b).normalize();else if(s[4].setComponents(c-l,f-u,p-m,P-b).normalize(),t===xi)s[5].setComponents(c+l,f+u,p+m,P+b).normalize();else if(t===Ro)s[5].setComponents(l,u,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Qs.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Qs.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Qs)}intersectsSprite(e){Qs.center.set(0,0,0);let t=rx.distanceTo(e.center);return Qs.radius=.7071067811865476+t,Qs.applyMatrix4(e.matrixWorld),this.intersectsSphere(Qs)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Xa.x=s.normal.x>0?e.max.x:e.min.x,Xa.y=s.normal.y>0?e.max.y:e.min.y,Xa.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Xa)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},_p=new an,ml=class i{constructor(){this.coordinateSystem=xi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];_p.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new nr),n[s].setFromProjectionMatrix(_p,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new nr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var gl=class extends Ds{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new At(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},_l=new se,xl=new se,xp=new an,wo=new Fo,qa=new tr,Jh=new se,vp=new se,vl=class extends ci{constructor(e=new Wi,t=new gl){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)_l.fromBufferAttribute(t,s-1),xl.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=_l.distanceTo(xl);e.setAttribute("lineDistance",new $n(n,1))}else st("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),qa.copy(n.boundingSphere),qa.applyMatrix4(s),qa.radius+=r,e.ray.intersectsSphere(qa)===!1)return;xp.copy(s).invert(),wo.copy(e.ray).applyMatrix4(xp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=f,m=g-1;y<m;y+=c){let p=h.getX(y),v=h.getX(y+1),A=Ya(this,e,wo,l,p,v,y);A&&t.push(A)}if(this.isLineLoop){let y=h.getX(g-1),m=h.getX(f),p=Ya(this,e,wo,l,y,m,g-1);p&&t.push(p)}}else{let f=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=f,m=g-1;y<m;y+=c){let p=Ya(this,e,wo,l,y,y+1,y);p&&t.push(p)}if(this.isLineLoop){let y=Ya(this,e,wo,l,g-1,f,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ya(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(_l.fromBufferAttribute(a,s),xl.fromBufferAttribute(a,r),t.distanceSqToSegment(_l,xl,Jh,vp)>n)return;Jh.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Jh);if(!(c<e.near||c>e.far))return{distance:c,point:vp.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var yp=new se,Sp=new se,Oo=class extends vl{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)yp.fromBufferAttribute(t,s),Sp.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+yp.distanceTo(Sp);e.setAttribute("lineDistance",new $n(n,1))}else st("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Bo=class extends Zn{constructor(e=[],t=rr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var ls=class extends Zn{constructor(e,t,n=Ri,s,r,o,a=Cn,l=Cn,c,h=as,d=1){if(h!==as&&h!==hs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:d};super(u,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Yr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ko=class extends ls{constructor(e,t=Ri,n=rr,s,r,o=Cn,a=Cn,l,c=as){let h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},zo=class extends Zn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Zr=class i extends Wi{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new $n(c,3)),this.setAttribute("normal",new $n(h,3)),this.setAttribute("uv",new $n(d,2));function g(y,m,p,v,A,b,P,C,x,T,z){let F=b/x,D=P/T,q=b/2,$=P/2,I=C/2,V=x+1,te=T+1,k=0,pe=0,Q=new se;for(let re=0;re<te;re++){let ce=re*D-$;for(let de=0;de<V;de++){let me=de*F-q;Q[y]=me*v,Q[m]=ce*A,Q[p]=I,c.push(Q.x,Q.y,Q.z),Q[y]=0,Q[m]=0,Q[p]=C>0?1:-1,h.push(Q.x,Q.y,Q.z),d.push(de/x),d.push(1-re/T),k+=1}}for(let re=0;re<T;re++)for(let ce=0;ce<x;ce++){let de=u+ce+V*re,me=u+ce+V*(re+1),oe=u+(ce+1)+V*(re+1),be=u+(ce+1)+V*re;l.push(de,me,be),l.push(me,oe,be),pe+=6}a.addGroup(f,pe,z),f+=pe,u+=k}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Vo=class i extends Wi{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,d=e/a,u=t/l,f=[],g=[],y=[],m=[];for(let p=0;p<h;p++){let v=p*u-o;for(let A=0;A<c;A++){let b=A*d-r;g.push(b,-v,0),y.push(0,0,1),m.push(A/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let v=0;v<a;v++){let A=v+c*p,b=v+c*(p+1),P=v+1+c*(p+1),C=v+1+c*p;f.push(A,b,C),f.push(b,P,C)}this.setIndex(f),this.setAttribute("position",new $n(g,3)),this.setAttribute("normal",new $n(y,3)),this.setAttribute("uv",new $n(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};function ar(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Mp(s))s.isRenderTargetTexture?(st("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Mp(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Nn(i){let e={};for(let t=0;t<i.length;t++){let n=ar(i[t]);for(let s in n)e[s]=n[s]}return e}function Mp(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function ox(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Iu(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var dm={clone:ar,merge:Nn},ax=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,lx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,vi=class extends Ds{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=ax,this.fragmentShader=lx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=ar(e.uniforms),this.uniformsGroups=ox(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new At().setHex(s.value);break;case"v2":this.uniforms[n].value=new Tt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new se().fromArray(s.value);break;case"v4":this.uniforms[n].value=new sn().fromArray(s.value);break;case"m3":this.uniforms[n].value=new dt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new an().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},yl=class extends vi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Sl=class extends Ds{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Kp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Ml=class extends Ds{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Vr(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function $a(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Ns=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},bl=class extends Ns{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:jh,endingEnd:jh}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Qh:r=e,a=2*t-n;break;case eu:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Qh:o=e,l=2*n-t;break;case eu:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),y=g*g,m=y*g,p=-u*m+2*u*y-u*g,v=(1+u)*m+(-1.5-2*u)*y+(-.5+u)*g+1,A=(-1-f)*m+(1.5+f)*y+.5*g,b=f*m-f*y;for(let P=0;P!==a;++P)r[P]=p*o[h+P]+v*o[c+P]+A*o[l+P]+b*o[d+P];return r}},wl=class extends Ns{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),d=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*h;return r}},El=class extends Ns{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Tl=class extends Ns{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let g=(n-t)/(s-t),y=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*y+o[l+m]*g;return r}let u=a*2,f=e-1;for(let g=0;g!==a;++g){let y=o[c+g],m=o[l+g],p=f*u+g*2,v=d[p],A=d[p+1],b=e*u+g*2,P=h[b],C=h[b+1],x=hx(n,t,v,P,s);r[g]=fm(x,y,A,C,m)}return r}};function fm(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function cx(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function hx(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=fm(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=cx(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var hi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Vr(t,this.TimeBufferType),this.values=Vr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Vr(e.times,Array),values:Vr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),$a(e.settings)&&(n.settings={inTangents:Vr(e.settings.inTangents,Array),outTangents:Vr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new El(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new wl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new bl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Tl(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case To:t=this.InterpolantFactoryMethodDiscrete;break;case ll:t=this.InterpolantFactoryMethodLinear;break;case Ka:t=this.InterpolantFactoryMethodSmooth;break;case Kh:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return st("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return To;case this.InterpolantFactoryMethodLinear:return ll;case this.InterpolantFactoryMethodSmooth:return Ka;case this.InterpolantFactoryMethodBezier:return Kh}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;$a(this.settings)&&(bp(this.settings.inTangents,e),bp(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;$a(this.settings)&&(wp(this.settings.inTangents,e),wp(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(ht("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ht("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){ht("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){ht("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&B_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ht("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Ka,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let d=a*n,u=d-n,f=d+n;for(let g=0;g!==n;++g){let y=t[d+g];if(y!==t[u+g]||y!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*n,u=o*n;for(let f=0;f!==n;++f)t[u+f]=t[d+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,$a(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function bp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function wp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}hi.prototype.ValueTypeName="";hi.prototype.TimeBufferType=Float32Array;hi.prototype.ValueBufferType=Float32Array;hi.prototype.DefaultInterpolation=ll;var Us=class extends hi{constructor(e,t,n){super(e,t,n)}};Us.prototype.ValueTypeName="bool";Us.prototype.ValueBufferType=Array;Us.prototype.DefaultInterpolation=To;Us.prototype.InterpolantFactoryMethodLinear=void 0;Us.prototype.InterpolantFactoryMethodSmooth=void 0;var Al=class extends hi{constructor(e,t,n,s){super(e,t,n,s)}};Al.prototype.ValueTypeName="color";var Cl=class extends hi{constructor(e,t,n,s){super(e,t,n,s)}};Cl.prototype.ValueTypeName="number";var Rl=class extends Ns{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Hi.slerpFlat(r,0,o,c-a,o,c,l);return r}},Go=class extends hi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Rl(this.times,this.values,this.getValueSize(),e)}};Go.prototype.ValueTypeName="quaternion";Go.prototype.InterpolantFactoryMethodSmooth=void 0;var Fs=class extends hi{constructor(e,t,n){super(e,t,n)}};Fs.prototype.ValueTypeName="string";Fs.prototype.ValueBufferType=Array;Fs.prototype.DefaultInterpolation=To;Fs.prototype.InterpolantFactoryMethodLinear=void 0;Fs.prototype.InterpolantFactoryMethodSmooth=void 0;var Pl=class extends hi{constructor(e,t,n,s){super(e,t,n,s)}};Pl.prototype.ValueTypeName="vector";var Il=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let f=c[d],g=c[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},pm=new Il,Ll=class{constructor(e){this.manager=e!==void 0?e:pm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Ll.DEFAULT_MATERIAL_NAME="__DEFAULT";var Za=new se,Ja=new Hi,zi=new se,Ho=class extends ci{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new an,this.projectionMatrix=new an,this.projectionMatrixInverse=new an,this.coordinateSystem=xi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Za,Ja,zi),zi.x===1&&zi.y===1&&zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Za,Ja,zi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Za,Ja,zi),zi.x===1&&zi.y===1&&zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Za,Ja,zi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Rs=new se,Ep=new Tt,Tp=new Tt,ai=class extends Ho{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=cl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Rh*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return cl*2*Math.atan(Math.tan(Rh*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Rs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Rs.x,Rs.y).multiplyScalar(-e/Rs.z),Rs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Rs.x,Rs.y).multiplyScalar(-e/Rs.z)}getViewSize(e,t){return this.getViewBounds(e,Ep,Tp),t.subVectors(Tp,Ep)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Rh*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Jr=class extends Ho{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Wo=class extends Wi{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Gr=-90,Hr=1,Kr=class extends ci{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ai(Gr,Hr,e,t);s.layers=this.layers,this.add(s);let r=new ai(Gr,Hr,e,t);r.layers=this.layers,this.add(r);let o=new ai(Gr,Hr,e,t);o.layers=this.layers,this.add(o);let a=new ai(Gr,Hr,e,t);a.layers=this.layers,this.add(a);let l=new ai(Gr,Hr,e,t);l.layers=this.layers,this.add(l);let c=new ai(Gr,Hr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===xi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ro)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=e.getRenderTarget(),u=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,u,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Dl=class extends ai{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Lu="\\[\\]\\.:\\/",ux=new RegExp("["+Lu+"]","g"),Du="[^"+Lu+"]",dx="[^"+Lu.replace("\\.","")+"]",fx=/((?:WC+[\/:])*)/.source.replace("WC",Du),px=/(WCOD+)?/.source.replace("WCOD",dx),mx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Du),gx=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Du),_x=new RegExp("^"+fx+px+mx+gx+"$"),xx=["material","materials","bones","map"],tu=class{constructor(e,t,n){let s=n||nn.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},nn=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(ux,"")}static parseTrackName(e){let t=_x.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);xx.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){st("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){ht("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){ht("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){ht("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){ht("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){ht("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){ht("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){ht("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;ht("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){ht("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){ht("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};nn.Composite=tu;nn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};nn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};nn.prototype.GetterByBindingType=[nn.prototype._getValue_direct,nn.prototype._getValue_array,nn.prototype._getValue_arrayElement,nn.prototype._getValue_toArray];nn.prototype.SetterByBindingTypeAndVersioning=[[nn.prototype._setValue_direct,nn.prototype._setValue_direct_setNeedsUpdate,nn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_array,nn.prototype._setValue_array_setNeedsUpdate,nn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_arrayElement,nn.prototype._setValue_arrayElement_setNeedsUpdate,nn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_fromArray,nn.prototype._setValue_fromArray_setNeedsUpdate,nn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Vb=new Float32Array(1);var nu=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};function Nu(i,e,t,n){let s=vx(n);switch(t){case Mu:return i*e;case wu:return i*e/s.components*s.byteLength;case zl:return i*e/s.components*s.byteLength;case Bs:return i*e*2/s.components*s.byteLength;case Vl:return i*e*2/s.components*s.byteLength;case bu:return i*e*3/s.components*s.byteLength;case Li:return i*e*4/s.components*s.byteLength;case Gl:return i*e*4/s.components*s.byteLength;case Yo:case $o:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Zo:case Jo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Wl:case ql:return Math.max(i,16)*Math.max(e,8)/4;case Hl:case Xl:return Math.max(i,8)*Math.max(e,8)/2;case Yl:case $l:case Jl:case Kl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Zl:case Ko:case jl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ql:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ec:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case tc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case nc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ic:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case sc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case rc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case oc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case ac:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case lc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case cc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case hc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case uc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case dc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case fc:case pc:case mc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case gc:case _c:return Math.ceil(i/4)*Math.ceil(e/4)*8;case jo:case xc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function vx(i){switch(i){case ui:case xu:return{byteLength:1,components:1};case to:case vu:case Ii:return{byteLength:2,components:1};case Bl:case kl:return{byteLength:2,components:4};case Ri:case Ol:case Pi:return{byteLength:4,components:1};case yu:case Su:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?st("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Fm(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Sx(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,l,c){let h=l.array,d=l.updateRanges;if(i.bindBuffer(c,a),d.length===0)i.bufferSubData(c,0,h);else{d.sort((f,g)=>f.start-g.start);let u=0;for(let f=1;f<d.length;f++){let g=d[u],y=d[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++u,d[u]=y)}d.length=u+1;for(let f=0,g=d.length;f<g;f++){let y=d[f];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Mx=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,bx=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,wx=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Ex=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Tx=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Ax=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Cx=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Rx=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Px=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Ix=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Lx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Dx=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Nx=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Ux=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Fx=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Ox=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Bx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,kx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,zx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Vx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Gx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Hx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Wx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Xx=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,qx=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Yx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,$x=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Zx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Jx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Kx="gl_FragColor = linearToOutputTexel( gl_FragColor );",jx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Qx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,ev=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,tv=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,nv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,iv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,sv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,rv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ov=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,av=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,lv=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,cv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,hv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,uv=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,dv=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,fv=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,pv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,mv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,gv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,_v=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,xv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,vv=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,yv=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Sv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Mv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,bv=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,wv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Ev=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Tv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Av=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Cv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Rv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Pv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Iv=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Lv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Dv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Nv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Uv=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Fv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Ov=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Bv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,kv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,zv=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Vv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Gv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Hv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Wv=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Xv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,qv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Yv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,$v=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Zv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Jv=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Kv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,jv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Qv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,ey=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,ty=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,ny=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,iy=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,sy=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,ry=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,oy=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,ay=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,ly=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,cy=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,hy=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,uy=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,dy=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,fy=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,py=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,my=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,gy=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,_y=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,xy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,vy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,yy=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Sy=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,My=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,by=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,wy=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ey=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Ty=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ay=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Cy=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Ry=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Py=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Iy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ly=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Dy=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Ny=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Uy=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Fy=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Oy=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,By=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ky=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,zy=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Vy=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Gy=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Hy=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Wy=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Xy=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,qy=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Yy=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,$y=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Zy=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Jy=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ky=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,jy=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Qy=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,eS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,gt={alphahash_fragment:Mx,alphahash_pars_fragment:bx,alphamap_fragment:wx,alphamap_pars_fragment:Ex,alphatest_fragment:Tx,alphatest_pars_fragment:Ax,aomap_fragment:Cx,aomap_pars_fragment:Rx,batching_pars_vertex:Px,batching_vertex:Ix,begin_vertex:Lx,beginnormal_vertex:Dx,bsdfs:Nx,iridescence_fragment:Ux,bumpmap_pars_fragment:Fx,clipping_planes_fragment:Ox,clipping_planes_pars_fragment:Bx,clipping_planes_pars_vertex:kx,clipping_planes_vertex:zx,color_fragment:Vx,color_pars_fragment:Gx,color_pars_vertex:Hx,color_vertex:Wx,common:Xx,defaultnormal_vertex:qx,displacementmap_pars_vertex:Yx,displacementmap_vertex:$x,emissivemap_fragment:Zx,emissivemap_pars_fragment:Jx,colorspace_fragment:Kx,colorspace_pars_fragment:jx,envmap_fragment:Qx,envmap_common_pars_fragment:ev,envmap_pars_fragment:tv,envmap_pars_vertex:nv,envmap_physical_pars_fragment:fv,envmap_vertex:iv,fog_vertex:sv,fog_pars_vertex:rv,fog_fragment:ov,fog_pars_fragment:av,gradientmap_pars_fragment:lv,lightmap_pars_fragment:cv,lights_lambert_fragment:hv,lights_lambert_pars_fragment:uv,lights_pars_begin:dv,lights_toon_fragment:pv,lights_toon_pars_fragment:mv,lights_phong_fragment:gv,lights_phong_pars_fragment:_v,lights_physical_fragment:xv,lights_physical_pars_fragment:vv,lights_fragment_begin:yv,lights_fragment_maps:Sv,lights_fragment_end:Mv,lightprobes_pars_fragment:bv,logdepthbuf_fragment:wv,logdepthbuf_pars_fragment:Ev,logdepthbuf_pars_vertex:Tv,logdepthbuf_vertex:Av,map_fragment:Cv,map_pars_fragment:Rv,map_particle_fragment:Pv,map_particle_pars_fragment:Iv,metalnessmap_fragment:Lv,metalnessmap_pars_fragment:Dv,morphinstance_vertex:Nv,morphcolor_vertex:Uv,morphnormal_vertex:Fv,morphtarget_pars_vertex:Ov,morphtarget_vertex:Bv,normal_fragment_begin:kv,normal_fragment_maps:zv,normal_pars_fragment:Vv,normal_pars_vertex:Gv,normal_vertex:Hv,normalmap_pars_fragment:Wv,clearcoat_normal_fragment_begin:Xv,clearcoat_normal_fragment_maps:qv,clearcoat_pars_fragment:Yv,iridescence_pars_fragment:$v,opaque_fragment:Zv,packing:Jv,premultiplied_alpha_fragment:Kv,project_vertex:jv,dithering_fragment:Qv,dithering_pars_fragment:ey,roughnessmap_fragment:ty,roughnessmap_pars_fragment:ny,shadowmap_pars_fragment:iy,shadowmap_pars_vertex:sy,shadowmap_vertex:ry,shadowmask_pars_fragment:oy,skinbase_vertex:ay,skinning_pars_vertex:ly,skinning_vertex:cy,skinnormal_vertex:hy,specularmap_fragment:uy,specularmap_pars_fragment:dy,tonemapping_fragment:fy,tonemapping_pars_fragment:py,transmission_fragment:my,transmission_pars_fragment:gy,uv_pars_fragment:_y,uv_pars_vertex:xy,uv_vertex:vy,worldpos_vertex:yy,background_vert:Sy,background_frag:My,backgroundCube_vert:by,backgroundCube_frag:wy,cube_vert:Ey,cube_frag:Ty,depth_vert:Ay,depth_frag:Cy,distance_vert:Ry,distance_frag:Py,equirect_vert:Iy,equirect_frag:Ly,linedashed_vert:Dy,linedashed_frag:Ny,meshbasic_vert:Uy,meshbasic_frag:Fy,meshlambert_vert:Oy,meshlambert_frag:By,meshmatcap_vert:ky,meshmatcap_frag:zy,meshnormal_vert:Vy,meshnormal_frag:Gy,meshphong_vert:Hy,meshphong_frag:Wy,meshphysical_vert:Xy,meshphysical_frag:qy,meshtoon_vert:Yy,meshtoon_frag:$y,points_vert:Zy,points_frag:Jy,shadow_vert:Ky,shadow_frag:jy,sprite_vert:Qy,sprite_frag:eS},Ue={common:{diffuse:{value:new At(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new dt},alphaMap:{value:null},alphaMapTransform:{value:new dt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new dt}},envmap:{envMap:{value:null},envMapRotation:{value:new dt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new dt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new dt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new dt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new dt},normalScale:{value:new Tt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new dt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new dt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new dt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new dt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new At(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new At(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new dt},alphaTest:{value:0},uvTransform:{value:new dt}},sprite:{diffuse:{value:new At(16777215)},opacity:{value:1},center:{value:new Tt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new dt},alphaMap:{value:null},alphaMapTransform:{value:new dt},alphaTest:{value:0}}},Zi={basic:{uniforms:Nn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.fog]),vertexShader:gt.meshbasic_vert,fragmentShader:gt.meshbasic_frag},lambert:{uniforms:Nn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new At(0)},envMapIntensity:{value:1}}]),vertexShader:gt.meshlambert_vert,fragmentShader:gt.meshlambert_frag},phong:{uniforms:Nn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new At(0)},specular:{value:new At(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:gt.meshphong_vert,fragmentShader:gt.meshphong_frag},standard:{uniforms:Nn([Ue.common,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.roughnessmap,Ue.metalnessmap,Ue.fog,Ue.lights,{emissive:{value:new At(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag},toon:{uniforms:Nn([Ue.common,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.gradientmap,Ue.fog,Ue.lights,{emissive:{value:new At(0)}}]),vertexShader:gt.meshtoon_vert,fragmentShader:gt.meshtoon_frag},matcap:{uniforms:Nn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,{matcap:{value:null}}]),vertexShader:gt.meshmatcap_vert,fragmentShader:gt.meshmatcap_frag},points:{uniforms:Nn([Ue.points,Ue.fog]),vertexShader:gt.points_vert,fragmentShader:gt.points_frag},dashed:{uniforms:Nn([Ue.common,Ue.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:gt.linedashed_vert,fragmentShader:gt.linedashed_frag},depth:{uniforms:Nn([Ue.common,Ue.displacementmap]),vertexShader:gt.depth_vert,fragmentShader:gt.depth_frag},normal:{uniforms:Nn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,{opacity:{value:1}}]),vertexShader:gt.meshnormal_vert,fragmentShader:gt.meshnormal_frag},sprite:{uniforms:Nn([Ue.sprite,Ue.fog]),vertexShader:gt.sprite_vert,fragmentShader:gt.sprite_frag},background:{uniforms:{uvTransform:{value:new dt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:gt.background_vert,fragmentShader:gt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new dt}},vertexShader:gt.backgroundCube_vert,fragmentShader:gt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:gt.cube_vert,fragmentShader:gt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:gt.equirect_vert,fragmentShader:gt.equirect_frag},distance:{uniforms:Nn([Ue.common,Ue.displacementmap,{referencePosition:{value:new se},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:gt.distance_vert,fragmentShader:gt.distance_frag},shadow:{uniforms:Nn([Ue.lights,Ue.fog,{color:{value:new At(0)},opacity:{value:1}}]),vertexShader:gt.shadow_vert,fragmentShader:gt.shadow_frag}};Zi.physical={uniforms:Nn([Zi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new dt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new dt},clearcoatNormalScale:{value:new Tt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new dt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new dt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new dt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new dt},sheen:{value:0},sheenColor:{value:new At(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new dt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new dt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new dt},transmissionSamplerSize:{value:new Tt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new dt},attenuationDistance:{value:0},attenuationColor:{value:new At(0)},specularColor:{value:new At(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new dt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new dt},anisotropyVector:{value:new Tt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new dt}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag};var vc={r:0,b:0,g:0},tS=new an,Om=new dt;Om.set(-1,0,0,0,1,0,0,0,1);function nS(i,e,t,n,s,r){let o=new At(0),a=s===!0?0:1,l,c,h=null,d=0,u=null;function f(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let b=v.backgroundBlurriness>0;A=e.get(A,b)}return A}function g(v){let A=!1,b=f(v);b===null?m(o,a):b&&b.isColor&&(m(b,1),A=!0);let P=i.xr.getEnvironmentBlendMode();P==="additive"?t.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,A){let b=f(A);b&&b.isCubeTexture?(c===void 0&&(c=new Xi(new Zr(1,1,1),new vi({name:"BackgroundCubeMaterial",uniforms:ar(Zi.backgroundCube.uniforms),vertexShader:Zi.backgroundCube.vertexShader,fragmentShader:Zi.backgroundCube.fragmentShader,side:Hn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,C,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(tS.makeRotationFromEuler(A.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Om),c.material.toneMapped=St.getTransfer(b.colorSpace)!==Bt,(h!==b||d!==b.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,d=b.version,u=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Xi(new Vo(2,2),new vi({name:"BackgroundMaterial",uniforms:ar(Zi.background.uniforms),vertexShader:Zi.background.vertexShader,fragmentShader:Zi.background.fragmentShader,side:Os,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=St.getTransfer(b.colorSpace)!==Bt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||d!==b.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,d=b.version,u=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,A){v.getRGB(vc,Iu(i)),t.buffers.color.setClear(vc.r,vc.g,vc.b,A,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:g,addToRenderList:y,dispose:p}}function iS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,o=!1;function a(D,q,$,I,V){let te=!1,k=d(D,I,$,q);r!==k&&(r=k,c(r.object)),te=f(D,I,$,V),te&&g(D,I,$,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(te||o)&&(o=!1,b(D,q,$,I),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function d(D,q,$,I){let V=I.wireframe===!0,te=n[q.id];te===void 0&&(te={},n[q.id]=te);let k=D.isInstancedMesh===!0?D.id:0,pe=te[k];pe===void 0&&(pe={},te[k]=pe);let Q=pe[$.id];Q===void 0&&(Q={},pe[$.id]=Q);let re=Q[V];return re===void 0&&(re=u(l()),Q[V]=re),re}function u(D){let q=[],$=[],I=[];for(let V=0;V<t;V++)q[V]=0,$[V]=0,I[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:q,enabledAttributes:$,attributeDivisors:I,object:D,attributes:{},index:null}}function f(D,q,$,I){let V=r.attributes,te=q.attributes,k=0,pe=$.getAttributes();for(let Q in pe)if(pe[Q].location>=0){let ce=V[Q],de=te[Q];if(de===void 0&&(Q==="instanceMatrix"&&D.instanceMatrix&&(de=D.instanceMatrix),Q==="instanceColor"&&D.instanceColor&&(de=D.instanceColor)),ce===void 0||ce.attribute!==de||de&&ce.data!==de.data)return!0;k++}return r.attributesNum!==k||r.index!==I}function g(D,q,$,I){let V={},te=q.attributes,k=0,pe=$.getAttributes();for(let Q in pe)if(pe[Q].location>=0){let ce=te[Q];ce===void 0&&(Q==="instanceMatrix"&&D.instanceMatrix&&(ce=D.instanceMatrix),Q==="instanceColor"&&D.instanceColor&&(ce=D.instanceColor));let de={};de.attribute=ce,ce&&ce.data&&(de.data=ce.data),V[Q]=de,k++}r.attributes=V,r.attributesNum=k,r.index=I}function y(){let D=r.newAttributes;for(let q=0,$=D.length;q<$;q++)D[q]=0}function m(D){p(D,0)}function p(D,q){let $=r.newAttributes,I=r.enabledAttributes,V=r.attributeDivisors;$[D]=1,I[D]===0&&(i.enableVertexAttribArray(D),I[D]=1),V[D]!==q&&(i.vertexAttribDivisor(D,q),V[D]=q)}function v(){let D=r.newAttributes,q=r.enabledAttributes;for(let $=0,I=q.length;$<I;$++)q[$]!==D[$]&&(i.disableVertexAttribArray($),q[$]=0)}function A(D,q,$,I,V,te,k){k===!0?i.vertexAttribIPointer(D,q,$,V,te):i.vertexAttribPointer(D,q,$,I,V,te)}function b(D,q,$,I){y();let V=I.attributes,te=$.getAttributes(),k=q.defaultAttributeValues;for(let pe in te){let Q=te[pe];if(Q.location>=0){let re=V[pe];if(re===void 0&&(pe==="instanceMatrix"&&D.instanceMatrix&&(re=D.instanceMatrix),pe==="instanceColor"&&D.instanceColor&&(re=D.instanceColor)),re!==void 0){let ce=re.normalized,de=re.itemSize,me=e.get(re);if(me===void 0)continue;let oe=me.buffer,be=me.type,Ee=me.bytesPerElement,Ce=be===i.INT||be===i.UNSIGNED_INT||re.gpuType===Ol;if(re.isInterleavedBufferAttribute){let Te=re.data,We=Te.isInterleavedBuffer===!0?Te.stride:Te.itemSize,nt=re.offset;if(Te.isInstancedInterleavedBuffer||Te.isInstancedBufferAttribute){for(let qe=0;qe<Q.locationSize;qe++)p(Q.location+qe,Te.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Te.meshPerAttribute*Te.count)}else for(let qe=0;qe<Q.locationSize;qe++)m(Q.location+qe);i.bindBuffer(i.ARRAY_BUFFER,oe);for(let qe=0;qe<Q.locationSize;qe++)A(Q.location+qe,de/Q.locationSize,be,ce,We*Ee,(nt+de/Q.locationSize*qe)*Ee,Ce)}else{if(re.isInstancedBufferAttribute){for(let Te=0;Te<Q.locationSize;Te++)p(Q.location+Te,re.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=re.meshPerAttribute*re.count)}else for(let Te=0;Te<Q.locationSize;Te++)m(Q.location+Te);i.bindBuffer(i.ARRAY_BUFFER,oe);for(let Te=0;Te<Q.locationSize;Te++)A(Q.location+Te,de/Q.locationSize,be,ce,de*Ee,de/Q.locationSize*Te*Ee,Ce)}}else if(k!==void 0){let ce=k[pe];if(ce!==void 0)switch(ce.length){case 2:i.vertexAttrib2fv(Q.location,ce);break;case 3:i.vertexAttrib3fv(Q.location,ce);break;case 4:i.vertexAttrib4fv(Q.location,ce);break;default:i.vertexAttrib1fv(Q.location,ce)}}}}v()}function P(){z();for(let D in n){let q=n[D];for(let $ in q){let I=q[$];for(let V in I){let te=I[V];for(let k in te)h(te[k].object),delete te[k];delete I[V]}}delete n[D]}}function C(D){if(n[D.id]===void 0)return;let q=n[D.id];for(let $ in q){let I=q[$];for(let V in I){let te=I[V];for(let k in te)h(te[k].object),delete te[k];delete I[V]}}delete n[D.id]}function x(D){for(let q in n){let $=n[q];for(let I in $){let V=$[I];if(V[D.id]===void 0)continue;let te=V[D.id];for(let k in te)h(te[k].object),delete te[k];delete V[D.id]}}}function T(D){for(let q in n){let $=n[q],I=D.isInstancedMesh===!0?D.id:0,V=$[I];if(V!==void 0){for(let te in V){let k=V[te];for(let pe in k)h(k[pe].object),delete k[pe];delete V[te]}delete $[I],Object.keys($).length===0&&delete n[q]}}}function z(){F(),o=!0,r!==s&&(r=s,c(r.object))}function F(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:z,resetDefaultState:F,dispose:P,releaseStatesOfGeometry:C,releaseStatesOfObject:T,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:m,disableUnusedAttributes:v}}function sS(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let f=0;f<h;f++)u+=c[f];t.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function rS(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Li&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let T=x===Ii&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==ui&&x!==Pi&&!T&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(st("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&st("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&st("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=i.getParameter(i.MAX_SAMPLES),C=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:b,maxSamples:P,samples:C}}function oS(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Ci,a=new dt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||n!==0||s;return s=u,n=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){t=h(d,u,0)},this.setState=function(d,u,f){let g=d.clippingPlanes,y=d.clipIntersection,m=d.clipShadows,p=i.get(d);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let v=r?0:n,A=v*4,b=p.clippingState||null;l.value=b,b=h(g,u,A,f);for(let P=0;P!==A;++P)b[P]=t[P];p.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(d,u,f,g){let y=d!==null?d.length:0,m=null;if(y!==0){if(m=l.value,g!==!0||m===null){let p=f+y*4,v=u.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<p)&&(m=new Float32Array(p));for(let A=0,b=f;A!==y;++A,b+=4)o.copy(d[A]).applyMatrix4(v,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,m}}var ia=class extends li{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Bo(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Zr(5,5,5),r=new vi({name:"CubemapFromEquirect",uniforms:ar(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Hn,blending:ir});r.uniforms.tEquirect.value=t;let o=new Xi(s,r),a=t.minFilter;return t.minFilter===cs&&(t.minFilter=Gn),new Kr(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},mm=256,aS=3,lS=20,Bm=256,km=16,cS=3,hS=new se,uS=new At,Sc=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Kr(1,10,null),this._boxMesh=new Xi(new Zr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=hS}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(uS));let m=new Kr(n,s,h);return m.position.copy(a),m.update(l,e),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=g,e.background=y,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=xm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=_m(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(mm,hm(e))}_fromTexture(e,t){e.mapping===rr||e.mapping===eo?this._setSize(e.image.length===0?mm:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=gm(e,!1,!1),n=Math.log2(e)-aS;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=gm(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===rr||e.mapping===eo?(this._cubemapMaterial===null&&(this._cubemapMaterial=xm()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=_m()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=dS(),this._integrationMaterial=fS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/km);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-cS)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Bm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=pS());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function gm(i,e,t){return new ia(i,{minFilter:cs,generateMipmaps:e,type:Ii,colorSpace:Ao,depthBuffer:t})}function sa(i,e,t){return new vi({name:i,uniforms:e,vertexShader:gt.cube_vert,fragmentShader:t,side:Hn,blending:ir,depthTest:!1,depthWrite:!1})}function dS(){return sa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Bm}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function fS(){return sa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:km}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function pS(){return sa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${lS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function _m(){return sa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function xm(){return sa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function mS(i){let e=new WeakMap,t=new WeakMap,n=null;function s(u,f=!1){return u==null?null:f?o(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===Nl||f===Ul)if(e.has(u)){let g=e.get(u).texture;return a(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let y=new ia(g.height);return y.fromEquirectangularTexture(i,u),e.set(u,y),u.addEventListener("dispose",c),a(y.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,g=f===Nl||f===Ul,y=f===rr||f===eo;if(g||y){let m=t.get(u),p=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==p)return n===null&&(n=new Sc(i)),m=g?n.fromEquirectangular(u,m):n.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),m.texture;if(m!==void 0)return m.texture;{let v=u.image;return g&&v&&v.height>0||y&&v&&l(v)?(n===null&&(n=new Sc(i)),m=g?n.fromEquirectangular(u):n.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function a(u,f){return f===Nl?u.mapping=rr:f===Ul&&(u.mapping=eo),u}function l(u){let f=0,g=6;for(let y=0;y<g;y++)u[y]!==void 0&&f++;return f===g}function c(u){let f=u.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function h(u){let f=u.target;f.removeEventListener("dispose",h);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function gS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Eo("WebGLRenderer: "+n+" extension not supported."),s}}}function _S(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function h(g){let y=g.attributes;for(let m in y)e.update(y[m],i.ARRAY_BUFFER)}function d(g){let y=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let v=y!==null?y.array.length:m.array.length/3-1,A=m.count>=65535?Uo:No,b=new A(Math.ceil(v/3)*6,1),P=b.array;if(y!==null){let x=y.array;p=y.version;for(let T=0,z=0;T<v;T+=3){let F=x[T+0],D=x[T+1],q=x[T+2];P[z++]=F,P[z++]=D,P[z++]=D,P[z++]=q,P[z++]=q,P[z++]=F}}else{p=m.version;for(let x=0,T=0;x<v;x+=3){let z=x+0,F=x+1,D=x+2;P[T++]=z,P[T++]=F,P[T++]=F,P[T++]=D,P[T++]=D,P[T++]=z}}b.version=p;let C=r.get(g);C&&e.remove(C),r.set(g,b)}function u(g){let y=r.get(g);if(y){let m=g.index;m!==null&&y.version<m.version&&d(g)}else d(g);return r.get(g)}function f(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:u,dispose:f}}function xS(i,e,t){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){i.drawElements(n,u,r,d*o),t.update(u,n,1)}function c(d,u,f){f!==0&&(i.drawElementsInstanced(n,u,r,d*o,f),t.update(u,n,f))}function h(d,u,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,f);let y=0;for(let m=0;m<f;m++)y+=u[m];t.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function vS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:ht("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function yS(i,e,t){let n=new WeakMap,s=new sn;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==d){let z=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",z)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;f===!0&&(A=1),g===!0&&(A=2),y===!0&&(A=3);let b=a.attributes.position.count*A,P=1;b>e.maxTextureSize&&(P=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let C=new Float32Array(b*P*4*d),x=new Io(C,b,P,d);x.type=Pi,x.needsUpdate=!0;let T=A*4;for(let F=0;F<d;F++){let D=m[F],q=p[F],$=v[F],I=b*P*4*F;for(let V=0;V<D.count;V++){let te=V*T;f===!0&&(s.fromBufferAttribute(D,V),C[I+te+0]=s.x,C[I+te+1]=s.y,C[I+te+2]=s.z,C[I+te+3]=0),g===!0&&(s.fromBufferAttribute(q,V),C[I+te+4]=s.x,C[I+te+5]=s.y,C[I+te+6]=s.z,C[I+te+7]=0),y===!0&&(s.fromBufferAttribute($,V),C[I+te+8]=s.x,C[I+te+9]=s.y,C[I+te+10]=s.z,C[I+te+11]=$.itemSize===4?s.w:1)}}u={count:d,texture:x,size:new Tt(b,P)},n.set(a,u),a.addEventListener("dispose",z)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function SS(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,d=c.geometry,u=e.get(c,d);if(r.get(u)!==h&&(e.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var MS={[hu]:"LINEAR_TONE_MAPPING",[uu]:"REINHARD_TONE_MAPPING",[du]:"CINEON_TONE_MAPPING",[fu]:"ACES_FILMIC_TONE_MAPPING",[mu]:"AGX_TONE_MAPPING",[gu]:"NEUTRAL_TONE_MAPPING",[pu]:"CUSTOM_TONE_MAPPING"};function bS(i,e,t,n,s,r){let o=new li(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Wi;h.setAttribute("position",new $n([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new $n([0,2,0,0,2,0],2));let d=new yl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new Xi(h,d),f=new Jr(-1,1,1,-1,0,1),g=null,y=null,m=!1,p,v=null,A=[],b=!1;this.setSize=function(P,C){o.setSize(P,C),a!==null&&a.setSize(P,C),l!==null&&l.setSize(P,C);for(let x=0;x<A.length;x++){let T=A[x];T.setSize&&T.setSize(P,C)}},this.setEffects=function(P){A=P,b=A.length>0&&A[0].isRenderPass===!0;let C=o.width,x=o.height;A.length>0&&a===null&&(a=new li(C,x,{type:Ii,depthBuffer:!1,stencilBuffer:!1}),l=new li(C,x,{type:Ii,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&A.some(z=>z.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new ls(C,x),r===!0&&(c.format=hs,c.type=or)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let z=0;z<A.length;z++){let F=A[z];F.setSize&&F.setSize(C,x),T&&F.needsDepthTexture===!0&&F.setDepthTexture&&F.setDepthTexture(c)}},this.begin=function(P,C){if(m||P.toneMapping===Yi&&A.length===0)return!1;if(v=C,C!==null){let x=C.width,T=C.height;(o.width!==x||o.height!==T)&&this.setSize(x,T)}return b===!1&&P.setRenderTarget(o),p=P.toneMapping,P.toneMapping=Yi,!0},this.hasRenderPass=function(){return b},this.end=function(P,C){P.toneMapping=p,m=!0;let x=o,T=a;for(let z=0;z<A.length;z++){let F=A[z];F.enabled!==!1&&(F.render(P,T,x,C),F.needsSwap!==!1&&(x=T,T=T===a?l:a))}if(g!==P.outputColorSpace||y!==P.toneMapping){g=P.outputColorSpace,y=P.toneMapping,d.defines={},St.getTransfer(g)===Bt&&(d.defines.SRGB_TRANSFER="");let z=MS[y];z&&(d.defines[z]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=x.texture,P.setRenderTarget(v),P.render(u,f),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var zm=new Zn,Vm=new ls(1,1),Gm=new ko(1),Hm=new Io,Wm=new dl,Xm=new Bo,vm=[],ym=[],Sm=new Float32Array(16),Mm=new Float32Array(9),bm=new Float32Array(4);function io(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=vm[s];if(r===void 0&&(r=new Float32Array(s),vm[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Sn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Mn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function bc(i,e){let t=ym[e];t===void 0&&(t=new Int32Array(e),ym[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function wS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function ES(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;i.uniform2fv(this.addr,e),Mn(t,e)}}function TS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Sn(t,e))return;i.uniform3fv(this.addr,e),Mn(t,e)}}function AS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;i.uniform4fv(this.addr,e),Mn(t,e)}}function CS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Sn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,n))return;bm.set(n),i.uniformMatrix2fv(this.addr,!1,bm),Mn(t,n)}}function RS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Sn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,n))return;Mm.set(n),i.uniformMatrix3fv(this.addr,!1,Mm),Mn(t,n)}}function PS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Sn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Mn(t,e)}else{if(Sn(t,n))return;Sm.set(n),i.uniformMatrix4fv(this.addr,!1,Sm),Mn(t,n)}}function IS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function LS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;i.uniform2iv(this.addr,e),Mn(t,e)}}function DS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;i.uniform3iv(this.addr,e),Mn(t,e)}}function NS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;i.uniform4iv(this.addr,e),Mn(t,e)}}function US(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function FS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;i.uniform2uiv(this.addr,e),Mn(t,e)}}function OS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;i.uniform3uiv(this.addr,e),Mn(t,e)}}function BS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;i.uniform4uiv(this.addr,e),Mn(t,e)}}function wc(i){return i.version===0&&(i.compareFunction=Cu,i.needsUpdate=!0),i}function kS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=wc(Vm):r=zm,t.setTexture2D(e||r,s)}function zS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Wm,s)}function VS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=wc(Gm):r=Xm,t.setTextureCube(e||r,s)}function GS(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Hm,s)}function HS(i){switch(i){case 5126:return wS;case 35664:return ES;case 35665:return TS;case 35666:return AS;case 35674:return CS;case 35675:return RS;case 35676:return PS;case 5124:case 35670:return IS;case 35667:case 35671:return LS;case 35668:case 35672:return DS;case 35669:case 35673:return NS;case 5125:return US;case 36294:return FS;case 36295:return OS;case 36296:return BS;case 35678:case 36198:case 36298:case 36306:case 35682:return kS;case 35679:case 36299:case 36307:return zS;case 35680:case 36300:case 36308:case 36293:return VS;case 36289:case 36303:case 36311:case 36292:return GS}}function WS(i,e){i.uniform1fv(this.addr,e)}function XS(i,e){let t=io(e,this.size,2);i.uniform2fv(this.addr,t)}function qS(i,e){let t=io(e,this.size,3);i.uniform3fv(this.addr,t)}function YS(i,e){let t=io(e,this.size,4);i.uniform4fv(this.addr,t)}function $S(i,e){let t=io(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function ZS(i,e){let t=io(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function JS(i,e){let t=io(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function KS(i,e){i.uniform1iv(this.addr,e)}function jS(i,e){i.uniform2iv(this.addr,e)}function QS(i,e){i.uniform3iv(this.addr,e)}function eM(i,e){i.uniform4iv(this.addr,e)}function tM(i,e){i.uniform1uiv(this.addr,e)}function nM(i,e){i.uniform2uiv(this.addr,e)}function iM(i,e){i.uniform3uiv(this.addr,e)}function sM(i,e){i.uniform4uiv(this.addr,e)}function rM(i,e,t){let n=this.cache,s=e.length,r=bc(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=wc(Vm):o=zm;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function oM(i,e,t){let n=this.cache,s=e.length,r=bc(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Wm,r[o])}function aM(i,e,t){let n=this.cache,s=e.length,r=bc(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=wc(Gm):o=Xm;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function lM(i,e,t){let n=this.cache,s=e.length,r=bc(t,s);Sn(n,r)||(i.uniform1iv(this.addr,r),Mn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Hm,r[o])}function cM(i){switch(i){case 5126:return WS;case 35664:return XS;case 35665:return qS;case 35666:return YS;case 35674:return $S;case 35675:return ZS;case 35676:return JS;case 5124:case 35670:return KS;case 35667:case 35671:return jS;case 35668:case 35672:return QS;case 35669:case 35673:return eM;case 5125:return tM;case 36294:return nM;case 36295:return iM;case 36296:return sM;case 35678:case 36198:case 36298:case 36306:case 35682:return rM;case 35679:case 36299:case 36307:return oM;case 35680:case 36300:case 36308:case 36293:return aM;case 36289:case 36303:case 36311:case 36292:return lM}}var Ou=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=HS(t.type)}},Bu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=cM(t.type)}},ku=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Uu=/(\w+)(\])?(\[|\.)?/g;function wm(i,e){i.seq.push(e),i.map[e.id]=e}function hM(i,e,t){let n=i.name,s=n.length;for(Uu.lastIndex=0;;){let r=Uu.exec(n),o=Uu.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){wm(t,c===void 0?new Ou(a,i,e):new Bu(a,i,e));break}else{let d=t.map[a];d===void 0&&(d=new ku(a),wm(t,d)),t=d}}}var no=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);hM(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function Em(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var uM=37297,dM=0;function fM(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Tm=new dt;function pM(i){St._getMatrix(Tm,St.workingColorSpace,i);let e=`mat3( ${Tm.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(i)){case Co:return[e,"LinearTransferOETF"];case Bt:return[e,"sRGBTransferOETF"];default:return st("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Am(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+fM(i.getShaderSource(e),a)}else return r}function mM(i,e){let t=pM(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var gM={[hu]:"Linear",[uu]:"Reinhard",[du]:"Cineon",[fu]:"ACESFilmic",[mu]:"AgX",[gu]:"Neutral",[pu]:"Custom"};function _M(i,e){let t=gM[e];return t===void 0?(st("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var yc=new se;function xM(){St.getLuminanceCoefficients(yc);let i=yc.x.toFixed(4),e=yc.y.toFixed(4),t=yc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function vM(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(na).join(`
`)}function yM(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function SM(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function na(i){return i!==""}function Cm(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Rm(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var MM=/^[ \t]*#include +<([\w\d./]+)>/gm;function zu(i){return i.replace(MM,bM)}function bM(i,e){let t=gt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return zu(t)}var wM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Pm(i){return i.replace(wM,EM)}function EM(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Im(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var TM={[Xo]:"SHADOWMAP_TYPE_PCF",[jr]:"SHADOWMAP_TYPE_VSM"};function AM(i){return TM[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var CM={[eo]:"ENVMAP_MODE_REFRACTION"};function RM(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":CM[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var PM={[cu]:"ENVMAP_BLENDING_MULTIPLY",[$p]:"ENVMAP_BLENDING_MIX",[Zp]:"ENVMAP_BLENDING_ADD"};function IM(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":PM[i.combine]||"ENVMAP_BLENDING_NONE"}function LM(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=AM(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=RM(t),d=IM(t),u=vM(t),f=yM(r),g=s.createProgram(),y,m,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(na).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(na).join(`
`),m.length>0&&(m+=`
`)):(y=[Im(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(na).join(`
`),m=[Im(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Yi?"#define TONE_MAPPING":"",t.toneMapping!==Yi?gt.tonemapping_pars_fragment:"",t.toneMapping!==Yi?_M("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",gt.colorspace_pars_fragment,mM("linearToOutputTexel",t.outputColorSpace),xM(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(na).join(`
`)),o=zu(o),o=Cm(o,t),o=Rm(o,t),a=zu(a),a=Cm(a,t),a=Rm(a,t),o=Pm(o),a=Pm(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,y=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",t.glslVersion===Qo?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Qo?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=p+y+o,A=p+m+a,b=Em(s,s.VERTEX_SHADER,v),P=Em(s,s.FRAGMENT_SHADER,A);s.attachShader(g,b),s.attachShader(g,P),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function C(F){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",q=s.getShaderInfoLog(b)||"",$=s.getShaderInfoLog(P)||"",I=D.trim(),V=q.trim(),te=$.trim(),k=!0,pe=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(k=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,b,P);else{let Q=Am(s,b,"vertex"),re=Am(s,P,"fragment");ht("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+F.name+`
Material Type: `+F.type+`

Program Info Log: `+I+`
`+Q+`
`+re)}else I!==""?st("WebGLProgram: Program Info Log:",I):(V===""||te==="")&&(pe=!1);pe&&(F.diagnostics={runnable:k,programLog:I,vertexShader:{log:V,prefix:y},fragmentShader:{log:te,prefix:m}})}s.deleteShader(b),s.deleteShader(P),x=new no(s,g),T=SM(s,g)}let x;this.getUniforms=function(){return x===void 0&&C(this),x};let T;this.getAttributes=function(){return T===void 0&&C(this),T};let z=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return z===!1&&(z=s.getProgramParameter(g,uM)),z},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=dM++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=P,this}var DM=0,Vu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Gu(e),t.set(e,n)),n}},Gu=class{constructor(e){this.id=DM++,this.code=e,this.usedTimes=0}};function NM(i){return i===Bs||i===Ko||i===jo}function UM(i,e,t,n,s,r){let o=new Lo,a=new Vu,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,T,z,F,D,q){let $=F.fog,I=D.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?F.environment:null,te=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,k=e.get(x.envMap||V,te),pe=u[x.type],Q=n.precision;x.precision!==null&&(Q=n.getMaxPrecision(x.precision),Q!==x.precision&&st("WebGLProgram.getParameters:",x.precision,"not supported, using",Q,"instead."));let re=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ce=re!==void 0?re.length:0,de=0;I.morphAttributes.position!==void 0&&(de=1),I.morphAttributes.normal!==void 0&&(de=2),I.morphAttributes.color!==void 0&&(de=3);let me,oe,be,Ee;if(pe){let we=Zi[pe];me=we.vertexShader,oe=we.fragmentShader}else{me=x.vertexShader,oe=x.fragmentShader;let we=a.getVertexShaderStage(x),tt=a.getFragmentShaderStage(x);a.update(x,we,tt),be=we.id,Ee=tt.id}let Ce=i.getRenderTarget(),Te=i.state.buffers.depth.getReversed(),We=D.isInstancedMesh===!0,nt=D.isBatchedMesh===!0,qe=!!x.map,ct=!!x.matcap,rt=!!k,it=rt&&k.isPMREMTexture===!0,Dt=!!x.aoMap,Ct=!!x.lightMap,Wt=!!x.bumpMap&&x.wireframe===!1,Mt=!!x.normalMap,rn=!!x.displacementMap,pt=!!x.emissiveMap,kt=!!x.metalnessMap,Vt=!!x.roughnessMap,Xt=x.anisotropy>0,O=x.clearcoat>0,Ie=x.diffuseRoughness>0,et=x.dispersion>0,ot=x.retroreflectivity>0,Re=x.iridescence>0,bt=x.sheen>0,Ve=x.transmission>0,Ke=Xt&&!!x.anisotropyMap,E=O&&!!x.clearcoatMap,M=O&&!!x.clearcoatNormalMap,Z=O&&!!x.clearcoatRoughnessMap,B=Ie&&!!x.diffuseRoughnessMap,W=Re&&!!x.iridescenceMap,ae=Re&&!!x.iridescenceThicknessMap,le=bt&&!!x.sheenColorMap,K=bt&&!!x.sheenRoughnessMap,ne=!!x.specularMap,he=!!x.specularColorMap,N=!!x.specularIntensityMap,j=Ve&&!!x.transmissionMap,ee=Ve&&!!x.thicknessMap,ye=!!x.gradientMap,ge=!!x.alphaMap,Ae=x.alphaTest>0,Ye=!!x.alphaHash,Je=!!x.extensions,ue=Yi;x.toneMapped&&(Ce===null||Ce.isXRRenderTarget===!0)&&(ue=i.toneMapping);let Ne=it?k.isCompressedCubeTexture?k.image[0].mipmaps:k.mipmaps:null,Fe={shaderID:pe,shaderType:x.type,shaderName:x.name,vertexShader:me,fragmentShader:oe,defines:x.defines,customVertexShaderID:be,customFragmentShaderID:Ee,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Q,batching:nt,batchingColor:nt&&D._colorsTexture!==null,instancing:We,instancingColor:We&&D.instanceColor!==null,instancingMorph:We&&D.morphTexture!==null,outputColorSpace:Ce===null?i.outputColorSpace:Ce.isXRRenderTarget===!0?Ce.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:qe,matcap:ct,envMap:rt,envMapMode:rt&&k.mapping,envMapPMREM:it,envMapMaxLod:it?Ne.length-1:null,envMapSize:it?Ne[0].width:null,aoMap:Dt,lightMap:Ct,bumpMap:Wt,normalMap:Mt,displacementMap:rn,emissiveMap:pt,normalMapObjectSpace:Mt&&x.normalMapType===jp,normalMapTangentSpace:Mt&&x.normalMapType===Eu,packedNormalMap:Mt&&x.normalMapType===Eu&&NM(x.normalMap.format),metalnessMap:kt,roughnessMap:Vt,anisotropy:Xt,anisotropyMap:Ke,clearcoat:O,clearcoatMap:E,clearcoatNormalMap:M,clearcoatRoughnessMap:Z,diffuseRoughness:Ie,diffuseRoughnessMap:B,dispersion:et,retroreflection:ot,iridescence:Re,iridescenceMap:W,iridescenceThicknessMap:ae,sheen:bt,sheenColorMap:le,sheenRoughnessMap:K,specularMap:ne,specularColorMap:he,specularIntensityMap:N,transmission:Ve,transmissionMap:j,thicknessMap:ee,gradientMap:ye,opaque:x.transparent===!1&&x.blending===Qr&&x.alphaToCoverage===!1,alphaMap:ge,alphaTest:Ae,alphaHash:Ye,combine:x.combine,mapUv:qe&&f(x.map.channel),aoMapUv:Dt&&f(x.aoMap.channel),lightMapUv:Ct&&f(x.lightMap.channel),bumpMapUv:Wt&&f(x.bumpMap.channel),normalMapUv:Mt&&f(x.normalMap.channel),displacementMapUv:rn&&f(x.displacementMap.channel),emissiveMapUv:pt&&f(x.emissiveMap.channel),metalnessMapUv:kt&&f(x.metalnessMap.channel),roughnessMapUv:Vt&&f(x.roughnessMap.channel),anisotropyMapUv:Ke&&f(x.anisotropyMap.channel),clearcoatMapUv:E&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Z&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:B&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:W&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:ae&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:le&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:K&&f(x.sheenRoughnessMap.channel),specularMapUv:ne&&f(x.specularMap.channel),specularColorMapUv:he&&f(x.specularColorMap.channel),specularIntensityMapUv:N&&f(x.specularIntensityMap.channel),transmissionMapUv:j&&f(x.transmissionMap.channel),thicknessMapUv:ee&&f(x.thicknessMap.channel),alphaMapUv:ge&&f(x.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Mt||Xt),vertexNormals:!!I.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!I.attributes.uv&&(qe||ge),fog:!!$,useFog:x.fog===!0,fogExp2:!!$&&$.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||I.attributes.normal===void 0&&Mt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:Te,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ce,morphTextureStride:de,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:q.filter(we=>we.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&z.length>0,shadowMapType:i.shadowMap.type,toneMapping:ue,decodeVideoTexture:qe&&x.map.isVideoTexture===!0&&St.getTransfer(x.map.colorSpace)===Bt,decodeVideoTextureEmissive:pt&&x.emissiveMap.isVideoTexture===!0&&St.getTransfer(x.emissiveMap.colorSpace)===Bt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===qi,flipSided:x.side===Hn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Je&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&x.extensions.multiDraw===!0||nt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Fe.vertexUv1s=l.has(1),Fe.vertexUv2s=l.has(2),Fe.vertexUv3s=l.has(3),l.clear(),Fe}function y(x){let T=[];if(x.shaderID?T.push(x.shaderID):(T.push(x.customVertexShaderID),T.push(x.customFragmentShaderID)),x.defines!==void 0)for(let z in x.defines)T.push(z),T.push(x.defines[z]);return x.isRawShaderMaterial===!1&&(m(T,x),p(T,x),T.push(i.outputColorSpace)),T.push(x.customProgramCacheKey),T.join()}function m(x,T){x.push(T.precision),x.push(T.outputColorSpace),x.push(T.envMapMode),x.push(T.envMapPMREM),x.push(T.envMapMaxLod),x.push(T.envMapSize),x.push(T.mapUv),x.push(T.alphaMapUv),x.push(T.lightMapUv),x.push(T.aoMapUv),x.push(T.bumpMapUv),x.push(T.normalMapUv),x.push(T.displacementMapUv),x.push(T.emissiveMapUv),x.push(T.metalnessMapUv),x.push(T.roughnessMapUv),x.push(T.anisotropyMapUv),x.push(T.clearcoatMapUv),x.push(T.clearcoatNormalMapUv),x.push(T.clearcoatRoughnessMapUv),x.push(T.diffuseRoughnessMapUv),x.push(T.iridescenceMapUv),x.push(T.iridescenceThicknessMapUv),x.push(T.sheenColorMapUv),x.push(T.sheenRoughnessMapUv),x.push(T.specularMapUv),x.push(T.specularColorMapUv),x.push(T.specularIntensityMapUv),x.push(T.transmissionMapUv),x.push(T.thicknessMapUv),x.push(T.combine),x.push(T.fogExp2),x.push(T.sizeAttenuation),x.push(T.morphTargetsCount),x.push(T.numSunLights),x.push(T.numDirLights),x.push(T.numPointLights),x.push(T.numSpotLights),x.push(T.numSpotLightMaps),x.push(T.numHemiLights),x.push(T.numRectAreaLights),x.push(T.numSunLightShadows),x.push(T.numDirLightShadows),x.push(T.numPointLightShadows),x.push(T.numSpotLightShadows),x.push(T.numSpotLightShadowsWithMaps),x.push(T.numLightProbes),x.push(T.numLightProbeGrids),x.push(T.shadowMapType),x.push(T.toneMapping),x.push(T.numClippingPlanes),x.push(T.numClipIntersection),x.push(T.depthPacking)}function p(x,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let T=u[x.type],z;if(T){let F=Zi[T];z=dm.clone(F.uniforms)}else z=x.uniforms;return z}function A(x,T){let z=h.get(T);return z!==void 0?++z.usedTimes:(z=new LM(i,T,x,s),c.push(z),h.set(T,z)),z}function b(x){if(--x.usedTimes===0){let T=c.indexOf(x);c[T]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function P(x){a.remove(x)}function C(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:v,acquireProgram:A,releaseProgram:b,releaseShaderCache:P,programs:c,dispose:C}}function FM(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function OM(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Lm(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Dm(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function a(u,f,g,y,m,p){let v=i[e];return v===void 0?(v={id:u.id,object:u,geometry:f,material:g,materialVariant:o(u),groupOrder:y,renderOrder:u.renderOrder,z:m,group:p},i[e]=v):(v.id=u.id,v.object=u,v.geometry=f,v.material=g,v.materialVariant=o(u),v.groupOrder=y,v.renderOrder=u.renderOrder,v.z=m,v.group=p),e++,v}function l(u,f,g,y,m,p,v){v.reversedDepth===!0&&(m=-m);let A=a(u,f,g,y,m,p);g.transmission>0?n.push(A):g.transparent===!0?s.push(A):t.push(A)}function c(u,f,g,y,m,p){let v=a(u,f,g,y,m,p);g.transmission>0?n.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function h(u,f){t.length>1&&t.sort(u||OM),n.length>1&&n.sort(f||Lm),s.length>1&&s.sort(f||Lm)}function d(){for(let u=e,f=i.length;u<f;u++){let g=i[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function BM(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Dm,i.set(n,[o])):s>=r.length?(o=new Dm,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function kM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new se,color:new At};break;case"SpotLight":t={position:new se,direction:new se,color:new At,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new se,color:new At,distance:0,decay:0};break;case"HemisphereLight":t={direction:new se,skyColor:new At,groundColor:new At};break;case"RectAreaLight":t={color:new At,position:new se,halfWidth:new se,halfHeight:new se};break}return i[e.id]=t,t}}}function zM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Tt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Tt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Tt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var VM=0;function GM(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function HM(i){let e=new kM,t=zM(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new se);let s=new se,r=new an,o=new an;function a(c){let h=0,d=0,u=0;for(let q=0;q<9;q++)n.probe[q].set(0,0,0);let f=0,g=0,y=0,m=0,p=0,v=0,A=0,b=0,P=0,C=0,x=0,T=0,z=0,F=0;c.sort(GM);for(let q=0,$=c.length;q<$;q++){let I=c[q],V=I.color,te=I.intensity,k=I.distance,pe=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===Bs?pe=I.shadow.map.texture:pe=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=V.r*te,d+=V.g*te,u+=V.b*te;else if(I.isLightProbe){for(let Q=0;Q<9;Q++)n.probe[Q].addScaledVector(I.sh.coefficients[Q],te);F++}else if(I.isSunLight){let Q=e.get(I);if(Q.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let re=I.shadow,ce=t.get(I);ce.shadowIntensity=re.intensity,ce.shadowBias=re.bias,ce.shadowNormalBias=re.normalBias,ce.shadowRadius=re.radius,ce.shadowMapSize.copy(re.mapSize).multiply(re.getFrameExtents()),n.sunShadow[g]=ce,n.sunShadowMap[g]=pe;let de=re.getViewportCount();for(let me=0;me<de;me++)n.sunShadowMatrix[y+me]=re.getMatrix(me),n.sunShadowCascade[y+me]=re._cascadeData[me];y+=de,g++}n.sun[f]=Q,f++}else if(I.isDirectionalLight){let Q=e.get(I);if(Q.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let re=I.shadow,ce=t.get(I);ce.shadowIntensity=re.intensity,ce.shadowBias=re.bias,ce.shadowNormalBias=re.normalBias,ce.shadowRadius=re.radius,ce.shadowMapSize=re.mapSize,n.directionalShadow[m]=ce,n.directionalShadowMap[m]=pe,n.directionalShadowMatrix[m]=I.shadow.matrix,P++}n.directional[m]=Q,m++}else if(I.isSpotLight){let Q=e.get(I);Q.position.setFromMatrixPosition(I.matrixWorld),Q.color.copy(V).multiplyScalar(te),Q.distance=k,Q.coneCos=Math.cos(I.angle),Q.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),Q.decay=I.decay,n.spot[v]=Q;let re=I.shadow;if(I.map&&(n.spotLightMap[T]=I.map,T++,re.updateMatrices(I),I.castShadow&&z++),n.spotLightMatrix[v]=re.matrix,I.castShadow){let ce=t.get(I);ce.shadowIntensity=re.intensity,ce.shadowBias=re.bias,ce.shadowNormalBias=re.normalBias,ce.shadowRadius=re.radius,ce.shadowMapSize=re.mapSize,n.spotShadow[v]=ce,n.spotShadowMap[v]=pe,x++}v++}else if(I.isRectAreaLight){let Q=e.get(I);Q.color.copy(V).multiplyScalar(te),Q.halfWidth.set(I.width*.5,0,0),Q.halfHeight.set(0,I.height*.5,0),n.rectArea[A]=Q,A++}else if(I.isPointLight){let Q=e.get(I);if(Q.color.copy(I.color).multiplyScalar(I.intensity),Q.distance=I.distance,Q.decay=I.decay,I.castShadow){let re=I.shadow,ce=t.get(I);ce.shadowIntensity=re.intensity,ce.shadowBias=re.bias,ce.shadowNormalBias=re.normalBias,ce.shadowRadius=re.radius,ce.shadowMapSize=re.mapSize,ce.shadowCameraNear=re.camera.near,ce.shadowCameraFar=re.camera.far,n.pointShadow[p]=ce,n.pointShadowMap[p]=pe,n.pointShadowMatrix[p]=I.shadow.matrix,C++}n.point[p]=Q,p++}else if(I.isHemisphereLight){let Q=e.get(I);Q.skyColor.copy(I.color).multiplyScalar(te),Q.groundColor.copy(I.groundColor).multiplyScalar(te),n.hemi[b]=Q,b++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ue.LTC_FLOAT_1,n.rectAreaLTC2=Ue.LTC_FLOAT_2):(n.rectAreaLTC1=Ue.LTC_HALF_1,n.rectAreaLTC2=Ue.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let D=n.hash;(D.sunLength!==f||D.directionalLength!==m||D.pointLength!==p||D.spotLength!==v||D.rectAreaLength!==A||D.hemiLength!==b||D.numSunShadows!==g||D.numDirectionalShadows!==P||D.numPointShadows!==C||D.numSpotShadows!==x||D.numSpotMaps!==T||D.numLightProbes!==F)&&(n.sun.length=f,n.directional.length=m,n.spot.length=v,n.rectArea.length=A,n.point.length=p,n.hemi.length=b,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=P,n.directionalShadowMap.length=P,n.directionalShadowMatrix.length=P,n.pointShadow.length=C,n.pointShadowMap.length=C,n.pointShadowMatrix.length=C,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+T-z,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=z,n.numLightProbes=F,D.sunLength=f,D.directionalLength=m,D.pointLength=p,D.spotLength=v,D.rectAreaLength=A,D.hemiLength=b,D.numSunShadows=g,D.numDirectionalShadows=P,D.numPointShadows=C,D.numSpotShadows=x,D.numSpotMaps=T,D.numLightProbes=F,n.version=VM++)}function l(c,h){let d=0,u=0,f=0,g=0,y=0,m=0,p=h.matrixWorldInverse;for(let v=0,A=c.length;v<A;v++){let b=c[v];if(b.isSunLight){let P=n.sun[d];P.direction.setFromMatrixPosition(b.matrixWorld),P.direction.transformDirection(p),d++}else if(b.isDirectionalLight){let P=n.directional[u];P.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(p),u++}else if(b.isSpotLight){let P=n.spot[g];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(p),P.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(p),g++}else if(b.isRectAreaLight){let P=n.rectArea[y];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(p),o.identity(),r.copy(b.matrixWorld),r.premultiply(p),o.extractRotation(r),P.halfWidth.set(b.width*.5,0,0),P.halfHeight.set(0,b.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),y++}else if(b.isPointLight){let P=n.point[f];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(p),f++}else if(b.isHemisphereLight){let P=n.hemi[m];P.direction.setFromMatrixPosition(b.matrixWorld),P.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:n}}function Nm(i){let e=new HM(i),t=[],n=[],s=[];function r(d){h.camera=d,t.length=0,n.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){n.push(d)}function l(){e.setup(t),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function WM(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Nm(i),e.set(s,[a])):r>=o.length?(a=new Nm(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var XM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,qM=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,YM=[new se(1,0,0),new se(-1,0,0),new se(0,1,0),new se(0,-1,0),new se(0,0,1),new se(0,0,-1)],$M=[new se(0,-1,0),new se(0,-1,0),new se(0,0,1),new se(0,0,-1),new se(0,-1,0),new se(0,-1,0)],Um=new an,ta=new se,Fu=new se;function ZM(i,e,t){let n=new nr,s=new Tt,r=new Tt,o=new sn,a=new Sl,l=new Ml,c={},h=t.maxTextureSize,d={[Os]:Hn,[Hn]:Os,[qi]:qi},u=new vi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Tt},radius:{value:4}},vertexShader:XM,fragmentShader:qM}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let g=new Wi;g.setAttribute("position",new Yn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Xi(g,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xo;let p=this.type;this.render=function(C,x,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||C.length===0)return;this.type===Rp&&(st("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Xo);let z=i.getRenderTarget(),F=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),q=i.state;q.setBlending(ir),q.buffers.depth.getReversed()===!0?q.buffers.color.setClear(0,0,0,0):q.buffers.color.setClear(1,1,1,1),q.buffers.depth.setTest(!0),q.setScissorTest(!1);let $=p!==this.type;$&&x.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(V=>V.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,V=C.length;I<V;I++){let te=C[I],k=te.shadow;if(k===void 0){st("WebGLShadowMap:",te,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);let pe=k.getFrameExtents();s.multiply(pe),r.copy(k.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/pe.x),s.x=r.x*pe.x,k.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/pe.y),s.y=r.y*pe.y,k.mapSize.y=r.y));let Q=i.state.buffers.depth.getReversed();if(k.camera._reversedDepth=Q,k.map===null||$===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===jr){if(te.isPointLight){st("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new li(s.x,s.y,{format:Bs,type:Ii,minFilter:Gn,magFilter:Gn,generateMipmaps:!1}),k.map.texture.name=te.name+".shadowMap",k.map.depthTexture=new ls(s.x,s.y,Pi),k.map.depthTexture.name=te.name+".shadowMapDepth",k.map.depthTexture.format=as,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Cn,k.map.depthTexture.magFilter=Cn}else te.isPointLight?(k.map=new ia(s.x),k.map.depthTexture=new ko(s.x,Ri)):(k.map=new li(s.x,s.y),k.map.depthTexture=new ls(s.x,s.y,Ri)),k.map.depthTexture.name=te.name+".shadowMap",k.map.depthTexture.format=as,this.type===Xo?(k.map.depthTexture.compareFunction=Q?Au:Tu,k.map.depthTexture.minFilter=Gn,k.map.depthTexture.magFilter=Gn):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Cn,k.map.depthTexture.magFilter=Cn);k.camera.updateProjectionMatrix()}k.map.isWebGLCubeRenderTarget!==!0&&(k.map.width!==s.x||k.map.height!==s.y)&&k.map.setSize(s.x,s.y);let re=k.map.isWebGLCubeRenderTarget?6:k.getViewportCount();te.isPointLight!==!0&&k.updateMatrices(te,T);let ce=(k.camera.layers.mask&4294967294)!==0?k.camera.layers:T.layers;for(let de=0;de<re;de++){let me=k.getCamera(de);if(te.isPointLight){let oe=k.camera,be=k.matrix,Ee=te.distance||oe.far;Ee!==oe.far&&(oe.far=Ee,oe.updateProjectionMatrix()),ta.setFromMatrixPosition(te.matrixWorld),oe.position.copy(ta),Fu.copy(oe.position),Fu.add(YM[de]),oe.up.copy($M[de]),oe.lookAt(Fu),oe.updateMatrixWorld(),be.makeTranslation(-ta.x,-ta.y,-ta.z),Um.multiplyMatrices(oe.projectionMatrix,oe.matrixWorldInverse),k._frustum.setFromProjectionMatrix(Um,oe.coordinateSystem,oe.reversedDepth)}if(k.map.isWebGLCubeRenderTarget)i.setRenderTarget(k.map,de),i.clear();else{de===0&&(i.setRenderTarget(k.map),i.clear());let oe=k.getViewport(de);o.set(r.x*oe.x,r.y*oe.y,r.x*oe.z,r.y*oe.w),q.viewport(o)}n=k.getFrustum(de),b(x,T,me,te,ce,this.type)}k.isPointLightShadow!==!0&&this.type===jr&&v(k,T),k.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(z,F,D)};function v(C,x){let T=e.update(y);u.defines.VSM_SAMPLES!==C.blurSamples&&(u.defines.VSM_SAMPLES=C.blurSamples,f.defines.VSM_SAMPLES=C.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),C.mapPass===null?C.mapPass=new li(s.x,s.y,{format:Bs,type:Ii}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),u.uniforms.shadow_pass.value=C.map.depthTexture,u.uniforms.resolution.value.set(C.map.width,C.map.height),u.uniforms.radius.value=C.radius,i.setRenderTarget(C.mapPass),i.clear(),i.renderBufferDirect(x,null,T,u,y,null),f.uniforms.shadow_pass.value=C.mapPass.texture,f.uniforms.resolution.value.set(C.map.width,C.map.height),f.uniforms.radius.value=C.radius,i.setRenderTarget(C.map),i.clear(),i.renderBufferDirect(x,null,T,f,y,null)}function A(C,x,T,z){let F=null,D=T.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(D!==void 0)F=D;else if(F=T.isPointLight===!0?l:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let q=F.uuid,$=x.uuid,I=c[q];I===void 0&&(I={},c[q]=I);let V=I[$];V===void 0&&(V=F.clone(),I[$]=V,x.addEventListener("dispose",P)),F=V}if(F.visible=x.visible,F.wireframe=x.wireframe,z===jr?F.side=x.shadowSide!==null?x.shadowSide:x.side:F.side=x.shadowSide!==null?x.shadowSide:d[x.side],F.alphaMap=x.alphaMap,F.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,F.map=x.map,F.clipShadows=x.clipShadows,F.clippingPlanes=x.clippingPlanes,F.clipIntersection=x.clipIntersection,F.displacementMap=x.displacementMap,F.displacementScale=x.displacementScale,F.displacementBias=x.displacementBias,F.wireframeLinewidth=x.wireframeLinewidth,F.linewidth=x.linewidth,T.isPointLight===!0&&F.isMeshDistanceMaterial===!0){let q=i.properties.get(F);q.light=T}return F}function b(C,x,T,z,F,D){if(C.visible===!1)return;if(C.layers.test(F)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&D===jr)&&(!C.frustumCulled||C.intersectsFrustum(n))){C.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,C.matrixWorld);let I=e.update(C),V=C.material;if(Array.isArray(V)){let te=I.groups;for(let k=0,pe=te.length;k<pe;k++){let Q=te[k],re=V[Q.materialIndex];if(re&&re.visible){let ce=A(C,re,z,D);C.onBeforeShadow(i,C,x,T,I,ce,Q),i.renderBufferDirect(T,null,I,ce,C,Q),C.onAfterShadow(i,C,x,T,I,ce,Q)}}}else if(V.visible){let te=A(C,V,z,D);C.onBeforeShadow(i,C,x,T,I,te,null),i.renderBufferDirect(T,null,I,te,C,null),C.onAfterShadow(i,C,x,T,I,te,null)}}let $=C.children;for(let I=0,V=$.length;I<V;I++)b($[I],x,T,z,F,D)}function P(C){C.target.removeEventListener("dispose",P);for(let T in c){let z=c[T],F=C.target.uuid;F in z&&(z[F].dispose(),delete z[F])}}}function JM(i,e){function t(){let N=!1,j=new sn,ee=null,ye=new sn(0,0,0,0);return{setMask:function(ge){ee!==ge&&!N&&(i.colorMask(ge,ge,ge,ge),ee=ge)},setLocked:function(ge){N=ge},setClear:function(ge,Ae,Ye,Je,ue){ue===!0&&(ge*=Je,Ae*=Je,Ye*=Je),j.set(ge,Ae,Ye,Je),ye.equals(j)===!1&&(i.clearColor(ge,Ae,Ye,Je),ye.copy(j))},reset:function(){N=!1,ee=null,ye.set(-1,0,0,0)}}}function n(){let N=!1,j=!1,ee=null,ye=null,ge=null;return{setReversed:function(Ae){if(j!==Ae){let Ye=e.get("EXT_clip_control");Ae?Ye.clipControlEXT(Ye.LOWER_LEFT_EXT,Ye.ZERO_TO_ONE_EXT):Ye.clipControlEXT(Ye.LOWER_LEFT_EXT,Ye.NEGATIVE_ONE_TO_ONE_EXT),j=Ae;let Je=ge;ge=null,this.setClear(Je)}},getReversed:function(){return j},setTest:function(Ae){Ae?Te(i.DEPTH_TEST):We(i.DEPTH_TEST)},setMask:function(Ae){ee!==Ae&&!N&&(i.depthMask(Ae),ee=Ae)},setFunc:function(Ae){if(j&&(Ae=cm[Ae]),ye!==Ae){switch(Ae){case Qa:i.depthFunc(i.NEVER);break;case el:i.depthFunc(i.ALWAYS);break;case tl:i.depthFunc(i.LESS);break;case Xr:i.depthFunc(i.LEQUAL);break;case nl:i.depthFunc(i.EQUAL);break;case il:i.depthFunc(i.GEQUAL);break;case sl:i.depthFunc(i.GREATER);break;case rl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ye=Ae}},setLocked:function(Ae){N=Ae},setClear:function(Ae){ge!==Ae&&(ge=Ae,j&&(Ae=1-Ae),i.clearDepth(Ae))},reset:function(){N=!1,ee=null,ye=null,ge=null,j=!1}}}function s(){let N=!1,j=null,ee=null,ye=null,ge=null,Ae=null,Ye=null,Je=null,ue=null;return{setTest:function(Ne){N||(Ne?Te(i.STENCIL_TEST):We(i.STENCIL_TEST))},setMask:function(Ne){j!==Ne&&!N&&(i.stencilMask(Ne),j=Ne)},setFunc:function(Ne,Fe,we){(ee!==Ne||ye!==Fe||ge!==we)&&(i.stencilFunc(Ne,Fe,we),ee=Ne,ye=Fe,ge=we)},setOp:function(Ne,Fe,we){(Ae!==Ne||Ye!==Fe||Je!==we)&&(i.stencilOp(Ne,Fe,we),Ae=Ne,Ye=Fe,Je=we)},setLocked:function(Ne){N=Ne},setClear:function(Ne){ue!==Ne&&(i.clearStencil(Ne),ue=Ne)},reset:function(){N=!1,j=null,ee=null,ye=null,ge=null,Ae=null,Ye=null,Je=null,ue=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},d={},u={},f=new WeakMap,g=[],y=null,m=!1,p=null,v=null,A=null,b=null,P=null,C=null,x=null,T=new At(0,0,0),z=0,F=!1,D=null,q=null,$=null,I=null,V=null,te=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),k=!1,pe=0,Q=i.getParameter(i.VERSION);Q.indexOf("WebGL")!==-1?(pe=parseFloat(/^WebGL (\d)/.exec(Q)[1]),k=pe>=1):Q.indexOf("OpenGL ES")!==-1&&(pe=parseFloat(/^OpenGL ES (\d)/.exec(Q)[1]),k=pe>=2);let re=null,ce={},de=i.getParameter(i.SCISSOR_BOX),me=i.getParameter(i.VIEWPORT),oe=new sn().fromArray(de),be=new sn().fromArray(me);function Ee(N,j,ee,ye){let ge=new Uint8Array(4),Ae=i.createTexture();i.bindTexture(N,Ae),i.texParameteri(N,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(N,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ye=0;Ye<ee;Ye++)N===i.TEXTURE_3D||N===i.TEXTURE_2D_ARRAY?i.texImage3D(j,0,i.RGBA,1,1,ye,0,i.RGBA,i.UNSIGNED_BYTE,ge):i.texImage2D(j+Ye,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ge);return Ae}let Ce={};Ce[i.TEXTURE_2D]=Ee(i.TEXTURE_2D,i.TEXTURE_2D,1),Ce[i.TEXTURE_CUBE_MAP]=Ee(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ce[i.TEXTURE_2D_ARRAY]=Ee(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ce[i.TEXTURE_3D]=Ee(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Te(i.DEPTH_TEST),o.setFunc(Xr),Wt(!1),Mt(iu),Te(i.CULL_FACE),Dt(ir);function Te(N){h[N]!==!0&&(i.enable(N),h[N]=!0)}function We(N){h[N]!==!1&&(i.disable(N),h[N]=!1)}function nt(N,j){return u[N]!==j?(i.bindFramebuffer(N,j),u[N]=j,N===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=j),N===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=j),!0):!1}function qe(N,j){let ee=g,ye=!1;if(N){ee=f.get(j),ee===void 0&&(ee=[],f.set(j,ee));let ge=N.textures;if(ee.length!==ge.length||ee[0]!==i.COLOR_ATTACHMENT0){for(let Ae=0,Ye=ge.length;Ae<Ye;Ae++)ee[Ae]=i.COLOR_ATTACHMENT0+Ae;ee.length=ge.length,ye=!0}}else ee[0]!==i.BACK&&(ee[0]=i.BACK,ye=!0);ye&&i.drawBuffers(ee)}function ct(N){return y!==N?(i.useProgram(N),y=N,!0):!1}let rt={[sr]:i.FUNC_ADD,[Ip]:i.FUNC_SUBTRACT,[Lp]:i.FUNC_REVERSE_SUBTRACT};rt[Dp]=i.MIN,rt[Np]=i.MAX;let it={[Up]:i.ZERO,[Fp]:i.ONE,[Op]:i.SRC_COLOR,[au]:i.SRC_ALPHA,[Hp]:i.SRC_ALPHA_SATURATE,[Vp]:i.DST_COLOR,[kp]:i.DST_ALPHA,[Bp]:i.ONE_MINUS_SRC_COLOR,[lu]:i.ONE_MINUS_SRC_ALPHA,[Gp]:i.ONE_MINUS_DST_COLOR,[zp]:i.ONE_MINUS_DST_ALPHA,[Wp]:i.CONSTANT_COLOR,[Xp]:i.ONE_MINUS_CONSTANT_COLOR,[qp]:i.CONSTANT_ALPHA,[Yp]:i.ONE_MINUS_CONSTANT_ALPHA};function Dt(N,j,ee,ye,ge,Ae,Ye,Je,ue,Ne){if(N===ir){m===!0&&(We(i.BLEND),m=!1);return}if(m===!1&&(Te(i.BLEND),m=!0),N!==Pp){if(N!==p||Ne!==F){if((v!==sr||P!==sr)&&(i.blendEquation(i.FUNC_ADD),v=sr,P=sr),Ne)switch(N){case Qr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case su:i.blendFunc(i.ONE,i.ONE);break;case ru:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case ou:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ht("WebGLState: Invalid blending: ",N);break}else switch(N){case Qr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case su:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case ru:ht("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ou:ht("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ht("WebGLState: Invalid blending: ",N);break}A=null,b=null,C=null,x=null,T.set(0,0,0),z=0,p=N,F=Ne}return}ge=ge||j,Ae=Ae||ee,Ye=Ye||ye,(j!==v||ge!==P)&&(i.blendEquationSeparate(rt[j],rt[ge]),v=j,P=ge),(ee!==A||ye!==b||Ae!==C||Ye!==x)&&(i.blendFuncSeparate(it[ee],it[ye],it[Ae],it[Ye]),A=ee,b=ye,C=Ae,x=Ye),(Je.equals(T)===!1||ue!==z)&&(i.blendColor(Je.r,Je.g,Je.b,ue),T.copy(Je),z=ue),p=N,F=!1}function Ct(N,j){N.side===qi?We(i.CULL_FACE):Te(i.CULL_FACE);let ee=N.side===Hn;j&&(ee=!ee),Wt(ee),N.blending===Qr&&N.transparent===!1?Dt(ir):Dt(N.blending,N.blendEquation,N.blendSrc,N.blendDst,N.blendEquationAlpha,N.blendSrcAlpha,N.blendDstAlpha,N.blendColor,N.blendAlpha,N.premultipliedAlpha),o.setFunc(N.depthFunc),o.setTest(N.depthTest),o.setMask(N.depthWrite),r.setMask(N.colorWrite);let ye=N.stencilWrite;a.setTest(ye),ye&&(a.setMask(N.stencilWriteMask),a.setFunc(N.stencilFunc,N.stencilRef,N.stencilFuncMask),a.setOp(N.stencilFail,N.stencilZFail,N.stencilZPass)),pt(N.polygonOffset,N.polygonOffsetFactor,N.polygonOffsetUnits),N.alphaToCoverage===!0?Te(i.SAMPLE_ALPHA_TO_COVERAGE):We(i.SAMPLE_ALPHA_TO_COVERAGE)}function Wt(N){D!==N&&(N?i.frontFace(i.CW):i.frontFace(i.CCW),D=N)}function Mt(N){N!==Ap?(Te(i.CULL_FACE),N!==q&&(N===iu?i.cullFace(i.BACK):N===Cp?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):We(i.CULL_FACE),q=N}function rn(N){N!==$&&(k&&i.lineWidth(N),$=N)}function pt(N,j,ee){N?(Te(i.POLYGON_OFFSET_FILL),(I!==j||V!==ee)&&(I=j,V=ee,o.getReversed()&&(j=-j,ee=-ee),i.polygonOffset(j,ee))):We(i.POLYGON_OFFSET_FILL)}function kt(N){N?Te(i.SCISSOR_TEST):We(i.SCISSOR_TEST)}function Vt(N){N===void 0&&(N=i.TEXTURE0+te-1),re!==N&&(i.activeTexture(N),re=N)}function Xt(N,j,ee){ee===void 0&&(re===null?ee=i.TEXTURE0+te-1:ee=re);let ye=ce[ee];ye===void 0&&(ye={type:void 0,texture:void 0},ce[ee]=ye),(ye.type!==N||ye.texture!==j)&&(re!==ee&&(i.activeTexture(ee),re=ee),i.bindTexture(N,j||Ce[N]),ye.type=N,ye.texture=j)}function O(){let N=ce[re];N!==void 0&&N.type!==void 0&&(i.bindTexture(N.type,null),N.type=void 0,N.texture=void 0)}function Ie(){try{i.compressedTexImage2D(...arguments)}catch(N){ht("WebGLState:",N)}}function et(){try{i.compressedTexImage3D(...arguments)}catch(N){ht("WebGLState:",N)}}function ot(){try{i.texSubImage2D(...arguments)}catch(N){ht("WebGLState:",N)}}function Re(){try{i.texSubImage3D(...arguments)}catch(N){ht("WebGLState:",N)}}function bt(){try{i.compressedTexSubImage2D(...arguments)}catch(N){ht("WebGLState:",N)}}function Ve(){try{i.compressedTexSubImage3D(...arguments)}catch(N){ht("WebGLState:",N)}}function Ke(){try{i.texStorage2D(...arguments)}catch(N){ht("WebGLState:",N)}}function E(){try{i.texStorage3D(...arguments)}catch(N){ht("WebGLState:",N)}}function M(){try{i.texImage2D(...arguments)}catch(N){ht("WebGLState:",N)}}function Z(){try{i.texImage3D(...arguments)}catch(N){ht("WebGLState:",N)}}function B(N){return d[N]!==void 0?d[N]:i.getParameter(N)}function W(N,j){d[N]!==j&&(i.pixelStorei(N,j),d[N]=j)}function ae(N){oe.equals(N)===!1&&(i.scissor(N.x,N.y,N.z,N.w),oe.copy(N))}function le(N){be.equals(N)===!1&&(i.viewport(N.x,N.y,N.z,N.w),be.copy(N))}function K(N,j){let ee=c.get(j);ee===void 0&&(ee=new WeakMap,c.set(j,ee));let ye=ee.get(N);ye===void 0&&(ye=i.getUniformBlockIndex(j,N.name),i.uniformBlockBinding(j,ye,ye),ee.set(N,ye))}function ne(N,j,ee){let ge=c.get(j).get(N);l[ge]!==ee&&(i.bindBufferBase(i.UNIFORM_BUFFER,ge,ee),l[ge]=ee)}function he(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},re=null,ce={},u={},l={},f=new WeakMap,g=[],y=null,m=!1,p=null,v=null,A=null,b=null,P=null,C=null,x=null,T=new At(0,0,0),z=0,F=!1,D=null,q=null,$=null,I=null,V=null,oe.set(0,0,i.canvas.width,i.canvas.height),be.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Te,disable:We,bindFramebuffer:nt,drawBuffers:qe,useProgram:ct,setBlending:Dt,setMaterial:Ct,setFlipSided:Wt,setCullFace:Mt,setLineWidth:rn,setPolygonOffset:pt,setScissorTest:kt,activeTexture:Vt,bindTexture:Xt,unbindTexture:O,compressedTexImage2D:Ie,compressedTexImage3D:et,texImage2D:M,texImage3D:Z,pixelStorei:W,getParameter:B,updateUBOMapping:K,uniformBlockBinding:ne,texStorage2D:Ke,texStorage3D:E,texSubImage2D:ot,texSubImage3D:Re,compressedTexSubImage2D:bt,compressedTexSubImage3D:Ve,scissor:ae,viewport:le,reset:he}}function KM(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Tt,h=new WeakMap,d=new Set,u,f=new WeakMap,g=new Set,y=new FinalizationRegistry(E=>g.delete(E)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(E,M){return m?new OffscreenCanvas(E,M):Po("canvas")}function v(E,M,Z){let B=1,W=Ke(E);if((W.width>Z||W.height>Z)&&(B=Z/Math.max(W.width,W.height)),B<1)if(typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&E instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&E instanceof ImageBitmap||typeof VideoFrame<"u"&&E instanceof VideoFrame){let ae=Math.floor(B*W.width),le=Math.floor(B*W.height);u===void 0&&(u=p(ae,le));let K=M?p(ae,le):u;return K.width=ae,K.height=le,K.getContext("2d").drawImage(E,0,0,ae,le),st("WebGLRenderer: Texture has been resized from ("+W.width+"x"+W.height+") to ("+ae+"x"+le+")."),K}else return"data"in E&&st("WebGLRenderer: Image in DataTexture is too big ("+W.width+"x"+W.height+")."),E;return E}function A(E){return E.generateMipmaps}function b(E){i.generateMipmap(E)}function P(E){return E.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:E.isWebGL3DRenderTarget?i.TEXTURE_3D:E.isWebGLArrayRenderTarget||E.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function C(E,M,Z,B,W,ae=!1){if(E!==null){if(i[E]!==void 0)return i[E];st("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+E+"'")}let le;B&&(le=e.get("EXT_texture_norm16"),le||st("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let K=M;if(M===i.RED&&(Z===i.FLOAT&&(K=i.R32F),Z===i.HALF_FLOAT&&(K=i.R16F),Z===i.UNSIGNED_BYTE&&(K=i.R8),Z===i.UNSIGNED_SHORT&&le&&(K=le.R16_EXT),Z===i.SHORT&&le&&(K=le.R16_SNORM_EXT)),M===i.RED_INTEGER&&(Z===i.UNSIGNED_BYTE&&(K=i.R8UI),Z===i.UNSIGNED_SHORT&&(K=i.R16UI),Z===i.UNSIGNED_INT&&(K=i.R32UI),Z===i.BYTE&&(K=i.R8I),Z===i.SHORT&&(K=i.R16I),Z===i.INT&&(K=i.R32I)),M===i.RG&&(Z===i.FLOAT&&(K=i.RG32F),Z===i.HALF_FLOAT&&(K=i.RG16F),Z===i.UNSIGNED_BYTE&&(K=i.RG8),Z===i.UNSIGNED_SHORT&&le&&(K=le.RG16_EXT),Z===i.SHORT&&le&&(K=le.RG16_SNORM_EXT)),M===i.RG_INTEGER&&(Z===i.UNSIGNED_BYTE&&(K=i.RG8UI),Z===i.UNSIGNED_SHORT&&(K=i.RG16UI),Z===i.UNSIGNED_INT&&(K=i.RG32UI),Z===i.BYTE&&(K=i.RG8I),Z===i.SHORT&&(K=i.RG16I),Z===i.INT&&(K=i.RG32I)),M===i.RGB_INTEGER&&(Z===i.UNSIGNED_BYTE&&(K=i.RGB8UI),Z===i.UNSIGNED_SHORT&&(K=i.RGB16UI),Z===i.UNSIGNED_INT&&(K=i.RGB32UI),Z===i.BYTE&&(K=i.RGB8I),Z===i.SHORT&&(K=i.RGB16I),Z===i.INT&&(K=i.RGB32I)),M===i.RGBA_INTEGER&&(Z===i.UNSIGNED_BYTE&&(K=i.RGBA8UI),Z===i.UNSIGNED_SHORT&&(K=i.RGBA16UI),Z===i.UNSIGNED_INT&&(K=i.RGBA32UI),Z===i.BYTE&&(K=i.RGBA8I),Z===i.SHORT&&(K=i.RGBA16I),Z===i.INT&&(K=i.RGBA32I)),M===i.RGB&&(Z===i.UNSIGNED_SHORT&&le&&(K=le.RGB16_EXT),Z===i.SHORT&&le&&(K=le.RGB16_SNORM_EXT),Z===i.UNSIGNED_INT_5_9_9_9_REV&&(K=i.RGB9_E5),Z===i.UNSIGNED_INT_10F_11F_11F_REV&&(K=i.R11F_G11F_B10F)),M===i.RGBA){let ne=ae?Co:St.getTransfer(W);Z===i.FLOAT&&(K=i.RGBA32F),Z===i.HALF_FLOAT&&(K=i.RGBA16F),Z===i.UNSIGNED_BYTE&&(K=ne===Bt?i.SRGB8_ALPHA8:i.RGBA8),Z===i.UNSIGNED_SHORT&&le&&(K=le.RGBA16_EXT),Z===i.SHORT&&le&&(K=le.RGBA16_SNORM_EXT),Z===i.UNSIGNED_SHORT_4_4_4_4&&(K=i.RGBA4),Z===i.UNSIGNED_SHORT_5_5_5_1&&(K=i.RGB5_A1)}return(K===i.R16F||K===i.R32F||K===i.RG16F||K===i.RG32F||K===i.RGBA16F||K===i.RGBA32F)&&e.get("EXT_color_buffer_float"),K}function x(E,M){let Z;return E?M===null||M===Ri||M===or?Z=i.DEPTH24_STENCIL8:M===Pi?Z=i.DEPTH32F_STENCIL8:M===to&&(Z=i.DEPTH24_STENCIL8,st("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Ri||M===or?Z=i.DEPTH_COMPONENT24:M===Pi?Z=i.DEPTH_COMPONENT32F:M===to&&(Z=i.DEPTH_COMPONENT16),Z}function T(E,M){return A(E)===!0||E.isFramebufferTexture&&E.minFilter!==Cn&&E.minFilter!==Gn?Math.log2(Math.max(M.width,M.height))+1:E.mipmaps.length>0?E.mipmaps.length:E.isCompressedTexture&&Array.isArray(E.image)?M.mipmaps.length:1}function z(E){let M=new WeakRef(E);n.get(E).__ref=M,g.add(M),y.register(E,M,M)}function F(E){let M=n.get(E).__ref;M!==void 0&&(g.delete(M),y.unregister(M))}function D(E){$(E.target)}function q(E){I(E.target)}function $(E){E.removeEventListener("dispose",D),F(E),te(E),E.isVideoTexture&&h.delete(E),E.isHTMLTexture&&d.delete(E)}function I(E){E.removeEventListener("dispose",q),F(E),pe(E)}function V(){for(let E of g){let M=E.deref();M!==void 0&&(M.isRenderTarget===!0?I(M):$(M))}g.clear(),d.clear()}function te(E){let M=n.get(E);if(M.__webglInit===void 0)return;let Z=E.source,B=f.get(Z);if(B){let W=B[M.__cacheKey];W.usedTimes--,W.usedTimes===0&&k(E),Object.keys(B).length===0&&f.delete(Z)}n.remove(E)}function k(E){let M=n.get(E);i.deleteTexture(M.__webglTexture);let Z=E.source,B=f.get(Z);delete B[M.__cacheKey],o.memory.textures--}function pe(E){let M=n.get(E);M.__depthDisposeCallback&&M.__depthDisposeCallback();let Z=E.depthTexture;if(Z&&Z.renderTarget===E&&$(Z),E.isWebGLCubeRenderTarget)for(let W=0;W<6;W++){if(Array.isArray(M.__webglFramebuffer[W]))for(let ae=0;ae<M.__webglFramebuffer[W].length;ae++)i.deleteFramebuffer(M.__webglFramebuffer[W][ae]);else i.deleteFramebuffer(M.__webglFramebuffer[W]);M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer[W])}else{if(Array.isArray(M.__webglFramebuffer))for(let W=0;W<M.__webglFramebuffer.length;W++)i.deleteFramebuffer(M.__webglFramebuffer[W]);else i.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&i.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let W=0;W<M.__webglColorRenderbuffer.length;W++)M.__webglColorRenderbuffer[W]&&i.deleteRenderbuffer(M.__webglColorRenderbuffer[W]);M.__webglDepthRenderbuffer&&i.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let B=E.textures;for(let W=0,ae=B.length;W<ae;W++){let le=n.get(B[W]);le.__webglTexture&&(i.deleteTexture(le.__webglTexture),o.memory.textures--),n.remove(B[W])}n.remove(E)}let Q=0;function re(){Q=0}function ce(){return Q}function de(E){Q=E}function me(){let E=Q;return E>=s.maxTextures&&st("WebGLTextures: Trying to use "+(E+1)+" texture units while this GPU supports only "+s.maxTextures),Q+=1,E}function oe(E){let M=[];return M.push(E.wrapS),M.push(E.wrapT),M.push(E.wrapR||0),M.push(E.magFilter),M.push(E.minFilter),M.push(E.anisotropy),M.push(E.internalFormat),M.push(E.format),M.push(E.type),M.push(E.generateMipmaps),M.push(E.mipmapsAutoUpdate),M.push(E.premultiplyAlpha),M.push(E.flipY),M.push(E.unpackAlignment),M.push(E.colorSpace),M.join()}function be(E,M){let Z=n.get(E);if(E.isVideoTexture&&bt(E),E.isRenderTargetTexture===!1&&E.isExternalTexture!==!0&&E.version>0&&Z.__version!==E.version){let B=E.image;if(B===null)st("WebGLRenderer: Texture marked for update but no image data found.");else if(B.complete===!1)st("WebGLRenderer: Texture marked for update but image is incomplete");else{Ct(Z,E,M);return}}else E.isExternalTexture&&(Z.__webglTexture=E.sourceTexture?E.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,Z.__webglTexture,i.TEXTURE0+M)}function Ee(E,M){let Z=n.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&Z.__version!==E.version){Ct(Z,E,M);return}else E.isExternalTexture&&(Z.__webglTexture=E.sourceTexture?E.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,Z.__webglTexture,i.TEXTURE0+M)}function Ce(E,M){let Z=n.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&Z.__version!==E.version){Ct(Z,E,M);return}t.bindTexture(i.TEXTURE_3D,Z.__webglTexture,i.TEXTURE0+M)}function Te(E,M){let Z=n.get(E);if(E.version>0&&Z.__version!==E.version){Wt(Z,E,M);return}t.bindTexture(i.TEXTURE_CUBE_MAP,Z.__webglTexture,i.TEXTURE0+M)}let We={[ol]:i.REPEAT,[Vi]:i.CLAMP_TO_EDGE,[al]:i.MIRRORED_REPEAT},nt={[Cn]:i.NEAREST,[Jp]:i.NEAREST_MIPMAP_NEAREST,[qo]:i.NEAREST_MIPMAP_LINEAR,[Gn]:i.LINEAR,[Fl]:i.LINEAR_MIPMAP_NEAREST,[cs]:i.LINEAR_MIPMAP_LINEAR},qe={[em]:i.NEVER,[Cu]:i.ALWAYS,[tm]:i.LESS,[Tu]:i.LEQUAL,[nm]:i.EQUAL,[Au]:i.GEQUAL,[im]:i.GREATER,[sm]:i.NOTEQUAL};function ct(E,M){if(M.type===Pi&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===Gn||M.magFilter===Fl||M.magFilter===qo||M.magFilter===cs||M.minFilter===Gn||M.minFilter===Fl||M.minFilter===qo||M.minFilter===cs)&&st("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(E,i.TEXTURE_WRAP_S,We[M.wrapS]),i.texParameteri(E,i.TEXTURE_WRAP_T,We[M.wrapT]),(E===i.TEXTURE_3D||E===i.TEXTURE_2D_ARRAY)&&i.texParameteri(E,i.TEXTURE_WRAP_R,We[M.wrapR]),i.texParameteri(E,i.TEXTURE_MAG_FILTER,nt[M.magFilter]),i.texParameteri(E,i.TEXTURE_MIN_FILTER,nt[M.minFilter]),M.compareFunction&&(i.texParameteri(E,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(E,i.TEXTURE_COMPARE_FUNC,qe[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Cn||M.minFilter!==qo&&M.minFilter!==cs||M.type===Pi&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||n.get(M).__currentAnisotropy){let Z=e.get("EXT_texture_filter_anisotropic");i.texParameterf(E,Z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),n.get(M).__currentAnisotropy=M.anisotropy}}}function rt(E,M){let Z=!1;E.__webglInit===void 0&&(E.__webglInit=!0,M.addEventListener("dispose",D),z(M));let B=M.source,W=f.get(B);W===void 0&&(W={},f.set(B,W));let ae=oe(M);if(ae!==E.__cacheKey){W[ae]===void 0&&(W[ae]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Z=!0),W[ae].usedTimes++;let le=W[E.__cacheKey];le!==void 0&&(W[E.__cacheKey].usedTimes--,le.usedTimes===0&&k(M)),E.__cacheKey=ae,E.__webglTexture=W[ae].texture}return Z}function it(E,M,Z){return Math.floor(Math.floor(E/Z)/M)}function Dt(E,M,Z,B){let ae=E.updateRanges;if(ae.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,M.width,M.height,Z,B,M.data);else{ae.sort((N,j)=>N.start-j.start);let le=0;for(let N=1;N<ae.length;N++){let j=ae[le],ee=ae[N],ye=j.start+j.count,ge=it(ee.start,M.width,4),Ae=it(j.start,M.width,4);ee.start<=ye+1&&ge===Ae&&it(ee.start+ee.count-1,M.width,4)===ge?j.count=Math.max(j.count,ee.start+ee.count-j.start):(++le,ae[le]=ee)}ae.length=le+1;let K=t.getParameter(i.UNPACK_ROW_LENGTH),ne=t.getParameter(i.UNPACK_SKIP_PIXELS),he=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,M.width);for(let N=0,j=ae.length;N<j;N++){let ee=ae[N],ye=Math.floor(ee.start/4),ge=Math.ceil(ee.count/4),Ae=ye%M.width,Ye=Math.floor(ye/M.width),Je=ge,ue=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Ae),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ye),t.texSubImage2D(i.TEXTURE_2D,0,Ae,Ye,Je,ue,Z,B,M.data)}E.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,K),t.pixelStorei(i.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(i.UNPACK_SKIP_ROWS,he)}}function Ct(E,M,Z){let B=i.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(B=i.TEXTURE_2D_ARRAY),M.isData3DTexture&&(B=i.TEXTURE_3D);let W=rt(E,M),ae=M.source;t.bindTexture(B,E.__webglTexture,i.TEXTURE0+Z);let le=n.get(ae);if(ae.version!==le.__version||W===!0){if(t.activeTexture(i.TEXTURE0+Z),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ue=St.getPrimaries(St.workingColorSpace),Ne=M.colorSpace===us?null:St.getPrimaries(M.colorSpace),Fe=M.colorSpace===us||ue===Ne?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Fe)}t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment);let ne=v(M.image,!1,s.maxTextureSize);ne=Ve(M,ne);let he=r.convert(M.format,M.colorSpace),N=r.convert(M.type),j=C(M.internalFormat,he,N,M.normalized,M.colorSpace,M.isVideoTexture);ct(B,M);let ee,ye=M.mipmaps,ge=M.isVideoTexture!==!0,Ae=le.__version===void 0||W===!0,Ye=ae.dataReady,Je=T(M,ne);if(M.isDepthTexture)j=x(M.format===hs,M.type),Ae&&(ge?t.texStorage2D(i.TEXTURE_2D,1,j,ne.width,ne.height):t.texImage2D(i.TEXTURE_2D,0,j,ne.width,ne.height,0,he,N,null));else if(M.isDataTexture)if(ye.length>0){ge&&Ae&&t.texStorage2D(i.TEXTURE_2D,Je,j,ye[0].width,ye[0].height);for(let ue=0,Ne=ye.length;ue<Ne;ue++)ee=ye[ue],ge?Ye&&t.texSubImage2D(i.TEXTURE_2D,ue,0,0,ee.width,ee.height,he,N,ee.data):t.texImage2D(i.TEXTURE_2D,ue,j,ee.width,ee.height,0,he,N,ee.data);M.generateMipmaps=!1}else ge?(Ae&&t.texStorage2D(i.TEXTURE_2D,Je,j,ne.width,ne.height),Ye&&Dt(M,ne,he,N)):t.texImage2D(i.TEXTURE_2D,0,j,ne.width,ne.height,0,he,N,ne.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ge&&Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Je,j,ye[0].width,ye[0].height,ne.depth);for(let ue=0,Ne=ye.length;ue<Ne;ue++)if(ee=ye[ue],M.format!==Li)if(he!==null)if(ge){if(Ye)if(M.layerUpdates.size>0){let Fe=Nu(ee.width,ee.height,M.format,M.type);for(let we of M.layerUpdates){let tt=ee.data.subarray(we*Fe/ee.data.BYTES_PER_ELEMENT,(we+1)*Fe/ee.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ue,0,0,we,ee.width,ee.height,1,he,tt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ue,0,0,0,ee.width,ee.height,ne.depth,he,ee.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ue,j,ee.width,ee.height,ne.depth,0,ee.data,0,0);else st("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?Ye&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ue,0,0,0,ee.width,ee.height,ne.depth,he,N,ee.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ue,j,ee.width,ee.height,ne.depth,0,he,N,ee.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ge&&Ae&&t.texStorage2D(i.TEXTURE_2D,Je,j,ye[0].width,ye[0].height);for(let ue=0,Ne=ye.length;ue<Ne;ue++)ee=ye[ue],M.format!==Li?he!==null?ge?Ye&&t.compressedTexSubImage2D(i.TEXTURE_2D,ue,0,0,ee.width,ee.height,he,ee.data):t.compressedTexImage2D(i.TEXTURE_2D,ue,j,ee.width,ee.height,0,ee.data):st("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?Ye&&t.texSubImage2D(i.TEXTURE_2D,ue,0,0,ee.width,ee.height,he,N,ee.data):t.texImage2D(i.TEXTURE_2D,ue,j,ee.width,ee.height,0,he,N,ee.data)}else if(M.isDataArrayTexture)if(ge){if(Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Je,j,ne.width,ne.height,ne.depth),Ye)if(M.layerUpdates.size>0){let ue=Nu(ne.width,ne.height,M.format,M.type);for(let Ne of M.layerUpdates){let Fe=ne.data.subarray(Ne*ue/ne.data.BYTES_PER_ELEMENT,(Ne+1)*ue/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ne,ne.width,ne.height,1,he,N,Fe)}M.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,he,N,ne.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,j,ne.width,ne.height,ne.depth,0,he,N,ne.data);else if(M.isData3DTexture)ge?(Ae&&t.texStorage3D(i.TEXTURE_3D,Je,j,ne.width,ne.height,ne.depth),Ye&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,he,N,ne.data)):t.texImage3D(i.TEXTURE_3D,0,j,ne.width,ne.height,ne.depth,0,he,N,ne.data);else if(M.isFramebufferTexture){if(Ae)if(ge)t.texStorage2D(i.TEXTURE_2D,Je,j,ne.width,ne.height);else{let ue=ne.width,Ne=ne.height;for(let Fe=0;Fe<Je;Fe++)t.texImage2D(i.TEXTURE_2D,Fe,j,ue,Ne,0,he,N,null),ue>>=1,Ne>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in i){let ue=i.canvas;if(ue.hasAttribute("layoutsubtree")||ue.setAttribute("layoutsubtree","true"),ne.parentNode!==ue){ue.appendChild(ne),d.add(M),ue.onpaint=Ne=>{let Fe=Ne.changedElements;for(let we of d)Fe.includes(we.image)&&(we.needsUpdate=!0)},ue.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,ne);else{let Fe=i.RGBA,we=i.RGBA,tt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Fe,we,tt,ne)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ye.length>0){if(ge&&Ae){let ue=Ke(ye[0]);t.texStorage2D(i.TEXTURE_2D,Je,j,ue.width,ue.height)}for(let ue=0,Ne=ye.length;ue<Ne;ue++)ee=ye[ue],ge?Ye&&t.texSubImage2D(i.TEXTURE_2D,ue,0,0,he,N,ee):t.texImage2D(i.TEXTURE_2D,ue,j,he,N,ee);M.generateMipmaps=!1}else if(ge){if(Ae){let ue=Ke(ne);t.texStorage2D(i.TEXTURE_2D,Je,j,ue.width,ue.height)}Ye&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,he,N,ne)}else t.texImage2D(i.TEXTURE_2D,0,j,he,N,ne);A(M)&&M.mipmapsAutoUpdate===!0&&b(B),le.__version=ae.version,M.onUpdate&&M.onUpdate(M)}E.__version=M.version}function Wt(E,M,Z){if(M.image.length!==6)return;let B=rt(E,M),W=M.source;t.bindTexture(i.TEXTURE_CUBE_MAP,E.__webglTexture,i.TEXTURE0+Z);let ae=n.get(W);if(W.version!==ae.__version||B===!0){t.activeTexture(i.TEXTURE0+Z);let le=St.getPrimaries(St.workingColorSpace),K=M.colorSpace===us?null:St.getPrimaries(M.colorSpace),ne=M.colorSpace===us||le===K?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let he=M.isCompressedTexture||M.image[0].isCompressedTexture,N=M.image[0]&&M.image[0].isDataTexture,j=[];for(let we=0;we<6;we++)!he&&!N?j[we]=v(M.image[we],!0,s.maxCubemapSize):j[we]=N?M.image[we].image:M.image[we],j[we]=Ve(M,j[we]);let ee=j[0],ye=r.convert(M.format,M.colorSpace),ge=r.convert(M.type),Ae=C(M.internalFormat,ye,ge,M.normalized,M.colorSpace),Ye=M.isVideoTexture!==!0,Je=ae.__version===void 0||B===!0,ue=W.dataReady,Ne=T(M,ee);ct(i.TEXTURE_CUBE_MAP,M);let Fe;if(M.isDepthTexture){if(Ae=x(M.format===hs,M.type),Je)if(Ye)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ae,ee.width,ee.height);else for(let we=0;we<6;we++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,0,Ae,ee.width,ee.height,0,ye,ge,null)}else if(he){Ye&&Je&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ne,Ae,ee.width,ee.height);for(let we=0;we<6;we++){Fe=j[we].mipmaps;for(let tt=0;tt<Fe.length;tt++){let _t=Fe[tt];M.format!==Li?ye!==null?Ye?ue&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,tt,0,0,_t.width,_t.height,ye,_t.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,tt,Ae,_t.width,_t.height,0,_t.data):st("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ye?ue&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,tt,0,0,_t.width,_t.height,ye,ge,_t.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,tt,Ae,_t.width,_t.height,0,ye,ge,_t.data)}}}else{if(Fe=M.mipmaps,Ye&&Je){Fe.length>0&&Ne++;let we=Ke(j[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ne,Ae,we.width,we.height)}for(let we=0;we<6;we++)if(N){Ye?ue&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,0,0,0,j[we].width,j[we].height,ye,ge,j[we].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,0,Ae,j[we].width,j[we].height,0,ye,ge,j[we].data);for(let tt=0;tt<Fe.length;tt++){let fn=Fe[tt].image[we].image;Ye?ue&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,tt+1,0,0,fn.width,fn.height,ye,ge,fn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,tt+1,Ae,fn.width,fn.height,0,ye,ge,fn.data)}}else{Ye?ue&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,0,0,0,ye,ge,j[we]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,0,Ae,ye,ge,j[we]);for(let tt=0;tt<Fe.length;tt++){let _t=Fe[tt];Ye?ue&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,tt+1,0,0,ye,ge,_t.image[we]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,tt+1,Ae,ye,ge,_t.image[we])}}}A(M)&&M.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),ae.__version=W.version,M.onUpdate&&M.onUpdate(M)}E.__version=M.version}function Mt(E,M,Z,B,W,ae){let le=r.convert(Z.format,Z.colorSpace),K=r.convert(Z.type),ne=C(Z.internalFormat,le,K,Z.normalized,Z.colorSpace),he=n.get(M),N=n.get(Z);if(N.__renderTarget=M,!he.__hasExternalTextures){let j=Math.max(1,M.width>>ae),ee=Math.max(1,M.height>>ae);W===i.TEXTURE_3D||W===i.TEXTURE_2D_ARRAY?t.texImage3D(W,ae,ne,j,ee,M.depth,0,le,K,null):t.texImage2D(W,ae,ne,j,ee,0,le,K,null)}t.bindFramebuffer(i.FRAMEBUFFER,E),Re(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,B,W,N.__webglTexture,0,ot(M)):(W===i.TEXTURE_2D||W>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&W<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,B,W,N.__webglTexture,ae),t.bindFramebuffer(i.FRAMEBUFFER,null)}function rn(E,M,Z){if(i.bindRenderbuffer(i.RENDERBUFFER,E),M.depthBuffer){let B=M.depthTexture,W=B&&B.isDepthTexture?B.type:null,ae=x(M.stencilBuffer,W),le=M.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Re(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ot(M),ae,M.width,M.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,ot(M),ae,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,ae,M.width,M.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,E)}else{let B=M.textures;for(let W=0;W<B.length;W++){let ae=B[W],le=r.convert(ae.format,ae.colorSpace),K=r.convert(ae.type),ne=C(ae.internalFormat,le,K,ae.normalized,ae.colorSpace);Re(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ot(M),ne,M.width,M.height):Z?i.renderbufferStorageMultisample(i.RENDERBUFFER,ot(M),ne,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,ne,M.width,M.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function pt(E,M,Z){let B=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,E),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let W=n.get(M.depthTexture);W.__renderTarget=M;let ae=B?M.depthTexture.image[0]:M.depthTexture.image;(!W.__webglTexture||ae.width!==M.width||ae.height!==M.height)&&(ae.width=M.width,ae.height=M.height,M.depthTexture.needsUpdate=!0),B?Te(M.depthTexture,0):be(M.depthTexture,0);let le=W.__webglTexture,K=ot(M),ne=B?i.TEXTURE_CUBE_MAP_POSITIVE_X+Z:i.TEXTURE_2D,he=M.depthTexture.format===hs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(M.depthTexture.format===as)Re(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,he,ne,le,0,K):i.framebufferTexture2D(i.FRAMEBUFFER,he,ne,le,0);else if(M.depthTexture.format===hs)Re(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,he,ne,le,0,K):i.framebufferTexture2D(i.FRAMEBUFFER,he,ne,le,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function kt(E){let M=n.get(E),Z=E.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==E.depthTexture){let B=E.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),B){let W=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,B.removeEventListener("dispose",W)};B.addEventListener("dispose",W),M.__depthDisposeCallback=W}M.__boundDepthTexture=B}if(E.depthTexture&&!M.__autoAllocateDepthBuffer)if(Z)for(let B=0;B<6;B++)pt(M.__webglFramebuffer[B],E,B);else E.texture.mipmaps.length>0?pt(M.__webglFramebuffer[0],E,0):pt(M.__webglFramebuffer,E,0);else if(Z){M.__webglDepthbuffer=[];for(let B=0;B<6;B++)if(t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[B]),M.__webglDepthbuffer[B]===void 0)M.__webglDepthbuffer[B]=i.createRenderbuffer(),rn(M.__webglDepthbuffer[B],E,!1);else{let W=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ae=M.__webglDepthbuffer[B];i.bindRenderbuffer(i.RENDERBUFFER,ae),i.framebufferRenderbuffer(i.FRAMEBUFFER,W,i.RENDERBUFFER,ae)}}else if(E.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=i.createRenderbuffer(),rn(M.__webglDepthbuffer,E,!1);else{let W=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ae=M.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ae),i.framebufferRenderbuffer(i.FRAMEBUFFER,W,i.RENDERBUFFER,ae)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Vt(E,M,Z){let B=n.get(E);M!==void 0&&Mt(B.__webglFramebuffer,E,E.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Z!==void 0&&kt(E)}function Xt(E){let M=E.texture,Z=n.get(E),B=n.get(M);E.addEventListener("dispose",q),z(E);let W=E.textures,ae=E.isWebGLCubeRenderTarget===!0,le=W.length>1;if(le||(B.__webglTexture===void 0&&(B.__webglTexture=i.createTexture()),B.__version=M.version,o.memory.textures++),ae){Z.__webglFramebuffer=[];for(let K=0;K<6;K++)if(M.mipmaps.length>0){Z.__webglFramebuffer[K]=[];for(let ne=0;ne<M.mipmaps.length;ne++)Z.__webglFramebuffer[K][ne]=i.createFramebuffer()}else Z.__webglFramebuffer[K]=i.createFramebuffer()}else{if(M.mipmaps.length>0){Z.__webglFramebuffer=[];for(let K=0;K<M.mipmaps.length;K++)Z.__webglFramebuffer[K]=i.createFramebuffer()}else Z.__webglFramebuffer=i.createFramebuffer();if(le)for(let K=0,ne=W.length;K<ne;K++){let he=n.get(W[K]);he.__webglTexture===void 0&&(he.__webglTexture=i.createTexture(),o.memory.textures++)}if(E.samples>0&&Re(E)===!1){Z.__webglMultisampledFramebuffer=i.createFramebuffer(),Z.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,Z.__webglMultisampledFramebuffer);for(let K=0;K<W.length;K++){let ne=W[K];Z.__webglColorRenderbuffer[K]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Z.__webglColorRenderbuffer[K]);let he=r.convert(ne.format,ne.colorSpace),N=r.convert(ne.type),j=C(ne.internalFormat,he,N,ne.normalized,ne.colorSpace,E.isXRRenderTarget===!0),ee=ot(E);i.renderbufferStorageMultisample(i.RENDERBUFFER,ee,j,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+K,i.RENDERBUFFER,Z.__webglColorRenderbuffer[K])}i.bindRenderbuffer(i.RENDERBUFFER,null),E.depthBuffer&&(Z.__webglDepthRenderbuffer=i.createRenderbuffer(),rn(Z.__webglDepthRenderbuffer,E,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ae){t.bindTexture(i.TEXTURE_CUBE_MAP,B.__webglTexture),ct(i.TEXTURE_CUBE_MAP,M);for(let K=0;K<6;K++)if(M.mipmaps.length>0)for(let ne=0;ne<M.mipmaps.length;ne++)Mt(Z.__webglFramebuffer[K][ne],E,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+K,ne);else Mt(Z.__webglFramebuffer[K],E,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+K,0);A(M)?b(i.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(le){for(let K=0,ne=W.length;K<ne;K++){let he=W[K],N=n.get(he),j=i.TEXTURE_2D;(E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(j=E.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(j,N.__webglTexture),ct(j,he),Mt(Z.__webglFramebuffer,E,he,i.COLOR_ATTACHMENT0+K,j,0),A(he)&&b(j)}t.unbindTexture()}else{let K=i.TEXTURE_2D;if((E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(K=E.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(K,B.__webglTexture),ct(K,M),M.mipmaps.length>0)for(let ne=0;ne<M.mipmaps.length;ne++)Mt(Z.__webglFramebuffer[ne],E,M,i.COLOR_ATTACHMENT0,K,ne);else Mt(Z.__webglFramebuffer,E,M,i.COLOR_ATTACHMENT0,K,0);A(M)?b(K):M.mipmaps.length>0&&i.texParameteri(K,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}E.depthBuffer&&kt(E)}function O(E){let M=E.textures;for(let Z=0,B=M.length;Z<B;Z++){let W=M[Z];if(A(W)&&W.mipmapsAutoUpdate===!0){let ae=P(E),le=n.get(W).__webglTexture;t.bindTexture(ae,le),b(ae),t.unbindTexture()}}}let Ie=[];function et(E){if(E.samples>0){if(Re(E)===!1){let M=E.textures,Z=E.width,B=E.height,W=i.COLOR_BUFFER_BIT,ae=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,le=n.get(E),K=M.length>1;if(K)for(let he=0;he<M.length;he++)t.bindFramebuffer(i.FRAMEBUFFER,le.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+he,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,le.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+he,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,le.__webglMultisampledFramebuffer),E.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,le.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,le.__webglFramebuffer);for(let he=0;he<M.length;he++){if(E.resolveDepthBuffer&&(E.depthBuffer&&(W|=i.DEPTH_BUFFER_BIT),E.stencilBuffer&&E.resolveStencilBuffer&&(W|=i.STENCIL_BUFFER_BIT)),K){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,le.__webglColorRenderbuffer[he]);let N=n.get(M[he]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,N,0)}i.blitFramebuffer(0,0,Z,B,0,0,Z,B,W,i.NEAREST),l===!0&&(Ie.length=0,Ie.push(i.COLOR_ATTACHMENT0+he),E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&Ie.push(ae),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),K)for(let he=0;he<M.length;he++){t.bindFramebuffer(i.FRAMEBUFFER,le.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+he,i.RENDERBUFFER,le.__webglColorRenderbuffer[he]);let N=n.get(M[he]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,le.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+he,i.TEXTURE_2D,N,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,le.__webglMultisampledFramebuffer)}else if(E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&l){let M=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[M])}}}function ot(E){return Math.min(s.maxSamples,E.samples)}function Re(E){let M=n.get(E);return E.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function bt(E){let M=o.render.frame;h.get(E)!==M&&(h.set(E,M),E.update())}function Ve(E,M){let Z=E.colorSpace,B=E.format,W=E.type;return E.isCompressedTexture===!0||E.isVideoTexture===!0||Z!==Ao&&Z!==us&&(St.getTransfer(Z)===Bt?(B!==Li||W!==ui)&&st("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ht("WebGLTextures: Unsupported texture color space:",Z)),M}function Ke(E){return typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement?(c.width=E.naturalWidth||E.width,c.height=E.naturalHeight||E.height):typeof VideoFrame<"u"&&E instanceof VideoFrame?(c.width=E.displayWidth,c.height=E.displayHeight):(c.width=E.width,c.height=E.height),c}this.allocateTextureUnit=me,this.resetTextureUnits=re,this.getTextureUnits=ce,this.setTextureUnits=de,this.setTexture2D=be,this.setTexture2DArray=Ee,this.setTexture3D=Ce,this.setTextureCube=Te,this.rebindTextures=Vt,this.setupRenderTarget=Xt,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=et,this.setupDepthRenderbuffer=kt,this.setupFrameBufferTexture=Mt,this.useMultisampledRTT=Re,this.dispose=V}function jM(i,e){function t(n,s=us){let r,o=St.getTransfer(s);if(n===ui)return i.UNSIGNED_BYTE;if(n===Bl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===kl)return i.UNSIGNED_SHORT_5_5_5_1;if(n===yu)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Su)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===xu)return i.BYTE;if(n===vu)return i.SHORT;if(n===to)return i.UNSIGNED_SHORT;if(n===Ol)return i.INT;if(n===Ri)return i.UNSIGNED_INT;if(n===Pi)return i.FLOAT;if(n===Ii)return i.HALF_FLOAT;if(n===Mu)return i.ALPHA;if(n===bu)return i.RGB;if(n===Li)return i.RGBA;if(n===as)return i.DEPTH_COMPONENT;if(n===hs)return i.DEPTH_STENCIL;if(n===wu)return i.RED;if(n===zl)return i.RED_INTEGER;if(n===Bs)return i.RG;if(n===Vl)return i.RG_INTEGER;if(n===Gl)return i.RGBA_INTEGER;if(n===Yo||n===$o||n===Zo||n===Jo)if(o===Bt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Yo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===$o)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Zo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Jo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Yo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===$o)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Zo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Jo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Hl||n===Wl||n===Xl||n===ql)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Hl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Wl)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Xl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ql)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Yl||n===$l||n===Zl||n===Jl||n===Kl||n===Ko||n===jl)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Yl||n===$l)return o===Bt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Zl)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Jl)return r.COMPRESSED_R11_EAC;if(n===Kl)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ko)return r.COMPRESSED_RG11_EAC;if(n===jl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Ql||n===ec||n===tc||n===nc||n===ic||n===sc||n===rc||n===oc||n===ac||n===lc||n===cc||n===hc||n===uc||n===dc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Ql)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ec)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===tc)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===nc)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ic)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===sc)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===rc)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===oc)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===ac)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===lc)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===cc)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===hc)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===uc)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===dc)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===fc||n===pc||n===mc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===fc)return o===Bt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===pc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===mc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===gc||n===_c||n===jo||n===xc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===gc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===_c)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===jo)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===xc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===or?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var QM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,eb=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Hu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new zo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new vi({vertexShader:QM,fragmentShader:eb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Xi(new Vo(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Wu=class extends Gi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,g=null,y=typeof XRWebGLBinding<"u",m=new Hu,p={},v=t.getContextAttributes(),A=null,b=null,P=[],C=[],x=new Tt,T=null,z=null,F=new ai;F.viewport=new sn;let D=new ai;D.viewport=new sn;let q=[F,D],$=new Dl,I=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(oe){let be=P[oe];return be===void 0&&(be=new $r,P[oe]=be),be.getTargetRaySpace()},this.getControllerGrip=function(oe){let be=P[oe];return be===void 0&&(be=new $r,P[oe]=be),be.getGripSpace()},this.getHand=function(oe){let be=P[oe];return be===void 0&&(be=new $r,P[oe]=be),be.getHandSpace()};function te(oe){let be=C.indexOf(oe.inputSource);if(be===-1)return;let Ee=P[be];Ee!==void 0&&(Ee.update(oe.inputSource,oe.frame,c||o),Ee.dispatchEvent({type:oe.type,data:oe.inputSource}))}function k(){s.removeEventListener("select",te),s.removeEventListener("selectstart",te),s.removeEventListener("selectend",te),s.removeEventListener("squeeze",te),s.removeEventListener("squeezestart",te),s.removeEventListener("squeezeend",te),s.removeEventListener("end",k),s.removeEventListener("inputsourceschange",pe);for(let oe=0;oe<P.length;oe++){let be=C[oe];be!==null&&(C[oe]=null,P[oe].disconnect(be))}I=null,V=null,m.reset();for(let oe in p)delete p[oe];if(e.setRenderTarget(A),f=null,u=null,d=null,s=null,b=null,me.stop(),n.isPresenting=!1,e.setPixelRatio(T),e.setSize(x.width,x.height,!1),z!==null){let oe=z.camera;oe.fov=z.fov,oe.zoom=z.zoom,oe.updateProjectionMatrix(),z=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(oe){r=oe,n.isPresenting===!0&&st("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(oe){a=oe,n.isPresenting===!0&&st("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(oe){c=oe},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&y&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(oe){if(s=oe,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",te),s.addEventListener("selectstart",te),s.addEventListener("selectend",te),s.addEventListener("squeeze",te),s.addEventListener("squeezestart",te),s.addEventListener("squeezeend",te),s.addEventListener("end",k),s.addEventListener("inputsourceschange",pe),v.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let Ee=null,Ce=null,Te=null;v.depth&&(Te=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Ee=v.stencil?hs:as,Ce=v.stencil?or:Ri);let We={colorFormat:t.RGBA8,depthFormat:Te,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(We),s.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),b=new li(u.textureWidth,u.textureHeight,{format:Li,type:ui,depthTexture:new ls(u.textureWidth,u.textureHeight,Ce,void 0,void 0,void 0,void 0,void 0,void 0,Ee),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let Ee={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,Ee),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new li(f.framebufferWidth,f.framebufferHeight,{format:Li,type:ui,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),me.setContext(s),me.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function pe(oe){for(let be=0;be<oe.removed.length;be++){let Ee=oe.removed[be],Ce=C.indexOf(Ee);Ce>=0&&(C[Ce]=null,P[Ce].disconnect(Ee))}for(let be=0;be<oe.added.length;be++){let Ee=oe.added[be],Ce=C.indexOf(Ee);if(Ce===-1){for(let We=0;We<P.length;We++)if(We>=C.length){C.push(Ee),Ce=We;break}else if(C[We]===null){C[We]=Ee,Ce=We;break}if(Ce===-1)break}let Te=P[Ce];Te&&Te.connect(Ee)}}function Q(oe,be){be===null?oe.matrixWorld.copy(oe.matrix):oe.matrixWorld.multiplyMatrices(be.matrixWorld,oe.matrix),oe.matrixWorldInverse.copy(oe.matrixWorld).invert()}this.updateCamera=function(oe){if(s===null)return;let be=oe.near,Ee=oe.far;m.texture!==null&&(m.depthNear>0&&(be=m.depthNear),m.depthFar>0&&(Ee=m.depthFar)),$.near=D.near=F.near=be,$.far=D.far=F.far=Ee,(I!==$.near||V!==$.far)&&(s.updateRenderState({depthNear:$.near,depthFar:$.far}),I=$.near,V=$.far),$.layers.mask=oe.layers.mask|6,F.layers.mask=$.layers.mask&-5,D.layers.mask=$.layers.mask&-3;let Ce=oe.parent,Te=$.cameras;Q($,Ce);for(let We=0;We<Te.length;We++)Q(Te[We],Ce);$.projectionMatrix.copy(F.projectionMatrix),$.projectionMatrixInverse.copy(F.projectionMatrixInverse),z===null&&oe.isPerspectiveCamera&&(z={camera:oe,fov:oe.fov,zoom:oe.zoom}),re(oe,$,Ce)};function re(oe,be,Ee){Ee===null?oe.matrix.copy(be.matrixWorld):(oe.matrix.copy(Ee.matrixWorld),oe.matrix.invert(),oe.matrix.multiply(be.matrixWorld)),oe.matrix.decompose(oe.position,oe.quaternion,oe.scale),oe.updateMatrixWorld(!0),oe.projectionMatrix.copy(be.projectionMatrix),oe.projectionMatrixInverse.copy(be.projectionMatrixInverse),oe.isPerspectiveCamera&&(oe.fov=cl*2*Math.atan(1/oe.projectionMatrix.elements[5]),oe.zoom=1)}this.getCamera=function(){return $},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(oe){l=oe,u!==null&&(u.fixedFoveation=oe),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=oe)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh($)},this.getCameraTexture=function(oe){return p[oe]};let ce=null;function de(oe,be){if(h=be.getViewerPose(c||o),g=be,h!==null){let Ee=h.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Ce=!1;Ee.length!==$.cameras.length&&($.cameras.length=0,Ce=!0);for(let qe=0;qe<Ee.length;qe++){let ct=Ee[qe],rt=null;if(f!==null)rt=f.getViewport(ct);else{let Dt=d.getViewSubImage(u,ct);rt=Dt.viewport,qe===0&&(e.setRenderTargetTextures(b,Dt.colorTexture,Dt.depthStencilTexture),e.setRenderTarget(b))}let it=q[qe];it===void 0&&(it=new ai,it.layers.enable(qe),it.viewport=new sn,q[qe]=it),it.matrix.fromArray(ct.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(ct.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(rt.x,rt.y,rt.width,rt.height),qe===0&&($.matrix.copy(it.matrix),$.matrix.decompose($.position,$.quaternion,$.scale)),Ce===!0&&$.cameras.push(it)}let Te=s.enabledFeatures;if(Te&&Te.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){d=n.getBinding();let qe=d.getDepthInformation(Ee[0]);qe&&qe.isValid&&qe.texture&&m.init(qe,s.renderState)}if(Te&&Te.includes("camera-access")&&y){e.state.unbindTexture(),d=n.getBinding();for(let qe=0;qe<Ee.length;qe++){let ct=Ee[qe].camera;if(ct){let rt=p[ct];rt||(rt=new zo,p[ct]=rt);let it=d.getCameraImage(ct);rt.sourceTexture=it}}}}for(let Ee=0;Ee<P.length;Ee++){let Ce=C[Ee],Te=P[Ee];Ce!==null&&Te!==void 0&&Te.update(Ce,be,c||o)}ce&&ce(oe,be),be.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:be}),g=null}let me=new Fm;me.setAnimationLoop(de),this.setAnimationLoop=function(oe){ce=oe},this.dispose=function(){}}},tb=new an,qm=new dt;qm.set(-1,0,0,0,1,0,0,0,1);function nb(i,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,Iu(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,v,A,b){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),d(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),u(m,p),p.isMeshPhysicalMaterial&&f(m,p,b)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),y(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,v,A):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Hn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Hn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let v=e.get(p),A=v.envMap,b=v.envMapRotation;A&&(m.envMap.value=A,m.envMapRotation.value.setFromMatrix4(tb.makeRotationFromEuler(b)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(qm),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,v,A){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*v,m.scale.value=A*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function d(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function u(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,v){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Hn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function y(m,p){let v=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function ib(i,e,t,n){let s={},r={};function o(v,A){let b=A.program;n.uniformBlockBinding(v,b,s[v.id])}function a(v,A){let b=s[v.id];b===void 0&&(g(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",m));let P=A.program;n.updateUBOMapping(v,P);let C=e.render.frame;r[v.id]!==C&&(c(v),r[v.id]=C)}function l(v){let A=i.createBuffer(),b=v.__size,P=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,b,P),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function c(v){let A=s[v.id],b=v.uniforms,P=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let C=0,x=b.length;C<x;C++){let T=b[C];if(Array.isArray(T))for(let z=0,F=T.length;z<F;z++)h(T[z],C,z,P);else h(T,C,0,P)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,A,b,P){if(u(v,A,b,P)===!0){let C=v.__offset,x=v.value;if(Array.isArray(x)){let T=0;for(let z=0;z<x.length;z++){let F=x[z],D=y(F,!0);d(F,v.__data,T),T+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else d(x,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,C,v.__data)}}function d(v,A,b){typeof v=="number"||typeof v=="boolean"?A[b]=v:v.isMatrix3?(A[b]=v.elements[0],A[b+1]=v.elements[1],A[b+2]=v.elements[2],A[b+3]=0,A[b+4]=v.elements[3],A[b+5]=v.elements[4],A[b+6]=v.elements[5],A[b+7]=0,A[b+8]=v.elements[6],A[b+9]=v.elements[7],A[b+10]=v.elements[8],A[b+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-b),b):v.toArray(A,b)}function u(v,A,b,P){let C=v.value,x=A+"_"+b;if(Array.isArray(C)){P[x]===void 0&&(P[x]=[]);let T=P[x],z=!1;for(let F=0;F<C.length;F++)f(C[F],T,F)===!0&&(z=!0);return z}return f(C,P,x)}function f(v,A,b){if(A[b]===void 0)return typeof v=="number"||typeof v=="boolean"?A[b]=v:ArrayBuffer.isView(v)?A[b]=v.slice():A[b]=v.clone(),!0;{let P=A[b];if(typeof v=="number"||typeof v=="boolean"){if(P!==v)return A[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(P.equals(v)===!1)return P.copy(v),!0}}return!1}function g(v){let A=v.uniforms,b=0,P=16;for(let x=0,T=A.length;x<T;x++){let z=Array.isArray(A[x])?A[x]:[A[x]];for(let F=0,D=z.length;F<D;F++){let q=z[F],$=Array.isArray(q.value)?q.value:[q.value],I=Array.isArray(A[x])||Array.isArray(q.value),V=b;for(let k=0,pe=$.length;k<pe;k++){let Q=$[k],re=y(Q,I),ce=b%P,de=ce%re.boundary,me=ce+de;b+=de,me!==0&&P-me<re.storage&&(b+=P-me),k===0&&(V=b),b+=re.storage}let te=q.type==="int"?Int32Array:q.type==="uint"?Uint32Array:Float32Array;q.__data=new te((b-V)/Float32Array.BYTES_PER_ELEMENT),q.__offset=V}}let C=b%P;return C>0&&(b+=P-C),v.__size=b,v.__cache={},this}function y(v,A){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?st("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):st("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(v){let A=v.target;A.removeEventListener("dispose",m),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function p(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:p}}var sb=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),$i=null;function rb(){return $i===null&&($i=new pl(sb,16,16,Bs,Ii),$i.name="DFG_LUT",$i.minFilter=Gn,$i.magFilter=Gn,$i.wrapS=Vi,$i.wrapT=Vi,$i.generateMipmaps=!1,$i.needsUpdate=!0),$i}var Mc=class{constructor(e={}){let{canvas:t=om(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=ui}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let y=f,m=new Set([Gl,Vl,zl]),p=new Set([ui,Ri,to,or,Bl,kl]),v=new Uint32Array(4),A=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},P=null,C=null,x=[],T=[],z=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Yi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let F=this,D=!1,q=null,$=null,I=null,V=null;this._outputColorSpace=oi;let te=0,k=0,pe=null,Q=-1,re=null,ce=new sn,de=new sn,me=null,oe=new At(0),be=0,Ee=t.width,Ce=t.height,Te=1,We=null,nt=null,qe=new sn(0,0,Ee,Ce),ct=new sn(0,0,Ee,Ce),rt=!1,it=new nr,Dt=new ml,Ct=!1,Wt=!1,Mt=new an,rn=new se,pt=new sn,kt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Vt=!1;function Xt(){return pe===null?Te:1}let O=n;function Ie(S,U){return t.getContext(S,U)}let et,ot,Re,bt,Ve,Ke,E,M,Z,B,W,ae,le,K,ne,he,N,j,ee,ye,ge,Ae,Ye;try{let S={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ne,!1),t.addEventListener("webglcontextrestored",Fe,!1),t.addEventListener("webglcontextcreationerror",we,!1),O===null){let U="webgl2";if(O=Ie(U,S),O===null)throw Ie(U)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(S){throw t.removeEventListener("webglcontextlost",Ne,!1),t.removeEventListener("webglcontextrestored",Fe,!1),t.removeEventListener("webglcontextcreationerror",we,!1),ht("WebGLRenderer: "+S.message),S}function Je(){et=new gS(O),et.init(),ge=new jM(O,et),ot=new rS(O,et,e,ge),Re=new JM(O,et),ot.reversedDepthBuffer&&u&&Re.buffers.depth.setReversed(!0),$=O.createFramebuffer(),I=O.createFramebuffer(),V=O.createFramebuffer(),bt=new vS(O),Ve=new FM,Ke=new KM(O,et,Re,Ve,ot,ge,bt),E=new mS(F),M=new Sx(O),Ae=new iS(O,M),Z=new _S(O,M,bt,Ae),B=new SS(O,Z,M,Ae,bt),j=new yS(O,ot,Ke),ne=new oS(Ve),W=new UM(F,E,et,ot,Ae,ne),ae=new nb(F,Ve),le=new BM,K=new WM(et),N=new nS(F,E,Re,B,g,l),he=new ZM(F,B,ot),Ye=new ib(O,bt,ot,Re),ee=new sS(O,et,bt),ye=new xS(O,et,bt),bt.programs=W.programs,F.capabilities=ot,F.extensions=et,F.properties=Ve,F.renderLists=le,F.shadowMap=he,F.state=Re,F.info=bt}y!==ui&&(z=new bS(y,t.width,t.height,a,s,r));let ue=new Wu(F,O);this.xr=ue,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let S=et.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=et.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return Te},this.setPixelRatio=function(S){S!==void 0&&(Te=S,this.setSize(Ee,Ce,!1))},this.getSize=function(S){return S.set(Ee,Ce)},this.setSize=function(S,U,H=!0){if(ue.isPresenting){st("WebGLRenderer: Can't change size while VR device is presenting.");return}Ee=S,Ce=U,t.width=Math.floor(S*Te),t.height=Math.floor(U*Te),H===!0&&(t.style.width=S+"px",t.style.height=U+"px"),z!==null&&z.setSize(t.width,t.height),this.setViewport(0,0,S,U)},this.getDrawingBufferSize=function(S){return S.set(Ee*Te,Ce*Te).floor()},this.setDrawingBufferSize=function(S,U,H){Ee=S,Ce=U,Te=H,t.width=Math.floor(S*H),t.height=Math.floor(U*H),this.setViewport(0,0,S,U)},this.setEffects=function(S){if(y===ui){ht("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(S){for(let U=0;U<S.length;U++)if(S[U].isOutputPass===!0){st("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}z.setEffects(S||[])},this.getCurrentViewport=function(S){return S.copy(ce)},this.getViewport=function(S){return S.copy(qe)},this.setViewport=function(S,U,H,Y){S.isVector4?qe.set(S.x,S.y,S.z,S.w):qe.set(S,U,H,Y),Re.viewport(ce.copy(qe).multiplyScalar(Xt()).round())},this.getScissor=function(S){return S.copy(ct)},this.setScissor=function(S,U,H,Y){S.isVector4?ct.set(S.x,S.y,S.z,S.w):ct.set(S,U,H,Y),Re.scissor(de.copy(ct).multiplyScalar(Xt()).round())},this.getScissorTest=function(){return rt},this.setScissorTest=function(S){Re.setScissorTest(rt=S)},this.setOpaqueSort=function(S){We=S},this.setTransparentSort=function(S){nt=S},this.getClearColor=function(S){return S.copy(N.getClearColor())},this.setClearColor=function(){N.setClearColor(...arguments)},this.getClearAlpha=function(){return N.getClearAlpha()},this.setClearAlpha=function(){N.setClearAlpha(...arguments)},this.clear=function(S=!0,U=!0,H=!0){let Y=0;if(S){let J=!1;if(pe!==null){let xe=pe.texture.format;J=m.has(xe)}if(J){let xe=pe.texture.type,ve=p.has(xe),Se=N.getClearColor(),Le=N.getClearAlpha(),Be=Se.r,je=Se.g,at=Se.b;ve?(v[0]=Be,v[1]=je,v[2]=at,v[3]=Le,O.clearBufferuiv(O.COLOR,0,v)):(A[0]=Be,A[1]=je,A[2]=at,A[3]=Le,O.clearBufferiv(O.COLOR,0,A))}else Y|=O.COLOR_BUFFER_BIT}U&&(Y|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),H&&(Y|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&O.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(S){S.setRenderer(this),q=S},this.dispose=function(){t.removeEventListener("webglcontextlost",Ne,!1),t.removeEventListener("webglcontextrestored",Fe,!1),t.removeEventListener("webglcontextcreationerror",we,!1),N.dispose(),le.dispose(),K.dispose(),Ke.dispose(),Ve.dispose(),E.dispose(),B.dispose(),Z.dispose(),Ae.dispose(),Ye.dispose(),W.dispose(),ue.dispose(),ue.removeEventListener("sessionstart",zs),ue.removeEventListener("sessionend",Pn),Wn.stop()};function Ne(S){S.preventDefault(),Ru("WebGLRenderer: Context Lost."),D=!0}function Fe(){Ru("WebGLRenderer: Context Restored."),D=!1;let S=bt.autoReset,U=he.enabled,H=he.autoUpdate,Y=he.needsUpdate,J=he.type;Je(),bt.autoReset=S,he.enabled=U,he.autoUpdate=H,he.needsUpdate=Y,he.type=J}function we(S){ht("WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function tt(S){let U=S.target;U.removeEventListener("dispose",tt),_t(U)}function _t(S){fn(S),Ve.remove(S)}function fn(S){let U=Ve.get(S).programs;U!==void 0&&(U.forEach(function(H){W.releaseProgram(H)}),S.isShaderMaterial&&W.releaseShaderCache(S))}this.renderBufferDirect=function(S,U,H,Y,J,xe){U===null&&(U=kt);let ve=J.isMesh&&J.matrixWorld.determinantAffine()<0,Se=_e(S,U,H,Y,J);Re.setMaterial(Y,ve);let Le=H.index,Be=1;if(Y.wireframe===!0){if(Le=Z.getWireframeAttribute(H),Le===void 0)return;Be=2}let je=H.drawRange,at=H.attributes.position,ke=je.start*Be,ut=(je.start+je.count)*Be;xe!==null&&(ke=Math.max(ke,xe.start*Be),ut=Math.min(ut,(xe.start+xe.count)*Be)),Le!==null?(ke=Math.max(ke,0),ut=Math.min(ut,Le.count)):at!=null&&(ke=Math.max(ke,0),ut=Math.min(ut,at.count));let Zt=ut-ke;if(Zt<0||Zt===1/0)return;Ae.setup(J,Y,Se,H,Le);let Et,Rt=ee;if(Le!==null&&(Et=M.get(Le),Rt=ye,Rt.setIndex(Et)),J.isMesh)Y.wireframe===!0?(Re.setLineWidth(Y.wireframeLinewidth*Xt()),Rt.setMode(O.LINES)):Rt.setMode(O.TRIANGLES);else if(J.isLine){let qt=Y.linewidth;qt===void 0&&(qt=1),Re.setLineWidth(qt*Xt()),J.isLineSegments?Rt.setMode(O.LINES):J.isLineLoop?Rt.setMode(O.LINE_LOOP):Rt.setMode(O.LINE_STRIP)}else J.isPoints?Rt.setMode(O.POINTS):J.isSprite&&Rt.setMode(O.TRIANGLES);if(J.isBatchedMesh)if(et.get("WEBGL_multi_draw"))Rt.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let qt=J._multiDrawStarts,He=J._multiDrawCounts,ln=J._multiDrawCount,vt=Le?M.get(Le).bytesPerElement:1,Ji=Ve.get(Y).currentProgram.getUniforms();for(let pn=0;pn<ln;pn++)Ji.setValue(O,"_gl_DrawID",pn),Rt.render(qt[pn]/vt,He[pn])}else if(J.isInstancedMesh)Rt.renderInstances(ke,Zt,J.count);else if(H.isInstancedBufferGeometry){let qt=H._maxInstanceCount!==void 0?H._maxInstanceCount:1/0,He=Math.min(H.instanceCount,qt);Rt.renderInstances(ke,Zt,He)}else Rt.render(ke,Zt)};function ks(S,U,H,Y){q!==null&&S.isNodeMaterial&&q.setObject(Y,S),Ct===!0&&ne.setState(S,H,!1),S.transparent===!0&&S.side===qi&&S.forceSinglePass===!1?(S.side=Hn,S.needsUpdate=!0,Kn(S,U,Y),S.side=Os,S.needsUpdate=!0,Kn(S,U,Y),S.side=qi):Kn(S,U,Y)}this.compile=function(S,U,H=null){H===null&&(H=S),q!==null&&q.renderStart(S,U,H),C=K.get(H),C.init(U),T.push(C),H.traverseVisible(function(J){J.isLight&&J.layers.test(U.layers)&&(C.pushLight(J),J.castShadow&&C.pushShadow(J))}),S!==H&&S.traverseVisible(function(J){J.isLight&&J.layers.test(U.layers)&&(C.pushLight(J),J.castShadow&&C.pushShadow(J))}),C.setupLights(),q!==null&&q.updateLights(C.state.lightsArray),Wt=this.localClippingEnabled,Ct=ne.init(this.clippingPlanes,Wt),Ct===!0&&ne.setGlobalState(this.clippingPlanes,U),q!==null&&he.render(C.state.shadowsArray,H,U);let Y=new Set;return S.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let xe=J.material;if(xe)if(Array.isArray(xe))for(let ve=0;ve<xe.length;ve++){let Se=xe[ve];ks(Se,H,U,J),Y.add(Se)}else ks(xe,H,U,J),Y.add(xe)}),C=T.pop(),q!==null&&q.renderEnd(),Y},this.compileAsync=function(S,U,H=null){let Y=this.compile(S,U,H);return new Promise(J=>{function xe(){if(Y.forEach(function(ve){let Le=Ve.get(ve).currentProgram;(Le===void 0||Le.isReady())&&Y.delete(ve)}),Y.size===0){J(S);return}setTimeout(xe,10)}et.get("KHR_parallel_shader_compile")!==null?xe():setTimeout(xe,10)})};let ps=null;function lr(S){ps&&ps(S)}function zs(){Wn.stop()}function Pn(){Wn.start()}let Wn=new Fm;Wn.setAnimationLoop(lr),typeof self<"u"&&Wn.setContext(self),this.setAnimationLoop=function(S){ps=S,ue.setAnimationLoop(S),S===null?Wn.stop():Wn.start()},ue.addEventListener("sessionstart",zs),ue.addEventListener("sessionend",Pn),this.render=function(S,U){if(U!==void 0&&U.isCamera!==!0){ht("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;q!==null&&q.renderStart(S,U);let H=ue.enabled===!0&&ue.isPresenting===!0,Y=z!==null&&(pe===null||H)&&z.begin(F,pe);if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),U.parent===null&&U.matrixWorldAutoUpdate===!0&&U.updateMatrixWorld(),ue.enabled===!0&&ue.isPresenting===!0&&(z===null||z.isCompositing()===!1)&&(ue.cameraAutoUpdate===!0&&ue.updateCamera(U),U=ue.getCamera()),S.isScene===!0&&S.onBeforeRender(F,S,U,pe),C=K.get(S,T.length),C.init(U),C.state.textureUnits=Ke.getTextureUnits(),T.push(C),Mt.multiplyMatrices(U.projectionMatrix,U.matrixWorldInverse),U.isArrayCamera?Dt.setFromArrayCamera(U):it.setFromProjectionMatrix(Mt,xi,U.reversedDepth),Wt=this.localClippingEnabled,Ct=ne.init(this.clippingPlanes,Wt),P=le.get(S,x.length),P.init(),x.push(P),this.info.render.frame++,ue.enabled===!0&&ue.isPresenting===!0){let ve=F.xr.getDepthSensingMesh();ve!==null&&Xn(ve,U,-1/0,F.sortObjects)}Xn(S,U,0,F.sortObjects),P.finish(),q!==null&&q.updateLights(C.state.lightsArray),F.sortObjects===!0&&P.sort(We,nt),Vt=ue.enabled===!1||ue.isPresenting===!1||ue.hasDepthSensing()===!1,Vt&&N.addToRenderList(P,S),this.info.autoReset===!0&&this.info.reset(),Ct===!0&&ne.beginShadows();let J=C.state.shadowsArray;if(he.render(J,S,U),Ct===!0&&ne.endShadows(),(Y&&z.hasRenderPass())===!1){let ve=P.opaque,Se=P.transmissive;if(C.setupLights(),U.isArrayCamera){let Le=U.cameras;if(Se.length>0)for(let Be=0,je=Le.length;Be<je;Be++){let at=Le[Be];Un(ve,Se,S,at)}Vt&&N.render(S);for(let Be=0,je=Le.length;Be<je;Be++){let at=Le[Be];ms(P,S,at,at.viewport)}}else Se.length>0&&Un(ve,Se,S,U),Vt&&N.render(S),ms(P,S,U)}pe!==null&&k===0&&(Ke.updateMultisampleRenderTarget(pe),Ke.updateRenderTargetMipmap(pe)),Y&&z.end(F),S.isScene===!0&&S.onAfterRender(F,S,U),Ae.resetDefaultState(),Q=-1,re=null,T.pop(),T.length>0?(C=T[T.length-1],Ke.setTextureUnits(C.state.textureUnits),Ct===!0&&ne.setGlobalState(F.clippingPlanes,C.state.camera)):C=null,x.pop(),x.length>0?P=x[x.length-1]:P=null,q!==null&&q.renderEnd()};function Xn(S,U,H,Y){if(S.visible===!1)return;if(S.layers.test(U.layers)){if(S.isGroup)H=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(U);else if(S.isLight)C.pushLight(S),S.castShadow&&C.pushShadow(S);else if(S.isSprite){let ve=U.isArrayCamera?Dt:it;if(!S.frustumCulled||S.intersectsFrustum(ve)){Y&&pt.setFromMatrixPosition(S.matrixWorld).applyMatrix4(Mt);let Se=B.update(S),Le=S.material;Le.visible&&P.push(S,Se,Le,H,pt.z,null,U)}}else if(S.isMesh||S.isLine||S.isPoints){let ve=U.isArrayCamera?Dt:it;if(!S.frustumCulled||S.intersectsFrustum(ve)){let Se=B.update(S),Le=S.material;if(Y&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),pt.copy(S.boundingSphere.center)):(Se.boundingSphere===null&&Se.computeBoundingSphere(),pt.copy(Se.boundingSphere.center)),pt.applyMatrix4(S.matrixWorld).applyMatrix4(Mt)),Array.isArray(Le)){let Be=Se.groups;for(let je=0,at=Be.length;je<at;je++){let ke=Be[je],ut=Le[ke.materialIndex];ut&&ut.visible&&P.push(S,Se,ut,H,pt.z,ke,U)}}else Le.visible&&P.push(S,Se,Le,H,pt.z,null,U)}}}let xe=S.children;for(let ve=0,Se=xe.length;ve<Se;ve++)Xn(xe[ve],U,H,Y)}function ms(S,U,H,Y){let{opaque:J,transmissive:xe,transparent:ve}=S;C.setupLightsView(H),Ct===!0&&ne.setGlobalState(F.clippingPlanes,H),Y&&Re.viewport(ce.copy(Y)),J.length>0&&Jt(J,U,H),xe.length>0&&Jt(xe,U,H),ve.length>0&&Jt(ve,U,H),Re.buffers.depth.setTest(!0),Re.buffers.depth.setMask(!0),Re.buffers.color.setMask(!0),Re.setPolygonOffset(!1)}function Un(S,U,H,Y){if((H.isScene===!0?H.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[Y.id]===void 0){let ke=et.has("EXT_color_buffer_half_float")||et.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[Y.id]=new li(1,1,{generateMipmaps:!0,type:ke?Ii:ui,minFilter:cs,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let xe=C.state.transmissionRenderTarget[Y.id],ve=Y.viewport||ce;xe.setSize(ve.z*F.transmissionResolutionScale,ve.w*F.transmissionResolutionScale);let Se=F.getRenderTarget(),Le=F.getActiveCubeFace(),Be=F.getActiveMipmapLevel();F.setRenderTarget(xe),F.getClearColor(oe),be=F.getClearAlpha(),be<1&&F.setClearColor(16777215,.5),F.clear(),Vt&&N.render(H);let je=F.toneMapping;F.toneMapping=Yi;let at=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),C.setupLightsView(Y),Ct===!0&&ne.setGlobalState(F.clippingPlanes,Y),Jt(S,H,Y),Ke.updateMultisampleRenderTarget(xe),Ke.updateRenderTargetMipmap(xe),et.has("WEBGL_multisampled_render_to_texture")===!1){let ke=!1;for(let ut=0,Zt=U.length;ut<Zt;ut++){let Et=U[ut],{object:Rt,geometry:qt,material:He,group:ln}=Et;if(He.side===qi&&Rt.layers.test(Y.layers)){let vt=He.side;He.side=Hn,He.needsUpdate=!0,Gt(Rt,H,Y,qt,He,ln),He.side=vt,He.needsUpdate=!0,ke=!0}}ke===!0&&(Ke.updateMultisampleRenderTarget(xe),Ke.updateRenderTargetMipmap(xe))}F.setRenderTarget(Se,Le,Be),F.setClearColor(oe,be),at!==void 0&&(Y.viewport=at),F.toneMapping=je}function Jt(S,U,H){let Y=U.isScene===!0?U.overrideMaterial:null;for(let J=0,xe=S.length;J<xe;J++){let ve=S[J],{object:Se,geometry:Le,group:Be}=ve,je=ve.material;je.allowOverride===!0&&Y!==null&&(je=Y),Se.layers.test(H.layers)&&Gt(Se,U,H,Le,je,Be)}}function Gt(S,U,H,Y,J,xe){q!==null&&J.isNodeMaterial&&q.setObject(S,J),S.onBeforeRender(F,U,H,Y,J,xe),S.modelViewMatrix.multiplyMatrices(H.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),J.onBeforeRender(F,U,H,Y,S,xe),J.transparent===!0&&J.side===qi&&J.forceSinglePass===!1?(J.side=Hn,J.needsUpdate=!0,F.renderBufferDirect(H,U,Y,J,S,xe),J.side=Os,J.needsUpdate=!0,F.renderBufferDirect(H,U,Y,J,S,xe),J.side=qi):F.renderBufferDirect(H,U,Y,J,S,xe),S.onAfterRender(F,U,H,Y,J,xe)}function Kt(S){let U=0;for(let H of S)H.texture!==null&&U++;return U}function Kn(S,U,H){U.isScene!==!0&&(U=kt);let Y=Ve.get(S),J=C.state.lights,xe=C.state.shadowsArray,ve=J.state.version,Se=W.getParameters(S,J.state,xe,U,H,C.state.lightProbeGridArray),Le=W.getProgramCacheKey(Se),Be=Y.programs;Y.environment=S.isMeshStandardMaterial||S.isMeshLambertMaterial||S.isMeshPhongMaterial?U.environment:null,Y.fog=U.fog;let je=S.isMeshStandardMaterial||S.isMeshLambertMaterial&&!S.envMap||S.isMeshPhongMaterial&&!S.envMap;Y.envMap=E.get(S.envMap||Y.environment,je),Y.envMapRotation=Y.environment!==null&&S.envMap===null?U.environmentRotation:S.envMapRotation,Be===void 0&&(S.addEventListener("dispose",tt),Be=new Map,Y.programs=Be,Y.programVariants=new Map);let at=Be.get(Le);if(at!==void 0){if(Y.currentProgram===at&&Y.lightsStateVersion===ve)return X(S,Se),at}else Se.uniforms=W.getUniforms(S),q!==null&&S.isNodeMaterial&&q.build(S,H,Se),S.onBeforeCompile(Se,F),at=W.acquireProgram(Se,Le),Be.set(Le,at),Y.uniforms=Se.uniforms;let ke=Y.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(ke.clippingPlanes=ne.uniform),X(S,Se),Y.needsLights=Xe(S),Y.lightsStateVersion=ve,Y.needsLights&&(ke.ambientLightColor.value=J.state.ambient,ke.lightProbe.value=J.state.probe,ke.sunLights.value=J.state.sun,ke.sunLightShadows.value=J.state.sunShadow,ke.directionalLights.value=J.state.directional,ke.directionalLightShadows.value=J.state.directionalShadow,ke.spotLights.value=J.state.spot,ke.spotLightShadows.value=J.state.spotShadow,ke.rectAreaLights.value=J.state.rectArea,ke.ltc_1.value=J.state.rectAreaLTC1,ke.ltc_2.value=J.state.rectAreaLTC2,ke.pointLights.value=J.state.point,ke.pointLightShadows.value=J.state.pointShadow,ke.hemisphereLights.value=J.state.hemi,ke.sunShadowMatrix.value=J.state.sunShadowMatrix,ke.sunShadowCascade.value=J.state.sunShadowCascade,ke.directionalShadowMatrix.value=J.state.directionalShadowMatrix,ke.spotLightMatrix.value=J.state.spotLightMatrix,ke.spotLightMap.value=J.state.spotLightMap,ke.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.numLightProbeGrids=Kt(C.state.lightProbeGridArray),Y.currentProgram=at,Y.uniformsList=null,at}function Fn(S,U,H,Y,J){let xe=Ve.get(S),ve=xe.currentProgram.id+","+Y+","+J,Se=xe.programVariants.get(ve);return Se===void 0?(Se=Kn(S,U,H),xe.programVariants.set(ve,Se)):(xe.currentProgram=Se,xe.uniformsList=null,xe.outputColorSpace=Y,xe.toneMapping=J),Se}function Di(S){if(S.uniformsList===null){let U=S.currentProgram.getUniforms();S.uniformsList=no.seqWithValue(U.seq,S.uniforms)}return S.uniformsList}function X(S,U){let H=Ve.get(S);H.outputColorSpace=U.outputColorSpace,H.batching=U.batching,H.batchingColor=U.batchingColor,H.instancing=U.instancing,H.instancingColor=U.instancingColor,H.instancingMorph=U.instancingMorph,H.skinning=U.skinning,H.morphTargets=U.morphTargets,H.morphNormals=U.morphNormals,H.morphColors=U.morphColors,H.morphTargetsCount=U.morphTargetsCount,H.numClippingPlanes=U.numClippingPlanes,H.numIntersection=U.numClipIntersection,H.vertexAlphas=U.vertexAlphas,H.vertexTangents=U.vertexTangents,H.toneMapping=U.toneMapping}function _e(S,U,H,Y,J){U.isScene!==!0&&(U=kt),Ke.resetTextureUnits();let xe=U.fog,ve=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?U.environment:null,Se=pe===null?F.outputColorSpace:pe.isXRRenderTarget===!0?pe.texture.colorSpace:St.workingColorSpace,Le=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Be=E.get(Y.envMap||ve,Le),je=Y.vertexColors===!0&&!!H.attributes.color&&H.attributes.color.itemSize===4,at=!!H.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),ke=!!H.morphAttributes.position,ut=!!H.morphAttributes.normal,Zt=!!H.morphAttributes.color,Et=Yi;Y.toneMapped&&(pe===null||pe.isXRRenderTarget===!0)&&(Et=F.toneMapping);let Rt=H.morphAttributes.position||H.morphAttributes.normal||H.morphAttributes.color,qt=Rt!==void 0?Rt.length:0,He=Ve.get(Y),ln=C.state.lights;if(Ct===!0&&(Wt===!0||S!==re)){let zt=S===re&&Y.id===Q;ne.setState(Y,S,zt)}let vt=!1,Ji=!1;Y.version===He.__version?He.needsLights&&He.lightsStateVersion!==ln.state.version||J.isBatchedMesh&&He.batching===!1||!J.isBatchedMesh&&He.batching===!0||J.isBatchedMesh&&He.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&He.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&He.instancing===!1||!J.isInstancedMesh&&He.instancing===!0||J.isSkinnedMesh&&He.skinning===!1||!J.isSkinnedMesh&&He.skinning===!0||J.isInstancedMesh&&He.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&He.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&He.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&He.instancingMorph===!1&&J.morphTexture!==null||He.envMap!==Be||Y.fog===!0&&He.fog!==xe||He.numClippingPlanes!==void 0&&(He.numClippingPlanes!==ne.numPlanes||He.numIntersection!==ne.numIntersection)||He.vertexAlphas!==je||He.vertexTangents!==at||He.morphTargets!==ke||He.morphNormals!==ut||He.morphColors!==Zt||He.morphTargetsCount!==qt||He.numLightProbeGrids!==Kt(C.state.lightProbeGridArray)?vt=!0:(He.outputColorSpace!==Se||He.toneMapping!==Et)&&(Ji=!0):(vt=!0,He.__version=Y.version);let pn=He.currentProgram;(vt===!0||Ji===!0)&&(pn=Ji===!0?Fn(Y,U,J,Se,Et):Kn(Y,U,J),q&&Y.isNodeMaterial&&q.onUpdateProgram(Y,pn,He));let cr=!1,Ni=!1,Ki=!1,mt=pn.getUniforms(),cn=He.uniforms;if(Re.useProgram(pn.program)&&(cr=!0,Ni=!0,Ki=!0),Y.id!==Q&&(Q=Y.id,Ni=!0),cr||re!==S){Re.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),mt.setValue(O,"projectionMatrix",S.projectionMatrix),mt.setValue(O,"viewMatrix",S.matrixWorldInverse);let mn=mt.map.cameraPosition;mn!==void 0&&mn.setValue(O,rn.setFromMatrixPosition(S.matrixWorld)),ot.logarithmicDepthBuffer&&mt.setValue(O,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&mt.setValue(O,"isOrthographic",S.isOrthographicCamera===!0),re!==S&&(re=S,Ni=!0,Ki=!0)}if(He.needsLights&&(ln.state.sunShadowMap.length>0&&mt.setValue(O,"sunShadowMap",ln.state.sunShadowMap,Ke),ln.state.directionalShadowMap.length>0&&mt.setValue(O,"directionalShadowMap",ln.state.directionalShadowMap,Ke),ln.state.spotShadowMap.length>0&&mt.setValue(O,"spotShadowMap",ln.state.spotShadowMap,Ke),ln.state.pointShadowMap.length>0&&mt.setValue(O,"pointShadowMap",ln.state.pointShadowMap,Ke)),J.isSkinnedMesh){mt.setOptional(O,J,"bindMatrix"),mt.setOptional(O,J,"bindMatrixInverse");let zt=J.skeleton;zt&&(zt.boneTexture===null&&zt.computeBoneTexture(),mt.setValue(O,"boneTexture",zt.boneTexture,Ke))}J.isBatchedMesh&&(mt.setOptional(O,J,"batchingTexture"),mt.setValue(O,"batchingTexture",J._matricesTexture,Ke),mt.setOptional(O,J,"batchingIdTexture"),mt.setValue(O,"batchingIdTexture",J._indirectTexture,Ke),mt.setOptional(O,J,"batchingColorTexture"),J._colorsTexture!==null&&mt.setValue(O,"batchingColorTexture",J._colorsTexture,Ke));let On=H.morphAttributes;if((On.position!==void 0||On.normal!==void 0||On.color!==void 0)&&j.update(J,H,pn),(Ni||He.receiveShadow!==J.receiveShadow)&&(He.receiveShadow=J.receiveShadow,mt.setValue(O,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&U.environment!==null&&(cn.envMapIntensity.value=U.environmentIntensity),cn.dfgLUT!==void 0&&(cn.dfgLUT.value=rb()),Ni){if(mt.setValue(O,"toneMappingExposure",F.toneMappingExposure),He.needsLights&&De(cn,Ki),xe&&Y.fog===!0&&ae.refreshFogUniforms(cn,xe),ae.refreshMaterialUniforms(cn,Y,Te,Ce,C.state.transmissionRenderTarget[S.id]),He.needsLights&&He.numLightProbeGrids>0){let zt=b,mn=0;for(let In of C.state.lightProbeGridArray)In.texture!==null&&(zt.textures[mn]=In.texture,zt.min[mn]=In.boundingBox.min,zt.max[mn]=In.boundingBox.max,zt.resolution[mn]=In.resolution,mn++);for(let In in zt)zt[In].length=mn;cn.probesSH.value=zt.textures,cn.probesMin.value=zt.min,cn.probesMax.value=zt.max,cn.probesResolution.value=zt.resolution}no.upload(O,Di(He),cn,Ke)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(no.upload(O,Di(He),cn,Ke),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&mt.setValue(O,"center",J.center),mt.setValue(O,"modelViewMatrix",J.modelViewMatrix),mt.setValue(O,"normalMatrix",J.normalMatrix),mt.setValue(O,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let zt=Y.uniformsGroups;for(let mn=0,In=zt.length;mn<In;mn++){let aa=zt[mn];Ye.update(aa,pn),Ye.bind(aa,pn)}}return pn}function De(S,U){S.ambientLightColor.needsUpdate=U,S.lightProbe.needsUpdate=U,S.sunLights.needsUpdate=U,S.sunLightShadows.needsUpdate=U,S.directionalLights.needsUpdate=U,S.directionalLightShadows.needsUpdate=U,S.pointLights.needsUpdate=U,S.pointLightShadows.needsUpdate=U,S.spotLights.needsUpdate=U,S.spotLightShadows.needsUpdate=U,S.rectAreaLights.needsUpdate=U,S.hemisphereLights.needsUpdate=U}function Xe(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return te},this.getActiveMipmapLevel=function(){return k},this.getRenderTarget=function(){return pe},this.setRenderTargetTextures=function(S,U,H){let Y=Ve.get(S);Y.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Ve.get(S.texture).__webglTexture=U,Ve.get(S.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:H,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,U){let H=Ve.get(S);H.__webglFramebuffer=U,H.__useDefaultFramebuffer=U===void 0},this.setRenderTarget=function(S,U=0,H=0){pe=S,te=U,k=H;let Y=null,J=!1,xe=!1;if(S){let Se=Ve.get(S);if(Se.__useDefaultFramebuffer!==void 0){Re.bindFramebuffer(O.FRAMEBUFFER,Se.__webglFramebuffer),ce.copy(S.viewport),de.copy(S.scissor),me=S.scissorTest,Re.viewport(ce),Re.scissor(de),Re.setScissorTest(me),Q=-1;return}else if(Se.__webglFramebuffer===void 0)Ke.setupRenderTarget(S);else if(Se.__hasExternalTextures)Ke.rebindTextures(S,Ve.get(S.texture).__webglTexture,Ve.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let je=S.depthTexture;if(Se.__boundDepthTexture!==je){if(je!==null&&Ve.has(je)&&(S.width!==je.image.width||S.height!==je.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ke.setupDepthRenderbuffer(S)}}let Le=S.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(xe=!0);let Be=Ve.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(Be[U])?Y=Be[U][H]:Y=Be[U],J=!0):S.samples>0&&Ke.useMultisampledRTT(S)===!1?Y=Ve.get(S).__webglMultisampledFramebuffer:Array.isArray(Be)?Y=Be[H]:Y=Be,ce.copy(S.viewport),de.copy(S.scissor),me=S.scissorTest}else ce.copy(qe).multiplyScalar(Te).floor(),de.copy(ct).multiplyScalar(Te).floor(),me=rt;if(H!==0&&(Y=$),Re.bindFramebuffer(O.FRAMEBUFFER,Y)&&Re.drawBuffers(S,Y),Re.viewport(ce),Re.scissor(de),Re.setScissorTest(me),J){let Se=Ve.get(S.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+U,Se.__webglTexture,H)}else if(xe){let Se=U;for(let Le=0;Le<S.textures.length;Le++){let Be=Ve.get(S.textures[Le]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Le,Be.__webglTexture,H,Se)}}else if(S!==null&&H!==0){let Se=Ve.get(S.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Se.__webglTexture,H)}Q=-1};function Ge(S){let U=Ve.get(S);return(U.__readFormat!==S.format||U.__readType!==S.type)&&(U.__readFormat=S.format,U.__readType=S.type,U.__formatReadable=ot.textureFormatReadable(S.format),U.__typeReadable=ot.textureTypeReadable(S.type)),U}this.readRenderTargetPixels=function(S,U,H,Y,J,xe,ve,Se=0){if(!(S&&S.isWebGLRenderTarget)){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=Ve.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&ve!==void 0&&(Le=Le[ve],Array.isArray(Le)&&(Le=Le[0])),Le){Re.bindFramebuffer(O.FRAMEBUFFER,Le);try{let Be=S.textures[Se],je=Be.format,at=Be.type;S.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Se);let ke=Ge(Be);if(ke.__formatReadable===!1){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){ht("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}U>=0&&U<=S.width-Y&&H>=0&&H<=S.height-J&&O.readPixels(U,H,Y,J,ge.convert(je),ge.convert(at),xe)}finally{let Be=pe!==null?Ve.get(pe).__webglFramebuffer:null;Re.bindFramebuffer(O.FRAMEBUFFER,Be)}}},this.readRenderTargetPixelsAsync=async function(S,U,H,Y,J,xe,ve,Se=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=Ve.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&ve!==void 0&&(Le=Le[ve],Array.isArray(Le)&&(Le=Le[0])),Le)if(U>=0&&U<=S.width-Y&&H>=0&&H<=S.height-J){Re.bindFramebuffer(O.FRAMEBUFFER,Le);let Be=S.textures[Se],je=Be.format,at=Be.type;S.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Se);let ke=Ge(Be);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ut=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,ut),O.bufferData(O.PIXEL_PACK_BUFFER,xe.byteLength,O.STREAM_READ),O.readPixels(U,H,Y,J,ge.convert(je),ge.convert(at),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Zt=pe!==null?Ve.get(pe).__webglFramebuffer:null;Re.bindFramebuffer(O.FRAMEBUFFER,Zt);let Et=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await lm(O,Et,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,ut),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,xe),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(ut),O.deleteSync(Et),xe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,U=null,H=0){let Y=Math.pow(2,-H),J=Math.floor(S.image.width*Y),xe=Math.floor(S.image.height*Y),ve=U!==null?U.x:0,Se=U!==null?U.y:0;Ke.setTexture2D(S,0),O.copyTexSubImage2D(O.TEXTURE_2D,H,0,0,ve,Se,J,xe),Re.unbindTexture()},this.copyTextureToTexture=function(S,U,H=null,Y=null,J=0,xe=0){let ve,Se,Le,Be,je,at,ke,ut,Zt,Et=S.isCompressedTexture?S.mipmaps[xe]:S.image;if(H!==null)ve=H.max.x-H.min.x,Se=H.max.y-H.min.y,Le=H.isBox3?H.max.z-H.min.z:1,Be=H.min.x,je=H.min.y,at=H.isBox3?H.min.z:0;else{let mt=Math.pow(2,-J);ve=Math.floor(Et.width*mt),Se=Math.floor(Et.height*mt),S.isDataArrayTexture?Le=Et.depth:S.isData3DTexture?Le=Math.floor(Et.depth*mt):Le=1,Be=0,je=0,at=0}Y!==null?(ke=Y.x,ut=Y.y,Zt=Y.z):(ke=0,ut=0,Zt=0);let Rt=ge.convert(U.format),qt=ge.convert(U.type),He;U.isData3DTexture?(Ke.setTexture3D(U,0),He=O.TEXTURE_3D):U.isDataArrayTexture||U.isCompressedArrayTexture?(Ke.setTexture2DArray(U,0),He=O.TEXTURE_2D_ARRAY):(Ke.setTexture2D(U,0),He=O.TEXTURE_2D),Re.activeTexture(O.TEXTURE0),Re.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,U.flipY),Re.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,U.premultiplyAlpha),Re.pixelStorei(O.UNPACK_ALIGNMENT,U.unpackAlignment);let ln=Re.getParameter(O.UNPACK_ROW_LENGTH),vt=Re.getParameter(O.UNPACK_IMAGE_HEIGHT),Ji=Re.getParameter(O.UNPACK_SKIP_PIXELS),pn=Re.getParameter(O.UNPACK_SKIP_ROWS),cr=Re.getParameter(O.UNPACK_SKIP_IMAGES);Re.pixelStorei(O.UNPACK_ROW_LENGTH,Et.width),Re.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Et.height),Re.pixelStorei(O.UNPACK_SKIP_PIXELS,Be),Re.pixelStorei(O.UNPACK_SKIP_ROWS,je),Re.pixelStorei(O.UNPACK_SKIP_IMAGES,at);let Ni=S.isDataArrayTexture||S.isData3DTexture,Ki=U.isDataArrayTexture||U.isData3DTexture;if(S.isDepthTexture){let mt=Ve.get(S),cn=Ve.get(U),On=Ve.get(mt.__renderTarget),zt=Ve.get(cn.__renderTarget);Re.bindFramebuffer(O.READ_FRAMEBUFFER,On.__webglFramebuffer),Re.bindFramebuffer(O.DRAW_FRAMEBUFFER,zt.__webglFramebuffer);for(let mn=0;mn<Le;mn++)Ni&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ve.get(S).__webglTexture,J,at+mn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ve.get(U).__webglTexture,xe,Zt+mn)),O.blitFramebuffer(Be,je,Be+ve,je+Se,ke,ut,ke+ve,ut+Se,O.DEPTH_BUFFER_BIT,O.NEAREST);Re.bindFramebuffer(O.READ_FRAMEBUFFER,null),Re.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(J!==0||S.isRenderTargetTexture||Ve.has(S)){let mt=Ve.get(S),cn=Ve.get(U);Re.bindFramebuffer(O.READ_FRAMEBUFFER,I),Re.bindFramebuffer(O.DRAW_FRAMEBUFFER,V);for(let On=0;On<Le;On++)Ni?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,mt.__webglTexture,J,at+On):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,mt.__webglTexture,J),Ki?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,cn.__webglTexture,xe,Zt+On):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,cn.__webglTexture,xe),J!==0?O.blitFramebuffer(Be,je,Be+ve,je+Se,ke,ut,ke+ve,ut+Se,O.COLOR_BUFFER_BIT,O.NEAREST):Ki?O.copyTexSubImage3D(He,xe,ke,ut,Zt+On,Be,je,ve,Se):O.copyTexSubImage2D(He,xe,ke,ut,Be,je,ve,Se);Re.bindFramebuffer(O.READ_FRAMEBUFFER,null),Re.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else Ki?S.isDataTexture||S.isData3DTexture?O.texSubImage3D(He,xe,ke,ut,Zt,ve,Se,Le,Rt,qt,Et.data):U.isCompressedArrayTexture?O.compressedTexSubImage3D(He,xe,ke,ut,Zt,ve,Se,Le,Rt,Et.data):O.texSubImage3D(He,xe,ke,ut,Zt,ve,Se,Le,Rt,qt,Et):S.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,xe,ke,ut,ve,Se,Rt,qt,Et.data):S.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,xe,ke,ut,Et.width,Et.height,Rt,Et.data):O.texSubImage2D(O.TEXTURE_2D,xe,ke,ut,ve,Se,Rt,qt,Et);Re.pixelStorei(O.UNPACK_ROW_LENGTH,ln),Re.pixelStorei(O.UNPACK_IMAGE_HEIGHT,vt),Re.pixelStorei(O.UNPACK_SKIP_PIXELS,Ji),Re.pixelStorei(O.UNPACK_SKIP_ROWS,pn),Re.pixelStorei(O.UNPACK_SKIP_IMAGES,cr),xe===0&&U.generateMipmaps===!0&&U.mipmapsAutoUpdate===!0&&O.generateMipmap(He),Re.unbindTexture()},this.initRenderTarget=function(S){Ve.get(S).__webglFramebuffer===void 0&&Ke.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?Ke.setTextureCube(S,0):S.isData3DTexture?Ke.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?Ke.setTexture2DArray(S,0):Ke.setTexture2D(S,0),Re.unbindTexture()},this.resetState=function(){te=0,k=0,pe=null,Re.reset(),Ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return xi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var ob=`
in vec3 foot, error, tangent;
in float size;
uniform float magnification, side, top;
uniform vec3 view;
uniform vec2 pixel;
uniform int wide;
out float share;
void main() {
  share = size / top;
  vec3 beside = cross(tangent, view);
  float l = length(beside);
  vec3 off = l > 1e-6 ? beside * (side / l) : vec3(0.0);
  gl_Position = projectionMatrix * viewMatrix * vec4(foot + magnification * (error + off), 1.0);
  gl_Position.xy += (vec2(gl_InstanceID % wide, gl_InstanceID / wide) - 0.5 * float(wide - 1)) * pixel;
}`,ab=`
in float share;
uniform vec3 scale[9];
uniform vec4 paint;
out vec4 colour;
void main() {
  float x = 8.0 * clamp(share, 0.0, 1.0);
  int i = min(int(x), 7);
  colour = vec4(mix(paint.rgb, mix(scale[i], scale[i + 1], x - float(i)), paint.a), 1.0);
}`,Ec=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"].map(Ac);function Ac(i){let e=parseInt(i.trim().slice(1),16);return[(e>>16)/255,(e>>8&255)/255,(e&255)/255]}var so=(i,e,t)=>[i[0]+(e[0]-i[0])*t,i[1]+(e[1]-i[1])*t,i[2]+(e[2]-i[2])*t];function Ym(i){let[e,t]=i?[2,8]:[6.2,0];return Ec.map((n,s)=>{let r=e+(t-e)*s/8,o=Math.min(Math.floor(r),7);return so(Ec[o],Ec[o+1],r-o)})}function $m(){let i=new OffscreenCanvas(1,1).getContext("webgl2"),e=i?.getExtension("WEBGL_debug_renderer_info"),t=e?String(i.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(t)}function ro(i,e){let t=[];for(let n=0;n+1<i;n+=1)e(n)&&t.push(n,n+1);return Uint32Array.from(t)}function ra(i,e,t=[0,0,0],n=1){return new Yn(Float32Array.from(i,(s,r)=>(s-t[r%e])*n),e)}function Zm(i,e){let t=i.length-3,n=new Float32Array(i.length);for(let o=0;o<=t;o+=3){let a=Math.max(o-3,0),l=Math.min(o+3,t),c=[0,1,2].map(d=>i[l+d]-i[a+d]),h=Math.hypot(...c);h>e?n.set(c.map(d=>d/h),o):n.copyWithin(o,o-3,o)}let s=n.findIndex(o=>o!==0),r=s-s%3;for(let o=0;o<r;o+=3)n.copyWithin(o,r,r+3);return new Yn(n,3)}var Xu=class{object;own;constructor(e,t,n,s,r=0){let o=new Wo;this.own={side:{value:r},paint:{value:new sn},wide:{value:1}};let a=s>=qu,l={...e,...this.own},c={glslVersion:Qo,vertexShader:ob,fragmentShader:ab,uniforms:l},h=new vi({...c,depthTest:a,depthWrite:a});this.object=new Oo(o,h),this.object.frustumCulled=!1,this.fill(t,n),this.object.renderOrder=s,this.width(1)}paint(e){this.own.paint.value.set(...e??[0,0,0],e?0:1)}fill(e,t){let{geometry:n}=this.object;n.dispose();for(let[s,r]of Object.entries(e))n.setAttribute(s,r);n.setIndex(new Yn(t,1)),n.setDrawRange(0,1/0)}width(e){this.own.wide.value=e,this.object.geometry.instanceCount=e*e}only(e){let t=this.object.geometry.index;t.array.set(e),t.clearUpdateRanges(),t.addUpdateRange(0,e.length),t.needsUpdate=!0,this.object.geometry.setDrawRange(0,e.length),this.object.visible=e.length>0}},qu=9,Tc=class{camera=new Jr;scene=new Do;renderer;uniforms={magnification:{value:1},view:{value:new se},pixel:{value:new Tt},top:{value:1},scale:{value:Ec.map(()=>new se)}};constructor(e,t){this.renderer=new Mc({canvas:e,context:t}),this.renderer.setClearColor(0,0)}add(e,t,n,s=0){let r=new Xu(this.uniforms,e,t,n,s);return this.scene.add(r.object),r}destroy(){for(let{geometry:e,material:t}of this.scene.children)e.dispose(),t.dispose();this.renderer.dispose(),this.renderer.forceContextLoss()}};var Jn=(i,e)=>[i[3*e],i[3*e+1],i[3*e+2]],Cc=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],Yu=[210,52],$u=Math.PI/180,Rc=class{constructor(e,t,n,s,r,o){this.path=e;this.centre=t;this.extent=n;this.azimuth=s;this.elevation=r;this.changed=o;this.span=n,this.target=t}path;centre;extent;azimuth;elevation;changed;width=0;height=0;span;target;right=[1,0,0];up=[0,1,0];back=[0,0,1];turn(e,t){this.from(this.azimuth-e,this.elevation+t)}from(e,t){this.azimuth=e,this.elevation=Math.min(Math.max(t,-90),90);let[n,s]=[Math.cos(e*$u),Math.sin(e*$u)],r=this.elevation*$u;this.right=[-s,n,0],this.up=[-Math.sin(r)*n,-Math.sin(r)*s,Math.cos(r)],this.back=[Math.cos(r)*n,Math.cos(r)*s,Math.sin(r)],this.changed()}fit(e){let[[t,n],[s,r]]=[this.right,this.up].map(l=>{let c=1/0,h=-1/0;for(let d=0;d<this.path.length/3;d+=1){let u=Cc(Jn(this.path,d),l);c=Math.min(c,u),h=Math.max(h,u)}return[(c+h)/2,h-c+2*e]});this.target=[0,1,2].map(l=>t*this.right[l]+s*this.up[l]+Cc(this.centre,this.back)*this.back[l]);let o=n*this.height/this.width/Math.max(1-48/this.width,.5),a=l=>Math.max(r/Math.max(1-l/this.height,.5),o,.001*this.extent);this.span=a(64),this.width-n*this.height/this.span<2*Yu[0]&&(this.span=a(64+Yu[1]),this.shift(0,Yu[1]/2)),this.changed()}project(e){let t=this.height/this.span,n=[e[0]-this.target[0],e[1]-this.target[1],e[2]-this.target[2]];return[this.width/2+t*Cc(n,this.right),this.height/2-t*Cc(n,this.up)]}holds([e,t]){return e>=0&&t>=0&&e<=this.width&&t<=this.height}shift(e,t){this.target=this.target.map((n,s)=>n-this.span/this.height*(this.right[s]*e-this.up[s]*t)),this.changed()}zoom(e,t=this.width/2,n=this.height/2){let s=Math.min(Math.max(this.span*e,1e-6*this.extent),50*this.extent),r=1-s/this.span;this.shift((this.width/2-t)*r,(this.height/2-n)*r),this.span=s}aim(e,t){let n=this.target.map((o,a)=>o-this.centre[a]),s=this.span/2,r=s*this.width/this.height;Object.assign(e,{top:s,bottom:-s,right:r,left:-r,near:0,far:2*t}),e.position.set(n[0]+this.back[0]*t,n[1]+this.back[1]*t,n[2]+this.back[2]*t),e.up.set(...this.up),e.lookAt(...n),e.updateProjectionMatrix()}};var Jm=1e4,lb=14,cb=.25,hb=.05,Km=[-60,35.264],ub=[640,440],db=[20,36,52].flatMap(i=>[12,90].map(e=>[e,i])),fb=[.1,.2,.5,1,2,5,10],Zu=[0,0,0];function ds(i,e,...t){let n=document.createElementNS("http://www.w3.org/2000/svg",i);for(let[s,r]of Object.entries(e))n.setAttribute(s,String(r));return n.append(...t),n}var oa=new WeakSet,pb=i=>oa.has(i);function jm(i,e,t){let n=$m(),s=It("canvas"),r=s.getContext("webgl2",{antialias:!n,alpha:!0,preserveDrawingBuffer:!0});if(!r)return i.replaceChildren("The path in space needs WebGL 2, which this browser does not offer."),{highlight(){},resize(){},destroy(){i.replaceChildren()}};let o=i.getRootNode(),a=o instanceof ShadowRoot?o:document,l=new CSSStyleSheet,c=new AbortController;l.replaceSync(tp),a.adoptedStyleSheets.push(l);let h=(X,_e,De,Xe={})=>_e.split(" ").forEach(Ge=>X.addEventListener(Ge,De,{signal:c.signal,...Xe})),d=new Tc(s,r),u=d.uniforms,f=e.path.values,g=e.judged.values,y=g.length,m=[1/0,1/0,1/0],p=[-1/0,-1/0,-1/0];f.forEach((X,_e)=>{m[_e%3]=Math.min(m[_e%3],X),p[_e%3]=Math.max(p[_e%3],X)});let v=so(m,p,.5),A=Math.max(...p.map((X,_e)=>X-m[_e]))||1,b=e.tolerance,P={foot:ra(f,3,v),tangent:Zm(f,3e-5*A)},C=ro(y,X=>g[X]>0&&g[X+1]>0),x=ro(y,X=>!(g[X]&&g[X+1])),T=d.add(P,x,0),z=d.add(P,C,2),F=d.add(P,ro(y,()=>!0),3),D=b===null?[]:[1,-1].map(X=>d.add(P,C,1,X*b*.001));function q(X){let _e=X.size.values,De=X.stretch.values,Xe=ro(_e.length,U=>De[U]>0&&De[U]===De[U+1]),Ge={foot:ra(X.foot.values,3,v),error:ra(X.error.values,3,Zu,.001),size:ra(_e,1)},S=0;return _e.forEach((U,H)=>{De[H]>0&&(S=Math.max(S,U))}),{index:Xe,top:S,places:Ge,of:X.size}}function $(X,_e){let De=q(X),{places:Xe,index:Ge}=De;return{run:X,...De,shown:!1,lines:d.add(Xe,Ge,qu+_e),halo:d.add(Xe,Ge.slice(),4)}}let I=e.runs.map($),V=()=>I.filter(X=>X.shown),te=I.reduce((X,_e)=>_e.top>X.top?_e:X);(I.length===2?I:[te]).forEach(X=>{X.shown=!0});let k=It("canvas",{hidden:!0}),pe=ds("svg",{}),Q=It("div",{className:"path-bar"}),re=It("div",{className:"path-key"}),ce=`${e.title}. Arrow keys turn, with shift they move; plus and minus zoom, space plays.`,de=It("div",{className:"path-stage",tabIndex:0,role:"application",ariaLabel:ce},s,k,pe,re,Q),me=It("output",{className:"path-times"}),oe=It("output"),be=It("output",{className:"path-said",textContent:"Click on the path: line, time, error and cause."}),Ee=It("input",{type:"range",min:"0",max:"4",step:"any",ariaLabel:"Magnification of the error"}),Ce=Math.min(...I.map(({run:X})=>X.time.values[0]??0)),Te=Math.max(...I.map(({run:X})=>X.time.values.at(-1)??0)),We=It("input",{type:"range",min:String(Ce),max:String(Te),step:"any",ariaLabel:"Time",value:String(Ce)}),nt=It("button",{type:"button"}),qe=It("select",{ariaLabel:"Speed"},...fb.map(X=>new Option(`${X} ×`,String(X)))),ct=It("select",{ariaLabel:"Colour"},new Option("colour: error","error"),new Option("colour: run","run",I.length===2,I.length===2)),rt=(X,_e,De,Xe="")=>{let Ge=It("input",{type:"checkbox",checked:_e}),S=It("i");return S.style.background=Xe,h(Ge,"change",()=>{De(Ge.checked),Gt()}),It("label",{},Ge,...Xe?[S]:[],X)},it=(X,_e)=>{let De=It("button",{type:"button",textContent:X});return h(De,"click",_e),De},Dt=e.axes.map(X=>X.toUpperCase()),[Ct,Wt,Mt]=Dt,rn=Math.max(...Dt.map(X=>X.length)),pt=(X,_e)=>X+(rn>1?" ":"")+_e,kt=[[pt(Ct,Wt),-90,90],["ISO",...Km]];Mt&&kt.splice(1,0,[pt(Ct,Mt),-90,0],[pt(Wt,Mt),0,0]);let Vt=It("span",{className:"path-which"});function Xt(X,_e){X.shown=_e,ct.value=V().length>1?"run":"error"}let O=()=>{I.length>1&&Vt.replaceChildren(...I.map(X=>rt(X.run.name,X.shown,_e=>Xt(X,_e),X.run.colour)),ct)};O();let Ie=0,et=0,ot=!0;for(let X=0;X<C.length;X+=2){let _e=Jn(f,C[X]),De=Jn(f,C[X+1]);Ie+=Math.hypot(De[0]-_e[0],De[1]-_e[1],De[2]-_e[2]),et+=Math.abs(De[2]-_e[2])}let Re=et<=hb*Ie,bt=Re,[Ve,Ke]=Re?[-90,90]:Km,E=new Rc(f,v,A,Ve,Ke,()=>K());i.classList.add("cl-path"),i.replaceChildren(It("div",{className:"path-row"},It("span",{className:"path-views"},...kt.map(([X,_e,De])=>it(X,()=>{E.from(_e,De),ne()})),it("Fit",ne)),Vt,...x.length?[rt(e.unjudged,!0,X=>{ot=X})]:[],...D.length?[rt("tolerance",bt,X=>{bt=X})]:[]),de,It("div",{className:"path-row"},me,Ee),It("div",{className:"path-row"},nt,We,qe,oe),be);let M=0,Z=0,B=1,W=!1,ae=!0,le=new IntersectionObserver(([{isIntersecting:X}])=>{ae=X,K()},{rootMargin:"200px"});le.observe(de);function K(){ae&&(M||=requestAnimationFrame(N))}function ne(){E.fit(Math.min(.001*u.magnification.value*Math.max(...V().map(X=>X.top),0),.3*A))}function he(){W=n,clearTimeout(Z),Z=window.setTimeout(()=>{W=!1,K()},150)}function N(){cancelAnimationFrame(M),M=0,E.aim(d.camera,4*(A+.001*Jm*Math.max(...I.map(X=>X.top)))),u.view.value.set(...E.back),T.object.visible=ot,D.forEach(X=>{X.object.visible=bt&&b*.001*u.magnification.value<.3*A}),I.forEach(X=>{X.lines.object.visible=X.shown,X.lines.width(W||pb(X.run)?1:2*B)}),d.renderer.render(d.scene,d.camera),Ae()}let j=({foot:X,error:_e})=>[0,1,2].map(De=>X[De]+_e[De]*.001*u.magnification.value),ee=[],ye=[],ge=null;function Ae(){let X=[],_e=db.slice(),[De,Xe]=E.project(v);if(ye=V().flatMap(({run:U})=>U.worst.map(H=>({run:U,place:H}))).sort((U,H)=>H.place.size-U.place.size),ye.forEach(({run:U,place:H},Y)=>{let[J,xe]=E.project(j(H)),{width:ve,height:Se}=E;if(!E.holds([J,xe]))return;let Le=`${Ft(H.size,"um",3)}${H.line?`, line ${H.line}`:""}`,Be=7*Le.length,je=J<De?-1:1,at=J+je*(18+Be)<0||J+je*(18+Be)>ve?-je:je,ke=xe<Xe?-1:1,ut=J+at*14,Zt=at>0?ut:ut-Be,Et=[15,31,47,63,-23,-39].map(qt=>xe+3+ke*qt).find(qt=>qt>12&&qt<Se-6&&!_e.some(([He,ln])=>Math.abs(He-Zt)<Be+6&&Math.abs(ln-qt)<16)),Rt=ds("g",{class:"path-worst","data-place":Y},ds("circle",{class:"path-mark",cx:J,cy:xe,r:6}));if(V().length>1&&(Rt.firstChild.style.stroke=U.colour),Et!==void 0){_e.push([Zt,Et]);let qt=b!==null&&H.size>b?"path-over":"";Rt.append(ds("line",{class:"path-lead",x1:J+at*5,y1:xe,x2:ut-at*2,y2:Et-4}),ds("text",{class:qt,x:ut,y:Et,"text-anchor":at>0?"start":"end"},Le))}X.push(Rt)}),ge){let[U,H]=E.project(j(ge));X.push(ds("path",{class:"path-mark",d:`M${U-11} ${H}h8m6 0h8M${U} ${H-11}v8m0 6v8`}))}Dt.forEach((U,H)=>{let[Y,J]=[E.width-30-8*Math.min(rn,9),E.height-34],xe=E.right[H],ve=-E.up[H];X.push(ds("line",{class:"path-mark",x1:Y,y1:J,x2:Y+24*xe,y2:J+24*ve})),Math.hypot(xe,ve)>.3&&X.push(ds("text",{x:Y+30*xe-4,y:J+32*ve+4},U))}),ee=I.map(({run:U})=>ds("circle",{class:"path-tool",r:6,fill:U.colour})),pe.replaceChildren(...X,...ee);let Ge=ha(120*E.span/E.height),S=It("i");S.style.width=`${Ge*E.height/E.span}px`,Q.replaceChildren(S,`${Ft(Ge,"mm")} of path, ${Ft(Ge*1e3/u.magnification.value,"um",3)} of error`),we()}function Ye(X,_e,De){let Xe=X.stretch.values,Ge=Math.min(_e+1,Xe.length-1),S=({values:Y})=>Y[_e]+(Y[Ge]-Y[_e])*De,U=Y=>Xe[Y]>0?Jn(X.error.values,Y):Zu,H=so(Jn(X.foot.values,_e),Jn(X.foot.values,Ge),De);return{run:X,foot:H,error:so(U(_e),U(Ge),De),size:S(X.size),time:S(X.time),line:X.lines.values[De>0?Ge:_e],feedrate:S(X.feedrate),judged:Xe[_e]>0&&Xe[_e]===Xe[Ge]}}function Je(X,_e){let De=X.time.values,Xe=ua(De,_e);return Ye(X,Xe,Math.min(Math.max((_e-De[Xe])/(De[Xe+1]-De[Xe]||1),0),1))}let ue=Ce,Ne=0,Fe=0;function we(){let X=I.map(({run:Ge,shown:S})=>S&&Ge.time.values.length&&(ue>Ce||Ne)?Je(Ge,ue):null);X.forEach((Ge,S)=>{ee[S].setAttribute("visibility",Ge?"visible":"hidden"),Ge&&E.project(j(Ge)).forEach((U,H)=>ee[S].setAttribute(H?"cy":"cx",U.toFixed(2)))});let _e=X.filter(Ge=>Ge!==null),De=_e.find(Ge=>Ge.line)?.line,Xe=_e.map(Ge=>Ge.judged?Ft(Ge.size,"um",3):e.unjudged);oe.textContent=[`${ue.toFixed(3)} s`,...De?[`line ${De}`]:[],...Xe].join(", ")}function tt(X){ue=Math.min(ue+(X-Fe)/1e3*Number(qe.value),Te),Fe=X,We.value=String(ue),ue<Te?Ne=requestAnimationFrame(tt):_t(),we()}function _t(){cancelAnimationFrame(Ne),Ne=0,Object.assign(nt,{textContent:"▶",ariaLabel:"Play"})}function fn(){if(Ne)return _t();ue>=Te&&(ue=Ce),Fe=performance.now(),Ne=requestAnimationFrame(tt),Object.assign(nt,{textContent:"❚❚",ariaLabel:"Pause"})}h(nt,"click",fn),h(We,"input",()=>{ue=Number(We.value),we()});function ks(X,_e){let De=lb,Xe=null,Ge=(S,U,H)=>{let Y=-1,J=0;for(let xe=0;xe<S.length;xe+=2){let[ve,Se]=E.project(U(S[xe])),[Le,Be]=E.project(U(S[xe+1])),je=Le-ve,at=Be-Se,ke=Math.min(Math.max(((X-ve)*je+(_e-Se)*at)/(je*je+at*at||1),0),1),ut=Math.hypot(X-ve-ke*je,_e-Se-ke*at);ut<De&&([De,Y,J]=[ut,S[xe],ke])}Y>=0&&(Xe=H(Y,J))};for(let{run:S,index:U}of V())Ge(U,H=>j({foot:Jn(S.foot.values,H),error:Jn(S.error.values,H)}),(H,Y)=>Ye(S,H,Y));return!Xe&&ot&&Ge(x,S=>Jn(f,S),(S,U)=>({run:te.run,foot:so(Jn(f,S),Jn(f,S+1),U),error:Zu,line:e.lines.values[U<.5?S:S+1],size:NaN,time:NaN,feedrate:NaN,judged:!1})),Xe}function ps(X){ge=X;let _e=X.line?`Line ${X.line}`:"";if(X.judged){let De=Ge=>Math.abs(Ge.time-X.time),Xe=X.run.worst.filter(Ge=>Ge.cause&&De(Ge)<cb).sort((Ge,S)=>De(Ge)-De(S));be.textContent=[_e,`t = ${X.time.toFixed(3)} s`,`error ${Ft(X.size,"um",3)}`,Ft(X.feedrate,"mm/min"),...Xe.slice(0,1).map(Ge=>`cause: ${Ge.cause}`),I.length>1?X.run.name:""].filter(Boolean).join(", "),ue=X.time,We.value=String(ue)}else be.textContent=[_e,e.unjudged].filter(Boolean).join(", ");K(),X.line&&t.pick(X.line)}let lr=null;function zs(X){lr=X;let _e=(Xe,Ge)=>{let S=[],U=[];for(let H=0;X!==null&&H<Xe.length;H+=2){let Y=Ge[Xe[H]],J=Ge[Xe[H+1]];J===X?S.push(Xe[H],Xe[H+1]):Y<X&&X<J&&U.push(Xe[H],Xe[H+1])}return S.length?S:U},De=_e(ro(y,()=>!0),e.lines.values);F.only(De),I.forEach(Xe=>Xe.halo.only(Xe.shown?_e(Xe.index,Xe.run.lines.values):[])),De.length&&!De.some(Xe=>E.holds(E.project(Jn(f,Xe))))&&(E.target=Jn(f,De[De.length>>1])),K()}let Pn=new Map,Wn=0,Xn=X=>{let _e=de.getBoundingClientRect();return[X.clientX-_e.left-de.clientLeft,X.clientY-_e.top-de.clientTop]};h(de,"pointerdown",X=>{Pn.set(X.pointerId,Xn(X)),Wn=0}),h(de,"pointerup pointercancel",X=>{Pn.delete(X.pointerId)}),h(de,"contextmenu",X=>X.preventDefault()),h(de,"pointermove",X=>{let _e=Pn.get(X.pointerId),De=Xn(X),Xe=[...Pn].find(([H])=>H!==X.pointerId)?.[1];if(!_e)return;let Ge=De[0]-_e[0],S=De[1]-_e[1],U=H=>Math.hypot(H[0]-Xe[0],H[1]-Xe[1])||1;Wn+=Math.hypot(Ge,S),Wn>4&&de.setPointerCapture(X.pointerId),Pn.set(X.pointerId,De),he(),Xe?(E.zoom(U(_e)/U(De),...Xe),E.shift(Ge/2,S/2)):X.shiftKey||X.buttons&6?E.shift(Ge,S):E.turn(Ge/2,S/2)}),h(de,"click",X=>{let _e=X.target.closest(".path-worst"),De=_e&&ye[Number(_e.dataset.place)],Xe=De?Je(De.run,De.place.time):Wn>4?null:ks(...Xn(X));Xe&&ps(Xe)}),h(de,"wheel",X=>{!X.ctrlKey&&a.activeElement!==de||(X.preventDefault(),he(),E.zoom(Math.exp(Math.max(-60,Math.min(60,X.deltaY))*.003),...Xn(X)))},{passive:!1}),h(de,"keydown",X=>{let _e=(Xe,Ge)=>()=>{X.shiftKey?E.shift(5*Xe,5*Ge):E.turn(Xe,Ge)},De={ArrowLeft:_e(-6,0),ArrowRight:_e(6,0),ArrowUp:_e(0,-6),ArrowDown:_e(0,6),Home:ne," ":fn,"+":()=>E.zoom(.8),"=":()=>E.zoom(.8),"-":()=>E.zoom(1.25)};!De[X.key]||X.altKey||X.ctrlKey||X.metaKey||(X.preventDefault(),he(),De[X.key]())});function ms(X){u.magnification.value=Number(Math.min(Math.max(X,1),Jm).toPrecision(2)),me.textContent=Ee.ariaValueText=`error × ${u.magnification.value.toLocaleString("en")}`,K()}h(Ee,"input",()=>{he(),ms(10**Number(Ee.value))}),h(ct,"change",()=>Gt());let Un=!1,Jt={};function Gt(){let X=getComputedStyle(i),_e=ve=>X.getPropertyValue(`--p-${ve}`).trim(),De=ct.value==="error",Xe=Ym(i.closest(".cl-dark")!==null),Ge=(ve,Se)=>ve.forEach(Le=>Le.paint(Ac(_e(Se))));Ge([z],"path"),Ge([T],"rapid"),Ge(D,"band"),Ge([F,...I.map(ve=>ve.halo)],"picked"),I.forEach(({run:ve,lines:Se})=>Se.paint(De?null:Ac(qn(ve.colour,_e("paper"))))),Xe.forEach((ve,Se)=>u.scale.value[Se].set(...ve));let S=Math.max(...V().map(ve=>ve.top),0)||1,U=It("div",{className:"path-scale"}),H=It("i");u.top.value=S;let Y=Xe.map(ve=>`rgb(${ve.map(Se=>Math.round(255*Se)).join(" ")})`);U.style.background=`linear-gradient(90deg, ${Y.join(", ")})`,H.style.left=`${100*(b??0)/S}%`,b!==null&&b<=S&&U.append(H);let J=It("div",{className:"path-ends"},It("span",{},"0"),It("span",{},Ft(S,"um",3))),xe=[...De?["error"]:[],...b===null?[]:[`tolerance ${Ft(b,"um")}`]];re.replaceChildren(xe.join(", "),...De?[U,J]:[]),zs(lr)}function Kt(){let X=!E.width,_e=Un?2:devicePixelRatio||1;!de.clientWidth||!de.clientHeight||([E.width,E.height]=[de.clientWidth,de.clientHeight],d.renderer.setPixelRatio(_e),d.renderer.setSize(E.width,E.height,!1),u.pixel.value.set(2/(E.width*_e),2/(E.height*_e)),B=Math.max(Math.round(_e),1),F.width(4*B),I.forEach(De=>De.halo.width(6*B)),X&&ne(),N())}function Kn(X){X&&(Jt={target:E.target,span:E.span}),Un=X,[de.style.width,de.style.height]=X?ub.map(_e=>`${_e}px`):["",""],Gt(),Kt(),X?ne():Object.assign(E,Jt),N(),[k.width,k.height,k.hidden]=[s.width,s.height,!X],X&&k.getContext("2d").drawImage(s,0,0)}function Fn(){if(Un!==pi())return Kn(pi());Gt(),Kt()}h(s,"webglcontextrestored",K),qe.value="1",_t(),Ee.value=String(Math.log10(e.magnification)),ms(e.magnification),E.turn(0,0),Gt(),Kt(),pi()&&Kn(!0);function Di(){for(let X of e.runs.slice(I.length)){let _e=$(X,I.length);I.push(_e),_e.halo.width(6*B),Xt(_e,!0)}O(),I.filter(({run:X,of:_e})=>X.size!==_e).forEach(X=>{let{places:_e,index:De}=Object.assign(X,q(X.run));ge?.run===X.run&&(ge=null),X.lines.fill(_e,De),X.halo.fill(_e,De.slice())}),he(),Gt()}return{highlight:zs,resize:Fn,update:Di,destroy(){c.abort(),_t(),cancelAnimationFrame(M),clearTimeout(Z),le.disconnect(),d.destroy(),a.adoptedStyleSheets=a.adoptedStyleSheets.filter(X=>X!==l),i.classList.remove("cl-path"),i.replaceChildren()}}}var Qm=`"use strict";(()=>{function I({start:b,coefficients:e,closed:s},n){let u=b.values,o=e.values,f=u.length-2,p=u[f+1],i=0;return(m,l)=>{for(s&&(m-=p*Math.floor(m/p));i<f&&m>=u[i+1];)i+=1;for(;i>0&&m<u[i];)i-=1;let r=m-u[i];for(let a=0,t=6*n*i;a<n;a+=1,t+=6)l[a]=o[t]+r*(o[t+1]+r*(o[t+2]+r*(o[t+3]+r*(o[t+4]+r*o[t+5])))),l[n+a]=o[t+1]+r*(2*o[t+2]+r*(3*o[t+3]+r*(4*o[t+4]+r*5*o[t+5]))),l[2*n+a]=2*o[t+2]+r*(6*o[t+3]+r*(12*o[t+4]+r*20*o[t+5]))}}var P=class{constructor(e){this.given=e;let s=new WebAssembly.Memory({initial:Math.ceil(e.n_word/8192)}),n=new WebAssembly.Instance(new WebAssembly.Module(e.code.values),{env:{memory:s}});this.memory=new Float64Array(s.buffer),this.loop=n.exports,this.early=Math.max(0,e.short[0]-Math.round(2/e.motion.period)),e.words.forEach(({at:u,values:o})=>this.memory.set(o.values,u)),this.plan(),this.rest=this.state()}given;memory;loop;rest;early;atEarly=[];plan(){let{memory:e,given:{motion:{period:s,n_sample:n,spans:u,duration:o,length:f,path:p},inputs:i,ahead:m,position:l}}=this,r=l.length,a=u.shape[1],[t,y,c,d,E]=[0,1,2,3,4].map(h=>u.values.subarray(h*a,(h+1)*a)),A=I(p,r),M=new Float64Array(3*r),v=h=>i+n*h;for(let h=0,g=0;h<n;h+=1){for(;g+1<a&&h*s>=t[g+1];)g+=1;let F=h*s<o,k=h*s-t[g],x=F?c[g]+k*(d[g]+k*E[g]/2):0,N=F?y[g]+k*(c[g]+k*(d[g]/2+k*E[g]/6)):f,C=F?d[g]+k*E[g]:0;A(N,M);for(let w=0;w<r;w+=1)e[v(w)+h]=M[w],e[v(r+w)+h]=M[r+w]*x,e[v(2*r+w)+h]=M[2*r+w]*x*x+M[r+w]*C;e[v(3*r)+h]=N,e[v(3*r+1)+h]=x}m.forEach((h,g)=>{for(let F=0;F<n;F+=1)e[v(3*r+2+g)+F]=e[v(g)+Math.min(F+h,n-1)]})}state(){return this.given.state.map(([e,s])=>this.memory.slice(e,s))}restore(e){this.given.state.forEach(([s],n)=>this.memory.set(e[n],s))}begin(e){return this.restore(this.rest),this.given.parameters.forEach(({word:s,value:n})=>{this.memory[s]=n??1/0}),e.forEach(([s,n])=>{this.memory[s]=n}),this.loop.prepare()!==0}first(e){let{early:s,given:{motion:n}}=this,u=performance.now();return this.begin([]),this.loop.run(0,s),this.atEarly=this.state(),this.loop.run(s,n.n_sample-s),[!1,!0].map(o=>this.found({id:0,run:e,values:[],short:o},u))}async answer(e,s){let{loop:n,early:u,given:{short:o,motion:f}}=this,[p,i]=e.short?[u,o[1]]:[0,f.n_sample],m=performance.now();if(!this.begin(e.values))return this.none(e);e.short&&this.restore(this.atEarly);for(let l=p;l<i;l+=8192)if(n.run(l,Math.min(8192,i-l)),!e.short&&await s())return null;return this.found(e,m)}none=({id:e,run:s,short:n})=>({id:e,run:s,short:n,begun:n?this.early:0,took:0,failed:null,figures:{},points:null});found(e,s){let{memory:n,loop:u,given:{short:o,motion:f,failed_at:p}}=this,i=this.none(e);if(n[p]>=0)return{...i,failed:n[p]};let[m,l]=e.short?o:[0,f.n_sample];e.short||u.judge();let r=e.short?this.around(m,l):Object.fromEntries(this.given.figures.map(([a,t])=>[a,n[t]]));return{...i,figures:r,points:this.points(m,l),took:performance.now()-s}}logged=(e,s)=>this.memory[this.given.log+e*this.given.n_log+s];around(e,s){let{part_error:n,doubt:u,judged:o}=this.given,f=0,p=0,i=0,m=0;for(let[l,r]of o)for(let a=Math.max(l,e);a<Math.min(r,s);a+=1){let t=Math.abs(this.logged(a,n));f+=1,p+=t*t,i=Math.max(i,t);for(let y of u)m+=this.logged(a,y)}return{part_error_max:i,part_error_rms:Math.sqrt(p/(f||1)),unsure:m}}kept(e,s){let{judged:n,part_error:u}=this.given,o=Math.max(e,n[0][0]),f=Math.min(s,n.at(-1)[1]),p=[],i=Math.max(1,Math.ceil((f-o)/4e3)),m=r=>Math.abs(this.logged(r,u)),l=(r,a,t)=>{for(let y=r;y<a;y+=i){let c=y;for(let d=y+1;t&&d<Math.min(y+i,a);d+=1)m(d)>m(c)&&(c=d);p.push([y,t]),c!==y&&p.push([c,t])}a>r&&p.at(-1)[0]!==a-1&&p.push([a-1,t])};return n.forEach(([r,a],t)=>{l(Math.max(o,t?n[t-1][1]:o),Math.min(r,f),0),l(Math.max(o,r),Math.min(a,f),t+1)}),p}points(e,s){let{part_error:n,foot:u,position:o,asked:f,motion:p,inputs:i}=this.given,m=this.kept(e,s),l=m.length,r=o.length,a=I(f,r),t=new Float64Array(3*r),y=i+(3*r+1)*p.n_sample,c={time:new Float64Array(l),signed:new Float32Array(l),size:new Float32Array(l),stretch:Int32Array.from(m,([,d])=>d),foot:new Float32Array(r*l),error:new Float32Array(r*l),feedrate:new Float32Array(l)};return m.forEach(([d,E],A)=>{let M=o.map(v=>this.logged(d,v));E?a(this.logged(d,u),t):t.set(M),c.time[A]=d*p.period,c.feedrate[A]=this.memory[y+d]*6e4,c.signed[A]=E?this.logged(d,n)*1e6:NaN,c.size[A]=E?Math.abs(c.signed[A]):0,M.forEach((v,h)=>{c.foot[r*A+h]=t[h]*1e3,c.error[r*A+h]=(v-t[h])*1e6})}),c}},z=[],j=new MessageChannel,_=null,L=!1,U=()=>new Promise(b=>{j.port1.onmessage=()=>b(_!==null),j.port2.postMessage(0)}),R=b=>postMessage(b,{transfer:Object.values(b.points??{}).map(e=>e.buffer)});async function q(){for(L=!0;_;){let b=_;_=null;let e=await z[b.run].answer(b,U);e&&R(e)}L=!1}addEventListener("message",({data:b})=>{if("loop"in b)return(z[b.run]=new P(b.loop)).first(b.run).forEach(R);_=b,L||q()});})();
`;var gb=60,_b=60,eg="changed settings",tg="settings before",Ju="#8a949e",ng=["#d55e00","#cc79a7","#56b4e9"],xb=[["part_error_max","largest part error [um]",1e6],["part_error_rms","part error, rms [um]",1e6],["tracking_error_max","largest tracking error [um]",1e6],["command_largest","largest command [% of the limit]",100],["unsure","samples, nearest point uncertain",1]],fs=i=>({values:i,shape:[i.length]}),Pc=({name:i})=>i.replace(/^(controller\.)?axes\.[^.]+\./,"$1axes.*."),Ku=({name:i})=>/(?:^|\.)axes\.([^.]+)\./.exec(i)?.[1]??"",ju=i=>i.split(".").slice(-2).join(" ").replaceAll("_"," "),Ic=i=>JSON.stringify([...i].sort()),Lc=i=>i.value??1/0;function ig({size:i,stretch:e}){return i.reduce((t,n,s)=>e[s]&&(n>i[t]||!e[t])?s:t,0)}function sg(i,e){if(!i)return 0;let t=i.time.values,n=ua(t,e);return i.lines.values[t[n+1]-e<e-t[n]?n+1:n]}var rg=({display:i,factor:e},t)=>Number.isFinite(t)?`${Number((t*e).toPrecision(15))} ${i}`.trim():"inf";function vb(i,e){let t=o=>Ft(o*i.factor,i.display),{minimum:n,maximum:s}=i,r=`${ju(i.name)} of ${Ku(i)||"all axes"} = ${t(e)}`;return n!==null&&(e<n||i.exclusive&&e===n)?`${r} must be ${i.exclusive?"more than":"at least"} ${t(n)}`:s!==null&&e>s?`${r} must be at most ${t(s)}`:""}function og(i,e,t){let n=e.runs.length&&(typeof WebAssembly!="object"||typeof Worker!="function");if(n||!e.runs.length)return n&&Ze(i,"p","note","The sliders need WebAssembly and workers, which this browser does not offer."),{resize(){},destroy(){i.replaceChildren()}};let s=t.pictures.find(B=>B.kind==="PathScene"),r=t.pictures.find(B=>B.key==="error-time"),o=s?.tolerance??r?.panels[0].band?.[1]??null,a=s?.runs.map(B=>B.colour)??[],l=ng.find(B=>!a.includes(B))??ng[0],[c,h]=[[tg,Ju],[eg,l]].map(([B,W])=>({kind:"SceneRun",name:B,colour:W,...Ve(null,0)})),d=-1,u=new Map,f=[],g=0,y=[],m=1,p=0,v=0,A=null,b=0,P=0,C=u,x=1/0,T=0,z,F=e.runs.map(()=>({})),D=null,q=[],$=new AbortController,{signal:I}=$,V=(B,W,ae)=>{let le=Ze(B,"button","",W);return le.type="button",le.addEventListener("click",ae),le},te=(B,W,ae,le)=>{let K=Object.assign(Ze(B,"select"),{ariaLabel:W});return ae.forEach((ne,he)=>K.add(new Option(ne,String(he)))),K.addEventListener("change",()=>le(Number(K.value))),K},k=Ze(i,"div","cl-tools"),pe=te(k,"Run",e.runs.map(B=>B.name),it),Q=Object.assign(Ze(k,"select"),{ariaLabel:"More parameters"});Q.addEventListener("change",()=>{Dt(Q.value),kt()});let re=V(k,"Undo",()=>pt(-1)),ce=V(k,"Redo",()=>pt(1)),de=V(k,"Reset",()=>rn(new Map)),me=Ze(i,"div","live-rows"),oe=Object.assign(Ze(i,"p","live-said"),{ariaLive:"polite"}),be=Ze(i,"div","cl-sides"),Ee=Ze(be,"div"),Ce=Ze(Ze(be,"div","scroll"),"table","figures slim tight live-table"),Te=Ze(i,"div","cl-tools"),We=V(Te,"Copy the command line",()=>{E()});V(Te,"Save as controller file",M);let nt=Ze(Te,"span"),qe=Ze(i,"pre","command"),ct=Ze(qe,"code"),rt=(B,W)=>{oe.textContent=B,i.dataset.shows=W};pe.hidden=e.runs.length===1,We.hidden=qe.hidden=!e.command,i.addEventListener("keydown",B=>{let W=B.key.toLowerCase();!(B.ctrlKey||B.metaKey)||!["z","y"].includes(W)||(B.preventDefault(),pt(W==="y"||B.shiftKey?1:-1))},{signal:I}),["pointerenter","focusin"].forEach(B=>i.addEventListener(B,Xt,{signal:I}));function it(B){[d,y,u,f,g,z]=[B,[],new Map,[{values:new Map}],0,void 0],P=b,s?.runs.forEach(j=>oa.delete(j)),oa.add(c),[c,h].forEach(j=>Object.assign(j,Ve(null,d))),s?.runs.includes(h)&&t.changed(s);let{name:W,parameters:ae,short:le,motion:{period:K}}=e.runs[d],ne=[...new Set(ae.map(Pc))];me.replaceChildren(),Q.replaceChildren(new Option("more parameters","")),ne.sort((j,ee)=>Number(ee.startsWith("controller"))-Number(j.startsWith("controller"))).forEach(j=>Q.add(new Option(ju(j),j)));let he=ne.filter(j=>ae.some(ee=>ee.value&&Pc(ee)===j)),N=he.filter(j=>ae.some(ee=>ee.first&&ee.value&&Pc(ee)===j));if((N.length?N:he.slice(0,5)).forEach(Dt),r){let[j]=r.panels,ee=j.curves.find(ge=>ge.name===W),ye=fs(new Float64Array(0));q=[{...ee,dash:"dash"},{name:tg,colour:Ju,dash:"dot"},{name:eg,colour:l,dash:"solid",width:2}].map(ge=>({kind:"Curve",x:ye,y:ye,name:"",colour:Ju,width:1.3,half:null,numbers:null,...ge})),D?.destroy(),D=Ca(Ee,{...r,panel_height:170,panels:[{...j,curves:q}]}),D.zoom([le[0]*K,le[1]*K])}A&&Xt(),kt(),bt(null),rt("Drag a slider: the loop runs in this page.","report")}function Dt(B){let W=e.runs[d].parameters.filter(j=>Pc(j)===B),ae=ju(B);if(!W.length)return;let le=Ze(me,"div","live-row"),K=Ze(le,"span","live-name",ae),ne=Object.assign(Ze(le,"input"),{type:"range",min:"-1",max:"1",step:"0.01",ariaLabel:ae}),he=Object.assign(Ze(le,"input"),{type:"number",step:"any",ariaLabel:`${ae}, value`}),N={taken:W,slider:ne,field:he,unit:Ze(le,"span","live-unit")};K.title=W.map(j=>j.name).join(`
`),W.length>1&&te(K,`Axes of ${ae}`,["all axes",...W.map(Ku)],j=>{N.taken=j?[W[j-1]]:W,kt()}),ne.addEventListener("input",()=>{let j=Number(ne.value);Mt(N,ee=>j?Number((ee*10**j).toPrecision(3)):ee)}),ne.addEventListener("change",()=>{m+=1}),he.addEventListener("change",()=>{let j=he.valueAsNumber;Number.isFinite(j)?Mt(N,(ee,{factor:ye})=>Ct(N)?j/ye:ee*j):kt(),m+=1}),y.push(N),[...Q.options].find(j=>j.value===B)?.remove()}let Ct=({taken:B})=>B.every(W=>W.value===B[0].value),Wt=()=>e.runs[d].parameters.filter(B=>u.has(B.name)).map(B=>[B,u.get(B.name)]);function Mt(B,W){for(let ae of B.taken){let le=W(Lc(ae),ae),K=ae.whole?Math.round(le):le;K===Lc(ae)?u.delete(ae.name):u.set(ae.name,K)}O(B)}function rn(B){u=new Map(B),m+=1,O(),m+=1}function pt(B){let W=g+(B>0||Ic(u)===Ic(f[g].values)?B:0);f[W]&&(g=W,rn(f[W].values))}function kt(B){for(let ae of y){let[le]=ae.taken,K=Lc(le),ne=u.get(le.name)??K,he=ne/K,{slider:N,field:j,unit:ee}=ae;N.disabled=!Number.isFinite(K)||K===0,ae!==B&&(N.value=String(Math.log10(he>0?he:1))),j.value=Number.isFinite(ne)?String(Number((Ct(ae)?ne*le.factor:he).toPrecision(5))):"",ee.textContent=Ct(ae)?le.display:"times",N.ariaValueText=`${j.value} ${ee.textContent}`}let W=Wt();[re.disabled,ce.disabled,de.disabled]=[!g&&!W.length,g+1>=f.length,!W.length],nt.textContent=W.some(([ae])=>!ae.name.startsWith("controller."))?"The controller file lacks the values of the machine.":"",ct.textContent=[e.command,...W.map(([ae,le])=>`--set "${ae.name}=${rg(ae,le)}"`)].join(" "),i.classList.toggle("live-same",!W.length)}let Vt=new Set;function Xt(){if(!A){let B=URL.createObjectURL(new Blob([Qm],{type:"text/javascript"}));A=new Worker(B),A.addEventListener("message",({data:W})=>et(W)),A.addEventListener("error",W=>rt(`The loop cannot run here: ${W.message}.`,"none")),URL.revokeObjectURL(B)}Vt.has(d)||A.postMessage({run:d,loop:e.runs[d]}),Vt.add(d)}function O(B){p=m,kt(B),clearTimeout(T);let W=Wt().map(([ae,le])=>vb(ae,le)).find(Boolean);if(W)return rt(`Not possible: ${W}.`,"none");Xt(),delete i.dataset.shows,Ie(x>_b)}function Ie(B){C=new Map(u),b+=1,A.postMessage({id:b,run:d,values:Wt().map(([W,ae])=>[W.word,ae]),short:B})}function et(B){let{id:W,run:ae,short:le,points:K,failed:ne}=B;if(W||(F[ae][le?"short":"whole"]=B,ae===d&&bt(null)),!(W<=P)){if(W===b&&le&&(T=window.setTimeout(()=>Ie(!1),gb)),!K){let he=Ft((ne??0)*e.runs[d].motion.period,"s",5),N=ne===null?"Not possible: these values do not fit together":`At ${he} an axis leaves its limit of following error`;return rt(`${N}. The pictures show the values before.`,"none")}W===b&&!le&&ot(B),bt(B)}}function ot(B){x=B.took,Ic(f[g].values)!==Ic(C)&&(f=[...f.slice(0,g+(p===v&&g?0:1)),{values:C}],[g,v]=[f.length-1,p]),f[g].answer=B;let W=g>1?f[g-1].answer:void 0;W!==z&&Object.assign(c,Ve(W?.points,d,Re())),z=W,kt()}let Re=()=>s?.runs.find(B=>B.name===e.runs[d].name);function bt(B){let W=Re();[F[d].whole,z,B].forEach((ae,le)=>{let K=ae?.points,ne=new Float64Array(0);q[le]&&(K||le)&&Object.assign(q[le],{x:fs(K?.time??ne),y:fs(K?.signed??ne)})}),D?.update?.(),Ke(B,W),!(!s||!B)&&(Object.assign(h,Ve(B.points,d,W)),s.runs.includes(h)||s.runs.push(c,h),W&&oa.add(W),t.changed(s))}function Ve(B,W,ae){let le=B?.time.length??0,K=[...new Set(e.runs[W].parameters.map(Ku).filter(Boolean))],ne=(s?.axes??[]).map(Je=>K.indexOf(Je)),he=new Float32Array(0),N=(Je=he)=>{let ue=new Float32Array(3*le);for(let Ne=0;Ne<le;Ne+=1)ne.forEach((Fe,we)=>{ue[3*Ne+we]=Je[K.length*Ne+Fe]});return fs(ue)},j=N(B?.foot),ee=N(B?.error),ye=Int32Array.from(B?.time??[],Je=>sg(ae,Je)),ge=B?ig(B):0,Ae=({values:Je})=>[...Je.subarray(3*ge,3*ge+3)],Ye=B?[{kind:"Place",foot:Ae(j),error:Ae(ee),size:B.size[ge],time:B.time[ge],line:ye[ge],cause:""}]:[];return{foot:j,error:ee,worst:Ye,lines:fs(ye),size:fs(B?.size??he),time:fs(B?.time??he),feedrate:fs(B?.feedrate??he),stretch:fs(B?.stretch??he)}}function Ke(B,W){let ae=B?.short??!1,le=F[d][ae?"short":"whole"],{motion:{period:K},short:[ne,he]}=e.runs[d];if(Ce.replaceChildren(),!le?.points)return;let N=[["report",le],["before",ae?null:z],["now",B]].filter(Fe=>!!Fe[1]),j=Ze(Ze(Ce,"thead"),"tr"),ee=Ze(Ce,"tbody");["",...N.map(([Fe])=>Fe)].forEach(Fe=>{Ze(j,"th","n",Fe).scope="col"});let ye=(Fe,we)=>{let tt=Ze(ee,"tr");Ze(tt,"th","",Fe).scope="row",N.forEach(([,_t])=>we(_t,Ze(tt,"td","n")))};o!==null&&ye(`tolerance ${Ft(o,"um")}`,(Fe,we)=>{let tt=Fe.figures.part_error_max*1e6<=o;we.classList.toggle("poor",!tt),Ze(we,"span","seal",tt?"PASS":"FAIL")});for(let[Fe,we,tt]of xb)N.some(([,_t])=>_t.figures[Fe])&&ye(we,(_t,fn)=>{fn.textContent=Ft(_t.figures[Fe]*tt)});if(ye("worst place",({points:Fe},we)=>{let tt=Fe.time[ig(Fe)],_t=sg(W,tt);we.textContent=Ft(tt,"s",5)+(_t?`, line ${_t}`:"")}),!B)return;let[ge,Ae,Ye]=[ne,he,B.begun].map(Fe=>Ft(Fe*K,"s",5)),Je=ae?`Short run, from ${ge} to ${Ae}, begun with the state of the report at ${Ye}`:"Whole part",[ue,Ne]=[le,B].map(Fe=>Ft(Fe.figures.part_error_max*1e6,"um"));rt(`${Je}: largest part error ${Ne}, with the report's values ${ue}.`,ae?"short":"whole")}async function E(){try{await navigator.clipboard.writeText(ct.textContent),We.textContent="Copied"}catch{getSelection()?.selectAllChildren(ct),We.textContent="Selected: press Ctrl-C"}setTimeout(()=>{We.textContent="Copy the command line"},2e3)}function M(){let B=new Map(e.runs[d].parameters.map(K=>[K.name,rg(K,u.get(K.name)??Lc(K))])),W=e.runs[d].controller.replace(/(\{value = )?"@([^"]+)@"(.*\})?/g,(K,ne="",he,N="")=>{let j=JSON.stringify(B.get(he)).replace(/^"([^ ]*)"$/,"$1");return u.has(he)?j:ne+j+N}),ae=document.createElement("a"),le=URL.createObjectURL(new Blob([W],{type:"application/toml"}));Object.assign(ae,{href:le,download:"controller.toml"}).click(),setTimeout(()=>URL.revokeObjectURL(le),1e3)}let Z=e.runs.map(({name:B})=>Math.max(0,...(s?.runs.find(W=>W.name===B)?.worst??[]).map(({size:W})=>W)));return pe.value=String(Z.indexOf(Math.max(...Z))),it(Number(pe.value)),{resize(){D?.resize()},destroy(){A?.terminate(),clearTimeout(T),D?.destroy(),$.abort(),i.replaceChildren()}}}var Qu="contourlab-page/1";var td=i=>new Response(new Blob([i]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();function nd(i){let e=new DataView(i).getUint32(0,!0),t=JSON.parse(new TextDecoder().decode(new Uint8Array(i,4,e)));if(t.contract!==Qu)throw new Error(`message of ${t.contract}, this viewer reads ${Qu}`);return t.pictures.map(n=>ed(n,i,4+e))}function ed(i,e,t){if(Array.isArray(i))return i.map(n=>ed(n,e,t));if(i===null||typeof i!="object")return i;if("dtype"in i){let n={f4:Float32Array,f8:Float64Array,i4:Int32Array,u1:Uint8Array},s=i.shape.reduce((o,a)=>o*a,1),r=n[i.dtype];return{values:new r(e,t+i.at,s),shape:i.shape}}return Object.fromEntries(Object.entries(i).map(([n,s])=>[n,ed(s,e,t)]))}function ag(i){let t=(i&&i.length>1?document.getElementById(i.slice(1)):null)?.querySelector("details");t&&(t.open=!0)}function yb(i){let e=i.closest("table"),t=e.tBodies[0],n=i.getAttribute("aria-sort")!=="descending",s=r=>{let o=r.cells[i.cellIndex].textContent;return o==="-"?-1/0:Number(o)};e.querySelectorAll("th").forEach(r=>r.removeAttribute("aria-sort")),i.setAttribute("aria-sort",n?"descending":"ascending"),t.append(...[...t.rows].sort((r,o)=>(n?-1:1)*(s(r)-s(o))||0))}function Sb(i,e){let t=document.querySelector(`#lines tr[data-line="${i}"]`),n=document.getElementById("picked");document.querySelectorAll("#lines tr.picked").forEach(r=>r.classList.remove("picked")),n&&(n.textContent=`Line ${i}${t?`: ${t.querySelector("code").textContent}`:" is not in the table"}`);let s=t?.closest(".lines");t?.classList.add("picked"),t&&s&&e&&(s.scrollTop=t.offsetTop-s.clientHeight/2)}function lg(i){let e=document.getElementById("picked");e&&(e.textContent="Click on a line of the program below.");let t=(n,s=!0)=>{Sb(n,s),i(n)};return document.querySelectorAll("a[href^='#']").forEach(n=>n.addEventListener("click",()=>{ag(n.getAttribute("href")),n.dataset.pick&&t(Number(n.dataset.pick))})),document.querySelectorAll("#lines th button").forEach(n=>n.addEventListener("click",()=>yb(n.closest("th")))),document.querySelector("#lines tbody")?.addEventListener("click",n=>{let s=n.target.closest("tr[data-line]");s&&t(Number(s.dataset.line),!1)}),document.querySelector(".lines")?.addEventListener("keydown",n=>{let s={ArrowDown:1,ArrowUp:-1}[n.key],r=[...document.querySelectorAll("#lines tr[data-line]")];if(!s||n.target.closest("button")||!r.length)return;let o=r.findIndex(a=>a.classList.contains("picked"));t(Number(r[Math.min(Math.max(o<0?0:o+s,0),r.length-1)].dataset.line)),n.preventDefault()}),ag(location.hash),t}var Mb=560,bb=34;function hg(i){let e=0;for(let{y:n}of i)for(let s=0;s<n.length;s+=1)Math.abs(n[s])>e&&(e=Math.abs(n[s]));if(e<=0)return[1,3];let t=ha(e/2);return[t,t*Math.ceil(1.05*e/t)]}var Dc=class{constructor(e,t,n,s=[],r=[]){this.host=e;this.curves=t;this.rings=n;this.marks=s;this.axes=r;let o=Ze(e,"div","cl-panel");this.canvas=Ze(o,"canvas"),this.tip=new ys(o),this.canvas.addEventListener("pointermove",a=>this.pointed(a)),this.canvas.addEventListener("pointerleave",()=>this.tip.hide())}host;curves;rings;marks;axes;canvas;tip;radius=0;middle=0;at(e,t){let n=this.rings[1],s=this.radius*(t+2*n)/(3*n),r=e*Math.PI/180;return[this.middle+s*Math.cos(r),this.middle-s*Math.sin(r)]}draw(){let e=Math.min(_r(this.host),pi()?420:Mb),t=Ss(this.host),n=da(this.canvas,e,e),[s,r]=this.rings,o=Math.round(r/s);this.middle=e/2,this.radius=e/2-bb,n.fillStyle=t.muted,n.textAlign="center",n.textBaseline="middle";for(let a=0;a<360;a+=45)n.strokeStyle=t.line,cg(n,[this.at(a,-2*r),this.at(a,r)]),n.fillText((a%180?this.axes[1]:this.axes[0])&&a%90===0?`${a>=180?"-":"+"}${this.axes[a%180?1:0]}`:`${a}°`,...this.at(a,r*(1+45/this.radius)));for(let a=-2*o;a<=o;a+=1)n.strokeStyle=a?t.line:t.ink,n.lineWidth=1.1,n.beginPath(),n.arc(this.middle,this.middle,this.radius*(a+2*o)/(3*o),0,7),n.stroke();for(let{x:a,y:l,colour:c,dash:h,alpha:d}of this.curves())n.strokeStyle=qn(c,t.card),n.globalAlpha=d??1,n.lineWidth=1.5,n.setLineDash(vr[h]),cg(n,Array.from(a,(u,f)=>this.at(u,l[f])));n.globalAlpha=1,n.setLineDash([]);for(let{x:a,y:l,colour:c}of this.marks){n.strokeStyle=qn(c,t.card);for(let h=0;h<a.length;h+=1)n.beginPath(),n.arc(...this.at(a[h],l[h]),4.5,0,7),n.stroke()}for(let a=-o;a<=o;a+=1){if(a%2&&a!==o)continue;let[l,c]=this.at(67.5,a*s),h=(a>0?"+":"")+Ft(a*s)+(a===o?" um":"");n.lineWidth=3,n.strokeStyle=t.card,n.strokeText(h,l,c),n.fillText(h,l,c)}}pointed(e){let t=576,n=null;for(let a of this.curves())for(let l=0;l<a.x.length;l+=1){let[c,h]=this.at(a.x[l],a.y[l]),d=(c-e.offsetX)**2+(h-e.offsetY)**2;d<t&&([t,n]=[d,[a,l]])}if(!n)return this.tip.hide();let[s,r]=n,o=(s.x[r]%360+360)%360;this.tip.show(e.offsetX,e.offsetY,[[s.name,s.colour],[`${Ft(s.y[r],"um",3)} at ${o.toFixed(1)}°`]])}};function cg(i,e){i.beginPath();let t=!1;for(let[n,s]of e){let r=Number.isFinite(n)&&Number.isFinite(s);r&&t?i.lineTo(n,s):r&&i.moveTo(n,s),t=r}i.stroke()}function ug(i,e){let t=a=>({...a,x:a.x.values,y:a.y.values}),n=e.curves.map(t),s=new Set,r,o=()=>{i.replaceChildren();let a=Ss(i);uo(i,n.map(l=>({...l,colour:qn(l.colour,a.card)})),s,()=>r.draw()),r=new Dc(i,()=>n.filter(l=>!s.has(l.name)),hg(n),e.marks.map(t)),r.draw()};return o(),{resize:o,destroy:()=>i.replaceChildren()}}function wb(i){let e=0,t=0,n=0,s=0,r=0,o=0,a=0,l=0,c=0,h=1/0,d=-1/0,u=m=>i.forEach(({angle:p,deviation:v})=>{for(let A=0;A<p.length;A+=1)m(Math.cos(p[A]*Math.PI/180),Math.sin(p[A]*Math.PI/180),v[A])});u((m,p,v)=>{e+=m*m,t+=m*p,n+=p*p,s+=m,r+=p,o+=1,a+=v*m,l+=v*p,c+=v}),e-=s*s/o,n-=r*r/o,t-=s*r/o,a-=c*s/o,l-=c*r/o;let f=e*n-t*t,g=(a*n-l*t)/f,y=(l*e-a*t)/f;return u((m,p,v)=>{h=Math.min(h,v-g*m-y*p),d=Math.max(d,v-g*m-y*p)}),d-h}function dg(i,e){let t=e.causes.map(()=>1),{runs:n}=e,s=(v,A)=>n.map(b=>{let P=b.deviation.values.length,C=Float64Array.from(b.deviation.values);return v.forEach((x,T)=>{if(x!==1)for(let z=0;z<P;z+=1)C[z]-=(1-x)*b.curves.values[T*P+z]}),{name:b.name,colour:b.colour,dash:"solid",x:b.angle.values,y:C,alpha:A}}),r=v=>Ft(wb(v.map(({x:A,y:b})=>({angle:A,deviation:b}))),"um",3),o=s(t,.3),a=hg(o),l=s(t),c,h=Ze(i,"div","cl-sides"),d=Ze(h,"div"),u=Ze(h,"div"),f=Ze(u,"p");f.append("Circular deviation: ");let g=Ze(Ze(f,"b"),"output","",r(l));f.append(` of ${r(o)} as measured, least-squares centre.`);let y=e.causes.map((v,A)=>{let b=Ze(u,"label","cl-slider");Ze(b,"span","",v);let P=Ze(b,"input"),C=Ze(b,"output","","100 %");return Object.assign(P,{type:"range",min:"0",max:"100",value:"100"}),P.addEventListener("input",()=>{t[A]=Number(P.value)/100,C.textContent=`${P.value} %`,l=s(t),g.textContent=r(l),c.draw()}),P}),m=Ze(u,"p","cl-tools");for(let[v,A]of[["Remove all","0"],["As measured","100"]]){let b=Ze(m,"button","",v);b.type="button",b.addEventListener("click",()=>y.forEach(P=>{P.value=A,P.dispatchEvent(new Event("input"))}))}let p=()=>{d.replaceChildren();let v=Ss(i);uo(d,l.map(A=>({...A,colour:qn(A.colour,v.card)})),new Set,()=>{}),c=new Dc(d,()=>[...o,...l],a,[],e.axes),c.draw()};return p(),{resize:p,destroy:()=>i.replaceChildren()}}function Eb(i,e,t){switch(e.kind){case"Chart":return Ca(i,e);case"PolarChart":return ug(i,e);case"PathScene":return jm(i,e,t);case"Heat":return ep(i,e);case"CircleCauses":return dg(i,e);case"LiveLoop":return og(i,e,t)}}var Tb="details.fold:not([open]), .verdict details:not([open])",fg=i=>`${Math.round(i)} ${innerHeight}`,Nc=class{constructor(e,t,n){this.places=e;this.root=n;this.page={pick:t,pictures:[...e.values()],changed:a=>this.changed(a)};let s=n.getRootNode(),r=s instanceof ShadowRoot?s:document.head;r.querySelector("#cl-style")||r.appendChild(It("style",{id:"cl-style"},Md+bd)),e.forEach((a,l)=>this.watch.observe(l));let{signal:o}=this.gone;matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.dress(),{signal:o}),addEventListener("beforeprint",()=>this.paper(!0),{signal:o}),addEventListener("afterprint",()=>this.paper(!1),{signal:o});for(let a of[document.documentElement,document.body])this.themes.observe(a,{attributes:!0})}places;root;drawn=new Map;line=null;watch=new IntersectionObserver(e=>e.forEach(({isIntersecting:t,target:n})=>{t&&this.draw(n)}),{rootMargin:"600px 0px"});folds=[];themes=new MutationObserver(()=>this.dress());gone=new AbortController;dark=!1;sizes=new ResizeObserver(e=>e.forEach(({target:t,contentRect:n})=>{let s=t,r=fg(n.width);s.dataset.size!==r&&n.width>0&&(s.dataset.size=r,this.drawn.get(s)?.resize())}));page;dress(){let e=qc(this.root);this.root.classList.toggle("cl-dark",e)!==this.dark&&this.resize(),this.dark=e}draw(e){if(!(this.drawn.has(e)||e.closest("[hidden], details:not([open])"))){this.watch.unobserve(e),this.dress(),e.dataset.size=fg(e.clientWidth-parseFloat(getComputedStyle(e).paddingLeft)*2);try{let t=Eb(e,this.places.get(e),this.page);this.drawn.set(e,t),this.line!==null&&t.highlight?.(this.line),this.sizes.observe(e)}catch(t){e.textContent=`This picture could not be drawn: ${t.message}`,console.error(t)}e.dataset.drawn="1"}}changed(e){this.drawn.forEach((t,n)=>{this.places.get(n)===e&&t.update?.()})}highlight(e){this.line=e,this.drawn.forEach(t=>t.highlight?.(e))}resize(){this.drawn.forEach((e,t)=>{if(t.clientWidth)return e.resize();t.dataset.size="",this.sizes.unobserve(t),this.sizes.observe(t)})}paper(e){document.documentElement.classList.toggle("printing",e),e&&document.querySelectorAll(Tb).forEach(t=>{this.folds.push(t),t.open=!0}),this.root.classList.toggle("cl-dark",this.dark=qc(this.root)),this.resize(),e?this.places.forEach((t,n)=>this.draw(n)):this.folds.splice(0).forEach(t=>{t.open=!1})}destroy(){this.gone.abort(),[this.watch,this.sizes,this.themes].forEach(e=>e.disconnect()),this.drawn.forEach(e=>e.destroy())}};function Ab(i){let e=new Map;for(let n of nd(i)){let s=document.getElementById(n.key);s&&e.set(s,n)}let t=new Nc(e,lg(n=>t.highlight(n)),document.body)}function pg(i,e){let t=new Map;i.classList.add("cl-show");for(let s of nd(e)){let r=Ze(i,"details","fold");r.open=t.size<2,Ze(r,"summary","",s.title);let o=Ze(r,"div","plot");o.dataset.key=s.key,t.set(o,s),Ze(r,"p","",s.caption)}let n=new Nc(t,s=>n.highlight(s),i);return()=>{n.destroy(),i.replaceChildren()}}async function Cb({model:i,el:e}){let t=await td(i.get("message"));e.dataset.lmSuppressShortcuts="true";let n=pg(e,t);return Ze(e,"style","",`.${i.get("name")} { display: none; }`),n}return Lg(Rb);})();
