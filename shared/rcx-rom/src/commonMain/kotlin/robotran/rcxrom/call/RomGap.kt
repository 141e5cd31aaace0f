package robotran.rcxrom.call

/**
 * The routines and messages that a real brick handles and the virtual one does not. Such a call does nothing, the log
 * reports its [reason], and the run continues.
 *
 * @property reason completes a sentence.
 */
enum class RomGap(val reason: String) {
    /** Routine 0x36ba, which the processor calls every millisecond. */
    TIMER_TICK("the brick does this by itself every millisecond"),

    /** The messages 0x12, 0x45 and 0x65 to the leJOS shell, which load a program or delete the firmware. */
    DOWNLOAD("programs come into this brick without infrared"),
}
