package robotran.simulation.goal

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus

/**
 * Activates each part when the one before allows it; the part observes the run from the next moment on. What a program
 * did after it had done what the part before wants counts, too, even if that could be seen only later.
 */
internal class InOrderEvaluator(sentence: String, parts: List<GoalEvaluator>) : GroupEvaluator(sentence, parts) {
    private var begun = minOf(1, parts.size)

    /** When each part was activated: by an event, or at a moment, after all events up to that. */
    private val begunAt = LongArray(parts.size) { -1 }
    private val byEvent = BooleanArray(parts.size)

    /** What programs have done while the display of an NXT may not have shown yet what was drawn before. */
    private val recent = ArrayDeque<GoalScene>()

    override fun begin(scene: GoalScene) = change {
        parts.firstOrNull()?.begin(scene)
        beginNext(scene)
    }

    override fun observe(scene: GoalScene) = change {
        repeat(begun) { if (counts(scene, it)) parts[it].observe(scene) }
        beginNext(scene)
        if (scene.between != null && begun < parts.size) recent += scene
        while (recent.isNotEmpty() && isOld(recent.first(), scene)) recent.removeFirst()
    }

    override fun finish(scene: GoalScene) = change {
        var number = 0
        while (number < begun) {
            parts[number++].finish(scene)
            beginNext(scene)
        }
        parts.drop(begun).forEach { it.failInactive() }
    }

    override fun decisivePart(parts: List<GoalProgress>): Int = firstFailed(parts)

    override fun statusOf(parts: List<GoalStatus>): GoalStatus = statusOfAll(parts)

    override fun hold(parts: List<GoalProgress>): Boolean = begun == parts.size && parts.all { it.holds }

    override fun shareOf(shares: List<Double>): Double = mean(shares)

    private fun beginNext(scene: GoalScene) {
        while (begun in 1..<parts.size && parts[begun - 1].allowsNext) {
            val number = begun++
            begunAt[number] = scene.between?.milliseconds ?: scene.state.milliseconds
            byEvent[number] = scene.between != null
            parts[number].begin(scene)
            handOverTones(number)
            for (earlier in recent) if (isAfterPartBefore(earlier, number)) parts[number].observe(earlier)
        }
    }

    /** From the turn of the part with the index [number] on, its tones are no longer those of the parts before. */
    private fun handOverTones(number: Int) {
        val before = parts.take(number).flatMap { it.toneCounts }
        for (later in parts[number].toneCounts) before.filter(later::countsTonesOf).forEach { it.close() }
    }

    /** Whether [scene] counts for the part with the index [number]: not if a program did it before the part's turn. */
    private fun counts(scene: GoalScene, number: Int): Boolean {
        val event = scene.between ?: return true
        if (number == 0 || byEvent[number] || event.milliseconds > begunAt[number]) return true
        return when (parts[number - 1].isDoneBy(event)) {
            null -> event.tone.milliseconds > begunAt[number]
            else -> isAfterPartBefore(scene, number)
        }
    }

    /** Whether the program had done what the part before [number] wants in that part's turn. */
    private fun isAfterPartBefore(scene: GoalScene, number: Int): Boolean {
        val event = scene.between ?: return false
        return parts[number - 1].isDoneBy(event) == true && event.milliseconds > begunAt[number - 1]
    }

    private fun isOld(event: GoalScene, now: GoalScene) =
        now.state.milliseconds - event.state.milliseconds > LATEST_REFRESH

    private companion object {
        /** After so many milliseconds the glass of an NXT shows what is drawn, unless something else is drawn by then. */
        const val LATEST_REFRESH = 260
    }
}
