package robotran.tinyvm.config

/**
 * The limits of programs and runs. The linker's limits come from `CodeUtilities`, `ClassRecord`, `MethodRecord` and
 * `TinyVMConstants` of `js.tinyvm` in leJOS 3.0, the virtual machine's limits from its `memory.c` and `threads.c`. The
 * other limits keep hostile class files within bounded time and memory.
 */
object TinyVmLimits {
    /** Class file versions: 45 (JDK 1.1) to 52 (Java 8). */
    val CLASS_FILE_VERSIONS: IntRange = 45..52

    /** Max size of a class file, far more than a brick holds. */
    const val CLASS_FILE_BYTES = 1_000_000

    /** Max classes and interfaces of a program, library classes included. */
    const val CLASSES = 255

    /** Max array types; each number of dimensions counts as a type. */
    const val ARRAY_TYPES = 1024

    const val FIELDS = 255
    const val METHODS = 255
    const val LOCALS = 255
    const val OPERANDS = 255
    const val PARAMETERS = 16
    const val EXCEPTION_HANDLERS = 255
    const val CODE_BYTES = 0xFFFF

    /** Max length of a string constant. */
    const val STRING_CHARACTERS = 255

    /** Max superclasses and interfaces above a class. */
    const val ANCESTORS = 64

    const val ARRAY_DIMENSIONS = 8

    /** Array lengths have nine bits on the brick. */
    const val BRICK_ARRAY_ELEMENTS = 511

    /** Max array length in forgiving mode. */
    const val FORGIVING_ARRAY_ELEMENTS = 65_535

    /** Max nesting of `finally` blocks that are compiled as subroutines. */
    const val NESTED_SUBROUTINES = 8

    /** Words that the verifier stores for one method: the types of all locals and operands at each position. */
    const val FRAME_STATE_WORDS = 8_000_000

    /** Words that the verifier compares for a whole program. A large program needs less than a hundredth. */
    const val VERIFIED_WORDS = 300_000_000L

    /** Max call depth of a thread; frames are counted in a byte. A brick has less room, see `ThreadStacks`. */
    const val FRAMES = 255

    /** Max words of locals and operands in one thread in forgiving mode. */
    const val STACK_WORDS = 8192

    /** Max living threads; the brick numbers them with bytes. */
    const val THREADS = 255

    /** Max warnings that a run keeps. */
    const val RUNTIME_WARNINGS = 100
}
