package robotran.ui.preview

import androidx.compose.desktop.ui.tooling.preview.Preview
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.ui.brick.BrickFront
import robotran.ui.brick.BrickHint
import robotran.ui.brick.BrickStrip

@Preview
@Composable
internal fun BrickFrontPreview() = PreviewWorkshop({ run("show 1234\nwait 5 seconds", milliseconds = 500) }) {
    BrickFront(it.run.brick, it.run.down, {}, {}, Modifier.width(260.dp))
}

@Preview
@Composable
internal fun BrickStripPreview() = PreviewWorkshop { BrickStrip(it.run.brick, it.run.down, {}, {}) }

@Preview
@Composable
internal fun BrickHintPreview() = PreviewWorkshop({ run("show 1 / (1 - 1)", milliseconds = 2_000) }) {
    BrickHint(it.run.brick, Modifier.width(400.dp), onClose = {})
}
