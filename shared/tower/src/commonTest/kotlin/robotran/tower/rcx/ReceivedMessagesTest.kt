package robotran.tower.rcx

import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.toList
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.runTest
import robotran.tower.ReceivedMessage
import robotran.tower.port.TowerKind
import robotran.tower.simulated.SimulatedLejos
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.seconds

class ReceivedMessagesTest {
    @Test
    fun `what the robot sends is watched until the tower is gone`() = runTest {
        for (kind in TowerKind.entries) {
            val line = TestLine(this, SimulatedLejos(), kind)
            val heard = mutableListOf<ReceivedMessage>()
            val watching = launch { line.tower.messages().toList(heard) }
            delay(1.seconds)
            line.port.robotSends(listOf(0xF7.toByte(), 12))
            delay(20.seconds)
            line.port.robotSends(listOf(0xC1.toByte(), 1, 2, 3))
            delay(1.seconds)
            line.port.robotSends(listOf(0xC9.toByte(), 4))
            delay(1.seconds)
            line.port.unplug()
            watching.join()
            val expected =
                listOf(
                    ReceivedMessage.Number(12),
                    ReceivedMessage.Packet(listOf(0xC1.toByte(), 1, 2, 3)),
                    ReceivedMessage.Packet(listOf(0xC9.toByte(), 4)),
                )
            assertEquals(expected, heard, "$kind")
        }
    }

    @Test
    fun `a serial tower is kept awake and the USB tower is left alone`() = runTest {
        for (kind in TowerKind.entries) {
            val line = TestLine(this, SimulatedLejos(), kind)
            val watching = launch { line.tower.messages().toList() }
            delay(31.seconds)
            watching.cancel()
            val awake = line.port.sent.count { it.contentEquals(byteArrayOf(-1)) }
            assertTrue(if (kind == TowerKind.SERIAL) awake >= 9 else awake == 0, "$kind: $awake")
        }
    }
}
