package robotran.simulation.goal

import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.Ink
import robotran.simulation.state.InkShortfall
import robotran.simulation.state.RunMoment
import robotran.world.GoalCondition
import robotran.world.Template

/** Evaluates the length of the drawing. */
internal class InkLengthEvaluator(sentence: String, private val goal: GoalCondition.InkLength) :
    SingleGoalEvaluator(sentence, goal) {
    private val atLeast = goal.atLeast ?: 0.0
    private var lengthAtStart = 0.0

    override fun begin(scene: GoalScene) {
        lengthAtStart = scene.state.ink.lengthCentimetres
    }

    override fun look(scene: GoalScene) {
        val length = length(scene)
        if (length > (goal.atMost ?: Double.MAX_VALUE)) return fail(scene)
        tell(length >= atLeast, if (atLeast > 0.0) length / atLeast else null)
    }

    override fun shortfall(scene: GoalScene): GoalShortfall {
        val most = goal.atMost
        val length = length(scene)
        if (most == null || length <= most) {
            return InkShortfall.TooShort(atLeast - length, scene.state.ink.strokes.lastOrNull()?.points?.last())
        }
        return InkShortfall.TooLong(length - most, scene.drawingMoment())
    }

    /** The drawing goes on after it has become too long. */
    override fun shortfallAtEnd(scene: GoalScene): GoalShortfall? = when (val known = progress.shortfall) {
        is InkShortfall.TooLong -> known.copy(centimetres = length(scene) - (goal.atMost ?: 0.0))
        else -> known
    }

    private fun length(scene: GoalScene): Double = scene.state.ink.lengthCentimetres - lengthAtStart
}

/** Evaluates whether the template is drawn, with little ink beside it. */
internal class DrawTemplateEvaluator(
    sentence: String,
    private val goal: GoalCondition.DrawTemplate,
    template: Template,
) : SingleGoalEvaluator(sentence, goal) {
    private val tracing = Tracing(template, goal.tolerance)
    private var seen: Ink? = null

    override fun look(scene: GoalScene) {
        val ink = scene.state.ink
        if (ink === seen) return
        seen = ink
        tracing.follow(ink)
        if (tracing.excess > goal.excess) return fail(scene, tracing.coverage)
        tell(tracing.coverage >= goal.coverage, tracing.coverage)
    }

    /** Follows the rest of the drawing, so that all of what is wrong can be shown. */
    override fun lookOn(scene: GoalScene) {
        val ink = scene.state.ink
        if (ink === seen) return
        seen = ink
        tracing.follow(ink)
    }

    override fun shortfall(scene: GoalScene): GoalShortfall = if (tracing.excess > goal.excess) {
        InkShortfall.InkBesideTemplate(
            tracing.centimetresBeside,
            tracing.stretchesBeside,
            scene.drawingMoment(),
        )
    } else {
        InkShortfall.TemplateMissing(tracing.coverage, goal.coverage, tracing.missingStretches())
    }

    override fun shortfallAtEnd(scene: GoalScene): GoalShortfall? = when (val known = progress.shortfall) {
        is InkShortfall.InkBesideTemplate -> {
            known.copy(centimetres = tracing.centimetresBeside, beside = tracing.stretchesBeside)
        }

        else -> known
    }
}

/** This moment, at the pen of the robot that draws; with several, of the first that does. */
private fun GoalScene.drawingMoment(): RunMoment {
    val number = maxOf(0, state.robots.indexOfFirst { it.robot.penDown })
    val actor = Actor.OfRobots(number)
    return moment(actor, middle(actor))
}
