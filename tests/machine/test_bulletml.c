/*
 * test_bulletml.c - BulletML documents on a board: each element and rule as libbulletml answers, bullet.ml and its
 * arguments, scripts that write what documents fly, and documents that mean harm.
 */
#include "rig.h"

/* ---- what libbulletml makes of documents ---- */

struct answer {
    const char *name, *type, *actions;
    const char *want; /* after 3, 10 and 25 frames: number, x, y of each bullet; the origin is in the field's middle */
};

/* The answers are those of libbulletml 0.0.6, with the player at (0, 80) and the root at (0, -100). */
static const struct answer answers[] = {
    { "left operand first", "vertical",
      "<action label='top'><repeat><times>3</times><action><fire><direction "
      "type='absolute'>$rand*180-$rand*40</direction><speed>1+$rand</speed><bullet></bullet></fire></action></repeat></"
      "action>",
      "1 0.20 -103.05,2 2.87 -100.91,3 2.96 -99.18;1 0.90 -113.74,2 12.93 -104.10,3 13.34 -96.29;1 2.40 -136.63,2 "
      "34.47 -110.93,3 35.57 -90.11" },
    { "speed before direction", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>$rand*180</direction><speed>1+$rand</speed><bullet/></fire><fire><direction "
      "type='absolute'>$rand*100</direction><speed>2</speed><bullet></bullet></fire></action>",
      "1 0.79 -102.95,2 1.89 -103.53;1 3.57 -113.30,2 8.50 -115.87;1 9.51 -135.46,2 22.66 -142.31" },
    { "defaults", "vertical",
      "<action label='top'><fire><bullet/></fire><wait>3</wait><fire><speed>3</speed><bullet/></fire></action>",
      "1 0.00 -98.00;1 0.00 -91.00,2 0.00 -82.00;1 0.00 -76.00,2 0.00 -37.00" },
    { "sequence begins", "vertical",
      "<action label='top'><repeat><times>4</times><action><fire><direction type='sequence'>20</direction><speed "
      "type='sequence'>0.25</speed><bullet/></fire></action></repeat></action>",
      "1 0.00 -98.00,2 -0.86 -97.65,3 -1.93 -97.70,4 -3.03 -98.25;1 0.00 -91.00,2 -3.85 -89.43,3 -8.68 -89.66,4 -13.64 "
      "-92.12;1 0.00 -76.00,2 -10.26 -71.81,3 -23.14 -72.42,4 -36.37 -79.00" },
    { "sequence after a default", "vertical",
      "<action label='top'><fire><bullet/></fire><repeat><times>3</times><action><fire><direction "
      "type='sequence'>-30</direction><speed type='sequence'>0.5</speed><bullet/></fire></action></repeat></action>",
      "1 0.00 -98.00,2 1.50 -97.40,3 3.46 -98.00,4 5.00 -100.00;1 0.00 -91.00,2 6.75 -88.31,3 15.59 -91.00,4 22.50 "
      "-100.00;1 0.00 -76.00,2 18.00 -68.82,3 41.57 -76.00,4 60.00 -100.00" },
    { "a bullet over its fire", "vertical",
      "<action label='top'><fire><direction type='absolute'>90</direction><speed>1</speed><bullet><direction "
      "type='absolute'>200</direction><speed>2</speed></bullet></fire><fire><direction "
      "type='sequence'>5</direction><bullet/></fire></action>",
      "1 -1.37 -96.24,2 -0.85 -98.19;1 -6.16 -83.09,2 -3.80 -91.84;1 -16.42 -54.89,2 -10.14 -78.25" },
    { "a bullet after its fire", "vertical",
      "<action label='top'><fire><direction type='absolute'>40</direction><speed>1</speed><bullet><direction "
      "type='sequence'>25</direction><speed type='sequence'>0.75</speed></bullet></fire></action>",
      "1 3.17 -101.48;1 14.27 -106.66;1 38.06 -117.75" },
    { "a turn is remembered", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>100</direction><speed>1</speed><bullet></bullet></fire><changeDirection><direction "
      "type='absolute'>30</direction><term>5</term></changeDirection><repeat><times>2</times><action><fire><direction "
      "type='sequence'>15</direction><bullet/></fire></action></repeat></action>",
      "1 1.97 -99.65,2 1.41 -101.41,3 1.73 -101.00;1 8.86 -98.44,2 6.36 -106.36,3 7.79 -104.50;1 23.64 -95.83,2 16.97 "
      "-116.97,3 20.78 -112.00" },
    { "a speed is remembered", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>100</direction><speed>1</speed><bullet></bullet></fire><changeSpeed><speed "
      "type='absolute'>2</speed><term>5</term></changeSpeed><fire><direction type='absolute'>100</direction><speed "
      "type='sequence'>0.5</speed><bullet/></fire></action>",
      "1 1.97 -99.65,2 4.92 -99.13;1 8.86 -98.44,2 22.16 -96.09;1 23.64 -95.83,2 59.09 -89.58" },
    { "term 0", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet><action><changeSpeed><speed "
      "type='absolute'>3</speed><term>0</term></changeSpeed><changeDirection><direction "
      "type='absolute'>150</direction><term>0</term></changeDirection></action></bullet></fire></action>",
      "1 2.50 -97.40;1 13.00 -79.22;1 35.50 -40.24" },
    { "term 1", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet><action><changeSpeed><speed "
      "type='absolute'>3</speed><term>1</term></changeSpeed><changeDirection><direction "
      "type='absolute'>150</direction><term>1</term></changeDirection></action></bullet></fire></action>",
      "1 2.50 -97.40;1 13.00 -79.22;1 35.50 -40.24" },
    { "term 2", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet><action><changeSpeed><speed "
      "type='absolute'>3</speed><term>2</term></changeSpeed><changeDirection><direction "
      "type='absolute'>150</direction><term>2</term></changeDirection></action></bullet></fire></action>",
      "1 2.73 -99.00;1 13.23 -80.81;1 35.73 -41.84" },
    { "term 3.99", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet><action><changeSpeed><speed "
      "type='absolute'>3</speed><term>3.99</term></changeSpeed><changeDirection><direction "
      "type='absolute'>150</direction><term>3.99</term></changeDirection></action></bullet></fire></action>",
      "1 2.57 -99.43;1 13.35 -82.34;1 35.85 -43.37" },
    { "term -4", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet><action><changeSpeed><speed "
      "type='absolute'>3</speed><term>-4</term></changeSpeed><changeDirection><direction "
      "type='absolute'>150</direction><term>-4</term></changeDirection></action></bullet></fire></action>",
      "1 2.50 -97.40;1 13.00 -79.22;1 35.50 -40.24" },
    { "wait 2.99", "vertical",
      "<action label='top'><repeat><times>3</times><action><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet></bullet></fire><wait>2.99</wait></action></repeat></"
      "action>",
      "1 2.00 -100.00,2 0.00 -100.00;1 9.00 -100.00,2 7.00 -100.00,3 5.00 -100.00;1 24.00 -100.00,2 22.00 -100.00,3 "
      "20.00 -100.00" },
    { "wait 0.99", "vertical",
      "<action label='top'><repeat><times>3</times><action><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet></bullet></fire><wait>0.99</wait></action></repeat></"
      "action>",
      "1 2.00 -100.00,2 2.00 -100.00,3 2.00 -100.00;1 9.00 -100.00,2 9.00 -100.00,3 9.00 -100.00;1 24.00 -100.00,2 "
      "24.00 -100.00,3 24.00 -100.00" },
    { "wait -3", "vertical",
      "<action label='top'><repeat><times>3</times><action><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet></bullet></fire><wait>-3</wait></action></repeat></"
      "action>",
      "1 2.00 -100.00,2 2.00 -100.00,3 2.00 -100.00;1 9.00 -100.00,2 9.00 -100.00,3 9.00 -100.00;1 24.00 -100.00,2 "
      "24.00 -100.00,3 24.00 -100.00" },
    { "wait 1", "vertical",
      "<action label='top'><repeat><times>3</times><action><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet></bullet></fire><wait>1</wait></action></repeat></action>",
      "1 2.00 -100.00,2 1.00 -100.00,3 0.00 -100.00;1 9.00 -100.00,2 8.00 -100.00,3 7.00 -100.00;1 24.00 -100.00,2 "
      "23.00 -100.00,3 22.00 -100.00" },
    { "times -2", "vertical",
      "<action label='top'><repeat><times>-2</times><action><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet></bullet></fire><wait>2</wait></action></repeat></action>",
      "1 2.00 -100.00;1 9.00 -100.00;1 24.00 -100.00" },
    { "times 0", "vertical",
      "<action label='top'><repeat><times>0</times><action><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet></bullet></fire><wait>2</wait></action></repeat></action>",
      "1 2.00 -100.00;1 9.00 -100.00;1 24.00 -100.00" },
    { "times 0.99", "vertical",
      "<action label='top'><repeat><times>0.99</times><action><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet></bullet></fire><wait>2</wait></action></repeat></action>",
      "1 2.00 -100.00;1 9.00 -100.00;1 24.00 -100.00" },
    { "times 1.99", "vertical",
      "<action label='top'><repeat><times>1.99</times><action><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet></bullet></fire><wait>2</wait></action></repeat></action>",
      "1 2.00 -100.00;1 9.00 -100.00;1 24.00 -100.00" },
    { "times 2.01", "vertical",
      "<action label='top'><repeat><times>2.01</times><action><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet></bullet></fire><wait>2</wait></action></repeat></action>",
      "1 2.00 -100.00,2 0.00 -100.00;1 9.00 -100.00,2 7.00 -100.00;1 24.00 -100.00,2 22.00 -100.00" },
    { "times 0.7*10", "vertical",
      "<action label='top'><repeat><times>0.7*10</times><action><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet></bullet></fire><wait>2</wait></action></repeat></action>",
      "1 2.00 -100.00,2 0.00 -100.00;1 9.00 -100.00,2 7.00 -100.00,3 5.00 -100.00,4 3.00 -100.00,5 1.00 -100.00;1 "
      "24.00 -100.00,2 22.00 -100.00,3 20.00 -100.00,4 18.00 -100.00,5 16.00 -100.00,6 14.00 -100.00,7 12.00 -100.00" },
    { "parameters", "vertical",
      "<action label='top'><fireRef label='f'><param>30</param><param>2</param></fireRef><fireRef "
      "label='f'/><actionRef label='a'><param>60</param></actionRef></action><fire label='f'><direction "
      "type='absolute'>$1*2</direction><speed>$2</speed><bulletRef "
      "label='b'><param>$2+1</param></bulletRef></fire><action label='a'><fire><direction "
      "type='absolute'>$1+$2+$3</direction><bullet/></fire></action><bullet label='b'><speed>$1*0.5</speed></bullet>",
      "1 2.60 -101.50,2 0.07 -102.00,3 1.77 -100.94;1 11.69 -106.75,2 0.31 -108.99,3 7.95 -104.23;1 31.18 -118.00,2 "
      "0.84 -123.99,3 21.19 -111.27" },
    { "from 0 to 179", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>0</direction><speed>1</speed><bullet><action><changeDirection><direction "
      "type='absolute'>179</direction><term>10</term></changeDirection></action></bullet></fire></action>",
      "1 0.31 -101.95;1 6.02 -102.00;1 6.58 -87.06" },
    { "from 0 to 180", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>0</direction><speed>1</speed><bullet><action><changeDirection><direction "
      "type='absolute'>180</direction><term>10</term></changeDirection></action></bullet></fire></action>",
      "1 -0.31 -101.95;1 -6.00 -101.95;1 -6.31 -87.00" },
    { "from 0 to 181", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>0</direction><speed>1</speed><bullet><action><changeDirection><direction "
      "type='absolute'>181</direction><term>10</term></changeDirection></action></bullet></fire></action>",
      "1 -0.31 -101.95;1 -6.02 -102.00;1 -6.58 -87.06" },
    { "from 10 to 350", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>10</direction><speed>1</speed><bullet><action><changeDirection><direction "
      "type='absolute'>350</direction><term>10</term></changeDirection></action></bullet></fire></action>",
      "1 0.31 -101.98;1 0.31 -108.96;1 -2.26 -123.74" },
    { "from 180 to 0", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>180</direction><speed>1</speed><bullet><action><changeDirection><direction "
      "type='absolute'>0</direction><term>10</term></changeDirection></action></bullet></fire></action>",
      "1 -0.31 -98.05;1 -6.00 -98.05;1 -6.31 -113.00" },
    { "from 270 to 90", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>270</direction><speed>1</speed><bullet><action><changeDirection><direction "
      "type='absolute'>90</direction><term>10</term></changeDirection></action></bullet></fire></action>",
      "1 -1.95 -100.31;1 -1.95 -106.00;1 13.00 -106.31" },
    { "from 350 to 10", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>350</direction><speed>1</speed><bullet><action><changeDirection><direction "
      "type='absolute'>10</direction><term>10</term></changeDirection></action></bullet></fire></action>",
      "1 -0.31 -101.98;1 -0.31 -108.96;1 2.26 -123.74" },
    { "from 90 to 270", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet><action><changeDirection><direction "
      "type='absolute'>270</direction><term>10</term></changeDirection></action></bullet></fire></action>",
      "1 1.95 -100.31;1 1.95 -106.00;1 -13.00 -106.31" },
    { "by 270", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>20</direction><speed>1</speed><bullet><action><changeDirection><direction "
      "type='relative'>270</direction><term>9</term></changeDirection></action></bullet></fire></action>",
      "1 0.52 -101.92;1 -2.77 -107.62;1 -16.87 -112.75" },
    { "by 540 in all", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>20</direction><speed>1</speed><bullet><action><changeDirection><direction "
      "type='sequence'>18</direction><term>30</term></changeDirection></action></bullet></fire></action>",
      "1 0.96 -101.73;1 6.31 -99.78;1 2.75 -102.56" },
    { "aims once", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>90</direction><speed>2</speed><bullet><action><wait>5</wait><changeDirection><direction "
      "type='aim'>10</direction><term>6</term></changeDirection><wait>7</wait><changeDirection><direction "
      "type='aim'>0</direction><term>4</term></changeDirection></action></bullet></fire></action>",
      "1 4.00 -100.00;1 16.80 -96.71;1 14.17 -67.12" },
    { "accel absolute", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>45</direction><speed>1</speed><bullet><action><accel><horizontal "
      "type='absolute'>0.5</horizontal><vertical "
      "type='absolute'>-0.25</vertical><term>6</term></accel><wait>3</wait><accel><horizontal "
      "type='absolute'>-1</horizontal><term>4</term></accel></action></bullet></fire></action>",
      "1 1.50 -101.46;1 3.74 -107.74;1 -0.65 -122.10" },
    { "speed absolute", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>45</direction><speed>2</speed><bullet><action><wait>2</wait><changeSpeed><speed "
      "type='absolute'>0.5</speed><term>6</term></changeSpeed></action></bullet></fire></action>",
      "1 2.83 -102.83;1 9.02 -109.02;1 14.32 -114.32" },
    { "accel relative", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>45</direction><speed>1</speed><bullet><action><accel><horizontal "
      "type='relative'>0.5</horizontal><vertical "
      "type='relative'>-0.25</vertical><term>6</term></accel><wait>3</wait><accel><horizontal "
      "type='relative'>-1</horizontal><term>4</term></accel></action></bullet></fire></action>",
      "1 1.50 -101.46;1 4.61 -107.74;1 3.97 -122.10" },
    { "speed relative", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>45</direction><speed>2</speed><bullet><action><wait>2</wait><changeSpeed><speed "
      "type='relative'>0.5</speed><term>6</term></changeSpeed></action></bullet></fire></action>",
      "1 2.83 -102.83;1 13.97 -113.97;1 40.48 -140.48" },
    { "accel sequence", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>45</direction><speed>1</speed><bullet><action><accel><horizontal "
      "type='sequence'>0.5</horizontal><vertical "
      "type='sequence'>-0.25</vertical><term>6</term></accel><wait>3</wait><accel><horizontal "
      "type='sequence'>-1</horizontal><term>4</term></accel></action></bullet></fire></action>",
      "1 1.91 -101.66;1 2.86 -114.61;1 -24.03 -147.72" },
    { "speed sequence", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>45</direction><speed>2</speed><bullet><action><wait>2</wait><changeSpeed><speed "
      "type='sequence'>0.5</speed><term>6</term></changeSpeed></action></bullet></fire></action>",
      "1 2.83 -102.83;1 20.15 -120.15;" },
    { "accel of a horizontal document", "horizontal",
      "<action label='top'><fire><direction "
      "type='absolute'>45</direction><speed>1</speed><bullet><action><accel><horizontal "
      "type='relative'>0.5</horizontal><vertical "
      "type='sequence'>-0.125</vertical><term>6</term></accel></action></bullet></fire><fire><direction "
      "type='aim'>10</direction><speed>1</speed><bullet></bullet></fire><fire><direction "
      "type='relative'>10</direction><speed>2</speed><bullet></bullet></fire></action>",
      "1 -1.54 -101.50,2 -0.35 -98.03,3 -0.69 -96.06;1 -10.49 -109.11,2 -1.56 -91.14,3 -3.13 -82.27;1 -32.35 -127.22,2 "
      "-4.17 -76.36,3 -8.34 -52.73" },
    { "vanish goes on", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>90</direction><speed>2</speed><bullet><action><wait>4</wait><vanish/><fire><direction "
      "type='absolute'>0</direction><speed>1</speed><bullet></bullet></fire><fire><direction "
      "type='absolute'>30</direction><speed>1</speed><bullet></bullet></fire><wait>1</wait><fire><direction "
      "type='absolute'>60</direction><speed>1</speed><bullet></bullet></fire></action></bullet></fire><fire><direction "
      "type='absolute'>180</direction><speed>1</speed><bullet></bullet></fire></action>",
      "1 4.00 -100.00,2 0.00 -98.00;2 0.00 -91.00,3 8.00 -104.00,4 10.00 -103.46;2 0.00 -76.00,3 8.00 -119.00,4 17.50 "
      "-116.45" },
    { "actions in turn", "vertical",
      "<action label='top'><fire><direction type='absolute'>90</direction><bullet><actionRef "
      "label='s'/><action><fire><direction "
      "type='absolute'>0</direction><speed>1</speed><bullet></bullet></fire><wait>2</wait><fire><direction "
      "type='absolute'>20</direction><speed>1</speed><bullet></bullet></fire></action><action><fire><direction "
      "type='absolute'>40</direction><speed>1</speed><bullet></bullet></fire></action></bullet></fire></action><action "
      "label='s'><fire><direction "
      "type='absolute'>200</direction><speed>1</speed><bullet></bullet></fire><wait>3</wait></action>",
      "1 2.00 -100.00,2 0.00 -101.00;1 9.00 -100.00,2 0.00 -108.00,3 4.05 -105.64,4 6.21 -103.83,5 2.63 -96.24;1 24.00 "
      "-100.00,2 0.00 -123.00,3 9.18 -119.73,4 15.86 -115.32,5 -2.50 -82.15" },
    { "tops side by side", "vertical",
      "<action label='top1'><repeat><times>3</times><action><fire><direction "
      "type='sequence'>10</direction><bullet/></fire><wait>2</wait></action></repeat></action><action "
      "label='topple'><fire><direction "
      "type='absolute'>100</direction><speed>1</speed><bullet></bullet></fire><repeat><times>3</"
      "times><action><fire><direction "
      "type='sequence'>10</direction><bullet/></fire><wait>3</wait></action></repeat></action><action "
      "label='Top'><fire><direction type='absolute'>0</direction><speed>9</speed><bullet></bullet></fire></action>",
      "1 0.00 -98.00,2 1.97 -99.65,3 1.88 -99.32,4 0.00 -100.00;1 0.00 -91.00,2 8.86 -98.44,3 8.46 -96.92,4 -1.22 "
      "-93.11,5 5.20 -97.00,6 -1.71 -95.30,7 2.30 -98.07;1 0.00 -76.00,2 23.64 -95.83,3 22.55 -91.79,4 -3.82 -78.33,5 "
      "18.19 -89.50,6 -6.84 -81.21,7 13.79 -88.43" },
    { "a top does not come back", "vertical",
      "<action label='go'><fire><direction "
      "type='absolute'>80</direction><speed>1</speed><bullet></bullet></fire></action><action "
      "label='top'><fire><direction "
      "type='absolute'>20</direction><speed>1</speed><bullet></bullet></fire></action><action "
      "label='top2'><wait>2</wait><actionRef label='go'/><actionRef label='top'/><fire><direction "
      "type='absolute'>140</direction><speed>1</speed><bullet></bullet></fire></action>",
      "1 0.68 -101.88,2 0.00 -100.00,3 0.00 -100.00;1 3.08 -108.46,2 6.89 -101.22,3 2.39 -106.58;1 8.21 -122.55,2 "
      "21.67 -103.82,3 7.52 -120.67" },
    { "relative", "vertical",
      "<action label='top'><changeDirection><direction "
      "type='absolute'>100</direction><term>1</term></changeDirection><changeSpeed><speed "
      "type='absolute'>0.5</speed><term>1</term></changeSpeed><wait>3</wait><fire><direction "
      "type='relative'>30</direction><speed type='relative'>1</speed><bullet><action><wait>3</wait><fire><direction "
      "type='relative'>-60</direction><speed "
      "type='relative'>-0.5</speed><bullet/></fire></action></bullet></fire></action>",
      ";1 7.88 -94.04,2 6.31 -97.62;1 25.12 -79.58,2 20.41 -102.75" },
    { "numbers", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>(1+2)*-3/.5+1.-200</direction><speed>1+2*3/4-5/(1+1)</speed><bullet></bullet></"
      "fire><fire><direction "
      "type='absolute'>-(30)</direction><speed>$rank*3</speed><bullet></bullet></fire><fire><direction "
      "type='absolute'>10 *  3</direction><speed>1</speed><bullet></bullet></fire></action>",
      "1 0.00 -100.00,2 -1.50 -102.60,3 1.00 -101.73;1 0.00 -100.00,2 -6.75 -111.69,3 4.50 -107.79;1 0.00 -100.00,2 "
      "-18.00 -131.18,3 12.00 -120.78" },
    { "once round", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>725</direction><speed>1</speed><bullet></bullet></fire><fire><direction "
      "type='absolute'>-400</direction><speed>1</speed><bullet></bullet></fire><fire><direction "
      "type='absolute'>360</direction><speed>2</speed><bullet><action><changeDirection><direction "
      "type='sequence'>-100</direction><term>9</term></changeDirection></action></bullet></fire></action>",
      "1 0.17 -101.99,2 -1.29 -101.53,3 -1.97 -101.65;1 0.78 -108.97,2 -5.79 -106.89,3 -1.68 -102.00;1 2.09 -123.91,2 "
      "-15.43 -118.39,3 -1.68 -72.00" },
    { "the newer change", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>0</direction><speed>1</speed><bullet><action><changeDirection><direction "
      "type='absolute'>90</direction><term>20</term></changeDirection><wait>5</wait><changeDirection><direction "
      "type='absolute'>0</direction><term>10</term></changeDirection><changeSpeed><speed "
      "type='absolute'>3</speed><term>10</term></changeSpeed><wait>4</wait><changeSpeed><speed "
      "type='absolute'>0</speed><term>10</term></changeSpeed></action></bullet></fire></action>",
      "1 0.08 -102.00;1 2.44 -109.83;1 3.67 -119.62" },
    { "repeats in one another", "vertical",
      "<action label='top'><repeat><times>3</times><action><repeat><times>2</times><action><fire><direction "
      "type='absolute'>90+$rand*90</direction><speed>1</speed><bullet></bullet></fire><wait>1</wait></action></"
      "repeat><repeat><times>$rank*4</times><action><fire><direction "
      "type='absolute'>180</direction><speed>2</speed><bullet></bullet></fire></action></repeat><wait>1</wait></"
      "action></repeat></action>",
      "1 1.35 -98.52,2 0.99 -99.87,3 0.00 -100.00,4 0.00 -100.00;1 6.06 -93.35,2 7.93 -98.95,3 0.00 -86.00,4 0.00 "
      "-86.00,5 5.42 -97.43,6 3.50 -96.43,7 0.00 -92.00,8 0.00 -92.00,9 2.32 -98.09,10 1.94 -99.49,11 0.00 -98.00,12 "
      "0.00 -98.00;1 16.16 -82.26,2 22.80 -96.99,3 0.00 -56.00,4 0.00 -56.00,5 18.98 -91.01,6 13.99 -85.71,7 0.00 "
      "-62.00,8 0.00 -62.00,9 13.90 -88.56,10 16.45 -95.70,11 0.00 -68.00,12 0.00 -68.00" },
    { "parameters stay", "vertical",
      "<action label='top'><fire><bulletRef "
      "label='m'><param>70</param><param>5</param></bulletRef></fire></action><bullet "
      "label='m'><action><wait>3</wait><fire><direction "
      "type='absolute'>$1</direction><bullet><action><wait>2</wait><fire><direction "
      "type='absolute'>$1*$2</direction><speed>2</speed><bullet/></fire><fireRef "
      "label='f'/></action></bullet></fire></action></bullet><fire label='f'><direction "
      "type='absolute'>$1+200</direction><bullet/></fire>",
      "1 0.00 -98.00;1 0.00 -91.00,2 4.70 -98.71,3 1.18 -101.62,4 1.16 -95.82;1 0.00 -76.00,2 18.79 -103.84,3 -4.02 "
      "-131.17,4 -4.21 -81.81" },
    { "drawn once", "vertical",
      "<action label='top'><actionRef label='a'><param>$rand*180</param></actionRef></action><action "
      "label='a'><repeat><times>3</times><action><fire><direction "
      "type='absolute'>$1+$rand</direction><speed>1</speed><bullet></bullet></fire></action></repeat></action>",
      "1 1.99 -99.81,2 1.99 -99.80,3 1.99 -99.80;1 8.96 -99.15,2 8.96 -99.12,3 8.95 -99.08;1 23.89 -97.73,2 23.88 "
      "-97.65,3 23.88 -97.56" },
    { "drawn anew", "vertical",
      "<action label='top'><repeat><times>3</times><actionRef "
      "label='a'><param>$rand*180</param></actionRef></repeat></action><action label='a'><fire><direction "
      "type='absolute'>$1</direction><speed>1</speed><bullet></bullet></fire><wait>1</wait></action>",
      "1 1.99 -99.81,2 0.26 -100.97,3 0.00 -100.00;1 8.96 -99.16,2 2.07 -107.73,3 5.42 -104.43;1 23.90 -97.77,2 5.96 "
      "-122.21,3 17.03 -113.93" },
    { "an action in an action", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>10</direction><speed>1</speed><bullet></bullet></fire><action><fire><direction "
      "type='absolute'>50</direction><speed>1</speed><bullet></bullet></fire><wait>2</wait><action><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet></bullet></fire></action></action><fire><direction "
      "type='absolute'>130</direction><speed>1</speed><bullet></bullet></fire></action>",
      "1 0.35 -101.97,2 1.53 -101.29,3 0.00 -100.00,4 0.00 -100.00;1 1.56 -108.86,2 6.89 -105.79,3 7.00 -100.00,4 5.36 "
      "-95.50;1 4.17 -123.64,2 18.39 -115.43,3 22.00 -100.00,4 16.85 -85.86" },
    { "calls itself", "vertical",
      "<action label='top'><actionRef label='a'><param>10</param></actionRef></action><action "
      "label='a'><fire><direction "
      "type='absolute'>$1</direction><speed>1</speed><bullet></bullet></fire><wait>2</wait><actionRef "
      "label='a'><param>$1+35</param></actionRef></action>",
      "1 0.35 -101.97,2 0.00 -100.00;1 1.56 -108.86,2 4.95 -104.95,3 4.92 -100.87,4 2.72 -98.73,5 0.50 -99.13;1 4.17 "
      "-123.64,2 15.56 -115.56,3 19.70 -103.47,4 16.31 -92.39,5 8.00 -86.14,6 -1.22 -86.05,7 -7.71 -90.81,8 -9.66 "
      "-97.41,9 -7.52 -102.74,10 -3.44 -104.91,11 0.00 -104.00,12 1.15 -101.64,13 0.00 -100.00" },
    { "calls itself and comes back", "vertical",
      "<action label='top'><actionRef label='a'><param>3</param></actionRef><fire><direction "
      "type='absolute'>0</direction><speed>3</speed><bullet></bullet></fire></action><action "
      "label='a'><fire><direction "
      "type='absolute'>$1*30</direction><speed>1</speed><bullet></bullet></fire><wait>6-$1*2</"
      "wait><repeat><times>$1-1</times><action><actionRef "
      "label='b'><param>$1-1</param></actionRef></action></repeat></action><action label='b'><fire><direction "
      "type='absolute'>$1*30+180</direction><speed>2</speed><bullet></bullet></fire><wait>1</wait></action>",
      "1 2.00 -100.00,2 -3.46 -98.00,3 -1.73 -99.00,4 0.00 -100.00;1 9.00 -100.00,2 -15.59 -91.00,3 -13.86 -92.00,4 "
      "0.00 -121.00;1 24.00 -100.00,2 -41.57 -76.00,3 -39.84 -77.00" },
    { "changes outlast actions", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>0</direction><speed>1</speed><bullet><action><changeDirection><direction "
      "type='absolute'>120</direction><term>15</term></changeDirection><changeSpeed><speed "
      "type='absolute'>2</speed><term>12</term></changeSpeed></action></bullet></fire><changeDirection><direction "
      "type='absolute'>90</direction><term>8</term></changeDirection><changeSpeed><speed "
      "type='absolute'>1</speed><term>8</term></changeSpeed></action>",
      "1 0.15 -102.07;1 6.52 -109.17;1 33.28 -99.66" },
    { "after the body", "vertical",
      "<action label='top'><repeat><times>2</times><action><fire><direction "
      "type='absolute'>30</direction><speed>1</speed><bullet></bullet></fire><wait>2</wait></action><fire><direction "
      "type='absolute'>90</direction><speed>1</speed><bullet></bullet></fire></repeat><fire><direction "
      "type='absolute'>150</direction><speed>1</speed><bullet></bullet></fire></action>",
      "1 1.00 -101.73,2 0.00 -100.00,3 0.00 -100.00;1 4.50 -107.79,2 7.00 -100.00,3 3.50 -106.06,4 5.00 -100.00,5 2.50 "
      "-95.67;1 12.00 -120.78,2 22.00 -100.00,3 11.00 -119.05,4 20.00 -100.00,5 10.00 -82.68" },
    { "fires that fire", "vertical",
      "<action label='top'><fire><direction "
      "type='absolute'>90</direction><speed>3</speed><bullet><action><repeat><times>3</times><action><wait>2</"
      "wait><fire><direction "
      "type='absolute'>100</direction><speed>1</speed><bullet><action><wait>2</wait><vanish/><fire><direction "
      "type='sequence'>10</direction><speed>2</speed><bullet></bullet></fire></action></bullet></fire></action></"
      "repeat></action></bullet></fire></action>",
      "1 6.00 -100.00;1 27.00 -100.00,4 7.70 -93.66,5 19.97 -99.65,6 13.81 -97.66;1 72.00 -100.00,4 6.37 -63.69,6 "
      "11.49 -67.75,7 16.88 -71.82" },
    { "labels of three kinds", "vertical",
      "<action label='top'><fireRef label='x'/><actionRef label='x'/></action><bullet "
      "label='x'><speed>2</speed></bullet><fire label='x'><direction type='absolute'>60</direction><bulletRef "
      "label='x'/></fire><action label='x'><fire><direction type='absolute'>120</direction><bulletRef "
      "label='x'/></fire></action>",
      "1 3.46 -102.00,2 3.46 -98.00;1 15.59 -109.00,2 15.59 -91.00;1 41.57 -124.00,2 41.57 -76.00" },
    { "the last of a label", "vertical",
      "<action label='top'><fire><direction type='absolute'>60</direction><bulletRef "
      "label='x'/></fire></action><bullet label='x'><speed>1</speed></bullet><bullet "
      "label='x'><speed>3</speed></bullet>",
      "1 5.20 -103.00;1 23.38 -113.50;1 62.35 -136.00" },
    { "too large", "vertical",
      "<action label='top'><repeat><times>99999999999</times><action><fire><direction "
      "type='absolute'>100</direction><speed>1</speed><bullet></bullet></fire></action></repeat><wait>1/0</"
      "wait><fire><direction type='absolute'>40</direction><speed>2</speed><bullet></bullet></fire><fire><direction "
      "type='absolute'>0</direction><speed>1/0</speed><bullet></bullet></fire></action>",
      "1 1.97 -99.65,2 2.57 -103.06;1 8.86 -98.44,2 11.57 -113.79;1 23.64 -95.83,2 30.85 -136.77" },
};

