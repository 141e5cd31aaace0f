package robotran.ui.send

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.dp
import robotran.tower.LegoLimits
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.SendTexts
import robotran.uikit.*
import robotran.workshop.event.SendEvent
import robotran.workshop.state.SendStep

/** A button for each slot of LEGO's own firmware, which sends the program. The last one that was used has a thick rim. */
@Composable
internal fun SlotChoice(step: SendStep.ChoosingSlot, onEvent: (SendEvent) -> Unit) =
    Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp)) {
        for (slot in 1..LegoLimits.SLOTS) {
            SlotButton(slot, slot == step.last, Modifier.weight(1f)) { onEvent(SendEvent.SlotChosen(slot)) }
        }
    }

@Composable
private fun SlotButton(slot: Int, isLast: Boolean, modifier: Modifier, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    val words = if (isLast) SendTexts.slotLast(spoken, slot) else SendTexts.slotNumber(spoken, slot)
    ButtonFrame(
        SendTags.slot(slot),
        ButtonKind.DIALOG_ANSWER,
        modifier.named(words),
        padding = PaddingValues(0.dp),
        border = if (isLast) edge(colours.onPane, 3.dp) else edge(),
        onClick = onClick,
    ) { Text("$slot", Modifier.clearAndSetSemantics { }, TextStyles.heading) }
}
