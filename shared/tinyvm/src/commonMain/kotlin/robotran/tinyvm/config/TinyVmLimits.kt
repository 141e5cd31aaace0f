package robotran.tinyvm.config

/**
 * How much there can be of anything. What the linker of leJOS refuses has its source in `CodeUtilities`, `ClassRecord`,
 * `MethodRecord` and `TinyVMConstants` of `js.tinyvm` in leJOS 3.0, what the machine refuses in its `memory.c` and
 * `threads.c`; the rest keeps hostile class files within bounded time and memory.
 */
object TinyVmLimits {
    /** Versions of class files: 45 of JDK 1.1 to 52 of Java 8. */
    val CLASS_FILE_VERSIONS: IntRange = 45..52

    /** The longest class file: far more than a brick holds. */
    const val CLASS_FILE_BYTES = 1_000_000

    /** Classes and interfaces of a program, the library's included. */
    const val CLASSES = 255

    /**
     * Bytes of a brick's memory for a program and its objects: from 0x8000 to 0xEF31 there are 28 KB, of which leJOS
     * takes about 16. Source: leJOS `main.c`.
     */
    const val MEMORY_BYTES = 0xEF32 - 0x8000 - 16 * 1024

    /** The largest program: it has to leave room for its first objects. */
    const val PROGRAM_BYTES = MEMORY_BYTES - 256

    /** Arrays of different kinds, each depth counted. */
    const val ARRAY_TYPES = 1024

    const val FIELDS = 255
    const val METHODS = 255
    const val LOCALS = 255
    const val OPERANDS = 255
    const val PARAMETERS = 16
    const val EXCEPTION_HANDLERS = 255
    const val CODE_BYTES = 0xFFFF

    /** Numbers and texts in the code of a class; an instruction names them with one byte. */
    const val STRING_CHARACTERS = 255

    /** How many interfaces and superclasses may stand above a class. */
    const val ANCESTORS = 64

    const val ARRAY_DIMENSIONS = 8

    /** Array lengths have nine bits on the brick. */
    const val BRICK_ARRAY_ELEMENTS = 511

    /** The longest array of the forgiving mode. */
    const val FORGIVING_ARRAY_ELEMENTS = 65_535

    /** How many `finally` blocks may be inside each other, as far as they are subroutines. */
    const val NESTED_SUBROUTINES = 8

    /** Words that the verifier remembers of one method: what is in each local and operand at each place. */
    const val SITUATION_WORDS = 8_000_000

    /** Words that the verifier compares for a whole program. A large program takes less than a hundredth. */
    const val VERIFIED_WORDS = 300_000_000L

    /** Methods inside each other in one thread. */
    const val FRAMES = 255

    /** Words of locals and operands in one thread. */
    const val STACK_WORDS = 8192

    /** Threads that live at the same time: their numbers are bytes. */
    const val THREADS = 255

    /** How many remarks about quirks and failures a run keeps. */
    const val REMARKS = 100
}
