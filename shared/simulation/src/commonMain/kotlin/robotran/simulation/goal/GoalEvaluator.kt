package robotran.simulation.goal

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import kotlin.math.floor

/** Judges one goal of a run: it is shown the run again and again, and in the end once more. */
internal interface GoalEvaluator {
    /** The same object as long as nothing changes. */
    val progress: GoalProgress

    /** Whether a goal that comes after this one may be begun. */
    val letsNextBegin: Boolean

    /**
     * The goal's turn has come in the middle of the run; what was before does not count. Not called if it counts from
     * the beginning.
     */
    fun begin(scene: Scene)

    fun observe(scene: Scene)

    /** The run is over: looks once more and decides what is not decided yet. */
    fun finish(scene: Scene)

    /** The run is over and this goal's turn has never come. */
    fun giveUp()
}

/** What evaluators of a single goal have in common. Once met or failed, they do not look any more. */
internal abstract class SingleGoalEvaluator(sentence: String) : GoalEvaluator {
    final override var progress = GoalProgress(sentence, GoalStatus.PENDING, 0.0)
        private set

    override val letsNextBegin: Boolean get() = progress.status == GoalStatus.MET

    /** Whether nothing can change any more. */
    protected open val isDecided: Boolean get() = progress.status != GoalStatus.PENDING

    /** What becomes of the goal if it is still pending when the run is over. */
    protected open val statusAtEnd: GoalStatus get() = GoalStatus.FAILED

    override fun begin(scene: Scene) = Unit

    override fun observe(scene: Scene) {
        if (!isDecided) look(scene)
    }

    override fun finish(scene: Scene) {
        observe(scene)
        if (progress.status == GoalStatus.PENDING) tell(statusAtEnd)
    }

    override fun giveUp() = tell(GoalStatus.FAILED)

    protected abstract fun look(scene: Scene)

    /** @param share how much of it is done, whatever its size; what is there already if null. */
    protected fun tell(status: GoalStatus, share: Double? = null) {
        val shown = if (status == GoalStatus.MET) 1.0 else share?.let(::belowOne) ?: belowOne(progress.progress)
        if (status != progress.status ||
            shown != progress.progress
        ) {
            progress = progress.copy(status = status, progress = shown)
        }
    }

    private fun belowOne(share: Double): Double = if (share >
        0.0
    ) {
        minOf(floor(share * HUNDRED), HUNDRED - 1) / HUNDRED
    } else {
        0.0
    }

    private companion object {
        const val HUNDRED = 100.0
    }
}

/** A goal about somebody that is not there. */
internal class UnsatisfiableGoal(sentence: String) : SingleGoalEvaluator(sentence) {
    init {
        tell(GoalStatus.FAILED)
    }

    override fun look(scene: Scene) = Unit
}
