package robotran.blockediting.palette

import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueForm

/** What pupils call a block in English, German and Spanish, by its id. */
internal val SYNONYMS: Map<String, String> = mapOf(
    idOf(ValueForm.DISTANCE) to
        "wall obstacle sonar ultrasonic Wand Abstand Entfernung Hindernis Ultraschall pared obstáculo distancia",
    idOf(LineForm.SONAR) to "ultrasonic distance Ultraschallsensor Abstandssensor Abstand ultrasonidos distancia",
    idOf(ValueForm.BUMPER) to "touch wall Berührung Tastsensor Stoßfühler Wand contacto choque pared",
    idOf(ValueForm.LIGHT) to "bright dark Helligkeit hell dunkel Licht luz claro oscuro",
    idOf(ValueForm.LOUDNESS) to "noise microphone Lautstärke Geräusch Mikrofon ruido volumen micrófono",
    idOf(ValueForm.COLOUR) to "Farbe color",
    idOf(ValueForm.TURNED) to "rotation encoder Drehung Umdrehung gedreht giro girado",
    idOf(ValueForm.TIMER) to "time clock Zeit Uhr Stoppuhr tiempo reloj",
    idOf(LineForm.WAIT) to "pause sleep Pause warte warten espera esperar",
    idOf(LineForm.WAIT_UNTIL) to "bis warte warten hasta espera esperar",
    idOf(LineForm.REPEAT) to "loop Schleife wiederhole wiederholen bucle repite repetir",
    idOf(LineForm.REPEAT_UNTIL) to "loop bis Schleife wiederhole wiederholen hasta bucle repite repetir",
    idOf(LineForm.REPEAT_WHILE) to "loop solange Schleife wiederhole wiederholen mientras bucle repite repetir",
    idOf(LineForm.REPEAT_FOREVER) to "loop always Schleife immer endlos ewig bucle siempre",
    idOf(LineForm.IF) to "when wenn falls si",
    idOf(LineForm.MOVE) to "drive go fahre fahren vorwärts avanza avanzar",
    idOf(LineForm.START_MOVING) to "drive go fahre fahren vorwärts losfahren avanza avanzar",
    idOf(ValueForm.LOGIC) to "both und beide y ambos",
    OR to "either oder o",
    idOf(LineForm.STOP) to "halt brake anhalten Stopp parar frena",
)
