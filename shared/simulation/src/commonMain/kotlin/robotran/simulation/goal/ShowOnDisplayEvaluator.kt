package robotran.simulation.goal

import robotran.brick.state.RunState
import robotran.brick.state.Screen
import robotran.language.editDistance
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.ProgramShortfall
import robotran.world.GoalCondition

/** Evaluates whether the program has shown the text, or has left it on the display if it must stay. */
internal class ShowOnDisplayEvaluator(
    sentence: String,
    private val goal: GoalCondition.ShowOnDisplay,
    private val actor: Actor.OfRobots,
) : SingleGoalEvaluator(sentence, goal) {
    private val wanted = goal.text.trim()

    /** The display content from the firmware, until the program changes it. */
    private var leftByFirmware: String? = null

    /** What the program has shown last. */
    private var last: Screen? = null
    private var nearest: ShownText? = null

    /** When the text was replaced for the last time. */
    private var replacingScene: GoalScene? = null

    override fun isDoneBy(event: ProgramEvent): Boolean? =
        event.drawn?.takeIf { event.robot == actor.number }?.shows(goal.text)

    override fun look(scene: GoalScene) {
        val brick = scene.robot(actor)?.brick ?: return
        val screen = brick.screen
        when {
            brick.run !is RunState.Running || brick.explanation != null -> {
                leftByFirmware = charactersOf(screen)
                brick.leftByProgram?.let { lookAt(it, scene) }
            }

            leftByFirmware == charactersOf(screen) -> return

            else -> {
                leftByFirmware = null
                lookAt(screen, scene)
            }
        }
    }

    private fun lookAt(screen: Screen, scene: GoalScene) {
        if (screen == last) return
        last = screen
        if (screen.shows(goal.text)) return tell(holds = true)
        if (progress.holds) replacingScene = scene
        remember(screen, scene)
        tell(holds = false)
    }

    override fun shortfall(scene: GoalScene): GoalShortfall {
        val shown = last?.text?.takeIf { it.isNotEmpty() }
        replacingScene?.let { return ProgramShortfall.DisplayChanged(wanted, shown, momentOf(it)) }
        return ProgramShortfall.DisplayDiffered(wanted, shown, nearest?.text, nearest?.let { momentOf(it.scene) })
    }

    private fun momentOf(scene: GoalScene) = scene.moment(actor, scene.middle(actor))

    private fun remember(screen: Screen, scene: GoalScene) {
        for (text in screen.texts.toSet()) {
            if (text.isEmpty()) continue
            val errors = editDistance(text.lowercase(), wanted.lowercase())
            if (errors < (nearest?.errors ?: Int.MAX_VALUE)) nearest = ShownText(text, errors, scene)
        }
    }

    /** Without the icons, which the firmware changes when a program starts. */
    private fun charactersOf(screen: Screen): String = screen.text

    private class ShownText(val text: String, val errors: Int, val scene: GoalScene)
}
