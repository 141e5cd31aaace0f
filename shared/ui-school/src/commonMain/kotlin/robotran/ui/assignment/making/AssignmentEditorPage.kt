package robotran.ui.assignment.making

import androidx.compose.foundation.ScrollState
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.input.KeyboardType
import androidx.compose.ui.unit.dp
import robotran.projects.Assignment
import robotran.ui.assignment.Quiet
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.AssignmentEditorState

/** The page with which an author makes an assignment of the open project; it opens at [place]. */
@Composable
fun AssignmentEditorPage(state: AssignmentEditorState, place: MakingPlace, onEvent: (WorkshopEvent) -> Unit) {
    val change = { changed: Assignment -> onEvent(AssignmentEvent.Changed(changed)) }
    val scroll = place.of(state.assignment.id)
    Page(SchoolTexts.makeTitle(spoken), AssignmentTags.ASSIGNMENT_MAKE, {
        onEvent(AssignmentEvent.MakingClosed)
    }, scroll) {
        Column(
            Modifier.testTag(AssignmentTags.MAKE_FORM).verticalScroll(scroll).padding(24.dp),
            Arrangement.spacedBy(32.dp),
        ) {
            Column {
                Explanation(SchoolTexts.makeIntro(spoken))
                Button(
                    SchoolTexts.makeUndo(spoken),
                    AssignmentTags.MAKE_UNDO,
                    ButtonKind.QUIET,
                    enabled = state.canUndo,
                ) {
                    onEvent(AssignmentEvent.UndoRequested)
                }
            }
            TaskSection(state, change, onEvent)
            GoalSection(state, change, onEvent)
            ProgramSection(state, change, onEvent)
            HintSection(state.assignment, change)
            HandInSection(state.assignment, change)
            GradingSection(state.assignment, change, onEvent)
            CheckSection(state, onEvent)
            GiveSection(state, onEvent)
            PlatformSection(state, onEvent)
            Button(SchoolTexts.makeRemove(spoken), AssignmentTags.MAKE_REMOVE, ButtonKind.QUIET) {
                onEvent(AssignmentEvent.Removed)
            }
        }
    }
    if (state.asksBeforeGiving) GivingDialog(onEvent)
}

/** How far the page is scrolled, also while the author is in the world editor or tries something out. */
class MakingPlace {
    private var assignment: String? = null
    private var scroll = ScrollState(0)

    /** That of the assignment with [id]; another one begins at the top. */
    fun of(id: String): ScrollState {
        if (id != assignment) scroll = ScrollState(0)
        assignment = id
        return scroll
    }
}

/** A part of the form with its [title]. */
@Composable
internal fun Section(title: String, tag: String, content: @Composable ColumnScope.() -> Unit) {
    Column(Modifier.fillMaxWidth().testTag(tag), Arrangement.spacedBy(8.dp)) {
        Text(title, Modifier.heading(), TextStyles.cardTitle.strong)
        content()
    }
}

/** A title within a part of the form. */
@Composable
internal fun Subtitle(title: String) = Text(
    title,
    Modifier.padding(top = 8.dp).heading(),
    TextStyles.sentence.medium,
)

/**
 * A field with its [label], in large text above it, since a label of several lines would cover the field before.
 *
 * @param lines the number of lines to show at least; one for a field of one line.
 */
@Composable
internal fun Field(
    value: String,
    label: String,
    tag: String,
    limit: Int,
    lines: Int = 1,
    modifier: Modifier = Modifier,
    keyboard: KeyboardType = KeyboardType.Unspecified,
    onChange: (String) -> Unit,
) {
    val isAbove = LocalDensity.current.fontScale > LARGE
    if (isAbove) Quiet(label, AssignmentTags.label(tag))
    TextField(
        value,
        { onChange(it.take(limit)) },
        modifier.fillMaxWidth().testTag(tag).semantics { if (isAbove) contentDescription = label },
        label.takeIf { !isAbove },
        if (lines == 1) 1..1 else lines..MAX_LINES,
        KeyboardOptions(keyboardType = keyboard),
    )
}

/** From this font scale on, words get a line of their own. */
internal const val LARGE = 1.3f

/** The rest scrolls. */
private const val MAX_LINES = 12
