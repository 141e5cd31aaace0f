package robotran.tinyvm.config

/**
 * How fast a program runs.
 *
 * @property bytecodesPerStep bytecodes in one step of the brick, which takes two steps per millisecond.
 */
enum class TinyVmSpeed(val bytecodesPerStep: Int) {
    /**
     * Like a real brick: 16,000 bytecodes a second. Users estimate 10,000 to 20,000 for an RCX (H8/300 at 16 MHz); no
     * measurement is known.
     */
    BRICK(bytecodesPerStep = 8),

    /**
     * Almost no delay: 10 million bytecodes a second of virtual time. A program in an endless loop uses the whole
     * limit, so a higher one would delay a screen at 60 frames per second.
     */
    UNLIMITED(bytecodesPerStep = 5_000),
}
