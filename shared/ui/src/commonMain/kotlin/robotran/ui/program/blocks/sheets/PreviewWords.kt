package robotran.ui.program.blocks.sheets

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.robolang.outline.PhrasePart
import robotran.ui.program.blocks.BlockScope
import robotran.ui.resources.*
import robotran.workshop.blocks.SheetPreview
import robotran.workshop.blocks.previewOf
import robotran.world.geometry.Pose
import robotran.worldediting.written
import kotlin.math.abs

/** What the number at [part] does, in words, as the sheet of paper shows it; null if it shows nothing. */
@Composable
internal fun previewWords(part: PhrasePart.Value, scope: BlockScope): String? {
    val program = scope.state.program
    return when (val preview = previewOf(part, program.text, program.lineAt(part.span.start), ANYWHERE)) {
        null -> null

        is SheetPreview.Way -> stringResource(
            if (preview.centimetres < 0) Res.string.blocks_preview_back else Res.string.blocks_preview_ahead,
            written(abs(preview.centimetres)),
        )

        is SheetPreview.Turn -> stringResource(
            if (preview.degrees < 0) Res.string.blocks_preview_right else Res.string.blocks_preview_left,
            written(abs(preview.degrees)),
        )
    }
}

/** The words do not depend on where the robot stands. */
private val ANYWHERE = Pose(0.0, 0.0, 0.0)
