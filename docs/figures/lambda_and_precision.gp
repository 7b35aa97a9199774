# lambda_and_precision.svg, from results/precision_ladder.csv: how far apart lambda of two formulations is, one point a
# scene, in arithmetic of five precisions. Run in the folder of the project: gnuplot docs/figures/lambda_and_precision.gp
set terminal svg size 760,440 font 'sans-serif,14' background '#ffffff'
set output 'docs/figures/lambda_and_precision.svg'
set datafile separator ','
set logscale xy
set format xy '10^{%T}'
set xlabel 'condition number κ of the scene'
set ylabel 'largest relative difference of λ'
set key outside right center reverse Left samplen 2
set xrange [0.7:1e8]
set yrange [1e-52:1e2]
set grid ytics linecolor rgb '#dddddd'
names = '"float" "double" "long double" "quad" "50 digits"'
roundoff = '5.96e-8 1.11e-16 5.42e-20 9.63e-35 2.67e-51'
colour = '#d62728 #1f77b4 #2ca02c #9467bd #8c564b'
# gnuplot reads the columns of the table by their names; 0 has no place on a logarithmic axis
difference(name) = strcol('scalar') eq name && column('difference') > 0 ? column('difference') : NaN
plot for [k = 1:5] 'results/precision_ladder.csv' using 'kappa':(difference(word(names, k))) with points \
       pointtype 7 pointsize 0.5 linecolor rgb word(colour, k) title word(names, k), \
     for [k = 1:5] 100 * real(word(roundoff, k)) * x with lines linecolor rgb word(colour, k) notitle, \
     NaN with lines linecolor rgb '#777777' title 'bound 100 u κ'
