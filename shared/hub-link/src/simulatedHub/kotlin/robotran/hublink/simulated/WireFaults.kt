package robotran.hublink.simulated

import kotlin.random.Random
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds

/**
 * What goes wrong between app and hub.
 *
 * @param losses the share of messages that are lost, in both directions. Bluetooth loses none.
 * @param longestDelay of a message, one way.
 * @param messagesUntilDisconnect commands before the connection breaks; null for never.
 * @param doesLast whether the hub still gets the command at which the connection breaks.
 * @param hidesReasons whether the system keeps back why the hub refuses, as a browser does.
 */
class WireFaults(
    private val random: Random = Random(1),
    private val losses: Double = 0.0,
    private val longestDelay: Duration = 20.milliseconds,
    private val messagesUntilDisconnect: Int? = null,
    val doesLast: Boolean = false,
    val hidesReasons: Boolean = false,
) {
    private var messages = 0

    fun delay(): Duration = longestDelay * random.nextDouble()

    fun isLost(): Boolean = losses > 0 && random.nextDouble() < losses

    /** Counts a command; whether the connection breaks at it. */
    fun breaksNow(): Boolean = ++messages == messagesUntilDisconnect
}
