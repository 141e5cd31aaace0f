package robotran.legofirmware.image

/** What fits into a program of LEGO's firmware, and what Robotran reads. */
object FirmwareLimits {
    /** Max tasks of a program; their numbers are 0..9, and 0 is the main task. Source: Proudfoot's opcode reference. */
    const val TASKS = 10

    /** Max subroutines of a program; their numbers are 0..7. Source: Proudfoot's opcode reference. */
    const val SUBROUTINES = 8

    /** Variables that all tasks share; their numbers are 0..31. */
    const val GLOBAL_VARIABLES = 32

    /** Variables that each task has for itself; their numbers are 32..47. Firmware 2.0 only. */
    const val LOCAL_VARIABLES = 16

    /** Max bytes of a chunk's code, whose length has 16 bits. */
    const val CHUNK_BYTES = 0xFFFF

    /** Bytes for the programs in all slots, with the datalog: about 6 KB. Source: Proudfoot's opcode reference. */
    const val PROGRAM_MEMORY = 6144

    /** Max characters of a symbol's name: its length, with the final zero byte, has 8 bits. */
    const val NAME_CHARACTERS = 254

    /** Max symbols of an image. Ours, far more than a program of NQC has. */
    const val SYMBOLS = 4096

    /** Max bytes of an image file. Ours: the largest chunks and symbols that a program can use fit many times. */
    const val IMAGE_BYTES = 0x40000
}
