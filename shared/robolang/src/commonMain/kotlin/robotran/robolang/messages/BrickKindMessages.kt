package robotran.robolang.messages

import robotran.brick.kind.BrickKind

/** The messages about what one of the bricks has and the other one lacks. */
interface BrickKindMessages {
    /** The header names [program], but the robot has [robot]. */
    fun wrongBrick(program: BrickKind, robot: BrickKind): String

    fun missingBrick(suggestion: String?): String

    /** What an RCX lacks, and what to do instead. */
    fun noSonar(): String

    fun noColourSensor(): String

    fun noSoundSensor(): String

    /** The motors of an RCX do not count degrees. */
    fun noMotorDegrees(): String

    /** An RCX has other buttons. */
    fun noNxtButton(): String

    /** There is no port or sensor of that number; [last] is the last one of the brick. */
    fun portOutOfRange(last: Int): String

    /** Two sensors, named by the words that read them, are on one [port]; [example] puts one of them elsewhere. */
    fun portShared(one: String, other: String, port: Int, example: String): String

    /** A line [setting] in the header for which there is one already. */
    fun settingTwice(setting: String): String

    fun missingNxtButton(suggestion: String?): String

    fun missingNxtMotorCommand(motor: String, suggestion: String?): String

    /** The display of an NXT has no such character. */
    fun textNotShownOnNxt(character: String): String

    fun colourNeeded(text: String): String
}
