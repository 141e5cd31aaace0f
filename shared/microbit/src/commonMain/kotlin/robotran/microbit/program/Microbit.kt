package robotran.microbit.program

import robotran.microbit.model.MicrobitButton
import robotran.microbit.model.MicrobitModel

/**
 * The only interface between a program and a micro:bit. What a program does to the board and the buggy is a [call], which
 * the log keeps; what it senses it reads from the other members. Nothing waits.
 *
 * A program makes its buggy ready and stops its wheels before its first line, and stops wheels and sound when it ends,
 * however it does: the board does both for it, as the frame of a program in Python does.
 */
interface Microbit {
    val model: MicrobitModel

    /** Milliseconds of virtual time since the board was first switched on. */
    val milliseconds: Long

    /**
     * Performs and logs a call.
     *
     * @param sourceLine the program line of the call, from 1.
     * @param sourceFile the file of the line; null if the program has only one.
     * @return why the board refuses it; null if it did it.
     */
    fun call(call: MicrobitCall, sourceLine: Int, sourceFile: String? = null): MicrobitError?

    /** Whether [button] is down; not for the press that started the program, until it is over. */
    fun isPressed(button: MicrobitButton): Boolean

    /** Whether the line sensor number [line], from 0 on the left, is over something dark; false without one. */
    fun isDark(line: Int): Boolean

    /** How light it is below the line sensor number [line], 0..100; 0 without one. */
    fun grey(line: Int): Int

    /** Whole centimetres to what the distance sensor hears, 0..254; 255 for nothing, and without one. */
    val distance: Int

    /** The light on the lights of the board, 0..255. */
    val lightLevel: Int

    /** What the microphone hears, 0..255; 0 without one. */
    val soundLevel: Int
}
