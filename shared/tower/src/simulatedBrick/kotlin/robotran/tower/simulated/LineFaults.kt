package robotran.tower.simulated

import kotlin.random.Random

/**
 * What happens to bytes on the way, in both directions and in the echo, each byte by itself.
 *
 * @param seed the same seed gives the same faults for the same bytes.
 * @property loss the share of bytes that are lost, 0 to 1.
 * @property doubled the share that come twice.
 * @property corrupted the share of which one bit is wrong.
 * @property delayed the share that come later, with all bytes behind them.
 * @property delayMilliseconds how much later.
 */
class LineFaults(
    seed: Int = 0,
    private val loss: Double = 0.0,
    private val doubled: Double = 0.0,
    private val corrupted: Double = 0.0,
    private val delayed: Double = 0.0,
    private val delayMilliseconds: Int = 0,
) {
    private val random = Random(seed)

    /** What arrives of [byte]. */
    fun pass(byte: Byte): List<Byte> {
        if (happens(loss)) return emptyList()
        val arriving = if (happens(
                corrupted,
            )
        ) {
            (byte.toInt() xor (1 shl random.nextInt(Byte.SIZE_BITS))).toByte()
        } else {
            byte
        }
        return if (happens(doubled)) listOf(arriving, arriving) else listOf(arriving)
    }

    /** How much later the next byte comes, in ms. */
    fun delay(): Int = if (happens(delayed)) random.nextInt(1, delayMilliseconds + 1) else 0

    // A share of 0 draws nothing, so that a line without faults needs no random numbers.
    private fun happens(share: Double) = share > 0 && random.nextDouble() < share
}
