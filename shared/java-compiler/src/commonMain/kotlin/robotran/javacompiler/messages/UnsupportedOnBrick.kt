package robotran.javacompiler.messages

/** What pupils know from Java on a computer, and a brick does not have. */
enum class UnsupportedOnBrick {
    /** `System.out` and `System.err`. */
    PRINTING,

    /** `System.in`, `Scanner`, readers. */
    KEYBOARD,

    /** `ArrayList` and the other collections. */
    COLLECTIONS,

    /** `Vector.add` and others that came later than `addElement`. */
    VECTOR_METHODS,

    /** All but `put` and `get`. */
    HASHTABLE_METHODS,

    RUNNABLE,

    /** `String.format`, `printf`. */
    FORMATTING,

    /** Most methods of `String`. */
    TEXT_METHODS,

    /** `Integer.parseInt` and its like. */
    PARSING,

    /** `String.valueOf` of a number and its like. */
    WRITING_NUMBERS,

    /** `System.nanoTime`, `System.gc` and the like. */
    SYSTEM_METHODS,

    /** `System.arraycopy`. */
    ARRAY_COPYING,

    /** Waiting with no `Thread.` before it. */
    WAITING,

    /** `Boolean`, `Character`, `Double` and the other classes for single values. */
    WRAPPERS,

    FILES,

    WINDOWS,

    /** The classes of leJOS for other bricks, such as `lejos.nxt`. */
    OTHER_BRICKS,
}
