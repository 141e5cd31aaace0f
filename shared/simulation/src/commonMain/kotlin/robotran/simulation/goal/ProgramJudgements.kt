package robotran.simulation.goal

import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.state.RunState
import robotran.simulation.state.GoalStatus
import robotran.world.Goal

/** Has the program come to its end by itself in time? */
internal class EndWithinJudgement(
    sentence: String,
    private val goal: Goal.EndWithin,
    private val actor: Actor.OfRobots,
) : SingleJudgement(sentence) {
    override fun look(scene: Scene) {
        val run = scene.robot(actor)?.brick?.run
        when {
            scene.isAfter(goal.seconds) -> tell(GoalStatus.FAILED)
            run is RunState.Ended && !run.stopped -> tell(GoalStatus.MET)
        }
    }
}

/** Has the program shown the text? */
internal class ShowOnDisplayJudgement(
    sentence: String,
    private val goal: Goal.ShowOnDisplay,
    private val actor: Actor.OfRobots,
) : SingleJudgement(sentence) {
    /** What the firmware has left on the display, as long as the program has changed nothing about it. */
    private var leftByFirmware: String? = null

    override fun look(scene: Scene) {
        val brick = scene.robot(actor)?.brick ?: return
        val glass = brick.glass
        when {
            brick.run !is RunState.Running || brick.explanation != null -> {
                leftByFirmware = charactersOf(glass)
            }

            leftByFirmware == charactersOf(glass) -> {
                return
            }

            else -> {
                leftByFirmware = null
                if (glass.shows(goal.text)) tell(GoalStatus.MET)
            }
        }
    }

    /** Without the icons, which the firmware changes when a program begins. */
    private fun charactersOf(glass: LcdGlass): String = glass.text
}

/** Has the program played so many tones? */
internal class PlaySoundJudgement(
    sentence: String,
    private val goal: Goal.PlaySound,
    private val actor: Actor.OfRobots,
) : SingleJudgement(sentence) {
    private val lowest = (goal.lowest ?: 0) / NEARLY
    private val highest = goal.highest?.let { it * NEARLY } ?: Double.MAX_VALUE
    private var played = 0

    override fun look(scene: Scene) {
        played += scene.newTones.getOrNull(actor.number).orEmpty().count { !it.ofFirmware && it.hertz in lowest..highest }
        if (played >= goal.times) tell(GoalStatus.MET) else tell(GoalStatus.PENDING, played.toDouble() / goal.times)
    }

    private companion object {
        /** Half a semitone. */
        const val NEARLY = 1.03
    }
}
