package robotran.nxt.program

import robotran.nxt.bluetooth.BluetoothLink
import robotran.nxt.display.BitBlt
import robotran.nxt.display.DisplayMemory
import robotran.nxt.display.Picture
import robotran.nxt.hardware.NxtColour
import robotran.nxt.regulator.MotorRegulator

/**
 * The only interface between a program and an NXT. What a program does to the robot is a [call], which the log keeps;
 * what it senses it reads from the other members. Ports are 0..2 for the motors A to C and 0..3 for the inputs 1 to 4.
 */
interface Nxt {
    /** Milliseconds of virtual time since the brick was first switched on; the clock continues while it is off. */
    val milliseconds: Long

    /**
     * Performs and logs a call.
     *
     * @param sourceLine the program line of the call, from 1; 0 if it is the class library's own doing.
     * @param sourceFile the file of the line; null if the program has only one.
     * @return its result, 0 if it has none.
     */
    fun call(call: NxtCall, sourceLine: Int, sourceFile: String? = null): Int

    /** Draws a part of [source] onto the [displayMemory], and logs that as [NxtNative.BIT_BLT]. */
    fun bitBlt(source: Picture, part: BitBlt, sourceLine: Int, sourceFile: String? = null)

    /** Degrees that a motor has turned since it was counted from 0, as of the last even millisecond. */
    fun tachoCount(motor: Int): Int

    /** What keeps a motor's speed and finds its place. Act on it by [call], so that the log tells it. */
    fun regulator(motor: Int): MotorRegulator

    /** What an analog pin measures, 0..1023, at most 3 milliseconds ago. */
    fun analog(port: Int): Int

    /** The bit of a digital pin, 0 or 1. */
    fun pin(port: Int, pin: Int): Boolean

    /** [robotran.nxt.hardware.I2cStatus]. */
    fun i2cStatus(port: Int): Int

    /** Takes the answer of a transaction; how many bytes it has, or a status below 0. */
    fun i2cComplete(port: Int, into: ByteArray): Int

    /** What a colour sensor sees; null if the port's type is none. */
    fun colour(port: Int): NxtColour?

    /** The buttons that are down, for at least 50 milliseconds: bits 1 ENTER, 2 LEFT, 4 RIGHT, 8 ESCAPE. */
    fun buttons(): Int

    /** Millivolts in bits 0 to 13. */
    fun batteryStatus(): Int

    /** Milliseconds that the sound still takes. */
    fun soundMillisecondsLeft(): Int

    /** When the last refresh of the display is complete: the low 32 bits of [milliseconds]. */
    fun refreshCompleteTime(): Int

    /** Copies a page of the flash memory, 256 bytes; false if there is no such page or no room in [into]. */
    fun readPage(page: Int, into: ByteArray): Boolean

    /** The name by which other robots know this one. */
    val name: String

    /** Whether another robot has this name. */
    fun knowsRobot(name: String): Boolean

    /** A link by its number; null if there is none. */
    fun link(number: Int): BluetoothLink?

    /**
     * What the glass shows after each refresh, [robotran.nxt.display.DisplaySize.BYTES]. A run may put in its own,
     * which should be clear; when the program ends, the brick takes its own again.
     */
    var displayMemory: DisplayMemory

    /**
     * Called when ENTER and ESCAPE are pressed together, for a run that can end in order. The second time, and always
     * if there is none, the program is cut off. A run sets it when it starts.
     */
    var onStopRequest: (() -> Unit)?
}