enum { FIELD_W = 320, FIELD_H = 240 };

static struct manifest manifest(void)
{
    struct manifest m = rig_manifest();

    m.bullets = 512;
    m.bulletml_runners = 512;
    m.bullet_values = 1;
    m.screen_w = m.field_w = FIELD_W;
    m.screen_h = m.field_h = FIELD_H;
    m.margin = 32;
    m.has_freeze = 1;
    return m;
}

static const char head[] = "value.def('number', { of = 'bullet' })\n"
                           "bullet.def('orb', { sprite = 'dot', hit = 'none' })\n"
                           "bullet.def('gem', { sprite = 'wink', hit = 'none', bank = 3 })\n"
                           "enemy.def('foe', { sprite = 'wink', hit = { box = { 4, 4 } }, hp = 9 })\n"
                           "player.def('ship', { sprite = 'dot', hit = { circle = 1 } })\n";

/* A game of a document and a script behind `head`. */
static void open_game(struct rig_game *g, struct rig *r, const char *xml, const char *script)
{
    static char text[1 << 14];
    struct manifest m = manifest();

    snprintf(text, sizeof text, "%s%s", head, script);
    rig_script(g, &m, text);
    rig_document(g, "doc", xml);
    rig_power(r, g, NULL);
}

static void close_game(struct rig_game *g, struct rig *r)
{
    rig_free(r);
    rig_game_free(g);
}

