package robotran.microbit.program

import robotran.brick.log.CallGroup

/**
 * The calls by which a program acts on a micro:bit.
 *
 * @property id never changes, because it identifies a call in the trace of a run.
 * @property words how the log names it.
 * @property parameters how many numbers a call has, at least.
 */
enum class MicrobitNative(val id: Int, val words: String, val group: CallGroup, val parameters: Int) {
    /** Address; bytes. */
    I2C_WRITE(1, "i2c", CallGroup.MOTORS, parameters = 1),

    /** Pin; 0..1023. */
    PIN_ANALOG(2, "analog", CallGroup.MOTORS, parameters = 2),

    /** Pin; milliseconds. */
    PIN_PERIOD(3, "period", CallGroup.MOTORS, parameters = 2),

    /** Pin; 0 or 1. */
    PIN_DIGITAL(4, "digital", CallGroup.MOTORS, parameters = 2),

    /** A text of one character. */
    DISPLAY_SHOW(10, "display show", CallGroup.DISPLAY, parameters = 0),

    /** A text that runs over the lights; the program goes on. */
    DISPLAY_SCROLL(11, "display scroll", CallGroup.DISPLAY, parameters = 0),
    DISPLAY_CLEAR(12, "display clear", CallGroup.DISPLAY, parameters = 0),

    /** Hertz; milliseconds. The program goes on. */
    MUSIC_PITCH(20, "pitch", CallGroup.SOUND, parameters = 2),
    MUSIC_STOP(21, "music stop", CallGroup.SOUND, parameters = 0),

    /** Text, a line of the output. */
    PRINT(30, "print", CallGroup.SYSTEM, parameters = 0),
}
