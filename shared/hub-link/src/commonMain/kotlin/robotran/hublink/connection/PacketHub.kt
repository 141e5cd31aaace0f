package robotran.hublink.connection

import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.withTimeoutOrNull
import robotran.hublink.u32
import kotlin.time.Duration.Companion.milliseconds

/**
 * A hub at the packet interface of USB (profile 1.5). Answers do not say what they answer, so nothing is sent twice, and
 * after a command without an answer the next one waits for it.
 */
class PacketHub(private val port: PacketPort) : HubConnection {
    override val isSureOfPybricks: Boolean get() = true

    private val answers = Channel<Long>(Channel.UNLIMITED)

    /** Whether the answer to the last command may still come, which must not be taken for that to the next. */
    private var isAnswerOwed = false

    override suspend fun listen(take: (ByteArray) -> Unit) {
        try {
            while (true) {
                val packet = port.receive() ?: break
                val rest = packet.drop(1).toByteArray()
                when (packet.firstOrNull()?.toInt()) {
                    RESPONSE -> if (rest.size >= Int.SIZE_BYTES) answers.trySend(rest.u32(0))
                    EVENT -> take(rest)
                }
            }
        } finally {
            answers.close()
        }
    }

    override suspend fun read(value: HubValue): ByteArray? =
        port.read(value.service, value.number)?.takeIf { it.isNotEmpty() }

    override suspend fun subscribe(): Boolean = port.send(byteArrayOf(SUBSCRIBE.toByte(), 1))

    override suspend fun command(command: ByteArray): CommandAnswer {
        if (isAnswerOwed) withTimeoutOrNull(LATEST_ANSWER) { answers.receiveCatching() }
        do {
            val late = answers.tryReceive()
        } while (late.isSuccess)
        if (!port.send(byteArrayOf(COMMAND.toByte()) + command)) return CommandAnswer.Gone
        isAnswerOwed = true
        val answer = withTimeoutOrNull(ANSWER_TIMEOUT) { answers.receiveCatching() } ?: return CommandAnswer.Unanswered
        isAnswerOwed = false
        return answer.getOrNull()?.let(::answerOf) ?: CommandAnswer.Gone
    }

    override suspend fun close() = port.close()

    private companion object {
        const val SUBSCRIBE = 1
        const val COMMAND = 2

        // What the hub sends.
        const val RESPONSE = 1
        const val EVENT = 2
        val ANSWER_TIMEOUT = 900.milliseconds
        val LATEST_ANSWER = 3_000.milliseconds
    }
}
