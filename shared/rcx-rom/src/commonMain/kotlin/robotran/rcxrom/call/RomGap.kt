package robotran.rcxrom.call

/**
 * Everything a real brick does when it is called and the virtual one does not: the one place where this is kept. A call
 * that meets a gap does nothing and is reported in the log with its [reason]; the run goes on.
 *
 * @property reason why it is so, as the end of a sentence.
 */
enum class RomGap(val reason: String) {
    /** Routine 0x36ba, which the processor itself calls every millisecond. */
    TIMER_TICK("the brick does this by itself every millisecond"),

    /** The messages 0x12, 0x45 and 0x65 to the leJOS shell, which load a program or delete the firmware. */
    DOWNLOAD("programs come into this brick without infrared"),
}
