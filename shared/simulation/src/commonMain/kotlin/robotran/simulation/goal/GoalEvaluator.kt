package robotran.simulation.goal

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.GoalStatus
import kotlin.math.floor

/** Evaluates one goal of a run: it observes the run repeatedly, and a last time at the end. */
internal interface GoalEvaluator {
    /** The same object while nothing changes. */
    val progress: GoalProgress

    /** Whether the goal after this one in an ordered group may begin. */
    val allowsNext: Boolean

    /** Whether the program had done what the goal wants when it did [event]; null if that cannot be told. */
    fun isDoneBy(event: ProgramEvent): Boolean? = null

    /**
     * Activates the goal in the middle of the run; earlier events do not count. Not called if the goal is active from
     * the start.
     */
    fun begin(scene: Scene)

    fun observe(scene: Scene)

    /** Ends the run: observes it once more and decides what is still pending. */
    fun finish(scene: Scene)

    /** Ends the run for a goal that was never activated. */
    fun failInactive()
}

/** Base class of evaluators of a single goal. Once met or failed, they stop observing. */
internal abstract class SingleGoalEvaluator(sentence: String) : GoalEvaluator {
    final override var progress = GoalProgress(sentence, GoalStatus.PENDING, 0.0)
        private set

    override val allowsNext: Boolean get() = progress.status == GoalStatus.MET

    protected open val isDecided: Boolean get() = progress.status != GoalStatus.PENDING

    /** Whether the goal is about what programs do between two moments, and not only about the moments themselves. */
    protected open val followsPrograms: Boolean get() = false

    /** The status of a goal that is still pending when the run ends. */
    protected open val statusAtEnd: GoalStatus get() = GoalStatus.FAILED

    override fun begin(scene: Scene) = Unit

    override fun observe(scene: Scene) {
        if (scene.between != null && !followsPrograms) return
        if (!isDecided) {
            look(scene)
        } else if (progress.status == GoalStatus.FAILED) {
            lookOn(scene)
        }
    }

    override fun finish(scene: Scene) {
        observe(scene)
        if (progress.status == GoalStatus.PENDING) tell(scene, statusAtEnd)
        if (progress.status == GoalStatus.FAILED) tellShortfall(shortfallAtEnd(scene))
    }

    override fun failInactive() {
        if (progress.status == GoalStatus.FAILED) return
        setProgress(GoalStatus.FAILED, belowOne(progress.progress), GoalShortfall.NotBegun)
    }

    protected abstract fun look(scene: Scene)

    /** Observes the run after the goal has failed, to tell more about what was missing. Most goals need not. */
    protected open fun lookOn(scene: Scene) = Unit

    /** What is missing at the moment when the goal fails. */
    protected abstract fun shortfall(scene: Scene): GoalShortfall?

    /** What is missing when the run ends, for a goal that has failed. */
    protected open fun shortfallAtEnd(scene: Scene): GoalShortfall? = progress.shortfall

    /** @param share completed part, any value; null keeps the current one. */
    protected fun tell(scene: Scene, status: GoalStatus, share: Double? = null) {
        val shown = if (status == GoalStatus.MET) 1.0 else share?.let(::belowOne) ?: belowOne(progress.progress)
        if (status != progress.status || shown != progress.progress) {
            setProgress(status, shown, if (status == GoalStatus.FAILED) shortfall(scene) else null)
        }
    }

    /** Changes what was missing for a goal that has failed. */
    protected fun tellShortfall(shortfall: GoalShortfall?) {
        if (shortfall != progress.shortfall) progress = progress.copy(shortfall = shortfall)
    }

    private fun setProgress(status: GoalStatus, share: Double, shortfall: GoalShortfall?) {
        progress = progress.copy(status = status, progress = share, shortfall = shortfall)
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
    override val allowsNext: Boolean get() = false

    override fun begin(scene: Scene) = Unit

    override fun observe(scene: Scene) = Unit

    override fun finish(scene: Scene) = Unit

    override fun failInactive() = Unit
}
