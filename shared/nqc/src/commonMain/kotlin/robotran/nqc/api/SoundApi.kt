package robotran.nqc.api

import robotran.nqc.config.ParameterLimit.FREQUENCY
import robotran.nqc.config.ParameterLimit.SOUND
import robotran.nqc.config.ParameterLimit.TONE_TIME

private val TONE = ApiHelp(
    "Plays a tone: its frequency in hertz, and its length in hundredths of a second. The program goes on at once.",
    "Spielt einen Ton: Frequenz in Hertz und Länge in Hundertstelsekunden. Das Programm läuft sofort weiter.",
    "Toca un tono: frecuencia en hercios y duración en centésimas de segundo. El programa sigue enseguida.",
)

internal val SOUND_API = api(NqcApiGroup.SOUND) {
    function(
        "PlaySound(const int sound)",
        "asm { 0x51, sound };",
        ApiHelp(
            "Plays one of the six sounds of the brick, such as SOUND_UP.",
            "Spielt einen der sechs Klänge des Steins, etwa SOUND_UP.",
            "Toca uno de los seis sonidos del ladrillo, como SOUND_UP.",
        ),
        SOUND,
    )
    function(
        "PlayTone(const int frequency, const int time)",
        "asm { 0x23, frequency, frequency >> 8, time };",
        TONE,
        FREQUENCY,
        TONE_TIME,
        targets = FIRST,
    )
    function(
        "PlayTone(const int &frequency, const int time)",
        "if (__type(frequency) == 2) asm { 0x23, \$frequency : 0x2000004, time }; " +
            "else asm { 0x02, \$frequency : 0x3000001, time };",
        TONE,
        FREQUENCY,
        TONE_TIME,
        targets = SECOND,
    )
    function(
        "MuteSound()",
        "asm { 0xd0 };",
        ApiHelp("Switches all sounds off.", "Schaltet alle Klänge aus.", "Apaga todos los sonidos."),
        targets = SECOND,
    )
    function(
        "UnmuteSound()",
        "asm { 0xe0 };",
        ApiHelp("Switches sounds on again.", "Schaltet Klänge wieder ein.", "Vuelve a encender los sonidos."),
        targets = SECOND,
    )
    function(
        "ClearSound()",
        "asm { 0x80 };",
        ApiHelp(
            "Forgets all sounds that wait to be played.",
            "Vergisst alle Klänge, die noch gespielt werden sollen.",
            "Olvida todos los sonidos que faltan por tocar.",
        ),
        targets = SECOND,
    )
    constants(
        "SOUND_CLICK=0 SOUND_DOUBLE_BEEP=1 SOUND_DOWN=2 SOUND_UP=3 SOUND_LOW_BEEP=4 SOUND_FAST_UP=5",
        ApiHelp("A sound of the brick.", "Ein Klang des Steins.", "Un sonido del ladrillo."),
    )
}
