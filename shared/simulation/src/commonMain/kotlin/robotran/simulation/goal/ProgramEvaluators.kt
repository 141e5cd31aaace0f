package robotran.simulation.goal

import robotran.brick.state.RunState
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.ProgramShortfall
import robotran.world.GoalCondition

/** Evaluates whether the program has ended by itself in time. */
internal class EndWithinEvaluator(
    sentence: String,
    private val goal: GoalCondition.EndWithin,
    private val actor: Actor.OfRobots,
) : SingleGoalEvaluator(sentence) {
    override fun look(scene: Scene) {
        when {
            scene.isAfter(goal.seconds) -> tell(scene, GoalStatus.FAILED)
            hasEnded(scene) -> tell(scene, GoalStatus.MET)
        }
    }

    /** By how much it ends too late. */
    override fun lookOn(scene: Scene) {
        if (progress.shortfall !is ProgramShortfall.StillRunning || !hasEnded(scene)) return
        val late = scene.state.milliseconds - goal.seconds * MILLISECONDS_PER_SECOND
        tellShortfall(ProgramShortfall.EndedTooLate(late, moment(scene)))
    }

    override fun shortfall(scene: Scene): GoalShortfall? = when (val run = scene.robot(actor)?.brick?.run) {
        null -> null
        RunState.Idle -> ProgramShortfall.NotStarted
        is RunState.Running -> ProgramShortfall.StillRunning(moment(scene))
        is RunState.Ended -> ProgramShortfall.Interrupted(hasFailed = false, moment(scene))
        is RunState.Failed -> ProgramShortfall.Interrupted(hasFailed = true, failureMoment(scene, run))
    }

    private fun hasEnded(scene: Scene) = scene.robot(actor)?.brick?.run == RunState.Ended(stopped = false)

    private fun moment(scene: Scene) = scene.moment(actor, scene.middle(actor))

    private fun failureMoment(scene: Scene, run: RunState.Failed) =
        moment(scene).copy(sourceLine = run.failure.sourceLine, sourceFile = run.failure.sourceFile)
}

/** Evaluates whether the program has played enough tones. */
internal class PlaySoundEvaluator(
    sentence: String,
    private val goal: GoalCondition.PlaySound,
    private val actor: Actor.OfRobots,
) : SingleGoalEvaluator(sentence) {
    private val lowest = (goal.lowest ?: 0) / NEARLY
    private val highest = goal.highest?.let { it * NEARLY } ?: Double.MAX_VALUE
    private var played = 0
    private var others = 0
    private var firstOther: OtherTone? = null

    override val followsPrograms: Boolean get() = true

    override fun look(scene: Scene) {
        val event = scene.between
        if (event == null || event.robot != actor.number || event.tone.isFirmware) return
        val tone = event.tone
        if (tone.hertz in lowest..highest) {
            played++
        } else {
            others++
            if (firstOther == null) firstOther = OtherTone(tone.hertz, tone.milliseconds, scene)
        }
        if (played >= goal.times) {
            tell(scene, GoalStatus.MET)
        } else {
            tell(scene, GoalStatus.PENDING, played.toDouble() / goal.times)
        }
    }

    override fun shortfall(scene: Scene): GoalShortfall {
        val other = firstOther
        val moment = other?.let {
            it.scene.moment(actor, it.scene.middle(actor)).copy(milliseconds = it.milliseconds)
        }
        return ProgramShortfall.TonesMissing(played, goal.times, others, other?.hertz, moment)
    }

    private class OtherTone(val hertz: Double, val milliseconds: Long, val scene: Scene)

    private companion object {
        /** Half a semitone. */
        const val NEARLY = 1.03
    }
}
