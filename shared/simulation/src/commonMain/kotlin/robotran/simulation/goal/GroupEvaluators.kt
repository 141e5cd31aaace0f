package robotran.simulation.goal

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.GoalStatus
import kotlin.math.floor

/** Evaluates a goal that consists of subgoals. */
internal abstract class GroupEvaluator(private val sentence: String, protected val parts: List<GoalEvaluator>) :
    GoalEvaluator {
    final override var progress = GoalProgress(sentence, GoalStatus.PENDING, 0.0, parts.map { it.progress })
        private set
    private var isInactive = false

    /** Whether one part is enough. */
    protected open val isChoice: Boolean get() = false

    init {
        tellAgain()
    }

    /** The index of the part that explains why the group was not met; -1 if it has no parts. */
    protected abstract fun decisivePart(parts: List<GoalProgress>): Int

    /** The status of the group for the statuses of its parts. */
    protected abstract fun statusOf(parts: List<GoalStatus>): GoalStatus

    /** Whether the group would be met if the run ended now, for its [parts]. */
    protected abstract fun hold(parts: List<GoalProgress>): Boolean

    /** The completed share of the group for the [shares] of its parts. */
    protected abstract fun shareOf(shares: List<Double>): Double

    override val toneCounts: List<PlaySoundEvaluator> get() = parts.flatMap { it.toneCounts }

    override fun begin(scene: GoalScene) = change { parts.forEach { it.begin(scene) } }

    override fun observe(scene: GoalScene) = change { parts.forEach { it.observe(scene) } }

    override fun finish(scene: GoalScene) = change { parts.forEach { it.finish(scene) } }

    override fun failInactive() {
        isInactive = true
        change { parts.forEach { it.failInactive() } }
    }

    protected fun change(work: () -> Unit) {
        work()
        if (parts.indices.any { parts[it].progress !== progress.parts[it] } || holdsNow() != progress.holds) tellAgain()
    }

    /** In an ordered group this can change with the turn of a part, although all parts are as before. */
    private fun holdsNow() = progress.status != GoalStatus.FAILED && hold(progress.parts)

    private fun tellAgain() {
        val results = parts.map { it.progress }
        val status = statusOf(results.map { it.status })
        val share = if (status == GoalStatus.MET) 1.0 else minOf(shareOf(results.map { it.progress }), MAX_OF_UNMET)
        val shortfall = if (status == GoalStatus.FAILED) shortfallOf(results) else null
        val shown = floor(share * HUNDRED + ROUNDING) / HUNDRED
        progress =
            GoalProgress(sentence, status, shown, results, status != GoalStatus.FAILED && hold(results), shortfall)
    }

    private fun shortfallOf(results: List<GoalProgress>): GoalShortfall {
        if (isInactive) return GoalShortfall.NotBegun
        val part = decisivePart(results)
        val shortfall = results.getOrNull(part)?.shortfall ?: return GoalShortfall.ImpossibleGoal
        return GoalShortfall.PartNotMet(part, shortfall, isChoice)
    }

    protected companion object {
        const val HUNDRED = 100.0
        const val MAX_OF_UNMET = 0.99

        /** Keeps inexact hundredths from being rounded down. */
        const val ROUNDING = 1e-6

        fun statusOfAll(parts: List<GoalStatus>): GoalStatus = when {
            parts.any { it == GoalStatus.FAILED } -> GoalStatus.FAILED
            parts.all { it == GoalStatus.MET } -> GoalStatus.MET
            else -> GoalStatus.PENDING
        }

        fun firstFailed(parts: List<GoalProgress>): Int = parts.indexOfFirst { it.status == GoalStatus.FAILED }

        fun mean(shares: List<Double>): Double = if (shares.isEmpty()) 0.0 else shares.sum() / shares.size
    }
}

internal class AllEvaluator(sentence: String, parts: List<GoalEvaluator>) : GroupEvaluator(sentence, parts) {
    override fun decisivePart(parts: List<GoalProgress>): Int = firstFailed(parts)

    override fun statusOf(parts: List<GoalStatus>): GoalStatus = statusOfAll(parts)

    override fun hold(parts: List<GoalProgress>): Boolean = parts.all { it.holds }

    override fun shareOf(shares: List<Double>): Double = mean(shares)
}

internal class AnyOfEvaluator(sentence: String, parts: List<GoalEvaluator>) : GroupEvaluator(sentence, parts) {
    override val isChoice: Boolean get() = true

    /** The one that was closest to being met. */
    override fun decisivePart(parts: List<GoalProgress>): Int = parts.indices.maxByOrNull { parts[it].progress } ?: -1

    override fun statusOf(parts: List<GoalStatus>): GoalStatus = when {
        parts.any { it == GoalStatus.MET } -> GoalStatus.MET
        parts.all { it == GoalStatus.FAILED } -> GoalStatus.FAILED
        else -> GoalStatus.PENDING
    }

    override fun hold(parts: List<GoalProgress>): Boolean = parts.any { it.holds }

    override fun shareOf(shares: List<Double>): Double = shares.maxOrNull() ?: 0.0
}
