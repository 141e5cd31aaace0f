package robotran.simulation.goal

import robotran.simulation.messages.GoalMessages
import robotran.simulation.messages.number
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.World

/** Creates the evaluator for each kind of condition, and the sentence that tells a pupil what to do. */
internal class GoalEvaluators(
    private val world: World,
    private val places: ObjectLocations,
    private val messages: GoalMessages,
    private val parts: SentenceParts,
) {
    /** The evaluator for [goal]. Its sentence is the author's or, if there is none, generated from the condition. */
    fun of(goal: Goal): GoalEvaluator {
        val sentence = goal.says ?: sentenceOf(goal.condition)
        return evaluatorOf(goal.condition, sentence) ?: UnsatisfiableGoal(sentence)
    }

    /** null if a robot or object that [condition] refers to is missing. */
    private fun evaluatorOf(condition: GoalCondition, sentence: String): GoalEvaluator? = with(condition) {
        when (this) {
            is GoalCondition.Reach -> places.actor(who)?.let {
                ReachEvaluator(sentence, this, it, places.region(region), parts.region(region).name)
            }

            is GoalCondition.StayOut -> places.actor(who)?.let {
                StayOutEvaluator(sentence, this, it, places.region(region), parts.region(region).name)
            }

            is GoalCondition.StayIn -> places.actor(who)?.let {
                StayInEvaluator(sentence, this, it, places.region(region), parts.region(region).name)
            }

            is GoalCondition.NeverTouch -> places.robot(who)?.let { NeverTouchEvaluator(sentence, this, it) }
            is GoalCondition.DrawTemplate -> world.template?.let { DrawTemplateEvaluator(sentence, this, it) }
            is GoalCondition.InkLength -> InkLengthEvaluator(sentence, this)
            is GoalCondition.FollowLine -> places.robot(who)?.let { followLineEvaluator(sentence, this, it, world) }
            is GoalCondition.EndWithin -> places.robot(who)?.let { EndWithinEvaluator(sentence, this, it) }
            is GoalCondition.ShowOnDisplay -> places.robot(who)?.let { ShowOnDisplayEvaluator(sentence, this, it) }
            is GoalCondition.PlaySound -> places.robot(who)?.let { PlaySoundEvaluator(sentence, this, it) }
            is GoalCondition.InOrder -> InOrderEvaluator(sentence, goals.map(::of))
            is GoalCondition.All -> AllEvaluator(sentence, goals.map(::of))
            is GoalCondition.AnyOf -> AnyOfEvaluator(sentence, goals.map(::of))
        }
    }

    private fun sentenceOf(condition: GoalCondition): String = with(condition) {
        when (this) {
            is GoalCondition.Reach -> messages.reach(parts.mover(who), parts.region(region), whole, within, stays)
            is GoalCondition.StayOut -> messages.stayOut(parts.mover(who), parts.region(region), whole)
            is GoalCondition.StayIn -> messages.stayIn(parts.mover(who), parts.region(region), whole)
            is GoalCondition.NeverTouch -> messages.neverTouch(parts.mover(who), what.sorted())
            is GoalCondition.DrawTemplate -> messages.drawTemplate(number(tolerance), percent(coverage))
            is GoalCondition.InkLength -> inkSentence(atLeast, atMost)

            is GoalCondition.FollowLine -> messages.followLine(
                parts.mover(who),
                parts.lineName(line),
                parts.isClosed(line),
                laps,
                within,
            )

            is GoalCondition.EndWithin -> messages.endWithin(parts.mover(who), seconds)
            is GoalCondition.ShowOnDisplay -> messages.showOnDisplay(parts.mover(who), text.trim(), stays)
            is GoalCondition.PlaySound -> messages.playSound(parts.mover(who), times, lowest, highest)
            is GoalCondition.InOrder -> messages.inOrder()
            is GoalCondition.All -> messages.all()
            is GoalCondition.AnyOf -> messages.anyOf()
        }
    }

    private fun inkSentence(atLeast: Double?, atMost: Double?): String = when {
        atMost == null -> messages.inkAtLeast(number(atLeast ?: 0.0))
        atLeast == null -> messages.inkAtMost(number(atMost))
        number(atLeast) == number(atMost) -> messages.inkExactly(number(atLeast))
        else -> messages.inkBetween(number(atLeast), number(atMost))
    }
}