/* A frame, with the player at that place of the field. */
static void frame(struct rig *r, int x, int y)
{
    r->b->player.in_game[0] = 1;
    r->b->player.safe_left[0] = 9;
    r->b->player.x[0] = x * FX_ONE;
    r->b->player.y[0] = y * FX_ONE;
    rig_run(r, 1);
}

static int32_t bullet_of(const struct board *b, int number)
{
    EACH_LIVE (i, &b->bullets.s)
        if (b->bullets.value1[i] == number * FX_ONE)
            return (int32_t)i;
    return NO_SLOT;
}

/* Are the bullets where the text says, to 1/50 px? */
static void check_places(const struct answer *a, const struct board *b, const char *want, int at)
{
    uint32_t n = 0;
    double x, y;
    int number, used;

    for (; sscanf(want, "%d %lf %lf%n", &number, &x, &y, &used) == 3; n++) {
        const int32_t i = bullet_of(b, number);
        if (i == NO_SLOT)
            fail_msg("%s: frame %d has no bullet %d", a->name, at, number);
        const double dx = fx_to_double(b->bullets.x[i]) - FIELD_W / 2 - x,
                     dy = fx_to_double(b->bullets.y[i]) - FIELD_H / 2 - y;
        if (dx * dx + dy * dy > 0.02 * 0.02)
            fail_msg("%s: frame %d: bullet %d is off by %.3f, %.3f", a->name, at, number, dx, dy);
        want += used;
        if (*want == ',')
            want++;
    }
    if (n != b->bullets.s.live)
        fail_msg("%s: frame %d has %u bullets, expected %u", a->name, at, b->bullets.s.live, n);
}

