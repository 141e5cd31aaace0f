package robotran.world.file

import robotran.json.decimal
import robotran.world.GoalCondition.All
import robotran.world.GoalCondition.AnyOf
import robotran.world.GoalCondition.DrawTemplate
import robotran.world.GoalCondition.EndWithin
import robotran.world.GoalCondition.FollowLine
import robotran.world.GoalCondition.InOrder
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.NeverTouch
import robotran.world.GoalCondition.PlaySound
import robotran.world.GoalCondition.Reach
import robotran.world.GoalCondition.ShowOnDisplay
import robotran.world.GoalCondition.StayIn
import robotran.world.GoalCondition.StayOut
import robotran.world.WorldLimits
import robotran.world.messages.reason

/** One for each kind of condition, in the order in which error messages list them. */
internal val GOAL_CODECS: List<GoalCodec> = listOf(
    codec<Reach>(
        "reach",
        read = {
            Reach(stays = flag("stays"), region = region(), who = who(), whole = flag("whole"), within = within())
        },
        write = {
            actorInRegion(it)
            number("within", it.within)
            flag("stays", it.stays, default = false)
        },
    ),
    codec<StayOut>(
        "stayOut",
        read = { StayOut(region(), who(), flag("whole")) },
        write = { actorInRegion(it) },
    ),
    codec<StayIn>(
        "stayIn",
        read = { StayIn(region(), who(), flag("whole")) },
        write = { actorInRegion(it) },
    ),
    codec<NeverTouch>(
        "neverTouch",
        read = { NeverTouch(touchKinds(), who()) },
        write = {
            touchKinds(it.what)
            text("who", it.who)
        },
    ),
    DrawTemplate().let { default ->
        codec<DrawTemplate>(
            "drawTemplate",
            read = {
                DrawTemplate(
                    coverage = number("coverage", 0.0..1.0) ?: default.coverage,
                    excess = number("excess", 0.0..WorldLimits.MAXIMUM_EXCESS) ?: default.excess,
                    tolerance = tolerance(default.tolerance),
                )
            },
            write = {
                number("tolerance", it.tolerance, default.tolerance)
                number("coverage", it.coverage, default.coverage)
                number("excess", it.excess, default.excess)
            },
        )
    },
    codec<InkLength>(
        "inkLength",
        read = {
            val atLeast = number("atLeast", 0.0..WorldLimits.MAXIMUM_INK)
            val atMost = number("atMost", 0.0..WorldLimits.MAXIMUM_INK)
            if (atLeast == null && atMost == null) place.refuse(reason { mustHaveOneOrBoth("atLeast", "atMost") })
            checkBounds("atLeast" to atLeast, "atMost" to atMost)
            InkLength(atLeast, atMost)
        },
        write = {
            put("atLeast", it.atLeast?.let(::decimal))
            put("atMost", it.atMost?.let(::decimal))
        },
    ),
    FollowLine(line = "").let { default ->
        codec<FollowLine>(
            "followLine",
            read = {
                FollowLine(
                    line = text("line", WorldLimits.MAXIMUM_NAME_CHARACTERS),
                    laps = number("laps", WorldLimits.MINIMUM_LAPS..WorldLimits.MAXIMUM_LAPS) ?: default.laps,
                    tolerance = tolerance(default.tolerance),
                    who = who(),
                    within = within(),
                )
            },
            write = {
                text("line", it.line)
                number("laps", it.laps, default.laps)
                number("tolerance", it.tolerance, default.tolerance)
                text("who", it.who)
                number("within", it.within)
            },
        )
    },
    codec<EndWithin>(
        "endWithin",
        read = { EndWithin(place.member("seconds").wholeNumber(WorldLimits.SECONDS), who()) },
        write = {
            number("seconds", it.seconds)
            text("who", it.who)
        },
    ),
    codec<ShowOnDisplay>(
        "showOnDisplay",
        read = { ShowOnDisplay(text("text", WorldLimits.MAXIMUM_DISPLAY_CHARACTERS), who(), flag("stays")) },
        write = {
            text("text", it.text)
            text("who", it.who)
            flag("stays", it.stays, default = false)
        },
    ),
    codec<PlaySound>(
        "playSound",
        read = {
            val times = wholeNumber("times", 1..WorldLimits.MAXIMUM_SOUNDS)
            val lowest = wholeNumber("lowest", WorldLimits.LOWEST_TONE..WorldLimits.HIGHEST_TONE)
            val highest = wholeNumber("highest", WorldLimits.LOWEST_TONE..WorldLimits.HIGHEST_TONE)
            checkBounds("lowest" to lowest, "highest" to highest)
            PlaySound(times, lowest, highest, who())
        },
        write = {
            number("times", it.times)
            number("lowest", it.lowest)
            number("highest", it.highest)
            text("who", it.who)
        },
    ),
    codec<InOrder>("inOrder", read = { InOrder(goals()) }, write = { parts(it.goals) }),
    codec<All>("all", read = { All(goals()) }, write = { parts(it.goals) }),
    codec<AnyOf>("anyOf", read = { AnyOf(goals()) }, write = { parts(it.goals) }),
)
