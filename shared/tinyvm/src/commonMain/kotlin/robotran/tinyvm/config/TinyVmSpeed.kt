package robotran.tinyvm.config

/**
 * How fast a program runs.
 *
 * @property bytecodesPerStep bytecodes in one step of the brick, of which it gives two to each millisecond.
 */
enum class TinyVmSpeed(val bytecodesPerStep: Int) {
    /**
     * As on a real brick, 16,000 bytecodes a second: an RCX (H8/300 at 16 MHz) is estimated by its users at 10,000 to
     * 20,000; no measurement is known.
     */
    BRICK(bytecodesPerStep = 8),

    /**
     * As if computing took hardly any time: 10 million bytecodes a second of virtual time. More would not let a screen
     * of 60 pictures a second answer in time, as a program that computes for ever takes all that it is given.
     */
    UNLIMITED(bytecodesPerStep = 5_000),
}