static void check_answer(const struct answer *a)
{
    static const int frames[] = { 3, 10, 25 };
    char xml[4096];
    const char *want = a->want;
    struct rig_game g;
    struct rig r;
    int f = 0;

    snprintf(xml, sizeof xml, "<bulletml type='%s'>%s</bulletml>", a->type, a->actions);
    open_game(&g, &r, xml,
              "local n = 0\n"
              "bullet.ml { name = 'doc', kind = 'orb', x = 160, y = 20, seed = 305419896,\n"
              "  on_fire = function(b) n = n + 1 b.number = n end }\n");
    for (int k = 0; k < 3; k++) {
        while (f < frames[k])
            frame(&r, FIELD_W / 2, FIELD_H / 2 + 80), f++;
        check_places(a, r.b, want, f - 1);
        want = strchr(want, ';') ? strchr(want, ';') + 1 : "";
    }
    close_game(&g, &r);
}

TEST(answers)
{
    for (size_t i = 0; i < sizeof answers / sizeof *answers; i++)
        check_answer(&answers[i]);
}

/* ---- bullet.ml ---- */

/* Runs so many frames; the script's `out` says what it saw. */
static const char *said(struct rig *r, const char *name)
{
    static char text[256];
    lua_State *L = r->b->vm.L;

    lua_getglobal(L, "string");
    lua_getfield(L, -1, name);
    snprintf(text, sizeof text, "%s", lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "nil");
    lua_settop(L, 0);
    return text;
}

