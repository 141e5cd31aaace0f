package robotran.workshop.send

import robotran.microbitlink.BoardError
import robotran.microbitlink.BoardResult
import robotran.microbitlink.dap.MicrobitPorts
import robotran.microbitlink.dap.OpenedBoard
import robotran.microbitlink.dap.PluggedBoard
import robotran.microbitlink.link.MicrobitLink

/** The board that is used. It stays connected until it is closed, another one is chosen or it is gone. */
internal class MicrobitSession(private val ports: MicrobitPorts) {
    /** The board that is connected, or was tried last; null if none was. */
    var device: PluggedBoard? = null
        private set

    /** The board that got a program last, which is taken without asking. */
    var lastUsed: PluggedBoard? = null
        private set

    /** Null while no board is connected. */
    var link: MicrobitLink? = null
        private set

    /** Connects [board] unless it is connected; returns why that has failed. */
    suspend fun open(board: PluggedBoard): BoardError? {
        val state = link?.state?.value
        if (board == device && state?.description != null && !state.isGone) return null
        close()
        device = board
        return when (val opened = ports.open(board)) {
            is OpenedBoard.Failure -> opened.error

            is OpenedBoard.Success -> {
                val link = MicrobitLink(opened.port)
                this.link = link
                (link.open() as? BoardResult.Failure)?.error?.also { close() }
            }
        }
    }

    /** Remembers the board that is connected. */
    fun remember() {
        lastUsed = device
    }

    suspend fun close() {
        val open = link
        link = null
        open?.close()
    }
}
