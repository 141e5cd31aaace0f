package robotran.ui.documents

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import robotran.ui.empty.EmptyPicture
import robotran.ui.empty.EmptyState
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.texts.CommonTexts
import robotran.ui.texts.HubTexts
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.state.ProjectListEntry

/** The list of projects: a touch opens one, the menu next to it has what else can be done with it. */
@Composable
internal fun ProjectsDialog(
    dialog: DocumentDialog.ProjectList,
    noticeText: @Composable (Notice) -> String,
    onEvent: (DocumentEvent) -> Unit,
) {
    val close = { onEvent(DocumentEvent.DialogClosed) }
    Dialog(
        CommonTexts.myWork(spoken),
        close,
        buttons = {
            Button(DocumentTexts.close(spoken), DocumentTags.DOCUMENT_CANCEL, ButtonKind.DIALOG_OTHER, onClick = close)
            Button(HubTexts.otherRobot(spoken), DocumentTags.WORKS_NEW_ROBOT, ButtonKind.DIALOG_OTHER) {
                onEvent(DocumentEvent.RobotChoiceRequested)
            }
            Button(
                CommonTexts.newProject(spoken),
                DocumentTags.WORKS_NEW,
                ButtonKind.DIALOG_MAIN,
            ) { onEvent(DocumentEvent.NewRequested) }
        },
        notice = dialog.notice?.let { { ListNotice(noticeText(it), it.isError) } },
    ) {
        val projects = dialog.projects
        when {
            projects == null -> Explanation(DocumentTexts.worksLoading(spoken))

            projects.isEmpty() -> EmptyState(
                EmptyPicture.SHEETS,
                DocumentTexts.worksEmpty(spoken),
                DocumentTags.WORKS_EMPTY,
                Modifier.fillMaxWidth(),
            )

            else -> projects.forEachIndexed { number, work ->
                if (number > 0) HorizontalDivider()
                when (work.entry.id) {
                    dialog.renaming -> RenamingRow(work, onEvent)
                    dialog.deleted -> DeletedRow(work, onEvent)
                    else -> ProjectRow(work, onEvent)
                }
            }
        }
    }
}

/** What did not work: screen readers announce it. */
@Composable
private fun ListNotice(label: String, isError: Boolean) = Explanation(
    label,
    Modifier.testTag(DocumentTags.WORKS_NOTICE).semantics {
        liveRegion = if (isError) LiveRegionMode.Assertive else LiveRegionMode.Polite
    },
    bad = isError,
)

@Composable
internal fun nameOf(work: ProjectListEntry) = work.entry.name.ifEmpty { DocumentTexts.untitled(spoken) }
