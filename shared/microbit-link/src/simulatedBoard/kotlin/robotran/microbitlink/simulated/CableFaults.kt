package robotran.microbitlink.simulated

import kotlin.random.Random
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds

/**
 * What goes wrong between app and board.
 *
 * @param losses the share of packets that are lost, in both directions.
 * @param serialLosses the share of bytes that the board's program loses.
 * @param longestDelay of a packet, one way.
 * @param packetsUntilUnplugged commands before the board is unplugged; null for never.
 * @param doesLast whether the board still gets the command at which it is unplugged.
 * @param injectedError what the board says to one command of a stream instead of writing.
 * @param staleAnswers answers to an earlier session that are still to be read.
 */
class CableFaults(
    private val random: Random = Random(1),
    private val losses: Double = 0.0,
    private val serialLosses: Double = 0.0,
    private val longestDelay: Duration = 1.milliseconds,
    private val packetsUntilUnplugged: Int? = null,
    val doesLast: Boolean = false,
    val injectedError: InjectedError? = null,
    val staleAnswers: List<ByteArray> = emptyList(),
) {
    private var packets = 0

    fun delay(): Duration = longestDelay * random.nextDouble()

    fun isLost(): Boolean = losses > 0 && random.nextDouble() < losses

    fun isByteLost(): Boolean = serialLosses > 0 && random.nextDouble() < serialLosses

    /** Counts a command; whether the board is unplugged at it. */
    fun unplugsNow(): Boolean = ++packets == packetsUntilUnplugged
}

/** The board says [number] to the command of a stream with the number [at], counted from 1, as often as [times]. */
class InjectedError(val number: Int, val at: Int, val times: Int = 1) {
    fun isAt(command: Int): Boolean = command in at until at + times
}
