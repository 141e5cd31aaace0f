package robotran.rcxrom.messages

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.messages.PlaceMessages
import robotran.brick.messages.place
import robotran.brick.program.ProgramFailure
import robotran.language.Language
import robotran.language.choose
import robotran.rcxrom.call.RomCallText
import robotran.rcxrom.call.RomGap
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.infrared.InfraredRange

/**
 * The texts about an RCX in one language: its ROM calls in the log (parts of sentences, without full stop) and
 * explanations of its display.
 */
interface BrickMessages : PlaceMessages {
    /** Explains the numbers that the display shows for [failure], and what to do; whole sentences. */
    fun failureShown(failure: ProgramFailure): String

    /** The same if only one thread of the program has failed. */
    fun threadFailureShown(failure: ProgramFailure): String

    /** Why the robot stopped when its program ended with motors running, and how to keep driving. */
    fun motorsBrakedAtEnd(): String

    fun unknownRoutine(): String

    fun tooFewArguments(routine: String, needed: Int, given: Int): String

    /** @param group the required high byte of the first argument. */
    fun wrongCodeGroup(routine: String, group: Int): String

    fun unknownCode(code: Int): String

    fun notModelled(routine: String, gap: RomGap): String

    /** @param received the text about the call that took the message. */
    fun messageNotModelled(received: String, gap: RomGap): String

    /** A routine that only changes the processor's settings, named as in the ROM's table. */
    fun setUp(routine: String): String

    /**
     * @param ignoredMode an invalid mode; the motor stays in [mode].
     * @param countedPower an invalid power, not 0..7; the ROM uses [power] instead.
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

    /** @param code one of the codes in [RomCode] that start with `SEGMENT_`. */
    fun segment(code: Int, shown: Boolean): String

    /** The name of a lit icon, for screen readers. */
    fun icon(icon: LcdIcon): String

    /**
     * @param text the number with its sign and decimal point.
     * @param shortened the requested number if it has too many digits.
     * @param unknownPoint an invalid decimal point code.
     */
    fun displayNumber(text: String, shortened: Int?, unknownPoint: Int?): String

    fun programDigit(digit: Int): String

    fun programDigitStays(number: Int): String

    fun queued(sound: String): String

    fun playedAtOnce(sound: String): String

    fun dropped(sound: String): String

    /** @param played 0..5, the sound that [number] really plays. */
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

    /** @param address where the data of messages 0x45 will go; 0 for none. */
    fun transferPointer(address: Int): String

    fun dataWaiting(waiting: Boolean): String

    fun received(bytes: Int): String

    fun sent(bytes: Int): String

    fun stillSending(): String

    fun infraredOff(): String

    /** @param longest max bytes of a short message. */
    fun wrongMessageLength(bytes: Int, longest: Int): String

    companion object {
        fun of(language: Language): BrickMessages =
            language.choose(EnglishBrickMessages, SpanishBrickMessages, GermanBrickMessages)
    }
}

internal fun hexadecimal(value: Int) = RomCallText.hexadecimal(value)
