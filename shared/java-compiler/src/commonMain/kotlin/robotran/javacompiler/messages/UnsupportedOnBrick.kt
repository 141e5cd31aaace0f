package robotran.javacompiler.messages

/** Features of Java on a computer that a brick does not have. */
enum class UnsupportedOnBrick {
    /** `System.out` and `System.err`. */
    PRINTING,

    /** `System.in`, `Scanner`, readers. */
    KEYBOARD,

    /** `ArrayList` and the other collections. */
    COLLECTIONS,

    /** `Vector.add` and other methods that are newer than `addElement`. */
    VECTOR_METHODS,

    /** All `Hashtable` methods but `put` and `get`. */
    HASHTABLE_METHODS,

    RUNNABLE,

    /** `String.format`, `printf`. */
    FORMATTING,

    /** Most methods of `String`. */
    TEXT_METHODS,

    /** `Integer.parseInt` and similar methods. */
    PARSING,

    /** `String.valueOf` of a number and similar methods. */
    WRITING_NUMBERS,

    /** `System.nanoTime`, `System.gc` and similar methods. */
    SYSTEM_METHODS,

    /** `System.arraycopy`. */
    ARRAY_COPYING,

    /** `sleep` and similar calls without `Thread.`. */
    WAITING,

    /** `Boolean`, `Character`, `Double` and other classes for primitive values. */
    WRAPPERS,

    FILES,

    WINDOWS,

    /** `Motor.A.run()` and other words for what `forward()` and `stop()` do. */
    MOTOR_DIRECTIONS,

    /** `Motor.A.rotate(90)` and what else counts degrees. */
    MOTOR_TIME,

    /** `Motor.A.setSpeed(300)`. */
    MOTOR_POWER,

    /** The leJOS classes for other bricks, such as `lejos.nxt`. */
    OTHER_BRICKS,
}
