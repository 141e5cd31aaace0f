package robotran.narration

import robotran.brick.state.RunState
import robotran.language.Language
import robotran.simulation.messages.ShortfallMessages
import robotran.simulation.messages.sentenceFor
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.world.writeThousandths
import kotlin.math.abs
import kotlin.math.floor

internal fun storySentences(story: RunStory, language: Language): List<String> {
    val messages = StoryMessages.of(language)
    if (story.end.run == RunState.Idle && story.robots.all { it.centimetres < STILL }) return listOf(messages.nothing())
    val told = buildList {
        story.robots.forEachIndexed { number, robot -> addAll(movesTold(robot, number, messages)) }
        story.robots.filter { it.bumps > 0 }.forEachIndexed { number, robot ->
            val time = seconds(robot.bumpedAt ?: 0)
            add(Told(messages.bumped(robot.name, robot.bumps, robot.bumpedInto, time), OFTEN_LEFT_OUT * number + 1))
        }
        story.arrivals.forEach {
            add(Told(messages.cameTo(seconds(it.milliseconds), it.ground.kind, it.ground.name), OFTEN_LEFT_OUT))
        }
        if (story.inkCentimetres >= STILL) add(Told(messages.drew(centimetres(story.inkCentimetres)), LEFT_OUT))
        val sounds = story.robots.first().sounds
        if (sounds > 0) add(Told(messages.sounded(sounds), OFTEN_LEFT_OUT))
        endTold(story.end, messages)?.let { add(Told(it, 1)) }
        goalsTold(story.goals, language, messages).forEach { add(Told(it, 0)) }
    }
    val kept = told.sortedBy { it.rank }.take(RunStory.MAX_SENTENCES).toSet()
    return told.filter { it in kept }.map { it.sentence }
}

/** @property rank of those with the highest one, the last are left out if there are too many. */
private class Told(val sentence: String, val rank: Int)

private fun movesTold(robot: RobotStory, number: Int, messages: StoryMessages): List<Told> {
    val groups = robot.groups
    if (groups != null && groups.isEmpty()) {
        return listOf(Told(messages.stood(robot.name), if (number == 0) 0 else OFTEN_LEFT_OUT))
    }
    if (groups == null || number > 0) {
        val metres = robot.centimetres >= LONG
        val length = if (metres) metres(robot.centimetres) else centimetres(robot.centimetres)
        return listOf(Told(messages.inAll(robot.name, length, metres), if (number == 0) 0 else OFTEN_LEFT_OUT))
    }
    return wayTold(robot.name, groups, messages).mapIndexed { place, sentence -> Told(sentence, place) }
}

private fun wayTold(who: String?, groups: List<MoveGroup>, messages: StoryMessages): List<String> = buildList {
    var next = 0
    while (next < groups.size && size < MAX_MOVE_SENTENCES) {
        val group = groups[next]
        if (group.times > 1) {
            add(messages.repeated(who, isEmpty(), group.times, group.moves.map { it.told(messages) }))
            next++
        } else {
            val single = groups.drop(next).takeWhile { it.times == 1 }.take(MAX_IN_SENTENCE).map { it.moves.single() }
            add(messages.did(who, isEmpty(), single.map { it.told(messages) }))
            next += single.size
        }
    }
    val rest = groups.drop(next).flatMap { group -> List(group.times) { group.moves }.flatten() }
    val way = rest.sumOf { it.way }
    if (way >= STILL) add(messages.wentOn(centimetres(way), rest.count { it is Move.Turn }))
}

private fun Move.told(messages: StoryMessages): String = when (this) {
    is Move.Drive -> messages.drove(centimetres(wholeUnlessTiny(along)), along < 0)
    is Move.Turn -> messages.turned(wholeDegrees(abs(degrees)), degrees > 0)

    is Move.Bend -> {
        messages.bent(centimetres(wholeUnlessTiny(along)), wholeDegrees(abs(degrees)), degrees > 0, along < 0)
    }

    is Move.Winding -> messages.wound(centimetres(way))
    is Move.Wait -> messages.waited(seconds(milliseconds))
    Move.Carried -> messages.carried()
}

private fun endTold(end: ProgramEnd, messages: StoryMessages): String? = when (val run = end.run) {
    RunState.Idle -> null
    is RunState.Running -> messages.stillRuns(seconds(end.milliseconds))
    is RunState.Ended -> seconds(end.milliseconds).let { if (run.stopped) messages.stopped(it) else messages.ended(it) }
    is RunState.Failed -> messages.failed(run.failure.message)
}

private fun goalsTold(goals: List<GoalProgress>, language: Language, messages: StoryMessages): List<String> {
    if (goals.isEmpty()) return emptyList()
    val met = goals.count { it.status == GoalStatus.MET }
    if (met == goals.size) return listOf(messages.allMet(goals.size))
    val words = ShortfallMessages.of(language)
    val missed = goals.withIndex().mapNotNull { (number, goal) ->
        val shortfall = goal.shortfall ?: return@mapNotNull null
        messages.missed((number + 1).takeIf { goals.size > 1 }, words.sentenceFor(shortfall))
    }
    val count = if (goals.size > 1) listOf(messages.someMet(met, goals.size)) else emptyList()
    return count + missed.take(MAX_MISSED)
}

/** What a robot drove is no more exact than its wheels. */
private fun wholeUnlessTiny(along: Double): Double = if (abs(along) < TINY) abs(along) else floor(abs(along) + HALF)

private fun metres(centimetres: Double): String =
    writeThousandths(floor(centimetres / DECIMETRE + HALF) / DECIMETRE).removeSuffix(".0")

/** Centimetres. */
private const val STILL = 0.5
private const val TINY = 2.0
private const val LONG = 1_000.0
private const val DECIMETRE = 10.0
private const val HALF = 0.5

private const val LEFT_OUT = 5
private const val OFTEN_LEFT_OUT = 10
private const val MAX_MOVE_SENTENCES = 3
private const val MAX_IN_SENTENCE = 5
private const val MAX_MISSED = 2
