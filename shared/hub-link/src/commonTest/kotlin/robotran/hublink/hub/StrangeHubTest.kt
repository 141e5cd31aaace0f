package robotran.hublink.hub

import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.test.runTest
import robotran.hublink.DownloadResult
import robotran.hublink.connection.BytePort
import robotran.hublink.connection.PacketHub
import robotran.hublink.connection.PacketPort
import robotran.hublink.connection.SerialHub
import robotran.hublink.frame.Cobs
import robotran.hublink.frame.FrameReader
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** A hub of another make, or a mad one: it answers anything. Every call must come to an end. */
class StrangeHubTest {
    @Test
    fun `whatever a hub answers every call ends`() = runTest(timeout = 5.minutes) {
        var met = 0
        for (seed in 1..HUBS) {
            val random = Random(seed)
            val wire = StrangeWire(random)
            val connection = if (random.nextBoolean()) SerialHub(wire.bytes) else PacketHub(wire.packets)
            if (useAll(HubLink(connection, backgroundScope))) met++
        }
        assertTrue(met > 0, "no hub was ever met")
    }

    private suspend fun useAll(link: HubLink): Boolean {
        link.open()
        val sent = link.send(square)
        assertTrue(sent !is DownloadResult.Success || sent.bytes == square.bytes.size)
        link.start()
        link.stop()
        val hasMet = link.state.value.description != null
        link.close()
        return hasMet
    }

    private companion object {
        const val HUBS = 150
    }
}

/** Answers each message with none, one or some, often of the kind that is expected. */
private class StrangeWire(private val random: Random) {
    /** Some hubs are mad all the time, others now and then. */
    private val madness = random.nextDouble()
    private var isGone = false
    private val arrived = Channel<ByteArray>(Channel.UNLIMITED)

    private fun answer(message: ByteArray, hasTags: Boolean): List<ByteArray> {
        if (random.nextDouble() < madness) return List(random.nextInt(3)) { random.nextBytes(random.nextInt(30)) }
        val status = byteArrayOf(2, 0) + random.nextBytes(6)
        return when (message.firstOrNull()?.toInt()) {
            1 -> listOf(status)
            2 -> listOf((if (hasTags) message.copyOf(2).also { it[0] = 1 } else byteArrayOf(1)) + ByteArray(4), status)
            3 -> listOf(message.copyOf(4) + value(message[2].toInt()))
            else -> emptyList()
        }
    }

    private fun value(number: Int): ByteArray = when (number) {
        0x03 -> byteArrayOf(60, 0, 0x2B, 0, 0, 0, 0, random.nextInt().toByte(), 0, 0, 5)
        0x28, 0x26 -> "${random.nextInt(3)}.${random.nextInt(9)}.0".encodeToByteArray()
        else -> random.nextBytes(random.nextInt(20))
    }

    private fun hear(messages: List<ByteArray>, pack: (ByteArray) -> ByteArray, hasTags: Boolean): Boolean {
        if (random.nextInt(500) == 0) isGone = true.also { arrived.close() }
        for (message in messages) answer(message, hasTags).forEach { arrived.trySend(pack(it)) }
        return !isGone
    }

    private suspend fun next(): ByteArray? = arrived.receiveCatching().getOrNull()

    val bytes = object : BytePort {
        private val reader = FrameReader()

        override suspend fun send(bytes: ByteArray): Boolean = hear(reader.add(bytes), Cobs::encode, hasTags = true)

        override suspend fun receive(): ByteArray? = next()

        override suspend fun close() {
            arrived.close()
        }
    }

    val packets = object : PacketPort {
        override suspend fun send(packet: ByteArray): Boolean = hear(listOf(packet), { it }, hasTags = false)

        override suspend fun receive(): ByteArray? = next()

        override suspend fun read(request: Int, value: Int): ByteArray? =
            if (random.nextInt(50) == 0) null else value(value and 0xFF)

        override suspend fun close() {
            arrived.close()
        }
    }
}
