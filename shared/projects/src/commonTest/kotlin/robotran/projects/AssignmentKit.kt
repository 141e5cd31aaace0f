package robotran.projects

import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.file.BuiltInWorlds

private val WORLD = BuiltInWorlds.plain.copy(
    goals = listOf(Goal(GoalCondition.InkLength(atLeast = 10.0, atMost = null))),
    task = "Draw.",
)

private fun program(text: String) =
    listOf(ProjectProgram(Program("a.robo", ProgramLanguage.ROBOLANG, text), ProgramView.BLOCKS))

/** A teacher's copy of an assignment with every feature of the file format. */
internal val EVERY_ASSIGNMENT = Project(
    WORLD,
    listOf(ProjectRobot(WORLD.robots.first().name, program("beep"))),
    assignment = Assignment(
        id = "draw-1",
        text = "Draw.\n\n![A line](line)",
        pictures = listOf(AssignmentPicture("line", "iVBORw0KGgo=")),
        mayChangeWorld = true,
        languages = listOf(ProgramLanguage.ROBOLANG),
        words = listOf("forward"),
        hints = listOf(AssignmentHint("Drive.", "never moved"), AssignmentHint("Draw.", afterTries = 2)),
        due = "Friday",
        nameWanted = "Your class",
        start = program("beep"),
        checks = AssignmentChecks(1..20, listOf(WorldVariation("other", WORLD.copy(realism = 0.5)))),
        solution = program("pen down\nforward 12"),
    ),
)

private val RESULT = TryResult(1, 1, 2500, "0123456789abcdef")

/** A hand-in with feedback, and with the pupil's tries. */
internal val EVERY_HAND_IN = EVERY_ASSIGNMENT.copy(
    tries = AssignmentTries(3, BestTry(program("forward 1"), 0, FULL_PROJECT.inputs.take(1), RESULT, percent = 40)),
    handIn = HandIn("Ann", 3, RESULT, "0123456789abcdef"),
    feedback = Feedback("Well done.", listOf(FeedbackResult("", 20, 20), FeedbackResult("other", 3, 20))),
)
