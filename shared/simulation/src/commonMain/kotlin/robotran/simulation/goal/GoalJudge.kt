package robotran.simulation.goal

import robotran.rcxrom.sound.SoundEvent
import robotran.simulation.messages.EnglishSimulationMessages
import robotran.simulation.messages.GoalMessages
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.SessionState
import robotran.world.World
import robotran.world.geometry.Trigonometry

/** Evaluates how far one run meets the goals of [world], from its beginning. */
internal class GoalJudge(
    world: World,
    trigonometry: Trigonometry,
    messages: GoalMessages = EnglishSimulationMessages,
) {
    private val places = ObjectLocations(world, trigonometry)
    private val evaluators = GoalEvaluators(world, places, messages, SentenceParts(world, trigonometry)).let {
        world.goals.map(it::of)
    }
    private var isOver = false

    /** The progress of the world's goals, in its order; the same list while nothing changes. */
    var progress: List<GoalProgress> = evaluators.map { it.progress }
        private set

    /**
     * Observes the current state of the run.
     *
     * @param newTones the tones of each robot's brick since the last call.
     */
    fun observe(state: SessionState, newTones: List<List<SoundEvent.Tone>>) {
        if (isOver || evaluators.isEmpty()) return
        val scene = Scene(state, newTones, places)
        evaluators.forEach { it.observe(scene) }
        tell()
    }

    /** Ends the run: decides all pending goals, finally. */
    fun finish(state: SessionState) {
        if (isOver) return
        isOver = true
        val scene = Scene(state, emptyList(), places)
        evaluators.forEach { it.finish(scene) }
        tell()
    }

    /** Ends the evaluation; the goals keep the progress that they have. */
    fun abandon() {
        isOver = true
    }

    private fun tell() {
        if (evaluators.indices.any { evaluators[it].progress !== progress[it] }) {
            progress = evaluators.map { it.progress }
        }
    }
}
