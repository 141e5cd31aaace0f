package robotran.simulation.goal

import robotran.brick.sound.SoundEvent
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.ProgramShortfall
import robotran.world.GoalCondition

/** Evaluates whether the program has played the tones, and not too many if they are counted. */
internal class PlaySoundEvaluator(
    sentence: String,
    private val goal: GoalCondition.PlaySound,
    private val actor: Actor.OfRobots,
) : SingleGoalEvaluator(sentence, goal) {
    private val lowest = (goal.lowest ?: 0) / NEARLY
    private val highest = goal.highest?.let { it * NEARLY } ?: Double.MAX_VALUE
    private val wanted = goal.times ?: 1
    private var played = 0
    private var others = 0
    private var firstOther: Heard? = null
    private var firstTooMany: Heard? = null
    private var isClosed = false

    override val toneCounts: List<PlaySoundEvaluator> get() = listOf(this)

    override val followsPrograms: Boolean get() = true

    /** Whether a tone can count both here and for [other]. */
    fun countsTonesOf(other: PlaySoundEvaluator): Boolean =
        actor == other.actor && lowest <= other.highest && other.lowest <= highest

    /** Ends the counting. */
    fun close() {
        isClosed = true
    }

    override fun look(scene: GoalScene) {
        if (!hear(scene)) return
        if (played > wanted && goal.times != null) return fail(scene)
        tell(played >= wanted, played.toDouble() / wanted)
    }

    /** How many too many there are. */
    override fun lookOn(scene: GoalScene) {
        val known = progress.shortfall as? ProgramShortfall.TooManyTones ?: return
        if (hear(scene)) tellShortfall(known.copy(played = played))
    }

    override fun shortfall(scene: GoalScene): GoalShortfall {
        firstTooMany?.let { return ProgramShortfall.TooManyTones(played, wanted, momentOf(it)) }
        val other = firstOther
        return ProgramShortfall.TonesMissing(played, wanted, others, other?.tone?.hertz, other?.let(::momentOf))
    }

    /** Counts the tone of [scene]; returns whether there is one. */
    private fun hear(scene: GoalScene): Boolean {
        val event = scene.between
        if (isClosed || event == null || event.robot != actor.number || event.tone.isFirmware) return false
        val heard = Heard(event.tone, scene)
        if (event.tone.hertz !in lowest..highest) {
            others++
            if (firstOther == null) firstOther = heard
        } else if (++played > wanted && firstTooMany == null) {
            firstTooMany = heard
        }
        return true
    }

    private fun momentOf(heard: Heard) =
        heard.scene.moment(actor, heard.scene.middle(actor)).copy(milliseconds = heard.tone.milliseconds)

    private class Heard(val tone: SoundEvent.Tone, val scene: GoalScene)

    private companion object {
        /** Half a semitone. */
        const val NEARLY = 1.03
    }
}
