package robotran.java

/** What pupils know from Java on a computer, and a brick does not have. */
enum class AbsentFromBrick {
    /** `System.out` and `System.err`. */
    PRINTING,

    /** `System.in`, `Scanner`, readers. */
    KEYBOARD,

    /** `ArrayList` and the other collections. */
    COLLECTIONS,

    RUNNABLE,

    /** `String.format`, `printf`. */
    FORMATTING,

    /** Most methods of `String`. */
    TEXT_METHODS,

    /** `Integer.parseInt` and its like. */
    PARSING,

    /** `Boolean`, `Character`, `Double` and the other classes for single values. */
    WRAPPERS,

    FILES,

    WINDOWS,

    /** The classes of leJOS for other bricks, such as `lejos.nxt`. */
    OTHER_BRICKS,
}
