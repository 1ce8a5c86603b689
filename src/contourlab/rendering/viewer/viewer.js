"use strict";var contourlab=(()=>{var zc=Object.defineProperty;var Mg=Object.getOwnPropertyDescriptor;var Sg=Object.getOwnPropertyNames;var bg=Object.prototype.hasOwnProperty;var wg=(i,e)=>{for(var t in e)zc(i,t,{get:e[t],enumerable:!0})},Eg=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of Sg(e))!bg.call(i,s)&&s!==t&&zc(i,s,{get:()=>e[s],enumerable:!(n=Mg(e,s))||n.enumerable});return i};var Tg=i=>Eg(zc({},"__esModule",{value:!0}),i);var yb={};wg(yb,{page:()=>xb,show:()=>vb});var _d='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var xd=`.plot { position: relative; }
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
.live-row { display: grid; grid-template-columns: minmax(10rem, 1.3fr) minmax(6rem, 1fr) 6.5rem 4.5rem; gap: .7rem; align-items: center; padding: .2rem 0; font-size: .92rem; }
.live-row [type="range"] { width: 100%; accent-color: var(--accent, #0b5a94); }
.live-row [type="number"], .live-row select, .cl-tools select { font: inherit; color: var(--ink, #1d2733); background: var(--card, #fff); border: 1px solid var(--edge, #c9d0d7); border-radius: 6px; padding: .1rem .3rem; }
.live-row [type="number"] { width: 100%; text-align: right; }
.live-name { display: flex; flex-wrap: wrap; gap: .1rem .6rem; justify-content: space-between; }
.live-unit { color: var(--muted, #5b6774); }
.live-table.figures th, .live-table td { white-space: normal; min-width: 0; padding: .3rem .5rem; font-size: .875rem; }
.live-said { min-height: 1.6em; margin: .6rem 0 0; }
.cl-tools button:disabled { opacity: .45; cursor: default; }
@media (max-width: 640px) { .live-row { grid-template-columns: minmax(0, 1fr) 6.5rem 4.5rem; } .live-name { grid-column: 1 / -1; } }
@media print { .live-rows, .cl-tools, .live-same { display: none; } }
`;var Ws=()=>document.documentElement.classList.contains("printing");function _r(i){if(Ws())return 640;let e=getComputedStyle(i);return Math.max(i.clientWidth-parseFloat(e.paddingLeft)-parseFloat(e.paddingRight),200)}function Ye(i,e,t="",n=""){let s=document.createElement(e);return t&&(s.className=t),n&&(s.textContent=n),i.append(s),s}function bs(i){let e=getComputedStyle(i),t=(s,r)=>e.getPropertyValue(`--${s}`).trim()||r,n=t("card","#ffffff");return{card:n,ink:t("ink","#1d2733"),muted:t("muted","#5b6774"),line:t("line","#e4e8ec"),edge:t("edge","#b9c1c9"),band:Xn("#0f7b5f",n),limit:Xn("#a33b3b",n)}}function vd(i){let e=i.length===4?i.replace(/[0-9a-f]/gi,"$&$&"):i;return[1,3,5].map(t=>parseInt(e.slice(t,t+2),16))}function yd(i){let[e,t,n]=i.map(s=>s/255).map(s=>s<=.04045?s/12.92:((s+.055)/1.055)**2.4);return .2126*e+.7152*t+.0722*n}function Xn(i,e){let t=yd(vd(e)),n=vd(i);if(t>.2||n.some(Number.isNaN))return i;for(let s=0;s<12&&(yd(n)+.05)/(t+.05)<4.5;s+=1)n=n.map(r=>r+(255-r)*.12);return"#"+n.map(s=>Math.round(s).toString(16).padStart(2,"0")).join("")}var ha=i=>i.match(/\[(.*)\]$/)?.[1]??"",Vc=i=>i.replace(/\s*\[[^\]]*\]$/,"");function Rt(i,e="",t=4){let n=String(Number(i.toPrecision(t)));return e&&e!=="1"?`${n} ${e}`:n}function lo(i){let e=10**Math.floor(Math.log10(i)+1e-12);return([5,2].find(t=>t<=i/e*(1+1e-12))??1)*e}function ua(i,e,t,n){let s=Ye(i,"div","cl-legend"),r=e.filter((a,o)=>e.findIndex(l=>l.name===a.name)===o);for(let a of r){let o=Ye(s,"button");o.type="button";let l=Ye(o,"i",a.glyph?"cl-glyph":"",a.glyph??"");a.glyph||(l.style.borderTop=`3px ${{dash:"dashed",dot:"dotted"}[a.dash]??"solid"} ${a.colour}`),o.append(a.name),o.setAttribute("aria-pressed",String(!t.has(a.name))),o.addEventListener("click",()=>{t.delete(a.name)||t.add(a.name),o.setAttribute("aria-pressed",String(!t.has(a.name))),n()})}return s}var Ss=class{constructor(e){this.host=e;this.box=Ye(e,"div","cl-tip"),this.box.hidden=!0}host;box;show(e,t,n){this.box.replaceChildren();for(let[a,o]of n){let l=Ye(this.box,"div");o&&(Ye(l,"i").style.background=o),l.append(a)}this.box.hidden=n.length===0;let s=this.box.offsetWidth,r=e+14+s>this.host.clientWidth;this.box.style.left=`${Math.max(r?e-14-s:e+14,0)}px`,this.box.style.top=`${Math.max(Math.min(t,this.host.clientHeight-this.box.offsetHeight),0)}px`}hide(){this.box.hidden=!0}};function co(i,e,t){let n=Ws()?3:Math.max(devicePixelRatio,1);i.width=Math.round(e*n),i.height=Math.round(t*n),Object.assign(i.style,{width:`${e}px`,height:`${t}px`});let s=i.getContext("2d");return s.scale(n,n),s.clearRect(0,0,e,t),s.font=xr,s.lineJoin="round",s}var xr="12px system-ui, -apple-system, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif",vr={solid:[],dash:[7,4],dot:[2,3]};var Rg="uplot",Pg="u-hz",Ig="u-vt",Lg="u-title",Ng="u-wrap",Dg="u-under",Ug="u-over",Fg="u-axis",Ys="u-off",Og="u-select",Bg="u-cursor-x",kg="u-cursor-y",zg="u-cursor-pt",Vg="u-legend",Gg="u-live",Hg="u-inline",Wg="u-series",Xg="u-marker",Md="u-label",qg="u-value",fa="width",pa="height";var Sd="bottom",yr="left",Gc="right",rh="#000",bd=rh+"0",Hc="mousemove",wd="mousedown",Wc="mouseup",Ed="mouseenter",Td="mouseleave",Ad="dblclick",Yg="resize",$g="scroll",Cd="change",mo="dppxchange",ah="--",Ar=typeof window<"u",Zc=Ar?document:null,Sr=Ar?window:null,Zg=Ar?navigator:null,Nt,ho;function Jc(){let i=devicePixelRatio;Nt!=i&&(Nt=i,ho&&jc(Cd,ho,Jc),ho=matchMedia(`(min-resolution: ${Nt-.001}dppx) and (max-resolution: ${Nt+.001}dppx)`),$s(Cd,ho,Jc),Sr.dispatchEvent(new CustomEvent(mo)))}function ei(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Kc(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Kt(i,e,t){i.style[e]=t+"px"}function Si(i,e,t,n){let s=Zc.createElement(i);return e!=null&&ei(s,e),t?.insertBefore(s,n),s}function mi(i,e){return Si("div",i,e)}var Rd=new WeakMap;function Bi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",a=Rd.get(i);r!=a&&(i.style.transform=r,Rd.set(i,r),e<0||t<0||e>n||t>s?ei(i,Ys):Kc(i,Ys))}var Pd=new WeakMap;function Id(i,e,t){let n=e+t,s=Pd.get(i);n!=s&&(Pd.set(i,n),i.style.background=e,i.style.borderColor=t)}var Ld=new WeakMap;function Nd(i,e,t,n){let s=e+""+t,r=Ld.get(i);s!=r&&(Ld.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var oh={passive:!0},Jg={...oh,capture:!0};function $s(i,e,t,n){e.addEventListener(i,t,n?Jg:oh)}function jc(i,e,t,n){e.removeEventListener(i,t,oh)}Ar&&Jc();function bi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:ti((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function lf(i){return(t,n,s)=>{let r=-1,a=-1;for(let o=n;o<=s;o++)if(i(t[o])){r=o;break}for(let o=s;o>=n;o--)if(i(t[o])){a=o;break}return[r,a]}}var cf=i=>i!=null,hf=i=>i!=null&&i>0,xo=lf(cf),Kg=lf(hf);function jg(i,e,t,n=0,s=!1){let r=s?Kg:xo,a=s?hf:cf;[e,t]=r(i,e,t);let o=i[e],l=i[e];if(e>-1)if(n==1)o=i[e],l=i[t];else if(n==-1)o=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];a(h)&&(h<o?o=h:h>l&&(l=h))}return[o??Wt,l??-Wt]}function vo(i,e,t,n){let s=Fd(i),r=Fd(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let a=t==10?ns:uf,o=s==1?ti:gi,l=r==1?gi:ti,c=o(a(yn(i))),h=l(a(yn(e))),d=br(t,c),u=br(t,h);return t==10&&(c<0&&(d=Xt(d,-c)),h<0&&(u=Xt(u,-h))),n||t==2?(i=d*s,e=u*r):(i=mf(i,d),e=yo(e,u)),[i,e]}function lh(i,e,t,n){let s=vo(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var ch=.1,Dd={mode:3,pad:ch},ga={pad:0,soft:null,mode:0},Qg={min:ga,max:ga};function go(i,e,t,n){return Mo(t)?Ud(i,e,t):(ga.pad=t,ga.soft=n?0:null,ga.mode=n?3:0,Ud(i,e,Qg))}function Pt(i,e){return i??e}function e0(i,e,t){for(e=Pt(e,0),t=Pt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Ud(i,e,t){let n=t.min,s=t.max,r=Pt(n.pad,0),a=Pt(s.pad,0),o=Pt(n.hard,-Wt),l=Pt(s.hard,Wt),c=Pt(n.soft,Wt),h=Pt(s.soft,-Wt),d=Pt(n.mode,0),u=Pt(s.mode,0),f=e-i,g=ns(f),y=Vn(yn(i),yn(e)),m=ns(y),p=yn(m-g);(f<1e-24||p>10)&&(f=0,(i==0||e==0)&&(f=1e-24,d==2&&c!=Wt&&(r=0),u==2&&h!=-Wt&&(a=0)));let v=f||y||1e3,T=ns(v),b=br(10,ti(T)),P=v*(f==0?i==0?.1:1:r),C=Xt(mf(i-P,b/10),24),x=i>=c&&(d==1||d==3&&C<=c||d==2&&C>=c)?c:Wt,A=Vn(o,C<x&&i>=x?x:wi(x,C)),z=v*(f==0?e==0?.1:1:a),U=Xt(yo(e+z,b/10),24),D=e<=h&&(u==1||u==3&&U>=h||u==2&&U<=h)?h:-Wt,W=wi(l,U>D&&e<=D?D:Vn(D,U));return A==W&&A==0&&(W=100),[A,W]}var t0=new Intl.NumberFormat(Ar?Zg.language:"en-US"),hh=i=>t0.format(i),ni=Math,po=ni.PI,yn=ni.abs,ti=ni.floor,vn=ni.round,gi=ni.ceil,wi=ni.min,Vn=ni.max,br=ni.pow,Fd=ni.sign,ns=ni.log10,uf=ni.log2,n0=(i,e=1)=>ni.sinh(i)*e,Xc=(i,e=1)=>ni.asinh(i/e),Wt=1/0;function Od(i){return(ns((i^i>>31)-(i>>31))|0)+1}function Qc(i,e,t){return wi(Vn(i,e),t)}function df(i){return typeof i=="function"}function Mt(i){return df(i)?i:()=>i}var i0=()=>{},ff=i=>i,pf=(i,e)=>e,s0=i=>null,Bd=i=>!0,kd=(i,e)=>i==e,r0=/\.\d*?(?=9{6,}|0{6,})/gm,Zs=i=>{if(_f(i)||Es.has(i))return i;let e=`${i}`,t=e.match(r0);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Zs(s)}e${r}`}return Xt(i,n)};function Xs(i,e){return Zs(Xt(Zs(i/e))*e)}function yo(i,e){return Zs(gi(Zs(i/e))*e)}function mf(i,e){return Zs(ti(Zs(i/e))*e)}function Xt(i,e=0){if(_f(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return vn(n)/t}var Es=new Map;function gf(i){return((""+i).split(".")[1]||"").length}function xa(i,e,t,n){let s=[],r=n.map(gf);for(let a=e;a<t;a++){let o=yn(a),l=Xt(br(i,a),o);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${a}`:n[c]*l,d=(a>=0?0:o)+(a>=r[c]?0:r[c]),u=i==10?h:Xt(h,d);s.push(u),Es.set(u,d)}}return s}var _a={},uh=[],wr=[null,null],ws=Array.isArray,_f=Number.isInteger,a0=i=>i===void 0;function zd(i){return typeof i=="string"}function Mo(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function o0(i){return i!=null&&typeof i=="object"}var l0=Object.getPrototypeOf(Uint8Array),xf="__proto__";function Er(i,e=Mo){let t;if(ws(i)){let n=i.find(s=>s!=null);if(ws(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=Er(i[s],e)}else t=i.slice()}else if(i instanceof l0)t=i.slice();else if(e(i)){t={};for(let n in i)n!=xf&&(t[n]=Er(i[n],e))}else t=i;return t}function _n(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=xf&&(Mo(i[s])?_n(i[s],Er(n[s])):i[s]=Er(n[s]))}return i}var c0=0,h0=1,u0=2;function d0(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let a=e[n];if(a>r){for(s=a-1;s>=0&&i[s]==null;)i[s--]=null;for(s=a+1;s<t&&i[s]==null;)i[r=s++]=null}}}function f0(i,e){if(g0(i)){let a=i[0].slice();for(let o=1;o<i.length;o++)a.push(...i[o].slice(1));return _0(a[0])||(a=m0(a)),a}let t=new Set;for(let a=0;a<i.length;a++){let l=i[a][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((a,o)=>a-o)],s=n[0].length,r=new Map;for(let a=0;a<s;a++)r.set(n[0][a],a);for(let a=0;a<i.length;a++){let o=i[a],l=o[0];for(let c=1;c<o.length;c++){let h=o[c],d=Array(s).fill(void 0),u=e?e[a][c]:h0,f=[];for(let g=0;g<h.length;g++){let y=h[g],m=r.get(l[g]);y===null?u!=c0&&(d[m]=y,u==u0&&f.push(m)):d[m]=y}d0(d,f,s),n.push(d)}}return n}var p0=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function m0(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,a)=>e[r]-e[a]);let s=[];for(let r=0;r<i.length;r++){let a=i[r],o=Array(t);for(let l=0;l<t;l++)o[l]=a[n[l]];s.push(o)}return s}function g0(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function _0(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Vn(1,ti((s-n+1)/e));for(let a=i[n],o=n+r;o<=s;o+=r){let l=i[o];if(l!=null){if(l<=a)return!1;a=l}}return!0}var vf=["January","February","March","April","May","June","July","August","September","October","November","December"],yf=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Mf(i){return i.slice(0,3)}var x0=yf.map(Mf),v0=vf.map(Mf),y0={MMMM:vf,MMM:v0,WWWW:yf,WWW:x0};function da(i){return(i<10?"0":"")+i}function M0(i){return(i<10?"00":i<100?"0":"")+i}var S0={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>da(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>da(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>da(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>da(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>da(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>M0(i.getMilliseconds())};function dh(i,e){e=e||y0;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?S0[s[1]]:s[0]);return r=>{let a="";for(let o=0;o<t.length;o++)a+=typeof t[o]=="string"?t[o]:t[o](r,e);return a}}var b0=new Intl.DateTimeFormat().resolvedOptions().timeZone;function w0(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==b0?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Sf=i=>i%1==0,_o=[1,2,2.5,5],E0=xa(10,-32,0,_o),bf=xa(10,0,32,_o),T0=bf.filter(Sf),qs=E0.concat(bf),fh=`
`,wf="{YYYY}",Vd=fh+wf,Ef="{M}/{D}",ma=fh+Ef,uo=ma+"/{YY}",Tf="{aa}",A0="{h}:{mm}",Mr=A0+Tf,Gd=fh+Mr,Hd=":{ss}",Dt=null;function Af(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,a=s*365,l=(i==1?xa(10,0,3,_o).filter(Sf):xa(10,-3,0,_o)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,a,a*2,a*5,a*10,a*25,a*50,a*100]),c=[[a,wf,Dt,Dt,Dt,Dt,Dt,Dt,1],[s*28,"{MMM}",Vd,Dt,Dt,Dt,Dt,Dt,1],[s,Ef,Vd,Dt,Dt,Dt,Dt,Dt,1],[n,"{h}"+Tf,uo,Dt,ma,Dt,Dt,Dt,1],[t,Mr,uo,Dt,ma,Dt,Dt,Dt,1],[e,Hd,uo+" "+Mr,Dt,ma+" "+Mr,Dt,Gd,Dt,1],[i,Hd+".{fff}",uo+" "+Mr,Dt,ma+" "+Mr,Dt,Gd,Dt,1]];function h(d){return(u,f,g,y,m,p)=>{let v=[],T=m>=a,b=m>=r&&m<a,P=d(g),C=Xt(P*i,3),x=qc(P.getFullYear(),T?0:P.getMonth(),b||T?1:P.getDate()),A=Xt(x*i,3);if(b||T){let z=b?m/r:0,U=T?m/a:0,D=C==A?C:Xt(qc(x.getFullYear()+U,x.getMonth()+z,1)*i,3),W=new Date(vn(D/i)),X=W.getFullYear(),I=W.getMonth();for(let V=0;D<=y;V++){let Z=qc(X+U*V,I+z*V,1),B=Z-d(Xt(Z*i,3));D=Xt((+Z+B)*i,3),D<=y&&v.push(D)}}else{let z=m>=s?s:m,U=ti(g)-ti(C),D=A+U+yo(C-A,z);v.push(D);let W=d(D),X=W.getHours()+W.getMinutes()/t+W.getSeconds()/n,I=m/n,V=u.axes[f]._space,Z=p/V;for(;D=Xt(D+m,i==1?0:3),!(D>y);)if(I>1){let B=ti(Xt(X+I,6))%24,Q=d(D).getHours()-B;Q>1&&(Q=-1),D-=Q*n,X=(X+I)%24;let se=v[v.length-1];Xt((D-se)/m,3)*Z>=.7&&v.push(D)}else v.push(D)}return v}}return[l,c,h]}var[C0,R0,P0]=Af(1),[I0,L0,N0]=Af(.001);xa(2,-53,53,[1]);function Wd(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Xd(i,e){return(t,n,s,r,a)=>{let o=e.find(g=>a>=g[0])||e[e.length-1],l,c,h,d,u,f;return n.map(g=>{let y=i(g),m=y.getFullYear(),p=y.getMonth(),v=y.getDate(),T=y.getHours(),b=y.getMinutes(),P=y.getSeconds(),C=m!=l&&o[2]||p!=c&&o[3]||v!=h&&o[4]||T!=d&&o[5]||b!=u&&o[6]||P!=f&&o[7]||o[1];return l=m,c=p,h=v,d=T,u=b,f=P,C(y)})}}function D0(i,e){let t=dh(e);return(n,s,r,a,o)=>s.map(l=>t(i(l)))}function qc(i,e,t){return new Date(i,e,t)}function qd(i,e){return e(i)}var U0="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Yd(i,e){return(t,n,s,r)=>r==null?ah:e(i(n))}function F0(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function O0(i,e){return i.series[e].fill(i,e)}var B0={show:!0,live:!0,isolate:!1,mount:i0,markers:{show:!0,width:2,stroke:F0,fill:O0,dash:"solid"},idx:null,idxs:null,values:[]};function k0(i,e){let t=i.cursor.points,n=mi(),s=t.size(i,e);Kt(n,fa,s),Kt(n,pa,s);let r=s/-2;Kt(n,"marginLeft",r),Kt(n,"marginTop",r);let a=t.width(i,e,s);return a&&Kt(n,"borderWidth",a),n}function z0(i,e){let t=i.series[e].points;return t._fill||t._stroke}function V0(i,e){let t=i.series[e].points;return t._stroke||t._fill}function G0(i,e){return i.series[e].points.size}var Yc=[0,0];function H0(i,e,t){return Yc[0]=e,Yc[1]=t,Yc}function fo(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function $c(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var W0={show:!0,x:!0,y:!0,lock:!1,move:H0,points:{one:!1,show:k0,size:G0,width:0,stroke:V0,fill:z0},bind:{mousedown:fo,mouseup:fo,click:fo,dblclick:fo,mousemove:$c,mouseleave:$c,mouseenter:$c},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Cf={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ph=_n({},Cf,{filter:pf}),Rf=_n({},ph,{size:10}),Pf=_n({},Cf,{show:!1}),mh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',If="bold "+mh,Lf=1.5,$d={show:!0,scale:"x",stroke:rh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:If,side:2,grid:ph,ticks:Rf,border:Pf,font:mh,lineGap:Lf,rotate:0},X0="Value",q0="Time",Zd={show:!0,scale:"x",auto:!1,sorted:1,min:Wt,max:-Wt,idxs:[]};function Y0(i,e,t,n,s){return e.map(r=>r==null?"":hh(r))}function $0(i,e,t,n,s,r,a){let o=[],l=Es.get(s)||0;t=a?t:Xt(yo(t,s),l);for(let c=t;c<=n;c=Xt(c+s,l))o.push(Object.is(c,-0)?0:c);return o}function eh(i,e,t,n,s,r,a){let o=[],l=i.scales[i.axes[e].scale].log,c=l==10?ns:uf,h=ti(c(t));s=br(l,h),l==10&&(s=qs[bi(s,qs)]);let d=t,u=s*l;l==10&&(u=qs[bi(u,qs)]);do o.push(d),d=d+s,l==10&&!Es.has(d)&&(d=Xt(d,Es.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=qs[bi(u,qs)]));while(d<=n);return o}function Z0(i,e,t,n,s,r,a){let l=i.scales[i.axes[e].scale].asinh,c=n>l?eh(i,e,Vn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?eh(i,e,Vn(l,-n),-t,s):[l]).reverse().map(u=>-u).concat(h,c)}var Nf=/./,J0=/[12357]/,K0=/[125]/,Jd=/1/,th=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function j0(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=i.scales[a],l=i.valToPos,c=r._space,h=l(10,a),d=l(9,a)-h>=c?Nf:l(7,a)-h>=c?J0:l(5,a)-h>=c?K0:Jd;if(d==Jd){let u=yn(l(1,a)-h);if(u<c)return th(e.slice().reverse(),o.distr,d,gi(c/u)).reverse()}return th(e,o.distr,d,1)}function Q0(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=r._space,l=i.valToPos,c=yn(l(1,a)-l(2,a));return c<o?th(e.slice().reverse(),3,Nf,gi(o/c)).reverse():e}function e_(i,e,t,n){return n==null?ah:e==null?"":hh(e)}var Kd={show:!0,scale:"y",stroke:rh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:If,side:3,grid:ph,ticks:Rf,border:Pf,font:mh,lineGap:Lf,rotate:0};function t_(i,e){let t=3+(i||1)*2;return Xt(t*e,3)}function n_(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),a=i.valToPos(s[n[1]],t,!0),o=yn(a-r),l=i.series[e],c=o/(l.points.space*Nt);return n[1]-n[0]<=c}var jd={scale:null,auto:!0,sorted:0,min:Wt,max:-Wt},Df=(i,e,t,n,s)=>s,Qd={show:!0,auto:!0,sorted:0,gaps:Df,alpha:1,facets:[_n({},jd,{scale:"x"}),_n({},jd,{scale:"y"})]},ef={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Df,alpha:1,points:{show:n_,filter:null},values:null,min:Wt,max:-Wt,idxs:[],path:null,clip:null};function i_(i,e,t,n,s){return t/10}var Uf={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},s_=_n({},Uf,{time:!1,ori:1}),tf={};function Ff(i,e){let t=tf[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,a,o,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,a,o,l,c)}},i!=null&&(tf[i]=t)),t}var Tr=1,nh=2;function Js(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,a=i.scales,o=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?a[s.facets[0].scale]:a[i.series[0].scale],d=n==2?a[s.facets[1].scale]:a[s.scale],u=o.left,f=o.top,g=o.width,y=o.height,m=i.valToPosH,p=i.valToPosV;return h.ori==0?t(s,l,c,h,d,m,p,u,f,g,y,bo,Cr,Eo,Bf,zf):t(s,l,c,h,d,p,m,f,u,y,g,wo,Rr,xh,kf,Vf)}function gh(i,e){let t=0,n=0,s=Pt(i.bands,uh);for(let r=0;r<s.length;r++){let a=s[r];a.series[0]==e?t=a.dir:a.series[1]==e&&(a.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function r_(i,e,t,n,s){let r=i.mode,a=i.series[e],o=r==2?a.facets[1].scale:a.scale,l=i.scales[o];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function is(i,e,t,n,s,r){return Js(i,e,(a,o,l,c,h,d,u,f,g,y,m)=>{let p=a.pxRound,v=c.dir*(c.ori==0?1:-1),T=c.ori==0?Cr:Rr,b,P;v==1?(b=t,P=n):(b=n,P=t);let C=p(d(o[b],c,y,f)),x=p(u(l[b],h,m,g)),A=p(d(o[P],c,y,f)),z=p(u(r==1?h.max:h.min,h,m,g)),U=new Path2D(s);return T(U,A,z),T(U,C,z),T(U,C,x),U})}function So(i,e,t,n,s,r){let a=null;if(i.length>0){a=new Path2D;let o=e==0?Eo:xh,l=t;for(let d=0;d<i.length;d++){let u=i[d];if(u[1]>u[0]){let f=u[0]-l;f>0&&o(a,l,n,f,n+r),l=u[1]}}let c=t+s-l,h=10;c>0&&o(a,l,n-h/2,c,n+r+h)}return a}function a_(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function _h(i,e,t,n,s,r,a){let o=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let d=c,u=c;if(s==1)for(;++c<=n&&e[c]===null;)u=c;else for(;--c>=t&&e[c]===null;)u=c;let f=r(i[d]),g=u==d?f:r(i[u]),y=d-s;f=a<=0&&y>=0&&y<l?r(i[y]):f;let p=u+s;g=a>=0&&p>=0&&p<l?r(i[p]):g,g>=f&&o.push([f,g])}return o}function nf(i){return i==0?ff:i==1?vn:e=>Xs(e,i)}function Of(i){let e=i==0?bo:wo,t=i==0?(s,r,a,o,l,c)=>{s.arcTo(r,a,o,l,c)}:(s,r,a,o,l,c)=>{s.arcTo(a,r,l,o,c)},n=i==0?(s,r,a,o,l)=>{s.rect(r,a,o,l)}:(s,r,a,o,l)=>{s.rect(a,r,l,o)};return(s,r,a,o,l,c=0,h=0)=>{c==0&&h==0?n(s,r,a,o,l):(c=wi(c,o/2,l/2),h=wi(h,o/2,l/2),e(s,r+c,a),t(s,r+o,a,r+o,a+l,c),t(s,r+o,a+l,r,a+l,h),t(s,r,a+l,r,a,h),t(s,r,a,r+o,a,c),s.closePath())}}var bo=(i,e,t)=>{i.moveTo(e,t)},wo=(i,e,t)=>{i.moveTo(t,e)},Cr=(i,e,t)=>{i.lineTo(e,t)},Rr=(i,e,t)=>{i.lineTo(t,e)},Eo=Of(0),xh=Of(1),Bf=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},kf=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},zf=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(e,t,n,s,r,a)},Vf=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(t,e,s,n,a,r)};function Gf(i){return(e,t,n,s,r)=>Js(e,t,(a,o,l,c,h,d,u,f,g,y,m)=>{let{pxRound:p,points:v}=a,T,b;c.ori==0?(T=bo,b=Bf):(T=wo,b=kf);let P=Xt(v.width*Nt,3),C=(v.size-v.width)/2*Nt,x=Xt(C*2,3),A=new Path2D,z=new Path2D,{left:U,top:D,width:W,height:X}=e.bbox;Eo(z,U-x,D-x,W+x*2,X+x*2);let I=V=>{if(l[V]!=null){let Z=p(d(o[V],c,y,f)),B=p(u(l[V],h,m,g));T(A,Z+C,B),b(A,Z,B,C,0,po*2)}};if(r)r.forEach(I);else for(let V=n;V<=s;V++)I(V);return{stroke:P>0?A:null,fill:A,clip:z,flags:Tr|nh}})}function Hf(i){return(e,t,n,s,r,a)=>{n!=s&&(r!=n&&a!=n&&i(e,t,n),r!=s&&a!=s&&i(e,t,s),i(e,t,a))}}var o_=Hf(Cr),l_=Hf(Rr);function Wf(i){let e=Pt(i?.alignGaps,0);return(t,n,s,r)=>Js(t,n,(a,o,l,c,h,d,u,f,g,y,m)=>{[s,r]=xo(l,s,r);let p=a.pxRound,v=X=>p(d(X,c,y,f)),T=X=>p(u(X,h,m,g)),b,P;c.ori==0?(b=Cr,P=o_):(b=Rr,P=l_);let C=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Tr},A=x.stroke,z=!1;if(r-s>=y*4){let X=fe=>t.posToVal(fe,c.key,!0),I=null,V=null,Z,B,ue,J=v(o[C==1?s:r]),Q=v(o[s]),se=v(o[r]),oe=X(C==1?Q+1:se-1);for(let fe=C==1?s:r;fe>=s&&fe<=r;fe+=C){let ee=o[fe],ve=(C==1?ee<oe:ee>oe)?J:v(ee),Te=l[fe];ve==J?Te!=null?(B=Te,I==null?(b(A,ve,T(B)),Z=I=V=B):B<I?I=B:B>V&&(V=B)):Te===null&&(z=!0):(I!=null&&P(A,J,T(I),T(V),T(Z),T(B)),Te!=null?(B=Te,b(A,ve,T(B)),I=V=Z=B):(I=V=null,Te===null&&(z=!0)),J=ve,oe=X(J+C))}I!=null&&I!=V&&ue!=J&&P(A,J,T(I),T(V),T(Z),T(B))}else for(let X=C==1?s:r;X>=s&&X<=r;X+=C){let I=l[X];I===null?z=!0:I!=null&&b(A,v(o[X]),T(I))}let[D,W]=gh(t,n);if(a.fill!=null||D!=0){let X=x.fill=new Path2D(A),I=a.fillTo(t,n,a.min,a.max,D),V=T(I),Z=v(o[s]),B=v(o[r]);C==-1&&([B,Z]=[Z,B]),b(X,B,V),b(X,Z,V)}if(!a.spanGaps){let X=[];z&&X.push(..._h(o,l,s,r,C,v,e)),x.gaps=X=a.gaps(t,n,s,r,X),x.clip=So(X,c.ori,f,g,y,m)}return W!=0&&(x.band=W==2?[is(t,n,s,r,A,-1),is(t,n,s,r,A,1)]:is(t,n,s,r,A,W)),x})}function c_(i){let e=Pt(i.align,1),t=Pt(i.ascDesc,!1),n=Pt(i.alignGaps,0),s=Pt(i.extend,!1);return(r,a,o,l)=>Js(r,a,(c,h,d,u,f,g,y,m,p,v,T)=>{[o,l]=xo(d,o,l);let b=c.pxRound,{left:P,width:C}=r.bbox,x=Q=>b(g(Q,u,v,m)),A=Q=>b(y(Q,f,T,p)),z=u.ori==0?Cr:Rr,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Tr},D=U.stroke,W=u.dir*(u.ori==0?1:-1),X=A(d[W==1?o:l]),I=x(h[W==1?o:l]),V=I,Z=I;s&&e==-1&&(Z=P,z(D,Z,X)),z(D,I,X);for(let Q=W==1?o:l;Q>=o&&Q<=l;Q+=W){let se=d[Q];if(se==null)continue;let oe=x(h[Q]),fe=A(se);e==1?z(D,oe,X):z(D,V,fe),z(D,oe,fe),X=fe,V=oe}let B=V;s&&e==1&&(B=P+C,z(D,B,X));let[ue,J]=gh(r,a);if(c.fill!=null||ue!=0){let Q=U.fill=new Path2D(D),se=c.fillTo(r,a,c.min,c.max,ue),oe=A(se);z(Q,B,oe),z(Q,Z,oe)}if(!c.spanGaps){let Q=[];Q.push(..._h(h,d,o,l,W,x,n));let se=c.width*Nt/2,oe=t||e==1?se:-se,fe=t||e==-1?-se:se;Q.forEach(ee=>{ee[0]+=oe,ee[1]+=fe}),U.gaps=Q=c.gaps(r,a,o,l,Q),U.clip=So(Q,u.ori,m,p,v,T)}return J!=0&&(U.band=J==2?[is(r,a,o,l,D,-1),is(r,a,o,l,D,1)]:is(r,a,o,l,D,J)),U})}function sf(i,e,t,n,s,r,a=Wt){if(i.length>1){let o=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(o!=null){let h=yn(i[l]-i[o]);h<c&&(c=h,a=yn(t(i[l],n,s,r)-t(i[o],n,s,r)))}o=l}}return a}function h_(i){i=i||_a;let e=Pt(i.size,[.6,Wt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Mt(s),a=1-e[0],o=Pt(e[1],Wt),l=Pt(e[2],1),c=Pt(i.disp,_a),h=Pt(i.each,f=>{}),{fill:d,stroke:u}=c;return(f,g,y,m)=>Js(f,g,(p,v,T,b,P,C,x,A,z,U,D)=>{let W=p.pxRound,X=t,I=n*Nt,V=o*Nt,Z=l*Nt,B,ue;b.ori==0?[B,ue]=r(f,g):[ue,B]=r(f,g);let J=b.dir*(b.ori==0?1:-1),Q=b.ori==0?Eo:xh,se=b.ori==0?h:(Ie,et,at,Ae,It,qe,je)=>{h(Ie,et,at,It,Ae,je,qe)},oe=Pt(f.bands,uh).find(Ie=>Ie.series[0]==g),fe=oe!=null?oe.dir:0,ee=p.fillTo(f,g,p.min,p.max,fe),xe=W(x(ee,P,D,z)),ve,Te,we,$e=U,it=W(p.width*Nt),Xe=!1,ut=null,dt=null,rt=null,kt=null;d!=null&&(it==0||u!=null)&&(Xe=!0,ut=d.values(f,g,y,m),dt=new Map,new Set(ut).forEach(Ie=>{Ie!=null&&dt.set(Ie,new Path2D)}),it>0&&(rt=u.values(f,g,y,m),kt=new Map,new Set(rt).forEach(Ie=>{Ie!=null&&kt.set(Ie,new Path2D)})));let{x0:Ft,size:nn}=c;if(Ft!=null&&nn!=null){X=1,v=Ft.values(f,g,y,m),Ft.unit==2&&(v=v.map(at=>f.posToVal(A+at*U,b.key,!0)));let Ie=nn.values(f,g,y,m);nn.unit==2?Te=Ie[0]*U:Te=C(Ie[0],b,U,A)-C(0,b,U,A),$e=sf(v,T,C,b,U,A,$e),we=$e-Te+I}else $e=sf(v,T,C,b,U,A,$e),we=$e*a+I,Te=$e-we;we<1&&(we=0),it>=Te/2&&(it=0),we<5&&(W=ff);let At=we>0,hn=$e-we-(At?it:0);Te=W(Qc(hn,Z,V)),ve=(X==0?Te/2:X==J?0:Te)-X*J*((X==0?I/2:0)+(At?it/2:0));let _t={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},an=Xe?null:new Path2D,Yt=null;if(oe!=null)Yt=f.data[oe.series[1]];else{let{y0:Ie,y1:et}=c;Ie!=null&&et!=null&&(T=et.values(f,g,y,m),Yt=Ie.values(f,g,y,m))}let sn=B*Te,O=ue*Te;for(let Ie=J==1?y:m;Ie>=y&&Ie<=m;Ie+=J){let et=T[Ie];if(et==null)continue;if(Yt!=null){let Y=Yt[Ie]??0;if(et-Y==0)continue;xe=x(Y,P,D,z)}let at=b.distr!=2||c!=null?v[Ie]:Ie,Ae=C(at,b,U,A),It=x(Pt(et,ee),P,D,z),qe=W(Ae-ve),je=W(Vn(It,xe)),E=W(wi(It,xe)),S=je-E;if(et!=null){let Y=et<0?O:sn,ce=et<0?sn:O;Xe?(it>0&&rt[Ie]!=null&&Q(kt.get(rt[Ie]),qe,E+ti(it/2),Te,Vn(0,S-it),Y,ce),ut[Ie]!=null&&Q(dt.get(ut[Ie]),qe,E+ti(it/2),Te,Vn(0,S-it),Y,ce)):Q(an,qe,E+ti(it/2),Te,Vn(0,S-it),Y,ce),se(f,g,Ie,qe-it/2,E,Te+it,S)}}return it>0?_t.stroke=Xe?kt:an:Xe||(_t._fill=p.width==0?p._fill:p._stroke??p._fill,_t.width=0),_t.fill=Xe?dt:an,_t})}function u_(i,e){let t=Pt(e?.alignGaps,0);return(n,s,r,a)=>Js(n,s,(o,l,c,h,d,u,f,g,y,m,p)=>{[r,a]=xo(c,r,a);let v=o.pxRound,T=B=>v(u(B,h,m,g)),b=B=>v(f(B,d,p,y)),P,C,x;h.ori==0?(P=bo,x=Cr,C=zf):(P=wo,x=Rr,C=Vf);let A=h.dir*(h.ori==0?1:-1),z=T(l[A==1?r:a]),U=z,D=[],W=[];for(let B=A==1?r:a;B>=r&&B<=a;B+=A)if(c[B]!=null){let J=l[B],Q=T(J);D.push(U=Q),W.push(b(c[B]))}let X={stroke:i(D,W,P,x,C,v),fill:null,clip:null,band:null,gaps:null,flags:Tr},I=X.stroke,[V,Z]=gh(n,s);if(o.fill!=null||V!=0){let B=X.fill=new Path2D(I),ue=o.fillTo(n,s,o.min,o.max,V),J=b(ue);x(B,U,J),x(B,z,J)}if(!o.spanGaps){let B=[];B.push(..._h(l,c,r,a,A,T,t)),X.gaps=B=o.gaps(n,s,r,a,B),X.clip=So(B,h.ori,g,y,m,p)}return Z!=0&&(X.band=Z==2?[is(n,s,r,a,I,-1),is(n,s,r,a,I,1)]:is(n,s,r,a,I,Z)),X})}function d_(i){return u_(f_,i)}function f_(i,e,t,n,s,r){let a=i.length;if(a<2)return null;let o=new Path2D;if(t(o,i[0],e[0]),a==2)n(o,i[1],e[1]);else{let l=Array(a),c=Array(a-1),h=Array(a-1),d=Array(a-1);for(let u=0;u<a-1;u++)h[u]=e[u+1]-e[u],d[u]=i[u+1]-i[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<a-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[a-1]=c[a-2];for(let u=0;u<a-1;u++)s(o,i[u]+d[u]/3,e[u]+l[u]*d[u]/3,i[u+1]-d[u]/3,e[u+1]-l[u+1]*d[u]/3,i[u+1],e[u+1])}return o}var ih=new Set;function rf(){for(let i of ih)i.syncRect(!0)}Ar&&($s(Yg,Sr,rf),$s($g,Sr,rf,!0),$s(mo,Sr,()=>{dn.pxRatio=Nt}));var p_=Wf(),m_=Gf();function af(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,a)=>sh(r,a,e,t))}function g_(i,e){return i.map((t,n)=>n==0?{}:_n({},e,t))}function sh(i,e,t,n){return _n({},e==0?t:n,i)}function Xf(i,e,t){return e==null?wr:[e,t]}var __=Xf;function x_(i,e,t){return e==null?wr:go(e,t,ch,!0)}function qf(i,e,t,n){return e==null?wr:vo(e,t,i.scales[n].log,!1)}var v_=qf;function Yf(i,e,t,n){return e==null?wr:lh(e,t,i.scales[n].log,!1)}var y_=Yf;function M_(i,e,t,n,s){let r=Vn(Od(i),Od(e)),a=e-i,o=bi(s/n*a,t);do{let l=t[o],c=n*l/a;if(c>=s&&r+(l<5?Es.get(l):0)<=17)return[l,c]}while(++o<t.length);return[0,0]}function of(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=vn((t=+s)*Nt))+"px"),[i,e,t]}function S_(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Xt(e[2]*Nt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function dn(i,e,t){let n={mode:Pt(i.mode,1)},s=n.mode;function r(_,w,R,L){let k=w.valToPct(_);return L+R*(w.dir==-1?1-k:k)}function a(_,w,R,L){let k=w.valToPct(_);return L+R*(w.dir==-1?k:1-k)}function o(_,w,R,L){return w.ori==0?r(_,w,R,L):a(_,w,R,L)}n.valToPosH=r,n.valToPosV=a;let l=!1;n.status=0;let c=n.root=mi(Rg);if(i.id!=null&&(c.id=i.id),ei(c,i.class),i.title){let _=mi(Lg,c);_.textContent=i.title}let h=Si("canvas"),d=n.ctx=h.getContext("2d"),u=mi(Ng,c);$s("click",u,_=>{_.target===g&&($t!=dr||tn!=fr)&&Pn.click(n,_)},!0);let f=n.under=mi(Dg,u);u.appendChild(h);let g=n.over=mi(Ug,u);i=Er(i);let y=+Pt(i.pxAlign,1),m=nf(y);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let p=i.ms||.001,v=n.series=s==1?af(i.series||[],Zd,ef,!1):g_(i.series||[null],Qd),T=n.axes=af(i.axes||[],$d,Kd,!0),b=n.scales={},P=n.bands=i.bands||[];P.forEach(_=>{_.fill=Mt(_.fill||null),_.dir=Pt(_.dir,-1)});let C=s==2?v[1].facets[0].scale:v[0].scale,x={axes:es,series:pt},A=(i.drawOrder||["axes","series"]).map(_=>x[_]);function z(_){let w=_.distr==3?R=>ns(R>0?R:_.clamp(n,R,_.min,_.max,_.key)):_.distr==4?R=>Xc(R,_.asinh):_.distr==100?R=>_.fwd(R):R=>R;return R=>{let L=w(R),{_min:k,_max:K}=_,le=K-k;return(L-k)/le}}function U(_){let w=b[_];if(w==null){let R=(i.scales||_a)[_]||_a;if(R.from!=null){U(R.from);let L=_n({},b[R.from],R,{key:_});L.valToPct=z(L),b[_]=L}else{w=b[_]=_n({},_==C?Uf:s_,R),w.key=_;let L=w.time,k=w.range,K=ws(k);if((_!=C||s==2&&!L)&&(K&&(k[0]==null||k[1]==null)&&(k={min:k[0]==null?Dd:{mode:1,hard:k[0],soft:k[0]},max:k[1]==null?Dd:{mode:1,hard:k[1],soft:k[1]}},K=!1),!K&&Mo(k))){let le=k;k=(ge,Ce,ke)=>Ce==null?wr:go(Ce,ke,le)}w.range=Mt(k||(L?__:_==C?w.distr==3?v_:w.distr==4?y_:Xf:w.distr==3?qf:w.distr==4?Yf:x_)),w.auto=Mt(K?!1:w.auto),w.clamp=Mt(w.clamp||i_),w._min=w._max=null,w.valToPct=z(w)}}}U("x"),U("y"),s==1&&v.forEach(_=>{U(_.scale)}),T.forEach(_=>{U(_.scale)});for(let _ in i.scales)U(_);let D=b[C],W=D.distr,X,I;D.ori==0?(ei(c,Pg),X=r,I=a):(ei(c,Ig),X=a,I=r);let V={};for(let _ in b){let w=b[_];(w.min!=null||w.max!=null)&&(V[_]={min:w.min,max:w.max},w.min=w.max=null)}let Z=i.tzDate||(_=>new Date(vn(_/p))),B=i.fmtDate||dh,ue=p==1?P0(Z):N0(Z),J=Xd(Z,Wd(p==1?R0:L0,B)),Q=Yd(Z,qd(U0,B)),se=[],oe=n.legend=_n({},B0,i.legend),fe=n.cursor=_n({},W0,{drag:{y:s==2}},i.cursor),ee=oe.show,xe=fe.show,ve=oe.markers;oe.idxs=se,ve.width=Mt(ve.width),ve.dash=Mt(ve.dash),ve.stroke=Mt(ve.stroke),ve.fill=Mt(ve.fill);let Te,we,$e,it=[],Xe=[],ut,dt=!1,rt={};if(oe.live){let _=v[1]?v[1].values:null;dt=_!=null,ut=dt?_(n,1,0):{_:0};for(let w in ut)rt[w]=ah}if(ee)if(Te=Si("table",Vg,c),$e=Si("tbody",null,Te),oe.mount(n,Te),dt){we=Si("thead",null,Te,$e);let _=Si("tr",null,we);Si("th",null,_);for(var kt in ut)Si("th",Md,_).textContent=kt}else ei(Te,Hg),oe.live&&ei(Te,Gg);let Ft={show:!0},nn={show:!1};function At(_,w){if(w==0&&(dt||!oe.live||s==2))return wr;let R=[],L=Si("tr",Wg,$e,$e.childNodes[w]);ei(L,_.class),_.show||ei(L,Ys);let k=Si("th",null,L);if(ve.show){let ge=mi(Xg,k);if(w>0){let Ce=ve.width(n,w);Ce&&(ge.style.border=Ce+"px "+ve.dash(n,w)+" "+ve.stroke(n,w)),ge.style.background=ve.fill(n,w)}}let K=mi(Md,k);_.label instanceof HTMLElement?K.appendChild(_.label):K.textContent=_.label,w>0&&(ve.show||(K.style.color=_.width>0?ve.stroke(n,w):ve.fill(n,w)),_t("click",k,ge=>{if(fe._lock)return;Qe(ge);let Ce=v.indexOf(_);if((ge.ctrlKey||ge.metaKey)!=oe.isolate){let ke=v.some((ze,We)=>We>0&&We!=Ce&&ze.show);v.forEach((ze,We)=>{We>0&&Di(We,ke?We==Ce?Ft:nn:Ft,!0,gn.setSeries)})}else Di(Ce,{show:!_.show},!0,gn.setSeries)},!1),tt&&_t(Ed,k,ge=>{fe._lock||(Qe(ge),Di(v.indexOf(_),mr,!0,gn.setSeries))},!1));for(var le in ut){let ge=Si("td",qg,L);ge.textContent="--",R.push(ge)}return[L,R]}let hn=new Map;function _t(_,w,R,L=!0){let k=hn.get(w)||{},K=fe.bind[_](n,w,R,L);K&&($s(_,w,k[_]=K),hn.set(w,k))}function an(_,w,R){let L=hn.get(w)||{};for(let k in L)(_==null||k==_)&&(jc(k,w,L[k]),delete L[k]);_==null&&hn.delete(w)}let Yt=0,sn=0,O=0,Ie=0,et=0,at=0,Ae=et,It=at,qe=O,je=Ie,E=0,S=0,Y=0,ce=0;n.bbox={};let ae=!1,_e=!1,ye=!1,te=!1,ie=!1,me=!1;function F(_,w,R){(R||_!=n.width||w!=n.height)&&re(_,w),mt(!1),ye=!0,_e=!0,In()}function re(_,w){n.width=Yt=O=_,n.height=sn=Ie=w,et=at=0,Ee(),Be();let R=n.bbox;E=R.left=Xs(et*Nt,.5),S=R.top=Xs(at*Nt,.5),Y=R.width=Xs(O*Nt,.5),ce=R.height=Xs(Ie*Nt,.5)}let ne=3;function Re(){let _=!1,w=0;for(;!_;){w++;let R=cr(w),L=Ni(w);_=w==ne||R&&L,_||(re(n.width,n.height),_e=!0)}}function Me({width:_,height:w}){F(_,w)}n.setSize=Me;function Ee(){let _=!1,w=!1,R=!1,L=!1;T.forEach((k,K)=>{if(k.show&&k._show){let{side:le,_size:ge}=k,Ce=le%2,ke=k.label!=null?k.labelSize:0,ze=ge+ke;ze>0&&(Ce?(O-=ze,le==3?(et+=ze,L=!0):R=!0):(Ie-=ze,le==0?(at+=ze,_=!0):w=!0))}}),Un[0]=_,Un[1]=R,Un[2]=w,Un[3]=L,O-=Wn[1]+Wn[3],et+=Wn[3],Ie-=Wn[2]+Wn[0],at+=Wn[0]}function Be(){let _=et+O,w=at+Ie,R=et,L=at;function k(K,le){switch(K){case 1:return _+=le,_-le;case 2:return w+=le,w-le;case 3:return R-=le,R+le;case 0:return L-=le,L+le}}T.forEach((K,le)=>{if(K.show&&K._show){let ge=K.side;K._pos=k(ge,K._size),K.label!=null&&(K._lpos=k(ge,K.labelSize))}})}if(fe.dataIdx==null){let _=fe.hover,w=_.skip=new Set(_.skip??[]);w.add(void 0);let R=_.prox=Mt(_.prox),L=_.bias??=0;fe.dataIdx=(k,K,le,ge)=>{if(K==0)return le;let Ce=le,ke=R(k,K,le,ge)??Wt,ze=ke>=0&&ke<Wt,We=D.ori==0?O:Ie,ht=fe.left,Lt=e[0],Ct=e[K];if(w.has(Ct[le])){Ce=null;let vt=null,st=null,Ke;if(L==0||L==-1)for(Ke=le;vt==null&&Ke-- >0;)w.has(Ct[Ke])||(vt=Ke);if(L==0||L==1)for(Ke=le;st==null&&Ke++<Ct.length;)w.has(Ct[Ke])||(st=Ke);if(vt!=null||st!=null)if(ze){let Jt=vt==null?-1/0:X(Lt[vt],D,We,0),ln=st==null?1/0:X(Lt[st],D,We,0),Tn=ht-Jt,Vt=ln-ht;Tn<=Vt?Tn<=ke&&(Ce=vt):Vt<=ke&&(Ce=st)}else Ce=st==null?vt:vt==null?st:le-vt<=st-le?vt:st}else ze&&yn(ht-X(Lt[le],D,We,0))>ke&&(Ce=null);return Ce}}let Qe=_=>{fe.event=_};fe.idxs=se,fe._lock=!1;let he=fe.points;he.show=Mt(he.show),he.size=Mt(he.size),he.stroke=Mt(he.stroke),he.width=Mt(he.width),he.fill=Mt(he.fill);let Ve=n.focus=_n({},i.focus||{alpha:.3},fe.focus),tt=Ve.prox>=0,Pe=tt&&he.one,ct=[],Ht=[],Rn=[];function _s(_,w){let R=he.show(n,w);if(R instanceof HTMLElement)return ei(R,zg),ei(R,_.class),Bi(R,-10,-10,O,Ie),g.insertBefore(R,ct[w]),R}function Zi(_,w){if(s==1||w>0){let R=s==1&&b[_.scale].time,L=_.value;_.value=R?zd(L)?Yd(Z,qd(L,B)):L||Q:L||e_,_.label=_.label||(R?q0:X0)}if(Pe||w>0){_.width=_.width==null?1:_.width,_.paths=_.paths||p_||s0,_.fillTo=Mt(_.fillTo||r_),_.pxAlign=+Pt(_.pxAlign,y),_.pxRound=nf(_.pxAlign),_.stroke=Mt(_.stroke||null),_.fill=Mt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let R=t_(Vn(1,_.width),1),L=_.points=_n({},{size:R,width:Vn(1,R*.2),stroke:_.stroke,space:R*2,paths:m_,_stroke:null,_fill:null},_.points);L.show=Mt(L.show),L.filter=Mt(L.filter),L.fill=Mt(L.fill),L.stroke=Mt(L.stroke),L.paths=Mt(L.paths),L.pxAlign=_.pxAlign}if(ee){let R=At(_,w);it.splice(w,0,R[0]),Xe.splice(w,0,R[1]),oe.values.push(null)}if(xe){se.splice(w,0,null);let R=null;Pe?w==0&&(R=_s(_,w)):w>0&&(R=_s(_,w)),ct.splice(w,0,R),Ht.splice(w,0,0),Rn.splice(w,0,0)}En("addSeries",w)}function Ji(_,w){w=w??v.length,_=s==1?sh(_,w,Zd,ef):sh(_,w,{},Qd),v.splice(w,0,_),Zi(v[w],w)}n.addSeries=Ji;function Ki(_){if(v.splice(_,1),ee){oe.values.splice(_,1),Xe.splice(_,1);let w=it.splice(_,1)[0];an(null,w.firstChild),w.remove()}xe&&(se.splice(_,1),ct.splice(_,1)[0].remove(),Ht.splice(_,1),Rn.splice(_,1)),En("delSeries",_)}n.delSeries=Ki;let Un=[!1,!1,!1,!1];function ui(_,w){if(_._show=_.show,_.show){let R=_.side%2,L=b[_.scale];L==null&&(_.scale=R?v[1].scale:C,L=b[_.scale]);let k=L.time;_.size=Mt(_.size),_.space=Mt(_.space),_.rotate=Mt(_.rotate),ws(_.incrs)&&_.incrs.forEach(le=>{!Es.has(le)&&Es.set(le,gf(le))}),_.incrs=Mt(_.incrs||(L.distr==2?T0:k?p==1?C0:I0:qs)),_.splits=Mt(_.splits||(k&&L.distr==1?ue:L.distr==3?eh:L.distr==4?Z0:$0)),_.stroke=Mt(_.stroke),_.grid.stroke=Mt(_.grid.stroke),_.ticks.stroke=Mt(_.ticks.stroke),_.border.stroke=Mt(_.border.stroke);let K=_.values;_.values=ws(K)&&!ws(K[0])?Mt(K):k?ws(K)?Xd(Z,Wd(K,B)):zd(K)?D0(Z,K):K||J:K||Y0,_.filter=Mt(_.filter||(L.distr>=3&&L.log==10?j0:L.distr==3&&L.log==2?Q0:pf)),_.font=of(_.font),_.labelFont=of(_.labelFont),_._size=_.size(n,null,w,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Un[w]=!0,_._el=mi(Fg,u))}}function di(_,w,R,L){let[k,K,le,ge]=R,Ce=w%2,ke=0;return Ce==0&&(ge||K)&&(ke=w==0&&!k||w==2&&!le?vn($d.size/3):0),Ce==1&&(k||le)&&(ke=w==1&&!K||w==3&&!ge?vn(Kd.size/2):0),ke}let ji=n.padding=(i.padding||[di,di,di,di]).map(_=>Mt(Pt(_,di))),Wn=n._padding=ji.map((_,w)=>_(n,w,Un,0)),Ot,qt=null,en=null,Jn=s==1?v[0].idxs:null,Fn=null,G=!1;function pe(_,w){if(e=_??[],n.data=n._data=e,s==2){Ot=0;for(let R=1;R<v.length;R++)Ot+=e[R][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),Fn=e[0],Ot=Fn.length;let R=e;if(W==2){R=e.slice();let L=R[0]=Array(Ot);for(let k=0;k<Ot;k++)L[k]=k}n._data=e=R}if(mt(!0),En("setData"),W==2&&(ye=!0),w!==!1){let R=D;R.auto(n,G)?Ne():vs(C,R.min,R.max),te=te||fe.left>=0,me=!0,In()}}n.setData=pe;function Ne(){G=!0;let _,w;s==1&&(Ot>0?(qt=Jn[0]=0,en=Jn[1]=Ot-1,_=e[0][qt],w=e[0][en],W==2?(_=qt,w=en):_==w&&(W==3?[_,w]=vo(_,_,D.log,!1):W==4?[_,w]=lh(_,_,D.log,!1):D.time?w=_+vn(86400/p):[_,w]=go(_,w,ch,!0))):(qt=Jn[0]=_=null,en=Jn[1]=w=null)),vs(C,_,w)}let He,De,Ze,M,N,$,H,q,de,Se;function be(_,w,R,L,k,K){_??=bd,R??=uh,L??="butt",k??=bd,K??="round",_!=He&&(d.strokeStyle=He=_),k!=De&&(d.fillStyle=De=k),w!=Ze&&(d.lineWidth=Ze=w),K!=N&&(d.lineJoin=N=K),L!=$&&(d.lineCap=$=L),R!=M&&d.setLineDash(M=R)}function Le(_,w,R,L){w!=De&&(d.fillStyle=De=w),_!=H&&(d.font=H=_),R!=q&&(d.textAlign=q=R),L!=de&&(d.textBaseline=de=L)}function Fe(_,w,R,L,k=0){if(L.length>0&&_.auto(n,G)&&(w==null||w.min==null)){let K=Pt(qt,0),le=Pt(en,L.length-1),ge=R.min==null?jg(L,K,le,k,_.distr==3):[R.min,R.max];_.min=wi(_.min,R.min=ge[0]),_.max=Vn(_.max,R.max=ge[1])}}let Je={min:null,max:null};function ft(){for(let L in b){let k=b[L];V[L]==null&&(k.min==null||V[C]!=null&&k.auto(n,G))&&(V[L]=Je)}for(let L in b){let k=b[L];V[L]==null&&k.from!=null&&V[k.from]!=null&&(V[L]=Je)}V[C]!=null&&mt(!0);let _={};for(let L in V){let k=V[L];if(k!=null){let K=_[L]=Er(b[L],o0);if(k.min!=null)_n(K,k);else if(L!=C||s==2)if(Ot==0&&K.from==null){let le=K.range(n,null,null,L);K.min=le[0],K.max=le[1]}else K.min=Wt,K.max=-Wt}}if(Ot>0){v.forEach((L,k)=>{if(s==1){let K=L.scale,le=V[K];if(le==null)return;let ge=_[K];if(k==0){let Ce=ge.range(n,ge.min,ge.max,K);ge.min=Ce[0],ge.max=Ce[1],qt=bi(ge.min,e[0]),en=bi(ge.max,e[0]),en-qt>1&&(e[0][qt]<ge.min&&qt++,e[0][en]>ge.max&&en--),L.min=Fn[qt],L.max=Fn[en]}else L.show&&L.auto&&Fe(ge,le,L,e[k],L.sorted);L.idxs[0]=qt,L.idxs[1]=en}else if(k>0&&L.show&&L.auto){let[K,le]=L.facets,ge=K.scale,Ce=le.scale,[ke,ze]=e[k],We=_[ge],ht=_[Ce];We!=null&&Fe(We,V[ge],K,ke,K.sorted),ht!=null&&Fe(ht,V[Ce],le,ze,le.sorted),L.min=le.min,L.max=le.max}});for(let L in _){let k=_[L],K=V[L];if(k.from==null&&(K==null||K.min==null)){let le=k.range(n,k.min==Wt?null:k.min,k.max==-Wt?null:k.max,L);k.min=le[0],k.max=le[1]}}}for(let L in _){let k=_[L];if(k.from!=null){let K=_[k.from];if(K.min==null)k.min=k.max=null;else{let le=k.range(n,K.min,K.max,L);k.min=le[0],k.max=le[1]}}}let w={},R=!1;for(let L in _){let k=_[L],K=b[L];if(K.min!=k.min||K.max!=k.max){K.min=k.min,K.max=k.max;let le=K.distr;K._min=le==3?ns(K.min):le==4?Xc(K.min,K.asinh):le==100?K.fwd(K.min):K.min,K._max=le==3?ns(K.max):le==4?Xc(K.max,K.asinh):le==100?K.fwd(K.max):K.max,w[L]=R=!0}}if(R){v.forEach((L,k)=>{s==2?k>0&&w.y&&(L._paths=null):w[L.scale]&&(L._paths=null)});for(let L in w)ye=!0,En("setScale",L);xe&&fe.left>=0&&(te=me=!0)}for(let L in V)V[L]=null}function Oe(_){let w=Qc(qt-1,0,Ot-1),R=Qc(en+1,0,Ot-1);for(;_[w]==null&&w>0;)w--;for(;_[R]==null&&R<Ot-1;)R++;return[w,R]}function pt(){if(Ot>0){let _=v.some(w=>w._focus)&&Se!=Ve.alpha;_&&(d.globalAlpha=Se=Ve.alpha),v.forEach((w,R)=>{if(R>0&&w.show&&(zt(R,!1),zt(R,!0),w._paths==null)){let L=Se;Se!=w.alpha&&(d.globalAlpha=Se=w.alpha);let k=s==2?[0,e[R][0].length-1]:Oe(e[R]);w._paths=w.paths(n,R,k[0],k[1]),Se!=L&&(d.globalAlpha=Se=L)}}),v.forEach((w,R)=>{if(R>0&&w.show){let L=Se;Se!=w.alpha&&(d.globalAlpha=Se=w.alpha),w._paths!=null&&Tt(R,!1);{let k=w._paths!=null?w._paths.gaps:null,K=w.points.show(n,R,qt,en,k),le=w.points.filter(n,R,K,k);(K||le)&&(w.points._paths=w.points.paths(n,R,qt,en,le),Tt(R,!0))}Se!=L&&(d.globalAlpha=Se=L),En("drawSeries",R)}}),_&&(d.globalAlpha=Se=1)}}function zt(_,w){let R=w?v[_].points:v[_];R._stroke=R.stroke(n,_),R._fill=R.fill(n,_)}function Tt(_,w){let R=w?v[_].points:v[_],{stroke:L,fill:k,clip:K,flags:le,_stroke:ge=R._stroke,_fill:Ce=R._fill,_width:ke=R.width}=R._paths;ke=Xt(ke*Nt,3);let ze=null,We=ke%2/2;w&&Ce==null&&(Ce=ke>0?"#fff":ge);let ht=R.pxAlign==1&&We>0;if(ht&&d.translate(We,We),!w){let Lt=E-ke/2,Ct=S-ke/2,vt=Y+ke,st=ce+ke;ze=new Path2D,ze.rect(Lt,Ct,vt,st)}w?Ge(ge,ke,R.dash,R.cap,Ce,L,k,le,K):xt(_,ge,ke,R.dash,R.cap,Ce,L,k,le,ze,K),ht&&d.translate(-We,-We)}function xt(_,w,R,L,k,K,le,ge,Ce,ke,ze){let We=!1;Ce!=0&&P.forEach((ht,Lt)=>{if(ht.series[0]==_){let Ct=v[ht.series[1]],vt=e[ht.series[1]],st=(Ct._paths||_a).band;ws(st)&&(st=ht.dir==1?st[0]:st[1]);let Ke,Jt=null;Ct.show&&st&&e0(vt,qt,en)?(Jt=ht.fill(n,Lt)||K,Ke=Ct._paths.clip):st=null,Ge(w,R,L,k,Jt,le,ge,Ce,ke,ze,Ke,st),We=!0}}),We||Ge(w,R,L,k,K,le,ge,Ce,ke,ze)}let un=Tr|nh;function Ge(_,w,R,L,k,K,le,ge,Ce,ke,ze,We){be(_,w,R,L,k),(Ce||ke||We)&&(d.save(),Ce&&d.clip(Ce),ke&&d.clip(ke)),We?(ge&un)==un?(d.clip(We),ze&&d.clip(ze),yt(k,le),fn(_,K,w)):ge&nh?(yt(k,le),d.clip(We),fn(_,K,w)):ge&Tr&&(d.save(),d.clip(We),ze&&d.clip(ze),yt(k,le),d.restore(),fn(_,K,w)):(yt(k,le),fn(_,K,w)),(Ce||ke||We)&&d.restore()}function fn(_,w,R){R>0&&(w instanceof Map?w.forEach((L,k)=>{d.strokeStyle=He=k,d.stroke(L)}):w!=null&&_&&d.stroke(w))}function yt(_,w){w instanceof Map?w.forEach((R,L)=>{d.fillStyle=De=L,d.fill(R)}):w!=null&&_&&d.fill(w)}function Qi(_,w,R,L){let k=T[_],K;if(L<=0)K=[0,0];else{let le=k._space=k.space(n,_,w,R,L),ge=k._incrs=k.incrs(n,_,w,R,L,le);K=M_(w,R,ge,L,le)}return k._found=K}function pn(_,w,R,L,k,K,le,ge,Ce,ke){let ze=le%2/2;y==1&&d.translate(ze,ze),be(ge,le,Ce,ke,ge),d.beginPath();let We,ht,Lt,Ct,vt=k+(L==0||L==3?-K:K);R==0?(ht=k,Ct=vt):(We=k,Lt=vt);for(let st=0;st<_.length;st++)w[st]!=null&&(R==0?We=Lt=_[st]:ht=Ct=_[st],d.moveTo(We,ht),d.lineTo(Lt,Ct));d.stroke(),y==1&&d.translate(-ze,-ze)}function cr(_){let w=!0;return T.forEach((R,L)=>{if(!R.show)return;let k=b[R.scale];if(k.min==null){R._show&&(w=!1,R._show=!1,mt(!1));return}else R._show||(w=!1,R._show=!0,mt(!1));let K=R.side,le=K%2,{min:ge,max:Ce}=k,[ke,ze]=Qi(L,ge,Ce,le==0?O:Ie);if(ze==0)return;let We=k.distr==2,ht=R._splits=R.splits(n,L,ge,Ce,ke,ze,We),Lt=k.distr==2?ht.map(Ke=>Fn[Ke]):ht,Ct=k.distr==2?Fn[ht[1]]-Fn[ht[0]]:ke,vt=R._values=R.values(n,R.filter(n,Lt,L,ze,Ct),L,ze,Ct);R._rotate=K==2?R.rotate(n,vt,L,ze):0;let st=R._size;R._size=gi(R.size(n,vt,L,_)),st!=null&&R._size!=st&&(w=!1)}),w}function Ni(_){let w=!0;return ji.forEach((R,L)=>{let k=R(n,L,Un,_);k!=Wn[L]&&(w=!1),Wn[L]=k}),w}function es(){for(let _=0;_<T.length;_++){let w=T[_];if(!w.show||!w._show)continue;let R=w.side,L=R%2,k,K,le=w.stroke(n,_),ge=R==0||R==3?-1:1,[Ce,ke]=w._found;if(w.label!=null){let kn=w.labelGap*ge,Qn=vn((w._lpos+kn)*Nt);Le(w.labelFont[0],le,"center",R==2?"top":Sd),d.save(),L==1?(k=K=0,d.translate(Qn,vn(S+ce/2)),d.rotate((R==3?-po:po)/2)):(k=vn(E+Y/2),K=Qn);let Hs=df(w.label)?w.label(n,_,Ce,ke):w.label;d.fillText(Hs,k,K),d.restore()}if(ke==0)continue;let ze=b[w.scale],We=L==0?Y:ce,ht=L==0?E:S,Lt=w._splits,Ct=ze.distr==2?Lt.map(kn=>Fn[kn]):Lt,vt=ze.distr==2?Fn[Lt[1]]-Fn[Lt[0]]:Ce,st=w.ticks,Ke=w.border,Jt=st.show?st.size:0,ln=vn(Jt*Nt),Tn=vn((w.alignTo==2?w._size-Jt-w.gap:w.gap)*Nt),Vt=w._rotate*-po/180,cn=m(w._pos*Nt),Kn=(ln+Tn)*ge,Bn=cn+Kn;K=L==0?Bn:0,k=L==1?Bn:0;let fi=w.font[0],yi=w.align==1?yr:w.align==2?Gc:Vt>0?yr:Vt<0?Gc:L==0?"center":R==3?Gc:yr,Fi=Vt||L==1?"middle":R==2?"top":Sd;Le(fi,le,yi,Fi);let jn=w.font[1]*w.lineGap,pi=Lt.map(kn=>m(o(kn,ze,We,ht))),Mi=w._values;for(let kn=0;kn<Mi.length;kn++){let Qn=Mi[kn];if(Qn!=null){L==0?k=pi[kn]:K=pi[kn],Qn=""+Qn;let Hs=Qn.indexOf(`
`)==-1?[Qn]:Qn.split(/\n/gm);for(let zn=0;zn<Hs.length;zn++){let gd=Hs[zn];Vt?(d.save(),d.translate(k,K+zn*jn),d.rotate(Vt),d.fillText(gd,0,0),d.restore()):d.fillText(gd,k,K+zn*jn)}}}st.show&&pn(pi,st.filter(n,Ct,_,ke,vt),L,R,cn,ln,Xt(st.width*Nt,3),st.stroke(n,_),st.dash,st.cap);let Oi=w.grid;Oi.show&&pn(pi,Oi.filter(n,Ct,_,ke,vt),L,L==0?2:1,L==0?S:E,L==0?ce:Y,Xt(Oi.width*Nt,3),Oi.stroke(n,_),Oi.dash,Oi.cap),Ke.show&&pn([cn],[1],L==0?1:0,L==0?1:2,L==1?S:E,L==1?ce:Y,Xt(Ke.width*Nt,3),Ke.stroke(n,_),Ke.dash,Ke.cap)}En("drawAxes")}function mt(_){v.forEach((w,R)=>{R>0&&(w._paths=null,_&&(s==1?(w.min=null,w.max=null):w.facets.forEach(L=>{L.min=null,L.max=null})))})}let on=!1,On=!1,Bt=[];function mn(){On=!1;for(let _=0;_<Bt.length;_++)En(...Bt[_]);Bt.length=0}function In(){on||(p0(ju),on=!0)}function ro(_,w=!1){on=!0,On=w,_(n),ju(),w&&Bt.length>0&&queueMicrotask(mn)}n.batch=ro;function ju(){if(ae&&(ft(),ae=!1),ye&&(Re(),ye=!1),_e){if(Kt(f,yr,et),Kt(f,"top",at),Kt(f,fa,O),Kt(f,pa,Ie),Kt(g,yr,et),Kt(g,"top",at),Kt(g,fa,O),Kt(g,pa,Ie),Kt(u,fa,Yt),Kt(u,pa,sn),h.width=vn(Yt*Nt),h.height=vn(sn*Nt),T.forEach(({_el:_,_show:w,_size:R,_pos:L,side:k})=>{if(_!=null)if(w){let K=k===3||k===0?R:0,le=k%2==1;Kt(_,le?"left":"top",L-K),Kt(_,le?"width":"height",R),Kt(_,le?"top":"left",le?at:et),Kt(_,le?"height":"width",le?Ie:O),Kc(_,Ys)}else ei(_,Ys)}),He=De=Ze=N=$=H=q=de=M=null,Se=1,la(!0),et!=Ae||at!=It||O!=qe||Ie!=je){mt(!1);let _=O/qe,w=Ie/je;if(xe&&!te&&fe.left>=0){fe.left*=_,fe.top*=w,hr&&Bi(hr,vn(fe.left),0,O,Ie),ur&&Bi(ur,0,vn(fe.top),O,Ie);for(let R=0;R<ct.length;R++){let L=ct[R];L!=null&&(Ht[R]*=_,Rn[R]*=w,Bi(L,gi(Ht[R]),gi(Rn[R]),O,Ie))}}if(Zt.show&&!ie&&Zt.left>=0&&Zt.width>0){Zt.left*=_,Zt.width*=_,Zt.top*=w,Zt.height*=w;for(let R in Fc)Kt(pr,R,Zt[R])}Ae=et,It=at,qe=O,je=Ie}En("setSize"),_e=!1}Yt>0&&sn>0&&(d.clearRect(0,0,h.width,h.height),En("drawClear"),A.forEach(_=>_()),En("draw")),Zt.show&&ie&&(ao(Zt),ie=!1),xe&&te&&(Gs(null,!0,!1),te=!1),oe.show&&oe.live&&me&&(Dc(),me=!1),l||(l=!0,n.status=1,En("ready")),G=!1,on=!1}n.redraw=(_,w)=>{ye=w||!1,_!==!1?vs(C,D.min,D.max):In()};function Ic(_,w){let R=b[_];if(R.from==null){if(Ot==0){let L=R.range(n,w.min,w.max,_);w.min=L[0],w.max=L[1]}if(w.min>w.max){let L=w.min;w.min=w.max,w.max=L}if(Ot>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;_==C&&R.distr==2&&Ot>0&&(w.min=bi(w.min,e[0]),w.max=bi(w.max,e[0]),w.min==w.max&&w.max++),V[_]=w,ae=!0,In()}}n.setScale=Ic;let Lc,Nc,hr,ur,Qu,ed,dr,fr,td,nd,$t,tn,xs=!1,Pn=fe.drag,bn=Pn.x,wn=Pn.y;xe&&(fe.x&&(Lc=mi(Bg,g)),fe.y&&(Nc=mi(kg,g)),D.ori==0?(hr=Lc,ur=Nc):(hr=Nc,ur=Lc),$t=fe.left,tn=fe.top);let Zt=n.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),pr=Zt.show?mi(Og,Zt.over?g:f):null;function ao(_,w){if(Zt.show){for(let R in _)Zt[R]=_[R],R in Fc&&Kt(pr,R,_[R]);w!==!1&&En("setSelect")}}n.setSelect=ao;function cg(_){if(v[_].show)ee&&Kc(it[_],Ys);else if(ee&&ei(it[_],Ys),xe){let R=Pe?ct[0]:ct[_];R!=null&&Bi(R,-10,-10,O,Ie)}}function vs(_,w,R){Ic(_,{min:w,max:R})}function Di(_,w,R,L){w.focus!=null&&pg(_),w.show!=null&&v.forEach((k,K)=>{K>0&&(_==K||_==null)&&(k.show=w.show,cg(K),s==2?(vs(k.facets[0].scale,null,null),vs(k.facets[1].scale,null,null)):vs(k.scale,null,null),In())}),R!==!1&&En("setSeries",_,w),L&&ca("setSeries",n,_,w)}n.setSeries=Di;function hg(_,w){_n(P[_],w)}function ug(_,w){_.fill=Mt(_.fill||null),_.dir=Pt(_.dir,-1),w=w??P.length,P.splice(w,0,_)}function dg(_){_==null?P.length=0:P.splice(_,1)}n.addBand=ug,n.setBand=hg,n.delBand=dg;function fg(_,w){v[_].alpha=w,xe&&ct[_]!=null&&(ct[_].style.opacity=w),ee&&it[_]&&(it[_].style.opacity=w)}let ts,ys,Vs,mr={focus:!0};function pg(_){if(_!=Vs){let w=_==null,R=Ve.alpha!=1;v.forEach((L,k)=>{if(s==1||k>0){let K=w||k==0||k==_;L._focus=w?null:K,R&&fg(k,K?1:Ve.alpha)}}),Vs=_,R&&In()}}ee&&tt&&_t(Td,Te,_=>{fe._lock||(Qe(_),Vs!=null&&Di(null,mr,!0,gn.setSeries))});function Ui(_,w,R){let L=b[w];R&&(_=_/Nt-(L.ori==1?at:et));let k=O;L.ori==1&&(k=Ie,_=k-_),L.dir==-1&&(_=k-_);let K=L._min,le=L._max,ge=_/k,Ce=K+(le-K)*ge,ke=L.distr;return ke==3?br(10,Ce):ke==4?n0(Ce,L.asinh):ke==100?L.bwd(Ce):Ce}function mg(_,w){let R=Ui(_,C,w);return bi(R,e[0],qt,en)}n.valToIdx=_=>bi(_,e[0]),n.posToIdx=mg,n.posToVal=Ui,n.valToPos=(_,w,R)=>b[w].ori==0?r(_,b[w],R?Y:O,R?E:0):a(_,b[w],R?ce:Ie,R?S:0),n.setCursor=(_,w,R)=>{$t=_.left,tn=_.top,Gs(null,w,R)};function id(_,w){Kt(pr,yr,Zt.left=_),Kt(pr,fa,Zt.width=w)}function sd(_,w){Kt(pr,"top",Zt.top=_),Kt(pr,pa,Zt.height=w)}let aa=D.ori==0?id:sd,oa=D.ori==1?id:sd;function gg(){if(ee&&oe.live)for(let _=s==2?1:0;_<v.length;_++){if(_==0&&dt)continue;let w=oe.values[_],R=0;for(let L in w)Xe[_][R++].firstChild.nodeValue=w[L]}}function Dc(_,w){if(_!=null&&(_.idxs?_.idxs.forEach((R,L)=>{se[L]=R}):a0(_.idx)||se.fill(_.idx),oe.idx=se[0]),ee&&oe.live){for(let R=0;R<v.length;R++)(R>0||s==1&&!dt)&&_g(R,se[R]);gg()}me=!1,w!==!1&&En("setLegend")}n.setLegend=Dc;function _g(_,w){let R=v[_],L=_==0&&W==2?Fn:e[_],k;dt?k=R.values(n,_,w)??rt:(k=R.value(n,w==null?null:L[w],_,w),k=k==null?rt:{_:k}),oe.values[_]=k}function Gs(_,w,R){td=$t,nd=tn,[$t,tn]=fe.move(n,$t,tn),fe.left=$t,fe.top=tn,xe&&(hr&&Bi(hr,vn($t),0,O,Ie),ur&&Bi(ur,0,vn(tn),O,Ie));let L,k=qt>en;ts=Wt,ys=null;let K=D.ori==0?O:Ie,le=D.ori==1?O:Ie;if($t<0||Ot==0||k){L=fe.idx=null;for(let ge=0;ge<v.length;ge++){let Ce=ct[ge];Ce!=null&&Bi(Ce,-10,-10,O,Ie)}tt&&Di(null,mr,!0,_==null&&gn.setSeries),oe.live&&(se.fill(L),me=!0)}else{let ge,Ce,ke;s==1&&(ge=D.ori==0?$t:tn,Ce=Ui(ge,C),L=fe.idx=bi(Ce,e[0],qt,en),ke=X(e[0][L],D,K,0));let ze=-10,We=-10,ht=0,Lt=0,Ct=!0,vt="",st="";for(let Ke=s==2?1:0;Ke<v.length;Ke++){let Jt=v[Ke],ln=se[Ke],Tn=ln==null?null:s==1?e[Ke][ln]:e[Ke][1][ln],Vt=fe.dataIdx(n,Ke,L,Ce),cn=Vt==null?null:s==1?e[Ke][Vt]:e[Ke][1][Vt];if(me=me||cn!=Tn||Vt!=ln,se[Ke]=Vt,Ke>0&&Jt.show){let Kn=Vt==null?-10:Vt==L?ke:X(s==1?e[0][Vt]:e[Ke][0][Vt],D,K,0),Bn=cn==null?-10:I(cn,s==1?b[Jt.scale]:b[Jt.facets[1].scale],le,0);if(tt&&cn!=null){let fi=D.ori==1?$t:tn,yi=yn(Ve.dist(n,Ke,Vt,Bn,fi));if(yi<ts){let Fi=Ve.bias;if(Fi!=0){let jn=Ui(fi,Jt.scale),pi=cn>=0?1:-1,Mi=jn>=0?1:-1;Mi==pi&&(Mi==1?Fi==1?cn>=jn:cn<=jn:Fi==1?cn<=jn:cn>=jn)&&(ts=yi,ys=Ke)}else ts=yi,ys=Ke}}if(me||Pe){let fi,yi;D.ori==0?(fi=Kn,yi=Bn):(fi=Bn,yi=Kn);let Fi,jn,pi,Mi,Oi,kn,Qn=!0,Hs=he.bbox;if(Hs!=null){Qn=!1;let zn=Hs(n,Ke);pi=zn.left,Mi=zn.top,Fi=zn.width,jn=zn.height}else pi=fi,Mi=yi,Fi=jn=he.size(n,Ke);if(kn=he.fill(n,Ke),Oi=he.stroke(n,Ke),Pe)Ke==ys&&ts<=Ve.prox&&(ze=pi,We=Mi,ht=Fi,Lt=jn,Ct=Qn,vt=kn,st=Oi);else{let zn=ct[Ke];zn!=null&&(Ht[Ke]=pi,Rn[Ke]=Mi,Nd(zn,Fi,jn,Qn),Id(zn,kn,Oi),Bi(zn,gi(pi),gi(Mi),O,Ie))}}}}if(Pe){let Ke=Ve.prox,Jt=Vs==null?ts<=Ke:ts>Ke||ys!=Vs;if(me||Jt){let ln=ct[0];ln!=null&&(Ht[0]=ze,Rn[0]=We,Nd(ln,ht,Lt,Ct),Id(ln,vt,st),Bi(ln,gi(ze),gi(We),O,Ie))}}}if(Zt.show&&xs)if(_!=null){let[ge,Ce]=gn.scales,[ke,ze]=gn.match,[We,ht]=_.cursor.sync.scales,Lt=_.cursor.drag;if(bn=Lt._x,wn=Lt._y,bn||wn){let{left:Ct,top:vt,width:st,height:Ke}=_.select,Jt=_.scales[We].ori,ln=_.posToVal,Tn,Vt,cn,Kn,Bn,fi=ge!=null&&ke(ge,We),yi=Ce!=null&&ze(Ce,ht);fi&&bn?(Jt==0?(Tn=Ct,Vt=st):(Tn=vt,Vt=Ke),cn=b[ge],Kn=X(ln(Tn,We),cn,K,0),Bn=X(ln(Tn+Vt,We),cn,K,0),aa(wi(Kn,Bn),yn(Bn-Kn))):aa(0,K),yi&&wn?(Jt==1?(Tn=Ct,Vt=st):(Tn=vt,Vt=Ke),cn=b[Ce],Kn=I(ln(Tn,ht),cn,le,0),Bn=I(ln(Tn+Vt,ht),cn,le,0),oa(wi(Kn,Bn),yn(Bn-Kn))):oa(0,le)}else Oc()}else{let ge=yn(td-Qu),Ce=yn(nd-ed);if(D.ori==1){let ht=ge;ge=Ce,Ce=ht}bn=Pn.x&&ge>=Pn.dist,wn=Pn.y&&Ce>=Pn.dist;let ke=Pn.uni;ke!=null?bn&&wn&&(bn=ge>=ke,wn=Ce>=ke,!bn&&!wn&&(Ce>ge?wn=!0:bn=!0)):Pn.x&&Pn.y&&(bn||wn)&&(bn=wn=!0);let ze,We;bn&&(D.ori==0?(ze=dr,We=$t):(ze=fr,We=tn),aa(wi(ze,We),yn(We-ze)),wn||oa(0,le)),wn&&(D.ori==1?(ze=dr,We=$t):(ze=fr,We=tn),oa(wi(ze,We),yn(We-ze)),bn||aa(0,K)),!bn&&!wn&&(aa(0,0),oa(0,0))}if(Pn._x=bn,Pn._y=wn,_==null){if(R){if(md!=null){let[ge,Ce]=gn.scales;gn.values[0]=ge!=null?Ui(D.ori==0?$t:tn,ge):null,gn.values[1]=Ce!=null?Ui(D.ori==1?$t:tn,Ce):null}ca(Hc,n,$t,tn,O,Ie,L)}if(tt){let ge=R&&gn.setSeries,Ce=Ve.prox;Vs==null?ts<=Ce&&Di(ys,mr,!0,ge):ts>Ce?Di(null,mr,!0,ge):ys!=Vs&&Di(ys,mr,!0,ge)}}me&&(oe.idx=L,Dc()),w!==!1&&En("setCursor")}let Ms=null;Object.defineProperty(n,"rect",{get(){return Ms==null&&la(!1),Ms}});function la(_=!1){_?Ms=null:(Ms=g.getBoundingClientRect(),En("syncRect",Ms))}function rd(_,w,R,L,k,K,le){fe._lock||xs&&_!=null&&_.movementX==0&&_.movementY==0||(Uc(_,w,R,L,k,K,le,!1,_!=null),_!=null?Gs(null,!0,!0):Gs(w,!0,!1))}function Uc(_,w,R,L,k,K,le,ge,Ce){if(Ms==null&&la(!1),Qe(_),_!=null)R=_.clientX-Ms.left,L=_.clientY-Ms.top;else{if(R<0||L<0){$t=-10,tn=-10;return}let[ke,ze]=gn.scales,We=w.cursor.sync,[ht,Lt]=We.values,[Ct,vt]=We.scales,[st,Ke]=gn.match,Jt=w.axes[0].side%2==1,ln=D.ori==0?O:Ie,Tn=D.ori==1?O:Ie,Vt=Jt?K:k,cn=Jt?k:K,Kn=Jt?L:R,Bn=Jt?R:L;if(Ct!=null?R=st(ke,Ct)?o(ht,b[ke],ln,0):-10:R=ln*(Kn/Vt),vt!=null?L=Ke(ze,vt)?o(Lt,b[ze],Tn,0):-10:L=Tn*(Bn/cn),D.ori==1){let fi=R;R=L,L=fi}}Ce&&(w==null||w.cursor.event.type==Hc)&&((R<=1||R>=O-1)&&(R=Xs(R,O)),(L<=1||L>=Ie-1)&&(L=Xs(L,Ie))),ge?(Qu=R,ed=L,[dr,fr]=fe.move(n,R,L)):($t=R,tn=L)}let Fc={width:0,height:0,left:0,top:0};function Oc(){ao(Fc,!1)}let ad,od,ld,cd;function hd(_,w,R,L,k,K,le){xs=!0,bn=wn=Pn._x=Pn._y=!1,Uc(_,w,R,L,k,K,le,!0,!1),_!=null&&(_t(Wc,Zc,ud,!1),ca(wd,n,dr,fr,O,Ie,null));let{left:ge,top:Ce,width:ke,height:ze}=Zt;ad=ge,od=Ce,ld=ke,cd=ze}function ud(_,w,R,L,k,K,le){xs=Pn._x=Pn._y=!1,Uc(_,w,R,L,k,K,le,!1,!0);let{left:ge,top:Ce,width:ke,height:ze}=Zt,We=ke>0||ze>0,ht=ad!=ge||od!=Ce||ld!=ke||cd!=ze;if(We&&ht&&ao(Zt),Pn.setScale&&We&&ht){let Lt=ge,Ct=ke,vt=Ce,st=ze;if(D.ori==1&&(Lt=Ce,Ct=ze,vt=ge,st=ke),bn&&vs(C,Ui(Lt,C),Ui(Lt+Ct,C)),wn)for(let Ke in b){let Jt=b[Ke];Ke!=C&&Jt.from==null&&Jt.min!=Wt&&vs(Ke,Ui(vt+st,Ke),Ui(vt,Ke))}Oc()}else fe.lock&&(fe._lock=!fe._lock,Gs(w,!0,_!=null));_!=null&&(an(Wc,Zc),ca(Wc,n,$t,tn,O,Ie,null))}function xg(_,w,R,L,k,K,le){if(fe._lock)return;Qe(_);let ge=xs;if(xs){let Ce=!0,ke=!0,ze=10,We,ht;D.ori==0?(We=bn,ht=wn):(We=wn,ht=bn),We&&ht&&(Ce=$t<=ze||$t>=O-ze,ke=tn<=ze||tn>=Ie-ze),We&&Ce&&($t=$t<dr?0:O),ht&&ke&&(tn=tn<fr?0:Ie),Gs(null,!0,!0),xs=!1}$t=-10,tn=-10,se.fill(null),Gs(null,!0,!0),ge&&(xs=ge)}function dd(_,w,R,L,k,K,le){fe._lock||(Qe(_),Ne(),Oc(),_!=null&&ca(Ad,n,$t,tn,O,Ie,null))}function fd(){T.forEach(S_),F(n.width,n.height,!0)}$s(mo,Sr,fd);let gr={};gr.mousedown=hd,gr.mousemove=rd,gr.mouseup=ud,gr.dblclick=dd,gr.setSeries=(_,w,R,L)=>{let k=gn.match[2];R=k(n,w,R),R!=-1&&Di(R,L,!0,!1)},xe&&(_t(wd,g,hd),_t(Hc,g,rd),_t(Ed,g,_=>{Qe(_),la(!1)}),_t(Td,g,xg),_t(Ad,g,dd),ih.add(n),n.syncRect=la);let oo=n.hooks=i.hooks||{};function En(_,w,R){On?Bt.push([_,w,R]):_ in oo&&oo[_].forEach(L=>{L.call(null,n,w,R)})}(i.plugins||[]).forEach(_=>{for(let w in _.hooks)oo[w]=(oo[w]||[]).concat(_.hooks[w])});let pd=(_,w,R)=>R,gn=_n({key:null,setSeries:!1,filters:{pub:Bd,sub:Bd},scales:[C,v[1]?v[1].scale:null],match:[kd,kd,pd],values:[null,null]},fe.sync);gn.match.length==2&&gn.match.push(pd),fe.sync=gn;let md=gn.key,Bc=Ff(md);function ca(_,w,R,L,k,K,le){gn.filters.pub(_,w,R,L,k,K,le)&&Bc.pub(_,w,R,L,k,K,le)}Bc.sub(n);function vg(_,w,R,L,k,K,le){gn.filters.sub(_,w,R,L,k,K,le)&&gr[_](null,w,R,L,k,K,le)}n.pub=vg;function yg(){Bc.unsub(n),ih.delete(n),hn.clear(),jc(mo,Sr,fd),c.remove(),Te?.remove(),En("destroy")}n.destroy=yg;function kc(){En("init",i,e),pe(e||i.data,!1),V[C]?Ic(C,V[C]):Ne(),ie=Zt.show&&(Zt.width>0||Zt.height>0),te=me=!0,F(i.width,i.height)}return v.forEach(Zi),T.forEach(ui),t?t instanceof HTMLElement?(t.appendChild(c),kc()):t(n,kc):kc(),n}dn.assign=_n;dn.fmtNum=hh;dn.rangeNum=go;dn.rangeLog=vo;dn.rangeAsinh=lh;dn.orient=Js;dn.pxRatio=Nt;dn.join=f0;dn.fmtDate=dh,dn.tzDate=w0;dn.sync=Ff;{dn.addGap=a_,dn.clipGaps=So;let i=dn.paths={points:Gf};i.linear=Wf,i.stepped=c_,i.bars=h_,i.spline=d_}var vh={reversal:"▲",corner:"◆","first zero":"●","curvature step":"▼"},Pr={alone:250,each:170,paper:120,axis:40,gap:8};function To(i,e){return new yh(i,e)}var yh=class{constructor(e,t){this.host=e;this.chart=t;this.whole=this.range=b_(t),e.tabIndex=0,e.addEventListener("keydown",this.key),this.body=Ye(e,"div"),this.resize()}host;chart;range;whole;hidden=new Set;views=[];body;resize(){this.views.forEach(l=>l.plot.destroy()),this.body.replaceChildren();let e=bs(this.host),{panels:t}=this.chart,n=t.flatMap(l=>l.curves.map(c=>({name:c.name,dash:c.dash,colour:Xn(c.colour,e.card),glyph:c.half?"●":void 0}))),s=t.flatMap(l=>l.ticks.map(c=>({name:c.mark,dash:"",colour:e.muted,glyph:vh[c.mark]}))),r=ua(this.body,[...n,...s],this.hidden,()=>this.redraw());n.filter(l=>l.glyph).forEach(l=>{let c=[...r.children].find(h=>h.lastChild.textContent===l.name);c.firstChild.style.color=l.colour});let a=t.flatMap(l=>l.y_ticks.map(([,c])=>c.length)),o=Math.max(58,7*Math.max(0,...a)+14);this.views=t.map((l,c)=>new Mh(this,l,this.body,e,o,c===t.length-1))}zoom(e=this.whole){let t=this.chart.panels[0].log_x,[n,s]=e;(t?s/n>1.0001:s-n>1e-9*(this.whole[1]-this.whole[0]))&&(this.range=[Math.max(n,this.whole[0]),Math.min(s,this.whole[1])]),this.redraw()}redraw(){this.views.forEach(e=>e.plot.redraw())}update(){this.views.some(e=>e.isBehind)?this.resize():this.redraw()}point(e,t){this.views.forEach(n=>{n!==t&&n.moved(e)})}destroy(){this.views.forEach(e=>e.plot.destroy()),this.host.removeEventListener("keydown",this.key),this.host.replaceChildren()}key=e=>{let t=this.chart.panels[0].log_x,n=t?Math.log:h=>h,s=t?Math.exp:h=>h,[r,a]=this.range.map(n),o=n(this.views[0].at??s((r+a)/2)),l={ArrowLeft:-.01,ArrowRight:.01}[e.key],c={"+":.5,"-":2}[e.key];if(l)this.point(s(Math.min(Math.max(o+l*(a-r),r),a)));else if(c)this.zoom([s(o-c*(o-r)),s(o+c*(a-o))]);else if(e.key==="0"||e.key==="Escape")this.zoom();else return;e.preventDefault()}};function b_(i){let e=1/0,t=-1/0;for(let r of i.panels)for(let a of r.curves)for(let o of a.x.values)o<e&&(e=o),o>t&&(t=o);let n=i.panels[0].log_x;if(e>t)return[n?.1:0,1];if(e===t)return n?[e/2,e*2]:[e-.5,e+.5];let s=!n&&(i.loops||i.panels.some(r=>r.curves.some(a=>a.half)))?.015*(t-e):0;return[e-s,t+s]}var Mh=class{constructor(e,t,n,s,r,a){this.group=e;this.panel=t;this.colours=s;let o=Ye(n,"div","cl-head");Ye(o,"b","",t.y_label);for(let[y,m]of this.notes())Ye(o,"span","",y).style.color=m;let l=Ye(n,"div","cl-panel"),c=this.scale,h=e.chart.panels.length,d=e.chart.panel_height||(h===1?Pr.alone:Ws()?Pr.paper:Pr.each);l.style.setProperty("zoom",String(1/c)),this.tip=new Ss(l);let u=`${12*c}px ${xr.slice(5)}`,f={values:(y,m,p,v,T)=>m.map(b=>b===null?"":E_(b,y.scales[y.axes[p].scale].distr===3?b:T)),stroke:s.muted,font:u,labelFont:u,gap:5*c,grid:{stroke:s.line,width:c},ticks:{stroke:s.edge,width:c,size:4*c},border:{show:!0,stroke:s.edge,width:c}},g=t.y_ticks;this.plot=new dn({width:_r(n.parentElement)*c,height:(d+(a?Pr.axis:Pr.gap))*c,padding:[6*c,22*c,0,0],scales:{x:{time:!1,distr:t.log_x?3:1,range:()=>e.range},y:{distr:t.log_y?3:1,range:()=>this.heights()}},series:[{},...t.curves.map(y=>this.series(y))],axes:[{...f,...t.log_x?{splits:$f,filter:w_}:{},size:(a?24:Pr.gap)*c,space:70*c,...a?{label:t.x_label,labelSize:16*c,labelGap:0}:{values:()=>[]}},{...f,...t.log_y?{splits:$f}:{},size:r*c,space:32*c,...g.length?{splits:()=>g.map(([y])=>y),values:()=>g.map(([,y])=>y)}:{}}],legend:{show:!1},cursor:{y:!1,points:{show:!1},drag:{setScale:!1,x:!0,y:!1}},hooks:{drawAxes:[()=>this.shade()],draw:[()=>this.mark()],setCursor:[y=>this.pointed(y)],setSelect:[y=>this.selected(y)]}},[e.whole,...t.curves.map(()=>[1,1])],l),this.plot.over.addEventListener("dblclick",()=>e.zoom())}group;panel;colours;plot;at=null;tip;scale=Ws()?2:1;get isBehind(){return this.plot.series.length!==this.panel.curves.length+1}get shown(){return this.panel.curves.filter(e=>!this.group.hidden.has(e.name))}notes(){let{band:e,y_range:t,levels:n,far:s}=this.panel,r=", off scale",a=[];e&&a.push([this.panel.band_label+(t&&e[1]>t[1]?r:""),this.colours.band]),this.panel.span&&a.push([this.panel.span_label,this.colours.band]);for(let o of n)o.label&&a.push([o.label+(s?r:""),this.colours.limit]);return a}heights(){let{y_range:e,log_y:t,band:n,levels:s,far:r}=this.panel;if(e)return e;let[a,o]=this.group.range,l=1/0,c=-1/0,h=u=>{!Number.isFinite(u)||t&&u<=0||(u<l&&(l=u),u>c&&(c=u))};for(let{x:u,y:f,half:g}of this.shown)for(let y=0;y<u.values.length;y+=1)!(u.values[y]>=a&&u.values[y]<=o)&&!(y>0&&u.values[y-1]<o&&u.values[y]>a)||(h(f.values[y]-(g?g.values[y]:0)),h(f.values[y]+(g?g.values[y]:0)));if(!t)for(let u of n??[])h(u);if(!r)for(let u of s)h(u.value);for(let[u]of this.panel.y_ticks)h(u-.5),h(u+.5);if(l>c)return t?[1,10]:[0,1];if(t)return[l/1.3,c*1.3];let d=this.panel.y_ticks.length?0:.07*(c-l||Math.abs(c)||1);return[l-d,c+d]}series(e){let t=Xn(e.colour,this.colours.card),n=this.scale;return{cap:e.dash==="solid"&&e.width<3?"round":"butt",stroke:t,width:(e.half?1:e.width)*n,dash:vr[e.dash].map(s=>s*n),points:{show:!1},fill:e.half?t:void 0,paths:s=>this.group.hidden.has(e.name)?null:this.path(s,e)}}path(e,{x:t,y:n,half:s,width:r}){let a=Ts(e,"x"),o=Ts(e,"y"),l=new Path2D,c=new Path2D,h=(1.3+1.3*r)*this.scale*dn.pxRatio,d=!1;for(let p=0;p<t.values.length;p+=1){let v=a(t.values[p]),T=o(n.values[p]);if(!Number.isFinite(v)||!Number.isFinite(T)){d=!1;continue}s?(c.moveTo(v+h,T),c.arc(v,T,h,0,7),s.values[p]>0&&(l.moveTo(v,o(n.values[p]-s.values[p])),l.lineTo(v,o(n.values[p]+s.values[p])))):(d||l.moveTo(v,T),l.lineTo(v,T)),d=!0}let{left:u,top:f,width:g,height:y}=e.bbox,m=new Path2D;return m.rect(u,f,g,y),{stroke:l,fill:s?c:null,clip:m}}shade(){let{band:e,span:t}=this.panel,{ctx:n}=this.plot,{left:s,top:r,width:a,height:o}=this.plot.bbox,l=Ts(this.plot,"x"),c=Ts(this.plot,"y");n.save(),n.beginPath(),n.rect(s,r,a,o),n.clip(),n.fillStyle=n.strokeStyle=this.colours.band,n.globalAlpha=.1,e&&n.fillRect(s,c(e[1]),a,c(e[0])-c(e[1])),t&&n.fillRect(l(t[0]),r,l(t[1])-l(t[0]),o),n.globalAlpha=1;for(let h of e??[])h!==0&&this.across(c(h),vr.dot);n.restore()}across(e,t){let{ctx:n,bbox:s}=this.plot,r=this.scale*dn.pxRatio;n.lineWidth=1.1*r,n.setLineDash(t.map(a=>a*r)),n.beginPath(),n.moveTo(s.left,e),n.lineTo(s.left+s.width,e),n.stroke(),n.setLineDash([])}mark(){let{levels:e,ticks:t,far:n}=this.panel,{ctx:s,bbox:r}=this.plot,a=this.scale*dn.pxRatio,o=Ts(this.plot,"x"),l=Ts(this.plot,"y");s.save(),s.strokeStyle=this.colours.limit;for(let c of n?[]:e){let h=l(c.value);h>=r.top&&h<=r.top+r.height&&this.across(h,vr.dash)}s.fillStyle=this.colours.muted,s.font=`${9*a}px ${xr.slice(5)}`,s.textAlign="center",s.textBaseline="bottom";for(let c of t){let h=o(c.x);h>=r.left&&h<=r.left+r.width&&!this.group.hidden.has(c.mark)&&s.fillText(vh[c.mark]??"●",h,r.top+r.height)}s.restore()}selected(e){let{left:t,width:n}=e.select;n<3||(e.setSelect({left:0,top:0,width:0,height:0},!1),this.group.zoom([e.posToVal(t,"x"),e.posToVal(t+n,"x")]))}pointed(e){if(!e.cursor.event)return;let{left:t=-1,top:n=-1}=e.cursor;this.at=t<0?null:e.posToVal(t,"x"),this.tell(t,n),this.group.point(this.at,this)}moved(e){this.at=e;let t=e===null?-10:this.plot.valToPos(e,"x");this.plot.setCursor({left:t,top:-10},!1),this.tell(t,8)}tell(e,t){if(this.at===null)return this.tip.hide();let n=this.group.chart.loops&&t!==8?this.nearest(e,t):this.values(this.at);this.tip.show(this.plot.over.offsetLeft+e,this.plot.over.offsetTop+t,n)}values(e){let{x_label:t,y_label:n,ticks:s,y_ticks:r}=this.panel,{valToPos:a}=this.plot,o=[],l=h=>Math.abs(a(h,"x")-a(e,"x"));if(this.group.chart.loops)return o;for(let h of this.shown){let d=T_(h.x.values,e),u=h.y.values[d];if(d<0||!Number.isFinite(u)||l(h.x.values[d])>24)continue;let f=r.length?"":` ${Rt(u,ha(n))}`;o.length||o.push([Rt(h.x.values[d],ha(t),6)]),o.push([h.name+f,Xn(h.colour,this.colours.card)])}let c=s.reduce((h,d)=>l(d.x)<(h?l(h.x):6)?d:h,null);return c&&o.length&&o.push([`${vh[c.mark]??""} ${c.label}`]),o}nearest(e,t){let n=Ts(this.plot,"x",!1),s=Ts(this.plot,"y",!1),r=30**2,a=null;for(let u of this.shown)u.x.values.forEach((f,g)=>{let y=(n(f)-e)**2+(s(u.y.values[g])-t)**2;y<r&&([r,a]=[y,[u,g]])});if(!a)return[];let[o,l]=a,{x_label:c,y_label:h}=this.panel,d=o.numbers?` ${o.numbers.values[l]}`:"";return[[o.name+d,Xn(o.colour,this.colours.card)],[`${Vc(c)} ${Rt(o.x.values[l],ha(c))}`],[`${Vc(h)} ${Rt(o.y.values[l],ha(h))}`]]}};function Ts(i,e,t=!0){let{min:n,max:s,distr:r}=i.scales[e],{bbox:a}=i,o=t?1:dn.pxRatio,l=r===3?Math.log:f=>f,c=l(n),h=l(s)-c,d=(e==="x"?a.width:a.height)/o,u=t?e==="x"?a.left:a.top:0;return e==="x"?f=>u+d*(l(f)-c)/h:f=>u+d*(1-(l(f)-c)/h)}function $f(i,e,t,n){let s=Math.floor(Math.log10(t)),r=9*(Math.ceil(Math.log10(n))-s)+1;return Array.from({length:r},(o,l)=>+`${1+l%9}e${s+Math.floor(l/9)}`).filter(o=>o>=t&&o<=n)}function w_(i,e){let t=Math.abs(i.valToPos(10,"x")-i.valToPos(1,"x")),n=t>240?"125":"1";return e.map(s=>n.includes(s.toExponential()[0])?s:null)}function E_(i,e){let t=Math.ceil(-Math.log10(e))+1;return t>7?Rt(i):i.toLocaleString("en",{maximumFractionDigits:Math.max(t,0)})}function T_(i,e){let t=0,n=i.length-1;for(;n-t>1;){let s=t+n>>1;for(;s<n&&Number.isNaN(i[s]);)s+=1;if(s===n){n=t+n>>1;continue}i[s]<=e?t=s:n=s}return n<0?-1:Math.abs(i[t]-e)<=Math.abs(i[n]-e)?t:n}var Sh=92,A_=40,C_="#444444";function Jf(i,e){let t=e.y_names.length,n=e.x_names.length,{values:s}=e.values,r=Ye(i,"div","cl-panel"),a=Ye(r,"canvas"),o=new Ss(r),l=0,c=[1,1],h=0;function d(f){if(!Number.isFinite(f))return C_;let g=Math.min(Math.max((f-e.low)/(e.high-e.low||1),0),1),y=e.colours.findIndex(([C])=>C>g);y<0&&(y=e.colours.length-1);let[[m,p],[v,T]]=[e.colours[y-1],e.colours[y]],b=(g-m)/(v-m||1);return`rgb(${[1,3,5].map(C=>{let x=parseInt(p.slice(C,C+2),16),A=parseInt(T.slice(C,C+2),16);return Math.round(x+Math.min(b,1)*(A-x))}).join()})`}function u(){let f=_r(i),g=bs(i);l=14+7*Math.max(...e.y_names.map(v=>v.length),3)+18,h=Math.min(Math.max(16*t,90),420),c=[(f-l-Sh)/n,h/t];let y=co(a,f,h+A_+8);y.translate(0,8);for(let v=0;v<t;v+=1)for(let T=0;T<n;T+=1)y.fillStyle=d(s[v*n+T]),y.fillRect(l+T*c[0],h-(v+1)*c[1],c[0]+.5,c[1]+.5);y.fillStyle=g.muted,y.font=xr,y.textBaseline="middle",y.textAlign="right",Zf(t,c[1],16,v=>y.fillText(e.y_names[v],l-6,h-(v+.5)*c[1])),y.textAlign="center";let m=7*Math.max(...e.x_names.map(v=>v.length))+10;Zf(n,c[0],m,v=>y.fillText(e.x_names[v],l+(v+.5)*c[0],h+11)),y.fillText(e.x_label,l+n*c[0]/2,h+29),y.save(),y.translate(8,h/2),y.rotate(-Math.PI/2),y.fillText(e.y_label,0,0),y.restore();for(let v=0;v<h;v+=1)y.fillStyle=d(e.low+(e.high-e.low)*(v+.5)/h),y.fillRect(f-Sh+14,h-v-1,12,1.5);y.fillStyle=g.muted,y.textAlign="left";let p=e.colours.find(([v],T)=>T>0&&v===e.colours[T-1][0])?.[0];for(let v of[0,p??.5,1]){if(v%1&&Math.min(v,1-v)*h<14)continue;let T=Rt(e.low+v*(e.high-e.low),"",3)+(v===1?` ${e.unit}`:"");y.fillText(T,f-Sh+30,Math.min(Math.max(h*(1-v),5),h-5))}}return a.addEventListener("pointermove",f=>{let g=Math.floor((f.offsetX-l)/c[0]),y=Math.floor((h+8-f.offsetY)/c[1]);if(g<0||y<0||g>=n||y>=t)return o.hide();let m=s[y*n+g],p=Number.isFinite(m)?Rt(m,e.unit):"diverged, or not judged";o.show(f.offsetX,f.offsetY,[[`${e.x_label} ${e.x_names[g]}`],[`${e.y_label} ${e.y_names[y]}`],[p]])}),a.addEventListener("pointerleave",()=>o.hide()),u(),{resize:u,destroy:()=>i.replaceChildren()}}function Zf(i,e,t,n){let s=Math.max(Math.ceil(t/e),1);for(let r=0;r<i;r+=s)n(r)}var Kf=`.cl-path { --p-ink: #1d2733; --p-muted: #5b6774; --p-edge: #c9d0d7; --p-paper: var(--card, #ffffff); --p-path: #7d8791; --p-rapid: #b4bdc6; --p-band: #8cc3b3;
  --p-poor: #a8321e; --p-picked: #f0a202; --p-accent: #0b5a94; color: var(--p-ink); font-size: .9rem; }
@media screen and (prefers-color-scheme: dark) {
  .cl-path { --p-ink: #e3e9ef; --p-muted: #9aa7b4; --p-edge: #3d4752; --p-paper: var(--card, #14191f); --p-path: #8d98a4; --p-rapid: #505b67; --p-band: #2f6f5e;
    --p-poor: #ff8f78; --p-picked: #ffb52e; --p-accent: #7cc0f5; }
}
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
`;var bp=0,Kh=1,wp=2;var Wa=1,Ep=2,jr=3,ks=0,Hn=1,Xi=2,sr=0,Qr=1,jh=2,Qh=3,eu=4,Tp=5;var rr=100,Ap=101,Cp=102,Rp=103,Pp=104,Ip=200,Lp=201,Np=202,Dp=203,tu=204,nu=205,Up=206,Fp=207,Op=208,Bp=209,kp=210,zp=211,Vp=212,Gp=213,Hp=214,Ko=0,jo=1,Qo=2,Xr=3,el=4,tl=5,nl=6,il=7,iu=0,Wp=1,Xp=2,qi=0,su=1,ru=2,au=3,ou=4,lu=5,cu=6,hu=7;var uu=300,ar=301,ea=302,Ll=303,Nl=304,sl=1e3,zi=1001,rl=1002,Cn=1003,qp=1004;var Xa=1005;var Gn=1006,Dl=1007;var ds=1008;var hi=1009,du=1010,fu=1011,ta=1012,Ul=1013,Ri=1014,Pi=1015,Ii=1016,Fl=1017,Ol=1018,or=1020,pu=35902,mu=35899,gu=1021,_u=1022,Li=1023,hs=1026,fs=1027,xu=1028,Bl=1029,zs=1030,kl=1031;var zl=1033,qa=33776,Ya=33777,$a=33778,Za=33779,Vl=35840,Gl=35841,Hl=35842,Wl=35843,Xl=36196,ql=37492,Yl=37496,$l=37488,Zl=37489,Ja=37490,Jl=37491,Kl=37808,jl=37809,Ql=37810,ec=37811,tc=37812,nc=37813,ic=37814,sc=37815,rc=37816,ac=37817,oc=37818,lc=37819,cc=37820,hc=37821,uc=36492,dc=36494,fc=36495,pc=36283,mc=36284,Ka=36285,gc=36286;var Ea=2300,al=2301,Zo=2302,Xh=2303,qh=2400,Yh=2401,$h=2402;var Yp=3200;var vu=0,$p=1,ps="",ri="srgb",Ta="srgb-linear",Aa="linear",Ut="srgb";var Jo=7680;var Zp=519,Jp=512,Kp=513,jp=514,yu=515,Qp=516,em=517,Mu=518,Su=519,tm=35044;var ja="300 es",xi=2e3,Ca=2001;function P_(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function I_(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ra(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function nm(){let i=Ra("canvas");return i.style.display="block",i}var jf={},qr=null;function bu(...i){let e="THREE."+i.shift();qr?qr("log",e,...i):console.log(e,...i)}function im(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function nt(...i){i=im(i);let e="THREE."+i.shift();if(qr)qr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function ot(...i){i=im(i);let e="THREE."+i.shift();if(qr)qr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function wa(...i){let e=i.join(" ");e in jf||(jf[e]=!0,nt(...i))}function sm(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var rm={[Ko]:Ko,[Qo]:nl,[el]:el,[Xr]:tl,[jo]:jo,[nl]:Qo,[il]:il,[tl]:Xr},Vi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}},Ln=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var bh=Math.PI/180,ol=180/Math.PI;function Qa(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Ln[i&255]+Ln[i>>8&255]+Ln[i>>16&255]+Ln[i>>24&255]+"-"+Ln[e&255]+Ln[e>>8&255]+"-"+Ln[e>>16&15|64]+Ln[e>>24&255]+"-"+Ln[t&63|128]+Ln[t>>8&255]+"-"+Ln[t>>16&255]+Ln[t>>24&255]+Ln[n&255]+Ln[n>>8&255]+Ln[n>>16&255]+Ln[n>>24&255]).toLowerCase()}function bt(i,e,t){return Math.max(e,Math.min(t,i))}function L_(i,e){return(i%e+e)%e}function wh(i,e,t){return(1-t)*i+t*e}function am(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function wu(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function N_(i,e){if(e.constructor===Float32Array)return i;let t=wu(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function D_(i,e){if(e.constructor===Float32Array)return i;let t=wu(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var wt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=bt(this.x,e.x,t.x),this.y=bt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=bt(this.x,e,t),this.y=bt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(bt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(bt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*n-a*s+e.x,this.y=r*s+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Gi=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,a,o){let l=n[s+0],c=n[s+1],h=n[s+2],d=n[s+3],u=r[a+0],f=r[a+1],g=r[a+2],y=r[a+3];if(d!==y||l!==u||c!==f||h!==g){let m=l*u+c*f+h*g+d*y;m<0&&(u=-u,f=-f,g=-g,y=-y,m=-m);let p=1-o;if(m<.9995){let v=Math.acos(m),T=Math.sin(v);p=Math.sin(p*v)/T,o=Math.sin(o*v)/T,l=l*p+u*o,c=c*p+f*o,h=h*p+g*o,d=d*p+y*o}else{l=l*p+u*o,c=c*p+f*o,h=h*p+g*o,d=d*p+y*o;let v=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=v,c*=v,h*=v,d*=v}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,s,r,a){let o=n[s],l=n[s+1],c=n[s+2],h=n[s+3],d=r[a],u=r[a+1],f=r[a+2],g=r[a+3];return e[t]=o*g+h*d+l*f-c*u,e[t+1]=l*g+h*u+c*d-o*f,e[t+2]=c*g+h*f+o*u-l*d,e[t+3]=h*g-o*d-l*u-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(n/2),h=o(s/2),d=o(r/2),u=l(n/2),f=l(s/2),g=l(r/2);switch(a){case"XYZ":this._x=u*h*d+c*f*g,this._y=c*f*d-u*h*g,this._z=c*h*g+u*f*d,this._w=c*h*d-u*f*g;break;case"YXZ":this._x=u*h*d+c*f*g,this._y=c*f*d-u*h*g,this._z=c*h*g-u*f*d,this._w=c*h*d+u*f*g;break;case"ZXY":this._x=u*h*d-c*f*g,this._y=c*f*d+u*h*g,this._z=c*h*g+u*f*d,this._w=c*h*d-u*f*g;break;case"ZYX":this._x=u*h*d-c*f*g,this._y=c*f*d+u*h*g,this._z=c*h*g-u*f*d,this._w=c*h*d+u*f*g;break;case"YZX":this._x=u*h*d+c*f*g,this._y=c*f*d+u*h*g,this._z=c*h*g-u*f*d,this._w=c*h*d-u*f*g;break;case"XZY":this._x=u*h*d-c*f*g,this._y=c*f*d-u*h*g,this._z=c*h*g+u*f*d,this._w=c*h*d+u*f*g;break;default:nt("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],h=t[6],d=t[10],u=n+o+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(a-s)*f}else if(n>o&&n>d){let f=2*Math.sqrt(1+n-o-d);this._w=(h-l)/f,this._x=.25*f,this._y=(s+a)/f,this._z=(r+c)/f}else if(o>d){let f=2*Math.sqrt(1+o-n-d);this._w=(r-c)/f,this._x=(s+a)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+d-n-o);this._w=(a-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(bt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+a*o+s*c-r*l,this._y=s*h+a*l+r*o-n*c,this._z=r*h+a*c+n*l-s*o,this._w=a*h-n*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let l=1-t;if(o<.9995){let c=Math.acos(o),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},j=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Qf.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Qf.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*n),h=2*(o*t-r*s),d=2*(r*n-a*t);return this.x=t+l*c+a*d-o*h,this.y=n+l*h+o*c-r*d,this.z=s+l*d+r*h-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=bt(this.x,e.x,t.x),this.y=bt(this.y,e.y,t.y),this.z=bt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=bt(this.x,e,t),this.y=bt(this.y,e,t),this.z=bt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(bt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-n*l,this.z=n*o-s*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Eh.copy(this).projectOnVector(e),this.sub(Eh)}reflect(e){return this.sub(Eh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(bt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Eh=new j,Qf=new Gi,lt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c)}set(e,t,n,s,r,a,o,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=o,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=a,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],f=n[5],g=n[8],y=s[0],m=s[3],p=s[6],v=s[1],T=s[4],b=s[7],P=s[2],C=s[5],x=s[8];return r[0]=a*y+o*v+l*P,r[3]=a*m+o*T+l*C,r[6]=a*p+o*b+l*x,r[1]=c*y+h*v+d*P,r[4]=c*m+h*T+d*C,r[7]=c*p+h*b+d*x,r[2]=u*y+f*v+g*P,r[5]=u*m+f*T+g*C,r[8]=u*p+f*b+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8];return t*a*h-t*o*c-n*r*h+n*o*l+s*r*c-s*a*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],d=h*a-o*c,u=o*l-h*r,f=c*r-a*l,g=t*d+n*u+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=d*y,e[1]=(s*c-h*n)*y,e[2]=(o*n-s*a)*y,e[3]=u*y,e[4]=(h*t-s*l)*y,e[5]=(s*r-o*t)*y,e[6]=f*y,e[7]=(n*l-c*t)*y,e[8]=(a*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return wa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Th.makeScale(e,t)),this}rotate(e){return wa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Th.makeRotation(-e)),this}translate(e,t){return wa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Th.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Th=new lt,ep=new lt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),tp=new lt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function U_(){let i={enabled:!0,workingColorSpace:Ta,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Ut&&(s.r=cs(s.r),s.g=cs(s.g),s.b=cs(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Ut&&(s.r=Wr(s.r),s.g=Wr(s.g),s.b=Wr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ps?Aa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ta]:{primaries:e,whitePoint:n,transfer:Aa,toXYZ:ep,fromXYZ:tp,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ri},outputColorSpaceConfig:{drawingBufferColorSpace:ri}},[ri]:{primaries:e,whitePoint:n,transfer:Ut,toXYZ:ep,fromXYZ:tp,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ri}}}),i}var St=U_();function cs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Wr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Ir,ll=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Ir===void 0&&(Ir=Ra("canvas")),Ir.width=e.width,Ir.height=e.height;let s=Ir.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Ir}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ra("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=cs(r[a]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(cs(t[n]/255)*255):t[n]=cs(t[n]);return{data:t,width:e.width,height:e.height}}else return nt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},F_=0,Yr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:F_++}),this.uuid=Qa(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(Ah(s[a].image)):r.push(Ah(s[a]))}else r=Ah(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Ah(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ll.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(nt("Texture: Unable to serialize Texture."),{})}var O_=0,Ch=new j,$n=class i extends Vi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=zi,s=zi,r=Gn,a=ds,o=Li,l=hi,c=i.DEFAULT_ANISOTROPY,h=ps){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:O_++}),this.uuid=Qa(),this.name="",this.source=new Yr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new wt(0,0),this.repeat=new wt(1,1),this.center=new wt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new lt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ch).x}get height(){return this.source.getSize(Ch).y}get depth(){return this.source.getSize(Ch).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){nt(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){nt(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==uu)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case sl:e.x=e.x-Math.floor(e.x);break;case zi:e.x=e.x<0?0:1;break;case rl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case sl:e.y=e.y-Math.floor(e.y);break;case zi:e.y=e.y<0?0:1;break;case rl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};$n.DEFAULT_IMAGE=null;$n.DEFAULT_MAPPING=uu;$n.DEFAULT_ANISOTROPY=1;var Qt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*n+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],g=l[9],y=l[2],m=l[6],p=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-y)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+y)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,b=(f+1)/2,P=(p+1)/2,C=(h+u)/4,x=(d+y)/4,A=(g+m)/4;return T>b&&T>P?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=C/n,r=x/n):b>P?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=C/s,r=A/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=x/r,s=A/r),this.set(n,s,r,t),this}let v=Math.sqrt((m-g)*(m-g)+(d-y)*(d-y)+(u-h)*(u-h));return Math.abs(v)<.001&&(v=1),this.x=(m-g)/v,this.y=(d-y)/v,this.z=(u-h)/v,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=bt(this.x,e.x,t.x),this.y=bt(this.y,e.y,t.y),this.z=bt(this.z,e.z,t.z),this.w=bt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=bt(this.x,e,t),this.y=bt(this.y,e,t),this.z=bt(this.z,e,t),this.w=bt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(bt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},cl=class extends Vi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Gn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Qt(0,0,e,t),this.scissorTest=!1,this.viewport=new Qt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new $n({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Gn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Yr(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},oi=class extends cl{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Pa=class extends $n{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=zi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var hl=class extends $n{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=zi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var rn=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,a,o,l,c,h,d,u,f,g,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c,h,d,u,f,g,y,m)}set(e,t,n,s,r,a,o,l,c,h,d,u,f,g,y,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=a,p[9]=o,p[13]=l,p[2]=c,p[6]=h,p[10]=d,p[14]=u,p[3]=f,p[7]=g,p[11]=y,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Lr.setFromMatrixColumn(e,0).length(),r=1/Lr.setFromMatrixColumn(e,1).length(),a=1/Lr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,a=Math.cos(n),o=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let u=a*h,f=a*d,g=o*h,y=o*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=f+g*c,t[5]=u-y*c,t[9]=-o*l,t[2]=y-u*c,t[6]=g+f*c,t[10]=a*l}else if(e.order==="YXZ"){let u=l*h,f=l*d,g=c*h,y=c*d;t[0]=u+y*o,t[4]=g*o-f,t[8]=a*c,t[1]=a*d,t[5]=a*h,t[9]=-o,t[2]=f*o-g,t[6]=y+u*o,t[10]=a*l}else if(e.order==="ZXY"){let u=l*h,f=l*d,g=c*h,y=c*d;t[0]=u-y*o,t[4]=-a*d,t[8]=g+f*o,t[1]=f+g*o,t[5]=a*h,t[9]=y-u*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){let u=a*h,f=a*d,g=o*h,y=o*d;t[0]=l*h,t[4]=g*c-f,t[8]=u*c+y,t[1]=l*d,t[5]=y*c+u,t[9]=f*c-g,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){let u=a*l,f=a*c,g=o*l,y=o*c;t[0]=l*h,t[4]=y-u*d,t[8]=g*d+f,t[1]=d,t[5]=a*h,t[9]=-o*h,t[2]=-c*h,t[6]=f*d+g,t[10]=u-y*d}else if(e.order==="XZY"){let u=a*l,f=a*c,g=o*l,y=o*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=u*d+y,t[5]=a*h,t[9]=f*d-g,t[2]=g*d-f,t[6]=o*h,t[10]=y*d+u}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(B_,e,k_)}lookAt(e,t,n){let s=this.elements;return ii.subVectors(e,t),ii.lengthSq()===0&&(ii.z=1),ii.normalize(),As.crossVectors(n,ii),As.lengthSq()===0&&(Math.abs(n.z)===1?ii.x+=1e-4:ii.z+=1e-4,ii.normalize(),As.crossVectors(n,ii)),As.normalize(),Ao.crossVectors(ii,As),s[0]=As.x,s[4]=Ao.x,s[8]=ii.x,s[1]=As.y,s[5]=Ao.y,s[9]=ii.y,s[2]=As.z,s[6]=Ao.z,s[10]=ii.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],f=n[13],g=n[2],y=n[6],m=n[10],p=n[14],v=n[3],T=n[7],b=n[11],P=n[15],C=s[0],x=s[4],A=s[8],z=s[12],U=s[1],D=s[5],W=s[9],X=s[13],I=s[2],V=s[6],Z=s[10],B=s[14],ue=s[3],J=s[7],Q=s[11],se=s[15];return r[0]=a*C+o*U+l*I+c*ue,r[4]=a*x+o*D+l*V+c*J,r[8]=a*A+o*W+l*Z+c*Q,r[12]=a*z+o*X+l*B+c*se,r[1]=h*C+d*U+u*I+f*ue,r[5]=h*x+d*D+u*V+f*J,r[9]=h*A+d*W+u*Z+f*Q,r[13]=h*z+d*X+u*B+f*se,r[2]=g*C+y*U+m*I+p*ue,r[6]=g*x+y*D+m*V+p*J,r[10]=g*A+y*W+m*Z+p*Q,r[14]=g*z+y*X+m*B+p*se,r[3]=v*C+T*U+b*I+P*ue,r[7]=v*x+T*D+b*V+P*J,r[11]=v*A+T*W+b*Z+P*Q,r[15]=v*z+T*X+b*B+P*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],h=e[2],d=e[6],u=e[10],f=e[14],g=e[3],y=e[7],m=e[11],p=e[15],v=l*f-c*u,T=o*f-c*d,b=o*u-l*d,P=a*f-c*h,C=a*u-l*h,x=a*d-o*h;return t*(y*v-m*T+p*b)-n*(g*v-m*P+p*C)+s*(g*T-y*P+p*x)-r*(g*b-y*C+m*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],a=e[5],o=e[9],l=e[2],c=e[6],h=e[10];return t*(a*h-o*c)-n*(r*h-o*l)+s*(r*c-a*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],h=e[8],d=e[9],u=e[10],f=e[11],g=e[12],y=e[13],m=e[14],p=e[15],v=t*o-n*a,T=t*l-s*a,b=t*c-r*a,P=n*l-s*o,C=n*c-r*o,x=s*c-r*l,A=h*y-d*g,z=h*m-u*g,U=h*p-f*g,D=d*m-u*y,W=d*p-f*y,X=u*p-f*m,I=v*X-T*W+b*D+P*U-C*z+x*A;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/I;return e[0]=(o*X-l*W+c*D)*V,e[1]=(s*W-n*X-r*D)*V,e[2]=(y*x-m*C+p*P)*V,e[3]=(u*C-d*x-f*P)*V,e[4]=(l*U-a*X-c*z)*V,e[5]=(t*X-s*U+r*z)*V,e[6]=(m*b-g*x-p*T)*V,e[7]=(h*x-u*b+f*T)*V,e[8]=(a*W-o*U+c*A)*V,e[9]=(n*U-t*W-r*A)*V,e[10]=(g*C-y*b+p*v)*V,e[11]=(d*b-h*C-f*v)*V,e[12]=(o*z-a*D-l*A)*V,e[13]=(t*D-n*z+s*A)*V,e[14]=(y*T-g*P-m*v)*V,e[15]=(h*P-d*T+u*v)*V,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,a=e.x,o=e.y,l=e.z,c=r*a,h=r*o;return this.set(c*a+n,c*o-s*l,c*l+s*o,0,c*o+s*l,h*o+n,h*l-s*a,0,c*l-s*o,h*l+s*a,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,a){return this.set(1,n,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,h=a+a,d=o+o,u=r*c,f=r*h,g=r*d,y=a*h,m=a*d,p=o*d,v=l*c,T=l*h,b=l*d,P=n.x,C=n.y,x=n.z;return s[0]=(1-(y+p))*P,s[1]=(f+b)*P,s[2]=(g-T)*P,s[3]=0,s[4]=(f-b)*C,s[5]=(1-(u+p))*C,s[6]=(m+v)*C,s[7]=0,s[8]=(g+T)*x,s[9]=(m-v)*x,s[10]=(1-(u+y))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let a=Lr.set(s[0],s[1],s[2]).length(),o=Lr.set(s[4],s[5],s[6]).length(),l=Lr.set(s[8],s[9],s[10]).length();r<0&&(a=-a),Ei.copy(this);let c=1/a,h=1/o,d=1/l;return Ei.elements[0]*=c,Ei.elements[1]*=c,Ei.elements[2]*=c,Ei.elements[4]*=h,Ei.elements[5]*=h,Ei.elements[6]*=h,Ei.elements[8]*=d,Ei.elements[9]*=d,Ei.elements[10]*=d,t.setFromRotationMatrix(Ei),n.x=a,n.y=o,n.z=l,this}makePerspective(e,t,n,s,r,a,o=xi,l=!1){let c=this.elements,h=2*r/(t-e),d=2*r/(n-s),u=(t+e)/(t-e),f=(n+s)/(n-s),g,y;if(l)g=r/(a-r),y=a*r/(a-r);else if(o===xi)g=-(a+r)/(a-r),y=-2*a*r/(a-r);else if(o===Ca)g=-a/(a-r),y=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,a,o=xi,l=!1){let c=this.elements,h=2/(t-e),d=2/(n-s),u=-(t+e)/(t-e),f=-(n+s)/(n-s),g,y;if(l)g=1/(a-r),y=a/(a-r);else if(o===xi)g=-2/(a-r),y=-(a+r)/(a-r);else if(o===Ca)g=-1/(a-r),y=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Lr=new j,Ei=new rn,B_=new j(0,0,0),k_=new j(1,1,1),As=new j,Ao=new j,ii=new j,np=new rn,ip=new Gi,Ns=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(bt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-bt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(o,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(bt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-bt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(bt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(o,f));break;case"XZY":this._z=Math.asin(-bt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:nt("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return np.makeRotationFromQuaternion(e),this.setFromRotationMatrix(np,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return ip.setFromEuler(this),this.setFromQuaternion(ip,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ns.DEFAULT_ORDER="XYZ";var Ia=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},z_=0,sp=new j,Nr=new Gi,ss=new rn,Co=new j,va=new j,V_=new j,G_=new Gi,rp=new j(1,0,0),ap=new j(0,1,0),op=new j(0,0,1),lp={type:"added"},H_={type:"removed"},Dr={type:"childadded",child:null},Rh={type:"childremoved",child:null},li=class i extends Vi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:z_++}),this.uuid=Qa(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new j,t=new Ns,n=new Gi,s=new j(1,1,1);function r(){n.setFromEuler(t,!1)}function a(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new rn},normalMatrix:{value:new lt}}),this.matrix=new rn,this.matrixWorld=new rn,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ia,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Nr.setFromAxisAngle(e,t),this.quaternion.multiply(Nr),this}rotateOnWorldAxis(e,t){return Nr.setFromAxisAngle(e,t),this.quaternion.premultiply(Nr),this}rotateX(e){return this.rotateOnAxis(rp,e)}rotateY(e){return this.rotateOnAxis(ap,e)}rotateZ(e){return this.rotateOnAxis(op,e)}translateOnAxis(e,t){return sp.copy(e).applyQuaternion(this.quaternion),this.position.add(sp.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(rp,e)}translateY(e){return this.translateOnAxis(ap,e)}translateZ(e){return this.translateOnAxis(op,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ss.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Co.copy(e):Co.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),va.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ss.lookAt(va,Co,this.up):ss.lookAt(Co,va,this.up),this.quaternion.setFromRotationMatrix(ss),s&&(ss.extractRotation(s.matrixWorld),Nr.setFromRotationMatrix(ss),this.quaternion.premultiply(Nr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(ot("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(lp),Dr.child=e,this.dispatchEvent(Dr),Dr.child=null):ot("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(H_),Rh.child=e,this.dispatchEvent(Rh),Rh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ss.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ss.multiply(e.parent.matrixWorld)),e.applyMatrix4(ss),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(lp),Dr.child=e,this.dispatchEvent(Dr),Dr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(va,e,V_),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(va,G_,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){let o=a(e.geometries),l=a(e.materials),c=a(e.textures),h=a(e.images),d=a(e.shapes),u=a(e.skeletons),f=a(e.animations),g=a(e.nodes);o.length>0&&(n.geometries=o),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){let l=[];for(let c in o){let h=o[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};li.DEFAULT_UP=new j(0,1,0);li.DEFAULT_MATRIX_AUTO_UPDATE=!0;li.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var tr=class extends li{constructor(){super(),this.isGroup=!0,this.type="Group"}},W_={type:"move"},$r=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new tr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new tr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new j,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new j),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new tr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new j,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new j,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(let y of e.hand.values()){let m=t.getJointPose(y,n),p=this._getHandJoint(c,y);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,g=.005;c.inputState.pinching&&u>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&u<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(W_)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new tr;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},om={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Cs={h:0,s:0,l:0},Ro={h:0,s:0,l:0};function Ph(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Et=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ri){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=n,St.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=St.workingColorSpace){if(e=L_(e,1),t=bt(t,0,1),n=bt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,a=2*n-r;this.r=Ph(a,r,e+1/3),this.g=Ph(a,r,e),this.b=Ph(a,r,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=ri){function n(r){r!==void 0&&parseFloat(r)<1&&nt("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:nt("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);nt("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ri){let n=om[e.toLowerCase()];return n!==void 0?this.setHex(n,t):nt("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=cs(e.r),this.g=cs(e.g),this.b=cs(e.b),this}copyLinearToSRGB(e){return this.r=Wr(e.r),this.g=Wr(e.g),this.b=Wr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ri){return St.workingToColorSpace(Nn.copy(this),e),Math.round(bt(Nn.r*255,0,255))*65536+Math.round(bt(Nn.g*255,0,255))*256+Math.round(bt(Nn.b*255,0,255))}getHexString(e=ri){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(Nn.copy(this),t);let n=Nn.r,s=Nn.g,r=Nn.b,a=Math.max(n,s,r),o=Math.min(n,s,r),l,c,h=(o+a)/2;if(o===a)l=0,c=0;else{let d=a-o;switch(c=h<=.5?d/(a+o):d/(2-a-o),a){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(Nn.copy(this),t),e.r=Nn.r,e.g=Nn.g,e.b=Nn.b,e}getStyle(e=ri){St.workingToColorSpace(Nn.copy(this),e);let t=Nn.r,n=Nn.g,s=Nn.b;return e!==ri?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Cs),this.setHSL(Cs.h+e,Cs.s+t,Cs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Cs),e.getHSL(Ro);let n=wh(Cs.h,Ro.h,t),s=wh(Cs.s,Ro.s,t),r=wh(Cs.l,Ro.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Nn=new Et;Et.NAMES=om;var La=class extends li{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ns,this.environmentIntensity=1,this.environmentRotation=new Ns,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ti=new j,rs=new j,Ih=new j,as=new j,Ur=new j,Fr=new j,cp=new j,Lh=new j,Nh=new j,Dh=new j,Uh=new Qt,Fh=new Qt,Oh=new Qt,Ls=class i{constructor(e=new j,t=new j,n=new j){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Ti.subVectors(e,t),s.cross(Ti);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Ti.subVectors(s,t),rs.subVectors(n,t),Ih.subVectors(e,t);let a=Ti.dot(Ti),o=Ti.dot(rs),l=Ti.dot(Ih),c=rs.dot(rs),h=rs.dot(Ih),d=a*c-o*o;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(c*l-o*h)*u,g=(a*h-o*l)*u;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,as)===null?!1:as.x>=0&&as.y>=0&&as.x+as.y<=1}static getInterpolation(e,t,n,s,r,a,o,l){return this.getBarycoord(e,t,n,s,as)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,as.x),l.addScaledVector(a,as.y),l.addScaledVector(o,as.z),l)}static getInterpolatedAttribute(e,t,n,s,r,a){return Uh.setScalar(0),Fh.setScalar(0),Oh.setScalar(0),Uh.fromBufferAttribute(e,t),Fh.fromBufferAttribute(e,n),Oh.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(Uh,r.x),a.addScaledVector(Fh,r.y),a.addScaledVector(Oh,r.z),a}static isFrontFacing(e,t,n,s){return Ti.subVectors(n,t),rs.subVectors(e,t),Ti.cross(rs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ti.subVectors(this.c,this.b),rs.subVectors(this.a,this.b),Ti.cross(rs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,a,o;Ur.subVectors(s,n),Fr.subVectors(r,n),Lh.subVectors(e,n);let l=Ur.dot(Lh),c=Fr.dot(Lh);if(l<=0&&c<=0)return t.copy(n);Nh.subVectors(e,s);let h=Ur.dot(Nh),d=Fr.dot(Nh);if(h>=0&&d<=h)return t.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return a=l/(l-h),t.copy(n).addScaledVector(Ur,a);Dh.subVectors(e,r);let f=Ur.dot(Dh),g=Fr.dot(Dh);if(g>=0&&f<=g)return t.copy(r);let y=f*c-l*g;if(y<=0&&c>=0&&g<=0)return o=c/(c-g),t.copy(n).addScaledVector(Fr,o);let m=h*g-f*d;if(m<=0&&d-h>=0&&f-g>=0)return cp.subVectors(r,s),o=(d-h)/(d-h+(f-g)),t.copy(s).addScaledVector(cp,o);let p=1/(m+y+u);return a=y*p,o=u*p,t.copy(n).addScaledVector(Ur,a).addScaledVector(Fr,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ds=class{constructor(e=new j(1/0,1/0,1/0),t=new j(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ai.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ai.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ai.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,Ai):Ai.fromBufferAttribute(r,a),Ai.applyMatrix4(e.matrixWorld),this.expandByPoint(Ai);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Po.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Po.copy(n.boundingBox)),Po.applyMatrix4(e.matrixWorld),this.union(Po)}let s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ai),Ai.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ya),Io.subVectors(this.max,ya),Or.subVectors(e.a,ya),Br.subVectors(e.b,ya),kr.subVectors(e.c,ya),Rs.subVectors(Br,Or),Ps.subVectors(kr,Br),Ks.subVectors(Or,kr);let t=[0,-Rs.z,Rs.y,0,-Ps.z,Ps.y,0,-Ks.z,Ks.y,Rs.z,0,-Rs.x,Ps.z,0,-Ps.x,Ks.z,0,-Ks.x,-Rs.y,Rs.x,0,-Ps.y,Ps.x,0,-Ks.y,Ks.x,0];return!Bh(t,Or,Br,kr,Io)||(t=[1,0,0,0,1,0,0,0,1],!Bh(t,Or,Br,kr,Io))?!1:(Lo.crossVectors(Rs,Ps),t=[Lo.x,Lo.y,Lo.z],Bh(t,Or,Br,kr,Io))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ai).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ai).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(os[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),os[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),os[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),os[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),os[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),os[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),os[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),os[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(os),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},os=[new j,new j,new j,new j,new j,new j,new j,new j],Ai=new j,Po=new Ds,Or=new j,Br=new j,kr=new j,Rs=new j,Ps=new j,Ks=new j,ya=new j,Io=new j,Lo=new j,js=new j;function Bh(i,e,t,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){js.fromArray(i,r);let o=s.x*Math.abs(js.x)+s.y*Math.abs(js.y)+s.z*Math.abs(js.z),l=e.dot(js),c=t.dot(js),h=n.dot(js);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>o)return!1}return!0}var xn=new j,No=new wt,X_=0,qn=class extends Vi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:X_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=tm,this.updateRanges=[],this.gpuType=Pi,this.version=0,this._normalizationScale=e!==void 0?wu(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)No.fromBufferAttribute(this,t),No.applyMatrix3(e),this.setXY(t,No.x,No.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix3(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix4(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.applyNormalMatrix(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.transformDirection(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):N_(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):D_(e,this.array)}};var Na=class extends qn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Da=class extends qn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Yn=class extends qn{constructor(e,t,n){super(new Float32Array(e),t,n)}},q_=new Ds,Ma=new j,kh=new j,nr=class{constructor(e=new j,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):q_.setFromPoints(e).getCenter(n);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ma.subVectors(e,this.center);let t=Ma.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Ma,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(kh.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ma.copy(e.center).add(kh)),this.expandByPoint(Ma.copy(e.center).sub(kh))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Y_=0,_i=new rn,zh=new li,zr=new j,si=new Ds,Sa=new Ds,An=new j,Hi=class i extends Vi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Y_++}),this.uuid=Qa(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(P_(e)?Da:Na)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new lt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return _i.makeRotationFromQuaternion(e),this.applyMatrix4(_i),this}rotateX(e){return _i.makeRotationX(e),this.applyMatrix4(_i),this}rotateY(e){return _i.makeRotationY(e),this.applyMatrix4(_i),this}rotateZ(e){return _i.makeRotationZ(e),this.applyMatrix4(_i),this}translate(e,t,n){return _i.makeTranslation(e,t,n),this.applyMatrix4(_i),this}scale(e,t,n){return _i.makeScale(e,t,n),this.applyMatrix4(_i),this}lookAt(e){return zh.lookAt(e),zh.updateMatrix(),this.applyMatrix4(zh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(zr).negate(),this.translate(zr.x,zr.y,zr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let a=e[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new Yn(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&nt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ds);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ot("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new j(-1/0,-1/0,-1/0),new j(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];si.setFromBufferAttribute(r),this.morphTargetsRelative?(An.addVectors(this.boundingBox.min,si.min),this.boundingBox.expandByPoint(An),An.addVectors(this.boundingBox.max,si.max),this.boundingBox.expandByPoint(An)):(this.boundingBox.expandByPoint(si.min),this.boundingBox.expandByPoint(si.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ot('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new nr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){ot("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new j,1/0);return}if(e){let n=this.boundingSphere.center;if(si.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){let o=t[r];Sa.setFromBufferAttribute(o),this.morphTargetsRelative?(An.addVectors(si.min,Sa.min),si.expandByPoint(An),An.addVectors(si.max,Sa.max),si.expandByPoint(An)):(si.expandByPoint(Sa.min),si.expandByPoint(Sa.max))}si.getCenter(n);let s=0;for(let r=0,a=e.count;r<a;r++)An.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(An));if(t)for(let r=0,a=t.length;r<a;r++){let o=t[r],l=this.morphTargetsRelative;for(let c=0,h=o.count;c<h;c++)An.fromBufferAttribute(o,c),l&&(zr.fromBufferAttribute(e,c),An.add(zr)),s=Math.max(s,n.distanceToSquared(An))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ot('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){ot("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new qn(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(n.count);for(let z=0;z<n.count;z++)o[z]=new j,l[z]=new j;let h=new j,d=new j,u=new j,f=new wt,g=new wt,y=new wt,m=new j,p=new j;function v(z,U,D){c[z]=c[U]=c[D]=1,h.fromBufferAttribute(n,z),d.fromBufferAttribute(n,U),u.fromBufferAttribute(n,D),f.fromBufferAttribute(r,z),g.fromBufferAttribute(r,U),y.fromBufferAttribute(r,D),d.sub(h),u.sub(h),g.sub(f),y.sub(f);let W=1/(g.x*y.y-y.x*g.y);isFinite(W)&&(m.copy(d).multiplyScalar(y.y).addScaledVector(u,-g.y).multiplyScalar(W),p.copy(u).multiplyScalar(g.x).addScaledVector(d,-y.x).multiplyScalar(W),o[z].add(m),o[U].add(m),o[D].add(m),l[z].add(p),l[U].add(p),l[D].add(p))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let z=0,U=T.length;z<U;++z){let D=T[z],W=D.start,X=D.count;for(let I=W,V=W+X;I<V;I+=3)v(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let b=new j,P=new j,C=new j,x=new j;function A(z){C.fromBufferAttribute(s,z),x.copy(C);let U=o[z];b.copy(U),b.sub(C.multiplyScalar(C.dot(U))).normalize(),P.crossVectors(x,U);let W=P.dot(l[z])<0?-1:1;a.setXYZW(z,b.x,b.y,b.z,W)}for(let z=0,U=n.count;z<U;++z)c[z]&&A(z);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new qn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let u=0,f=n.count;u<f;u++)n.setXYZ(u,0,0,0);let s=new j,r=new j,a=new j,o=new j,l=new j,c=new j,h=new j,d=new j;if(e)for(let u=0,f=e.count;u<f;u+=3){let g=e.getX(u+0),y=e.getX(u+1),m=e.getX(u+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),a.fromBufferAttribute(t,m),h.subVectors(a,r),d.subVectors(s,r),h.cross(d),o.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,m),o.add(h),l.add(h),c.add(h),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,f=t.count;u<f;u+=3)s.fromBufferAttribute(t,u+0),r.fromBufferAttribute(t,u+1),a.fromBufferAttribute(t,u+2),h.subVectors(a,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)An.fromBufferAttribute(e,t),An.normalize(),e.setXYZ(t,An.x,An.y,An.z)}toNonIndexed(){function e(o,l){let c=o.array,h=o.itemSize,d=o.normalized,u=new c.constructor(l.length*h),f=0,g=0;for(let y=0,m=l.length;y<m;y++){o.isInterleavedBufferAttribute?f=l[y]*o.data.stride+o.offset:f=l[y]*h;for(let p=0;p<h;p++)u[g++]=c[f++]}return new qn(u,h,d)}if(this.index===null)return nt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let o in s){let l=s[o],c=e(l,n);t.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let h=0,d=c.length;h<d;h++){let u=c[h],f=e(u,n);l.push(f)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let f=c[d];h.push(f.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let c=0,h=a.length;c<h;c++){let d=a[c];this.addGroup(d.start,d.count,d.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Vh=new j,$_=new j,Z_=new lt,Ci=class{constructor(e=new j(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Vh.subVectors(n,t).cross($_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Vh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Z_.getNormalMatrix(e),s=this.coplanarPoint(Vh).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},J_=0,Us=class extends Vi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:J_++}),this.uuid=Qa(),this.name="",this.type="Material",this.blending=Qr,this.side=ks,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=tu,this.blendDst=nu,this.blendEquation=rr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Et(0,0,0),this.blendAlpha=0,this.depthFunc=Xr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Zp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Jo,this.stencilZFail=Jo,this.stencilZPass=Jo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){nt(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){nt(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(t){let r=s(e.textures),a=s(e.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Et().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Ci().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new wt().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new wt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ls=new j,Gh=new j,Do=new j,Uo=new j,Ua=class{constructor(e=new j,t=new j(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ls)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ls.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ls.copy(this.origin).addScaledVector(this.direction,t),ls.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Gh.copy(e).add(t).multiplyScalar(.5),Do.copy(t).sub(e).normalize(),Uo.copy(this.origin).sub(Gh);let r=e.distanceTo(t)*.5,a=-this.direction.dot(Do),o=Uo.dot(this.direction),l=-Uo.dot(Do),c=Uo.lengthSq(),h=Math.abs(1-a*a),d,u,f,g;if(h>0)if(d=a*l-o,u=a*o-l,g=r*h,d>=0)if(u>=-g)if(u<=g){let y=1/h;d*=y,u*=y,f=d*(d+a*u+2*o)+u*(a*d+u+2*l)+c}else u=r,d=Math.max(0,-(a*u+o)),f=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(a*u+o)),f=-d*d+u*(u+2*l)+c;else u<=-g?(d=Math.max(0,-(-a*r+o)),u=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c):u<=g?(d=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(d=Math.max(0,-(a*r+o)),u=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c);else u=a>0?-r:r,d=Math.max(0,-(a*u+o)),f=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Gh).addScaledVector(Do,u),f}intersectSphere(e,t){if(e.radius<0)return null;ls.subVectors(e.center,this.origin);let n=ls.dot(this.direction),s=ls.dot(ls)-n*n,r=e.radius*e.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,l=n+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,a,o,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(e.min.x-u.x)*c,s=(e.max.x-u.x)*c):(n=(e.max.x-u.x)*c,s=(e.min.x-u.x)*c),h>=0?(r=(e.min.y-u.y)*h,a=(e.max.y-u.y)*h):(r=(e.max.y-u.y)*h,a=(e.min.y-u.y)*h),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),d>=0?(o=(e.min.z-u.z)*d,l=(e.max.z-u.z)*d):(o=(e.max.z-u.z)*d,l=(e.min.z-u.z)*d),n>l||o>s)||((o>n||n!==n)&&(n=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,ls)!==null}intersectTriangle(e,t,n,s,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,h=o.z,d=e.x-a.x,u=e.y-a.y,f=e.z-a.z,g=t.x-a.x,y=t.y-a.y,m=t.z-a.z,p=n.x-a.x,v=n.y-a.y,T=n.z-a.z,b=Math.abs(l),P=Math.abs(c),C=Math.abs(h),x,A,z,U,D,W,X,I,V,Z,B,ue;if(b>=P&&b>=C?(z=l,W=d,V=g,ue=p,l>=0?(x=c,A=h,U=u,D=f,X=y,I=m,Z=v,B=T):(x=h,A=c,U=f,D=u,X=m,I=y,Z=T,B=v)):P>=C?(z=c,W=u,V=y,ue=v,c>=0?(x=h,A=l,U=f,D=d,X=m,I=g,Z=T,B=p):(x=l,A=h,U=d,D=f,X=g,I=m,Z=p,B=T)):(z=h,W=f,V=m,ue=T,h>=0?(x=l,A=c,U=d,D=u,X=g,I=y,Z=p,B=v):(x=c,A=l,U=u,D=d,X=y,I=g,Z=v,B=p)),z===0)return null;let J=x/z,Q=A/z,se=1/z,oe=U-J*W,fe=D-Q*W,ee=X-J*V,xe=I-Q*V,ve=Z-J*ue,Te=B-Q*ue,we=ve*xe-Te*ee,$e=oe*Te-fe*ve,it=ee*fe-xe*oe;if(s){if(we<0||$e<0||it<0)return null}else if((we<0||$e<0||it<0)&&(we>0||$e>0||it>0))return null;let Xe=we+$e+it;if(Xe===0)return null;let ut=se*(we*W+$e*V+it*ue);return(Xe>0?ut<0:ut>0)?null:this.at(ut/Xe,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ul=class extends Us{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Et(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ns,this.combine=iu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},hp=new rn,Qs=new Ua,Fo=new nr,up=new j,Oo=new j,Bo=new j,ko=new j,Hh=new j,zo=new j,dp=new j,Vo=new j,Wi=class extends li{constructor(e=new Hi,t=new ul){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let o=this.morphTargetInfluences;if(r&&o){zo.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=o[l],d=r[l];h!==0&&(Hh.fromBufferAttribute(d,e),a?zo.addScaledVector(Hh,h):zo.addScaledVector(Hh.sub(t),h))}t.add(zo)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Fo.copy(n.boundingSphere),Fo.applyMatrix4(r),Qs.copy(e.ray).recast(e.near),!(Fo.containsPoint(Qs.origin)===!1&&(Qs.intersectSphere(Fo,up)===null||Qs.origin.distanceToSquared(up)>(e.far-e.near)**2))&&(hp.copy(r).invert(),Qs.copy(e.ray).applyMatrix4(hp),!(n.boundingBox!==null&&Qs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Qs)))}_computeIntersections(e,t,n){let s,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,y=u.length;g<y;g++){let m=u[g],p=a[m.materialIndex],v=Math.max(m.start,f.start),T=Math.min(o.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,P=T;b<P;b+=3){let C=o.getX(b),x=o.getX(b+1),A=o.getX(b+2);s=Go(this,p,e,n,c,h,d,C,x,A),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(o.count,f.start+f.count);for(let m=g,p=y;m<p;m+=3){let v=o.getX(m),T=o.getX(m+1),b=o.getX(m+2);s=Go(this,a,e,n,c,h,d,v,T,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let g=0,y=u.length;g<y;g++){let m=u[g],p=a[m.materialIndex],v=Math.max(m.start,f.start),T=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,P=T;b<P;b+=3){let C=b,x=b+1,A=b+2;s=Go(this,p,e,n,c,h,d,C,x,A),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let m=g,p=y;m<p;m+=3){let v=m,T=m+1,b=m+2;s=Go(this,a,e,n,c,h,d,v,T,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function K_(i,e,t,n,s,r,a,o){let l;if(e.side===Hn?l=n.intersectTriangle(a,r,s,!0,o):l=n.intersectTriangle(s,r,a,e.side===ks,o),l===null)return null;Vo.copy(o),Vo.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Vo);return c<t.near||c>t.far?null:{distance:c,point:Vo.clone(),object:i}}function Go(i,e,t,n,s,r,a,o,l,c){i.getVertexPosition(o,Oo),i.getVertexPosition(l,Bo),i.getVertexPosition(c,ko);let h=K_(i,e,t,n,Oo,Bo,ko,dp);if(h){let d=new j;Ls.getBarycoord(dp,Oo,Bo,ko,d),s&&(h.uv=Ls.getInterpolatedAttribute(s,o,l,c,d,new wt)),r&&(h.uv1=Ls.getInterpolatedAttribute(r,o,l,c,d,new wt)),a&&(h.normal=Ls.getInterpolatedAttribute(a,o,l,c,d,new j),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a:o,b:l,c,normal:new j,materialIndex:0};Ls.getNormal(Oo,Bo,ko,u.normal),h.face=u,h.barycoord=d}return h}var dl=class extends $n{constructor(e=null,t=1,n=1,s,r,a,o,l,c=Cn,h=Cn,d,u){super(null,a,o,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var er=new nr,j_=new wt(.5,.5),Ho=new j,ir=class{constructor(e=new Ci,t=new Ci,n=new Ci,s=new Ci,r=new Ci,a=new Ci){this.planes=[e,t,n,s,r,a]}set(e,t,n,s,r,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=xi,n=!1){let s=this.planes,r=e.elements,a=r[0],o=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],f=r[7],g=r[8],y=r[9],m=r[10],p=r[11],v=r[12],T=r[13],b=r[14],P=r[15];if(s[0].setComponents(c-a,f-h,p-g,P-v).normalize(),s[1].setComponents(c+a,f+h,p+g,P+v).normalize(),s[2].setComponents(c+o,f+d,p+y,P+T).normalize(),s[3].setComponents(c-o,f-d,p-y,P-T).normalize(),n)s[4].setComponents(l,u,m,b).normalize(),s[5].setComponents(c-l,f-u,p-m,P-b).normalize();else if(s[4].setComponents(c-l,f-u,p-m,P-b).normalize(),t===xi)s[5].setComponents(c+l,f+u,p+m,P+b).normalize();else if(t===Ca)s[5].setComponents(l,u,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),er.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),er.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(er)}intersectsSprite(e){er.center.set(0,0,0);let t=j_.distanceTo(e.center);return er.radius=.7071067811865476+t,er.applyMatrix4(e.matrixWorld),this.intersectsSphere(er)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Ho.x=s.normal.x>0?e.max.x:e.min.x,Ho.y=s.normal.y>0?e.max.y:e.min.y,Ho.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ho)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},fp=new rn,fl=class i{constructor(){this.coordinateSystem=xi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];fp.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new ir),n[s].setFromProjectionMatrix(fp,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new ir),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var pl=class extends Us{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Et(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},ml=new j,gl=new j,pp=new rn,ba=new Ua,Wo=new nr,Wh=new j,mp=new j,_l=class extends li{constructor(e=new Hi,t=new pl){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)ml.fromBufferAttribute(t,s-1),gl.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=ml.distanceTo(gl);e.setAttribute("lineDistance",new Yn(n,1))}else nt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,a=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Wo.copy(n.boundingSphere),Wo.applyMatrix4(s),Wo.radius+=r,e.ray.intersectsSphere(Wo)===!1)return;pp.copy(s).invert(),ba.copy(e.ray).applyMatrix4(pp);let o=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=o*o,c=this.isLineSegments?2:1,h=n.index,u=n.attributes.position;if(h!==null){let f=Math.max(0,a.start),g=Math.min(h.count,a.start+a.count);for(let y=f,m=g-1;y<m;y+=c){let p=h.getX(y),v=h.getX(y+1),T=Xo(this,e,ba,l,p,v,y);T&&t.push(T)}if(this.isLineLoop){let y=h.getX(g-1),m=h.getX(f),p=Xo(this,e,ba,l,y,m,g-1);p&&t.push(p)}}else{let f=Math.max(0,a.start),g=Math.min(u.count,a.start+a.count);for(let y=f,m=g-1;y<m;y+=c){let p=Xo(this,e,ba,l,y,y+1,y);p&&t.push(p)}if(this.isLineLoop){let y=Xo(this,e,ba,l,g-1,f,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}};function Xo(i,e,t,n,s,r,a){let o=i.geometry.attributes.position;if(ml.fromBufferAttribute(o,s),gl.fromBufferAttribute(o,r),t.distanceSqToSegment(ml,gl,Wh,mp)>n)return;Wh.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Wh);if(!(c<e.near||c>e.far))return{distance:c,point:mp.clone().applyMatrix4(i.matrixWorld),index:a,face:null,faceIndex:null,barycoord:null,object:i}}var gp=new j,_p=new j,Fa=class extends _l{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)gp.fromBufferAttribute(t,s),_p.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+gp.distanceTo(_p);e.setAttribute("lineDistance",new Yn(n,1))}else nt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Oa=class extends $n{constructor(e=[],t=ar,n,s,r,a,o,l,c,h){super(e,t,n,s,r,a,o,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var us=class extends $n{constructor(e,t,n=Ri,s,r,a,o=Cn,l=Cn,c,h=hs,d=1){if(h!==hs&&h!==fs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:e,height:t,depth:d};super(u,s,r,a,o,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Yr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ba=class extends us{constructor(e,t=Ri,n=ar,s,r,a=Cn,o=Cn,l,c=hs){let h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,n,s,r,a,o,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ka=class extends $n{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Zr=class i extends Hi{constructor(e=1,t=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],h=[],d=[],u=0,f=0;g("z","y","x",-1,-1,n,t,e,a,r,0),g("z","y","x",1,-1,n,t,-e,a,r,1),g("x","z","y",1,1,e,n,t,s,a,2),g("x","z","y",1,-1,e,n,-t,s,a,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Yn(c,3)),this.setAttribute("normal",new Yn(h,3)),this.setAttribute("uv",new Yn(d,2));function g(y,m,p,v,T,b,P,C,x,A,z){let U=b/x,D=P/A,W=b/2,X=P/2,I=C/2,V=x+1,Z=A+1,B=0,ue=0,J=new j;for(let Q=0;Q<Z;Q++){let se=Q*D-X;for(let oe=0;oe<V;oe++){let fe=oe*U-W;J[y]=fe*v,J[m]=se*T,J[p]=I,c.push(J.x,J.y,J.z),J[y]=0,J[m]=0,J[p]=C>0?1:-1,h.push(J.x,J.y,J.z),d.push(oe/x),d.push(1-Q/A),B+=1}}for(let Q=0;Q<A;Q++)for(let se=0;se<x;se++){let oe=u+se+V*Q,fe=u+se+V*(Q+1),ee=u+(se+1)+V*(Q+1),xe=u+(se+1)+V*Q;l.push(oe,fe,xe),l.push(fe,ee,xe),ue+=6}o.addGroup(f,ue,z),f+=ue,u+=B}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var za=class i extends Hi{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,a=t/2,o=Math.floor(n),l=Math.floor(s),c=o+1,h=l+1,d=e/o,u=t/l,f=[],g=[],y=[],m=[];for(let p=0;p<h;p++){let v=p*u-a;for(let T=0;T<c;T++){let b=T*d-r;g.push(b,-v,0),y.push(0,0,1),m.push(T/o),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let v=0;v<o;v++){let T=v+c*p,b=v+c*(p+1),P=v+1+c*(p+1),C=v+1+c*p;f.push(T,b,C),f.push(b,P,C)}this.setIndex(f),this.setAttribute("position",new Yn(g,3)),this.setAttribute("normal",new Yn(y,3)),this.setAttribute("uv",new Yn(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};function lr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(xp(s))s.isRenderTargetTexture?(nt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(xp(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Dn(i){let e={};for(let t=0;t<i.length;t++){let n=lr(i[t]);for(let s in n)e[s]=n[s]}return e}function xp(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Q_(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Eu(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var lm={clone:lr,merge:Dn},ex=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,tx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,vi=class extends Us{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=ex,this.fragmentShader=tx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=lr(e.uniforms),this.uniformsGroups=Q_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Et().setHex(s.value);break;case"v2":this.uniforms[n].value=new wt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new j().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Qt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new lt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new rn().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},xl=class extends vi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var vl=class extends Us{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Yp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},yl=class extends Us{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Vr(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function qo(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Fs=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let a;t:{i:if(!(e<s)){for(let o=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=t[++n],e<s)break e}a=t.length;break t}if(!(e>=r)){let o=t[1];e<o&&(n=2,r=o);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}a=n,n=0;break t}break n}for(;n<a;){let o=n+a>>>1;e<t[o]?a=o:n=o+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let a=0;a!==s;++a)t[a]=n[r+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ml=class extends Fs{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:qh,endingEnd:qh}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,a=e+1,o=s[r],l=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case Yh:r=e,o=2*t-n;break;case $h:r=s.length-2,o=t+s[r]-s[r+1];break;default:r=e,o=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Yh:a=e,l=2*n-t;break;case $h:a=1,l=n+s[1]-s[0];break;default:a=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=a*h}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),y=g*g,m=y*g,p=-u*m+2*u*y-u*g,v=(1+u)*m+(-1.5-2*u)*y+(-.5+u)*g+1,T=(-1-f)*m+(1.5+f)*y+.5*g,b=f*m-f*y;for(let P=0;P!==o;++P)r[P]=p*a[h+P]+v*a[c+P]+T*a[l+P]+b*a[d+P];return r}},Sl=class extends Fs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=(n-t)/(s-t),d=1-h;for(let u=0;u!==o;++u)r[u]=a[c+u]*d+a[l+u]*h;return r}},bl=class extends Fs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},wl=class extends Fs{interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,h=this.inTangents,d=this.outTangents;if(!h||!d){let g=(n-t)/(s-t),y=1-g;for(let m=0;m!==o;++m)r[m]=a[c+m]*y+a[l+m]*g;return r}let u=o*2,f=e-1;for(let g=0;g!==o;++g){let y=a[c+g],m=a[l+g],p=f*u+g*2,v=d[p],T=d[p+1],b=e*u+g*2,P=h[b],C=h[b+1],x=ix(n,t,v,P,s);r[g]=cm(x,y,T,C,m)}return r}};function cm(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function nx(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function ix(i,e,t,n,s){let r=(i-e)/(s-e);for(let a=0;a<8;a++){let o=cm(r,e,t,n,s)-i;if(Math.abs(o)<1e-10)break;let l=nx(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var ci=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Vr(t,this.TimeBufferType),this.values=Vr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Vr(e.times,Array),values:Vr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),qo(e.settings)&&(n.settings={inTangents:Vr(e.settings.inTangents,Array),outTangents:Vr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new bl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Sl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Ml(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new wl(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ea:t=this.InterpolantFactoryMethodDiscrete;break;case al:t=this.InterpolantFactoryMethodLinear;break;case Zo:t=this.InterpolantFactoryMethodSmooth;break;case Xh:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return nt("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ea;case this.InterpolantFactoryMethodLinear:return al;case this.InterpolantFactoryMethodSmooth:return Zo;case this.InterpolantFactoryMethodBezier:return Xh}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;qo(this.settings)&&(vp(this.settings.inTangents,e),vp(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;qo(this.settings)&&(yp(this.settings.inTangents,e),yp(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<e;)++r;for(;a!==-1&&n[a]>t;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(ot("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(ot("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let o=0;o!==r;o++){let l=n[o];if(typeof l=="number"&&isNaN(l)){ot("KeyframeTrack: Time is not a valid number.",this,o,l),e=!1;break}if(a!==null&&a>l){ot("KeyframeTrack: Out of order keys.",this,o,l,a),e=!1;break}a=l}if(s!==void 0&&I_(s))for(let o=0,l=s.length;o!==l;++o){let c=s[o];if(isNaN(c)){ot("KeyframeTrack: Value is not a valid number.",this,o,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Zo,r=e.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=e[o],h=e[o+1];if(c!==h&&(o!==1||c!==e[0]))if(s)l=!0;else{let d=o*n,u=d-n,f=d+n;for(let g=0;g!==n;++g){let y=t[d+g];if(y!==t[u+g]||y!==t[f+g]){l=!0;break}}}if(l){if(o!==a){e[a]=e[o];let d=o*n,u=a*n;for(let f=0;f!==n;++f)t[u+f]=t[d+f]}++a}}if(r>0){e[a]=e[r];for(let o=r*n,l=a*n,c=0;c!==n;++c)t[l+c]=t[o+c];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,qo(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function vp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function yp(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}ci.prototype.ValueTypeName="";ci.prototype.TimeBufferType=Float32Array;ci.prototype.ValueBufferType=Float32Array;ci.prototype.DefaultInterpolation=al;var Os=class extends ci{constructor(e,t,n){super(e,t,n)}};Os.prototype.ValueTypeName="bool";Os.prototype.ValueBufferType=Array;Os.prototype.DefaultInterpolation=Ea;Os.prototype.InterpolantFactoryMethodLinear=void 0;Os.prototype.InterpolantFactoryMethodSmooth=void 0;var El=class extends ci{constructor(e,t,n,s){super(e,t,n,s)}};El.prototype.ValueTypeName="color";var Tl=class extends ci{constructor(e,t,n,s){super(e,t,n,s)}};Tl.prototype.ValueTypeName="number";var Al=class extends Fs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(n-t)/(s-t),c=e*o;for(let h=c+o;c!==h;c+=4)Gi.slerpFlat(r,0,a,c-o,a,c,l);return r}},Va=class extends ci{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Al(this.times,this.values,this.getValueSize(),e)}};Va.prototype.ValueTypeName="quaternion";Va.prototype.InterpolantFactoryMethodSmooth=void 0;var Bs=class extends ci{constructor(e,t,n){super(e,t,n)}};Bs.prototype.ValueTypeName="string";Bs.prototype.ValueBufferType=Array;Bs.prototype.DefaultInterpolation=Ea;Bs.prototype.InterpolantFactoryMethodLinear=void 0;Bs.prototype.InterpolantFactoryMethodSmooth=void 0;var Cl=class extends ci{constructor(e,t,n,s){super(e,t,n,s)}};Cl.prototype.ValueTypeName="vector";var Rl=class{constructor(e,t,n){let s=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){o++,r===!1&&s.onStart!==void 0&&s.onStart(h,a,o),r=!0},this.itemEnd=function(h){a++,s.onProgress!==void 0&&s.onProgress(h,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let f=c[d],g=c[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},hm=new Rl,Pl=class{constructor(e){this.manager=e!==void 0?e:hm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Pl.DEFAULT_MATERIAL_NAME="__DEFAULT";var Yo=new j,$o=new Gi,ki=new j,Ga=class extends li{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new rn,this.projectionMatrix=new rn,this.projectionMatrixInverse=new rn,this.coordinateSystem=xi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Yo,$o,ki),ki.x===1&&ki.y===1&&ki.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Yo,$o,ki.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Yo,$o,ki),ki.x===1&&ki.y===1&&ki.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Yo,$o,ki.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Is=new j,Mp=new wt,Sp=new wt,ai=class extends Ga{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=ol*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(bh*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return ol*2*Math.atan(Math.tan(bh*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Is.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Is.x,Is.y).multiplyScalar(-e/Is.z),Is.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Is.x,Is.y).multiplyScalar(-e/Is.z)}getViewSize(e,t){return this.getViewBounds(e,Mp,Sp),t.subVectors(Sp,Mp)}setViewOffset(e,t,n,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(bh*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*n/c,s*=a.width/l,n*=a.height/c}let o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Jr=class extends Ga{constructor(e=-1,t=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,a=n+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=h*this.view.offsetY,l=o-h*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Ha=class extends Hi{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Gr=-90,Hr=1,Kr=class extends li{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ai(Gr,Hr,e,t);s.layers=this.layers,this.add(s);let r=new ai(Gr,Hr,e,t);r.layers=this.layers,this.add(r);let a=new ai(Gr,Hr,e,t);a.layers=this.layers,this.add(a);let o=new ai(Gr,Hr,e,t);o.layers=this.layers,this.add(o);let l=new ai(Gr,Hr,e,t);l.layers=this.layers,this.add(l);let c=new ai(Gr,Hr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,a,o,l]=t;for(let c of t)this.remove(c);if(e===xi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ca)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,h]=this.children,d=e.getRenderTarget(),u=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,u,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Il=class extends ai{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Tu="\\[\\]\\.:\\/",sx=new RegExp("["+Tu+"]","g"),Au="[^"+Tu+"]",rx="[^"+Tu.replace("\\.","")+"]",ax=/((?:WC+[\/:])*)/.source.replace("WC",Au),ox=/(WCOD+)?/.source.replace("WCOD",rx),lx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Au),cx=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Au),hx=new RegExp("^"+ax+ox+lx+cx+"$"),ux=["material","materials","bones","map"],Zh=class{constructor(e,t,n){let s=n||jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},jt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(sx,"")}static parseTrackName(e){let t=hx.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);ux.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===t||o.uuid===t)return o;let l=n(o.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){nt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){ot("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){ot("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){ot("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){ot("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){ot("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){ot("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){ot("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let a=e[s];if(a===void 0){let c=t.nodeName;ot("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let o=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?o=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){ot("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){ot("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};jt.Composite=Zh;jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};jt.prototype.GetterByBindingType=[jt.prototype._getValue_direct,jt.prototype._getValue_array,jt.prototype._getValue_arrayElement,jt.prototype._getValue_toArray];jt.prototype.SetterByBindingTypeAndVersioning=[[jt.prototype._setValue_direct,jt.prototype._setValue_direct_setNeedsUpdate,jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_array,jt.prototype._setValue_array_setNeedsUpdate,jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_arrayElement,jt.prototype._setValue_arrayElement_setNeedsUpdate,jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_fromArray,jt.prototype._setValue_fromArray_setNeedsUpdate,jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Lb=new Float32Array(1);var Jh=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};function Cu(i,e,t,n){let s=dx(n);switch(t){case gu:return i*e;case xu:return i*e/s.components*s.byteLength;case Bl:return i*e/s.components*s.byteLength;case zs:return i*e*2/s.components*s.byteLength;case kl:return i*e*2/s.components*s.byteLength;case _u:return i*e*3/s.components*s.byteLength;case Li:return i*e*4/s.components*s.byteLength;case zl:return i*e*4/s.components*s.byteLength;case qa:case Ya:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case $a:case Za:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Gl:case Wl:return Math.max(i,16)*Math.max(e,8)/4;case Vl:case Hl:return Math.max(i,8)*Math.max(e,8)/2;case Xl:case ql:case $l:case Zl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Yl:case Ja:case Jl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Kl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case jl:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Ql:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case ec:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case tc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case nc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case ic:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case sc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case rc:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case ac:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case oc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case lc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case cc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case hc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case uc:case dc:case fc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case pc:case mc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Ka:case gc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function dx(i){switch(i){case hi:case du:return{byteLength:1,components:1};case ta:case fu:case Ii:return{byteLength:2,components:1};case Fl:case Ol:return{byteLength:2,components:4};case Ri:case Ul:case Pi:return{byteLength:4,components:1};case pu:case mu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?nt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Lm(){let i=null,e=!1,t=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function px(i){let e=new WeakMap;function t(o,l){let c=o.array,h=o.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),o.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:d}}function n(o,l,c){let h=l.array,d=l.updateRanges;if(i.bindBuffer(c,o),d.length===0)i.bufferSubData(c,0,h);else{d.sort((f,g)=>f.start-g.start);let u=0;for(let f=1;f<d.length;f++){let g=d[u],y=d[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++u,d[u]=y)}d.length=u+1;for(let f=0,g=d.length;f<g;f++){let y=d[f];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=e.get(o);l&&(i.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let h=e.get(o);(!h||h.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var mx=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,gx=`#ifdef USE_ALPHAHASH
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
#endif`,_x=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,xx=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,vx=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,yx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Mx=`#ifdef USE_AOMAP
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
#endif`,Sx=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,bx=`#ifdef USE_BATCHING
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
#endif`,wx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Ex=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Tx=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Ax=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Cx=`#ifdef USE_IRIDESCENCE
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
#endif`,Rx=`#ifdef USE_BUMPMAP
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
#endif`,Px=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Ix=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Lx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Nx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Dx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Ux=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Fx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Ox=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Bx=`#define PI 3.141592653589793
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
} // validated`,kx=`vec3 transformedNormal = objectNormal;
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
#endif`,zx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Vx=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Gx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Hx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Wx="gl_FragColor = linearToOutputTexel( gl_FragColor );",Xx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,qx=`#ifdef USE_ENVMAP
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
#endif`,Yx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,$x=`#ifdef USE_ENVMAP
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
#endif`,Zx=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Jx=`#ifdef USE_ENVMAP
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
#endif`,Kx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,jx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Qx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ev=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,tv=`#ifdef USE_GRADIENTMAP
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
}`,nv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,iv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,sv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,rv=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,av=`#ifdef USE_ENVMAP
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
#endif`,ov=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,lv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,cv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,hv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,uv=`PhysicalMaterial material;
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
#endif`,dv=`uniform sampler2D dfgLUT;
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
}`,fv=`
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
#endif`,pv=`#if defined( RE_IndirectDiffuse )
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
#endif`,mv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,gv=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,_v=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,xv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,yv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Mv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Sv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,bv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,wv=`#if defined( USE_POINTS_UV )
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
#endif`,Ev=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Tv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Av=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Cv=`#if defined( USE_MORPHCOLORS )
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
#endif`,Rv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Pv=`#ifdef USE_MORPHTARGETS
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
#endif`,Iv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Lv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Nv=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Dv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Uv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Fv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Ov=`#ifdef USE_NORMALMAP
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
#endif`,Bv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,kv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,zv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Vv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Gv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Hv=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Wv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Xv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,qv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Yv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,$v=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Zv=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Jv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Kv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,jv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Qv=`float getShadowMask() {
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
}`,ey=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,ty=`#ifdef USE_SKINNING
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
#endif`,ny=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,iy=`#ifdef USE_SKINNING
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
#endif`,sy=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ry=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ay=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,oy=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,ly=`#ifdef USE_TRANSMISSION
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
#endif`,cy=`#ifdef USE_TRANSMISSION
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
#endif`,hy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,uy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,dy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,fy=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,py=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,my=`uniform sampler2D t2D;
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
}`,gy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,_y=`uniform float backgroundBlurriness;
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
}`,xy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vy=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yy=`#include <common>
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
}`,My=`#if DEPTH_PACKING == 3200
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
}`,Sy=`#define DISTANCE
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
}`,by=`#define DISTANCE
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
}`,wy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ey=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ty=`uniform float scale;
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
}`,Ay=`uniform vec3 diffuse;
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
}`,Cy=`#include <common>
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
}`,Ry=`uniform vec3 diffuse;
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
}`,Py=`#define LAMBERT
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
}`,Iy=`#define LAMBERT
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
}`,Ly=`#define MATCAP
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
}`,Ny=`#define MATCAP
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
}`,Dy=`#define NORMAL
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
}`,Uy=`#define NORMAL
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
}`,Fy=`#define PHONG
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
}`,Oy=`#define PHONG
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
}`,By=`#define STANDARD
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
}`,ky=`#define STANDARD
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
}`,zy=`#define TOON
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
}`,Vy=`#define TOON
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
}`,Gy=`uniform float size;
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
}`,Hy=`uniform vec3 diffuse;
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
}`,Wy=`#include <common>
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
}`,Xy=`uniform vec3 color;
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
}`,qy=`uniform float rotation;
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
}`,Yy=`uniform vec3 diffuse;
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
}`,gt={alphahash_fragment:mx,alphahash_pars_fragment:gx,alphamap_fragment:_x,alphamap_pars_fragment:xx,alphatest_fragment:vx,alphatest_pars_fragment:yx,aomap_fragment:Mx,aomap_pars_fragment:Sx,batching_pars_vertex:bx,batching_vertex:wx,begin_vertex:Ex,beginnormal_vertex:Tx,bsdfs:Ax,iridescence_fragment:Cx,bumpmap_pars_fragment:Rx,clipping_planes_fragment:Px,clipping_planes_pars_fragment:Ix,clipping_planes_pars_vertex:Lx,clipping_planes_vertex:Nx,color_fragment:Dx,color_pars_fragment:Ux,color_pars_vertex:Fx,color_vertex:Ox,common:Bx,defaultnormal_vertex:kx,displacementmap_pars_vertex:zx,displacementmap_vertex:Vx,emissivemap_fragment:Gx,emissivemap_pars_fragment:Hx,colorspace_fragment:Wx,colorspace_pars_fragment:Xx,envmap_fragment:qx,envmap_common_pars_fragment:Yx,envmap_pars_fragment:$x,envmap_pars_vertex:Zx,envmap_physical_pars_fragment:av,envmap_vertex:Jx,fog_vertex:Kx,fog_pars_vertex:jx,fog_fragment:Qx,fog_pars_fragment:ev,gradientmap_pars_fragment:tv,lightmap_pars_fragment:nv,lights_lambert_fragment:iv,lights_lambert_pars_fragment:sv,lights_pars_begin:rv,lights_toon_fragment:ov,lights_toon_pars_fragment:lv,lights_phong_fragment:cv,lights_phong_pars_fragment:hv,lights_physical_fragment:uv,lights_physical_pars_fragment:dv,lights_fragment_begin:fv,lights_fragment_maps:pv,lights_fragment_end:mv,lightprobes_pars_fragment:gv,logdepthbuf_fragment:_v,logdepthbuf_pars_fragment:xv,logdepthbuf_pars_vertex:vv,logdepthbuf_vertex:yv,map_fragment:Mv,map_pars_fragment:Sv,map_particle_fragment:bv,map_particle_pars_fragment:wv,metalnessmap_fragment:Ev,metalnessmap_pars_fragment:Tv,morphinstance_vertex:Av,morphcolor_vertex:Cv,morphnormal_vertex:Rv,morphtarget_pars_vertex:Pv,morphtarget_vertex:Iv,normal_fragment_begin:Lv,normal_fragment_maps:Nv,normal_pars_fragment:Dv,normal_pars_vertex:Uv,normal_vertex:Fv,normalmap_pars_fragment:Ov,clearcoat_normal_fragment_begin:Bv,clearcoat_normal_fragment_maps:kv,clearcoat_pars_fragment:zv,iridescence_pars_fragment:Vv,opaque_fragment:Gv,packing:Hv,premultiplied_alpha_fragment:Wv,project_vertex:Xv,dithering_fragment:qv,dithering_pars_fragment:Yv,roughnessmap_fragment:$v,roughnessmap_pars_fragment:Zv,shadowmap_pars_fragment:Jv,shadowmap_pars_vertex:Kv,shadowmap_vertex:jv,shadowmask_pars_fragment:Qv,skinbase_vertex:ey,skinning_pars_vertex:ty,skinning_vertex:ny,skinnormal_vertex:iy,specularmap_fragment:sy,specularmap_pars_fragment:ry,tonemapping_fragment:ay,tonemapping_pars_fragment:oy,transmission_fragment:ly,transmission_pars_fragment:cy,uv_pars_fragment:hy,uv_pars_vertex:uy,uv_vertex:dy,worldpos_vertex:fy,background_vert:py,background_frag:my,backgroundCube_vert:gy,backgroundCube_frag:_y,cube_vert:xy,cube_frag:vy,depth_vert:yy,depth_frag:My,distance_vert:Sy,distance_frag:by,equirect_vert:wy,equirect_frag:Ey,linedashed_vert:Ty,linedashed_frag:Ay,meshbasic_vert:Cy,meshbasic_frag:Ry,meshlambert_vert:Py,meshlambert_frag:Iy,meshmatcap_vert:Ly,meshmatcap_frag:Ny,meshnormal_vert:Dy,meshnormal_frag:Uy,meshphong_vert:Fy,meshphong_frag:Oy,meshphysical_vert:By,meshphysical_frag:ky,meshtoon_vert:zy,meshtoon_frag:Vy,points_vert:Gy,points_frag:Hy,shadow_vert:Wy,shadow_frag:Xy,sprite_vert:qy,sprite_frag:Yy},Ue={common:{diffuse:{value:new Et(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new lt},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new lt}},envmap:{envMap:{value:null},envMapRotation:{value:new lt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new lt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new lt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new lt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new lt},normalScale:{value:new wt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new lt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new lt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new lt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new lt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Et(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Et(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0},uvTransform:{value:new lt}},sprite:{diffuse:{value:new Et(16777215)},opacity:{value:1},center:{value:new wt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new lt},alphaMap:{value:null},alphaMapTransform:{value:new lt},alphaTest:{value:0}}},$i={basic:{uniforms:Dn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.fog]),vertexShader:gt.meshbasic_vert,fragmentShader:gt.meshbasic_frag},lambert:{uniforms:Dn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new Et(0)},envMapIntensity:{value:1}}]),vertexShader:gt.meshlambert_vert,fragmentShader:gt.meshlambert_frag},phong:{uniforms:Dn([Ue.common,Ue.specularmap,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,Ue.lights,{emissive:{value:new Et(0)},specular:{value:new Et(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:gt.meshphong_vert,fragmentShader:gt.meshphong_frag},standard:{uniforms:Dn([Ue.common,Ue.envmap,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.roughnessmap,Ue.metalnessmap,Ue.fog,Ue.lights,{emissive:{value:new Et(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag},toon:{uniforms:Dn([Ue.common,Ue.aomap,Ue.lightmap,Ue.emissivemap,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.gradientmap,Ue.fog,Ue.lights,{emissive:{value:new Et(0)}}]),vertexShader:gt.meshtoon_vert,fragmentShader:gt.meshtoon_frag},matcap:{uniforms:Dn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,Ue.fog,{matcap:{value:null}}]),vertexShader:gt.meshmatcap_vert,fragmentShader:gt.meshmatcap_frag},points:{uniforms:Dn([Ue.points,Ue.fog]),vertexShader:gt.points_vert,fragmentShader:gt.points_frag},dashed:{uniforms:Dn([Ue.common,Ue.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:gt.linedashed_vert,fragmentShader:gt.linedashed_frag},depth:{uniforms:Dn([Ue.common,Ue.displacementmap]),vertexShader:gt.depth_vert,fragmentShader:gt.depth_frag},normal:{uniforms:Dn([Ue.common,Ue.bumpmap,Ue.normalmap,Ue.displacementmap,{opacity:{value:1}}]),vertexShader:gt.meshnormal_vert,fragmentShader:gt.meshnormal_frag},sprite:{uniforms:Dn([Ue.sprite,Ue.fog]),vertexShader:gt.sprite_vert,fragmentShader:gt.sprite_frag},background:{uniforms:{uvTransform:{value:new lt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:gt.background_vert,fragmentShader:gt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new lt}},vertexShader:gt.backgroundCube_vert,fragmentShader:gt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:gt.cube_vert,fragmentShader:gt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:gt.equirect_vert,fragmentShader:gt.equirect_frag},distance:{uniforms:Dn([Ue.common,Ue.displacementmap,{referencePosition:{value:new j},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:gt.distance_vert,fragmentShader:gt.distance_frag},shadow:{uniforms:Dn([Ue.lights,Ue.fog,{color:{value:new Et(0)},opacity:{value:1}}]),vertexShader:gt.shadow_vert,fragmentShader:gt.shadow_frag}};$i.physical={uniforms:Dn([$i.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new lt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new lt},clearcoatNormalScale:{value:new wt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new lt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new lt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new lt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new lt},sheen:{value:0},sheenColor:{value:new Et(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new lt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new lt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new lt},transmissionSamplerSize:{value:new wt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new lt},attenuationDistance:{value:0},attenuationColor:{value:new Et(0)},specularColor:{value:new Et(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new lt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new lt},anisotropyVector:{value:new wt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new lt}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag};var _c={r:0,b:0,g:0},$y=new rn,Nm=new lt;Nm.set(-1,0,0,0,1,0,0,0,1);function Zy(i,e,t,n,s,r){let a=new Et(0),o=s===!0?0:1,l,c,h=null,d=0,u=null;function f(v){let T=v.isScene===!0?v.background:null;if(T&&T.isTexture){let b=v.backgroundBlurriness>0;T=e.get(T,b)}return T}function g(v){let T=!1,b=f(v);b===null?m(a,o):b&&b.isColor&&(m(b,1),T=!0);let P=i.xr.getEnvironmentBlendMode();P==="additive"?t.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,T){let b=f(T);b&&b.isCubeTexture?(c===void 0&&(c=new Wi(new Zr(1,1,1),new vi({name:"BackgroundCubeMaterial",uniforms:lr($i.backgroundCube.uniforms),vertexShader:$i.backgroundCube.vertexShader,fragmentShader:$i.backgroundCube.fragmentShader,side:Hn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,C,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4($y.makeRotationFromEuler(T.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Nm),c.material.toneMapped=St.getTransfer(b.colorSpace)!==Ut,(h!==b||d!==b.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,d=b.version,u=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Wi(new za(2,2),new vi({name:"BackgroundMaterial",uniforms:lr($i.background.uniforms),vertexShader:$i.background.vertexShader,fragmentShader:$i.background.fragmentShader,side:ks,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=St.getTransfer(b.colorSpace)!==Ut,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||d!==b.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,d=b.version,u=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,T){v.getRGB(_c,Eu(i)),t.buffers.color.setClear(_c.r,_c.g,_c.b,T,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(v,T=1){a.set(v),o=T,m(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(v){o=v,m(a,o)},render:g,addToRenderList:y,dispose:p}}function Jy(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,a=!1;function o(D,W,X,I,V){let Z=!1,B=d(D,I,X,W);r!==B&&(r=B,c(r.object)),Z=f(D,I,X,V),Z&&g(D,I,X,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(Z||a)&&(a=!1,b(D,W,X,I),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function d(D,W,X,I){let V=I.wireframe===!0,Z=n[W.id];Z===void 0&&(Z={},n[W.id]=Z);let B=D.isInstancedMesh===!0?D.id:0,ue=Z[B];ue===void 0&&(ue={},Z[B]=ue);let J=ue[X.id];J===void 0&&(J={},ue[X.id]=J);let Q=J[V];return Q===void 0&&(Q=u(l()),J[V]=Q),Q}function u(D){let W=[],X=[],I=[];for(let V=0;V<t;V++)W[V]=0,X[V]=0,I[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:W,enabledAttributes:X,attributeDivisors:I,object:D,attributes:{},index:null}}function f(D,W,X,I){let V=r.attributes,Z=W.attributes,B=0,ue=X.getAttributes();for(let J in ue)if(ue[J].location>=0){let se=V[J],oe=Z[J];if(oe===void 0&&(J==="instanceMatrix"&&D.instanceMatrix&&(oe=D.instanceMatrix),J==="instanceColor"&&D.instanceColor&&(oe=D.instanceColor)),se===void 0||se.attribute!==oe||oe&&se.data!==oe.data)return!0;B++}return r.attributesNum!==B||r.index!==I}function g(D,W,X,I){let V={},Z=W.attributes,B=0,ue=X.getAttributes();for(let J in ue)if(ue[J].location>=0){let se=Z[J];se===void 0&&(J==="instanceMatrix"&&D.instanceMatrix&&(se=D.instanceMatrix),J==="instanceColor"&&D.instanceColor&&(se=D.instanceColor));let oe={};oe.attribute=se,se&&se.data&&(oe.data=se.data),V[J]=oe,B++}r.attributes=V,r.attributesNum=B,r.index=I}function y(){let D=r.newAttributes;for(let W=0,X=D.length;W<X;W++)D[W]=0}function m(D){p(D,0)}function p(D,W){let X=r.newAttributes,I=r.enabledAttributes,V=r.attributeDivisors;X[D]=1,I[D]===0&&(i.enableVertexAttribArray(D),I[D]=1),V[D]!==W&&(i.vertexAttribDivisor(D,W),V[D]=W)}function v(){let D=r.newAttributes,W=r.enabledAttributes;for(let X=0,I=W.length;X<I;X++)W[X]!==D[X]&&(i.disableVertexAttribArray(X),W[X]=0)}function T(D,W,X,I,V,Z,B){B===!0?i.vertexAttribIPointer(D,W,X,V,Z):i.vertexAttribPointer(D,W,X,I,V,Z)}function b(D,W,X,I){y();let V=I.attributes,Z=X.getAttributes(),B=W.defaultAttributeValues;for(let ue in Z){let J=Z[ue];if(J.location>=0){let Q=V[ue];if(Q===void 0&&(ue==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),ue==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let se=Q.normalized,oe=Q.itemSize,fe=e.get(Q);if(fe===void 0)continue;let ee=fe.buffer,xe=fe.type,ve=fe.bytesPerElement,Te=xe===i.INT||xe===i.UNSIGNED_INT||Q.gpuType===Ul;if(Q.isInterleavedBufferAttribute){let we=Q.data,$e=we.isInterleavedBuffer===!0?we.stride:we.itemSize,it=Q.offset;if(we.isInstancedInterleavedBuffer||we.isInstancedBufferAttribute){for(let Xe=0;Xe<J.locationSize;Xe++)p(J.location+Xe,we.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=we.meshPerAttribute*we.count)}else for(let Xe=0;Xe<J.locationSize;Xe++)m(J.location+Xe);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let Xe=0;Xe<J.locationSize;Xe++)T(J.location+Xe,oe/J.locationSize,xe,se,$e*ve,(it+oe/J.locationSize*Xe)*ve,Te)}else{if(Q.isInstancedBufferAttribute){for(let we=0;we<J.locationSize;we++)p(J.location+we,Q.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let we=0;we<J.locationSize;we++)m(J.location+we);i.bindBuffer(i.ARRAY_BUFFER,ee);for(let we=0;we<J.locationSize;we++)T(J.location+we,oe/J.locationSize,xe,se,oe*ve,oe/J.locationSize*we*ve,Te)}}else if(B!==void 0){let se=B[ue];if(se!==void 0)switch(se.length){case 2:i.vertexAttrib2fv(J.location,se);break;case 3:i.vertexAttrib3fv(J.location,se);break;case 4:i.vertexAttrib4fv(J.location,se);break;default:i.vertexAttrib1fv(J.location,se)}}}}v()}function P(){z();for(let D in n){let W=n[D];for(let X in W){let I=W[X];for(let V in I){let Z=I[V];for(let B in Z)h(Z[B].object),delete Z[B];delete I[V]}}delete n[D]}}function C(D){if(n[D.id]===void 0)return;let W=n[D.id];for(let X in W){let I=W[X];for(let V in I){let Z=I[V];for(let B in Z)h(Z[B].object),delete Z[B];delete I[V]}}delete n[D.id]}function x(D){for(let W in n){let X=n[W];for(let I in X){let V=X[I];if(V[D.id]===void 0)continue;let Z=V[D.id];for(let B in Z)h(Z[B].object),delete Z[B];delete V[D.id]}}}function A(D){for(let W in n){let X=n[W],I=D.isInstancedMesh===!0?D.id:0,V=X[I];if(V!==void 0){for(let Z in V){let B=V[Z];for(let ue in B)h(B[ue].object),delete B[ue];delete V[Z]}delete X[I],Object.keys(X).length===0&&delete n[W]}}}function z(){U(),a=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:z,resetDefaultState:U,dispose:P,releaseStatesOfGeometry:C,releaseStatesOfObject:A,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:m,disableUnusedAttributes:v}}function Ky(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function a(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function o(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let f=0;f<h;f++)u+=c[f];t.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function jy(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(x){return!(x!==Li&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(x){let A=x===Ii&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==hi&&x!==Pi&&!A&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(nt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),u=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&nt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&nt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=i.getParameter(i.MAX_SAMPLES),C=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:v,maxVaryings:T,maxFragmentUniforms:b,maxSamples:P,samples:C}}function Qy(i){let e=this,t=null,n=0,s=!1,r=!1,a=new Ci,o=new lt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||n!==0||s;return s=u,n=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){t=h(d,u,0)},this.setState=function(d,u,f){let g=d.clippingPlanes,y=d.clipIntersection,m=d.clipShadows,p=i.get(d);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let v=r?0:n,T=v*4,b=p.clippingState||null;l.value=b,b=h(g,u,T,f);for(let P=0;P!==T;++P)b[P]=t[P];p.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(d,u,f,g){let y=d!==null?d.length:0,m=null;if(y!==0){if(m=l.value,g!==!0||m===null){let p=f+y*4,v=u.matrixWorldInverse;o.getNormalMatrix(v),(m===null||m.length<p)&&(m=new Float32Array(p));for(let T=0,b=f;T!==y;++T,b+=4)a.copy(d[T]).applyMatrix4(v,o),a.normal.toArray(m,b),m[b+3]=a.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,m}}var no=class extends oi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Oa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Zr(5,5,5),r=new vi({name:"CubemapFromEquirect",uniforms:lr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Hn,blending:sr});r.uniforms.tEquirect.value=t;let a=new Wi(s,r),o=t.minFilter;return t.minFilter===ds&&(t.minFilter=Gn),new Kr(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,n,s);e.setRenderTarget(r)}},um=256,eM=3,tM=20,Dm=256,Um=16,nM=3,iM=new j,sM=new Et,vc=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Kr(1,10,null),this._boxMesh=new Wi(new Zr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:a=256,position:o=iM}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(sM));let m=new Kr(n,s,h);return m.position.copy(o),m.update(l,e),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=g,e.background=y,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=pm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=fm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(um,am(e))}_fromTexture(e,t){e.mapping===ar||e.mapping===ea?this._setSize(e.image.length===0?um:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=dm(e,!1,!1),n=Math.log2(e)-eM;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=dm(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===ar||e.mapping===ea?(this._cubemapMaterial===null&&(this._cubemapMaterial=pm()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=fm()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=rM(),this._integrationMaterial=aM());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Um);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-nM)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{let l=o>0?Math.log2(t)+.5*Math.log2(6/(Dm*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=oM());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function dm(i,e,t){return new no(i,{minFilter:ds,generateMipmaps:e,type:Ii,colorSpace:Ta,depthBuffer:t})}function io(i,e,t){return new vi({name:i,uniforms:e,vertexShader:gt.cube_vert,fragmentShader:t,side:Hn,blending:sr,depthTest:!1,depthWrite:!1})}function rM(){return io("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Dm}u

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
	`)}function aM(){return io("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Um}},`

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
	`)}function oM(){return io("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${tM}
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
	`)}function fm(){return io("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function pm(){return io("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function lM(i){let e=new WeakMap,t=new WeakMap,n=null;function s(u,f=!1){return u==null?null:f?a(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===Ll||f===Nl)if(e.has(u)){let g=e.get(u).texture;return o(g,u.mapping)}else{let g=u.image;if(g&&g.height>0){let y=new no(g.height);return y.fromEquirectangularTexture(i,u),e.set(u,y),u.addEventListener("dispose",c),o(y.texture,u.mapping)}else return null}}return u}function a(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,g=f===Ll||f===Nl,y=f===ar||f===ea;if(g||y){let m=t.get(u),p=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==p)return n===null&&(n=new vc(i)),m=g?n.fromEquirectangular(u,m):n.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),m.texture;if(m!==void 0)return m.texture;{let v=u.image;return g&&v&&v.height>0||y&&v&&l(v)?(n===null&&(n=new vc(i)),m=g?n.fromEquirectangular(u):n.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,t.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function o(u,f){return f===Ll?u.mapping=ar:f===Nl&&(u.mapping=ea),u}function l(u){let f=0,g=6;for(let y=0;y<g;y++)u[y]!==void 0&&f++;return f===g}function c(u){let f=u.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function h(u){let f=u.target;f.removeEventListener("dispose",h);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function cM(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&wa("WebGLRenderer: "+n+" extension not supported."),s}}}function hM(i,e,t,n){let s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",o),s[y.id]=new WeakRef(y),a.register(y,y.id,y),t.memory.geometries++),y}function h(g){let y=g.attributes;for(let m in y)e.update(y[m],i.ARRAY_BUFFER)}function d(g){let y=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let v=y!==null?y.array.length:m.array.length/3-1,T=m.count>=65535?Da:Na,b=new T(Math.ceil(v/3)*6,1),P=b.array;if(y!==null){let x=y.array;p=y.version;for(let A=0,z=0;A<v;A+=3){let U=x[A+0],D=x[A+1],W=x[A+2];P[z++]=U,P[z++]=D,P[z++]=D,P[z++]=W,P[z++]=W,P[z++]=U}}else{p=m.version;for(let x=0,A=0;x<v;x+=3){let z=x+0,U=x+1,D=x+2;P[A++]=z,P[A++]=U,P[A++]=U,P[A++]=D,P[A++]=D,P[A++]=z}}b.version=p;let C=r.get(g);C&&e.remove(C),r.set(g,b)}function u(g){let y=r.get(g);if(y){let m=g.index;m!==null&&y.version<m.version&&d(g)}else d(g);return r.get(g)}function f(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:u,dispose:f}}function uM(i,e,t){let n;function s(d){n=d}let r,a;function o(d){r=d.type,a=d.bytesPerElement}function l(d,u){i.drawElements(n,u,r,d*a),t.update(u,n,1)}function c(d,u,f){f!==0&&(i.drawElementsInstanced(n,u,r,d*a,f),t.update(u,n,f))}function h(d,u,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,f);let y=0;for(let m=0;m<f;m++)y+=u[m];t.update(y,n,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function dM(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(t.calls++,a){case i.TRIANGLES:t.triangles+=o*(r/3);break;case i.LINES:t.lines+=o*(r/2);break;case i.LINE_STRIP:t.lines+=o*(r-1);break;case i.LINE_LOOP:t.lines+=o*r;break;case i.POINTS:t.points+=o*r;break;default:ot("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function fM(i,e,t){let n=new WeakMap,s=new Qt;function r(a,o,l){let c=a.morphTargetInfluences,h=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(o);if(u===void 0||u.count!==d){let z=function(){x.dispose(),n.delete(o),o.removeEventListener("dispose",z)};u!==void 0&&u.texture.dispose();let f=o.morphAttributes.position!==void 0,g=o.morphAttributes.normal!==void 0,y=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],p=o.morphAttributes.normal||[],v=o.morphAttributes.color||[],T=0;f===!0&&(T=1),g===!0&&(T=2),y===!0&&(T=3);let b=o.attributes.position.count*T,P=1;b>e.maxTextureSize&&(P=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let C=new Float32Array(b*P*4*d),x=new Pa(C,b,P,d);x.type=Pi,x.needsUpdate=!0;let A=T*4;for(let U=0;U<d;U++){let D=m[U],W=p[U],X=v[U],I=b*P*4*U;for(let V=0;V<D.count;V++){let Z=V*A;f===!0&&(s.fromBufferAttribute(D,V),C[I+Z+0]=s.x,C[I+Z+1]=s.y,C[I+Z+2]=s.z,C[I+Z+3]=0),g===!0&&(s.fromBufferAttribute(W,V),C[I+Z+4]=s.x,C[I+Z+5]=s.y,C[I+Z+6]=s.z,C[I+Z+7]=0),y===!0&&(s.fromBufferAttribute(X,V),C[I+Z+8]=s.x,C[I+Z+9]=s.y,C[I+Z+10]=s.z,C[I+Z+11]=X.itemSize===4?s.w:1)}}u={count:d,texture:x,size:new wt(b,P)},n.set(o,u),o.addEventListener("dispose",z)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,t);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let g=o.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function pM(i,e,t,n,s){let r=new WeakMap;function a(c){let h=s.render.frame,d=c.geometry,u=e.get(c,d);if(r.get(u)!==h&&(e.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return u}function o(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:a,dispose:o}}var mM={[su]:"LINEAR_TONE_MAPPING",[ru]:"REINHARD_TONE_MAPPING",[au]:"CINEON_TONE_MAPPING",[ou]:"ACES_FILMIC_TONE_MAPPING",[cu]:"AGX_TONE_MAPPING",[hu]:"NEUTRAL_TONE_MAPPING",[lu]:"CUSTOM_TONE_MAPPING"};function gM(i,e,t,n,s,r){let a=new oi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,h=new Hi;h.setAttribute("position",new Yn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Yn([0,2,0,0,2,0],2));let d=new xl({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new Wi(h,d),f=new Jr(-1,1,1,-1,0,1),g=null,y=null,m=!1,p,v=null,T=[],b=!1;this.setSize=function(P,C){a.setSize(P,C),o!==null&&o.setSize(P,C),l!==null&&l.setSize(P,C);for(let x=0;x<T.length;x++){let A=T[x];A.setSize&&A.setSize(P,C)}},this.setEffects=function(P){T=P,b=T.length>0&&T[0].isRenderPass===!0;let C=a.width,x=a.height;T.length>0&&o===null&&(o=new oi(C,x,{type:Ii,depthBuffer:!1,stencilBuffer:!1}),l=new oi(C,x,{type:Ii,depthBuffer:!1,stencilBuffer:!1}));let A=s===!0&&T.some(z=>z.needsDepthTexture===!0);A!==(a.depthTexture!==null)&&(A===!0&&c===null&&(c=new us(C,x),r===!0&&(c.format=fs,c.type=or)),a.dispose(),a.depthTexture=A?c:null,a.resolveDepthBuffer=A,a.storeMultisampledDepthBuffer=A);for(let z=0;z<T.length;z++){let U=T[z];U.setSize&&U.setSize(C,x),A&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(P,C){if(m||P.toneMapping===qi&&T.length===0)return!1;if(v=C,C!==null){let x=C.width,A=C.height;(a.width!==x||a.height!==A)&&this.setSize(x,A)}return b===!1&&P.setRenderTarget(a),p=P.toneMapping,P.toneMapping=qi,!0},this.hasRenderPass=function(){return b},this.end=function(P,C){P.toneMapping=p,m=!0;let x=a,A=o;for(let z=0;z<T.length;z++){let U=T[z];U.enabled!==!1&&(U.render(P,A,x,C),U.needsSwap!==!1&&(x=A,A=A===o?l:o))}if(g!==P.outputColorSpace||y!==P.toneMapping){g=P.outputColorSpace,y=P.toneMapping,d.defines={},St.getTransfer(g)===Ut&&(d.defines.SRGB_TRANSFER="");let z=mM[y];z&&(d.defines[z]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=x.texture,P.setRenderTarget(v),P.render(u,f),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var Fm=new $n,Om=new us(1,1),Bm=new Ba(1),km=new Pa,zm=new hl,Vm=new Oa,mm=[],gm=[],_m=new Float32Array(16),xm=new Float32Array(9),vm=new Float32Array(4);function ia(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=mm[s];if(r===void 0&&(r=new Float32Array(s),mm[s]=r),e!==0){n.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,i[a].toArray(r,o)}return r}function Mn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Sn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Mc(i,e){let t=gm[e];t===void 0&&(t=new Int32Array(e),gm[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function _M(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function xM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;i.uniform2fv(this.addr,e),Sn(t,e)}}function vM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Mn(t,e))return;i.uniform3fv(this.addr,e),Sn(t,e)}}function yM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;i.uniform4fv(this.addr,e),Sn(t,e)}}function MM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Mn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Sn(t,e)}else{if(Mn(t,n))return;vm.set(n),i.uniformMatrix2fv(this.addr,!1,vm),Sn(t,n)}}function SM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Mn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Sn(t,e)}else{if(Mn(t,n))return;xm.set(n),i.uniformMatrix3fv(this.addr,!1,xm),Sn(t,n)}}function bM(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Mn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Sn(t,e)}else{if(Mn(t,n))return;_m.set(n),i.uniformMatrix4fv(this.addr,!1,_m),Sn(t,n)}}function wM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function EM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;i.uniform2iv(this.addr,e),Sn(t,e)}}function TM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mn(t,e))return;i.uniform3iv(this.addr,e),Sn(t,e)}}function AM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;i.uniform4iv(this.addr,e),Sn(t,e)}}function CM(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function RM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;i.uniform2uiv(this.addr,e),Sn(t,e)}}function PM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mn(t,e))return;i.uniform3uiv(this.addr,e),Sn(t,e)}}function IM(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;i.uniform4uiv(this.addr,e),Sn(t,e)}}function Sc(i){return i.version===0&&(i.compareFunction=Su,i.needsUpdate=!0),i}function LM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Sc(Om):r=Fm,t.setTexture2D(e||r,s)}function NM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||zm,s)}function DM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Sc(Bm):r=Vm,t.setTextureCube(e||r,s)}function UM(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||km,s)}function FM(i){switch(i){case 5126:return _M;case 35664:return xM;case 35665:return vM;case 35666:return yM;case 35674:return MM;case 35675:return SM;case 35676:return bM;case 5124:case 35670:return wM;case 35667:case 35671:return EM;case 35668:case 35672:return TM;case 35669:case 35673:return AM;case 5125:return CM;case 36294:return RM;case 36295:return PM;case 36296:return IM;case 35678:case 36198:case 36298:case 36306:case 35682:return LM;case 35679:case 36299:case 36307:return NM;case 35680:case 36300:case 36308:case 36293:return DM;case 36289:case 36303:case 36311:case 36292:return UM}}function OM(i,e){i.uniform1fv(this.addr,e)}function BM(i,e){let t=ia(e,this.size,2);i.uniform2fv(this.addr,t)}function kM(i,e){let t=ia(e,this.size,3);i.uniform3fv(this.addr,t)}function zM(i,e){let t=ia(e,this.size,4);i.uniform4fv(this.addr,t)}function VM(i,e){let t=ia(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function GM(i,e){let t=ia(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function HM(i,e){let t=ia(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function WM(i,e){i.uniform1iv(this.addr,e)}function XM(i,e){i.uniform2iv(this.addr,e)}function qM(i,e){i.uniform3iv(this.addr,e)}function YM(i,e){i.uniform4iv(this.addr,e)}function $M(i,e){i.uniform1uiv(this.addr,e)}function ZM(i,e){i.uniform2uiv(this.addr,e)}function JM(i,e){i.uniform3uiv(this.addr,e)}function KM(i,e){i.uniform4uiv(this.addr,e)}function jM(i,e,t){let n=this.cache,s=e.length,r=Mc(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=Sc(Om):a=Fm;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function QM(i,e,t){let n=this.cache,s=e.length,r=Mc(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||zm,r[a])}function eS(i,e,t){let n=this.cache,s=e.length,r=Mc(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Sc(Bm):a=Vm;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function tS(i,e,t){let n=this.cache,s=e.length,r=Mc(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||km,r[a])}function nS(i){switch(i){case 5126:return OM;case 35664:return BM;case 35665:return kM;case 35666:return zM;case 35674:return VM;case 35675:return GM;case 35676:return HM;case 5124:case 35670:return WM;case 35667:case 35671:return XM;case 35668:case 35672:return qM;case 35669:case 35673:return YM;case 5125:return $M;case 36294:return ZM;case 36295:return JM;case 36296:return KM;case 35678:case 36198:case 36298:case 36306:case 35682:return jM;case 35679:case 36299:case 36307:return QM;case 35680:case 36300:case 36308:case 36293:return eS;case 36289:case 36303:case 36311:case 36292:return tS}}var Iu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=FM(t.type)}},Lu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=nS(t.type)}},Nu=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(e,t[o.id],n)}}},Ru=/(\w+)(\])?(\[|\.)?/g;function ym(i,e){i.seq.push(e),i.map[e.id]=e}function iS(i,e,t){let n=i.name,s=n.length;for(Ru.lastIndex=0;;){let r=Ru.exec(n),a=Ru.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){ym(t,c===void 0?new Iu(o,i,e):new Lu(o,i,e));break}else{let d=t.map[o];d===void 0&&(d=new Nu(o),ym(t,d)),t=d}}}var na=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);iS(o,l,this)}let s=[],r=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,a=t.length;r!==a;++r){let o=t[r],l=n[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let a=e[s];a.id in t&&n.push(a)}return n}};function Mm(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var sS=37297,rS=0;function aS(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return n.join(`
`)}var Sm=new lt;function oS(i){St._getMatrix(Sm,St.workingColorSpace,i);let e=`mat3( ${Sm.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(i)){case Aa:return[e,"LinearTransferOETF"];case Ut:return[e,"sRGBTransferOETF"];default:return nt("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function bm(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+aS(i.getShaderSource(e),o)}else return r}function lS(i,e){let t=oS(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var cS={[su]:"Linear",[ru]:"Reinhard",[au]:"Cineon",[ou]:"ACESFilmic",[cu]:"AgX",[hu]:"Neutral",[lu]:"Custom"};function hS(i,e){let t=cS[e];return t===void 0?(nt("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var xc=new j;function uS(){St.getLuminanceCoefficients(xc);let i=xc.x.toFixed(4),e=xc.y.toFixed(4),t=xc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function dS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(to).join(`
`)}function fS(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function pS(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:i.getAttribLocation(e,a),locationSize:o}}return t}function to(i){return i!==""}function wm(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Em(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var mS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Du(i){return i.replace(mS,gS)}function gS(i,e){let t=gt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Du(t)}var _S=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Tm(i){return i.replace(_S,xS)}function xS(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Am(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var vS={[Wa]:"SHADOWMAP_TYPE_PCF",[jr]:"SHADOWMAP_TYPE_VSM"};function yS(i){return vS[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var MS={[ea]:"ENVMAP_MODE_REFRACTION"};function SS(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":MS[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var bS={[iu]:"ENVMAP_BLENDING_MULTIPLY",[Wp]:"ENVMAP_BLENDING_MIX",[Xp]:"ENVMAP_BLENDING_ADD"};function wS(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":bS[i.combine]||"ENVMAP_BLENDING_NONE"}function ES(i,e,t,n){let s=i.getContext(),r=t.defines,a=t.vertexShader,o=t.fragmentShader,l=yS(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=SS(t),d=wS(t),u=dS(t),f=fS(r),g=s.createProgram(),y,m,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(to).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(to).join(`
`),m.length>0&&(m+=`
`)):(y=[Am(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(to).join(`
`),m=[Am(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==qi?"#define TONE_MAPPING":"",t.toneMapping!==qi?gt.tonemapping_pars_fragment:"",t.toneMapping!==qi?hS("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",gt.colorspace_pars_fragment,lS("linearToOutputTexel",t.outputColorSpace),uS(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(to).join(`
`)),a=Du(a),a=wm(a,t),a=Em(a,t),o=Du(o),o=wm(o,t),o=Em(o,t),a=Tm(a),o=Tm(o),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,y=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",t.glslVersion===ja?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===ja?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=p+y+a,T=p+m+o,b=Mm(s,s.VERTEX_SHADER,v),P=Mm(s,s.FRAGMENT_SHADER,T);s.attachShader(g,b),s.attachShader(g,P),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function C(U){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",W=s.getShaderInfoLog(b)||"",X=s.getShaderInfoLog(P)||"",I=D.trim(),V=W.trim(),Z=X.trim(),B=!0,ue=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(B=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,b,P);else{let J=bm(s,b,"vertex"),Q=bm(s,P,"fragment");ot("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+I+`
`+J+`
`+Q)}else I!==""?nt("WebGLProgram: Program Info Log:",I):(V===""||Z==="")&&(ue=!1);ue&&(U.diagnostics={runnable:B,programLog:I,vertexShader:{log:V,prefix:y},fragmentShader:{log:Z,prefix:m}})}s.deleteShader(b),s.deleteShader(P),x=new na(s,g),A=pS(s,g)}let x;this.getUniforms=function(){return x===void 0&&C(this),x};let A;this.getAttributes=function(){return A===void 0&&C(this),A};let z=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return z===!1&&(z=s.getProgramParameter(g,sS)),z},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=rS++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=P,this}var TS=0,Uu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Fu(e),t.set(e,n)),n}},Fu=class{constructor(e){this.id=TS++,this.code=e,this.usedTimes=0}};function AS(i){return i===zs||i===Ja||i===Ka}function CS(i,e,t,n,s,r){let a=new Ia,o=new Uu,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,A,z,U,D,W){let X=U.fog,I=D.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?U.environment:null,Z=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,B=e.get(x.envMap||V,Z),ue=u[x.type],J=n.precision;x.precision!==null&&(J=n.getMaxPrecision(x.precision),J!==x.precision&&nt("WebGLProgram.getParameters:",x.precision,"not supported, using",J,"instead."));let Q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,se=Q!==void 0?Q.length:0,oe=0;I.morphAttributes.position!==void 0&&(oe=1),I.morphAttributes.normal!==void 0&&(oe=2),I.morphAttributes.color!==void 0&&(oe=3);let fe,ee,xe,ve;if(ue){let Pe=$i[ue];fe=Pe.vertexShader,ee=Pe.fragmentShader}else{fe=x.vertexShader,ee=x.fragmentShader;let Pe=o.getVertexShaderStage(x),ct=o.getFragmentShaderStage(x);o.update(x,Pe,ct),xe=Pe.id,ve=ct.id}let Te=i.getRenderTarget(),we=i.state.buffers.depth.getReversed(),$e=D.isInstancedMesh===!0,it=D.isBatchedMesh===!0,Xe=!!x.map,ut=!!x.matcap,dt=!!B,rt=dt&&B.isPMREMTexture===!0,kt=!!x.aoMap,Ft=!!x.lightMap,nn=!!x.bumpMap&&x.wireframe===!1,At=!!x.normalMap,hn=!!x.displacementMap,_t=!!x.emissiveMap,an=!!x.metalnessMap,Yt=!!x.roughnessMap,sn=x.anisotropy>0,O=x.clearcoat>0,Ie=x.diffuseRoughness>0,et=x.dispersion>0,at=x.retroreflectivity>0,Ae=x.iridescence>0,It=x.sheen>0,qe=x.transmission>0,je=sn&&!!x.anisotropyMap,E=O&&!!x.clearcoatMap,S=O&&!!x.clearcoatNormalMap,Y=O&&!!x.clearcoatRoughnessMap,ce=Ie&&!!x.diffuseRoughnessMap,ae=Ae&&!!x.iridescenceMap,_e=Ae&&!!x.iridescenceThicknessMap,ye=It&&!!x.sheenColorMap,te=It&&!!x.sheenRoughnessMap,ie=!!x.specularMap,me=!!x.specularColorMap,F=!!x.specularIntensityMap,re=qe&&!!x.transmissionMap,ne=qe&&!!x.thicknessMap,Re=!!x.gradientMap,Me=!!x.alphaMap,Ee=x.alphaTest>0,Be=!!x.alphaHash,Qe=!!x.extensions,he=qi;x.toneMapped&&(Te===null||Te.isXRRenderTarget===!0)&&(he=i.toneMapping);let Ve=rt?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,tt={shaderID:ue,shaderType:x.type,shaderName:x.name,vertexShader:fe,fragmentShader:ee,defines:x.defines,customVertexShaderID:xe,customFragmentShaderID:ve,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:J,batching:it,batchingColor:it&&D._colorsTexture!==null,instancing:$e,instancingColor:$e&&D.instanceColor!==null,instancingMorph:$e&&D.morphTexture!==null,outputColorSpace:Te===null?i.outputColorSpace:Te.isXRRenderTarget===!0?Te.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Xe,matcap:ut,envMap:dt,envMapMode:dt&&B.mapping,envMapPMREM:rt,envMapMaxLod:rt?Ve.length-1:null,envMapSize:rt?Ve[0].width:null,aoMap:kt,lightMap:Ft,bumpMap:nn,normalMap:At,displacementMap:hn,emissiveMap:_t,normalMapObjectSpace:At&&x.normalMapType===$p,normalMapTangentSpace:At&&x.normalMapType===vu,packedNormalMap:At&&x.normalMapType===vu&&AS(x.normalMap.format),metalnessMap:an,roughnessMap:Yt,anisotropy:sn,anisotropyMap:je,clearcoat:O,clearcoatMap:E,clearcoatNormalMap:S,clearcoatRoughnessMap:Y,diffuseRoughness:Ie,diffuseRoughnessMap:ce,dispersion:et,retroreflection:at,iridescence:Ae,iridescenceMap:ae,iridescenceThicknessMap:_e,sheen:It,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:ie,specularColorMap:me,specularIntensityMap:F,transmission:qe,transmissionMap:re,thicknessMap:ne,gradientMap:Re,opaque:x.transparent===!1&&x.blending===Qr&&x.alphaToCoverage===!1,alphaMap:Me,alphaTest:Ee,alphaHash:Be,combine:x.combine,mapUv:Xe&&f(x.map.channel),aoMapUv:kt&&f(x.aoMap.channel),lightMapUv:Ft&&f(x.lightMap.channel),bumpMapUv:nn&&f(x.bumpMap.channel),normalMapUv:At&&f(x.normalMap.channel),displacementMapUv:hn&&f(x.displacementMap.channel),emissiveMapUv:_t&&f(x.emissiveMap.channel),metalnessMapUv:an&&f(x.metalnessMap.channel),roughnessMapUv:Yt&&f(x.roughnessMap.channel),anisotropyMapUv:je&&f(x.anisotropyMap.channel),clearcoatMapUv:E&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ce&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(x.sheenRoughnessMap.channel),specularMapUv:ie&&f(x.specularMap.channel),specularColorMapUv:me&&f(x.specularColorMap.channel),specularIntensityMapUv:F&&f(x.specularIntensityMap.channel),transmissionMapUv:re&&f(x.transmissionMap.channel),thicknessMapUv:ne&&f(x.thicknessMap.channel),alphaMapUv:Me&&f(x.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(At||sn),vertexNormals:!!I.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!I.attributes.uv&&(Xe||Me),fog:!!X,useFog:x.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||I.attributes.normal===void 0&&At===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:we,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:oe,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:W.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&z.length>0,shadowMapType:i.shadowMap.type,toneMapping:he,decodeVideoTexture:Xe&&x.map.isVideoTexture===!0&&St.getTransfer(x.map.colorSpace)===Ut,decodeVideoTextureEmissive:_t&&x.emissiveMap.isVideoTexture===!0&&St.getTransfer(x.emissiveMap.colorSpace)===Ut,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Xi,flipSided:x.side===Hn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Qe&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qe&&x.extensions.multiDraw===!0||it)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function y(x){let A=[];if(x.shaderID?A.push(x.shaderID):(A.push(x.customVertexShaderID),A.push(x.customFragmentShaderID)),x.defines!==void 0)for(let z in x.defines)A.push(z),A.push(x.defines[z]);return x.isRawShaderMaterial===!1&&(m(A,x),p(A,x),A.push(i.outputColorSpace)),A.push(x.customProgramCacheKey),A.join()}function m(x,A){x.push(A.precision),x.push(A.outputColorSpace),x.push(A.envMapMode),x.push(A.envMapPMREM),x.push(A.envMapMaxLod),x.push(A.envMapSize),x.push(A.mapUv),x.push(A.alphaMapUv),x.push(A.lightMapUv),x.push(A.aoMapUv),x.push(A.bumpMapUv),x.push(A.normalMapUv),x.push(A.displacementMapUv),x.push(A.emissiveMapUv),x.push(A.metalnessMapUv),x.push(A.roughnessMapUv),x.push(A.anisotropyMapUv),x.push(A.clearcoatMapUv),x.push(A.clearcoatNormalMapUv),x.push(A.clearcoatRoughnessMapUv),x.push(A.diffuseRoughnessMapUv),x.push(A.iridescenceMapUv),x.push(A.iridescenceThicknessMapUv),x.push(A.sheenColorMapUv),x.push(A.sheenRoughnessMapUv),x.push(A.specularMapUv),x.push(A.specularColorMapUv),x.push(A.specularIntensityMapUv),x.push(A.transmissionMapUv),x.push(A.thicknessMapUv),x.push(A.combine),x.push(A.fogExp2),x.push(A.sizeAttenuation),x.push(A.morphTargetsCount),x.push(A.numSunLights),x.push(A.numDirLights),x.push(A.numPointLights),x.push(A.numSpotLights),x.push(A.numSpotLightMaps),x.push(A.numHemiLights),x.push(A.numRectAreaLights),x.push(A.numSunLightShadows),x.push(A.numDirLightShadows),x.push(A.numPointLightShadows),x.push(A.numSpotLightShadows),x.push(A.numSpotLightShadowsWithMaps),x.push(A.numLightProbes),x.push(A.numLightProbeGrids),x.push(A.shadowMapType),x.push(A.toneMapping),x.push(A.numClippingPlanes),x.push(A.numClipIntersection),x.push(A.depthPacking)}function p(x,A){a.disableAll(),A.instancing&&a.enable(0),A.instancingColor&&a.enable(1),A.instancingMorph&&a.enable(2),A.matcap&&a.enable(3),A.envMap&&a.enable(4),A.normalMapObjectSpace&&a.enable(5),A.normalMapTangentSpace&&a.enable(6),A.clearcoat&&a.enable(7),A.iridescence&&a.enable(8),A.alphaTest&&a.enable(9),A.vertexColors&&a.enable(10),A.vertexAlphas&&a.enable(11),A.vertexUv1s&&a.enable(12),A.vertexUv2s&&a.enable(13),A.vertexUv3s&&a.enable(14),A.vertexTangents&&a.enable(15),A.anisotropy&&a.enable(16),A.alphaHash&&a.enable(17),A.batching&&a.enable(18),A.dispersion&&a.enable(19),A.retroreflection&&a.enable(24),A.diffuseRoughness&&a.enable(25),A.batchingColor&&a.enable(20),A.gradientMap&&a.enable(21),A.packedNormalMap&&a.enable(22),A.vertexNormals&&a.enable(23),x.push(a.mask),a.disableAll(),A.fog&&a.enable(0),A.useFog&&a.enable(1),A.flatShading&&a.enable(2),A.logarithmicDepthBuffer&&a.enable(3),A.reversedDepthBuffer&&a.enable(4),A.skinning&&a.enable(5),A.morphTargets&&a.enable(6),A.morphNormals&&a.enable(7),A.morphColors&&a.enable(8),A.premultipliedAlpha&&a.enable(9),A.shadowMapEnabled&&a.enable(10),A.doubleSided&&a.enable(11),A.flipSided&&a.enable(12),A.useDepthPacking&&a.enable(13),A.dithering&&a.enable(14),A.transmission&&a.enable(15),A.sheen&&a.enable(16),A.opaque&&a.enable(17),A.pointsUvs&&a.enable(18),A.decodeVideoTexture&&a.enable(19),A.decodeVideoTextureEmissive&&a.enable(20),A.alphaToCoverage&&a.enable(21),A.numLightProbeGrids>0&&a.enable(22),A.hasPositionAttribute&&a.enable(23),x.push(a.mask)}function v(x){let A=u[x.type],z;if(A){let U=$i[A];z=lm.clone(U.uniforms)}else z=x.uniforms;return z}function T(x,A){let z=h.get(A);return z!==void 0?++z.usedTimes:(z=new ES(i,A,x,s),c.push(z),h.set(A,z)),z}function b(x){if(--x.usedTimes===0){let A=c.indexOf(x);c[A]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function P(x){o.remove(x)}function C(){o.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:v,acquireProgram:T,releaseProgram:b,releaseShaderCache:P,programs:c,dispose:C}}function RS(){let i=new WeakMap;function e(a){return i.has(a)}function t(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,l){i.get(a)[o]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function PS(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Cm(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Rm(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function a(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function o(u,f,g,y,m,p){let v=i[e];return v===void 0?(v={id:u.id,object:u,geometry:f,material:g,materialVariant:a(u),groupOrder:y,renderOrder:u.renderOrder,z:m,group:p},i[e]=v):(v.id=u.id,v.object=u,v.geometry=f,v.material=g,v.materialVariant=a(u),v.groupOrder=y,v.renderOrder=u.renderOrder,v.z=m,v.group=p),e++,v}function l(u,f,g,y,m,p,v){v.reversedDepth===!0&&(m=-m);let T=o(u,f,g,y,m,p);g.transmission>0?n.push(T):g.transparent===!0?s.push(T):t.push(T)}function c(u,f,g,y,m,p){let v=o(u,f,g,y,m,p);g.transmission>0?n.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function h(u,f){t.length>1&&t.sort(u||PS),n.length>1&&n.sort(f||Cm),s.length>1&&s.sort(f||Cm)}function d(){for(let u=e,f=i.length;u<f;u++){let g=i[u];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function IS(){let i=new WeakMap;function e(n,s){let r=i.get(n),a;return r===void 0?(a=new Rm,i.set(n,[a])):s>=r.length?(a=new Rm,r.push(a)):a=r[s],a}function t(){i=new WeakMap}return{get:e,dispose:t}}function LS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new j,color:new Et};break;case"SpotLight":t={position:new j,direction:new j,color:new Et,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new j,color:new Et,distance:0,decay:0};break;case"HemisphereLight":t={direction:new j,skyColor:new Et,groundColor:new Et};break;case"RectAreaLight":t={color:new Et,position:new j,halfWidth:new j,halfHeight:new j};break}return i[e.id]=t,t}}}function NS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new wt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new wt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new wt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var DS=0;function US(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function FS(i){let e=new LS,t=NS(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new j);let s=new j,r=new rn,a=new rn;function o(c){let h=0,d=0,u=0;for(let W=0;W<9;W++)n.probe[W].set(0,0,0);let f=0,g=0,y=0,m=0,p=0,v=0,T=0,b=0,P=0,C=0,x=0,A=0,z=0,U=0;c.sort(US);for(let W=0,X=c.length;W<X;W++){let I=c[W],V=I.color,Z=I.intensity,B=I.distance,ue=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===zs?ue=I.shadow.map.texture:ue=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=V.r*Z,d+=V.g*Z,u+=V.b*Z;else if(I.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(I.sh.coefficients[J],Z);U++}else if(I.isSunLight){let J=e.get(I);if(J.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,se=t.get(I);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=se,n.sunShadowMap[g]=ue;let oe=Q.getViewportCount();for(let fe=0;fe<oe;fe++)n.sunShadowMatrix[y+fe]=Q.getMatrix(fe),n.sunShadowCascade[y+fe]=Q._cascadeData[fe];y+=oe,g++}n.sun[f]=J,f++}else if(I.isDirectionalLight){let J=e.get(I);if(J.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,se=t.get(I);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,n.directionalShadow[m]=se,n.directionalShadowMap[m]=ue,n.directionalShadowMatrix[m]=I.shadow.matrix,P++}n.directional[m]=J,m++}else if(I.isSpotLight){let J=e.get(I);J.position.setFromMatrixPosition(I.matrixWorld),J.color.copy(V).multiplyScalar(Z),J.distance=B,J.coneCos=Math.cos(I.angle),J.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),J.decay=I.decay,n.spot[v]=J;let Q=I.shadow;if(I.map&&(n.spotLightMap[A]=I.map,A++,Q.updateMatrices(I),I.castShadow&&z++),n.spotLightMatrix[v]=Q.matrix,I.castShadow){let se=t.get(I);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,n.spotShadow[v]=se,n.spotShadowMap[v]=ue,x++}v++}else if(I.isRectAreaLight){let J=e.get(I);J.color.copy(V).multiplyScalar(Z),J.halfWidth.set(I.width*.5,0,0),J.halfHeight.set(0,I.height*.5,0),n.rectArea[T]=J,T++}else if(I.isPointLight){let J=e.get(I);if(J.color.copy(I.color).multiplyScalar(I.intensity),J.distance=I.distance,J.decay=I.decay,I.castShadow){let Q=I.shadow,se=t.get(I);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,se.shadowCameraNear=Q.camera.near,se.shadowCameraFar=Q.camera.far,n.pointShadow[p]=se,n.pointShadowMap[p]=ue,n.pointShadowMatrix[p]=I.shadow.matrix,C++}n.point[p]=J,p++}else if(I.isHemisphereLight){let J=e.get(I);J.skyColor.copy(I.color).multiplyScalar(Z),J.groundColor.copy(I.groundColor).multiplyScalar(Z),n.hemi[b]=J,b++}}T>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ue.LTC_FLOAT_1,n.rectAreaLTC2=Ue.LTC_FLOAT_2):(n.rectAreaLTC1=Ue.LTC_HALF_1,n.rectAreaLTC2=Ue.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let D=n.hash;(D.sunLength!==f||D.directionalLength!==m||D.pointLength!==p||D.spotLength!==v||D.rectAreaLength!==T||D.hemiLength!==b||D.numSunShadows!==g||D.numDirectionalShadows!==P||D.numPointShadows!==C||D.numSpotShadows!==x||D.numSpotMaps!==A||D.numLightProbes!==U)&&(n.sun.length=f,n.directional.length=m,n.spot.length=v,n.rectArea.length=T,n.point.length=p,n.hemi.length=b,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=P,n.directionalShadowMap.length=P,n.directionalShadowMatrix.length=P,n.pointShadow.length=C,n.pointShadowMap.length=C,n.pointShadowMatrix.length=C,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+A-z,n.spotLightMap.length=A,n.numSpotLightShadowsWithMaps=z,n.numLightProbes=U,D.sunLength=f,D.directionalLength=m,D.pointLength=p,D.spotLength=v,D.rectAreaLength=T,D.hemiLength=b,D.numSunShadows=g,D.numDirectionalShadows=P,D.numPointShadows=C,D.numSpotShadows=x,D.numSpotMaps=A,D.numLightProbes=U,n.version=DS++)}function l(c,h){let d=0,u=0,f=0,g=0,y=0,m=0,p=h.matrixWorldInverse;for(let v=0,T=c.length;v<T;v++){let b=c[v];if(b.isSunLight){let P=n.sun[d];P.direction.setFromMatrixPosition(b.matrixWorld),P.direction.transformDirection(p),d++}else if(b.isDirectionalLight){let P=n.directional[u];P.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(p),u++}else if(b.isSpotLight){let P=n.spot[g];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(p),P.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(p),g++}else if(b.isRectAreaLight){let P=n.rectArea[y];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(p),a.identity(),r.copy(b.matrixWorld),r.premultiply(p),a.extractRotation(r),P.halfWidth.set(b.width*.5,0,0),P.halfHeight.set(0,b.height*.5,0),P.halfWidth.applyMatrix4(a),P.halfHeight.applyMatrix4(a),y++}else if(b.isPointLight){let P=n.point[f];P.position.setFromMatrixPosition(b.matrixWorld),P.position.applyMatrix4(p),f++}else if(b.isHemisphereLight){let P=n.hemi[m];P.direction.setFromMatrixPosition(b.matrixWorld),P.direction.transformDirection(p),m++}}}return{setup:o,setupView:l,state:n}}function Pm(i){let e=new FS(i),t=[],n=[],s=[];function r(d){h.camera=d,t.length=0,n.length=0,s.length=0}function a(d){d.isLightProbeGrid?s.push(d):t.push(d)}function o(d){n.push(d)}function l(){e.setup(t),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function OS(i){let e=new WeakMap;function t(s,r=0){let a=e.get(s),o;return a===void 0?(o=new Pm(i),e.set(s,[o])):r>=a.length?(o=new Pm(i),a.push(o)):o=a[r],o}function n(){e=new WeakMap}return{get:t,dispose:n}}var BS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,kS=`uniform sampler2D shadow_pass;
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
}`,zS=[new j(1,0,0),new j(-1,0,0),new j(0,1,0),new j(0,-1,0),new j(0,0,1),new j(0,0,-1)],VS=[new j(0,-1,0),new j(0,-1,0),new j(0,0,1),new j(0,0,-1),new j(0,-1,0),new j(0,-1,0)],Im=new rn,eo=new j,Pu=new j;function GS(i,e,t){let n=new ir,s=new wt,r=new wt,a=new Qt,o=new vl,l=new yl,c={},h=t.maxTextureSize,d={[ks]:Hn,[Hn]:ks,[Xi]:Xi},u=new vi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new wt},radius:{value:4}},vertexShader:BS,fragmentShader:kS}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let g=new Hi;g.setAttribute("position",new qn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Wi(g,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Wa;let p=this.type;this.render=function(C,x,A){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||C.length===0)return;this.type===Ep&&(nt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Wa);let z=i.getRenderTarget(),U=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),W=i.state;W.setBlending(sr),W.buffers.depth.getReversed()===!0?W.buffers.color.setClear(0,0,0,0):W.buffers.color.setClear(1,1,1,1),W.buffers.depth.setTest(!0),W.setScissorTest(!1);let X=p!==this.type;X&&x.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(V=>V.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,V=C.length;I<V;I++){let Z=C[I],B=Z.shadow;if(B===void 0){nt("WebGLShadowMap:",Z,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let ue=B.getFrameExtents();s.multiply(ue),r.copy(B.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ue.x),s.x=r.x*ue.x,B.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ue.y),s.y=r.y*ue.y,B.mapSize.y=r.y));let J=i.state.buffers.depth.getReversed();if(B.camera._reversedDepth=J,B.map===null||X===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===jr){if(Z.isPointLight){nt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new oi(s.x,s.y,{format:zs,type:Ii,minFilter:Gn,magFilter:Gn,generateMipmaps:!1}),B.map.texture.name=Z.name+".shadowMap",B.map.depthTexture=new us(s.x,s.y,Pi),B.map.depthTexture.name=Z.name+".shadowMapDepth",B.map.depthTexture.format=hs,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=Cn,B.map.depthTexture.magFilter=Cn}else Z.isPointLight?(B.map=new no(s.x),B.map.depthTexture=new Ba(s.x,Ri)):(B.map=new oi(s.x,s.y),B.map.depthTexture=new us(s.x,s.y,Ri)),B.map.depthTexture.name=Z.name+".shadowMap",B.map.depthTexture.format=hs,this.type===Wa?(B.map.depthTexture.compareFunction=J?Mu:yu,B.map.depthTexture.minFilter=Gn,B.map.depthTexture.magFilter=Gn):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=Cn,B.map.depthTexture.magFilter=Cn);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);let Q=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();Z.isPointLight!==!0&&B.updateMatrices(Z,A);let se=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:A.layers;for(let oe=0;oe<Q;oe++){let fe=B.getCamera(oe);if(Z.isPointLight){let ee=B.camera,xe=B.matrix,ve=Z.distance||ee.far;ve!==ee.far&&(ee.far=ve,ee.updateProjectionMatrix()),eo.setFromMatrixPosition(Z.matrixWorld),ee.position.copy(eo),Pu.copy(ee.position),Pu.add(zS[oe]),ee.up.copy(VS[oe]),ee.lookAt(Pu),ee.updateMatrixWorld(),xe.makeTranslation(-eo.x,-eo.y,-eo.z),Im.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),B._frustum.setFromProjectionMatrix(Im,ee.coordinateSystem,ee.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)i.setRenderTarget(B.map,oe),i.clear();else{oe===0&&(i.setRenderTarget(B.map),i.clear());let ee=B.getViewport(oe);a.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),W.viewport(a)}n=B.getFrustum(oe),b(x,A,fe,Z,se,this.type)}B.isPointLightShadow!==!0&&this.type===jr&&v(B,A),B.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(z,U,D)};function v(C,x){let A=e.update(y);u.defines.VSM_SAMPLES!==C.blurSamples&&(u.defines.VSM_SAMPLES=C.blurSamples,f.defines.VSM_SAMPLES=C.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),C.mapPass===null?C.mapPass=new oi(s.x,s.y,{format:zs,type:Ii}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),u.uniforms.shadow_pass.value=C.map.depthTexture,u.uniforms.resolution.value.set(C.map.width,C.map.height),u.uniforms.radius.value=C.radius,i.setRenderTarget(C.mapPass),i.clear(),i.renderBufferDirect(x,null,A,u,y,null),f.uniforms.shadow_pass.value=C.mapPass.texture,f.uniforms.resolution.value.set(C.map.width,C.map.height),f.uniforms.radius.value=C.radius,i.setRenderTarget(C.map),i.clear(),i.renderBufferDirect(x,null,A,f,y,null)}function T(C,x,A,z){let U=null,D=A.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(D!==void 0)U=D;else if(U=A.isPointLight===!0?l:o,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let W=U.uuid,X=x.uuid,I=c[W];I===void 0&&(I={},c[W]=I);let V=I[X];V===void 0&&(V=U.clone(),I[X]=V,x.addEventListener("dispose",P)),U=V}if(U.visible=x.visible,U.wireframe=x.wireframe,z===jr?U.side=x.shadowSide!==null?x.shadowSide:x.side:U.side=x.shadowSide!==null?x.shadowSide:d[x.side],U.alphaMap=x.alphaMap,U.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,U.map=x.map,U.clipShadows=x.clipShadows,U.clippingPlanes=x.clippingPlanes,U.clipIntersection=x.clipIntersection,U.displacementMap=x.displacementMap,U.displacementScale=x.displacementScale,U.displacementBias=x.displacementBias,U.wireframeLinewidth=x.wireframeLinewidth,U.linewidth=x.linewidth,A.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let W=i.properties.get(U);W.light=A}return U}function b(C,x,A,z,U,D){if(C.visible===!1)return;if(C.layers.test(U)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&D===jr)&&(!C.frustumCulled||C.intersectsFrustum(n))){C.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,C.matrixWorld);let I=e.update(C),V=C.material;if(Array.isArray(V)){let Z=I.groups;for(let B=0,ue=Z.length;B<ue;B++){let J=Z[B],Q=V[J.materialIndex];if(Q&&Q.visible){let se=T(C,Q,z,D);C.onBeforeShadow(i,C,x,A,I,se,J),i.renderBufferDirect(A,null,I,se,C,J),C.onAfterShadow(i,C,x,A,I,se,J)}}}else if(V.visible){let Z=T(C,V,z,D);C.onBeforeShadow(i,C,x,A,I,Z,null),i.renderBufferDirect(A,null,I,Z,C,null),C.onAfterShadow(i,C,x,A,I,Z,null)}}let X=C.children;for(let I=0,V=X.length;I<V;I++)b(X[I],x,A,z,U,D)}function P(C){C.target.removeEventListener("dispose",P);for(let A in c){let z=c[A],U=C.target.uuid;U in z&&(z[U].dispose(),delete z[U])}}}function HS(i,e){function t(){let F=!1,re=new Qt,ne=null,Re=new Qt(0,0,0,0);return{setMask:function(Me){ne!==Me&&!F&&(i.colorMask(Me,Me,Me,Me),ne=Me)},setLocked:function(Me){F=Me},setClear:function(Me,Ee,Be,Qe,he){he===!0&&(Me*=Qe,Ee*=Qe,Be*=Qe),re.set(Me,Ee,Be,Qe),Re.equals(re)===!1&&(i.clearColor(Me,Ee,Be,Qe),Re.copy(re))},reset:function(){F=!1,ne=null,Re.set(-1,0,0,0)}}}function n(){let F=!1,re=!1,ne=null,Re=null,Me=null;return{setReversed:function(Ee){if(re!==Ee){let Be=e.get("EXT_clip_control");Ee?Be.clipControlEXT(Be.LOWER_LEFT_EXT,Be.ZERO_TO_ONE_EXT):Be.clipControlEXT(Be.LOWER_LEFT_EXT,Be.NEGATIVE_ONE_TO_ONE_EXT),re=Ee;let Qe=Me;Me=null,this.setClear(Qe)}},getReversed:function(){return re},setTest:function(Ee){Ee?we(i.DEPTH_TEST):$e(i.DEPTH_TEST)},setMask:function(Ee){ne!==Ee&&!F&&(i.depthMask(Ee),ne=Ee)},setFunc:function(Ee){if(re&&(Ee=rm[Ee]),Re!==Ee){switch(Ee){case Ko:i.depthFunc(i.NEVER);break;case jo:i.depthFunc(i.ALWAYS);break;case Qo:i.depthFunc(i.LESS);break;case Xr:i.depthFunc(i.LEQUAL);break;case el:i.depthFunc(i.EQUAL);break;case tl:i.depthFunc(i.GEQUAL);break;case nl:i.depthFunc(i.GREATER);break;case il:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Re=Ee}},setLocked:function(Ee){F=Ee},setClear:function(Ee){Me!==Ee&&(Me=Ee,re&&(Ee=1-Ee),i.clearDepth(Ee))},reset:function(){F=!1,ne=null,Re=null,Me=null,re=!1}}}function s(){let F=!1,re=null,ne=null,Re=null,Me=null,Ee=null,Be=null,Qe=null,he=null;return{setTest:function(Ve){F||(Ve?we(i.STENCIL_TEST):$e(i.STENCIL_TEST))},setMask:function(Ve){re!==Ve&&!F&&(i.stencilMask(Ve),re=Ve)},setFunc:function(Ve,tt,Pe){(ne!==Ve||Re!==tt||Me!==Pe)&&(i.stencilFunc(Ve,tt,Pe),ne=Ve,Re=tt,Me=Pe)},setOp:function(Ve,tt,Pe){(Ee!==Ve||Be!==tt||Qe!==Pe)&&(i.stencilOp(Ve,tt,Pe),Ee=Ve,Be=tt,Qe=Pe)},setLocked:function(Ve){F=Ve},setClear:function(Ve){he!==Ve&&(i.clearStencil(Ve),he=Ve)},reset:function(){F=!1,re=null,ne=null,Re=null,Me=null,Ee=null,Be=null,Qe=null,he=null}}}let r=new t,a=new n,o=new s,l={},c=new WeakMap,h={},d={},u={},f=new WeakMap,g=[],y=null,m=!1,p=null,v=null,T=null,b=null,P=null,C=null,x=null,A=new Et(0,0,0),z=0,U=!1,D=null,W=null,X=null,I=null,V=null,Z=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),B=!1,ue=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(ue=parseFloat(/^WebGL (\d)/.exec(J)[1]),B=ue>=1):J.indexOf("OpenGL ES")!==-1&&(ue=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),B=ue>=2);let Q=null,se={},oe=i.getParameter(i.SCISSOR_BOX),fe=i.getParameter(i.VIEWPORT),ee=new Qt().fromArray(oe),xe=new Qt().fromArray(fe);function ve(F,re,ne,Re){let Me=new Uint8Array(4),Ee=i.createTexture();i.bindTexture(F,Ee),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Be=0;Be<ne;Be++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(re,0,i.RGBA,1,1,Re,0,i.RGBA,i.UNSIGNED_BYTE,Me):i.texImage2D(re+Be,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Me);return Ee}let Te={};Te[i.TEXTURE_2D]=ve(i.TEXTURE_2D,i.TEXTURE_2D,1),Te[i.TEXTURE_CUBE_MAP]=ve(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Te[i.TEXTURE_2D_ARRAY]=ve(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Te[i.TEXTURE_3D]=ve(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),we(i.DEPTH_TEST),a.setFunc(Xr),nn(!1),At(Kh),we(i.CULL_FACE),kt(sr);function we(F){h[F]!==!0&&(i.enable(F),h[F]=!0)}function $e(F){h[F]!==!1&&(i.disable(F),h[F]=!1)}function it(F,re){return u[F]!==re?(i.bindFramebuffer(F,re),u[F]=re,F===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=re),F===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=re),!0):!1}function Xe(F,re){let ne=g,Re=!1;if(F){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let Me=F.textures;if(ne.length!==Me.length||ne[0]!==i.COLOR_ATTACHMENT0){for(let Ee=0,Be=Me.length;Ee<Be;Ee++)ne[Ee]=i.COLOR_ATTACHMENT0+Ee;ne.length=Me.length,Re=!0}}else ne[0]!==i.BACK&&(ne[0]=i.BACK,Re=!0);Re&&i.drawBuffers(ne)}function ut(F){return y!==F?(i.useProgram(F),y=F,!0):!1}let dt={[rr]:i.FUNC_ADD,[Ap]:i.FUNC_SUBTRACT,[Cp]:i.FUNC_REVERSE_SUBTRACT};dt[Rp]=i.MIN,dt[Pp]=i.MAX;let rt={[Ip]:i.ZERO,[Lp]:i.ONE,[Np]:i.SRC_COLOR,[tu]:i.SRC_ALPHA,[kp]:i.SRC_ALPHA_SATURATE,[Op]:i.DST_COLOR,[Up]:i.DST_ALPHA,[Dp]:i.ONE_MINUS_SRC_COLOR,[nu]:i.ONE_MINUS_SRC_ALPHA,[Bp]:i.ONE_MINUS_DST_COLOR,[Fp]:i.ONE_MINUS_DST_ALPHA,[zp]:i.CONSTANT_COLOR,[Vp]:i.ONE_MINUS_CONSTANT_COLOR,[Gp]:i.CONSTANT_ALPHA,[Hp]:i.ONE_MINUS_CONSTANT_ALPHA};function kt(F,re,ne,Re,Me,Ee,Be,Qe,he,Ve){if(F===sr){m===!0&&($e(i.BLEND),m=!1);return}if(m===!1&&(we(i.BLEND),m=!0),F!==Tp){if(F!==p||Ve!==U){if((v!==rr||P!==rr)&&(i.blendEquation(i.FUNC_ADD),v=rr,P=rr),Ve)switch(F){case Qr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case jh:i.blendFunc(i.ONE,i.ONE);break;case Qh:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case eu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:ot("WebGLState: Invalid blending: ",F);break}else switch(F){case Qr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case jh:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Qh:ot("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case eu:ot("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ot("WebGLState: Invalid blending: ",F);break}T=null,b=null,C=null,x=null,A.set(0,0,0),z=0,p=F,U=Ve}return}Me=Me||re,Ee=Ee||ne,Be=Be||Re,(re!==v||Me!==P)&&(i.blendEquationSeparate(dt[re],dt[Me]),v=re,P=Me),(ne!==T||Re!==b||Ee!==C||Be!==x)&&(i.blendFuncSeparate(rt[ne],rt[Re],rt[Ee],rt[Be]),T=ne,b=Re,C=Ee,x=Be),(Qe.equals(A)===!1||he!==z)&&(i.blendColor(Qe.r,Qe.g,Qe.b,he),A.copy(Qe),z=he),p=F,U=!1}function Ft(F,re){F.side===Xi?$e(i.CULL_FACE):we(i.CULL_FACE);let ne=F.side===Hn;re&&(ne=!ne),nn(ne),F.blending===Qr&&F.transparent===!1?kt(sr):kt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),a.setFunc(F.depthFunc),a.setTest(F.depthTest),a.setMask(F.depthWrite),r.setMask(F.colorWrite);let Re=F.stencilWrite;o.setTest(Re),Re&&(o.setMask(F.stencilWriteMask),o.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),o.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),_t(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?we(i.SAMPLE_ALPHA_TO_COVERAGE):$e(i.SAMPLE_ALPHA_TO_COVERAGE)}function nn(F){D!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),D=F)}function At(F){F!==bp?(we(i.CULL_FACE),F!==W&&(F===Kh?i.cullFace(i.BACK):F===wp?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):$e(i.CULL_FACE),W=F}function hn(F){F!==X&&(B&&i.lineWidth(F),X=F)}function _t(F,re,ne){F?(we(i.POLYGON_OFFSET_FILL),(I!==re||V!==ne)&&(I=re,V=ne,a.getReversed()&&(re=-re,ne=-ne),i.polygonOffset(re,ne))):$e(i.POLYGON_OFFSET_FILL)}function an(F){F?we(i.SCISSOR_TEST):$e(i.SCISSOR_TEST)}function Yt(F){F===void 0&&(F=i.TEXTURE0+Z-1),Q!==F&&(i.activeTexture(F),Q=F)}function sn(F,re,ne){ne===void 0&&(Q===null?ne=i.TEXTURE0+Z-1:ne=Q);let Re=se[ne];Re===void 0&&(Re={type:void 0,texture:void 0},se[ne]=Re),(Re.type!==F||Re.texture!==re)&&(Q!==ne&&(i.activeTexture(ne),Q=ne),i.bindTexture(F,re||Te[F]),Re.type=F,Re.texture=re)}function O(){let F=se[Q];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Ie(){try{i.compressedTexImage2D(...arguments)}catch(F){ot("WebGLState:",F)}}function et(){try{i.compressedTexImage3D(...arguments)}catch(F){ot("WebGLState:",F)}}function at(){try{i.texSubImage2D(...arguments)}catch(F){ot("WebGLState:",F)}}function Ae(){try{i.texSubImage3D(...arguments)}catch(F){ot("WebGLState:",F)}}function It(){try{i.compressedTexSubImage2D(...arguments)}catch(F){ot("WebGLState:",F)}}function qe(){try{i.compressedTexSubImage3D(...arguments)}catch(F){ot("WebGLState:",F)}}function je(){try{i.texStorage2D(...arguments)}catch(F){ot("WebGLState:",F)}}function E(){try{i.texStorage3D(...arguments)}catch(F){ot("WebGLState:",F)}}function S(){try{i.texImage2D(...arguments)}catch(F){ot("WebGLState:",F)}}function Y(){try{i.texImage3D(...arguments)}catch(F){ot("WebGLState:",F)}}function ce(F){return d[F]!==void 0?d[F]:i.getParameter(F)}function ae(F,re){d[F]!==re&&(i.pixelStorei(F,re),d[F]=re)}function _e(F){ee.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),ee.copy(F))}function ye(F){xe.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),xe.copy(F))}function te(F,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Re=ne.get(F);Re===void 0&&(Re=i.getUniformBlockIndex(re,F.name),i.uniformBlockBinding(re,Re,Re),ne.set(F,Re))}function ie(F,re,ne){let Me=c.get(re).get(F);l[Me]!==ne&&(i.bindBufferBase(i.UNIFORM_BUFFER,Me,ne),l[Me]=ne)}function me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},Q=null,se={},u={},l={},f=new WeakMap,g=[],y=null,m=!1,p=null,v=null,T=null,b=null,P=null,C=null,x=null,A=new Et(0,0,0),z=0,U=!1,D=null,W=null,X=null,I=null,V=null,ee.set(0,0,i.canvas.width,i.canvas.height),xe.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:we,disable:$e,bindFramebuffer:it,drawBuffers:Xe,useProgram:ut,setBlending:kt,setMaterial:Ft,setFlipSided:nn,setCullFace:At,setLineWidth:hn,setPolygonOffset:_t,setScissorTest:an,activeTexture:Yt,bindTexture:sn,unbindTexture:O,compressedTexImage2D:Ie,compressedTexImage3D:et,texImage2D:S,texImage3D:Y,pixelStorei:ae,getParameter:ce,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:je,texStorage3D:E,texSubImage2D:at,texSubImage3D:Ae,compressedTexSubImage2D:It,compressedTexSubImage3D:qe,scissor:_e,viewport:ye,reset:me}}function WS(i,e,t,n,s,r,a){let o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new wt,h=new WeakMap,d=new Set,u,f=new WeakMap,g=new Set,y=new FinalizationRegistry(E=>g.delete(E)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(E,S){return m?new OffscreenCanvas(E,S):Ra("canvas")}function v(E,S,Y){let ce=1,ae=je(E);if((ae.width>Y||ae.height>Y)&&(ce=Y/Math.max(ae.width,ae.height)),ce<1)if(typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&E instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&E instanceof ImageBitmap||typeof VideoFrame<"u"&&E instanceof VideoFrame){let _e=Math.floor(ce*ae.width),ye=Math.floor(ce*ae.height);u===void 0&&(u=p(_e,ye));let te=S?p(_e,ye):u;return te.width=_e,te.height=ye,te.getContext("2d").drawImage(E,0,0,_e,ye),nt("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+_e+"x"+ye+")."),te}else return"data"in E&&nt("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),E;return E}function T(E){return E.generateMipmaps}function b(E){i.generateMipmap(E)}function P(E){return E.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:E.isWebGL3DRenderTarget?i.TEXTURE_3D:E.isWebGLArrayRenderTarget||E.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function C(E,S,Y,ce,ae,_e=!1){if(E!==null){if(i[E]!==void 0)return i[E];nt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+E+"'")}let ye;ce&&(ye=e.get("EXT_texture_norm16"),ye||nt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=S;if(S===i.RED&&(Y===i.FLOAT&&(te=i.R32F),Y===i.HALF_FLOAT&&(te=i.R16F),Y===i.UNSIGNED_BYTE&&(te=i.R8),Y===i.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),Y===i.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),S===i.RED_INTEGER&&(Y===i.UNSIGNED_BYTE&&(te=i.R8UI),Y===i.UNSIGNED_SHORT&&(te=i.R16UI),Y===i.UNSIGNED_INT&&(te=i.R32UI),Y===i.BYTE&&(te=i.R8I),Y===i.SHORT&&(te=i.R16I),Y===i.INT&&(te=i.R32I)),S===i.RG&&(Y===i.FLOAT&&(te=i.RG32F),Y===i.HALF_FLOAT&&(te=i.RG16F),Y===i.UNSIGNED_BYTE&&(te=i.RG8),Y===i.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),Y===i.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(Y===i.UNSIGNED_BYTE&&(te=i.RG8UI),Y===i.UNSIGNED_SHORT&&(te=i.RG16UI),Y===i.UNSIGNED_INT&&(te=i.RG32UI),Y===i.BYTE&&(te=i.RG8I),Y===i.SHORT&&(te=i.RG16I),Y===i.INT&&(te=i.RG32I)),S===i.RGB_INTEGER&&(Y===i.UNSIGNED_BYTE&&(te=i.RGB8UI),Y===i.UNSIGNED_SHORT&&(te=i.RGB16UI),Y===i.UNSIGNED_INT&&(te=i.RGB32UI),Y===i.BYTE&&(te=i.RGB8I),Y===i.SHORT&&(te=i.RGB16I),Y===i.INT&&(te=i.RGB32I)),S===i.RGBA_INTEGER&&(Y===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),Y===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),Y===i.UNSIGNED_INT&&(te=i.RGBA32UI),Y===i.BYTE&&(te=i.RGBA8I),Y===i.SHORT&&(te=i.RGBA16I),Y===i.INT&&(te=i.RGBA32I)),S===i.RGB&&(Y===i.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),Y===i.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),Y===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),Y===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),S===i.RGBA){let ie=_e?Aa:St.getTransfer(ae);Y===i.FLOAT&&(te=i.RGBA32F),Y===i.HALF_FLOAT&&(te=i.RGBA16F),Y===i.UNSIGNED_BYTE&&(te=ie===Ut?i.SRGB8_ALPHA8:i.RGBA8),Y===i.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),Y===i.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),Y===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),Y===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(E,S){let Y;return E?S===null||S===Ri||S===or?Y=i.DEPTH24_STENCIL8:S===Pi?Y=i.DEPTH32F_STENCIL8:S===ta&&(Y=i.DEPTH24_STENCIL8,nt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Ri||S===or?Y=i.DEPTH_COMPONENT24:S===Pi?Y=i.DEPTH_COMPONENT32F:S===ta&&(Y=i.DEPTH_COMPONENT16),Y}function A(E,S){return T(E)===!0||E.isFramebufferTexture&&E.minFilter!==Cn&&E.minFilter!==Gn?Math.log2(Math.max(S.width,S.height))+1:E.mipmaps.length>0?E.mipmaps.length:E.isCompressedTexture&&Array.isArray(E.image)?S.mipmaps.length:1}function z(E){let S=new WeakRef(E);n.get(E).__ref=S,g.add(S),y.register(E,S,S)}function U(E){let S=n.get(E).__ref;S!==void 0&&(g.delete(S),y.unregister(S))}function D(E){X(E.target)}function W(E){I(E.target)}function X(E){E.removeEventListener("dispose",D),U(E),Z(E),E.isVideoTexture&&h.delete(E),E.isHTMLTexture&&d.delete(E)}function I(E){E.removeEventListener("dispose",W),U(E),ue(E)}function V(){for(let E of g){let S=E.deref();S!==void 0&&(S.isRenderTarget===!0?I(S):X(S))}g.clear(),d.clear()}function Z(E){let S=n.get(E);if(S.__webglInit===void 0)return;let Y=E.source,ce=f.get(Y);if(ce){let ae=ce[S.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&B(E),Object.keys(ce).length===0&&f.delete(Y)}n.remove(E)}function B(E){let S=n.get(E);i.deleteTexture(S.__webglTexture);let Y=E.source,ce=f.get(Y);delete ce[S.__cacheKey],a.memory.textures--}function ue(E){let S=n.get(E);S.__depthDisposeCallback&&S.__depthDisposeCallback();let Y=E.depthTexture;if(Y&&Y.renderTarget===E&&X(Y),E.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(S.__webglFramebuffer[ae]))for(let _e=0;_e<S.__webglFramebuffer[ae].length;_e++)i.deleteFramebuffer(S.__webglFramebuffer[ae][_e]);else i.deleteFramebuffer(S.__webglFramebuffer[ae]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[ae])}else{if(Array.isArray(S.__webglFramebuffer))for(let ae=0;ae<S.__webglFramebuffer.length;ae++)i.deleteFramebuffer(S.__webglFramebuffer[ae]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ae=0;ae<S.__webglColorRenderbuffer.length;ae++)S.__webglColorRenderbuffer[ae]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[ae]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ce=E.textures;for(let ae=0,_e=ce.length;ae<_e;ae++){let ye=n.get(ce[ae]);ye.__webglTexture&&(i.deleteTexture(ye.__webglTexture),a.memory.textures--),n.remove(ce[ae])}n.remove(E)}let J=0;function Q(){J=0}function se(){return J}function oe(E){J=E}function fe(){let E=J;return E>=s.maxTextures&&nt("WebGLTextures: Trying to use "+(E+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,E}function ee(E){let S=[];return S.push(E.wrapS),S.push(E.wrapT),S.push(E.wrapR||0),S.push(E.magFilter),S.push(E.minFilter),S.push(E.anisotropy),S.push(E.internalFormat),S.push(E.format),S.push(E.type),S.push(E.generateMipmaps),S.push(E.mipmapsAutoUpdate),S.push(E.premultiplyAlpha),S.push(E.flipY),S.push(E.unpackAlignment),S.push(E.colorSpace),S.join()}function xe(E,S){let Y=n.get(E);if(E.isVideoTexture&&It(E),E.isRenderTargetTexture===!1&&E.isExternalTexture!==!0&&E.version>0&&Y.__version!==E.version){let ce=E.image;if(ce===null)nt("WebGLRenderer: Texture marked for update but no image data found.");else if(ce.complete===!1)nt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ft(Y,E,S);return}}else E.isExternalTexture&&(Y.__webglTexture=E.sourceTexture?E.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,Y.__webglTexture,i.TEXTURE0+S)}function ve(E,S){let Y=n.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&Y.__version!==E.version){Ft(Y,E,S);return}else E.isExternalTexture&&(Y.__webglTexture=E.sourceTexture?E.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,Y.__webglTexture,i.TEXTURE0+S)}function Te(E,S){let Y=n.get(E);if(E.isRenderTargetTexture===!1&&E.version>0&&Y.__version!==E.version){Ft(Y,E,S);return}t.bindTexture(i.TEXTURE_3D,Y.__webglTexture,i.TEXTURE0+S)}function we(E,S){let Y=n.get(E);if(E.version>0&&Y.__version!==E.version){nn(Y,E,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,Y.__webglTexture,i.TEXTURE0+S)}let $e={[sl]:i.REPEAT,[zi]:i.CLAMP_TO_EDGE,[rl]:i.MIRRORED_REPEAT},it={[Cn]:i.NEAREST,[qp]:i.NEAREST_MIPMAP_NEAREST,[Xa]:i.NEAREST_MIPMAP_LINEAR,[Gn]:i.LINEAR,[Dl]:i.LINEAR_MIPMAP_NEAREST,[ds]:i.LINEAR_MIPMAP_LINEAR},Xe={[Jp]:i.NEVER,[Su]:i.ALWAYS,[Kp]:i.LESS,[yu]:i.LEQUAL,[jp]:i.EQUAL,[Mu]:i.GEQUAL,[Qp]:i.GREATER,[em]:i.NOTEQUAL};function ut(E,S){if(S.type===Pi&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===Gn||S.magFilter===Dl||S.magFilter===Xa||S.magFilter===ds||S.minFilter===Gn||S.minFilter===Dl||S.minFilter===Xa||S.minFilter===ds)&&nt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(E,i.TEXTURE_WRAP_S,$e[S.wrapS]),i.texParameteri(E,i.TEXTURE_WRAP_T,$e[S.wrapT]),(E===i.TEXTURE_3D||E===i.TEXTURE_2D_ARRAY)&&i.texParameteri(E,i.TEXTURE_WRAP_R,$e[S.wrapR]),i.texParameteri(E,i.TEXTURE_MAG_FILTER,it[S.magFilter]),i.texParameteri(E,i.TEXTURE_MIN_FILTER,it[S.minFilter]),S.compareFunction&&(i.texParameteri(E,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(E,i.TEXTURE_COMPARE_FUNC,Xe[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Cn||S.minFilter!==Xa&&S.minFilter!==ds||S.type===Pi&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let Y=e.get("EXT_texture_filter_anisotropic");i.texParameterf(E,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function dt(E,S){let Y=!1;E.__webglInit===void 0&&(E.__webglInit=!0,S.addEventListener("dispose",D),z(S));let ce=S.source,ae=f.get(ce);ae===void 0&&(ae={},f.set(ce,ae));let _e=ee(S);if(_e!==E.__cacheKey){ae[_e]===void 0&&(ae[_e]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,Y=!0),ae[_e].usedTimes++;let ye=ae[E.__cacheKey];ye!==void 0&&(ae[E.__cacheKey].usedTimes--,ye.usedTimes===0&&B(S)),E.__cacheKey=_e,E.__webglTexture=ae[_e].texture}return Y}function rt(E,S,Y){return Math.floor(Math.floor(E/Y)/S)}function kt(E,S,Y,ce){let _e=E.updateRanges;if(_e.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,Y,ce,S.data);else{_e.sort((F,re)=>F.start-re.start);let ye=0;for(let F=1;F<_e.length;F++){let re=_e[ye],ne=_e[F],Re=re.start+re.count,Me=rt(ne.start,S.width,4),Ee=rt(re.start,S.width,4);ne.start<=Re+1&&Me===Ee&&rt(ne.start+ne.count-1,S.width,4)===Me?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,_e[ye]=ne)}_e.length=ye+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),ie=t.getParameter(i.UNPACK_SKIP_PIXELS),me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let F=0,re=_e.length;F<re;F++){let ne=_e[F],Re=Math.floor(ne.start/4),Me=Math.ceil(ne.count/4),Ee=Re%S.width,Be=Math.floor(Re/S.width),Qe=Me,he=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Ee),t.pixelStorei(i.UNPACK_SKIP_ROWS,Be),t.texSubImage2D(i.TEXTURE_2D,0,Ee,Be,Qe,he,Y,ce,S.data)}E.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(i.UNPACK_SKIP_ROWS,me)}}function Ft(E,S,Y){let ce=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ce=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ce=i.TEXTURE_3D);let ae=dt(E,S),_e=S.source;t.bindTexture(ce,E.__webglTexture,i.TEXTURE0+Y);let ye=n.get(_e);if(_e.version!==ye.__version||ae===!0){if(t.activeTexture(i.TEXTURE0+Y),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let he=St.getPrimaries(St.workingColorSpace),Ve=S.colorSpace===ps?null:St.getPrimaries(S.colorSpace),tt=S.colorSpace===ps||he===Ve?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let ie=v(S.image,!1,s.maxTextureSize);ie=qe(S,ie);let me=r.convert(S.format,S.colorSpace),F=r.convert(S.type),re=C(S.internalFormat,me,F,S.normalized,S.colorSpace,S.isVideoTexture);ut(ce,S);let ne,Re=S.mipmaps,Me=S.isVideoTexture!==!0,Ee=ye.__version===void 0||ae===!0,Be=_e.dataReady,Qe=A(S,ie);if(S.isDepthTexture)re=x(S.format===fs,S.type),Ee&&(Me?t.texStorage2D(i.TEXTURE_2D,1,re,ie.width,ie.height):t.texImage2D(i.TEXTURE_2D,0,re,ie.width,ie.height,0,me,F,null));else if(S.isDataTexture)if(Re.length>0){Me&&Ee&&t.texStorage2D(i.TEXTURE_2D,Qe,re,Re[0].width,Re[0].height);for(let he=0,Ve=Re.length;he<Ve;he++)ne=Re[he],Me?Be&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,me,F,ne.data):t.texImage2D(i.TEXTURE_2D,he,re,ne.width,ne.height,0,me,F,ne.data);S.generateMipmaps=!1}else Me?(Ee&&t.texStorage2D(i.TEXTURE_2D,Qe,re,ie.width,ie.height),Be&&kt(S,ie,me,F)):t.texImage2D(i.TEXTURE_2D,0,re,ie.width,ie.height,0,me,F,ie.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){Me&&Ee&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Qe,re,Re[0].width,Re[0].height,ie.depth);for(let he=0,Ve=Re.length;he<Ve;he++)if(ne=Re[he],S.format!==Li)if(me!==null)if(Me){if(Be)if(S.layerUpdates.size>0){let tt=Cu(ne.width,ne.height,S.format,S.type);for(let Pe of S.layerUpdates){let ct=ne.data.subarray(Pe*tt/ne.data.BYTES_PER_ELEMENT,(Pe+1)*tt/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,Pe,ne.width,ne.height,1,me,ct)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,ie.depth,me,ne.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,he,re,ne.width,ne.height,ie.depth,0,ne.data,0,0);else nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Me?Be&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,ie.depth,me,F,ne.data):t.texImage3D(i.TEXTURE_2D_ARRAY,he,re,ne.width,ne.height,ie.depth,0,me,F,ne.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{Me&&Ee&&t.texStorage2D(i.TEXTURE_2D,Qe,re,Re[0].width,Re[0].height);for(let he=0,Ve=Re.length;he<Ve;he++)ne=Re[he],S.format!==Li?me!==null?Me?Be&&t.compressedTexSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,me,ne.data):t.compressedTexImage2D(i.TEXTURE_2D,he,re,ne.width,ne.height,0,ne.data):nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Me?Be&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,ne.width,ne.height,me,F,ne.data):t.texImage2D(i.TEXTURE_2D,he,re,ne.width,ne.height,0,me,F,ne.data)}else if(S.isDataArrayTexture)if(Me){if(Ee&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Qe,re,ie.width,ie.height,ie.depth),Be)if(S.layerUpdates.size>0){let he=Cu(ie.width,ie.height,S.format,S.type);for(let Ve of S.layerUpdates){let tt=ie.data.subarray(Ve*he/ie.data.BYTES_PER_ELEMENT,(Ve+1)*he/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ve,ie.width,ie.height,1,me,F,tt)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,me,F,ie.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,re,ie.width,ie.height,ie.depth,0,me,F,ie.data);else if(S.isData3DTexture)Me?(Ee&&t.texStorage3D(i.TEXTURE_3D,Qe,re,ie.width,ie.height,ie.depth),Be&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,me,F,ie.data)):t.texImage3D(i.TEXTURE_3D,0,re,ie.width,ie.height,ie.depth,0,me,F,ie.data);else if(S.isFramebufferTexture){if(Ee)if(Me)t.texStorage2D(i.TEXTURE_2D,Qe,re,ie.width,ie.height);else{let he=ie.width,Ve=ie.height;for(let tt=0;tt<Qe;tt++)t.texImage2D(i.TEXTURE_2D,tt,re,he,Ve,0,me,F,null),he>>=1,Ve>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let he=i.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),ie.parentNode!==he){he.appendChild(ie),d.add(S),he.onpaint=Ve=>{let tt=Ve.changedElements;for(let Pe of d)tt.includes(Pe.image)&&(Pe.needsUpdate=!0)},he.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,ie);else{let tt=i.RGBA,Pe=i.RGBA,ct=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,tt,Pe,ct,ie)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Re.length>0){if(Me&&Ee){let he=je(Re[0]);t.texStorage2D(i.TEXTURE_2D,Qe,re,he.width,he.height)}for(let he=0,Ve=Re.length;he<Ve;he++)ne=Re[he],Me?Be&&t.texSubImage2D(i.TEXTURE_2D,he,0,0,me,F,ne):t.texImage2D(i.TEXTURE_2D,he,re,me,F,ne);S.generateMipmaps=!1}else if(Me){if(Ee){let he=je(ie);t.texStorage2D(i.TEXTURE_2D,Qe,re,he.width,he.height)}Be&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,me,F,ie)}else t.texImage2D(i.TEXTURE_2D,0,re,me,F,ie);T(S)&&S.mipmapsAutoUpdate===!0&&b(ce),ye.__version=_e.version,S.onUpdate&&S.onUpdate(S)}E.__version=S.version}function nn(E,S,Y){if(S.image.length!==6)return;let ce=dt(E,S),ae=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,E.__webglTexture,i.TEXTURE0+Y);let _e=n.get(ae);if(ae.version!==_e.__version||ce===!0){t.activeTexture(i.TEXTURE0+Y);let ye=St.getPrimaries(St.workingColorSpace),te=S.colorSpace===ps?null:St.getPrimaries(S.colorSpace),ie=S.colorSpace===ps||ye===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let me=S.isCompressedTexture||S.image[0].isCompressedTexture,F=S.image[0]&&S.image[0].isDataTexture,re=[];for(let Pe=0;Pe<6;Pe++)!me&&!F?re[Pe]=v(S.image[Pe],!0,s.maxCubemapSize):re[Pe]=F?S.image[Pe].image:S.image[Pe],re[Pe]=qe(S,re[Pe]);let ne=re[0],Re=r.convert(S.format,S.colorSpace),Me=r.convert(S.type),Ee=C(S.internalFormat,Re,Me,S.normalized,S.colorSpace),Be=S.isVideoTexture!==!0,Qe=_e.__version===void 0||ce===!0,he=ae.dataReady,Ve=A(S,ne);ut(i.TEXTURE_CUBE_MAP,S);let tt;if(S.isDepthTexture){if(Ee=x(S.format===fs,S.type),Qe)if(Be)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ee,ne.width,ne.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,ne.width,ne.height,0,Re,Me,null)}else if(me){Be&&Qe&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ve,Ee,ne.width,ne.height);for(let Pe=0;Pe<6;Pe++){tt=re[Pe].mipmaps;for(let ct=0;ct<tt.length;ct++){let Ht=tt[ct];S.format!==Li?Re!==null?Be?he&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct,0,0,Ht.width,Ht.height,Re,Ht.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct,Ee,Ht.width,Ht.height,0,Ht.data):nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Be?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct,0,0,Ht.width,Ht.height,Re,Me,Ht.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct,Ee,Ht.width,Ht.height,0,Re,Me,Ht.data)}}}else{if(tt=S.mipmaps,Be&&Qe){tt.length>0&&Ve++;let Pe=je(re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ve,Ee,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(F){Be?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,re[Pe].width,re[Pe].height,Re,Me,re[Pe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,re[Pe].width,re[Pe].height,0,Re,Me,re[Pe].data);for(let ct=0;ct<tt.length;ct++){let Rn=tt[ct].image[Pe].image;Be?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct+1,0,0,Rn.width,Rn.height,Re,Me,Rn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct+1,Ee,Rn.width,Rn.height,0,Re,Me,Rn.data)}}else{Be?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Re,Me,re[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,Re,Me,re[Pe]);for(let ct=0;ct<tt.length;ct++){let Ht=tt[ct];Be?he&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct+1,0,0,Re,Me,Ht.image[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ct+1,Ee,Re,Me,Ht.image[Pe])}}}T(S)&&S.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),_e.__version=ae.version,S.onUpdate&&S.onUpdate(S)}E.__version=S.version}function At(E,S,Y,ce,ae,_e){let ye=r.convert(Y.format,Y.colorSpace),te=r.convert(Y.type),ie=C(Y.internalFormat,ye,te,Y.normalized,Y.colorSpace),me=n.get(S),F=n.get(Y);if(F.__renderTarget=S,!me.__hasExternalTextures){let re=Math.max(1,S.width>>_e),ne=Math.max(1,S.height>>_e);ae===i.TEXTURE_3D||ae===i.TEXTURE_2D_ARRAY?t.texImage3D(ae,_e,ie,re,ne,S.depth,0,ye,te,null):t.texImage2D(ae,_e,ie,re,ne,0,ye,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,E),Ae(S)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ce,ae,F.__webglTexture,0,at(S)):(ae===i.TEXTURE_2D||ae>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ce,ae,F.__webglTexture,_e),t.bindFramebuffer(i.FRAMEBUFFER,null)}function hn(E,S,Y){if(i.bindRenderbuffer(i.RENDERBUFFER,E),S.depthBuffer){let ce=S.depthTexture,ae=ce&&ce.isDepthTexture?ce.type:null,_e=x(S.stencilBuffer,ae),ye=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Ae(S)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,at(S),_e,S.width,S.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,at(S),_e,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,_e,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ye,i.RENDERBUFFER,E)}else{let ce=S.textures;for(let ae=0;ae<ce.length;ae++){let _e=ce[ae],ye=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),ie=C(_e.internalFormat,ye,te,_e.normalized,_e.colorSpace);Ae(S)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,at(S),ie,S.width,S.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,at(S),ie,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,ie,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function _t(E,S,Y){let ce=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,E),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=n.get(S.depthTexture);ae.__renderTarget=S;let _e=ce?S.depthTexture.image[0]:S.depthTexture.image;(!ae.__webglTexture||_e.width!==S.width||_e.height!==S.height)&&(_e.width=S.width,_e.height=S.height,S.depthTexture.needsUpdate=!0),ce?we(S.depthTexture,0):xe(S.depthTexture,0);let ye=ae.__webglTexture,te=at(S),ie=ce?i.TEXTURE_CUBE_MAP_POSITIVE_X+Y:i.TEXTURE_2D,me=S.depthTexture.format===fs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===hs)Ae(S)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,ie,ye,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,me,ie,ye,0);else if(S.depthTexture.format===fs)Ae(S)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,ie,ye,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,me,ie,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function an(E){let S=n.get(E),Y=E.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==E.depthTexture){let ce=E.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ce){let ae=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ce.removeEventListener("dispose",ae)};ce.addEventListener("dispose",ae),S.__depthDisposeCallback=ae}S.__boundDepthTexture=ce}if(E.depthTexture&&!S.__autoAllocateDepthBuffer)if(Y)for(let ce=0;ce<6;ce++)_t(S.__webglFramebuffer[ce],E,ce);else E.texture.mipmaps.length>0?_t(S.__webglFramebuffer[0],E,0):_t(S.__webglFramebuffer,E,0);else if(Y){S.__webglDepthbuffer=[];for(let ce=0;ce<6;ce++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[ce]),S.__webglDepthbuffer[ce]===void 0)S.__webglDepthbuffer[ce]=i.createRenderbuffer(),hn(S.__webglDepthbuffer[ce],E,!1);else{let ae=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=S.__webglDepthbuffer[ce];i.bindRenderbuffer(i.RENDERBUFFER,_e),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,_e)}}else if(E.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),hn(S.__webglDepthbuffer,E,!1);else{let ae=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,_e),i.framebufferRenderbuffer(i.FRAMEBUFFER,ae,i.RENDERBUFFER,_e)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Yt(E,S,Y){let ce=n.get(E);S!==void 0&&At(ce.__webglFramebuffer,E,E.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Y!==void 0&&an(E)}function sn(E){let S=E.texture,Y=n.get(E),ce=n.get(S);E.addEventListener("dispose",W),z(E);let ae=E.textures,_e=E.isWebGLCubeRenderTarget===!0,ye=ae.length>1;if(ye||(ce.__webglTexture===void 0&&(ce.__webglTexture=i.createTexture()),ce.__version=S.version,a.memory.textures++),_e){Y.__webglFramebuffer=[];for(let te=0;te<6;te++)if(S.mipmaps.length>0){Y.__webglFramebuffer[te]=[];for(let ie=0;ie<S.mipmaps.length;ie++)Y.__webglFramebuffer[te][ie]=i.createFramebuffer()}else Y.__webglFramebuffer[te]=i.createFramebuffer()}else{if(S.mipmaps.length>0){Y.__webglFramebuffer=[];for(let te=0;te<S.mipmaps.length;te++)Y.__webglFramebuffer[te]=i.createFramebuffer()}else Y.__webglFramebuffer=i.createFramebuffer();if(ye)for(let te=0,ie=ae.length;te<ie;te++){let me=n.get(ae[te]);me.__webglTexture===void 0&&(me.__webglTexture=i.createTexture(),a.memory.textures++)}if(E.samples>0&&Ae(E)===!1){Y.__webglMultisampledFramebuffer=i.createFramebuffer(),Y.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let te=0;te<ae.length;te++){let ie=ae[te];Y.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Y.__webglColorRenderbuffer[te]);let me=r.convert(ie.format,ie.colorSpace),F=r.convert(ie.type),re=C(ie.internalFormat,me,F,ie.normalized,ie.colorSpace,E.isXRRenderTarget===!0),ne=at(E);i.renderbufferStorageMultisample(i.RENDERBUFFER,ne,re,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,Y.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),E.depthBuffer&&(Y.__webglDepthRenderbuffer=i.createRenderbuffer(),hn(Y.__webglDepthRenderbuffer,E,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(_e){t.bindTexture(i.TEXTURE_CUBE_MAP,ce.__webglTexture),ut(i.TEXTURE_CUBE_MAP,S);for(let te=0;te<6;te++)if(S.mipmaps.length>0)for(let ie=0;ie<S.mipmaps.length;ie++)At(Y.__webglFramebuffer[te][ie],E,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else At(Y.__webglFramebuffer[te],E,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);T(S)?b(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,ie=ae.length;te<ie;te++){let me=ae[te],F=n.get(me),re=i.TEXTURE_2D;(E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(re=E.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(re,F.__webglTexture),ut(re,me),At(Y.__webglFramebuffer,E,me,i.COLOR_ATTACHMENT0+te,re,0),T(me)&&b(re)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((E.isWebGL3DRenderTarget||E.isWebGLArrayRenderTarget)&&(te=E.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,ce.__webglTexture),ut(te,S),S.mipmaps.length>0)for(let ie=0;ie<S.mipmaps.length;ie++)At(Y.__webglFramebuffer[ie],E,S,i.COLOR_ATTACHMENT0,te,ie);else At(Y.__webglFramebuffer,E,S,i.COLOR_ATTACHMENT0,te,0);T(S)?b(te):S.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}E.depthBuffer&&an(E)}function O(E){let S=E.textures;for(let Y=0,ce=S.length;Y<ce;Y++){let ae=S[Y];if(T(ae)&&ae.mipmapsAutoUpdate===!0){let _e=P(E),ye=n.get(ae).__webglTexture;t.bindTexture(_e,ye),b(_e),t.unbindTexture()}}}let Ie=[];function et(E){if(E.samples>0){if(Ae(E)===!1){let S=E.textures,Y=E.width,ce=E.height,ae=i.COLOR_BUFFER_BIT,_e=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=n.get(E),te=S.length>1;if(te)for(let me=0;me<S.length;me++)t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),E.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let me=0;me<S.length;me++){if(E.resolveDepthBuffer&&(E.depthBuffer&&(ae|=i.DEPTH_BUFFER_BIT),E.stencilBuffer&&E.resolveStencilBuffer&&(ae|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let F=n.get(S[me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,F,0)}i.blitFramebuffer(0,0,Y,ce,0,0,Y,ce,ae,i.NEAREST),l===!0&&(Ie.length=0,Ie.push(i.COLOR_ATTACHMENT0+me),E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&Ie.push(_e),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let me=0;me<S.length;me++){t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,ye.__webglColorRenderbuffer[me]);let F=n.get(S[me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,F,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(E.depthBuffer&&E.storeMultisampledDepthBuffer===!1&&l){let S=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function at(E){return Math.min(s.maxSamples,E.samples)}function Ae(E){let S=n.get(E);return E.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function It(E){let S=a.render.frame;h.get(E)!==S&&(h.set(E,S),E.update())}function qe(E,S){let Y=E.colorSpace,ce=E.format,ae=E.type;return E.isCompressedTexture===!0||E.isVideoTexture===!0||Y!==Ta&&Y!==ps&&(St.getTransfer(Y)===Ut?(ce!==Li||ae!==hi)&&nt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ot("WebGLTextures: Unsupported texture color space:",Y)),S}function je(E){return typeof HTMLImageElement<"u"&&E instanceof HTMLImageElement?(c.width=E.naturalWidth||E.width,c.height=E.naturalHeight||E.height):typeof VideoFrame<"u"&&E instanceof VideoFrame?(c.width=E.displayWidth,c.height=E.displayHeight):(c.width=E.width,c.height=E.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=Q,this.getTextureUnits=se,this.setTextureUnits=oe,this.setTexture2D=xe,this.setTexture2DArray=ve,this.setTexture3D=Te,this.setTextureCube=we,this.rebindTextures=Yt,this.setupRenderTarget=sn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=et,this.setupDepthRenderbuffer=an,this.setupFrameBufferTexture=At,this.useMultisampledRTT=Ae,this.dispose=V}function XS(i,e){function t(n,s=ps){let r,a=St.getTransfer(s);if(n===hi)return i.UNSIGNED_BYTE;if(n===Fl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Ol)return i.UNSIGNED_SHORT_5_5_5_1;if(n===pu)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===mu)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===du)return i.BYTE;if(n===fu)return i.SHORT;if(n===ta)return i.UNSIGNED_SHORT;if(n===Ul)return i.INT;if(n===Ri)return i.UNSIGNED_INT;if(n===Pi)return i.FLOAT;if(n===Ii)return i.HALF_FLOAT;if(n===gu)return i.ALPHA;if(n===_u)return i.RGB;if(n===Li)return i.RGBA;if(n===hs)return i.DEPTH_COMPONENT;if(n===fs)return i.DEPTH_STENCIL;if(n===xu)return i.RED;if(n===Bl)return i.RED_INTEGER;if(n===zs)return i.RG;if(n===kl)return i.RG_INTEGER;if(n===zl)return i.RGBA_INTEGER;if(n===qa||n===Ya||n===$a||n===Za)if(a===Ut)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===qa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===qa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ya)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===$a)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Za)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Vl||n===Gl||n===Hl||n===Wl)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Vl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Gl)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Hl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Wl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Xl||n===ql||n===Yl||n===$l||n===Zl||n===Ja||n===Jl)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Xl||n===ql)return a===Ut?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Yl)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===$l)return r.COMPRESSED_R11_EAC;if(n===Zl)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ja)return r.COMPRESSED_RG11_EAC;if(n===Jl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Kl||n===jl||n===Ql||n===ec||n===tc||n===nc||n===ic||n===sc||n===rc||n===ac||n===oc||n===lc||n===cc||n===hc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Kl)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===jl)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Ql)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===ec)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===tc)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===nc)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===ic)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===sc)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===rc)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===ac)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===oc)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===lc)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===cc)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===hc)return a===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===uc||n===dc||n===fc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===uc)return a===Ut?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===dc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===fc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===pc||n===mc||n===Ka||n===gc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===pc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===mc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ka)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===gc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===or?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var qS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,YS=`
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

}`,Ou=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new ka(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new vi({vertexShader:qS,fragmentShader:YS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Wi(new za(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Bu=class extends Vi{constructor(e,t){super();let n=this,s=null,r=1,a=null,o="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,g=null,y=typeof XRWebGLBinding<"u",m=new Ou,p={},v=t.getContextAttributes(),T=null,b=null,P=[],C=[],x=new wt,A=null,z=null,U=new ai;U.viewport=new Qt;let D=new ai;D.viewport=new Qt;let W=[U,D],X=new Il,I=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let xe=P[ee];return xe===void 0&&(xe=new $r,P[ee]=xe),xe.getTargetRaySpace()},this.getControllerGrip=function(ee){let xe=P[ee];return xe===void 0&&(xe=new $r,P[ee]=xe),xe.getGripSpace()},this.getHand=function(ee){let xe=P[ee];return xe===void 0&&(xe=new $r,P[ee]=xe),xe.getHandSpace()};function Z(ee){let xe=C.indexOf(ee.inputSource);if(xe===-1)return;let ve=P[xe];ve!==void 0&&(ve.update(ee.inputSource,ee.frame,c||a),ve.dispatchEvent({type:ee.type,data:ee.inputSource}))}function B(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",ue);for(let ee=0;ee<P.length;ee++){let xe=C[ee];xe!==null&&(C[ee]=null,P[ee].disconnect(xe))}I=null,V=null,m.reset();for(let ee in p)delete p[ee];if(e.setRenderTarget(T),f=null,u=null,d=null,s=null,b=null,fe.stop(),n.isPresenting=!1,e.setPixelRatio(A),e.setSize(x.width,x.height,!1),z!==null){let ee=z.camera;ee.fov=z.fov,ee.zoom=z.zoom,ee.updateProjectionMatrix(),z=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,n.isPresenting===!0&&nt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){o=ee,n.isPresenting===!0&&nt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&y&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",B),s.addEventListener("inputsourceschange",ue),v.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Te=null,we=null;v.depth&&(we=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=v.stencil?fs:hs,Te=v.stencil?or:Ri);let $e={colorFormat:t.RGBA8,depthFormat:we,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer($e),s.updateRenderState({layers:[u]}),e.setPixelRatio(1),e.setSize(u.textureWidth,u.textureHeight,!1),b=new oi(u.textureWidth,u.textureHeight,{format:Li,type:hi,depthTexture:new us(u.textureWidth,u.textureHeight,Te,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let ve={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new oi(f.framebufferWidth,f.framebufferHeight,{format:Li,type:hi,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),fe.setContext(s),fe.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ue(ee){for(let xe=0;xe<ee.removed.length;xe++){let ve=ee.removed[xe],Te=C.indexOf(ve);Te>=0&&(C[Te]=null,P[Te].disconnect(ve))}for(let xe=0;xe<ee.added.length;xe++){let ve=ee.added[xe],Te=C.indexOf(ve);if(Te===-1){for(let $e=0;$e<P.length;$e++)if($e>=C.length){C.push(ve),Te=$e;break}else if(C[$e]===null){C[$e]=ve,Te=$e;break}if(Te===-1)break}let we=P[Te];we&&we.connect(ve)}}function J(ee,xe){xe===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(xe.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let xe=ee.near,ve=ee.far;m.texture!==null&&(m.depthNear>0&&(xe=m.depthNear),m.depthFar>0&&(ve=m.depthFar)),X.near=D.near=U.near=xe,X.far=D.far=U.far=ve,(I!==X.near||V!==X.far)&&(s.updateRenderState({depthNear:X.near,depthFar:X.far}),I=X.near,V=X.far),X.layers.mask=ee.layers.mask|6,U.layers.mask=X.layers.mask&-5,D.layers.mask=X.layers.mask&-3;let Te=ee.parent,we=X.cameras;J(X,Te);for(let $e=0;$e<we.length;$e++)J(we[$e],Te);X.projectionMatrix.copy(U.projectionMatrix),X.projectionMatrixInverse.copy(U.projectionMatrixInverse),z===null&&ee.isPerspectiveCamera&&(z={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,X,Te)};function Q(ee,xe,ve){ve===null?ee.matrix.copy(xe.matrixWorld):(ee.matrix.copy(ve.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(xe.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(xe.projectionMatrix),ee.projectionMatrixInverse.copy(xe.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=ol*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return X},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(ee){l=ee,u!==null&&(u.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(X)},this.getCameraTexture=function(ee){return p[ee]};let se=null;function oe(ee,xe){if(h=xe.getViewerPose(c||a),g=xe,h!==null){let ve=h.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Te=!1;ve.length!==X.cameras.length&&(X.cameras.length=0,Te=!0);for(let Xe=0;Xe<ve.length;Xe++){let ut=ve[Xe],dt=null;if(f!==null)dt=f.getViewport(ut);else{let kt=d.getViewSubImage(u,ut);dt=kt.viewport,Xe===0&&(e.setRenderTargetTextures(b,kt.colorTexture,kt.depthStencilTexture),e.setRenderTarget(b))}let rt=W[Xe];rt===void 0&&(rt=new ai,rt.layers.enable(Xe),rt.viewport=new Qt,W[Xe]=rt),rt.matrix.fromArray(ut.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(ut.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(dt.x,dt.y,dt.width,dt.height),Xe===0&&(X.matrix.copy(rt.matrix),X.matrix.decompose(X.position,X.quaternion,X.scale)),Te===!0&&X.cameras.push(rt)}let we=s.enabledFeatures;if(we&&we.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){d=n.getBinding();let Xe=d.getDepthInformation(ve[0]);Xe&&Xe.isValid&&Xe.texture&&m.init(Xe,s.renderState)}if(we&&we.includes("camera-access")&&y){e.state.unbindTexture(),d=n.getBinding();for(let Xe=0;Xe<ve.length;Xe++){let ut=ve[Xe].camera;if(ut){let dt=p[ut];dt||(dt=new ka,p[ut]=dt);let rt=d.getCameraImage(ut);dt.sourceTexture=rt}}}}for(let ve=0;ve<P.length;ve++){let Te=C[ve],we=P[ve];Te!==null&&we!==void 0&&we.update(Te,xe,c||a)}se&&se(ee,xe),xe.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:xe}),g=null}let fe=new Lm;fe.setAnimationLoop(oe),this.setAnimationLoop=function(ee){se=ee},this.dispose=function(){}}},$S=new rn,Gm=new lt;Gm.set(-1,0,0,0,1,0,0,0,1);function ZS(i,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,Eu(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,v,T,b){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),d(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),u(m,p),p.isMeshPhysicalMaterial&&f(m,p,b)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),y(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(a(m,p),p.isLineDashedMaterial&&o(m,p)):p.isPointsMaterial?l(m,p,v,T):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Hn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Hn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let v=e.get(p),T=v.envMap,b=v.envMapRotation;T&&(m.envMap.value=T,m.envMapRotation.value.setFromMatrix4($S.makeRotationFromEuler(b)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Gm),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function a(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function o(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,v,T){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*v,m.scale.value=T*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function d(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function u(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,v){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Hn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function y(m,p){let v=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function JS(i,e,t,n){let s={},r={};function a(v,T){let b=T.program;n.uniformBlockBinding(v,b,s[v.id])}function o(v,T){let b=s[v.id];b===void 0&&(g(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",m));let P=T.program;n.updateUBOMapping(v,P);let C=e.render.frame;r[v.id]!==C&&(c(v),r[v.id]=C)}function l(v){let T=i.createBuffer(),b=v.__size,P=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,T),i.bufferData(i.UNIFORM_BUFFER,b,P),i.bindBuffer(i.UNIFORM_BUFFER,null),T}function c(v){let T=s[v.id],b=v.uniforms,P=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let C=0,x=b.length;C<x;C++){let A=b[C];if(Array.isArray(A))for(let z=0,U=A.length;z<U;z++)h(A[z],C,z,P);else h(A,C,0,P)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,T,b,P){if(u(v,T,b,P)===!0){let C=v.__offset,x=v.value;if(Array.isArray(x)){let A=0;for(let z=0;z<x.length;z++){let U=x[z],D=y(U,!0);d(U,v.__data,A),A+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else d(x,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,C,v.__data)}}function d(v,T,b){typeof v=="number"||typeof v=="boolean"?T[b]=v:v.isMatrix3?(T[b]=v.elements[0],T[b+1]=v.elements[1],T[b+2]=v.elements[2],T[b+3]=0,T[b+4]=v.elements[3],T[b+5]=v.elements[4],T[b+6]=v.elements[5],T[b+7]=0,T[b+8]=v.elements[6],T[b+9]=v.elements[7],T[b+10]=v.elements[8],T[b+11]=0):ArrayBuffer.isView(v)?T.set(v.subarray(0,T.length-b),b):v.toArray(T,b)}function u(v,T,b,P){let C=v.value,x=T+"_"+b;if(Array.isArray(C)){P[x]===void 0&&(P[x]=[]);let A=P[x],z=!1;for(let U=0;U<C.length;U++)f(C[U],A,U)===!0&&(z=!0);return z}return f(C,P,x)}function f(v,T,b){if(T[b]===void 0)return typeof v=="number"||typeof v=="boolean"?T[b]=v:ArrayBuffer.isView(v)?T[b]=v.slice():T[b]=v.clone(),!0;{let P=T[b];if(typeof v=="number"||typeof v=="boolean"){if(P!==v)return T[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(P.equals(v)===!1)return P.copy(v),!0}}return!1}function g(v){let T=v.uniforms,b=0,P=16;for(let x=0,A=T.length;x<A;x++){let z=Array.isArray(T[x])?T[x]:[T[x]];for(let U=0,D=z.length;U<D;U++){let W=z[U],X=Array.isArray(W.value)?W.value:[W.value],I=Array.isArray(T[x])||Array.isArray(W.value),V=b;for(let B=0,ue=X.length;B<ue;B++){let J=X[B],Q=y(J,I),se=b%P,oe=se%Q.boundary,fe=se+oe;b+=oe,fe!==0&&P-fe<Q.storage&&(b+=P-fe),B===0&&(V=b),b+=Q.storage}let Z=W.type==="int"?Int32Array:W.type==="uint"?Uint32Array:Float32Array;W.__data=new Z((b-V)/Float32Array.BYTES_PER_ELEMENT),W.__offset=V}}let C=b%P;return C>0&&(b+=P-C),v.__size=b,v.__cache={},this}function y(v,T){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?nt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):nt("WebGLRenderer: Unsupported uniform value type.",v),T===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(v){let T=v.target;T.removeEventListener("dispose",m),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:a,update:o,dispose:p}}var KS=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Yi=null;function jS(){return Yi===null&&(Yi=new dl(KS,16,16,zs,Ii),Yi.name="DFG_LUT",Yi.minFilter=Gn,Yi.magFilter=Gn,Yi.wrapS=zi,Yi.wrapT=zi,Yi.generateMipmaps=!1,Yi.needsUpdate=!0),Yi}var yc=class{constructor(e={}){let{canvas:t=nm(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=hi}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let y=f,m=new Set([zl,kl,Bl]),p=new Set([hi,Ri,ta,or,Fl,Ol]),v=new Uint32Array(4),T=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},P=null,C=null,x=[],A=[],z=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=qi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,D=!1,W=null,X=null,I=null,V=null;this._outputColorSpace=ri;let Z=0,B=0,ue=null,J=-1,Q=null,se=new Qt,oe=new Qt,fe=null,ee=new Et(0),xe=0,ve=t.width,Te=t.height,we=1,$e=null,it=null,Xe=new Qt(0,0,ve,Te),ut=new Qt(0,0,ve,Te),dt=!1,rt=new ir,kt=new fl,Ft=!1,nn=!1,At=new rn,hn=new j,_t=new Qt,an={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Yt=!1;function sn(){return ue===null?we:1}let O=n;function Ie(M,N){return t.getContext(M,N)}let et,at,Ae,It,qe,je,E,S,Y,ce,ae,_e,ye,te,ie,me,F,re,ne,Re,Me,Ee,Be;try{let M={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ve,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),O===null){let N="webgl2";if(O=Ie(N,M),O===null)throw Ie(N)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qe()}catch(M){throw t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),ot("WebGLRenderer: "+M.message),M}function Qe(){et=new cM(O),et.init(),Me=new XS(O,et),at=new jy(O,et,e,Me),Ae=new HS(O,et),at.reversedDepthBuffer&&u&&Ae.buffers.depth.setReversed(!0),X=O.createFramebuffer(),I=O.createFramebuffer(),V=O.createFramebuffer(),It=new dM(O),qe=new RS,je=new WS(O,et,Ae,qe,at,Me,It),E=new lM(U),S=new px(O),Ee=new Jy(O,S),Y=new hM(O,S,It,Ee),ce=new pM(O,Y,S,Ee,It),re=new fM(O,at,je),ie=new Qy(qe),ae=new CS(U,E,et,at,Ee,ie),_e=new ZS(U,qe),ye=new IS,te=new OS(et),F=new Zy(U,E,Ae,ce,g,l),me=new GS(U,ce,at),Be=new JS(O,It,at,Ae),ne=new Ky(O,et,It),Re=new uM(O,et,It),It.programs=ae.programs,U.capabilities=at,U.extensions=et,U.properties=qe,U.renderLists=ye,U.shadowMap=me,U.state=Ae,U.info=It}y!==hi&&(z=new gM(y,t.width,t.height,o,s,r));let he=new Bu(U,O);this.xr=he,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let M=et.get("WEBGL_lose_context");M&&M.loseContext()},this.forceContextRestore=function(){let M=et.get("WEBGL_lose_context");M&&M.restoreContext()},this.getPixelRatio=function(){return we},this.setPixelRatio=function(M){M!==void 0&&(we=M,this.setSize(ve,Te,!1))},this.getSize=function(M){return M.set(ve,Te)},this.setSize=function(M,N,$=!0){if(he.isPresenting){nt("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=M,Te=N,t.width=Math.floor(M*we),t.height=Math.floor(N*we),$===!0&&(t.style.width=M+"px",t.style.height=N+"px"),z!==null&&z.setSize(t.width,t.height),this.setViewport(0,0,M,N)},this.getDrawingBufferSize=function(M){return M.set(ve*we,Te*we).floor()},this.setDrawingBufferSize=function(M,N,$){ve=M,Te=N,we=$,t.width=Math.floor(M*$),t.height=Math.floor(N*$),this.setViewport(0,0,M,N)},this.setEffects=function(M){if(y===hi){ot("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(M){for(let N=0;N<M.length;N++)if(M[N].isOutputPass===!0){nt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}z.setEffects(M||[])},this.getCurrentViewport=function(M){return M.copy(se)},this.getViewport=function(M){return M.copy(Xe)},this.setViewport=function(M,N,$,H){M.isVector4?Xe.set(M.x,M.y,M.z,M.w):Xe.set(M,N,$,H),Ae.viewport(se.copy(Xe).multiplyScalar(sn()).round())},this.getScissor=function(M){return M.copy(ut)},this.setScissor=function(M,N,$,H){M.isVector4?ut.set(M.x,M.y,M.z,M.w):ut.set(M,N,$,H),Ae.scissor(oe.copy(ut).multiplyScalar(sn()).round())},this.getScissorTest=function(){return dt},this.setScissorTest=function(M){Ae.setScissorTest(dt=M)},this.setOpaqueSort=function(M){$e=M},this.setTransparentSort=function(M){it=M},this.getClearColor=function(M){return M.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(M=!0,N=!0,$=!0){let H=0;if(M){let q=!1;if(ue!==null){let de=ue.texture.format;q=m.has(de)}if(q){let de=ue.texture.type,Se=p.has(de),be=F.getClearColor(),Le=F.getClearAlpha(),Fe=be.r,Je=be.g,ft=be.b;Se?(v[0]=Fe,v[1]=Je,v[2]=ft,v[3]=Le,O.clearBufferuiv(O.COLOR,0,v)):(T[0]=Fe,T[1]=Je,T[2]=ft,T[3]=Le,O.clearBufferiv(O.COLOR,0,T))}else H|=O.COLOR_BUFFER_BIT}N&&(H|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),$&&(H|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),H!==0&&O.clear(H)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(M){M.setRenderer(this),W=M},this.dispose=function(){t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),F.dispose(),ye.dispose(),te.dispose(),je.dispose(),qe.dispose(),E.dispose(),ce.dispose(),Y.dispose(),Ee.dispose(),Be.dispose(),ae.dispose(),he.dispose(),he.removeEventListener("sessionstart",Ki),he.removeEventListener("sessionend",Un),ui.stop()};function Ve(M){M.preventDefault(),bu("WebGLRenderer: Context Lost."),D=!0}function tt(){bu("WebGLRenderer: Context Restored."),D=!1;let M=It.autoReset,N=me.enabled,$=me.autoUpdate,H=me.needsUpdate,q=me.type;Qe(),It.autoReset=M,me.enabled=N,me.autoUpdate=$,me.needsUpdate=H,me.type=q}function Pe(M){ot("WebGLRenderer: A WebGL context could not be created. Reason: ",M.statusMessage)}function ct(M){let N=M.target;N.removeEventListener("dispose",ct),Ht(N)}function Ht(M){Rn(M),qe.remove(M)}function Rn(M){let N=qe.get(M).programs;N!==void 0&&(N.forEach(function($){ae.releaseProgram($)}),M.isShaderMaterial&&ae.releaseShaderCache(M))}this.renderBufferDirect=function(M,N,$,H,q,de){N===null&&(N=an);let Se=q.isMesh&&q.matrixWorld.determinantAffine()<0,be=Ne(M,N,$,H,q);Ae.setMaterial(H,Se);let Le=$.index,Fe=1;if(H.wireframe===!0){if(Le=Y.getWireframeAttribute($),Le===void 0)return;Fe=2}let Je=$.drawRange,ft=$.attributes.position,Oe=Je.start*Fe,pt=(Je.start+Je.count)*Fe;de!==null&&(Oe=Math.max(Oe,de.start*Fe),pt=Math.min(pt,(de.start+de.count)*Fe)),Le!==null?(Oe=Math.max(Oe,0),pt=Math.min(pt,Le.count)):ft!=null&&(Oe=Math.max(Oe,0),pt=Math.min(pt,ft.count));let zt=pt-Oe;if(zt<0||zt===1/0)return;Ee.setup(q,H,be,$,Le);let Tt,xt=ne;if(Le!==null&&(Tt=S.get(Le),xt=Re,xt.setIndex(Tt)),q.isMesh)H.wireframe===!0?(Ae.setLineWidth(H.wireframeLinewidth*sn()),xt.setMode(O.LINES)):xt.setMode(O.TRIANGLES);else if(q.isLine){let un=H.linewidth;un===void 0&&(un=1),Ae.setLineWidth(un*sn()),q.isLineSegments?xt.setMode(O.LINES):q.isLineLoop?xt.setMode(O.LINE_LOOP):xt.setMode(O.LINE_STRIP)}else q.isPoints?xt.setMode(O.POINTS):q.isSprite&&xt.setMode(O.TRIANGLES);if(q.isBatchedMesh)if(et.get("WEBGL_multi_draw"))xt.renderMultiDraw(q._multiDrawStarts,q._multiDrawCounts,q._multiDrawCount);else{let un=q._multiDrawStarts,Ge=q._multiDrawCounts,fn=q._multiDrawCount,yt=Le?S.get(Le).bytesPerElement:1,Qi=qe.get(H).currentProgram.getUniforms();for(let pn=0;pn<fn;pn++)Qi.setValue(O,"_gl_DrawID",pn),xt.render(un[pn]/yt,Ge[pn])}else if(q.isInstancedMesh)xt.renderInstances(Oe,zt,q.count);else if($.isInstancedBufferGeometry){let un=$._maxInstanceCount!==void 0?$._maxInstanceCount:1/0,Ge=Math.min($.instanceCount,un);xt.renderInstances(Oe,zt,Ge)}else xt.render(Oe,zt)};function _s(M,N,$,H){W!==null&&M.isNodeMaterial&&W.setObject(H,M),Ft===!0&&ie.setState(M,$,!1),M.transparent===!0&&M.side===Xi&&M.forceSinglePass===!1?(M.side=Hn,M.needsUpdate=!0,Jn(M,N,H),M.side=ks,M.needsUpdate=!0,Jn(M,N,H),M.side=Xi):Jn(M,N,H)}this.compile=function(M,N,$=null){$===null&&($=M),W!==null&&W.renderStart(M,N,$),C=te.get($),C.init(N),A.push(C),$.traverseVisible(function(q){q.isLight&&q.layers.test(N.layers)&&(C.pushLight(q),q.castShadow&&C.pushShadow(q))}),M!==$&&M.traverseVisible(function(q){q.isLight&&q.layers.test(N.layers)&&(C.pushLight(q),q.castShadow&&C.pushShadow(q))}),C.setupLights(),W!==null&&W.updateLights(C.state.lightsArray),nn=this.localClippingEnabled,Ft=ie.init(this.clippingPlanes,nn),Ft===!0&&ie.setGlobalState(this.clippingPlanes,N),W!==null&&me.render(C.state.shadowsArray,$,N);let H=new Set;return M.traverse(function(q){if(!(q.isMesh||q.isPoints||q.isLine||q.isSprite))return;let de=q.material;if(de)if(Array.isArray(de))for(let Se=0;Se<de.length;Se++){let be=de[Se];_s(be,$,N,q),H.add(be)}else _s(de,$,N,q),H.add(de)}),C=A.pop(),W!==null&&W.renderEnd(),H},this.compileAsync=function(M,N,$=null){let H=this.compile(M,N,$);return new Promise(q=>{function de(){if(H.forEach(function(Se){let Le=qe.get(Se).currentProgram;(Le===void 0||Le.isReady())&&H.delete(Se)}),H.size===0){q(M);return}setTimeout(de,10)}et.get("KHR_parallel_shader_compile")!==null?de():setTimeout(de,10)})};let Zi=null;function Ji(M){Zi&&Zi(M)}function Ki(){ui.stop()}function Un(){ui.start()}let ui=new Lm;ui.setAnimationLoop(Ji),typeof self<"u"&&ui.setContext(self),this.setAnimationLoop=function(M){Zi=M,he.setAnimationLoop(M),M===null?ui.stop():ui.start()},he.addEventListener("sessionstart",Ki),he.addEventListener("sessionend",Un),this.render=function(M,N){if(N!==void 0&&N.isCamera!==!0){ot("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;W!==null&&W.renderStart(M,N);let $=he.enabled===!0&&he.isPresenting===!0,H=z!==null&&(ue===null||$)&&z.begin(U,ue);if(M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(z===null||z.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(N),N=he.getCamera()),M.isScene===!0&&M.onBeforeRender(U,M,N,ue),C=te.get(M,A.length),C.init(N),C.state.textureUnits=je.getTextureUnits(),A.push(C),At.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),N.isArrayCamera?kt.setFromArrayCamera(N):rt.setFromProjectionMatrix(At,xi,N.reversedDepth),nn=this.localClippingEnabled,Ft=ie.init(this.clippingPlanes,nn),P=ye.get(M,x.length),P.init(),x.push(P),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Se=U.xr.getDepthSensingMesh();Se!==null&&di(Se,N,-1/0,U.sortObjects)}di(M,N,0,U.sortObjects),P.finish(),W!==null&&W.updateLights(C.state.lightsArray),U.sortObjects===!0&&P.sort($e,it),Yt=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,Yt&&F.addToRenderList(P,M),this.info.autoReset===!0&&this.info.reset(),Ft===!0&&ie.beginShadows();let q=C.state.shadowsArray;if(me.render(q,M,N),Ft===!0&&ie.endShadows(),(H&&z.hasRenderPass())===!1){let Se=P.opaque,be=P.transmissive;if(C.setupLights(),N.isArrayCamera){let Le=N.cameras;if(be.length>0)for(let Fe=0,Je=Le.length;Fe<Je;Fe++){let ft=Le[Fe];Wn(Se,be,M,ft)}Yt&&F.render(M);for(let Fe=0,Je=Le.length;Fe<Je;Fe++){let ft=Le[Fe];ji(P,M,ft,ft.viewport)}}else be.length>0&&Wn(Se,be,M,N),Yt&&F.render(M),ji(P,M,N)}ue!==null&&B===0&&(je.updateMultisampleRenderTarget(ue),je.updateRenderTargetMipmap(ue)),H&&z.end(U),M.isScene===!0&&M.onAfterRender(U,M,N),Ee.resetDefaultState(),J=-1,Q=null,A.pop(),A.length>0?(C=A[A.length-1],je.setTextureUnits(C.state.textureUnits),Ft===!0&&ie.setGlobalState(U.clippingPlanes,C.state.camera)):C=null,x.pop(),x.length>0?P=x[x.length-1]:P=null,W!==null&&W.renderEnd()};function di(M,N,$,H){if(M.visible===!1)return;if(M.layers.test(N.layers)){if(M.isGroup)$=M.renderOrder;else if(M.isLOD)M.autoUpdate===!0&&M.update(N);else if(M.isLight)C.pushLight(M),M.castShadow&&C.pushShadow(M);else if(M.isSprite){let Se=N.isArrayCamera?kt:rt;if(!M.frustumCulled||M.intersectsFrustum(Se)){H&&_t.setFromMatrixPosition(M.matrixWorld).applyMatrix4(At);let be=ce.update(M),Le=M.material;Le.visible&&P.push(M,be,Le,$,_t.z,null,N)}}else if(M.isMesh||M.isLine||M.isPoints){let Se=N.isArrayCamera?kt:rt;if(!M.frustumCulled||M.intersectsFrustum(Se)){let be=ce.update(M),Le=M.material;if(H&&(M.boundingSphere!==void 0?(M.boundingSphere===null&&M.computeBoundingSphere(),_t.copy(M.boundingSphere.center)):(be.boundingSphere===null&&be.computeBoundingSphere(),_t.copy(be.boundingSphere.center)),_t.applyMatrix4(M.matrixWorld).applyMatrix4(At)),Array.isArray(Le)){let Fe=be.groups;for(let Je=0,ft=Fe.length;Je<ft;Je++){let Oe=Fe[Je],pt=Le[Oe.materialIndex];pt&&pt.visible&&P.push(M,be,pt,$,_t.z,Oe,N)}}else Le.visible&&P.push(M,be,Le,$,_t.z,null,N)}}}let de=M.children;for(let Se=0,be=de.length;Se<be;Se++)di(de[Se],N,$,H)}function ji(M,N,$,H){let{opaque:q,transmissive:de,transparent:Se}=M;C.setupLightsView($),Ft===!0&&ie.setGlobalState(U.clippingPlanes,$),H&&Ae.viewport(se.copy(H)),q.length>0&&Ot(q,N,$),de.length>0&&Ot(de,N,$),Se.length>0&&Ot(Se,N,$),Ae.buffers.depth.setTest(!0),Ae.buffers.depth.setMask(!0),Ae.buffers.color.setMask(!0),Ae.setPolygonOffset(!1)}function Wn(M,N,$,H){if(($.isScene===!0?$.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[H.id]===void 0){let Oe=et.has("EXT_color_buffer_half_float")||et.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[H.id]=new oi(1,1,{generateMipmaps:!0,type:Oe?Ii:hi,minFilter:ds,samples:Math.max(4,at.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let de=C.state.transmissionRenderTarget[H.id],Se=H.viewport||se;de.setSize(Se.z*U.transmissionResolutionScale,Se.w*U.transmissionResolutionScale);let be=U.getRenderTarget(),Le=U.getActiveCubeFace(),Fe=U.getActiveMipmapLevel();U.setRenderTarget(de),U.getClearColor(ee),xe=U.getClearAlpha(),xe<1&&U.setClearColor(16777215,.5),U.clear(),Yt&&F.render($);let Je=U.toneMapping;U.toneMapping=qi;let ft=H.viewport;if(H.viewport!==void 0&&(H.viewport=void 0),C.setupLightsView(H),Ft===!0&&ie.setGlobalState(U.clippingPlanes,H),Ot(M,$,H),je.updateMultisampleRenderTarget(de),je.updateRenderTargetMipmap(de),et.has("WEBGL_multisampled_render_to_texture")===!1){let Oe=!1;for(let pt=0,zt=N.length;pt<zt;pt++){let Tt=N[pt],{object:xt,geometry:un,material:Ge,group:fn}=Tt;if(Ge.side===Xi&&xt.layers.test(H.layers)){let yt=Ge.side;Ge.side=Hn,Ge.needsUpdate=!0,qt(xt,$,H,un,Ge,fn),Ge.side=yt,Ge.needsUpdate=!0,Oe=!0}}Oe===!0&&(je.updateMultisampleRenderTarget(de),je.updateRenderTargetMipmap(de))}U.setRenderTarget(be,Le,Fe),U.setClearColor(ee,xe),ft!==void 0&&(H.viewport=ft),U.toneMapping=Je}function Ot(M,N,$){let H=N.isScene===!0?N.overrideMaterial:null;for(let q=0,de=M.length;q<de;q++){let Se=M[q],{object:be,geometry:Le,group:Fe}=Se,Je=Se.material;Je.allowOverride===!0&&H!==null&&(Je=H),be.layers.test($.layers)&&qt(be,N,$,Le,Je,Fe)}}function qt(M,N,$,H,q,de){W!==null&&q.isNodeMaterial&&W.setObject(M,q),M.onBeforeRender(U,N,$,H,q,de),M.modelViewMatrix.multiplyMatrices($.matrixWorldInverse,M.matrixWorld),M.normalMatrix.getNormalMatrix(M.modelViewMatrix),q.onBeforeRender(U,N,$,H,M,de),q.transparent===!0&&q.side===Xi&&q.forceSinglePass===!1?(q.side=Hn,q.needsUpdate=!0,U.renderBufferDirect($,N,H,q,M,de),q.side=ks,q.needsUpdate=!0,U.renderBufferDirect($,N,H,q,M,de),q.side=Xi):U.renderBufferDirect($,N,H,q,M,de),M.onAfterRender(U,N,$,H,q,de)}function en(M){let N=0;for(let $ of M)$.texture!==null&&N++;return N}function Jn(M,N,$){N.isScene!==!0&&(N=an);let H=qe.get(M),q=C.state.lights,de=C.state.shadowsArray,Se=q.state.version,be=ae.getParameters(M,q.state,de,N,$,C.state.lightProbeGridArray),Le=ae.getProgramCacheKey(be),Fe=H.programs;H.environment=M.isMeshStandardMaterial||M.isMeshLambertMaterial||M.isMeshPhongMaterial?N.environment:null,H.fog=N.fog;let Je=M.isMeshStandardMaterial||M.isMeshLambertMaterial&&!M.envMap||M.isMeshPhongMaterial&&!M.envMap;H.envMap=E.get(M.envMap||H.environment,Je),H.envMapRotation=H.environment!==null&&M.envMap===null?N.environmentRotation:M.envMapRotation,Fe===void 0&&(M.addEventListener("dispose",ct),Fe=new Map,H.programs=Fe,H.programVariants=new Map);let ft=Fe.get(Le);if(ft!==void 0){if(H.currentProgram===ft&&H.lightsStateVersion===Se)return pe(M,be),ft}else be.uniforms=ae.getUniforms(M),W!==null&&M.isNodeMaterial&&W.build(M,$,be),M.onBeforeCompile(be,U),ft=ae.acquireProgram(be,Le),Fe.set(Le,ft),H.uniforms=be.uniforms;let Oe=H.uniforms;return(!M.isShaderMaterial&&!M.isRawShaderMaterial||M.clipping===!0)&&(Oe.clippingPlanes=ie.uniform),pe(M,be),H.needsLights=De(M),H.lightsStateVersion=Se,H.needsLights&&(Oe.ambientLightColor.value=q.state.ambient,Oe.lightProbe.value=q.state.probe,Oe.sunLights.value=q.state.sun,Oe.sunLightShadows.value=q.state.sunShadow,Oe.directionalLights.value=q.state.directional,Oe.directionalLightShadows.value=q.state.directionalShadow,Oe.spotLights.value=q.state.spot,Oe.spotLightShadows.value=q.state.spotShadow,Oe.rectAreaLights.value=q.state.rectArea,Oe.ltc_1.value=q.state.rectAreaLTC1,Oe.ltc_2.value=q.state.rectAreaLTC2,Oe.pointLights.value=q.state.point,Oe.pointLightShadows.value=q.state.pointShadow,Oe.hemisphereLights.value=q.state.hemi,Oe.sunShadowMatrix.value=q.state.sunShadowMatrix,Oe.sunShadowCascade.value=q.state.sunShadowCascade,Oe.directionalShadowMatrix.value=q.state.directionalShadowMatrix,Oe.spotLightMatrix.value=q.state.spotLightMatrix,Oe.spotLightMap.value=q.state.spotLightMap,Oe.pointShadowMatrix.value=q.state.pointShadowMatrix),H.numLightProbeGrids=en(C.state.lightProbeGridArray),H.currentProgram=ft,H.uniformsList=null,ft}function Fn(M,N,$,H,q){let de=qe.get(M),Se=de.currentProgram.id+","+H+","+q,be=de.programVariants.get(Se);return be===void 0?(be=Jn(M,N,$),de.programVariants.set(Se,be)):(de.currentProgram=be,de.uniformsList=null,de.outputColorSpace=H,de.toneMapping=q),be}function G(M){if(M.uniformsList===null){let N=M.currentProgram.getUniforms();M.uniformsList=na.seqWithValue(N.seq,M.uniforms)}return M.uniformsList}function pe(M,N){let $=qe.get(M);$.outputColorSpace=N.outputColorSpace,$.batching=N.batching,$.batchingColor=N.batchingColor,$.instancing=N.instancing,$.instancingColor=N.instancingColor,$.instancingMorph=N.instancingMorph,$.skinning=N.skinning,$.morphTargets=N.morphTargets,$.morphNormals=N.morphNormals,$.morphColors=N.morphColors,$.morphTargetsCount=N.morphTargetsCount,$.numClippingPlanes=N.numClippingPlanes,$.numIntersection=N.numClipIntersection,$.vertexAlphas=N.vertexAlphas,$.vertexTangents=N.vertexTangents,$.toneMapping=N.toneMapping}function Ne(M,N,$,H,q){N.isScene!==!0&&(N=an),je.resetTextureUnits();let de=N.fog,Se=H.isMeshStandardMaterial||H.isMeshLambertMaterial||H.isMeshPhongMaterial?N.environment:null,be=ue===null?U.outputColorSpace:ue.isXRRenderTarget===!0?ue.texture.colorSpace:St.workingColorSpace,Le=H.isMeshStandardMaterial||H.isMeshLambertMaterial&&!H.envMap||H.isMeshPhongMaterial&&!H.envMap,Fe=E.get(H.envMap||Se,Le),Je=H.vertexColors===!0&&!!$.attributes.color&&$.attributes.color.itemSize===4,ft=!!$.attributes.tangent&&(!!H.normalMap||H.anisotropy>0),Oe=!!$.morphAttributes.position,pt=!!$.morphAttributes.normal,zt=!!$.morphAttributes.color,Tt=qi;H.toneMapped&&(ue===null||ue.isXRRenderTarget===!0)&&(Tt=U.toneMapping);let xt=$.morphAttributes.position||$.morphAttributes.normal||$.morphAttributes.color,un=xt!==void 0?xt.length:0,Ge=qe.get(H),fn=C.state.lights;if(Ft===!0&&(nn===!0||M!==Q)){let Bt=M===Q&&H.id===J;ie.setState(H,M,Bt)}let yt=!1,Qi=!1;H.version===Ge.__version?Ge.needsLights&&Ge.lightsStateVersion!==fn.state.version||q.isBatchedMesh&&Ge.batching===!1||!q.isBatchedMesh&&Ge.batching===!0||q.isBatchedMesh&&Ge.batchingColor===!0&&q._colorsTexture===null||q.isBatchedMesh&&Ge.batchingColor===!1&&q._colorsTexture!==null||q.isInstancedMesh&&Ge.instancing===!1||!q.isInstancedMesh&&Ge.instancing===!0||q.isSkinnedMesh&&Ge.skinning===!1||!q.isSkinnedMesh&&Ge.skinning===!0||q.isInstancedMesh&&Ge.instancingColor===!0&&q.instanceColor===null||q.isInstancedMesh&&Ge.instancingColor===!1&&q.instanceColor!==null||q.isInstancedMesh&&Ge.instancingMorph===!0&&q.morphTexture===null||q.isInstancedMesh&&Ge.instancingMorph===!1&&q.morphTexture!==null||Ge.envMap!==Fe||H.fog===!0&&Ge.fog!==de||Ge.numClippingPlanes!==void 0&&(Ge.numClippingPlanes!==ie.numPlanes||Ge.numIntersection!==ie.numIntersection)||Ge.vertexAlphas!==Je||Ge.vertexTangents!==ft||Ge.morphTargets!==Oe||Ge.morphNormals!==pt||Ge.morphColors!==zt||Ge.morphTargetsCount!==un||Ge.numLightProbeGrids!==en(C.state.lightProbeGridArray)?yt=!0:(Ge.outputColorSpace!==be||Ge.toneMapping!==Tt)&&(Qi=!0):(yt=!0,Ge.__version=H.version);let pn=Ge.currentProgram;(yt===!0||Qi===!0)&&(pn=Qi===!0?Fn(H,N,q,be,Tt):Jn(H,N,q),W&&H.isNodeMaterial&&W.onUpdateProgram(H,pn,Ge));let cr=!1,Ni=!1,es=!1,mt=pn.getUniforms(),on=Ge.uniforms;if(Ae.useProgram(pn.program)&&(cr=!0,Ni=!0,es=!0),H.id!==J&&(J=H.id,Ni=!0),cr||Q!==M){Ae.buffers.depth.getReversed()&&M.reversedDepth!==!0&&(M._reversedDepth=!0,M.updateProjectionMatrix()),mt.setValue(O,"projectionMatrix",M.projectionMatrix),mt.setValue(O,"viewMatrix",M.matrixWorldInverse);let mn=mt.map.cameraPosition;mn!==void 0&&mn.setValue(O,hn.setFromMatrixPosition(M.matrixWorld)),at.logarithmicDepthBuffer&&mt.setValue(O,"logDepthBufFC",2/(Math.log(M.far+1)/Math.LN2)),(H.isMeshPhongMaterial||H.isMeshToonMaterial||H.isMeshLambertMaterial||H.isMeshBasicMaterial||H.isMeshStandardMaterial||H.isShaderMaterial)&&mt.setValue(O,"isOrthographic",M.isOrthographicCamera===!0),Q!==M&&(Q=M,Ni=!0,es=!0)}if(Ge.needsLights&&(fn.state.sunShadowMap.length>0&&mt.setValue(O,"sunShadowMap",fn.state.sunShadowMap,je),fn.state.directionalShadowMap.length>0&&mt.setValue(O,"directionalShadowMap",fn.state.directionalShadowMap,je),fn.state.spotShadowMap.length>0&&mt.setValue(O,"spotShadowMap",fn.state.spotShadowMap,je),fn.state.pointShadowMap.length>0&&mt.setValue(O,"pointShadowMap",fn.state.pointShadowMap,je)),q.isSkinnedMesh){mt.setOptional(O,q,"bindMatrix"),mt.setOptional(O,q,"bindMatrixInverse");let Bt=q.skeleton;Bt&&(Bt.boneTexture===null&&Bt.computeBoneTexture(),mt.setValue(O,"boneTexture",Bt.boneTexture,je))}q.isBatchedMesh&&(mt.setOptional(O,q,"batchingTexture"),mt.setValue(O,"batchingTexture",q._matricesTexture,je),mt.setOptional(O,q,"batchingIdTexture"),mt.setValue(O,"batchingIdTexture",q._indirectTexture,je),mt.setOptional(O,q,"batchingColorTexture"),q._colorsTexture!==null&&mt.setValue(O,"batchingColorTexture",q._colorsTexture,je));let On=$.morphAttributes;if((On.position!==void 0||On.normal!==void 0||On.color!==void 0)&&re.update(q,$,pn),(Ni||Ge.receiveShadow!==q.receiveShadow)&&(Ge.receiveShadow=q.receiveShadow,mt.setValue(O,"receiveShadow",q.receiveShadow)),(H.isMeshStandardMaterial||H.isMeshLambertMaterial||H.isMeshPhongMaterial)&&H.envMap===null&&N.environment!==null&&(on.envMapIntensity.value=N.environmentIntensity),on.dfgLUT!==void 0&&(on.dfgLUT.value=jS()),Ni){if(mt.setValue(O,"toneMappingExposure",U.toneMappingExposure),Ge.needsLights&&He(on,es),de&&H.fog===!0&&_e.refreshFogUniforms(on,de),_e.refreshMaterialUniforms(on,H,we,Te,C.state.transmissionRenderTarget[M.id]),Ge.needsLights&&Ge.numLightProbeGrids>0){let Bt=b,mn=0;for(let In of C.state.lightProbeGridArray)In.texture!==null&&(Bt.textures[mn]=In.texture,Bt.min[mn]=In.boundingBox.min,Bt.max[mn]=In.boundingBox.max,Bt.resolution[mn]=In.resolution,mn++);for(let In in Bt)Bt[In].length=mn;on.probesSH.value=Bt.textures,on.probesMin.value=Bt.min,on.probesMax.value=Bt.max,on.probesResolution.value=Bt.resolution}na.upload(O,G(Ge),on,je)}if(H.isShaderMaterial&&H.uniformsNeedUpdate===!0&&(na.upload(O,G(Ge),on,je),H.uniformsNeedUpdate=!1),H.isSpriteMaterial&&mt.setValue(O,"center",q.center),mt.setValue(O,"modelViewMatrix",q.modelViewMatrix),mt.setValue(O,"normalMatrix",q.normalMatrix),mt.setValue(O,"modelMatrix",q.matrixWorld),H.uniformsGroups!==void 0){let Bt=H.uniformsGroups;for(let mn=0,In=Bt.length;mn<In;mn++){let ro=Bt[mn];Be.update(ro,pn),Be.bind(ro,pn)}}return pn}function He(M,N){M.ambientLightColor.needsUpdate=N,M.lightProbe.needsUpdate=N,M.sunLights.needsUpdate=N,M.sunLightShadows.needsUpdate=N,M.directionalLights.needsUpdate=N,M.directionalLightShadows.needsUpdate=N,M.pointLights.needsUpdate=N,M.pointLightShadows.needsUpdate=N,M.spotLights.needsUpdate=N,M.spotLightShadows.needsUpdate=N,M.rectAreaLights.needsUpdate=N,M.hemisphereLights.needsUpdate=N}function De(M){return M.isMeshLambertMaterial||M.isMeshToonMaterial||M.isMeshPhongMaterial||M.isMeshStandardMaterial||M.isShadowMaterial||M.isShaderMaterial&&M.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return ue},this.setRenderTargetTextures=function(M,N,$){let H=qe.get(M);H.__autoAllocateDepthBuffer=M.resolveDepthBuffer===!1,H.__autoAllocateDepthBuffer===!1&&(H.__useRenderToTexture=!1),qe.get(M.texture).__webglTexture=N,qe.get(M.depthTexture).__webglTexture=H.__autoAllocateDepthBuffer?void 0:$,H.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(M,N){let $=qe.get(M);$.__webglFramebuffer=N,$.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(M,N=0,$=0){ue=M,Z=N,B=$;let H=null,q=!1,de=!1;if(M){let be=qe.get(M);if(be.__useDefaultFramebuffer!==void 0){Ae.bindFramebuffer(O.FRAMEBUFFER,be.__webglFramebuffer),se.copy(M.viewport),oe.copy(M.scissor),fe=M.scissorTest,Ae.viewport(se),Ae.scissor(oe),Ae.setScissorTest(fe),J=-1;return}else if(be.__webglFramebuffer===void 0)je.setupRenderTarget(M);else if(be.__hasExternalTextures)je.rebindTextures(M,qe.get(M.texture).__webglTexture,qe.get(M.depthTexture).__webglTexture);else if(M.depthBuffer){let Je=M.depthTexture;if(be.__boundDepthTexture!==Je){if(Je!==null&&qe.has(Je)&&(M.width!==Je.image.width||M.height!==Je.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");je.setupDepthRenderbuffer(M)}}let Le=M.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(de=!0);let Fe=qe.get(M).__webglFramebuffer;M.isWebGLCubeRenderTarget?(Array.isArray(Fe[N])?H=Fe[N][$]:H=Fe[N],q=!0):M.samples>0&&je.useMultisampledRTT(M)===!1?H=qe.get(M).__webglMultisampledFramebuffer:Array.isArray(Fe)?H=Fe[$]:H=Fe,se.copy(M.viewport),oe.copy(M.scissor),fe=M.scissorTest}else se.copy(Xe).multiplyScalar(we).floor(),oe.copy(ut).multiplyScalar(we).floor(),fe=dt;if($!==0&&(H=X),Ae.bindFramebuffer(O.FRAMEBUFFER,H)&&Ae.drawBuffers(M,H),Ae.viewport(se),Ae.scissor(oe),Ae.setScissorTest(fe),q){let be=qe.get(M.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+N,be.__webglTexture,$)}else if(de){let be=N;for(let Le=0;Le<M.textures.length;Le++){let Fe=qe.get(M.textures[Le]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Le,Fe.__webglTexture,$,be)}}else if(M!==null&&$!==0){let be=qe.get(M.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,be.__webglTexture,$)}J=-1};function Ze(M){let N=qe.get(M);return(N.__readFormat!==M.format||N.__readType!==M.type)&&(N.__readFormat=M.format,N.__readType=M.type,N.__formatReadable=at.textureFormatReadable(M.format),N.__typeReadable=at.textureTypeReadable(M.type)),N}this.readRenderTargetPixels=function(M,N,$,H,q,de,Se,be=0){if(!(M&&M.isWebGLRenderTarget)){ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=qe.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&Se!==void 0&&(Le=Le[Se],Array.isArray(Le)&&(Le=Le[0])),Le){Ae.bindFramebuffer(O.FRAMEBUFFER,Le);try{let Fe=M.textures[be],Je=Fe.format,ft=Fe.type;M.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+be);let Oe=Ze(Fe);if(Oe.__formatReadable===!1){ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Oe.__typeReadable===!1){ot("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=M.width-H&&$>=0&&$<=M.height-q&&O.readPixels(N,$,H,q,Me.convert(Je),Me.convert(ft),de)}finally{let Fe=ue!==null?qe.get(ue).__webglFramebuffer:null;Ae.bindFramebuffer(O.FRAMEBUFFER,Fe)}}},this.readRenderTargetPixelsAsync=async function(M,N,$,H,q,de,Se,be=0){if(!(M&&M.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=qe.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&Se!==void 0&&(Le=Le[Se],Array.isArray(Le)&&(Le=Le[0])),Le)if(N>=0&&N<=M.width-H&&$>=0&&$<=M.height-q){Ae.bindFramebuffer(O.FRAMEBUFFER,Le);let Fe=M.textures[be],Je=Fe.format,ft=Fe.type;M.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+be);let Oe=Ze(Fe);if(Oe.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Oe.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.bufferData(O.PIXEL_PACK_BUFFER,de.byteLength,O.STREAM_READ),O.readPixels(N,$,H,q,Me.convert(Je),Me.convert(ft),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let zt=ue!==null?qe.get(ue).__webglFramebuffer:null;Ae.bindFramebuffer(O.FRAMEBUFFER,zt);let Tt=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await sm(O,Tt,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,de),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(pt),O.deleteSync(Tt),de}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(M,N=null,$=0){let H=Math.pow(2,-$),q=Math.floor(M.image.width*H),de=Math.floor(M.image.height*H),Se=N!==null?N.x:0,be=N!==null?N.y:0;je.setTexture2D(M,0),O.copyTexSubImage2D(O.TEXTURE_2D,$,0,0,Se,be,q,de),Ae.unbindTexture()},this.copyTextureToTexture=function(M,N,$=null,H=null,q=0,de=0){let Se,be,Le,Fe,Je,ft,Oe,pt,zt,Tt=M.isCompressedTexture?M.mipmaps[de]:M.image;if($!==null)Se=$.max.x-$.min.x,be=$.max.y-$.min.y,Le=$.isBox3?$.max.z-$.min.z:1,Fe=$.min.x,Je=$.min.y,ft=$.isBox3?$.min.z:0;else{let mt=Math.pow(2,-q);Se=Math.floor(Tt.width*mt),be=Math.floor(Tt.height*mt),M.isDataArrayTexture?Le=Tt.depth:M.isData3DTexture?Le=Math.floor(Tt.depth*mt):Le=1,Fe=0,Je=0,ft=0}H!==null?(Oe=H.x,pt=H.y,zt=H.z):(Oe=0,pt=0,zt=0);let xt=Me.convert(N.format),un=Me.convert(N.type),Ge;N.isData3DTexture?(je.setTexture3D(N,0),Ge=O.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?(je.setTexture2DArray(N,0),Ge=O.TEXTURE_2D_ARRAY):(je.setTexture2D(N,0),Ge=O.TEXTURE_2D),Ae.activeTexture(O.TEXTURE0),Ae.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,N.flipY),Ae.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),Ae.pixelStorei(O.UNPACK_ALIGNMENT,N.unpackAlignment);let fn=Ae.getParameter(O.UNPACK_ROW_LENGTH),yt=Ae.getParameter(O.UNPACK_IMAGE_HEIGHT),Qi=Ae.getParameter(O.UNPACK_SKIP_PIXELS),pn=Ae.getParameter(O.UNPACK_SKIP_ROWS),cr=Ae.getParameter(O.UNPACK_SKIP_IMAGES);Ae.pixelStorei(O.UNPACK_ROW_LENGTH,Tt.width),Ae.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Tt.height),Ae.pixelStorei(O.UNPACK_SKIP_PIXELS,Fe),Ae.pixelStorei(O.UNPACK_SKIP_ROWS,Je),Ae.pixelStorei(O.UNPACK_SKIP_IMAGES,ft);let Ni=M.isDataArrayTexture||M.isData3DTexture,es=N.isDataArrayTexture||N.isData3DTexture;if(M.isDepthTexture){let mt=qe.get(M),on=qe.get(N),On=qe.get(mt.__renderTarget),Bt=qe.get(on.__renderTarget);Ae.bindFramebuffer(O.READ_FRAMEBUFFER,On.__webglFramebuffer),Ae.bindFramebuffer(O.DRAW_FRAMEBUFFER,Bt.__webglFramebuffer);for(let mn=0;mn<Le;mn++)Ni&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,qe.get(M).__webglTexture,q,ft+mn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,qe.get(N).__webglTexture,de,zt+mn)),O.blitFramebuffer(Fe,Je,Fe+Se,Je+be,Oe,pt,Oe+Se,pt+be,O.DEPTH_BUFFER_BIT,O.NEAREST);Ae.bindFramebuffer(O.READ_FRAMEBUFFER,null),Ae.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(q!==0||M.isRenderTargetTexture||qe.has(M)){let mt=qe.get(M),on=qe.get(N);Ae.bindFramebuffer(O.READ_FRAMEBUFFER,I),Ae.bindFramebuffer(O.DRAW_FRAMEBUFFER,V);for(let On=0;On<Le;On++)Ni?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,mt.__webglTexture,q,ft+On):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,mt.__webglTexture,q),es?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,on.__webglTexture,de,zt+On):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,on.__webglTexture,de),q!==0?O.blitFramebuffer(Fe,Je,Fe+Se,Je+be,Oe,pt,Oe+Se,pt+be,O.COLOR_BUFFER_BIT,O.NEAREST):es?O.copyTexSubImage3D(Ge,de,Oe,pt,zt+On,Fe,Je,Se,be):O.copyTexSubImage2D(Ge,de,Oe,pt,Fe,Je,Se,be);Ae.bindFramebuffer(O.READ_FRAMEBUFFER,null),Ae.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else es?M.isDataTexture||M.isData3DTexture?O.texSubImage3D(Ge,de,Oe,pt,zt,Se,be,Le,xt,un,Tt.data):N.isCompressedArrayTexture?O.compressedTexSubImage3D(Ge,de,Oe,pt,zt,Se,be,Le,xt,Tt.data):O.texSubImage3D(Ge,de,Oe,pt,zt,Se,be,Le,xt,un,Tt):M.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,de,Oe,pt,Se,be,xt,un,Tt.data):M.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,de,Oe,pt,Tt.width,Tt.height,xt,Tt.data):O.texSubImage2D(O.TEXTURE_2D,de,Oe,pt,Se,be,xt,un,Tt);Ae.pixelStorei(O.UNPACK_ROW_LENGTH,fn),Ae.pixelStorei(O.UNPACK_IMAGE_HEIGHT,yt),Ae.pixelStorei(O.UNPACK_SKIP_PIXELS,Qi),Ae.pixelStorei(O.UNPACK_SKIP_ROWS,pn),Ae.pixelStorei(O.UNPACK_SKIP_IMAGES,cr),de===0&&N.generateMipmaps===!0&&N.mipmapsAutoUpdate===!0&&O.generateMipmap(Ge),Ae.unbindTexture()},this.initRenderTarget=function(M){qe.get(M).__webglFramebuffer===void 0&&je.setupRenderTarget(M)},this.initTexture=function(M){M.isCubeTexture?je.setTextureCube(M,0):M.isData3DTexture?je.setTexture3D(M,0):M.isDataArrayTexture||M.isCompressedArrayTexture?je.setTexture2DArray(M,0):je.setTexture2D(M,0),Ae.unbindTexture()},this.resetState=function(){Z=0,B=0,ue=null,Ae.reset(),Ee.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return xi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var QS=`
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
}`,eb=`
in float share;
uniform vec3 scale[9];
uniform vec4 paint;
out vec4 colour;
void main() {
  float x = 8.0 * clamp(share, 0.0, 1.0);
  int i = min(int(x), 7);
  colour = vec4(mix(paint.rgb, mix(scale[i], scale[i + 1], x - float(i)), paint.a), 1.0);
}`,bc=["#440154","#472d7b","#3b528b","#2c728e","#21918c","#28ae80","#5ec962","#addc30","#fde725"].map(Ec);function Ec(i){let e=parseInt(i.trim().slice(1),16);return[(e>>16)/255,(e>>8&255)/255,(e&255)/255]}var sa=(i,e,t)=>[i[0]+(e[0]-i[0])*t,i[1]+(e[1]-i[1])*t,i[2]+(e[2]-i[2])*t];function Hm(i){let[e,t]=i?[2,8]:[6.2,0];return bc.map((n,s)=>{let r=e+(t-e)*s/8,a=Math.min(Math.floor(r),7);return sa(bc[a],bc[a+1],r-a)})}function Wm(){let i=new OffscreenCanvas(1,1).getContext("webgl2"),e=i?.getExtension("WEBGL_debug_renderer_info"),t=e?String(i.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(t)}function ra(i,e){let t=[];for(let n=0;n+1<i;n+=1)e(n)&&t.push(n,n+1);return Uint32Array.from(t)}function so(i,e,t=[0,0,0],n=1){return new qn(Float32Array.from(i,(s,r)=>(s-t[r%e])*n),e)}function Xm(i,e){let t=i.length-3,n=new Float32Array(i.length);for(let a=0;a<=t;a+=3){let o=Math.max(a-3,0),l=Math.min(a+3,t),c=[0,1,2].map(d=>i[l+d]-i[o+d]),h=Math.hypot(...c);h>e?n.set(c.map(d=>d/h),a):n.copyWithin(a,a-3,a)}let s=n.findIndex(a=>a!==0),r=s-s%3;for(let a=0;a<r;a+=3)n.copyWithin(a,r,r+3);return new qn(n,3)}var ku=class{object;own;constructor(e,t,n,s,r=0){let a=new Ha;this.own={side:{value:r},paint:{value:new Qt},wide:{value:1}};let o=s>=zu,l={...e,...this.own},c={glslVersion:ja,vertexShader:QS,fragmentShader:eb,uniforms:l},h=new vi({...c,depthTest:o,depthWrite:o});this.object=new Fa(a,h),this.object.frustumCulled=!1,this.fill(t,n),this.object.renderOrder=s,this.width(1)}paint(e){this.own.paint.value.set(...e??[0,0,0],e?0:1)}fill(e,t){let{geometry:n}=this.object;n.dispose();for(let[s,r]of Object.entries(e))n.setAttribute(s,r);n.setIndex(new qn(t,1)),n.setDrawRange(0,1/0)}width(e){this.own.wide.value=e,this.object.geometry.instanceCount=e*e}only(e){let t=this.object.geometry.index;t.array.set(e),t.clearUpdateRanges(),t.addUpdateRange(0,e.length),t.needsUpdate=!0,this.object.geometry.setDrawRange(0,e.length),this.object.visible=e.length>0}},zu=9,wc=class{camera=new Jr;scene=new La;renderer;uniforms={magnification:{value:1},view:{value:new j},pixel:{value:new wt},top:{value:1},scale:{value:bc.map(()=>new j)}};constructor(e,t){this.renderer=new yc({canvas:e,context:t}),this.renderer.setClearColor(0,0)}add(e,t,n,s=0){let r=new ku(this.uniforms,e,t,n,s);return this.scene.add(r.object),r}destroy(){for(let{geometry:e,material:t}of this.scene.children)e.dispose(),t.dispose();this.renderer.dispose()}};var Zn=(i,e)=>[i[3*e],i[3*e+1],i[3*e+2]],Tc=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],Vu=[210,52],Gu=Math.PI/180,Ac=class{constructor(e,t,n,s,r,a){this.path=e;this.centre=t;this.extent=n;this.azimuth=s;this.elevation=r;this.changed=a;this.span=n,this.target=t}path;centre;extent;azimuth;elevation;changed;width=0;height=0;span;target;right=[1,0,0];up=[0,1,0];back=[0,0,1];turn(e,t){this.from(this.azimuth-e,this.elevation+t)}from(e,t){this.azimuth=e,this.elevation=Math.min(Math.max(t,-90),90);let[n,s]=[Math.cos(e*Gu),Math.sin(e*Gu)],r=this.elevation*Gu;this.right=[-s,n,0],this.up=[-Math.sin(r)*n,-Math.sin(r)*s,Math.cos(r)],this.back=[Math.cos(r)*n,Math.cos(r)*s,Math.sin(r)],this.changed()}fit(e){let[[t,n],[s,r]]=[this.right,this.up].map(l=>{let c=1/0,h=-1/0;for(let d=0;d<this.path.length/3;d+=1){let u=Tc(Zn(this.path,d),l);c=Math.min(c,u),h=Math.max(h,u)}return[(c+h)/2,h-c+2*e]});this.target=[0,1,2].map(l=>t*this.right[l]+s*this.up[l]+Tc(this.centre,this.back)*this.back[l]);let a=n*this.height/this.width/Math.max(1-48/this.width,.5),o=l=>Math.max(r/Math.max(1-l/this.height,.5),a,.001*this.extent);this.span=o(64),this.width-n*this.height/this.span<2*Vu[0]&&(this.span=o(64+Vu[1]),this.shift(0,Vu[1]/2)),this.changed()}project(e){let t=this.height/this.span,n=[e[0]-this.target[0],e[1]-this.target[1],e[2]-this.target[2]];return[this.width/2+t*Tc(n,this.right),this.height/2-t*Tc(n,this.up)]}holds([e,t]){return e>=0&&t>=0&&e<=this.width&&t<=this.height}shift(e,t){this.target=this.target.map((n,s)=>n-this.span/this.height*(this.right[s]*e-this.up[s]*t)),this.changed()}zoom(e,t=this.width/2,n=this.height/2){let s=Math.min(Math.max(this.span*e,1e-6*this.extent),50*this.extent),r=1-s/this.span;this.shift((this.width/2-t)*r,(this.height/2-n)*r),this.span=s}aim(e,t){let n=this.target.map((a,o)=>a-this.centre[o]),s=this.span/2,r=s*this.width/this.height;Object.assign(e,{top:s,bottom:-s,right:r,left:-r,near:0,far:2*t}),e.position.set(n[0]+this.back[0]*t,n[1]+this.back[1]*t,n[2]+this.back[2]*t),e.up.set(...this.up),e.lookAt(...n),e.updateProjectionMatrix()}};var qm=1e4,tb=14,nb=.25,ib=.05,Ym=[-60,35.264],sb=[640,440],rb=[20,36,52].flatMap(i=>[12,90].map(e=>[e,i])),ab=[.1,.2,.5,1,2,5,10],Hu=[0,0,0];function Gt(i,e={},...t){let n=Object.assign(document.createElement(i),e);return n.append(...t),n}function ms(i,e,...t){let n=document.createElementNS("http://www.w3.org/2000/svg",i);for(let[s,r]of Object.entries(e))n.setAttribute(s,String(r));return n.append(...t),n}var Cc=new WeakSet,ob=i=>Cc.has(i);function $m(i,e,t){let n=Wm(),s=Gt("canvas"),r=s.getContext("webgl2",{antialias:!n,alpha:!0,preserveDrawingBuffer:!0});if(!r)return i.replaceChildren("The path in space needs WebGL 2, which this browser does not offer."),{highlight(){},resize(){},destroy(){i.replaceChildren()}};let a=i.getRootNode(),o=a instanceof ShadowRoot?a:document,l=new CSSStyleSheet,c=new AbortController;l.replaceSync(Kf),o.adoptedStyleSheets.push(l);let h=(G,pe,Ne,He={})=>pe.split(" ").forEach(De=>G.addEventListener(De,Ne,{signal:c.signal,...He})),d=new wc(s,r),u=d.uniforms,f=e.path.values,g=e.judged.values,y=g.length,m=[1/0,1/0,1/0],p=[-1/0,-1/0,-1/0];f.forEach((G,pe)=>{m[pe%3]=Math.min(m[pe%3],G),p[pe%3]=Math.max(p[pe%3],G)});let v=sa(m,p,.5),T=Math.max(...p.map((G,pe)=>G-m[pe]))||1,b=e.tolerance,P={foot:so(f,3,v),tangent:Xm(f,3e-5*T)},C=ra(y,G=>g[G]>0&&g[G+1]>0),x=ra(y,G=>!(g[G]&&g[G+1])),A=d.add(P,x,0),z=d.add(P,C,2),U=d.add(P,ra(y,()=>!0),3),D=b===null?[]:[1,-1].map(G=>d.add(P,C,1,G*b*.001));function W(G){let pe=G.size.values,Ne=G.stretch.values,He=ra(pe.length,M=>Ne[M]>0&&Ne[M]===Ne[M+1]),De={foot:so(G.foot.values,3,v),error:so(G.error.values,3,Hu,.001),size:so(pe,1)},Ze=0;return pe.forEach((M,N)=>{Ne[N]>0&&(Ze=Math.max(Ze,M))}),{index:He,top:Ze,places:De,of:G.size}}function X(G,pe){let Ne=W(G),{places:He,index:De}=Ne;return{run:G,...Ne,shown:!1,lines:d.add(He,De,zu+pe),halo:d.add(He,De.slice(),4)}}let I=e.runs.map(X),V=()=>I.filter(G=>G.shown),Z=I.reduce((G,pe)=>pe.top>G.top?pe:G);Z.shown=!0;let B=Gt("canvas",{hidden:!0}),ue=ms("svg",{}),J=Gt("div",{className:"path-bar"}),Q=Gt("div",{className:"path-key"}),se=`${e.title}. Arrow keys turn, with shift they move; plus and minus zoom, space plays.`,oe=Gt("div",{className:"path-stage",tabIndex:0,role:"application",ariaLabel:se},s,B,ue,Q,J),fe=Gt("output",{className:"path-times"}),ee=Gt("output"),xe=Gt("output",{className:"path-said",textContent:"Click on the path: line, time, error and cause."}),ve=Gt("input",{type:"range",min:"0",max:"4",step:"any",ariaLabel:"Magnification of the error"}),Te=Math.min(...I.map(({run:G})=>G.time.values[0]??0)),we=Math.max(...I.map(({run:G})=>G.time.values.at(-1)??0)),$e=Gt("input",{type:"range",min:String(Te),max:String(we),step:"any",ariaLabel:"Time",value:String(Te)}),it=Gt("button",{type:"button"}),Xe=Gt("select",{ariaLabel:"Speed"},...ab.map(G=>new Option(`${G} ×`,String(G)))),ut=Gt("select",{ariaLabel:"Colour"},new Option("colour: error","error"),new Option("colour: run","run")),dt=(G,pe,Ne,He="")=>{let De=Gt("input",{type:"checkbox",checked:pe}),Ze=Gt("i");return Ze.style.background=He,h(De,"change",()=>{Ne(De.checked),Ot()}),Gt("label",{},De,...He?[Ze]:[],G)},rt=(G,pe)=>{let Ne=Gt("button",{type:"button",textContent:G});return h(Ne,"click",pe),Ne},kt=e.axes.map(G=>G.toUpperCase()),[Ft,nn,At]=kt,hn=Math.max(...kt.map(G=>G.length)),_t=(G,pe)=>G+(hn>1?" ":"")+pe,an=[[_t(Ft,nn),-90,90],["ISO",...Ym]];At&&an.splice(1,0,[_t(Ft,At),-90,0],[_t(nn,At),0,0]);let Yt=Gt("span",{className:"path-which"});function sn(G,pe){G.shown=pe,ut.value=V().length>1?"run":"error"}let O=()=>{I.length>1&&Yt.replaceChildren(...I.map(G=>dt(G.run.name,G.shown,pe=>sn(G,pe),G.run.colour)),ut)};O();let Ie=0,et=0,at=!0;for(let G=0;G<C.length;G+=2){let pe=Zn(f,C[G]),Ne=Zn(f,C[G+1]);Ie+=Math.hypot(Ne[0]-pe[0],Ne[1]-pe[1],Ne[2]-pe[2]),et+=Math.abs(Ne[2]-pe[2])}let Ae=et<=ib*Ie,It=Ae,[qe,je]=Ae?[-90,90]:Ym,E=new Ac(f,v,T,qe,je,()=>_e());i.classList.add("cl-path"),i.replaceChildren(Gt("div",{className:"path-row"},Gt("span",{className:"path-views"},...an.map(([G,pe,Ne])=>rt(G,()=>{E.from(pe,Ne),ye()})),rt("Fit",ye)),Yt,...x.length?[dt(e.unjudged,!0,G=>{at=G})]:[],...D.length?[dt("tolerance",It,G=>{It=G})]:[]),oe,Gt("div",{className:"path-row"},fe,ve),Gt("div",{className:"path-row"},it,$e,Xe,ee),xe);let S=0,Y=0,ce=1,ae=!1;function _e(){S||=requestAnimationFrame(ie)}function ye(){E.fit(Math.min(.001*u.magnification.value*Math.max(...V().map(G=>G.top),0),.3*T))}function te(){ae=n,clearTimeout(Y),Y=window.setTimeout(()=>{ae=!1,_e()},150)}function ie(){cancelAnimationFrame(S),S=0,E.aim(d.camera,4*(T+.001*qm*Math.max(...I.map(G=>G.top)))),u.view.value.set(...E.back),A.object.visible=at,D.forEach(G=>{G.object.visible=It&&b*.001*u.magnification.value<.3*T}),I.forEach(G=>{G.lines.object.visible=G.shown,G.lines.width(ae||ob(G.run)?1:2*ce)}),d.renderer.render(d.scene,d.camera),Re()}let me=({foot:G,error:pe})=>[0,1,2].map(Ne=>G[Ne]+pe[Ne]*.001*u.magnification.value),F=[],re=[],ne=null;function Re(){let G=[],pe=rb.slice(),[Ne,He]=E.project(v);if(re=V().flatMap(({run:M})=>M.worst.map(N=>({run:M,place:N}))).sort((M,N)=>N.place.size-M.place.size),re.forEach(({run:M,place:N},$)=>{let[H,q]=E.project(me(N)),{width:de,height:Se}=E;if(!E.holds([H,q]))return;let be=`${Rt(N.size,"um",3)}${N.line?`, line ${N.line}`:""}`,Le=7*be.length,Fe=H<Ne?-1:1,Je=H+Fe*(18+Le)<0||H+Fe*(18+Le)>de?-Fe:Fe,ft=q<He?-1:1,Oe=H+Je*14,pt=Je>0?Oe:Oe-Le,zt=[15,31,47,63,-23,-39].map(xt=>q+3+ft*xt).find(xt=>xt>12&&xt<Se-6&&!pe.some(([un,Ge])=>Math.abs(un-pt)<Le+6&&Math.abs(Ge-xt)<16)),Tt=ms("g",{class:"path-worst","data-place":$},ms("circle",{class:"path-mark",cx:H,cy:q,r:6}));if(V().length>1&&(Tt.firstChild.style.stroke=M.colour),zt!==void 0){pe.push([pt,zt]);let xt=b!==null&&N.size>b?"path-over":"";Tt.append(ms("line",{class:"path-lead",x1:H+Je*5,y1:q,x2:Oe-Je*2,y2:zt-4}),ms("text",{class:xt,x:Oe,y:zt,"text-anchor":Je>0?"start":"end"},be))}G.push(Tt)}),ne){let[M,N]=E.project(me(ne));G.push(ms("path",{class:"path-mark",d:`M${M-11} ${N}h8m6 0h8M${M} ${N-11}v8m0 6v8`}))}kt.forEach((M,N)=>{let[$,H]=[E.width-30-8*Math.min(hn,9),E.height-34],q=E.right[N],de=-E.up[N];G.push(ms("line",{class:"path-mark",x1:$,y1:H,x2:$+24*q,y2:H+24*de})),Math.hypot(q,de)>.3&&G.push(ms("text",{x:$+30*q-4,y:H+32*de+4},M))}),F=I.map(({run:M})=>ms("circle",{class:"path-tool",r:6,fill:M.colour})),ue.replaceChildren(...G,...F);let De=lo(120*E.span/E.height),Ze=Gt("i");Ze.style.width=`${De*E.height/E.span}px`,J.replaceChildren(Ze,`${Rt(De,"mm")} of path, ${Rt(De*1e3/u.magnification.value,"um",3)} of error`),Ve()}function Me(G,pe,Ne){let He=G.stretch.values,De=Math.min(pe+1,He.length-1),Ze=({values:$})=>$[pe]+($[De]-$[pe])*Ne,M=$=>He[$]>0?Zn(G.error.values,$):Hu,N=sa(Zn(G.foot.values,pe),Zn(G.foot.values,De),Ne);return{run:G,foot:N,error:sa(M(pe),M(De),Ne),size:Ze(G.size),time:Ze(G.time),line:G.lines.values[Ne>0?De:pe],feedrate:Ze(G.feedrate),judged:He[pe]>0&&He[pe]===He[De]}}function Ee(G,pe){let Ne=G.time.values,He=0,De=Ne.length-1;for(;De-He>1;){let Ze=He+De>>1;Ne[Ze]<=pe?He=Ze:De=Ze}return Me(G,He,Math.min(Math.max((pe-Ne[He])/(Ne[De]-Ne[He]||1),0),1))}let Be=Te,Qe=0,he=0;function Ve(){let G=I.map(({run:De,shown:Ze})=>Ze&&De.time.values.length&&(Be>Te||Qe)?Ee(De,Be):null);G.forEach((De,Ze)=>{F[Ze].setAttribute("visibility",De?"visible":"hidden"),De&&E.project(me(De)).forEach((M,N)=>F[Ze].setAttribute(N?"cy":"cx",M.toFixed(2)))});let pe=G.filter(De=>De!==null),Ne=pe.find(De=>De.line)?.line,He=pe.map(De=>De.judged?Rt(De.size,"um",3):e.unjudged);ee.textContent=[`${Be.toFixed(3)} s`,...Ne?[`line ${Ne}`]:[],...He].join(", ")}function tt(G){Be=Math.min(Be+(G-he)/1e3*Number(Xe.value),we),he=G,$e.value=String(Be),Be<we?Qe=requestAnimationFrame(tt):Pe(),Ve()}function Pe(){cancelAnimationFrame(Qe),Qe=0,Object.assign(it,{textContent:"▶",ariaLabel:"Play"})}function ct(){if(Qe)return Pe();Be>=we&&(Be=Te),he=performance.now(),Qe=requestAnimationFrame(tt),Object.assign(it,{textContent:"❚❚",ariaLabel:"Pause"})}h(it,"click",ct),h($e,"input",()=>{Be=Number($e.value),Ve()});function Ht(G,pe){let Ne=tb,He=null,De=(Ze,M,N)=>{let $=-1,H=0;for(let q=0;q<Ze.length;q+=2){let[de,Se]=E.project(M(Ze[q])),[be,Le]=E.project(M(Ze[q+1])),Fe=be-de,Je=Le-Se,ft=Math.min(Math.max(((G-de)*Fe+(pe-Se)*Je)/(Fe*Fe+Je*Je||1),0),1),Oe=Math.hypot(G-de-ft*Fe,pe-Se-ft*Je);Oe<Ne&&([Ne,$,H]=[Oe,Ze[q],ft])}$>=0&&(He=N($,H))};for(let{run:Ze,index:M}of V())De(M,N=>me({foot:Zn(Ze.foot.values,N),error:Zn(Ze.error.values,N)}),(N,$)=>Me(Ze,N,$));return!He&&at&&De(x,Ze=>Zn(f,Ze),(Ze,M)=>({run:Z.run,foot:sa(Zn(f,Ze),Zn(f,Ze+1),M),error:Hu,line:e.lines.values[M<.5?Ze:Ze+1],size:NaN,time:NaN,feedrate:NaN,judged:!1})),He}function Rn(G){ne=G;let pe=G.line?`Line ${G.line}`:"";if(G.judged){let Ne=De=>Math.abs(De.time-G.time),He=G.run.worst.filter(De=>De.cause&&Ne(De)<nb).sort((De,Ze)=>Ne(De)-Ne(Ze));xe.textContent=[pe,`t = ${G.time.toFixed(3)} s`,`error ${Rt(G.size,"um",3)}`,Rt(G.feedrate,"mm/min"),...He.slice(0,1).map(De=>`cause: ${De.cause}`),I.length>1?G.run.name:""].filter(Boolean).join(", "),Be=G.time,$e.value=String(Be)}else xe.textContent=[pe,e.unjudged].filter(Boolean).join(", ");_e(),G.line&&t.pick(G.line)}let _s=null;function Zi(G){_s=G;let pe=(He,De)=>{let Ze=[],M=[];for(let N=0;G!==null&&N<He.length;N+=2){let $=De[He[N]],H=De[He[N+1]];H===G?Ze.push(He[N],He[N+1]):$<G&&G<H&&M.push(He[N],He[N+1])}return Ze.length?Ze:M},Ne=pe(ra(y,()=>!0),e.lines.values);U.only(Ne),I.forEach(He=>He.halo.only(He.shown?pe(He.index,He.run.lines.values):[])),Ne.length&&!Ne.some(He=>E.holds(E.project(Zn(f,He))))&&(E.target=Zn(f,Ne[Ne.length>>1])),_e()}let Ji=new Map,Ki=0,Un=G=>{let pe=oe.getBoundingClientRect();return[G.clientX-pe.left-oe.clientLeft,G.clientY-pe.top-oe.clientTop]};h(oe,"pointerdown",G=>{Ji.set(G.pointerId,Un(G)),Ki=0}),h(oe,"pointerup pointercancel",G=>{Ji.delete(G.pointerId)}),h(oe,"contextmenu",G=>G.preventDefault()),h(oe,"pointermove",G=>{let pe=Ji.get(G.pointerId),Ne=Un(G),He=[...Ji].find(([N])=>N!==G.pointerId)?.[1];if(!pe)return;let De=Ne[0]-pe[0],Ze=Ne[1]-pe[1],M=N=>Math.hypot(N[0]-He[0],N[1]-He[1])||1;Ki+=Math.hypot(De,Ze),Ki>4&&oe.setPointerCapture(G.pointerId),Ji.set(G.pointerId,Ne),te(),He?(E.zoom(M(pe)/M(Ne),...He),E.shift(De/2,Ze/2)):G.shiftKey||G.buttons&6?E.shift(De,Ze):E.turn(De/2,Ze/2)}),h(oe,"click",G=>{let pe=G.target.closest(".path-worst"),Ne=pe&&re[Number(pe.dataset.place)],He=Ne?Ee(Ne.run,Ne.place.time):Ki>4?null:Ht(...Un(G));He&&Rn(He)}),h(oe,"wheel",G=>{!G.ctrlKey&&o.activeElement!==oe||(G.preventDefault(),te(),E.zoom(Math.exp(Math.max(-60,Math.min(60,G.deltaY))*.003),...Un(G)))},{passive:!1}),h(oe,"keydown",G=>{let pe=(He,De)=>()=>{G.shiftKey?E.shift(5*He,5*De):E.turn(He,De)},Ne={ArrowLeft:pe(-6,0),ArrowRight:pe(6,0),ArrowUp:pe(0,-6),ArrowDown:pe(0,6),Home:ye," ":ct,"+":()=>E.zoom(.8),"=":()=>E.zoom(.8),"-":()=>E.zoom(1.25)};!Ne[G.key]||G.altKey||G.ctrlKey||G.metaKey||(G.preventDefault(),te(),Ne[G.key]())});function ui(G){u.magnification.value=Number(Math.min(Math.max(G,1),qm).toPrecision(2)),fe.textContent=ve.ariaValueText=`error × ${u.magnification.value.toLocaleString("en").replace(","," ")}`,_e()}h(ve,"input",()=>{te(),ui(10**Number(ve.value))}),h(ut,"change",()=>Ot());let di=matchMedia("screen and (prefers-color-scheme: dark)"),ji=!1,Wn={};function Ot(){let G=getComputedStyle(i),pe=de=>G.getPropertyValue(`--p-${de}`).trim(),Ne=ut.value==="error",He=Hm(di.matches&&!ji),De=(de,Se)=>de.forEach(be=>be.paint(Ec(pe(Se))));De([z],"path"),De([A],"rapid"),De(D,"band"),De([U,...I.map(de=>de.halo)],"picked"),I.forEach(({run:de,lines:Se})=>Se.paint(Ne?null:Ec(Xn(de.colour,pe("paper"))))),He.forEach((de,Se)=>u.scale.value[Se].set(...de));let Ze=Math.max(...V().map(de=>de.top),0)||1,M=Gt("div",{className:"path-scale"}),N=Gt("i");u.top.value=Ze;let $=He.map(de=>`rgb(${de.map(Se=>Math.round(255*Se)).join(" ")})`);M.style.background=`linear-gradient(90deg, ${$.join(", ")})`,N.style.left=`${100*(b??0)/Ze}%`,b!==null&&b<=Ze&&M.append(N);let H=Gt("div",{className:"path-ends"},Gt("span",{},"0"),Gt("span",{},Rt(Ze,"um",3))),q=[...Ne?["error"]:[],...b===null?[]:[`tolerance ${Rt(b,"um")}`]];Q.replaceChildren(q.join(", "),...Ne?[M,H]:[]),Zi(_s)}function qt(){let G=!E.width,pe=ji?2:devicePixelRatio||1;!oe.clientWidth||!oe.clientHeight||([E.width,E.height]=[oe.clientWidth,oe.clientHeight],d.renderer.setPixelRatio(pe),d.renderer.setSize(E.width,E.height,!1),u.pixel.value.set(2/(E.width*pe),2/(E.height*pe)),ce=Math.max(Math.round(pe),1),U.width(4*ce),I.forEach(Ne=>Ne.halo.width(6*ce)),G&&ye(),ie())}function en(G){G&&(Wn={target:E.target,span:E.span}),ji=G,[oe.style.width,oe.style.height]=G?sb.map(pe=>`${pe}px`):["",""],Ot(),qt(),G?ye():Object.assign(E,Wn),ie(),[B.width,B.height,B.hidden]=[s.width,s.height,!G],G&&B.getContext("2d").drawImage(s,0,0)}h(di,"change",()=>Ot()),h(window,"beforeprint",()=>en(!0)),h(window,"afterprint",()=>en(!1)),h(s,"webglcontextrestored",_e);let Jn=new ResizeObserver(qt);Jn.observe(oe),Xe.value="1",Pe(),ve.value=String(Math.log10(e.magnification)),ui(e.magnification),E.turn(0,0),Ot(),qt();function Fn(){for(let G of e.runs.slice(I.length)){let pe=X(G,I.length);I.push(pe),pe.halo.width(6*ce),sn(pe,!0)}O(),I.filter(({run:G,of:pe})=>G.size!==pe).forEach(G=>{let{places:pe,index:Ne}=Object.assign(G,W(G.run));G.lines.fill(pe,Ne),G.halo.fill(pe,Ne.slice())}),Ot()}return{highlight:Zi,resize:qt,update:Fn,destroy(){c.abort(),Pe(),cancelAnimationFrame(S),clearTimeout(Y),Jn.disconnect(),d.destroy(),o.adoptedStyleSheets=o.adoptedStyleSheets.filter(G=>G!==l),i.classList.remove("cl-path"),i.replaceChildren()}}}var Zm=`"use strict";(()=>{function B({start:b,coefficients:e,closed:t},o){let a=b.values,r=e.values,g=a.length-2,y=a[g+1],m=0;return(s,u)=>{for(t&&(s-=y*Math.floor(s/y));m<g&&s>=a[m+1];)m+=1;for(;m>0&&s<a[m];)m-=1;let i=s-a[m];for(let h=0,l=6*o*m;h<o;h+=1,l+=6)u[h]=r[l]+i*(r[l+1]+i*(r[l+2]+i*(r[l+3]+i*(r[l+4]+i*r[l+5])))),u[o+h]=r[l+1]+i*(2*r[l+2]+i*(3*r[l+3]+i*(4*r[l+4]+i*5*r[l+5]))),u[2*o+h]=2*r[l+2]+i*(6*r[l+3]+i*(12*r[l+4]+i*20*r[l+5]))}}var z=class{constructor(e){this.given=e;let t=new WebAssembly.Memory({initial:Math.ceil(e.n_word/8192)}),o=new WebAssembly.Instance(new WebAssembly.Module(e.code.values),{env:{memory:t}});this.loop={memory:new Float64Array(t.buffer),...o.exports},this.axes=e.position.length,e.words.forEach(({at:a,values:r})=>this.loop.memory.set(r.values,a)),this.plan(),this.rest=this.state()}given;loop;rest;worst=[];axes;plan(){let{motion:{period:e,n_sample:t,spans:o,duration:a,length:r,path:g},inputs:y,ahead:m}=this.given,{memory:s}=this.loop,{axes:u}=this,i=o.shape[1],[h,l,_,w,A]=[0,1,2,3,4].map(p=>o.values.subarray(p*i,(p+1)*i)),L=B(g,u),k=new Float64Array(3*u),d=p=>y+t*p;for(let p=0,f=0;p<t;p+=1){let v=p*e,P=v>=a;for(;f+1<i&&v>=h[f+1];)f+=1;let F=v-h[f],N=P?r:l[f]+F*(_[f]+F*(w[f]/2+F*A[f]/6)),M=P?0:_[f]+F*(w[f]+F*A[f]/2),c=P?0:w[f]+F*A[f];L(N,k);for(let n=0;n<u;n+=1)s[d(n)+p]=k[n],s[d(u+n)+p]=k[u+n]*M,s[d(2*u+n)+p]=k[2*u+n]*M*M+k[u+n]*c;s[d(3*u)+p]=N,s[d(3*u+1)+p]=M}m.forEach((p,f)=>{for(let v=0;v<t;v+=1)s[d(3*u+2+f)+v]=s[d(f)+Math.min(v+p,t-1)]})}get early(){return Math.max(0,this.given.short[0]-Math.round(2/this.given.motion.period))}state(){return this.given.state.map(([e,t])=>this.loop.memory.slice(e,t))}restore(e){this.given.state.forEach(([t],o)=>this.loop.memory.set(e[o],t))}first(e){let{early:t,given:{motion:o}}=this,a=performance.now();return this.begin([]),this.loop.run(0,t),this.worst=this.state(),this.loop.run(t,o.n_sample-t),[!1,!0].map(r=>this.found({id:0,run:e,values:[],short:r},a))}async answer(e,t){let{loop:o,given:{short:a,motion:r}}=this,[g,y]=e.short?[this.early,a[1]]:[0,r.n_sample],m=performance.now();if(!this.begin(e.values))return this.none(e);e.short&&this.restore(this.worst);for(let s=g;s<y;s+=8192)if(o.run(s,Math.min(8192,y-s)),!e.short&&await t())return null;return this.found(e,m)}none=({id:e,run:t,short:o})=>({id:e,run:t,short:o,begun:o?this.early:0,took:0,failed:null,unsure:0,figures:{},points:null});found(e,t){let{short:o,motion:{n_sample:a},failed_at:r}=this.given,[g,y]=e.short?o:[0,a],m=this.loop.memory[r];if(m>=0)return{...this.none(e),failed:m};let s=e.short?this.around(g,y):this.judged(),u=this.points(g,y);return{...this.none(e),figures:s,points:u,unsure:s.unsure,took:performance.now()-t}}begin(e){let{memory:t,prepare:o}=this.loop;return this.restore(this.rest),this.given.parameters.forEach(({word:a,value:r})=>{t[a]=r??1/0}),e.forEach(([a,r])=>{t[a]=r}),o()!==0}judged(){return this.loop.judge(),Object.fromEntries(this.given.figures.map(([e,t])=>[e,this.loop.memory[t]]))}around(e,t){let{log:o,n_log:a,part_error:r,doubt:g}=this.given,{memory:y}=this.loop,m=0,s=0,u=0,i=0,h=e;return this.given.judged.forEach(([l,_])=>{for(let w=Math.max(l,e);w<Math.min(_,t);w+=1){let A=Math.abs(y[o+w*a+r]);m+=1,s+=A*A,g.forEach(L=>{i+=y[o+w*a+L]}),A>u&&([u,h]=[A,w])}}),{part_error_max:u,part_error_rms:Math.sqrt(s/(m||1)),part_error_max_time:h*this.given.motion.period,unsure:i}}points(e,t){let{log:o,n_log:a,part_error:r,foot:g,position:y,judged:m,motion:s,inputs:u}=this.given,{memory:i}=this.loop,{axes:h}=this,l=[],_=[],w=Math.max(e,m[0][0]),A=Math.min(t,m.at(-1)[1]),L=Math.max(1,Math.ceil((A-w)/4e3)),k=c=>Math.abs(i[o+c*a+r]),d=w,p=(c,n)=>{l.push(c),_.push(n)},f=(c,n)=>{for(;d<c;d=Math.min(d+L,c)){let E=d;for(let x=d;n&&x<Math.min(d+L,c);x+=1)k(x)>k(E)&&(E=x);p(d,n),E!==d&&p(E,n)}l.at(-1)!==c-1&&c>w&&p(c-1,n)};m.forEach(([c,n],E)=>{f(Math.min(Math.max(c,d),A),0),f(Math.min(n,A),E+1)});let v=l.length,P=B(this.given.asked,h),F=new Float64Array(3*h),N=s.n_sample,M={time:new Float64Array(v),signed:new Float32Array(v),size:new Float32Array(v),stretch:Int32Array.from(_),foot:new Float32Array(h*v),error:new Float32Array(h*v),feedrate:new Float32Array(v)};return l.forEach((c,n)=>{let E=o+c*a,x=y.map(R=>i[E+R]);_[n]?P(i[E+g],F):F.set(x),M.time[n]=c*s.period,M.feedrate[n]=i[u+(3*h+1)*N+c]*6e4,M.signed[n]=_[n]?i[E+r]*1e6:NaN,M.size[n]=_[n]?k(c)*1e6:0,x.forEach((R,I)=>{M.foot[h*n+I]=F[I]*1e3,M.error[h*n+I]=(R-F[I])*1e6})}),M}},C=[],H=new MessageChannel,j=null,U=!1,W=()=>new Promise(b=>{H.port1.onmessage=()=>b(j!==null),H.port2.postMessage(0)}),K=b=>postMessage(b,{transfer:Object.values(b.points??{}).map(e=>e.buffer)});async function q(){for(U=!0;j;){let b=j;j=null;let e=await C[b.run].answer(b,W);e&&K(e)}U=!1}addEventListener("message",({data:b})=>{"id"in b?(j=b,U||q()):(C[b.run]=new z(b.loop),C[b.run].first(b.run).forEach(K))});})();
`;var cb=60,hb=60,Jm="changed settings",Km="settings before",jm="#8a949e",Qm=["#d55e00","#cc79a7","#56b4e9"],ub=[["part_error_max","largest part error",1e6,"um"],["part_error_rms","part error, rms",1e6,"um"],["tracking_error_max","largest tracking error",1e6,"um"],["command_largest","largest command, of the limit",100,"%"],["unsure","ticks in doubt",1,""]];function ng(i,e,t){let n=e.refused.map(([s,r])=>`${s}: ${r}.`).join(" ");return!e.runs.length||typeof WebAssembly!="object"||typeof Worker!="function"?(Ye(i,"p","note",e.runs.length?"The sliders need WebAssembly and workers, which this browser does not offer.":n),{resize(){},destroy(){i.replaceChildren()}}):new $u(i,e,t,n)}var gs=(i,e=0)=>({values:i,shape:e?[i.length/e,e]:[i.length]}),Wu=i=>i.replace(/^(controller\.)?axes\.[^.]+\./,"$1axes.*."),Xu=i=>/(?:^|\.)axes\.([^.]+)\./.exec(i)?.[1]??"",qu=i=>i.split(".").slice(-2).join(" ").replaceAll("_"," "),Yu=i=>JSON.stringify([...i].sort()),$u=class{constructor(e,t,n,s){this.host=e;this.live=t;this.page=n;this.scene=n.pictures.find(u=>u.kind==="PathScene"),this.errors=n.pictures.find(u=>u.key==="error-time");let r=this.scene?.runs.map(u=>u.colour)??[],a=Qm.find(u=>!r.includes(u))??Qm[0];[this.then,this.now]=[[Km,jm],[Jm,a]].map(([u,f])=>({kind:"SceneRun",name:u,colour:f,...this.drawn(null)})),this.firsts=t.runs.map(()=>({})),Cc.add(this.then);let o=Ye(e,"div","cl-tools"),l=Ye(o,"select");t.runs.forEach((u,f)=>l.add(new Option(u.name,String(f)))),l.setAttribute("aria-label","Run"),l.hidden=t.runs.length===1,l.addEventListener("change",()=>this.take(Number(l.value)));let c=(u,f)=>{let g=Ye(e,"button","",u);return g.type="button",g.addEventListener("click",f),g};this.tools={undo:c("Undo",()=>this.step(-1)),redo:c("Redo",()=>this.step(1)),reset:c("Reset",()=>this.set(new Map)),copy:c("Copy the command line",()=>{this.copy()}),save:c("Save as controller file",()=>this.save())},this.more=Ye(o,"select"),this.more.setAttribute("aria-label","More parameters"),this.more.addEventListener("change",()=>this.show(this.more.value)),o.append(this.tools.undo,this.tools.redo,this.tools.reset),this.list=Ye(e,"div","live-rows"),this.said=Ye(e,"p","live-said"),this.said.setAttribute("aria-live","polite");let h=Ye(e,"div","cl-sides");this.place=Ye(h,"div"),this.table=Ye(Ye(h,"div","scroll"),"table","figures slim tight live-table"),Ye(e,"div","cl-tools").append(this.tools.copy,this.tools.save),this.command=Ye(Ye(e,"pre","command"),"code"),s&&Ye(e,"p","note",s),e.addEventListener("keydown",this.key),["pointerenter","focusin"].forEach(u=>e.addEventListener(u,()=>this.load(),{once:!0}));let d=t.runs.map(u=>Math.max(0,...this.scene?.runs.find(f=>f.name===u.name)?.worst.map(f=>f.size)??[]));l.value=String(d.indexOf(Math.max(...d))),this.take(Number(l.value))}host;live;page;r=0;values=new Map;past=[new Map];at=0;rows=[];firsts;before=null;settled=null;worker=null;loaded=new Set;asked=0;since=0;sent=new Map;took=1/0;rest=0;scene;errors;now;then;curves=[];picture=null;place;list;more;said;table;tools;command;resize(){this.picture?.resize()}destroy(){this.worker?.terminate(),this.picture?.destroy(),clearTimeout(this.rest),this.host.removeEventListener("keydown",this.key),this.host.replaceChildren()}take(e){this.r=e,this.rows=[],this.list.replaceChildren(),[this.values,this.past,this.at]=[new Map,[new Map],0],[this.before,this.settled]=[null,null],this.asked+=1,this.since=this.asked;let{parameters:t}=this.live.runs[e],s=[...new Set(t.map(r=>Wu(r.name)))].sort((r,a)=>Number(a.startsWith("controller"))-Number(r.startsWith("controller")));this.more.replaceChildren(new Option("more parameters","")),s.forEach(r=>{t.some(a=>a.first&&Wu(a.name)===r)?this.show(r):this.more.add(new Option(qu(r),r))}),this.worker&&this.load(),this.chart(),this.refresh()}chart(){let{name:e,short:t,motion:{period:n}}=this.live.runs[this.r],s=gs(new Float64Array(0));if(this.picture?.destroy(),!this.errors)return;let r=l=>({kind:"Curve",x:s,y:s,name:"",colour:jm,dash:"solid",width:1.3,half:null,numbers:null,...l}),[a]=this.errors.panels,o=a.curves.find(l=>l.name===e);this.curves=[{...o,dash:"dash"},{name:Km,dash:"dot"},{name:Jm,colour:this.now.colour,width:2}].map(r),this.picture=To(this.place,{...this.errors,panel_height:170,panels:[{...a,curves:this.curves}]}),this.picture.zoom([t[0]*n,t[1]*n])}show(e){let t=this.live.runs[this.r].parameters.filter(c=>Wu(c.name)===e),n=qu(e);if(!t.length)return;let s=Ye(this.list,"div","live-row"),r=Ye(s,"span","live-name",n),a=Ye(s,"input"),o=Ye(s,"input"),l={title:n,members:t,taken:t,slider:a,field:o,unit:Ye(s,"span","live-unit")};if(r.title=t.map(c=>c.name).join(`
`),t.length>1){let c=Ye(r,"select");["all axes",...t.map(h=>Xu(h.name))].forEach((h,d)=>c.add(new Option(h,String(d)))),c.setAttribute("aria-label",`Axes of ${n}`),c.addEventListener("change",()=>{l.taken=c.value==="0"?t:[t[Number(c.value)-1]],this.refresh()})}Object.assign(a,{type:"range",min:"-1",max:"1",step:"0.01",ariaLabel:n}),Object.assign(o,{type:"number",step:"any",ariaLabel:`${n}, value`}),a.addEventListener("input",()=>this.change(l,c=>Number((c*10**Number(a.value)).toPrecision(3)),Number(a.value)===0)),o.addEventListener("change",()=>{let c=o.valueAsNumber;Number.isFinite(c)&&this.change(l,(h,{factor:d})=>this.isEqual(l)?c/d:h*c)}),this.rows.push(l),[...this.more.options].find(c=>c.value===e)?.remove(),this.more.value="",this.refresh()}baseOf=e=>e.value??1/0;valueOf=e=>this.values.get(e.name)??this.baseOf(e);isEqual=({taken:e})=>e.every(t=>this.baseOf(t)===this.baseOf(e[0]));change(e,t,n=!1){for(let s of e.taken){let r=this.baseOf(s),a=n?r:t(r,s),o=s.whole?Math.round(a):a;o===r?this.values.delete(s.name):this.values.set(s.name,o)}this.touched(e)}set(e){this.values=new Map(e),this.touched()}step(e){this.past[this.at+e]&&(this.at+=e,this.set(this.past[this.at]))}key=e=>{let t=e.key.toLowerCase();!(e.ctrlKey||e.metaKey)||!"zy".includes(t)||(e.preventDefault(),this.step(t==="y"||e.shiftKey?1:-1))};refresh(e){for(let l of this.rows){let[c]=l.taken,h=this.baseOf(c),d=this.valueOf(c),u=this.isEqual(l),f=d/h;l.slider.disabled=!Number.isFinite(h)||h===0,l!==e&&(l.slider.value=String(Math.log10(f>0?f:1))),l.field.value=Number.isFinite(d)?String(Number((u?d*c.factor:f).toPrecision(5))):"",l.unit.textContent=u?c.display:"times",l.slider.ariaValueText=`${l.field.value} ${l.unit.textContent}`}let t=this.changed(),{undo:n,redo:s,reset:r,save:a}=this.tools;[n.disabled,s.disabled,r.disabled]=[this.at===0,this.at+1>=this.past.length,!t.length],a.hidden=!this.live.runs[this.r].controller;let o=t.some(([l])=>!l.name.startsWith("controller."));a.title=o?"Values of the machine are not in it: they are in the command line.":"",this.command.textContent=this.commandLine(),this.host.classList.toggle("live-same",!t.length)}changed(){return this.live.runs[this.r].parameters.filter(e=>this.values.has(e.name)).map(e=>[e,this.values.get(e.name)])}load(){if(!this.worker){let e=URL.createObjectURL(new Blob([Zm],{type:"text/javascript"}));this.worker=new Worker(e),this.worker.addEventListener("message",({data:t})=>this.answered(t)),this.worker.addEventListener("error",t=>this.say(`The loop cannot run here: ${t.message}.`)),URL.revokeObjectURL(e)}this.loaded.has(this.r)||this.worker.postMessage({run:this.r,loop:this.live.runs[this.r]}),this.loaded.add(this.r)}touched(e){this.refresh(e);let t=this.changed().map(([n,s])=>this.beyond(n,s)).find(Boolean);if(clearTimeout(this.rest),t)return this.say(`Not possible: ${t}.`);this.worker||this.load(),this.ask(this.took>hb)}ask(e){let{parameters:t}=this.live.runs[this.r],n=new Map(t.map(s=>[s.name,s.word]));this.sent=new Map(this.values),this.asked+=1,this.worker.postMessage({id:this.asked,run:this.r,values:[...this.values].map(([s,r])=>[n.get(s),r]),short:e})}beyond(e,t){let n=o=>Rt(o*e.factor,e.display),{minimum:s,maximum:r}=e,a=`${qu(e.name)} ${Xu(e.name)} = ${n(t)}`;return s!==null&&(t<s||e.exclusive&&t===s)?`${a} must be ${e.exclusive?"more than":"at least"} ${n(s)}`:r!==null&&t>r?`${a} must be at most ${n(r)}`:""}answered(e){let{short:t,points:n,failed:s}=e,{period:r}=this.live.runs[this.r].motion;if(!e.id)return this.firsts[e.run][t?"short":"whole"]=e,e.run===this.r?this.draw(null):void 0;if(e.id<=this.since)return;let a=e.id===this.asked;if(a&&t&&(this.rest=window.setTimeout(()=>this.ask(!1),cb)),!n){let o=s===null?"":Rt(s*r,"s",5);return this.say(s===null?"Not possible: these values do not fit together.":`The loop runs away at ${o}. The picture is that of the settings before.`)}a&&!t&&this.settle(e),this.draw(e)}settle(e){let t=Yu(this.sent);this.took=e.took,this.settled??={answer:this.firsts[this.r].whole,key:Yu(new Map)},this.settled.key!==t&&(this.before=this.settled.answer),this.settled={answer:e,key:t},Yu(this.past[this.at])!==t&&(this.past=[...this.past.slice(0,this.at+1),this.sent],this.at+=1,this.refresh())}draw(e){if([this.firsts[this.r].whole,this.before,e].forEach((s,r)=>{s?.points&&this.curves[r]&&Object.assign(this.curves[r],{x:gs(s.points.time),y:gs(s.points.signed)})}),this.picture?.update?.(),this.figures(e),!e)return;let{scene:t}=this,n=t?.runs.find(s=>s.name===this.live.runs[this.r].name);Object.assign(this.now,this.drawn(e.points,n)),this.before&&Object.assign(this.then,this.drawn(this.before.points,n)),t&&(t.runs.includes(this.now)||t.runs.push(this.then,this.now),n&&Cc.add(n),this.page.changed(t))}drawn(e,t){let n=new Float32Array(0),s=e?.time.length??0,r=[...new Set(this.live.runs[this.r].parameters.map(y=>Xu(y.name)))],a=r.filter(Boolean).length,o=(this.scene?.axes??[]).map(y=>r.indexOf(y)),l=y=>{let m=new Float32Array(3*s);for(let p=0;p<s;p+=1)o.forEach((v,T)=>{m[3*p+T]=y[a*p+v]});return gs(m,3)},c=Int32Array.from(e?.time??[],y=>tg(t,y)),h=l(e?.foot??n),d=l(e?.error??n),u=e?eg(e):-1,f=({values:y})=>[...y.subarray(3*u,3*u+3)],g=u<0?[]:[{kind:"Place",foot:f(h),error:f(d),size:e.size[u],time:e.time[u],line:c[u],cause:""}];return{foot:h,error:d,lines:gs(c),worst:g,size:gs(e?.size??n),time:gs(e?.time??n),feedrate:gs(e?.feedrate??n),stretch:gs(e?.stretch??new Int32Array(0))}}figures(e){let t=e?.short??!1,n=this.firsts[this.r][t?"short":"whole"],{motion:{period:s},short:[r,a]}=this.live.runs[this.r];if(!n)return;let o=this.scene?.runs.find(p=>p.name===this.live.runs[this.r].name),l=this.scene?.tolerance??this.errors?.panels[0].band?.[1]??null,h=[["report",n],["before",t?null:this.before],["now",e]].filter(p=>p[1]!==null),d=document.createElement("tbody"),u=Ye(this.table.tHead??this.table.createTHead(),"tr");this.table.tHead.replaceChildren(u);for(let p of["",...h.map(([v])=>v)])Ye(u,"th","n",p).scope="col";let f=(p,v)=>{let T=Ye(d,"tr");Ye(T,"th","",p).scope="row",h.forEach(([,b])=>v(b,Ye(T,"td","n")))};l!==null&&f(`tolerance ${Rt(l,"um")}`,(p,v)=>{let T=p.figures.part_error_max*1e6<=l;v.className=T?"n":"n poor",Ye(v,"span","seal",T?"PASS":"FAIL")});for(let[p,v,T,b]of ub)p in n.figures&&f(v,(P,C)=>{C.textContent=Rt(P.figures[p]*T,b)});if(f("worst place",(p,v)=>{let T=p.points.time[eg(p.points)],b=tg(o,T);v.textContent=Rt(T,"s",5)+(b?`, line ${b}`:"")}),this.table.tBodies[0]?.remove(),this.table.append(d),!e)return;let g=t?`Short run, from ${Rt(r*s,"s",5)} to ${Rt(a*s,"s",5)}, begun with the state of the report at ${Rt(e.begun*s,"s",5)}`:"Whole part",[y,m]=[n,e].map(p=>Rt(p.figures.part_error_max*1e6,"um"));this.say(`${g}: largest part error ${m}, in the report ${y}.`)}say(e){this.said.textContent=e}commandLine(){return[this.live.command,...this.changed().map(([e,t])=>`--set ${e.name}=${t}`)].join(" ")}async copy(){try{await navigator.clipboard.writeText(this.commandLine()),this.tools.copy.textContent="Copied"}catch{getSelection()?.selectAllChildren(this.command),this.tools.copy.textContent="Selected: press Ctrl-C"}setTimeout(()=>{this.tools.copy.textContent="Copy the command line"},2e3)}save(){let{controller:e,parameters:t}=this.live.runs[this.r],n=new Map(t.map(o=>[o.name,this.valueOf(o)])),s=e.replace(/"@([^"]+)@"/g,(o,l)=>{let c=n.get(l);return Number.isFinite(c)?String(c):"inf"}),r=Ye(this.host,"a"),a=URL.createObjectURL(new Blob([s],{type:"application/toml"}));Object.assign(r,{href:a,download:"controller.toml"}).click(),r.remove(),setTimeout(()=>URL.revokeObjectURL(a),1e3)}};function eg({size:i,stretch:e}){let t=0;return i.forEach((n,s)=>{e[s]&&(n>i[t]||!e[t])&&(t=s)}),t}function tg(i,e){if(!i)return 0;let t=i.time.values,n=0,s=t.length-1;for(;s-n>1;){let r=n+s>>1;t[r]<=e?n=r:s=r}return i.lines.values[e-t[n]<t[s]-e?n:s]??0}var Zu="contourlab-page/1";function Ku(i){let e=new DataView(i).getUint32(0,!0),t=JSON.parse(new TextDecoder().decode(new Uint8Array(i,4,e)));if(t.contract!==Zu)throw new Error(`message of ${t.contract}, this viewer reads ${Zu}`);return t.pictures.map(n=>Ju(n,i,4+e))}function Ju(i,e,t){if(Array.isArray(i))return i.map(n=>Ju(n,e,t));if(i===null||typeof i!="object")return i;if("dtype"in i){let n={f4:Float32Array,f8:Float64Array,i4:Int32Array,u1:Uint8Array},s=i.shape.reduce((a,o)=>a*o,1),r=n[i.dtype];return{values:new r(e,t+i.at,s),shape:i.shape}}return Object.fromEntries(Object.entries(i).map(([n,s])=>[n,Ju(s,e,t)]))}function ig(i){let t=(i&&i.length>1?document.getElementById(i.slice(1)):null)?.querySelector("details");t&&(t.open=!0)}function db(i){let e=i.closest("table"),t=e.tBodies[0],n=i.getAttribute("aria-sort")!=="descending",s=r=>{let a=r.cells[i.cellIndex].textContent;return a==="-"?-1/0:Number(a)};e.querySelectorAll("th").forEach(r=>r.removeAttribute("aria-sort")),i.setAttribute("aria-sort",n?"descending":"ascending"),t.append(...[...t.rows].sort((r,a)=>(n?-1:1)*(s(r)-s(a))||0))}function fb(i,e){let t=document.querySelector(`#lines tr[data-line="${i}"]`),n=document.getElementById("picked");document.querySelectorAll("#lines tr.picked").forEach(r=>r.classList.remove("picked")),n&&(n.textContent=`Line ${i}${t?`: ${t.querySelector("code").textContent}`:" is not in the table"}`);let s=t?.closest(".lines");t?.classList.add("picked"),t&&s&&e&&(s.scrollTop=t.offsetTop-s.clientHeight/2)}function sg(i){let e=(t,n=!0)=>{fb(t,n),i(t)};return document.querySelectorAll("a[href^='#']").forEach(t=>t.addEventListener("click",()=>{ig(t.getAttribute("href")),t.dataset.pick&&e(Number(t.dataset.pick))})),document.querySelectorAll("#lines th button").forEach(t=>t.addEventListener("click",()=>db(t.closest("th")))),document.querySelector("#lines tbody")?.addEventListener("click",t=>{let n=t.target.closest("tr[data-line]");n&&e(Number(n.dataset.line),!1)}),document.querySelector(".lines")?.addEventListener("keydown",t=>{let n={ArrowDown:1,ArrowUp:-1}[t.key],s=[...document.querySelectorAll("#lines tr[data-line]")];if(!n||t.target.closest("button")||!s.length)return;let r=s.findIndex(a=>a.classList.contains("picked"));e(Number(s[Math.min(Math.max(r<0?0:r+n,0),s.length-1)].dataset.line)),t.preventDefault()}),ig(location.hash),e}var pb=560,mb=34;function ag(i){let e=0;for(let{y:n}of i)for(let s=0;s<n.length;s+=1)Math.abs(n[s])>e&&(e=Math.abs(n[s]));if(e<=0)return[1,3];let t=lo(e/2);return[t,t*Math.ceil(1.05*e/t)]}var Rc=class{constructor(e,t,n,s=[],r=[]){this.host=e;this.curves=t;this.rings=n;this.marks=s;this.axes=r;let a=Ye(e,"div","cl-panel");this.canvas=Ye(a,"canvas"),this.tip=new Ss(a),this.canvas.addEventListener("pointermove",o=>this.pointed(o)),this.canvas.addEventListener("pointerleave",()=>this.tip.hide())}host;curves;rings;marks;axes;canvas;tip;radius=0;middle=0;at(e,t){let n=this.rings[1],s=this.radius*(t+2*n)/(3*n),r=e*Math.PI/180;return[this.middle+s*Math.cos(r),this.middle-s*Math.sin(r)]}draw(){let e=Math.min(_r(this.host),Ws()?420:pb),t=bs(this.host),n=co(this.canvas,e,e),[s,r]=this.rings,a=Math.round(r/s);this.middle=e/2,this.radius=e/2-mb,n.fillStyle=t.muted,n.textAlign="center",n.textBaseline="middle";for(let o=0;o<360;o+=45)n.strokeStyle=t.line,rg(n,[this.at(o,-2*r),this.at(o,r)]),n.fillText((o%180?this.axes[1]:this.axes[0])&&o%90===0?`${o>=180?"-":"+"}${this.axes[o%180?1:0]}`:`${o}°`,...this.at(o,r*(1+45/this.radius)));for(let o=-2*a;o<=a;o+=1)n.strokeStyle=o?t.line:t.ink,n.lineWidth=1.1,n.beginPath(),n.arc(this.middle,this.middle,this.radius*(o+2*a)/(3*a),0,7),n.stroke();for(let{x:o,y:l,colour:c,dash:h,alpha:d}of this.curves())n.strokeStyle=Xn(c,t.card),n.globalAlpha=d??1,n.lineWidth=1.5,n.setLineDash(vr[h]),rg(n,Array.from(o,(u,f)=>this.at(u,l[f])));n.globalAlpha=1,n.setLineDash([]);for(let{x:o,y:l,colour:c}of this.marks){n.strokeStyle=Xn(c,t.card);for(let h=0;h<o.length;h+=1)n.beginPath(),n.arc(...this.at(o[h],l[h]),4.5,0,7),n.stroke()}for(let o=-a;o<=a;o+=1){if(o%2&&o!==a)continue;let[l,c]=this.at(67.5,o*s),h=(o>0?"+":"")+Rt(o*s)+(o===a?" um":"");n.lineWidth=3,n.strokeStyle=t.card,n.strokeText(h,l,c),n.fillText(h,l,c)}}pointed(e){let t=576,n=null;for(let o of this.curves())for(let l=0;l<o.x.length;l+=1){let[c,h]=this.at(o.x[l],o.y[l]),d=(c-e.offsetX)**2+(h-e.offsetY)**2;d<t&&([t,n]=[d,[o,l]])}if(!n)return this.tip.hide();let[s,r]=n,a=(s.x[r]%360+360)%360;this.tip.show(e.offsetX,e.offsetY,[[s.name,s.colour],[`${Rt(s.y[r],"um",3)} at ${a.toFixed(1)}°`]])}};function rg(i,e){i.beginPath();let t=!1;for(let[n,s]of e){let r=Number.isFinite(n)&&Number.isFinite(s);r&&t?i.lineTo(n,s):r&&i.moveTo(n,s),t=r}i.stroke()}function og(i,e){let t=o=>({...o,x:o.x.values,y:o.y.values}),n=e.curves.map(t),s=new Set,r,a=()=>{i.replaceChildren();let o=bs(i);ua(i,n.map(l=>({...l,colour:Xn(l.colour,o.card)})),s,()=>r.draw()),r=new Rc(i,()=>n.filter(l=>!s.has(l.name)),ag(n),e.marks.map(t)),r.draw()};return a(),{resize:a,destroy:()=>i.replaceChildren()}}function gb(i){let e=0,t=0,n=0,s=0,r=0,a=0,o=0,l=0,c=0,h=1/0,d=-1/0,u=m=>i.forEach(({angle:p,deviation:v})=>{for(let T=0;T<p.length;T+=1)m(Math.cos(p[T]*Math.PI/180),Math.sin(p[T]*Math.PI/180),v[T])});u((m,p,v)=>{e+=m*m,t+=m*p,n+=p*p,s+=m,r+=p,a+=1,o+=v*m,l+=v*p,c+=v}),e-=s*s/a,n-=r*r/a,t-=s*r/a,o-=c*s/a,l-=c*r/a;let f=e*n-t*t,g=(o*n-l*t)/f,y=(l*e-o*t)/f;return u((m,p,v)=>{h=Math.min(h,v-g*m-y*p),d=Math.max(d,v-g*m-y*p)}),d-h}function lg(i,e){let t=e.causes.map(()=>1),{runs:n}=e,s=(v,T)=>n.map(b=>{let P=b.deviation.values.length,C=Float64Array.from(b.deviation.values);return v.forEach((x,A)=>{if(x!==1)for(let z=0;z<P;z+=1)C[z]-=(1-x)*b.curves.values[A*P+z]}),{name:b.name,colour:b.colour,dash:"solid",x:b.angle.values,y:C,alpha:T}}),r=v=>Rt(gb(v.map(({x:T,y:b})=>({angle:T,deviation:b}))),"um",3),a=s(t,.3),o=ag(a),l=s(t),c,h=Ye(i,"div","cl-sides"),d=Ye(h,"div"),u=Ye(h,"div"),f=Ye(u,"p");f.append("Circular deviation: ");let g=Ye(Ye(f,"b"),"output","",r(l));f.append(` of ${r(a)} as measured, least-squares centre.`);let y=e.causes.map((v,T)=>{let b=Ye(u,"label","cl-slider");Ye(b,"span","",v);let P=Ye(b,"input"),C=Ye(b,"output","","100 %");return Object.assign(P,{type:"range",min:"0",max:"100",value:"100"}),P.addEventListener("input",()=>{t[T]=Number(P.value)/100,C.textContent=`${P.value} %`,l=s(t),g.textContent=r(l),c.draw()}),P}),m=Ye(u,"p","cl-tools");for(let[v,T]of[["Remove all","0"],["As measured","100"]]){let b=Ye(m,"button","",v);b.type="button",b.addEventListener("click",()=>y.forEach(P=>{P.value=T,P.dispatchEvent(new Event("input"))}))}let p=()=>{d.replaceChildren();let v=bs(i);ua(d,l.map(T=>({...T,colour:Xn(T.colour,v.card)})),new Set,()=>{}),c=new Rc(d,()=>[...a,...l],o,[],e.axes),c.draw()};return p(),{resize:p,destroy:()=>i.replaceChildren()}}function _b(i,e,t){switch(e.kind){case"Chart":return To(i,e);case"PolarChart":return og(i,e);case"PathScene":return $m(i,e,t);case"Heat":return Jf(i,e);case"CircleCauses":return lg(i,e);case"LiveLoop":return ng(i,e,t)}}var Pc=class{constructor(e,t){this.places=e;this.page={pick:t,pictures:[...e.values()],changed:n=>this.changed(n)},document.getElementById("cl-style")||(Ye(document.head,"style","",_d+xd).id="cl-style"),e.forEach((n,s)=>this.watch.observe(s)),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.resize()),addEventListener("beforeprint",()=>this.paper(!0)),addEventListener("afterprint",()=>this.paper(!1))}places;drawn=new Map;line=null;watch=new IntersectionObserver(e=>e.forEach(({isIntersecting:t,target:n})=>{t&&this.draw(n)}),{rootMargin:"600px 0px"});sizes=new ResizeObserver(e=>e.forEach(({target:t,contentRect:n})=>{let s=t,r=String(Math.round(n.width));s.dataset.width!==r&&n.width>0&&(s.dataset.width=r,this.drawn.get(s)?.resize())}));page;draw(e){if(!(this.drawn.has(e)||e.closest("[hidden], details:not([open])"))){this.watch.unobserve(e),e.dataset.width=String(Math.round(e.clientWidth-parseFloat(getComputedStyle(e).paddingLeft)*2));try{let t=_b(e,this.places.get(e),this.page);this.drawn.set(e,t),this.line!==null&&t.highlight?.(this.line),this.sizes.observe(e)}catch(t){e.textContent=`This picture could not be drawn: ${t.message}`,console.error(t)}e.dataset.drawn="1"}}changed(e){this.drawn.forEach((t,n)=>{this.places.get(n)===e&&t.update?.()})}highlight(e){this.line=e,this.drawn.forEach(t=>t.highlight?.(e))}resize(){this.drawn.forEach(e=>e.resize())}paper(e){document.documentElement.classList.toggle("printing",e);let t=e?[...this.places.keys()].filter(n=>!this.drawn.has(n)):[];t.forEach(n=>this.draw(n)),this.resize(),t.some(n=>this.drawn.get(n)?.highlight)&&dispatchEvent(new Event("beforeprint"))}};function xb(i){let e=new Map;for(let n of Ku(i)){let s=document.getElementById(n.key);s&&e.set(s,n)}let t=new Pc(e,sg(n=>t.highlight(n)))}function vb(i,e){let t=new Map;for(let s of Ku(e))Ye(i,"h3","",s.title),t.set(Ye(i,"div","plot"),s),Ye(i,"p","",s.caption);let n=new Pc(t,s=>n.highlight(s))}return Tg(yb);})();
