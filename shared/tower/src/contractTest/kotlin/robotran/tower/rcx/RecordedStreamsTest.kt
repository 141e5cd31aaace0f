package robotran.tower.rcx

import kotlinx.coroutines.awaitCancellation
import kotlinx.coroutines.test.runTest
import robotran.tower.TowerError
import robotran.tower.TransferResult
import robotran.tower.bytesOf
import robotran.tower.firmware.FirmwareFile
import robotran.tower.firmware.readFirmwareFile
import robotran.tower.hexOf
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort
import robotran.tower.recordedStreams
import robotran.tower.smallImage
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/**
 * What the tools of leJOS sent, byte for byte, with the answers that they got. On purpose we differ in two streams: we do
 * not end after status 3, but begin again; and we ask a silent brick ten times instead of five.
 */
class RecordedStreamsTest {
    @Test
    fun `a program is sent as the tool sends it when the answer to a block is lost`() = runTest {
        val port = ReplayedPort("program-two-blocks")
        assertEquals(TransferResult.Success(290, repeats = 1), RcxTower(port).sendProgram(smallImage))
        port.assertAllSent()
    }

    @Test
    fun `a program is sent as the tool sends it when an answer is damaged`() = runTest {
        val port = ReplayedPort("program-wrong-reply")
        assertEquals(TransferResult.Success(290, repeats = 1), RcxTower(port).sendProgram(smallImage))
        port.assertAllSent()
    }

    @Test
    fun `a program is sent as the tool sends it when an answer comes twice`() = runTest {
        val port = ReplayedPort("program-reply-twice")
        assertEquals(TransferResult.Success(290, repeats = 0), RcxTower(port).sendProgram(smallImage))
        port.assertAllSent()
    }

    @Test
    fun `after status 3 the download begins again where the tool ends`() = runTest {
        val port = ReplayedPort("program-status-3")
        assertIs<TransferResult.Failure>(RcxTower(port).sendProgram(smallImage))
        port.assertAllSent()
        assertEquals("55 FF 00 12 ED CA 35 F6 09 D2 2D", port.sentBehind.first())
    }

    @Test
    fun `a silent brick is asked with the bytes of the tool but more often`() = runTest {
        val port = ReplayedPort("program-silent")
        val result = RcxTower(port).sendProgram(smallImage)
        assertEquals(TransferResult.Failure(TowerError.BrickSilent), result)
        port.assertAllSent()
        assertEquals(List(5) { "55 FF 00 10 EF 10 EF" }, port.sentBehind)
    }

    @Test
    fun `a firmware is sent as the tool sends it`() = runTest {
        val file = readFirmwareFile(recordedStreams.getValue("madeup.srec").encodeToByteArray())
        val port = ReplayedPort("firmware-made-up")
        val result = RcxTower(port).sendFirmware(assertIs<FirmwareFile.Success>(file).firmware)
        assertEquals(TransferResult.Success(250, repeats = 1), result)
        port.assertAllSent()
    }
}

/** Expects the messages of a recorded stream and gives its answers; behind its end it only echoes. */
private class ReplayedPort(stream: String) : TowerPort {
    override val kind = TowerKind.SERIAL

    /** What was sent behind the end of the stream. */
    val sentBehind = mutableListOf<String>()
    private val lines = recordedStreams.getValue("$stream.txt").lines().filter { it.isNotBlank() }
        .map { it.take(NAME_WIDTH).trim() to bytesOf(it.drop(NAME_WIDTH).substringBefore('#')) }
        .filterNot { it.first == "tool ends" }
    private var next = 0
    private var arrived = ByteArray(0)

    fun assertAllSent() = assertEquals(lines.size, next, "lines that were replayed")

    override suspend fun send(bytes: ByteArray): Boolean {
        if (next == lines.size) {
            sentBehind += hexOf(bytes)
            arrived += bytes
            return true
        }
        val (name, expected) = lines[next++]
        assertEquals("PC to tower", name)
        assertEquals(hexOf(expected), hexOf(bytes), "line $next")
        while (next < lines.size && lines[next].first != "PC to tower") arrived += lines[next++].second
        return true
    }

    override suspend fun receive(): ByteArray? {
        if (arrived.isEmpty()) awaitCancellation()
        return arrived.also { arrived = ByteArray(0) }
    }

    override suspend fun close() = Unit

    private companion object {
        const val NAME_WIDTH = 15
    }
}