#define FAN                                                                                                            \
    "<bulletml><action label='top'><fire><direction type='absolute'>90</direction><speed>2</speed><bulletRef "         \
    "label='a'/></fire><fire label='f'><direction type='absolute'>180</direction><bullet/></fire><fire><direction "    \
    "type='absolute'>0</direction><bullet/></fire><wait>5</wait><fire><direction>0</direction><speed>$rank</speed>"    \
    "<bullet label='late'/></fire></action><bullet label='a'><action><wait>3</wait><vanish/></action></bullet>"        \
    "</bulletml>"

TEST(labels)
{
    struct rig_game g;
    struct rig r;

    open_game(
        &g, &r, FAN,
        "string.out = ''\n"
        "local d = bullet.ml { name = 'doc', kind = 'orb', kinds = { a = 'gem' }, x = 160, y = 20, tag = 't',\n"
        "  on_fire = function(b, label) string.out = string.out .. b.kind .. b.bank .. tostring(label) .. ' ' end }\n"
        "task.go(function() wait(2) d.rank = 0.25 string.more = d.name .. d.rank .. d.x .. d.y end)\n"
        "task.go(function() wait(7) string.last = tostring(d.alive) .. bullet.group('t').count end)\n");
    frame(&r, 160, 200);
    assert_string_equal(said(&r, "out"), "gem3a orb0f orb0nil ");
    for (int i = 0; i < 7; i++)
        frame(&r, 160, 200);
    assert_string_equal(said(&r, "out"), "gem3a orb0f orb0nil orb0late ");
    assert_string_equal(said(&r, "more"), "doc0.25160.020.0");
    assert_string_equal(said(&r, "last"), "false3"); /* that with the label a has vanished */
    assert_int_equal(r.b->bullets.s.live, 3);
    bool slow = false;
    EACH_LIVE (i, &r.b->bullets.s)
        slow |= r.b->bullets.speed[i] == FX_ONE / 4;
    assert_true(slow); /* the rank that was written */
    close_game(&g, &r);
}

