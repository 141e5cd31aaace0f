package robotran.simulation.goal

import robotran.brick.state.RunState
import robotran.simulation.messages.GoalMessages
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.SessionState
import robotran.world.World
import robotran.world.geometry.Trigonometry

/** Evaluates how far one run meets the goals of [world], from its beginning. */
internal class GoalJudge(world: World, trigonometry: Trigonometry, messages: GoalMessages) {
    private val places = ObjectLocations(world, trigonometry)
    private val evaluators = GoalEvaluators(world, places, messages, SentenceParts(world, trigonometry)).let {
        world.goals.map(it::of)
    }
    private var isOver = false

    /** The line that each robot's program is at or, once it has ended, was at last; null before it runs. */
    private var lines: List<RunState.Running?> = world.robots.map { null }

    /** The progress of the world's goals, in its order; the same list while nothing changes. */
    var progress: List<GoalProgress> = evaluators.map { it.progress }
        private set

    /**
     * Observes what programs have done since the last call, one [event][events] after the other, and then the current
     * state of the run.
     */
    fun observe(state: SessionState, events: List<ProgramEvent>) {
        if (isOver || evaluators.isEmpty()) return
        for (event in events) observe(sceneOf(state, event))
        observe(sceneOf(state))
        tell()
    }

    /** Ends the run: decides all pending goals, finally. */
    fun finish(state: SessionState) {
        if (isOver) return
        isOver = true
        val scene = sceneOf(state)
        evaluators.forEach { it.finish(scene) }
        tell()
    }

    /** Ends the evaluation; the goals keep the progress that they have. */
    fun abandon() {
        isOver = true
    }

    private fun observe(scene: GoalScene) = evaluators.forEach { it.observe(scene) }

    private fun sceneOf(state: SessionState, between: ProgramEvent? = null): GoalScene {
        val now = state.robots
        val hasChanged = lines.indices.any { now[it].brick.run is RunState.Running && now[it].brick.run != lines[it] }
        if (hasChanged) lines = lines.mapIndexed { number, line -> now[number].brick.run as? RunState.Running ?: line }
        return GoalScene(state, places, lines, between)
    }

    private fun tell() {
        if (evaluators.indices.any { evaluators[it].progress !== progress[it] }) {
            progress = evaluators.map { it.progress }
        }
    }
}
