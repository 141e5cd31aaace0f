package robotran.microbitlink.link

import kotlinx.coroutines.test.TestScope
import robotran.microbitlink.BoardDescription
import robotran.microbitlink.BoardResult
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.image.MicroPythonImage
import robotran.microbitlink.madeUp
import robotran.microbitlink.mainOf
import robotran.microbitlink.simulated.CableFaults
import robotran.microbitlink.simulated.SimulatedBoard
import robotran.microbitlink.simulated.SimulatedDapPort
import robotran.microbitlink.value
import kotlin.test.assertIs

/** A simulated board at a simulated cable, with an old program on it, and what talks to it. */
internal class TestBoard(
    scope: TestScope,
    type: MicrobitBoard = MicrobitBoard.V2,
    faults: CableFaults = CableFaults(),
    id: String = if (type == MicrobitBoard.V1) "9900" else "9904",
    daplink: Int = if (type == MicrobitBoard.V1) 253 else 257,
    baudRate: Int = 115_200,
) {
    private val old = madeUp(type).imageFor(type).value().withFiles(mainOf(OLD)).value()
    val board = SimulatedBoard(old.memory, id, daplink, baudRate)
    val port = SimulatedDapPort(scope.backgroundScope, board, faults)
    val link = MicrobitLink(port)

    /** What the board has as a file; null if that is no MicroPython. */
    val text: String? get() = MicroPythonImage.of(board.memory)?.hexText()

    val oldText: String = old.hexText()

    suspend fun open(): BoardDescription = assertIs<BoardResult.Success<BoardDescription>>(link.open()).value

    companion object {
        const val OLD = "# the old program\n"
    }
}

/** A program of [size] bytes with all kinds of letters, among them those that must be written otherwise. */
internal fun programOf(size: Int): ByteArray =
    "print('ä\\n')\r\n\t\"\u0001#".encodeToByteArray().let { text -> ByteArray(size) { text[it % text.size] } }
