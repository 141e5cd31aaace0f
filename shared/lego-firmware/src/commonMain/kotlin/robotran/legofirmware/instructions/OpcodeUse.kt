package robotran.legofirmware.instructions

enum class OpcodeUse {
    /** In programs and as a request over infrared light. */
    ANYWHERE,

    /** Only in programs. */
    PROGRAM,

    /** Only as a request over infrared light. */
    REQUEST,
}
