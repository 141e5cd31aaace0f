package robotran.tower.line

import kotlinx.coroutines.delay
import kotlinx.coroutines.withTimeoutOrNull
import robotran.tower.LineSpeed
import robotran.tower.Wait
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort
import kotlin.time.Duration.Companion.milliseconds

/** Sends messages through a tower and finds their answers. It resends nothing, see [Requests]. */
internal class TowerLine(private val port: TowerPort) {
    /** How long to wait for an answer to begin, in ms. It becomes less with each answer, and more if one is late. */
    private var timeout = Wait.FIRST_ANSWER_TIMEOUT

    private val hasEcho = port.kind == TowerKind.SERIAL

    /** How long [attempt] takes at most, in ms, if sending returns at once. */
    fun milliseconds(frameBytes: Int, answerBytes: Int): Int =
        LineSpeed.milliseconds(frameBytes + framedSize(answerBytes + 1)) + timeout

    /**
     * Sends [message] once.
     *
     * @param answerBytes the bytes of the answer behind the complement of the opcode.
     * @param timeoutOrNull the wait for the answer to begin, in ms; null for the usual one.
     */
    suspend fun attempt(message: ByteArray, answerBytes: Int, timeoutOrNull: Int? = null): Attempt {
        val sent = frame(message)
        val late = drain() ?: return Attempt.Gone
        if (late >= LATE_BYTES) timeout = (timeout * 2).coerceIn(Wait.FIRST_ANSWER_TIMEOUT, Wait.MAX_ANSWER_TIMEOUT)
        if (!port.send(sent)) return Attempt.Gone
        val reader = AnswerReader(sent, message.first().toInt(), answerBytes)
        return reader.read(timeoutOrNull ?: timeout)
    }

    /**
     * Wakes a serial tower and checks that it hears itself, for at most [milliseconds]. Other towers need neither.
     */
    suspend fun wake(milliseconds: Int = Wait.WAKE_UP_IN_ALL): Waking {
        if (!hasEcho) return Waking.AWAKE
        if (!port.send(byteArrayOf(WAKE_BYTE))) return Waking.GONE
        delay(Wait.WAKE_UP.milliseconds)
        var isSilent = true
        var spent = 0
        while (spent < milliseconds) {
            drain() ?: return Waking.GONE
            if (!port.send(TEST_BYTES)) return Waking.GONE
            var heard = ByteArray(0)
            while (heard.size < TEST_BYTES.size) {
                when (val received = receive(LineSpeed.milliseconds(TEST_BYTES.size) + Wait.FOR_ECHO)) {
                    is Received.Bytes -> heard += received.bytes
                    Received.Nothing -> break
                    Received.Gone -> return Waking.GONE
                }
            }
            if (heard.contentEquals(TEST_BYTES)) return Waking.AWAKE
            if (heard.isNotEmpty()) isSilent = false
            spent += LineSpeed.milliseconds(TEST_BYTES.size) + Wait.FOR_ECHO
        }
        return if (isSilent) Waking.SILENT else Waking.DISTURBED
    }

    /**
     * Sends one byte to keep a serial tower awake. Returns what is heard then besides its echo; null if the tower is
     * gone.
     */
    suspend fun keepAwake(): ByteArray? {
        if (!hasEcho) return ByteArray(0)
        if (!port.send(byteArrayOf(WAKE_BYTE))) return null
        return when (val received = receive(Wait.FOR_ECHO)) {
            is Received.Bytes -> received.bytes.toList().minus(WAKE_BYTE).toByteArray()
            Received.Nothing -> ByteArray(0)
            Received.Gone -> null
        }
    }

    /** Reads what comes within [milliseconds]. */
    suspend fun receive(milliseconds: Int): Received {
        // A variable, not the block's result: a result that comes with the end of the time would be lost.
        var received: Received = Received.Nothing
        withTimeoutOrNull(milliseconds.milliseconds) {
            received = port.receive()?.let { Received.Bytes(it) } ?: Received.Gone
        }
        return received
    }

