package robotran.robolang.messages

import robotran.brick.kind.BrickKind
import robotran.language.quoted

/** The messages about the bricks in German. */
internal object GermanBrickKindMessages : BrickKindMessages {
    override fun wrongBrick(program: BrickKind, robot: BrickKind) =
        "Dieses Programm ist für einen $program, aber der Roboter hat einen $robot. Nimm einen anderen Roboter, oder " +
            "ändere diese Zeile."

    override fun missingBrick(suggestion: String?) =
        "Sag, welcher Stein: \"brick rcx\" oder \"brick nxt\".${didYouMean(suggestion)}"

    override fun noSonar() =
        "Ein RCX hat keinen Ultraschallsensor, der den Abstand misst. Nimm einen Stoßfühler, oder einen Roboter mit " +
            "NXT."

    override fun noColourSensor() = "Ein RCX hat keinen Farbsensor. Nimm \"light\", oder einen Roboter mit NXT."

    override fun noSoundSensor() = "Ein RCX hat keinen Geräuschsensor. Nimm einen Roboter mit NXT."

    override fun noMotorDegrees() =
        "Die Motoren eines RCX zählen keine Grade. Lass sie eine Zeit lang drehen, oder nimm einen Roboter mit NXT."

    override fun noNxtButton() = "Die Tasten eines RCX heißen run, view und prgm. Nimm eine von ihnen."

    override fun portOutOfRange(last: Int) = if (last == BrickKind.NXT.inputPorts) {
        "Die Sensoren heißen 1, 2, 3 und 4, zum Beispiel \"sensor 2\"."
    } else {
        "Die Sensoren heißen 1, 2 und 3, zum Beispiel \"sensor 2\"."
    }

    override fun portShared(one: String, other: String, port: Int, example: String) =
        "${quoted(one)} und ${quoted(other)} können nicht beide an Eingang $port sein. Sag im Kopf, wo einer der " +
            "Sensoren ist, zum Beispiel ${quoted(example)}."

    override fun settingTwice(setting: String) = "Eine Zeile ${quoted(setting)} gibt es schon."

    override fun missingNxtButton(suggestion: String?) =
        "Sag, welche Taste: \"button enter\", \"button left\", \"button right\" oder \"button escape\"." +
            didYouMean(suggestion)

    override fun missingNxtMotorCommand(motor: String, suggestion: String?) =
        "Sag, was Motor $motor tun soll: forward, backward, stop, float, power oder turn.${didYouMean(suggestion)}"

    override fun textNotShownOnNxt(character: String) =
        "Die Anzeige kann ${quoted(character)} nicht zeigen. Sie hat die Buchstaben a bis z, Ziffern und Zeichen."

    override fun colourNeeded(text: String) =
        "Hier muss eine Farbe stehen, zum Beispiel \"red\", und ${quoted(text)} ist keine."

    private fun didYouMean(suggestion: String?) = if (suggestion == null) "" else " Meinst du ${quoted(suggestion)}?"
}
