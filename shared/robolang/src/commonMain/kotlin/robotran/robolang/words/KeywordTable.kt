package robotran.robolang.words

/**
 * How the keywords are written in each language of people: a row for each [Keyword] in its order, a column for each
 * language. The first column is the English that the rest of the code knows them by.
 *
 * `seconds, second` are two spellings; what stands behind the comma is written where another language has its own second
 * spelling. `links; linker before bumper` and `durante; para first` say where another spelling is written: before a
 * keyword, or as the first word of a line. All spellings can be read everywhere.
 *
 * Two keywords may have one spelling, as `to` and `until` in most languages, if only one of them can stand in a `for`
 * line: see [WITHIN_FOR].
 */
internal const val KEYWORD_TABLE = """
en                        | es                            | de
forward                   | adelante                      | vorwärts
backward                  | atrás                         | rückwärts
turn                      | gira                          | drehe
start                     | arranca                       | starte
stop                      | detente                       | stopp
power                     | potencia                      | kraft
motor                     | motor                         | motor
pen                       | lápiz                         | stift
wait                      | espera                        | warte
reset                     | reinicia                      | nulle
beep                      | pita                          | piepse
buzz                      | zumba                         | brumme
play                      | toca                          | spiele
show                      | muestra                       | zeige
clear                     | borra                         | lösche
repeat                    | repite                        | wiederhole
for                       | durante; para first           | für
break                     | sal                           | verlasse
continue                  | continúa                      | weiter
if                        | si                            | wenn
else                      | sino                          | sonst
var                       | sea                           | variable
const                     | constante                     | konstante
procedure                 | procedimiento                 | prozedur
function                  | función                       | funktion
return                    | devuelve                      | zurück
whenever                  | cuando                        | sobald
halt                      | termina                       | schluss
robot                     | robot                         | roboter
end                       | fin                           | ende
left                      | izquierda                     | links; linker before bumper
right                     | derecha                       | rechts; rechter before bumper
down                      | abajo                         | runter
up                        | arriba                        | hoch
turning                   | girando                       | drehend
float                     | libre                         | frei
screen                    | pantalla                      | anzeige
times, time               | veces, vez                    | mal
forever                   | siempre                       | endlos
while                     | mientras                      | solange
until                     | hasta                         | bis
from                      | desde                         | von
to                        | hasta                         | bis
step                      | paso                          | schritt
each                      | cada                          | jedes
in                        | en                            | in
on                        | en                            | an
facing                    | mirando                       | schaut
cm                        | cm                            | cm
degrees, degree           | grados, grado                 | grad
seconds, second           | segundos, segundo             | sekunden, sekunde
milliseconds, millisecond | milisegundos, milisegundo     | millisekunden, millisekunde
bumper                    | parachoques                   | fühler
light                     | luz                           | licht
sensor                    | sensor                        | sensor
button                    | botón                         | taste
run                       | run                           | run
view                      | view                          | view
prgm                      | prgm                          | prgm
timer                     | cronómetro                    | uhr
battery                   | batería                       | batterie
true                      | verdadero                     | wahr
false                     | falso                         | falsch
and                       | y                             | und
or                        | o                             | oder
not                       | no                            | nicht
mod                       | mod                           | mod
brick                     | ladrillo                      | stein
rcx                       | rcx                           | rcx
nxt                       | nxt                           | nxt
sonar                     | sonar                         | sonar
sound                     | sonido                        | geräusch
distance                  | distancia                     | abstand
colour, color             | color                         | farbe
loudness                  | volumen                       | lautstärke
turned                    | girado                        | gedreht
black                     | negro                         | schwarz
blue                      | azul                          | blau
green                     | verde                         | grün
yellow                    | amarillo                      | gelb
red                       | rojo                          | rot
white                     | blanco                        | weiß
enter                     | enter                         | enter
escape                    | escape                        | escape
"""
