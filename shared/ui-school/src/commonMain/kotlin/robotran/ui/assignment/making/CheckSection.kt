package robotran.ui.assignment.making

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.ui.assignment.ProgressBar
import robotran.ui.assignment.worldName
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.AssignmentEditorState
import robotran.workshop.state.MissingPart
import robotran.workshop.state.SolutionCheck

/** What is missing, and whether the solution meets the goals with all seeds and variations. Nothing is forbidden. */
@Composable
internal fun CheckSection(state: AssignmentEditorState, onEvent: (WorkshopEvent) -> Unit) {
    Section(SchoolTexts.makeCheck(spoken), AssignmentTags.MAKE_CHECK_SECTION) {
        if (state.missing.isEmpty()) {
            Explanation(
                SchoolTexts.makeCheckAll(spoken),
                Modifier.testTag(AssignmentTags.MAKE_COMPLETE),
            )
        }
        for (part in state.missing) {
            Explanation(
                "⚠ ${part.sentence(spoken)}",
                Modifier.testTag(AssignmentTags.MAKE_MISSING),
            )
        }
        val check = state.check
        // While it runs, only its beginning is news.
        ComesIntoView(check?.newsKey) { CheckOfSolution(state, onEvent) }
    }
}

@Composable
private fun CheckOfSolution(state: AssignmentEditorState, onEvent: (WorkshopEvent) -> Unit) {
    val check = state.check
    if (check is SolutionCheck.Running) {
        Explanation(SchoolTexts.makeTrying(spoken, check.done, check.all), Modifier.testTag(AssignmentTags.MAKE_TRYING))
        ProgressBar(check.done.toFloat() / check.all.coerceAtLeast(1), AssignmentTags.MAKE_CHECK_PROGRESS)
        Button(SchoolTexts.handInCancel(spoken), AssignmentTags.MAKE_CHECK_STOP, ButtonKind.SECOND) {
            onEvent(AssignmentEvent.CheckRequested(on = false))
        }
    } else if (state.assignment.solution.isNotEmpty()) {
        Button(SchoolTexts.makeTrySolution(spoken), AssignmentTags.MAKE_CHECK, ButtonKind.SECOND) {
            onEvent(AssignmentEvent.CheckRequested(on = true))
        }
    }
    CheckResult(check)
}

/** Differs between results, but not while the check runs. */
private val SolutionCheck.newsKey: Any get() = if (this is SolutionCheck.Running) "running" else this

@Composable
private fun CheckResult(check: SolutionCheck?) {
    val news = Modifier.testTag(AssignmentTags.MAKE_CHECKED).announced()
    when (check) {
        null, is SolutionCheck.Running -> Unit

        is SolutionCheck.Passed -> {
            Explanation(SchoolTexts.makeTryPassed(spoken, check.runs), news)
            StartPassed(check.startPassed, check.runs)
        }

        is SolutionCheck.Failed -> {
            val world = worldName(check.world)
            Explanation(
                SchoolTexts.makeTryFailed(spoken, check.failed, check.runs, world, check.seed),
                news,
                bad = true,
            )
            StartPassed(check.startPassed, check.runs)
        }

        is SolutionCheck.HasErrors -> {
            Explanation(SchoolTexts.makeTryMistakes(spoken), news, bad = true)
            for (reason in check.reasons.take(MAX_REASONS)) Explanation(reason)
        }
    }
}

/** The program to begin with should leave something to do. */
@Composable
private fun StartPassed(passed: Int, runs: Int) {
    if (passed == 0) return
    Explanation(
        "⚠ ${SchoolTexts.makeTryStart(spoken, passed, runs)}",
        Modifier.testTag(AssignmentTags.MAKE_CHECKED_START).announced(),
    )
}

private val MissingPart.sentence: Label
    get() = when (this) {
        MissingPart.TASK -> SchoolTexts::makeMissingTask
        MissingPart.GOALS -> SchoolTexts::makeMissingGoals
        MissingPart.SOLUTION -> SchoolTexts::makeMissingSolution
        MissingPart.SOLUTION_NOT_ALLOWED -> SchoolTexts::makeMissingAllowed
    }

private const val MAX_REASONS = 5
