package robotran.simulation.goal

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.GoalStatus
import robotran.world.GoalCondition
import kotlin.math.floor

/** Evaluates one goal of a run: it observes the run repeatedly, and a last time at the end. */
internal interface GoalEvaluator {
    /** The same object while nothing changes. */
    val progress: GoalProgress

    /** Whether the goal after this one in an ordered group may begin. */
    val allowsNext: Boolean get() = progress.holds

    /** What counts tones, of this goal or of its parts. */
    val toneCounts: List<PlaySoundEvaluator> get() = emptyList()

    /** Whether the program had done what the goal wants when it did [event]; null if that cannot be told. */
    fun isDoneBy(event: ProgramEvent): Boolean? = null

    /**
     * Activates the goal in the middle of the run; earlier events do not count. Not called if the goal is active from
     * the start.
     */
    fun begin(scene: GoalScene)

    fun observe(scene: GoalScene)

    /** Ends the run: observes it once more and decides what is still pending. */
    fun finish(scene: GoalScene)

    /** Ends the run for a goal that was never activated. */
    fun failInactive()
}

/**
 * Base class of evaluators of a single goal. Once met or failed, it stays so, and they stop observing. This is the one
 * place that says when that is: a condition that holds is met at once if nothing can change that any more, and by the end
 * of the run if it [is decided then][GoalCondition.isDecidedAtEnd].
 *
 * @param holds whether [condition] holds before anything has happened.
 */
internal abstract class SingleGoalEvaluator(
    sentence: String,
    private val condition: GoalCondition,
    holds: Boolean = false,
) : GoalEvaluator {
    final override var progress = GoalProgress(sentence, GoalStatus.PENDING, 0.0, holds = holds)
        private set

    /** Whether the goal is about what programs do between two moments, and not only about the moments themselves. */
    protected open val followsPrograms: Boolean get() = false

    override fun begin(scene: GoalScene) = Unit

    override fun observe(scene: GoalScene) {
        if (scene.between != null && !followsPrograms) return
        when (progress.status) {
            GoalStatus.PENDING -> look(scene)
            GoalStatus.FAILED -> lookOn(scene)
            GoalStatus.MET -> Unit
        }
    }

    override fun finish(scene: GoalScene) {
        observe(scene)
        if (progress.status == GoalStatus.PENDING) {
            if (progress.holds) setProgress(GoalStatus.MET, 1.0) else fail(scene)
        }
        if (progress.status == GoalStatus.FAILED) tellShortfall(shortfallAtEnd(scene))
    }

    override fun failInactive() {
        if (progress.status == GoalStatus.FAILED) return
        setProgress(GoalStatus.FAILED, belowOne(progress.progress), shortfall = GoalShortfall.NotBegun)
    }

    protected abstract fun look(scene: GoalScene)

    /** Observes the run after the goal has failed, to tell more about what was missing. Most goals need not. */
    protected open fun lookOn(scene: GoalScene) = Unit

    /** What is missing at the moment when the goal fails. */
    protected abstract fun shortfall(scene: GoalScene): GoalShortfall?

    /** What is missing when the run ends, for a goal that has failed. */
    protected open fun shortfallAtEnd(scene: GoalScene): GoalShortfall? = progress.shortfall

    /**
     * Tells whether the condition [holds] now.
     *
     * @param share completed part, any value; null keeps the current one.
     */
    protected fun tell(holds: Boolean, share: Double? = null) {
        if (holds && !condition.isDecidedAtEnd) return setProgress(GoalStatus.MET, 1.0)
        val shown = belowOne(share ?: progress.progress)
        if (holds != progress.holds || shown != progress.progress) setProgress(GoalStatus.PENDING, shown, holds)
    }

    /** Tells that the condition can no longer be met. */
    protected fun fail(scene: GoalScene, share: Double? = null) =
        setProgress(GoalStatus.FAILED, belowOne(share ?: progress.progress), shortfall = shortfall(scene))

    /** Changes what was missing for a goal that has failed. */
    protected fun tellShortfall(shortfall: GoalShortfall?) {
        if (shortfall != progress.shortfall) progress = progress.copy(shortfall = shortfall)
    }

    private fun setProgress(
        status: GoalStatus,
        share: Double,
        holds: Boolean = status == GoalStatus.MET,
        shortfall: GoalShortfall? = null,
    ) {
        progress = progress.copy(status = status, progress = share, holds = holds, shortfall = shortfall)
    }

    private fun belowOne(share: Double): Double = if (share > 0.0) {
        minOf(floor(share * HUNDRED), HUNDRED - 1) / HUNDRED
    } else {
        0.0
    }

    private companion object {
        const val HUNDRED = 100.0
    }
}

/** A goal that refers to a missing robot or object. */
internal class UnsatisfiableGoal(sentence: String) : GoalEvaluator {
    override val progress = GoalProgress(sentence, GoalStatus.FAILED, 0.0, shortfall = GoalShortfall.ImpossibleGoal)

    override fun begin(scene: GoalScene) = Unit

    override fun observe(scene: GoalScene) = Unit

    override fun finish(scene: GoalScene) = Unit

    override fun failInactive() = Unit
}
