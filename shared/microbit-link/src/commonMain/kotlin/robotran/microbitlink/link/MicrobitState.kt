package robotran.microbitlink.link

import robotran.microbitlink.BoardDescription
import robotran.microbitlink.Remains
import robotran.microbitlink.SendProgress
import robotran.microbitlink.serial.BoardConsole

/**
 * What is known of a board at a moment.
 *
 * @property description what the board is, once it has told.
 * @property console what its program has printed while it was watched.
 * @property sending how far a program is that is being sent.
 * @property holds what the board has since the last sending, also if that was cancelled.
 * @property isGone whether the board is unplugged or released. It never comes back: connect again for a new one.
 */
data class MicrobitState(
    val description: BoardDescription? = null,
    val console: BoardConsole = BoardConsole(),
    val sending: SendProgress? = null,
    val holds: Remains = Remains.AS_BEFORE,
    val isGone: Boolean = false,
)
