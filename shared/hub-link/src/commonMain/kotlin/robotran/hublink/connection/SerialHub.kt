package robotran.hublink.connection

import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.flow.update
import kotlinx.coroutines.withTimeoutOrNull
import robotran.hublink.frame.Cobs
import robotran.hublink.frame.FrameReader
import robotran.hublink.u32
import robotran.hublink.u8
import kotlin.time.Duration.Companion.milliseconds

/**
 * A hub at a serial port of USB (profile 1.6): messages in frames. A frame that is lost or spoiled is never told, so what is
 * not answered is sent again, with the same tag: whichever is answered, the command was done.
 */
class SerialHub(private val port: BytePort) : HubConnection {
    override val isSureOfPybricks: Boolean get() = false

    private var lastTag = 0

    /** The last answer to a command, by its tag, and to a read, by what was asked. */
    private val answers = MutableStateFlow(Answers())

    override suspend fun listen(take: (ByteArray) -> Unit) {
        val reader = FrameReader()
        try {
            while (true) {
                val bytes = port.receive() ?: break
                for (message in reader.add(bytes)) hear(message, take)
            }
        } finally {
            answers.update { it.copy(isGone = true) }
        }
    }

    private fun hear(message: ByteArray, take: (ByteArray) -> Unit) {
        val rest = message.drop(1).toByteArray()
        when (message.firstOrNull()?.toInt()) {
            RESPONSE -> if (rest.size >= RESPONSE_SIZE) answers.update { it.copy(command = rest) }
            EVENT -> take(rest)
            READ -> if (rest.size >= READ_HEAD) answers.update { it.copy(read = rest) }
        }
    }

    override suspend fun read(value: HubValue): ByteArray? {
        val asked = byteArrayOf(value.service.toByte(), value.number.toByte(), (value.number shr 8).toByte())
        answers.update { it.copy(read = null) }
        val answer = ask(byteArrayOf(READ.toByte()) + asked) {
            it.read?.takeIf { read -> read.copyOf(READ_HEAD).contentEquals(asked) }
        }
        return (answer as? Heard.Answer)?.bytes?.drop(READ_HEAD)?.toByteArray()?.takeIf { it.isNotEmpty() }
    }

    override suspend fun subscribe(): Boolean = port.send(Cobs.encode(byteArrayOf(SUBSCRIBE.toByte(), 1)))

    override suspend fun command(command: ByteArray): CommandAnswer {
        lastTag = (lastTag + 1) and 0xFF
        val tag = lastTag
        answers.update { it.copy(command = null) }
        val heard = ask(byteArrayOf(COMMAND.toByte(), tag.toByte()) + command) {
            it.command?.takeIf { answer -> answer.u8(0) == tag }
        }
        return when (heard) {
            is Heard.Answer -> answerOf(heard.bytes.u32(1))
            Heard.Nothing -> CommandAnswer.Unanswered
            Heard.Gone -> CommandAnswer.Gone
        }
    }

    override suspend fun close() = port.close()

    /** Sends [message] until [find] finds an answer, for at most [TRIES] times. */
    private suspend fun ask(message: ByteArray, find: (Answers) -> ByteArray?): Heard {
        val frame = Cobs.encode(message)
        repeat(TRIES) {
            if (answers.value.isGone || !port.send(frame)) return Heard.Gone
            val heard = withTimeoutOrNull(ANSWER_TIMEOUT) { answers.first { it.isGone || find(it) != null } }
            if (heard != null) return find(heard)?.let { Heard.Answer(it) } ?: Heard.Gone
        }
        return Heard.Nothing
    }

    private data class Answers(
        val command: ByteArray? = null,
        val read: ByteArray? = null,
        val isGone: Boolean = false,
    ) {
        override fun equals(other: Any?): Boolean = this === other

        override fun hashCode(): Int = isGone.hashCode()
    }

    private sealed interface Heard {
        class Answer(val bytes: ByteArray) : Heard

        data object Nothing : Heard

        data object Gone : Heard
    }

    private companion object {
        const val SUBSCRIBE = 1
        const val COMMAND = 2
        const val READ = 3

        // What the hub sends.
        const val RESPONSE = 1
        const val EVENT = 2

        /** A tag and the error. */
        const val RESPONSE_SIZE = 5

        /** The kind of number and the number. */
        const val READ_HEAD = 3

        /** All tries together are shorter than the second after which a hub gives up a download. */
        const val TRIES = 3
        val ANSWER_TIMEOUT = 300.milliseconds
    }
}

/** The answer with [error], 0 for none. */
internal fun answerOf(error: Long): CommandAnswer = when (error) {
    0L -> CommandAnswer.Accepted
    else -> CommandAnswer.Refused(error.coerceAtMost(Int.MAX_VALUE.toLong()).toInt())
}
