package robotran.legofirmware.event

/** Finds clicks: a value that leaves the low range, gets high, and is low again soon. */
internal class ClickTimes {
    /** [SECOND] follows another click soon. */
    enum class Click { FIRST, SECOND }

    private var leftLowAt: Long? = null
    private var wasHigh = false
    private var lastClickAt: Long? = null

    fun forget() {
        leftLowAt = null
        wasHigh = false
        lastClickAt = null
    }

    /** The click that ends with the change from [before] to [after]; null if none does. [time] is in 10 ms. */
    fun follow(before: EventState, after: EventState, now: Long, time: Int): Click? {
        if (before == EventState.LOW && after != EventState.LOW) {
            leftLowAt = now
            wasHigh = false
        }
        if (after == EventState.HIGH) wasHigh = true
        val begin = leftLowAt
        if (after != EventState.LOW || before == EventState.LOW || begin == null || !wasHigh) return null
        leftLowAt = null
        val longest = time * UNIT_MILLISECONDS
        if (now - begin > longest) return null
        val lastClick = lastClickAt
        val isSecond = lastClick != null && begin - lastClick <= longest
        lastClickAt = if (isSecond) null else now
        return if (isSecond) Click.SECOND else Click.FIRST
    }

    private companion object {
        const val UNIT_MILLISECONDS = 10L
    }
}
