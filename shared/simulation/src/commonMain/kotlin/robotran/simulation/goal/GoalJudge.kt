package robotran.simulation.goal

import robotran.rcxrom.sound.SoundEvent
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.SessionState
import robotran.world.Goal
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.World
import robotran.world.geometry.Trigonometry

/** Judges how far the goals of [world] are met in one run, from its beginning. */
internal class GoalJudge(
    private val world: World,
    trigonometry: Trigonometry,
    messages: GoalMessages = EnglishGoalMessages,
) {
    private val sentences = GoalSentences(world, trigonometry, messages)
    private val places = Places(world, trigonometry)
    private val judgements = world.goals.map(::judgementOf)
    private var isOver = false

    /** How the world's goals stand, in its order; the same list as long as nothing changes. */
    var progress: List<GoalProgress> = judgements.map { it.progress }
        private set

    /**
     * Looks at the run as it is now.
     *
     * @param newTones what each robot's brick has played since the last look.
     */
    fun observe(state: SessionState, newTones: List<List<SoundEvent.Tone>>) {
        if (isOver || judgements.isEmpty()) return
        val scene = Scene(state, newTones, places)
        judgements.forEach { it.observe(scene) }
        tell()
    }

    /** The run is over: all that is not decided yet is decided now, and for good. */
    fun finish(state: SessionState) {
        if (isOver) return
        isOver = true
        val scene = Scene(state, emptyList(), places)
        judgements.forEach { it.finish(scene) }
        tell()
    }

    private fun tell() {
        if (judgements.indices.any { judgements[it].progress !== progress[it] }) progress = judgements.map { it.progress }
    }

    private fun judgementOf(goal: Goal): Judgement {
        val sentence = sentences.of(goal)
        return when (goal) {
            is Goal.Reach -> places.actor(goal.who)?.let { ReachJudgement(sentence, goal, it, places.region(goal.region)) }
            is Goal.StayOut -> places.actor(goal.who)?.let { StayOutJudgement(sentence, goal, it, places.region(goal.region)) }
            is Goal.StayIn -> places.actor(goal.who)?.let { StayInJudgement(sentence, goal, it, places.region(goal.region)) }
            is Goal.NeverTouch -> places.robot(goal.who)?.let { NeverTouchJudgement(sentence, goal, it) }
            is Goal.DrawTemplate -> world.template?.let { DrawTemplateJudgement(sentence, goal, it) }
            is Goal.InkLength -> InkLengthJudgement(sentence, goal)
            is Goal.FollowLine -> places.robot(goal.who)?.let { followLine(sentence, goal, it) }
            is Goal.EndWithin -> places.robot(goal.who)?.let { EndWithinJudgement(sentence, goal, it) }
            is Goal.ShowOnDisplay -> places.robot(goal.who)?.let { ShowOnDisplayJudgement(sentence, goal, it) }
            is Goal.PlaySound -> places.robot(goal.who)?.let { PlaySoundJudgement(sentence, goal, it) }
            is Goal.InOrder -> InOrderJudgement(sentence, goal.goals.map(::judgementOf))
            is Goal.All -> AllJudgement(sentence, goal.goals.map(::judgementOf))
            is Goal.AnyOf -> AnyOfJudgement(sentence, goal.goals.map(::judgementOf))
        } ?: HopelessJudgement(sentence)
    }

    private fun followLine(sentence: String, goal: Goal.FollowLine, actor: Actor.OfRobots): Judgement? =
        world.marks.find { it.name == goal.line && it.isWay() }?.let {
            FollowLineJudgement(sentence, goal, actor, it.figure as MarkFigure.Line)
        }

    /** Whether it leads from somewhere to somewhere else. */
    private fun Mark.isWay() = (figure as? MarkFigure.Line)?.let { line -> line.points.any { it != line.points.first() } } == true
}
