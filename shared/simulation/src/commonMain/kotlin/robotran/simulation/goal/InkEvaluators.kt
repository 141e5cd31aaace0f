package robotran.simulation.goal

import robotran.simulation.state.GoalStatus
import robotran.simulation.state.Ink
import robotran.world.GoalCondition
import robotran.world.Template

/** Evaluates the length of the drawing. */
internal class InkLengthEvaluator(sentence: String, private val goal: GoalCondition.InkLength) :
    SingleGoalEvaluator(sentence) {
    private val atLeast = goal.atLeast ?: 0.0
    private var lengthAtStart = 0.0
    private var isEnough = false

    override val allowsNext: Boolean get() = isEnough && progress.status != GoalStatus.FAILED

    override val statusAtEnd: GoalStatus get() = if (isEnough) GoalStatus.MET else GoalStatus.FAILED

    override fun begin(scene: Scene) {
        lengthAtStart = scene.state.ink.lengthCentimetres
    }

    override fun look(scene: Scene) {
        val length = scene.state.ink.lengthCentimetres - lengthAtStart
        isEnough = length >= atLeast
        when {
            length > (goal.atMost ?: Double.MAX_VALUE) -> tell(GoalStatus.FAILED)
            goal.atMost == null && isEnough -> tell(GoalStatus.MET)
            atLeast > 0.0 -> tell(GoalStatus.PENDING, length / atLeast)
        }
    }
}

/** Evaluates whether the template is drawn, with little ink beside it. */
internal class DrawTemplateEvaluator(
    sentence: String,
    private val goal: GoalCondition.DrawTemplate,
    template: Template,
) : SingleGoalEvaluator(sentence) {
    private val tracing = Tracing(template, goal.tolerance)
    private var seen: Ink? = null

    override val allowsNext: Boolean get() = tracing.coverage >= goal.coverage &&
        progress.status != GoalStatus.FAILED

    override val statusAtEnd: GoalStatus get() = if (tracing.coverage >= goal.coverage) {
        GoalStatus.MET
    } else {
        GoalStatus.FAILED
    }

    override fun look(scene: Scene) {
        val ink = scene.state.ink
        if (ink === seen) return
        seen = ink
        tracing.follow(ink)
        tell(if (tracing.excess > goal.excess) GoalStatus.FAILED else GoalStatus.PENDING, tracing.coverage)
    }
}
