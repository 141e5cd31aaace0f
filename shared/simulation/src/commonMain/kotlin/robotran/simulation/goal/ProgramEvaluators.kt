package robotran.simulation.goal

import robotran.brick.state.RunState
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.ProgramShortfall
import robotran.world.GoalCondition

/** Evaluates whether the program has ended by itself in time. */
internal class EndWithinEvaluator(
    sentence: String,
    private val goal: GoalCondition.EndWithin,
    private val actor: Actor.OfRobots,
) : SingleGoalEvaluator(sentence, goal) {
    override fun look(scene: GoalScene) {
        if (scene.isAfter(goal.seconds)) fail(scene) else tell(hasEnded(scene))
    }

    /** By how much it ends too late. */
    override fun lookOn(scene: GoalScene) {
        if (progress.shortfall !is ProgramShortfall.StillRunning || !hasEnded(scene)) return
        val late = scene.state.milliseconds - goal.seconds * MILLISECONDS_PER_SECOND
        tellShortfall(ProgramShortfall.EndedTooLate(late, moment(scene)))
    }

    override fun shortfall(scene: GoalScene): GoalShortfall? = when (val run = scene.robot(actor)?.brick?.run) {
        null -> null
        RunState.Idle -> ProgramShortfall.NotStarted
        is RunState.Running -> ProgramShortfall.StillRunning(moment(scene))
        is RunState.Ended -> ProgramShortfall.Interrupted(hasFailed = false, moment(scene))
        is RunState.Failed -> ProgramShortfall.Interrupted(hasFailed = true, failureMoment(scene, run))
    }

    private fun hasEnded(scene: GoalScene) = scene.robot(actor)?.brick?.run == RunState.Ended(stopped = false)

    private fun moment(scene: GoalScene) = scene.moment(actor, scene.middle(actor))

    private fun failureMoment(scene: GoalScene, run: RunState.Failed) =
        moment(scene).copy(sourceLine = run.failure.sourceLine, sourceFile = run.failure.sourceFile)
}
