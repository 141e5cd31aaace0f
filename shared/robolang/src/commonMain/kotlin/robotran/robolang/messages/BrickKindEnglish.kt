package robotran.robolang.messages

import robotran.brick.kind.BrickKind
import robotran.language.quoted

/** The messages about the bricks in English. */
internal object EnglishBrickKindMessages : BrickKindMessages {
    override fun wrongBrick(program: BrickKind, robot: BrickKind) =
        "This program is for an $program, but the robot has an $robot. Take another robot, or change this line."

    override fun missingBrick(suggestion: String?) =
        "Say which brick: \"brick rcx\" or \"brick nxt\".${didYouMean(suggestion)}"

    override fun noSonar() =
        "An RCX has no ultrasonic sensor to measure a distance. Use a bumper, or a robot with an NXT."

    override fun noColourSensor() = "An RCX has no colour sensor. Use \"light\", or a robot with an NXT."

    override fun noSoundSensor() = "An RCX has no sound sensor. Use a robot with an NXT."

    override fun noMotorDegrees() =
        "The motors of an RCX do not count degrees. Let one turn for a time, or use a robot with an NXT."

    override fun noNxtButton() = "The buttons of an RCX are run, view and prgm. Use one of these."

    override fun portOutOfRange(last: Int) = if (last == BrickKind.NXT.inputPorts) {
        "The sensors are 1, 2, 3 and 4, such as \"sensor 2\"."
    } else {
        "The sensors are 1, 2 and 3, such as \"sensor 2\"."
    }

    override fun portShared(one: String, other: String, port: Int, example: String) =
        "${quoted(one)} and ${quoted(other)} cannot both be on port $port. Say in the header where one of them is, " +
            "such as ${quoted(example)}."

    override fun settingTwice(setting: String) = "There is a line ${quoted(setting)} already."

    override fun missingNxtButton(suggestion: String?) =
        "Say which button: \"button enter\", \"button left\", \"button right\" or \"button escape\"." +
            didYouMean(suggestion)

    override fun missingNxtMotorCommand(motor: String, suggestion: String?) =
        "Say what motor $motor does: forward, backward, stop, float, power or turn.${didYouMean(suggestion)}"

    override fun textNotShownOnNxt(character: String) =
        "The display cannot show ${quoted(character)}. It has the letters a to z, figures and signs."

    override fun colourNeeded(text: String) = "A colour is needed here, such as \"red\", and ${quoted(text)} is none."

    private fun didYouMean(suggestion: String?) = if (suggestion == null) "" else " Did you mean ${quoted(suggestion)}?"
}
