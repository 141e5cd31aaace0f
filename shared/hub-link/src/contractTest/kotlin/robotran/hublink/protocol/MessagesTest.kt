package robotran.hublink.protocol

import robotran.hublink.HubCapabilities
import robotran.hublink.HubKind
import robotran.hublink.HubVersion
import robotran.hublink.bytesOf
import robotran.hublink.hexOf
import robotran.hublink.vectorLines
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue

class MessagesTest {
    private val messages = vectorLines("messages.txt")

    private fun command(name: String) = messages.single { it[0] == ">" && it.drop(2).joinToString(" ") == name }[1]

    private fun status(name: String) = assertIs<HubEvent.Status>(
        HubEvent.read(
            bytesOf(
                messages.single {
                    it.drop(2).joinToString(" ") == name
                }[1],
            ),
        ),
    ).status

    @Test
    fun `commands are those of the protocol`() {
        val new = HubVersion(1, 4)
        val commands = mapOf(
            "stop" to HubCommand.stop(),
            "start slot 0" to HubCommand.start(new, 0),
            "start slot 4" to HubCommand.start(new, 4),
            "start before profile 1.4" to HubCommand.start(HubVersion(1, 3), 4),
            "size 0" to HubCommand.open(),
            "size 52" to HubCommand.size(52),
            "size 65536" to HubCommand.size(65_536),
            "bytes abc at 0" to HubCommand.bytes(0, "abc".encodeToByteArray()),
            "bytes abc at 300" to HubCommand.bytes(300, "abc".encodeToByteArray()),
            "stdin a" to HubCommand.input("a".encodeToByteArray()),
            "app data 0102 at 0" to HubCommand.appData(0, byteArrayOf(1, 2)),
            "app data ff at 258" to HubCommand.appData(258, byteArrayOf(-1)),
        )
        for ((name, bytes) in commands) assertEquals(command(name), hexOf(bytes), name)
    }

    @Test
    fun `events tell what a hub does`() {
        assertTrue(status("status: program in slot 0 runs, BLE host").isProgramRunning)
        assertEquals(3, status("status: program in slot 3 runs, slot 3 selected").slot)
        assertEquals(128, status("status: REPL runs").program)
        assertTrue(status("status: low battery, BLE host").isBatteryLow)
        assertTrue(status("status: download in progress").isDownloadOpen)
        assertTrue(status("status: shutdown requested").isShuttingDown)
        assertTrue(status("status: shuts down").isShuttingDown)
        val quiet = status("status: nothing")
        assertTrue(!quiet.isProgramRunning && !quiet.isBatteryLow && !quiet.isShuttingDown && !quiet.isDownloadOpen)
    }

    @Test
    fun `older hubs tell less`() {
        assertTrue(status("status of profile 1.0 to 1.3, program runs").isProgramRunning)
        assertEquals(0, status("status of profile 1.4, program runs").slot)
        assertNull(HubEvent.read(bytesOf("00400000")))
        assertNull(HubEvent.read(bytesOf("03")))
        assertNull(HubEvent.read(ByteArray(0)))
    }

    @Test
    fun `capabilities tell how much fits`() {
        val prime = HubCapabilities.read(bytesOf("0002" + "2b000000" + "4ccc0000" + "05"))
        assertEquals(HubCapabilities(512, 0x2B, 52_300, 5), prime)
        assertEquals(507, prime?.payload)
        assertEquals(52_300, prime?.roomFor(HubKind.SPIKE_PRIME))
        assertEquals(0, HubCapabilities.read(bytesOf("1400" + "0b000000" + "a03f0000"))?.slots)
        assertNull(HubCapabilities.read(ByteArray(9)))
    }

    @Test
    fun `an NXT has room for less than it says`() {
        val nxt = HubCapabilities.read(bytesOf("3c00" + "0b000000" + "20fdffff" + "00"))
        assertEquals(4_294_966_560, nxt?.programBytes)
        assertEquals(10_000, nxt?.roomFor(HubKind.NXT))
    }

    @Test
    fun `a hub tells its kind`() {
        assertEquals(HubKind.SPIKE_PRIME, HubKind.ofPnpId(bytesOf("01970381000000")))
        assertEquals(HubKind.ROBOT_INVENTOR, HubKind.ofPnpId(bytesOf("01970381000100")))
        assertEquals(HubKind.SPIKE_PRIME, HubKind.ofPnpId(bytesOf("01970381000200")))
        assertEquals(HubKind.EV3, HubKind.ofPnpId(bytesOf("019703e2000000")))
        assertEquals(HubKind.UNKNOWN, HubKind.ofPnpId(bytesOf("0197")))
        assertEquals(HubKind.SPIKE_ESSENTIAL, HubKind.ofUsbProduct(0x000D))
    }

    @Test
    fun `versions are read with whatever stands behind`() {
        assertEquals(HubVersion(4, 1, 0), HubVersion.read("4.1.0b2"))
        assertEquals(HubVersion(1, 5, 0), HubVersion.read("1.5.0"))
        assertEquals(HubVersion(3, 2), HubVersion.read("3.2"))
        for (text in listOf("", "4", "x.y", "local-build")) assertNull(HubVersion.read(text), text)
    }
}
