package robotran.simulation.goal

import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.state.RunState
import robotran.simulation.state.GoalStatus
import robotran.world.GoalCondition

/** Evaluates whether the program has ended by itself in time. */
internal class EndWithinEvaluator(
    sentence: String,
    private val goal: GoalCondition.EndWithin,
    private val actor: Actor.OfRobots,
) : SingleGoalEvaluator(sentence) {
    override fun look(scene: Scene) {
        val run = scene.robot(actor)?.brick?.run
        when {
            scene.isAfter(goal.seconds) -> tell(GoalStatus.FAILED)
            run is RunState.Ended && !run.stopped -> tell(GoalStatus.MET)
        }
    }
}

/** Evaluates whether the program has shown the text. */
internal class ShowOnDisplayEvaluator(
    sentence: String,
    private val goal: GoalCondition.ShowOnDisplay,
    private val actor: Actor.OfRobots,
) : SingleGoalEvaluator(sentence) {
    /** The display content from the firmware, until the program changes it. */
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

    /** Without the icons, which the firmware changes when a program starts. */
    private fun charactersOf(glass: LcdGlass): String = glass.text
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

    override fun look(scene: Scene) {
        played +=
            scene.newTones.getOrNull(actor.number).orEmpty().count { !it.isFirmware && it.hertz in lowest..highest }
        if (played >= goal.times) tell(GoalStatus.MET) else tell(GoalStatus.PENDING, played.toDouble() / goal.times)
    }

    private companion object {
        /** Half a semitone. */
        const val NEARLY = 1.03
    }
}
