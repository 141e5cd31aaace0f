package robotran.tinyvm.config

/** How true to the brick a program runs. */
enum class TinyVmMode {
    /** With all the brick's peculiarities; each one that bites is explained. */
    BRICK,

    /**
     * With a collected heap and the arithmetic of the Java language; where the brick would do something else, there is
     * a warning.
     */
    FORGIVING,
}