/* Where bullet 1 is after ten frames of flight at speed 1 in direction 90 (to the right). */
static void check_turned(const char *more, double x, double y)
{
    char script[512];
    struct rig_game g;
    struct rig r;

    snprintf(script, sizeof script,
             "local e = enemy.spawn { kind = 'foe', x = 100, y = 50 }\n"
             "bullet.ml { name = 'doc', kind = 'orb', %s }",
             more);
    open_game(&g, &r,
              "<bulletml><action label='top'><fire><direction type='absolute'>90</direction><bullet><action><accel>"
              "<vertical>1</vertical><term>1</term></accel></action></bullet></fire></action></bulletml>",
              script);
    for (int i = 0; i < 11; i++)
        frame(&r, 160, 200);
    assert_int_equal(r.b->bullets.s.live, 1);
    const double dx = fx_to_double(r.b->bullets.x[0]) - x, dy = fx_to_double(r.b->bullets.y[0]) - y;
    if (dx * dx + dy * dy > 1e-6)
        fail_msg("%s: it is off by %f, %f", more, dx, dy);
    close_game(&g, &r);
}

/* accel shows in the move after the next: nine of the ten frames go down as well. */
TEST(turned)
{
    check_turned("x = 100, y = 50", 110, 59);
    check_turned("x = 100, y = 50, speed = 2", 120, 68);
    check_turned("x = 100, y = 50, mirror = true", 90, 59);
    check_turned("x = 100, y = 50, angle = 90", 91, 60);
    check_turned("x = 100, y = 50, angle = 90, mirror = true", 91, 40);
    check_turned("from = e, dx = 9", 119, 59);
}

TEST(follows)
{
    static const char doc[] = "<bulletml><action label='top'><changeSpeed><speed>1</speed><term>1</term></changeSpeed>"
                              "<changeDirection><direction type='absolute'>90</direction><term>1</term>"
                              "</changeDirection><wait>6</wait><fire><speed>0</speed><bullet/></fire><wait>9</wait>"
                              "</action></bulletml>";
    struct rig_game g;
    struct rig r;

    open_game(&g, &r, doc,
              "local e = enemy.spawn { kind = 'foe', x = 100, y = 50 }\n"
              "local d = bullet.ml { name = 'doc', kind = 'orb', from = e }\n"
              "local f = enemy.spawn { kind = 'foe', x = 100, y = 90 }\n"
              "local s = bullet.ml { name = 'doc', kind = 'gem', from = f, steer = true }\n"
              "e:move { x = 130, y = 50, over = 3 }\n"
              "task.go(function() wait(8) string.at = e.x .. ' ' .. f.x .. ' ' .. d.x e:remove() wait(1)\n"
              "  string.over = tostring(d.alive) .. tostring(s.alive) end)\n");
    for (int i = 0; i < 10; i++)
        frame(&r, 160, 200);
    assert_string_equal(said(&r, "at"), "130.0 107.0 130.0");
    assert_string_equal(said(&r, "over"), "falsetrue");
    assert_int_equal(r.b->bullets.x[0], 130 * FX_ONE);
    assert_int_equal(r.b->bullets.x[1], 105 * FX_ONE);
    close_game(&g, &r);
}

