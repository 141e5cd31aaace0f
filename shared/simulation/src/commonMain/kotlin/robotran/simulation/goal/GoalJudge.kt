package robotran.simulation.goal

import robotran.rcxrom.sound.SoundEvent
import robotran.simulation.messages.EnglishSimulationMessages
import robotran.simulation.messages.GoalMessages
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.SessionState
import robotran.world.World
import robotran.world.geometry.Trigonometry

/** Judges how far the goals of [world] are met in one run, from its beginning. */
internal class GoalJudge(
    world: World,
    trigonometry: Trigonometry,
    messages: GoalMessages = EnglishSimulationMessages,
) {
    private val places = Places(world, trigonometry)
    private val evaluators = GoalEvaluators(world, places, messages, SentenceParts(world, trigonometry)).let {
        world.goals.map(it::of)
    }
    private var isOver = false

    /** How the world's goals stand, in its order; the same list as long as nothing changes. */
    var progress: List<GoalProgress> = evaluators.map { it.progress }
        private set

    /**
     * Looks at the run as it is now.
     *
     * @param newTones what each robot's brick has played since the last look.
     */
    fun observe(state: SessionState, newTones: List<List<SoundEvent.Tone>>) {
        if (isOver || evaluators.isEmpty()) return
        val scene = Scene(state, newTones, places)
        evaluators.forEach { it.observe(scene) }
        tell()
    }

    /** The run is over: all that is not decided yet is decided now, and for good. */
    fun finish(state: SessionState) {
        if (isOver) return
        isOver = true
        val scene = Scene(state, emptyList(), places)
        evaluators.forEach { it.finish(scene) }
        tell()
    }

    private fun tell() {
        if (evaluators.indices.any { evaluators[it].progress !== progress[it] }) {
            progress =
                evaluators.map { it.progress }
        }
    }
}
