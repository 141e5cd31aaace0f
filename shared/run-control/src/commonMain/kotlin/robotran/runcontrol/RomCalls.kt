package robotran.runcontrol

import robotran.brick.log.CallLog
import robotran.brick.log.CallLogFilter
import robotran.brick.log.LoggedCall

/** The first [count] calls of [log]: those up to a moment of the run, while the log may continue. */
class RomCalls internal constructor(internal val log: CallLog, val count: Long) {
    /** The kept calls, oldest first. */
    val entries: List<LoggedCall>
        get() {
            val all = log.entries
            val surplus = (log.total - count).coerceIn(0, all.size.toLong()).toInt()
            return if (surplus == 0) all else all.subList(0, all.size - surplus)
        }
}

/**
 * The ROM calls of a run that [filter] accepts. A frame is too short to search a log of 200,000 calls, so each call of
 * [find] searches at most [MAX_PER_CALL] calls and continues there the next time.
 */
class FilteredRomCalls(val filter: CallLogFilter) {
    private var log: CallLog? = null
    private var numbers = LongArray(FIRST_ROOM)
    private var accepted = arrayOfNulls<LoggedCall>(FIRST_ROOM)
    private var size = 0

    /** The first call that has not been searched. */
    private var next = 0L
    private val takesAll = filter == CallLogFilter()

    /** Whether all calls have been searched. */
    var isComplete = true
        private set

    /** The matches in [calls] found so far, oldest first; the list is immutable. */
    fun find(calls: RomCalls): List<LoggedCall> {
        if (takesAll) return calls.entries
        if (calls.log !== log) begin(calls.log)
        recordLog(calls.log)
        var end = size
        while (end > 0 && numbers[end - 1] >= calls.count) end--
        return Found(accepted, end)
    }

    private fun begin(other: CallLog) {
        log = other
        size = 0
        next = 0
        // Arrays in returned lists are never written again.
        numbers = LongArray(FIRST_ROOM)
        accepted = arrayOfNulls(FIRST_ROOM)
    }

    private fun recordLog(log: CallLog) {
        val oldest = log.total - log.entries.size
        var number = maxOf(next, oldest)
        val end = minOf(log.total, number + MAX_PER_CALL)
        while (number < end) {
            log[number]?.takeIf(filter::accepts)?.let { add(number, it) }
            number++
        }
        next = number
        isComplete = next == log.total
    }

    private fun add(number: Long, entry: LoggedCall) {
        if (size >= CallLog.CAPACITY) forgetHalf()
        if (size == accepted.size) {
            numbers = numbers.copyOf(size * 2)
            accepted = accepted.copyOf(size * 2)
        }
        numbers[size] = number
        accepted[size++] = entry
    }

    private fun forgetHalf() {
        val half = size / 2
        numbers = numbers.copyOfRange(half, size)
        accepted = accepted.copyOfRange(half, size)
        size -= half
    }

    private class Found(private val entries: Array<LoggedCall?>, override val size: Int) :
        AbstractList<LoggedCall>() {
        override fun get(index: Int): LoggedCall {
            if (index !in 0..<size) throw IndexOutOfBoundsException("entry $index of $size")
            return checkNotNull(entries[index])
        }
    }

    companion object {
        /** Max number of calls to search in one frame. */
        const val MAX_PER_CALL = 10_000
        private const val FIRST_ROOM = 256
    }
}
