package robotran.microbitlink.dap

import robotran.microbitlink.BoardError

/**
 * The debug interface of a board at USB, as a stream of packets: WebUSB, or Android's USB host. A platform chooses, of the
 * interfaces of class 255, one with endpoints, or else the first, which takes its packets by control transfers.
 */
interface DapPort {
    /** Sends [packet], of 64 bytes. False if the board is gone. */
    suspend fun send(packet: ByteArray): Boolean

    /**
     * Waits for the next packet; null once the board is gone. It may be cancelled: a packet that comes then is for the next
     * call.
     */
    suspend fun receive(): ByteArray?

    /** Releases the board. Calling it again does nothing. */
    suspend fun close()
}

/** A board that can be connected: what [MicrobitPorts.open] needs to find it, and what the system shows for it. */
data class PluggedBoard(val id: String, val name: String)

/** The boards at a machine, as far as its platform lets the app reach them. */
interface MicrobitPorts {
    /** Whether boards can be reached at all, which they cannot from Firefox, Safari or an iPad. */
    val canReach: Boolean

    /** Boards that can be connected without asking the user. */
    suspend fun available(): List<PluggedBoard>

    /** Asks the user for a board by a dialog of the platform; one without such a dialog tells of [ChosenBoard.Several]. */
    suspend fun choose(): ChosenBoard

    /** Connects [board]. */
    suspend fun open(board: PluggedBoard): OpenedBoard
}

/** A platform that reaches no board. */
object NoMicrobitPorts : MicrobitPorts {
    override val canReach: Boolean get() = false

    override suspend fun available(): List<PluggedBoard> = emptyList()

    override suspend fun choose(): ChosenBoard = ChosenBoard.None

    override suspend fun open(board: PluggedBoard): OpenedBoard = OpenedBoard.Failure(BoardError.NotAllowed)
}

/** What came of asking the user for a board. */
sealed interface ChosenBoard {
    data class Chosen(val board: PluggedBoard) : ChosenBoard

    /** The platform has no dialog that asks which of these is meant. */
    data class Several(val boards: List<PluggedBoard>) : ChosenBoard

    /** The system lets nobody ask, or the user does not let the app. */
    data class Refused(val error: BoardError) : ChosenBoard

    /** There is none, or the user took none. */
    data object None : ChosenBoard
}

/** The result of opening a board. */
sealed interface OpenedBoard {
    data class Success(val port: DapPort) : OpenedBoard

    data class Failure(val error: BoardError) : OpenedBoard
}

/** How boards are found at USB. */
object MicrobitUsb {
    /** Also that of other boards with DAPLink. */
    const val VENDOR = 0x0D28
    const val PRODUCT = 0x0204

    /** The class of the interface that takes packets. */
    const val INTERFACE_CLASS = 0xFF
}
