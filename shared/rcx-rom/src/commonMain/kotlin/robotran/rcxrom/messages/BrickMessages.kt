package robotran.rcxrom.messages

import robotran.language.Language
import robotran.language.choose
import robotran.rcxrom.call.RomCallText
import robotran.rcxrom.call.RomGap
import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.controls.MotorMode
import robotran.rcxrom.controls.MotorPort
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.infrared.InfraredRange
import robotran.rcxrom.program.ProgramFailure

/**
 * What is said of a brick, in some language: of its ROM calls in the log, which may be part of a sentence and has no
 * full stop; and of what its display cannot say.
 */
interface BrickMessages {
    /**
     * Where in a program something happened, at the beginning of a sentence: `Line 7`.
     *
     * @param line from 1.
     * @param file null if the program has only one.
     */
    fun place(line: Int, file: String?): String

    /** What it means that the display shows the numbers of [failure], and what to do; whole sentences. */
    fun failureShown(failure: ProgramFailure): String

    /** The same if only a thread of the program cannot go on. */
    fun threadFailureShown(failure: ProgramFailure): String

    /** Why the robot stopped when its program came to its end with motors running, and how to go on driving. */
    fun motorsBrakedAtEnd(): String

    fun unknownRoutine(): String

    fun tooFewArguments(routine: String, needed: Int, given: Int): String

    /** @param group the high byte that the routine wants in its first argument. */
    fun wrongCodeGroup(routine: String, group: Int): String

    fun unknownCode(code: Int): String

    fun notModelled(routine: String, gap: RomGap): String

    /** @param received what was said of the call that took the message. */
    fun messageNotModelled(received: String, gap: RomGap): String

    /** A routine that only changes the processor's settings, named as in the ROM's table. */
    fun setUp(routine: String): String

    /**
     * @param ignoredMode a mode that there is none of; the motor goes on in [mode].
     * @param countedPower a power that is not 0..7 and counts as [power].
     */
    fun motor(port: MotorPort, mode: MotorMode, power: Int, ignoredMode: Int?, countedPower: Int?): String

    /** @param port 1..3. */
    fun readSensor(port: Int): String

    fun sensorPower(port: Int, active: Boolean): String

    /** @param ports 1..3. */
    fun sensorPowers(ports: List<Int>, active: Boolean): String

    fun buttons(held: List<BrickButton>): String

    fun onOffKey(held: Boolean): String

    fun battery(raw: Int): String

    fun clearDisplay(): String

    fun refreshDisplay(): String

    /** @param code one of those at [RomCode] that begin with `SEGMENT_`. */
    fun segment(code: Int, shown: Boolean): String

    /** What is lit on the display, for somebody who cannot see it. */
    fun icon(icon: LcdIcon): String

    /**
     * @param text the number with its sign and point.
     * @param shortened the number asked for if it has too many digits.
     * @param unknownPoint a code of a decimal point that there is none of.
     */
    fun displayNumber(text: String, shortened: Int?, unknownPoint: Int?): String

    fun programDigit(digit: Int): String

    fun programDigitStays(number: Int): String

    fun queued(sound: String): String

    fun playedAtOnce(sound: String): String

    fun dropped(sound: String): String

    /** @param played 0..5, what really sounds for [number]. */
    fun systemSound(number: Int, played: Int): String

    fun tone(hertz: Int, milliseconds: Int): String

    fun pause(milliseconds: Int): String

    fun soundPlaying(playing: Boolean): String

    fun powerOff(): String

    fun startTimer(): String

    fun stopTimer(): String

    fun resetMinuteTimer(): String

    fun startInfrared(): String

    fun stopInfrared(): String

    fun infraredRange(range: InfraredRange): String

    /** @param address where the data of messages 0x45 will go; 0 for nowhere. */
    fun transferPointer(address: Int): String

    fun dataWaiting(waiting: Boolean): String

    fun received(bytes: Int): String

    fun sent(bytes: Int): String

    fun stillSending(): String

    fun infraredOff(): String

    /** @param longest how many bytes a short message has at most. */
    fun wrongMessageLength(bytes: Int, longest: Int): String

    companion object {
        fun of(language: Language): BrickMessages =
            language.choose(EnglishBrickMessages, SpanishBrickMessages, GermanBrickMessages)
    }
}

/** As it is printed on the brick. */
internal fun buttonName(button: BrickButton) = when (button) {
    BrickButton.ON_OFF -> "On-Off"
    BrickButton.VIEW -> "View"
    BrickButton.PRGM -> "Prgm"
    BrickButton.RUN -> "Run"
}

internal fun hexadecimal(value: Int) = RomCallText.hexadecimal(value)
