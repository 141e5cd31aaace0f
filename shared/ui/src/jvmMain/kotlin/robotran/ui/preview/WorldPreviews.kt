package robotran.ui.preview

import androidx.compose.desktop.ui.tooling.preview.Preview
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.ui.world.WorldPane
import robotran.ui.worldedit.WorldEditPane
import robotran.workshop.event.WorldEditEvent

@Preview
@Composable
internal fun WorldPanePreview() = PreviewWorkshop({
    openGalleryWorld("corridor")
    run("pen down\nforward 20\nturn left 90\nforward 10", milliseconds = 8_000)
}) { WorldPane(it.world, it.run.drawn, it.sheet, {}, Modifier.size(640.dp, 420.dp)) }

@Preview
@Composable
internal fun WorldEditPanePreview() = PreviewWorkshop({ handle(WorldEditEvent.EditorOpened) }) { state ->
    Box(Modifier.size(1_000.dp, 600.dp)) {
        state.worldEdit?.let { WorldEditPane(it, state.session, state.document, {}) }
    }
}