#define STREAM                                                                                                         \
    "<bulletml><action label='top'><repeat><times>1000</times><action><fire><speed>$1</speed><bullet/></fire>"         \
    "<wait>1</wait></action></repeat></action></bulletml>"

/* It ends with its owner, or by stop; loop begins anew. */
TEST(owner)
{
    struct rig_game g;
    struct rig r;

    open_game(&g, &r, STREAM,
              "local e = enemy.spawn { kind = 'foe', x = 100, y = 50 }\n"
              "task.own(e, function()\n"
              "  string.d = bullet.ml { name = 'doc', kind = 'orb', x = 9, y = 9, params = { 0.25 } }\n"
              "end)\n"
              "task.go(function() wait(4) e:remove() end)\n"
              "task.go(function() wait(8) local e = bullet.ml { name = 'doc', kind = 'orb', x = 9, y = 9 }\n"
              "  wait(2) e:stop() string.out = tostring(e.alive) .. tostring(string.d.alive)\n"
              "  e:stop() e.rank = 1 string.none = tostring(e.rank) wait(forever) end)\n");
    for (int i = 0; i < 14; i++)
        frame(&r, 160, 200);
    assert_int_equal(r.b->bullets.s.live, 6);
    assert_string_equal(said(&r, "out"), "falsefalse");
    assert_string_equal(said(&r, "none"), "nil");
    assert_int_equal(r.b->bullets.speed[0], FX_ONE / 4);
    assert_int_equal(r.b->ml_roots.s.live, 0);
    assert_int_equal(r.b->ml_runners.s.live, 0);
    close_game(&g, &r);
    open_game(&g, &r,
              "<bulletml><action label='top'><fire><bullet/></fire><wait>1</wait></action><action label='top2'>"
              "<wait>9</wait><fire><bullet/></fire></action></bulletml>",
              "bullet.ml { name = 'doc', kind = 'orb', x = 9, y = 9, loop = true }");
    for (int i = 0; i < 10; i++)
        frame(&r, 160, 200);
    assert_int_equal(r.b->bullets.s.live, 5); /* every other frame; what comes after nine never comes */
    close_game(&g, &r);
}

static void check_refused(const char *call, const char *sentence)
{
    struct manifest m = manifest();
    char text[2048];
    struct rig_game g;
    struct rig r;

    snprintf(text, sizeof text, "%s%s", head, call);
    rig_script(&g, &m, text);
    rig_document(&g, "doc", FAN);
    rig_power_any(&r, &g, NULL);
    const struct board_fault *fault = rig_fault(&r);
    if (!fault || !strstr(fault->message, sentence))
        fail_msg("%s: expected \"%s\", got \"%s\"", call, sentence, fault ? fault->message : "no fault");
    close_game(&g, &r);
}

TEST(arguments)
{
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    check_refused("bullet.ml { kind = 'orb', x = 1, y = 1 }", "bullet.ml: name: expected");
    check_refused("bullet.ml { name = 'dok', kind = 'orb', x = 1, y = 1 }",
                  "bullet.ml: name: no bulletml/dok.xml in the game (did you mean \"doc\"?)");
    check_refused("bullet.ml { name = 'doc', x = 1, y = 1 }", "bullet.ml: kind: expected");
    check_refused("bullet.ml { name = 'doc', kind = 'orb' }", "bullet.ml: ");
    check_refused("bullet.ml { name = 'doc', kind = 'orb', x = 1, y = 1, rank = 1.5 }",
                  "rank: expected a number from 0");
    check_refused("bullet.ml { name = 'doc', kind = 'orb', x = 1, y = 1, speed = 0 }", "bullet.ml: speed: expected");
    check_refused("bullet.ml { name = 'doc', kind = 'orb', x = 1, y = 1, kinds = { b = 'gem' } }",
                  "kinds: unknown label \"b\"");
    check_refused("bullet.ml { name = 'doc', kind = 'orb', x = 1, y = 1, kinds = { a = 'gam' } }",
                  "(did you mean \"gem\"?)");
    check_refused("bullet.ml { name = 'doc', kind = 'orb', x = 1, y = 1, kinds = { 'gem' } }", "got key 1");
    check_refused(
        "bullet.ml { name = 'doc', kind = 'orb', x = 1, y = 1, kinds = { zf = 1, ze = 1, zd = 1, zc = 1, zb = 1, "
        "za = 1, zg = 1, zh = 1 } }",
        "kinds: unknown label \"za\"");
    check_refused("bullet.ml { name = 'doc', kind = 'orb', x = 1, y = 1, params = { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 } }",
                  "params: expected at most 9 numbers, got 10");
    check_refused("bullet.ml { name = 'doc', kind = 'orb', x = 1, y = 1, params = { a = 1 } }",
                  "params: expected a list");
    check_refused("bullet.ml { name = 'doc', kind = 'orb', x = 1, y = 1, params = { 'a' } }",
                  "params: expected a number");
    check_refused("bullet.ml { name = 'doc', kind = 'orb', x = 1, y = 1, steer = true }", "steer: requires `from`");
    rig_script(&g, &m, "bullet.ml { name = 'doc' }");
    rig_power_any(&r, &g, NULL);
    assert_non_null(strstr(rig_fault(&r)->message, "add `bulletml = 1024` to `board`"));
    close_game(&g, &r);
}

/* ---- scripts and documents ---- */

#define LINE                                                                                                           \
    "<bulletml><action label='top'><fire><direction type='absolute'>90</direction><bullet><action><wait>4</wait>"      \
    "<changeSpeed><speed type='relative'>1</speed><term>4</term></changeSpeed><wait>20</wait><fire><speed>0</speed>"   \
    "<bullet/></fire></action></bullet></fire></action></bulletml>"

/* What the bullet of LINE does when a script does this to b in frame 5. */
static void check_written(const char *what, double x, double y, uint32_t runners)
{
    char script[512];
    struct rig_game g;
    struct rig r;

    snprintf(script, sizeof script,
             "local b bullet.ml { name = 'doc', kind = 'orb', x = 100, y = 50, on_fire = function(c) b = b or c end }\n"
             "task.go(function() wait(5) %s wait(forever) end)\n",
             what);
    open_game(&g, &r, LINE, script);
    for (int i = 0; i < 20; i++)
        frame(&r, 160, 200);
    const int32_t i = r.b->bullets.s.live ? 0 : NO_SLOT;
    if (i == NO_SLOT
            ? x >= 0
            : fx_abs(r.b->bullets.x[0] - (fx)(x * FX_ONE)) > 9 || fx_abs(r.b->bullets.y[0] - (fx)(y * FX_ONE)) > 9)
        fail_msg("%s: it is at %f, %f", what, fx_to_double(r.b->bullets.x[0]), fx_to_double(r.b->bullets.y[0]));
    if (r.b->ml_runners.s.live != runners)
        fail_msg("%s: %u runners", what, r.b->ml_runners.s.live);
    close_game(&g, &r);
}

