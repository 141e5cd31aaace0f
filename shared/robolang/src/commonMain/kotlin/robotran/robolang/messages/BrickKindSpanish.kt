package robotran.robolang.messages

import robotran.brick.kind.BrickKind
import robotran.language.quoted

/** The messages about the bricks in Spanish. */
internal object SpanishBrickKindMessages : BrickKindMessages {
    override fun wrongBrick(program: BrickKind, robot: BrickKind) =
        "Este programa es para un $program, pero el robot tiene un $robot. Usa otro robot o cambia esta línea."

    override fun missingBrick(suggestion: String?) =
        "Di qué ladrillo: \"brick rcx\" o \"brick nxt\".${didYouMean(suggestion)}"

    override fun noSonar() =
        "Un RCX no tiene sensor de ultrasonidos para medir distancias. Usa un parachoques, o un robot con NXT."

    override fun noColourSensor() = "Un RCX no tiene sensor de color. Usa \"light\", o un robot con NXT."

    override fun noSoundSensor() = "Un RCX no tiene sensor de sonido. Usa un robot con NXT."

    override fun noMotorDegrees() =
        "Los motores de un RCX no cuentan grados. Haz que giren durante un tiempo, o usa un robot con NXT."

    override fun noNxtButton() = "Los botones de un RCX son run, view y prgm. Usa uno de ellos."

    override fun portOutOfRange(last: Int) = if (last == BrickKind.NXT.inputPorts) {
        "Los sensores son el 1, el 2, el 3 y el 4, como en \"sensor 2\"."
    } else {
        "Los sensores son el 1, el 2 y el 3, como en \"sensor 2\"."
    }

    override fun portShared(one: String, other: String, port: Int, example: String) =
        "${quoted(one)} y ${quoted(other)} no pueden estar los dos en el puerto $port. Di en la cabecera dónde está " +
            "uno de ellos, como en ${quoted(example)}."

    override fun settingTwice(setting: String) = "Ya hay una línea ${quoted(setting)}."

    override fun missingNxtButton(suggestion: String?) =
        "Di qué botón: \"button enter\", \"button left\", \"button right\" o \"button escape\".${didYouMean(
            suggestion,
        )}"

    override fun missingNxtMotorCommand(motor: String, suggestion: String?) =
        "Di qué hace el motor $motor: forward, backward, stop, float, power o turn.${didYouMean(suggestion)}"

    override fun textNotShownOnNxt(character: String) =
        "La pantalla no puede mostrar ${quoted(character)}. Tiene las letras de la a a la z, cifras y signos."

    override fun colourNeeded(text: String) = "Aquí hace falta un color, como \"red\", y ${quoted(text)} no lo es."

    private fun didYouMean(suggestion: String?) =
        if (suggestion == null) "" else " ¿Querías decir ${quoted(suggestion)}?"
}
