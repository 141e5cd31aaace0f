package robotran.tower.line

import robotran.tower.RcxOpcode
import robotran.tower.TowerError
import robotran.tower.Tries
import robotran.tower.port.TowerPort

/** The result of a request. */
internal sealed interface Reply {
    /** @property payload the answer's bytes behind the complement of the opcode. */
    class Success(val payload: ByteArray) : Reply

    class Failure(val error: TowerError) : Reply
}

/** Sends messages to a brick until they are answered, each new one with the toggle that tells it from the last. */
internal class Requests(port: TowerPort) {
    val line = TowerLine(port)
    private var lastOpcode = -1

    /** Attempts of the last request. */
    var attempts = 0
        private set

    /** Wakes the tower; the error if that fails. */
    suspend fun wake(): TowerError? = when (line.wake()) {
        Waking.AWAKE -> null
        Waking.SILENT -> TowerError.TowerSilent
        Waking.DISTURBED -> TowerError.BadConnection
        Waking.GONE -> TowerError.TowerGone
    }

    /**
     * Asks between two blocks whether the brick is there: null, or why it is not. leJOS still takes a resend of the last
     * block for one afterwards, so this leaves the toggle as it is.
     */
    suspend fun aliveBetweenBlocks(): TowerError? {
        val failures = Failures()
        repeat(Tries.REQUEST) {
            when (val result = line.attempt(byteArrayOf(RcxOpcode.ALIVE.toByte()), 0)) {
                is Attempt.Answered -> return null
                is Attempt.Unanswered -> failures.add(result)
                Attempt.Gone -> return TowerError.TowerGone
            }
        }
        return failures.error
    }

    /** [message] as it must be sent after the messages before it. Resend what this returns as it is. */
    fun next(message: ByteArray): ByteArray {
        val opcode = toggled(message.first().toInt() and 0xFF, lastOpcode)
        lastOpcode = opcode
        return message.copyOf().also { it[0] = opcode.toByte() }
    }

    /**
     * Sends [message] at most [tries] times; a brick that is heard, though badly, may be asked [Tries.WHEN_HEARD] times.
     * See [TowerLine.attempt] for the other parameters.
     */
    suspend fun request(
        message: ByteArray,
        answerBytes: Int,
        tries: Int = Tries.REQUEST,
        timeout: Int? = null,
    ): Reply {
        val sent = next(message)
        val failures = Failures()
        for (attempt in 1..maxOf(tries, Tries.WHEN_HEARD)) {
            if (attempt > tries && !(failures.isBrickHeard && tries == Tries.REQUEST)) break
            attempts = attempt
            when (val result = line.attempt(sent, answerBytes, timeout)) {
                is Attempt.Answered -> return Reply.Success(result.payload)
                is Attempt.Unanswered -> failures.add(result)
                Attempt.Gone -> return Reply.Failure(TowerError.TowerGone)
            }
            if (failures.isTowerSilent) break
        }
        return Reply.Failure(failures.error)
    }
}

/** What attempts without an answer tell about the reason. */
internal class Failures {
    private var withoutEcho = 0
    private var isEchoHeard = false

    /** Whether the brick was heard at all. */
    var isBrickHeard = false
        private set

    /** Whether a serial tower has not heard itself, so that more attempts are in vain. */
    val isTowerSilent get() = withoutEcho >= Tries.WITHOUT_ECHO && !isEchoHeard

    val error: TowerError
        get() = when {
            isBrickHeard -> TowerError.BadConnection
            isTowerSilent -> TowerError.TowerSilent
            else -> TowerError.BrickSilent
        }

    fun add(attempt: Attempt.Unanswered) {
        if (attempt.echoHeard) isEchoHeard = true else withoutEcho++
        if (attempt.brickHeard) isBrickHeard = true
    }
}
