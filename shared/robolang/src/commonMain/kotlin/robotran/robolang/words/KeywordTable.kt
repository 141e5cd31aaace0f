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
en                        | es                                 | de                            | fr                          | pt
forward                   | adelante                           | vorwärts                      | avant; avance first         | frente; ande first
backward                  | atrás                              | rückwärts                     | arrière; recule first       | trás; recue first
turn                      | gira                               | drehe                         | tourne                      | gire
start                     | arranca                            | starte                        | démarre                     | comece
stop                      | detente                            | stopp                         | arrête                      | pare
power                     | potencia                           | kraft                         | puissance                   | potência
motor                     | motor                              | motor                         | moteur                      | motor
pen                       | lápiz                              | stift                         | stylo                       | caneta
wait                      | espera                             | warte                         | attends                     | espere
reset                     | reinicia                           | nulle                         | réinitialise                | zere
beep                      | pita                               | piepse                        | bipe                        | apite
buzz                      | zumba                              | brumme                        | bourdonne                   | zumbe
play                      | toca                               | spiele                        | joue                        | toque
show                      | muestra                            | zeige                         | affiche                     | mostre
clear                     | borra                              | lösche                        | efface                      | limpe
repeat                    | repite                             | wiederhole                    | répète                      | repita
for                       | durante; para first                | für                           | pendant; pour first         | por; para first
break                     | sal                                | verlasse                      | sors                        | saia
continue                  | continúa                           | weiter                        | continue                    | continue
if                        | si                                 | wenn                          | si                          | se
else                      | sino                               | sonst                         | sinon                       | senão
var                       | sea                                | variable                      | variable                    | variável
const                     | constante                          | konstante                     | constante                   | constante
procedure                 | procedimiento                      | prozedur                      | procédure                   | procedimento
function                  | función                            | funktion                      | fonction                    | função
return                    | devuelve                           | zurück                        | renvoie                     | devolva
whenever                  | cuando                             | sobald                        | quand                       | quando
halt                      | termina                            | schluss                       | termine                     | encerre
robot                     | robot                              | roboter                       | robot                       | robô
end                       | fin                                | ende                          | fin                         | fim
left                      | izquierda; izquierdo before bumper | links; linker before bumper   | gauche                      | esquerda; esquerdo before bumper
right                     | derecha; derecho before bumper     | rechts; rechter before bumper | droite; droit before bumper | direita; direito before bumper
down                      | abajo                              | runter                        | bas                         | baixo
up                        | arriba                             | hoch                          | haut                        | cima
turning                   | girando                            | drehend                       | tournant                    | girando
float                     | libre                              | frei                          | libre                       | livre
screen                    | pantalla                           | anzeige                       | écran                       | tela
times, time               | veces, vez                         | mal                           | fois                        | vezes, vez
forever                   | siempre                            | endlos                        | toujours                    | sempre
while                     | mientras                           | solange                       | tantque                     | enquanto
until                     | hasta                              | bis                           | jusque                      | até
from                      | desde                              | von                           | de                          | de
to                        | hasta                              | bis                           | à                           | até
step                      | paso                               | schritt                       | pas                         | passo
each                      | cada                               | jedes                         | chaque                      | cada
in                        | en                                 | in                            | dans                        | em
on                        | en                                 | an                            | sur                         | em
facing                    | mirando                            | schaut                        | vers                        | voltado
cm                        | cm                                 | cm                            | cm                          | cm
degrees, degree           | grados, grado                      | grad                          | degrés, degré               | graus, grau
seconds, second           | segundos, segundo                  | sekunden, sekunde             | secondes, seconde           | segundos, segundo
milliseconds, millisecond | milisegundos, milisegundo          | millisekunden, millisekunde   | millisecondes, milliseconde | milissegundos, milissegundo
bumper                    | parachoques                        | fühler                        | contact                     | contato
light                     | luz                                | licht                         | lumière                     | luz
sensor                    | sensor                             | sensor                        | capteur                     | sensor
button                    | botón                              | taste                         | bouton                      | botão
run                       | run                                | run                           | run                         | run
view                      | view                               | view                          | view                        | view
prgm                      | prgm                               | prgm                          | prgm                        | prgm
timer                     | cronómetro                         | uhr                           | chrono                      | cronômetro
battery                   | batería                            | batterie                      | batterie                    | bateria
true                      | verdadero                          | wahr                          | vrai                        | verdadeiro
false                     | falso                              | falsch                        | faux                        | falso
and                       | y                                  | und                           | et                          | e
or                        | o                                  | oder                          | ou                          | ou
not                       | no                                 | nicht                         | non                         | não
mod                       | mod                                | mod                           | mod                         | mod
brick                     | ladrillo                           | stein                         | brique                      | tijolo
rcx                       | rcx                                | rcx                           | rcx                         | rcx
nxt                       | nxt                                | nxt                           | nxt                         | nxt
spike                     | spike                              | spike                         | spike                       | spike
essential                 | essential                          | essential                     | essential                   | essential
technic                   | technic                            | technic                       | technic                     | technic
ev3                       | ev3                                | ev3                           | ev3                         | ev3
microbit                  | microbit                           | microbit                      | microbit                    | microbit
sonar                     | sonar                              | sonar                         | sonar                       | sonar
sound                     | sonido                             | geräusch                      | son                         | som
distance                  | distancia                          | abstand                       | distance                    | distância
colour, color             | color                              | farbe                         | couleur                     | cor
loudness                  | volumen                            | lautstärke                    | volume                      | volume
turned                    | girado                             | gedreht                       | tourné                      | girado
black                     | negro                              | schwarz                       | noir                        | preto
blue                      | azul                               | blau                          | bleu                        | azul
green                     | verde                              | grün                          | vert                        | verde
yellow                    | amarillo                           | gelb                          | jaune                       | amarelo
red                       | rojo                               | rot                           | rouge                       | vermelho
white                     | blanco                             | weiß                          | blanc                       | branco
enter                     | enter                              | enter                         | enter                       | enter
escape                    | escape                             | escape                        | escape                      | escape
"""
