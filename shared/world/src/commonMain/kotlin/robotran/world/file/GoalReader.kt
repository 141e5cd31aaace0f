package robotran.world.file

import robotran.json.JsonPlace
import robotran.world.Goal
import robotran.world.TouchKind
import robotran.world.WorldLimits

/** Reads goals, and counts them. */
internal class GoalReader(private val shapes: ShapeReader) {
    private var goals = 0

    fun read(place: JsonPlace): List<Goal> = goals(place, depth = 1, least = 0)

    private fun goals(place: JsonPlace, depth: Int, least: Int): List<Goal> {
        val deepest = WorldLimits.MAXIMUM_GOAL_DEPTH
        if (depth > deepest) place.refuse(told { goalsTooDeep(deepest) })
        return place.items(least..WorldLimits.MAXIMUM_GOALS).map { goal(it, depth) }
    }

    private fun goal(place: JsonPlace, depth: Int): Goal {
        if (++goals > WorldLimits.MAXIMUM_GOALS) place.refuse(told { tooManyGoals(WorldLimits.MAXIMUM_GOALS) })
        val says = place.optional("says")?.text(WorldLimits.MAXIMUM_SENTENCE_CHARACTERS)
        val read = place.member("kind").choice(KINDS)
        return read(Fields(place, says, depth))
    }

    /** @property says read already, so that it is the same for all kinds. */
    private inner class Fields(val place: JsonPlace, val says: String?, private val depth: Int) {
        fun region() = shapes.shape(place.member("region"))

        fun who() = place.optional("who")?.text(WorldLimits.MAXIMUM_NAME_CHARACTERS)

        fun whole() = place.optional("whole")?.flag() ?: false

        fun within() = place.optional("within")?.wholeNumber(WorldLimits.SECONDS)

        fun length(name: String) = place.optional(name)?.number(0.0..WorldLimits.MAXIMUM_INK)

        fun tone(name: String) = place.optional(name)?.wholeNumber(WorldLimits.LOWEST_TONE..WorldLimits.HIGHEST_TONE)

        fun tolerance(usual: Double) =
            place.optional("tolerance")?.number(WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_TOLERANCE) ?: usual

        fun touchKinds(): Set<TouchKind> {
            val what = place.optional("what") ?: return TouchKind.entries.toSet()
            val kinds = what.items(1..TouchKind.entries.size).map { it.choice(TOUCH_KINDS) }
            if (kinds.toSet().size < kinds.size) what.refuse(told { wordTwice() })
            return kinds.toSet()
        }

        fun goals() = goals(place.member("goals"), depth + 1, least = 1)

        fun unknown() = unknownOf(place)
    }

    companion object {
        val USUAL_DRAWING = Goal.DrawTemplate()
        val USUAL_FOLLOWING = Goal.FollowLine(line = "")
        private val KINDS: Map<String, (Fields) -> Goal> = mapOf(
            "reach" to { f ->
                val stays = f.place.optional("stays")?.flag() ?: false
                Goal.Reach(f.region(), f.who(), f.whole(), f.within(), stays, f.says, f.unknown())
            },
            "stayOut" to { f -> Goal.StayOut(f.region(), f.who(), f.whole(), f.says, f.unknown()) },
            "stayIn" to { f -> Goal.StayIn(f.region(), f.who(), f.whole(), f.says, f.unknown()) },
            "neverTouch" to { f -> Goal.NeverTouch(f.touchKinds(), f.who(), f.says, f.unknown()) },
            "drawTemplate" to { f ->
                val coverage = f.place.optional("coverage")?.number(0.0..1.0) ?: USUAL_DRAWING.coverage
                val excess = f.place.optional("excess")?.number(0.0..WorldLimits.MAXIMUM_EXCESS) ?: USUAL_DRAWING.excess
                Goal.DrawTemplate(f.tolerance(USUAL_DRAWING.tolerance), coverage, excess, f.says, f.unknown())
            },
            "inkLength" to { f ->
                val atLeast = f.length("atLeast")
                val atMost = f.length("atMost")
                if (atLeast == null && atMost == null) f.place.refuse(told { mustHaveOneOrBoth("atLeast", "atMost") })
                if (atLeast != null && atMost != null && atLeast > atMost) f.place.refuse(told { mustNotBeAbove("atLeast", "atMost") })
                Goal.InkLength(atLeast, atMost, f.says, f.unknown())
            },
            "followLine" to { f ->
                val line = f.place.member("line").text(WorldLimits.MAXIMUM_NAME_CHARACTERS)
                val laps = f.place.optional("laps")?.number(WorldLimits.MINIMUM_LAPS..WorldLimits.MAXIMUM_LAPS) ?: USUAL_FOLLOWING.laps
                Goal.FollowLine(line, laps, f.tolerance(USUAL_FOLLOWING.tolerance), f.who(), f.within(), f.says, f.unknown())
            },
            "endWithin" to { f ->
                Goal.EndWithin(f.place.member("seconds").wholeNumber(WorldLimits.SECONDS), f.who(), f.says, f.unknown())
            },
            "showOnDisplay" to { f ->
                Goal.ShowOnDisplay(f.place.member("text").text(WorldLimits.MAXIMUM_DISPLAY_CHARACTERS), f.who(), f.says, f.unknown())
            },
            "playSound" to { f ->
                val times = f.place.optional("times")?.wholeNumber(1..WorldLimits.MAXIMUM_SOUNDS) ?: 1
                val lowest = f.tone("lowest")
                val highest = f.tone("highest")
                if (lowest != null && highest != null && lowest > highest) f.place.refuse(told { mustNotBeAbove("lowest", "highest") })
                Goal.PlaySound(times, lowest, highest, f.who(), f.says, f.unknown())
            },
            "inOrder" to { f -> Goal.InOrder(f.goals(), f.says, f.unknown()) },
            "all" to { f -> Goal.All(f.goals(), f.says, f.unknown()) },
            "anyOf" to { f -> Goal.AnyOf(f.goals(), f.says, f.unknown()) },
        )
    }
}
