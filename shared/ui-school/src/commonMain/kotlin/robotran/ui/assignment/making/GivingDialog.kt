package robotran.ui.assignment.making

import androidx.compose.runtime.Composable
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent

/** Asks whether pupils shall begin with what solves the task. */
@Composable
internal fun GivingDialog(onEvent: (WorkshopEvent) -> Unit) {
    val cancel = { onEvent(AssignmentEvent.GivingCancelled) }
    Dialog(
        SchoolTexts.makeGivingTitle(spoken),
        cancel,
        buttons = {
            Button(SchoolTexts.makeGivingShare(spoken), AssignmentTags.MAKE_GIVING_SHARE, ButtonKind.DIALOG_OTHER) {
                onEvent(AssignmentEvent.GivingConfirmed)
            }
            Button(DocumentTexts.cancel(spoken), AssignmentTags.MAKE_GIVING_CANCEL, ButtonKind.DIALOG_MAIN) { cancel() }
        },
    ) { Explanation(SchoolTexts.makeGivingHelp(spoken)) }
}