/* Alone: speed 1 up to frame 5, then 1.25, 1.5, 1.75, then 2. */
TEST(written)
{
    check_written("", 100 + 5 + 4.5 + 11 * 2, 50, 1);
    check_written("b.x = 50", 50 + 1 + 4.5 + 11 * 2, 50, 1);
    check_written("b.dir = 90", 104, 50 + 1 + 4.5 + 11 * 2, 1);
    check_written("b.speed = 3", 104 + 3 + 10.5 + 11 * 4, 50, 1);
    check_written("b.vx = 0 b.vy = -2", 104, 50 - 2 - 7.5 - 11 * 3, 1);
    check_written("b.frozen = 6", 100 + 5 + 4.5 + 5 * 2, 50, 1);
    check_written("b:remove()", -1, 0, 0);
    check_written("b.motion = motion.def { { wait = 1 } }", 119, 50, 0);
}

/* RAM is spoilt and restored after every frame, and nothing changes. */
TEST(torture)
{
    static const char doc[] =
        "<bulletml><action label='top'><repeat><times>40</times><action><fire><direction type='sequence'>37</direction>"
        "<speed>0.5+$rand</speed><bulletRef label='b'><param>$rand*3</param></bulletRef></fire><wait>1</wait></action>"
        "</repeat></action><bullet label='b'><action><repeat><times>4</times><action><changeDirection><direction "
        "type='sequence'>$1</direction><term>5</term></changeDirection><accel><vertical>$rand-0.5</vertical>"
        "<term>9</term></accel><wait>4+$rand*3</wait><fire><bullet/></fire></action></repeat><vanish/></action>"
        "</bullet></bulletml>";
    static const char script[] =
        "bullet.ml { name = 'doc', kind = 'orb', x = 160, y = 60, loop = true, params = { 1, 2 },\n"
        "  on_fire = function(b, label) b.tag = label or 'none' end }\n"
        "task.go(function() while true do wait(9) bullet.group('b').frozen = 3 wait(1) bullet.clear { x = 160, y = 90, "
        "radius = 20 } end end)";
    struct rig_game g;
    struct rig r, t;

    open_game(&g, &r, doc, script);
    rig_power(&t, &g, NULL);
    for (int i = 0; i < 160; i++) {
        frame(&r, 160, 200);
        frame(&t, 160, 200);
        rig_spoil(&t);
        if (board_hash(r.b) != board_hash(t.b))
            fail_msg("frame %d differs", i);
    }
    assert_true(r.b->ml_runners.s.live > 10 && r.b->ml_frames.s.live > 5 && r.b->ml_params.s.live > 5);
    assert_null(rig_fault(&r));
    rig_free(&t);
    close_game(&g, &r);
}

/* ---- harm ---- */

/* The fault that a document of these actions leads to, or "". */
static const char *harm(const char *actions, int frames)
{
    static char out[512];
    char xml[4096];
    struct rig_game g;
    struct rig r;

    snprintf(xml, sizeof xml, "<bulletml>\n%s</bulletml>", actions);
    open_game(&g, &r, xml, "bullet.ml { name = 'doc', kind = 'orb', x = 160, y = 20 }");
    for (int i = 0; i < frames && !rig_fault(&r); i++)
        if (board_tick(r.b, (const uint16_t[MAX_PLAYERS]){ 0 })->fault)
            break;
    snprintf(out, sizeof out, "%s", rig_fault(&r) ? rig_fault(&r)->message : "");
    close_game(&g, &r);
    return out;
}

TEST(harm)
{
    assert_string_equal(
        harm("<action "
             "label='top'><repeat><times>1000000000</times>\n<action><fire><bullet/></fire></action></repeat></action>",
             3),
        "bulletml/doc.xml:3: more than 100000 commands in one frame (repeat without a wait?)");
    assert_string_equal(harm("<action label='top'><actionRef label='top'/></action>", 3),
                        "bulletml/doc.xml:2: more than 100000 commands in one frame (repeat without a wait?)");
    assert_string_equal(
        harm("<action label='top'><actionRef label='a'/></action>\n<action "
             "label='a'><repeat><times>2</times><action><actionRef label='a'/></action></repeat></action>",
             3),
        "");
    /* a bullet that fires itself twice a frame: the pools fill */
    assert_string_equal(
        harm("<action label='top'><fire><bulletRef label='b'/></fire></action><bullet "
             "label='b'><speed>0</speed><action><repeat><times>99999</times><action><fire><bulletRef "
             "label='b'/></fire><fire><bulletRef label='b'/></fire><wait>1</wait></action></repeat></action></bullet>",
             60),
        "");
    assert_string_equal(
        harm("<action "
             "label='top'><wait>99999999999</wait><fire><direction>1/0</direction><speed>-1/0</"
             "speed><bullet><action><changeSpeed><speed "
             "type='sequence'>9999999999</speed><term>9999999999</term></changeSpeed><changeDirection><direction "
             "type='sequence'>1/0</direction><term>3</term></changeDirection><accel><horizontal>-1/0</"
             "horizontal><vertical "
             "type='sequence'>1/0</vertical><term>-1/0</term></accel></action></bullet></fire></action>",
             20),
        "");
}

/* A byte of a program set to anything: refused, or it runs to some end. */
TEST(mutations)
{
    char err[256];
    struct manifest m = manifest();
    char text[2048];
    uint8_t *out;
    size_t size;
    struct rng rng;
    int good = 0, bad = 0;

    assert_true(
        rig_compile("<bulletml><action label='top'><actionRef "
                    "label='a'><param>$rand*3</param></actionRef><repeat><times>2</times><action><fire><speed>$1+2</"
                    "speed><bulletRef label='b'><param>$rank-3</param></bulletRef></fire><wait>2</wait><fireRef "
                    "label='f'/></action></repeat></action><action "
                    "label='a'><accel><horizontal>$1</horizontal><term>4</term></accel><wait>1</wait></action><fire "
                    "label='f'><bullet/></fire><bullet "
                    "label='b'><action><changeDirection><direction>3</direction><term>$1</term></"
                    "changeDirection><vanish/></action></bullet></bulletml>",
                    &out, &size, err, sizeof err));
    snprintf(text, sizeof text, "%sbullet.ml { name = 'doc', kind = 'orb', x = 160, y = 20 }", head);
    rng_seed(&rng, 5);
    for (size_t at = 0; at < size; at++)
        for (int k = 0; k < 3; k++) {
            const uint8_t was = out[at];
            out[at] = (uint8_t)(k == 2 ? rng_next(&rng) : was ^ 1u << rng_below(&rng, 8));
            struct rig_game g;
            struct rig r;
            if (ml_check(out, size, err, sizeof err)) {
                good++;
                rig_script(&g, &m, text);
                rig_lump(&g, "bulletml/doc", out, size);
                rig_power(&r, &g, NULL);
                for (int f = 0; f < 12 && !rig_fault(&r); f++)
                    board_tick(r.b, (const uint16_t[MAX_PLAYERS]){ 0 });
                close_game(&g, &r);
            } else
                bad++;
            out[at] = was;
        }
    assert_true(ml_check(out, size, err, sizeof err));
    assert_true(good > 100 && bad > 300);
    for (size_t n = 0; n < size; n++)
        assert_false(ml_check(out, n, err, sizeof err));
    free(out);
}

RUN_TESTS(NULL, NULL)
