package robotran.ui.worldedit

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.KeyInjectionScope
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.withKeyDown
import robotran.ui.screen.onScreen
import robotran.ui.screen.pass
import robotran.ui.sheet.SheetTransform
import robotran.ui.sheet.transform
import robotran.ui.world.tags.WorldTags
import robotran.workshop.Workshop
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.SheetCamera
import robotran.world.World
import robotran.world.geometry.Point
import robotran.worldediting.PaletteItem
import robotran.worldediting.Snapping
import robotran.worldediting.WorldEdit
import robotran.worldediting.WorldEditing
import robotran.worldediting.piece

/** The world editor with the empty sheet on a tablet. Snapping is off, so that elements stay at the given places. */
@OptIn(ExperimentalTestApi::class)
internal fun onEditor(width: Int = 1280, height: Int = 800, check: EditorTest.() -> Unit) =
    onScreen(width, height) { workshop ->
        workshop.handle(WorldEditEvent.EditorOpened)
        workshop.handle(WorldEditEvent.Edited(WorldEdit.Snap(Snapping(toOthers = false))))
        pass(200)
        EditorTest(this, workshop).check()
    }

/** User actions in the editor. */
@OptIn(ExperimentalTestApi::class)
internal class EditorTest(val screen: ComposeUiTest, val workshop: Workshop) {
    val editing: WorldEditing get() = checkNotNull(workshop.state.worldEdit).editing
    val world: World get() = editing.world

    fun tap(tag: String) {
        screen.onNodeWithTag(tag).performClick()
        screen.pass(100)
    }

    fun isThere(tag: String): Boolean = screen.onAllNodesWithTag(tag).fetchSemanticsNodes().isNotEmpty()

    /** Places an element without the palette. */
    fun put(item: PaletteItem, x: Double, y: Double) {
        make(WorldEdit.Put(item.piece(world), Point(x, y)))
    }

    fun make(edit: WorldEdit) {
        workshop.handle(WorldEditEvent.Edited(edit))
        screen.pass(100)
    }

    /** The position of a point of the paper on the sheet's pane, which shows all of it. */
    fun place(x: Double, y: Double): Offset = transform().toPixels(x, y)

    fun transform(): SheetTransform {
        val size = screen.onNodeWithTag(WorldTags.EDIT_SHEET).fetchSemanticsNode().size
        val window = Rect(0f, 0f, size.width.toFloat(), size.height.toFloat())
        return SheetCamera.FITTING.transform(world.paper, window)
    }

    fun boundsOf(tag: String): Rect = screen.onNodeWithTag(tag).fetchSemanticsNode().boundsInRoot

    fun tapAt(x: Double, y: Double) {
        val place = place(x, y)
        screen.onNodeWithTag(WorldTags.EDIT_SHEET).performTouchInput {
            down(place)
            up()
        }
        screen.pass(100)
    }

    fun drag(from: Offset, to: Offset) {
        screen.onNodeWithTag(WorldTags.EDIT_SHEET).performTouchInput {
            down(from)
            for (step in 1..STEPS) moveTo(from + (to - from) * (step / STEPS.toFloat()))
            up()
        }
        screen.pass(100)
    }

    fun key(key: Key) = keys { pressKey(key) }

    fun shift(key: Key) = keys { withKeyDown(Key.ShiftLeft) { pressKey(key) } }

    fun control(key: Key) = keys { withKeyDown(Key.CtrlLeft) { pressKey(key) } }

    private fun keys(press: KeyInjectionScope.() -> Unit) {
        screen.onRoot().performKeyInput(press)
        screen.pass(60)
    }

    private companion object {
        const val STEPS = 8
    }
}
