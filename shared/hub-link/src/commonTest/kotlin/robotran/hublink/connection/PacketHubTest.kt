package robotran.hublink.connection

import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.milliseconds

class PacketHubTest {
    @Test
    fun `an answer that comes late is not taken for that to the next command`() = runTest {
        val incoming = Channel<ByteArray>(Channel.UNLIMITED)
        val port = object : PacketPort {
            override suspend fun send(packet: ByteArray): Boolean = true

            override suspend fun receive(): ByteArray? = incoming.receiveCatching().getOrNull()

            override suspend fun read(request: Int, value: Int): ByteArray? = null

            override suspend fun close() = Unit
        }
        val hub = PacketHub(port)
        backgroundScope.launch { hub.listen {} }
        backgroundScope.launch {
            delay(1_500.milliseconds)
            incoming.send(byteArrayOf(1, 0, 0, 0, 0))
            delay(100.milliseconds)
            incoming.send(byteArrayOf(1, 0x81.toByte(), 0, 0, 0))
        }
        assertEquals(CommandAnswer.Unanswered, hub.command(byteArrayOf(0)))
        assertEquals(CommandAnswer.Refused(0x81), hub.command(byteArrayOf(1, 0)))
    }
}
