package robotran.hublink.hub

import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/** How long things may take. All times are those of the coroutines, so tests need not wait. */
internal object HubTimes {
    /** A hub closes a download by itself a second after the last command. */
    val DOWNLOAD_CLOSES = 1_100.milliseconds

    /** A write over Bluetooth that no answer comes to. */
    val COMMAND = 5.seconds

    /** A program ends between two of its steps, when it is told to. */
    val STOP = 3.seconds

    /** From an accepted start to the event that tells of it. */
    val START = 1.seconds

    /** From the subscription to the first event. */
    val FIRST_STATUS = 1.seconds

    /** Downloads that are begun before the connection counts as bad. */
    const val DOWNLOADS = 4
}