    /** Sends [message] without waiting for an answer. False if the tower is gone. */
    suspend fun sendOnly(message: ByteArray): Boolean {
        val sent = frame(message)
        drain() ?: return false
        if (!port.send(sent)) return false
        delay(LineSpeed.milliseconds(sent.size).milliseconds)
        return drain() != null
    }

    /** Drops what has come. Returns its number of bytes; null if the tower is gone. */
    private suspend fun drain(): Int? {
        var bytes = 0
        // A lamp can make a serial tower hear bytes without end.
        while (bytes < MAX_DRAINED) {
            when (val received = receive(Wait.DRAIN)) {
                is Received.Bytes -> bytes += received.bytes.size
                Received.Nothing -> return bytes
                Received.Gone -> return null
            }
        }
        return bytes
    }

    /** What is heard after one message. */
    private inner class AnswerReader(
        private val sent: ByteArray,
        private val opcode: Int,
        private val answerBytes: Int,
    ) {
        private var heard = ByteArray(0)
        private var isGone = false

        suspend fun read(timeout: Int): Attempt {
            listenToEcho()?.let { return it }
            if (hasEcho && heard.isEmpty()) return Attempt.Unanswered(false, false, heard)
            // The answer's bytes come one by one, with pauses if an adapter hands them over in packets.
            var left = timeout + LineSpeed.milliseconds(framedSize(answerBytes + 1))
            while (left > 0 && !isGone && heard.size < MAX_HEARD) {
                val slice = minOf(left, SLICE)
                if (!hear(slice)) left -= slice
                answer()?.let { return it }
            }
            if (isGone) return Attempt.Gone
            val rest = heard.copyOfRange(echo(), heard.size)
            return Attempt.Unanswered(true, rest.size >= LATE_BYTES, rest)
        }

        /** Waits until the message is on the line: until its echo is there, or as long as it takes. */
        private suspend fun listenToEcho(): Attempt? {
            var left = LineSpeed.milliseconds(sent.size) + if (hasEcho) Wait.FOR_ECHO else 0
            var pause = 0
            while (left > 0 && !isGone && heard.size < if (hasEcho) sent.size else 1) {
                val slice = minOf(left, SLICE)
                left -= slice
                if (hear(slice)) pause = 0 else pause += slice
                answer()?.let { return it }
                if (heard.isNotEmpty() && pause >= Wait.ECHO_GAP) break
            }
            return if (isGone) Attempt.Gone else null
        }

        /** True if a byte has come within [milliseconds]. */
        private suspend fun hear(milliseconds: Int): Boolean = when (val received = receive(milliseconds)) {
            is Received.Bytes -> {
                heard += received.bytes
                true
            }

            Received.Nothing -> false

            Received.Gone -> {
                isGone = true
                true
            }
        }

        private fun echo() = if (hasEcho) echoSize(heard, sent) else 0

        private fun answer(): Attempt.Answered? {
            val payload = findAnswer(heard, echo(), opcode, answerBytes) ?: return null
            timeout = maxOf(Wait.MIN_ANSWER_TIMEOUT, timeout * 9 / 10)
            return Attempt.Answered(payload)
        }
    }

    private companion object {
        /** Wakes a serial tower. Source: leJOS-RCX. */
        const val WAKE_BYTE = 0xFF.toByte()

        /** What a serial tower must hear of itself. Source: leJOS-RCX. */
        val TEST_BYTES = byteArrayOf(0x10, 0xFE.toByte(), 0x10, 0xFE.toByte())

        /** Fewer bytes than these are noise, not a part of an answer. */
        const val LATE_BYTES = 4

        /** More bytes than any answer has: a lamp, or another device. */
        const val MAX_HEARD = 4000
        const val MAX_DRAINED = 4000

        /** In ms: how finely waits are counted. */
        const val SLICE = 50
    }
}
