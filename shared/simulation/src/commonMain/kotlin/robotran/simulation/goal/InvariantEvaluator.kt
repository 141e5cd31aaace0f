package robotran.simulation.goal

import robotran.simulation.state.ForbiddenTouch
import robotran.simulation.state.GoalShortfall
import robotran.world.GoalCondition
import robotran.world.TouchKind

/** Evaluates a condition that must hold until the run ends. */
internal abstract class InvariantEvaluator(sentence: String, condition: GoalCondition) :
    SingleGoalEvaluator(sentence, condition, holds = true) {
    /** Whether the condition is violated now. */
    protected abstract fun isBroken(scene: GoalScene): Boolean

    override fun look(scene: GoalScene) {
        if (isBroken(scene)) fail(scene)
    }
}

/** Evaluates whether the robot has touched nothing of these kinds. */
internal class NeverTouchEvaluator(
    sentence: String,
    private val goal: GoalCondition.NeverTouch,
    private val actor: Actor.OfRobots,
) : InvariantEvaluator(sentence, goal) {
    /** The kinds touched before this goal was activated; only a current touch of them can be detected. */
    private var touchedBefore: Set<TouchKind> = emptySet()

    override fun begin(scene: GoalScene) {
        touchedBefore = scene.robot(actor)?.robot?.touched.orEmpty()
    }

    override fun isBroken(scene: GoalScene): Boolean {
        val robot = scene.robot(actor)?.robot ?: return false
        return goal.what.any { it in robot.touching || (it in robot.touched && it !in touchedBefore) }
    }

    override fun shortfall(scene: GoalScene): GoalShortfall? {
        val robot = scene.robot(actor)?.robot ?: return null
        val what = goal.what.filterTo(mutableSetOf()) {
            it in robot.touching || (it in robot.touched && it !in touchedBefore)
        }
        val contact = scene.contact(actor, what)
        return ForbiddenTouch(what, contact?.name, scene.moment(actor, contact?.place ?: scene.middle(actor)))
    }
}
