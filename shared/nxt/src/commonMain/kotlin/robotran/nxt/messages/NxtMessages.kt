package robotran.nxt.messages

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.messages.PlaceMessages
import robotran.brick.program.ProgramFailure
import robotran.language.Language
import robotran.language.choose
import robotran.nxt.hardware.SensorType

/**
 * The texts about an NXT in one language: its calls in the log (parts of sentences, without full stop) and explanations
 * of its display.
 */
interface NxtMessages : PlaceMessages {
    /** Explains what the display shows for [failure], and what to do; whole sentences. */
    fun failureShown(failure: ProgramFailure): String

    /** The same if a thread of the program has failed, and the others can end in order. */
    fun threadFailureShown(failure: ProgramFailure): String

    /** Why the robot stopped when its program ended with motors running, and how to keep driving. */
    fun motorsRollAtEnd(): String

    /** The call has no effect, because there is no such port or value. */
    fun wrongArguments(): String

    /** @param power 0..100. */
    fun motor(port: MotorPort, mode: MotorMode, power: Int, brakesInPauses: Boolean): String

    fun resetTachoCount(port: MotorPort): String

    /**
     * @param speed degrees a second with at most one decimal, without sign.
     * @param isForward the direction.
     */
    fun turnOn(port: MotorPort, speed: String, isForward: Boolean): String

    /** @param limit the count at which the motor stops. */
    fun turnTo(port: MotorPort, speed: String, limit: Int, isHeld: Boolean): String

    fun stopMotor(port: MotorPort, isHeld: Boolean): String

    fun motorSpeed(port: MotorPort, speed: String): String

    fun motorAcceleration(port: MotorPort, acceleration: Int): String

    fun rollMotor(port: MotorPort): String

    fun regulateNoMore(port: MotorPort): String

    fun stallThreshold(port: MotorPort, degrees: Int, milliseconds: Int): String

    /**
     * @param port 1..4.
     * @param power one of [robotran.nxt.hardware.SensorPower].
     */
    fun sensorPower(port: Int, power: Int): String

    /** @param mode 0 off, 1 input, 2 output, 3 measures. */
    fun pinMode(port: Int, pin: Int, mode: Int): String

    fun pin(port: Int, pin: Int, isHigh: Boolean): String

    /** @param type one of [SensorType]. */
    fun sensorType(port: Int, type: Int): String

    fun i2cReady(port: Int): String

    fun i2cOff(port: Int): String

    fun i2cMessage(port: Int, bytes: Int, answer: Int): String

    /** @param status below 0, see [robotran.nxt.hardware.I2cStatus]. */
    fun i2cRefused(port: Int, status: Int): String

    /**
     * @param text quoted.
     * @param gaps characters that the display does not have, each once.
     */
    fun drawText(text: String, column: Int, row: Int, isInverted: Boolean, gaps: List<String>): String

    fun clearDisplay(): String

    fun drawPicture(width: Int, height: Int, x: Int, y: Int): String

    fun refreshDisplay(): String

    /** @param period milliseconds; 0 for never. */
    fun refreshEvery(period: Int): String

    fun contrast(contrast: Int): String

    fun tone(hertz: Int, milliseconds: Int, volume: Int): String

    fun samples(count: Int, perSecond: Int): String

    fun shutDown(): String

    /** @param name quoted. */
    fun connectTo(name: String): String

    /** @param name quoted. */
    fun noRobot(name: String): String

    fun awaitConnection(): String

    fun sent(bytes: Int, link: Int): String

    fun notSent(link: Int): String

    fun closeLink(link: Int): String

    fun exit(): String

    fun exception(number: Int): String

    /** A program writes a page of the flash memory, from 0. */
    fun writePage(page: Int): String

    /** The flash memory has no page with this number, so nothing is written. */
    fun noPage(page: Int): String

    /** @param text quoted. */
    fun console(text: String): String

    companion object {
        fun of(language: Language): NxtMessages =
            language.choose(EnglishNxtMessages, SpanishNxtMessages, GermanNxtMessages)
    }
}
