package robotran.ui.program.blocks.dialogs

import androidx.compose.runtime.Composable
import robotran.editing.written
import robotran.robolang.outline.PhrasePart
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
import robotran.workshop.blocks.SheetPreview
import robotran.workshop.blocks.previewOf
import robotran.world.geometry.Pose
import kotlin.math.abs

/** What the number at [part] does, in words, as the sheet of paper shows it; null if it shows nothing. */
@Composable
internal fun previewWords(part: PhrasePart.Value, scope: BlockScope): String? {
    val program = scope.state.program
    return when (
        val preview = previewOf(
            part,
            program.text,
            program.lineAt(part.span.start),
            ANYWHERE,
            program.vocabulary,
        )
    ) {
        null -> null

        is SheetPreview.Way ->
            if (preview.centimetres <
                0
            ) {
                BlockTexts.previewBack(spoken, scope.shownNumber(written(abs(preview.centimetres))))
            } else {
                BlockTexts.previewAhead(spoken, scope.shownNumber(written(abs(preview.centimetres))))
            }

        is SheetPreview.Turn ->
            if (preview.degrees <
                0
            ) {
                BlockTexts.previewRight(spoken, scope.shownNumber(written(abs(preview.degrees))))
            } else {
                BlockTexts.previewLeft(spoken, scope.shownNumber(written(abs(preview.degrees))))
            }
    }
}

/** The words do not depend on where the robot stands. */
private val ANYWHERE = Pose(0.0, 0.0, 0.0)
