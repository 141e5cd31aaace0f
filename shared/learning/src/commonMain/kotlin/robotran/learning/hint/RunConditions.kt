package robotran.learning.hint

import robotran.simulation.state.ForbiddenTouch
import robotran.simulation.state.LineShortfall
import robotran.simulation.state.PlaceShortfall
import robotran.simulation.state.ProgramShortfall
import robotran.world.TouchKind

/** What the run alone tells. */
internal val runConditions: List<HintCondition> = listOf(
    HintCondition("never moved") { attempt ->
        HintMatch().takeIf { attempt.driven < LITTLE && attempt.solutionLines.any { it.tokens.any(DRIVING::contains) } }
    },
    HintCondition("touched something") { if (it.lacked<ForbiddenTouch>()) HintMatch() else null },
    HintCondition("hit a wall") { attempt -> HintMatch().takeIf { attempt.run.robot.touched.any(WALLS::contains) } },
    HintCondition("left the paper") { attempt ->
        val pose = attempt.run.robot.pose
        val paper = attempt.world.paper
        HintMatch().takeIf { pose.x !in 0.0..paper.width || pose.y !in 0.0..paper.height }
    },
    HintCondition("left again") { if (it.lacked<PlaceShortfall.LeftAgain>()) HintMatch() else null },
    HintCondition("left its place") { if (it.lacked<PlaceShortfall.Left>()) HintMatch() else null },
    HintCondition("went where it must not") { if (it.lacked<PlaceShortfall.Entered>()) HintMatch() else null },
    HintCondition("left the line") { attempt ->
        HintMatch().takeIf { attempt.lacked<LineShortfall>() && !attempt.lacked<LineShortfall.TooLate>() }
    },
    HintCondition("wrong text") { if (it.lacked<ProgramShortfall.DisplayDiffered>()) HintMatch() else null },
    HintCondition("text replaced") { if (it.lacked<ProgramShortfall.DisplayChanged>()) HintMatch() else null },
    HintCondition("too many sounds") { if (it.lacked<ProgramShortfall.TooManyTones>()) HintMatch() else null },
    HintCondition("no sound") { if (it.lacked<ProgramShortfall.TonesMissing>()) HintMatch() else null },
    HintCondition("never stops") { if (it.isRunning) HintMatch() else null },
    HintCondition("too slow") { attempt ->
        HintMatch().takeIf {
            attempt.lacked<PlaceShortfall.ReachedTooLate>() || attempt.lacked<ProgramShortfall.EndedTooLate>() ||
                attempt.lacked<LineShortfall.TooLate>()
        }
    },
    HintCondition("ended too early") { if (it.seconds < EARLY && !it.isRunning) HintMatch() else null },
)

private val WALLS = setOf(TouchKind.WALLS, TouchKind.BARRIERS)
private val DRIVING = setOf("forward", "backward", "turn", "start", "motor", "drive")

/** A program that is over sooner, in seconds, has hardly begun. */
private const val EARLY = 1.0
